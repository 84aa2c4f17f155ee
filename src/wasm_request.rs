//! What Read and Compose are asked, member by member.
//!
//! These are the requests that the page begins with, and serde's way would add 15 kB to the compressed
//! wasm: visitors, and sentences that hold any number.

use crate::convention::{
    ComponentOrder, Convention, Direction, Function, Handedness, Perturbation,
};
use crate::euler_sequence::{EulerAxes, EulerFrame, EulerSequence};
use crate::request::{ComposeRequest, ReadRequest};
use crate::rotation_matrix::MatrixConvention;
use js_sys::{Reflect, TypeError};
use wasm_bindgen::prelude::*;

type Typed<Kind> = Result<Kind, TypeError>;

pub(crate) fn read_request(request: &JsValue) -> Typed<ReadRequest> {
    Ok(ReadRequest {
        quaternion: text(request, "quaternion")?,
        vector: text(request, "vector")?,
        convention: convention(request)?,
        matrix: matrix(request)?,
        euler: euler(request)?,
    })
}

pub(crate) fn compose_request(request: &JsValue) -> Typed<ComposeRequest> {
    Ok(ComposeRequest {
        p: text(request, "p")?,
        q: text(request, "q")?,
        vector: text(request, "vector")?,
        convention: convention(request)?,
        matrix: matrix(request)?,
    })
}

fn convention(request: &JsValue) -> Typed<Convention> {
    use {ComponentOrder as Order, Direction as Way, Handedness as Hand, Perturbation as Small};
    Ok(Convention {
        order: choice(request, "convention.order", Order::ALL, Order::name)?,
        handedness: choice(request, "convention.handedness", Hand::ALL, Hand::name)?,
        function: choice(
            request,
            "convention.function",
            Function::ALL,
            Function::name,
        )?,
        direction: choice(request, "convention.direction", Way::ALL, Way::name)?,
        perturbation: choice(request, "convention.perturbation", Small::ALL, Small::name)?,
    })
}

fn matrix(request: &JsValue) -> Typed<MatrixConvention> {
    if member(request, "matrix").is_undefined() {
        return Ok(MatrixConvention::default());
    }
    Ok(MatrixConvention {
        function: choice(request, "matrix.function", Function::ALL, Function::name)?,
        direction: choice(request, "matrix.direction", Direction::ALL, Direction::name)?,
    })
}

fn euler(request: &JsValue) -> Typed<EulerSequence> {
    if member(request, "euler").is_undefined() {
        return Ok(EulerSequence::default());
    }
    Ok(EulerSequence {
        axes: choice(request, "euler.axes", EulerAxes::ALL, EulerAxes::name)?,
        frame: choice(request, "euler.frame", EulerFrame::ALL, EulerFrame::name)?,
    })
}

/// Undefined where there is none.
fn member(of: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(of.clone(), |of, name| {
        Reflect::get(&of, &name.into()).unwrap_or(JsValue::UNDEFINED)
    })
}

fn text(request: &JsValue, path: &str) -> Typed<String> {
    let text = member(request, path).as_string();
    text.ok_or_else(|| TypeError::new(&format!("this is not a request: no text is its {path}")))
}

/// The names of JavaScript are in small letters.
fn choice<Choice: Copy, const COUNT: usize>(
    request: &JsValue,
    path: &str,
    all: [Choice; COUNT],
    name_of: fn(Choice) -> &'static str,
) -> Typed<Choice> {
    let name = text(request, path)?;
    let chosen = all
        .into_iter()
        .find(|&choice| name_of(choice).to_ascii_lowercase() == name);
    chosen.ok_or_else(|| {
        TypeError::new(&format!(
            "this is not a request: its {path} cannot be `{name}`"
        ))
    })
}
