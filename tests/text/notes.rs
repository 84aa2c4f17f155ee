//! What is said about four numbers that were read: the example of the lecture, notes, what is left out.

use crate::asked::{facts, read};
use crate::quaternions::{ARITHMETIC, COS, HALF_ROOT, SIN};
use crate::support::assert_close;
use quatlas::{ComponentOrder, Convention, Fact, OrderSource, OutOfRangeNumber};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn the_opening_example_is_that_of_the_lecture() {
    let report = read(
        "cos(pi/8) + sin(pi/8) k",
        "1/√2, 1/√2, 0",
        Convention::HAMILTON,
    );
    let half = HALF_ROOT;
    assert_eq!(report.hamilton.quaternion.array, [COS, 0.0, 0.0, SIN]);
    assert_eq!(report.jpl.quaternion.array, [0.0, 0.0, SIN, COS]);
    let rows = [[half, -half, 0.0], [half, half, 0.0], [0.0, 0.0, 1.0]];
    assert_close(
        "R(q)",
        report.hamilton.matrix.as_flattened(),
        rows.as_flattened(),
        ARITHMETIC,
    );
    assert_eq!(report.jpl.inverse_matrix, report.hamilton.matrix);
    assert_eq!(report.jpl.matrix, report.hamilton.inverse_matrix);
    assert_close(
        "R(q) v",
        &report.hamilton.image.expect("finite"),
        &[0.0, 1.0, 0.0],
        ARITHMETIC,
    );
    assert_close(
        "C(q) v",
        &report.jpl.image.expect("finite"),
        &[1.0, 0.0, 0.0],
        ARITHMETIC,
    );
    assert_eq!(report.jpl_with_same_matrix.array, [0.0, 0.0, -SIN, COS]);
    assert_eq!(report.turn.axis, Some([0.0, 0.0, 1.0]));
    assert_close("45°", &[report.turn.angle_deg], &[45.0], ARITHMETIC);
    assert_eq!(facts(&report), []);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_text_declared_as_jpl_has_the_other_order_and_the_same_meaning_of_names() {
    let bare = read("0.6 0 0 0.8", "1 0 0", Convention::JPL);
    assert_eq!(bare.jpl.quaternion.array, [0.6, 0.0, 0.0, 0.8]);
    assert_eq!(bare.hamilton.quaternion.array, [0.8, 0.6, 0.0, 0.0]);
    let named = read("w=1/√2, x=0, y=0, z=1/√2", "1 0 0", Convention::JPL);
    assert_eq!(named.jpl.image, Some([0.0, -1.0, 0.0]));
    assert_eq!(named.hamilton.image, Some([0.0, 1.0, 0.0]));
}

#[wasm_bindgen_test(unsupported = test)]
fn notes_say_what_was_done_and_what_cannot_be_told() {
    let hamilton = |text| facts(&read(text, "1 0 0", Convention::HAMILTON));

    // Norm 1 but for the rounding of the text: nothing is said.
    assert_eq!(hamilton("w=0.6, x=0.8, y=0, z=0"), []);
    let [Fact::Normalised(normalised)] = &hamilton("qw=1, qx=2, qy=2, qz=4")[..] else {
        panic!("one fact")
    };
    assert_eq!(
        (normalised.norm, normalised.deviation),
        (Some(5.0), Some(4.0))
    );

    let [Fact::OrderAssumed(assumed)] = &hamilton("0.6 0.8 0 0")[..] else {
        panic!("one fact")
    };
    assert_eq!(assumed.order, ComponentOrder::ScalarFirst);
    // q = 0.6 + 0.8i against 0.6 as x and 0.8 as y: the scalar of the quotient is 0.48.
    assert_close(
        "differs by",
        &[assumed.other_order_differs_by_deg],
        &[122.629_195_971_762_16],
        1e-14,
    );

    assert_eq!(hamilton("0.5 0.5 0.5 0.5"), [Fact::OrderInvisible]);
    assert_eq!(hamilton("0.5 -0.5 0.5 -0.5"), [Fact::OrderInvisible]);
    let [Fact::OrderFromText(from_text)] = &hamilton("R.from_quat([0, 0, 0.6, 0.8])")[..] else {
        panic!("one fact")
    };
    assert_eq!(from_text.source, OrderSource::Constructor);
    assert_eq!(from_text.order, ComponentOrder::ScalarLast);
    let [Fact::UnknownConstructor(unknown)] = &hamilton("Quaternion(0.6, 0, 0, 0.8)")[..] else {
        panic!("one fact")
    };
    assert_eq!(unknown.name, "Quaternion");

    assert_eq!(hamilton("-0.6 + 0.8k"), [Fact::NegativeScalar]);
    assert_eq!(hamilton("0.6i + 0.8k"), [Fact::HalfTurn]);
    assert_eq!(hamilton("cos(pi/2) + sin(pi/2)k"), [Fact::HalfTurn]);
    assert_eq!(hamilton("1 + 0k"), [Fact::NoTurn]);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_a_double_cannot_hold_is_left_out_and_said() {
    let left_out = |text, vector| {
        facts(&read(text, vector, Convention::HAMILTON))
            .into_iter()
            .filter_map(|fact| match fact {
                Fact::OutOfRange(out_of_range) => Some(out_of_range.what),
                _ => None,
            })
            .collect::<Vec<_>>()
    };
    assert_eq!(
        left_out("1e-310 + 0i", "1 0 0"),
        [OutOfRangeNumber::Inverse]
    );
    assert_eq!(left_out("1e300 + 1e300i", "1 0 0"), []);
    let report = read(
        "qw=1.7e308, qx=1.7e308, qy=0, qz=0",
        "0 1 0",
        Convention::HAMILTON,
    );
    assert_eq!(report.quaternion.norm, None);
    assert_eq!(report.hamilton.image, Some([0.0, 0.0, 1.0]));
    // Turned by 45°, two components of 1.7e308 become one of 2.4e308.
    assert_eq!(
        left_out("cos(pi/8) + sin(pi/8)k", "1.7e308 1.7e308 0"),
        [OutOfRangeNumber::Image]
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn no_minus_zero_reaches_the_report() {
    let report = read("-1 + 0i - 0j", "-0 0 -0", Convention::JPL);
    let json = serde_json::to_string(&report).expect("JSON");
    assert!(!json.contains("-0.0"), "{json}");
}
