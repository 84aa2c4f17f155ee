//! Texts that are read as another text is, texts that are refused at a place, and what is offered for them.

use crate::asked::{read, read_request};
use quatlas::{
    ComposeRequest, Convention, Field, Outcome, Problem, ProblemCode, Remedy, Request, Rotation,
    Suggestion, TaggedQuaternion, analyze,
};

/// What is answered to a text in one field, beside good texts in the others.
pub(crate) fn answer(field: Field, text: &str) -> Outcome {
    analyze(&match field {
        Field::Vector => read_request("1 0 0 0", text, Convention::HAMILTON),
        Field::P => Request::Compose(ComposeRequest::new(
            text,
            "1 0 0 0",
            "1 0 0",
            Convention::HAMILTON,
        )),
        _ => read_request(text, "1 0 0", Convention::HAMILTON),
    })
}

/// The only problem of a text in one field.
#[track_caller]
pub(crate) fn problem(field: Field, text: &str) -> Problem {
    match answer(field, text) {
        Outcome::Problems(found) if found.problems.len() == 1 => found.problems[0].clone(),
        other => panic!("{text:?} has no problem of its own: {other:?}"),
    }
}

/// The problem of a text that is refused with this code at this place.
#[track_caller]
pub(crate) fn refusal(field: Field, text: &str, code: ProblemCode, place: &str) -> Problem {
    let problem = problem(field, text);
    assert_eq!(problem.code, code, "{text}: {problem:?}");
    let marked = text.get(problem.span.start..problem.span.end);
    assert_eq!(marked, Some(place), "{text}");
    problem
}

/// The same, with a word of what is said about it.
#[track_caller]
pub(crate) fn check_refusal(field: Field, text: &str, code: ProblemCode, place: &str, word: &str) {
    let problem = refusal(field, text, code, place);
    let said = format!("{}; {}", problem.message, problem.hint);
    assert!(said.contains(word), "{text}: {said}");
}

/// A text, its problem, where it stands, and a word of what is said about it.
pub(crate) type Refusal = (&'static str, ProblemCode, &'static str, &'static str);

#[track_caller]
pub(crate) fn check_refused(texts: &[Refusal]) {
    for (text, code, place, word) in texts {
        check_refusal(Field::Quaternion, text, *code, place, word);
    }
}

pub(crate) fn attitude(text: &str) -> Rotation {
    let unit = read(text, "1 0 0", Convention::HAMILTON).hamilton.unit;
    let tagged = TaggedQuaternion::new(unit.w, unit.x, unit.y, unit.z, Convention::HAMILTON);
    Rotation::from_tagged(&tagged).expect("a rotation")
}

/// Texts, each with one of the same attitude that has no such words.
#[track_caller]
pub(crate) fn check_read(texts: &[(&str, &str)]) {
    for (text, plain) in texts {
        let distance = attitude(text).angle_to_rad(&attitude(plain));
        assert!(
            distance < 1e-15,
            "{text} is {distance} rad away from {plain}"
        );
    }
}

#[track_caller]
pub(crate) fn check_offered(texts: &[(&str, Remedy, &str)]) {
    for (text, remedy, expected) in texts {
        let expected = Suggestion {
            remedy: *remedy,
            text: (*expected).to_owned(),
            label: None,
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
