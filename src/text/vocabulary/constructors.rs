//! Which order the constructors of known libraries take their numbers in.

use crate::character::is_capital;
use crate::convention::order::ComponentOrder::{self, ScalarFirst, ScalarLast};
use crate::text::grammar::lex::last_segment;

/// A constructor's last path segments, and the order of its arguments: joined by points for any language, by `::`
/// for those that write it so.
///
/// Each was measured by running the library or read in its source; names that mean different
/// orders in different libraries, such as a bare `Quaternion`, are left out on purpose.
const CONSTRUCTORS: &[(&str, ComponentOrder)] = &[
    // C++: Eigen, GLM, ROS tf and tf2, Bullet, KDL, GTSAM, Drake, PX4
    ("Eigen.Quaterniond", ScalarFirst),
    ("Eigen.Quaternionf", ScalarFirst),
    ("Eigen.Quaternion", ScalarFirst),
    ("glm.quat", ScalarFirst),
    ("glm.dquat", ScalarFirst),
    ("glm.fquat", ScalarFirst),
    ("tf.Quaternion", ScalarLast),
    ("tf2.Quaternion", ScalarLast),
    ("btQuaternion", ScalarLast),
    // Unreal
    ("FQuat", ScalarLast),
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
    // Not with a point: modules of Lua take the scalar last.
    ("Quaternion::new", ScalarFirst),
];

/// What a call does with its numbers, as far as its name tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Call {
    /// It makes a quaternion of numbers in this order.
    Ordered(ComponentOrder),
    /// It makes a quaternion, and the order of its numbers is not known.
    Unordered,
    /// It only holds numbers, such as `np.array`.
    Container,
    /// It makes a vector of its numbers.
    Vector,
    /// It does something else to its numbers, such as `inverse` or `fromEuler`.
    Other,
}

/// Words that say that a call computes, or that its numbers are not components.
const OPERATIONS: [&str; 34] = [
    "2quat", "about", "align", "angle", "as_", "average", "axang", "axis", "between", "conj",
    "cross", "deriv", "diff", "dot", "euler", "exp", "halve", "inv", "lerp", "log", "look",
    "matrix", "mirror", "mul", "negat", "pow", "random", "reflect", "rotvec", "rpy", "sqrt",
    "swap", "to_", "twist",
];

pub(crate) fn call(name: &str) -> Call {
    let last = last_segment(name);
    let lower = last.to_ascii_lowercase();
    let computes = OPERATIONS.iter().any(|word| lower.contains(word))
        || ["to", "as"].iter().any(|word| {
            last.strip_prefix(word)
                .is_some_and(|rest| rest.starts_with(is_capital))
        });
    if computes || names_both_orders(last) {
        return Call::Other;
    }
    // `Quaternion<xyzw>` tells its order, `Quaternion<left>` something that is not known here.
    if last.contains('<') {
        return order_in_name(last).map_or(Call::Other, Call::Ordered);
    }
    if let Some(order) = order_in_name(last) {
        return Call::Ordered(order);
    }
    let known = CONSTRUCTORS
        .iter()
        .find(|(known, _)| ends_with_path(name, known));
    if let Some(&(_, order)) = known {
        return Call::Ordered(order);
    }
    match lower.as_str() {
        "array" | "asarray" | "tensor" | "list" | "tuple" | "vec" => Call::Container,
        "new" if name.to_ascii_lowercase().contains("vec") => Call::Vector,
        "so3" | "so3d" | "so3f" | "rot3" | "rotation" | "new" | "new_normalize"
        | "new_unchecked" => Call::Unordered,
        "float3" | "double3" | "point3" => Call::Vector,
        _ if lower.contains("quat") => Call::Unordered,
        _ if lower.contains("vec") || lower.contains("point") => Call::Vector,
        _ => Call::Other,
    }
}

/// Whether the last segments of a path are these, which are joined by points.
pub(crate) fn ends_with_path(path: &str, segments: &str) -> bool {
    let path = if segments.contains("::") {
        path.to_owned()
    } else {
        path.replace("::", ".")
    };
    path.strip_suffix(segments)
        .is_some_and(|before| before.is_empty() || before.ends_with(['.', ':']))
}

/// The order that a name spells out, such as `from_xyzw` or `q_wxyz`.
pub(crate) fn order_in_name(name: &str) -> Option<ComponentOrder> {
    let lower = name.to_ascii_lowercase();
    if lower.contains("xyzw") {
        Some(ScalarLast)
    } else if lower.contains("wxyz") {
        Some(ScalarFirst)
    } else {
        None
    }
}

/// `wxyz_to_xyzw`: which of the two the numbers have is not known.
fn names_both_orders(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    lower.contains("xyzw") && lower.replacen("xyzw", " ", 1).contains("wxyz")
}

/// `Matrix3d`, `glm::mat3`, `pyrr.Matrix33`: which of its numbers are a row is not known.
pub(crate) fn is_matrix(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    ["mat3", "matrix3"].iter().any(|word| lower.contains(word))
}

/// What a label says of the numbers that it names, besides their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Named {
    /// Nothing of the kind: `pose`, which holds more, or `data`.
    Anything,
    /// A rotation, which four plain numbers may also be as an axis and an angle, as in X3D and VRML:
    /// `orientation`, `rotation`.
    Rotation,
    /// A quaternion: `q`, `q_wb`, `quat`.
    Quaternion,
}

impl Named {
    pub(crate) fn by(label: &str) -> Self {
        let label = last_segment(label);
        let lower = label.to_ascii_lowercase();
        // `qWB` and `qx`, not `quality`.
        let is_symbol = lower.starts_with('q')
            && (label.len() <= 3
                || !label[1..].starts_with(|next: char| next.is_ascii_lowercase()));
        if is_symbol || lower.contains("quat") {
            return Self::Quaternion;
        }
        let words = ["orientation", "rotation", "attitude"];
        if words.iter().any(|word| lower.contains(word)) {
            return Self::Rotation;
        }
        Self::Anything
    }
}

/// Whether a label announces something else than a quaternion or a vector.
pub(crate) fn is_other_label(name: &str) -> bool {
    if names_both_orders(name) {
        return true;
    }
    let lower = name.to_ascii_lowercase();
    const WORDS: [&str; 10] = [
        "angle",
        "axis",
        "euler",
        "gibbs",
        "matrix",
        "mrp",
        "rodrigues",
        "rotvec",
        "rpy",
        "ypr",
    ];
    WORDS.iter().any(|word| lower.contains(word))
}
