//! What `analyze` reports of an attitude, whatever the text describes it by.

use crate::asked::{facts, read, report};
use crate::support::assert_close;
use quatlas::{
    AngleUnit, AngleUnitAssumed, Convention, Direction, EulerSequence, Fact, Form, Function,
    MatrixConvention, ReadRequest, Side, Survivor,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Yaw 30°, pitch 20°, roll 10° about the moving axes; from half angles, with 40 digits.
const YPR_WXYZ: [f64; 4] = [
    0.951_548_524_643_788_6,
    0.038_134_576_474_850_15,
    0.189_307_857_412,
    0.239_298_337_744_730_33,
];

#[wasm_bindgen_test(unsupported = test)]
fn three_angles_are_the_same_attitude_in_every_description() {
    let texts = [
        "ZYX 30deg 20deg 10deg",
        "rpy 10deg 20deg 30deg",
        "xyz pi/18 pi/9 pi/6",
        "0.9515485246437886 + 0.03813457647485015i + 0.189307857412j + 0.23929833774473033k",
        // Rows of Rz(30°) Ry(20°) Rx(10°).
        "0.8137976813493737 -0.4409696105298824 0.3785223063697925
         0.4698463103929542 0.8825641192593856 0.01802831123629729
         -0.3420201433256687 0.16317591116653482 0.9254165783983234",
    ];
    for text in texts {
        let report = read(text, "1 0 0", Convention::HAMILTON);
        assert_close(text, &report.hamilton.unit.array, &YPR_WXYZ, 3e-16);
        assert_close(text, &report.euler.angles_deg, &[30.0, 20.0, 10.0], 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_text_is_reported_as_it_was_read() {
    let form = |text: &str| read(text, "1 0 0", Convention::JPL).quaternion.form;
    assert_eq!(form("1 0 0 0"), Form::Quaternion);
    let Form::EulerAngles(euler) = form("zxz 0.1 0.2 0.3") else {
        panic!("Euler angles")
    };
    assert_eq!(euler.sequence.to_string(), "zxz");
    assert_eq!(euler.angles_rad, [0.1, 0.2, 0.3]);
    let Form::AxisAngle(turn) = form("0.5 about [0, 3, 4]") else {
        panic!("axis and angle")
    };
    assert_eq!((turn.axis, turn.angle_rad), ([0.0, 3.0, 4.0], 0.5));
    let Form::RotationVector(turn) = form("rotvec 7 8 9") else {
        panic!("a rotation vector")
    };
    assert_eq!(turn.vector_rad, [7.0, 8.0, 9.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_angle_without_a_unit_is_told() {
    let told = |text| facts(&read(text, "1 0 0", Convention::HAMILTON));
    let assumed = |unit, text: &str| {
        Fact::AngleUnitAssumed(AngleUnitAssumed {
            unit,
            in_degrees: Some(format!("{text} deg")),
            in_radians: Some(format!("{text} rad")),
        })
    };
    let degrees = assumed(AngleUnit::Degrees, "ZYX 30 20 10");
    assert_eq!(told("ZYX 30 20 10"), [degrees]);
    let radians = assumed(AngleUnit::Radians, "ZYX 3 2 1");
    assert_eq!(told("ZYX 3 2 1\n"), [radians]);
    assert_eq!(told("ZYX 3rad 2rad 1rad"), []);
    let long = assumed(AngleUnit::Radians, "rotvec 0 0 90");
    assert_eq!(told("rotvec 0 0 90"), [long]);
    assert_eq!(told("rotvec 0 0 0.9"), []);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_text_with_an_assumed_unit_is_offered_with_each_unit() {
    for text in [
        "ZYX 30 20 10",
        "45 about z",
        "0.5 about [0, 3, 4]",
        "axis-angle [0 0 1] 0.785",
        "roll=0.1 pitch=0.2 yaw=0.3",
        "rpy 10 20 30",
        "rotvec 0 0 13",
    ] {
        let told = facts(&read(text, "1 0 0", Convention::HAMILTON));
        let [Fact::AngleUnitAssumed(assumed)] = &told[..] else {
            panic!("{text}: {told:?}")
        };
        let degrees = assumed.in_degrees.as_deref().expect(text);
        let radians = assumed.in_radians.as_deref().expect(text);
        let turned = |text| {
            read(text, "1 0 0", Convention::HAMILTON)
                .hamilton
                .unit
                .array
        };
        assert_eq!(facts(&read(degrees, "1 0 0", Convention::HAMILTON)), []);
        let (as_read, other) = match assumed.unit {
            AngleUnit::Degrees => (degrees, radians),
            AngleUnit::Radians => (radians, degrees),
        };
        assert_eq!(turned(as_read), turned(text), "{text}");
        assert_ne!(turned(other), turned(text), "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn nearly_no_turn_is_told_below_a_ten_thousandth_of_a_radian() {
    let told = |text| facts(&read(text, "1 0 0", Convention::JPL));
    for text in [
        "rotvec 0 0.0001 0",
        "rotvec 0 0.000101 0",
        "rotvec 0 0.01 0",
    ] {
        assert_eq!(told(text), [], "{text}");
    }
    let [Fact::NearlyNoTurn(near)] = &told("rotvec 0 0.000099 0")[..] else {
        panic!("a note")
    };
    assert_close("angle", &[near.angle_rad], &[9.9e-5], 1e-19);
    // asin(√3 · 5e-7 / 4.95e-5), by hand.
    let uncertain = near.axis_uncertain_by_deg.expect("an angle");
    assert_close(
        "axis",
        &[near.angle_deg, uncertain],
        &[0.005_672_282, 1.002_467_3],
        1e-6,
    );
    // A vector part of 2.5e-6 is three times as large as its rounding: asin(0.346).
    let [Fact::NearlyNoTurn(near)] = &told("rotvec 0 0 5e-6")[..] else {
        panic!("a note")
    };
    let uncertain = near.axis_uncertain_by_deg.expect("an angle");
    assert_close("axis", &[uncertain], &[20.267_901_06], 1e-8);
    // A vector part of 8.660e-7 is as large as its rounding: any axis.
    let [Fact::NearlyNoTurn(near)] = &told("rotvec 0 0 -1.7e-6")[..] else {
        panic!("a note")
    };
    assert_eq!(near.axis_uncertain_by_deg, None);
    // The same turn of either sign of q, with any norm.
    assert!(matches!(
        told("-3 + 0.00014k")[..],
        [.., Fact::NearlyNoTurn(_)]
    ));
    assert!(!matches!(
        told("-3 + 0.00016k")[..],
        [.., Fact::NearlyNoTurn(_)]
    ));
    assert_eq!(told("1 + 0k"), [Fact::NoTurn]);
}

#[wasm_bindgen_test(unsupported = test)]
fn nearly_half_a_turn_is_told_within_a_ten_thousandth_of_a_radian() {
    let told = |text| facts(&read(text, "1 0 0", Convention::HAMILTON));
    for text in ["(pi - 0.0001001) rad about x", "179.99 deg about [1, 2, 3]"] {
        assert_eq!(told(text), [], "{text}");
    }
    for (text, before) in [
        ("(pi - 0.0000999) rad about x", &[][..]),
        ("(pi + 0.0000999) rad about x", &[Fact::NegativeScalar]),
    ] {
        let told = told(text);
        let Some((Fact::NearlyHalfTurn(near), others)) = told.split_last() else {
            panic!("{text}: {told:?}")
        };
        assert_eq!(others, before, "{text}");
        let short_by = [near.short_by_rad, near.short_by_deg];
        assert_close(text, &short_by, &[9.99e-5, 0.005_723_848_4], 1e-10);
    }
    // The last digit of the scalar is kept: 2 asin(1e-15).
    let [Fact::NearlyHalfTurn(near)] = &told("1e-15 + 1i")[..] else {
        panic!("a note")
    };
    assert_eq!(near.short_by_rad, 2e-15);
    assert_eq!(told("180 deg about x"), [Fact::HalfTurn]);
}

#[wasm_bindgen_test(unsupported = test)]
fn nine_numbers_are_read_as_the_matrix_that_is_declared() {
    // Of a body yawed by a quarter turn, its axes in the columns.
    let rows = "0 -1 0, 1 0 0, 0 0 1";
    let z = |matrix| {
        let request = ReadRequest {
            matrix,
            ..ReadRequest::new(rows, "1 0 0", Convention::HAMILTON)
        };
        report(request).turn.rotation_vector_rad[2].to_degrees()
    };
    let active = |direction| MatrixConvention {
        function: Function::Active,
        direction,
    };
    assert_eq!(z(MatrixConvention::BODY_TO_WORLD), 90.0);
    assert_eq!(z(MatrixConvention::WORLD_TO_BODY), -90.0);
    assert_eq!(z(active(Direction::BodyToWorld)), -90.0);
    assert_eq!(z(active(Direction::WorldToBody)), 90.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_matrix_with_rounded_entries_is_mended_and_told_by_how_much() {
    let report = read(
        "0.81 -0.44 0.38, 0.47 0.88 0.02, -0.34 0.16 0.93",
        "1 0 0",
        Convention::HAMILTON,
    );
    let Form::Matrix(matrix) = report.quaternion.form else {
        panic!("a matrix")
    };
    // ‖M − R‖ and max |MᵀM − I| of the entries as typed.
    assert!((0.004..0.02).contains(&matrix.correction), "{matrix:?}");
    let largest = [
        0.81 * 0.81 + 0.47 * 0.47 + 0.34 * 0.34 - 1.0_f64,
        0.44 * 0.44 + 0.88 * 0.88 + 0.16 * 0.16 - 1.0,
        0.38 * 0.38 + 0.02 * 0.02 + 0.93 * 0.93 - 1.0,
    ]
    .map(f64::abs);
    let largest = largest.into_iter().fold(0.0, f64::max);
    assert!((matrix.orthogonality_error - largest).abs() < 1e-15);
    assert!(matches!(facts(&report)[..], [Fact::NearestRotation(_)]));
    assert_close("near", &report.euler.angles_deg, &[30.0, 20.0, 10.0], 0.03);
}

/// Nine numbers in a row may be columns: then they are the opposite turn, here of 30°.
#[wasm_bindgen_test(unsupported = test)]
fn nine_numbers_without_rows_are_read_by_rows_and_that_is_said() {
    let rows_assumed = |text: &str| {
        let report = read(text, "1 0 0", Convention::HAMILTON);
        facts(&report).iter().find_map(|fact| match fact {
            Fact::RowsAssumed(rows) => Some(rows.columns_differ_by_deg),
            _ => None,
        })
    };
    let flat = rows_assumed("0.866 -0.5 0 0.5 0.866 0 0 0 1").expect("in a row");
    assert!((flat - 60.0).abs() < 0.01, "{flat}");
    for marked in [
        "0.866 -0.5 0; 0.5 0.866 0; 0 0 1",
        "0.866 -0.5 0\n0.5 0.866 0\n0 0 1",
        "0.866 -0.5 0, 0.5 0.866 0, 0 0 1",
        "[[0.866, -0.5, 0], [0.5, 0.866, 0], [0, 0, 1]]",
        // A half turn is its own opposite.
        "-1 0 0 0 -1 0 0 0 1",
    ] {
        assert_eq!(rows_assumed(marked), None, "{marked}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn near_gimbal_lock_the_distance_is_told() {
    let euler = |text| read(text, "1 0 0", Convention::HAMILTON).euler;
    for text in ["ZYX 30deg 89.42deg 10deg", "ZYX 30deg -89.42deg 10deg"] {
        assert_eq!(euler(text).near_lock_deg, None, "{text}");
    }
    // A hundredth of a radian is 0.573°.
    for text in ["ZYX 30deg 89.44deg 10deg", "ZYX 30deg -89.44deg 10deg"] {
        let near = euler(text).near_lock_deg.expect(text);
        assert_close(text, &[near], &[0.56], 1e-13);
    }
    // At the lock that is told instead.
    assert_eq!(euler("ZYX 30deg 90deg 10deg").near_lock_deg, None);
    // With equal outer axes the lock is at 0 and at 180°.
    for text in ["ZXZ 30deg 0.5deg 10deg", "ZXZ 30deg 179.5deg 10deg"] {
        let mut request = ReadRequest::new(text, "1 0 0", Convention::HAMILTON);
        request.euler = "ZXZ".parse().expect("a sequence");
        let near = report(request).euler.near_lock_deg.expect(text);
        assert_close(text, &[near], &[0.5], 1e-13);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn gimbal_lock_is_told_with_what_survives() {
    let report = read("ZYX 50deg 90deg 20deg", "1 0 0", Convention::HAMILTON);
    let lock = report.euler.gimbal_lock.expect("the nose is up");
    assert_eq!((lock.survivor, lock.lost), (Survivor::Difference, 2));
    assert!((lock.survivor_deg - 30.0).abs() < 1e-13, "{lock:?}");
    assert_close(
        "canonical",
        &report.euler.angles_deg,
        &[30.0, 90.0, 0.0],
        1e-14,
    );

    // With the nose down the sum is left, and about fixed axes the first angle is the lost one.
    let request = ReadRequest {
        euler: EulerSequence::ROLL_PITCH_YAW,
        ..ReadRequest::new("ZYX 50deg -90deg 20deg", "1 0 0", Convention::HAMILTON)
    };
    let down = self::report(request);
    let lock = down.euler.gimbal_lock.expect("the nose is down");
    assert_eq!((lock.survivor, lock.lost), (Survivor::Sum, 0));
    assert!((lock.survivor_deg - 70.0).abs() < 1e-13, "{lock:?}");
    assert_close(
        "canonical",
        &down.euler.angles_deg,
        &[0.0, -90.0, 70.0],
        1e-14,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn the_declared_convention_is_answered_in_its_own_numbers_and_rules() {
    let declared: Convention = "my-lab scalar-last world-to-body left global"
        .parse()
        .expect("a convention");
    let report = read("rotvec 0 0 pi/2", "1 0 0", declared);
    let half = 0.5_f64.sqrt();
    // Left and operator R_WB: the conjugate, and the scalar last.
    assert_close(
        "q",
        &report.declared.unit.array,
        &[0.0, 0.0, -half, half],
        2e-16,
    );
    assert_close(
        "S x",
        &report.declared.image.expect("finite"),
        &[0.0, 1.0, 0.0],
        3e-16,
    );
    let rules = report.rules;
    assert!(!rules.is_canonical);
    assert_eq!(rules.operator, Direction::BodyToWorld);
    assert_eq!(rules.labelled_first, Side::Left);
    assert_eq!(rules.chain_first, Side::Left);
    assert_eq!(rules.increment, Side::Left);
    assert_eq!(rules.body_rate, Side::Right);

    let jpl = read("rotvec 0 0 1", "1 0 0", Convention::JPL).rules;
    assert_eq!(jpl.operator, Direction::WorldToBody);
    assert_eq!(
        (jpl.labelled_first, jpl.chain_first),
        (Side::Right, Side::Right)
    );
    assert_eq!((jpl.increment, jpl.body_rate), (Side::Left, Side::Left));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_turn_has_its_four_vectors() {
    let turn = read("90deg about z", "1 0 0", Convention::HAMILTON).turn;
    assert_close(
        "Gibbs",
        &turn.gibbs_vector.expect("finite"),
        &[0.0, 0.0, 1.0],
        3e-16,
    );
    let eighth = 2.0_f64.sqrt() - 1.0;
    let expected = [0.0, 0.0, eighth];
    assert_close("MRP", &turn.modified_rodrigues_parameters, &expected, 2e-16);
    let half_turn = read("0 0 0 1", "1 0 0", Convention::HAMILTON).turn;
    assert_eq!(half_turn.gibbs_vector, None);
}
