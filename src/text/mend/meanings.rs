//! What four numbers may be meant as where their norm is not that of a rotation, or where they are one of
//! two things, each as a text that says so.

use crate::character::is_alphabetic;
use crate::convention::angle::{AngleUnit, UnitSource};
use crate::convention::order::OrderSource;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::problem::suggestion::{Remedy, Suggestion};
use crate::text::description::ParsedRotation;
use crate::text::description::angle::FULL_TURN_RAD;
use crate::text::description::quaternion::ParsedQuaternion;
use crate::text::mend::number_text::{exact, exact_list};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// How far from 1 an axis of length 1 is with two decimals, at most.
const ROUNDING_OF_TWO_DECIMALS: f64 = 0.01;

/// What two decimals make of an angle, at most half of it: 1.57 is a quarter turn.
const NEARLY_SAME_ANGLE_RAD: f64 = 0.002;

/// The step of angles that are familiar, 15°.
const FAMILIAR_STEP_DEG: f64 = 15.0;

/// A coordinate of this size is no metre and no millimetre, but a time.
const LARGEST_COORDINATE: f64 = 1e6;

/// The texts that say what the numbers are, the likeliest first; `read` tells how a text is read. Only
/// what is likely is offered beside the quaternion that was read.
pub(crate) fn of_norm(
    text: &str,
    parsed: &ParsedQuaternion,
    read: &dyn Fn(&str) -> Option<ParsedRotation>,
) -> Vec<Suggestion> {
    let mut found = Vec::from_iter(as_quaternion(text, parsed, read));
    for Candidate { suggestion, unit } in others(parsed) {
        let is_in_unit = |read: ParsedRotation| read.unit() == Some(UnitSource::Written(unit));
        if read(&suggestion.text).is_some_and(is_in_unit) {
            found.push(suggestion);
        }
    }
    found
}

/// The text that says that it is the quaternion as which it was read.
fn as_quaternion(
    text: &str,
    parsed: &ParsedQuaternion,
    read: &dyn Fn(&str) -> Option<ParsedRotation>,
) -> Option<Suggestion> {
    let text = text.trim();
    let announced = ParsedQuaternion {
        is_announced: true,
        ..parsed.clone()
    };
    let numbers = exact_list(&in_order(parsed));
    let announced = Some(ParsedRotation::Quaternion(announced));
    let [one, two, three] = saying_quaternion(text);
    for text in [one, two, three, format!("quaternion {numbers}")] {
        if read(&text) == announced {
            return Some(Suggestion::new(Remedy::AsQuaternion, text));
        }
    }
    None
}

/// The ways to say so before a text; before a bracket the word alone would be a call.
fn saying_quaternion(text: &str) -> [String; 3] {
    let saying = |word: &str| [word, text].concat();
    [
        saying("quaternion "),
        saying("quaternion: "),
        saying("q = "),
    ]
}

/// The texts that say which of two things the numbers are, where `marked` may be a sequence of Euler
/// angles, or holds an axis and an angle; `read` tells whether a text is read.
pub(crate) fn of_two(
    text: &str,
    marked: Span,
    read: &dyn Fn(&str) -> Result<(), Fault>,
) -> Vec<Suggestion> {
    let text = text.trim_end();
    let (Some(before), Some(place), Some(after)) = (
        text.get(..marked.start),
        text.get(marked.start..marked.end),
        text.get(marked.end..),
    ) else {
        return Vec::new();
    };
    let is_sequence = place.chars().count() == 3;
    let other = if is_sequence {
        let mut sequence = String::new();
        for digit in place.chars() {
            sequence.push_str(if sequence.is_empty() { "" } else { "-" });
            sequence.push(digit);
        }
        Suggestion::new(Remedy::AsEulerAngles, format!("{before}{sequence}{after}"))
    } else {
        Suggestion::new(Remedy::AsAxisAngle, format!("axis-angle {text}"))
    };
    let mut found = Vec::new();
    if read(&other.text).is_ok() {
        found.push(other);
    }
    for text in saying_quaternion(text) {
        if read(&text).is_ok() {
            found.push(Suggestion::new(Remedy::AsQuaternion, text));
            break;
        }
    }
    found
}

/// The sequences that most angles are in which come without one.
const USUAL_SEQUENCES: [&str; 4] = ["ZYX", "xyz", "XYZ", "ZXZ"];

/// What angles are called without a word of their sequence.
const NAMES_OF_ANGLES: [&str; 5] = ["euler", "eul", "angles", "angle", ""];

/// The texts that say in which of the usual sequences three angles are, whose sequence is missing at `place`;
/// `read` tells whether a text is read.
pub(crate) fn with_sequences(
    text: &str,
    place: Span,
    read: &dyn Fn(&str) -> Result<(), Fault>,
) -> Vec<Suggestion> {
    let mut found = Vec::new();
    let (Some(before), Some(after)) = (text.get(..place.start), text.get(place.end..)) else {
        return found;
    };
    let after = after.trim_start_matches([':', '=', ' ', '\t']);
    // `Euler angles (deg): 10 20 30`
    let mut unit = "";
    for word in text[place.start..place.end].split(|mark: char| !is_alphabetic(mark)) {
        match AngleUnit::named(word) {
            Some(AngleUnit::Degrees) => unit = " deg",
            Some(AngleUnit::Radians) => unit = " rad",
            None if NAMES_OF_ANGLES.contains(&&word.to_ascii_lowercase()[..]) => {}
            // A word that says something of the sequence contradicts one of these.
            None => return found,
        }
    }
    for sequence in USUAL_SEQUENCES {
        let with_sequence = [before, sequence, " ", after.trim_end(), unit].concat();
        if read(&with_sequence).is_ok() {
            found.push(Suggestion {
                label: Some(sequence.to_owned()),
                ..Suggestion::new(Remedy::WithSequence, with_sequence)
            });
        }
    }
    found
}

/// A text to try, and the unit that it has to be read in.
struct Candidate {
    suggestion: Suggestion,
    unit: AngleUnit,
}

fn others(parsed: &ParsedQuaternion) -> Vec<Candidate> {
    let [first, second, third, fourth] = in_order(parsed);
    let mut found = Vec::new();
    let mut add = |remedy, angle: f64, text: &dyn Fn(String) -> String| {
        let (unit, word) = unit_of(angle);
        let text = text(format!("{}{word}", exact(angle)));
        let suggestion = Suggestion::new(remedy, text);
        found.push(Candidate { suggestion, unit });
    };
    let list = |axis: [f64; 3]| format!("[{}]", exact_list(&axis));
    let front = [first, second, third];
    let back = [second, third, fourth];
    if are_axis_and_angle(front, fourth) {
        add(Remedy::AsAxisAngle, fourth, &|angle| {
            format!("axis-angle {} {angle}", list(front))
        });
    }
    // By names the scalar stands last here, and it alone can be the angle; where it is one by name, it
    // is none about the vertical.
    if parsed.order_source == OrderSource::Named {
        return found;
    }
    if are_axis_and_angle(back, first) {
        add(Remedy::AsAxisAngle, first, &|angle| {
            format!("{angle} about {}", list(back))
        });
    }
    if are_position_and_yaw(front, fourth) {
        add(Remedy::AsYaw, fourth, &|angle| format!("{angle} about z"));
    }
    found
}

/// The numbers as they stand in the text; by names x, y, z, w, as most write them.
fn in_order(parsed: &ParsedQuaternion) -> [f64; 4] {
    let nalgebra::Quaternion { coords } = parsed.quaternion;
    match parsed.order_source {
        OrderSource::Named => coords.into(),
        _ => parsed.order.array([coords.w, coords.x, coords.y, coords.z]),
    }
}

/// An axis of length 1 and any angle; or one such as `1 1 0`, and an angle that is familiar.
fn are_axis_and_angle(axis: [f64; 3], angle: f64) -> bool {
    let length = Vector3::from(axis).norm();
    let is_unit = (length - 1.0).abs() <= ROUNDING_OF_TWO_DECIMALS;
    let is_diagonal = axis.iter().all(|number| [-1.0, 0.0, 1.0].contains(number));
    let is_angle = angle != 0.0 && angle.abs() <= 360.0;
    is_angle && (is_unit || (is_diagonal && is_familiar(angle)))
}

/// Coordinates that are no axis, and an angle that is up to half a turn.
fn are_position_and_yaw(position: [f64; 3], yaw: f64) -> bool {
    let position = Vector3::from(position);
    let is_axis = (position.norm() - 1.0).abs() <= ROUNDING_OF_TWO_DECIMALS;
    let is_yaw = yaw.fract() != 0.0 && yaw.abs() <= PI + NEARLY_SAME_ANGLE_RAD;
    let is_half_turn_at_most = yaw.abs() <= 180.0;
    let is_place = position.amax() < LARGEST_COORDINATE && !is_axis;
    is_place && (is_yaw || (is_familiar(yaw) && is_half_turn_at_most))
}

/// A multiple of 15°, in the unit in which an angle of this size is read.
fn is_familiar(angle: f64) -> bool {
    let (degrees, tolerance) = match unit_of(angle).0 {
        AngleUnit::Degrees => (angle, 0.0),
        AngleUnit::Radians => (angle.to_degrees(), NEARLY_SAME_ANGLE_RAD.to_degrees()),
    };
    let steps = (degrees / FAMILIAR_STEP_DEG).round();
    steps != 0.0 && (degrees - steps * FAMILIAR_STEP_DEG).abs() <= tolerance
}

/// Radians up to a full turn, as where an angle has no unit.
fn unit_of(angle: f64) -> (AngleUnit, &'static str) {
    if angle.abs() <= FULL_TURN_RAD {
        (AngleUnit::Radians, "rad")
    } else {
        (AngleUnit::Degrees, "deg")
    }
}
