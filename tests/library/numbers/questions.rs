//! Questions as people bring them, with two programs' numbers; the answers were computed with numpy.

use super::{matrix_of, numbers};
use crate::identify::identify;
use quatlas::{
    ComponentOrder, Direction, MatrixLayout, NumbersMeaning, NumbersReport, Probe, Rotation,
    TaggedMatrix,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// The sequence of the only reading that fits, what each number turns about, and of what.
#[track_caller]
fn told(report: &NumbersReport) -> (String, String, Direction) {
    assert!(report.decides, "{report:#?}");
    let reading = &report.readings[0];
    let NumbersMeaning::EulerAngles {
        sequence,
        turns_about,
        ..
    } = reading.meaning
    else {
        panic!("{reading:?}")
    };
    let axes = turns_about.map(|axis| ["x", "y", "z"][axis.index()]);
    (sequence.to_string(), axes.concat(), reading.direction)
}

fn is(sequence: &str, turns_about: &str, direction: Direction) -> (String, String, Direction) {
    (sequence.to_owned(), turns_about.to_owned(), direction)
}

/// The attitude that a text says.
fn attitude(text: &str) -> Rotation {
    let matrix = TaggedMatrix {
        entries: matrix_of(text),
        convention: quatlas::MatrixConvention::BODY_TO_WORLD,
    };
    Rotation::nearest_to_matrix(&matrix)
        .expect("a rotation")
        .rotation
}

#[track_caller]
fn assert_near(found: [f64; 3], expected: [f64; 3], tolerance: f64) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{found} {expected}");
    }
}

fn angles_deg(text: &str, sequence: &str) -> [f64; 3] {
    let sequence = sequence.parse().expect("a sequence");
    attitude(text)
        .euler(sequence)
        .angles_rad
        .map(f64::to_degrees)
}

/// Moving z, y, x, and an engine's moving y, x, z with its numbers in the order x, y, z, from 0 to 360.
#[wasm_bindgen_test(unsupported = test)]
fn which_sequences_two_programs_print() {
    let q = "w=0.77781 x=-0.52878 y=-0.19588 z=0.27755";
    use Direction::BodyToWorld;
    let first = numbers("-68.65, -0.64, 39.71", q);
    // Roll, pitch, yaw about fixed axes: z, y, x about moving ones.
    assert_eq!(told(&first), is("xyz", "xyz", BodyToWorld));
    let second = numbers("314.45, 301.32, 65.83", q);
    assert_eq!(told(&second), is("YXZ", "xyz", BodyToWorld));
    assert_near(angles_deg(q, "ZYX"), [39.7141, -0.6411, -68.6498], 0.01);
    assert_near(angles_deg(q, "YXZ"), [-58.6784, -45.5489, 65.8318], 0.01);
}

/// Moving x, y, z of q, and roll, pitch, yaw of its conjugate: the same numbers with the other sign.
#[wasm_bindgen_test(unsupported = test)]
fn whether_one_of_two_programs_is_reversed() {
    let q = "[0.494, -0.352, 0.785, -0.124]";
    let converter = numbers("(-162.335, 59.686, 121.508) degrees", q);
    assert_eq!(told(&converter), is("XYZ", "xyz", Direction::BodyToWorld));
    let sensor = numbers("(162.335, -59.686, -121.508)", q);
    assert_eq!(told(&sensor), is("xyz", "xyz", Direction::WorldToBody));
    let conjugate = "[0.494, 0.352, -0.785, 0.124]";
    assert_near(angles_deg(q, "XYZ"), [-162.3347, 59.686, 121.5076], 0.001);
    assert_near(
        angles_deg(conjugate, "xyz"),
        [162.3347, -59.686, -121.5076],
        0.001,
    );
    assert_near(angles_deg(q, "xyz"), [-131.5469, 43.5194, -111.3317], 0.001);
}

/// A triple that is called roll, pitch, yaw and is moving x, y, z.
#[wasm_bindgen_test(unsupported = test)]
fn whether_three_numbers_can_go_into_a_urdf() {
    // x y z w, as it was printed.
    let q = "x: -0.700565, y: 0.452149, z: -0.533382, w: 0.142381";
    let report = numbers("rpy=\"2.514692 1.067699 1.524884\"", q);
    assert_eq!(told(&report), is("XYZ", "xyz", Direction::BodyToWorld));
    let as_urdf = attitude("rpy=\"2.514692 1.067699 1.524884\"");
    let apart_deg = attitude(q).angle_to_rad(&as_urdf).to_degrees();
    assert!((apart_deg - 164.836).abs() < 0.001, "{apart_deg}");
    let urdf = angles_deg(q, "xyz").map(f64::to_radians);
    assert_near(urdf, [-2.090875, -0.666939, -1.542629], 0.001);
}

/// The other solution, with the pitch beyond 90°, is the same attitude.
#[wasm_bindgen_test(unsupported = test)]
fn whether_two_triples_are_one_attitude() {
    let first = "rpy 76.41837 -8.21011 33.69479 deg";
    let report = numbers("[-103.582, -171.79, -146.305]", first);
    assert_eq!(told(&report), is("xyz", "xyz", Direction::BodyToWorld));
    let apart_deg = report.readings[0].off_deg;
    assert!((apart_deg - 0.00041).abs() < 0.0001, "{apart_deg}");
}

/// Of one printed matrix: as four numbers beside it, and as what a library printed.
#[wasm_bindgen_test(unsupported = test)]
fn in_which_order_a_constructor_takes_four_numbers() {
    let given = "0.93120417, -0.22159990, 0.28939987, 0.00000000";
    let printed = "[[0.832495, -0.128262, 0.538981], [-0.128262, 0.901787, 0.412709], [-0.538981, -0.412709, 0.734282]]";
    let order = |order| NumbersMeaning::Quaternion { order };
    let report = numbers(given, printed);
    assert!(report.decides, "{report:#?}");
    assert_eq!(
        report.readings[0].meaning,
        order(ComponentOrder::ScalarFirst)
    );
    assert_eq!(report.readings[0].direction, Direction::BodyToWorld);
    let other = report.readings.iter().find(|reading| {
        let is_of_q = reading.direction == Direction::BodyToWorld;
        is_of_q && reading.meaning == order(ComponentOrder::ScalarLast)
    });
    let between_deg = other.expect("the colleague's").off_deg;
    assert!((between_deg - 148.6137).abs() < 0.001, "{between_deg}");
    let angle_deg = attitude(printed).angle_rad().to_degrees();
    assert!((angle_deg - 42.7534).abs() < 0.001, "{angle_deg}");

    let report = identify(vec![Probe::Matrix {
        quaternion: given.to_owned(),
        printed: printed.to_owned(),
        layout: MatrixLayout::AsWritten,
    }]);
    assert_eq!(report.remaining.constructor, [ComponentOrder::ScalarFirst]);
}
