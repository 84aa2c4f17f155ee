//! Game engines, and libraries of graphics.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Angles, DECLARED_ONLY, Field, Format, Letters, Part, Unit};

/// Pitch, yaw, roll in degrees: Rz(yaw) Ry(−pitch) Rx(−roll), as the axes are left-handed.
pub(crate) const ROTATOR: Part = Part::Euler(
    Angles::new("ZYX", Unit::Always(Degrees))
        .placed([1, 0, 2])
        .signed([1, -1, -1]),
);

/// The angles about x, y and z; y turns first, about moving axes.
const Y_X_Z: Part = Part::Euler(Angles::new("YXZ", Unit::Always(Radians)).by_axis());

/// The same in degrees.
pub(crate) const Y_X_Z_DEGREES: Part =
    Part::Euler(Angles::new("YXZ", Unit::Always(Degrees)).by_axis());

pub(crate) const ENGINES: &[Format] = &[
    // `P=39.25 Y=-94.09 R=-102.15` (Unreal, FRotator::ToString), `Rotation(pitch=…, yaw=…, roll=…)` (CARLA).
    Format {
        id: "carla-rotation",
        name: "CARLA",
        marks: &["carla|location", "rotation", "pitch"],
        order: None,
        fields: &[Field::Named("pitch yaw roll", &[ROTATOR])],
    },
    Format {
        id: "unreal",
        name: "Unreal",
        marks: &[
            "frotator|ftransform|relativerotation|unreal|ue4|ue5|fquat|fvector|rotator|logtemp|~LogBlueprintUserMessages",
        ],
        order: None,
        fields: &[
            Field::Named("pitch yaw roll", &[ROTATOR]),
            Field::Named("p y r", &[ROTATOR]),
            Field::Groups(&[&[Part::Position], &[ROTATOR], &[Part::Scale]]),
        ],
    },
    // The basis row by row, then the origin (Godot, text of a scene).
    Format {
        id: "godot",
        name: "Godot",
        marks: &["transform3d|transform|basis|godot"],
        order: None,
        fields: &[
            Field::Under("Transform3D|Transform", &[Part::Rows, Part::Position]),
            Field::Under("Basis", &[Part::Rows]),
        ],
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
        fields: &[Field::NamedUnder(
            "Euler|rotation",
            "x y z",
            &[Part::Euler(
                Angles::new("XYZ", Unit::Usually(Radians))
                    .by_axis()
                    .lettered(Letters::AllMove),
            )],
        )],
    },
    // `new THREE.Matrix3().set(…)` takes rows, and fills columns; `setFromAxisAngle(new THREE.Vector3(…), angle)`,
    // radians (three.js).
    Format {
        id: "three",
        name: "three.js",
        marks: &["~new THREE.Matrix|~.setFromAxisAngle(new THREE.Vector3("],
        order: None,
        fields: &[
            Field::VectorThenAngle(Unit::Always(Radians)),
            Field::Under("set", &[Part::Rows]),
            Field::Under("set", &[Part::HomogeneousRows(16)]),
        ],
    },
    // The length of a vector is the angle about it (three.js, Eigen).
    Format {
        id: "three",
        name: "three.js",
        marks: &["~.setFromAxisAngle(v.clone().normalize(), v.length())"],
        order: None,
        fields: &[Field::Under("v|Vector3", &[Part::RotationVector(Radians)])],
    },
    Format {
        id: "eigen",
        name: "Eigen",
        marks: &["~AngleAxis", "~(v.norm(), v.normalized())"],
        order: None,
        fields: &[Field::Under(
            "v|Vector3d|Vector3f",
            &[Part::RotationVector(Radians)],
        )],
    },
    // `quaternion([…], "rotvec")`, radians (MATLAB).
    Format {
        id: "matlab",
        name: "MATLAB",
        marks: &["~], \"rotvec\")|~], 'rotvec')"],
        order: None,
        fields: &[Field::Under("quaternion", &[Part::RotationVector(Radians)])],
    },
    // `Rotation.from_rotvec(angle * np.array([…]))`, radians (SciPy).
    Format {
        id: "scipy",
        name: "SciPy",
        marks: &["~from_rotvec(", "~ * np.array("],
        order: None,
        fields: &[Field::VectorThenAngle(Unit::Usually(Radians))],
    },
    // `UnitQuaternion::from_axis_angle(&Unit::new_normalize(Vector3::new(…)), angle)`, radians (nalgebra).
    Format {
        id: "nalgebra",
        name: "nalgebra",
        marks: &["~from_axis_angle(&Unit::new_"],
        order: None,
        fields: &[Field::VectorThenAngle(Unit::Always(Radians))],
    },
    // `<Euler (x=0.1, y=0.2, z=0.3), order='XYZ'>`: fixed axes, radians (Blender, mathutils).
    Format {
        id: "mathutils",
        name: "Blender",
        marks: &["~Euler((|~<Euler|bpy|mathutils"],
        order: None,
        fields: &[Field::NamedUnder(
            "Euler",
            "x y z",
            &[Part::Euler(
                Angles::new("xyz", Unit::Usually(Radians))
                    .by_axis()
                    .lettered(Letters::AllFixed),
            )],
        )],
    },
    // `Euler((0.1, 0.2, 0.3), 'XYZ')` and `(Vector((0, 0, 1)), 0.5)`, radians (Blender, repr and to_axis_angle).
    Format {
        id: "mathutils",
        name: "Blender",
        marks: &["~Euler((|~(Vector(("],
        order: None,
        fields: &[
            Field::Under(
                "Euler|rotation_euler",
                &[Part::Euler(
                    Angles::new("xyz", Unit::Usually(Radians))
                        .by_axis()
                        .lettered(Letters::AllFixed),
                )],
            ),
            Field::VectorThenAngle(Unit::Usually(Radians)),
        ],
    },
    // `rotation.toArray()` prints the angles about x, y, z and the order (three.js).
    Format {
        id: "three",
        name: "three.js",
        marks: &["rotation", "toarray|three"],
        order: None,
        fields: &[Field::Under(
            "toArray|rotation",
            &[Part::Euler(
                Angles::new("XYZ", Unit::Usually(Radians))
                    .by_axis()
                    .lettered(Letters::AllMove),
            )],
        )],
    },
    // `Quaternion.Euler(10f, 20f, 30f)`, `eulerAngles = (10, 20, 30)`: Ry Rx Rz, degrees (Unity).
    Format {
        id: "unity",
        name: "Unity",
        marks: &["~Quaternion.Euler(|localeulerangles|unityengine"],
        order: Some(ScalarLast),
        fields: &[
            Field::Under(
                "eulerAngles|localEulerAngles|Euler|localRotation",
                &[Y_X_Z_DEGREES],
            ),
            Field::NamedUnder(
                "eulerAngles|localEulerAngles|localEulerAnglesHint",
                "x y z",
                &[Y_X_Z_DEGREES],
            ),
        ],
    },
    // `rotation_degrees = Vector3(10, 20, 30)`, `rotation` in radians: Ry Rx Rz (Godot, Node3D).
    Format {
        id: "godot",
        name: "Godot",
        marks: &["rotation_degrees|camera3d|node3d|godot|gdscript"],
        order: None,
        fields: &[
            Field::Under("rotation_degrees", &[Y_X_Z_DEGREES]),
            Field::Under("rotation", &[Y_X_Z]),
        ],
    },
    // `QQuaternion::fromEulerAngles(pitch, yaw, roll)`: Ry Rx Rz, degrees (Qt).
    Format {
        id: "qt",
        name: "Qt",
        marks: &["qquaternion"],
        order: None,
        fields: &[Field::Under(
            "fromEulerAngles|toEulerAngles",
            &[Y_X_Z_DEGREES],
        )],
    },
    // `btQuaternion(yaw, pitch, roll)`: Ry Rx Rz, radians (Bullet).
    Format {
        id: "bullet",
        name: "Bullet",
        marks: &["btquaternion"],
        order: None,
        fields: &[Field::Under(
            "btQuaternion",
            &[Part::Euler(Angles::new("YXZ", Unit::Always(Radians)))],
        )],
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
    // `getHpr()`, `LVecBase3f(h, p, r)`: Rz(h) Rx(p) Ry(r), degrees (Panda3D).
    Format {
        id: "panda3d",
        name: "Panda3D",
        marks: &["gethpr|sethpr|lvecbase3f|hpr"],
        order: Some(ScalarFirst),
        fields: &[
            Field::Under(
                "getHpr|setHpr|get_hpr|set_hpr|hpr",
                &[Part::Euler(Angles::new("ZXY", Unit::Always(Degrees)))],
            ),
            Field::Named(
                "h p r",
                &[Part::Euler(Angles::new("ZXY", Unit::Always(Degrees)))],
            ),
        ],
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
    // `{{x, y, z, w}, {px, py, pz}}` (OpenXR, XrPosef).
    Format {
        id: "openxr",
        name: "OpenXR",
        marks: &["xrposef|xrquaternionf"],
        order: Some(ScalarLast),
        fields: &[],
    },
];
