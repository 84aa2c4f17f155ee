//! One bad input per file of `problems/`, with the whole text of its problem.
//!
//! Above the line `---` stands the input, below it what [`Problem::render`] says. A first line may
//! begin with `@`: `@field vector` puts the input into the vector field, `@repeat N` repeats it,
//! `@nest N` puts it into N pairs of brackets. To write the lower parts anew, and then to review
//! them as text: `QUATLAS_BLESS=1 cargo test --test problems`.

mod common;

use common::{problems, read_request, wasm_bindgen_test};
use quatlas::{Convention, Field, Outcome, Problem, ProblemCode, analyze};

macro_rules! cases {
    ($($name:literal,)+) => {
        &[$(($name, include_str!(concat!("problems/", $name, ".txt"))),)+]
    };
}

/// Every file of the folder; a native test sees to it that none is left out.
const CASES: &[(&str, &str)] = cases![
    "a-call-of-euler-angles",
    "a-call-that-computes",
    "a-constructor-without-its-axis",
    "a-conversion-by-name",
    "a-function-of-units",
    "a-label-of-rates",
    "a-long-line",
    "a-matrix-of-unknown-layout",
    "a-method-after-the-value",
    "a-missing-yaw",
    "a-number-in-two-forms",
    "a-sequence-against-its-frame",
    "a-sequence-or-a-number",
    "a-sum-of-an-angle-and-a-number",
    "a-unit-beside-one-angle",
    "a-unit-vector-and-a-number",
    "an-angle-among-numbers",
    "an-axis-that-a-call-does-not-normalise",
    "an-axis-that-follows-itself",
    "an-axis-that-follows-itself-in-a-call",
    "an-unknown-argument",
    "angle-without-an-axis",
    "arc-cosine-beyond-1",
    "assignment-without-a-value",
    "axis-and-angle-by-label",
    "axis-and-angle-in-a-constructor",
    "axis-angle-of-three-numbers",
    "axis-of-length-zero",
    "axis-of-length-zero-in-a-call",
    "axis-without-an-angle",
    "axis-without-an-angle-by-name",
    "capitals-and-small-letters",
    "commas-between-some",
    "components-of-several-values",
    "decimal-comma-of-an-angle",
    "decimal-commas",
    "decimal-commas-that-make-four",
    "degrees-and-a-unit-for-all",
    "degrees-and-radians",
    "degrees-beside-pi",
    "degrees-of-pi",
    "difference-in-a-list",
    "division-by-a-difference-that-is-zero",
    "division-by-a-unit",
    "division-by-zero",
    "double-colon",
    "duplicate-component",
    "emoji",
    "emoji-before-the-error",
    "emoji-in-a-comment-before-the-error",
    "empty-text",
    "euler-angles-without-a-sequence",
    "five-numbers",
    "four-numbers-of-roll-pitch-yaw",
    "infinity",
    "infinity-sign",
    "letters",
    "list-in-a-list",
    "list-times-number",
    "many-signs",
    "matlab-scale-factor",
    "matrix-far-from-a-rotation",
    "matrix-of-eight-numbers",
    "matrix-of-eight-numbers-announced",
    "matrix-of-four-rows",
    "matrix-of-sixteen-numbers",
    "matrix-of-three-rows-of-four",
    "matrix-of-unequal-rows",
    "matrix-of-unequal-rows-in-brackets",
    "matrix-of-zeros",
    "matrix-that-is-a-reflection",
    "matrix-that-is-scaled",
    "matrix-that-is-scaled-beyond-squares",
    "matrix-that-is-scaled-to-almost-nothing",
    "matrix-with-a-nan",
    "matrix-without-an-inverse",
    "microsoft-nan",
    "minus-apart-from-its-number",
    "missing-component",
    "missing-number-at-the-end",
    "missing-sign",
    "nan",
    "nine-numbers-of-a-quaternion",
    "number-without-a-name",
    "one-number",
    "only-spaces",
    "operator-without-a-number",
    "position-without-orientation",
    "product-of-units",
    "python-nan",
    "roll-with-an-axis",
    "root-of-a-negative-number",
    "several-angles-about-an-axis",
    "stray-closing-bracket",
    "tab-before-the-error",
    "ten-thousand-brackets",
    "ten-thousand-brackets-that-close",
    "text-of-100-kb",
    "three-numbers",
    "too-large",
    "too-large-product",
    "too-small",
    "two-arguments",
    "two-euler-angles",
    "two-missing-components",
    "two-numbers-of-a-rotation-vector",
    "two-numbers-that-touch",
    "two-rolls",
    "two-units-of-one-angle",
    "uncertainty-in-brackets",
    "unclosed-bracket",
    "unclosed-bracket-at-the-end",
    "unit-in-a-function",
    "unit-under-a-name",
    "unknown-axis",
    "unknown-component",
    "unknown-keyword",
    "unknown-method",
    "vector-from-a-call-that-computes",
    "vector-from-a-rotation-vector-by-label",
    "vector-of-angles-by-label",
    "vector-of-coefficients-in-a-constructor",
    "vector-of-four",
    "vector-of-two",
    "vector-that-is-empty",
    "vector-with-a-missing-component",
    "vector-with-a-named-scalar",
    "vector-with-a-scalar",
    "wide-characters-before-the-error",
    "zero-by-names",
    "zero-quaternion",
];

struct Case {
    input: String,
    field: Field,
}

impl Case {
    fn parse(file: &str) -> (Self, &str) {
        let (upper, expected) = file.split_once("---\n").expect("a line ---");
        let (directive, text) = match upper.strip_prefix('@') {
            Some(rest) => rest.split_once('\n').expect("a line after the directive"),
            None => ("", upper),
        };
        let text = text.strip_suffix('\n').unwrap_or(text);
        let count = |number: &str| number.parse().expect("a number");
        let (input, field) = match directive.split_once(' ') {
            None => (text.to_owned(), Field::Quaternion),
            Some(("field", "vector")) => (text.to_owned(), Field::Vector),
            Some(("repeat", number)) => (text.repeat(count(number)), Field::Quaternion),
            Some(("nest", number)) => {
                let (open, close) = ("[".repeat(count(number)), "]".repeat(count(number)));
                (format!("{open}{text}{close}"), Field::Quaternion)
            }
            Some(other) => panic!("unknown directive {other:?}"),
        };
        (Self { input, field }, expected)
    }

    fn problem(&self) -> Problem {
        let request = match self.field {
            Field::Vector => read_request("1 0 0 0", &self.input, Convention::HAMILTON),
            _ => read_request(&self.input, "1 0 0", Convention::HAMILTON),
        };
        let [problem] = problems(analyze(&request)).try_into().expect("one problem");
        problem
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_bad_input_has_the_message_of_its_file() {
    let mut differences = Vec::new();
    for (name, file) in CASES {
        let (case, expected) = Case::parse(file);
        let problem = case.problem();
        assert_eq!(problem.field, case.field, "{name}");
        let rendered = problem.render(&case.input);
        if rendered != expected {
            bless(name, file, expected, &rendered);
            differences.push(format!(
                "{name}\n--- expected\n{expected}--- got\n{rendered}"
            ));
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

#[cfg(target_arch = "wasm32")]
fn bless(_: &str, _: &str, _: &str, _: &str) {}

#[cfg(not(target_arch = "wasm32"))]
fn bless(name: &str, file: &str, expected: &str, rendered: &str) {
    if std::env::var_os("QUATLAS_BLESS").is_some() {
        let upper = file
            .strip_suffix(expected)
            .expect("the file ends as expected");
        let path = format!("{}/tests/problems/{name}.txt", env!("CARGO_MANIFEST_DIR"));
        std::fs::write(path, format!("{upper}{rendered}")).expect("a writable folder");
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn no_file_of_the_folder_is_left_out() {
    let folder = format!("{}/tests/problems", env!("CARGO_MANIFEST_DIR"));
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "txt"))
        .map(|path| {
            path.file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    files.sort();
    let listed: Vec<_> = CASES.iter().map(|(name, _)| *name).collect();
    assert_eq!(files, listed);
}

/// Texts that could be read as another rotation than was meant, and where the problem stands.
const MISLEADING: &[(&str, ProblemCode, &str)] = &[
    ("45°+30/60 about z", ProblemCode::MixedUnits, "45°+30/60"),
    ("0.5 - 45° about z", ProblemCode::MixedUnits, "0.5 - 45°"),
    ("90° + pi/2 about z", ProblemCode::MixedUnits, "90° + pi/2"),
    ("90° + 1rad about z", ProblemCode::MixedUnits, "90° + 1rad"),
    ("45° * (2°) about z", ProblemCode::MixedUnits, "45° * (2°)"),
    ("pi/2 deg about z", ProblemCode::MixedUnits, "pi/2"),
    ("ZYX pi/2 0 0 deg", ProblemCode::MixedUnits, "pi/2"),
    // Columns in these libraries, or vectors as rows.
    (
        "Gf.Matrix3d(0,-1,0,1,0,0,0,0,1)",
        ProblemCode::UnknownWord,
        "Gf.Matrix3d(0,-1,0,1,0,0,0,0,1)",
    ),
    (
        "new Matrix3f(0,-1,0,1,0,0,0,0,1)",
        ProblemCode::UnknownWord,
        "Matrix3f(0,-1,0,1,0,0,0,0,1)",
    ),
    (
        "org.joml.Matrix3d(1,0,0,0,1,0,0,0,1)",
        ProblemCode::UnknownWord,
        "org.joml.Matrix3d(1,0,0,0,1,0,0,0,1)",
    ),
    (
        "Matrix3::new(1,0,0,0,1,0,0,0,1)",
        ProblemCode::UnknownWord,
        "Matrix3::new(1,0,0,0,1,0,0,0,1)",
    ),
    (
        "cgmath::Matrix3::new(1,0,0,0,1,0,0,0,1)",
        ProblemCode::UnknownWord,
        "cgmath::Matrix3::new(1,0,0,0,1,0,0,0,1)",
    ),
    (
        "vec3(0,-1,0), vec3(1,0,0), vec3(0,0,1)",
        ProblemCode::UnknownWord,
        "vec3(0,-1,0)",
    ),
    (
        "wxyz2xyzw([0.92, 0, 0, 0.38])",
        ProblemCode::UnknownWord,
        "wxyz2xyzw([0.92, 0, 0, 0.38])",
    ),
    (
        "wxyzToXyzw(0.92, 0, 0, 0.38)",
        ProblemCode::UnknownWord,
        "wxyzToXyzw(0.92, 0, 0, 0.38)",
    ),
    (
        "q_wxyz_from_xyzw = [0.92, 0, 0, 0.38]",
        ProblemCode::UnknownWord,
        "q_wxyz_from_xyzw",
    ),
    // Neither library divides the axis by its length.
    (
        "glm::angleAxis(1.0f, glm::vec3(1,1,0))",
        ProblemCode::NotARotation,
        "glm::vec3(1,1,0)",
    ),
    (
        "q.setFromAxisAngle(new THREE.Vector3(0,0,2), 1)",
        ProblemCode::NotARotation,
        "THREE.Vector3(0,0,2)",
    ),
    (
        "R.from_rotvec([0,0,1], degrees='False')",
        ProblemCode::UnknownComponent,
        "'False'",
    ),
    (
        "R.from_quat([0,0,0,1], scalar_first=1)",
        ProblemCode::UnknownComponent,
        "1",
    ),
    // An axis and its angle, or a quaternion that is not normalised.
    (
        "(array([0., 0., 1.]), 1.5707963267948966)",
        ProblemCode::Unexpected,
        "(array([0., 0., 1.]), 1.5707963267948966)",
    ),
    (
        "(1.57, [0, 0, 1])",
        ProblemCode::Unexpected,
        "(1.57, [0, 0, 1])",
    ),
    (
        "Quaternion(1.57, [0, 0, 1])",
        ProblemCode::Unexpected,
        "Quaternion(1.57, [0, 0, 1])",
    ),
    ("321 30 20 10", ProblemCode::UnknownSequence, "321"),
    ("[313, 30, 20, 10]", ProblemCode::UnknownSequence, "313"),
    // Which of two rotations is meant is not said.
    (
        r#"<origin rpy="0 0 1"/> <origin rpy="0 0 2"/>"#,
        ProblemCode::MixedNames,
        r#"rpy="0 0 2""#,
    ),
    (
        "orientation:\n x: 0\n y: 0\n z: 0\n w: 1\norientation:\n x: 1\n y: 0\n z: 0\n w: 2",
        ProblemCode::MixedNames,
        "1",
    ),
    (
        "a.orientation.w=1 a.orientation.x=2 b.orientation.w=3 b.orientation.x=4",
        ProblemCode::MixedNames,
        "3",
    ),
    (
        r#"{"orientation": [0, 0, 0, 1], "rotation": [1, 0, 0, 0]}"#,
        ProblemCode::MixedNames,
        "[1, 0, 0, 0]",
    ),
    (
        r#"{"quaternion": [0, 0, 0, 1], "rpy": [1, 0, 0]}"#,
        ProblemCode::MixedNames,
        "[1, 0, 0]",
    ),
    // Words that may change the numbers.
    (
        "ZYX 30 20 10, frame=extrinsic",
        ProblemCode::UnknownComponent,
        "frame",
    ),
    (
        "RPY(0.1, 0.2, 0.3, order='xyz')",
        ProblemCode::UnknownComponent,
        "order",
    ),
    (
        "rpy: [1, 2, 3]\nconvention: intrinsic",
        ProblemCode::UnknownComponent,
        "convention",
    ),
    (
        r#"{"matrix": [0,-1,0,1,0,0,0,0,1], "layout": "column-major"}"#,
        ProblemCode::UnknownComponent,
        r#""layout""#,
    ),
    (
        "np.array([[0,-1,0],[1,0,0],[0,0,1]], order='F')",
        ProblemCode::UnknownComponent,
        "order",
    ),
    (
        "[[0,-1,0],[1,0,0],[0,0,1]], transpose=true",
        ProblemCode::UnknownComponent,
        "transpose",
    ),
    (
        "matrix 0 -1 0 1 0 0 0 0 s=1",
        ProblemCode::UnknownComponent,
        "s",
    ),
    (
        r#"{"w": 1, "x": 0, "y": 0, "z": 0, "handedness": "left"}"#,
        ProblemCode::UnknownComponent,
        r#""handedness""#,
    ),
    (
        r#"{"rotation": [1, 0, 0, 0], "handedness": "left"}"#,
        ProblemCode::UnknownComponent,
        r#""handedness""#,
    ),
    (
        r#"{"rotation": [1, 0, 0, 0], "unit": "deg"}"#,
        ProblemCode::UnknownComponent,
        r#""unit""#,
    ),
    (
        r#"{"w": 1, "x": 0, "y": 0, "z": 0, "type": "JPL"}"#,
        ProblemCode::UnknownComponent,
        r#""type""#,
    ),
    (
        r#"{"rpy": [1, 2, 3], "unit": "turns"}"#,
        ProblemCode::UnknownComponent,
        r#""unit""#,
    ),
    (
        r#"{"rpy": [1, 2, 3], "order": "xyzw"}"#,
        ProblemCode::UnknownComponent,
        r#""order""#,
    ),
    (
        "Eigen::Quaterniond(1, 0, 0, 0), order=xyzw",
        ProblemCode::UnknownComponent,
        "order",
    ),
    (
        "q_wxyz = [1, 0, 0, 0], order=xyzw",
        ProblemCode::UnknownComponent,
        "q_wxyz",
    ),
    ("45deg about z, unit=rad", ProblemCode::MixedUnits, "45deg"),
    (
        "rpy: 1 2 3\nunit: deg\nunits: rad",
        ProblemCode::MixedUnits,
        "units: rad",
    ),
    // Labels that only contain a word.
    ("rpy_rate: 1 2 3", ProblemCode::UnknownWord, "rpy_rate"),
    (
        "rpy_rate (deg): 1 2 3",
        ProblemCode::UnknownWord,
        "rpy_rate",
    ),
    (
        "rpy_std_deg = [1, 2, 3]",
        ProblemCode::UnknownWord,
        "rpy_std_deg",
    ),
    ("ypr_cov: 1 2 3", ProblemCode::UnknownWord, "ypr_cov"),
    (
        "euler_rates: ZYX 1 2 3",
        ProblemCode::UnknownWord,
        "euler_rates",
    ),
    (
        "rotvec_of_a: 1 2 3",
        ProblemCode::UnknownWord,
        "rotvec_of_a",
    ),
    (
        "inverse_matrix = [[0,-1,0],[1,0,0],[0,0,1]]",
        ProblemCode::UnknownWord,
        "inverse_matrix",
    ),
    (
        "R.T = [[0,-1,0],[1,0,0],[0,0,1]]",
        ProblemCode::UnknownWord,
        "R.T",
    ),
    (
        r#"{"q_dot": {"w": 1, "x": 0, "y": 0, "z": 0}}"#,
        ProblemCode::UnknownWord,
        r#""q_dot""#,
    ),
    (
        "q_dot:\n w: 1\n x: 0\n y: 0\n z: 0",
        ProblemCode::UnknownWord,
        "w",
    ),
    (
        "rpy_deg (rad): 1 2 3",
        ProblemCode::MixedUnits,
        "rpy_deg (rad):",
    ),
    (
        "rpy (deg) (rad) 1 2 3",
        ProblemCode::MixedUnits,
        "rpy (deg) (rad)",
    ),
    (
        "roll_deg=10 pitch_rad=0.2 yaw_deg=30",
        ProblemCode::MixedUnits,
        "0.2",
    ),
];

#[wasm_bindgen_test(unsupported = test)]
fn what_could_be_read_as_another_rotation_is_refused_at_its_place() {
    for (text, code, place) in MISLEADING {
        let outcome = analyze(&read_request(text, "1 0 0", Convention::HAMILTON));
        let Outcome::Problems(found) = outcome else {
            panic!("{text} is read: {outcome:?}")
        };
        let [problem] = &found.problems[..] else {
            panic!("{text}: {found:?}")
        };
        assert_eq!(problem.code, *code, "{text}");
        assert_eq!(
            &text[problem.span.start..problem.span.end],
            *place,
            "{text}"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn both_texts_are_answered_at_once() {
    let request = read_request("1 0 0", "oops", Convention::JPL);
    let fields: Vec<_> = problems(analyze(&request))
        .iter()
        .map(|problem| problem.field)
        .collect();
    assert_eq!(fields, [Field::Quaternion, Field::Vector]);
}

#[wasm_bindgen_test(unsupported = test)]
fn spans_count_utf16_units_at_the_edge() {
    // The emoji takes 4 bytes and 2 UTF-16 units, each of the letters 3 bytes and 1 unit.
    let text = "1 0 0 # 🙂四元\noops";
    let outcome = analyze(&read_request(text, "1 0 0", Convention::HAMILTON));
    let [inside] = &problems(outcome.clone())[..] else {
        panic!("{outcome:?}")
    };
    assert_eq!(&text[inside.span.start..inside.span.end], "oops");
    let [at_the_edge] = &problems(outcome.in_utf16(|_| text.to_owned()))[..] else {
        panic!("one problem")
    };
    assert_eq!((at_the_edge.span.start, at_the_edge.span.end), (13, 17));
}
