//! The numbers of the golden cases.

use serde_json::Value;

/// The numbers of an output, a matrix row by row.
#[track_caller]
pub(crate) fn output(id: &str, name: &str) -> Vec<f64> {
    fn flatten(value: &Value) -> Vec<f64> {
        match value {
            Value::Array(members) => members.iter().flat_map(flatten).collect(),
            number => vec![number.as_f64().expect("a number")],
        }
    }
    let file: Value = serde_json::from_str(include_str!("../vectors/golden.json")).expect("JSON");
    let cases = file["cases"].as_array().expect("a list of cases");
    let case = cases.iter().find(|case| case["id"] == id);
    flatten(&case.expect("a case of that id")["output"][name])
}
