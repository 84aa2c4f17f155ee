//! Texts as programs print them, of `tests/cases`: how many are read right, at once or by a button, and that none
//! is read as another rotation.

use quatlas::{Convention, Outcome, Problem, Request, Suggestion, analyze};
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

const PRINTED: &str = include_str!("../cases/printed.json");
const LOOKALIKES: &str = include_str!("../cases/lookalikes.json");

/// Those of `printed.json` that have a rotation and are refused, with no button that reads it.
const REFUSED: &[&str] = &[
    // Which of two lists is the rotation stands in the line that was typed.
    "opencv-solvepnp-tuple",
];

/// Those of `printed.json` that are read as another rotation.
const MISREAD: &[&str] = &[
    // A rotation vector is not declared to lead from world to body.
    "opencv-solvepnp",
];

/// Those of `lookalikes.json` that are read without a note that stops.
const LOOKALIKES_READ: &[&str] = &[];

/// Of those that have a rotation so many are read, at once or by a button.
const LEAST_READ: f64 = 0.95;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Right,
    ByButton,
    /// It is asked, or refused, as it should be.
    Asked,
    Refused,
    Misread,
}

#[wasm_bindgen_test(unsupported = test)]
fn what_programs_print_is_read_and_never_misread() {
    let verdicts = verdicts(PRINTED);
    let of = |verdict: Verdict| ids(&verdicts, verdict);
    assert_eq!(of(Verdict::Misread), MISREAD);
    assert_eq!(of(Verdict::Refused), REFUSED);
    let read = of(Verdict::Right).len() + of(Verdict::ByButton).len();
    let readable = read + REFUSED.len() + MISREAD.len();
    assert!(readable > 640, "{readable} texts");
    assert!(
        read as f64 >= LEAST_READ * readable as f64,
        "{read} of {readable}"
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn what_only_looks_like_a_rotation_is_not_read_without_a_question() {
    let verdicts = verdicts(LOOKALIKES);
    assert!(verdicts.len() > 420, "{} texts", verdicts.len());
    assert_eq!(ids(&verdicts, Verdict::Misread), LOOKALIKES_READ);
}

fn ids(verdicts: &[(String, Verdict)], wanted: Verdict) -> Vec<String> {
    let those = verdicts.iter().filter(|(_, verdict)| *verdict == wanted);
    those.map(|(id, _)| id.clone()).collect()
}

fn verdicts(cases: &str) -> Vec<(String, Verdict)> {
    let cases: Vec<Value> = serde_json::from_str(cases).expect("JSON");
    let id = |case: &Value| case["id"].as_str().expect("an id").to_owned();
    cases.iter().map(|case| (id(case), verdict(case))).collect()
}

fn verdict(case: &Value) -> Verdict {
    let expected = &case["expected"];
    let right: Vec<Vec<f64>> = match (&expected["rotation"], &expected["either"]) {
        (Value::Null, Value::Null) => Vec::new(),
        (Value::Null, either) => serde_json::from_value(either.clone()).expect("quaternions"),
        (one, _) => vec![serde_json::from_value(one.clone()).expect("a quaternion")],
    };
    let tolerance = case["tolerance"].as_f64().expect("degrees").max(0.01);
    let is_right = |read: &[f64]| {
        right
            .iter()
            .any(|right| apart_deg(read, right) <= tolerance)
    };
    match read(case, case["text"].as_str().expect("a text")) {
        Ok(read) if is_right(&read.components) && (right.len() == 1 || read.stops) => {
            Verdict::Right
        }
        Ok(read) if read.stops && (right.is_empty() || expected["orAsked"] == true) => {
            Verdict::Asked
        }
        Ok(_) => Verdict::Misread,
        Err(_) if right.is_empty() => Verdict::Asked,
        Err(problem) => {
            let texts = suggested(&problem);
            let answers: Vec<Read> = texts
                .iter()
                .filter_map(|text| read(case, text).ok())
                .collect();
            if answers.iter().any(|read| is_right(&read.components)) {
                Verdict::ByButton
            } else if answers.is_empty() {
                Verdict::Refused
            } else {
                Verdict::Misread
            }
        }
    }
}

fn suggested(problem: &Problem) -> Vec<String> {
    let one = problem.suggestion.iter().map(AsRef::as_ref);
    let all = one.chain(problem.choices.iter());
    all.map(|suggestion: &Suggestion| suggestion.text.clone())
        .collect()
}

/// What a text is read as: w, x, y, z, Hamilton, body to world.
struct Read {
    components: [f64; 4],
    /// Whether a note stops the reader.
    stops: bool,
}

fn read(case: &Value, text: &str) -> Result<Read, Problem> {
    let request: Request = serde_json::from_value(request(case, text)).expect("a request");
    let (notes, quaternion) = match analyze(&request) {
        Outcome::Read(report) => {
            let unit = &report.hamilton.unit;
            (report.notes.clone(), [unit.w, unit.x, unit.y, unit.z])
        }
        Outcome::Translate(report) => {
            let to = &report.to.components;
            (report.notes.clone(), [to.w, to.x, to.y, to.z])
        }
        Outcome::Problems(found) => return Err(found.problems[0].clone()),
        other => panic!("{other:?}"),
    };
    Ok(Read {
        components: quaternion,
        stops: notes.iter().any(|note| note.stops),
    })
}

/// What is declared of a text: a preset with what differs from it, or the library that printed it.
fn request(case: &Value, text: &str) -> Value {
    let declared = &case["declared"];
    let hamilton = serde_json::to_value(Convention::HAMILTON).expect("JSON");
    if let Some(library) = declared.get("library") {
        return json!({
            "view": "translate",
            "quaternion": text,
            "from": {"kind": "library", "id": library},
            "to": {"kind": "convention", "convention": hamilton},
        });
    }
    let mut convention = match declared["preset"].as_str() {
        Some("jpl") => serde_json::to_value(Convention::JPL).expect("JSON"),
        _ => hamilton,
    };
    for choice in ["order", "direction"] {
        if let Some(value) = declared.get(choice) {
            convention[choice] = value.clone();
        }
    }
    let mut request = json!({
        "view": "read", "quaternion": text, "vector": "1 2 3", "convention": convention,
    });
    if let Some(matrix) = declared.get("matrix").filter(|matrix| matrix.is_object()) {
        request["matrix"] = matrix.clone();
    } else if let Some(direction) = declared.get("direction") {
        request["matrix"] = json!({"function": "passive", "direction": direction});
    }
    request
}

/// The angle between two rotations.
fn apart_deg(one: &[f64], other: &[f64]) -> f64 {
    let norm = |q: &[f64]| q.iter().map(|c| c * c).sum::<f64>().sqrt();
    let apart = |sign: f64| {
        let difference: Vec<f64> = one
            .iter()
            .zip(other)
            .map(|(one_part, other_part)| one_part / norm(one) - sign * other_part / norm(other))
            .collect();
        norm(&difference)
    };
    let chord = apart(1.0).min(apart(-1.0));
    4.0 * (chord / 2.0).min(1.0).asin().to_degrees()
}
