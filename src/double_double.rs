//! Numbers with 106 bits: a double, and what it lacks.
//!
//! A product is split and not fused (Dekker 1971): WebAssembly has no fused multiplication, and one that is
//! computed takes ten times as long. No factor may be larger than 2^996, or its parts are infinite; and the
//! product not smaller than 2^-968, or what it lacks is no double.

use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// The sum of two doubles, of which the second is at most half a unit in the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleDouble {
    rounded: f64,
    rest: f64,
}

impl DoubleDouble {
    /// π.
    pub(crate) const PI: Self = Self {
        rounded: std::f64::consts::PI,
        rest: 1.224_646_799_147_353_2e-16,
    };

    /// The nearest double.
    pub(crate) const fn rounded(self) -> f64 {
        self.rounded
    }

    /// What [`Self::rounded`] lacks.
    pub(crate) const fn rest(self) -> f64 {
        self.rest
    }

    /// `a + b`, exact (Knuth's `TwoSum`).
    fn sum(a: f64, b: f64) -> Self {
        let rounded = a + b;
        let of_a = rounded - b;
        let of_b = rounded - of_a;
        Self {
            rounded,
            rest: (a - of_a) + (b - of_b),
        }
    }

    /// `a + b`, exact where a is not the smaller one (Dekker's `Fast2Sum`).
    fn sum_of_ordered(a: f64, b: f64) -> Self {
        let rounded = a + b;
        Self {
            rounded,
            rest: b - (rounded - a),
        }
    }

    /// `a · b`, exact.
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let rounded = a * b;
        let ((a, a_rest), (b, b_rest)) = (halves(a), halves(b));
        Self {
            rounded,
            rest: ((a * b - rounded) + a * b_rest + a_rest * b) + a_rest * b_rest,
        }
    }

    /// The quotient with 106 bits.
    pub(crate) fn divided_by(self, divisor: Self) -> Self {
        let first = self.rounded / divisor.rounded;
        let rest = self - divisor * first.into();
        Self::sum(first, rest.rounded / divisor.rounded)
    }

    /// The square root with 106 bits (Karp and Markstein 1997, eq. 4); 0 of 0.
    pub(crate) fn sqrt(self) -> Self {
        if self.rounded == 0.0 {
            return self;
        }
        let root = self.rounded.sqrt();
        let rest = self - Self::product(root, root);
        Self::sum(root, rest.rounded / (2.0 * root))
    }
}

/// The upper 26 bits of a double and the others, which have a sign of their own (Veltkamp).
fn halves(number: f64) -> (f64, f64) {
    let enlarged = number * 134_217_729.0;
    let upper = enlarged - (enlarged - number);
    (upper, number - upper)
}

impl From<f64> for DoubleDouble {
    fn from(rounded: f64) -> Self {
        Self { rounded, rest: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            rounded: -self.rounded,
            rest: -self.rest,
        }
    }
}

/// Within 3 · 2^-106 (Joldes, Muller and Popescu 2017, algorithm 6).
impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let upper = Self::sum(self.rounded, other.rounded);
        let lower = Self::sum(self.rest, other.rest);
        let sum = Self::sum_of_ordered(upper.rounded, upper.rest + lower.rounded);
        Self::sum_of_ordered(sum.rounded, lower.rest + sum.rest)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Within 7 · 2^-106 (the same, algorithm 10).
impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.rounded, other.rounded);
        let crossed = self.rounded * other.rest + self.rest * other.rounded;
        Self::sum_of_ordered(product.rounded, product.rest + crossed)
    }
}

impl AddAssign for DoubleDouble {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for DoubleDouble {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for DoubleDouble {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{E, PI};

    /// Numbers of all digits, from the least to the most.
    fn numbers(least: f64, most: f64) -> impl Iterator<Item = f64> {
        let grown = move |number: &f64| Some(number * -E / 2.0);
        std::iter::successors(Some(least * PI), grown).take_while(move |number| number.abs() < most)
    }

    /// What a product lacks is what a fused one tells.
    #[test]
    fn a_product_is_exact() {
        for a in numbers(1e-120, 1e250) {
            for b in numbers(1e-120, 1e50) {
                let product = DoubleDouble::product(a, b);
                assert_eq!(product.rounded(), a * b, "{a:e} {b:e}");
                assert_eq!(product.rest(), a.mul_add(b, -(a * b)), "{a:e} {b:e}");
            }
        }
    }

    /// A root squared, and a quotient times its divisor, are what they are of but for 106 bits.
    #[test]
    fn roots_and_quotients_have_twice_the_digits() {
        for a in numbers(1e-3, 1e3) {
            for b in numbers(1e-2, 1e4) {
                let product = DoubleDouble::product(a, b);
                let quotient = DoubleDouble::from(a).divided_by(product);
                let off = (quotient * product - a.into()).rounded() / a;
                assert!(off.abs() < 1e-30, "{a} {b}: {off:e}");
                let square = product * product;
                let root = square.sqrt();
                let off = (root * root - square).rounded() / square.rounded();
                assert!(off.abs() < 1e-30, "{a} {b}: {off:e}");
            }
        }
    }

    /// `1 / (1/3)`, the third with all its 106 bits, is 3.
    #[test]
    fn one_third_of_a_third() {
        let one = DoubleDouble::from(1.0);
        let third = one.divided_by(3.0.into());
        let error = one.divided_by(third) - 3.0.into();
        assert!(error.rounded().abs() < 1e-31);
    }
}
