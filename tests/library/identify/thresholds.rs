//! How far printed numbers may be off: each threshold of the identification, from both sides.

use crate::identify::{follow, identify};
use crate::simulated::{Noise, Simulated};
use quatlas::{
    Behaviour, CosineMatrix, Field, Handedness, IdentifyRequest, MatrixLayout, ObservationReport,
    Outcome, Probe, ProblemCode, Request, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// A vector at 53.13° in the plane of x and y, in two decimals.
const AT_DEG: f64 = 53.130_102_354_155_98;

fn plane_vector(angle_rad: f64, decimals: usize) -> String {
    let (sine, cosine) = angle_rad.sin_cos();
    format!("{cosine:.decimals$} {sine:.decimals$} {:.decimals$}", 0.0)
}

/// A vector rotated about z by so much, in the name of R(q).
fn rotate(turn_rad: f64, vector: String, printed: String) -> Probe {
    let (sine, cosine) = (turn_rad / 2.0).sin_cos();
    Probe::Rotate {
        quaternion: format!("w: {cosine:.15}, x: 0, y: 0, z: {sine:.15}"),
        vector,
        printed,
    }
}

/// What remains of how it rotates, where what was printed is so far from R(q) v and from C(q) v, with so
/// many decimals in what went in and in what came out.
fn rotations_left(off_r: f64, off_c: f64, decimals: [usize; 2]) -> Vec<CosineMatrix> {
    let at = AT_DEG.to_radians();
    // Each of the two is written where it has few decimals, and the other is put beside it.
    let turn = (off_r + off_c) / 2.0;
    let (vector, printed) = if decimals[0] < decimals[1] {
        (at, at + turn - off_r)
    } else {
        (at - turn + off_r, at)
    };
    let probe = rotate(
        turn,
        plane_vector(vector, decimals[0]),
        plane_vector(printed, decimals[1]),
    );
    let report = identify(vec![probe]);
    assert!(
        matches!(report.observations[..], [ObservationReport::Told(_)]),
        "{report:#?}"
    );
    report.remaining.rotate
}

fn is_told(probe: Probe) -> bool {
    match &identify(vec![probe]).observations[..] {
        [ObservationReport::Told(_)] => true,
        [ObservationReport::Unexplained(unexplained)] => {
            assert!(unexplained.distance.is_some());
            false
        }
        other => panic!("{other:?}"),
    }
}

/// Whether numbers so far from what R(q) makes are explained, in so many decimals.
fn is_told_when_off(off: f64, decimals: usize) -> bool {
    // A quarter turn takes y to −x; (0, 1, 0) is in all decimals, and so is −cos of what it is off.
    is_told(rotate(
        std::f64::consts::FRAC_PI_2,
        "0 1 0".to_owned(),
        plane_vector(std::f64::consts::PI - off, decimals),
    ))
}

const ONLY_R: [CosineMatrix; 1] = [CosineMatrix::Hamilton];

/// Two answers nearer to each other than single precision are not told apart, however many digits.
#[wasm_bindgen_test(unsupported = test)]
fn what_single_precision_cannot_tell_stays_open() {
    assert_eq!(rotations_left(0.0, 0.9e-5, [15, 15]), CosineMatrix::ALL);
    assert_eq!(rotations_left(0.0, 1.1e-5, [15, 15]), ONLY_R);
}

/// A library in single precision that prints eight decimals or more.
#[wasm_bindgen_test(unsupported = test)]
fn single_precision_in_eight_decimals_is_told() {
    for (seed, behaviour) in (0..).zip(Behaviour::all().step_by(5)) {
        let mut library = Simulated::new(behaviour, Noise::SingleInDecimals(8), seed);
        let (answers, report) = follow(&mut library, |report| report.possible == 1);
        assert_eq!(answers.len(), 5);
        let is_noisy = |observation: &ObservationReport| matches!(observation, ObservationReport::Told(told) if told.distance > 1e-8);
        assert!(report.observations.iter().any(is_noisy), "{report:#?}");
    }
    // A turn by some millionths: one digit of single precision is as much.
    let perturb = |rotation_vector: &str, printed: &str| Probe::Perturb {
        quaternion: "w: 0.5, x: 0.5, y: 0.5, z: 0.5".to_owned(),
        rotation_vector: rotation_vector.to_owned(),
        printed: printed.to_owned(),
    };
    let left = |rotation_vector: &str, printed: &str| {
        identify(vec![perturb(rotation_vector, printed)]).possible
    };
    let far = left("0.002 0 0", "w: 0.4995, x: 0.5005, y: 0.4995, z: 0.5005");
    assert_eq!(far, 64);
    let printed = "w: 0.499999, x: 0.500001, y: 0.499999, z: 0.500001";
    assert_eq!(left("0.000004 0 0", printed), 256);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_off_by_more_than_the_second_order_of_a_small_turn_is_a_mistake() {
    assert!(is_told_when_off(1.9e-3, 9));
    assert!(!is_told_when_off(2.1e-3, 9));
    assert!(
        !is_told_when_off(0.01, 9),
        "no rounding explains a hundredth"
    );
    // That is what [1, φ/2] on the right of q is, with a turn by 0.1 rad.
    let first_order = Probe::Perturb {
        quaternion: "w: 0.5, x: 0.5, y: 0.5, z: 0.5".to_owned(),
        rotation_vector: "0.1 0 0".to_owned(),
        printed: "w: 0.47500000, x: 0.52500000, y: 0.52500000, z: 0.47500000".to_owned(),
    };
    assert!(is_told(first_order));
}

/// Where the nearest is off itself, another that is not three times as far is possible too.
#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_clearly_farther_stays_possible() {
    assert_eq!(rotations_left(5e-4, 1.4e-3, [9, 9]), CosineMatrix::ALL);
    assert_eq!(rotations_left(5e-4, 1.6e-3, [9, 9]), ONLY_R);
    assert_eq!(
        rotations_left(1.4e-3, 5e-4, [9, 9]),
        CosineMatrix::ALL,
        "the nearest first or last"
    );
    assert_eq!(
        rotations_left(1.6e-3, 5e-4, [9, 9]),
        [CosineMatrix::Shuster]
    );
}

/// Two units of the last decimal are one rounding in each of some numbers.
#[wasm_bindgen_test(unsupported = test)]
fn rounded_numbers_tell_what_is_two_roundings_apart() {
    let half_unit = 0.5e-3;
    let (near, far) = (1.8 * half_unit, 2.2 * half_unit);
    assert_eq!(rotations_left(1e-4, near, [15, 3]), CosineMatrix::ALL);
    assert_eq!(rotations_left(1e-4, far, [15, 3]), ONLY_R);
    // Half a unit of the decimal before.
    assert_eq!(
        rotations_left(1e-3, 10.0 * near, [15, 2]),
        CosineMatrix::ALL
    );
    assert_eq!(rotations_left(1e-3, 10.0 * far, [15, 2]), ONLY_R);
}

#[wasm_bindgen_test(unsupported = test)]
fn rounded_numbers_are_believed_up_to_four_roundings() {
    let is_told_as = |printed: &str| {
        let quarter = std::f64::consts::FRAC_PI_2;
        is_told(rotate(quarter, "0 1 0".to_owned(), printed.to_owned()))
    };
    // Of two decimals: 4 × 0.005.
    assert!(is_told_as("-10.00 0.19 0.00"));
    assert!(!is_told_as("-10.00 0.21 0.00"));
    // Of three, where a small turn to first order may be as far off, and of four.
    assert!(is_told_as("-10.000 0.019 0.000"));
    assert!(!is_told_as("-10.000 0.021 0.000"));
    assert!(!is_told_as("-10.0000 0.0210 0.0000"));
}

/// A wrong sign is no rounding.
#[wasm_bindgen_test(unsupported = test)]
fn what_is_far_from_every_answer_is_not_believed_to_be_rounded() {
    let components = |printed: &str| Probe::Components {
        quaternion: "0.1 0.5 0.5 0.7".to_owned(),
        printed: printed.to_owned(),
    };
    let rotate = |printed: &str| Probe::Rotate {
        quaternion: "0.5 0.5 0.5 0.5".to_owned(),
        vector: "1 2 3".to_owned(),
        printed: printed.to_owned(),
    };
    let quarter_turn = |printed: &str| Probe::QuarterTurn {
        printed: printed.to_owned(),
    };
    let wrong = vec![
        components("0.1 -0.5 -0.5 -0.7"),
        rotate("3 1 3"),
        quarter_turn("0.8 0 0 0.6"),
    ];
    for report in identify(wrong).observations {
        assert!(
            matches!(report, ObservationReport::Unexplained(_)),
            "{report:?}"
        );
    }
    for report in identify(vec![
        quarter_turn("0.7 0 0 0.7"),
        quarter_turn("0.71 0 0 0.71"),
    ])
    .observations
    {
        assert!(matches!(report, ObservationReport::Told(_)), "{report:?}");
    }
}

/// With one decimal or none the roundings would allow anything.
#[wasm_bindgen_test(unsupported = test)]
fn coarse_numbers_have_a_limit() {
    let printed = |text: &str| {
        rotate(
            std::f64::consts::FRAC_PI_2,
            "0 1 0".to_owned(),
            text.to_owned(),
        )
    };
    // Off by the angle of (−1, 0.1), 0.0997, and of (−0.9, 0.1), 0.1107.
    assert!(is_told(printed("-1.0 0.1 0.0")));
    assert!(!is_told(printed("-0.9 0.1 0.0")));
    assert!(is_told(printed("-10 1 0")));
    assert!(!is_told(printed("-9 1 0")));
    for decimals in [1, 0] {
        // (0.6, 0.8) and (6, 8).
        let left = |off_c: f64| {
            let turn = (0.01 + off_c) / 2.0;
            let vector = plane_vector(AT_DEG.to_radians() - turn + 0.01, 15);
            let printed = if decimals == 1 {
                "0.6 0.8 0.0"
            } else {
                "6 8 0"
            };
            identify(vec![rotate(turn, vector, printed.to_owned())])
                .remaining
                .rotate
        };
        assert_eq!(left(0.045), CosineMatrix::ALL, "{decimals}");
        assert_eq!(left(0.055), ONLY_R, "{decimals}");
    }
}

/// Numbers that went in with three decimals or more may be rounded themselves; 0.60 is exact.
#[wasm_bindgen_test(unsupported = test)]
fn what_went_in_with_three_decimals_is_taken_for_rounded() {
    assert_eq!(rotations_left(1e-4, 9e-4, [3, 9]), CosineMatrix::ALL);
    assert_eq!(rotations_left(1e-4, 11e-4, [3, 9]), ONLY_R);
    assert_eq!(rotations_left(1e-4, 9e-4, [2, 9]), ONLY_R);
}

/// i and j have a product whose sign tells; where the two products are not quite opposite, q and −q are
/// one rotation.
#[wasm_bindgen_test(unsupported = test)]
fn the_sign_of_a_product_tells_where_nothing_else_does() {
    // The scalar of b is the half of how far a*b and −b*a are apart.
    let hands = |scalar: &str| {
        let product = Probe::Product {
            a: "w: 0, x: 1, y: 0, z: 0".to_owned(),
            b: format!("w: {scalar}, x: 0, y: 1, z: 0"),
            printed: "w: 0, x: 0, y: 0, z: 1".to_owned(),
        };
        identify(vec![product]).remaining.handedness
    };
    assert_eq!(hands("0.0000004"), [Handedness::Right]);
    assert_eq!(hands("0.0000006"), Handedness::ALL);
}

/// Sixteen observations are read again with every letter: a text that no library prints is measured, and not
/// worked on.
#[wasm_bindgen_test(unsupported = test)]
fn a_text_longer_than_any_print_is_measured_before_it_is_read() {
    let filled = |text: &str, bytes: usize| format!("{text}{}", " ".repeat(bytes - text.len()));
    let (quaternion, vector, matrix) = ("w: 1, x: 0, y: 0, z: 0", "1 2 3", "1 0 0\n0 1 0\n0 0 1");
    let text = str::to_owned;
    let probes = |fill: &dyn Fn(&str) -> String| {
        let printed = text(quaternion);
        [
            (
                Field::Quaternion,
                Probe::Components {
                    quaternion: fill(quaternion),
                    printed: printed.clone(),
                },
            ),
            (
                Field::A,
                Probe::Product {
                    a: fill(quaternion),
                    b: text(quaternion),
                    printed: printed.clone(),
                },
            ),
            (
                Field::B,
                Probe::Product {
                    a: text(quaternion),
                    b: fill(quaternion),
                    printed: printed.clone(),
                },
            ),
            (
                Field::Vector,
                Probe::Rotate {
                    quaternion: text(quaternion),
                    vector: fill(vector),
                    printed: text(vector),
                },
            ),
            (
                Field::Printed,
                Probe::Rotate {
                    quaternion: text(quaternion),
                    vector: text(vector),
                    printed: fill(vector),
                },
            ),
            (
                Field::Printed,
                Probe::Matrix {
                    quaternion: text(quaternion),
                    printed: fill(matrix),
                    layout: MatrixLayout::Rows,
                },
            ),
            (
                Field::Matrix,
                Probe::FromMatrix {
                    matrix: fill(matrix),
                    layout: MatrixLayout::Rows,
                    printed: printed.clone(),
                },
            ),
            (
                Field::Printed,
                Probe::FromMatrix {
                    matrix: text(matrix),
                    layout: MatrixLayout::Rows,
                    printed: fill(quaternion),
                },
            ),
            (
                Field::RotationVector,
                Probe::Perturb {
                    quaternion: text(quaternion),
                    rotation_vector: fill("0 0 0"),
                    printed,
                },
            ),
        ]
    };
    for (_, probe) in probes(&|text| filled(text, 4096)) {
        assert!(is_told(probe));
    }
    for (field, probe) in probes(&|text| filled(text, 4097)) {
        let length = probe.text(field).trim_end().len();
        let report = identify(vec![probe]);
        let [ObservationReport::Problem(found)] = &report.observations[..] else {
            panic!("{report:#?}")
        };
        let problem = &found.problem;
        assert_eq!(
            (problem.code, problem.field),
            (ProblemCode::TextTooLong, field)
        );
        assert_eq!((problem.span.start, problem.span.end), (0, length));
        assert_eq!(
            problem.message,
            "the text has 4097 bytes; at most 4096 are read"
        );
    }
}

/// What a library prints may be as small as a double can be: it is compared all the same.
#[wasm_bindgen_test(unsupported = test)]
fn tiny_numbers_that_a_library_printed_are_told_apart() {
    let rotated = |printed: &str| {
        let request = IdentifyRequest::new(vec![Probe::Rotate {
            quaternion: "0.5 0.5 0.5 0.5".to_owned(),
            vector: "1e-200 2e-200 3e-200".to_owned(),
            printed: printed.to_owned(),
        }]);
        match analyze(&Request::Identify(request)) {
            Outcome::Identify(report) => report.remaining.rotate,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(rotated("3e-200 1e-200 2e-200"), [CosineMatrix::Hamilton]);
    assert_eq!(rotated("2e-200 3e-200 1e-200"), [CosineMatrix::Shuster]);
}
