//! Many attitudes one after the other.

use crate::golden::output;
use crate::support::{all_conventions, assert_close};
use quatlas::{
    ChainFactor, ChainReport, ChainRequest, Convention, Direction, EulerSequence, Fact, Field,
    MatrixConvention, Outcome, Request, Rotation, TaggedQuaternion, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

const A: &str = "rotvec 0.4 -0.7 1.1";
const B: &str = "rotvec -0.6 0.25 0.9";

/// A text that begins with `/` stands as its inverse.
fn request(texts: &[&str], convention: Convention) -> Request {
    let factors = texts.iter().map(|text| ChainFactor {
        text: text.trim_start_matches('/').to_owned(),
        inverse: text.starts_with('/'),
    });
    Request::Chain(ChainRequest {
        factors: factors.collect(),
        convention,
        matrix: MatrixConvention::default(),
        euler: EulerSequence::default(),
    })
}

#[track_caller]
fn ask(texts: &[&str], convention: Convention) -> ChainReport {
    match analyze(&request(texts, convention)) {
        Outcome::Chain(report) => *report,
        outcome => panic!("{outcome:?}"),
    }
}

/// G25: Exp(v) = Exp(a) Exp(b). In JPL, world to body, the same attitude is b ⊗ a.
#[wasm_bindgen_test(unsupported = test)]
fn two_factors_make_the_golden_product() {
    let v = output("G25", "v");
    let rows = output("G25", "R");
    let hamilton = ask(&[A, B], Convention::HAMILTON);
    let jpl = ask(&[B, A], Convention::JPL);
    for report in [&hamilton, &jpl] {
        assert_close("v", &report.turn.rotation_vector_rad, &v, 4e-15);
        assert_close("R", &report.hamilton.matrix.concat(), &rows, 4e-15);
        assert_eq!(report.hamilton.unit.w, report.jpl.unit.w);
        assert_eq!(report.hamilton.unit.z, report.jpl.unit.z);
    }
    let turned_round = ask(&[B, A], Convention::HAMILTON);
    assert!((turned_round.turn.rotation_vector_rad[0] - v[0]).abs() > 0.1);
}

/// (p∘q)⁻¹ = q⁻¹∘p⁻¹ (Cheng 2018, eq. 2.7), of any norm, in every convention.
#[wasm_bindgen_test(unsupported = test)]
fn the_inverse_of_a_product_is_that_of_the_inverses_in_reverse() {
    for convention in all_conventions() {
        let product = ask(&["1 2 3 4", "0.5 -1 0.25 2", "0 3 1 1"], convention);
        let inverses = ask(&["/0 3 1 1", "/0.5 -1 0.25 2", "/1 2 3 4"], convention);
        let wanted = product.declared.inverse.expect("a double").array;
        assert_close(
            "inverse",
            &inverses.declared.quaternion.array,
            &wanted,
            1e-15,
        );
        let nothing = ask(&["1 2 3 4", "/1 2 3 4"], convention);
        assert_close("1", &[nothing.declared.quaternion.w], &[1.0], 1e-15);
        assert!(nothing.turn.angle_rad < 1e-15);
    }
}

/// The declared product of the numbers as typed, and what each column says of the order of the factors.
#[wasm_bindgen_test(unsupported = test)]
fn the_columns_are_one_attitude_and_tell_the_order_of_the_factors() {
    let arrays = [
        [0.1, 0.2, -0.3, 0.4],
        [0.5, -0.1, 0.2, 0.3],
        [-0.2, 0.7, 0.1, 0.6],
    ];
    let texts = arrays.map(|array| format!("{array:?}"));
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    for convention in all_conventions() {
        let report = ask(&texts, convention);
        for column in [&report.declared, &report.hamilton, &report.jpl] {
            let factors = arrays.map(|array| {
                TaggedQuaternion::from_array(array, convention).to_convention(column.convention)
            });
            let [a, b, c] = &factors;
            let in_listed_order = column.rules.operator == convention.operator();
            let (left, right) = if in_listed_order { (a, c) } else { (c, a) };
            let product = left.product(b).and_then(|product| product.product(right));
            let wanted = product.expect("one convention").to_array();
            assert_close("product", &column.quaternion.array, &wanted, 1e-15);
        }
        assert_eq!(report.hamilton.rules.operator, Direction::BodyToWorld);
        assert_eq!(report.jpl.rules.operator, Direction::WorldToBody);
        assert_eq!(report.factors.len(), 3);
    }
}

/// The question of the mounted camera, and that of the mean of two signs.
#[wasm_bindgen_test(unsupported = test)]
fn the_questions_of_products_and_means_are_answered() {
    let texts = [
        "0.4952 -0.283 -0.15426 0.80678",
        "yaw 90 pitch -30 roll 0 deg",
    ];
    let camera = ask(&texts, Convention::HAMILTON);
    let wanted = [-0.189_252, -0.060_375, 0.144_954, 0.969_292];
    assert_close("camera", &camera.declared.unit.array, &wanted, 2e-6);
    let texts = ["0.984808 0.173648 0 0", "-0.906308 -0.422618 0 0"];
    let mean = ask(&texts, Convention::HAMILTON).mean.expect("one");
    let wanted = [0.953_717, 0.300_706, 0.0, 0.0];
    assert_close("mean", &mean.array, &wanted, 2e-6);
    // In the middle of an attitude and its inverse there is no turn.
    let mean = ask(&[A, "/rotvec 0.4 -0.7 1.1"], Convention::JPL)
        .mean
        .expect("one");
    assert_close("mean", &mean.array, &[0.0, 0.0, 0.0, 1.0], 1e-15);
    assert_eq!(
        ask(&["1 0 0 0", "0 1 0 0"], Convention::HAMILTON).mean,
        None
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn each_factor_has_its_problem_and_its_notes_in_its_place() {
    let texts = ["1 0 0 0", "x", "2 0 0 0", ""];
    let Outcome::Problems(found) = analyze(&request(&texts, Convention::HAMILTON)) else {
        panic!("problems");
    };
    let places: Vec<_> = found.problems.iter().map(|problem| problem.at).collect();
    assert_eq!(places, [1, 3]);
    assert!(
        found
            .problems
            .iter()
            .all(|problem| problem.field == Field::Factor)
    );
    let report = ask(&["1 0 0 0", "w=0 x=0 y=1.05 z=0"], Convention::HAMILTON);
    let is_normalised = |fact: &Fact| matches!(fact, Fact::Normalised(_));
    let mut notes = report.notes.iter();
    let place = notes.position(|note| is_normalised(&note.fact));
    assert_eq!(report.noted[place.expect("a note")], 1);
    assert_eq!(report.noted.len(), report.notes.len());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_product_beyond_a_double_is_that_of_norm_one() {
    let huge = ["1e300i", "1e300j", "1e-300k"];
    let report = ask(&huge, Convention::HAMILTON);
    assert_eq!(report.declared.quaternion.w, -1.0);
    let is_told = |fact: &Fact| matches!(fact, Fact::OutOfRange(_));
    assert!(report.notes.iter().any(|note| is_told(&note.fact)));
    let many = vec![A; 32];
    let turned = ask(&many, Convention::HAMILTON);
    let step = Rotation::from_rotation_vector_rad([0.4, -0.7, 1.1]).expect("finite");
    let whole = (0..32).fold(Rotation::identity(), |product, _| product * step);
    let rotation = TaggedQuaternion::from_array(turned.declared.unit.array, Convention::HAMILTON);
    let rotation = Rotation::from_tagged(&rotation).expect("not zero");
    assert!(rotation.angle_to_rad(&whole) < 1e-14);
    assert_eq!(ask(&[], Convention::JPL).declared.quaternion.w, 1.0);
}
