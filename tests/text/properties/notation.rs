//! Marks that say nothing of the rotation change nothing, and words that say something are not dropped.

use crate::asked::read_request;
use crate::properties::written::written;
use crate::property::for_all;
use crate::turned::{angles, sequences, turned};
use proptest::prelude::*;
use quatlas::{Convention, Outcome, ReadReport, analyze};

const CASES: u32 = 500;

fn answer(text: &str) -> Outcome {
    analyze(&read_request(text, "1 2 3", Convention::HAMILTON))
}

fn read(text: &str) -> Result<ReadReport, TestCaseError> {
    match answer(text) {
        Outcome::Read(report) => Ok(*report),
        other => Err(TestCaseError::fail(format!("{text:?} gives {other:?}"))),
    }
}

fn check_same(one: &str, other: &str) -> Result<(), TestCaseError> {
    let [one, other] = [read(one)?, read(other)?];
    prop_assert_eq!(one.quaternion, other.quaternion);
    prop_assert_eq!(one.hamilton, other.hamilton);
    Ok(())
}

/// Refused, or read as something else.
fn check_other(one: &str, other: &str) -> Result<(), TestCaseError> {
    if let Outcome::Read(report) = answer(one) {
        prop_assert_ne!(report.quaternion, read(other)?.quaternion, "{}", one);
    }
    Ok(())
}

fn check_refused(text: &str) -> Result<(), TestCaseError> {
    let outcome = answer(text);
    prop_assert!(
        matches!(outcome, Outcome::Problems(_)),
        "{text:?} gives {outcome:?}"
    );
    Ok(())
}

/// The marks of a YAML document, with what may stand beside them.
#[test]
fn the_marks_of_a_document_change_nothing() {
    for_all(CASES, written(), |written| {
        let text = &written.text;
        for marked in [
            format!("---\n{text}"),
            format!("{text}\n---"),
            format!("{text}\n---\n"),
            format!("--- # as logged\n{text}"),
        ] {
            check_same(&marked, text)?;
        }
        if text.starts_with(['{', '[']) {
            check_same(&format!("--- {text}"), text)?;
        }
        Ok(())
    });
}

/// Dashes that touch a number are signs, however many.
#[test]
fn dashes_that_touch_a_number_are_not_dropped() {
    for_all(CASES, written(), |written| {
        let text = &written.text;
        let end = text.find(|mark: char| !"0123456789.e-".contains(mark));
        let first: Option<f64> = end.and_then(|end| text[..end].parse().ok());
        if first.is_none_or(|first| first == 0.0) {
            return Ok(());
        }
        check_other(&format!("---{text}"), text)
    });
}

#[test]
fn a_tab_after_the_dash_of_a_list_changes_nothing() {
    for_all(CASES / 5, (sequences(), angles()), |(sequence, angles)| {
        let q = turned(sequence, angles);
        let list = |mark: &str| {
            let numbers = [q.w, q.i, q.j, q.k].map(|number| format!("-{mark}{number:?}\n"));
            numbers.concat()
        };
        check_same(&list("\t"), &list(" "))
    });
}

/// Four numbers, three of a rotation vector, nine of a matrix; each in its brackets.
fn lists() -> impl Strategy<Value = (String, String, usize)> {
    (sequences(), angles()).prop_flat_map(|(sequence, angles)| {
        let q = turned(sequence, angles);
        let vector = q.scaled_axis();
        let matrix = q.to_rotation_matrix().into_inner().transpose();
        let list = |numbers: &[f64]| {
            let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
            numbers.join(", ")
        };
        let four = format!("[ {} ]", list(&[q.w, q.i, q.j, q.k]));
        let three = format!("[ {} ]", list(vector.as_slice()));
        let nine = format!("[ {} ]", list(matrix.as_slice()));
        prop::sample::select(vec![
            (String::new(), four, 4),
            ("rotvec ".to_owned(), three, 3),
            (String::new(), nine, 9),
        ])
    })
}

/// What consoles print before a list says how many numbers follow.
#[test]
fn the_name_and_count_of_a_console_change_nothing() {
    let names = ["Float32Array", "Float64Array", "Array"];
    for_all(
        CASES,
        (prop::sample::select(names.to_vec()), lists()),
        |(name, (before, list, count))| {
            check_same(
                &format!("{before}{name}({count}) {list}"),
                &format!("{before}{list}"),
            )
        },
    );
}

/// Whatever a call does to a list, or a name says of it, the list itself is not read for it.
#[test]
fn a_word_with_a_number_before_a_list_is_not_dropped() {
    let words = prop::sample::select(vec![
        "sqrt",
        "abs",
        "deg2rad",
        "transpose",
        "inv",
        "inverse",
        "conj",
        "conjugate",
        "column",
        "exp",
        "log",
        "q_xyzw",
        "axisangle",
        "left",
        "covariance",
        "neg",
        "T",
        "e",
    ]);
    for_all(
        CASES,
        (words, 2..100_u32, lists()),
        |(word, number, (before, list, _))| {
            let bare = format!("{before}{list}");
            // A factor of no turn is none.
            prop_assume!(read(&bare)?.turn.axis.is_some());
            check_other(&format!("{before}{word}({number}) {list}"), &bare)
        },
    );
}

/// A count that is not that of the numbers.
#[test]
fn a_console_that_counts_other_numbers_is_refused() {
    for_all(
        CASES / 5,
        (lists(), 0..20_usize),
        |((before, list, count), counted)| {
            if counted == count {
                return Ok(());
            }
            check_refused(&format!("{before}Float32Array({counted}) {list}"))
        },
    );
}

/// However small the angle is, its report is read back, in degrees too.
#[test]
fn a_turn_of_any_size_is_read_back() {
    let sizes = prop_oneof![
        (-323.0..0.4_f64).prop_map(|exponent| 10_f64.powf(exponent)),
        (1..100_u64).prop_map(f64::from_bits),
    ];
    for_all(CASES, (sizes, 0..3_usize), |(size, place)| {
        let mut vector = [0.0; 3];
        vector[place] = size;
        let turn = read(&format!("rotvec {vector:?}"))?.turn;
        let axis = turn.axis.unwrap_or([0.0, 0.0, 1.0]);
        for text in [
            format!("rotvec {:?}", turn.rotation_vector_rad),
            format!("axis-angle {axis:?} {:?} rad", turn.angle_rad),
            format!("axis-angle {axis:?} {:?} deg", turn.angle_deg),
            format!("{:?}° about {axis:?}", turn.angle_deg),
        ] {
            let again = read(&text)?.turn.rotation_vector_rad;
            // A few roundings, of the least doubles too.
            let allowed = (4.0 * f64::EPSILON * vector[place]).max(4.0 * 5e-324);
            let apart = (again[place] - vector[place]).abs();
            prop_assert!(apart <= allowed, "{text}: {again:?}");
        }
        Ok(())
    });
}
