//! Which description of an attitude three, four or nine numbers are.

mod questions;
mod renamed;
mod three;

use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    Convention, NumbersReport, NumbersRequest, Outcome, ReadReport, ReadRequest, Request, analyze,
};

fn numbers(numbers: &str, quaternion: &str) -> NumbersReport {
    numbers_in(numbers, quaternion, Convention::HAMILTON)
}

#[track_caller]
fn numbers_in(numbers: &str, quaternion: &str, convention: Convention) -> NumbersReport {
    let request = NumbersRequest::new(numbers, quaternion, convention);
    match analyze(&Request::Numbers(request)) {
        Outcome::Numbers(report) => *report,
        other => panic!("{numbers} | {quaternion}: {other:?}"),
    }
}

/// The attitude of a text that says all of it, body to world.
#[track_caller]
fn matrix_of(text: &str) -> Matrix3<f64> {
    let request = ReadRequest::new(text, "1 0 0", Convention::HAMILTON);
    let report: ReadReport = match analyze(&Request::Read(request)) {
        Outcome::Read(report) => *report,
        other => panic!("{text}: {other:?}"),
    };
    Matrix3::from(report.hamilton.matrix).transpose()
}

/// The turn about a coordinate axis.
fn elementary(axis: usize, angle_rad: f64) -> Matrix3<f64> {
    let (sine, cosine) = angle_rad.sin_cos();
    let mut matrix = Matrix3::identity();
    let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
    matrix[(next, next)] = cosine;
    matrix[(next, last)] = -sine;
    matrix[(last, next)] = sine;
    matrix[(last, last)] = cosine;
    matrix
}

/// The turn by an angle about an axis of length 1 (Rodrigues).
fn about(axis: Vector3<f64>, angle_rad: f64) -> Matrix3<f64> {
    let k = axis.cross_matrix();
    Matrix3::identity() + k * angle_rad.sin() + k * k * (1.0 - angle_rad.cos())
}

/// A matrix as lines, with so many decimals.
fn rows(matrix: &Matrix3<f64>, decimals: usize) -> String {
    let row = |row: usize| {
        let numbers = [0, 1, 2].map(|column| format!("{:.decimals$}", matrix[(row, column)]));
        numbers.join(" ")
    };
    [row(0), row(1), row(2)].join("\n")
}

/// The numbers w x y z of a matrix body to world, with so many decimals.
fn components(matrix: &Matrix3<f64>) -> [f64; 4] {
    // Of 4 q qᵀ the column that is not small, without quatlas.
    let m = |row: usize, column: usize| matrix[(row, column)];
    let k = [
        [
            1.0 + m(0, 0) + m(1, 1) + m(2, 2),
            m(2, 1) - m(1, 2),
            m(0, 2) - m(2, 0),
            m(1, 0) - m(0, 1),
        ],
        [
            m(2, 1) - m(1, 2),
            1.0 + m(0, 0) - m(1, 1) - m(2, 2),
            m(0, 1) + m(1, 0),
            m(0, 2) + m(2, 0),
        ],
        [
            m(0, 2) - m(2, 0),
            m(0, 1) + m(1, 0),
            1.0 - m(0, 0) + m(1, 1) - m(2, 2),
            m(1, 2) + m(2, 1),
        ],
        [
            m(1, 0) - m(0, 1),
            m(0, 2) + m(2, 0),
            m(1, 2) + m(2, 1),
            1.0 - m(0, 0) - m(1, 1) + m(2, 2),
        ],
    ];
    let largest = (0..4).max_by(|a, b| k[*a][*a].total_cmp(&k[*b][*b]));
    let column = k[largest.expect("four")];
    let norm = column.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    column.map(|entry| entry / norm)
}
