//! Attitudes of other attitudes: the first stands in the registers from 0 on, the second from 4 on.

use crate::convention::Direction;
use crate::wasm::registers::{
    leave, leave_found, leave_product, leave_rotation, numbers, rotation,
};
use crate::wasm::{CallOutcome, direction, in_unit, unit};
use wasm_bindgen::prelude::*;

/// `R_WB R_BC`.
#[wasm_bindgen]
pub fn product() -> CallOutcome {
    leave_product(&(rotation(0) * rotation(4)))
}

/// `R_WBᵀ`.
#[wasm_bindgen]
pub fn inverse() -> CallOutcome {
    leave_rotation(&rotation(0).inverse())
}

/// A vector behind the attitude, in the coordinates of the other frame.
#[wasm_bindgen]
pub fn apply(direction_place: u8) -> CallOutcome {
    let vector = numbers(4).into();
    let rotation = rotation(0);
    let image = match direction(direction_place) {
        Direction::BodyToWorld => rotation.body_to_world(vector),
        Direction::WorldToBody => rotation.world_to_body(vector),
    };
    leave(image.as_slice())
}

/// A part of the way from the first to the second.
#[wasm_bindgen]
pub fn slerp(fraction: f64) -> CallOutcome {
    leave_found(rotation(0).slerp(&rotation(4), fraction))
}

/// The turn about the same axis by a multiple of the angle.
#[wasm_bindgen]
pub fn power(exponent: f64) -> CallOutcome {
    leave_found(rotation(0).power(exponent))
}

/// The angle.
#[wasm_bindgen]
pub fn magnitude(unit_place: u8) -> f64 {
    in_unit(rotation(0).angle_rad(), unit(unit_place))
}

/// The angle between two.
#[wasm_bindgen(js_name = angleTo)]
pub fn angle_to(unit_place: u8) -> f64 {
    in_unit(rotation(0).angle_to_rad(&rotation(4)), unit(unit_place))
}

/// The Frobenius norm of the difference of the matrices.
#[wasm_bindgen(js_name = chordalDistance)]
pub fn chordal_distance() -> f64 {
    rotation(0).chordal_distance(&rotation(4))
}

/// The smaller of the distances of the unit quaternions p to q and to −q.
#[wasm_bindgen(js_name = quaternionDistance)]
pub fn quaternion_distance() -> f64 {
    rotation(0).shorter_quaternion_distance(&rotation(4))
}
