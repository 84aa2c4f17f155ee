//! Names that mean one thing wherever they stand.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: None,
        library: None,
        text: "phi1 = 39.6941, Phi = 83.2533, phi2 = 85.4412",
        rotation: [
            0.344369009105,
            0.612038742897,
            -0.258202395186,
            0.663438079915,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "Omega: 114.0630  Phi: -73.2400  Kappa: 175.0654",
        rotation: [
            0.518788110665,
            -0.295316110716,
            -0.686714764717,
            0.414813359119,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "X: 123.200 Y: 245.100 Z: 57.800 W: 96.8258 P: -0.0832 R: 66.0240",
        rotation: [
            0.556302421056,
            0.627458662625,
            0.407088572503,
            0.362080291043,
        ],
        position: Some([123.2, 245.1, 57.8]),
    },
    Printed {
        format: None,
        library: None,
        text: "log: qw=-0.299814 qx=-0.169424 qy=-0.793430 qz=-0.501873 tx=0.031 ty=2.895 tz=1.942",
        rotation: [
            -0.299813910146,
            -0.169423949224,
            -0.793429762209,
            -0.501872849588,
        ],
        position: Some([0.031, 2.895, 1.942]),
    },
    Printed {
        format: None,
        library: None,
        text: "{Real:-0.816125 Imag:0.149362 Jmag:-0.438592 Kmag:0.345353} log: ok",
        rotation: [
            -0.816124730784,
            0.14936195073,
            -0.438591855321,
            0.345352886078,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "Ox: -0.456856, Oy: 0.674168, Oz: 0.530576, Ow: -0.235094, Tx: 0.896, Ty: -1.623, Tz: -2.539",
        rotation: [
            -0.235094002636,
            -0.456856005123,
            0.67416800756,
            0.53057600595,
        ],
        position: Some([0.896, -1.623, -2.539]),
    },
    Printed {
        format: None,
        library: None,
        text: "img,rvec_x,rvec_y,rvec_z,tvec_x,tvec_y,tvec_z\n07.png,0.604974,-0.856288,0.979103,2.170,0.633,0.716",
        rotation: [
            0.753607587268,
            0.277209496861,
            -0.392365896135,
            0.448641842468,
        ],
        position: Some([2.17, 0.633, 0.716]),
    },
    Printed {
        format: None,
        library: None,
        text: "hdg: 149.0111 pitch: 28.8768 roll: 138.7179 speed: 3",
        rotation: [
            0.316050619092,
            0.157399827997,
            0.89679517485,
            0.266637796801,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "transform: rotateY(35.5970deg) rotateX(2.4997deg) rotateZ(100.2869deg);",
        rotation: [0.615167111406, 0.24790217503, 0.17990486163, 0.726462784609],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "Gimbal P: -12.5 Y: 71.25 R: 33.0",
        rotation: [
            0.756730979887,
            0.290289953896,
            0.0796013773745,
            0.580304736726,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "X_WO = RigidTransform(RollPitchYaw(-0.32, 1.02, -1.54), [0.5, -0.2, 1.1])",
        rotation: [
            0.672692097751,
            0.235675502037,
            0.442784720792,
            -0.543952286875,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "view matrix:\n0.3624310 0.8974228 0.2515476 0.5\n-0.6442703 0.4362671 -0.6281614 -1.5\n-0.6734683 0.0656005 0.7362996 2.25\n0 0 0 1",
        rotation: [
            0.796083797838,
            -0.217867113569,
            -0.290489480701,
            0.484149118812,
        ],
        position: Some([0.5, -1.5, 2.25]),
    },
    Printed {
        format: None,
        library: None,
        text: "q0 = -0.612372 qx = 0.231455 qy = 0.433013 qz = 0.619657",
        rotation: [
            -0.612357934536,
            0.231449683751,
            0.433003054201,
            0.619642767209,
        ],
        position: None,
    },
    Printed {
        format: None,
        library: None,
        text: "QUAT (W X Y Z) =  -6.12372D-01  2.31455D-01  4.33013D-01  6.19657D-01",
        rotation: [
            -0.612357934536,
            0.231449683751,
            0.433003054201,
            0.619642767209,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn names_of_numbers_are_read() {
    check(PRINTED);
}
