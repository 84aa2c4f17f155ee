//! A turn about an axis, and the rest.

use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::Vector3;
use quatlas::{
    Convention, Field, MatrixConvention, Outcome, ProblemCode, Request, Rotation, SwingTwistReport,
    SwingTwistRequest, TaggedQuaternion, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn request(text: &str, axis: &str, convention: Convention) -> Request {
    Request::SwingTwist(SwingTwistRequest {
        quaternion: text.to_owned(),
        axis: axis.to_owned(),
        convention,
        matrix: MatrixConvention::default(),
    })
}

#[track_caller]
fn ask(text: &str, axis: &str, convention: Convention) -> SwingTwistReport {
    match analyze(&request(text, axis, convention)) {
        Outcome::SwingTwist(report) => *report,
        outcome => panic!("{outcome:?}"),
    }
}

/// The question of the heading without the tilt.
#[wasm_bindgen_test(unsupported = test)]
fn the_heading_is_not_the_yaw() {
    let report = ask("yaw 65 pitch 20 roll -35 deg", "z", Convention::HAMILTON);
    let twist = report.twist_deg.expect("one is nearest");
    assert!((twist - 71.3642).abs() < 1e-4, "{twist}");
    assert!((report.swing.angle_deg - 39.6685).abs() < 1e-4);
    let down = ask(
        "yaw 65 pitch 20 roll -35 deg",
        "0 0 -2",
        Convention::HAMILTON,
    );
    assert_eq!(down.axis, [0.0, 0.0, -1.0]);
    assert_close(
        "the other way",
        &[down.twist_deg.expect("one")],
        &[-twist],
        1e-14,
    );
}

/// Both orders give the attitude again; the swings have no part along the axis; no turn about the axis is
/// nearer than the twist.
#[wasm_bindgen_test(unsupported = test)]
fn twist_and_swing_make_the_attitude() {
    let axis = Vector3::new(1.0, -2.0, 0.5);
    let typed = [0.1, -0.2, 0.4, 0.8];
    for convention in all_conventions() {
        let report = ask(&format!("{typed:?}"), "[1, -2, 0.5]", convention);
        let of = |array| {
            let numbers = TaggedQuaternion::from_array(array, convention);
            Rotation::from_tagged(&numbers).expect("not zero")
        };
        let attitude = of(typed);
        let twist = of(report.twist.array);
        let again = of(report.swing_quaternion.array) * twist;
        assert!(again.angle_to_rad(&attitude) < 1e-15, "{convention}");
        let again = twist * of(report.body_swing_quaternion.array);
        assert!(again.angle_to_rad(&attitude) < 1e-15, "{convention}");
        for swing in [&report.swing, &report.body_swing] {
            let along = Vector3::from(swing.rotation_vector_rad).dot(&axis);
            assert!(along.abs() < 1e-15, "{convention}");
        }
        let angle = report.twist_rad.expect("one is nearest");
        let about = |angle: f64| Rotation::from_axis_angle(axis.into(), angle).expect("an axis");
        assert!(about(angle).angle_to_rad(&twist) < 1e-15);
        let nearest = attitude.angle_to_rad(&twist);
        for other in [-0.1, 0.1, 1.0, 3.0] {
            assert!(attitude.angle_to_rad(&about(angle + other)) > nearest);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_ends_of_the_range() {
    let half = ask("180deg about z", "z", Convention::HAMILTON);
    assert_eq!(half.twist_deg, Some(180.0));
    let half = ask("-180deg about z", "z", Convention::HAMILTON);
    assert_eq!(half.twist_deg, Some(180.0), "not −180");
    assert!(half.swing.angle_rad < 1e-15);
    // Half a turn about a perpendicular axis: every twist is as near.
    let none = ask("0 1 0 0", "z", Convention::JPL);
    assert_eq!(none.twist_deg, None);
    let across = ask("0 1 0 0", "z", Convention::HAMILTON);
    assert_eq!((across.twist_rad, across.twist.w), (None, 1.0));
    assert_eq!(across.swing.angle_deg, 180.0);
    let nothing = ask("1 0 0 0", "1 1 1", Convention::HAMILTON);
    assert_eq!(
        (nothing.twist_rad, nothing.swing.angle_rad),
        (Some(0.0), 0.0)
    );
    // Half a turn too much: the other sign, the shorter twist.
    let negative = ask("-0.8 0 0 -0.6", "z", Convention::HAMILTON);
    let positive = ask("0.8 0 0 0.6", "z", Convention::HAMILTON);
    assert_close(
        "−q",
        &[negative.twist_rad.expect("one")],
        &[positive.twist_rad.expect("one")],
        1e-15,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn an_axis_of_no_length_is_a_problem() {
    for (axis, code) in [
        ("0 0 0", ProblemCode::ZeroAxis),
        ("", ProblemCode::EmptyText),
        ("1 2", ProblemCode::WrongCount),
    ] {
        let Outcome::Problems(found) = analyze(&request("1 0 0 0", axis, Convention::HAMILTON))
        else {
            panic!("problems");
        };
        assert_eq!(found.problems[0].code, code, "{axis}");
        assert_eq!(found.problems[0].field, Field::Axis);
    }
}
