//! Game engines, and programs that model.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Angles, Field, Format, Letters, Part, Unit};

/// Pitch, yaw, roll in degrees: Rz(yaw) Ry(−pitch) Rx(−roll), as the axes are left-handed.
pub(crate) const ROTATOR: Part = Part::Euler(
    Angles::new("ZYX", Unit::Always(Degrees))
        .placed([1, 0, 2])
        .signed([1, -1, -1]),
);

/// The angles about x, y and z; y turns first, about moving axes.
pub(crate) const Y_X_Z: Part = Part::Euler(Angles::new("YXZ", Unit::Always(Radians)).by_axis());

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
        order: Some(ScalarLast),
        fields: &[
            Field::Named("pitch yaw roll", &[ROTATOR]),
            Field::Named("p y r", &[ROTATOR]),
            Field::Groups(&[&[Part::Position], &[ROTATOR], &[Part::Scale]]),
        ],
    },
    // The same alone; with colons the letters are those of any pitch, yaw and roll.
    Format {
        id: "unreal",
        name: "Unreal",
        marks: &["~P=", "~ Y=", "~ R="],
        order: None,
        fields: &[Field::OnlyNamed("p y r", &[ROTATOR])],
    },
    // `FRotator(pitch, yaw, roll)` (Unreal).
    Format {
        id: "unreal",
        name: "Unreal",
        marks: &["~FRotator("],
        order: None,
        fields: &[Field::Under("FRotator", &[ROTATOR])],
    },
    // `Quaternion.AngleAxis(30f, new Vector3(0, 1, 0))`: degrees (Unity).
    Format {
        id: "unity",
        name: "Unity",
        marks: &["~Quaternion.AngleAxis("],
        order: Some(ScalarLast),
        fields: &[Field::AngleThenVector(Unit::Always(Degrees))],
    },
    // `Basis.from_euler(Vector3(x, y, z))`: radians, Ry Rx Rz unless an order is given (Godot).
    Format {
        id: "godot",
        name: "Godot",
        marks: &["~EULER_ORDER_"],
        order: None,
        fields: &[Field::Under("from_euler", &[Part::Skip(3)])],
    },
    Format {
        id: "godot",
        name: "Godot",
        marks: &["~Basis.from_euler(|~Quaternion.from_euler(Vector3("],
        order: None,
        fields: &[Field::Under("from_euler", &[Y_X_Z])],
    },
    // `rotation = Quaternion(x, y, z, w)` among the properties of a node (Godot, text of a scene).
    Format {
        id: "godot",
        name: "Godot",
        marks: &[
            "~= Quaternion(",
            "~position = Vector3(|~scale = Vector3(|~[node|~[sub_resource",
        ],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `[x|y|z|w]` (libGDX, `Quaternion.toString`).
    Format {
        id: "libgdx",
        name: "libGDX",
        marks: &["touching-bars"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `llGetRot() = <x, y, z, s>` (Second Life, LSL).
    Format {
        id: "lsl",
        name: "LSL",
        marks: &["llgetrot|llgetlocalrot|llgetrootrotation|llsetrot|llsetlocalrot|lleuler2rot"],
        order: Some(ScalarLast),
        fields: &[],
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
    // `rotation_axis_angle` is the angle, then the axis (Blender, `Object`).
    Format {
        id: "mathutils",
        name: "Blender",
        marks: &["rotation_axis_angle"],
        order: None,
        fields: &[Field::Under(
            "rotation_axis_angle",
            &[Part::AngleAxis(Unit::Usually(Radians))],
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
    // `{{x, y, z, w}, {px, py, pz}}` (OpenXR, XrPosef).
    Format {
        id: "openxr",
        name: "OpenXR",
        marks: &["xrposef|xrquaternionf"],
        order: Some(ScalarLast),
        fields: &[],
    },
];
