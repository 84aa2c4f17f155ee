//! The names of the choices and of the problems: one in Rust, in JSON and on the page, and the other
//! words by which a choice is read.

use quatlas::{
    ComponentOrder, Convention, Direction, EulerAxes, EulerFrame, EulerSequence, Function,
    Handedness, Perturbation, ProblemCode, UnknownName,
};
use serde::Serialize;
use std::fmt::{Debug, Display};
use std::str::FromStr;
use strum::VariantNames;
use wasm_bindgen_test::wasm_bindgen_test;

fn in_json(value: impl Serialize) -> String {
    let json = serde_json::to_value(value).expect("JSON");
    json.as_str().expect("a name").to_owned()
}

/// Each value with its name, which is displayed and is that of JSON, and with the other words for it.
fn assert_names<Choice>(all: [Choice; 2], name: fn(Choice) -> &'static str, words: [&[&str]; 2])
where
    Choice: Copy + Debug + Display + PartialEq + Serialize + FromStr<Err = UnknownName>,
{
    for (choice, words) in all.into_iter().zip(words) {
        assert_eq!(name(choice), words[0]);
        assert_eq!(in_json(choice), words[0]);
        assert_eq!(choice.to_string(), words[0]);
        for word in words {
            let typed = [
                word.to_string(),
                word.to_uppercase(),
                format!(" \t{word}\n"),
            ];
            for text in typed {
                assert_eq!(text.parse(), Ok(choice), "{text:?}");
            }
        }
    }
    for unknown in ["", "w x", &words.concat().concat()] {
        let refused = unknown.parse::<Choice>().expect_err(unknown);
        let message = format!("{unknown:?} names no convention and no axis of one");
        assert_eq!(refused.to_string(), message);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_choice_has_one_name_and_is_read_by_all_its_words() {
    assert_names(
        ComponentOrder::ALL,
        ComponentOrder::name,
        [
            &["scalar-first", "wxyz", "w-first", "first"],
            &["scalar-last", "xyzw", "w-last", "last"],
        ],
    );
    assert_names(
        Handedness::ALL,
        Handedness::name,
        [
            &["right", "hamilton-product", "ij=k"],
            &["left", "shuster-product", "jpl-product", "ij=-k"],
        ],
    );
    assert_names(
        Function::ALL,
        Function::name,
        [&["passive", "alias"], &["active", "alibi"]],
    );
    assert_names(
        Direction::ALL,
        Direction::name,
        [
            &["body-to-world", "b2w", "local-to-global"],
            &["world-to-body", "w2b", "global-to-local"],
        ],
    );
    assert_names(
        Perturbation::ALL,
        Perturbation::name,
        [&["local", "body"], &["global", "world"]],
    );
}

/// A name is a constant, so that it can stand in one.
#[wasm_bindgen_test(unsupported = test)]
fn a_name_can_stand_in_a_constant() {
    const ORDER: &str = Convention::JPL.order.name();
    const CODE: &str = ProblemCode::OneSidedReflection.name();
    assert_eq!([ORDER, CODE], ["scalar-last", "one-sided-reflection"]);
}

#[wasm_bindgen_test(unsupported = test)]
fn frames_and_axes_of_euler_angles_have_the_names_of_json() {
    for frame in EulerFrame::ALL {
        assert_eq!(in_json(frame), frame.name());
    }
    assert_eq!(
        EulerFrame::ALL.map(EulerFrame::name),
        ["intrinsic", "extrinsic"]
    );
    for axes in EulerAxes::ALL {
        let fixed = EulerSequence {
            axes,
            frame: EulerFrame::Extrinsic,
        };
        let moving = EulerSequence {
            axes,
            frame: EulerFrame::Intrinsic,
        };
        assert_eq!(in_json(axes), fixed.to_string());
        assert_eq!(in_json(axes).to_uppercase(), moving.to_string());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_code_of_a_problem_has_the_name_of_json() {
    assert_eq!(ProblemCode::VARIANTS.len(), 45);
    for name in ProblemCode::VARIANTS {
        let code: ProblemCode = serde_json::from_value((*name).into()).expect(name);
        assert_eq!(code.name(), *name);
        assert_eq!(in_json(code), *name);
    }
}
