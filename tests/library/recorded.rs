//! What libraries printed, and the pieces to compute it again.

use crate::support::{assert_close, wxyz};
use quatlas::nalgebra::{Matrix3, Quaternion, Vector3};
use quatlas::{
    CosineMatrix, Handedness, Library, Rotation, hamilton_product, jpl_product, library,
};
use serde_json::Value;

/// Some of the libraries compute in single precision.
pub(crate) const SINGLE_PRECISION: f64 = 3e-6;

pub(crate) struct Recorded {
    pub(crate) inputs: Value,
    pub(crate) observations: Vec<Value>,
}

pub(crate) fn recorded() -> Recorded {
    let mut file: Value =
        serde_json::from_str(include_str!("../../src/library/observations.json")).expect("JSON");
    Recorded {
        inputs: file["inputs"].take(),
        observations: file["observations"].as_array().expect("a list").clone(),
    }
}

/// Runs a check on every record that was run, with what it printed.
pub(crate) fn for_each(check: impl Fn(&Library, &Value, &Value)) {
    let Recorded {
        inputs,
        observations,
    } = recorded();
    for observation in &observations {
        let id = observation["id"].as_str().expect("an id");
        check(library(id).expect(id), observation, &inputs);
    }
}

/// The numbers of a value of any shape, if all of it is numbers.
pub(crate) fn numbers(value: &Value) -> Option<Vec<f64>> {
    match value {
        Value::Array(parts) => parts
            .iter()
            .map(numbers)
            .collect::<Option<Vec<_>>>()
            .map(|p| p.concat()),
        Value::Number(number) => number.as_f64().map(|number| vec![number]),
        _ => None,
    }
}

pub(crate) fn quaternion(value: &Value) -> Option<Quaternion<f64>> {
    match numbers(value)?[..] {
        [w, x, y, z] => Some(Quaternion::new(w, x, y, z)),
        _ => None,
    }
}

pub(crate) fn vector(value: &Value) -> Option<Vector3<f64>> {
    numbers(value).map(|numbers| Vector3::from_column_slice(&numbers))
}

pub(crate) fn matrix(value: &Value) -> Option<Matrix3<f64>> {
    let numbers = numbers(value)?;
    (numbers.len() == 9).then(|| Matrix3::from_row_slice(&numbers))
}

/// Compares two quaternions that may be opposite.
#[track_caller]
pub(crate) fn assert_same_rotation(what: &str, got: &Quaternion<f64>, expected: &Quaternion<f64>) {
    let sign = if got.coords.dot(&expected.coords) < 0.0 {
        -1.0
    } else {
        1.0
    };
    let expected = wxyz(&(expected * sign));
    assert_close(what, &wxyz(got), &expected, SINGLE_PRECISION);
}

pub(crate) fn product(
    handedness: Handedness,
    a: &Quaternion<f64>,
    b: &Quaternion<f64>,
) -> Quaternion<f64> {
    match handedness {
        Handedness::Right => hamilton_product(a, b),
        Handedness::Left => jpl_product(a, b),
    }
}

pub(crate) fn of(form: CosineMatrix, q: &Quaternion<f64>) -> Matrix3<f64> {
    form.of(q).expect("not zero")
}

/// `Rz(c) Ry(-b) Rx(a)` with numbers for the letters.
pub(crate) fn product_of_turns(means: &str, angles: &[f64]) -> Matrix3<f64> {
    means
        .split_whitespace()
        .fold(Matrix3::identity(), |product, factor| {
            let inner = factor.trim_start_matches('R').trim_end_matches(')');
            let (axis, angle) = inner.split_once('(').expect(means);
            let letter = angle.trim_start_matches('-');
            let size = angles[["a", "b", "c"]
                .iter()
                .position(|name| *name == letter)
                .expect(means)];
            let axis = match axis {
                "x" => Vector3::x(),
                "y" => Vector3::y(),
                "z" => Vector3::z(),
                _ => panic!("{means}"),
            };
            let turn =
                Rotation::from_axis_angle(axis.into(), if angle == letter { size } else { -size });
            product * turn.expect("finite").body_to_world_matrix()
        })
}
