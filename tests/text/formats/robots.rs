//! Robot controllers.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("KUKA"),
        library: None,
        text: "{E6POS: X -111.000, Y 254.100, Z 272.000, A -65.0427, B 2.7387, C -127.2151}",
        rotation: [
            0.38621436399,
            -0.749378980568,
            0.490398056181,
            -0.220860487694,
        ],
        position: Some([-111.0, 254.1, 272.0]),
    },
    Printed {
        format: Some("KUKA"),
        library: None,
        text: "{X 123.900, Y -9.500, Z 19.200, A 89.9250, B -45.9554, C 164.9894, S 2, T 35}",
        rotation: [
            -0.188403002243,
            0.681879261895,
            0.608924119889,
            0.358826416475,
        ],
        position: Some([123.9, -9.5, 19.2]),
    },
    Printed {
        format: Some("FANUC"),
        library: None,
        text: "GP1:\n  UF : 1, UT : 1, CONFIG : 'N U T, 0, 0, 0',\n  X = -130.700 mm, Y = -277.100 mm, Z = -280.300 mm,\n  W = -36.8848 deg, P = -24.5711 deg, R = -19.4568 deg",
        rotation: [
            0.902213679296,
            -0.338770648405,
            -0.146720948197,
            -0.222975083878,
        ],
        position: Some([-130.7, -277.1, -280.3]),
    },
    Printed {
        format: Some("Doosan"),
        library: None,
        text: "posx(191.900, -273.000, 16.300, 23.2730, 72.3936, -44.7093)",
        rotation: [
            0.792914436829,
            -0.330161667327,
            0.489647927378,
            -0.150082898793,
        ],
        position: Some([191.9, -273.0, 16.3]),
    },
    Printed {
        format: Some("Universal Robots"),
        library: None,
        text: "movel(p[0.557, -1.910, 2.569, -0.92321, 0.58175, 0.75945], a=1.2, v=0.25)",
        rotation: [
            0.787077542041,
            -0.42835268588,
            0.269921442587,
            0.352371017744,
        ],
        position: Some([0.557, -1.91, 2.569]),
    },
    Printed {
        format: Some("ABB RAPID"),
        library: None,
        text: "CONST robtarget p10:=[[-1.830,-0.471,1.684],[0.477346,0.430457,-0.199668,0.739581],[0,-1,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]];",
        rotation: [
            0.477346048128,
            0.430457043401,
            -0.199668020132,
            0.739581074568,
        ],
        position: Some([-1.83, -0.471, 1.684]),
    },
    Printed {
        format: Some("Mecademic"),
        library: None,
        text: "MovePose(-56.400, -50.900, -205.100, 106.6012, 4.1029, -62.2091)",
        rotation: [
            0.526194220747,
            0.67501500431,
            0.432253225617,
            -0.283956924465,
        ],
        position: Some([-56.4, -50.9, -205.1]),
    },
    Printed {
        format: Some("Kawasaki"),
        library: None,
        text: "X[mm] 18.400 Y[mm] 36.600 Z[mm] 162.700 O[deg] -31.1975 A[deg] 103.5061 T[deg] -51.5373",
        rotation: [
            0.464590722384,
            -0.138667403025,
            0.773010863007,
            -0.409122252738,
        ],
        position: Some([18.4, 36.6, 162.7]),
    },
    Printed {
        format: Some("Mitsubishi MELFA"),
        library: None,
        text: "MELFA RV-7F  X -145.500, Y 299.400, Z -3.500, A -157.4616, B 29.4022, C 142.3498",
        rotation: [
            -0.17457684402,
            -0.353039017643,
            -0.88186803869,
            0.259220253629,
        ],
        position: Some([-145.5, 299.4, -3.5]),
    },
    Printed {
        format: Some("Mitsubishi MELFA"),
        library: None,
        text: "P10=(7.300,-166.500,-159.000,143.0750,-30.9859,-4.5490)(7,0)",
        rotation: [
            0.31499181656,
            0.909987292395,
            -0.120802463609,
            0.241060257954,
        ],
        position: Some([7.3, -166.5, -159.0]),
    },
    Printed {
        format: Some("Comau"),
        library: None,
        text: "pnt1 := POS(214.600, -281.100, -114.100, -68.1569, 97.8409, -12.2069, '')",
        rotation: [
            0.50202909911,
            0.353596272337,
            0.665718455986,
            -0.423975703544,
        ],
        position: Some([214.6, -281.1, -114.1]),
    },
    Printed {
        format: Some("Stäubli VAL3"),
        library: None,
        text: r#"<Value key="0" x="118.000" y="68.800" z="173.800" rx="-118.1801" ry="-8.9417" rz="-126.9720" fatherId="world[0]" />"#,
        rotation: [
            0.288468658518,
            -0.346017421779,
            -0.783278157087,
            -0.428407639415,
        ],
        position: Some([118.0, 68.8, 173.8]),
    },
    Printed {
        format: Some("Nachi"),
        library: None,
        text: "Nachi MZ07: 149.900, -269.800, -267.000, -109.4659, 39.7828, 162.4452",
        rotation: [
            -0.191690432265,
            0.578972490518,
            -0.728789615607,
            -0.311305845729,
        ],
        position: Some([149.9, -269.8, -267.0]),
    },
    Printed {
        format: Some("CATIA"),
        library: None,
        text: "CATIA: -184.200, 178.600, 184.300, -114.7766, 57.2895, 134.7859",
        rotation: [
            0.864263611606,
            -0.273458379965,
            -0.393729921738,
            0.152465316739,
        ],
        position: Some([-184.2, 178.6, 184.3]),
    },
    Printed {
        format: Some("DENSO, DOBOT, AUBO, JAKA, ROKAE, Techman, ELITE, Hyundai, Flexiv"),
        library: None,
        text: "DOBOT pose: 234.800, 222.300, -145.100, -87.6556, -24.8782, -56.3390",
        rotation: [
            0.55062822216,
            -0.669499972467,
            0.182249014132,
            -0.464072887244,
        ],
        position: Some([234.8, 222.3, -145.1]),
    },
    Printed {
        format: Some("EFORT, EPSON, ESTUN, INOVANCE"),
        library: None,
        text: "EPSON: X -182.200 Y -214.400 Z 122.700 U 124.5871 V 11.0335 W -105.0368",
        rotation: [
            0.214067686255,
            -0.419037323258,
            -0.672108328834,
            0.571710715074,
        ],
        position: Some([-182.2, -214.4, 122.7]),
    },
    Printed {
        format: Some("TURIN, ADT"),
        library: None,
        text: "TURIN pose: -226.700, -238.900, -94.300, -125.1852, 23.7539, -36.2068",
        rotation: [
            0.371387139984,
            -0.855183294983,
            -0.179901590473,
            -0.31363759657,
        ],
        position: Some([-226.7, -238.9, -94.3]),
    },
    Printed {
        format: Some("Yaskawa Motoman"),
        library: None,
        text: "Motoman GP8: X 212.900 Y 205.800 Z -171.000 Rx -150.1441 Ry -25.9219 Rz -53.4853",
        rotation: [
            0.126669715273,
            -0.866912093338,
            0.372122705112,
            -0.30650105709,
        ],
        position: Some([212.9, 205.8, -171.0]),
    },
    Printed {
        format: Some("UFACTORY xArm"),
        library: None,
        text: "xarm position: [68.200, 253.800, 294.100, -35.7535, 57.3809, 7.9668]",
        rotation: [
            0.822618621611,
            -0.300371576928,
            0.43708856254,
            0.205010018413,
        ],
        position: Some([68.2, 253.8, 294.1]),
    },
    Printed {
        format: Some("Franka"),
        library: None,
        text: r#""O_T_EE": [-0.082750755,0.757413291,-0.647670765,0.000000000,-0.346809574,-0.631163391,-0.693798164,0.000000000,-0.934278027,0.167206100,0.314907428,0.000000000,-0.088000000,1.874000000,-1.333000000,1.000000000]"#,
        rotation: [
            0.387618782285,
            -0.555316398224,
            -0.184851247945,
            0.712183539277,
        ],
        position: Some([-0.088, 1.874, -1.333]),
    },
    Printed {
        format: Some("FANUC"),
        library: None,
        text: "POS(310.5, -120.25, 95, -56.5, 39.4, 110.3, 'FUT000')",
        rotation: [
            0.342967548749,
            -0.498326045475,
            -0.196012838607,
            0.771766402487,
        ],
        position: Some([310.5, -120.25, 95.0]),
    },
    Printed {
        format: Some("KUKA"),
        library: None,
        text: "LIN {X 403.5,Y 393.0,Z 157.8,A -32.161,B -11.856,C 42.547} C_DIS",
        rotation: [
            0.900989718732,
            0.320102492002,
            -0.192434876044,
            -0.220727750489,
        ],
        position: Some([403.5, 393.0, 157.8]),
    },
    Printed {
        format: Some("ABB RAPID"),
        library: None,
        text: "p10.rot := OrientZYX(-111.7, 30.2, -17.4);",
        rotation: [
            0.568352697784,
            0.131125162397,
            0.265411484895,
            -0.767683623893,
        ],
        position: None,
    },
    Printed {
        format: Some("EPSON"),
        library: None,
        text: "P1 = XY(-63.9, -81.3, 513.6, -94.125, -16.479, 120.042) /R /A /NF",
        rotation: [
            0.427750960493,
            0.531545059624,
            -0.676383843476,
            -0.27747767779,
        ],
        position: Some([-63.9, -81.3, 513.6]),
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn poses_of_robots_are_read() {
    check(PRINTED);
}
