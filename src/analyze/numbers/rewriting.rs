//! A rewriting of any quaternion by names, such as `(-q2, q1, -q4, q3)`.

use crate::analyze::numbers::renamed::Renamed;
use crate::convention::Convention;
use crate::convention::order::ComponentOrder;
use crate::problem::is_too_long;
use crate::rotation::Rotation;
use crate::rotation::quaternion::TaggedQuaternion;

/// What a rewriting is tried on, as an array of any order: no two of the numbers have the same size.
const ANY: [f64; 4] = [-0.31, 0.52, 0.19, 0.77];

/// The readings of four names; `None` where a text is no such names.
///
/// Letters are components. Digits are places in the array of the declared order, counted from 0 where there
/// is a 0, and from 1 otherwise.
pub(crate) fn of_names(text: &str, convention: Convention) -> Option<Renamed> {
    let seen = rewritten(text, convention.order)?;
    let tagged = |array, order| {
        let convention = Convention {
            order,
            ..convention
        };
        Rotation::from_tagged(&TaggedQuaternion::from_array(array, convention)).ok()
    };
    let any = tagged(ANY, convention.order)?;
    let mut orders = Vec::new();
    for order in [convention.order, convention.order.other()] {
        orders.push((order, tagged(seen, order)?));
    }
    Some(Renamed::of_quaternion(orders, &any, convention))
}

/// The numbers of [`ANY`] in the order and with the signs of the names.
fn rewritten(text: &str, order: ComponentOrder) -> Option<[f64; 4]> {
    if is_too_long(text) {
        return None;
    }
    let inside = text.rsplit(['=', '(']).next()?;
    let plain = inside.replace('\u{2212}', "-").replace("- ", "-");
    let marks: &[char] = if plain.contains(',') {
        &[',']
    } else {
        &[' ', ';']
    };
    let mut names = Vec::new();
    for part in plain.split(marks) {
        if !part.trim().is_empty() {
            names.push(Name::of(part)?);
        }
    }
    let names: [Name; 4] = names.try_into().ok()?;
    let first = if names.iter().any(|name| name.letter == b'0') {
        b'0'
    } else {
        b'1'
    };
    let letters = order.array([b'w', b'x', b'y', b'z']);
    let mut rewritten = [0.0; 4];
    let mut left = ANY;
    for (number, name) in rewritten.iter_mut().zip(names) {
        let place = if name.letter.is_ascii_digit() {
            usize::from(name.letter.checked_sub(first)?)
        } else {
            letters.iter().position(|letter| *letter == name.letter)?
        };
        let size = std::mem::take(left.get_mut(place)?);
        if size == 0.0 {
            // It is named twice.
            return None;
        }
        *number = name.sign * size;
    }
    Some(rewritten)
}

/// The name of a component with its sign: `-q2`, `q[1]`, `q.x`, `z`.
#[derive(Clone, Copy)]
struct Name {
    sign: f64,
    /// The small letter of a component, or a digit.
    letter: u8,
}

impl Name {
    fn of(text: &str) -> Option<Self> {
        let mut letters = Vec::new();
        let mut sign = 1.0;
        for byte in text.bytes() {
            if byte == b'-' {
                sign = -1.0;
            } else if byte.is_ascii_alphanumeric() {
                letters.push(byte.to_ascii_lowercase());
            } else if !byte.is_ascii() {
                return None;
            }
        }
        let letter = letters.pop()?;
        let is_name = match letter {
            b'w'..=b'z' => matches!(&letters[..], b"" | b"q" | b"quat"),
            b'0'..=b'4' => matches!(&letters[..], b"q" | b"quat"),
            _ => false,
        };
        is_name.then_some(Self { sign, letter })
    }
}
