//! Comments that tell the unit, the order or the convention of the numbers beside them.

use crate::asked::{DEGREES, facts, read, unit_of};
use crate::checked::{check_read, check_refusal, check_refused};
use quatlas::ProblemCode::{MixedUnits, OtherQuantity};
use quatlas::{Convention, Fact, Field};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn the_unit_in_a_comment_is_that_of_all_the_angles() {
    for text in [
        "rpy 5 4 3 # deg",
        "rpy 5 4 3 // in degrees",
        "/* degrees */ ZYX 3 4 5",
        "roll=5 pitch=4 yaw=3 # [deg]",
    ] {
        assert_eq!(unit_of(text), DEGREES, "{text}");
        check_read(&[(text, "rpy 5deg 4deg 3deg")]);
    }
    check_read(&[
        ("5 about z # deg", "5deg about z"),
        ("rpy 5 4 3 # rad", "rpy 5rad 4rad 3rad"),
        // What is told of one angle, or of two units, is nothing of these.
        ("rpy 0.5 0.4 0.3 # 28.6 deg", "rpy 0.5rad 0.4rad 0.3rad"),
        ("rpy 0.5 0.4 0.3 # rad or deg", "rpy 0.5rad 0.4rad 0.3rad"),
        ("0.6 0 0 0.8 # deg", "0.6 0 0 0.8"),
    ]);
    check_refused(&[("rpy 5 4 3 deg # rad", MixedUnits, "rpy", "one unit")]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_order_in_a_comment_is_that_of_four_numbers() {
    let named = "w=0.92 x=0.1 y=-0.2 z=0.38";
    for text in [
        "0.1 -0.2 0.38 0.92 # x y z w",
        "0.1 -0.2 0.38 0.92 // xyzw",
        "0.1, -0.2, 0.38, 0.92; // scalar last",
        "/* x */ 0.1, /* y */ -0.2, /* z */ 0.38, /* w */ 0.92",
        "% qx, qy, qz, qw: x, y, z, w\n0.1 -0.2 0.38 0.92",
        "0.92 0.1 -0.2 0.38 # w x y z",
    ] {
        check_read(&[(text, named)]);
        let report = read(text, "1 0 0", Convention::HAMILTON);
        let is_assumed = |fact: &Fact| matches!(fact, Fact::OrderAssumed(_));
        assert!(!facts(&report).iter().any(is_assumed), "{text}");
    }
    let read_last = read("0.92 0.1 -0.2 0.38 # wxyz", "1 0 0", Convention::JPL);
    assert!(read_last.hamilton.unit.w > 0.9);
    check_refused(&[
        (
            "0.1 -0.2 0.38 0.92 # from wxyz to xyzw",
            OtherQuantity,
            "# from wxyz to xyzw",
            "more than one",
        ),
        (
            "0.38 -0.2 0.1 0.92 # z y x w",
            OtherQuantity,
            "# z y x w",
            "order",
        ),
    ]);
    check_refusal(
        Field::Vector,
        "3 2 1 # z y x",
        OtherQuantity,
        "# z y x",
        "order",
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_comment_that_speaks_of_something_else_stops_the_text() {
    check_refused(&[
        (
            "1 0 0 0 # conjugate of q",
            OtherQuantity,
            "# conjugate of q",
            "a conjugate",
        ),
        (
            "0.6 0 0 0.8 // inverse",
            OtherQuantity,
            "// inverse",
            "an inverse",
        ),
        (
            "0 0 1 0 # position",
            OtherQuantity,
            "# position",
            "a position",
        ),
        ("0.6 0 0 0.8 # JPL", OtherQuantity, "# JPL", "declare JPL"),
        (
            "0.6 0 0 0.8 # left-handed",
            OtherQuantity,
            "# left-handed",
            "right-handed",
        ),
        (
            "[[0, -1, 0], [1, 0, 0], [0, 0, 1]] # R transposed",
            OtherQuantity,
            "# R transposed",
            "a transpose",
        ),
    ]);
    check_read(&[
        ("0.6 0 0 0.8 # Hamilton, body to world", "0.6 0 0 0.8"),
        (
            "0.6 0 0 0.8 # the tool at position 3 of the rack",
            "0.6 0 0 0.8",
        ),
        (
            "0.6 0 0 0.8 # minus the first, 90 deg about z",
            "0.6 0 0 0.8",
        ),
        // In quotes it is none.
        (
            r#"{"id": "a # inverse", "w": 0.6, "x": 0, "y": 0, "z": 0.8}"#,
            "0.6 0 0 0.8",
        ),
    ]);
}
