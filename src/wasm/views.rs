//! The views that a request may ask, and who answers each.

use crate::analyze::compose::compose;
use crate::analyze::read::read;
use crate::problem::Field;
use crate::wasm::answer::answer;
use crate::wasm::members::{Members, word};
use crate::wasm::refusal::{Typed, no_such_choice, refused};
use crate::wasm::request::{compose_request, read_request};
use crate::wasm::request_texts::Texts;
use wasm_bindgen::prelude::*;
#[cfg(feature = "libraries")]
use {
    crate::analyze::identify::identify,
    crate::analyze::identify::matrix_library::identify_matrices,
    crate::analyze::numbers::numbers,
    crate::analyze::translate::translate,
    crate::contract::request::{IdentifyRequest, TranslateRequest},
    crate::library::endpoint::Endpoint,
    crate::wasm::answer::{of_whole_texts, with_status},
    crate::wasm::library_request::{
        IDENTIFY, MATRICES, NUMBERS, TRANSLATE, identify_request, matrices_request,
        numbers_request, translate_request,
    },
    crate::wasm::request::{COMPOSE, READ},
};
#[cfg(feature = "whole")]
use {
    crate::analyze::motion::motion,
    crate::analyze::{atlas::atlas, between::between, chain::chain, swing_twist::swing_twist},
    crate::wasm::answer::frames_of_whole_texts,
    crate::wasm::attitude_request::{
        ATLAS, BETWEEN, CHAIN, SWING_TWIST, atlas_request, between_request, chain_request,
        swing_twist_request,
    },
    crate::wasm::frames_request::{FRAMES, frames_request},
    crate::wasm::motion_request::{MOTION, motion_request},
};

/// The tag of a request.
const VIEW: &str = "view";

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

/// By its tag here, and not by serde through the types of a request and an outcome, which would copy
/// everything first, and would hold every view where a build answers two.
pub(crate) fn answer_of(request: &JsValue, view: &JsValue) -> Typed<JsValue> {
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
                Field::Duration => &request.duration,
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
                Field::Covariance => &request.covariance,
                Field::Point => &request.point,
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

#[cfg(feature = "libraries")]
fn id_of(endpoint: &Endpoint) -> &str {
    match endpoint {
        Endpoint::Library(endpoint) => &endpoint.id,
        Endpoint::Convention(_) => "",
    }
}
