//! Texts that a less careful reader takes for another rotation than was meant: each is refused.

use crate::checked::refusal;
use quatlas::{Field, ProblemCode};
use wasm_bindgen_test::wasm_bindgen_test;

/// Texts that could be read as another rotation than was meant, and where the problem stands.
const MISLEADING: &[(&str, ProblemCode, &str)] = &[
    ("45°+30/60 about z", ProblemCode::MixedUnits, "45°+30/60"),
    ("0.5 - 45° about z", ProblemCode::MixedUnits, "0.5 - 45°"),
    ("90° + pi/2 about z", ProblemCode::MixedUnits, "90° + pi/2"),
    ("90° + 1rad about z", ProblemCode::MixedUnits, "90° + 1rad"),
    ("45° * (2°) about z", ProblemCode::MixedUnits, "45° * (2°)"),
    ("pi/2 deg about z", ProblemCode::MixedUnits, "pi/2"),
    ("ZYX pi/2 0 0 deg", ProblemCode::MixedUnits, "pi/2"),
    // Columns in these libraries, or vectors as rows.
    (
        "Gf.Matrix3d(0,-1,0,1,0,0,0,0,1)",
        ProblemCode::UnknownWord,
        "Gf.Matrix3d(0,-1,0,1,0,0,0,0,1)",
    ),
    (
        "new Matrix3f(0,-1,0,1,0,0,0,0,1)",
        ProblemCode::UnknownWord,
        "Matrix3f(0,-1,0,1,0,0,0,0,1)",
    ),
    (
        "org.joml.Matrix3d(1,0,0,0,1,0,0,0,1)",
        ProblemCode::UnknownWord,
        "org.joml.Matrix3d(1,0,0,0,1,0,0,0,1)",
    ),
    (
        "Matrix3::new(1,0,0,0,1,0,0,0,1)",
        ProblemCode::UnknownWord,
        "Matrix3::new(1,0,0,0,1,0,0,0,1)",
    ),
    (
        "cgmath::Matrix3::new(1,0,0,0,1,0,0,0,1)",
        ProblemCode::UnknownWord,
        "cgmath::Matrix3::new(1,0,0,0,1,0,0,0,1)",
    ),
    (
        "vec3(0,-1,0), vec3(1,0,0), vec3(0,0,1)",
        ProblemCode::UnknownWord,
        "vec3(0,-1,0)",
    ),
    (
        "wxyz2xyzw([0.92, 0, 0, 0.38])",
        ProblemCode::UnknownWord,
        "wxyz2xyzw([0.92, 0, 0, 0.38])",
    ),
    (
        "wxyzToXyzw(0.92, 0, 0, 0.38)",
        ProblemCode::UnknownWord,
        "wxyzToXyzw(0.92, 0, 0, 0.38)",
    ),
    (
        "q_wxyz_from_xyzw = [0.92, 0, 0, 0.38]",
        ProblemCode::UnknownWord,
        "q_wxyz_from_xyzw",
    ),
    // Neither library divides the axis by its length.
    (
        "glm::angleAxis(1.0f, glm::vec3(1,1,0))",
        ProblemCode::NotARotation,
        "glm::vec3(1,1,0)",
    ),
    (
        "q.setFromAxisAngle(new THREE.Vector3(0,0,2), 1)",
        ProblemCode::NotARotation,
        "THREE.Vector3(0,0,2)",
    ),
    (
        "R.from_rotvec([0,0,1], degrees='False')",
        ProblemCode::UnknownComponent,
        "'False'",
    ),
    (
        "R.from_quat([0,0,0,1], scalar_first=1)",
        ProblemCode::UnknownComponent,
        "1",
    ),
    // An axis and its angle, or a quaternion that is not normalised.
    (
        "(array([0., 0., 1.]), 1.5707963267948966)",
        ProblemCode::TwoMeanings,
        "(array([0., 0., 1.]), 1.5707963267948966)",
    ),
    (
        "(1.57, [0, 0, 1])",
        ProblemCode::TwoMeanings,
        "(1.57, [0, 0, 1])",
    ),
    (
        "Quaternion(1.57, [0, 0, 1])",
        ProblemCode::TwoMeanings,
        "Quaternion(1.57, [0, 0, 1])",
    ),
    ("321 30 20 10", ProblemCode::TwoMeanings, "321"),
    ("[313, 30, 20, 10]", ProblemCode::TwoMeanings, "313"),
    // Which of two rotations is meant is not said.
    (
        r#"<origin rpy="0 0 1"/> <origin rpy="0 0 2"/>"#,
        ProblemCode::SeveralRotations,
        r#"<origin rpy="0 0 1"/> <origin rpy="0 0 2"/>"#,
    ),
    (
        "orientation:\n x: 0\n y: 0\n z: 0\n w: 1\norientation:\n x: 1\n y: 0\n z: 0\n w: 2",
        ProblemCode::SeveralRotations,
        "orientation:\n x: 0\n y: 0\n z: 0\n w: 1\norientation:\n x: 1\n y: 0\n z: 0\n w: 2",
    ),
    (
        "a.orientation.w=1 a.orientation.x=2 b.orientation.w=3 b.orientation.x=4",
        ProblemCode::MixedNames,
        "3",
    ),
    // Words that may change the numbers.
    (
        "ZYX 30 20 10, frame=extrinsic",
        ProblemCode::UnknownComponent,
        "frame",
    ),
    (
        "RPY(0.1, 0.2, 0.3, order='xyz')",
        ProblemCode::UnknownComponent,
        "order",
    ),
    (
        "rpy: [1, 2, 3]\nconvention: intrinsic",
        ProblemCode::UnknownComponent,
        "convention",
    ),
    (
        r#"{"matrix": [0,-1,0,1,0,0,0,0,1], "layout": "column-major"}"#,
        ProblemCode::UnknownComponent,
        r#""layout""#,
    ),
    (
        "np.array([[0,-1,0],[1,0,0],[0,0,1]], order='F')",
        ProblemCode::UnknownComponent,
        "order",
    ),
    (
        "[[0,-1,0],[1,0,0],[0,0,1]], transpose=true",
        ProblemCode::UnknownComponent,
        "transpose",
    ),
    (
        "matrix 0 -1 0 1 0 0 0 0 s=1",
        ProblemCode::UnknownComponent,
        "s",
    ),
    (
        r#"{"w": 1, "x": 0, "y": 0, "z": 0, "handedness": "left"}"#,
        ProblemCode::UnknownComponent,
        r#""handedness""#,
    ),
    (
        r#"{"rotation": [1, 0, 0, 0], "handedness": "left"}"#,
        ProblemCode::UnknownComponent,
        r#""handedness""#,
    ),
    (
        r#"{"rotation": [1, 0, 0, 0], "unit": "deg"}"#,
        ProblemCode::UnknownComponent,
        r#""unit""#,
    ),
    (
        r#"{"w": 1, "x": 0, "y": 0, "z": 0, "type": "JPL"}"#,
        ProblemCode::UnknownComponent,
        r#""type""#,
    ),
    (
        r#"{"rpy": [1, 2, 3], "unit": "turns"}"#,
        ProblemCode::UnknownComponent,
        r#""unit""#,
    ),
    (
        r#"{"rpy": [1, 2, 3], "order": "xyzw"}"#,
        ProblemCode::UnknownComponent,
        r#""order""#,
    ),
    (
        "Eigen::Quaterniond(1, 0, 0, 0), order=xyzw",
        ProblemCode::UnknownComponent,
        "order",
    ),
    (
        "q_wxyz = [1, 0, 0, 0], order=xyzw",
        ProblemCode::UnknownComponent,
        "q_wxyz",
    ),
    ("45deg about z, unit=rad", ProblemCode::MixedUnits, "45deg"),
    (
        "rpy: 1 2 3\nunit: deg\nunits: rad",
        ProblemCode::MixedUnits,
        "units: rad",
    ),
    // Labels that only contain a word.
    ("rpy_rate: 1 2 3", ProblemCode::OtherQuantity, "rpy_rate"),
    (
        "rpy_rate (deg): 1 2 3",
        ProblemCode::OtherQuantity,
        "rpy_rate",
    ),
    (
        "rpy_std_deg = [1, 2, 3]",
        ProblemCode::OtherQuantity,
        "rpy_std_deg",
    ),
    ("ypr_cov: 1 2 3", ProblemCode::OtherQuantity, "ypr_cov"),
    (
        "euler_rates: ZYX 1 2 3",
        ProblemCode::OtherQuantity,
        "euler_rates",
    ),
    (
        "rotvec_of_a: 1 2 3",
        ProblemCode::UnknownWord,
        "rotvec_of_a",
    ),
    (
        "inverse_matrix = [[0,-1,0],[1,0,0],[0,0,1]]",
        ProblemCode::OtherQuantity,
        "inverse_matrix",
    ),
    (
        "R.T = [[0,-1,0],[1,0,0],[0,0,1]]",
        ProblemCode::OtherQuantity,
        "R.T",
    ),
    (
        r#"{"q_dot": {"w": 1, "x": 0, "y": 0, "z": 0}}"#,
        ProblemCode::OtherQuantity,
        r#""q_dot""#,
    ),
    (
        "q_dot:\n w: 1\n x: 0\n y: 0\n z: 0",
        ProblemCode::OtherQuantity,
        "w",
    ),
    (
        "rpy_deg (rad): 1 2 3",
        ProblemCode::MixedUnits,
        "rpy_deg (rad):",
    ),
    (
        "rpy (deg) (rad) 1 2 3",
        ProblemCode::MixedUnits,
        "rpy (deg) (rad)",
    ),
    // A number that is missing, rates, what was made of a rotation, a mark for no value.
    ("0.7,0.1,,-0.5,0.5", ProblemCode::Unexpected, ","),
    (
        "roll: 0.12 rad/s, pitch: -0.05 rad/s, yaw: 0.31 rad/s",
        ProblemCode::UnknownWord,
        "s",
    ),
    (
        "omega_q = [0, 0.36, 0.48, 0.8]",
        ProblemCode::OtherQuantity,
        "omega_q",
    ),
    (
        "log(q) = (0, 0.36, -0.48, 0.8)",
        ProblemCode::OtherQuantity,
        "q",
    ),
    (
        "rvecs: [[0.8, -0.6, 0], [0.6, 0.8, 0], [0, 0, 1]]",
        ProblemCode::OtherQuantity,
        "rvecs",
    ),
    (
        "waypoint[3]: 0.5 -0.5 0.12 0.7",
        ProblemCode::Unexpected,
        ":",
    ),
    (
        "quat: -9999 -9999 -9999 -9999",
        ProblemCode::FarFromUnit,
        "quat: -9999 -9999 -9999 -9999",
    ),
    (
        "quaternion 200 200 200 200",
        ProblemCode::FarFromUnit,
        "quaternion 200 200 200 200",
    ),
    // What says itself that nothing was measured.
    (
        r#"{"isTracked": false, "rotation": [0, 0, 0, 1]}"#,
        ProblemCode::OtherQuantity,
        "false",
    ),
    (
        "orientation:\n  x: 0.0\n  y: 0.0\n  z: 0.0\n  w: 1.0\norientation_covariance: [-1.0, 0.0, 0.0]",
        ProblemCode::OtherQuantity,
        "[-1.0, 0.0, 0.0",
    ),
    // Two orders.
    (
        "quat_wxyz: [0.1, -0.5, 0.5, 0.7]  # xyzw",
        ProblemCode::OtherQuantity,
        "# xyzw",
    ),
    (
        "# w x y z\n0.1 -0.5 0.5 0.7  # w last",
        ProblemCode::OtherQuantity,
        "# w last",
    ),
    (
        "roll_deg=10 pitch_rad=0.2 yaw_deg=30",
        ProblemCode::MixedUnits,
        "0.2",
    ),
];

#[wasm_bindgen_test(unsupported = test)]
fn what_could_be_read_as_another_rotation_is_refused_at_its_place() {
    for (text, code, place) in MISLEADING {
        refusal(Field::Quaternion, text, *code, place);
    }
}
