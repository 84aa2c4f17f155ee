//! Attitudes in motion: the first stands in the registers from 0 on.

use crate::motion::kinematics::IntegrationOrder;
use crate::wasm::registers::{leave, leave_found, numbers, rotation};
use crate::wasm::{CallOutcome, rate_axes};
use nalgebra::Vector3;
use wasm_bindgen::prelude::*;

/// Turned by a rotation vector, in radians, on the axes of the body or of the world.
#[wasm_bindgen(js_name = turnedBy)]
pub fn turned_by(axes: u8) -> CallOutcome {
    leave_found(rotation(0).turned_by_rad(numbers(4), rate_axes(axes)))
}

/// After so many seconds at the rate from 4 on, in rad/s; where it changes, from 7 on stands that of the second
/// place of the fourth order.
#[wasm_bindgen]
pub fn integrate(axes: u8, is_changing: u8, seconds: f64) -> CallOutcome {
    let axes = rate_axes(axes);
    let [early, late] = [4, 7].map(|from| Vector3::from(numbers(from)));
    let order = match is_changing {
        0 => IntegrationOrder::First,
        _ => IntegrationOrder::Fourth,
    };
    let rate_rad = |time: f64| if time / seconds < 0.5 { early } else { late };
    leave_found(rotation(0).step(rate_rad, axes, 0.0, seconds, order))
}

/// The constant rate that leads to the attitude from 4 on within so many seconds, in rad/s.
#[wasm_bindgen(js_name = rateTo)]
pub fn rate_to(axes: u8, seconds: f64) -> CallOutcome {
    let rate = rotation(0).rate_to(&rotation(4), rate_axes(axes), seconds);
    leave(rate.as_slice())
}
