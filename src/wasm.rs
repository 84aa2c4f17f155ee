//! The edge: only this file and the requests of `wasm_request` know JavaScript exists.
//!
//! It moves plain data across and counts spans the way a text field does. What
//! is typed never throws; a caller who breaks the types gets a `TypeError`.

use crate::analyze::{compose, read};
use crate::convention::Convention;
use crate::problem::{Field, Problem};
use crate::report::Problems;
use crate::wasm_request::{compose_request, read_request};
use js_sys::{Reflect, TypeError};
use serde::Serialize;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;
#[cfg(feature = "libraries")]
use {
    crate::identify::identify,
    crate::library::TABLE,
    crate::request::{IdentifyRequest, TranslateRequest},
    crate::translate::translate,
    serde::de::DeserializeOwned,
};

/// The tags of a request and of an outcome.
const VIEW: &str = "view";
const STATUS: &str = "status";

/// The named conventions.
#[derive(Serialize, tsify::Tsify)]
#[serde(rename_all = "camelCase")]
struct Presets {
    /// `[w, x, y, z]`, ij = k, body to world.
    hamilton: Convention,
    /// `[x, y, z, w]`, ij = −k, world to body.
    jpl: Convention,
    /// `[w, x, y, z]`, ij = k, active, world to body; its matrix is passive, world to body.
    my_lab: Convention,
    /// `[x, y, z, w]`, ij = −k, body to world (Yoosefian 2021, eq. 18).
    jpl_body_to_world: Convention,
    /// `[x, y, z, w]`, ij = k, body to world, as Eigen and ROS store it.
    hamilton_scalar_last: Convention,
}

/// The answer to a request: a report with notes, or the problems of its texts.
///
/// Spans count UTF-16 units, as `HTMLTextAreaElement.setSelectionRange` does. Throws a `TypeError`
/// for a request that is not of the type; never for what is typed in its texts.
#[wasm_bindgen(unchecked_return_type = "Outcome")]
pub fn analyze(
    #[wasm_bindgen(unchecked_param_type = "Request")] request: JsValue,
) -> Result<JsValue, TypeError> {
    let view = Reflect::get(&request, &VIEW.into()).ok();
    let view = view.and_then(|view| view.as_string());
    answer_of(view.as_deref().unwrap_or_default(), &request)
}

/// By its tag here, and not by serde through the types of a request and an outcome, which would copy
/// everything first, and would hold every view where a build answers two.
fn answer_of(view: &str, request: &JsValue) -> Result<JsValue, TypeError> {
    match view {
        "read" => {
            let request = read_request(request)?;
            answer(view, read(&request), |field| match field {
                Field::Vector => &request.vector,
                _ => &request.quaternion,
            })
        }
        "compose" => {
            let request = compose_request(request)?;
            answer(view, compose(&request), |field| match field {
                Field::P => &request.p,
                Field::Q => &request.q,
                _ => &request.vector,
            })
        }
        #[cfg(feature = "libraries")]
        "translate" => {
            let request: TranslateRequest = typed(request)?;
            answer(view, translate(&request), |field| match field {
                Field::WorldAxes => &request.world_axes,
                Field::BodyAxes => &request.body_axes,
                _ => &request.quaternion,
            })
        }
        #[cfg(feature = "libraries")]
        "identify" => {
            let request: IdentifyRequest = typed(request)?;
            let report = identify(&request).in_utf16(|field, at| {
                let probe = request.observations.get(at);
                probe.map_or_else(String::new, |probe| probe.text(field).to_owned())
            });
            with_status(view, &report)
        }
        _ => Err(TypeError::new(
            "this is not a request: its view is none of read, compose, translate, identify",
        )),
    }
}

/// A report, or problems that count the units of the texts they point into.
fn answer<'request>(
    view: &str,
    answered: Result<impl Serialize, Vec<Problem>>,
    text_of: impl Fn(Field) -> &'request String,
) -> Result<JsValue, TypeError> {
    match answered {
        Ok(report) => with_status(view, &report),
        Err(problems) => {
            let problems = Problems { problems }.in_utf16(|field| text_of(field).clone());
            with_status("problems", &problems)
        }
    }
}

#[cfg(feature = "libraries")]
fn typed<Kind: DeserializeOwned>(request: &JsValue) -> Result<Kind, TypeError> {
    serde_wasm_bindgen::from_value(request.clone())
        .map_err(|error| TypeError::new(&format!("this is not a request: {error}")))
}

/// An [`Outcome`](crate::Outcome) as serde would tag it.
fn with_status(status: &str, report: &impl Serialize) -> Result<JsValue, TypeError> {
    let outcome = to_js(report)?;
    Reflect::set(&outcome, &STATUS.into(), &status.into())
        .map_err(|_| TypeError::new("a report is an object"))?;
    Ok(outcome)
}

/// The double nearest to a decimal number: digits, a point, an exponent.
pub(crate) fn nearest_double(decimal: &str) -> f64 {
    js_sys::parse_float(decimal)
}

/// The shortest decimal number that reads back as the same double.
pub(crate) fn shortest(number: f64) -> String {
    js_sys::Number::from(number)
        .to_string_with_radix(10)
        .map_or_else(|_| String::new(), String::from)
}

/// The named conventions.
#[wasm_bindgen(unchecked_return_type = "Presets")]
pub fn presets() -> Result<JsValue, TypeError> {
    to_js(&Presets {
        hamilton: Convention::HAMILTON,
        jpl: Convention::JPL,
        my_lab: Convention::MY_LAB,
        jpl_body_to_world: Convention::JPL_BODY_TO_WORLD,
        hamilton_scalar_last: Convention::HAMILTON_SCALAR_LAST,
    })
}

/// The table of libraries, as JSON: an array of `Library`.
#[cfg(feature = "libraries")]
#[wasm_bindgen(js_name = librariesJson)]
pub fn libraries_json() -> String {
    TABLE.to_owned()
}

/// What the last panic said, once; undefined where there was none.
///
/// A panic is a mistake in quatlas. It traps, which JavaScript sees as an error without words.
#[wasm_bindgen(js_name = takePanicMessage)]
pub fn take_panic_message() -> Option<String> {
    PANIC_MESSAGE.take()
}

thread_local! {
    static PANIC_MESSAGE: RefCell<Option<String>> = const { RefCell::new(None) };
}

#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| {
        PANIC_MESSAGE.set(Some(panic.to_string()));
    }));
}

fn to_js(value: &impl Serialize) -> Result<JsValue, TypeError> {
    serde_wasm_bindgen::to_value(value).map_err(|error| TypeError::new(&error.to_string()))
}
