//! What holds for every answer, whatever was asked.

use proptest::prelude::*;
use quatlas::{Field, ObservationReport, Outcome, Probe, Problem, Request, Span, analyze};
use serde_json::Value;

/// The answer has plain numbers, and problems with a place and a suggestion that is read.
pub(crate) fn check(request: &Request) -> Result<(), TestCaseError> {
    let outcome = analyze(request);
    let json = serde_json::to_value(&outcome).map_err(failed)?;
    prop_assert!(is_plain(&json), "{json}");
    // `serde_json` writes a number that is not finite as null, which is read as no number.
    let back: Outcome = serde_json::from_value(json).map_err(failed)?;
    prop_assert_eq!(&back, &outcome);
    for (problem, at) in problems(&outcome) {
        let text = text_of(request, problem.field, at);
        prop_assert!(is_inside(problem.span, &text), "{problem:?} in {text:?}");
        if let Some(suggestion) = &problem.suggestion {
            let mended = with_text(request, problem.field, &suggestion.text);
            let left = analyze(&mended);
            let is_left = problems(&left)
                .iter()
                .any(|(other, _)| other.field == problem.field);
            prop_assert!(!is_left, "{problem:?} leads to {left:?}");
        }
    }
    Ok(())
}

fn failed(error: serde_json::Error) -> TestCaseError {
    TestCaseError::fail(error.to_string())
}

/// Every number of the outcome is a number of JSON (so neither NaN nor infinite), and none is −0.
fn is_plain(value: &Value) -> bool {
    match value {
        Value::Array(members) => members.iter().all(is_plain),
        Value::Object(members) => members.values().all(is_plain),
        Value::Number(number) => number
            .as_f64()
            .is_some_and(|number| number != 0.0 || number.is_sign_positive()),
        Value::Null | Value::Bool(_) | Value::String(_) => true,
    }
}

/// On the boundaries of characters, the first not after the last.
fn is_inside(span: Span, text: &str) -> bool {
    text.get(span.start..span.end).is_some()
}

/// The problems with the places of the observations that they are about.
fn problems(outcome: &Outcome) -> Vec<(&Problem, usize)> {
    match outcome {
        Outcome::Problems(found) => found.problems.iter().map(|problem| (problem, 0)).collect(),
        Outcome::Identify(report) => {
            let observations = report.observations.iter().enumerate();
            observations
                .filter_map(|(at, observation)| match observation {
                    ObservationReport::Problem(found) => Some((&found.problem, at)),
                    _ => None,
                })
                .collect()
        }
        _ => Vec::new(),
    }
}

fn text_of(request: &Request, field: Field, at: usize) -> String {
    match (request, field) {
        (Request::Read(request), Field::Quaternion) => request.quaternion.clone(),
        (Request::Read(request), Field::Vector) => request.vector.clone(),
        (Request::Compose(request), Field::P) => request.p.clone(),
        (Request::Compose(request), Field::Q) => request.q.clone(),
        (Request::Compose(request), Field::Vector) => request.vector.clone(),
        (Request::Translate(request), Field::Quaternion) => request.quaternion.clone(),
        (Request::Translate(request), Field::WorldAxes) => request.world_axes.clone(),
        (Request::Translate(request), Field::BodyAxes) => request.body_axes.clone(),
        (Request::Identify(request), field) => request
            .observations
            .get(at)
            .map_or("", |probe| probe.text(field))
            .to_owned(),
        // An end of a translation is no text.
        _ => String::new(),
    }
}

fn with_text(request: &Request, field: Field, text: &str) -> Request {
    let mut request = request.clone();
    let place = match (&mut request, field) {
        (Request::Read(request), Field::Quaternion) => &mut request.quaternion,
        (Request::Read(request), Field::Vector) => &mut request.vector,
        (Request::Compose(request), Field::P) => &mut request.p,
        (Request::Compose(request), Field::Q) => &mut request.q,
        (Request::Compose(request), Field::Vector) => &mut request.vector,
        (Request::Translate(request), Field::Quaternion) => &mut request.quaternion,
        _ => panic!("a suggestion for {field:?}"),
    };
    text.clone_into(place);
    request
}

/// One observation of every kind with these texts.
pub(crate) fn probes([one, other, printed]: [&str; 3]) -> Vec<Probe> {
    let [one, other, printed] = [one, other, printed].map(str::to_owned);
    vec![
        Probe::Components {
            quaternion: one.clone(),
            printed: printed.clone(),
        },
        Probe::Product {
            a: one.clone(),
            b: other.clone(),
            printed: printed.clone(),
        },
        Probe::Rotate {
            quaternion: one.clone(),
            vector: other.clone(),
            printed: printed.clone(),
        },
        Probe::Matrix {
            quaternion: one.clone(),
            printed: printed.clone(),
            layout: quatlas::MatrixLayout::default(),
        },
        Probe::FromMatrix {
            matrix: one.clone(),
            layout: quatlas::MatrixLayout::default(),
            printed: printed.clone(),
        },
        Probe::QuarterTurn {
            printed: printed.clone(),
        },
        Probe::Perturb {
            quaternion: one,
            rotation_vector: other,
            printed,
        },
    ]
}
