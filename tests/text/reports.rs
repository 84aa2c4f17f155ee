//! The numbers of reports: product matrices, rules, pairings, norms, sequences that are free.

use crate::asked::{read, report};
use crate::support::assert_close;
use quatlas::nalgebra::Quaternion;
use quatlas::{
    Convention, CosineMatrix, Direction, Endpoint, EulerSequence, Fact, MatrixConvention, Note,
    OutOfRange, OutOfRangeNumber, Outcome, ReadRequest, Request, Rotation, Side, TranslateReport,
    TranslateRequest, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Yoosefian 2021, eqs. 6, 7, 13 and 14: of the four numbers as typed, whatever their norm.
#[wasm_bindgen_test(unsupported = test)]
fn the_product_matrices_are_those_of_the_numbers_as_typed() {
    let report = read("1 2 3 4", "1 0 0", Convention::HAMILTON);
    let left = [
        [1.0, -2.0, -3.0, -4.0],
        [2.0, 1.0, -4.0, 3.0],
        [3.0, 4.0, 1.0, -2.0],
        [4.0, -3.0, 2.0, 1.0],
    ];
    let right = [
        [1.0, -2.0, -3.0, -4.0],
        [2.0, 1.0, 4.0, -3.0],
        [3.0, -4.0, 1.0, 2.0],
        [4.0, 3.0, -2.0, 1.0],
    ];
    assert_eq!(report.hamilton.left_product_matrix, left);
    assert_eq!(report.hamilton.right_product_matrix, right);
    // The same numbers in JPL, [x, y, z, w]: q ⊗ p = p ⊙ q.
    let moved = |rows: [[f64; 4]; 4]| {
        [1, 2, 3, 0].map(|row: usize| [1, 2, 3, 0].map(|column: usize| rows[row][column]))
    };
    assert_eq!(report.jpl.left_product_matrix, moved(right));
    assert_eq!(report.jpl.right_product_matrix, moved(left));
    let huge = read("1e300 0 0 -1e300", "1 0 0", Convention::HAMILTON);
    assert_eq!(huge.hamilton.left_product_matrix[3][0], -1e300);
}

/// Where small turns are on the axes of the world, they stand on the other side, in both columns.
#[wasm_bindgen_test(unsupported = test)]
fn both_columns_say_what_they_multiply_with_the_declared_perturbation() {
    let rules = |words: &str| {
        let report = read(
            "rotvec 0 0 1",
            "1 0 0",
            words.parse().expect("a convention"),
        );
        assert_eq!(report.rules, report.declared.rules);
        [report.hamilton, report.jpl].map(|column| {
            let rules = column.rules;
            (rules.increment, rules.body_rate, rules.chain_first)
        })
    };
    use Side::{Left, Right};
    // Hamilton: q∘δq, q̇ = ½ q∘ω, q_WB∘q_BC. JPL: δq∘q, q̇ = ½ ω∘q, q_BC∘q_WB.
    for words in ["hamilton", "jpl", "my-lab"] {
        assert_eq!(rules(words), [(Right, Right, Left), (Left, Left, Right)]);
        let words = format!("{words} global");
        assert_eq!(rules(&words), [(Left, Right, Left), (Right, Left, Right)]);
    }
    let report = read("rotvec 0 0 1", "1 0 0", "jpl global".parse().expect("JPL"));
    assert_eq!(
        report.hamilton.convention.to_string(),
        "scalar-first right passive body-to-world global"
    );
}

/// MODEL-09: the matrix beside the quaternion, with a function and a direction of its own.
#[wasm_bindgen_test(unsupported = test)]
fn the_matrix_of_the_chosen_pairing_is_in_the_report() {
    let report = |convention: Convention, matrix: MatrixConvention| {
        report(ReadRequest {
            matrix,
            ..ReadRequest::new("rotvec 0.4 -0.7 1.1", "1 0 0", convention)
        })
    };
    // G32, mylab_matrix_R_WtoB.
    let expected = [[0.273_847_0, 0.669_743_1, 0.690_255_4]];
    let my_lab = report(Convention::MY_LAB, MatrixConvention::WORLD_TO_BODY).paired;
    assert_close("R_W^B", &my_lab.rows[0], &expected[0], 1e-6);
    assert_eq!(my_lab.form, CosineMatrix::Shuster);
    assert_eq!(my_lab.convention, MatrixConvention::WORLD_TO_BODY);
    for matrix in MatrixConvention::all() {
        for convention in [
            Convention::HAMILTON,
            Convention::JPL,
            Convention::JPL_BODY_TO_WORLD,
        ] {
            let report = report(convention, matrix);
            let made = report.paired.form.of(&Quaternion::new(
                report.declared.unit.w,
                report.declared.unit.x,
                report.declared.unit.y,
                report.declared.unit.z,
            ));
            let rows: [[f64; 3]; 3] = made.expect("not zero").transpose().into();
            assert_close("of q", &report.paired.rows.concat(), &rows.concat(), 1e-15);
            let of_column = match matrix.operator() {
                Direction::BodyToWorld => report.hamilton.matrix,
                Direction::WorldToBody => report.jpl.matrix,
            };
            assert_eq!(report.paired.rows, of_column);
        }
    }
}

/// Half a turn has no Gibbs vector, also where the cosine of 90° is rounded.
#[wasm_bindgen_test(unsupported = test)]
fn half_a_turn_has_no_gibbs_vector() {
    for text in [
        "180deg about [1, 2, 3]",
        "rotvec 0 pi 0",
        "0 0 0 1",
        "ZYX 180deg 0 0",
    ] {
        let turn = read(text, "1 0 0", Convention::HAMILTON).turn;
        assert_eq!(turn.gibbs_vector, None, "{text}");
        let length = turn.modified_rodrigues_parameters.map(|part| part * part);
        assert_close(text, &[length.iter().sum()], &[1.0], 1e-15);
    }
    let nearly = read("179.9999deg about x", "1 0 0", Convention::HAMILTON).turn;
    let [x, ..] = nearly.gibbs_vector.expect("finite");
    // 1/tan of half of 1e-4 degrees.
    assert_close("x", &[x * 8.726_646_259_971_648e-7], &[1.0], 1e-8);
}

/// The norms of all numbers are the core's, rounded once.
#[wasm_bindgen_test(unsupported = test)]
fn four_numbers_have_their_norm_beside_them() {
    let report = read("0.02 -0.01 0.38 0.92", "1 0 0", Convention::JPL);
    // 0.995640497368402583…; V8's Math.hypot is two units off.
    let norm = Some(0.995_640_497_368_402_5);
    for column in [&report.declared, &report.hamilton, &report.jpl] {
        assert_eq!(column.quaternion.norm, norm);
        assert_eq!(column.conjugate.norm, norm);
        assert_close(
            "1/|q|",
            &[column.inverse.expect("finite").norm.expect("finite")],
            &[1.004_378_59],
            1e-8,
        );
        assert_close("unit", &[column.unit.norm.expect("finite")], &[1.0], 2e-16);
    }
    let beyond = read("1.5e308 1.5e308 0 0", "1 0 0", Convention::HAMILTON);
    assert_eq!(beyond.hamilton.quaternion.norm, None);
}

/// The lecture's atlas of charts: where one sequence is locked, another one is free.
#[wasm_bindgen_test(unsupported = test)]
fn at_gimbal_lock_a_free_sequence_of_the_same_axes_is_told() {
    let told = |text: &str, sequence: &str| {
        let euler = sequence.parse().expect("a sequence");
        let request = ReadRequest {
            euler,
            ..ReadRequest::new(text, "1 0 0", Convention::HAMILTON)
        };
        report(request)
            .euler
            .free_sequence
            .map(|free| free.to_string())
    };
    let free = |text: &str, sequence: &str| told(text, sequence).expect("locked");
    assert_eq!(told("ZYX 30deg 80deg 10deg", "ZYX"), None);
    assert_eq!(free("ZYX 30deg 90deg 10deg", "ZYX"), "YZX");
    assert_eq!(free("ZYX 30deg 90deg 10deg", "xyz"), "xzy");
    // Near the lock too.
    assert_eq!(free("ZYX 30deg -89.9deg 10deg", "ZYX"), "YZX");
    // About z alone ZXZ is locked and XZX is free; where nothing is turned, none of the twelve that end
    // as they begin is.
    assert_eq!(free("90deg about z", "ZXZ"), "XZX");
    assert_eq!(free("1 0 0 0", "ZXZ"), "XYZ");
    for sequence in EulerSequence::all() {
        for (middle, outer) in [(0, 0.3), (1, -2.1), (0, 1.2), (1, 3.0)] {
            let locked =
                Rotation::from_euler_rad(sequence, [outer, sequence.locks_rad()[middle], 0.4])
                    .expect("finite");
            let free = locked.free_euler_sequence(sequence);
            assert_eq!(free.frame, sequence.frame);
            let found = locked.euler(free);
            assert!(found.lock_distance_rad > 0.5, "{sequence}: {free}");
            let again = Rotation::from_euler_rad(free, found.angles_rad).expect("finite");
            assert!(again.angle_to_rad(&locked) < 1e-14);
            if !sequence.is_proper() {
                assert!(
                    !free.is_proper() && found.lock_distance_rad > 1.5,
                    "{sequence}: {free}"
                );
            }
        }
    }
}

/// A component times the norm may be too small for a double, and the norm itself too large.
#[wasm_bindgen_test(unsupported = test)]
fn numbers_for_other_axes_never_vanish() {
    // A third of a turn more on the body's axes: four components of ±½.
    let translated = |text: &str| {
        let eigen = || Endpoint::library("eigen");
        let request = TranslateRequest {
            body_axes: "y z x".to_owned(),
            ..TranslateRequest::new(text, eigen(), eigen())
        };
        match analyze(&Request::Translate(request)) {
            Outcome::Translate(report) => *report,
            other => panic!("{text}: {other:?}"),
        }
    };
    let told = |report: &TranslateReport| {
        let is_told = |note: &Note| {
            let fact = OutOfRange {
                what: OutOfRangeNumber::Norm,
            };
            note.fact == Fact::OutOfRange(fact)
        };
        report.notes.iter().any(is_told)
    };
    let wanted = translated("w: 1, x: 0, y: 0, z: 0").to.array;
    assert_eq!(wanted.map(f64::abs), [0.5; 4]);
    for text in [
        "qw: 5e-324, qx: 0, qy: 0, qz: 0",
        "qw: 1e-310, qx: 0, qy: 0, qz: 0",
        "qw: 4e-308, qx: 0, qy: 0, qz: 0",
        // Its norm is √2 times the largest double.
        "qw: 1.7976931348623157e308, qx: 1.7976931348623157e308, qy: 0, qz: 0",
    ] {
        let report = translated(text);
        assert!(told(&report), "{text}");
        let norm = report.to.array.iter().map(|n| n * n).sum::<f64>();
        assert!((norm - 1.0).abs() < 1e-15, "{text}: {:?}", report.to.array);
    }
    assert_eq!(
        translated("qw: 5e-324, qx: 0, qy: 0, qz: 0").to.array,
        wanted
    );
    // Where doubles hold it, the norm is kept, and nothing is said.
    for norm in [1e-307, 0.2, 1.5e308] {
        let report = translated(&format!("qw: {norm:e}, qx: 0, qy: 0, qz: 0"));
        assert_eq!(report.to.array, wanted.map(|part| part * norm));
        assert!(!told(&report), "{norm}");
    }
}
