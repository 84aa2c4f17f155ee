//! The edge: the only file that knows JavaScript exists.
//!
//! It moves plain data across and counts spans the way a text field does. What
//! is typed never throws; a caller who breaks the types gets a `TypeError`.

use crate::convention::Convention;
use crate::library::TABLE;
use crate::problem::Field;
use crate::request::Request;
use js_sys::{Reflect, TypeError};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

/// The named conventions.
#[derive(Serialize, tsify::Tsify)]
struct Presets {
    /// `[w, x, y, z]`, ij = k, body to world.
    hamilton: Convention,
    /// `[x, y, z, w]`, ij = −k, world to body.
    jpl: Convention,
}

/// The answer to a request: a report with notes, or the problems of its texts.
///
/// Spans count UTF-16 units, as `HTMLTextAreaElement.setSelectionRange` does. Throws a `TypeError`
/// for a request that is not of the type; never for what is typed in its texts.
#[wasm_bindgen(unchecked_return_type = "Outcome")]
pub fn analyze(
    #[wasm_bindgen(unchecked_param_type = "Request")] request: JsValue,
) -> Result<JsValue, TypeError> {
    let request = request_of(request)?;
    let outcome = crate::analyze(&request).in_utf16(|field, at| text_of(&request, field, at));
    to_js(&outcome)
}

/// The request of a view. By its tag here, and not by serde, which would copy everything into a type of
/// its own first and add 18 kB to the compressed wasm.
fn request_of(request: JsValue) -> Result<Request, TypeError> {
    let view = Reflect::get(&request, &"view".into()).ok();
    match view.and_then(|view| view.as_string()).as_deref() {
        Some("read") => typed(request).map(Request::Read),
        Some("compose") => typed(request).map(Request::Compose),
        Some("translate") => typed(request).map(Request::Translate),
        Some("identify") => typed(request).map(Request::Identify),
        _ => Err(TypeError::new(
            "this is not a request: its view is none of read, compose, translate, identify",
        )),
    }
}

fn typed<Kind: DeserializeOwned>(request: JsValue) -> Result<Kind, TypeError> {
    serde_wasm_bindgen::from_value(request)
        .map_err(|error| TypeError::new(&format!("this is not a request: {error}")))
}

/// The named conventions, Hamilton and JPL.
#[wasm_bindgen(unchecked_return_type = "Presets")]
pub fn presets() -> Result<JsValue, TypeError> {
    to_js(&Presets {
        hamilton: Convention::HAMILTON,
        jpl: Convention::JPL,
    })
}

/// The table of libraries, as JSON: an array of `Library`.
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

fn text_of(request: &Request, field: Field, at: usize) -> String {
    let text = match (request, field) {
        (Request::Read(read), Field::Vector) => &read.vector,
        (Request::Read(read), _) => &read.quaternion,
        (Request::Compose(compose), Field::P) => &compose.p,
        (Request::Compose(compose), Field::Q) => &compose.q,
        (Request::Compose(compose), _) => &compose.vector,
        (Request::Translate(translate), Field::WorldAxes) => &translate.world_axes,
        (Request::Translate(translate), Field::BodyAxes) => &translate.body_axes,
        (Request::Translate(translate), _) => &translate.quaternion,
        (Request::Identify(identify), field) => {
            let probe = identify.observations.get(at);
            return probe.map_or_else(String::new, |probe| probe.text(field).to_owned());
        }
    };
    text.clone()
}
