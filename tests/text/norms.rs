//! Numbers whose norm is not that of a rotation: said so that a reader stops, or refused.

use crate::asked::{compose, facts, read};
use crate::checked::{attitude, check_refusal, problem};
use crate::support::assert_close;
use quatlas::{
    Convention, Endpoint, Fact, Field, Note, Outcome, ProblemCode, Remedy, Request, Suggestion,
    TranslateRequest, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// The note about the norm.
fn norm_note(text: &str) -> Option<Note> {
    let is_of_norm = |note: &Note| matches!(note.fact, Fact::FarFromUnit(_) | Fact::Normalised(_));
    let notes = read(text, "1 0 0", Convention::HAMILTON).notes;
    notes.into_iter().find(is_of_norm)
}

fn is_far(text: &str) -> bool {
    norm_note(text).is_some_and(|note| matches!(note.fact, Fact::FarFromUnit(_)))
}

#[wasm_bindgen_test(unsupported = test)]
fn a_norm_outside_0_9_to_1_1_stops_the_reader() {
    let note = norm_note("2 4 5 6").expect("of norm 9");
    let Fact::FarFromUnit(far) = &note.fact else {
        panic!("{note:?}")
    };
    assert_eq!((far.norm, far.deviation), (Some(9.0), Some(8.0)));
    assert!(note.stops);
    for text in [
        "0.89 0 0 0",
        "0 0 1.11 0",
        "[255, 128, 0, 255]",
        "np.array([1, 2, 2, 4])",
        "x=1 y=2 z=3 w=1",
        "x: 0\ny: 0\nz: 3\nw: 4",
        "3 [0, 0, 4]",
        "{\"pose\": [1.0, 2.0, 0.0, 1.57]}",
        "quality: 3 0 0 4",
        // As X3D and VRML have it, an axis and an angle.
        "orientation: 0 0 1 1.5708",
        "1.7e308 1.7e308 0 0",
    ] {
        assert!(is_far(text), "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_norm_of_what_says_to_be_a_quaternion_is_only_told() {
    for text in [
        "quaternion 1 2 3 4",
        "quaternion: [1, 2, 3, 4]",
        "quaternion x=1 y=2 z=3 w=4",
        "q = [1, 2, 3, 4]",
        "q_wb: 1 2 3 4",
        "qBody = 1 2 3 4",
        "robot.orientation.x: 2 robot.orientation.y: 3 robot.orientation.z: 4 robot.orientation.w: 1",
        "rotation: {x: 1, y: 2, z: 3, w: 4}",
        "qw: 1 qx: 2 qy: 3 qz: 4",
        "orientation:\n  x: 1\n  y: 2\n  z: 3\n  w: 4",
        "position: {x: 1, y: 2, z: 3}\norientation: {x: 0, y: 0, z: 3, w: 4}",
        "Eigen::Quaterniond(1, 2, 3, 4)",
        "Quaternion(1, 2, 3, 4)",
        "R.from_quat([1, 2, 3, 4])",
        "1 + 2i + 3j + 4k",
    ] {
        let note = norm_note(text).expect(text);
        assert!(matches!(note.fact, Fact::Normalised(_)), "{text}: {note:?}");
        assert!(!note.stops && note.suggestions.is_empty(), "{text}");
    }
    // And where the norm is nearly 1, nothing has to say so.
    for text in ["0.9 0 0 0", "1.1 0 0 0", "0.93 0.1 -0.2 0.4"] {
        assert!(norm_note(text).is_some() && !is_far(text), "{text}");
    }
}

fn offered(text: &str) -> Vec<(Remedy, String)> {
    let note = norm_note(text).expect(text);
    let texts = note.suggestions.into_iter();
    texts
        .map(|Suggestion { remedy, text, .. }| (remedy, text))
        .collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn what_the_numbers_may_be_is_offered_the_quaternion_first() {
    use Remedy::{AsAxisAngle, AsQuaternion, AsYaw};
    let check = |text: &str, expected: &[(Remedy, &str)]| {
        let expected: Vec<_> = expected
            .iter()
            .map(|&(remedy, text)| (remedy, text.to_owned()))
            .collect();
        assert_eq!(offered(text), expected, "{text}");
    };
    check("1 2 3 4", &[(AsQuaternion, "quaternion 1 2 3 4")]);
    check(
        "[1, 2, 3, 4]",
        &[(AsQuaternion, "quaternion: [1, 2, 3, 4]")],
    );
    check(
        "0.6 0.64 0.48 50",
        &[
            (AsQuaternion, "quaternion 0.6 0.64 0.48 50"),
            (AsAxisAngle, "axis-angle [0.6 0.64 0.48] 50deg"),
        ],
    );
    check(
        "-50 0.6 0.64 0.48",
        &[
            (AsQuaternion, "quaternion -50 0.6 0.64 0.48"),
            (AsAxisAngle, "-50deg about [0.6 0.64 0.48]"),
            (AsYaw, "0.48rad about z"),
        ],
    );
    check(
        "0 1 0 2.0944",
        &[
            (AsQuaternion, "quaternion 0 1 0 2.0944"),
            (AsAxisAngle, "axis-angle [0 1 0] 2.0944rad"),
        ],
    );
    // No axis of length 1, but a quarter turn.
    check(
        "1 -1 0 1.571",
        &[
            (AsQuaternion, "quaternion 1 -1 0 1.571"),
            (AsAxisAngle, "axis-angle [1 -1 0] 1.571rad"),
            (AsYaw, "1.571rad about z"),
        ],
    );
    check(
        "12.5 -3 0 135",
        &[
            (AsQuaternion, "quaternion 12.5 -3 0 135"),
            (AsYaw, "135deg about z"),
        ],
    );
    // By names the scalar alone may be the angle, and is no yaw.
    check(
        "w=0.7854 x=0 y=0 z=1",
        &[
            (AsQuaternion, "quaternion w=0.7854 x=0 y=0 z=1"),
            (AsAxisAngle, "axis-angle [0 0 1] 0.7854rad"),
        ],
    );
    // Neither a length of 1 nor a familiar angle.
    check(
        "1 -1 0 1.58",
        &[
            (AsQuaternion, "quaternion 1 -1 0 1.58"),
            (AsYaw, "1.58rad about z"),
        ],
    );
    // A time and a position; a colour; a point; a fraction; no axis; more than half and a whole turn.
    for text in [
        "0.6 0.64 0.52 50",
        "0 0 4 225",
        "0 0 1 361",
        "1305031098.67 1.36 0.63 1.64",
        "255 128 0 255",
        "1.25 -0.75 2.5 1",
        "1, 1/2, 0, 0",
    ] {
        check(text, &[(AsQuaternion, &format!("quaternion {text}"))]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_offered_is_read_as_it_says() {
    // Half of 50° about (0.6, 0.64, 0.48): cos 25° and sin 25°.
    let (scalar, sine) = (0.906_307_787_036_65, 0.422_618_261_740_699_4);
    let turned = [scalar, sine * 0.6, sine * 0.64, sine * 0.48];
    for text in ["0.6 0.64 0.48 50", "50 0.6 0.64 0.48"] {
        let (_, axis_angle) = &offered(text)[1];
        let report = read(axis_angle, "1 0 0", Convention::HAMILTON);
        assert_close(text, &report.hamilton.unit.array, &turned, 1e-15);
        assert_eq!(facts(&report), [], "{axis_angle}");
    }
    for text in [
        "1 2 3 4",
        "[1, 2, 3, 4]",
        "x=1 y=2 z=3 w=1",
        "{\"pose\": [1.0, 2.0, 0.0, 1.57]}",
        "[[1, 2, 3], 4]",
        "order: xyzw, 0 0 3 4",
    ] {
        let said = offered(text).remove(0).1;
        assert!(!is_far(&said), "{said}");
        let apart = attitude(&said).angle_to_rad(&attitude(text));
        assert!(apart < 1e-15, "{said}");
    }
    // In the declared order, and as the numbers of an axis whatever it is.
    let jpl = read("0 0 1 0.5", "1 0 0", Convention::JPL);
    assert_eq!(
        jpl.notes[0].suggestions[1].text,
        "axis-angle [0 0 1] 0.5rad"
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn zeros_that_were_rounded_are_refused() {
    let refused = |text: &str, word| {
        check_refusal(
            Field::Quaternion,
            text,
            ProblemCode::FarFromUnit,
            text,
            word,
        );
    };
    for text in [
        "0 0 0 6e-17",
        "[1e-17, 0, 0, -1e-17]",
        "w=0 x=0 y=0 z=-2.2e-16",
        // Single precision: the cosine of π/2, and a few operations more.
        "0 0 0 -4.371139e-08",
        "0 9e-7 0 0",
    ] {
        refused(text, "zero but for rounding");
    }
    refused("0 0 0 6e-17", "norm 6e-17");
    assert!(is_far("0 1.1e-6 0 0"));
    // Who says what it is has it read.
    let tiny = norm_note("quaternion 0 0 0 6e-17").expect("a norm");
    assert!(matches!(tiny.fact, Fact::Normalised(_)), "{tiny:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_by_name_of_a_norm_of_hundreds_are_no_quaternion() {
    // √(30² + 40² + 120² + 0²) = 130
    let text = "X=30 Y=40 Z=120 W=0";
    check_refusal(
        Field::Quaternion,
        text,
        ProblemCode::FarFromUnit,
        text,
        "its norm is 130, far from 1",
    );
    let found = problem(Field::P, text);
    assert_eq!((found.suggestion, found.choices.len()), (None, 0));
    assert!(is_far("x=0 y=60 z=80 w=0"));
    assert!(is_far("30 40 120 0"));
    assert!(!is_far(&format!("quaternion {text}")));
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_of_two_meanings_are_a_choice_and_each_text_says_which() {
    use Remedy::{AsAxisAngle, AsEulerAngles, AsQuaternion};
    for (text, first, second) in [
        (
            "[0, 0, 1] 0.7",
            (AsAxisAngle, "axis-angle [0, 0, 1] 0.7"),
            (AsQuaternion, "q = [0, 0, 1] 0.7"),
        ),
        (
            "(1.57, [0, 0, 1])",
            (AsAxisAngle, "axis-angle (1.57, [0, 0, 1])"),
            (AsQuaternion, "quaternion: (1.57, [0, 0, 1])"),
        ),
        (
            "[321, 30, 20, 10]",
            (AsEulerAngles, "[3-2-1, 30, 20, 10]"),
            (AsQuaternion, "quaternion [321, 30, 20, 10]"),
        ),
    ] {
        let found = problem(Field::Quaternion, text);
        assert_eq!(
            (found.code, found.suggestion),
            (ProblemCode::TwoMeanings, None)
        );
        let choices = found.choices.iter();
        let choices: Vec<_> = choices.map(|found| (found.remedy, &*found.text)).collect();
        assert_eq!(choices, [first, second], "{text}");
        // They are two: neither is what the other is.
        assert!(
            attitude(first.1).angle_to_rad(&attitude(second.1)) > 0.1,
            "{text}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_other_views_say_the_same() {
    let expected = norm_note("0 0 1 1.5708");
    let of_p = Note {
        field: Field::P,
        ..expected.clone().expect("a norm")
    };
    let report = compose("0 0 1 1.5708", "1 0 0 0", "1 0 0", Convention::HAMILTON);
    assert_eq!(report.notes.first(), Some(&of_p));
    // `w x y z` there as in the declaration above.
    let end = || Endpoint::library("mujoco");
    let request = TranslateRequest::new("0 0 1 1.5708", end(), end());
    let Outcome::Translate(report) = analyze(&Request::Translate(request)) else {
        panic!("translated")
    };
    assert_eq!(report.notes.first(), expected.as_ref());
    // The line of a library says what it is.
    let line = "Eigen::Quaterniond q(120.0, 0.0, 0.0, 50.0);";
    let request = TranslateRequest::new(line, Endpoint::library("eigen"), end());
    let Outcome::Translate(report) = analyze(&Request::Translate(request)) else {
        panic!("translated")
    };
    assert!(
        report.notes.iter().all(|note| !note.stops),
        "{:?}",
        report.notes
    );
}
