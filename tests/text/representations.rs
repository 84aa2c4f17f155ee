//! Every form of text of an axis with its angle, a rotation vector and a matrix.

use crate::asked::{AS_DEGREES, AS_RADIANS, DEGREES, RADIANS, rotation};
use crate::rows::row_major;
use crate::support::assert_close;
use quatlas::nalgebra::Vector3;
use quatlas::{
    ComponentOrder, ParsedRotation, UnitSource, parse_quaternion, parse_rotation, parse_vector,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

#[track_caller]
fn check_axis_angle(cases: &[(&str, [f64; 3], f64, UnitSource)]) {
    for &(text, axis, angle_rad, unit) in cases {
        let ParsedRotation::AxisAngle(parsed) = rotation(text) else {
            panic!("{text}: {:?}", rotation(text));
        };
        assert_eq!(parsed.axis, Vector3::from(axis), "{text}");
        assert_eq!(parsed.angle_rad, angle_rad, "{text}");
        assert_eq!(parsed.unit, unit, "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_angle_about_an_axis() {
    check_axis_angle(&[
        ("45deg about z", Z, FRAC_PI_4, DEGREES),
        ("45° about z", Z, FRAC_PI_4, DEGREES),
        ("45 degrees about the z axis", Z, FRAC_PI_4, DEGREES),
        ("45° around z-axis", Z, FRAC_PI_4, DEGREES),
        ("rotate by 45° about Z", Z, FRAC_PI_4, DEGREES),
        ("about z by 45 deg", Z, FRAC_PI_4, DEGREES),
        ("pi/4 about [0, 0, 1]", Z, FRAC_PI_4, RADIANS),
        ("2pi*2 about z", Z, 4.0 * PI, RADIANS),
        ("30° + 15° about z", Z, FRAC_PI_4, DEGREES),
        ("0 + 90°/2 about z", Z, FRAC_PI_4, DEGREES),
        ("2*22.5° about z", Z, FRAC_PI_4, DEGREES),
        // Whole turns of many are left out exactly, after the arithmetic.
        ("720000000000090 deg about z", Z, FRAC_PI_2, DEGREES),
        ("1440.0° / 32 about z", Z, FRAC_PI_4, DEGREES),
        ("-90deg about -x", X.map(|part| -part), -FRAC_PI_2, DEGREES),
        ("45deg about +z", Z, FRAC_PI_4, DEGREES),
        ("0.785 rad about (1, 1, 0)", [1.0, 1.0, 0.0], 0.785, RADIANS),
        ("0.785rad about 1 1 0", [1.0, 1.0, 0.0], 0.785, RADIANS),
        ("0.785 about k", Z, 0.785, AS_RADIANS),
        ("90 about i/2 + k", [0.5, 0.0, 1.0], FRAC_PI_2, AS_DEGREES),
        ("q = 45deg about z", Z, FRAC_PI_4, DEGREES),
        (
            "rotate about the axis [0, 0, 1] by 45°",
            Z,
            FRAC_PI_4,
            DEGREES,
        ),
        ("(45deg about z)", Z, FRAC_PI_4, DEGREES),
        ("45deg [0 0 1]", Z, FRAC_PI_4, DEGREES),
        ("1 about z, unit=deg", Z, PI / 180.0, DEGREES),
        (
            r#"{"axis": [0, 0, 1], "angle": 1, "unit": "deg"}"#,
            Z,
            PI / 180.0,
            DEGREES,
        ),
        ("45º about z", Z, FRAC_PI_4, DEGREES),
        ("45˚ about z", Z, FRAC_PI_4, DEGREES),
        ("45 Deg about z", Z, FRAC_PI_4, DEGREES),
        ("45 DEG about z", Z, FRAC_PI_4, DEGREES),
        ("2 RAD about z", Z, 2.0, RADIANS),
        ("(z, 45°)", Z, FRAC_PI_4, DEGREES),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_rounded_full_turn_is_in_radians() {
    for turn in ["6.2832", "-6.28319", "6.283185307179587"] {
        let angle_rad = turn.parse().expect("a number");
        check_axis_angle(&[(&format!("{turn} about z"), Z, angle_rad, AS_RADIANS)]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_axis_and_an_angle_by_name() {
    check_axis_angle(&[
        ("axis-angle [0 0 1] 0.785", Z, 0.785, AS_RADIANS),
        ("axis-angle 0 0 1 0.785", Z, 0.785, AS_RADIANS),
        ("axis-angle 0, 0, 1, 45", Z, FRAC_PI_4, AS_DEGREES),
        ("axis angle: ([0, 0, 1], 45deg)", Z, FRAC_PI_4, DEGREES),
        ("axis_angle: 0 0 1 0.785", Z, 0.785, AS_RADIANS),
        ("axis-angle 0 0 1 45 deg", Z, FRAC_PI_4, DEGREES),
        ("axis-angle z 45°", Z, FRAC_PI_4, DEGREES),
        ("axis-angle -z, 0.785", [0.0, 0.0, -1.0], 0.785, AS_RADIANS),
        ("angle-axis 0.785 0 0 1", Z, 0.785, AS_RADIANS),
        ("angle-axis 45deg [0, 0, 1]", Z, FRAC_PI_4, DEGREES),
        ("axis=[0,0,1], angle=0.785", Z, 0.785, AS_RADIANS),
        ("axis [0 0 1] angle 45deg", Z, FRAC_PI_4, DEGREES),
        ("angle 45deg axis [0 0 1]", Z, FRAC_PI_4, DEGREES),
        ("angle = 45 deg, axis = z", Z, FRAC_PI_4, DEGREES),
        (
            r#"{"axis": [0, 0, 1], "angle": 0.785}"#,
            Z,
            0.785,
            AS_RADIANS,
        ),
        (
            "axis:\n  x: 1\n  y: 0\n  z: 0\nangle: 0.785",
            X,
            0.785,
            AS_RADIANS,
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_axis_and_an_angle_in_a_call() {
    check_axis_angle(&[
        (
            "Eigen::AngleAxisd(0.785, Eigen::Vector3d(0, 0, 1))",
            Z,
            0.785,
            RADIANS,
        ),
        (
            "Eigen::AngleAxisd(M_PI/2, Eigen::Vector3d::UnitZ())",
            Z,
            FRAC_PI_2,
            RADIANS,
        ),
        (
            "Eigen::Quaterniond q(Eigen::AngleAxisd(30, Eigen::Vector3d::UnitX()));",
            X,
            30.0,
            AS_RADIANS,
        ),
        (
            "Eigen::AngleAxis<double>(0.5f, Eigen::Vector3d::UnitY())",
            [0.0, 1.0, 0.0],
            0.5,
            RADIANS,
        ),
        (
            "Quaternion(axis=[0, 0, 1], degrees=90)",
            Z,
            FRAC_PI_2,
            DEGREES,
        ),
        (
            "q = Quaternion(axis=[0, 0, 1], radians=90)",
            Z,
            90.0,
            RADIANS,
        ),
        (
            "Quaternion(axis=(1.0, 0.0, 0.0), angle=2.5)",
            X,
            2.5,
            RADIANS,
        ),
        (
            "q.setFromAxisAngle(new THREE.Vector3(0,0,1), Math.PI/2)",
            Z,
            FRAC_PI_2,
            RADIANS,
        ),
        (
            "DQuat::from_axis_angle(DVec3::Z, FRAC_PI_2)",
            Z,
            FRAC_PI_2,
            RADIANS,
        ),
        (
            "glm::angleAxis(glm::radians(90.0f), glm::vec3(0.f, 0.f, 1.f))",
            Z,
            FRAC_PI_2,
            RADIANS,
        ),
        (
            "mathutils.Quaternion((0.0, 0.0, 1.0), 0.785)",
            Z,
            0.785,
            RADIANS,
        ),
        ("R.from_euler('z', 90, degrees=True)", Z, FRAC_PI_2, DEGREES),
        (
            "Quat::from_axis_angle(Vec3::new(0.0, 0.0, 1.0), 0.785)",
            Z,
            0.785,
            RADIANS,
        ),
        (
            "UnitQuaternion::from_axis_angle(&Vector3::z_axis(), FRAC_PI_2)",
            Z,
            FRAC_PI_2,
            RADIANS,
        ),
        // Three decimals are as good as 1; Bullet and Blender normalise.
        (
            "glm::angleAxis(0.785f, glm::vec3(0, 0, 0.9995))",
            [0.0, 0.0, 0.9995],
            0.785,
            RADIANS,
        ),
        (
            "tf2::Quaternion(tf2::Vector3(1, 1, 0), 0.785)",
            [1.0, 1.0, 0.0],
            0.785,
            RADIANS,
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_rotation_vector() {
    let cases = [
        ("rotvec 0 0 0.785", [0.0, 0.0, 0.785], AS_RADIANS),
        ("rotation vector [0 0 0.785]", [0.0, 0.0, 0.785], AS_RADIANS),
        ("rotvec: {x: 0, y: 0, z: 7}", [0.0, 0.0, 7.0], AS_RADIANS),
        ("rotvec = [0, 0, 7]", [0.0, 0.0, 7.0], AS_RADIANS),
        ("rotvec [0, 0, pi]", [0.0, 0.0, PI], RADIANS),
        (
            "rotvec(0, 0, 45, degrees=True)",
            [0.0, 0.0, FRAC_PI_4],
            DEGREES,
        ),
        (
            r#"{"rotvec": [0, 0, 45], "units": "degrees"}"#,
            [0.0, 0.0, FRAC_PI_4],
            DEGREES,
        ),
        ("rotvec 0 0 45deg", [0.0, 0.0, FRAC_PI_4], DEGREES),
        ("rotvec 30° -45° 0", [FRAC_PI_6, -FRAC_PI_4, 0.0], DEGREES),
        ("rotvec [30 0 45] deg", [FRAC_PI_6, 0.0, FRAC_PI_4], DEGREES),
        (
            "rotvec_deg: 30, 0, 45",
            [FRAC_PI_6, 0.0, FRAC_PI_4],
            DEGREES,
        ),
        (
            "Rotation.from_rotvec([0, 0, 0.785])",
            [0.0, 0.0, 0.785],
            RADIANS,
        ),
        (
            "R.from_rotvec(np.array([0, 0, 90]), degrees=True)",
            [0.0, 0.0, FRAC_PI_2],
            DEGREES,
        ),
        (
            "from_rotvec([0, 0, np.pi/2], degrees=False)",
            [0.0, 0.0, FRAC_PI_2],
            RADIANS,
        ),
        (
            "UnitQuaternion::from_scaled_axis(Vector3::new(0.0, 0.0, 0.785))",
            [0.0, 0.0, 0.785],
            RADIANS,
        ),
    ];
    for (text, vector_rad, unit) in cases {
        let ParsedRotation::RotationVector(parsed) = rotation(text) else {
            panic!("{text}: {:?}", rotation(text));
        };
        assert_eq!(parsed.vector_rad, Vector3::from(vector_rad), "{text}");
        assert_eq!(parsed.unit, unit, "{text}");
    }
}

/// Not symmetric, so that rows and columns cannot be confused: the turn x to y to z to x, and −1.
const ROWS: [f64; 9] = [0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -0.5, 0.0];

#[wasm_bindgen_test(unsupported = test)]
fn a_matrix_row_by_row() {
    let texts = [
        "0 0 1 -1 0 0 0 -0.5 0",
        "0, 0, 1, -1, 0, 0, 0, -1/2, 0",
        "[0 0 1 -1 0 0 0 -0.5 0]",
        "[[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]]",
        "[0 0 1; -1 0 0; 0 -0.5 0]",
        "[0, 0, 1; -1, 0, 0; 0, -.5, 0]",
        "0, 0, 1\n-1, 0, 0\n0, -0.5, 0",
        "[[ 0.   0.   1. ]\n [-1.   0.   0. ]\n [ 0.  -0.5  0. ]]",
        "   0    0    1\n  -1    0    0\n   0 -0.5    0",
        "R =\n\n         0         0    1.0000\n   -1.0000         0         0\n         0   -0.5000         0\n",
        "np.array([[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]])",
        "array([[ 0. ,  0. ,  1. ],\n       [-1. ,  0. ,  0. ],\n       [ 0. , -0.5,  0. ]], dtype=float32)",
        "R = [[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]]",
        "R = [0 0 1 -1 0 0 0 -0.5 0]",
        "matrix 0 0 1 -1 0 0 0 -0.5 0",
        "rotation matrix: [[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]]",
        "R_matrix = [[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]]",
        "Rotation.from_matrix([[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]])",
        "R.from_matrix(np.array([[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]]))",
        "Quaternion(matrix=np.array([[0, 0, 1], [-1, 0, 0], [0, -0.5, 0]]))",
        "tf2::Matrix3x3(0, 0, 1, -1, 0, 0, 0, -0.5, 0)",
        "nalgebra::Matrix3::new(0, 0, 1, -1, 0, 0, 0, -0.5, 0)",
        "Eigen::Matrix3d R{{0, 0, 1}, {-1, 0, 0}, {0, -0.5, 0}};",
        "[[0, 0, 1], [-cos(0), 0, 0], [0, -sin(pi/6), 0]]",
        "(0, 0, 1), (-1, 0, 0), (0, -0.5, 0)",
        "R << 0, 0, 1,\n     -1, 0, 0,\n     0, -0.5, 0;",
        "Eigen::Matrix3d R; R << 0, 0, 1, -1, 0, 0, 0, -0.5, 0;",
    ];
    for text in texts {
        let ParsedRotation::Matrix(matrix) = rotation(text) else {
            panic!("{text}: {:?}", rotation(text));
        };
        assert_close(text, &row_major(&matrix), &ROWS, 1e-16);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn degrees_become_the_nearest_doubles() {
    let cases = [
        (30.0, FRAC_PI_6),
        (45.0, FRAC_PI_4),
        (60.0, FRAC_PI_3),
        (60.0, FRAC_PI_3),
        (90.0, FRAC_PI_2),
        (180.0, PI),
        (-360.0, -TAU),
    ];
    for (degrees, radians) in cases {
        check_axis_angle(&[
            (&format!("{degrees}deg about z"), Z, radians, DEGREES),
            (&format!("{}° about z", -degrees), Z, -radians, DEGREES),
            (&format!("{degrees} about z"), Z, radians, AS_DEGREES),
        ]);
    }
    let smallest = 1.745_329_251_994_329_8e-292;
    check_axis_angle(&[("1e-290deg about z", Z, smallest, DEGREES)]);
    // The largest double; of the angle of a turn whole turns are left out, of a vector they are not.
    let text = "rotvec 0 0 1.7976931348623157e308 deg";
    let ParsedRotation::RotationVector(parsed) = rotation(text) else {
        panic!("{text}");
    };
    let largest = f64::MAX / 180.0 * PI;
    assert!(
        (parsed.vector_rad.z / largest - 1.0).abs() < 1e-15,
        "{text}"
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn an_announced_quaternion_is_one() {
    for text in [
        "quaternion 1/2 0 0 -1",
        "quat [1/2, 0, 0, -1]",
        "quaternion = [1/2, 0, 0, -1]",
    ] {
        let parsed = parse_quaternion(text, ComponentOrder::ScalarFirst);
        let quaternion = parsed.expect("a quaternion").quaternion;
        assert_eq!((quaternion.w, quaternion.k), (0.5, -1.0), "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn where_a_quaternion_or_a_vector_is_wanted_the_others_are_refused() {
    let cases = [
        (
            "45deg about z",
            "this is an axis and an angle, a quaternion is needed here",
        ),
        (
            "rotvec 0 0 1",
            "this is a rotation vector, a quaternion is needed here",
        ),
        (
            "ZYX 3 2 1",
            "this is a set of Euler angles, a quaternion is needed here",
        ),
        (
            "1 0 0 0 1 0 0 0 1",
            "this is a matrix, a quaternion is needed here",
        ),
    ];
    for (text, message) in cases {
        let refused = parse_quaternion(text, ComponentOrder::ScalarFirst);
        assert_eq!(refused.expect_err("a problem").to_string(), message);
        parse_vector(text).expect_err("a problem");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_vector_and_a_scalar_in_the_open_stay_a_quaternion() {
    // Of an axis and an angle the vector would have length 1 and the four numbers would not.
    for (text, w, k) in [
        ("[[0, 0, 0.6], 0.8]", 0.8, 0.6),
        ("[[0, 0, 2], 0.7]", 0.7, 2.0),
        ("([0, 0, 1], 0)", 0.0, 1.0),
        ("Gf.Quatd(0.5, Gf.Vec3d(0, 0, 1))", 0.5, 1.0),
    ] {
        let parsed = parse_rotation(text, ComponentOrder::ScalarFirst);
        let Ok(ParsedRotation::Quaternion(parsed)) = parsed else {
            panic!("{text}: {parsed:?}");
        };
        let quaternion = parsed.quaternion;
        assert_eq!((quaternion.w, quaternion.k), (w, k), "{text}");
    }
}
