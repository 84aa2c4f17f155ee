//! Exact scaling by powers of two, so that squares neither overflow nor underflow.

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

/// The Euclidean norm as `(fraction, exponent)`, meaning `fraction * 2^exponent`; never overflows.
pub(crate) fn norm(numbers: &[f64]) -> (f64, i32) {
    let exponent = binary_exponent(numbers);
    let sum_of_squares: f64 = numbers
        .iter()
        .map(|&number| times_power_of_two(number, -exponent))
        .map(|number| number * number)
        .sum();
    (libm::sqrt(sum_of_squares), exponent)
}
