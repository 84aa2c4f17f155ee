//! The edge: the one room that knows JavaScript exists.
//!
//! It moves plain data across and counts spans the way a text field does. What
//! is typed never throws; a caller who breaks the types gets a `TypeError`.

// Reports and problems to JavaScript.
mod answer;

// The requests of several attitudes, and of one in all its parts, from JavaScript.
#[cfg(feature = "whole")]
mod attitude_request;

// Poses between named frames, from JavaScript.
#[cfg(feature = "whole")]
mod frames_request;

// The requests that need the table of libraries, from JavaScript.
#[cfg(feature = "libraries")]
mod library_request;

// Lists of JavaScript, and numbers in place of a text.
#[cfg(feature = "libraries")]
mod list;

// The members of objects of JavaScript.
mod members;

// What moves an attitude, from JavaScript.
#[cfg(feature = "whole")]
mod motion_request;

// What is thrown at a caller.
mod refusal;

// The requests that the page begins with, from JavaScript.
mod request;

// The texts of requests, and how long they are.
mod request_texts;

// The views that a request may ask, and who answers each.
mod views;

use crate::analyze::describe::describe_convention as described_convention;
use crate::convention::Convention;
use crate::text::parse_number;
use crate::wasm::answer::{STATUS, to_js};
use crate::wasm::members::Members;
use crate::wasm::refusal::Typed;
use crate::wasm::request_texts::Texts;
use crate::wasm::views::answer_of;
use js_sys::{JsString, Object, Reflect, TypeError};
use serde::Serialize;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;
#[cfg(feature = "libraries")]
use {
    crate::analyze::identify::standard_probes,
    crate::analyze::translate::describe_library as described_library,
};

/// What the alias of Rust, which is another one in each build, is in TypeScript.
#[wasm_bindgen(typescript_custom_section)]
const SUGGESTIONS: &str = "/** Several of them, in the order in which they are offered. */
export type Suggestions = Suggestion[];";

/// What a text of a request is in TypeScript, where Rust has a `String`.
#[wasm_bindgen(typescript_custom_section)]
const TEXT: &str = "/** What is typed; or numbers, which are read as they would be typed: a number, a list of them, or rows of them. */
export type Text =
  | string
  | number
  | Float64Array
  | Float32Array
  | readonly number[]
  | readonly (readonly number[] | Float64Array | Float32Array)[];";

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
/// Spans count UTF-16 units, as `HTMLTextAreaElement.setSelectionRange` does. A request that is not of
/// the type is refused, with a `TypeError` or with what its own members threw; what is typed in its texts
/// never is. A view that is asked for here need not stand in the request, which must not name another.
///
/// It throws nothing: whatever comes out of it as an error is a trap, after which [`start_anew`] is
/// needed. So the arguments are plain handles, which are taken before the instance is looked at.
#[wasm_bindgen(unchecked_return_type = "Outcome | { status: \"refused\"; error: unknown }")]
pub fn analyze(
    #[wasm_bindgen(unchecked_param_type = "unknown")] request: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "Request[\"view\"]")] view: JsValue,
) -> JsValue {
    answer_of(&request, &view).unwrap_or_else(|error| {
        let refusal = JsValue::from(Object::new());
        for (name, value) in [(STATUS, &"refused".into()), ("error", &error)] {
            // Nothing keeps a new object from having members.
            Reflect::set(&refusal, &name.into(), value).ok();
        }
        refusal
    })
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

/// What a convention is called and does.
///
/// A `TypeError` is thrown for what is no convention.
#[wasm_bindgen(js_name = describeConvention, unchecked_return_type = "ConventionDescription")]
pub fn describe_convention(
    #[wasm_bindgen(unchecked_param_type = "Convention")] convention: JsValue,
) -> Typed<JsValue> {
    let texts = Texts::default();
    let convention = request::convention(&Members::of_request(&convention, &texts)?)?;
    Ok(to_js(&described_convention(convention))?)
}

/// The one number that a text holds; undefined where it holds none, or several.
#[wasm_bindgen(js_name = readNumber)]
pub fn read_number(text: &JsString) -> Option<f64> {
    let texts = Texts::default();
    parse_number(&texts.read(text, "")?).ok()
}

/// What a library does by itself; undefined for an id that no library has.
#[cfg(feature = "libraries")]
#[wasm_bindgen(js_name = describeLibrary, unchecked_return_type = "LibraryDescription | undefined")]
pub fn describe_library(id: &str) -> Result<JsValue, TypeError> {
    described_library(id).map_or(Ok(JsValue::UNDEFINED), |description| to_js(&description))
}

/// The probes that are proposed, one of each kind.
#[cfg(feature = "libraries")]
#[wasm_bindgen(js_name = standardProbes, unchecked_return_type = "Probe[]")]
pub fn probes() -> Result<JsValue, TypeError> {
    to_js(&standard_probes())
}

/// Makes the instance anew before the next call; nothing of the old one stays.
///
/// After a trap the old one is not to be trusted: its stack stays where it stopped, and a few of these
/// use it up.
#[wasm_bindgen(js_name = startAnew)]
pub fn start_anew() {
    wasm_bindgen::handler::schedule_reinit();
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
