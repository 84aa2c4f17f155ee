//! An attitude as a turn about an axis, and the rest.

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::describe::turn;
use crate::analyze::plain_numbers::{coordinates, plain};
use crate::analyze::vector::TypedVector;
use crate::contract::request::SwingTwistRequest;
use crate::contract::{Components, SwingTwistReport};
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem, Span};
use crate::rotation::Rotation;
use crate::rotation::precise;
use nalgebra::Vector3;

pub(crate) fn swing_twist(request: &SwingTwistRequest) -> Result<SwingTwistReport, Vec<Problem>> {
    let declared = Declared::plain(request.convention, request.matrix);
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, declared);
    let (attitude, axis) = match (attitude, axis(&request.axis)) {
        (Ok(attitude), Ok(axis)) => (attitude, axis),
        (attitude, axis) => {
            let mut problems = Vec::new();
            problems.extend(attitude.err());
            problems.extend(axis.err());
            return Err(problems);
        }
    };
    let TypedVector { vector, note } = axis;
    let found = precise::direction(&vector)
        .and_then(|axis| Some((axis, attitude.rotation.swing_twist(axis.into()).ok()?)));
    let Some((axis, found)) = found else {
        let span = Span::of_trimmed(&request.axis);
        return Err(vec![Fault::zero_axis(span).in_field(Field::Axis)]);
    };
    let convention = attitude.tagged.convention;
    let shown = |rotation: &Rotation| {
        Components::of(&rotation.to_tagged(convention).components, convention.order)
    };
    let mut notes = attitude.notes(Field::Quaternion);
    notes.extend(note);
    Ok(SwingTwistReport {
        axis: coordinates(&axis),
        twist_rad: found.twist_rad.map(plain),
        twist_deg: found.twist_rad.map(|angle| plain(angle.to_degrees())),
        twist: shown(&found.twist),
        swing: turn(&found.swing),
        swing_quaternion: shown(&found.swing),
        body_swing: turn(&found.body_swing),
        body_swing_quaternion: shown(&found.body_swing),
        notes,
        quaternion: attitude.as_read(),
    })
}

/// The axis that a text holds: three numbers, or the name of an axis.
fn axis(text: &str) -> Result<TypedVector, Problem> {
    let name = text.trim();
    let (sign, name) = match name.strip_prefix('-') {
        Some(name) => (-1.0, name),
        None => (1.0, name),
    };
    let [letter @ b'x'..=b'z'] = name.as_bytes() else {
        return TypedVector::of_text(text, Field::Axis);
    };
    let mut named = Vector3::zeros();
    named[usize::from(letter - b'x')] = sign;
    Ok(TypedVector {
        vector: named,
        note: None,
    })
}
