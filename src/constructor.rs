//! Which order the constructors of known libraries take their numbers in.

use crate::convention::ComponentOrder::{self, ScalarFirst, ScalarLast};

/// A constructor's last path segments, joined by points, and the order of its arguments.
///
/// Each was measured by running the library or read in its source; names that mean different
/// orders in different libraries, such as a bare `Quaternion`, are left out on purpose.
const CONSTRUCTORS: &[(&str, ComponentOrder)] = &[
    // C++: Eigen, GLM, ROS tf and tf2, Bullet, KDL, GTSAM, Drake, PX4
    ("Eigen.Quaterniond", ScalarFirst),
    ("Eigen.Quaternionf", ScalarFirst),
    ("Eigen.Quaternion", ScalarFirst),
    ("Quaterniond", ScalarFirst),
    ("Quaternionf", ScalarFirst),
    ("glm.quat", ScalarFirst),
    ("glm.dquat", ScalarFirst),
    ("glm.fquat", ScalarFirst),
    ("tf.Quaternion", ScalarLast),
    ("tf2.Quaternion", ScalarLast),
    ("btQuaternion", ScalarLast),
    ("KDL.Rotation.Quaternion", ScalarLast),
    ("PyKDL.Rotation.Quaternion", ScalarLast),
    ("Rot3.Quaternion", ScalarFirst),
    ("matrix.Quatf", ScalarFirst),
    ("Gf.Quatd", ScalarFirst),
    ("Gf.Quatf", ScalarFirst),
    ("GfQuatd", ScalarFirst),
    ("GfQuatf", ScalarFirst),
    // Python: SciPy, numpy-quaternion, Blender, pyquaternion, spatialmath, JAX and MuJoCo helpers
    ("from_quat", ScalarLast),
    ("np.quaternion", ScalarFirst),
    ("quaternion.quaternion", ScalarFirst),
    ("mathutils.Quaternion", ScalarFirst),
    ("pyquaternion.Quaternion", ScalarFirst),
    ("UnitQuaternion", ScalarFirst),
    // JavaScript: three.js, Babylon.js, CesiumJS, gl-matrix
    ("THREE.Quaternion", ScalarLast),
    ("BABYLON.Quaternion", ScalarLast),
    ("Cesium.Quaternion", ScalarLast),
    ("quat.fromValues", ScalarLast),
    // Rust: nalgebra and cgmath take the scalar first; glam says its order in the name
    ("nalgebra.Quaternion.new", ScalarFirst),
    ("na.Quaternion.new", ScalarFirst),
    ("cgmath.Quaternion.new", ScalarFirst),
    ("Quaternion.new", ScalarFirst),
];

/// The order of a constructor's arguments, by the name it is called by; `None` where the name is
/// not known.
pub(crate) fn order_of(name: &str) -> Option<ComponentOrder> {
    let name = name.replace("::", ".");
    let lower = name.to_ascii_lowercase();
    if lower.contains("xyzw") {
        return Some(ScalarLast);
    }
    if lower.contains("wxyz") {
        return Some(ScalarFirst);
    }
    CONSTRUCTORS
        .iter()
        .find(|(known, _)| {
            name.strip_suffix(known)
                .is_some_and(|before| before.is_empty() || before.ends_with('.'))
        })
        .map(|&(_, order)| order)
}

/// Whether a call only holds numbers and says nothing about their order, such as `np.array`.
pub(crate) fn is_container(name: &str) -> bool {
    let last = name.rsplit([':', '.']).next().unwrap_or(name);
    matches!(
        last,
        "array"
            | "asarray"
            | "tensor"
            | "list"
            | "tuple"
            | "vec"
            | "vec4"
            | "Vector4d"
            | "Vector4f"
    )
}
