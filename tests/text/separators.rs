//! What separates numbers and what only seems to: decimal commas, semicolons, fractions, indices.

use crate::asked::{AS_RADIANS, RADIANS, facts, read, unit_of};
use crate::checked::{check_none_offered, check_offered, check_read, check_refusal, check_refused};
use quatlas::ProblemCode::{TwoMeanings, Unexpected, UnknownWord, WrongCount};
use quatlas::{
    ComponentOrder, Convention, Fact, Field, OrderSource, Remedy, parse_quaternion, parse_vector,
};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn commas_between_semicolons_may_be_decimal() {
    check_refused(&[
        ("1,0;0,0", Unexpected, "1,0;0,0", "decimal"),
        ("(0,7; 0,7)", Unexpected, "0,7; 0,7", "decimal"),
        ("rotvec 0,785;0", Unexpected, "rotvec 0,785;0", "decimal"),
        ("0,5,0,5", Unexpected, "0,5,0,5", "decimal"),
        ("q = [0,7,-0,7]", Unexpected, "0,7,-0,7", "decimal"),
    ]);
    for text in ["1,5;2", "1,5;2;3", "0,5;0,5;0,5"] {
        check_refusal(Field::Vector, text, Unexpected, text, "decimal");
    }
    check_offered(&[(
        "0,92;0,1;-0,2;0,38",
        Remedy::DecimalPoints,
        "0.92;0.1;-0.2;0.38",
    )]);
    let quarter = "[0 -1 0; 1 0 0; 0 0 1]";
    check_read(&[
        ("[0, -1, 0; 1, 0, 0; 0, 0, 1]", quarter),
        ("0,-1,0;1,0,0;0,0,1;", quarter),
        ("0.6; 0; 0; 0.8", "0.6 0 0 0.8"),
        ("q = 0.6, 0, 0, 0.8;", "0.6 0 0 0.8"),
        ("1,0,0,0", "1 0 0 0"),
        ("0,1,0,0", "0 1 0 0"),
        ("1,2,3,4", "1 2 3 4"),
        ("0, 5, 0, 5", "0 5 0 5"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_semicolon_parts_a_scalar_from_a_vector() {
    for (text, order) in [
        ("(0.92; 0.1, -0.2, 0.38)", ComponentOrder::ScalarFirst),
        ("q = [0.92; 0.1, -0.2, 0.38];", ComponentOrder::ScalarFirst),
        ("0.92; 0.1,-0.2,0.38;", ComponentOrder::ScalarFirst),
        ("(0.1, -0.2, 0.38; 0.92)", ComponentOrder::ScalarLast),
    ] {
        for declared in ComponentOrder::ALL {
            let parsed = parse_quaternion(text, declared).expect(text);
            assert_eq!(parsed.order_source, OrderSource::Grouped, "{text}");
            assert_eq!(parsed.order, order, "{text}");
            let q = parsed.quaternion;
            assert_eq!([q.w, q.i, q.j, q.k], [0.92, 0.1, -0.2, 0.38], "{text}");
        }
    }
    check_refused(&[("(1.57; 0, 0, 1)", TwoMeanings, "(1.57; 0, 0, 1)", "axis")]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_whole_number_before_a_fraction_may_be_one_with_it() {
    check_refused(&[
        ("1 1/2 0 0", Unexpected, "1 1/2", "fraction"),
        ("rpy 1 1/2 0", Unexpected, "1 1/2", "fraction"),
        ("0 0 1 ½", Unexpected, "1 ½", "fraction"),
        ("3/4/2024 1 0 0", Unexpected, "3/4/2024", "a date"),
    ]);
    check_refusal(Field::Vector, "2 3/4 0", Unexpected, "2 3/4", "fraction");
    check_read(&[
        ("1/2 1/2 1/2 1/2", "1 1 1 1"),
        ("0 1/2 0 1/2", "0 1 0 1"),
        ("1, 1/2, 0, 0", "2 1 0 0"),
        ("1\n1/2\n0\n0", "2 1 0 0"),
        ("1 3/2 0 0", "2 3 0 0"),
        ("1/2/2 0 0 1/4", "1 0 0 1"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_indices_that_r_prints_are_none_of_the_numbers() {
    check_read(&[
        ("[1] 0.92 0.1 -0.2 0.38", "0.92 0.1 -0.2 0.38"),
        ("[1]  0.92  0.10\n[3] -0.20  0.38", "0.92 0.1 -0.2 0.38"),
    ]);
    let vector = parse_vector("[1] 1 2 3").expect("three numbers");
    assert_eq!(vector.as_slice(), [1.0, 2.0, 3.0]);
    check_refused(&[
        ("[1] 1 2 3", WrongCount, "[1] 1 2 3", "3 numbers"),
        (
            "[2] 0.92 0.1 -0.2 0.38",
            WrongCount,
            "[2] 0.92 0.1 -0.2 0.38",
            "5 numbers",
        ),
    ]);
    check_refusal(
        Field::Vector,
        "[1] 0.6 0.8",
        WrongCount,
        "[1] 0.6 0.8",
        "2 numbers",
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_complex_number_is_no_quaternion() {
    check_refused(&[
        ("0.6+0.8j", UnknownWord, "j", "complex"),
        ("(-0.6-0.8j)", UnknownWord, "j", "complex"),
        ("z = 0.6+0.8i", UnknownWord, "i", "complex"),
    ]);
    // No button makes one of it.
    check_none_offered(
        Field::Quaternion,
        &["0.6+0.8j", "(0.6-0.8j)", "z = 0.6+0.8i"],
    );
    check_read(&[
        ("0.6 + 0.8i", "0.6 0.8 0 0"),
        ("0.6+0.8k", "0.6 0 0 0.8"),
        ("0.6+0.8i+0j+0k", "0.6 0.8 0 0"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn more_than_a_turn_in_the_radians_of_a_library_is_noted() {
    for (text, in_degrees) in [
        (
            "Eigen::AngleAxisd(90, Eigen::Vector3d::UnitZ())",
            "Eigen::AngleAxisd(90 deg, Eigen::Vector3d::UnitZ())",
        ),
        ("R.from_euler('z', 90)", "R.from_euler('z', 90 deg)"),
        ("R.from_rotvec([0, 0, 90])", "R.from_rotvec([0, 0, 90 deg])"),
        (
            "tf.createQuaternionFromRPY(0, 0, 90)",
            "tf.createQuaternionFromRPY(0, 0, 90 deg)",
        ),
    ] {
        assert_eq!(unit_of(text), AS_RADIANS, "{text}");
        let report = read(text, "1 0 0", Convention::HAMILTON);
        let [Fact::AngleUnitAssumed(assumed)] = &facts(&report)[..] else {
            panic!("{text}: {:?}", report.notes);
        };
        assert_eq!(assumed.in_degrees.as_deref(), Some(in_degrees), "{text}");
        check_read(&[(in_degrees, "90deg about z")]);
    }
    for text in [
        "R.from_euler('z', 1.5)",
        "R.from_euler('z', 90, degrees=False)",
    ] {
        assert_eq!(unit_of(text), RADIANS, "{text}");
    }
}
