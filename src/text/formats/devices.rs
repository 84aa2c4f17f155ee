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
    Format {
        id: "xsens-mti",
        name: "Xsens",
        marks: &["packetcounter|packet counter|xsens|sampletimefine|sample time fine"],
        order: Some(ScalarFirst),
        fields: &[],
    },
];
