//! Autopilots and what they send.

use crate::convention::order::ComponentOrder::ScalarFirst;
use crate::text::record::format::{Field, Format, Part};

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
    // `q: [w, x, y, z]` (PX4, VehicleAttitude).
    Format {
        id: "px4-vehicle-attitude",
        name: "PX4",
        marks: &["vehicle_attitude|delta_q_reset"],
        order: Some(ScalarFirst),
        fields: &[],
    },
];
