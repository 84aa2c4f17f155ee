//! What a rotation that was found in a block of text is likely to be.

use crate::analyze::attitude::Declared;
use crate::convention::order::OrderSource;
use crate::text::{ParsedRotation, RecordRotation, other_than_rotation, says_nothing};
use nalgebra::Matrix3;

/// No turn, which stands for what was never set.
pub(crate) fn is_identity(found: &RecordRotation) -> bool {
    match &found.rotation {
        ParsedRotation::Quaternion(parsed) => parsed.quaternion.imag().amax() == 0.0,
        ParsedRotation::Matrix(matrix) => *matrix == Matrix3::identity(),
        _ => false,
    }
}

/// Whether a format says what the rotation is that is declared, or is known by its words.
pub(crate) fn is_of_format(found: &RecordRotation, declared: Declared) -> bool {
    found.format.is_some_and(|format| {
        let is_declared = declared
            .library
            .is_some_and(|library| library.id == format.id);
        is_declared || format.has_marks()
    })
}

/// Whether the label of numbers that may be anything names something else.
pub(crate) fn is_another_quantity(found: &RecordRotation) -> bool {
    may_be_anything(found) && other_than_rotation(&found.label).is_some()
}

/// Whether only the count of the numbers, or that they are upright, makes a rotation of them: the label
/// says nothing, and no format is marked.
pub(crate) fn is_assumed(found: &RecordRotation) -> bool {
    may_be_anything(found) && !found.label.is_empty() && says_nothing(&found.label)
}

/// Whether neither a format nor the numbers themselves say that they are a rotation.
fn may_be_anything(found: &RecordRotation) -> bool {
    let is_any = match &found.rotation {
        ParsedRotation::Quaternion(parsed) => parsed.order_source == OrderSource::Declared,
        // A matrix of real numbers that is one is no accident; a permutation may be anything.
        ParsedRotation::Matrix(matrix) => matrix.iter().all(|entry| entry.fract() == 0.0),
        _ => false,
    };
    is_any && found.format.is_none()
}
