//! The unit of an angle: which one it is, how it was told, and degrees in radians.

use serde::{Deserialize, Serialize};
use twofloat::{TwoFloat, consts};

/// In which unit an angle is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[doc(alias("deg", "rad"))]
pub enum AngleUnit {
    /// 360 in a full turn.
    Degrees,
    /// 2π in a full turn.
    Radians,
}

impl AngleUnit {
    /// The unit with this name in small letters; `º` is the sign of an ordinal, typed for a degree.
    pub(crate) fn named(name: &str) -> Option<Self> {
        match name {
            "deg" | "degree" | "degrees" | "°" | "º" => Some(Self::Degrees),
            "rad" | "radian" | "radians" => Some(Self::Radians),
            _ => None,
        }
    }
}

/// How the unit of an angle was told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnitSource {
    /// By the text: a unit beside the number, a π in it, or a library's call, which has its own.
    Written(AngleUnit),
    /// By nothing. The magnitude decides: radians up to a full turn, degrees beyond; what has a
    /// customary unit, such as a rotation vector, has that one.
    Assumed(AngleUnit),
}

impl UnitSource {
    /// The unit, however it was told.
    #[must_use]
    pub const fn unit(self) -> AngleUnit {
        match self {
            Self::Written(unit) | Self::Assumed(unit) => unit,
        }
    }
}

/// The double nearest to `degrees` · π/180, so that 90 gives the double nearest to π/2.
pub(crate) fn degrees_in_radians(degrees: f64) -> f64 {
    let exact = (consts::PI * (TwoFloat::from(degrees) / 180.0)).hi();
    if exact.is_finite() {
        return exact;
    }
    // The parts of a double-double overflow before its value does.
    degrees / 180.0 * std::f64::consts::PI
}

/// Two turns, after which even a quaternion is what it was.
const TWO_TURNS_DEG: f64 = 720.0;

/// The angle of a turn by so many degrees, in radians: what is beyond two turns is left out, which
/// is exact here and would not be in radians.
pub(crate) fn turn_in_radians(degrees: f64) -> f64 {
    degrees_in_radians(if degrees.abs() > TWO_TURNS_DEG {
        libm::fmod(degrees, TWO_TURNS_DEG)
    } else {
        degrees
    })
}

#[cfg(test)]
mod tests {
    use super::{degrees_in_radians, turn_in_radians};
    use std::f64::consts::{FRAC_PI_2, TAU};

    #[test]
    fn many_turns_lose_no_digits() {
        assert_eq!(turn_in_radians(720e12 + 90.0), FRAC_PI_2);
        assert_eq!(turn_in_radians(-720e12 - 90.0), -FRAC_PI_2);
        assert_eq!(turn_in_radians(720.0), 2.0 * TAU);
    }

    #[test]
    fn the_ends_of_the_range_stay_finite() {
        for degrees in [f64::MAX, f64::MIN_POSITIVE, 5e-324, 0.0] {
            let radians = degrees_in_radians(degrees);
            assert!(radians.is_finite() && radians <= degrees, "{degrees}");
        }
    }
}
