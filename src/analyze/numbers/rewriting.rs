//! A rewriting of any quaternion by names, such as `(-q2, q1, -q4, q3)`.

use crate::analyze::numbers::candidate::Candidate;
use crate::analyze::numbers::renamed::of_quaternion;
use crate::convention::Convention;
use crate::convention::order::ComponentOrder;
use crate::problem::is_too_long;
use crate::rotation::Rotation;
use crate::rotation::quaternion::TaggedQuaternion;

/// What a rewriting is tried on, as an array of any order: no two of the numbers have the same size.
const ANY: [f64; 4] = [-0.31, 0.52, 0.19, 0.77];

/// A number of an array: its place, and 1 or −1.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    place: usize,
    sign: f64,
}

/// The readings of four names; `None` where a text is no such names.
///
/// Letters are components. Digits are places in the array of the declared order, counted from 0 where there
/// is a 0, and from 1 otherwise.
pub(crate) fn of_names(text: &str, convention: Convention) -> Option<Vec<Candidate>> {
    let places = places(text, convention.order)?;
    let tagged = |array| TaggedQuaternion::from_array(array, convention);
    let any = Rotation::from_tagged(&tagged(ANY)).ok()?;
    let rewritten = places.map(|Place { place, sign }| sign * ANY[place]);
    let seen = [convention.order, convention.order.other()].map(|order| {
        let convention = Convention {
            order,
            ..convention
        };
        let tagged = TaggedQuaternion::from_array(rewritten, convention);
        Some((order, Rotation::from_tagged(&tagged).ok()?))
    });
    let seen: Vec<_> = seen.into_iter().flatten().collect();
    let mut candidates = of_quaternion(&seen, &any, convention);
    for candidate in &mut candidates {
        // Not of the numbers on which it was tried.
        candidate.reading.text = None;
    }
    Some(candidates)
}

fn places(text: &str, order: ComponentOrder) -> Option<[Place; 4]> {
    if is_too_long(text) {
        return None;
    }
    let inside = text.rsplit(['=', '(']).next()?.to_lowercase();
    let spaced = inside.replace('\u{2212}', "-").replace("- ", "-");
    let names: Vec<&str> = if spaced.contains([',', ';']) {
        spaced.split([',', ';']).collect()
    } else {
        spaced.split_whitespace().collect()
    };
    let names: [Name; 4] = names
        .into_iter()
        .map(Name::of)
        .collect::<Option<Vec<_>>>()?
        .try_into()
        .ok()?;
    let digits = names.map(|name| name.letter.to_digit(10));
    let first = u32::from(!digits.contains(&Some(0)));
    let letters = order.array(['w', 'x', 'y', 'z']);
    let place = |name: Name| match name.letter.to_digit(10) {
        Some(digit) => usize::try_from(digit.checked_sub(first)?).ok(),
        None => letters.iter().position(|letter| *letter == name.letter),
    };
    let mut places = [Place {
        place: 0,
        sign: 1.0,
    }; 4];
    let mut is_named = [false; 4];
    for (found, name) in places.iter_mut().zip(names) {
        found.place = place(name)?;
        found.sign = name.sign;
        let is_new = is_named.get_mut(found.place)?;
        if std::mem::replace(is_new, true) {
            return None;
        }
    }
    Some(places)
}

/// The name of a component with its sign: `-q2`, `q[1]`, `q.x`, `z`.
#[derive(Clone, Copy, Debug)]
struct Name {
    sign: f64,
    /// The letter of a component, or a digit.
    letter: char,
}

impl Name {
    fn of(text: &str) -> Option<Self> {
        let letters: String = text.chars().filter(char::is_ascii_alphanumeric).collect();
        let letter = letters.chars().last()?;
        let before = letters.strip_suffix(letter)?;
        let is_name = match letter {
            'w' | 'x' | 'y' | 'z' => matches!(before, "" | "q" | "quat"),
            '0'..='4' => matches!(before, "q" | "quat"),
            _ => false,
        };
        let is_negative = text.contains('-');
        is_name.then_some(Self {
            sign: if is_negative { -1.0 } else { 1.0 },
            letter,
        })
    }
}
