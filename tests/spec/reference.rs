//! Reference mathematics of the specification's tests: it uses no function of quatlas.

use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Matrix3, Quaternion, SMatrix, Vector3};
use quatlas::{
    ComponentOrder, Convention, Direction, Function, Handedness, MatrixConvention, Perturbation,
    RateAxes,
};
use std::ops::{Add, Mul};

/// A few dozen roundings of numbers near 1.
pub(crate) const CLOSE: f64 = 1e-14;

/// What a central difference of fourth order with a step of 1e-3 keeps.
pub(crate) const SLOPE: f64 = 1e-10;

/// Rotation vectors of less than half a turn: small, ordinary, and close to half a turn.
pub(crate) const TURNS: [[f64; 3]; 7] = [
    [0.4, -0.7, 1.1],
    [-0.6, 0.25, 0.9],
    [1e-3, 2e-3, -5e-4],
    [2.0, -1.5, 0.9],
    [-0.2, 0.1, 3.0],
    [0.1, -2.9, 0.2],
    [-2.2, 0.5, -0.3],
];

pub(crate) const VECTORS: [[f64; 3]; 3] = [[1.25, -0.5, 2.0], [-0.3, 0.8, 0.1], [3.0, 2.0, -1.0]];

/// Quaternions of no particular norm.
pub(crate) const NUMBERS: [[f64; 4]; 4] = [
    [0.9, 0.2, -0.4, 0.5],
    [-0.3, 1.7, 0.6, -0.8],
    [1.0, 2.0, 3.0, 4.0],
    [0.1, -0.2, 0.05, 0.02],
];

pub(crate) fn turns() -> impl Iterator<Item = Vector3<f64>> {
    TURNS.into_iter().map(Vector3::from)
}

pub(crate) fn vectors() -> impl Iterator<Item = Vector3<f64>> {
    VECTORS.into_iter().map(Vector3::from)
}

pub(crate) fn numbers() -> impl Iterator<Item = Quaternion<f64>> {
    NUMBERS
        .into_iter()
        .map(|[w, x, y, z]| Quaternion::new(w, x, y, z))
}

/// Every two of a list, each with itself too.
pub(crate) fn pairs<T: Clone>(list: impl IntoIterator<Item = T>) -> Vec<(T, T)> {
    let list: Vec<T> = list.into_iter().collect();
    let with_all = |first: &T| -> Vec<(T, T)> {
        let second = list.iter().cloned();
        second.map(|second| (first.clone(), second)).collect()
    };
    list.iter().flat_map(with_all).collect()
}

pub(crate) fn unit(axis: usize) -> Vector3<f64> {
    let mut unit = Vector3::zeros();
    unit[axis] = 1.0;
    unit
}

pub(crate) fn skew(v: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::new(0.0, -v.z, v.y, v.z, 0.0, -v.x, -v.y, v.x, 0.0)
}

/// The vector of a skew matrix.
pub(crate) fn unskew(m: &Matrix3<f64>) -> Vector3<f64> {
    Vector3::new(m[(2, 1)], m[(0, 2)], m[(1, 0)])
}

/// The exponential of a matrix by its power series; of a sixteenth, squared four times.
pub(crate) fn exponential_matrix(v: &Vector3<f64>) -> Matrix3<f64> {
    let small = skew(v) / 16.0;
    let (mut term, mut sum) = (Matrix3::identity(), Matrix3::identity());
    for n in 1..20 {
        term = term * small / f64::from(n);
        sum += term;
    }
    for _ in 0..4 {
        sum *= sum;
    }
    sum
}

/// The right-handed turn about the axis 0, 1 or 2.
pub(crate) fn elementary(axis: usize, angle: f64) -> Matrix3<f64> {
    let (sine, cosine) = angle.sin_cos();
    match axis {
        0 => Matrix3::new(1.0, 0.0, 0.0, 0.0, cosine, -sine, 0.0, sine, cosine),
        1 => Matrix3::new(cosine, 0.0, sine, 0.0, 1.0, 0.0, -sine, 0.0, cosine),
        _ => Matrix3::new(cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0),
    }
}

/// The logarithm by the trace, for turns that are neither 0 nor half a turn.
pub(crate) fn logarithm(m: &Matrix3<f64>) -> Vector3<f64> {
    let angle = ((m.trace() - 1.0) / 2.0).acos();
    unskew(&(m - m.transpose())) * (angle / (2.0 * angle.sin()))
}

/// What two of 1, i, j, k make in the product of a hand: the sign and the place.
fn basis_product(hand: Handedness, a: usize, b: usize) -> (f64, usize) {
    let ij = match hand {
        Handedness::Right => 1.0,
        Handedness::Left => -1.0,
    };
    match (a, b) {
        (0, place) | (place, 0) => (1.0, place),
        (1, 1) | (2, 2) | (3, 3) => (-1.0, 0),
        (1, 2) | (2, 3) | (3, 1) => (ij, 6 - a - b),
        _ => (-ij, 6 - a - b),
    }
}

/// The product by the multiplication table.
pub(crate) fn product(
    hand: Handedness,
    p: &Quaternion<f64>,
    q: &Quaternion<f64>,
) -> Quaternion<f64> {
    let mut sum = [0.0; 4];
    for (a, left) in [p.w, p.i, p.j, p.k].into_iter().enumerate() {
        for (b, right) in [q.w, q.i, q.j, q.k].into_iter().enumerate() {
            let (sign, place) = basis_product(hand, a, b);
            sum[place] += sign * left * right;
        }
    }
    Quaternion::new(sum[0], sum[1], sum[2], sum[3])
}

pub(crate) fn hamilton(p: &Quaternion<f64>, q: &Quaternion<f64>) -> Quaternion<f64> {
    product(Handedness::Right, p, q)
}

pub(crate) fn jpl(p: &Quaternion<f64>, q: &Quaternion<f64>) -> Quaternion<f64> {
    product(Handedness::Left, p, q)
}

pub(crate) fn pure(v: &Vector3<f64>) -> Quaternion<f64> {
    Quaternion::new(0.0, v.x, v.y, v.z)
}

pub(crate) fn vector_part(q: &Quaternion<f64>) -> Vector3<f64> {
    Vector3::new(q.i, q.j, q.k)
}

pub(crate) fn conjugate(q: &Quaternion<f64>) -> Quaternion<f64> {
    Quaternion::new(q.w, -q.i, -q.j, -q.k)
}

pub(crate) fn inverse(q: &Quaternion<f64>) -> Quaternion<f64> {
    let square = q.w * q.w + q.i * q.i + q.j * q.j + q.k * q.k;
    conjugate(q) / square
}

/// `q∘x∘q⁻¹`
pub(crate) fn turned(hand: Handedness, q: &Quaternion<f64>, x: &Vector3<f64>) -> Vector3<f64> {
    vector_part(&product(hand, &product(hand, q, &pure(x)), &inverse(q)))
}

/// The matrix of `q∘x∘q⁻¹`, column by column.
pub(crate) fn matrix_of(hand: Handedness, q: &Quaternion<f64>) -> Matrix3<f64> {
    Matrix3::from_columns(&[0, 1, 2].map(|axis| turned(hand, q, &unit(axis))))
}

/// The quaternion of a turn, by the half angle.
pub(crate) fn half_angle(v: &Vector3<f64>) -> Quaternion<f64> {
    let angle = v.norm();
    let vector = v * ((angle / 2.0).sin() / angle);
    Quaternion::new((angle / 2.0).cos(), vector.x, vector.y, vector.z)
}

/// τ, by the table of section 1.3.
pub(crate) fn tau(function: Function, direction: Direction) -> f64 {
    match (function, direction) {
        (Function::Passive, Direction::BodyToWorld)
        | (Function::Active, Direction::WorldToBody) => 1.0,
        (Function::Passive, Direction::WorldToBody)
        | (Function::Active, Direction::BodyToWorld) => -1.0,
    }
}

/// σ, by parity: one sign for each of left, world to body and active (MODEL-02).
pub(crate) fn sigma(convention: Convention) -> f64 {
    let conjugations = [
        convention.handedness == Handedness::Left,
        convention.direction == Direction::WorldToBody,
        convention.function == Function::Active,
    ];
    conjugations
        .into_iter()
        .fold(1.0, |sign, is_so| if is_so { -sign } else { sign })
}

/// The components of an attitude in a convention, from its rotation vector.
pub(crate) fn components(convention: Convention, v: &Vector3<f64>) -> Quaternion<f64> {
    let canonical = half_angle(v);
    if sigma(convention) > 0.0 {
        canonical
    } else {
        conjugate(&canonical)
    }
}

/// The matrix of an attitude in a convention, from its rotation vector.
pub(crate) fn matrix(convention: MatrixConvention, v: &Vector3<f64>) -> Matrix3<f64> {
    exponential_matrix(&(v * tau(convention.function, convention.direction)))
}

/// The eight combinations of handedness, function and direction, scalar first, in the order of
/// table 2.1.
pub(crate) fn eight() -> impl Iterator<Item = Convention> {
    all_conventions().into_iter().filter(|convention| {
        convention.order == ComponentOrder::ScalarFirst
            && convention.perturbation == Perturbation::Local
    })
}

#[track_caller]
pub(crate) fn assert_same<const R: usize, const C: usize>(
    what: &str,
    got: &SMatrix<f64, R, C>,
    expected: &SMatrix<f64, R, C>,
    tolerance: f64,
) {
    assert_close(what, got.as_slice(), expected.as_slice(), tolerance);
}

#[track_caller]
pub(crate) fn assert_quaternion(what: &str, got: &Quaternion<f64>, expected: &Quaternion<f64>) {
    assert_close(
        what,
        got.coords.as_slice(),
        expected.coords.as_slice(),
        CLOSE,
    );
}

/// The same attitude: equal up to the sign of all four.
#[track_caller]
pub(crate) fn assert_turn(what: &str, got: &Quaternion<f64>, expected: &Quaternion<f64>) {
    let sign = got.coords.dot(&expected.coords).signum();
    assert_quaternion(what, &(got * sign), expected);
}

/// A statement as it is printed is off by more than this.
#[track_caller]
pub(crate) fn assert_off<const R: usize, const C: usize>(
    what: &str,
    printed: &SMatrix<f64, R, C>,
    right: &SMatrix<f64, R, C>,
) {
    assert!(
        (printed - right).amax() > 0.1,
        "{what}: {printed} is {right}"
    );
}

/// The derivative at 0, by a central difference of fourth order.
pub(crate) fn slope<const R: usize, const C: usize>(
    function: impl Fn(f64) -> SMatrix<f64, R, C>,
) -> SMatrix<f64, R, C> {
    let step = 1e-3;
    let near = function(step) - function(-step);
    let far = function(2.0 * step) - function(-2.0 * step);
    (near * 8.0 - far) / (12.0 * step)
}

/// The order with which an error vanishes when its argument is halved.
pub(crate) fn order(argument: f64, error: impl Fn(f64) -> f64) -> f64 {
    (error(argument) / error(argument / 2.0)).log2()
}

#[track_caller]
pub(crate) fn assert_order(what: &str, got: f64, expected: f64) {
    assert!(
        (got - expected).abs() < 0.1,
        "{what}: order {got} is not {expected}"
    );
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
