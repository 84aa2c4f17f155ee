//! Numbers out of reach of overflow, underflow and rounding: exact scaling by powers of two, and
//! sums of products with 106 bits that are rounded once.
//!
//! The doubled precision is `twofloat`'s (Joldes, Muller & Popescu 2017). It is what makes the last
//! digit of a product, a matrix or a norm right; plain doubles lose two to six units of it.

use crate::rotation::products::{self, Split};
use nalgebra::{Matrix3, Quaternion, Vector3};
use twofloat::TwoFloat;

/// Half a unit in the last place of 1: the largest relative error of one rounding.
pub(crate) const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Scaled numbers have their largest magnitude in `[2^399, 2^400)`.
///
/// So high, that the smallest double beside 1 is a normal number there and keeps its digits when it
/// is halved; so low, that the sum of squares is far from the largest double.
const WORKING_EXPONENT: i32 = 400;

/// The exponent `e` for which the largest magnitude is `m * 2^e` with `m` in [1/2, 1).
///
/// 0 where all the numbers are zero.
pub(crate) fn binary_exponent(numbers: &[f64]) -> i32 {
    let largest = numbers.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
    if !largest.is_normal() {
        return libm::frexp(largest).1;
    }
    exponent_bits(largest) - 1022
}

/// The exponent of a normal number that is not negative, as it is stored.
fn exponent_bits(number: f64) -> i32 {
    i32::try_from(number.to_bits() >> 52).unwrap_or(0)
}

/// `number * 2^exponent`, exact unless the result is subnormal or too large.
pub(crate) fn times_power_of_two(number: f64, exponent: i32) -> f64 {
    // A power that is a normal number takes one product.
    match u64::try_from(exponent + 1023) {
        Ok(stored @ 1..=2046) => number * f64::from_bits(stored << 52),
        _ => libm::scalbn(number, exponent),
    }
}

/// The same with 106 bits, where `2^exponent` may be larger than any double.
pub(crate) fn precisely_times_power_of_two(number: TwoFloat, exponent: i32) -> TwoFloat {
    TwoFloat::new_add(
        times_power_of_two(number.hi(), exponent),
        times_power_of_two(number.lo(), exponent),
    )
}

/// The power of two that brings these numbers to the working size.
pub(crate) fn working_scale(numbers: &[f64]) -> i32 {
    WORKING_EXPONENT - binary_exponent(numbers)
}

/// The number at the working size, where 1 is `2^400`.
pub(crate) fn working_size(number: f64) -> f64 {
    times_power_of_two(number, WORKING_EXPONENT)
}

/// A number of the working size, where `2^400` becomes 1.
pub(crate) fn from_working_size(number: f64) -> f64 {
    times_power_of_two(number, -WORKING_EXPONENT)
}

/// The quaternion times `2^exponent`.
pub(crate) fn scale(quaternion: &Quaternion<f64>, exponent: i32) -> Quaternion<f64> {
    let scaled = |number| times_power_of_two(number, exponent);
    Quaternion {
        coords: quaternion.coords.map(scaled),
    }
}

/// The quotient with 106 bits.
///
/// The division of `twofloat` 0.8 by a `TwoFloat` has only the 53 bits of a plain one: it rounds a
/// product that Joldes' algorithm 18 fuses (`one_third_of_a_third` in the tests keeps the case).
pub(crate) fn quotient(dividend: TwoFloat, divisor: TwoFloat) -> TwoFloat {
    let first = dividend.hi() / divisor.hi();
    let rest = dividend - products::times(divisor, first);
    TwoFloat::new_add(first, rest.hi() / divisor.hi())
}

/// A Euclidean norm, `fraction * 2^exponent`, which may be larger than any double.
#[derive(Clone, Copy)]
pub(crate) struct Norm {
    /// 0, or in `[2^399, 2^401]`: the norm of the numbers scaled by `2^-exponent`.
    pub(crate) fraction: TwoFloat,
    pub(crate) exponent: i32,
}

impl Norm {
    pub(crate) fn of(numbers: &[f64]) -> Self {
        let scale = working_scale(numbers);
        let sum_of_squares = numbers
            .iter()
            .map(|&number| times_power_of_two(number, scale))
            .map(|number| products::exact_product(number, number))
            .fold(TwoFloat::from(0.0), |sum, square| sum + square);
        Self {
            fraction: products::square_root(sum_of_squares),
            exponent: -scale,
        }
    }

    pub(crate) fn is_zero(self) -> bool {
        self.fraction.hi() == 0.0
    }

    /// As a double; infinite where it is larger than any.
    pub(crate) fn value(self) -> f64 {
        times_power_of_two(self.fraction.hi(), self.exponent)
    }

    /// The exponent `e` of the power of two `2^e` that the norm is but for a rounding of the
    /// numbers; `None` where it is none.
    ///
    /// Rounding each component of a quaternion of norm 1 to a double changes the norm by at most
    /// one roundoff.
    pub(crate) fn rounded_power_of_two(self) -> Option<i32> {
        let (fraction, exponent) = libm::frexp(self.fraction.hi());
        let nearest = if fraction > 0.75 {
            exponent
        } else {
            exponent - 1
        };
        let power = times_power_of_two(1.0, nearest);
        let deviation = (self.fraction - power) / power;
        (deviation.hi().abs() <= UNIT_ROUNDOFF).then_some(nearest + self.exponent)
    }

    /// A number divided by the norm, rounded once.
    pub(crate) fn divide(self, number: f64) -> f64 {
        self.divide_precisely(number).hi()
    }

    /// A number divided by the norm, with 106 bits.
    pub(crate) fn divide_precisely(self, number: f64) -> TwoFloat {
        let scaled = times_power_of_two(number, -self.exponent);
        quotient(scaled.into(), self.fraction)
    }
}

/// The vector of length 1 with the same direction; `None` for the zero vector.
pub(crate) fn direction(vector: &Vector3<f64>) -> Option<Vector3<f64>> {
    let norm = Norm::of(vector.as_slice());
    (!norm.is_zero()).then(|| vector.map(|number| norm.divide(number)))
}

/// The Hamilton product `[w, x, y, z]` with 106 bits.
///
/// Summed in pairs, each of which is small by itself where the factors are conjugate but for a small
/// difference; so the relative rotation of two near attitudes keeps its digits.
pub(crate) fn hamilton_product(left: &Quaternion<f64>, right: &Quaternion<f64>) -> [TwoFloat; 4] {
    let [lw, lx, ly, lz] = split(left);
    let [rw, rx, ry, rz] = split(right);
    [
        (lw.times(rw) - lx.times(rx)) - (ly.times(ry) + lz.times(rz)),
        (lw.times(rx) + lx.times(rw)) + (ly.times(rz) - lz.times(ry)),
        (lw.times(ry) + ly.times(rw)) + (lz.times(rx) - lx.times(rz)),
        (lw.times(rz) + lz.times(rw)) + (lx.times(ry) - ly.times(rx)),
    ]
}

/// The components `[w, x, y, z]`, ready to be multiplied.
pub(crate) fn split(quaternion: &Quaternion<f64>) -> [Split; 4] {
    let Quaternion { coords } = quaternion;
    [coords.w, coords.x, coords.y, coords.z].map(Split::of)
}

/// The quaternion of norm `2^399` with the direction of `[w, x, y, z]`, each component rounded once.
///
/// For components of at most the working size, squared. `None` where all are zero.
pub(crate) fn rounded_direction(components: [TwoFloat; 4]) -> Option<Quaternion<f64>> {
    let exponent = binary_exponent(rounded(components).coords.as_slice());
    let power = times_power_of_two(1.0, WORKING_EXPONENT - exponent);
    let mut scaled = components;
    let mut sum_of_squares = TwoFloat::from(0.0);
    for number in &mut scaled {
        *number = products::times_power(*number, power);
        sum_of_squares += products::square(*number);
    }
    let size = times_power_of_two(1.0, WORKING_EXPONENT - 1);
    let norm = products::square_root(sum_of_squares);
    for number in &mut scaled {
        *number = quotient(products::times_power(*number, size), norm);
    }
    (norm.hi() > 0.0).then(|| rounded(scaled))
}

/// The quaternion of four components `[w, x, y, z]`, each rounded once.
pub(crate) fn rounded([w, x, y, z]: [TwoFloat; 4]) -> Quaternion<f64> {
    Quaternion::new(w.hi(), x.hi(), y.hi(), z.hi())
}

/// A matrix times a column, in the order of nalgebra's product, which would compare with zero and so bring
/// libm's table of powers into the wasm.
pub(crate) fn product(matrix: &Matrix3<TwoFloat>, column: Vector3<TwoFloat>) -> Vector3<TwoFloat> {
    let [x, y, z] = column.into();
    let times = products::product;
    Vector3::from_fn(|row, _| {
        let at = |place| matrix[(row, place)];
        times(at(0), x) + times(at(1), y) + times(at(2), z)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Why [`quotient`] is written here: `1 / (1/3)`, the third with all its 106 bits, is 3.
    #[test]
    fn one_third_of_a_third() {
        let third = TwoFloat::new_div(1.0, 3.0);
        let one = TwoFloat::from(1.0);
        let error = |quotient: TwoFloat| (quotient - 3.0).hi().abs();
        assert!(error(quotient(one, third)) < 1e-31);
        assert!(
            error(one / third) > 1e-17,
            "twofloat divides well now: use it"
        );
    }
}
