//! Products with 106 bits, with the bits of `twofloat` and a third of its time.
//!
//! Where there is no instruction for it, `twofloat` multiplies by `libm::fma`, a hundred instructions of integers:
//! two thirds of the time of a product of quaternions. What the fused operation is needed for, the rounding error
//! of a product, is found by 17 plain operations (Dekker 1971, with the splitting of Veltkamp); a sum that is rounded
//! once, by rounding an inner sum to odd (Boldo & Melquiond 2008). Both are exact while nothing overflows or is
//! subnormal; elsewhere `libm::fma` is asked. A test compares all bits.

use twofloat::TwoFloat;

/// 2^27 + 1 splits a double into two of 26 bits each.
const SPLITTER: f64 = 134_217_729.0;

/// Beyond this a factor would overflow where it is split.
const LARGEST_FACTOR: f64 = f64::from_bits(0x7e20_0000_0000_0000);

/// Below this the error of a product might be subnormal: 2^-960.
const SMALLEST_PRODUCT: f64 = f64::from_bits(0x03f0_0000_0000_0000);

/// Beyond this a sum with a product might overflow: 2^1000.
const LARGEST_PRODUCT: f64 = f64::from_bits(0x7e70_0000_0000_0000);

/// A double, and the two of 26 bits each that it is the sum of.
#[derive(Clone, Copy)]
pub(crate) struct Split {
    number: f64,
    high: f64,
    low: f64,
}

impl Split {
    pub(crate) fn of(number: f64) -> Self {
        let scaled = SPLITTER * number;
        let high = scaled - (scaled - number);
        Self {
            number,
            high,
            low: number - high,
        }
    }

    /// The product of two doubles, all of it.
    #[inline(never)]
    pub(crate) fn times(self, other: Self) -> TwoFloat {
        let product = self.number * other.number;
        if !is_plain(self.number, other.number, product) {
            return TwoFloat::new_mul(self.number, other.number);
        }
        // The parts do not overlap, so that nothing is changed here.
        TwoFloat::new_add(product, self.rest_of(product, other))
    }

    /// What is left of a product beyond its rounded value.
    fn rest_of(self, product: f64, other: Self) -> f64 {
        let rest = self.high * other.high - product;
        ((rest + self.high * other.low) + self.low * other.high) + self.low * other.low
    }
}

/// The product of two doubles, all of it.
pub(crate) fn exact_product(a: f64, b: f64) -> TwoFloat {
    Split::of(a).times(Split::of(b))
}

/// The product with a double (Joldes, Muller & Popescu 2017, algorithm 9).
#[inline(never)]
pub(crate) fn times(number: TwoFloat, factor: f64) -> TwoFloat {
    let high = exact_product(number.hi(), factor);
    let low = fused(number.lo(), factor, high.lo());
    TwoFloat::new_add(high.hi(), low)
}

/// The square (their algorithm 12).
#[inline(never)]
pub(crate) fn square(number: TwoFloat) -> TwoFloat {
    let (hi, lo) = number.into();
    let high = exact_product(hi, hi);
    let low = fused(lo, hi, fused(hi, lo, lo * lo));
    TwoFloat::new_add(high.hi(), high.lo() + low)
}

/// The product of two (their algorithm 12).
#[inline(never)]
pub(crate) fn product(left: TwoFloat, right: TwoFloat) -> TwoFloat {
    let high = exact_product(left.hi(), right.hi());
    let low = fused(left.hi(), right.lo(), left.lo() * right.lo());
    let low = fused(left.lo(), right.hi(), low);
    TwoFloat::new_add(high.hi(), high.lo() + low)
}

/// The product with a power of two.
pub(crate) fn times_power(number: TwoFloat, power: f64) -> TwoFloat {
    let high = number.hi() * power;
    if !(SMALLEST_PRODUCT..=LARGEST_PRODUCT).contains(&high.abs()) {
        return number * power;
    }
    TwoFloat::new_add(high, number.lo() * power)
}

/// The square root, by one step of Newton as in `twofloat`; its argument is not negative.
#[inline(never)]
pub(crate) fn square_root(number: TwoFloat) -> TwoFloat {
    if number.hi() == 0.0 {
        return number.sqrt();
    }
    let reciprocal = number.hi().sqrt().recip();
    let root = number.hi() * reciprocal;
    let rest = number - exact_product(root, root);
    TwoFloat::new_add(root, rest.hi() * (reciprocal * 0.5))
}

/// Whether the error of a product is found by plain operations.
fn is_plain(a: f64, b: f64, product: f64) -> bool {
    let is_between = (SMALLEST_PRODUCT..=LARGEST_PRODUCT).contains(&product.abs());
    is_between && a.abs() <= LARGEST_FACTOR && b.abs() <= LARGEST_FACTOR
}

/// `a b + c`, rounded once.
#[inline(never)]
fn fused(a: f64, b: f64, c: f64) -> f64 {
    let high = a * b;
    if high == 0.0 && (a == 0.0 || b == 0.0) {
        return high + c;
    }
    if !(is_plain(a, b, high) && c.abs() <= LARGEST_PRODUCT) {
        return libm::fma(a, b, c);
    }
    let low = Split::of(a).rest_of(high, Split::of(b));
    let (of_low, of_low_error): (f64, f64) = TwoFloat::new_add(c, low).into();
    let (sum, sum_error): (f64, f64) = TwoFloat::new_add(high, of_low).into();
    sum + rounded_to_odd(of_low_error, sum_error)
}

/// The sum, or that of its two neighbours whose last bit is 1.
fn rounded_to_odd(a: f64, b: f64) -> f64 {
    let (sum, error): (f64, f64) = TwoFloat::new_add(a, b).into();
    let bits = sum.to_bits();
    if error == 0.0 || bits & 1 == 1 {
        return sum;
    }
    // Toward the error: away from zero where it has the sign of the sum.
    f64::from_bits(if (error > 0.0) == (sum > 0.0) {
        bits + 1
    } else {
        bits - 1
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of all sizes, with many bits and with few, and with the ends of the range.
    struct Numbers(u64);

    impl Numbers {
        fn bits(&mut self) -> u64 {
            // SplitMix64.
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut mixed = self.0;
            mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            mixed ^ (mixed >> 31)
        }

        fn number(&mut self) -> f64 {
            const ENDS: [f64; 8] = [
                0.0,
                -0.0,
                5e-324,
                f64::MIN_POSITIVE,
                f64::MAX,
                1.0,
                f64::INFINITY,
                f64::NAN,
            ];
            let kind = self.bits() % 16;
            let bits = self.bits();
            match kind {
                0 => ENDS[usize::try_from(bits % 8).unwrap_or(0)],
                // Of any size.
                1..=3 => f64::from_bits(bits),
                // Few bits: products and sums that are exact, or half way between two doubles.
                4..=7 => f64::from_bits(bits & 0xbfff_ffff_f000_0000 | 0x3000_0000_0000_0000),
                // Near 1, as components are.
                _ => f64::from_bits(bits & 0x800f_ffff_ffff_ffff | 0x3fe0_0000_0000_0000),
            }
        }

        fn pair(&mut self) -> TwoFloat {
            let high = self.number();
            let low = self.number() * high * 1e-17;
            TwoFloat::new_add(high, if low.is_finite() { low } else { 0.0 })
        }
    }

    fn same(one: f64, other: f64) -> bool {
        one.to_bits() == other.to_bits() || (one.is_nan() && other.is_nan())
    }

    fn same_pair(one: TwoFloat, other: TwoFloat) -> bool {
        // The sign of a zero that is added to the rest of a number is nowhere seen.
        let is_low = same(one.lo(), other.lo()) || (one.lo() == 0.0 && other.lo() == 0.0);
        same(one.hi(), other.hi()) && (is_low || !one.hi().is_finite())
    }

    #[test]
    fn products_have_the_bits_of_twofloat() {
        let mut numbers = Numbers(17);
        let mut plain = 0;
        for _ in 0..200_000 {
            let (a, b, c) = (numbers.number(), numbers.number(), numbers.number());
            plain += usize::from(is_plain(a, b, a * b));
            assert!(
                same_pair(exact_product(a, b), TwoFloat::new_mul(a, b)),
                "{a:e} {b:e}"
            );
            assert!(
                same(fused(a, b, c), libm::fma(a, b, c)),
                "{a:e} {b:e} {c:e}"
            );
            // A third number that takes nearly all of the product away, or is half of its last place.
            for near in [-a * b, a * b * 1.1e-16, -a * b * 2.2e-16] {
                assert!(
                    same(fused(a, b, near), libm::fma(a, b, near)),
                    "{a:e} {b:e} {near:e}"
                );
            }
        }
        assert!(plain > 100_000, "{plain}");
    }

    #[test]
    fn products_of_106_bits_have_the_bits_of_twofloat() {
        let mut numbers = Numbers(18);
        for _ in 0..200_000 {
            let (one, other, factor) = (numbers.pair(), numbers.pair(), numbers.number());
            assert!(
                same_pair(times(one, factor), one * factor),
                "{one:?} {factor:e}"
            );
            assert!(
                same_pair(product(one, other), one * other),
                "{one:?} {other:?}"
            );
            assert!(same_pair(square(one), one * one), "{one:?}");
            let exponent = i32::try_from(numbers.bits() % 900).unwrap_or(0) - 450;
            let power = libm::scalbn(1.0, exponent);
            assert!(
                same_pair(times_power(one, power), one * power),
                "{one:?} {power:e}"
            );
            if one.hi() >= 0.0 && one.hi().is_finite() {
                assert!(same_pair(square_root(one), one.sqrt()), "{one:?}");
            }
        }
    }
}
