//! From one library or convention to another: what the tests of it share.

mod axes;
mod ends;
mod lines;
mod mistakes;
mod numbers;
mod printed;
#[cfg(not(target_arch = "wasm32"))]
mod properties;

use crate::simulated::active_matrix;
use quatlas::nalgebra::Matrix3;
use quatlas::{
    ComponentOrder, CosineMatrix, Direction, Endpoint, Library, LibraryEndpoint, Outcome, Problem,
    RecordNumbersKind, Request, TranslateReport, TranslateRequest, TranslatedEnd, analyze,
    libraries,
};

/// The records at whose end four plain numbers are a quaternion.
pub(super) fn with_plain_quaternions() -> impl Iterator<Item = &'static Library> {
    let is_axis_and_angle = |library: &Library| {
        let numbers = library.numbers;
        numbers.is_some_and(|numbers| numbers.kind == RecordNumbersKind::AxisAngle)
    };
    let libraries = libraries().iter();
    libraries.filter(move |library| !is_axis_and_angle(library))
}

/// The records that have a quaternion.
pub(super) fn with_quaternions() -> impl Iterator<Item = &'static Library> {
    libraries()
        .iter()
        .filter(|library| library.numbers.is_none())
}

pub(super) fn answer(request: TranslateRequest) -> Outcome {
    analyze(&Request::Translate(request))
}

#[track_caller]
pub(super) fn report(request: TranslateRequest) -> TranslateReport {
    match answer(request) {
        Outcome::Translate(report) => *report,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
pub(super) fn translate(text: &str, from: &Endpoint, to: &Endpoint) -> TranslateReport {
    report(TranslateRequest::new(text, from.clone(), to.clone()))
}

#[track_caller]
pub(super) fn between(text: &str, from: &str, to: &str) -> TranslateReport {
    translate(text, &Endpoint::library(from), &Endpoint::library(to))
}

pub(super) fn problems(request: TranslateRequest) -> Vec<Problem> {
    match answer(request) {
        Outcome::Problems(found) => found.problems,
        other => panic!("{other:?}"),
    }
}

/// `R_WB` from the numbers of one end, by what the end says of them.
pub(super) fn body_to_world(end: &TranslatedEnd) -> Matrix3<f64> {
    let q = &end.components;
    let active = active_matrix([q.w, q.x, q.y, q.z]);
    let acts = match end.action {
        CosineMatrix::Hamilton => active,
        CosineMatrix::Shuster => active.transpose(),
    };
    match end.direction {
        Direction::BodyToWorld => acts,
        Direction::WorldToBody => acts.transpose(),
    }
}

pub(super) const TEXT: &str = "0.1 0.7 -0.5 0.5";

pub(super) fn end(
    id: &str,
    order: Option<ComponentOrder>,
    direction: Option<Direction>,
) -> Endpoint {
    Endpoint::Library(LibraryEndpoint {
        id: id.to_owned(),
        order,
        direction,
    })
}
