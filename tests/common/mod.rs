//! What several test files share.
#![allow(
    dead_code,
    unused_imports,
    reason = "each test file is a crate of its own and uses a part of this"
)]

use quatlas::nalgebra::{Matrix3, Quaternion, Vector3};
use quatlas::{
    AngleUnit, ComponentOrder, ComposeReport, ComposeRequest, Convention, Direction, Fact, Field,
    Function, Handedness, MatrixConvention, Outcome, ParsedRotation, Perturbation, Problem,
    RateAxes, ReadReport, ReadRequest, Request, Rotation, TaggedMatrix, UnitSource, analyze,
    parse_rotation,
};
use std::ops::{Add, Mul};
pub(crate) use wasm_bindgen_test::wasm_bindgen_test;

pub(crate) const DEGREES: UnitSource = UnitSource::Written(AngleUnit::Degrees);
pub(crate) const RADIANS: UnitSource = UnitSource::Written(AngleUnit::Radians);
pub(crate) const AS_DEGREES: UnitSource = UnitSource::Assumed(AngleUnit::Degrees);
pub(crate) const AS_RADIANS: UnitSource = UnitSource::Assumed(AngleUnit::Radians);

/// All 32 conventions, in the order of the table of the specification (section 2.4).
pub(crate) fn all_conventions() -> Vec<Convention> {
    let mut all = Vec::new();
    for order in ComponentOrder::ALL {
        for handedness in Handedness::ALL {
            for function in Function::ALL {
                for direction in Direction::ALL {
                    for perturbation in Perturbation::ALL {
                        all.push(Convention {
                            order,
                            handedness,
                            function,
                            direction,
                            perturbation,
                        });
                    }
                }
            }
        }
    }
    all
}

/// Compares lists of numbers with a tolerance that is absolute and scaled by max(1, |expected|).
#[track_caller]
pub(crate) fn assert_close(what: &str, got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(
        got.len(),
        expected.len(),
        "{what}: got {got:?}, expected {expected:?}"
    );
    for (number, wanted) in got.iter().zip(expected) {
        assert!(
            (number - wanted).abs() <= tolerance * wanted.abs().max(1.0),
            "{what}: got {got:?}, expected {expected:?}"
        );
    }
}

/// The rows of a matrix, one after the other.
pub(crate) fn row_major(matrix: &Matrix3<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

pub(crate) fn wxyz(quaternion: &Quaternion<f64>) -> [f64; 4] {
    [quaternion.w, quaternion.i, quaternion.j, quaternion.k]
}

pub(crate) fn read_request(quaternion: &str, vector: &str, convention: Convention) -> Request {
    Request::Read(ReadRequest::new(quaternion, vector, convention))
}

#[track_caller]
pub(crate) fn report(request: ReadRequest) -> ReadReport {
    match analyze(&Request::Read(request)) {
        Outcome::Read(report) => *report,
        other => panic!("no report: {other:?}"),
    }
}

#[track_caller]
pub(crate) fn read(quaternion: &str, vector: &str, convention: Convention) -> ReadReport {
    match analyze(&read_request(quaternion, vector, convention)) {
        Outcome::Read(report) => *report,
        other => panic!("{quaternion:?} has no report: {other:?}"),
    }
}

#[track_caller]
pub(crate) fn compose(p: &str, q: &str, vector: &str, convention: Convention) -> ComposeReport {
    let request = Request::Compose(ComposeRequest::new(p, q, vector, convention));
    match analyze(&request) {
        Outcome::Compose(report) => *report,
        other => panic!("{p:?} and {q:?} have no report: {other:?}"),
    }
}

/// No description but a quaternion's depends on the declared order.
#[track_caller]
pub(crate) fn rotation(text: &str) -> ParsedRotation {
    let [first, last] = ComponentOrder::ALL.map(|declared| {
        parse_rotation(text, Field::Quaternion, declared)
            .unwrap_or_else(|problem| panic!("{text}\n{}", problem.render(text)))
    });
    assert_eq!(first, last, "{text}");
    first
}

pub(crate) fn problems(outcome: Outcome) -> Vec<Problem> {
    match outcome {
        Outcome::Problems(found) => found.problems,
        other => panic!("there is a report: {other:?}"),
    }
}

pub(crate) fn facts(report: &ReadReport) -> Vec<Fact> {
    report.notes.iter().map(|note| note.fact.clone()).collect()
}

/// The rotation nearest to a matrix of this convention.
#[track_caller]
pub(crate) fn nearest(entries: Matrix3<f64>, convention: MatrixConvention) -> Rotation {
    let matrix = TaggedMatrix {
        entries,
        convention,
    };
    Rotation::nearest_to_matrix(&matrix)
        .expect("a rotation")
        .rotation
}

/// A value one step later, by the classical Runge-Kutta method.
pub(crate) fn runge_kutta<T>(time: f64, step: f64, value: T, derivative: impl Fn(f64, T) -> T) -> T
where
    T: Copy + Add<Output = T> + Mul<f64, Output = T>,
{
    let a = derivative(time, value);
    let b = derivative(time + step / 2.0, value + a * (step / 2.0));
    let c = derivative(time + step / 2.0, value + b * (step / 2.0));
    let d = derivative(time + step, value + c * step);
    value + (a + b * 2.0 + c * 2.0 + d) * (step / 6.0)
}

/// The nine entries of `R_WB` after a time with a rate on some axes, by steps of the classical
/// Runge-Kutta method on `Ṙ = R [ω_B]× = [ω_W]× R`.
pub(crate) fn integrated_entries(
    start: Matrix3<f64>,
    rate: impl Fn(f64) -> Vector3<f64>,
    axes: RateAxes,
    duration: f64,
    steps: u32,
) -> Matrix3<f64> {
    let mut r = start;
    let h = duration / f64::from(steps);
    for n in 0..steps {
        r = runge_kutta(f64::from(n) * h, h, r, |time, r| match axes {
            RateAxes::Body => r * rate(time).cross_matrix(),
            RateAxes::World => rate(time).cross_matrix() * r,
        });
    }
    r
}
