//! One bad input per file of `problems/`, with the whole text of its problem.
//!
//! Above the line `---` stands the input, below it what [`Problem::render`] says. A first line may
//! begin with `@`: `@field vector` puts the input into the vector field, `@repeat N` repeats it,
//! `@nest N` puts it into N pairs of brackets. To write the lower parts anew, and then to review
//! them as text: `QUATLAS_BLESS=1 cargo test --test text problems`.

use crate::asked::{problems, read_request};
use crate::checked::{answer, problem};
use quatlas::{Convention, Field, Outcome, Problem, Remedy, Suggestion, analyze};
use wasm_bindgen_test::wasm_bindgen_test;

macro_rules! cases {
    ($($name:literal,)+) => {
        &[$(($name, include_str!(concat!("problems/", $name, ".txt"))),)+]
    };
}

/// Every file of the folder; a native test sees to it that none is left out.
const CASES: &[(&str, &str)] = cases![
    "a-call-before-a-list",
    "a-call-of-euler-angles",
    "a-call-that-computes",
    "a-comment-of-a-conjugate",
    "a-comment-of-two-orders",
    "a-complex-number",
    "a-constructor-without-its-axis",
    "a-conversion-by-name",
    "a-date-before-numbers",
    "a-drawn-line",
    "a-frame-against-roll-pitch-yaw",
    "a-frame-that-touches",
    "a-frame-without-a-sequence",
    "a-function-of-units",
    "a-label-of-another-convention",
    "a-label-of-left-handed-axes",
    "a-label-of-rates",
    "a-label-of-something-else",
    "a-long-line",
    "a-mark-that-turns-the-writing",
    "a-matrix-of-unknown-layout",
    "a-matrix-without-its-third-axis",
    "a-method-after-the-value",
    "a-missing-yaw",
    "a-mixed-number",
    "a-number-before-a-list",
    "a-number-in-two-forms",
    "a-power-of-a-number",
    "a-question-mark",
    "a-rodrigues-vector",
    "a-sequence-against-its-frame",
    "a-sequence-against-the-names-of-angles",
    "a-sequence-of-two-axes-and-named-angles",
    "a-sequence-or-a-number",
    "a-sign-behind-its-number",
    "a-space-that-groups-digits",
    "a-sum-of-an-angle-and-a-number",
    "a-unit-beside-one-angle",
    "a-unit-mark-apart",
    "a-unit-of-tangents",
    "a-unit-vector-and-a-number",
    "a-vector-for-a-quaternion",
    "a-vector-of-the-opposite-direction",
    "a-word-of-a-declaration",
    "an-angle-among-numbers",
    "an-argument-of-a-template",
    "an-axis-that-a-call-does-not-normalise",
    "an-axis-that-follows-itself",
    "an-axis-that-follows-itself-in-a-call",
    "an-unknown-argument",
    "an-unseen-space-in-a-number",
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
    "commas-and-semicolons",
    "commas-between-some",
    "components-of-several-values",
    "dashes-before-a-number",
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
    "four-numbers-or-two-with-decimal-commas",
    "full-width-digits",
    "full-width-marks",
    "homogeneous-matrix",
    "infinity",
    "infinity-sign",
    "letters",
    "list-in-a-list",
    "list-times-number",
    "many-signs",
    "matlab-scale-factor",
    "matrix-far-from-a-rotation",
    "matrix-near-a-rotation",
    "matrix-of-eight-numbers",
    "matrix-of-eight-numbers-announced",
    "matrix-of-four-rows",
    "matrix-of-sixteen-numbers",
    "matrix-of-three-rows-of-four",
    "matrix-of-unequal-rows",
    "matrix-of-unequal-rows-in-brackets",
    "matrix-of-zeros",
    "matrix-that-is-a-reflection",
    "matrix-that-is-a-reflection-of-a-turn",
    "matrix-that-is-a-scaled-reflection",
    "matrix-that-is-minus-a-turn",
    "matrix-that-is-scaled",
    "matrix-that-is-scaled-beyond-squares",
    "matrix-that-is-scaled-to-almost-nothing",
    "matrix-with-a-nan",
    "matrix-with-scaled-columns",
    "matrix-without-an-inverse",
    "microsoft-nan",
    "minus-apart-from-its-number",
    "minus-between-spaces",
    "missing-component",
    "missing-components-of-json",
    "missing-number-at-the-end",
    "missing-sign",
    "missing-sign-after-a-comma",
    "nan",
    "nine-numbers-of-a-quaternion",
    "number-without-a-name",
    "numbers-by-name-of-a-norm-of-hundreds",
    "numbers-that-run-together",
    "numbers-that-run-together-to-three",
    "one-number",
    "only-spaces",
    "operator-without-a-number",
    "position-without-orientation",
    "product-of-units",
    "python-nan",
    "roll-with-an-axis",
    "root-of-a-negative-number",
    "several-angles-about-an-axis",
    "signs-in-a-row",
    "stray-closing-bracket",
    "tab-before-the-error",
    "ten-thousand-brackets",
    "ten-thousand-brackets-that-close",
    "text-of-200-kb",
    "the-last-number-without-a-name",
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
    "unclosed-brackets-in-brackets",
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
    "vector-of-grouped-digits",
    "vector-of-numbers-that-run-together",
    "vector-of-two",
    "vector-that-is-empty",
    "vector-with-a-missing-component",
    "vector-with-a-named-scalar",
    "vector-with-a-scalar",
    "vector-with-decimal-commas",
    "wide-characters-before-the-error",
    "zero-but-for-rounding",
    "zero-by-names",
    "zero-quaternion",
];

/// Each has a case at least.
const REMEDIES: &[Remedy] = &[
    Remedy::MatchBrackets,
    Remedy::DecimalPoints,
    Remedy::PlainCharacters,
    Remedy::RemoveMark,
    Remedy::AttachSign,
    Remedy::SeparateNumbers,
    Remedy::AddSign,
    Remedy::AddZeros,
    Remedy::NameNumber,
    Remedy::SameUnit,
    Remedy::WriteZero,
    Remedy::WriteIdentity,
    Remedy::RestoreAxis,
    Remedy::NearestRotation,
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
        problem(self.field, &self.input)
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
        let path = format!(
            "{}/tests/text/problems/{name}.txt",
            env!("CARGO_MANIFEST_DIR")
        );
        std::fs::write(path, format!("{upper}{rendered}")).expect("a writable folder");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_suggestion_is_read() {
    let mut suggested = Vec::new();
    for (name, file) in CASES {
        let (case, _) = Case::parse(file);
        let problem = case.problem();
        let suggestions = problem.suggestion.as_deref().into_iter();
        for Suggestion { remedy, text, .. } in suggestions.chain(&problem.choices) {
            let outcome = answer(case.field, text);
            assert!(
                matches!(outcome, Outcome::Read(_)),
                "{name}: {text}\n{outcome:?}"
            );
            suggested.push(*remedy);
        }
    }
    for remedy in REMEDIES {
        assert!(suggested.contains(remedy), "no case has {remedy:?}");
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn no_file_of_the_folder_is_left_out() {
    let folder = format!("{}/tests/text/problems", env!("CARGO_MANIFEST_DIR"));
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
    let [at_the_edge] = &problems(outcome.in_utf16(|_, _| text.to_owned()))[..] else {
        panic!("one problem")
    };
    assert_eq!((at_the_edge.span.start, at_the_edge.span.end), (13, 17));
}
