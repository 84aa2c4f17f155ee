//! The edge: the one room that knows JavaScript exists.
//!
//! It moves plain data across and counts spans the way a text field does. What
//! is typed never throws; a caller who breaks the types gets a `TypeError`.

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

use crate::analyze::compose::compose;
use crate::analyze::describe::describe_convention as described_convention;
use crate::analyze::read::read;
use crate::contract::Problems;
use crate::convention::Convention;
use crate::problem::{Field, MAX_TEXT_BYTES, Problem};
use crate::text::parse_number;
use crate::wasm::members::{Members, word};
use crate::wasm::refusal::{Typed, no_such_choice, refused};
use crate::wasm::request::{compose_request, read_request};
use crate::wasm::request_texts::{Texts, member_of};
use js_sys::{JsString, Object, Reflect, TypeError};
use serde::Serialize;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;
#[cfg(feature = "whole")]
use {
    crate::analyze::frames::frames,
    crate::contract::FramesReport,
    crate::contract::request::FramesRequest,
    crate::wasm::frames_request::{FRAMES, frames_request},
    std::mem::take,
};
#[cfg(feature = "libraries")]
use {
    crate::analyze::identify::matrix_library::identify_matrices,
    crate::analyze::identify::observation::LONGEST_TEXT_BYTES,
    crate::analyze::identify::{identify, standard_probes},
    crate::analyze::numbers::numbers,
    crate::analyze::translate::{describe_library as described_library, translate},
    crate::contract::request::{IdentifyRequest, TranslateRequest},
    crate::contract::{IdentifyReport, ObservationReport},
    crate::library::endpoint::Endpoint,
    crate::wasm::library_request::{
        IDENTIFY, MATRICES, NUMBERS, TRANSLATE, identify_request, matrices_request,
        numbers_request, translate_request,
    },
    crate::wasm::request::{COMPOSE, READ},
};
#[cfg(feature = "whole")]
use {
    crate::analyze::motion::motion,
    crate::wasm::motion_request::{MOTION, motion_request},
};

#[cfg(feature = "whole")]
use {
    crate::analyze::{atlas::atlas, between::between, chain::chain, swing_twist::swing_twist},
    crate::wasm::attitude_request::{
        ATLAS, BETWEEN, CHAIN, SWING_TWIST, atlas_request, between_request, chain_request,
        swing_twist_request,
    },
};

/// The tags of a request and of an outcome.
const VIEW: &str = "view";
const STATUS: &str = "status";

#[cfg(feature = "whole")]
const VIEWS: [&str; 12] = [
    "read",
    "compose",
    "translate",
    "identify",
    "numbers",
    "matrices",
    "between",
    "chain",
    "atlas",
    "swing-twist",
    "frames",
    "motion",
];
#[cfg(all(feature = "libraries", not(feature = "whole")))]
const VIEWS: [&str; 6] = [
    "read",
    "compose",
    "translate",
    "identify",
    "numbers",
    "matrices",
];
#[cfg(not(feature = "libraries"))]
const VIEWS: [&str; 2] = ["read", "compose"];

/// The members of all requests.
#[cfg(feature = "whole")]
const KNOWN: [&[&str]; 12] = [
    &READ,
    &COMPOSE,
    &TRANSLATE,
    &IDENTIFY,
    &NUMBERS,
    &MATRICES,
    &BETWEEN,
    &CHAIN,
    &ATLAS,
    &SWING_TWIST,
    &FRAMES,
    &MOTION,
];
#[cfg(all(feature = "libraries", not(feature = "whole")))]
const KNOWN: [&[&str]; 6] = [&READ, &COMPOSE, &TRANSLATE, &IDENTIFY, &NUMBERS, &MATRICES];

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

/// By its tag here, and not by serde through the types of a request and an outcome, which would copy
/// everything first, and would hold every view where a build answers two.
fn answer_of(request: &JsValue, view: &JsValue) -> Typed<JsValue> {
    let texts = Texts::default();
    let members = Members::of_request(request, &texts)?;
    let view = view_of(&members, view)?;
    match &*view {
        "read" => {
            let request = read_request(&members)?;
            answer(&view, read(&request), &texts, &|field, _| match field {
                Field::Vector => &request.vector,
                _ => &request.quaternion,
            })
        }
        "compose" => {
            let request = compose_request(&members)?;
            answer(&view, compose(&request), &texts, &|field, _| match field {
                Field::P => &request.p,
                Field::Q => &request.q,
                _ => &request.vector,
            })
        }
        #[cfg(feature = "libraries")]
        "translate" => {
            let request: TranslateRequest = translate_request(&members)?;
            answer(
                &view,
                translate(&request),
                &texts,
                &|field, _| match field {
                    Field::WorldAxes => &request.world_axes,
                    Field::BodyAxes => &request.body_axes,
                    Field::From => id_of(&request.from),
                    Field::To => id_of(&request.to),
                    _ => &request.quaternion,
                },
            )
        }
        #[cfg(feature = "libraries")]
        "identify" => {
            let request: IdentifyRequest = identify_request(&members)?;
            let report = identify(&request).in_utf16(|field, at| {
                let probe = request.observations.get(at);
                probe.map_or_else(String::new, |probe| probe.text(field).to_owned())
            });
            with_status(&view, &of_whole_texts(report, &texts))
        }
        #[cfg(feature = "libraries")]
        "matrices" => {
            let request = matrices_request(&members)?;
            let answered = identify_matrices(&request).map_err(|problem| vec![problem]);
            answer(&view, answered, &texts, &|field, _| match field {
                Field::A => &request.a,
                Field::B => &request.b,
                Field::Product => &request.product,
                Field::Matrix => &request.matrix,
                Field::RotationVector => &request.rotation_vector,
                Field::Printed => &request.printed,
                _ => &request.yawed,
            })
        }
        #[cfg(feature = "libraries")]
        "numbers" => {
            let request = numbers_request(&members)?;
            answer(&view, numbers(&request), &texts, &|field, _| match field {
                Field::Numbers => &request.numbers,
                _ => &request.quaternion,
            })
        }
        #[cfg(feature = "whole")]
        "between" => {
            let request = between_request(&members)?;
            answer(&view, between(&request), &texts, &|field, _| match field {
                Field::P => &request.p,
                Field::Q => &request.q,
                _ => &request.part,
            })
        }
        #[cfg(feature = "whole")]
        "chain" => {
            let request = chain_request(&members)?;
            answer(&view, chain(&request), &texts, &|_, at| {
                request.factors.get(at).map_or("", |factor| &factor.text)
            })
        }
        #[cfg(feature = "whole")]
        "atlas" => {
            let request = atlas_request(&members)?;
            answer(&view, atlas(&request), &texts, &|_, _| &request.quaternion)
        }
        #[cfg(feature = "whole")]
        "swing-twist" => {
            let request = swing_twist_request(&members)?;
            let answered = swing_twist(&request);
            answer(&view, answered, &texts, &|field, _| match field {
                Field::Axis => &request.axis,
                _ => &request.quaternion,
            })
        }
        #[cfg(feature = "whole")]
        "frames" => {
            let request = frames_request(&members)?;
            with_status(&view, &frames_of_whole_texts(&request, &texts))
        }
        #[cfg(feature = "whole")]
        "motion" => {
            let request = motion_request(&members)?;
            answer(&view, motion(&request), &texts, &|field, _| match field {
                Field::Rate => &request.rate,
                Field::RateEnd => &request.rate_end,
                Field::Duration => &request.duration,
                Field::Increment => &request.increment,
                _ => &request.quaternion,
            })
        }
        _ => Err(no_such_choice(VIEW, &view, &VIEWS)),
    }
}

/// The view that is asked, which the request need not name where the caller does.
fn view_of(members: &Members<'_>, asked: &JsValue) -> Typed<String> {
    let named = members.value(VIEW)?;
    let asked = asked.as_string();
    if let (Some(asked), true) = (&asked, named.is_undefined()) {
        return Ok(asked.clone());
    }
    #[cfg(feature = "libraries")]
    if named.is_undefined() {
        // A misspelt `view` is told before it is missed.
        members.only(&KNOWN.concat())?;
    }
    let named = word(&named, VIEW)?;
    match asked {
        Some(asked) if asked != named => Err(refused(&format!(
            "its `view` is `{named}`, and {asked} was asked"
        ))),
        _ => Ok(named),
    }
}

/// The text of a field of a request, of the one at a place where there are several.
type TextOf<'request> = &'request dyn Fn(Field, usize) -> &'request str;

/// A report, or problems that count the units of the texts they point into.
fn answer(
    view: &str,
    answered: Result<impl Serialize, Vec<Problem>>,
    texts: &Texts,
    text_of: TextOf<'_>,
) -> Typed<JsValue> {
    match answered {
        Ok(report) => with_status(view, &report),
        Err(problems) => with_status("problems", &of_texts(problems, texts, text_of, "")),
    }
}

/// The problems, with spans in the units of JavaScript, of texts that stand in this part of the request.
fn of_texts(problems: Vec<Problem>, texts: &Texts, text_of: TextOf<'_>, part: &str) -> Problems {
    let mut whole = Vec::new();
    for mut problem in problems {
        let text = text_of(problem.field, problem.at.into());
        problem.span = problem.span.in_utf16(text);
        let member = member_of(problem.field);
        #[cfg(feature = "whole")]
        let whole_path = match problem.field {
            Field::Factor => format!("{member}[{}].text", problem.at),
            _ => format!("{part}{member}"),
        };
        #[cfg(feature = "whole")]
        let path = &*whole_path;
        #[cfg(feature = "whole")]
        let most = match problem.field {
            Field::Parent | Field::Child | Field::Rotation | Field::Position | Field::Point => {
                LONGEST_TEXT_BYTES
            }
            _ => MAX_TEXT_BYTES,
        };
        #[cfg(not(feature = "whole"))]
        let (path, most, _) = (member, MAX_TEXT_BYTES, part);
        whole.push(texts.of_whole_text(problem, path, most));
    }
    Problems { problems: whole }
}

#[cfg(feature = "libraries")]
fn id_of(endpoint: &Endpoint) -> &str {
    match endpoint {
        Endpoint::Library(endpoint) => &endpoint.id,
        Endpoint::Convention(_) => "",
    }
}

#[cfg(feature = "libraries")]
fn of_whole_texts(mut report: IdentifyReport, texts: &Texts) -> IdentifyReport {
    for (at, observation) in report.observations.iter_mut().enumerate() {
        if let ObservationReport::Problem(found) = observation {
            let path = format!("observations[{at}].{}", member_of(found.problem.field));
            found.problem = texts.of_whole_text(found.problem.clone(), &path, LONGEST_TEXT_BYTES);
        }
    }
    report
}

#[cfg(feature = "whole")]
fn frames_of_whole_texts(request: &FramesRequest, texts: &Texts) -> FramesReport {
    let mut report = frames(request);
    for (at, pose) in report.poses.iter_mut().enumerate() {
        let part = format!("poses[{at}].");
        let problems = take(&mut pose.problems);
        let text_of = |field, at: usize| request.poses[at].text(field);
        pose.problems = of_texts(problems, texts, &text_of, &part).problems;
    }
    let problems = take(&mut report.problems);
    report.problems = of_texts(problems, texts, &|field, _| request.text(field), "").problems;
    report
}

/// An [`Outcome`](crate::Outcome) as serde would tag it.
fn with_status(status: &str, report: &impl Serialize) -> Typed<JsValue> {
    let outcome = to_js(report)?;
    Reflect::set(&outcome, &STATUS.into(), &status.into())?;
    Ok(outcome)
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

fn to_js(value: &impl Serialize) -> Result<JsValue, TypeError> {
    serde_wasm_bindgen::to_value(value).map_err(|error| TypeError::new(&error.to_string()))
}
