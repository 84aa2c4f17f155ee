//! Matrices as rotations.

use quatlas::nalgebra::Matrix3;
use quatlas::{MatrixConvention, Rotation, TaggedMatrix};

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
