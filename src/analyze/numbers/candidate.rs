//! The ways to read numbers beside an attitude, and which of them fit.
//!
//! Those fit that are no farther from the attitude than the rounding of both texts leaves open, and not
//! clearly farther than the nearest.

use crate::analyze::identify::observation::{ROUNDED_DECIMALS, decimals, half_unit};
use crate::contract::{NumbersReport, Reading};

/// Noise of single precision, in radians, after a few operations.
const SINGLE_PRECISION_RAD: f64 = 1e-5;

/// Farther than this, 1.5°, nothing is believed to be rounded: three whole degrees are together as far off.
pub(crate) const COARSEST_RAD: f64 = 0.0262;

/// A reading that is this many times farther than the nearest is not the one, unless both are within what
/// is certainly rounded.
const CLEARLY_FARTHER: f64 = 3.0;

/// More readings tell no more.
const MOST_READINGS: usize = 12;

/// One way to read numbers, beside the others.
pub(crate) struct Candidate {
    pub(crate) reading: Reading,
    pub(crate) off_rad: f64,
    /// How much half a unit of the last decimal of every number turns, at most.
    pub(crate) half_unit_rad: f64,
    /// What fits in a lower class needs none of a higher one.
    pub(crate) class: u8,
    /// The lower, the more usual in its class.
    pub(crate) rank: u8,
}

/// How much half a unit of the last decimal of every number turns, at most: the four of a quaternion have
/// norm 1, and the nine of a matrix norm √3.
pub(crate) const HALF_UNIT_RAD: f64 = 4.0;

/// How far numbers may be from what was meant, by their last decimals.
#[derive(Clone, Copy)]
pub(crate) struct Rounding {
    /// Half a unit of the last decimal.
    pub(crate) half_unit: f64,
    /// Whether there are too many decimals for exact numbers, such as 0.5 or 30.
    is_certain: bool,
}

impl Rounding {
    pub(crate) const NONE: Self = Self {
        half_unit: 0.0,
        is_certain: true,
    };

    pub(crate) fn of(text: &str) -> Self {
        let decimals = decimals(text);
        Self {
            half_unit: half_unit(decimals),
            is_certain: decimals >= ROUNDED_DECIMALS,
        }
    }

    /// Half a unit, or none of numbers that may be exact.
    pub(crate) fn certain(self) -> f64 {
        if self.is_certain { self.half_unit } else { 0.0 }
    }
}

/// The candidates that fit, the most usual first, and then the others, the nearest first.
pub(crate) fn judged(
    candidates: Vec<Candidate>,
    of_numbers: Rounding,
    of_attitude: Rounding,
) -> NumbersReport {
    let rounded_rad = |candidate: &Candidate, numbers: f64, attitude: f64| {
        let rounded_rad = numbers * candidate.half_unit_rad + attitude * HALF_UNIT_RAD;
        rounded_rad.clamp(SINGLE_PRECISION_RAD, COARSEST_RAD)
    };
    let is_believed = |candidate: &Candidate| {
        candidate.off_rad <= rounded_rad(candidate, of_numbers.half_unit, of_attitude.half_unit)
    };
    let believed = candidates.iter().filter(|candidate| is_believed(candidate));
    let nearest_rad = believed
        .map(|candidate| candidate.off_rad)
        .fold(f64::INFINITY, f64::min);
    let fits = |candidate: &Candidate| {
        let certain_rad = rounded_rad(candidate, of_numbers.certain(), of_attitude.certain());
        is_believed(candidate)
            && candidate.off_rad <= certain_rad.max(CLEARLY_FARTHER * nearest_rad)
    };
    let (mut fitting, mut others): (Vec<_>, Vec<_>) = candidates.into_iter().partition(fits);
    let lowest = fitting.iter().map(|candidate| candidate.class).min();
    fitting.retain(|candidate| Some(candidate.class) == lowest);
    fitting.sort_by_key(|candidate| candidate.rank);
    others.sort_by(|one, other| one.off_rad.total_cmp(&other.off_rad));
    let margin_deg = others.first().map(|nearest| nearest.reading.off_deg);
    let count = fitting.len();
    fitting.append(&mut others);
    NumbersReport {
        quaternion: None,
        readings: fitting
            .into_iter()
            .take(MOST_READINGS)
            .map(|candidate| candidate.reading)
            .collect(),
        fitting: count,
        decides: count == 1,
        margin_deg,
    }
}
