//! What Read and Compose are asked, member by member.
//!
//! These are the requests that the page begins with, and serde's way would add 15 kB to the compressed
//! wasm: visitors, and sentences that hold any number.

use crate::contract::request::{ComposeRequest, ReadRequest};
use crate::convention::euler_sequence::{EulerAxes, EulerFrame, EulerSequence};
use crate::convention::matrix::MatrixConvention;
use crate::convention::order::ComponentOrder;
use crate::convention::{Convention, Direction, Function, Handedness, Perturbation};
use crate::wasm::members::Members;
use crate::wasm::refusal::Typed;

pub(crate) const READ: [&str; 6] = [
    "view",
    "quaternion",
    "vector",
    "convention",
    "matrix",
    "euler",
];
pub(crate) const COMPOSE: [&str; 6] = ["view", "p", "q", "vector", "convention", "matrix"];

pub(crate) fn read_request(request: &Members<'_>) -> Typed<ReadRequest> {
    request.only(&READ)?;
    Ok(ReadRequest {
        quaternion: request.text("quaternion")?,
        vector: request.text("vector")?,
        convention: convention(&request.object("convention")?)?,
        matrix: matrix(request)?,
        euler: euler(request)?,
    })
}

pub(crate) fn compose_request(request: &Members<'_>) -> Typed<ComposeRequest> {
    request.only(&COMPOSE)?;
    Ok(ComposeRequest {
        p: request.text("p")?,
        q: request.text("q")?,
        vector: request.text("vector")?,
        convention: convention(&request.object("convention")?)?,
        matrix: matrix(request)?,
    })
}

pub(crate) fn convention(members: &Members<'_>) -> Typed<Convention> {
    use {ComponentOrder as Order, Direction as Way, Handedness as Hand, Perturbation as Small};
    members.only(&[
        "order",
        "handedness",
        "function",
        "direction",
        "perturbation",
    ])?;
    Ok(Convention {
        order: members.choice("order", Order::ALL, Order::name)?,
        handedness: members.choice("handedness", Hand::ALL, Hand::name)?,
        function: members.choice("function", Function::ALL, Function::name)?,
        direction: members.choice("direction", Way::ALL, Way::name)?,
        perturbation: members.choice("perturbation", Small::ALL, Small::name)?,
    })
}

pub(crate) fn matrix(request: &Members<'_>) -> Typed<MatrixConvention> {
    Ok(matrix_if_any(request)?.unwrap_or_default())
}

pub(crate) fn matrix_if_any(request: &Members<'_>) -> Typed<Option<MatrixConvention>> {
    let Some(members) = request.object_if_any("matrix")? else {
        return Ok(None);
    };
    members.only(&["function", "direction"])?;
    Ok(Some(MatrixConvention {
        function: members.choice("function", Function::ALL, Function::name)?,
        direction: members.choice("direction", Direction::ALL, Direction::name)?,
    }))
}

pub(crate) fn euler(request: &Members<'_>) -> Typed<EulerSequence> {
    let Some(members) = request.object_if_any("euler")? else {
        return Ok(EulerSequence::default());
    };
    members.only(&["axes", "frame"])?;
    Ok(EulerSequence {
        axes: members.choice("axes", EulerAxes::ALL, EulerAxes::name)?,
        frame: members.choice("frame", EulerFrame::ALL, EulerFrame::name)?,
    })
}
