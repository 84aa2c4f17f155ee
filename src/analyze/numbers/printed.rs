//! What was printed beside an attitude, as numbers: three, four or nine.

use crate::analyze::attitude::Declared;
use crate::analyze::identify::observation::matrix;
use crate::analyze::matrix::of_matrix;
use crate::convention::Convention;
use crate::convention::angle::AngleUnit;
use crate::convention::matrix::MatrixConvention;
use crate::convention::order::{ComponentOrder, OrderSource};
use crate::decimal::nearest_double;
use crate::problem::fault::Fault;
use crate::problem::{Span, is_too_long};
use crate::rotation::Rotation;
use crate::rotation::precise::Norm;
use crate::rotation::quaternion::TaggedQuaternion;
use crate::text::mend::typed_numbers::typed_numbers;
use crate::text::{ParsedQuaternion, ParsedRotation, parse_rotation, parse_vector};
use nalgebra::Matrix3;

const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// Numbers beside an attitude.
pub(crate) enum Printed {
    /// With their unit, where the text says it.
    Three([f64; 3], Option<AngleUnit>),
    /// What they are in each order in which they may stand.
    Four(Vec<(ComponentOrder, Rotation)>),
    Nine(SeenMatrix),
}

/// A matrix as a multiple of a rotation, or of a rotation times −1.
pub(crate) struct SeenMatrix {
    /// Negative where it is a reflection.
    pub(crate) scale: f64,
    /// The matrix divided by that, as one body to world.
    pub(crate) turn: Rotation,
}

impl Printed {
    pub(crate) fn of(text: &str, declared: Declared) -> Result<Self, Fault> {
        let span = Span::of_trimmed(text);
        if is_too_long(text) || text.trim().is_empty() {
            // Said as of a vector.
            parse_vector(text)?;
        }
        if let Ok(vector) = parse_vector(text) {
            return Ok(Self::Three(vector.into(), None));
        }
        let order = declared.convention.order;
        let read = parse_rotation(text, order);
        if let Ok(ParsedRotation::Quaternion(parsed)) = read {
            return orders(&parsed, declared.convention, span).map(Self::Four);
        }
        let typed = typed_numbers(&without_names(text));
        match &typed[..] {
            [a, b, c] => {
                let numbers = [a, b, c].map(|number| nearest_double(number));
                Ok(Self::Three(numbers, unit_of(text)))
            }
            // Four that are none of a quaternion: why, its reader says.
            [_, _, _, _] => Err(read.err().unwrap_or_else(|| Fault::not_numbers(span, 4))),
            _ if typed.len() < 9 => Err(Fault::not_numbers(span, typed.len())),
            _ => seen_matrix(&matrix(text)?, span).map(Self::Nine),
        }
    }
}

/// The text with a space for every letter of a name, and for the digits behind it: no `32` of `float32` is a
/// number. What follows a digit is an exponent or a unit.
fn without_names(text: &str) -> String {
    let mut plain = String::new();
    let mut before = ' ';
    let mut is_name = false;
    for character in text.chars() {
        let is_part = character.is_ascii_alphanumeric() || character == '_';
        let is_after_number = before.is_ascii_digit() || before == '.';
        is_name = is_part && (is_name || !character.is_ascii_digit() && !is_after_number);
        before = character;
        plain.push(if is_name { ' ' } else { character });
    }
    plain
}

/// The unit that a text says of its numbers.
fn unit_of(text: &str) -> Option<AngleUnit> {
    let text = text.to_ascii_lowercase();
    if text.contains("deg") || text.contains('°') {
        Some(AngleUnit::Degrees)
    } else if text.contains("rad") {
        Some(AngleUnit::Radians)
    } else {
        None
    }
}

/// What four numbers are in the order that the text tells, or else in both.
fn orders(
    parsed: &ParsedQuaternion,
    convention: Convention,
    span: Span,
) -> Result<Vec<(ComponentOrder, Rotation)>, Fault> {
    let q = parsed.quaternion;
    let typed = parsed.order.array([q.w, q.i, q.j, q.k]);
    let mut orders = Vec::new();
    for order in [parsed.order, parsed.order.other()] {
        let in_order = Convention {
            order,
            ..convention
        };
        let tagged = TaggedQuaternion::from_array(typed, in_order);
        let rotation = Rotation::from_tagged(&tagged).map_err(|_| Fault::zero_quaternion(span))?;
        orders.push((order, rotation));
        if parsed.order_source != OrderSource::Declared {
            break;
        }
    }
    Ok(orders)
}

/// Of a rotation times a number the norm is √3 times that.
fn seen_matrix(entries: &Matrix3<f64>, span: Span) -> Result<SeenMatrix, Fault> {
    let size = Norm::of(entries.as_slice()).value() / SQRT_3;
    let scale = if entries.determinant() < 0.0 {
        -size
    } else {
        size
    };
    let divided = if scale.is_normal() {
        entries / scale
    } else {
        *entries
    };
    let (_, turn) = of_matrix(divided, MatrixConvention::BODY_TO_WORLD, span)?;
    Ok(SeenMatrix { scale, turn })
}
