//! Libraries of graphics and of mathematics.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::formats::engines::Y_X_Z;
use crate::text::record::format::{Angles, DECLARED_ONLY, Field, Format, Letters, Part, Unit};

/// Yaw about y, pitch about x, roll about z, moving in this order, radians.
const YAW_PITCH_ROLL: Part =
    Part::Euler(Angles::new("YXZ", Unit::Always(Radians)).lettered(Letters::Ignored));

/// The angles about x, y and z, moving, in the order that is told or x, y, z.
const THREE_EULER: Part = Part::Euler(
    Angles::new("XYZ", Unit::Usually(Radians))
        .by_axis()
        .lettered(Letters::AllMove),
);

/// Moving z, y, x, radians, unless a sequence is told.
const MATLAB_EULER: Part = Part::Euler(Angles::new("ZYX", Unit::Always(Radians)));

pub(crate) const GRAPHICS: &[Format] = &[
    // `<mesh rotation={[x, y, z]}>`: moving x, y, z, radians (React Three Fiber).
    Format {
        id: "three",
        name: "React Three Fiber",
        marks: &["~rotation={["],
        order: None,
        fields: &[Field::Under("rotation", &[THREE_EULER])],
    },
    // `camera.rotation.set(x, y, z, 'YXZ')`: no other library sets an order so (three.js).
    Format {
        id: "three",
        name: "three.js",
        marks: &["~.rotation.set(", "three|~'X|~'Y|~'Z|~\"X|~\"Y|~\"Z"],
        order: None,
        fields: &[Field::Under("rotation", &[THREE_EULER])],
    },
    // `<group quaternion={[x, y, z, w]} />` (React Three Fiber: `Quaternion.set`).
    Format {
        id: "three",
        name: "React Three Fiber",
        marks: &["~quaternion={["],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `mesh.quaternion.toArray()` (three.js).
    Format {
        id: "three",
        name: "three.js",
        marks: &["~.quaternion.toArray()"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `flutter: x, y, z @ w` (Dart, `vector_math`: `Quaternion.toString`).
    Format {
        id: "dart-vector-math",
        name: "Dart vector_math",
        marks: &["flutter|vector_math", "~ @ "],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `SE3Type LieTensor` above tx ty tz qx qy qz qw (PyPose).
    Format {
        id: "pypose",
        name: "PyPose",
        marks: &["so3type|se3type"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // Column by column (GLM, `to_string`).
    Format {
        id: "glm",
        name: "GLM",
        marks: &["mat3x3|mat4x4|dmat3x3|dmat4x4|mat3|mat4"],
        order: None,
        fields: &[
            Field::Under("mat3x3|dmat3x3|mat3", &[Part::Columns]),
            Field::Under("mat4x4|dmat4x4|mat4", &[Part::HomogeneousColumns(16)]),
        ],
    },
    // `Euler {_x: 0.1, _y: 0.2, _z: 0.3, _order: 'XYZ'}`: moving axes, radians (three.js).
    Format {
        id: "three",
        name: "three.js",
        marks: &["_order|iseuler|isquaternion|isobject3d"],
        order: Some(ScalarLast),
        fields: &[Field::NamedUnder("Euler|rotation", "x y z", &[THREE_EULER])],
    },
    // `rotation.toArray()` prints the angles about x, y, z and the order (three.js).
    Format {
        id: "three",
        name: "three.js",
        marks: &["rotation", "toarray|three"],
        order: None,
        fields: &[Field::Under("toArray|rotation", &[THREE_EULER])],
    },
    // `new HeadingPitchRoll(h, p, r)`: Rz(−h) Ry(−p) Rx(r), radians (CesiumJS).
    Format {
        id: "cesium",
        name: "CesiumJS",
        marks: &["headingpitchroll|heading pitch roll", "cesium"],
        order: None,
        fields: &[Field::Under(
            "HeadingPitchRoll",
            &[Part::Euler(
                Angles::new("ZYX", Unit::Always(Radians)).signed([-1, -1, 1]),
            )],
        )],
    },
    // `mesh.rotation {X: 0.1 Y: 0.2 Z: 0.3}`: Ry Rx Rz, radians (Babylon.js).
    Format {
        id: "babylon",
        name: "Babylon.js",
        marks: &["babylon"],
        order: None,
        fields: &[
            Field::NamedUnder("rotation", "x y z", &[Y_X_Z]),
            // `RotationYawPitchRoll(yaw, pitch, roll)`
            Field::Under("RotationYawPitchRoll", &[YAW_PITCH_ROLL]),
            Field::Under("rotation|FromEulerAngles", &[Y_X_Z]),
        ],
    },
    // `( x y z <| angle )` and `rotationXYZ(a, b, c)`, radians (JOML).
    Format {
        id: "joml",
        name: "JOML",
        marks: &["rotationxyz|rotationzyx|rotationyxz|joml"],
        order: Some(ScalarLast),
        fields: &[
            Field::Any(&[Part::UnitAxisAngle(Unit::Always(Radians))]),
            Field::Under(
                "rotationXYZ|rotateXYZ",
                &[Part::Euler(Angles::new("XYZ", Unit::Always(Radians)))],
            ),
            Field::Under(
                "rotationZYX|rotateZYX",
                &[Part::Euler(Angles::new("ZYX", Unit::Always(Radians)))],
            ),
            Field::Under(
                "rotationYXZ|rotateYXZ",
                &[Part::Euler(Angles::new("YXZ", Unit::Always(Radians)))],
            ),
        ],
    },
    // `glm::quat(glm::vec3(x, y, z))`: fixed x, y, z, radians (GLM).
    Format {
        id: "glm",
        name: "GLM",
        marks: &["glm"],
        order: None,
        fields: &[Field::Under(
            "quat|dquat|fquat",
            &[Part::Euler(Angles::new("xyz", Unit::Always(Radians)))],
        )],
    },
    // `eul = 10°, 20°, 30°`: moving z, y, z (spatialmath, printline with orient='eul').
    Format {
        id: "spatialmath",
        name: "spatialmath",
        marks: DECLARED_ONLY,
        order: None,
        fields: &[Field::Under(
            "eul",
            &[Part::Euler(Angles::new("ZYZ", Unit::Usually(Degrees)))],
        )],
    },
    // `q.a = 0.8, q.b = 0.2, …`: a is the scalar (SymPy).
    Format {
        id: "sympy",
        name: "SymPy",
        marks: DECLARED_ONLY,
        order: None,
        fields: &[Field::Named(
            "a b c d",
            &[Part::Quaternion(Some(ScalarFirst))],
        )],
    },
    // `Quaternion { coords: Matrix { data: [x, y, z, w] } }` (nalgebra, Debug).
    Format {
        id: "nalgebra",
        name: "nalgebra",
        marks: &["coords", "quaternion|unitquaternion|unit"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `Quat(x, y, z, w)` (Bevy and glam, Debug).
    Format {
        id: "glam",
        name: "glam",
        marks: &["~Vec3(|~Affine3A|~Transform {", "~Quat("],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `eul2quat([z y x])`, radians; `axang2rotm([x y z angle])` (MATLAB, Robotics System Toolbox).
    Format {
        id: "matlab-robotics",
        name: "MATLAB",
        marks: &["eul2quat|eul2rotm|eul2tform|axang2quat|axang2rotm|axang2tform"],
        order: Some(ScalarFirst),
        fields: &[
            Field::Under("eul2quat|eul2rotm|eul2tform", &[MATLAB_EULER]),
            Field::Under(
                "axang2quat|axang2rotm|axang2tform",
                &[Part::AxisAngle(Unit::Always(Radians))],
            ),
        ],
    },
    // `quaternion([z y x], 'eulerd', 'ZYX', 'frame')`, degrees; with `'euler'` radians (MATLAB).
    Format {
        id: "matlab-quaternion-frame",
        name: "MATLAB",
        marks: &["~'eulerd'", "~'frame'"],
        order: Some(ScalarFirst),
        fields: &[Field::Under(
            "quaternion",
            &[Part::Euler(Angles::new("ZYX", Unit::Always(Degrees)))],
        )],
    },
    Format {
        id: "matlab-quaternion-frame",
        name: "MATLAB",
        marks: &["~'euler'", "~'frame'"],
        order: Some(ScalarFirst),
        fields: &[Field::Under("quaternion", &[MATLAB_EULER])],
    },
    // `Quaternion.CreateFromYawPitchRoll(yaw, pitch, roll)` (.NET, System.Numerics).
    Format {
        id: "dotnet",
        name: ".NET",
        marks: &["createfromyawpitchroll"],
        order: None,
        fields: &[Field::Under("CreateFromYawPitchRoll", &[YAW_PITCH_ROLL])],
    },
    // `glRotatef(angle, x, y, z)` (OpenGL), `actor.GetOrientationWXYZ()` (VTK): degrees.
    Format {
        id: "opengl",
        name: "OpenGL",
        marks: &["glrotatef|glrotated"],
        order: None,
        fields: &[Field::Under(
            "glRotatef|glRotated",
            &[Part::AngleAxis(Unit::Always(Degrees))],
        )],
    },
    Format {
        id: "vtk",
        name: "VTK",
        marks: &["getorientationwxyz|rotatewxyz"],
        order: None,
        fields: &[Field::Under(
            "GetOrientationWXYZ|RotateWXYZ",
            &[Part::AngleAxis(Unit::Always(Degrees))],
        )],
    },
];
