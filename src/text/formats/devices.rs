//! Inertial sensors and motion capture.

use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Field, Format, Part};

pub(crate) const DEVICES: &[Format] = &[
    // `$VNQMR,x,y,z,w,…`: the scalar last, then the field, the acceleration and the rates (VectorNav).
    Format {
        id: "vectornav",
        name: "VectorNav",
        marks: &["vnqmr|vnqtn|vnqtm|vnqta|vnqar|vnqma"],
        order: Some(ScalarLast),
        fields: &[
            Field::Under(
                "VNQMR",
                &[Part::Quaternion(Some(ScalarLast)), Part::Skip(9)],
            ),
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
        marks: &["6d|6df|6dcal|6dmt"],
        order: None,
        fields: &[Field::Any(&[Part::Columns])],
    },
    Format {
        id: "xsens-mti",
        name: "Xsens",
        marks: &["packetcounter|packet counter|xsens|sampletimefine|sample time fine"],
        order: Some(ScalarFirst),
        fields: &[],
    },
];
