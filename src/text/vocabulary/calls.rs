//! The names of calls that make a rotation of something else than four numbers, and what they take.
//!
//! Each was checked in the library's documentation or source. Names that take other arguments, or
//! another unit, in another library are left out on purpose.

use crate::convention::euler_sequence::EulerSequence;
use crate::text::vocabulary::constructors::ends_with_path;

/// What a call takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Takes {
    /// Of an axis that is not of length 1 the library makes no rotation.
    AngleThenAxis,
    /// Alike.
    AxisThenAngle,
    /// The library divides the axis by its length.
    AnyAxisThenAngle,
    RotationVector,
    ModifiedRodrigues,
    /// The letters of a sequence, and as many angles: `SciPy`, glam.
    SequenceThenAngles,
    /// Angles about x, y, z and then the letters of transforms3d, or none for `sxyz`.
    AnglesThenAxes,
    /// Angles about x, y, z and then the letters of an intrinsic sequence, or none for `XYZ`.
    ThreeEuler,
    Angles(EulerSequence),
    Matrix,
    /// Numbers row by row in one library and column by column in another.
    RowsOrColumns,
    /// Any rotation, of which it makes another description.
    Rotation,
}

use Takes::{
    AngleThenAxis, Angles, AnglesThenAxes, AnyAxisThenAngle, AxisThenAngle, Matrix,
    ModifiedRodrigues, Rotation, RotationVector, SequenceThenAngles, ThreeEuler,
};

const ROLL_PITCH_YAW: Takes = Angles(EulerSequence::ROLL_PITCH_YAW);

/// The last path segments of a call, joined by points, and what it takes; angles are radians.
const CALLS: &[(&str, Takes)] = &[
    // Eigen, GLM
    ("AngleAxisd", AngleThenAxis),
    ("AngleAxisf", AngleThenAxis),
    ("Eigen.AngleAxis", AngleThenAxis),
    ("glm.angleAxis", AngleThenAxis),
    // three.js, glam, nalgebra, and those that normalise: Babylon.js, CesiumJS, Blender, ROS tf, Bullet
    ("setFromAxisAngle", AxisThenAngle),
    ("makeRotationAxis", AxisThenAngle),
    ("BABYLON.Quaternion.RotationAxis", AnyAxisThenAngle),
    ("Cesium.Quaternion.fromAxisAngle", AnyAxisThenAngle),
    ("from_axis_angle", AxisThenAngle),
    ("mathutils.Quaternion", AnyAxisThenAngle),
    ("tf.Quaternion", AnyAxisThenAngle),
    ("tf2.Quaternion", AnyAxisThenAngle),
    ("btQuaternion", AnyAxisThenAngle),
    // SciPy, numpy-quaternion, nalgebra and glam, OpenCV
    ("from_rotvec", RotationVector),
    ("from_rotation_vector", RotationVector),
    ("from_scaled_axis", RotationVector),
    ("Rodrigues", RotationVector),
    ("from_euler", SequenceThenAngles),
    ("from_mrp", ModifiedRodrigues),
    // ROS tf and its transformations.py, transforms3d
    ("setRPY", ROLL_PITCH_YAW),
    ("createQuaternionFromRPY", ROLL_PITCH_YAW),
    ("createQuaternionMsgFromRollPitchYaw", ROLL_PITCH_YAW),
    ("setEulerYPR", Angles(EulerSequence::AEROSPACE)),
    ("quaternion_from_euler", AnglesThenAxes),
    ("euler_matrix", AnglesThenAxes),
    ("transforms3d.euler.euler2quat", AnglesThenAxes),
    ("transforms3d.euler.euler2mat", AnglesThenAxes),
    // KDL, nalgebra, PyBullet, three.js
    ("KDL.Rotation.RPY", ROLL_PITCH_YAW),
    ("PyKDL.Rotation.RPY", ROLL_PITCH_YAW),
    ("UnitQuaternion.from_euler_angles", ROLL_PITCH_YAW),
    ("Rotation3.from_euler_angles", ROLL_PITCH_YAW),
    ("getQuaternionFromEuler", ROLL_PITCH_YAW),
    ("THREE.Euler", ThreeEuler),
    // Nine numbers, row by row: SciPy, numpy, numpy-quaternion, SymPy, Eigen, nalgebra, tf, OpenCV
    ("from_matrix", Matrix),
    ("from_dcm", Matrix),
    ("from_rotation_matrix", Matrix),
    ("np.matrix", Matrix),
    ("numpy.matrix", Matrix),
    ("sympy.Matrix", Matrix),
    ("Eigen.Matrix3d", Matrix),
    ("Eigen.Matrix3f", Matrix),
    ("nalgebra.Matrix3.new", Matrix),
    ("na.Matrix3.new", Matrix),
    ("tf.Matrix3x3", Matrix),
    ("tf2.Matrix3x3", Matrix),
    ("btMatrix3x3", Matrix),
    ("Matx33d", Matrix),
    ("Matx33f", Matrix),
    // three.js
    ("setFromEuler", Rotation),
];

/// What the call of this name takes, where it is known.
pub(crate) fn takes(name: &str) -> Option<Takes> {
    let known = CALLS.iter().find(|(known, _)| ends_with_path(name, known));
    known.map(|(_, takes)| *takes)
}
