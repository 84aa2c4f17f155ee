//! Nine numbers to an attitude, or why not: how far from a rotation they are, and which axis a
//! reflection flips.

use crate::analyze::plain_numbers::rows3;
use crate::contract::ReadMatrix;
use crate::convention::matrix::MatrixConvention;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::problem::sentences::matrix::Mirror;
use crate::problem::suggestion::{Remedy, Suggestion};
use crate::rotation::Rotation;
use crate::rotation::nearest::NoNearestRotation;
use crate::rotation::precise::{times_power_of_two, working_scale};
use crate::rotation::tagged_matrix::TaggedMatrix;
use crate::text::mend::number_text::rows_text;
use nalgebra::{Matrix3, Vector3};

/// A matrix this far from the nearest rotation (Frobenius norm) is not one with rounded entries: two
/// decimals are off by 0.015 at most.
const LARGEST_CORRECTION: f64 = 0.1;

/// Columns of any length that are this near to those of a rotation, each divided by its own, were scaled; the
/// lengths of noisy ones differ too.
const LARGEST_CORRECTION_OF_COLUMNS: f64 = 0.02;

/// Farther away than this the nearest rotation has little to do with the matrix: two rotations are as
/// far apart that differ by 41°.
const LARGEST_CORRECTION_OFFERED: f64 = 1.0;

/// The cosine of 2.6°: an axis that a mirror carries so near to its opposite is the one it flips,
/// whatever two decimals have made of the matrix.
const FLIPPED_COSINE: f64 = 0.999;

pub(crate) fn of_matrix(
    entries: Matrix3<f64>,
    convention: MatrixConvention,
    span: Span,
) -> Result<(ReadMatrix, Rotation), Fault> {
    let tagged = |entries| TaggedMatrix {
        entries,
        convention,
    };
    let typed = tagged(entries);
    let is_within = |entries, correction| {
        Rotation::nearest_to_matrix(&tagged(entries))
            .is_ok_and(|nearest| nearest.correction <= correction)
    };
    let is_near = |entries| is_within(entries, LARGEST_CORRECTION);
    // Divided by a power of two, so that no length overflows or vanishes.
    let exponent = working_scale(entries.as_slice());
    let scaled = entries.map(|entry| times_power_of_two(entry, exponent));
    let mut scaled_lengths = [0.0; 3];
    let mut lengths = [0.0; 3];
    for column in 0..3 {
        scaled_lengths[column] = scaled.column(column).norm();
        lengths[column] = times_power_of_two(scaled_lengths[column], -exponent);
    }
    let scaled_by = scaled_lengths.iter().sum::<f64>() / 3.0;
    let unscaled = scaled / scaled_by;
    let scale = times_power_of_two(scaled_by, -exponent);
    let nearest = Rotation::nearest_to_matrix(&typed).map_err(|reason| match reason {
        NoNearestRotation::Reflection if is_near(-entries) => reflection(entries, 1.0, span),
        NoNearestRotation::Reflection if is_near(-unscaled) => reflection(unscaled, scale, span),
        NoNearestRotation::Reflection => Fault::not_a_rotation(span, lengths, None),
        NoNearestRotation::NotFinite => Fault::too_large(span),
        NoNearestRotation::Singular if entries.amax() == 0.0 => Fault::zero_matrix(span)
            .suggesting(|_| Some(suggested(Remedy::WriteIdentity, &Matrix3::identity()))),
        NoNearestRotation::Singular => Fault::singular_matrix(span),
    })?;
    if nearest.correction > LARGEST_CORRECTION {
        let columns = Matrix3::from_fn(|row, at| scaled[(row, at)] / scaled_lengths[at]);
        let is_scaled = is_near(unscaled);
        let are_columns_scaled = is_within(columns, LARGEST_CORRECTION_OF_COLUMNS);
        let rotation = nearest.rotation.to_tagged_matrix(convention).entries;
        let is_near_enough = nearest.correction <= LARGEST_CORRECTION_OFFERED;
        let is_offered = is_scaled || are_columns_scaled || is_near_enough;
        let fault = if is_scaled {
            Fault::scaled_rotation(span, scale)
        } else if are_columns_scaled {
            Fault::scaled_columns(span, lengths)
        } else {
            Fault::not_a_rotation(span, lengths, Some(nearest.correction))
        };
        return Err(
            fault.suggesting(|_| is_offered.then(|| suggested(Remedy::NearestRotation, &rotation)))
        );
    }
    let read = ReadMatrix {
        rows: rows3(&entries),
        convention,
        orthogonality_error: typed.orthogonality_error(),
        correction: nearest.correction,
    };
    // A matrix tells no sign of q: the scalar is chosen not negative (specification FX-04).
    Ok((read, nearest.rotation.with_scalar_not_negative()))
}

fn suggested(remedy: Remedy, matrix: &Matrix3<f64>) -> Suggestion {
    Suggestion::new(remedy, rows_text(&rows3(matrix)))
}

/// A mirror image and the flip that undoes it with the smallest turn left over.
///
/// Turning round any one axis, or all three, makes a rotation of a mirror image; only where one
/// stands against itself does the matrix alone tell which of them it was. Rows and columns leave the
/// same angle, which the trace tells.
fn reflection(entries: Matrix3<f64>, scale: f64, span: Span) -> Fault {
    let trace = entries.trace();
    let mut axis = None;
    let mut most = -trace;
    for flipped in 0..3 {
        let left = trace - 2.0 * entries[(flipped, flipped)];
        if left > most {
            most = left;
            axis = Some(flipped);
        }
    }
    let signs = |axis| Vector3::from_fn(|at, _| if at == axis { -1.0 } else { 1.0 });
    let (mirror, restored) = match axis {
        None => (Mirror::All, -entries),
        Some(axis) => {
            let restored = entries * Matrix3::from_diagonal(&signs(axis));
            let is_certain = entries[(axis, axis)] <= -FLIPPED_COSINE;
            let mirror = if is_certain {
                Mirror::Axis(axis)
            } else {
                Mirror::Nearest(axis)
            };
            (mirror, restored)
        }
    };
    Fault::reflection(span, mirror, scale)
        .suggesting(|_| Some(suggested(Remedy::RestoreAxis, &restored)))
}
