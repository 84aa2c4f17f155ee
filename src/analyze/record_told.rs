//! What is told of a block besides its rotation: other descriptions of it, and what stands beside it.

use crate::analyze::attitude::Attitude;
use crate::analyze::numbers::nearest_off_rad;
use crate::analyze::plain_numbers::{coordinates, plain as plain_number, plain3};
use crate::contract::{Beside, BesideQuantity, Fact, Form, FoundInText, OtherDescription};
use crate::convention::Direction;
use crate::problem::Span;
use crate::text::{Record, RecordRotation, What};
use nalgebra::Vector3;

/// Two descriptions of one rotation are no farther apart, in degrees: angles are often printed with no
/// more than whole degrees, and matrices with two decimals.
pub(crate) const SAME_WITHIN_DEG: f64 = 0.75;

/// What is told of the other descriptions, each with how far it is from the one that is read.
pub(crate) fn descriptions(text: &str, others: &[(&RecordRotation, f64)]) -> Vec<Fact> {
    let mut told = Vec::new();
    for (other, differs_by_deg) in others {
        told.push(description(text, &other.label, other.span, *differs_by_deg));
    }
    told
}

/// What is told of angles without a sequence: whether they are those of the attitude in any of them.
pub(crate) fn loose_angles(text: &str, record: &Record, attitude: &Attitude) -> Vec<Fact> {
    let mut told = Vec::new();
    for angles in &record.angles {
        let off_rad = nearest_off_rad(angles.numbers, angles.unit, &attitude.rotation);
        told.push(description(
            text,
            &angles.label,
            angles.span,
            off_rad.to_degrees(),
        ));
    }
    told
}

/// That the text holds the rotation a second time, or another one.
fn description(text: &str, label: &str, span: Span, differs_by_deg: f64) -> Fact {
    let description = OtherDescription {
        label: named(label),
        text: piece(text, span),
        differs_by_deg: plain_number(differs_by_deg),
    };
    if differs_by_deg > SAME_WITHIN_DEG {
        Fact::DescriptionsDisagree(description)
    } else {
        Fact::SecondDescription(description)
    }
}

/// What stands around the rotation; `None` where the numbers are all that there is.
pub(crate) fn found_in_text(
    record: &Record,
    found: &RecordRotation,
    attitude: &Attitude,
    text: &str,
) -> Option<Fact> {
    let mut all = Vec::new();
    for beside in &record.beside {
        let numbers = plain3(beside.numbers);
        let (quantity, body_in_world) = match beside.what {
            What::Scale => (BesideQuantity::Scale, None),
            What::Position if beside.is_in_world => (BesideQuantity::Position, Some(numbers)),
            What::Position => {
                let in_world = body_in_world(beside.numbers, attitude);
                (BesideQuantity::Position, Some(in_world))
            }
        };
        all.push(Beside {
            quantity,
            label: named(&beside.label),
            numbers,
            body_in_world,
        });
    }
    let format = found.format.map(|format| format.name.to_owned());
    let is_told = !all.is_empty() || format.is_some();
    is_told.then(|| {
        Fact::FoundInText(FoundInText {
            format,
            label: named(&found.label),
            text: piece(text, found.span),
            beside: all,
        })
    })
}

/// Where the body's origin stands in the world, of a translation beside numbers that lead from one to the
/// other: x = R X + t of world to body puts it at −Rᵀt.
fn body_in_world(translation: [f64; 3], attitude: &Attitude) -> [f64; 3] {
    let direction = match attitude.form {
        Form::Quaternion => attitude.tagged.convention.direction,
        Form::Matrix(read) => read.convention.direction,
        _ => Direction::BodyToWorld,
    };
    match direction {
        Direction::BodyToWorld => plain3(translation),
        Direction::WorldToBody => {
            let body_to_world = attitude.rotation.matrix(Direction::BodyToWorld);
            let origin = -(body_to_world * Vector3::from(translation));
            coordinates(&origin)
        }
    }
}

fn named(label: &str) -> Option<String> {
    (!label.is_empty()).then(|| closed(label))
}

/// A piece of a text with the unit behind it.
fn piece(text: &str, span: Span) -> String {
    let behind = &text[span.end..];
    let word = behind
        .find(|mark: char| !(mark.is_alphabetic() || mark == '°'))
        .unwrap_or(behind.len());
    closed(&text[span.start..span.end + word])
}

/// A piece of a text with the brackets that it leaves open.
fn closed(piece: &str) -> String {
    let mut text = piece.to_owned();
    let mut open = Vec::new();
    for mark in piece.chars() {
        match mark {
            '(' => open.push(')'),
            '[' => open.push(']'),
            '{' => open.push('}'),
            _ if open.last() == Some(&mark) => drop(open.pop()),
            _ => {}
        }
    }
    text.extend(open.iter().rev());
    text
}
