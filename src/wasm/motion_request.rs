//! What Motion is asked, member by member.

use crate::contract::MotionRequest;
use crate::convention::side::IncrementSign;
use crate::motion::kinematics::RateAxes;
use crate::wasm::members::Members;
use crate::wasm::refusal::Typed;
use crate::wasm::request::{convention, euler, matrix};

pub(crate) const MOTION: [&str; 14] = [
    "view",
    "quaternion",
    "convention",
    "matrix",
    "euler",
    "rate",
    "rateEnd",
    "rateAxes",
    "duration",
    "steps",
    "increment",
    "incrementSign",
    "covariance",
    "point",
];

/// The texts that may be left out.
const TEXTS: [&str; 6] = [
    "rate",
    "rateEnd",
    "duration",
    "increment",
    "covariance",
    "point",
];

pub(crate) fn motion_request(request: &Members<'_>) -> Typed<MotionRequest> {
    request.only(&MOTION)?;
    let rate_axes = match request.place_or_first("rateAxes", &["body", "world"])? {
        0 => RateAxes::Body,
        _ => RateAxes::World,
    };
    let increment_sign = match request.place_or_first("incrementSign", &["physical", "formal"])? {
        0 => IncrementSign::Physical,
        _ => IncrementSign::Formal,
    };
    let steps = request.count_if_any("steps", MotionRequest::MOST_STEPS)?;
    let (convention, matrix) = (
        convention(&request.object("convention")?)?,
        matrix(request)?,
    );
    let euler = euler(request)?;
    let quaternion = request.text("quaternion")?;
    let mut texts: [String; 6] = Default::default();
    for (text, name) in texts.iter_mut().zip(TEXTS) {
        *text = request.text_or_empty(name)?;
    }
    let [rate, rate_end, duration, increment, covariance, point] = texts;
    Ok(MotionRequest {
        quaternion,
        convention,
        matrix,
        euler,
        rate,
        rate_end,
        rate_axes,
        duration,
        steps: steps.unwrap_or(MotionRequest::usual_steps()),
        increment,
        increment_sign,
        covariance,
        point,
    })
}
