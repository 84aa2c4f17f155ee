//! What Frames is asked, member by member.

use crate::contract::{FramesRequest, GivenPose};
use crate::wasm::members::Members;
use crate::wasm::refusal::Typed;
use crate::wasm::request::{convention, euler, matrix, matrix_if_any};

pub(crate) const FRAMES: [&str; 8] = [
    "view",
    "poses",
    "child",
    "parent",
    "point",
    "convention",
    "matrix",
    "euler",
];

const POSE: [&str; 6] = [
    "parent",
    "child",
    "rotation",
    "position",
    "convention",
    "matrix",
];

pub(crate) fn frames_request(request: &Members<'_>) -> Typed<FramesRequest> {
    request.only(&FRAMES)?;
    let child = request.name("child")?;
    let parent = request.name("parent")?;
    let point = request.text_or_empty("point")?;
    let convention = convention(&request.object("convention")?)?;
    let matrix = matrix(request)?;
    let euler = euler(request)?;
    Ok(FramesRequest {
        poses: request.list_of_objects("poses", pose)?,
        child,
        parent,
        point,
        convention,
        matrix,
        euler,
    })
}

fn pose(members: &Members<'_>) -> Typed<GivenPose> {
    members.only(&POSE)?;
    let of_four = members.object_if_any("convention")?;
    let convention = of_four.map(|given| convention(&given)).transpose()?;
    let matrix = matrix_if_any(members)?;
    Ok(GivenPose {
        parent: members.name("parent")?,
        child: members.name("child")?,
        rotation: members.text("rotation")?,
        position: members.text_or_empty("position")?,
        convention,
        matrix,
    })
}
