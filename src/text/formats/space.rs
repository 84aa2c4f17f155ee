//! Spacecraft: attitude files and kernels.

use crate::convention::angle::AngleUnit::Degrees;
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Angles, Field, Format, Part, Unit};

pub(crate) const SPACE: &[Format] = &[
    // ` ATT G01              4  w x y z`: earth-fixed to satellite (ORBEX; GROOPS).
    Format {
        id: "orbex-att",
        name: "ORBEX",
        marks: &["att"],
        order: None,
        fields: &[Field::Under(
            "ATT",
            &[Part::Skip(1), Part::Quaternion(Some(ScalarFirst))],
        )],
    },
    // `GMAT Sat.Q4 = 0.9;`: Q4 is the scalar (GMAT, user guide, Spacecraft Attitude).
    Format {
        id: "gmat",
        name: "GMAT",
        marks: &["gmat"],
        order: None,
        fields: &[
            Field::Named("q1 q2 q3 q4", &[Part::Quaternion(Some(ScalarLast))]),
            // `EulerAngle1`; the sequence is told, or 321.
            Field::Named(
                "angle1 angle2 angle3",
                &[Part::Euler(Angles::new("ZYX", Unit::Always(Degrees)))],
            ),
        ],
    },
    // `sigma_BN = [[0.1], [0.2], [-0.3]]`: modified Rodrigues parameters (Basilisk).
    Format {
        id: "basilisk",
        name: "Basilisk",
        marks: &["~sigma_BN"],
        order: None,
        fields: &[Field::Under("sigma_BN", &[Part::ModifiedRodrigues])],
    },
    // The keyword above the rows says where the scalar is (STK, attitude file).
    Format {
        id: "stk-attitude-a",
        name: "STK attitude",
        marks: &["attitudetimequaternions|attitudetimequatscalarfirst|attitudetimequatangvels"],
        order: None,
        fields: &[
            Field::Under(
                "AttitudeTimeQuaternions",
                &[Part::Time, Part::Quaternion(Some(ScalarLast))],
            ),
            Field::Under(
                "AttitudeTimeQuatScalarFirst",
                &[Part::Time, Part::Quaternion(Some(ScalarFirst))],
            ),
            Field::Under(
                "AttitudeTimeQuatAngVels",
                &[
                    Part::Time,
                    Part::Quaternion(Some(ScalarLast)),
                    Part::Skip(3),
                ],
            ),
        ],
    },
];
