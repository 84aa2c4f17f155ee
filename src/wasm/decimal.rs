//! Doubles to and from decimal text, by JavaScript: that spares the wasm 40 kB of code and tables.
//!
//! This takes the place of `src/decimal.rs`, which does the same natively.

use js_sys::Number;
use wasm_bindgen::prelude::*;

/// The double nearest to a decimal number: digits, a point, an exponent.
pub(crate) fn nearest_double(decimal: &str) -> f64 {
    js_sys::parse_float(decimal)
}

/// The shortest decimal number that reads back as the same double.
pub(crate) fn shortest(number: f64) -> String {
    Number::from(number)
        .to_string_with_radix(10)
        .map_or_else(|_| String::new(), String::from)
}

/// The same with a point or an exponent, as languages write a double. Only the native build knows of −0.
pub(crate) fn literal(number: f64) -> String {
    let size = number.abs();
    if size != 0.0 && !(1e-4..1e16).contains(&size) {
        return to_exponential(number).replace('+', "");
    }
    let mut written = shortest(number);
    if !written.contains('.') {
        written.push_str(".0");
    }
    written
}

#[wasm_bindgen]
extern "C" {
    /// With as many digits as it takes; the one of `js_sys` has to be told how many.
    #[wasm_bindgen(js_namespace = ["Number", "prototype", "toExponential"], js_name = call)]
    fn to_exponential(number: f64) -> String;
}
