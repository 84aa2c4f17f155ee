//! Robot controllers: a position in millimetres, and the orientation of the tool in the base.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::ScalarFirst;
use crate::text::record::format::{Angles, Field, Format, Part, Unit};

/// Degrees about moving z, y, x.
const ZYX: Part = Part::Euler(Angles::new("ZYX", Unit::Usually(Degrees)));

/// Degrees about fixed x, y, z.
const FIXED_XYZ: Part = Part::Euler(Angles::new("xyz", Unit::Usually(Degrees)));

/// Degrees about moving x, y, z.
const XYZ: Part = Part::Euler(Angles::new("XYZ", Unit::Usually(Degrees)));

/// Degrees about moving z, y, z.
const ZYZ: Part = Part::Euler(Angles::new("ZYZ", Unit::Usually(Degrees)));

pub(crate) const ROBOTS: &[Format] = &[
    // `{X 1, Y 2, Z 3, A 65, B 22, C 104}`: A about z, B about y, C about x, moving, degrees (KUKA System
    // Software; rc_cube, pose format of KUKA).
    Format {
        id: "kuka-abc",
        name: "KUKA",
        marks: &[
            "e6pos|kuka|krl|pos act|~FRAME|base data|tool data|e6axis|~LIN {|~PTP {|~SLIN {|~SPTP {|~LIN_REL {|~} C_DIS|~} C_PTP",
        ],
        order: None,
        fields: &[Field::Named("a b c", &[ZYX])],
    },
    // The same with the status and turn that only KUKA has.
    Format {
        id: "kuka-abc",
        name: "KUKA",
        marks: &["a", "b", "c", "s", "t"],
        order: None,
        fields: &[Field::Named("a b c s t", &[ZYX, Part::Skip(2)])],
    },
    // `X = 1 mm, …, W = 10 deg, P = 20 deg, R = 30 deg`: W about x, P about y, R about z, fixed (FANUC).
    Format {
        id: "fanuc-wpr",
        name: "FANUC",
        marks: &["fanuc|uf|ut|gp1|wpr|xyzwpr|config"],
        order: None,
        fields: &[Field::Named("w p r", &[FIXED_XYZ])],
    },
    // `posx(x, y, z, a, b, c)`: about moving z, y, z, degrees (Doosan).
    Format {
        id: "doosan-abc",
        name: "Doosan",
        marks: &["posx|doosan"],
        order: None,
        fields: &[
            Field::Under("posx", &[Part::Position, ZYZ]),
            Field::Named("a b c", &[ZYZ]),
        ],
    },
    // `movel(p[x, y, z, rx, ry, rz])`: metres and a rotation vector in radians (Universal Robots).
    Format {
        id: "ur-rotvec",
        name: "Universal Robots",
        marks: &[
            "~p[|movel|movej|movep|movec|urscript|polyscope|actualtcppose|getactualtcppose|tcp pose",
        ],
        order: None,
        fields: &[Field::Under(
            "p|tcp|actualtcppose",
            &[Part::Position, Part::RotationVector(Radians)],
        )],
    },
    // `[[x,y,z],[q1,q2,q3,q4],[conf],[external axes]]`: q1 is the scalar (ABB RAPID).
    Format {
        id: "abb-quaternion",
        name: "ABB RAPID",
        marks: &[
            "robtarget|wobjdata|tooldata|rapid|~VAR orient|~PERS orient|~CONST orient|~VAR pose|~PERS pose|~CONST pose",
        ],
        order: Some(ScalarFirst),
        fields: &[
            Field::Named("q1 q2 q3 q4", &[Part::Quaternion(Some(ScalarFirst))]),
            Field::Groups(&[&[Part::Position], &[Part::Quaternion(Some(ScalarFirst))]]),
        ],
    },
    // `OrientZYX(z, y, x)`: degrees about moving z, y, x, as of `EulerZYX` (ABB RAPID).
    Format {
        id: "abb-quaternion",
        name: "ABB RAPID",
        marks: &["orientzyx"],
        order: Some(ScalarFirst),
        fields: &[Field::Under("OrientZYX", &[ZYX])],
    },
    // `MovePose(x, y, z, alpha, beta, gamma)`: about moving x, y, z, degrees (Mecademic).
    Format {
        id: "staubli-rxryrz",
        name: "Mecademic",
        marks: &["movepose|movelin|mecademic|setwrf|settrf"],
        order: None,
        fields: &[Field::Any(&[Part::Position, XYZ])],
    },
    // `O A T` about moving z, y, z, degrees (Kawasaki).
    Format {
        id: "kawasaki-oat",
        name: "Kawasaki",
        marks: &["o", "a", "t"],
        order: None,
        fields: &[Field::Named("o a t", &[ZYZ])],
    },
    // A about x, B about y, C about z, fixed, degrees (Mitsubishi MELFA).
    Format {
        id: "mitsubishi-abc",
        name: "Mitsubishi MELFA",
        marks: &["melfa|mitsubishi"],
        order: None,
        fields: &[Field::Named("a b c", &[FIXED_XYZ])],
    },
    // `P1=(300.0,100.0,250.0,180.0,0.0,90.0)(7,0)`: the flags of the structure behind it.
    Format {
        id: "mitsubishi-abc",
        name: "Mitsubishi MELFA",
        marks: &["~)("],
        order: None,
        fields: &[Field::Groups(&[
            &[Part::Position, FIXED_XYZ],
            &[Part::Skip(2)],
        ])],
    },
    // `POS(1, 2, 3, w, p, r, 'FUT000')`: flip, up and front, with the turns, are FANUC's (KAREL, POSITION).
    Format {
        id: "fanuc-wpr",
        name: "FANUC",
        marks: &["~POS(", "~'FU|~'FD|~'NU|~'ND|~'F U|~'F D|~'N U|~'N D"],
        order: None,
        fields: &[Field::Under("POS", &[Part::Position, FIXED_XYZ])],
    },
    // `POS(1000, 200, 300, -56.5, 99.4, 110.3, '')`: about moving z, y, z, degrees (Comau PDL2, POSITION); the
    // flags of its string are S, E and W.
    Format {
        id: "comau-euler",
        name: "Comau",
        marks: &["~POS(|comau|pdl2", "~'')|~'S|~'E|~'W|comau|pdl2"],
        order: None,
        fields: &[
            Field::Under("POS", &[Part::Position, ZYZ]),
            Field::Named("e1 e2 e3", &[ZYZ]),
        ],
    },
    // `<Value key="0" x="1" y="2" z="3" rx="10" ry="20" rz="30" fatherId="world[0]"/>`: about moving x, y, z,
    // degrees (Stäubli VAL3, data of a project).
    Format {
        id: "staubli-rxryrz",
        name: "Stäubli VAL3",
        marks: &["fatherid|staubli|stäubli|val3|pointrx|pjoint"],
        order: None,
        fields: &[Field::Named("rx ry rz", &[XYZ])],
    },
    // Roll about z, pitch about y, yaw about x (Nachi; a vision vendor's table).
    Format {
        id: "nachi-rpy",
        name: "Nachi",
        marks: &["nachi"],
        order: None,
        fields: &[Field::Any(&[Part::Position, ZYX])],
    },
    // Angles of CATIA and SolidWorks, about moving z, x, z (RoboDK, Pose_2_Catia).
    Format {
        id: "catia-solidworks-zxz",
        name: "CATIA",
        marks: &["catia|solidworks"],
        order: None,
        fields: &[Field::Any(&[
            Part::Position,
            Part::Euler(Angles::new("ZXZ", Unit::Usually(Degrees))),
        ])],
    },
    // Fixed x, y, z, degrees (a vision vendor's table).
    Format {
        id: "robots-sxyz",
        name: "DENSO, DOBOT, AUBO, JAKA, ROKAE, Techman, ELITE, Hyundai, Flexiv",
        marks: &["denso|dobot|aubo|jaka|rokae|techman|elibot|hyundai|flexiv"],
        order: None,
        fields: &[
            Field::Any(&[Part::Position, FIXED_XYZ]),
            Field::Named("rx ry rz", &[FIXED_XYZ]),
            Field::Named("a b c", &[FIXED_XYZ]),
        ],
    },
    // Moving z, y, x, degrees (a vision vendor's table); Epson calls them U, V, W.
    Format {
        id: "robots-rzyx",
        name: "EFORT, EPSON, ESTUN, INOVANCE",
        marks: &["efort|epson|estun|inovance"],
        order: None,
        fields: &[
            Field::Any(&[Part::Position, ZYX]),
            Field::Named("u v w", &[ZYX]),
            Field::Named("a b c", &[ZYX]),
        ],
    },
    // `XY(x, y, z, u, v, w) /R /A /NF` (EPSON SPEL+).
    Format {
        id: "robots-rzyx",
        name: "EPSON",
        marks: &["~XY(", "~) /R|~) /L"],
        order: None,
        fields: &[Field::Under("XY", &[Part::Position, ZYX])],
    },
    // Moving x, y, z, degrees (a vision vendor's table).
    Format {
        id: "robots-rxyz",
        name: "TURIN, ADT",
        marks: &["~TURIN |~Turin |~ADT "],
        order: None,
        fields: &[Field::Any(&[Part::Position, XYZ])],
    },
    // Rx, Ry, Rz about fixed x, y, z, degrees (Yaskawa Motoman).
    Format {
        id: "yaskawa-rxryrz",
        name: "Yaskawa Motoman",
        marks: &["yaskawa|motoman|~RCONF"],
        order: None,
        fields: &[
            Field::Any(&[Part::Position, FIXED_XYZ]),
            Field::Named("rx ry rz", &[FIXED_XYZ]),
        ],
    },
    // `set_position(x, y, z, roll, pitch, yaw)`: millimetres and degrees, fixed x, y, z (UFACTORY).
    Format {
        id: "ufactory-xarm",
        name: "UFACTORY xArm",
        marks: &["xarm|lite6|ufactory|get_position|set_position"],
        order: None,
        fields: &[Field::Under(
            "position",
            &[
                Part::Position,
                Part::Euler(Angles::new("xyz", Unit::BySize)),
            ],
        )],
    },
    // Sixteen numbers column by column (libfranka, robot_state.h).
    Format {
        id: "franka-o-t-ee",
        name: "Franka",
        marks: &["ee", "o|f|ne"],
        order: None,
        fields: &[Field::Under("ee|EE", &[Part::HomogeneousColumns(16)])],
    },
];
