//! What is asked of several attitudes, and of one in all its parts, member by member.

use crate::contract::request::{
    AtlasRequest, BetweenRequest, ChainFactor, ChainRequest, SwingTwistRequest,
};
use crate::wasm::members::Members;
use crate::wasm::refusal::{Typed, refused};
use crate::wasm::request::{convention, euler, matrix};

pub(crate) const BETWEEN: [&str; 8] = [
    "view",
    "p",
    "q",
    "convention",
    "matrix",
    "euler",
    "part",
    "duration",
];
pub(crate) const CHAIN: [&str; 5] = ["view", "factors", "convention", "matrix", "euler"];
pub(crate) const ATLAS: [&str; 4] = ["view", "quaternion", "convention", "matrix"];
pub(crate) const SWING_TWIST: [&str; 5] = ["view", "quaternion", "axis", "convention", "matrix"];

/// The most factors of a chain: more than anybody mounts on each other, few enough to answer at once.
const MOST_FACTORS: usize = 32;

pub(crate) fn between_request(request: &Members<'_>) -> Typed<BetweenRequest> {
    request.only(&BETWEEN)?;
    Ok(BetweenRequest {
        p: request.text("p")?,
        q: request.text("q")?,
        convention: convention(&request.object("convention")?)?,
        matrix: matrix(request)?,
        euler: euler(request)?,
        part: request.text_or_empty("part")?,
        duration: request.text_or_empty("duration")?,
    })
}

pub(crate) fn chain_request(request: &Members<'_>) -> Typed<ChainRequest> {
    request.only(&CHAIN)?;
    let factors = request.list_of_objects("factors", factor)?;
    if !(1..=MOST_FACTORS).contains(&factors.len()) {
        return Err(refused("`factors` needs 1 to 32 elements"));
    }
    Ok(ChainRequest {
        factors,
        convention: convention(&request.object("convention")?)?,
        matrix: matrix(request)?,
        euler: euler(request)?,
    })
}

fn factor(members: &Members<'_>) -> Typed<ChainFactor> {
    members.only(&["text", "inverse"])?;
    Ok(ChainFactor {
        text: members.text("text")?,
        inverse: members.is_set("inverse")?,
    })
}

pub(crate) fn atlas_request(request: &Members<'_>) -> Typed<AtlasRequest> {
    request.only(&ATLAS)?;
    Ok(AtlasRequest {
        quaternion: request.text("quaternion")?,
        convention: convention(&request.object("convention")?)?,
        matrix: matrix(request)?,
    })
}

pub(crate) fn swing_twist_request(request: &Members<'_>) -> Typed<SwingTwistRequest> {
    request.only(&SWING_TWIST)?;
    Ok(SwingTwistRequest {
        quaternion: request.text("quaternion")?,
        axis: request.text("axis")?,
        convention: convention(&request.object("convention")?)?,
        matrix: matrix(request)?,
    })
}
