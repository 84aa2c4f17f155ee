//! Texts of ten megabytes are measured before anything is done with them: not even the white space around
//! them is looked for. Where each of their bytes is looked at, an unoptimised build takes minutes here. Native
//! only, for their size.

use crate::asked::read_request;
use quatlas::{
    ComposeRequest, Convention, Endpoint, IdentifyRequest, MatrixLayout, ObservationReport,
    Outcome, Probe, ProblemCode, Request, Span, TranslateRequest, analyze,
};

const BYTES: usize = 10_000_000;

fn huge(pattern: &str) -> String {
    pattern.repeat(BYTES / pattern.len())
}

/// The problems of a request: their codes, of which each points at its whole text.
#[track_caller]
fn codes(request: &Request, texts: &[&str]) -> Vec<ProblemCode> {
    let Outcome::Problems(found) = analyze(request) else {
        return Vec::new();
    };
    for (problem, text) in found.problems.iter().zip(texts) {
        assert_eq!(problem.span, Span::from(0..text.len()));
    }
    found.problems.iter().map(|problem| problem.code).collect()
}

/// Numbers, spaces, brackets, wrappers of consoles, frames, signs and characters of four bytes.
const PATTERNS: [&str; 9] = ["1 ", " ", " [", "a(9) [", "─ ", "-", "1,", "🙂", "cos(45) "];

#[test]
fn read_and_compose_answer_a_huge_text() {
    for pattern in PATTERNS {
        let text = huge(pattern);
        let long = ProblemCode::TextTooLong;
        let request = read_request(&text, &text, Convention::HAMILTON);
        assert_eq!(codes(&request, &[&text[..]; 2]), [long; 2], "{pattern:?}");
        let request = ComposeRequest::new(&text, &text, &text, Convention::JPL);
        assert_eq!(
            codes(&Request::Compose(request), &[&text[..]; 3]),
            [long; 3],
            "{pattern:?}"
        );
    }
}

#[test]
fn translate_answers_a_huge_text() {
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
            codes(&Request::Translate(request(&text, "eigen")), &[&text]),
            [ProblemCode::TextTooLong]
        );
        assert_eq!(
            codes(&Request::Translate(request("1 0 0 0", &text)), &[&text]),
            [ProblemCode::UnknownLibrary]
        );
        let mut of_axes = request("1 0 0 0", "eigen");
        of_axes.world_axes.clone_from(&text);
        of_axes.body_axes.clone_from(&text);
        assert_eq!(
            codes(&Request::Translate(of_axes), &[&text[..]; 2]),
            [ProblemCode::TextTooLong; 2]
        );
    }
}

#[test]
fn identify_answers_huge_texts() {
    for pattern in PATTERNS {
        let text = huge(pattern);
        let observations = vec![
            Probe::Components {
                quaternion: text.clone(),
                printed: text.clone(),
            },
            Probe::Rotate {
                quaternion: "1 0 0 0".to_owned(),
                vector: text.clone(),
                printed: text.clone(),
            },
            Probe::FromMatrix {
                matrix: text.clone(),
                layout: MatrixLayout::AsWritten,
                printed: text.clone(),
            },
            Probe::Matrix {
                quaternion: "1 0 0 0".to_owned(),
                layout: MatrixLayout::AsWritten,
                printed: text.clone(),
            },
        ];
        let request = Request::Identify(IdentifyRequest::new(observations));
        let Outcome::Identify(report) = analyze(&request) else {
            panic!("{pattern:?} is not identified");
        };
        for observation in report.observations {
            let ObservationReport::Problem(refused) = observation else {
                panic!("{pattern:?} is no problem: {observation:?}");
            };
            assert_eq!(refused.problem.code, ProblemCode::TextTooLong);
            assert_eq!(refused.problem.span, Span::from(0..text.len()));
        }
    }
}
