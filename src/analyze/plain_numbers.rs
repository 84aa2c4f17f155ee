//! Numbers of the types of algebra as the plain ones of a report, where −0 is 0.

use crate::contract::Components;
use crate::convention::order::ComponentOrder;
use crate::rotation::precise::Norm;
use nalgebra::{Matrix3, Matrix4, Quaternion, Vector3};
use winnow::ascii::{digit0, digit1};
use winnow::combinator::{alt, opt};
use winnow::error::EmptyError;
use winnow::prelude::*;
use winnow::token::one_of;

/// The number itself, with −0 written as 0.
pub(crate) fn plain(number: f64) -> f64 {
    number + 0.0
}

/// Whether a text is a decimal number and no more: a sign, digits, a point, an exponent.
pub(crate) fn is_decimal(text: &str) -> bool {
    decimal.parse(text).is_ok()
}

fn decimal(input: &mut &str) -> Result<(), EmptyError> {
    let digits = alt(((digit1, opt(('.', digit0))).void(), ('.', digit1).void()));
    let exponent = (one_of(['e', 'E']), opt(one_of(['+', '-'])), digit1);
    (opt(one_of(['+', '-'])), digits, opt(exponent))
        .void()
        .parse_next(input)
}

impl Components {
    pub(crate) fn of(quaternion: &Quaternion<f64>, order: ComponentOrder) -> Self {
        let components = [quaternion.w, quaternion.i, quaternion.j, quaternion.k].map(plain);
        let [w, x, y, z] = components;
        let array = order.array(components);
        let norm = Norm::of(&array).value();
        Self {
            w,
            x,
            y,
            z,
            norm: norm.is_finite().then_some(norm),
            array,
        }
    }
}

pub(crate) fn coordinates(vector: &Vector3<f64>) -> [f64; 3] {
    [vector.x, vector.y, vector.z].map(plain)
}

pub(crate) fn rows3(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    matrix.transpose().map(plain).into()
}

pub(crate) fn rows4(matrix: &Matrix4<f64>) -> [[f64; 4]; 4] {
    matrix.transpose().map(plain).into()
}

#[cfg(test)]
mod tests {
    use super::is_decimal;

    /// All texts of up to five of these characters; words for what is no number are none.
    #[test]
    fn a_decimal_number_is_what_rust_reads_as_a_double() {
        let mut texts = vec![String::new()];
        for _ in 0..5 {
            let shorter = texts.iter();
            let longer = shorter.flat_map(|text| {
                ["1", "+", "-", ".", "e", "E", " "].map(|next| format!("{text}{next}"))
            });
            texts = longer.collect();
            for text in &texts {
                assert_eq!(is_decimal(text), text.parse::<f64>().is_ok(), "{text}");
            }
        }
        for word in ["", "nan", "inf", "-infinity"] {
            assert!(!is_decimal(word), "{word}");
        }
    }
}
