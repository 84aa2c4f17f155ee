//! Scenes and drawings: their files, and the programs that make them.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::formats::engines::Y_X_Z_DEGREES;
use crate::text::record::format::{Angles, Field, Format, Part, Unit};

/// Degrees about the fixed axes x, y and z, which turn in this order.
const fn usd_angles(sequence: &'static str) -> Part {
    Part::Euler(Angles::new(sequence, Unit::Always(Degrees)).by_axis())
}

pub(crate) const SCENES: &[Format] = &[
    // Twelve numbers, the x axis first and the translation last (3MF, transform).
    Format {
        id: "3mf",
        name: "3MF",
        marks: &["<item|<component", "transform"],
        order: None,
        fields: &[Field::Under("transform", &[Part::HomogeneousColumns(12)])],
    },
    // Sixteen numbers column by column, four x y z w (glTF 2.0, nodes).
    Format {
        id: "gltf-node-rotation",
        name: "glTF",
        marks: &["node|nodes|mesh|children|name|skin", "matrix"],
        order: None,
        fields: &[Field::Under("matrix", &[Part::HomogeneousColumns(16)])],
    },
    // `"mesh": 0, "rotation": [x, y, z, w], "translation": […]` (glTF 2.0, nodes).
    Format {
        id: "gltf-node-rotation",
        name: "glTF",
        marks: &["nodes|mesh|skin", "rotation", "translation|scale"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // For row vectors: the rows as printed are the columns of the rotation (OpenUSD, GfMatrix4d).
    Format {
        id: "usd",
        name: "USD",
        marks: &["matrix4d|xformop"],
        order: Some(ScalarFirst),
        fields: &[
            Field::Under("matrix4d|transform", &[Part::HomogeneousColumns(16)]),
            Field::Under("rotateXYZ", &[usd_angles("xyz")]),
            // The angles about x, y, z whatever turns first.
            Field::Under("rotateXZY", &[usd_angles("xzy")]),
            Field::Under("rotateYXZ", &[usd_angles("yxz")]),
            Field::Under("rotateYZX", &[usd_angles("yzx")]),
            Field::Under("rotateZXY", &[usd_angles("zxy")]),
            Field::Under("rotateZYX", &[usd_angles("zyx")]),
        ],
    },
    // `Gf.Rotation(Gf.Vec3d(x, y, z), angle)`: degrees (OpenUSD).
    Format {
        id: "usd",
        name: "USD",
        marks: &["~Gf.Rotation(|~GfRotation("],
        order: Some(ScalarFirst),
        fields: &[Field::VectorThenAngle(Unit::Always(Degrees))],
    },
    // Position first, then nine numbers row by row (Roblox, CFrame.new).
    Format {
        id: "roblox-cframe",
        name: "Roblox CFrame",
        marks: &["cframe"],
        order: Some(ScalarLast),
        fields: &[Field::Under("cframe", &[Part::Position, Part::Rows])],
    },
    // `<RotationAxis>0 0 1 90</RotationAxis>`: degrees (OpenRAVE, XML format).
    Format {
        id: "openrave",
        name: "OpenRAVE",
        marks: &["<rotationaxis"],
        order: Some(ScalarFirst),
        fields: &[Field::Under(
            "RotationAxis",
            &[Part::AxisAngle(Unit::Always(Degrees))],
        )],
    },
    // `"unitQuaternion": [x, y, z, w]` (CZML).
    Format {
        id: "cesium",
        name: "CZML",
        marks: &["~\"unitQuaternion\""],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `axis angle`, radians (VRML, X3D, Webots: SFRotation).
    Format {
        id: "x3d-vrml-rotation",
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
    // `<Viewpoint position="…" orientation="0 0 1 0.5"/>` (X3D).
    Format {
        id: "x3d-vrml-rotation",
        name: "X3D",
        marks: &["viewpoint", "orientation"],
        order: None,
        fields: &[Field::Under(
            "orientation",
            &[Part::AxisAngle(Unit::Always(Radians))],
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
    // `setAttr ".r" -type "double3" 10 20 30`: degrees about fixed x, y, z (Maya ASCII).
    Format {
        id: "maya",
        name: "Maya",
        marks: &["setattr|createnode"],
        order: None,
        fields: &[
            Field::Under(
                "r|rotate",
                &[Part::Euler(Angles::new("xyz", Unit::Always(Degrees)))],
            ),
            Field::Under("t|translate", &[Part::Position]),
            Field::Under("s|scale", &[Part::Scale]),
        ],
    },
    // `<a-entity rotation="10 20 30">`: Ry Rx Rz, degrees (A-Frame).
    Format {
        id: "aframe",
        name: "A-Frame",
        marks: &["~<a-"],
        order: None,
        fields: &[Field::Under("rotation", &[Y_X_Z_DEGREES])],
    },
    // `<rotate sid="rotationZ">0 0 1 25</rotate>`: an axis and degrees (COLLADA).
    Format {
        id: "collada",
        name: "COLLADA",
        marks: &["<rotate", "sid"],
        order: None,
        fields: &[Field::Under(
            "rotate",
            &[Part::AxisAngle(Unit::Always(Degrees))],
        )],
    },
    // `rotate([x, y, z])` in degrees about fixed x, y, z (OpenSCAD).
    Format {
        id: "openscad",
        name: "OpenSCAD",
        marks: &["~rotate([|~rotate(a|~multmatrix("],
        order: None,
        fields: &[
            Field::Under(
                "rotate",
                &[Part::Euler(Angles::new("xyz", Unit::Always(Degrees)))],
            ),
            Field::Under("multmatrix", &[Part::HomogeneousRows(16)]),
            Field::Under("multmatrix", &[Part::HomogeneousRows(12)]),
        ],
    },
];
