//! What names mean in no particular format.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::ScalarFirst;
use crate::text::record::format::{Angles, Field, Part, Unit};

/// Roll, pitch and yaw by name: turns about the fixed axes x, y, z, as in ROS.
const ROLL_PITCH_YAW: Part = Part::Euler(Angles::new("xyz", Unit::BySize));

/// The same angles in another order.
const PITCH_YAW_ROLL: Part = Part::Euler(Angles::new("xyz", Unit::BySize).placed([2, 0, 1]));

/// Names of components and of angles that mean one thing wherever they stand; the longer sets first.
pub(crate) const PLAIN: &[Field] = &[
    // FANUC, where W is an angle and no scalar: the rotation about fixed x, y and z.
    Field::Named(
        "x y z w p r",
        &[
            Part::Position,
            Part::Euler(Angles::new("xyz", Unit::Usually(Degrees))),
        ],
    ),
    // Bunge's angles: the crystal is the body.
    Field::Named(
        "phi1 phi phi2",
        &[Part::Euler(Angles::new("ZXZ", Unit::BySize))],
    ),
    // Photogrammetry: about moving x, y, z.
    Field::Named(
        "omega phi kappa",
        &[Part::Euler(Angles::new("XYZ", Unit::BySize))],
    ),
    Field::OnlyNamed("p y r", &[PITCH_YAW_ROLL]),
    Field::OnlyNamed("r p y", &[ROLL_PITCH_YAW]),
    Field::Named(
        "m11 m12 m13 m14 m21 m22 m23 m24 m31 m32 m33 m34 m41 m42 m43 m44",
        &[Part::Homogeneous(16)],
    ),
    Field::Named(
        "m00 m01 m02 m03 m10 m11 m12 m13 m20 m21 m22 m23 m30 m31 m32 m33",
        &[Part::Homogeneous(16)],
    ),
    Field::Named("m11 m12 m13 m21 m22 m23 m31 m32 m33", &[Part::Rows]),
    Field::Named("m00 m01 m02 m10 m11 m12 m20 m21 m22", &[Part::Rows]),
    Field::Named("r11 r12 r13 r21 r22 r23 r31 r32 r33", &[Part::Rows]),
    Field::Named("r00 r01 r02 r10 r11 r12 r20 r21 r22", &[Part::Rows]),
    Field::Named("w x y z", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("qw qx qy qz", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("q0 qx qy qz", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("q0 q1 q2 q3", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("qc q1 q2 q3", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("qs q1 q2 q3", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("qs qx qy qz", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("qr qi qj qk", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named(
        "real imag jmag kmag",
        &[Part::Quaternion(Some(ScalarFirst))],
    ),
    Field::Named("ow ox oy oz", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("real i j k", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("r i j k", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named(
        "quatw quati quatj quatk",
        &[Part::Quaternion(Some(ScalarFirst))],
    ),
    Field::Named(
        "quatw quatx quaty quatz",
        &[Part::Quaternion(Some(ScalarFirst))],
    ),
    Field::Named("rw rx ry rz", &[Part::Quaternion(Some(ScalarFirst))]),
    Field::Named("q1 q2 q3 q4", &[Part::Quaternion(None)]),
    Field::Named("roll pitch yaw", &[ROLL_PITCH_YAW]),
    // Heading, pitch and roll as in OpenDRIVE and OpenSCENARIO.
    Field::Named("r p h", &[ROLL_PITCH_YAW]),
    Field::Named("roll pitch heading", &[ROLL_PITCH_YAW]),
    Field::Named("bank pitch heading", &[ROLL_PITCH_YAW]),
    Field::NamedUnder(
        "rvec|rotvec|rotation_vector|rodrigues",
        "x y z",
        &[Part::RotationVector(Radians)],
    ),
    Field::Named("x y z", &[Part::Position]),
    Field::Named("tx ty tz", &[Part::Position]),
    Field::Named("px py pz", &[Part::Position]),
    Field::Named("posx posy posz", &[Part::Position]),
];
