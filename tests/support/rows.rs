//! A matrix as numbers.

use quatlas::nalgebra::Matrix3;

/// The rows of a matrix, one after the other.
pub(crate) fn row_major(matrix: &Matrix3<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}
