//! What was recorded of a library, computed again by its own calls and compared number by number.

mod crates;

use serde_json::Value;

/// Of numbers that a library computes in float64 on any machine.
const TOLERANCE: f64 = 1e-14;

/// A library's own calls and nothing else. Its quaternion stays its own between them; what is
/// compared is named `[w, x, y, z]`, and a matrix `[row][column]`.
pub(crate) trait Library {
    /// Its name in `src/library/observations.json` and as a crate.
    const ID: &str;
    /// What is recorded and cannot be run again here, each with the reason.
    const NOT_RERUN: &[(&str, &str)] = &[];
    type Quaternion: Copy;

    /// With these four named components, whatever they are.
    fn named(wxyz: [f64; 4]) -> Self::Quaternion;
    /// From four numbers in the order in which the library takes them.
    fn construct(four: [f64; 4]) -> Self::Quaternion;
    fn construct_zero() -> Self::Quaternion {
        Self::construct([0.0; 4])
    }
    fn components(q: Self::Quaternion) -> [f64; 4];
    /// As the library writes it into an array, where it does.
    fn array(q: Self::Quaternion) -> Option<[f64; 4]>;
    fn product(a: Self::Quaternion, b: Self::Quaternion) -> Self::Quaternion;
    fn matrix(q: Self::Quaternion) -> [[f64; 3]; 3];
    fn rotate(q: Self::Quaternion, v: [f64; 3]) -> [f64; 3];
    fn norm(q: Self::Quaternion) -> f64;
    fn about_z(angle: f64) -> Self::Quaternion;
    fn from_matrix(rows: [[f64; 3]; 3]) -> Self::Quaternion;
    fn slerp(a: Self::Quaternion, b: Self::Quaternion, t: f64) -> Self::Quaternion;
    fn inverse(q: Self::Quaternion) -> Self::Quaternion;
    fn normalize(q: Self::Quaternion) -> Self::Quaternion;
    /// By the call as it is recorded; `None` for one that is not known.
    fn euler(call: &str, angles: [f64; 3]) -> Option<Self::Quaternion>;
    /// By what else is recorded; `None` for what is not known.
    fn other(_text: &str, _inputs: &Inputs) -> Option<Vec<f64>> {
        None
    }
}

/// What every library was given.
pub(crate) struct Inputs {
    pub(crate) a: [f64; 4],
    pub(crate) b: [f64; 4],
    pub(crate) v: [f64; 3],
    pub(crate) matrices: Vec<[[f64; 3]; 3]>,
    axis_angle: f64,
}

/// One recorded list of numbers beside that of today.
pub(crate) struct Compared {
    pub(crate) name: String,
    pub(crate) recorded: Vec<f64>,
    pub(crate) today: Vec<f64>,
}

/// Everything that is recorded of a library, computed again.
pub(crate) fn run_again<L: Library>() -> Vec<Compared> {
    let file: Value =
        serde_json::from_str(include_str!("../../../src/library/observations.json")).expect("JSON");
    let inputs = Inputs::new(&file["inputs"]);
    let observations = file["observations"].as_array().expect("a list");
    let observation = observations
        .iter()
        .find(|observation| observation["id"] == L::ID)
        .unwrap_or_else(|| panic!("{} has no observation", L::ID));
    let mut compared = Vec::new();
    let mut listed_and_recorded = 0;
    let mut compare = |name: String, recorded: &Value, today: Option<Vec<f64>>| {
        let is_listed = L::NOT_RERUN.iter().any(|(listed, _)| *listed == name);
        let Some(today) = today else {
            assert!(is_listed, "{name} is neither run again nor listed as such");
            listed_and_recorded += 1;
            return;
        };
        assert!(!is_listed, "{name} is run again and listed as not");
        let recorded = numbers(recorded);
        compared.push(Compared {
            name,
            recorded,
            today,
        });
    };
    for (key, recorded) in observation.as_object().expect("an object") {
        match key.as_str() {
            "id" => {}
            "euler" => {
                for call in recorded.as_array().expect("a list") {
                    let name = call["call"].as_str().expect("a call");
                    let q = L::euler(name, fixed(&call["args"]));
                    let today = q.map(|q| L::components(q).to_vec());
                    compare(format!("euler {name}"), &call["out"], today);
                }
            }
            "other" => {
                for (text, recorded) in recorded.as_object().expect("an object") {
                    let today = L::other(text, &inputs);
                    compare(format!("other {text}"), recorded, today);
                }
            }
            _ => compare(key.clone(), recorded, plain::<L>(key, &inputs)),
        }
    }
    assert_eq!(listed_and_recorded, L::NOT_RERUN.len(), "listed in vain");
    compared
}

/// The version of which the numbers were recorded is the one that runs here.
pub(crate) fn assert_version<L: Library>() {
    let file: Value =
        serde_json::from_str(include_str!("../../../src/library/libraries.json")).expect("JSON");
    let mut records = file.as_array().expect("a list").iter();
    let record = records.find(|record| record["id"] == L::ID).expect(L::ID);
    let name = format!("name = \"{}\"", L::ID);
    let lock = include_str!("../../../Cargo.lock");
    let locked = lock.lines().skip_while(|line| *line != name).nth(1);
    assert_eq!(
        locked,
        Some(format!("version = {}", record["version"]).as_str())
    );
}

/// By the keys that all libraries share: how each was found, in the calls of any library.
fn plain<L: Library>(key: &str, inputs: &Inputs) -> Option<Vec<f64>> {
    let Inputs { v, .. } = *inputs;
    let [a, b, twice_a, minus_b, zero, i, j, not_a_number] = [
        inputs.a,
        inputs.b,
        inputs.a.map(|component| 2.0 * component),
        inputs.b.map(|component| -component),
        [0.0; 4],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [f64::NAN, 0.0, 0.0, 1.0],
    ]
    .map(L::named);
    let ab = L::product(a, b);
    let named = |q| L::components(q).to_vec();
    let rotated = |q, v| L::rotate(q, v).to_vec();
    let entries = |q| L::matrix(q).as_flattened().to_vec();
    Some(match key {
        "arrayOfA" => L::array(a)?.to_vec(),
        "constructed1234" => named(L::construct([0.1, 0.2, 0.3, 0.4])),
        "productAB" => named(ab),
        "productIJ" => named(L::product(i, j)),
        "matrixA" => entries(a),
        "matrixB" => entries(b),
        "matrixAB" => entries(ab),
        "matrix2A" => entries(twice_a),
        "matrix0" => entries(zero),
        "rotateAV" => rotated(a, v),
        "rotate2AV" => rotated(twice_a, v),
        "rotate0V" => rotated(zero, v),
        "rotateABV" => rotated(ab, v),
        "rotateBThenA" => rotated(a, L::rotate(b, v)),
        "rotateAThenB" => rotated(b, L::rotate(a, v)),
        "norm2A" => vec![L::norm(twice_a)],
        "constructed0" => named(L::construct_zero()),
        "nan" => rotated(not_a_number, v),
        "axisAngleZ" => named(L::about_z(inputs.axis_angle)),
        "fromMatrix" => {
            let quaternions = inputs.matrices.iter().map(|rows| L::from_matrix(*rows));
            quaternions.flat_map(L::components).collect()
        }
        "slerpPositive" => named(L::slerp(a, b, 0.5)),
        "slerpNegative" => named(L::slerp(a, minus_b, 0.5)),
        "inverse0" => named(L::inverse(zero)),
        "normalize0" => named(L::normalize(zero)),
        _ => return None,
    })
}

impl Compared {
    /// What differs, one line a number.
    pub(crate) fn differences(&self) -> Vec<String> {
        let Self {
            name,
            recorded,
            today,
        } = self;
        if recorded.len() != today.len() {
            return vec![format!("{name}: {today:?}, recorded {recorded:?}")];
        }
        let both = today.iter().zip(recorded).enumerate();
        both.filter(|(_, (today, recorded))| !is_same(**today, **recorded))
            .map(|(at, (today, recorded))| {
                format!("{name}[{at}]: {today:?}, recorded {recorded:?}")
            })
            .collect()
    }
}

fn is_same(today: f64, recorded: f64) -> bool {
    if recorded.is_nan() {
        return today.is_nan();
    }
    (today - recorded).abs() <= TOLERANCE * recorded.abs().max(1.0)
}

impl Inputs {
    fn new(inputs: &Value) -> Self {
        let matrices = inputs["fromMatrix"].as_array().expect("a list");
        Self {
            a: fixed(&inputs["a"]),
            b: fixed(&inputs["b"]),
            v: fixed(&inputs["v"]),
            matrices: matrices
                .iter()
                .map(|rows| [0, 1, 2].map(|row| fixed(&rows[row])))
                .collect(),
            axis_angle: inputs["axisAngle"].as_f64().expect("a number"),
        }
    }
}

/// All numbers of a recorded value in their order. No library here has a recorded error.
fn numbers(recorded: &Value) -> Vec<f64> {
    match recorded {
        Value::Array(members) => members.iter().flat_map(numbers).collect(),
        Value::String(text) if text == "NaN" => vec![f64::NAN],
        number => vec![
            number
                .as_f64()
                .unwrap_or_else(|| panic!("no number: {number}")),
        ],
    }
}

fn fixed<const COUNT: usize>(recorded: &Value) -> [f64; COUNT] {
    numbers(recorded).try_into().expect("so many numbers")
}
