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

/// Below this the parts of a double-double would lose bits: the lower of its two is 2^-53 of it, and
/// the smallest double is 2^-1074.
const SMALL_DEG: f64 = 1e-280;

/// Brings every smaller angle, down to the smallest double, above that: 2^200.
const ENLARGEMENT: f64 = f64::from_bits(0x4c70_0000_0000_0000);

/// The double nearest to `degrees` · π/180, so that 90 gives the double nearest to π/2.
///
/// Below 2.2e-308 radians, where doubles have fewer digits, it is rounded twice, which leaves it within
/// 0.5001 units of the last place.
pub(crate) fn degrees_in_radians(degrees: f64) -> f64 {
    if degrees.abs() < SMALL_DEG {
        let enlarged = consts::PI * (TwoFloat::from(degrees * ENLARGEMENT) / 180.0);
        return enlarged.hi() / ENLARGEMENT;
    }
    if !degrees.is_finite() {
        // Infinity less infinity, in the parts of a double-double, would be no number.
        return degrees;
    }
    (consts::PI * (TwoFloat::from(degrees) / 180.0)).hi()
}

/// Two turns, after which even a quaternion is what it was.
const TWO_TURNS_DEG: f64 = 720.0;

/// The angle of a turn by so many degrees, in radians: what is beyond two turns is left out, which
/// is exact here and would not be in radians.
pub(crate) fn turn_in_radians(degrees: f64) -> f64 {
    degrees_in_radians(if degrees.abs() > TWO_TURNS_DEG {
        without_turns(degrees)
    } else {
        degrees
    })
}

/// The rest of an angle beyond turns, exactly: what is taken away is at least half of what is left. `fmod` is
/// the same by a division of 128 bits, which takes 1 kB of the wasm.
fn without_turns(degrees: f64) -> f64 {
    if !degrees.is_finite() {
        return f64::NAN;
    }
    let mut rest = degrees.abs();
    while rest >= TWO_TURNS_DEG {
        let mut turns = TWO_TURNS_DEG;
        while turns <= rest / 2.0 {
            turns *= 2.0;
        }
        rest -= turns;
    }
    rest.copysign(degrees)
}

/// A right angle, whose multiples are exact in degrees and in no double in radians.
const QUARTER_TURN_DEG: f64 = 90.0;

/// Sine and cosine of half of an angle, times any positive number. Of degrees whole quarter turns are
/// exact: 180° has the cosine 0, and 360° the sine.
pub(crate) fn half_angle_sincos(angle_rad: f64, written_in: AngleUnit) -> (f64, f64) {
    let quarter_turns = (angle_rad / std::f64::consts::FRAC_PI_2).round();
    let is_whole = written_in == AngleUnit::Degrees
        && quarter_turns.abs() * QUARTER_TURN_DEG <= TWO_TURNS_DEG
        && angle_rad == degrees_in_radians(quarter_turns * QUARTER_TURN_DEG);
    if !is_whole {
        return libm::sincos(angle_rad / 2.0);
    }
    // Of half of each, the direction: at 45° both are the same, whatever √½ is as a double.
    const SINCOS: [(f64, f64); 8] = [
        (0.0, 1.0),
        (1.0, 1.0),
        (1.0, 0.0),
        (1.0, -1.0),
        (0.0, -1.0),
        (-1.0, -1.0),
        (-1.0, 0.0),
        (-1.0, 1.0),
    ];
    let eighths = quarter_turns.rem_euclid(8.0);
    let (_, found) = (0_u8..8)
        .zip(SINCOS)
        .find(|(number, _)| f64::from(*number) == eighths)
        .unwrap_or((0, SINCOS[0]));
    found
}

#[cfg(test)]
mod tests {
    use super::{degrees_in_radians, turn_in_radians, without_turns};
    use std::f64::consts::{FRAC_PI_2, TAU};

    #[test]
    fn many_turns_lose_no_digits() {
        assert_eq!(turn_in_radians(720e12 + 90.0), FRAC_PI_2);
        assert_eq!(turn_in_radians(-720e12 - 90.0), -FRAC_PI_2);
        assert_eq!(turn_in_radians(720.0), 2.0 * TAU);
    }

    #[test]
    fn turns_are_left_out_as_by_a_division() {
        let mut degrees = 719.3;
        while degrees < f64::MAX / 1.9 {
            degrees *= 1.9;
            for angle in [degrees, -degrees, degrees.round()] {
                let rest = libm::fmod(angle, 720.0);
                assert_eq!(without_turns(angle).to_bits(), rest.to_bits(), "{angle:e}");
            }
        }
        assert!(turn_in_radians(f64::INFINITY).is_nan());
    }

    /// What the smallest angles in radians are in degrees is read back, each as itself.
    #[test]
    fn the_smallest_angles_are_read_back() {
        for units in 1..2000_u64 {
            let radians = f64::from_bits(units);
            let read_back = degrees_in_radians(radians.to_degrees());
            assert_eq!(read_back.to_bits(), units, "{radians:e}");
        }
        let mut radians = f64::from_bits(1999);
        while radians < 1e-250 {
            radians *= 1.7;
            let read_back = degrees_in_radians(radians.to_degrees());
            let error = (read_back / radians - 1.0).abs();
            assert!(
                error < 4.0 * f64::EPSILON.max(5e-324 / radians),
                "{radians:e}"
            );
        }
        // Less than half of the smallest double is none.
        assert_eq!(degrees_in_radians(1.3e-322), 0.0);
        assert_eq!(degrees_in_radians(-1.5e-322), -5e-324);
    }

    #[test]
    fn the_ends_of_the_range_stay_finite() {
        for degrees in [f64::MAX, f64::MIN_POSITIVE, 5e-324, 0.0] {
            let radians = degrees_in_radians(degrees);
            assert!(radians.is_finite() && radians <= degrees, "{degrees}");
        }
    }
}
