//! Texts that are read as another text is, and texts that are refused at a place.
#![allow(
    dead_code,
    reason = "each test file is a crate of its own and uses a part of this"
)]

use crate::common::{read, read_request};
use quatlas::{Convention, Outcome, ProblemCode, Rotation, TaggedQuaternion, analyze};

/// A text, its problem, where it stands, and a word of what is said about it.
pub(crate) type Refusal = (&'static str, ProblemCode, &'static str, &'static str);

#[track_caller]
pub(crate) fn check_refused(texts: &[Refusal]) {
    for (text, code, place, word) in texts {
        check_refusal(text, text, "1 0 0", *code, place, word);
    }
}

#[track_caller]
pub(crate) fn check_refusal(
    text: &str,
    quaternion: &str,
    vector: &str,
    code: ProblemCode,
    place: &str,
    word: &str,
) {
    let outcome = analyze(&read_request(quaternion, vector, Convention::HAMILTON));
    let Outcome::Problems(found) = outcome else {
        panic!("{text} is read: {outcome:?}")
    };
    let [problem] = &found.problems[..] else {
        panic!("{text}: {found:?}")
    };
    assert_eq!(problem.code, code, "{text}");
    let span = problem.span;
    assert_eq!(&text[span.start..span.end], place, "{text}");
    let said = format!("{}; {}", problem.message, problem.hint);
    assert!(said.contains(word), "{text}: {said}");
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
