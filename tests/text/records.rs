//! What is told of a block with more than one description of a rotation, and what is asked.

use crate::asked::{self, problems, read, read_request};
use quatlas::{
    ComponentOrder, Convention, Fact, Note, OtherDescription, Outcome, Problem, ProblemCode,
    Remedy, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

// Roll 12.5°, pitch 33.75°, yaw −61.2° about the fixed axes x, y, z, by products of quaternions in Python.
const W_FIRST: &str = "[0.802696173189, 0.236559979419, 0.195343658385, -0.511428474778]";
const W_LAST: &str = "[0.236559979419, 0.195343658385, -0.511428474778, 0.802696173189]";

fn hamilton() -> Convention {
    Convention::HAMILTON
}

fn facts(text: &str, declared: Convention) -> Vec<Fact> {
    asked::facts(&read(text, "1 0 0", declared))
}

#[track_caller]
fn problem(text: &str) -> Problem {
    problems(analyze(&read_request(text, "1 0 0", hamilton()))).remove(0)
}

fn notes(text: &str) -> Vec<Note> {
    read(text, "1 0 0", hamilton()).notes
}

/// Angles beside a quaternion are compared with it.
#[wasm_bindgen_test(unsupported = test)]
fn a_second_description_is_compared() {
    let text = format!("orientation: {W_FIRST}\nrpy: [12.5deg, 33.75deg, -61.2deg]");
    let agrees = |note: &Note| matches!(&note.fact, Fact::SecondDescription(OtherDescription { label: Some(label), differs_by_deg, .. }) if label == "rpy" && *differs_by_deg < 1e-9);
    assert!(notes(&text).iter().any(agrees), "{:?}", notes(&text));

    let text = format!("orientation: {W_FIRST}\nrpy: [12.5deg, 33.75deg, -51.2deg]");
    let notes = notes(&text);
    let disagrees = |note: &&Note| matches!(&note.fact, Fact::DescriptionsDisagree(other) if (other.differs_by_deg - 10.0).abs() < 1e-6);
    let note = notes.iter().find(disagrees).expect("they disagree");
    assert!(note.stops);
    assert!(
        note.suggestions.is_empty(),
        "the other order is as far away"
    );
}

/// Angles of which the sequence is not told are looked for in all of them.
#[wasm_bindgen_test(unsupported = test)]
fn angles_without_a_sequence_are_compared() {
    // About moving x, y, z the quaternion above has other angles.
    let text = format!("quaternion: {W_FIRST}\neuler: 12.5 33.75 -61.2");
    let agrees = |note: &Note| matches!(&note.fact, Fact::SecondDescription(other) if other.label.as_deref() == Some("euler"));
    assert!(notes(&text).iter().any(agrees), "{:?}", notes(&text));
    let text = format!("quaternion: {W_FIRST}\neuler xyz (deg): 12.5 33.75 -51.2");
    let disagrees = |note: &Note| matches!(&note.fact, Fact::DescriptionsDisagree(_)) && note.stops;
    assert!(notes(&text).iter().any(disagrees), "{:?}", notes(&text));
}

/// Where the declared order disagrees with the angles and the other one does not, it is a button.
#[wasm_bindgen_test(unsupported = test)]
fn the_order_that_agrees_with_the_angles_is_offered() {
    let text = format!("orientation: {W_LAST}\nrpy: [12.5deg, 33.75deg, -61.2deg]");
    let notes = notes(&text);
    let disagrees = |note: &&Note| matches!(note.fact, Fact::DescriptionsDisagree(_));
    let note = notes.iter().find(disagrees).expect("they disagree");
    assert!(note.stops);
    let [suggestion] = &note.suggestions[..] else {
        panic!("{:?}", note.suggestions);
    };
    assert_eq!(suggestion.remedy, Remedy::OtherOrder);
    assert_eq!(
        suggestion.text,
        "w=0.802696173189 x=0.236559979419 y=0.195343658385 z=-0.511428474778"
    );

    let declared = Convention {
        order: ComponentOrder::ScalarLast,
        ..hamilton()
    };
    let told = facts(&text, declared);
    assert!(
        told.iter()
            .any(|fact| matches!(fact, Fact::SecondDescription(_))),
        "{told:?}"
    );
}

/// What a listener of PX4 adds of the last reset is neither another rotation nor another description.
#[wasm_bindgen_test(unsupported = test)]
fn a_difference_is_no_second_description() {
    let text = format!(
        "vehicle_attitude\n    q: {W_FIRST} (Roll: 12.5 deg, Pitch: 33.75 deg, Yaw: -61.2 deg)\n    \
         delta_q_reset: [1.0, 0.0, 0.0, 0.0] (Roll: 0.0 deg, Pitch: -0.0 deg, Yaw: 0.0 deg)\n    \
         quat_reset_counter: 0"
    );
    let told = facts(&text, hamilton());
    let agree = told
        .iter()
        .filter(|fact| matches!(fact, Fact::SecondDescription(_)));
    assert_eq!(agree.count(), 1, "{told:?}");
    assert!(
        !told
            .iter()
            .any(|fact| matches!(fact, Fact::DescriptionsDisagree(_))),
        "{told:?}"
    );
}

/// Of several rotations each is a button, which reads it.
#[wasm_bindgen_test(unsupported = test)]
fn several_rotations_are_asked() {
    let text =
        format!("left: {{quaternion: {W_FIRST}}}\nright: {{quaternion: [0.5, -0.5, 0.5, 0.5]}}");
    let problem = problem(&text);
    assert_eq!(problem.code, ProblemCode::SeveralRotations);
    let texts: Vec<&str> = problem
        .choices
        .iter()
        .map(|choice| &choice.text[..])
        .collect();
    assert_eq!(
        texts,
        [
            "w=0.802696173189 x=0.236559979419 y=0.195343658385 z=-0.511428474778",
            "w=0.5 x=-0.5 y=0.5 z=0.5"
        ]
    );
    let labels: Vec<_> = problem
        .choices
        .iter()
        .filter_map(|choice| choice.label.as_deref())
        .collect();
    assert_eq!(labels, ["left", "right"]);
}

/// Rows of a list are several quaternions, and not a time, a position and one.
#[wasm_bindgen_test(unsupported = test)]
fn a_list_of_quaternions_is_asked() {
    let text = "[[0.8, 0.2, -0.4, 0.4],\n [0.5, -0.5, 0.5, 0.5],\n [0.1, 0.7, -0.5, 0.5]]";
    let problem = problem(text);
    assert_eq!(problem.code, ProblemCode::SeveralRotations);
    let texts: Vec<&str> = problem
        .choices
        .iter()
        .map(|choice| &choice.text[..])
        .collect();
    assert_eq!(
        texts,
        [
            "w=0.8 x=0.2 y=-0.4 z=0.4",
            "w=0.5 x=-0.5 y=0.5 z=0.5",
            "w=0.1 x=0.7 y=-0.5 z=0.5"
        ]
    );
}

/// A time and four numbers of norm 1 are a row of a file, under a question.
#[wasm_bindgen_test(unsupported = test)]
fn a_time_before_four_numbers_is_a_row() {
    let text = "2026-07-08T09:10:11 0.236559979419 0.195343658385 -0.511428474778 0.802696173189";
    let report = read(text, "1 0 0", Convention::JPL);
    assert!(
        (report.jpl.unit.w - 0.802696173189).abs() < 1e-9,
        "{report:?}"
    );
    let is_assumed = |note: &Note| matches!(note.fact, Fact::FormatAssumed(_)) && note.stops;
    assert!(report.notes.iter().any(is_assumed), "{:?}", report.notes);
}

/// Angles without a sequence can be read in those that are usual, in the unit that stands there.
#[wasm_bindgen_test(unsupported = test)]
fn usual_sequences_are_offered() {
    for (text, first) in [
        ("euler: [10, -20.5, 30]", "ZYX [10, -20.5, 30]"),
        ("Euler angles (deg): 10 -20.5 30", "ZYX 10 -20.5 30 deg"),
        ("euler 0.1 -0.2 0.3 rad", "ZYX 0.1 -0.2 0.3 rad"),
    ] {
        let problem = problem(text);
        assert_eq!(problem.code, ProblemCode::UnknownSequence, "{text}");
        let labels: Vec<_> = problem
            .choices
            .iter()
            .filter_map(|choice| choice.label.as_deref())
            .collect();
        assert_eq!(labels, ["ZYX", "xyz", "XYZ", "ZXZ"], "{text}");
        assert_eq!(problem.choices[0].text, first);
        assert!(
            problem
                .choices
                .iter()
                .all(|choice| choice.remedy == Remedy::WithSequence)
        );
    }
}

/// Degrees come back as they were written.
#[wasm_bindgen_test(unsupported = test)]
fn degrees_of_a_choice_are_short() {
    let problem = problem("a: rpy=[32.4, -13.9, -100.4] deg\nb: rpy=[12.5, 33.7, -61.2] deg");
    assert_eq!(problem.choices[0].text, "xyz 32.4deg -13.9deg -100.4deg");
}

/// Sixteen numbers in one line are rows or columns; a translation tells which.
#[wasm_bindgen_test(unsupported = test)]
fn rows_are_assumed_where_no_translation_tells_them() {
    let is_assumed = |text: &str| {
        let assumed = |note: &Note| matches!(note.fact, Fact::RowsAssumed(_)) && note.stops;
        notes(text).iter().any(assumed)
    };
    assert!(is_assumed("0.8 -0.6 0 0 0.6 0.8 0 0 0 0 1 0 0 0 0 1"));
    assert!(!is_assumed("0.8 -0.6 0 1.5 0.6 0.8 0 0 0 0 1 0 0 0 0 1"));
    assert!(!is_assumed("0.8 -0.6 0 0\n0.6 0.8 0 0\n0 0 1 0\n0 0 0 1"));
}

/// What is said behind the numbers in their line tells their order and their unit, wherever the line stands.
#[wasm_bindgen_test(unsupported = test)]
fn words_behind_numbers_are_read() {
    for remark in [
        "(scalar last)",
        "scalar last",
        "(x y z w)",
        "(x,y,z,w)",
        "in x,y,z,w order, why?",
        ", where the last entry is the scalar.",
        "# xyzw",
        "// x, y, z, w",
        "-- x, y, z, w",
        "# qx qy qz qw",
        "# xyzw\ntranslation: [1, 2, 3]",
    ] {
        let text = format!("rotation: {W_LAST} {remark}");
        let components = read(&text, "1 0 0", hamilton()).hamilton.unit;
        assert!(
            (components.w - 0.802696173189).abs() < 1e-9,
            "{text}: {components:?}"
        );
    }
    let text = format!("quaternion_order: xyzw\nquaternion: {W_LAST}");
    assert!((read(&text, "1 0 0", hamilton()).hamilton.unit.w - 0.802696173189).abs() < 1e-9);
    // Roll, pitch and yaw as above.
    for text in [
        "rpy: [12.5, 33.75, -61.2]  # degrees\nxyz: [1, 2, 3]",
        "# angles in degrees\nxyz: [1, 2, 3]\nrpy: [12.5, 33.75, -61.2]",
    ] {
        let report = read(text, "1 0 0", hamilton());
        assert!(
            (report.hamilton.unit.w - 0.802696173189).abs() < 1e-9,
            "{text}"
        );
        assert!(!report.notes.iter().any(|note| note.stops), "{text}");
    }
}

/// What is said behind the numbers, or was typed above them, may say that they are something else.
#[wasm_bindgen_test(unsupported = test)]
fn words_around_numbers_refuse_them() {
    let rows = "0.36 0.48 -0.8\n-0.8 0.6 0\n0.48 0.64 0.6";
    let refused = [
        format!("quaternion: {W_FIRST} (inverse)"),
        format!("q: {W_FIRST} -- conjugate!"),
        format!("quaternion: {W_FIRST} (left-handed)"),
        format!("rotation: {W_FIRST} # inverse\ntranslation: [1, 2, 3]"),
        format!("quaternion: {W_FIRST} rad/s"),
        format!("quaternion: {W_FIRST} m"),
        "rvec = [0.1 0.2 0.3] (per second)".to_owned(),
        format!(">> R'\n\nans =\n{rows}"),
        format!("octave:3> R'\nans =\n{rows}"),
        format!(">> rotm2quat(R')\nans =\n{W_FIRST}"),
        format!("julia> inv(R)\n{rows}"),
        format!("std::cout << R.transpose() << std::endl;\n{rows}"),
        format!("print(R.T)\n{rows}"),
        "R.T\narray([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])".to_owned(),
        "> t(R)\n      [,1] [,2] [,3]\n[1,] 0.36 0.48 -0.8\n[2,] -0.8 0.6 0\n[3,] 0.48 0.64 0.6"
            .to_owned(),
        format!("C.object.rotation_quaternion.inverted()\nQuaternion(({W_FIRST}))"),
        format!("U, S, Vt = np.linalg.svd(H)\nU:\n{rows}"),
        format!(">>> p.getDifferenceQuaternion(a, b)\n{W_FIRST}"),
    ];
    for text in refused {
        assert_eq!(problem(&text).code, ProblemCode::OtherQuantity, "{text}");
    }
}

/// A formula has no numbers to read, whatever sign of it is the first that is not known.
#[wasm_bindgen_test(unsupported = test)]
fn a_formula_is_told() {
    for text in [
        "R = I + sin(θ)K + (1-cos θ)K²",
        "q = q1 * q2",
        "C(q) = (2 q4^2 - 1) I - 2 q4 [q×] + 2 q q^T",
        r"R_{ij} = \frac{1}{2} \delta_{ij}",
    ] {
        let problem = problem(text);
        assert_eq!(problem.code, ProblemCode::Formula, "{text}");
    }
}

/// Marks on a name make another one of it, and names of a tuple are its own.
#[wasm_bindgen_test(unsupported = test)]
fn marks_on_names_refuse_them() {
    for name in [
        "q⁻¹",
        "q^-1",
        "R^T",
        "R'",
        "q*",
        "q†",
        "q\u{304}",
        "q\u{307}",
        "∂q",
        "σ_q",
        "2q",
        "q1 - q2",
        "q_a ⊗ q_b",
        "fx, fy, cx, cy",
        "z, y, x, w",
    ] {
        let text = format!("{name} = 0.8 0.2 -0.4 0.4");
        assert_eq!(problem(&text).code, ProblemCode::OtherQuantity, "{text}");
    }
    // A log and a moved axis are none of these.
    for text in [
        "12:30:01 - INFO - q: 0.8 0.2 -0.4 0.4",
        "Umeyama's method\nq: 0.8 0.2 -0.4 0.4",
    ] {
        assert!(
            (read(text, "1 0 0", hamilton()).hamilton.unit.w - 0.8).abs() < 1e-12,
            "{text}"
        );
    }
}

/// The order is that which the text tells anywhere, in names before the numbers, in a sentence or a table.
#[wasm_bindgen_test(unsupported = test)]
fn the_order_is_told_anywhere() {
    let numbers = &W_LAST[1..W_LAST.len() - 1];
    for text in [
        format!("qx, qy, qz, qw = {numbers}"),
        format!("[qx, qy, qz, qw] = {W_LAST}"),
        format!("T_WC (x y z qx qy qz qw): 0.1 0.2 0.3 {numbers}"),
        format!("# tx ty tz qx qy qz qw\npose = [0.1, 0.2, 0.3, {numbers}]"),
        format!("q = {W_LAST}\n\nin x, y, z, w order."),
        format!("The scalar comes last.\nq = {W_LAST}"),
        format!("; xyzw\nq = {W_LAST}"),
        format!("-- x, y, z, w\nlocal q = {{{numbers}}}"),
        format!(
            "<table><tr><th>qx</th><th>qy</th><th>qz</th><th>qw</th></tr><tr><td>{}</td></tr></table>",
            numbers.replace(", ", "</td><td>")
        ),
        format!(">>> p.getBasePositionAndOrientation(box)\n((0.1, 0.2, 0.5), ({numbers}))"),
        format!("> mesh.quaternion.toArray()\n(4) {W_LAST}"),
        format!("quat = np.array({W_LAST})\nr = R.from_quat(quat)"),
        format!("tf::Quaternion q({numbers});\ntf::Vector3 t(1,2,3);"),
    ] {
        let read = read(&text, "1 0 0", hamilton()).hamilton.unit;
        assert!((read.w - 0.802696173189).abs() < 1e-9, "{text}: {read:?}");
    }
    // Both are told.
    let text = format!("q = {W_FIRST}\nfrom w, x, y, z to x, y, z, w");
    assert!((read(&text, "1 0 0", hamilton()).hamilton.unit.w - 0.802696173189).abs() < 1e-9);
}

/// A flag in quotes is the name of the number behind it; names of angles in brackets tell which is which.
#[wasm_bindgen_test(unsupported = test)]
fn names_in_lists_are_names() {
    for text in [
        "arguments=['--x', '0.1', '--y', '0', '--z', '0.25', '--yaw', '-1.06814150222053', '--pitch', '0.589048622548086', '--roll', '0.218166156499291']",
        "(yaw, pitch, roll) = (-61.2, 33.75, 12.5) deg",
        "[yaw, pitch, roll]: [-61.2, 33.75, 12.5] deg",
    ] {
        let read = read(text, "1 0 0", hamilton()).hamilton.unit;
        assert!((read.w - 0.802696173189).abs() < 1e-9, "{text}: {read:?}");
    }
}

/// What is said anywhere and may be said of the numbers stops the reader.
#[wasm_bindgen_test(unsupported = test)]
fn what_is_said_elsewhere_stops() {
    let rows = "[0.36, 0.48, -0.8],\n[-0.8, 0.6, 0],\n[0.48, 0.64, 0.6]";
    for text in [
        format!("Note that this is the conjugate.\nq = {W_FIRST}"),
        format!("q = {W_FIRST}\nThis is already the inverse."),
        format!("I use a left_handed system.\nq = {W_FIRST}"),
        format!("MSCKF uses the JPL convention.\nq = {W_FIRST}"),
        format!("Transponierte Rotationsmatrix:\n{rows}"),
        format!("extrinsics (world -> cam):\n{rows}"),
        "inverse_pose:\n  rotation: {w: 0.8, x: 0.2, y: -0.4, z: 0.4}".to_owned(),
        format!("{{\"type\": \"world2cam\", \"rotation\": {W_FIRST}}}"),
        format!("R = np.array([{rows}])\nR = R.T"),
        format!("R1 = np.array([{rows}])\nR = R1 @ R2"),
        format!("quaternion_multiply(q0, {W_FIRST})"),
        "limits: roll 30 pitch 20 yaw 180 deg".to_owned(),
        "delta:\n  rotation: {w: 0.8, x: 0.2, y: -0.4, z: 0.4}".to_owned(),
    ] {
        let is_said = |note: &Note| matches!(note.fact, Fact::SaidElsewhere(_)) && note.stops;
        assert!(
            notes(&text).iter().any(is_said),
            "{text}: {:?}",
            notes(&text)
        );
    }
    for text in [
        format!("inverse kinematics solved\nq: {W_FIRST}"),
        format!("2 * pi\nq: {W_FIRST}"),
        format!("# as in the paper: R(q) transposes\nq = {W_FIRST}"),
    ] {
        let is_said = |note: &Note| matches!(note.fact, Fact::SaidElsewhere(_));
        if let Outcome::Read(report) = analyze(&read_request(&text, "1 0 0", hamilton())) {
            assert!(!report.notes.iter().any(is_said), "{text}");
        }
    }
}
