//! Game engines, scenes and modelling programs.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Angles, Field, Format, Letters, Part, Unit};

/// Pitch, yaw, roll in degrees: Rz(yaw) Ry(−pitch) Rx(−roll), as the axes are left-handed.
pub(crate) const ROTATOR: Part = Part::Euler(
    Angles::new("ZYX", Unit::Always(Degrees))
        .placed([1, 0, 2])
        .signed([1.0, -1.0, -1.0]),
);

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
            "frotator|ftransform|relativerotation|uobject|actor|unreal|ue4|ue5|fquat|fvector|rotator",
        ],
        order: None,
        fields: &[Field::Named("pitch yaw roll", &[ROTATOR])],
    },
    // Twelve numbers, the x axis first and the translation last (3MF, transform).
    Format {
        id: "3mf",
        name: "3MF",
        marks: &["<item|<component", "transform"],
        order: None,
        fields: &[Field::Under("transform", &[Part::HomogeneousColumns(12)])],
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
    // Sixteen numbers column by column, four x y z w (glTF 2.0, nodes).
    Format {
        id: "gltf-node",
        name: "glTF",
        marks: &["node|nodes|mesh|children|name", "matrix"],
        order: Some(ScalarLast),
        fields: &[Field::Under("matrix", &[Part::HomogeneousColumns(16)])],
    },
    // For row vectors: the rows as printed are the columns of the rotation (OpenUSD, GfMatrix4d).
    Format {
        id: "openusd",
        name: "USD",
        marks: &["matrix4d|xformop|quatf|quatd|quath"],
        order: Some(ScalarFirst),
        fields: &[
            Field::Under("matrix4d|transform", &[Part::HomogeneousColumns(16)]),
            Field::Under(
                "rotateXYZ",
                &[Part::Euler(Angles::new("xyz", Unit::Always(Degrees)))],
            ),
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
    // Position first, then nine numbers row by row (Roblox, CFrame.new).
    Format {
        id: "roblox-cframe",
        name: "Roblox CFrame",
        marks: &["cframe"],
        order: Some(ScalarLast),
        fields: &[Field::Under("cframe", &[Part::Position, Part::Rows])],
    },
    // `axis angle`, radians (VRML, X3D, Webots: SFRotation).
    Format {
        id: "x3d-sfrotation",
        name: "X3D",
        marks: &[
            "rotation",
            "transform|def|translation|shape|solid|children|robot|vrml|rotation",
        ],
        order: None,
        fields: &[Field::Under(
            "rotation",
            &[Part::UnitAxisAngle(Unit::Usually(Radians))],
        )],
    },
    // Four numbers by name: x y z w; the axis and the angle in radians beside them (FreeCAD, Placement).
    Format {
        id: "freecad-placement",
        name: "FreeCAD",
        marks: &["propertyplacement|placement"],
        order: Some(ScalarLast),
        fields: &[
            Field::Named("q3 q0 q1 q2", &[Part::Quaternion(Some(ScalarFirst))]),
            Field::Named("a ox oy oz", &[Part::AngleAxis(Unit::Always(Radians))]),
            Field::Named("px py pz", &[Part::Position]),
            Field::Under(
                "Yaw-Pitch-Roll",
                &[Part::Euler(Angles::new("ZYX", Unit::Always(Degrees)))],
            ),
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
    // `<Euler (x=0.1, y=0.2, z=0.3), order='XYZ'>`: fixed axes, radians (Blender, mathutils).
    Format {
        id: "mathutils",
        name: "Blender",
        marks: &["euler", "order"],
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
        marks: &["vec3", "quat"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `{{x, y, z, w}, {px, py, pz}}` (OpenXR, XrPosef).
    Format {
        id: "openxr-posef",
        name: "OpenXR",
        marks: &["xrposef|xrquaternionf"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `rotate([x, y, z])` in degrees about fixed x, y, z (OpenSCAD).
    Format {
        id: "openscad",
        name: "OpenSCAD",
        marks: &["multmatrix|cube|cylinder|translate|rotate"],
        order: None,
        fields: &[Field::Under(
            "rotate",
            &[Part::Euler(Angles::new("xyz", Unit::Always(Degrees)))],
        )],
    },
];
