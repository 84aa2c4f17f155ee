//! One attitude in all conventions.

use crate::golden::output;
use crate::support::{all_conventions, assert_close};
use quatlas::{
    AtlasReport, AtlasRequest, Convention, CosineMatrix, Direction, Function, Handedness,
    MatrixConvention, Outcome, Request, Rotation, Side, TaggedQuaternion, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

const V: &str = "rotvec 0.4 -0.7 1.1";

#[track_caller]
fn ask(text: &str, convention: Convention, matrix: MatrixConvention) -> AtlasReport {
    let request = AtlasRequest {
        quaternion: text.to_owned(),
        convention,
        matrix,
    };
    match analyze(&Request::Atlas(request)) {
        Outcome::Atlas(report) => *report,
        outcome => panic!("{outcome:?}"),
    }
}

/// G32: the named conventions.
#[wasm_bindgen_test(unsupported = test)]
fn the_named_rows_are_those_of_the_golden_case() {
    let report = ask(V, Convention::HAMILTON, MatrixConvention::WORLD_TO_BODY);
    let hamilton_world_to_body = Convention {
        direction: Direction::WorldToBody,
        ..Convention::HAMILTON
    };
    for (name, convention) in [
        ("hamilton_B2W_wxyz", Convention::HAMILTON),
        ("eigen_ros_B2W_xyzw", Convention::HAMILTON_SCALAR_LAST),
        ("jpl_W2B_xyzw", Convention::JPL),
        ("jpl_B2W_xyzw", Convention::JPL_BODY_TO_WORLD),
        ("hamilton_W2B_wxyz", hamilton_world_to_body),
        ("mylab_active_W2B_wxyz", Convention::MY_LAB),
    ] {
        let mut rows = report.rows.iter();
        let place = rows
            .position(|row| row.convention == convention)
            .expect("a row");
        let array = report.rows[place].quaternion.array;
        assert_close(name, &array, &output("G32", name), 4e-15);
    }
    let my_lab = ask(V, Convention::MY_LAB, MatrixConvention::WORLD_TO_BODY);
    assert_eq!(my_lab.paired.form, CosineMatrix::Shuster, "C(q)");
    let paired = report.paired.rows.concat();
    assert_close(
        "R_WtoB",
        &paired,
        &output("G32", "mylab_matrix_R_WtoB"),
        4e-15,
    );
}

/// Table 2.1 of the specification, row by row: the operator, the sign of the numbers, the labelled
/// composition, the chain; and the sides of table 2.2 for a local turn.
#[wasm_bindgen_test(unsupported = test)]
fn the_rows_are_those_of_the_table_of_the_specification() {
    use Direction::{BodyToWorld as B2W, WorldToBody as W2B};
    use Function::{Active, Passive};
    use Handedness::{Left, Right};
    let table = [
        (Right, Passive, B2W, B2W, true),
        (Right, Passive, W2B, W2B, false),
        (Right, Active, B2W, W2B, false),
        (Right, Active, W2B, B2W, true),
        (Left, Passive, B2W, B2W, false),
        (Left, Passive, W2B, W2B, true),
        (Left, Active, B2W, W2B, true),
        (Left, Active, W2B, B2W, false),
    ];
    let report = ask(
        "0.8 0.2 -0.4 0.4",
        Convention::HAMILTON,
        MatrixConvention::default(),
    );
    assert_eq!(report.rows.len(), 16);
    for (place, row) in report.rows.iter().enumerate() {
        let (handedness, function, direction, operator, is_canonical) = table[place % 8];
        let convention = row.convention;
        let got = (
            convention.handedness,
            convention.function,
            convention.direction,
        );
        assert_eq!(got, (handedness, function, direction), "row {place}");
        assert_eq!(row.rules.operator, operator, "row {place}");
        assert_eq!(row.rules.is_canonical, is_canonical, "row {place}");
        let sign = if is_canonical { 1.0 } else { -1.0 };
        let [x, y, z] = [0.2, -0.4, 0.4].map(|part| sign * part);
        let wanted = if place < 8 {
            [0.8, x, y, z]
        } else {
            [x, y, z, 0.8]
        };
        assert_eq!(row.quaternion.array, wanted, "row {place}");
        let side = |is_left| if is_left { Side::Left } else { Side::Right };
        assert_eq!(row.rules.labelled_first, side(function == Active));
        assert_eq!(row.rules.chain_first, side(operator == B2W));
        assert_eq!(row.rules.increment, side(operator == W2B));
        assert_eq!(row.rules.body_rate, side(operator == W2B));
    }
    assert_eq!(
        report.same_as,
        [0, 1, 1, 0, 1, 0, 0, 1, 8, 9, 9, 8, 9, 8, 8, 9]
    );
}

/// Whatever is declared, the rows are one attitude, and the declared one has the numbers that were typed.
#[wasm_bindgen_test(unsupported = test)]
fn every_row_is_the_attitude_that_was_typed() {
    let typed = [0.1, -0.2, 0.4, 0.8];
    for convention in all_conventions() {
        let report = ask(
            &format!("{typed:?}"),
            convention,
            MatrixConvention::default(),
        );
        let numbers = TaggedQuaternion::from_array(typed, convention);
        let attitude = Rotation::from_tagged(&numbers).expect("not zero");
        for row in &report.rows {
            let numbers = TaggedQuaternion::from_array(row.quaternion.array, row.convention);
            let other = Rotation::from_tagged(&numbers).expect("not zero");
            assert_eq!(other, attitude, "{}", row.convention);
            assert_eq!(row.convention.perturbation, convention.perturbation);
        }
        let is_declared = |row: &&quatlas::Column| row.convention == convention;
        let declared = report.rows.iter().find(is_declared).expect("a row");
        assert_eq!(declared.quaternion.array, typed);
    }
    // Without a turn all rows of one order are the same.
    let nothing = ask("1 0 0 0", Convention::HAMILTON, MatrixConvention::default());
    assert_eq!(nothing.same_as[..8], [0; 8]);
    assert_eq!(nothing.same_as[8..], [8; 8]);
}
