//! Doubles to and from decimal text, by JavaScript: that spares the wasm tables of 25 kB.
//!
//! This takes the place of `src/decimal.rs`, which does the same natively.

/// The double nearest to a decimal number: digits, a point, an exponent.
pub(crate) fn nearest_double(decimal: &str) -> f64 {
    js_sys::parse_float(decimal)
}

/// The shortest decimal number that reads back as the same double.
pub(crate) fn shortest(number: f64) -> String {
    js_sys::Number::from(number)
        .to_string_with_radix(10)
        .map_or_else(|_| String::new(), String::from)
}
