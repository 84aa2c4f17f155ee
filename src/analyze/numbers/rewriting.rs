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

/// The numbers of [`ANY`] in the order and with the signs of the names: `-q2`, `q[1]`, `q.x`, `z`.
fn rewritten(text: &str, order: ComponentOrder) -> Option<[f64; 4]> {
    if is_too_long(text) {
        return None;
    }
    let inside = text.rsplit(['=', '(']).next()?;
    let first = if inside.contains('0') { b'0' } else { b'1' };
    let mut rewritten = [0.0; 4];
    let mut left = ANY;
    let mut count = 0;
    let mut name = Vec::new();
    let mut sign = 1.0;
    // With a mark at the end of the last name too.
    for character in inside.chars().chain([',']) {
        match character {
            '-' | '\u{2212}' if name.is_empty() => sign = -sign,
            '[' | ']' | '{' | '}' | ')' | '.' | '_' => {}
            ',' | ';' | ' ' | '\t' | '\n' => {
                if name.is_empty() {
                    continue;
                }
                let size = std::mem::take(left.get_mut(place(&name, first, order)?)?);
                // A name that stands twice has left nothing.
                if size == 0.0 {
                    return None;
                }
                *rewritten.get_mut(count)? = sign * size;
                count += 1;
                name.clear();
                sign = 1.0;
            }
            _ => name.push(u8::try_from(character).ok()?.to_ascii_lowercase()),
        }
    }
    (count == 4).then_some(rewritten)
}

/// The place of a component in an array of this order, by the letters and digits of its name.
fn place(name: &[u8], first: u8, order: ComponentOrder) -> Option<usize> {
    let (&last, before) = name.split_last()?;
    let is_number = last.is_ascii_digit();
    if !matches!(before, b"q" | b"quat") && (is_number || !before.is_empty()) {
        return None;
    }
    if is_number {
        return last.checked_sub(first).map(usize::from);
    }
    let letters = order.array([b'w', b'x', b'y', b'z']);
    letters.iter().position(|letter| *letter == last)
}
