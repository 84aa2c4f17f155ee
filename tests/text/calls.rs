//! What calls of libraries do with axes of any length, with sequences and with other calls.

use crate::checked::{check_read, check_refusal, check_refused};
use quatlas::{Field, ProblemCode};
use wasm_bindgen_test::wasm_bindgen_test;

/// Calls with an axis along y of a length that stands for `{}`, and the axis as they write it.
const AXIS_AND_ANGLE: &[(&str, &str, bool)] = &[
    (
        "Eigen::AngleAxisd(0.5, Eigen::Vector3d(0, {}, 0))",
        "Eigen::Vector3d(0, {}, 0)",
        false,
    ),
    (
        "Eigen::AngleAxisf(0.5f, Eigen::Vector3f(0, {}, 0))",
        "Eigen::Vector3f(0, {}, 0)",
        false,
    ),
    (
        "Eigen::AngleAxis<double>(0.5, Eigen::Vector3d(0, {}, 0))",
        "Eigen::Vector3d(0, {}, 0)",
        false,
    ),
    (
        "glm::angleAxis(0.5f, glm::vec3(0, {}, 0))",
        "glm::vec3(0, {}, 0)",
        false,
    ),
    (
        "q.setFromAxisAngle(new THREE.Vector3(0, {}, 0), 0.5)",
        "THREE.Vector3(0, {}, 0)",
        false,
    ),
    (
        "m.makeRotationAxis(new THREE.Vector3(0, {}, 0), 0.5)",
        "THREE.Vector3(0, {}, 0)",
        false,
    ),
    (
        "Quat::from_axis_angle(Vec3::new(0.0, {}, 0.0), 0.5)",
        "Vec3::new(0.0, {}, 0.0)",
        false,
    ),
    (
        "BABYLON.Quaternion.RotationAxis(new BABYLON.Vector3(0, {}, 0), 0.5)",
        "",
        true,
    ),
    (
        "Cesium.Quaternion.fromAxisAngle(new Cesium.Vec3(0, {}, 0), 0.5)",
        "",
        true,
    ),
    ("mathutils.Quaternion((0, {}, 0), 0.5)", "", true),
    ("tf::Quaternion(tf::Vector3(0, {}, 0), 0.5)", "", true),
    ("tf2::Quaternion(tf2::Vector3(0, {}, 0), 0.5)", "", true),
    ("btQuaternion(btVector3(0, {}, 0), 0.5)", "", true),
];

/// An axis whose three decimals are rounded has a length within 0.001 of 1.
#[wasm_bindgen_test(unsupported = test)]
fn a_library_that_does_not_normalise_takes_no_longer_axis() {
    for (call, axis, normalises) in AXIS_AND_ANGLE {
        let of_length = |text: &str, length| text.replace("{}", length);
        for length in ["1", "0.9992", "1.0008"] {
            check_read(&[(&of_length(call, length), "0.5rad about y")]);
        }
        for length in ["2", "1.1", "0.9", "0.9985"] {
            let text = of_length(call, length);
            if *normalises {
                check_read(&[(&text, "0.5rad about y")]);
            } else {
                let axis = of_length(axis, length);
                check_refusal(
                    Field::Quaternion,
                    &text,
                    ProblemCode::NotARotation,
                    &axis,
                    "normalise",
                );
            }
        }
    }
}

/// Its letters are capitals, and three different ones.
#[wasm_bindgen_test(unsupported = test)]
fn the_euler_angles_of_three_js_turn_about_moving_axes() {
    let wrong = [
        "THREE.Euler(0.4, -0.6, 0.9, 'ZXZ')",
        "THREE.Euler(0.4, -0.6, 0.9, 'XYX')",
        "THREE.Euler(0.4, -0.6, 0.9, 'xyz')",
        "THREE.Euler(0.4, -0.6, 0.9, 'zxz')",
        "THREE.Euler(0.4, -0.6, 0.9, 'sxyz')",
    ];
    for text in wrong {
        let code = ProblemCode::WrongCount;
        check_refusal(Field::Quaternion, text, code, text, "wrong arguments for ");
    }
    check_read(&[
        ("THREE.Euler(0.4, -0.6, 0.9)", "XYZ 0.4 -0.6 0.9"),
        ("THREE.Euler(0.4, -0.6, 0.9, 'ZYX')", "ZYX 0.9 -0.6 0.4"),
        (
            "q.setFromEuler(new THREE.Euler(0.4, -0.6, 0.9, 'YXZ'))",
            "YXZ -0.6 0.4 0.9",
        ),
    ]);
}

/// A call in a call in a call: what makes the rotation is found as deep as anyone writes it.
#[wasm_bindgen_test(unsupported = test)]
fn a_call_inside_other_calls_is_found() {
    let nested = |depth: usize| {
        let call = "AngleAxisd(0.5, Vector3d(0, 1, 0))";
        format!("{}{call}{}", "Quaternion(".repeat(depth), ")".repeat(depth))
    };
    for depth in 0..8 {
        check_read(&[(&nested(depth), "0.5rad about y")]);
    }
    // Beyond that it is refused, not read as something else.
    for depth in [8, 12] {
        let text = nested(depth);
        let code = ProblemCode::UnknownWord;
        check_refusal(
            Field::Quaternion,
            &text,
            code,
            "AngleAxisd(0.5, Vector3d(0, 1, 0))",
            "is not supported here",
        );
    }
    // A matrix of it is the same rotation, whichever of its numbers would be a row.
    check_read(&[
        (
            "Eigen::Matrix3d(Eigen::AngleAxisd(0.5, Eigen::Vector3d(0, 1, 0)))",
            "0.5rad about y",
        ),
        (
            "glm::mat3(glm::angleAxis(0.5f, glm::vec3(0, 1, 0)))",
            "0.5rad about y",
        ),
    ]);
}

/// What is done with the rotation inside would be lost.
#[wasm_bindgen_test(unsupported = test)]
fn a_call_that_computes_is_not_passed_over() {
    use ProblemCode::{UnknownComponent, UnknownWord};
    let calls = [
        "inverse(AngleAxisd(0.5, Vector3d(0, 1, 0)))",
        "np.transpose(R.from_rotvec([0, 0, 1]))",
        "np.matrix(R.from_rotvec([0, 0, 1]), order='F')",
        // Nor are its named arguments those of a constructor.
        "inverse(axis=[0, 0, 1], degrees=90)",
        "foo(axis=[0, 0, 1], degrees=90)",
        "foo(matrix=[[0, -1, 0], [1, 0, 0], [0, 0, 1]])",
        // Nor does it only hold numbers.
        "np.transpose([[0, -1, 0], [1, 0, 0], [0, 0, 1]])",
        "flip([[0, -1, 0], [1, 0, 0], [0, 0, 1]])",
    ];
    for text in calls {
        check_refusal(
            Field::Quaternion,
            text,
            UnknownWord,
            text,
            "is not supported here",
        );
    }
    let vector = "flip(1, 2, 3)";
    check_refusal(
        Field::Vector,
        vector,
        UnknownWord,
        vector,
        "is not supported here",
    );
    check_refused(&[
        (
            "Quaternion(AngleAxisd(0.5, Vector3d(0, 1, 0)), inverse=True)",
            UnknownComponent,
            "inverse",
            "may change the numbers",
        ),
        (
            "AngleAxisd(axis=[0, 0, 1], angle=1)",
            UnknownComponent,
            "axis",
            "may change the numbers",
        ),
        (
            "rotvec flip(1, 2, 3)",
            UnknownWord,
            "flip(1, 2, 3)",
            "is not a known number, unit or function",
        ),
        // A component is a number, and no rotation.
        (
            "w: AngleAxisd(0.5, Vector3d(0, 1, 0))",
            UnknownWord,
            "AngleAxisd(0.5, Vector3d(0, 1, 0))",
            "is not a known number, unit or function",
        ),
    ]);
}

/// Two numbers of a quaternion, and letters in two places.
#[wasm_bindgen_test(unsupported = test)]
fn arguments_that_a_call_does_not_take_are_refused() {
    use ProblemCode::{UnknownSequence, UnknownWord, WrongCount};
    check_refused(&[
        (
            "tf2::Quaternion(z, 0.5)",
            UnknownWord,
            "z",
            "is not a known number, unit or function",
        ),
        (
            "mathutils.Quaternion(1, 2)",
            WrongCount,
            "mathutils.Quaternion(1, 2)",
            "a quaternion has 4",
        ),
        (
            "q.setFromAxisAngle(0.5)",
            WrongCount,
            "q.setFromAxisAngle(0.5)",
            "wrong arguments for ",
        ),
        (
            "np.matrix(5)",
            WrongCount,
            "np.matrix(5)",
            "1 number: a rotation matrix has 9",
        ),
        (
            "glm::mat3(1.0)",
            UnknownWord,
            "glm::mat3(1.0)",
            "depends on the library: rows, columns or row vectors",
        ),
        (
            "quaternion_from_euler(0.1, 0.2, 0.3, 'sxyz', axes='rzyx')",
            UnknownWord,
            "'sxyz'",
            "is not a known number, unit or function",
        ),
        // The axis of one angle is a letter.
        (
            "R.from_euler('z_axis', 0.5)",
            UnknownSequence,
            "'z_axis'",
            "is not an Euler sequence",
        ),
    ]);
}
