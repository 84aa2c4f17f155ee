//! Texts of the vectors along the axis: half-angle, Gibbs, modified Rodrigues parameters.

use crate::asked::{AS_RADIANS, DEGREES, RADIANS, facts, read, rotation};
use crate::checked::{attitude, check_refusal, check_refused};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::Vector3;
use quatlas::{
    AngleUnit, ComponentOrder, Convention, Fact, Field, Form, ParsedRotation, ProblemCode,
    Rotation, UnitSource, parse_quaternion,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Three different numbers, so that no two can change places.
const NUMBERS: [f64; 3] = [0.1, -0.3, 0.2];

#[wasm_bindgen_test(unsupported = test)]
fn a_gibbs_vector() {
    for text in [
        "gibbs 0.1 -0.3 0.2",
        "gibbs vector [0.1, -0.3, 0.2]",
        "Gibbs vector: 0.1, -0.3, 0.2",
        "imu_gibbs = [0.1; -0.3; 0.2]",
        r#"{"gibbs": {"z": 0.2, "x": 0.1, "y": -0.3}}"#,
        "gibbs x=0.1 y=-0.3 z=0.2",
        "gibbs 0.1i - 0.3j + 0.2k",
        "Rodrigues parameters 0.1 -0.3 0.2",
        "classical Rodrigues parameters: 0.1 -0.3 0.2",
        "CRP 1/10 -3/10 2/10",
        "q = gibbs (0.1, -0.3, 0.2)",
    ] {
        let expected = ParsedRotation::GibbsVector(Vector3::from(NUMBERS));
        assert_eq!(rotation(text), expected, "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn modified_rodrigues_parameters() {
    for text in [
        "mrp 0.1 -0.3 0.2",
        "MRPs: [0.1 -0.3 0.2]",
        "attitude_mrp: 0.1, -0.3, 0.2",
        "modified Rodrigues parameters 0.1 -0.3 0.2",
        "modified_rodrigues_parameters = [0.1, -0.3, 0.2]",
        "{mrp: {x: 0.1, y: -0.3, z: 0.2}}",
        "mrp 0.2k - 0.3j + 0.1i",
        "Rotation.from_mrp([0.1, -0.3, 0.2])",
        "R.from_mrp(np.array([0.1, -0.3, 0.2]))",
    ] {
        let expected = ParsedRotation::ModifiedRodrigues(Vector3::from(NUMBERS));
        assert_eq!(rotation(text), expected, "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_half_angle_vector() {
    let degrees = [6.0, -18.0, 12.0].map(f64::to_radians);
    let cases: [(&str, [f64; 3], UnitSource); 8] = [
        ("halfangle 0.1 -0.3 0.2", NUMBERS, AS_RADIANS),
        ("half-angle vector [0.1, -0.3, 0.2] rad", NUMBERS, RADIANS),
        ("half angle vector: 0.1, -0.3, 0.2", NUMBERS, AS_RADIANS),
        (
            "half_angle = {x: 0.1, y: -0.3, z: 0.2}",
            NUMBERS,
            AS_RADIANS,
        ),
        ("halfangle 6deg -18deg 12deg", degrees, DEGREES),
        ("halfangle<deg>(6, -18, 12)", degrees, DEGREES),
        ("half_angle_deg: 6 -18 12", degrees, DEGREES),
        (
            r#"{"halfangle": [6, -18, 12], "unit": "deg"}"#,
            degrees,
            DEGREES,
        ),
    ];
    for (text, vector_rad, unit) in cases {
        let ParsedRotation::HalfAngleVector(parsed) = rotation(text) else {
            panic!("{text}: {:?}", rotation(text));
        };
        assert_eq!(parsed.vector_rad, Vector3::from(vector_rad), "{text}");
        assert_eq!(parsed.unit, unit, "{text}");
    }
    // Longer than any turn needs: perhaps degrees. More than half a turn is −q as well.
    let note = |text| facts(&read(text, "1 0 0", Convention::HAMILTON));
    assert_eq!(note("halfangle 0 3.1 0"), [Fact::NegativeScalar]);
    assert_eq!(note("halfangle 0 3.2 0").len(), 2);
    let [Fact::AngleUnitAssumed(assumed), Fact::NegativeScalar] = &note("halfangle 0 22.5 0")[..]
    else {
        panic!("no note of the unit");
    };
    assert_eq!(assumed.unit, AngleUnit::Radians);
    assert_eq!(
        assumed.in_degrees.as_deref(),
        Some("halfangle 0 22.5 0 deg")
    );
}

/// What only a turn of a known angle tells apart (specification, FX-19), whatever is declared.
#[wasm_bindgen_test(unsupported = test)]
fn the_same_numbers_are_four_turns() {
    let angles_rad = [
        ("rotvec", 0.1),
        ("halfangle", 0.2),
        ("gibbs", 2.0 * 0.1_f64.atan()),
        ("mrp", 4.0 * 0.1_f64.atan()),
    ];
    for (word, angle_rad) in angles_rad {
        let expected = Rotation::from_axis_angle([0.0, 1.0, 0.0], angle_rad).expect("a turn");
        for convention in all_conventions() {
            let report = read(&format!("{word} 0 0.1 0"), "1 0 0", convention);
            let turned = report.turn.rotation_vector_rad;
            let expected = expected.rotation_vector_rad();
            assert_close(word, &turned, expected.as_slice(), 3e-16);
        }
    }
    // 45° about z.
    for text in [
        "gibbs 0 0 0.414213562373095",
        "mrp 0 0 0.198912367379658",
        "halfangle 0 0 22.5deg",
    ] {
        let off_rad = attitude(text).angle_to_rad(&attitude("45deg about z"));
        assert!(off_rad < 2e-15, "{text}: {off_rad}");
    }
}

/// The report says what was typed, and its numbers pasted back are the same attitude.
#[wasm_bindgen_test(unsupported = test)]
fn the_numbers_of_the_report_are_read_back() {
    for text in [
        "0.92 0.1 -0.2 0.38",
        "-0.1 0.7 -0.2 0.6",
        "1 1e-9 -2e-9 3e-9",
        "1e-7 0.6 0 -0.8",
        "mrp 3 -1 2",
        "gibbs 1e9 -2e9 3e9",
        "halfangle 2 -1 7",
    ] {
        let report = read(text, "1 0 0", Convention::HAMILTON);
        let back = |word: &str, numbers: [f64; 3]| {
            let [x, y, z] = numbers;
            let off_rad =
                attitude(&format!("{word} [{x:e}, {y:e}, {z:e}]")).angle_to_rad(&attitude(text));
            assert!(off_rad < 1e-15, "{text} as {word}: {off_rad}");
        };
        back(
            "gibbs",
            report.turn.gibbs_vector.expect("less than half a turn"),
        );
        back("mrp", report.turn.modified_rodrigues_parameters);
        back(
            "halfangle",
            report.turn.rotation_vector_rad.map(|part| part / 2.0),
        );
    }
    let form = |text| read(text, "1 0 0", Convention::JPL).quaternion.form;
    assert!(
        matches!(form("gibbs 0.1 -0.3 0.2"), Form::GibbsVector(read) if read.vector == NUMBERS)
    );
    assert!(
        matches!(form("mrp 0.1 -0.3 0.2"), Form::ModifiedRodrigues(read) if read.parameters == NUMBERS)
    );
    assert!(
        matches!(form("halfangle 0.1 -0.3 0.2"), Form::HalfAngleVector(read) if read.vector_rad == NUMBERS)
    );
    let json = serde_json::to_value(form("gibbs 0.1 -0.3 0.2")).expect("JSON");
    assert_eq!(json["kind"], "gibbs-vector");
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_no_such_vector_is_refused() {
    use ProblemCode::{
        MixedNames, MixedUnits, ScalarInVector, Unexpected, UnknownWord, WrongCount,
    };
    check_refused(&[
        ("gibbs 0.1 0.2", WrongCount, "0.1 0.2", "2 numbers"),
        (
            "mrp 0.1 0.2 0.3 0.4",
            WrongCount,
            "0.1 0.2 0.3 0.4",
            "4 numbers",
        ),
        ("halfangle 0.1 0.2", WrongCount, "0.1 0.2", "2 numbers"),
        ("gibbs 0 0 24 deg", MixedUnits, "0 0 24", "tangents"),
        ("mrp_deg: 0 0 24", MixedUnits, "0 0 24", "tangents"),
        ("mrp 0 0 24deg", Unexpected, "24deg", "unexpected angle"),
        ("gibbs w=1 x=0 y=0 z=1", ScalarInVector, "w=1", "no scalar"),
        (
            "mrp roll=1 pitch=2 yaw=3",
            MixedNames,
            "roll",
            "two descriptions of a rotation are mixed here",
        ),
        (
            "gibbs_rate: 0 0 0.4",
            ProblemCode::OtherQuantity,
            "gibbs_rate",
            "a rate",
        ),
        // One name for two vectors; a call says which.
        ("rodrigues 0 0 0.4", UnknownWord, "rodrigues", "OpenCV"),
        (
            "Rodrigues vector: [0, 0, 0.4]",
            UnknownWord,
            "Rodrigues vector:",
            "gibbs",
        ),
    ]);
    assert!(matches!(
        rotation("cv::Rodrigues([0, 0, 0.4])"),
        ParsedRotation::RotationVector(_)
    ));
    let vector = "mrp: 0 0 0.4";
    check_refusal(
        Field::Vector,
        vector,
        UnknownWord,
        "mrp",
        "is not supported here",
    );
    for (text, what) in [
        ("gibbs 0 0 1", "a Gibbs vector"),
        ("mrp 0 0 1", "a set of modified Rodrigues parameters"),
        ("halfangle 0 0 1", "a half-angle vector"),
    ] {
        let problem =
            parse_quaternion(text, ComponentOrder::ScalarFirst).expect_err("no quaternion");
        assert!(problem.message.contains(what), "{problem}");
    }
}
