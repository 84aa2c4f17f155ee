//! What is asked of a library next, in numbers and as a line of code.

use crate::identify::{answer, identify};
use crate::simulated::every_probe;
use quatlas::{
    ComponentOrder, IdentifyRequest, Language, MatrixLayout, ObservationReport, Probe, ProbeKind,
};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn what_cannot_be_run_is_not_asked_again() {
    let mut request = IdentifyRequest::new(vec![]);
    let mut asked = Vec::new();
    while let Some(next) = answer(request.clone()).next {
        asked.push(next.probe.kind());
        request.unavailable.push(next.probe.kind());
    }
    assert_eq!(asked[0], ProbeKind::Product);
    assert_eq!(asked.len(), 7, "every kind once: {asked:?}");
}

/// A library that prints names has no printed order; what was answered is not asked again.
#[wasm_bindgen_test(unsupported = test)]
fn no_question_is_asked_twice() {
    let mut request = IdentifyRequest::new(vec![
        Probe::Product {
            a: "0 1 0 0".to_owned(),
            b: "0 0 1 0".to_owned(),
            printed: "Quaternion { x: 1, y: 0, z: 0, w: 0 }".to_owned(),
        },
        Probe::Components {
            quaternion: "0.1 0.5 0.5 0.7".to_owned(),
            printed: "{ x: 0.1, y: 0.5, z: 0.5, w: 0.7 }".to_owned(),
        },
    ]);
    request.unavailable = vec![
        ProbeKind::Rotate,
        ProbeKind::Matrix,
        ProbeKind::FromMatrix,
        ProbeKind::QuarterTurn,
        ProbeKind::Perturb,
    ];
    let report = answer(request);
    assert_eq!(report.remaining.constructor, [ComponentOrder::ScalarLast]);
    assert_eq!(report.remaining.array.len(), 2);
    assert_eq!(report.next, None);
}

/// What was printed is numbers: other descriptions of a rotation are not proposed.
#[wasm_bindgen_test(unsupported = test)]
fn problems_of_printed_numbers_ask_for_numbers() {
    let quarter_turn = |printed: &str| Probe::QuarterTurn {
        printed: printed.to_owned(),
    };
    let matrix = |printed: &str| Probe::Matrix {
        quaternion: "0.5 0.5 0.5 0.5".to_owned(),
        printed: printed.to_owned(),
        layout: MatrixLayout::Rows,
    };
    let probes = vec![
        quarter_turn("1 0 0"),
        quarter_turn("0 0 0 0"),
        quarter_turn("45deg about z"),
        matrix("1 0 0 1"),
        matrix("1 0 0, 0 1 0"),
    ];
    for (at, report) in identify(probes).observations.iter().enumerate() {
        let ObservationReport::Problem(found) = report else {
            panic!("{at}: {report:?}")
        };
        let expected = if at < 3 {
            "four numbers of a quaternion"
        } else {
            "nine numbers"
        };
        assert!(found.problem.expected.contains(expected), "{at}: {found:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_probe_is_a_line_of_code_in_every_language() {
    let code = |probe: &Probe, language| {
        let mut request = IdentifyRequest::new(vec![probe.clone()]);
        request.language = language;
        answer(request).codes.pop().expect("one")
    };
    let languages = [
        Language::C,
        Language::Cpp,
        Language::Csharp,
        Language::Java,
        Language::Javascript,
        Language::Matlab,
        Language::Message,
        Language::Python,
        Language::Rust,
        Language::Swift,
    ];
    for probe in every_probe() {
        for language in languages {
            let line = code(&probe, language).expect("plain numbers");
            let is_whole = ![
                "{n}", "{q}", "{a}", "{b}", "{v}", "{m}", "{e}", "{r1}", "{r2}", "{r3}",
            ]
            .iter()
            .any(|place| line.contains(place));
            assert!(is_whole, "{line}");
            let numbers: &[&str] = match probe.kind() {
                ProbeKind::QuarterTurn => &["+90 degrees"],
                ProbeKind::Product => &["0.1, 0.7, -0.5, 0.5", "0.8, 0.2, -0.4, 0.4"],
                ProbeKind::FromMatrix => &["0.36, -0.48, 0.8", "0.8, 0.6, 0", "-0.48, 0.64, 0.6"],
                _ => &["0.1, 0.7, -0.5, 0.5"],
            };
            for number in numbers {
                assert!(line.contains(number), "{line}");
            }
        }
    }
    let product = |a: &str| Probe::Product {
        a: a.to_owned(),
        b: "[0, 0, 1, 0]".to_owned(),
        printed: String::new(),
    };
    let expected = "println!(\"{:?}\", Quaternion::new(0.0, 1.0, 0.0, 0.0) * Quaternion::new(0.0, 0.0, 1.0, 0.0));";
    assert_eq!(
        code(&product("0 1 0 0"), Language::Rust).as_deref(),
        Some(expected)
    );
    for text in ["i", "nan 0 0 1", "0 0 inf 1"] {
        assert_eq!(code(&product(text), Language::Rust), None, "{text}");
    }
}

/// What was answered with names left the orders open: the same kind is asked again, with other numbers.
#[wasm_bindgen_test(unsupported = test)]
fn a_kind_is_asked_again_with_other_numbers_alone() {
    let product = |a: &str, b: &str, printed: &str| Probe::Product {
        a: a.to_owned(),
        b: b.to_owned(),
        printed: printed.to_owned(),
    };
    let mut request = IdentifyRequest::new(vec![product("i", "j", "k")]);
    request.unavailable = vec![
        ProbeKind::Components,
        ProbeKind::Rotate,
        ProbeKind::Matrix,
        ProbeKind::FromMatrix,
        ProbeKind::QuarterTurn,
        ProbeKind::Perturb,
    ];
    let next = answer(request.clone()).next.expect("the orders are open");
    assert!(next.probe.asks_the_same(&product("0 1 0 0", "0 0 1 0", "")));
    // Answered with names, the very same is not asked once more.
    request
        .observations
        .push(product("0 1 0 0", "0 0 1 0", "k"));
    let report = answer(request);
    assert_eq!(report.remaining.array.len(), 2);
    assert_eq!(report.next, None);
}
