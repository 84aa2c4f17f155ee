//! What stands before and around a list: read with its words, or refused at the word.

use crate::asked::{facts, read};
use crate::checked::{check_read, check_refusal, check_refused};
use quatlas::{
    Convention, Fact, Field, IdentifyRequest, MatrixLayout, ObservationReport, Outcome, Probe,
    ProblemCode, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn what_stands_before_a_list_is_read_or_refused() {
    use ProblemCode::{Unexpected, UnknownWord};
    check_refused(&[
        (
            "rotvec sqrt(3) [1, 0, 0]",
            Unexpected,
            "sqrt(3)",
            "a factor",
        ),
        (
            "rotvec deg2rad(60) [1, 0, 0]",
            Unexpected,
            "deg2rad(60)",
            "a factor",
        ),
        ("rotvec 2 [1, 0, 0]", Unexpected, "2", "a factor"),
        (
            "axis=sqrt(2) [0, 1, 0], angle=0.3",
            Unexpected,
            "sqrt(2)",
            "a factor",
        ),
        ("rpy(3) [0.1, 0.2, 0.3]", Unexpected, "(3)", "a count"),
        ("XYZ(1) [0.1, 0.2, 0.3]", Unexpected, "(1)", "an index"),
        ("axisangle(1) [0, 1, 0, 0.3]", Unexpected, "(1)", "an index"),
        (
            "sqrt(2) [0.5, 0.5, 0.5, 0.5]",
            Unexpected,
            "sqrt(2)",
            "a factor",
        ),
        (
            "transpose(1) [[0,-1,0],[1,0,0],[0,0,1]]",
            UnknownWord,
            "transpose(1)",
            "transpose is not supported before a list",
        ),
        (
            "R = inv(3) [[0,-1,0],[1,0,0],[0,0,1]]",
            UnknownWord,
            "inv(3)",
            "inv is not supported before a list",
        ),
        (
            "matrix t(1) [[0,-1,0],[1,0,0],[0,0,1]]",
            UnknownWord,
            "t(1)",
            "t is not supported before a list",
        ),
        (
            "conj(2) [0.8, 0, 0.6, 0]",
            UnknownWord,
            "conj(2)",
            "conj is not supported before a list",
        ),
        (
            "inverse(4) [0.8, 0, 0.6, 0]",
            UnknownWord,
            "inverse(4)",
            "inverse is not supported before a list",
        ),
        (
            "q_xyzw(1) [0, 0.6, 0, 0.8]",
            UnknownWord,
            "q_xyzw(1)",
            "q_xyzw is not supported before a list",
        ),
        // Another number than that of the members is no length.
        (
            "Float32Array(9) [0.8, 0, 0.6, 0]",
            UnknownWord,
            "Float32Array(9)",
            "Float32Array is not supported before a list",
        ),
    ]);
    let of_vectors = [
        ("sqrt(2) [1, 0, 0]", Unexpected, "sqrt(2)", "a factor"),
        ("abs(2) [1, 2, 3]", Unexpected, "abs(2)", "a factor"),
        (
            "cross(2) [1, 2, 3]",
            UnknownWord,
            "cross(2)",
            "cross is not supported before a list",
        ),
        (
            "Vector3(2) [1, 2, 3]",
            UnknownWord,
            "Vector3(2)",
            "Vector3 is not supported before a list",
        ),
    ];
    for (text, code, place, word) in of_vectors {
        check_refusal(Field::Vector, text, code, place, word);
    }
    check_read(&[
        // A scalar and a vector part.
        ("cos(0.5) [0, sin(0.5), 0]", "1rad about y"),
        ("rotvec Float64Array(3) [ 0, 0.5, 0 ]", "0.5rad about y"),
        (
            "Array(3) [ Array(3) [ 0, -1, 0 ], Array(3) [ 1, 0, 0 ], Array(3) [ 0, 0, 1 ] ]",
            "90deg about z",
        ),
    ]);
}

/// What Node prints of nine numbers in a typed array, whose lines end anywhere: of gl-matrix they are
/// columns.
#[wasm_bindgen_test(unsupported = test)]
fn the_rows_of_a_list_that_a_console_prints_are_assumed() {
    for text in [
        "Mat3(9) [Float32Array] [\n  0, -1, 0, 1,\n  0, 0,\n 0, 0, 1\n]",
        "Float64Array(9) [ 0, -1, 0, 1, 0, 0, 0, 0, 1 ]",
        // Brackets around one number mark no row.
        "0, (-1), 0, 1, 0, 0, 0, 0, 1",
        r#"{"pose": {"R": [0, -1, 0, 1, 0, 0, 0, 0, 1]}}"#,
    ] {
        let report = read(text, "1 0 0", Convention::HAMILTON);
        let is_assumed = |fact: &Fact| matches!(fact, Fact::RowsAssumed(_));
        assert!(facts(&report).iter().any(is_assumed), "{text}: {report:?}");
    }
    // A library's own class of quaternions has an order that its name does not tell.
    let report = read("Quat(4) [ 0, 0.6, 0, 0.8 ]", "1 0 0", Convention::HAMILTON);
    let is_unknown = |fact: &Fact| matches!(fact, Fact::UnknownConstructor(_));
    assert!(facts(&report).iter().any(is_unknown), "{report:?}");
}

/// Sixteen numbers are the matrix of an observation by themselves, and not what a call makes of them.
#[wasm_bindgen_test(unsupported = test)]
fn words_before_sixteen_numbers_are_not_passed_over() {
    let numbers = "[[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]";
    let problem = |printed: String| {
        let probe = Probe::Matrix {
            quaternion: "0.5 0.5 0.5 0.5".to_owned(),
            printed,
            layout: MatrixLayout::Rows,
        };
        let request = quatlas::Request::Identify(IdentifyRequest::new(vec![probe]));
        let Outcome::Identify(report) = analyze(&request) else {
            panic!("an identification")
        };
        match &report.observations[..] {
            [ObservationReport::Problem(found)] => Some(found.problem.code),
            _ => None,
        }
    };
    assert_eq!(problem(numbers.to_owned()), None);
    assert_eq!(problem(format!("Array(4) {numbers}")), None);
    assert_eq!(
        problem(format!("transpose(4) {numbers}")),
        Some(ProblemCode::UnknownWord)
    );
    assert_eq!(
        problem(format!("-1 {numbers}")),
        Some(ProblemCode::Unexpected)
    );
}

/// As without the braces.
#[wasm_bindgen_test(unsupported = test)]
fn one_matrix_or_call_in_json_is_read() {
    check_read(&[
        (
            r#"{"extrinsic_R": [0, 0, 1, 0, 1, 0, -1, 0, 0]}"#,
            "90deg about y",
        ),
        (
            r#"{"R": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]}"#,
            "90deg about y",
        ),
        (
            r#"{"pose": {"R": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]}}"#,
            "90deg about y",
        ),
        (
            r#"[{"id": 7, "R": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]}]"#,
            "90deg about y",
        ),
        ("{R: 0 0 1 0 1 0 -1 0 0}", "90deg about y"),
        (
            "{q = Quaternion(axis=[0, 1, 0], radians=0.3)}",
            "0.3rad about y",
        ),
        (
            r#"{"a": {"q": Rotation.from_rotvec([0, 0.3, 0])}}"#,
            "0.3rad about y",
        ),
    ]);
    use ProblemCode::{NotARotation, OtherQuantity, Unexpected};
    let scaled = r#"{"K": [500, 0, 320, 0, 500, 240, 0, 0, 1]}"#;
    check_refused(&[
        (
            r#"{"R_inv": [0, 0, 1, 0, 1, 0, -1, 0, 0]}"#,
            OtherQuantity,
            r#""R_inv""#,
            "an inverse",
        ),
        (
            r#"{"inv": {"R": [0, 0, 1, 0, 1, 0, -1, 0, 0]}}"#,
            OtherQuantity,
            r#""inv""#,
            "an inverse",
        ),
        (scaled, NotARotation, scaled, "the nearest rotation"),
        // A component is no name of the whole.
        (
            r#"{"x": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]}"#,
            Unexpected,
            "[[0, 0, 1], [0, 1, 0], [-1, 0, 0]]",
            "unexpected list",
        ),
    ]);
}

/// In the field of a vector; behind a comma a list is a member, and no factor stands before it.
#[wasm_bindgen_test(unsupported = test)]
fn a_name_of_the_whole_stands_before_a_call() {
    for text in ["x = Eigen::Vector3d(1, 2, 3)", "x = np.array([1, 2, 3])"] {
        let vector = quatlas::parse_vector(text).expect(text);
        assert_eq!(vector.as_slice(), [1.0, 2.0, 3.0], "{text}");
    }
    let text = "2, [0, 0, 1]";
    let code = ProblemCode::Unexpected;
    check_refusal(Field::Vector, text, code, "[0, 0, 1]", "unexpected list");
}

/// What is closed does not count as open.
#[wasm_bindgen_test(unsupported = test)]
fn any_number_of_brackets_may_stand_beside_each_other() {
    let text = format!("{}0.6, 0, 0.8, 0", "(0)+".repeat(100));
    check_read(&[(&text, "w=0.6, x=0, y=0.8, z=0")]);
}

/// As many numbers as a homogeneous matrix has, announced as one.
#[wasm_bindgen_test(unsupported = test)]
fn a_matrix_of_four_rows_is_named() {
    // Its last row is that of no pose.
    let numbers = "0 -1 0 5 1 0 0 6 0 0 1 7 1 0 0 1";
    check_refused(&[(
        "matrix 0 -1 0 5 1 0 0 6 0 0 1 7 1 0 0 1",
        ProblemCode::WrongCount,
        numbers,
        "(4 by 4)",
    )]);
    check_read(&[("matrix 0 -1 0 5 1 0 0 6 0 0 1 7 0 0 0 1", "90deg about z")]);
}
