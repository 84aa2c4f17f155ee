//! Descriptions of the attitude in the first four registers.

use crate::rotation::euler::Survivor;
use crate::wasm::registers::{leave, leave_rows, rotation};
use crate::wasm::{CallOutcome, convention, direction, in_unit, sequence, unit};
use nalgebra::Vector3;
use wasm_bindgen::prelude::*;

/// The unit quaternion in a convention, in its order.
#[wasm_bindgen(js_name = asQuaternion)]
pub fn as_quaternion(convention_code: u8) -> CallOutcome {
    leave(
        &rotation(0)
            .to_tagged(convention(convention_code))
            .to_array(),
    )
}

/// The matrix with a direction, row by row.
#[wasm_bindgen(js_name = asMatrix)]
pub fn as_matrix(direction_place: u8) -> CallOutcome {
    leave_rows(&rotation(0).matrix(direction(direction_place)))
}

/// Three angles of a sequence; the distance from gimbal lock; 0 where it is not locked, and else 1 for the
/// sum and 2 for the difference that survives; and the angle that does.
#[wasm_bindgen(js_name = asEuler)]
pub fn as_euler(axes: u8, frame: u8, unit_place: u8) -> CallOutcome {
    let unit = unit(unit_place);
    let euler = rotation(0).euler(sequence(axes, frame));
    let [first, second, third] = euler.angles_rad.map(|angle| in_unit(angle, unit));
    let (lock, survivor_rad) = match euler.gimbal_lock {
        None => (0.0, 0.0),
        Some(lock) => match lock.survivor {
            Survivor::Sum => (1.0, lock.survivor_rad),
            Survivor::Difference => (2.0, lock.survivor_rad),
        },
    };
    leave(&[
        first,
        second,
        third,
        in_unit(euler.lock_distance_rad, unit),
        lock,
        in_unit(survivor_rad, unit),
    ])
}

/// The axis, which is zero where there is none, and the angle.
#[wasm_bindgen(js_name = asAxisAngle)]
pub fn as_axis_angle(unit_place: u8) -> CallOutcome {
    let rotation = rotation(0);
    let axis = rotation.axis().unwrap_or_else(Vector3::zeros);
    leave(&[
        axis.x,
        axis.y,
        axis.z,
        in_unit(rotation.angle_rad(), unit(unit_place)),
    ])
}

/// The rotation vector.
#[wasm_bindgen(js_name = asRotationVector)]
pub fn as_rotation_vector(unit_place: u8) -> CallOutcome {
    let unit = unit(unit_place);
    let vector = rotation(0).rotation_vector_rad();
    leave(vector.map(|number| in_unit(number, unit)).as_slice())
}

/// The modified Rodrigues parameters.
#[wasm_bindgen(js_name = asModifiedRodrigues)]
pub fn as_modified_rodrigues() -> CallOutcome {
    leave(rotation(0).modified_rodrigues_parameters().as_slice())
}

/// The Gibbs vector, which a half turn does not have.
#[wasm_bindgen(js_name = asGibbs)]
pub fn as_gibbs() -> CallOutcome {
    match rotation(0).gibbs_vector() {
        Some(vector) => leave(vector.as_slice()),
        None => CallOutcome::TooLarge,
    }
}
