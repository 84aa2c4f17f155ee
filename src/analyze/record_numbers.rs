//! What records without a quaternion write for an attitude: Euler angles, a rotation vector, axis and
//! angle, a matrix.

use crate::analyze::plain_numbers::{plain, rows3};
use crate::contract::EndNumbers;
use crate::convention::Direction;
use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::EulerSequence;
use crate::decimal::{literal, nearest_double};
use crate::library::endpoint::Meaning;
use crate::library::{RecordNumbers, RecordNumbersKind};
use crate::problem::{Problem, Span};
use crate::rotation::Rotation;
use crate::text::is_decimal;
use nalgebra::Vector3;

/// The same numbers in words that are read everywhere; `None` where a text is anything else than the
/// numbers of this record, bare or after their names.
///
/// What numbers at an end mean is known by the end alone: `30 -20 100` are A, B and C of a KUKA, and W, P
/// and R of a FANUC.
pub(crate) fn in_words(text: &str, meaning: &Meaning) -> Option<String> {
    let numbers = meaning.library?.numbers?;
    let values = values_of(text, numbers)?;
    // Words are about the turn of the body in the world.
    let is_inverse = meaning.direction == Direction::WorldToBody;
    let inverted = |angle: f64| if is_inverse { -angle } else { angle };
    let mut words = String::new();
    let angles = match numbers.kind {
        RecordNumbersKind::EulerAngles => {
            let mut turns = Turn::all(numbers.means?)?;
            if is_inverse {
                turns.reverse();
            }
            words.extend(turns.iter().map(|turn| turn.axis));
            turns.map(|turn| turn.sign * values[turn.place]).to_vec()
        }
        RecordNumbersKind::RotationVector => {
            words.push_str("rotvec");
            values
        }
        RecordNumbersKind::AxisAngle => {
            words.push_str("axis-angle");
            let (angle, axis) = values.split_last()?;
            for number in axis {
                words.push(' ');
                words.push_str(&literal(*number));
            }
            vec![*angle]
        }
        RecordNumbersKind::Matrix => return None,
    };
    for angle in angles {
        words.push(' ');
        words.push_str(&literal(inverted(angle)));
        words.push_str(match numbers.unit? {
            AngleUnit::Degrees => "deg",
            AngleUnit::Radians => "rad",
        });
    }
    Some(words)
}

/// A problem of the words, said of all that was typed: no place in them is one of it.
pub(crate) fn about_all(problem: Problem, typed: &str) -> Problem {
    Problem {
        span: Span::of_trimmed(typed),
        suggestion: None,
        ..problem
    }
}

/// What an end writes for an attitude where that is no quaternion.
pub(crate) fn written(rotation: &Rotation, meaning: &Meaning) -> Option<EndNumbers> {
    let numbers = meaning.library?.numbers?;
    let taking = match meaning.direction {
        Direction::BodyToWorld => *rotation,
        Direction::WorldToBody => rotation.inverse(),
    };
    let in_unit = |angle_rad: f64| match numbers.unit {
        Some(AngleUnit::Degrees) => angle_rad.to_degrees(),
        _ => angle_rad,
    };
    let mut values = match numbers.kind {
        RecordNumbersKind::Matrix => {
            let form = meaning.matrix.map_or(meaning.action, |matrix| matrix.form);
            rows3(&rotation.matrix(meaning.direction_of(form))).concat()
        }
        RecordNumbersKind::RotationVector => {
            let vector = taking.rotation_vector_rad();
            vector.map(in_unit).as_slice().to_vec()
        }
        RecordNumbersKind::AxisAngle => {
            let axis = taking.axis().unwrap_or_else(Vector3::z);
            vec![axis.x, axis.y, axis.z, in_unit(taking.angle_rad())]
        }
        RecordNumbersKind::EulerAngles => {
            let turns = Turn::all(numbers.means?)?;
            let mut letters = String::new();
            for turn in &turns {
                letters.push(turn.axis);
            }
            let sequence: EulerSequence = letters.parse().ok()?;
            let mut values = vec![0.0; 3];
            let angles_rad = taking.euler(sequence).angles_rad;
            for (turn, angle_rad) in turns.iter().zip(angles_rad) {
                values[turn.place] = turn.sign * in_unit(angle_rad);
            }
            values
        }
    };
    for value in &mut values {
        *value = plain(*value);
    }
    Some(EndNumbers {
        kind: numbers.kind,
        names: numbers.names.map(str::to_owned),
        values,
        unit: numbers.unit,
    })
}

/// One factor of a product of turns, as `Rz(-b)`.
struct Turn {
    /// X, Y or Z, the letter of a sequence about moving axes.
    axis: char,
    sign: f64,
    /// Which of the numbers a, b, c it is.
    place: usize,
}

impl Turn {
    /// The three factors of a product.
    fn all(means: &str) -> Option<[Self; 3]> {
        let mut factors = means.split(' ');
        let all = [
            Self::of(factors.next()?)?,
            Self::of(factors.next()?)?,
            Self::of(factors.next()?)?,
        ];
        factors.next().is_none().then_some(all)
    }

    fn of(factor: &str) -> Option<Self> {
        let (axis, sign, letter) = match factor.as_bytes() {
            [b'R', axis, b'(', letter, b')'] => (axis, 1.0, letter),
            [b'R', axis, b'(', b'-', letter, b')'] => (axis, -1.0, letter),
            _ => return None,
        };
        Some(Self {
            axis: char::from(axis.to_ascii_uppercase()),
            sign,
            place: usize::from(letter.checked_sub(b'a').filter(|place| *place < 3)?),
        })
    }
}

/// The numbers of a text that holds those of a record and nothing else, each after its name or all
/// without.
fn values_of(text: &str, numbers: &RecordNumbers) -> Option<Vec<f64>> {
    let mut names = numbers.names.unwrap_or_default().split(' ');
    let mut values = Vec::new();
    let mut named = 0;
    for word in text.split(|c: char| c.is_whitespace() || ",;:=()[]{}".contains(c)) {
        if is_decimal(word) {
            values.push(nearest_double(word));
        } else if !word.is_empty() {
            if named != values.len() || !names.next()?.eq_ignore_ascii_case(word) {
                return None;
            }
            named += 1;
        }
    }
    let count = match numbers.kind {
        RecordNumbersKind::EulerAngles | RecordNumbersKind::RotationVector => 3,
        RecordNumbersKind::AxisAngle => 4,
        // Nine numbers are a matrix everywhere.
        RecordNumbersKind::Matrix => return None,
    };
    let is_all = values.len() == count && (named == 0 || named == count);
    (is_all && values.iter().all(|value: &f64| value.is_finite())).then_some(values)
}
