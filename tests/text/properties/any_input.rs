//! What must hold for every input, tried on many: native only, with a fixed seed.

use crate::asked::read_request;
use crate::properties::answered::check;
use crate::properties::corpus::PIECES;
use crate::property::for_all;
use crate::support::all_conventions;
use proptest::prelude::*;
use quatlas::{
    ComposeRequest, Field, Outcome, ProblemCode, Request, Rotation, TaggedQuaternion, analyze,
};

const CASES: u32 = 2000;

/// Pieces in any order.
fn typed() -> impl Strategy<Value = String> {
    prop::collection::vec(prop::sample::select(PIECES), 0..14).prop_map(|pieces| pieces.concat())
}

#[test]
fn whatever_is_typed_gives_plain_numbers_or_a_problem_with_a_place() {
    for_all(CASES, (typed(), typed()), |(quaternion, vector)| {
        for convention in [quatlas::Convention::HAMILTON, quatlas::Convention::JPL] {
            check(&read_request(&quaternion, &vector, convention))?;
        }
        Ok(())
    });
}

#[test]
fn any_unicode_text_is_answered() {
    for_all(CASES, any::<String>(), |text| {
        check(&read_request(&text, &text, quatlas::Convention::HAMILTON))
    });
}

/// Marks, spaces and letters of one to four bytes, among numbers.
const MARKS: [&str; 52] = [
    "0",
    "1",
    "0.5",
    "-0.5",
    ".",
    " ",
    " ",
    " ",
    "\n",
    "\t",
    ", ",
    ";",
    "(",
    ")",
    "[",
    "]",
    "-",
    "---",
    "\n---",
    "- ",
    "─",
    "── ",
    " │ ",
    "┌",
    "└ ",
    "\n├─ ",
    "╱",
    "−",
    "—",
    "\u{a0}",
    "\u{200b}",
    "\u{202f}",
    "\u{ad}",
    "\u{feff}",
    "\u{202e}",
    "🙂",
    "四",
    "é",
    "\"│\"",
    "'─ x'",
    "# │\n",
    "w=",
    "ω:",
    "Float32Array(4) ",
    "Größe(4) ",
    "Mat3(9)\u{200b}[",
    "45°",
    "ZYX ",
    " about ",
    "rpy ",
    "cos(",
    "√",
];

fn marked() -> impl Strategy<Value = String> {
    prop::collection::vec(prop::sample::select(&MARKS[..]), 0..14)
        .prop_map(|pieces| pieces.concat())
}

#[test]
fn every_problem_points_at_whole_characters_and_names_what_it_points_at() {
    for_all(1500, (marked(), marked()), |(one, other)| {
        let requests = [
            read_request(&one, &other, quatlas::Convention::JPL),
            Request::Compose(ComposeRequest::new(
                &one,
                &other,
                "1 0 0",
                quatlas::Convention::JPL,
            )),
        ];
        for request in requests {
            let Outcome::Problems(found) = analyze(&request) else {
                continue;
            };
            for problem in found.problems {
                let text = match problem.field {
                    Field::Quaternion | Field::P => &one,
                    _ => &other,
                };
                let marked = text.get(problem.span.start..problem.span.end);
                prop_assert!(marked.is_some(), "{text:?}: {problem:?}");
                let marked = marked.unwrap_or_default();
                let names_it = marked.chars().next().is_some_and(|character| {
                    let code = format!("U+{:04X}", u32::from(character));
                    problem.message.contains(character) || problem.message.contains(&code)
                });
                let is_of_characters = problem.code == ProblemCode::UnexpectedCharacter;
                prop_assert!(
                    !is_of_characters || names_it || marked == ".",
                    "{text:?}: {problem:?}"
                );
            }
        }
        Ok(())
    });
}

/// Any double that is finite, of all sizes.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        -1.0..1.0_f64,
        prop::sample::select(vec![
            0.0,
            1.0,
            -1.0,
            0.5,
            f64::MAX,
            f64::MIN_POSITIVE,
            5e-324
        ]),
    ]
}

#[test]
fn any_four_finite_numbers_are_answered_in_plain_numbers() {
    for_all(
        CASES,
        (
            prop::array::uniform8(number()),
            prop::array::uniform3(number()),
        ),
        |(numbers, vector)| {
            let text = |numbers: &[f64]| {
                numbers
                    .iter()
                    .map(|number| format!("{number:e}"))
                    .collect::<Vec<_>>()
                    .join(", ")
            };
            let (p, q, vector) = (text(&numbers[..4]), text(&numbers[4..]), text(&vector));
            let convention = quatlas::Convention::JPL;
            check(&read_request(&p, &vector, convention))?;
            let request = Request::Compose(ComposeRequest::new(&p, &q, &vector, convention));
            check(&request)
        },
    );
}

#[test]
fn any_finite_numbers_of_any_description_are_answered_in_plain_numbers() {
    let descriptions = prop::sample::select(vec![
        ("axis-angle", 4),
        ("rotvec", 3),
        ("ZYX", 3),
        ("zxz", 3),
        ("rpy", 3),
        ("matrix", 9),
    ]);
    for_all(
        CASES,
        (descriptions, prop::array::uniform9(number())),
        |((name, count), numbers)| {
            let numbers: Vec<_> = numbers[..count].iter().map(|n| format!("{n:e}")).collect();
            let text = format!("{name} {}", numbers.join(", "));
            check(&read_request(&text, "1 2 3", quatlas::Convention::JPL))
        },
    );
}

#[test]
fn an_attitude_survives_every_convention() {
    for_all(
        CASES,
        prop::array::uniform4(-1.0..1.0_f64),
        |[w, x, y, z]| {
            // At half a turn the vector of q and that of −q are opposite, and both are right.
            prop_assume!(w != 0.0 && w * w + x * x + y * y + z * z > 1e-4);
            let canonical = TaggedQuaternion::new(w, x, y, z, quatlas::Convention::HAMILTON);
            let attitude = Rotation::from_tagged(&canonical)
                .map_err(|error| TestCaseError::fail(error.to_string()))?;
            for convention in all_conventions() {
                let tagged = attitude.to_tagged(convention);
                let back = Rotation::from_tagged(&tagged)
                    .map_err(|error| TestCaseError::fail(error.to_string()))?;
                prop_assert_eq!(back, attitude, "{}", convention);
                // −q is the same rotation.
                let opposite = TaggedQuaternion {
                    components: -tagged.components,
                    convention,
                };
                let opposite = Rotation::from_tagged(&opposite)
                    .map_err(|error| TestCaseError::fail(error.to_string()))?;
                prop_assert_eq!(opposite.body_to_world_matrix(), back.body_to_world_matrix());
                prop_assert_eq!(opposite.rotation_vector_rad(), back.rotation_vector_rad());
            }
            Ok(())
        },
    );
}
