//! Reports, and problems of the texts of a request, to JavaScript.

use crate::contract::Problems;
use crate::problem::{Field, MAX_TEXT_BYTES, Problem};
use crate::wasm::refusal::Typed;
use crate::wasm::request_texts::{Texts, member_of};
use js_sys::{Reflect, TypeError};
use serde::Serialize;
use wasm_bindgen::prelude::*;
#[cfg(feature = "whole")]
use {
    crate::analyze::frames::frames,
    crate::contract::{FramesReport, FramesRequest},
    std::mem::take,
};
#[cfg(feature = "libraries")]
use {
    crate::analyze::identify::observation::LONGEST_TEXT_BYTES,
    crate::contract::{IdentifyReport, ObservationReport},
};

/// The tag of an outcome.
pub(crate) const STATUS: &str = "status";

/// The text of a field of a request, of the one at a place where there are several.
pub(crate) type TextOf<'request> = &'request dyn Fn(Field, usize) -> &'request str;

/// A report, or problems that count the units of the texts they point into.
pub(crate) fn answer(
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
pub(crate) fn of_whole_texts(mut report: IdentifyReport, texts: &Texts) -> IdentifyReport {
    for (at, observation) in report.observations.iter_mut().enumerate() {
        if let ObservationReport::Problem(found) = observation {
            let path = format!("observations[{at}].{}", member_of(found.problem.field));
            found.problem = texts.of_whole_text(found.problem.clone(), &path, LONGEST_TEXT_BYTES);
        }
    }
    report
}

#[cfg(feature = "whole")]
pub(crate) fn frames_of_whole_texts(request: &FramesRequest, texts: &Texts) -> FramesReport {
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
pub(crate) fn with_status(status: &str, report: &impl Serialize) -> Typed<JsValue> {
    let outcome = to_js(report)?;
    Reflect::set(&outcome, &STATUS.into(), &status.into())?;
    Ok(outcome)
}

pub(crate) fn to_js(value: &impl Serialize) -> Result<JsValue, TypeError> {
    serde_wasm_bindgen::to_value(value).map_err(|error| TypeError::new(&error.to_string()))
}
