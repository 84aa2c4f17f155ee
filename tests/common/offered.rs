//! What is offered in place of a text that is not read.
#![allow(
    dead_code,
    reason = "a wasm build has no properties, which use a part of this"
)]

use crate::common::read_request;
use quatlas::{Convention, Field, Outcome, Problem, Remedy, Suggestion, analyze};

pub(crate) fn answer(field: Field, text: &str) -> Outcome {
    analyze(&match field {
        Field::Vector => read_request("1 0 0 0", text, Convention::HAMILTON),
        _ => read_request(text, "1 0 0", Convention::HAMILTON),
    })
}

#[track_caller]
pub(crate) fn problem(field: Field, text: &str) -> Problem {
    match answer(field, text) {
        Outcome::Problems(found) => found.problems[0].clone(),
        other => panic!("{text:?} is read: {other:?}"),
    }
}

#[track_caller]
pub(crate) fn check_offered(texts: &[(&str, Remedy, &str)]) {
    for (text, remedy, expected) in texts {
        let expected = Suggestion {
            remedy: *remedy,
            text: (*expected).to_owned(),
        };
        let problem = problem(Field::Quaternion, text);
        assert_eq!(problem.suggestion.as_deref(), Some(&expected), "{text}");
    }
}

#[track_caller]
pub(crate) fn check_none_offered(field: Field, texts: &[&str]) {
    for text in texts {
        let problem = problem(field, text);
        assert_eq!(problem.suggestion, None, "{text}: {}", problem.message);
    }
}
