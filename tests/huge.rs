//! Texts of ten megabytes are measured before anything is done with them. Native only: it needs a clock.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::read_request;
use quatlas::{
    ComposeRequest, Convention, Endpoint, IdentifyRequest, MatrixLayout, Outcome, Probe,
    ProblemCode, Request, TranslateRequest, analyze,
};
use std::time::{Duration, Instant};

const BYTES: usize = 10_000_000;

/// Where every byte is looked at, even once, it takes more in an unoptimised build: tens of
/// milliseconds up to minutes.
const AT_ONCE: Duration = Duration::from_millis(30);

const TRIES: usize = 4;

fn huge(pattern: &str) -> String {
    pattern.repeat(BYTES / pattern.len())
}

/// The quickest of a few answers: another process may have the processor meanwhile.
fn time(request: &Request) -> Duration {
    let took = (0..TRIES).map(|_| {
        let asked = Instant::now();
        let _ = analyze(request);
        asked.elapsed()
    });
    took.min().expect("some tries")
}

/// The codes of the problems of an answer that comes at once.
#[track_caller]
fn codes(request: &Request) -> Vec<ProblemCode> {
    let took = time(request);
    assert!(took < AT_ONCE, "{took:?}");
    match analyze(request) {
        Outcome::Problems(found) => found.problems.iter().map(|problem| problem.code).collect(),
        _ => Vec::new(),
    }
}

/// Numbers, spaces, brackets, wrappers of consoles, frames, signs and characters of four bytes.
const PATTERNS: [&str; 9] = ["1 ", " ", " [", "a(9) [", "─ ", "-", "1,", "🙂", "cos(45) "];

#[test]
fn read_and_compose_answer_a_huge_text_at_once() {
    for pattern in PATTERNS {
        let text = huge(pattern);
        let long = ProblemCode::TextTooLong;
        let request = read_request(&text, &text, Convention::HAMILTON);
        assert_eq!(codes(&request), [long; 2], "{pattern:?}");
        let request = ComposeRequest::new(&text, &text, &text, Convention::JPL);
        assert_eq!(codes(&Request::Compose(request)), [long; 3], "{pattern:?}");
    }
}

#[test]
fn translate_answers_a_huge_text_at_once() {
    for pattern in PATTERNS {
        let text = huge(pattern);
        let request = |quaternion: &str, from: &str| {
            TranslateRequest::new(
                quaternion,
                Endpoint::library(from),
                Endpoint::library("drake"),
            )
        };
        assert_eq!(
            codes(&Request::Translate(request(&text, "eigen"))),
            [ProblemCode::TextTooLong]
        );
        assert_eq!(
            codes(&Request::Translate(request("1 0 0 0", &text))),
            [ProblemCode::UnknownLibrary]
        );
        let mut of_axes = request("1 0 0 0", "eigen");
        of_axes.world_axes.clone_from(&text);
        of_axes.body_axes = text;
        assert_eq!(
            codes(&Request::Translate(of_axes)),
            [ProblemCode::UnknownAxes; 2]
        );
    }
}

#[test]
fn identify_answers_huge_texts_as_soon_as_short_ones() {
    let with = |text: &str| {
        let text = || text.to_owned();
        let observations = vec![
            Probe::Components {
                quaternion: text(),
                printed: text(),
            },
            Probe::Rotate {
                quaternion: text(),
                vector: text(),
                printed: text(),
            },
            Probe::FromMatrix {
                matrix: text(),
                layout: MatrixLayout::AsWritten,
                printed: text(),
            },
            Probe::Matrix {
                quaternion: "1 0 0 0".to_owned(),
                layout: MatrixLayout::AsWritten,
                printed: text(),
            },
        ];
        Request::Identify(IdentifyRequest::new(observations))
    };
    let of_short_texts = time(&with("oops"));
    for pattern in PATTERNS {
        let took = time(&with(&huge(pattern)));
        let most = 2 * of_short_texts + AT_ONCE;
        assert!(took < most, "{pattern:?}: {took:?} for {of_short_texts:?}");
    }
}
