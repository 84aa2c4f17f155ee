//! How much each of many observations counts.

use crate::rotation::precise;
use std::fmt;

/// Why weights cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnusableWeights {
    /// There is not one weight for each.
    CountsDiffer,
    /// A weight is negative, infinite or not a number.
    NegativeOrNotFinite,
    /// All weights are zero.
    AllZero,
}

impl UnusableWeights {
    pub(crate) fn message(self) -> &'static str {
        match self {
            Self::CountsDiffer => "the number of weights is another than that of what they weigh",
            Self::NegativeOrNotFinite => {
                "a weight needs to be a finite number that is not negative"
            }
            Self::AllZero => "all weights are zero",
        }
    }
}

impl fmt::Display for UnusableWeights {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl std::error::Error for UnusableWeights {}

/// The weights times the power of two that makes the largest 1/2 or more, and less than 1.
pub(crate) fn at_unit_size(weights: &[f64], count: usize) -> Result<Vec<f64>, UnusableWeights> {
    if weights.len() != count {
        return Err(UnusableWeights::CountsDiffer);
    }
    let is_weight = |&weight: &f64| weight >= 0.0 && weight.is_finite();
    if !weights.iter().all(is_weight) {
        return Err(UnusableWeights::NegativeOrNotFinite);
    }
    if weights.iter().all(|&weight| weight == 0.0) {
        return Err(UnusableWeights::AllZero);
    }
    let exponent = precise::binary_exponent(weights);
    let scaled = |&weight: &f64| precise::times_power_of_two(weight, -exponent);
    Ok(weights.iter().map(scaled).collect())
}
