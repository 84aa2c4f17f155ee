//! Which norms four numbers may have that are read as a quaternion.

use crate::convention::order::OrderSource;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::ParsedQuaternion;
use std::ops::RangeInclusive;

/// What rounding makes of a norm of 1, and more: two decimals are off by 0.01 at most.
const NEAR_UNIT: RangeInclusive<f64> = 0.9..=1.1;

/// Below this only rounding is left: of numbers of about 1, single precision is off by 6e-8, and after a
/// few operations by ten times as much. Nobody scales a quaternion so.
const ROUNDED_TO_ZERO: f64 = 1e-6;

/// Of such a norm x, y, z and w by name are something else: a position in millimetres and an angle.
const NO_QUATERNION: f64 = 100.0;

/// Whether the norm of numbers that nothing says to be a quaternion leaves it open what they are.
pub(crate) fn is_far_from_unit(parsed: &ParsedQuaternion, norm: f64) -> bool {
    !parsed.is_announced && !NEAR_UNIT.contains(&norm)
}

/// That numbers of such a norm are read; what else they may be, a build without suggestions cannot ask.
pub(crate) fn check_norm(parsed: &ParsedQuaternion, norm: f64, span: Span) -> Result<(), Fault> {
    // Four times −9999 is what some programs write for no value.
    let first = parsed.quaternion.w;
    if norm > NO_QUATERNION
        && parsed
            .quaternion
            .coords
            .iter()
            .all(|number| *number == first)
    {
        return Err(Fault::far_from_unit(span, norm));
    }
    if !is_far_from_unit(parsed, norm) || norm == 0.0 {
        return Ok(());
    }
    if norm < ROUNDED_TO_ZERO {
        return Err(Fault::zero_but_for_rounding(span, norm));
    }
    let is_named = parsed.order_source == OrderSource::Named;
    if !cfg!(feature = "whole") || (is_named && norm > NO_QUATERNION) {
        return Err(Fault::far_from_unit(span, norm));
    }
    Ok(())
}
