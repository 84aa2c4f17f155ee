//! Numbers without a unit inside sin, cos and tan are radians; where one is more than a full turn, that
//! is said, with the text in degrees.

use crate::asked::{compose, facts, read, read_request};
use crate::support::assert_close;
use quatlas::{
    AngleUnit, AngleUnitAssumed, Convention, Endpoint, Fact, Field, Note, Outcome, Request,
    TranslateRequest, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn assumed(in_degrees: Option<&str>, in_radians: Option<&str>) -> Fact {
    Fact::AngleUnitAssumed(AngleUnitAssumed {
        unit: AngleUnit::Radians,
        in_degrees: in_degrees.map(str::to_owned),
        in_radians: in_radians.map(str::to_owned),
    })
}

fn is_assumed(fact: &Fact) -> bool {
    matches!(fact, Fact::AngleUnitAssumed(_))
}

/// Texts, and the same with degrees and with radians.
const BARE: [(&str, &str, &str); 9] = [
    (
        "cos(22.5) + sin(22.5) k",
        "cos(22.5 deg) + sin(22.5 deg) k",
        "cos(22.5 rad) + sin(22.5 rad) k",
    ),
    (
        "[cos(35), 0, 0, sin(35)]",
        "[cos(35 deg), 0, 0, sin(35 deg)]",
        "[cos(35 rad), 0, 0, sin(35 rad)]",
    ),
    (
        "1 0 0; 0 cos(30) -sin(30); 0 sin(30) cos(30)",
        "1 0 0; 0 cos(30 deg) -sin(30 deg); 0 sin(30 deg) cos(30 deg)",
        "1 0 0; 0 cos(30 rad) -sin(30 rad); 0 sin(30 rad) cos(30 rad)",
    ),
    (
        "[[Math.cos(-40), 0, Math.sin(-40)], [0, 1, 0], [-Math.sin(-40), 0, Math.cos(-40)]]",
        "[[Math.cos(-40 deg), 0, Math.sin(-40 deg)], [0, 1, 0], [-Math.sin(-40 deg), 0, Math.cos(-40 deg)]]",
        "[[Math.cos(-40 rad), 0, Math.sin(-40 rad)], [0, 1, 0], [-Math.sin(-40 rad), 0, Math.cos(-40 rad)]]",
    ),
    // What is computed is put in brackets, and no angle is left without the unit but 0.
    (
        "w=cos(70/2) x=0 y=sin(70 / 2) z=sin(0)",
        "w=cos((70/2) deg) x=0 y=sin((70 / 2) deg) z=sin(0)",
        "w=cos((70/2) rad) x=0 y=sin((70 / 2) rad) z=sin(0)",
    ),
    (
        "np.cos(5) 0 0 np.sin(85)",
        "np.cos(5 deg) 0 0 np.sin(85 deg)",
        "np.cos(5 rad) 0 0 np.sin(85 rad)",
    ),
    (
        "0.3deg about [cos(100 -40), sin(60), 0]",
        "0.3deg about [cos((100 -40) deg), sin(60 deg), 0]",
        "0.3deg about [cos((100 -40) rad), sin(60 rad), 0]",
    ),
    (
        "Quaternion(cos(6.3), 0, sin(6.3), 0)",
        "Quaternion(cos(6.3 deg), 0, sin(6.3 deg), 0)",
        "Quaternion(cos(6.3 rad), 0, sin(6.3 rad), 0)",
    ),
    ("1 0 0 tan(45)", "1 0 0 tan(45 deg)", "1 0 0 tan(45 rad)"),
];

#[wasm_bindgen_test(unsupported = test)]
fn more_than_a_full_turn_in_a_function_is_told() {
    for (text, in_degrees, in_radians) in BARE {
        let told = |text| facts(&read(text, "1 0 0", Convention::HAMILTON));
        let turned = |text| {
            read(text, "1 0 0", Convention::HAMILTON)
                .hamilton
                .unit
                .array
        };
        let note = assumed(Some(in_degrees), Some(in_radians));
        assert_eq!(
            told(text).into_iter().find(is_assumed),
            Some(note),
            "{text}"
        );
        assert!(!told(in_degrees).iter().any(is_assumed), "{in_degrees}");
        assert!(!told(in_radians).iter().any(is_assumed), "{in_radians}");
        // Radians is what is computed.
        assert_eq!(turned(in_radians), turned(text), "{text}");
        assert_ne!(turned(in_degrees), turned(text), "{text}");
    }
    // 45° about z: cos and sin of 22.5°, to 16 digits.
    let [(_, in_degrees, _), ..] = BARE;
    let report = read(in_degrees, "1 0 0", Convention::HAMILTON);
    let expected = [0.923_879_532_511_286_7, 0.0, 0.0, 0.382_683_432_365_089_8];
    assert_close(in_degrees, &report.hamilton.unit.array, &expected, 1e-16);
}

#[wasm_bindgen_test(unsupported = test)]
fn up_to_a_full_turn_and_with_a_unit_nothing_is_told() {
    for text in [
        "cos(0.4) + sin(0.4) k",
        "cos(6.2832) + sin(6.2832) k",
        "cos(6.29) + sin(-6.29) k",
        "cos(-6.28) + sin(3) k",
        "cos(22.5°) + sin(22.5 deg) k",
        "cos(22.5 rad) + sin(22.5rad) k",
        "cos(9pi) + sin(25*pi/2) k",
        "cos(radians(45)) + sin(np.deg2rad(45)) k",
        "sqrt(45) + 45 k",
        "cos(acos(0.6)) 0 0.8 0 # cos(45)",
        "rpy 10° 20° 30°",
    ] {
        let told = facts(&read(text, "1 0 0", Convention::HAMILTON));
        assert!(!told.iter().any(is_assumed), "{text}: {told:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_number_inside_another_has_no_plain_place_for_a_unit() {
    let told = facts(&read("cos(45 + sin(30)) 0 0 0.1", "1 0 0", Convention::JPL));
    assert!(told.contains(&assumed(None, None)), "{told:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn every_field_tells_it() {
    let text = "cos(40) sin(40) 0";
    let of_field = |notes: &[Note]| -> Vec<(Field, Fact)> {
        let notes = notes.iter().filter(|note| is_assumed(&note.fact));
        notes.map(|note| (note.field, note.fact.clone())).collect()
    };
    let of_vector = (
        Field::Vector,
        assumed(
            Some("cos(40 deg) sin(40 deg) 0"),
            Some("cos(40 rad) sin(40 rad) 0"),
        ),
    );
    let report = read("1 0 0 0", text, Convention::HAMILTON);
    assert_eq!(of_field(&report.notes), vec![of_vector.clone()]);

    let turned = "cos(9) + sin(9) i";
    let of = |field| {
        let in_degrees = "cos(9 deg) + sin(9 deg) i";
        let in_radians = "cos(9 rad) + sin(9 rad) i";
        (field, assumed(Some(in_degrees), Some(in_radians)))
    };
    let report = compose(turned, turned, text, Convention::JPL);
    assert_eq!(
        of_field(&report.notes),
        [of(Field::P), of(Field::Q), of_vector]
    );

    let request = TranslateRequest::new(
        turned,
        Endpoint::convention(Convention::HAMILTON),
        Endpoint::convention(Convention::JPL),
    );
    let Outcome::Translate(report) = analyze(&Request::Translate(request)) else {
        panic!("a report")
    };
    assert_eq!(of_field(&report.notes), [of(Field::Quaternion)]);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_assumed_unit_of_the_rotation_itself_is_told_first() {
    let notes = facts(&read("rpy sin(40) 0.1 0.2", "1 0 0", Convention::HAMILTON));
    let notes: Vec<_> = notes.into_iter().filter(is_assumed).collect();
    let first = assumed(
        Some("rpy sin(40) 0.1 0.2 deg"),
        Some("rpy sin(40) 0.1 0.2 rad"),
    );
    assert_eq!(notes, [first]);
    let outcome = analyze(&read_request("oops cos(45)", "1 0 0", Convention::JPL));
    assert!(matches!(outcome, Outcome::Problems(_)));
}
