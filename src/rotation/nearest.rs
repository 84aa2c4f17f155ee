//! The rotation that is nearest to nine numbers.
//!
//! `R(q)` is nearest to `M` where `qᵀ K q` is largest, `K` being Davenport's symmetric 4×4 matrix of
//! `M` (Davenport's q-method; Bar-Itzhack 2000 for matrices). Its eigenvector gives a quaternion to a
//! few digits less than a double has, and loses the small components; two Newton steps with residuals
//! of 106 bits give all of them. nalgebra's `UnitQuaternion::from_matrix` iterates from the
//! identity: for some half turns it stays there, and for entries of 1e100 it never ends.

use crate::rotation::Rotation;
use crate::rotation::precise;
use nalgebra::{Matrix3, Matrix4, Vector3};
use std::fmt;
use twofloat::TwoFloat;

/// A rotation and how far the matrix is from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestRotation {
    /// The rotation.
    pub rotation: Rotation,
    /// The size of the correction: the Frobenius norm of the difference between the matrix and that
    /// of the rotation, 0 for a rotation.
    pub correction: f64,
}

/// Why there is no nearest rotation, or why it would mean nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoNearestRotation {
    /// An entry is not finite.
    NotFinite,
    /// The determinant is negative: a mirror image, which no turn makes.
    Reflection,
    /// The columns lie in a plane, or nearly: no rotation is nearer than all others.
    Singular,
}

impl fmt::Display for NoNearestRotation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "an entry of the matrix is not finite",
            Self::Reflection => "the matrix is a reflection: its determinant is negative",
            Self::Singular => "the matrix has no inverse: its columns lie in a plane",
        })
    }
}

impl std::error::Error for NoNearestRotation {}

/// The two largest eigenvalues of `K` must differ by this part of the largest (by 4/3 of it for a
/// rotation); below it the nearest rotation changes with the last digits of the matrix.
const SMALLEST_GAP: f64 = 1e-6;

/// Newton steps after the eigenvector: each doubles the number of right digits, about 14 at first,
/// and 106 bits are 32 digits.
const NEWTON_STEPS: usize = 2;

/// The same for a matrix whose entries have 106 bits themselves: its nearest rotation has 17 digits down to
/// here.
const SMALLEST_PRECISE_GAP: f64 = 1e-12;

/// At that gap the eigenvector has 4 digits, and as the Jacobian has doubles each step adds 4.
const PRECISE_NEWTON_STEPS: usize = 5;

impl NearestRotation {
    pub(crate) fn of_body_to_world(matrix: &Matrix3<f64>) -> Result<Self, NoNearestRotation> {
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return Err(NoNearestRotation::NotFinite);
        }
        let determinant = unit_size(matrix).determinant();
        let Some(rotation) = nearest(matrix) else {
            // A mirror image of a rotation is as near to a whole circle of rotations.
            return Err(if determinant < -SMALLEST_GAP {
                NoNearestRotation::Reflection
            } else {
                NoNearestRotation::Singular
            });
        };
        if determinant < 0.0 {
            return Err(NoNearestRotation::Reflection);
        }
        let difference = matrix - rotation.body_to_world_matrix();
        Ok(Self {
            rotation,
            correction: precise::Norm::of(difference.as_slice()).value(),
        })
    }
}

/// The rotation nearest to a finite matrix; `None` where no one is nearer than all others.
pub(crate) fn nearest(matrix: &Matrix3<f64>) -> Option<Rotation> {
    let scale = precise::working_scale(matrix.as_slice());
    let working_size = |entry| TwoFloat::from(precise::times_power_of_two(entry, scale));
    let k = davenport(&matrix.map(working_size));
    of_davenport(&k, SMALLEST_GAP, NEWTON_STEPS)
}

/// The rotation nearest to a sum of finite matrices; `None` where no one is nearer than all others by as
/// much as is asked for one matrix.
pub(crate) fn nearest_to_sum(sum: &Matrix3<TwoFloat>) -> Option<Rotation> {
    let k = davenport(&at_working_size(sum));
    of_davenport(&k, SMALLEST_GAP, NEWTON_STEPS)
}

/// The rotation nearest to a finite matrix with 106 bits; `None` where no one is nearer than all others.
pub(crate) fn nearest_to_precise(matrix: &Matrix3<TwoFloat>) -> Option<Rotation> {
    let k = davenport(&at_working_size(matrix));
    of_davenport(&k, SMALLEST_PRECISE_GAP, PRECISE_NEWTON_STEPS)
}

/// The matrix times the power of two that makes its largest entry as large as the working size.
fn at_working_size(matrix: &Matrix3<TwoFloat>) -> Matrix3<TwoFloat> {
    let scale = precise::working_scale(matrix.map(|entry| entry.hi()).as_slice());
    matrix.map(|entry| precise::precisely_times_power_of_two(entry, scale))
}

/// The rotation of the first eigenvector of `K`; `None` where the gap to the second is smaller.
fn of_davenport(k: &Matrix4<TwoFloat>, smallest_gap: f64, newton_steps: usize) -> Option<Rotation> {
    let dominant = Dominant::of(k);
    if dominant.gap < smallest_gap {
        return None;
    }
    let q = eigenvector(k, dominant.pivot, dominant.eigenvalue, newton_steps)?;
    Some(Rotation::from_precise(q))
}

/// The matrix times the power of two that makes its largest entry 1/2 or more, and less than 1.
fn unit_size(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    let exponent = precise::binary_exponent(matrix.as_slice());
    matrix.map(|entry| precise::times_power_of_two(entry, -exponent))
}

/// Davenport's matrix on `[w, x, y, z]`.
pub(crate) fn davenport(m: &Matrix3<TwoFloat>) -> Matrix4<TwoFloat> {
    let at = |row: usize, column: usize| m[(row, column)];
    let (a, b, c) = (at(0, 0), at(1, 1), at(2, 2));
    let (wx, wy, wz) = (
        at(2, 1) - at(1, 2),
        at(0, 2) - at(2, 0),
        at(1, 0) - at(0, 1),
    );
    let (xy, xz, yz) = (
        at(0, 1) + at(1, 0),
        at(0, 2) + at(2, 0),
        at(1, 2) + at(2, 1),
    );
    Matrix4::new(
        a + b + c,
        wx,
        wy,
        wz, //
        wx,
        a - b - c,
        xy,
        xz, //
        wy,
        xy,
        b - a - c,
        yz, //
        wz,
        xz,
        yz,
        c - a - b,
    )
}

/// What plain doubles tell of the first eigenvector.
struct Dominant {
    /// At the working size, as `K` is.
    eigenvalue: f64,
    /// The place of the largest component.
    pivot: usize,
    /// How far the second eigenvalue is from the first, as a part of the first.
    gap: f64,
}

impl Dominant {
    fn of(k: &Matrix4<TwoFloat>) -> Self {
        // At a size whose squares and cubes are far from overflow.
        let eigen = k
            .map(|entry| precise::from_working_size(entry.hi()))
            .symmetric_eigen();
        let first = eigen.eigenvalues.imax();
        let second = (0..4)
            .filter(|&place| place != first)
            .fold(f64::NEG_INFINITY, |most, place| {
                most.max(eigen.eigenvalues[place])
            });
        let eigenvalue = eigen.eigenvalues[first];
        Self {
            eigenvalue: precise::working_size(eigenvalue),
            pivot: eigen.eigenvectors.column(first).iamax(),
            // K has the trace 0, so the first eigenvalue is 0 only for the zero matrix.
            gap: if eigenvalue > 0.0 {
                (eigenvalue - second) / eigenvalue
            } else {
                0.0
            },
        }
    }
}

/// The first eigenvector of `K`, whose component at `pivot` is the largest and positive.
///
/// With that component held at `s`, the other three and the eigenvalue are `K q = λ q`: of
/// `K = [[k, bᵀ], [b, A]]` and `q = [s, y]` these are `λ = k + b·y/s` and `b s + A y = λ y`. A small
/// `y` has a small `b`, so no digit of it is lost against 1.
fn eigenvector(
    k: &Matrix4<TwoFloat>,
    pivot: usize,
    eigenvalue: f64,
    newton_steps: usize,
) -> Option<[TwoFloat; 4]> {
    let others = [0, 1, 2].map(|place| place + usize::from(place >= pivot));
    let b = Vector3::from_fn(|row, _| k[(others[row], pivot)]);
    let a = Matrix3::from_fn(|row, column| k[(others[row], others[column])]);
    let s = precise::working_size(1.0);

    let in_doubles = |number: TwoFloat| number.hi();
    let a_minus = |eigenvalue| a.map(in_doubles) - Matrix3::from_diagonal_element(eigenvalue);
    let start = a_minus(eigenvalue).lu().solve(&b.map(in_doubles))? * -s;
    let mut y = start.map(TwoFloat::from);
    for _ in 0..newton_steps {
        let eigenvalue = k[(pivot, pivot)] + b.dot(&y) * (1.0 / s);
        let residual = b * TwoFloat::from(s) + precise::product(&a, y) - y * eigenvalue;
        let jacobian =
            a_minus(eigenvalue.hi()) - y.map(in_doubles) * b.map(in_doubles).transpose() / s;
        y -= jacobian
            .lu()
            .solve(&residual.map(in_doubles))?
            .map(TwoFloat::from);
    }
    let mut components = [TwoFloat::from(s); 4];
    for (place, &number) in others.into_iter().zip(y.iter()) {
        components[place] = number;
    }
    Some(components)
}
