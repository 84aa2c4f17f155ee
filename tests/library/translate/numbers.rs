//! Ends that have no quaternion: Euler angles, a rotation vector, axis and angle, a matrix.

use super::{between, body_to_world, end, problems, translate};
use crate::support::assert_close;
use quatlas::{
    AngleUnit, Direction, EndNumbers, Endpoint, Form, RecordNumbersKind, TranslateRequest,
    libraries,
};
use std::collections::HashSet;
use wasm_bindgen_test::wasm_bindgen_test;

/// Of each record its id, what it writes, and w x y z of the same body to world, by `SciPy` 1.17.1.
const WRITTEN: &str = "\
kuka-abc: 30 -20 100: 0.577023828058 0.757589824726 0.087439196331 0.292327806187
fanuc-wpr: 100 -20 30: 0.577023828058 0.757589824726 0.087439196331 0.292327806187
yaskawa-rxryrz: 15 -40 75: 0.71195366783 0.303735774153 -0.194354119207 0.602572012883
mitsubishi-abc: -65 35 110: 0.3290103945 -0.50166613451 -0.274293242636 0.751562683241
kawasaki-oat: -56.5 99.4 110.3: 0.576805527541 0.757613947906 0.087658924586 0.292630145879
doosan-abc: 20 70 -130: 0.469846310393 -0.554032293222 0.14845250555 -0.671010071663
comau-euler: -35 50 80: 0.837319214599 0.356432626796 0.227072626513 0.346828974722
staubli-rxryrz: 101.2 32.9 14.1: 0.57728957127 0.75756099157 0.08742341724 0.291882238366
nachi-rpy: 25 -55 140: 0.202270829491 0.847941570452 0.02622239473 0.489279051924
catia-solidworks-zxz: 33.5 99.4 20.3: 0.576805527541 0.757613947906 0.087658924586 0.292630145879
robodk-txyzrxyz: -80 45 10: 0.726478578018 -0.566048580814 0.343795145653 -0.183365148448
robots-sxyz: 12 -34 56: 0.825393853748 0.224768658483 -0.209805848125 0.473482357064
robots-rzyx: 12 -34 56: 0.825393853748 0.473482357064 -0.209805848125 0.224768658483
robots-rxyz: 12 -34 56: 0.854089049532 -0.048247892291 -0.303663604393 0.419514542925
ufactory-xarm: -21 43 65: 0.735680244074 -0.336624855777 0.212826117134 0.547871635347
kitti-oxts: 0.1 -0.2 1.3: 0.788097135576 0.099931154655 -0.049280835305 0.605382580273
urdf-rpy: 0.4 -0.6 2.1: 0.41494535707 0.345668360656 0.020522268737 0.841375404664
sdf-pose: -0.3 0.5 1.7: 0.604509327935 -0.279343214961 0.052669217366 0.744151727967
bvh-channels: 40 -15 70: 0.788771739628 -0.294969077387 0.497805382264 0.20741790554
carla-rotation: 10 30 -50: 0.862561598084 0.427108599172 0.032667012929 0.269255641148
bunge-euler: 33.5 99.4 20.3: 0.576805527541 0.757613947906 0.087658924586 0.292630145879
oxford-ctf: 12 47 81: 0.631262498389 0.32861955039 -0.225853959607 0.665211874638
edax-ang: 0.6 1.7 0.35: 0.586918208029 0.745418665415 0.093665684208 0.301835667103
ur-rotvec: 0.3 -1.1 0.7: 0.784470535273 0.139060169719 -0.509887288969 0.324473729344
opencv-rvec-tvec: 0.3 -1.1 0.7: 0.784470535273 -0.139060169719 0.509887288969 -0.324473729344
x3d-vrml-rotation: 2 -6 9 1.2: 0.82533561491 0.10266226789 -0.30798680367 0.461980205505";

/// The parts of a line of [`WRITTEN`].
fn parts(line: &str) -> (&str, &str, [f64; 4]) {
    let mut parts = line.split(": ");
    let mut next = || parts.next().expect("three parts");
    let (id, text) = (next(), next());
    let numbers: Vec<f64> = numbers_of(next());
    (id, text, numbers.try_into().expect("four numbers"))
}

fn numbers_of(text: &str) -> Vec<f64> {
    text.split(' ')
        .map(|number| number.parse().expect("a number"))
        .collect()
}

fn written(text: &str, from: &str, to: &str) -> EndNumbers {
    between(text, from, to).to.numbers.expect("no quaternion")
}

fn in_text(numbers: &EndNumbers) -> String {
    let numbers: Vec<String> = numbers.values.iter().map(f64::to_string).collect();
    numbers.join(", ")
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_are_those_of_their_own_end() {
    for (id, text, [w, x, y, z]) in WRITTEN.lines().map(parts) {
        let mut found = between(text, id, "eigen").to.array;
        if found[3] < 0.0 {
            found = found.map(|number| -number);
        }
        assert_close(id, &found, &[x, y, z, w], 1e-11);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_end_writes_its_own_numbers() {
    for (id, text, [w, x, y, z]) in WRITTEN.lines().map(parts) {
        let found = written(&format!("{x} {y} {z} {w}"), "eigen", id).values;
        let mut expected = numbers_of(text);
        if id == "x3d-vrml-rotation" {
            // A unit axis: 2, -6, 9 has length 11.
            expected[..3].iter_mut().for_each(|number| *number /= 11.0);
        }
        assert_close(id, &found, &expected, 1e-9);
    }
}

/// Every one is tried: none of angles, vectors and axes is left out above.
#[wasm_bindgen_test(unsupported = test)]
fn every_record_without_a_quaternion_is_tried() {
    let tried: HashSet<&str> = WRITTEN.lines().map(|line| parts(line).0).collect();
    for library in libraries() {
        let Some(numbers) = library.numbers else {
            continue;
        };
        let id = library.id;
        let is_matrix = numbers.kind == RecordNumbersKind::Matrix;
        assert_eq!(!is_matrix, tried.contains(id), "{id}");
        assert_eq!(is_matrix, numbers.unit.is_none(), "{id}: a unit of angles");
        let is_euler = numbers.kind == RecordNumbersKind::EulerAngles;
        assert_eq!(is_euler, numbers.means.is_some(), "{id}: a product");
        assert!(
            library.array_order.is_none() && library.constructor_order.is_none(),
            "{id}"
        );
        assert!(is_matrix || library.direction.is_some(), "{id}: direction");
    }
}

/// Computed with numpy: KUKA A -118.4, B 21.3, C 76.9 is this vector of a UR.
#[wasm_bindgen_test(unsupported = test)]
fn from_one_controller_to_another() {
    for text in [
        "-118.4 21.3 76.9",
        "A -118.4, B 21.3, C 76.9",
        "{A -118.4, B 21.3, C 76.9}",
        "a = -118.4; b = 21.3; c = 76.9",
    ] {
        let report = between(text, "kuka-abc", "ur-rotvec");
        let numbers = report.to.numbers.expect("a vector");
        assert_close(
            text,
            &numbers.values,
            &[1.163317, -1.199443, -1.915499],
            1e-6,
        );
        assert_eq!(numbers.kind, RecordNumbersKind::RotationVector);
        assert_eq!(numbers.names.as_deref(), Some("Rx Ry Rz"));
        assert_eq!(numbers.unit, Some(AngleUnit::Radians));
        assert!(matches!(report.quaternion.form, Form::EulerAngles(_)));
        // What is said of angles without a unit is not said: the controller has one.
        assert_eq!(report.notes, []);
        assert_eq!(report.from.assumed, []);
        // Three numbers are neither conjugated nor reordered.
        assert_eq!(report.mistakes, []);
    }
}

/// The same letters are other axes elsewhere.
#[wasm_bindgen_test(unsupported = test)]
fn the_same_letters_elsewhere() {
    let of = |id| between("A 30 B -20 C 100", id, "eigen").to.array;
    // A about z and C about x of a KUKA; the other way round of a Mitsubishi.
    assert_ne!(of("kuka-abc"), of("mitsubishi-abc"));
    assert_eq!(
        of("mitsubishi-abc"),
        between("30 -20 100", "fanuc-wpr", "eigen").to.array
    );
    let names = problems(TranslateRequest::new(
        "W 30 P -20 R 100",
        Endpoint::library("kuka-abc"),
        Endpoint::library("eigen"),
    ));
    assert_eq!(names.len(), 1, "the names of another controller");
}

/// What an end writes, it reads: of any kind, and in either direction.
#[wasm_bindgen_test(unsupported = test)]
fn every_end_reads_the_numbers_that_it_writes() {
    for library in libraries()
        .iter()
        .filter(|library| library.numbers.is_some())
    {
        for direction in [Direction::BodyToWorld, Direction::WorldToBody] {
            let here = end(library.id, None, Some(direction));
            let there = translate("0.1 0.7 -0.5 0.5", &Endpoint::library("openvins"), &here).to;
            let text = in_text(&there.numbers.clone().expect("numbers"));
            let back = translate(&text, &here, &Endpoint::library("openvins"));
            let what = format!("{} {text}", library.id);
            let (back, there) = (body_to_world(&back.to), body_to_world(&there));
            assert_close(&what, back.as_slice(), there.as_slice(), 1e-12);
        }
    }
}

/// Camera to IMU of 0.8 0.2 -0.4 0.4: Kalibr has the inverse, so the rows are columns of the rotation.
#[wasm_bindgen_test(unsupported = test)]
fn a_matrix_leads_where_its_format_does() {
    let rows = written(
        "0.8, 0.2, -0.4, 0.4",
        "nuscenes-rotation",
        "kalibr-camchain",
    )
    .values;
    let expected = [0.36, 0.48, 0.8, -0.8, 0.6, 0.0, -0.48, -0.64, 0.6];
    assert_close("kalibr", &rows, &expected, 1e-15);
    let rows = written(
        "0.8, 0.2, -0.4, 0.4",
        "nuscenes-rotation",
        "openvins-camchain",
    )
    .values;
    let expected = [0.36, -0.8, -0.48, 0.48, 0.6, -0.64, 0.8, 0.0, 0.6];
    assert_close("openvins", &rows, &expected, 1e-15);
}

/// Whatever else stands in a text is read as everywhere.
#[wasm_bindgen_test(unsupported = test)]
fn other_texts_are_read_as_everywhere() {
    let kuka = |text| between(text, "kuka-abc", "eigen").to.array;
    assert_eq!(
        kuka("w: 0.8, x: 0.2, y: -0.4, z: 0.4"),
        [0.2, -0.4, 0.4, 0.8]
    );
    assert_eq!(kuka("ZYX 30deg -20deg 100deg"), kuka("30 -20 100"));
    assert_eq!(
        between("0 0 1 0", "x3d-vrml-rotation", "eigen").to.array,
        [0.0, 0.0, 0.0, 1.0]
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_problem_of_the_numbers_is_about_all_of_them() {
    let found = problems(TranslateRequest::new(
        " 0 0 0 1.2 ",
        Endpoint::library("x3d-vrml-rotation"),
        Endpoint::library("eigen"),
    ));
    assert_eq!((found[0].span.start, found[0].span.end), (1, 10));
    assert!(found[0].suggestion.is_none());
}
