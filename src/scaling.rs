//! Exact scaling by powers of two, so that squares neither overflow nor underflow.

use nalgebra::Vector3;

/// The exponent `e` for which the largest magnitude is `m * 2^e` with `m` in [1/2, 1).
///
/// 0 where all the numbers are zero.
pub(crate) fn binary_exponent(numbers: &[f64]) -> i32 {
    let largest = numbers.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
    libm::frexp(largest).1
}

/// `number * 2^exponent`, exact unless the result is subnormal or too large.
pub(crate) fn times_power_of_two(number: f64, exponent: i32) -> f64 {
    libm::scalbn(number, exponent)
}

/// A Euclidean norm, `fraction * 2^exponent`, which may be larger than any double.
#[derive(Clone, Copy)]
pub(crate) struct Norm {
    /// 0, or in [1/2, 2]: the norm of the numbers scaled by `2^-exponent`.
    pub(crate) fraction: f64,
    pub(crate) exponent: i32,
}

impl Norm {
    pub(crate) fn of(numbers: &[f64]) -> Self {
        let exponent = binary_exponent(numbers);
        let sum_of_squares: f64 = numbers
            .iter()
            .map(|&number| times_power_of_two(number, -exponent))
            .map(|number| number * number)
            .sum();
        Self {
            fraction: libm::sqrt(sum_of_squares),
            exponent,
        }
    }

    /// As a double; infinite where it is larger than any.
    pub(crate) fn value(self) -> f64 {
        times_power_of_two(self.fraction, self.exponent)
    }
}

/// The vector of length 1 with the same direction; `None` for the zero vector.
pub(crate) fn direction(vector: &Vector3<f64>) -> Option<Vector3<f64>> {
    let Norm { fraction, exponent } = Norm::of(vector.as_slice());
    let scaled = vector.map(|number| times_power_of_two(number, -exponent));
    (fraction > 0.0).then(|| scaled / fraction)
}
