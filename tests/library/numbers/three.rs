//! Three numbers beside a quaternion or a matrix.

use super::{about, components, elementary, matrix_of, numbers, rows};
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    AngleUnit, Axis, Direction, EulerFrame, EulerSequence, NumbersMeaning, NumbersReport,
};
use wasm_bindgen_test::wasm_bindgen_test;

const UNITS: [AngleUnit; 2] = [AngleUnit::Radians, AngleUnit::Degrees];

/// The 54 that have their numbers in their order.
fn meanings() -> Vec<NumbersMeaning> {
    let euler = EulerSequence::all().flat_map(|sequence| {
        UNITS.map(|unit| NumbersMeaning::EulerAngles {
            sequence,
            unit,
            turns_about: sequence.axes.axes(),
        })
    });
    let vectors = UNITS.into_iter().flat_map(|unit| {
        [
            NumbersMeaning::RotationVector { unit },
            NumbersMeaning::HalfAngleVector { unit },
        ]
    });
    let others = [
        NumbersMeaning::GibbsVector,
        NumbersMeaning::ModifiedRodrigues,
    ];
    euler.chain(vectors).chain(others).collect()
}

/// The matrix body to world of the numbers, by elementary turns and Rodrigues' formula alone.
fn matrix(meaning: &NumbersMeaning, numbers: [f64; 3]) -> Matrix3<f64> {
    let in_rad = |unit: AngleUnit, number: f64| match unit {
        AngleUnit::Radians => number,
        AngleUnit::Degrees => number.to_radians(),
    };
    let vector = Vector3::from(numbers);
    let turn = |angle_rad: f64| about(vector.normalize(), angle_rad);
    match *meaning {
        NumbersMeaning::EulerAngles {
            sequence,
            unit,
            turns_about,
        } => {
            // Of an axis that stands twice the numbers are in order.
            let mut left: Vec<_> = turns_about.into_iter().zip(numbers).collect();
            let [a, b, c] = sequence.axes.axes().map(|axis| {
                let at = left.iter().position(|(other, _)| *other == axis);
                let (axis, angle) = left.remove(at.expect("each axis"));
                elementary(axis.index(), in_rad(unit, angle))
            });
            match sequence.frame {
                EulerFrame::Intrinsic => a * b * c,
                EulerFrame::Extrinsic => c * b * a,
            }
        }
        NumbersMeaning::RotationVector { unit } => turn(in_rad(unit, vector.norm())),
        NumbersMeaning::HalfAngleVector { unit } => turn(2.0 * in_rad(unit, vector.norm())),
        NumbersMeaning::GibbsVector => turn(2.0 * vector.norm().atan()),
        NumbersMeaning::ModifiedRodrigues => turn(4.0 * vector.norm().atan()),
        _ => panic!("{meaning:?}"),
    }
}

fn text(numbers: impl IntoIterator<Item = impl std::fmt::Display>) -> String {
    let words: Vec<String> = numbers
        .into_iter()
        .map(|number| number.to_string())
        .collect();
    words.join(" ")
}

/// 108 readings, by one print each: the matrix and the quaternion with four decimals, and the quaternion in
/// single precision. In degrees the first are small turns, nearly the same in any order.
#[wasm_bindgen_test(unsupported = test)]
#[expect(
    clippy::cast_possible_truncation,
    reason = "as a program prints in single precision"
)]
fn every_reading_is_told_by_one_print() {
    let in_degrees = |meaning: &NumbersMeaning| format!("{meaning:?}").contains("Degrees");
    for (given, margin_deg) in [([0.7, -0.4, 1.1], 9.04), ([30.0, 20.0, 10.0], 2.78)] {
        let is_told = |meaning: &NumbersMeaning| given[0] > 1.0 || !in_degrees(meaning);
        let told: Vec<_> = meanings().into_iter().filter(is_told).collect();
        assert_eq!(told.len(), if given[0] > 1.0 { 54 } else { 28 });
        for (meaning, direction) in told
            .iter()
            .flat_map(|meaning| Direction::ALL.map(|direction| (meaning, direction)))
        {
            let described = matrix(meaning, given);
            let attitude = match direction {
                Direction::BodyToWorld => described,
                Direction::WorldToBody => described.transpose(),
            };
            let q = components(&attitude);
            for (print, most_off_deg) in [
                (rows(&attitude, 4), 0.01),
                (text(q.map(|number| format!("{number:.4}"))), 0.02),
                (text(q.map(|number| number as f32)), 2e-5),
            ] {
                let report = numbers(&text(given), &print);
                let first = &report.readings[0];
                assert_eq!((&first.meaning, first.direction), (meaning, direction));
                assert!(report.decides && report.fitting == 1, "{report:#?}");
                assert!(first.off_deg < most_off_deg, "{report:#?}");
                let margin = report.margin_deg.expect("others do not fit");
                assert!(margin > margin_deg, "{margin}: {report:#?}");
                // Its text says the attitude itself, also where the numbers are those of the inverse.
                let back = matrix_of(first.text.as_deref().expect("of numbers"));
                assert!((back - attitude).norm() < 5e-4, "{first:?}");
            }
        }
    }
}

/// Three different axes, with the numbers in any order: 144 of each unit, less those that are the same.
#[wasm_bindgen_test(unsupported = test)]
fn numbers_in_another_order_are_told() {
    let given = [30.0, 20.0, 10.0];
    let unit = AngleUnit::Degrees;
    let sequences = EulerSequence::all().filter(|sequence| !sequence.is_proper());
    for sequence in sequences {
        let orders = EulerSequence::all().map(|other| other.axes.axes());
        for turns_about in orders.filter(|[first, _, third]| first != third) {
            let meaning = NumbersMeaning::EulerAngles {
                sequence,
                unit,
                turns_about,
            };
            let attitude = matrix(&meaning, given);
            let report = numbers(&text(given), &rows(&attitude, 5));
            assert!(report.decides, "{meaning:?}: {report:#?}");
            let first = &report.readings[0];
            assert_eq!(first.direction, Direction::BodyToWorld);
            // The same about other axes backwards: what is told has the same matrix, and where it can its
            // numbers in their order.
            assert!((matrix(&first.meaning, given) - attitude).norm() < 1e-12);
            let NumbersMeaning::EulerAngles {
                sequence: told,
                turns_about: order,
                ..
            } = first.meaning
            else {
                panic!("{first:?}")
            };
            let axes = sequence.axes.axes();
            let [x, y, z] = axes;
            let has_order = turns_about == axes || turns_about == [z, y, x];
            assert_eq!(order == told.axes.axes(), has_order, "{first:?}");
            let back = matrix_of(first.text.as_deref().expect("of numbers"));
            assert!((back - attitude).norm() < 1e-12, "{first:?}");
        }
    }
}

/// What is said of a sequence in a few words.
fn named(report: &NumbersReport) -> (String, String, Direction) {
    let first = &report.readings[0];
    match first.meaning {
        NumbersMeaning::EulerAngles {
            sequence,
            unit,
            turns_about,
        } => (
            format!("{sequence} {unit:?}"),
            turns_about
                .map(|axis| ["x", "y", "z"][axis.index()])
                .concat(),
            first.direction,
        ),
        _ => panic!("{first:?}"),
    }
}

/// Three tools of one thread made three rotations of the same "Euler XYZ".
#[wasm_bindgen_test(unsupported = test)]
fn what_three_tools_mean_by_one_triple_is_told() {
    let given = "0.68, -1.083, -2.076";
    let angles = [0.68, -1.083, -2.076];
    let in_order = |frame: EulerFrame, unit| NumbersMeaning::EulerAngles {
        sequence: EulerSequence {
            axes: quatlas::EulerAxes::Xyz,
            frame,
        },
        unit,
        turns_about: [Axis::X, Axis::Y, Axis::Z],
    };
    let tools = [
        in_order(EulerFrame::Intrinsic, AngleUnit::Degrees),
        in_order(EulerFrame::Intrinsic, AngleUnit::Radians),
        in_order(EulerFrame::Extrinsic, AngleUnit::Radians),
    ];
    let matrices = tools.each_ref().map(|tool| matrix(tool, angles));
    for (tool, print) in tools.iter().zip(&matrices) {
        let report = numbers(given, &rows(print, 6));
        assert!(report.decides, "{report:#?}");
        assert_eq!(report.readings[0].meaning, *tool);
    }
    // As the thread's research computed them with other means.
    let apart_deg = |one: usize, other: usize| {
        let trace = (matrices[one].transpose() * matrices[other]).trace();
        ((trace - 1.0) / 2.0).acos().to_degrees()
    };
    assert!(
        (apart_deg(0, 1) - 147.5).abs() < 0.05,
        "{}",
        apart_deg(0, 1)
    );
    assert!(
        (apart_deg(1, 2) - 124.0).abs() < 0.05,
        "{}",
        apart_deg(1, 2)
    );
}

/// Angles from 0 to 360, and the other solution with the middle angle beyond a quarter turn, are the same.
#[wasm_bindgen_test(unsupported = test)]
fn whole_turns_and_the_other_solution_are_the_same() {
    let print = rows(
        &(elementary(2, 0.7) * elementary(1, -0.4) * elementary(0, 1.1)),
        8,
    );
    let [yaw, pitch, roll] = [0.7_f64, -0.4, 1.1].map(f64::to_degrees);
    for angles in [
        [yaw, pitch, roll],
        [yaw, pitch + 360.0, roll],
        [yaw - 180.0, 180.0 - pitch, roll + 180.0],
        [yaw + 180.0, 180.0 - pitch, roll + 180.0],
    ] {
        let report = numbers(&text(angles.map(|angle| format!("{angle:.5}"))), &print);
        assert!(report.decides, "{report:#?}");
        let expected = ("ZYX Degrees".to_owned(), "zyx".to_owned());
        let (sequence, order, direction) = named(&report);
        assert_eq!(
            ((sequence, order), direction),
            (expected, Direction::BodyToWorld)
        );
    }
}

/// The unit that the text says is that of its numbers; a word for them changes nothing.
#[wasm_bindgen_test(unsupported = test)]
fn a_unit_in_the_text_counts() {
    let print = rows(&elementary(2, 0.5), 6);
    let units = |given: &str| {
        let report = numbers(given, &print);
        let fitting = report.readings.into_iter().take(report.fitting);
        let of = |meaning| match meaning {
            NumbersMeaning::EulerAngles { unit, .. }
            | NumbersMeaning::RotationVector { unit }
            | NumbersMeaning::HalfAngleVector { unit } => Some(unit),
            _ => None,
        };
        fitting
            .filter_map(|reading| of(reading.meaning))
            .collect::<Vec<_>>()
    };
    let all_are = |units: &[AngleUnit], unit| units.iter().all(|other| *other == unit);
    let degrees = units("rpy 0 0 28.6479 degrees");
    assert!(!degrees.is_empty() && all_are(&degrees, AngleUnit::Degrees));
    let radians = units("x: 0 y: 0 z: 0.5");
    assert!(!radians.is_empty() && all_are(&radians, AngleUnit::Radians));
    assert!(units("0 0 0.5 deg").is_empty());
    assert!(units("0 0 28.6479 rad").is_empty());
}

/// One angle alone tells no sequence, and equal ones not all: what fits is counted, and nothing is decided.
#[wasm_bindgen_test(unsupported = test)]
fn what_does_not_decide_says_so() {
    let report = numbers("0 0 90", "0.707107 0 0 0.707107");
    // Eight sequences end about z, and the rotation vector.
    assert_eq!((report.fitting, report.decides), (9, false), "{report:#?}");
    for reading in &report.readings[..9] {
        let turned = matrix(&reading.meaning, [0.0, 0.0, 90.0]);
        assert!((turned - elementary(2, std::f64::consts::FRAC_PI_2)).norm() < 1e-5);
    }
}

/// Where none fits, the nearest comes first, with its angle.
#[wasm_bindgen_test(unsupported = test)]
fn what_does_not_fit_says_how_far_the_nearest_is() {
    let attitude = elementary(0, 0.7) * elementary(1, -0.4) * elementary(2, 1.1);
    // 3° more about the body's axis: nine are between it and any other.
    let turned = attitude * elementary(2, 3.0_f64.to_radians());
    let report = numbers("0.7 -0.4 1.1", &rows(&turned, 6));
    assert_eq!((report.fitting, report.decides), (0, false));
    let first = &report.readings[0];
    assert!((first.off_deg - 3.0).abs() < 1e-3, "{first:?}");
    assert_eq!(named(&report).0, "XYZ Radians");
    assert_eq!(report.margin_deg, Some(first.off_deg));
    assert!(report.readings.is_sorted_by_key(|reading| reading.off_deg));
}

/// Whole degrees are rounded, by up to half of one each: the nearest is taken where no other is near.
#[wasm_bindgen_test(unsupported = test)]
fn coarse_numbers_are_believed_as_far_as_they_are_rounded() {
    let [yaw, pitch, roll] = [39.7141_f64, -0.6411, -68.6498].map(f64::to_radians);
    let attitude = elementary(2, yaw) * elementary(1, pitch) * elementary(0, roll);
    let report = numbers("40 -1 -69", &rows(&attitude, 6));
    assert!(report.decides, "{report:#?}");
    assert_eq!(named(&report).0, "ZYX Degrees");
    assert!(report.readings[0].off_deg > 0.3);
    // With three decimals the same is none.
    let report = numbers("40.000 -1.000 -69.000", &rows(&attitude, 6));
    assert_eq!(report.fitting, 0, "{report:#?}");
}
