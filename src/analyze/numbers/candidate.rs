//! The ways to read numbers beside an attitude, and which of them fit.
//!
//! Those fit that are no farther from the attitude than the rounding of both texts leaves open, and not
//! clearly farther than the nearest.

use crate::analyze::identify::observation::{ROUNDED_DECIMALS, decimals, half_unit};

/// Noise of single precision, in radians, after a few operations.
const SINGLE_PRECISION_RAD: f64 = 1e-5;

/// Farther than this, 1.5°, nothing is believed to be rounded: three whole degrees are together as far off.
pub(crate) const COARSEST_RAD: f64 = 0.0262;

/// A reading that is this many times farther than the nearest is not the one, unless both are within what
/// is certainly rounded.
const CLEARLY_FARTHER: f64 = 3.0;

/// How much half a unit of the last decimal of every number turns, at most: the four of a quaternion have
/// norm 1, and the nine of a matrix norm √3.
pub(crate) const HALF_UNIT_RAD: f64 = 4.0;

/// One way to read numbers, as it is compared with the others.
#[derive(Clone, Copy)]
pub(crate) struct Candidate {
    /// How far the attitude is that it reads.
    pub(crate) off_rad: f64,
    /// How much half a unit of the last decimal of every number turns, at most.
    pub(crate) half_unit_rad: f64,
    /// What fits in a lower class needs none of a higher one.
    pub(crate) class: u8,
    /// The lower, the more usual in its class.
    pub(crate) rank: u8,
}

/// How far numbers may be from what was meant, by their last decimals.
#[derive(Clone, Copy)]
pub(crate) struct Rounding {
    /// Half a unit of the last decimal.
    half_unit: f64,
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
    fn certain(self) -> f64 {
        if self.is_certain { self.half_unit } else { 0.0 }
    }
}

/// How a candidate stands to the attitude; ordered as they are told.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Standing {
    /// It fits: its rank.
    Fits(u8),
    /// It does not: how far off it is.
    Off(f64),
    /// It fits, and so does a simpler one.
    Spared,
}

/// Which candidates fit.
pub(crate) struct Judged {
    standings: Vec<Standing>,
    /// How many fit.
    pub(crate) fitting: usize,
    /// How far the nearest is that does not.
    pub(crate) margin_rad: Option<f64>,
}

impl Judged {
    pub(crate) fn of(
        candidates: &[Candidate],
        of_numbers: Rounding,
        of_attitude: Rounding,
    ) -> Self {
        let rounded_rad = |half_unit_rad: f64, numbers: f64, attitude: f64| {
            (numbers * half_unit_rad + attitude * HALF_UNIT_RAD)
                .clamp(SINGLE_PRECISION_RAD, COARSEST_RAD)
        };
        let is_believed = |off_rad: f64, half_unit_rad: f64| {
            off_rad <= rounded_rad(half_unit_rad, of_numbers.half_unit, of_attitude.half_unit)
        };
        let mut nearest_rad = f64::INFINITY;
        for candidate in candidates {
            if is_believed(candidate.off_rad, candidate.half_unit_rad) {
                nearest_rad = nearest_rad.min(candidate.off_rad);
            }
        }
        let fits = |candidate: &Candidate| {
            let (numbers, attitude) = (of_numbers.certain(), of_attitude.certain());
            let certain_rad = rounded_rad(candidate.half_unit_rad, numbers, attitude);
            is_believed(candidate.off_rad, candidate.half_unit_rad)
                && candidate.off_rad <= certain_rad.max(CLEARLY_FARTHER * nearest_rad)
        };
        let mut lowest = u8::MAX;
        for candidate in candidates {
            if fits(candidate) {
                lowest = lowest.min(candidate.class);
            }
        }
        let mut judged = Self {
            standings: Vec::with_capacity(candidates.len()),
            fitting: 0,
            margin_rad: None,
        };
        for candidate in candidates {
            let off_rad = candidate.off_rad;
            judged.standings.push(if !fits(candidate) {
                judged.margin_rad = Some(
                    judged
                        .margin_rad
                        .map_or(off_rad, |least| least.min(off_rad)),
                );
                Standing::Off(off_rad)
            } else if candidate.class > lowest {
                Standing::Spared
            } else {
                judged.fitting += 1;
                Standing::Fits(candidate.rank)
            });
        }
        judged
    }

    /// The place of the next to be told: those that fit, the most usual first, and then the others, the
    /// nearest first. None is told twice.
    pub(crate) fn next(&mut self) -> Option<usize> {
        let mut best: Option<(usize, Standing)> = None;
        for (at, standing) in self.standings.iter().enumerate() {
            // The first of equal ones.
            let is_better = best.is_none_or(|(_, best)| *standing < best);
            if *standing != Standing::Spared && is_better {
                best = Some((at, *standing));
            }
        }
        let (at, _) = best?;
        self.standings[at] = Standing::Spared;
        Some(at)
    }
}
