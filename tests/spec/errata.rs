//! Errata of the literature: every printed statement fails, every corrected one holds, and the
//! printed ones are transcribed to the letter (numbers of the specification, sections 4.1 and 6).

use crate::rows::row_major;
use crate::support::assert_close;
use quatlas::errata::{CORRECTED_TOLERANCE, Sides};
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{Erratum, SourceDocument, Witness, errata};
use serde_json::Value;
use std::collections::BTreeSet;
use wasm_bindgen_test::wasm_bindgen_test;

/// No printed statement is wrong by less than this: far above every rounding.
const PRINTED_ERROR: f64 = 0.05;

/// Numbers that the specification tells with all digits.
const FULL: f64 = 4e-15;

fn witness(number: u8) -> Witness {
    let found = errata().into_iter().find(|each| each.number == number);
    found.expect("one of the 27").witness
}

fn printed(number: u8) -> Sides {
    witness(number).printed
}

/// The first nine numbers of a side.
fn matrix(numbers: &[f64]) -> Matrix3<f64> {
    Matrix3::from_row_slice(&numbers[..9])
}

/// A matrix of a golden case, row by row.
fn golden(case: &str, name: &str) -> Vec<f64> {
    let file: Value = serde_json::from_str(include_str!("../vectors/golden.json")).expect("JSON");
    let cases = file["cases"].as_array().expect("a list");
    let found = cases.iter().find(|value| value["id"] == case);
    let rows: [[f64; 3]; 3] =
        serde_json::from_value(found.expect(case)["output"][name].clone()).expect("a matrix");
    rows.concat()
}

/// The angle of the turn between two rotation matrices.
fn angle_between(left: &[f64], right: &[f64]) -> f64 {
    let turn = matrix(left).transpose() * matrix(right);
    ((turn.trace() - 1.0) / 2.0).acos()
}

#[wasm_bindgen_test(unsupported = test)]
fn there_are_27_in_the_order_of_their_numbers_and_documents() {
    let all = errata();
    let numbers: Vec<u8> = all.iter().map(|erratum| erratum.number).collect();
    assert_eq!(numbers, (1..=27).collect::<Vec<u8>>());
    let ids: BTreeSet<&str> = all.iter().map(|erratum| erratum.id).collect();
    assert_eq!(ids.len(), 27, "{ids:?}");
    let counts = SourceDocument::ALL.map(|document| {
        let of_it = |erratum: &&Erratum| erratum.document == document;
        all.iter().filter(of_it).count()
    });
    assert_eq!(counts, [9, 2, 9, 7]);
    // The ids begin with the number of the document.
    let prefixes = ["000-", "002-", "003-", "004-"];
    for erratum in &all {
        let place = SourceDocument::ALL
            .iter()
            .position(|it| *it == erratum.document);
        let prefix = prefixes[place.expect("one of four")];
        assert!(erratum.id.starts_with(prefix), "{}", erratum.id);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_printed_statement_fails() {
    for Erratum { id, witness, .. } in errata() {
        assert!(
            witness.printed_error >= PRINTED_ERROR && witness.printed_error.is_finite(),
            "{id}: {witness:?}"
        );
        assert_eq!(witness.printed.left.len(), witness.printed.right.len());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_corrected_statement_holds() {
    for Erratum { id, witness, .. } in errata() {
        assert!(
            witness.corrected_error <= CORRECTED_TOLERANCE,
            "{id}: {witness:?}"
        );
        assert_eq!(witness.corrected.left.len(), witness.corrected.right.len());
        assert!(!witness.corrected.left.is_empty(), "{id}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_text_is_one_line_and_every_reason_one_sentence() {
    for erratum in errata() {
        let texts = [
            erratum.place,
            erratum.printed,
            erratum.reason,
            erratum.correct,
            erratum.witness.example,
        ];
        for text in texts {
            let is_tidy = !text.is_empty() && !text.contains('\n') && !text.contains("  ");
            assert!(is_tidy, "{}: {text:?}", erratum.id);
        }
        assert_ne!(erratum.printed, erratum.correct, "{}", erratum.id);
        assert!(erratum.reason.ends_with('.'), "{}", erratum.reason);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_erratum_crosses_with_camel_case_and_without_minus_zero() {
    let all = serde_json::to_value(errata().to_vec()).expect("JSON");
    let first = &all[0];
    assert_eq!(first["document"], "cheng2018");
    assert_eq!(all[11]["document"], "me495-lecture");
    assert_eq!(first["witness"]["printedError"], 2.0);
    assert!(!all.to_string().contains("-0.0,"), "{all}");
}

#[wasm_bindgen_test(unsupported = test)]
fn e1_and_e13_make_a_unit_its_own_opposite() {
    let k = [0.0, 0.0, 0.0, 1.0];
    let minus_k = [0.0, 0.0, 0.0, -1.0];
    // ji = −ji, −ji = k.
    assert_eq!(printed(1).left, [k, minus_k].concat());
    assert_eq!(printed(1).right, [minus_k, k].concat());
    let j = [0.0, 0.0, 1.0, 0.0];
    let minus_j = [0.0, 0.0, -1.0, 0.0];
    assert_eq!(printed(13).left, [j, minus_j].concat());
    assert_eq!(printed(13).right, [minus_j, j].concat());
}

#[wasm_bindgen_test(unsupported = test)]
fn e2_the_printed_conjugate_squares_the_quaternion() {
    assert_close(
        "E2",
        &printed(2).left,
        &[0.28, 0.32, 0.64, 0.64],
        CORRECTED_TOLERANCE,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn e3_after_a_turn_the_quaternion_is_two_away_and_after_two_turns_it_is_back() {
    let Sides { left, right } = printed(3);
    let distance = |places: std::ops::Range<usize>| -> f64 {
        let squares = places.map(|place| (left[place] - right[place]).powi(2));
        squares.sum::<f64>().sqrt()
    };
    assert_close("E3", &[distance(0..4), distance(4..8)], &[2.0, 0.0], FULL);
}

#[wasm_bindgen_test(unsupported = test)]
fn e4_e5_e25_and_e26_are_no_rotations() {
    let expected = golden("G30", "printed_qw2_minus_1");
    let transposed = matrix(&expected).transpose();
    for (number, expected) in [
        (4, expected.clone()),
        (25, expected),
        (5, row_major(&transposed)),
        (26, row_major(&transposed)),
    ] {
        let Sides { left, right } = printed(number);
        assert_close(&format!("E{number}"), &left, &expected, FULL);
        let (left, right) = (matrix(&left), matrix(&right));
        assert_close("determinant", &[left.determinant()], &[0.378432], FULL);
        let skewness = (left.transpose() * left - Matrix3::identity()).amax();
        assert!((skewness - 0.410).abs() < 5e-4, "{skewness}");
        let off = left - right + Matrix3::identity() * 0.64;
        assert!(off.amax() < FULL, "E{number}: off by w² I, {off}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn e6_e7_and_e8_double_the_error() {
    let error: f64 = Vector3::new(0.3, -0.2, 0.25).norm();
    for number in [6, 7] {
        let Sides { left, right } = printed(number);
        let angle = angle_between(&left, &right);
        assert_close(&format!("E{number}"), &[angle], &[2.0 * error], 1e-14);
        // The quaternions are those of the matrices: the scalar part of p* ⊙ q.
        let scalar: f64 = (9..13).map(|place| left[place] * right[place]).sum();
        assert_close(&format!("E{number}"), &[scalar], &[error.cos()], 1e-14);
    }
    let Sides { left, right } = printed(8);
    assert_close("E8", &left[..1], &[(error / 2.0).cos()], FULL);
    assert_close(
        "E8: its inverse",
        &[right[0], -right[1], -right[2], -right[3]],
        &left,
        FULL,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn e9_the_listing_of_appendix_b_is_no_rotation() {
    let left = printed(9).left;
    assert_close("E9", &left, &golden("G30", "printed_appendix_B"), FULL);
    let left = matrix(&left);
    let determinant = left.determinant();
    assert!((determinant - 1.2417).abs() < 5e-5, "{determinant}");
    let skewness = (left.transpose() * left - Matrix3::identity()).amax();
    assert!((skewness - 0.512).abs() < 5e-4, "{skewness}");
}

#[wasm_bindgen_test(unsupported = test)]
fn e10_moves_a_rig_that_is_at_rest() {
    let left = printed(10).left;
    assert_close("E10 at rest", &left[..3], &[1.0, -1.0, 0.0], FULL);
    // Case G29 of the specification, `p_GI2_as_printed` and `p_GI2_corrected`.
    assert_close(
        "E10 moving",
        &left[3..],
        &[1.3602213926648317, 0.9836788533843599, 2.811299707102605],
        FULL,
    );
    let corrected = witness(10).corrected.left;
    assert_close(
        "E10 corrected",
        &corrected,
        &[0.0, 0.0, 0.0, 1.5, 1.0, 2.5],
        FULL,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn e11_the_matrix_of_the_rate_is_that_of_equation_10() {
    // Case G31 of the specification, `OmegaH_q`.
    let expected = [-2.2, 1.2, 1.4, 2.4];
    assert_close("E11", &witness(11).corrected.left, &expected, FULL);
    // The closest of the five other readings takes all arrays scalar-first.
    assert_close("E11", &printed(11).left, &expected, FULL);
}

#[wasm_bindgen_test(unsupported = test)]
fn e12_columns_of_length_1_without_a_determinant() {
    let Sides { left, right } = printed(12);
    assert_close("E12", &left, &[1.0, 1.0, 1.0, 0.0], FULL);
    assert_eq!(right, [1.0; 4]);
}

#[wasm_bindgen_test(unsupported = test)]
fn e14_the_printed_matrix_turns_the_vector() {
    let Sides { left, right } = printed(14);
    let direction = |side: &[f64]| side[1].atan2(side[0]);
    let of_p = 1.0_f64.atan2(2.0);
    assert_close("E14", &[direction(&left)], &[of_p + 0.5], FULL);
    assert_close("E14", &[direction(&right)], &[of_p - 0.5], FULL);
}

#[wasm_bindgen_test(unsupported = test)]
fn e15_the_one_sided_product_is_as_long_and_no_vector() {
    // −q·p.
    assert_close("E15", &printed(15).left, &[-2.2], FULL);
    let length = witness(15).corrected.left[0];
    assert_close("E15", &[length], &[14.0_f64.sqrt()], FULL);
}

#[wasm_bindgen_test(unsupported = test)]
fn e16_a_quaternion_and_its_opposite() {
    assert_eq!(printed(16).left, [0.8, 0.2, 0.4, 0.4]);
    assert_eq!(printed(16).right, [-0.8, -0.2, -0.4, -0.4]);
}

#[wasm_bindgen_test(unsupported = test)]
fn e17_a_matrix_with_a_column_of_zeros() {
    assert_eq!(printed(17).left, [0.0; 4]);
    assert_close("E17", &printed(17).right, &[0.0, 0.0, 1.0, 1.0], FULL);
}

#[wasm_bindgen_test(unsupported = test)]
fn e18_the_printed_product_leads_to_y_and_not_to_x() {
    let Sides { left, right } = printed(18);
    assert_close("E18", &left, &[0.0, 0.0, 1.0, 0.0], FULL);
    assert_eq!(right, [0.0, 1.0, 0.0, 0.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn e19_four_matrices_that_are_no_rotations_are_accepted() {
    assert_eq!(printed(19).left, [1.0; 5]);
    assert_eq!(printed(19).right, [1.0, 0.0, 0.0, 0.0, 0.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn e20_half_a_turn_comes_back_as_none() {
    let Sides { left, right } = printed(20);
    assert_close("E20 within its range", &left[..9], &right[..9], 1e-14);
    assert_eq!(matrix(&left[9..]), Matrix3::identity());
    assert_close("E20", &[matrix(&right[9..]).trace()], &[-1.0], FULL);
}

#[wasm_bindgen_test(unsupported = test)]
fn e21_of_27_strings_15_are_no_sequences() {
    assert_eq!(printed(21).left, [27.0]);
    assert_eq!(printed(21).right, [12.0]);
    assert_eq!(witness(21).corrected.left, [12.0, 24.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn e22_the_printed_line_holds_where_the_two_directions_differ() {
    let Sides { left, right } = printed(22);
    assert!(left[0] >= right[0], "dist(a, b) ≥ dist(b, a)");
    assert_eq!((left[0], right[0]), (2.0, 1.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn e23_the_printed_chain_adds_the_first_rotation_once_more() {
    let Sides { left, right } = printed(23);
    let first: f64 = Vector3::new(0.4, -0.7, 1.1).norm();
    assert_close("E23", &[angle_between(&left, &right)], &[first], 1e-14);
}

#[wasm_bindgen_test(unsupported = test)]
fn e24_the_sum_of_two_quarter_turns_is_not_their_composition() {
    let Sides { left, right } = printed(24);
    // By π/√2 about the line between x and y.
    let angle = std::f64::consts::PI / 2.0_f64.sqrt();
    let (sine, cosine) = angle.sin_cos();
    let last_row = [-sine / 2.0_f64.sqrt(), sine / 2.0_f64.sqrt(), cosine];
    assert_close("E24", &left[6..], &last_row, FULL);
    assert_close("E24", &[matrix(&left).trace()], &[1.0 + 2.0 * cosine], FULL);
    // First about y, z goes to x and stays there; x goes to −z and on to y.
    let composed = [0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    assert_close("E24", &right, &composed, FULL);
}

#[wasm_bindgen_test(unsupported = test)]
fn e27_four_numbers_move_in_three_directions() {
    assert_eq!(printed(27).left, [4.0]);
    assert_eq!(printed(27).right, [3.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn every_document_is_cited_by_its_title() {
    for (document, title) in [
        (SourceDocument::Cheng2018, "Standardised Use of Quaternion"),
        (
            SourceDocument::Yoosefian2021,
            "A Concise Note on Coordinate",
        ),
        (
            SourceDocument::Me495Lecture,
            "Quaternions and More Geometry",
        ),
        (SourceDocument::FieldGuide, "A Robotics Field Guide"),
    ] {
        assert!(document.citation().contains(title), "{document:?}");
    }
}
