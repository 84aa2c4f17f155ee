//! Texts whose words say something of their numbers: read as the words say, or refused at the word.

mod common;
#[path = "common/texts.rs"]
mod texts;

use common::{facts, read, wasm_bindgen_test};
use quatlas::{
    Convention, Fact, IdentifyRequest, MatrixLayout, ObservationReport, Outcome, Probe,
    ProblemCode, analyze,
};
use texts::{check_read, check_refusal, check_refused};

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
            "transpose does",
        ),
        (
            "R = inv(3) [[0,-1,0],[1,0,0],[0,0,1]]",
            UnknownWord,
            "inv(3)",
            "inv does",
        ),
        (
            "matrix t(1) [[0,-1,0],[1,0,0],[0,0,1]]",
            UnknownWord,
            "t(1)",
            "t does",
        ),
        (
            "conj(2) [0.8, 0, 0.6, 0]",
            UnknownWord,
            "conj(2)",
            "conj does",
        ),
        (
            "inverse(4) [0.8, 0, 0.6, 0]",
            UnknownWord,
            "inverse(4)",
            "inverse does",
        ),
        (
            "q_xyzw(1) [0, 0.6, 0, 0.8]",
            UnknownWord,
            "q_xyzw(1)",
            "q_xyzw does",
        ),
        // Another number than that of the members is no length.
        (
            "Float32Array(9) [0.8, 0, 0.6, 0]",
            UnknownWord,
            "Float32Array(9)",
            "Float32Array does",
        ),
    ]);
    let of_vectors = [
        ("sqrt(2) [1, 0, 0]", Unexpected, "sqrt(2)", "a factor"),
        ("abs(2) [1, 2, 3]", Unexpected, "abs(2)", "a factor"),
        ("cross(2) [1, 2, 3]", UnknownWord, "cross(2)", "cross does"),
        (
            "Vector3(2) [1, 2, 3]",
            UnknownWord,
            "Vector3(2)",
            "Vector3 does",
        ),
    ];
    for (text, code, place, word) in of_vectors {
        check_refusal(text, "1 0 0 0", text, code, place, word);
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

#[wasm_bindgen_test(unsupported = test)]
fn words_of_declarations_and_arguments_of_templates_say_something() {
    use ProblemCode::UnknownWord;
    check_refused(&[
        ("rpy var: 0.1 0.2 0.3", UnknownWord, "var", "a spread"),
        ("rpy var = 0.1 0.2 0.3", UnknownWord, "var", "a spread"),
        ("var rpy: 0.1 0.2 0.3", UnknownWord, "var", "a spread"),
        (
            "var 0.5 0.5 -0.5 0.5",
            UnknownWord,
            "var",
            "what these numbers are",
        ),
        (
            "let 0.5 0.5 -0.5 0.5",
            UnknownWord,
            "let",
            "what these numbers are",
        ),
        (
            "static ZYX 0.1 0.2 0.3",
            UnknownWord,
            "static",
            "what these numbers are",
        ),
        ("rotvec new 0.1 0.2 0.3", UnknownWord, "new", "not a number"),
        (
            "Quaternion<left>(0.5, 0.5, -0.5, 0.5)",
            UnknownWord,
            "Quaternion<left>(0.5, 0.5, -0.5, 0.5)",
            "not applied",
        ),
        (
            "rpy<intrinsic>(0.1, 0.2, 0.3)",
            UnknownWord,
            "rpy<intrinsic>(0.1, 0.2, 0.3)",
            "not applied",
        ),
    ]);
    check_read(&[
        ("rotvec<deg>(0, 30, 0)", "30deg about y"),
        ("rotvec<rad>(0, 0.5, 0)", "0.5rad about y"),
        ("(double(0.8), 0, double(0.6), 0)", "w=0.8, x=0, y=0.6, z=0"),
        (
            "(const Eigen::Quaterniond q(0.8, 0, 0.6, 0))",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "{const auto q = [0.8, 0, 0.6, 0]}",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        ("Quaternion<xyzw>(0, 0.6, 0, 0.8)", "w=0.8, x=0, y=0.6, z=0"),
        (
            "Quaternion<double>(w=0.8, x=0, y=0.6, z=0)",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "static const std::float64_t q[4] = {0.8, 0, 0.6, 0};",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "const auto q = Eigen::Quaterniond(0.8, 0, 0.6, 0);",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "let q: Quat<f32> = from_xyzw(0, 0.6, 0, 0.8);",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "var w = 0.8, x = 0, y = 0.6, z = 0;",
            "w=0.8, x=0, y=0.6, z=0",
        ),
    ]);
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
    use ProblemCode::{NotARotation, Unexpected, UnknownWord};
    let scaled = r#"{"K": [500, 0, 320, 0, 500, 240, 0, 0, 1]}"#;
    check_refused(&[
        (
            r#"{"R_inv": [0, 0, 1, 0, 1, 0, -1, 0, 0]}"#,
            UnknownWord,
            r#""R_inv""#,
            "an inverse",
        ),
        (
            r#"{"inv": {"R": [0, 0, 1, 0, 1, 0, -1, 0, 0]}}"#,
            UnknownWord,
            r#""inv""#,
            "an inverse",
        ),
        (scaled, NotARotation, scaled, "the nearest rotation"),
        // A component is no name of the whole.
        (
            r#"{"x": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]}"#,
            Unexpected,
            "[[0, 0, 1], [0, 1, 0], [-1, 0, 0]]",
            "a list",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_turn_about_an_axis_has_one_angle_and_its_words_bare() {
    use ProblemCode::{Unexpected, UnexpectedEnd, UnknownWord, WrongCount};
    check_refused(&[
        // The angle stands before `about` or behind `by`, not in both places.
        ("30deg about y by 25deg", UnknownWord, "y", "y is not"),
        // In quotes they are values.
        (r#"about y "by" 25deg"#, UnexpectedEnd, "", "no angle"),
        (
            r#""rotate" 25deg about y"#,
            WrongCount,
            r#""rotate" 25deg"#,
            "one angle",
        ),
        // A component and a number are no names of the whole.
        ("x = 25deg about y", WrongCount, "x = 25deg", "one angle"),
        ("0: 25deg about y", Unexpected, ":", "cannot stand here"),
        // Three brackets are looked behind, as below, and not more.
        ("[[[[25deg about y]]]]", Unexpected, "25deg", "an angle"),
    ]);
    check_read(&[("[[[25deg about y]]]", "25deg about y")]);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_angle_beside_an_axis_is_no_angle_beside_something_else() {
    use ProblemCode::{MixedNames, Unexpected, UnknownComponent, UnknownWord, WrongCount};
    check_refused(&[
        ("25deg, b=[0, 1, 0]", MixedNames, "25deg", "no name"),
        ("a=25deg [0, 1, 0]", Unexpected, "25deg", "an angle"),
        // `j` is a part of a quaternion.
        ("(j, 25deg)", Unexpected, "25deg", "an angle"),
        (
            "axis-angle [0, 1, 0] half",
            WrongCount,
            "[0, 1, 0] half",
            "something else",
        ),
        (
            "axis-angle 2 25deg",
            WrongCount,
            "2 25deg",
            "something else",
        ),
        // An axis has no unit.
        (
            "axis_deg=[0, 1, 0], angle=25deg",
            UnknownComponent,
            "axis_deg",
            "not a component",
        ),
        (
            "ZYX [[R.from_rotvec([0, 0.5, 0])]]",
            UnknownWord,
            "[[R.from_rotvec([0, 0.5, 0])]]",
            "R.from_rotvec is not",
        ),
    ]);
    check_read(&[
        ("axis-angle y-25deg", "-25deg about y"),
        ("rotvec_deg 0 25 0 deg", "25deg about y"),
        // The call of OpenCV tells which vector it takes.
        ("Rodrigues(0, 0.5, 0)", "0.5rad about y"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn only_touching_shifts_behind_a_name_begin_a_matrix() {
    use ProblemCode::{MixedUnits, UnclosedBracket, UnknownWord};
    check_refused(&[
        (
            "R < < 0, 0, 1, 0, 1, 0, -1, 0, 0",
            UnknownWord,
            "R",
            "not a number",
        ),
        (
            "<< 0, 0, 1, 0, 1, 0, -1, 0, 0",
            UnclosedBracket,
            "<",
            "never closed",
        ),
        (
            "R << 0, 0, 1, 0, 1, 0, -1, 0, 0 deg",
            MixedUnits,
            "<<",
            "another unit",
        ),
    ]);
}

/// Words in quotes are words, and no name of a call; a quote ends in its line.
#[wasm_bindgen_test(unsupported = test)]
fn quotes_make_a_word_of_one_line() {
    use ProblemCode::{UnexpectedCharacter, UnknownWord};
    check_refused(&[
        (
            "'Float64Array'(4) [0.6, 0, 0.8, 0]",
            UnknownWord,
            "'Float64Array'",
            "what these numbers are",
        ),
        (
            "'10' 020 0 0",
            UnknownWord,
            "'10'",
            "what these numbers are",
        ),
        (
            "q' = 0.6 0 0.8 0\np' = 1 0 0 0",
            UnexpectedCharacter,
            "'",
            "no meaning",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_setting_stands_behind_a_call_too_and_its_value_is_a_word() {
    check_read(&[(
        "np.array([0, 0, 0.6, 0.8]), order=xyzw",
        "w=0.8, x=0, y=0, z=0.6",
    )]);
    check_refused(&[(
        "order: 321, roll: 10 deg, pitch: 20 deg, yaw: 30 deg",
        ProblemCode::UnknownComponent,
        "order",
        "not a component",
    )]);
}

/// In the field of a vector; behind a comma a list is a member, and no factor stands before it.
#[wasm_bindgen_test(unsupported = test)]
fn a_name_of_the_whole_stands_before_a_call() {
    for text in ["x = Eigen::Vector3d(1, 2, 3)", "x = np.array([1, 2, 3])"] {
        let vector = quatlas::parse_vector(text, quatlas::Field::Vector).expect(text);
        assert_eq!(vector.as_slice(), [1.0, 2.0, 3.0], "{text}");
    }
    let text = "2, [0, 0, 1]";
    let code = ProblemCode::Unexpected;
    check_refusal(text, "1 0 0 0", text, code, "[0, 0, 1]", "a list cannot");
}

#[wasm_bindgen_test(unsupported = test)]
fn forty_characters_of_an_unknown_constructor_are_told() {
    let told = |length: usize| {
        let text = format!("{:a>length$}(1, 0, 0, 0)", "quat");
        let name = format!("{:a>length$}", "quat");
        let told = facts(&read(&text, "1 0 0", Convention::HAMILTON));
        let found = told.into_iter().find_map(|fact| match fact {
            Fact::UnknownConstructor(unknown) => Some(unknown.name),
            _ => None,
        });
        (name, found.expect("a note"))
    };
    let (name, found) = told(40);
    assert_eq!(found, name);
    let (name, found) = told(41);
    assert_eq!(found, format!("{}…", &name[..40]));
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
    let numbers = "0 -1 0 5 1 0 0 6 0 0 1 7 0 0 0 1";
    check_refused(&[(
        "matrix 0 -1 0 5 1 0 0 6 0 0 1 7 0 0 0 1",
        ProblemCode::WrongCount,
        numbers,
        "(4 by 4)",
    )]);
}

/// Between a word that announces and the mark of a label nothing is passed over that would change the numbers.
#[wasm_bindgen_test(unsupported = test)]
fn a_label_behind_an_announcement_is_not_passed_over() {
    use ProblemCode::UnknownWord;
    check_refused(&[
        (
            "rotvec in degrees: 0 0 7",
            UnknownWord,
            "degrees",
            "what these",
        ),
        ("rotvec turns: 0 0 0.2", UnknownWord, "turns", "what these"),
        (
            "rotation vector in mrad = 0 0 7",
            UnknownWord,
            "mrad",
            "what these",
        ),
        ("gibbs neg: 0 0 0.3", UnknownWord, "neg", "what these"),
        ("mrp inv: 0 0 0.3", UnknownWord, "inv", "an inverse"),
        (
            "quaternion inverse: 0.8 0 0 0.6",
            UnknownWord,
            "inverse",
            "an inverse",
        ),
        ("rpy half = 0.1 0.2 0.3", UnknownWord, "half", "what these"),
    ]);
    check_read(&[
        ("rotvec deg: 0 0 7", "7deg about z"),
        ("rotvec (deg): 0 0 7", "7deg about z"),
        ("rotvec tool: 0 0 0.2", "0.2rad about z"),
    ]);
}
