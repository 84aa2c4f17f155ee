//! Inertial sensors and motion capture.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Angles, DECLARED_ONLY, Field, Format, Part, Unit};

/// Degrees about moving z, y, x, in this order.
const YAW_PITCH_ROLL: Part = Part::Euler(Angles::new("ZYX", Unit::Always(Degrees)));

pub(crate) const DEVICES: &[Format] = &[
    // `$VNQMR,x,y,z,w,…`: the scalar last, then the field, the acceleration and the rates (VectorNav).
    Format {
        id: "vectornav-vn",
        name: "VectorNav",
        marks: &["vnqmr|vnqtn|vnqtm|vnqta|vnqar|vnqma|vnypr|vnymr|vnyma|vnyba"],
        order: Some(ScalarLast),
        fields: &[
            Field::Under(
                "VNQMR",
                &[Part::Quaternion(Some(ScalarLast)), Part::Skip(9)],
            ),
            Field::Under("VNYPR", &[YAW_PITCH_ROLL]),
            Field::Under("VNYMR", &[YAW_PITCH_ROLL, Part::Skip(9)]),
            Field::Under("VNYMA|VNYBA", &[YAW_PITCH_ROLL, Part::Skip(6)]),
            Field::Under("VNQTN", &[Part::Quaternion(Some(ScalarLast))]),
            Field::Under(
                "VNQTM|VNQTA",
                &[Part::Quaternion(Some(ScalarLast)), Part::Skip(3)],
            ),
            Field::Under(
                "VNQMA|VNQAR",
                &[Part::Quaternion(Some(ScalarLast)), Part::Skip(6)],
            ),
        ],
    },
    // `6d 1 [0 1.000][x y z η θ φ][nine numbers column by column]` (ART DTrack).
    Format {
        id: "dtrack",
        name: "ART DTrack",
        marks: &["~6d 1 [|~6d 2 [|~6df|~6dcal|~6dmt"],
        order: None,
        fields: &[
            Field::Any(&[Part::Columns]),
            Field::Any(&[Part::Position, Part::Skip(3)]),
        ],
    },
    Format {
        id: "xsens-mti",
        name: "Xsens",
        marks: &["packetcounter|packet counter|xsens|sampletimefine|sample time fine"],
        order: Some(ScalarFirst),
        // `Euler_X` is roll, `Euler_Y` pitch, `Euler_Z` yaw.
        fields: &[Field::NamedUnder(
            "Euler",
            "x y z",
            &[Part::Euler(Angles::new("xyz", Unit::Always(Degrees)))],
        )],
    },
    // `$PASHR,time,heading,T,roll,pitch,heave,…` (NMEA 0183, proprietary of Ashtech; NovAtel).
    Format {
        id: "nmea-pashr",
        name: "NMEA PASHR",
        marks: &["~$PASHR"],
        order: None,
        fields: &[Field::Sentence(
            "$PASHR",
            &["", "heading", "", "roll", "pitch"],
        )],
    },
    // `$PSAT,HPR,time,heading,pitch,roll,type` (Hemisphere GNSS).
    Format {
        id: "nmea-psat-hpr",
        name: "NMEA PSAT HPR",
        marks: &["~$PSAT,HPR"],
        order: None,
        fields: &[Field::Sentence(
            "$PSAT,HPR",
            &["", "heading", "pitch", "roll"],
        )],
    },
    // `azimuth=…, pitch=…, roll=…`: azimuth and pitch turn the other way (Android, SensorManager.getOrientation);
    // `values = [x, y, z, w, accuracy]` of a rotation vector.
    Format {
        id: "android-sensor",
        name: "Android sensors",
        marks: &["sensor manager|type_rotation_vector|type_game_rotation_vector|getorientation"],
        order: Some(ScalarLast),
        fields: &[
            Field::Named(
                "azimuth pitch roll",
                &[Part::Euler(
                    Angles::new("ZXY", Unit::Usually(Radians)).signed([-1, -1, 1]),
                )],
            ),
            Field::Under(
                "values",
                &[Part::Quaternion(Some(ScalarLast)), Part::Skip(1)],
            ),
        ],
    },
    // `q0 = 0.8, q1 = 0.2, …`: q0 is the scalar (DJI Payload SDK, sample code).
    Format {
        id: "dji",
        name: "DJI",
        marks: DECLARED_ONLY,
        order: Some(ScalarFirst),
        fields: &[],
    },
];
