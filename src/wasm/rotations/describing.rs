//! Attitudes from their descriptions.

use crate::convention::matrix::MatrixConvention;
use crate::rotation::Rotation;
use crate::rotation::nearest::NoNearestRotation;
use crate::rotation::quaternion::TaggedQuaternion;
use crate::rotation::rotation_vector::AxisVector;
use crate::rotation::tagged_matrix::TaggedMatrix;
use crate::wasm::registers::{leave_found, leave_from, leave_rotation, numbers, rotation};
use crate::wasm::{CallOutcome, convention, direction, in_radians, sequence, unit};
use wasm_bindgen::prelude::*;

/// Of four numbers in the order of their convention.
#[wasm_bindgen(js_name = fromQuaternion)]
pub fn from_quaternion(convention_code: u8) -> CallOutcome {
    let tagged = TaggedQuaternion::from_array(numbers(0), convention(convention_code));
    leave_found(Rotation::from_tagged(&tagged))
}

/// The nearest to nine numbers, row by row, of the matrix with this direction. Behind the attitude stand how
/// far it is (the Frobenius norm of the difference), and 1 where the numbers are a rotation but for rounding.
#[wasm_bindgen(js_name = fromMatrix)]
pub fn from_matrix(direction_place: u8) -> CallOutcome {
    let [a, b, c, d, e, f, g, h, i] = numbers(0);
    let passive = MatrixConvention {
        direction: direction(direction_place),
        ..MatrixConvention::BODY_TO_WORLD
    };
    let matrix = TaggedMatrix::from_rows([[a, b, c], [d, e, f], [g, h, i]], passive);
    match Rotation::nearest_to_matrix(&matrix) {
        Ok(nearest) => {
            let is_rotation = f64::from(u8::from(matrix.is_rotation()));
            leave_from(8, &[nearest.correction, is_rotation]);
            leave_rotation(&nearest.rotation)
        }
        Err(NoNearestRotation::Reflection) => CallOutcome::Reflection,
        Err(NoNearestRotation::NotFinite) => CallOutcome::NoRotation,
        Err(NoNearestRotation::Singular) => CallOutcome::Singular,
    }
}

/// Of three angles in the order of their sequence.
#[wasm_bindgen(js_name = fromEuler)]
pub fn from_euler(axes: u8, frame: u8, unit_place: u8) -> CallOutcome {
    let unit = unit(unit_place);
    let angles_rad = numbers(0).map(|angle| in_radians(angle, unit));
    leave_found(Rotation::from_euler_in(
        unit,
        sequence(axes, frame),
        angles_rad,
    ))
}

/// Of an axis of any length, and an angle.
#[wasm_bindgen(js_name = fromAxisAngle)]
pub fn from_axis_angle(angle: f64, unit_place: u8) -> CallOutcome {
    let unit = unit(unit_place);
    let angle_rad = in_radians(angle, unit);
    leave_found(Rotation::from_axis_angle_in(unit, numbers(0), angle_rad))
}

/// Of a rotation vector.
#[wasm_bindgen(js_name = fromRotationVector)]
pub fn from_rotation_vector(unit_place: u8) -> CallOutcome {
    let unit = unit(unit_place);
    let vector_rad = numbers(0).map(|number| in_radians(number, unit));
    leave_found(Rotation::from_rotation_vector_rad(vector_rad))
}

/// Of modified Rodrigues parameters.
#[wasm_bindgen(js_name = fromModifiedRodrigues)]
pub fn from_modified_rodrigues() -> CallOutcome {
    leave_found(AxisVector::ModifiedRodrigues(numbers(0).into()).to_rotation())
}

/// Of a Gibbs vector.
#[wasm_bindgen(js_name = fromGibbs)]
pub fn from_gibbs() -> CallOutcome {
    leave_found(AxisVector::Gibbs(numbers(0).into()).to_rotation())
}

/// Of what another copy of the package computes with.
#[wasm_bindgen(js_name = fromCanonical)]
pub fn from_canonical() -> CallOutcome {
    leave_rotation(&rotation(0))
}

/// The shortest turn that brings the first vector, of the body, along the second, of the world.
#[wasm_bindgen(js_name = fromTwoVectors)]
pub fn from_two_vectors() -> CallOutcome {
    leave_found(Rotation::from_two_vectors(numbers(0), numbers(3)))
}

/// The attitude that a seed gives: a whole number up to 2^53.
#[wasm_bindgen]
pub fn random(seed: f64) -> CallOutcome {
    // What is no such number is another seed.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "it saturates"
    )]
    leave_rotation(&Rotation::random(seed as u64))
}
