//! Autopilots and what they send.

use crate::formats::{Printed, check};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &[Printed] = &[
    Printed {
        format: Some("MAVLink"),
        library: None,
        text: "ATTITUDE_QUATERNION {time_boot_ms : 12345, q1 : -0.158732, q2 : 0.588776, q3 : -0.482384, q4 : -0.628851, rollspeed : 0.1}",
        rotation: [
            -0.158731926217,
            0.58877572632,
            -0.482383775774,
            -0.628850707692,
        ],
        position: None,
    },
    Printed {
        format: Some("PX4"),
        library: None,
        text: "TOPIC: vehicle_attitude\n    q: [0.505733, 0.754956, -0.366413, 0.200044]\n    delta_q_reset: [1.0000, 0.0000, 0.0000, 0.5000]",
        rotation: [
            0.505732869083,
            0.754955804568,
            -0.366412905149,
            0.200043948216,
        ],
        position: None,
    },
    Printed {
        format: Some("ArduPilot"),
        library: None,
        text: "XKQ {TimeUS : 123456789, C : 0, Q1 : -0.143649, Q2 : -0.199561, Q3 : -0.614446, Q4 : -0.749664}",
        rotation: [
            -0.143649026738,
            -0.199561037145,
            -0.614446114369,
            -0.749664139537,
        ],
        position: None,
    },
    Printed {
        format: Some("AirSim"),
        library: None,
        text: ">>> airsim.to_eularian_angles(q)\n(0.69289952, 1.32793666, -1.91608557)",
        rotation: [
            0.254844186845,
            0.552128568145,
            -0.320377874984,
            -0.726337732663,
        ],
        position: None,
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn prints_of_autopilots_are_read() {
    check(PRINTED);
}
