//! Cases of the documents: the camera on a moving body, and a chain of named quaternions.

use crate::frames::{CLOSE, answered, asked, report, rig};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Quaternion, UnitQuaternion, Vector3};
use quatlas::{Components, Convention, FramesRequest, GivenPose, PathStep, Side};
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

fn golden(member: &str, name: &str) -> Vec<f64> {
    let all: Value = serde_json::from_str(include_str!("../../vectors/golden.json")).expect("JSON");
    let cases = all["cases"].as_array().expect("a list of cases");
    let case = cases.iter().find(|case| case["id"] == "G29").expect("G29");
    serde_json::from_value(case[member][name].clone()).expect("numbers")
}

/// G29, 002-S2.3 to 002-S2.6: the second body by way of the cameras, and where the printed formula puts it.
#[wasm_bindgen_test(unsupported = test)]
fn the_second_body_is_found_over_the_cameras() {
    let report = asked(&rig(), "I2", "G");
    let answer = answered(&report);
    let turned = golden("input", "v_GI2");
    assert_close("ᴳR_I2", &answer.turn.rotation_vector_rad, &turned, CLOSE);
    let position = answer.position.expect("a position");
    assert_close(
        "ᴳp_I2",
        &position,
        &golden("output", "p_GI2_corrected"),
        CLOSE,
    );
    let misprinted = answer.misprinted_position.expect("an inverted pose");
    let printed = golden("output", "p_GI2_as_printed");
    assert_close("as printed", &misprinted, &printed, CLOSE);
    assert_close(
        "E10",
        answer.misprinted_distance.as_slice(),
        &[0.341_631],
        1e-6,
    );
    let step = |pose, inverted, frame| PathStep {
        pose,
        inverted,
        frame,
    };
    let names = ["G", "I1", "C1", "I2", "C2"];
    assert_eq!(
        report
            .frames
            .iter()
            .map(|frame| &*frame.name)
            .collect::<Vec<_>>(),
        names
    );
    let path = [
        step(0, false, 1),
        step(1, false, 2),
        step(3, false, 4),
        step(2, true, 3),
    ];
    assert_eq!(report.path, path);
    assert!(report.loops.is_empty() && report.notes.is_empty());
}

/// 002-S2.4: at rest, with the camera a metre ahead and yawed by a quarter turn.
#[wasm_bindgen_test(unsupported = test)]
fn at_rest_the_printed_formula_moves_the_body() {
    let camera = |body| GivenPose::new(body, "C", "90 deg about z", "1 0 0");
    let report = asked(&[camera("I1"), camera("I2")], "I2", "I1");
    let answer = answered(&report);
    assert_close("at rest", &answer.position.expect("one"), &[0.0; 3], CLOSE);
    let misprinted = answer.misprinted_position.expect("one");
    assert_close("as printed", &misprinted, &[1.0, -1.0, 0.0], CLOSE);
    let ahead = asked(&[camera("I1")], "C", "I1");
    let off = answered(&ahead).misprinted_distance;
    assert_eq!(off, Some(0.0), "nothing is taken back");
}

/// The same rig typed in each convention is one rig.
#[wasm_bindgen_test(unsupported = test)]
fn all_conventions_give_one_frame() {
    let wanted = asked(&rig(), "I2", "G");
    for convention in all_conventions() {
        let mut poses = rig();
        for (pose, read) in poses.iter_mut().zip(&wanted.poses) {
            let unit = read.unit.expect("read");
            let conjugated = is_conjugated(convention);
            pose.rotation = written(unit, conjugated, convention);
        }
        let report = report(FramesRequest::new(poses, "I2", "G", convention));
        let (answer, expected) = (answered(&report), answered(&wanted));
        let position = answer.position.expect("a position");
        assert_close(
            "position",
            &position,
            &expected.position.expect("one"),
            CLOSE,
        );
        for (got, wanted) in answer.hamilton.matrix.iter().zip(&expected.hamilton.matrix) {
            assert_close(&convention.to_string(), got, wanted, CLOSE);
        }
        let sign = if is_conjugated(convention) { -1.0 } else { 1.0 };
        let (got, wanted) = (answer.declared.unit, expected.hamilton.unit);
        let wanted = [wanted.w, sign * wanted.x, sign * wanted.y, sign * wanted.z];
        assert_close("declared", &[got.w, got.x, got.y, got.z], &wanted, CLOSE);
    }
}

/// Each of three choices turns the sign of the vector part round (specification, MODEL-02).
pub(crate) fn is_conjugated(convention: Convention) -> bool {
    use quatlas::{Direction, Function, Handedness};
    (convention.handedness == Handedness::Left)
        ^ (convention.function == Function::Active)
        ^ (convention.direction == Direction::WorldToBody)
}

fn written(unit: Components, is_conjugated: bool, convention: Convention) -> String {
    let sign = if is_conjugated { -1.0 } else { 1.0 };
    let Components { w, x, y, z, .. } = unit;
    let numbers = convention.order.array([w, sign * x, sign * y, sign * z]);
    let [first, second, third, fourth] = numbers;
    format!("{first:?} {second:?} {third:?} {fourth:?}")
}

/// Cheng 2018, eqs. 2.23 to 2.26: three named quaternions of a JPL filter in one chain.
#[wasm_bindgen_test(unsupported = test)]
fn named_quaternions_are_multiplied_in_the_order_of_their_convention() {
    let chain = [
        GivenPose::new("W", "B", "0.1 -0.2 0.3 0.9", ""),
        GivenPose::new("B", "C", "-0.5 0.1 0.2 0.7", ""),
        GivenPose::new("C", "D", "0.2 0.6 -0.1 0.4", ""),
    ];
    let request = FramesRequest::new(chain.to_vec(), "D", "W", Convention::JPL);
    let report = report(request);
    let answer = answered(&report);
    // Body to world these numbers are Hamilton's, and the world stands on the left.
    let [b, c, d] = [
        [0.1, -0.2, 0.3, 0.9],
        [-0.5, 0.1, 0.2, 0.7],
        [0.2, 0.6, -0.1, 0.4],
    ]
    .map(|[x, y, z, w]| UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)));
    let expected = (b * c * d).coords;
    assert_close("q_WD", &answer.jpl.unit.array, expected.as_slice(), CLOSE);
    assert_eq!(answer.jpl.rules.chain_first, Side::Right);
    assert_eq!(answer.hamilton.rules.chain_first, Side::Left);
    assert_eq!(answer.position, None, "no position is known");
    assert_eq!(answer.homogeneous, None);
    let reverse = FramesRequest::new(chain.to_vec(), "W", "D", Convention::JPL);
    let reverse = crate::frames::report(reverse);
    let conjugate = (b * c * d).conjugate().coords;
    assert_close(
        "q_DW",
        &answered(&reverse).jpl.unit.array,
        conjugate.as_slice(),
        CLOSE,
    );
    assert!(reverse.path.iter().all(|step| step.inverted));
}

/// 003-S2.b: a point in every frame, and a frame beside the way too.
#[wasm_bindgen_test(unsupported = test)]
fn a_point_is_told_in_every_frame() {
    let mut poses = rig();
    poses.push(GivenPose::new("I1", "radar", "90 deg about z", "0 0 2"));
    let mut request = FramesRequest::new(poses, "I2", "G", Convention::HAMILTON);
    request.point = "0.5 -1.5 2".to_owned();
    let report = report(request);
    let point = |name: &str| {
        let frame = report.frames.iter().find(|frame| frame.name == name);
        frame.expect(name).point.expect("joined")
    };
    assert_eq!(point("I2"), [0.5, -1.5, 2.0], "as typed");
    let turn = |v: [f64; 3]| UnitQuaternion::from_scaled_axis(Vector3::from(v));
    let in_g = turn([0.3, -0.1, 0.4]) * Vector3::new(0.5, -1.5, 2.0) + Vector3::new(1.5, 1.0, 2.5);
    assert_close("in G", &point("G"), in_g.as_slice(), CLOSE);
    let in_i1 = turn([0.1, 0.2, -0.3]).inverse() * (in_g - Vector3::new(1.0, 2.0, 3.0));
    assert_close("in I1", &point("I1"), in_i1.as_slice(), CLOSE);
    let in_radar = [in_i1.y, -in_i1.x, in_i1.z - 2.0];
    assert_close("beside the way", &point("radar"), &in_radar, CLOSE);
    let turned = answered(&report).hamilton.image.expect("finite");
    let expected = in_g - Vector3::new(1.5, 1.0, 2.5);
    assert_close("without the position", &turned, expected.as_slice(), CLOSE);
}
