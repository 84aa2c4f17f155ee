//! Spacecraft.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("ORBEX"),
        library: None,
        text: " ATT G07              4  0.164181 0.312510 0.545420 -0.760197",
        rotation: [
            0.16418097077,
            0.312509944362,
            0.545419902896,
            -0.760196864658,
        ],
        position: None,
    },
    Printed {
        format: Some("STK attitude"),
        library: None,
        text: "BEGIN Attitude\nAttitudeTimeQuaternions\n60.000 -0.237384 -0.317661 0.897647 -0.192276\nEND Attitude",
        rotation: [
            -0.192276012386,
            -0.237384015292,
            -0.317661020463,
            0.897647057826,
        ],
        position: None,
    },
    Printed {
        format: Some("STK attitude"),
        library: None,
        text: "BEGIN Attitude\nAttitudeTimeQuatScalarFirst\n60.000 -0.124053 -0.867291 -0.216618 -0.430689\nEND Attitude",
        rotation: [
            -0.124053049737,
            -0.867291347725,
            -0.216618086849,
            -0.430689172677,
        ],
        position: None,
    },
    Printed {
        format: Some("STK attitude"),
        library: None,
        text: "AttitudeTimeQuatAngVels\n60.000 0.413164 0.219611 -0.757849 0.454677 0.1 0.2 0.3",
        rotation: [
            0.4546770538,
            0.413164048888,
            0.219611025986,
            -0.757849089674,
        ],
        position: None,
    },
    Printed {
        format: Some("GMAT"),
        library: None,
        text: "GMAT Sat.Q1 = 0.231455;\nGMAT Sat.Q2 = -0.612372;\nGMAT Sat.Q3 = 0.433013;\nGMAT Sat.Q4 = 0.619657;",
        rotation: [
            0.619642767209,
            0.231449683751,
            -0.612357934536,
            0.433003054201,
        ],
        position: None,
    },
    Printed {
        format: Some("GMAT"),
        library: None,
        text: "GMAT Sat.EulerAngleSequence = '312';\nGMAT Sat.EulerAngle1 = 83.7392;\nGMAT Sat.EulerAngle2 = 62.9318;\nGMAT Sat.EulerAngle3 = -21.8785;",
        rotation: [
            0.689736335553,
            0.489678955185,
            0.221531930971,
            0.485182349048,
        ],
        position: None,
    },
    Printed {
        format: Some("Basilisk"),
        library: None,
        text: "sigma_BN = [[-0.17130436], [0.20610412], [-0.22820400]]",
        rotation: [
            0.779515917733,
            -0.304838835397,
            0.36676556225,
            -0.40609265049,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn attitudes_of_spacecraft_are_read() {
    check(PRINTED);
}
