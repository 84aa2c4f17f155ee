//! Labels that say something of the numbers under them: another thing, another order, another convention.

use crate::asked::{facts, read};
use crate::checked::{Refusal, attitude, check_read, check_refusal, check_refused};
use crate::support::assert_close;
use quatlas::ProblemCode::{OtherQuantity, UnknownComponent};
use quatlas::{
    ComponentOrder, Convention, Direction, Fact, Field, OrderFromText, OrderSource, Outcome,
    ReadReport,
};
use quatlas::{ReadRequest, Request, analyze};
use wasm_bindgen_test::wasm_bindgen_test;

/// A text with this label, and a word of what the problem at the label says.
fn labelled(labels: &[(&'static str, &str)], numbers: &str) {
    for (label, word) in labels {
        for mark in [" = ", ": "] {
            let text = [label, mark, numbers].concat();
            check_refusal(Field::Quaternion, &text, OtherQuantity, label, word);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_was_made_of_a_rotation_is_no_rotation() {
    labelled(
        &[
            ("qInv", "an inverse"),
            ("invQ", "an inverse"),
            ("quatInverse", "an inverse"),
            ("q.inverse", "an inverse"),
            ("qConj", "a conjugate"),
            ("conj_q", "a conjugate"),
            ("q_star", "a conjugate"),
            ("qbar", "a conjugate"),
            ("qDot", "a derivative"),
            ("attitudeRate", "a rate"),
            ("minus", "a negative"),
            ("orientationCovariance", "a variance"),
        ],
        "0.6 0 0 0.8",
    );
    labelled(
        &[
            ("Rinv", "an inverse"),
            ("Rt", "a transpose"),
            ("R_T", "a transpose"),
            ("R.T", "a transpose"),
            ("Rᵀ", "a transpose"),
            ("rotationMatrixTransposed", "a transpose"),
            ("covarianceMatrix", "a variance"),
            ("Sigma", "a variance"),
        ],
        "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]",
    );
    check_refused(&[
        ("minus: 90° about z", OtherQuantity, "minus", "a negative"),
        (
            "inverse: rotvec 0 0 0.7",
            OtherQuantity,
            "inverse",
            "an inverse",
        ),
        (
            "negated rpy: 0.1 0.2 0.3",
            OtherQuantity,
            "negated",
            "a negative",
        ),
        (
            "eulerRates: 0.1 0.2 0.3",
            OtherQuantity,
            "eulerRates",
            "a rate",
        ),
        ("rotvecDot: 0 0 0.1", OtherQuantity, "rotvecDot", "a rate"),
        (
            "inverse of q = 0.6 0 0 0.8",
            OtherQuantity,
            "inverse",
            "an inverse",
        ),
        (
            r#"{"inverted": {"w": 0.6, "x": 0, "y": 0, "z": 0.8}}"#,
            OtherQuantity,
            r#""inverted""#,
            "an inverse",
        ),
        (
            r#"{"a": {"b": {"c": {"q_conj": [0.6, 0, 0, 0.8]}}}}"#,
            OtherQuantity,
            r#""q_conj""#,
            "a conjugate",
        ),
        (
            "q_inv = Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()))",
            OtherQuantity,
            "q_inv",
            "an inverse",
        ),
        (
            r#"{"type": "conjugate", "w": 0.6, "x": 0, "y": 0, "z": 0.8}"#,
            UnknownComponent,
            r#""type""#,
            "may change",
        ),
        (
            r#"{"comment": "inverse of the attitude", "w": 0.6, "x": 0, "y": 0, "z": 0.8}"#,
            UnknownComponent,
            r#""comment""#,
            "may change",
        ),
    ]);
    // A name that only contains such a word, or says nothing.
    for name in ["invoice", "barn", "q_t", "star_tracker", "left", "q2"] {
        let text = format!("{name} = 0.6 0 0 0.8");
        check_read(&[(&text, "0.6 0 0 0.8")]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn another_quantity_is_no_rotation() {
    const OTHERS: &[Refusal] = &[
        ("rgba: 0.8 0.6 0 0", OtherQuantity, "rgba", "a colour"),
        ("tint = (0, 0.6, 0.8, 0)", OtherQuantity, "tint", "a colour"),
        (
            "float4 color = 0 0.6 0.8 0",
            OtherQuantity,
            "color",
            "a colour",
        ),
        ("color.r: 0 0 1 0", OtherQuantity, "color.r", "a colour"),
        ("plane: [0, 0, 1, 0]", OtherQuantity, "plane", "a plane"),
        ("plane normal: 0 0 1 0", OtherQuantity, "plane", "a plane"),
        (
            "translation = [0, 1, 0, 0]",
            OtherQuantity,
            "translation",
            "a position",
        ),
        (
            "cameraPosition: 0 0 1 0",
            OtherQuantity,
            "cameraPosition",
            "a position",
        ),
        (
            "point: {x: 0, y: 0, z: 1, w: 0}",
            OtherQuantity,
            "point",
            "a position",
        ),
        (
            "position.x=0 position.y=0 position.z=1 position.w=0",
            OtherQuantity,
            "position.x",
            "a position",
        ),
        ("t = 0 0 1 0", OtherQuantity, "t", "a translation"),
        ("acc: 0 0 1 0", OtherQuantity, "acc", "an acceleration"),
        ("gyro: 0 0 0 1", OtherQuantity, "gyro", "a velocity"),
        (
            "wheelSpeeds: 0.5 0.5 0.5 0.5",
            OtherQuantity,
            "wheelSpeeds",
            "wheels",
        ),
        (
            "motor_pwm: 0.5 0.5 0.5 0.5",
            OtherQuantity,
            "motor_pwm",
            "motors",
        ),
        (
            "joint_positions: 0 0 1 0",
            OtherQuantity,
            "joint_positions",
            "joints",
        ),
        ("scale = 1 0 0 0", OtherQuantity, "scale", "a size"),
        (
            "inertia: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
            OtherQuantity,
            "inertia",
            "an inertia",
        ),
        // Symmetric, as these are and half a turn is.
        (
            "P = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
            OtherQuantity,
            "P",
            "a covariance",
        ),
    ];
    check_refused(OTHERS);
    let quarter = "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]";
    check_read(&[
        ("position_quat: 0.6 0 0 0.8", "0.6 0 0 0.8"),
        ("camera rotvec: 0 0 0.3", "rotvec 0 0 0.3"),
        ("cam_R = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]", quarter),
        ("P = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]", quarter),
        (
            "position: {x: 1, y: 2, z: 3}, orientation: {w: 0.6, x: 0, y: 0, z: 0.8}",
            "0.6 0 0 0.8",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_order_in_a_label_is_used_and_told() {
    let first = "w=0.92 x=0.1 y=-0.2 z=0.38";
    for text in [
        "quat_scalar_last: 0.1 -0.2 0.38 0.92",
        "qScalarLast = [0.1, -0.2, 0.38, 0.92]",
        "quaternion_xyzw: 0.1 -0.2 0.38 0.92",
        "q_wLast = 0.1 -0.2 0.38 0.92",
        "order: scalar_last, 0.1 -0.2 0.38 0.92",
    ] {
        check_read(&[(text, first)]);
        let report = read(text, "1 0 0", Convention::HAMILTON);
        let told = Fact::OrderFromText(OrderFromText {
            source: OrderSource::Named,
            order: ComponentOrder::ScalarLast,
        });
        assert!(facts(&report).contains(&told), "{text}");
    }
    check_refused(&[
        ("zyxw: 0.38 -0.2 0.1 0.92", OtherQuantity, "zyxw", "order"),
        (
            "q_wzyx = 0.92 0.38 -0.2 0.1",
            OtherQuantity,
            "q_wzyx",
            "order",
        ),
    ]);
}

fn is_read(text: &str, convention: Convention) -> bool {
    let request = Request::Read(ReadRequest::new(text, "1 0 0", convention));
    matches!(analyze(&request), Outcome::Read(_))
}

#[wasm_bindgen_test(unsupported = test)]
fn another_convention_than_the_declared_one_is_asked_about() {
    use Convention as Of;
    // Under the first it is read, under the second it is refused.
    for (label, read, refused) in [
        ("JPL", Of::JPL, Of::HAMILTON),
        ("quaternion jpl", Of::JPL, Of::HAMILTON),
        ("qJpl", Of::JPL, Of::HAMILTON),
        ("q_hamilton", Of::HAMILTON, Of::JPL),
    ] {
        let text = format!("{label}: 0.6 0 0 0.8");
        assert!(is_read(&text, read), "{text}");
        assert!(!is_read(&text, refused), "{text}");
    }
    check_refused(&[
        ("JPL: 0 0 0.6 0.8", OtherQuantity, "JPL", "declare JPL"),
        // Of angles nothing is declared.
        (
            "rotvec world_to_body: 0 0 0.7",
            OtherQuantity,
            "rotvec world_to_body",
            "the opposite turn",
        ),
        (
            "leftHanded: 0.6 0 0 0.8",
            OtherQuantity,
            "leftHanded",
            "right-handed",
        ),
        (
            "q_lhs = 0.6 0 0 0.8",
            OtherQuantity,
            "q_lhs",
            "right-handed",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_label_of_columns_turns_the_matrix_and_is_told() {
    // The columns of a quarter turn about z.
    let quarter = attitude("90deg about z");
    for text in [
        "columns: [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]",
        "column_major = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]",
        "colMajor = 0 1 0 -1 0 0 0 0 1",
        "elements: [0, 1, 0, -1, 0, 0, 0, 0, 1]",
        "[[0, 1, 0], [-1, 0, 0], [0, 0, 1]] # column-major",
    ] {
        let report = read(text, "1 0 0", Convention::HAMILTON);
        assert!(attitude(text).angle_to_rad(&quarter) < 1e-15, "{text}");
        let [Fact::ColumnsFromText(told)] = &facts(&report)[..] else {
            panic!("{text}: {:?}", report.notes);
        };
        assert_close(text, &[told.rows_differ_by_deg], &[180.0], 1e-12);
    }
    for text in [
        "rows: 0 -1 0 1 0 0 0 0 1",
        "elements: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]",
    ] {
        let report = read(text, "1 0 0", Convention::HAMILTON);
        assert!(attitude(text).angle_to_rad(&quarter) < 1e-15, "{text}");
        assert_eq!(report.notes, [], "{text}");
    }
    check_read(&[("elements: 0.6 0 0 0.8", "0.6 0 0 0.8")]);
    check_refused(&[(
        "columns: 0.6 0 0 0.8",
        UnknownComponent,
        "columns",
        "may change",
    )]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_vector_has_labels_too() {
    for (text, place, word) in [
        ("v.T = [1, 2, 3]", "v.T", "a transpose"),
        ("vTransposed = 1 2 3", "vTransposed", "a transpose"),
        ("variance: 1 2 3", "variance", "a variance"),
        ("zyx = 3 2 1", "zyx", "order"),
        ("negated: {x: 1, y: 2, z: 3}", "negated", "a negative"),
    ] {
        check_refusal(Field::Vector, text, OtherQuantity, place, word);
    }
    for text in [
        "velocity: 1 2 3",
        "position = 1 2 3",
        "point: {x: 1, y: 2, z: 3}",
        "xyz: 1 2 3",
    ] {
        let request = Request::Read(ReadRequest::new("1 0 0 0", text, Convention::HAMILTON));
        let Outcome::Read(report) = analyze(&request) else {
            panic!("{text}");
        };
        assert_close(text, &report.vector, &[1.0, 2.0, 3.0], 0.0);
    }
}

/// The direction that a label tells wins over the declared one, and is told.
#[wasm_bindgen_test(unsupported = test)]
fn the_direction_in_a_label_is_used_and_told() {
    use Direction::{BodyToWorld, WorldToBody};
    let told = |report: &ReadReport| {
        report.notes.iter().find_map(|note| match &note.fact {
            Fact::DirectionFromText(fact) => Some(fact.direction),
            _ => None,
        })
    };
    for (label, direction) in [
        ("world_to_body", WorldToBody),
        ("globalToLocal", WorldToBody),
        ("q_w2c", WorldToBody),
        ("q_GtoI", WorldToBody),
        ("body_from_world", WorldToBody),
        ("bodyToWorld", BodyToWorld),
        ("c2w", BodyToWorld),
    ] {
        // A quarter turn about z: of the body in the world, or of the world in the body.
        let signed = match direction {
            BodyToWorld => 1.0,
            WorldToBody => -1.0,
        };
        let text = format!("{label}: 1/√2 0 0 1/√2");
        let report = read(&text, "1 0 0", Convention::HAMILTON);
        assert_eq!(report.quaternion.convention.direction, direction, "{text}");
        assert_eq!(report.hamilton.unit.z.signum(), signed, "{text}");
        let differs = direction != BodyToWorld;
        assert_eq!(told(&report), differs.then_some(direction), "{text}");
        let text = format!("{label} = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]");
        let report = read(&text, "1 0 0", Convention::HAMILTON);
        assert_eq!(report.hamilton.unit.z.signum(), signed, "{text}");
    }
}
