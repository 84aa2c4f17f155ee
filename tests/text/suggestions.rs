//! What is offered to be written in place of a text, and where nothing is: no click changes a number
//! or chooses between two readings.

use crate::checked::{check_none_offered, check_offered, check_read, problem};
use quatlas::{Field, Remedy};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn a_mark_that_may_tell_something_is_not_removed() {
    check_none_offered(
        Field::Quaternion,
        &[
            // Dashes of every kind may be a minus.
            "0.6 0 — 0.8 0",
            "0.6 0 ‒ 0.8 0",
            "0.6 0 ― 0.8 0",
            "0.6 0 ‐ 0.8 0",
            "0.6 0 ⁻ 0.8 0",
            "0.6 0 ─ 0.8 0",
            "0.6 0 ➖ 0.8 0",
            "— 0.6 0 0.8 0",
            // What acts on the numbers, or says how sure they are.
            "~ [0.92, 0, 0, 0.38]",
            "! [0.92, 0, 0, 0.38]",
            "¬ 0.6 0 0.8 0",
            "∼ (0.6, 0, 0.8, 0)",
            "[0.92, 0, 0, 0.38] '",
            "[0.92, 0, 0, 0.38] ^",
            "[0.92, 0, 0, 0.38] †",
            "[0.92, 0, 0, 0.38] ⁻¹",
            "± 0.6 0 0.8 0",
            "∓ 0.6 0 0.8 0",
            "‖ 0.6 0 0.8 0 ‖",
            "∂ 0.6 0 0.8 0",
            "Δ 0.6 0 0.8 0",
            // What stands for a number that is left out, or was lost.
            "0.6 0 ? 0.8 0",
            "0.6 0 … 0.8 0",
            "0.6 0 \u{fffd} 0.8 0",
            "0.6 0 _ 0.8 0",
            // A minus behind its number.
            "0.6 0 0 0.8-",
            "0.6 0 0 0.8 -",
            "0.6 0- 0.8 0",
        ],
    );
    check_offered(&[
        ("• 0.6 0 0.8 0", Remedy::RemoveMark, "0.6 0 0.8 0"),
        ("→ [0.6, 0, 0.8, 0]", Remedy::RemoveMark, "[0.6, 0, 0.8, 0]"),
        ("0.6 & 0 & 0.8 & 0", Remedy::RemoveMark, "0.6  0  0.8  0"),
        ("| -0.6 0 0.8 0 |", Remedy::RemoveMark, "-0.6 0 0.8 0"),
        ("🙂 0.6 0 0.8 0", Remedy::RemoveMark, "0.6 0 0.8 0"),
        ("🤖 0.6 0 0.8 0", Remedy::RemoveMark, "0.6 0 0.8 0"),
        ("0.6 + 0.8j *", Remedy::RemoveMark, "0.6 + 0.8j"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_sign_is_added_or_joined_only_where_no_other_stands() {
    check_none_offered(
        Field::Quaternion,
        &[
            "- 0.5 + 0.5i\n- 0.5j - 0.5k",
            "- 0.6\n- 0.8k",
            "0.6 (0.8k)",
            "0.6, (0.8k)",
            "- 0.6 0 0.8 0",
            "( - 0.6 0 0.8 0)",
            "q = - 0.6 0 0.8 0",
            "[0.6 0; - 0.8 0",
            "0.6 -- 0.8 0 0",
            "0.6 --0.8 0 0",
            "+- 0.6 0 0.8 0",
        ],
    );
    check_offered(&[
        ("0.6 0.8k", Remedy::AddSign, "0.6 + 0.8k"),
        ("0.6 - 0.8 0 0", Remedy::AttachSign, "0.6 -0.8 0 0"),
        ("ZYX 30 − 20 10", Remedy::AttachSign, "ZYX 30 −20 10"),
        (
            "0.5000-0.5000 0.5000 0.5000",
            Remedy::SeparateNumbers,
            "0.5000 -0.5000 0.5000 0.5000",
        ),
        (
            "5.0E-01−5.0E-01-5.0E-01 0.5",
            Remedy::SeparateNumbers,
            "5.0E-01 −5.0E-01 -5.0E-01 0.5",
        ),
        (
            "-0.5-0.5-0.5-0.5",
            Remedy::SeparateNumbers,
            "-0.5 -0.5 -0.5 -0.5",
        ),
    ]);
    // Apart they would be five numbers, or three.
    check_none_offered(
        Field::Quaternion,
        &["12.5 0.5000-0.5000 0.5000 0.5000", "0.5-0.5 0.5"],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_bracket_is_mended_where_it_encloses_a_list() {
    check_none_offered(
        Field::Quaternion,
        &[
            // Two numbers would become one.
            "0 0 0 1)0",
            "1e30)0 0 0 1",
            "0.5 0.5 0.5]5",
            "5)e3 0 0 0",
            // A sign would be joined to a number.
            "0.6 0 0.8 -)1",
            "0.6 0 -)0.8 0",
            // What was enclosed is not known.
            "2*(0.5 + 0.5i + 0.5j",
            "-(0.5 + 0.5i + 0.5j",
            "0.5 - (0.5i + 0.5j",
            "√(0.25 + 0.5i + 0.5j",
            "(1 + i + j + k/2",
            "2*1 + k)",
            "-0.5 + 0.5i)",
            "0.5 + 0.5i) * 2",
            "1 + k) / 2",
        ],
    );
    check_offered(&[
        ("(0.6, 0, 0.8, 0", Remedy::MatchBrackets, "(0.6, 0, 0.8, 0)"),
        ("0.6 0 0.8 0)", Remedy::MatchBrackets, "0.6 0 0.8 0"),
        ("0.6 + 0.8j)", Remedy::MatchBrackets, "0.6 + 0.8j"),
        (
            "(1/√2, 0, 0, 1/√2",
            Remedy::MatchBrackets,
            "(1/√2, 0, 0, 1/√2)",
        ),
        ("(0.6 + 0.8j", Remedy::MatchBrackets, "(0.6 + 0.8j)"),
        // What is open there closes there: the vector, and not all.
        (
            "[[0.1, 0.2, 0.3), 0.9]",
            Remedy::MatchBrackets,
            "[[0.1, 0.2, 0.3], 0.9]",
        ),
        (
            "{[0.9, (0.1, 0.2, 0.3}]}",
            Remedy::MatchBrackets,
            "{[0.9, (0.1, 0.2, 0.3)]}",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn six_places_are_mended_and_no_more() {
    let opened = |count: usize| format!("{}0.6, 0, 0.8, 0", "[".repeat(count));
    for count in 1..=6 {
        let closed = format!("{}{}", opened(count), "]".repeat(count));
        check_offered(&[(&opened(count), Remedy::MatchBrackets, &closed)]);
    }
    check_none_offered(Field::Quaternion, &[&opened(7)]);
    check_offered(&[(
        "0.5 0.5i 0.5j 0.5k",
        Remedy::AddSign,
        "0.5 + 0.5i + 0.5j + 0.5k",
    )]);
    // Nor is another problem mended as the first one is: no word and no bracket becomes a zero.
    check_none_offered(
        Field::Quaternion,
        &["1e-999 0.6 0.8 foo", "1e-999 0.6 0 (0.8"],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn texts_up_to_four_kilobytes_are_mended() {
    let padded = |length: usize| {
        let numbers = "0.6, 0, 0.8, 0]";
        format!("{}{numbers}", " ".repeat(length - numbers.len()))
    };
    for length in [20, 500, 4096] {
        let offered = problem(Field::Quaternion, &padded(length)).suggestion;
        assert!(offered.is_some(), "{length} bytes");
    }
    check_none_offered(Field::Quaternion, &[&padded(4097)]);
}

#[wasm_bindgen_test(unsupported = test)]
fn only_numbers_have_a_rotation_part() {
    // A translation beside the rotation is told.
    check_read(&[
        ("0 -1 0 5\n1 0 0 6\n0 0 1 7\n0 0 0 1.0", "90deg about z"),
        ("[0 -1 0 5 1 0 0 6 0 0 1 7]", "90deg about z"),
        (
            "0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, -0.0, 0, 0, 1",
            "90deg about z",
        ),
        // For row vectors: it stands in the last row.
        ("0 -1 0 0\n1 0 0 0\n0 0 1 0\n5 6 7 1", "-90deg about z"),
    ]);
    check_none_offered(
        Field::Quaternion,
        &[
            // The last row is not that of a pose.
            "0 -1 0 5\n1 0 0 6\n0 0 1 7\n0 0 0.5 1",
            "0 -1 0 5\n1 0 0 6\n0 0 1 7\n1 0 0 1",
            "0 -1 0 5\n1 0 0 6\n0 0 1 7\n0 0 0 2",
            // A rotation and then a translation.
            "0 -1 0 1 0 0 0 0 1 0 0 0",
            // Either: a quarter turn about x and then a translation, or no turn; also where it is rounded.
            "1 0 0 0 0 1 0 -1 0 0 1 5",
            "1 0 0 0 0 1 0 -0.99 0 0 1 5",
            // A computed number.
            "0 -1 0 -(5) 1 0 0 6 0 0 1 7",
            // Words that happen to be as many.
            "0.92 0.1 -0.2 0.38 5 % w x y z and some seconds",
            "0 -1 0 5 1 0 0 6 0 0 1 a",
            "0.5-0.5 0 0 5 1 0 0 6 0 0 1 7",
        ],
    );
    check_none_offered(
        Field::Vector,
        &[
            "0.92 0.1 -0.2 0.38 % w x y z as MATLAB comments",
            "0 -1 0 5 1 0 0 6 0 0 1 7",
            "0 -1 0 5\n1 0 0 6\n0 0 1 7\n0 0 0 1",
        ],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_comma_or_a_space_that_may_part_thousands_is_left() {
    check_none_offered(
        Field::Quaternion,
        &[
            "1,000 0 0 2,000",
            "1\u{a0}000 0 0 0",
            "0.707\u{202f}107 0 0 0.707",
            "1\u{200b}0 0 0",
        ],
    );
    check_offered(&[
        ("0,707 0 0 0,707", Remedy::DecimalPoints, "0.707 0 0 0.707"),
        ("1,25 0 0 2,000", Remedy::DecimalPoints, "1.25 0 0 2.000"),
        (
            "0.6\u{a0}0\u{a0}0.8\u{a0}0",
            Remedy::PlainCharacters,
            "0.6 0 0.8 0",
        ),
        (
            "０．６ ０ －０．８ ０",
            Remedy::PlainCharacters,
            "0.6 0 -0.8 0",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn no_zero_of_a_suggestion_has_a_sign() {
    // A mirror image of a quarter turn about z: x is turned round, and its zeros with it.
    for text in [
        "0 -1 0; -1 0 0; 0 0 1",
        "-1 0 0\n0 1 0\n0 0 1",
        "-0 0 -0 0 0 0 -0 0 -0",
    ] {
        let problem = problem(Field::Quaternion, text);
        let suggestion = problem.suggestion.expect(text);
        let zeros = suggestion.text.split_whitespace();
        assert!(zeros.clone().any(|number| number == "0"), "{text}");
        assert!(
            zeros.clone().all(|number| number != "-0"),
            "{}",
            suggestion.text
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_nearest_rotation_is_offered_up_to_a_distance_of_1() {
    // Sheared alike in y and z, the nearest rotation is the identity, √2 times the number away.
    let sheared = |entry: &str| format!("1 0 0\n0 1 {entry}\n0 {entry} 1");
    for near in ["0.2", "0.7", "0.7071"] {
        let offered = problem(Field::Quaternion, &sheared(near)).suggestion;
        let offered = offered.map(|suggestion| suggestion.remedy);
        assert_eq!(offered, Some(Remedy::NearestRotation), "{near}");
    }
    for far in ["0.7072", "0.9"] {
        check_none_offered(Field::Quaternion, &[&sheared(far)]);
    }
}

/// However far the nearest rotation is: columns that are those of a rotation, each times a length, are no noise.
#[wasm_bindgen_test(unsupported = test)]
fn columns_of_other_lengths_are_divided_by_them() {
    for stretched in ["0 -1 0\n1 0 0\n0 0 2.01", "0 -7 0\n0.02 0 0\n0 0 3"] {
        let found = problem(Field::Quaternion, stretched);
        assert!(
            found.message.contains("those of a rotation times"),
            "{}",
            found.message
        );
        let suggestion = found.suggestion.expect("a suggestion");
        assert_eq!(suggestion.text, "0 -1 0\n1 0 0\n0 0 1");
    }
}

/// A dash stays a minus or the mark of an item, a number stays out of comments, and `q*` is a conjugate.
#[wasm_bindgen_test(unsupported = test)]
fn no_layout_of_a_text_becomes_another() {
    check_none_offered(
        Field::Quaternion,
        &[
            "0.51 -0.52 # e\n- 9\n0.53 -0.54",
            "]- 0.51\n- -0.52\n- 0.53\n- -0.54",
            "- 0.51)\n- -0.52\n- 0.53\n0.54)- ",
            "[0.92, 0, 0, 0.38]*",
            "0.92 - 0.38 k*",
        ],
    );
}
