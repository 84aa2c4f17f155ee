//! Doubles to and from decimal text.
//!
//! In the wasm `src/wasm/decimal.rs` stands in its place: JavaScript has the tables that this needs.

/// The double nearest to a decimal number: digits, a point, an exponent.
pub(crate) fn nearest_double(decimal: &str) -> f64 {
    decimal.parse().unwrap_or(f64::NAN)
}

/// The shortest decimal number that reads back as the same double.
pub(crate) fn shortest(number: f64) -> String {
    literal(number)
}

/// The same with a point or an exponent, as languages write a double.
pub(crate) fn literal(number: f64) -> String {
    format!("{number:?}")
}
