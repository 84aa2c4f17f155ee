//! Autopilots and what they send.

use crate::convention::angle::AngleUnit::Radians;
use crate::convention::order::ComponentOrder::ScalarFirst;
use crate::text::record::format::{Angles, Field, Format, Part, Unit};

pub(crate) const AUTOPILOTS: &[Format] = &[
    // `ATTITUDE_QUATERNION {q1 : 0.8, q2 : …}`: q1 is the scalar (MAVLink, common.xml).
    Format {
        id: "mavlink-attitude-quaternion",
        name: "MAVLink",
        marks: &["attitude_quaternion|attitude_target|mavlink|time_boot_ms"],
        order: Some(ScalarFirst),
        fields: &[Field::Named(
            "q1 q2 q3 q4",
            &[Part::Quaternion(Some(ScalarFirst))],
        )],
    },
    // `XKQ {TimeUS : 1, C : 0, Q1 : 0.8, Q2 : …}`: Q1 is the scalar (ArduPilot, AP_NavEKF3).
    Format {
        id: "ardupilot-xkq",
        name: "ArduPilot",
        marks: &["xkq|nkq|xkq1|nkq1|xkq2|ahr2"],
        order: Some(ScalarFirst),
        fields: &[Field::Named(
            "q1 q2 q3 q4",
            &[Part::Quaternion(Some(ScalarFirst))],
        )],
    },
    // `to_eularian_angles(q)` prints pitch, roll, yaw in radians (AirSim, utils.py).
    Format {
        id: "airsim-quaternionr",
        name: "AirSim",
        marks: &["to_eularian_angles|airsim|quaternionr"],
        order: None,
        fields: &[Field::Under(
            "to_eularian_angles",
            &[Part::Euler(
                Angles::new("ZYX", Unit::Usually(Radians)).placed([2, 0, 1]),
            )],
        )],
    },
    // `q: [w, x, y, z]` (PX4, VehicleAttitude).
    Format {
        id: "px4-vehicle-attitude",
        name: "PX4",
        marks: &["vehicle_attitude|delta_q_reset"],
        order: Some(ScalarFirst),
        fields: &[],
    },
];
