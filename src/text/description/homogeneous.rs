//! Twelve or sixteen numbers that are a homogeneous matrix row by row: a rotation and a translation.

use crate::text::description::list::{Written, only_numbers};
use nalgebra::Matrix3;

/// Three rows of four numbers as they are written; whether the nine are a rotation is not asked.
pub(crate) struct HomogeneousMatrix {
    /// The three by three on the left, row by row.
    pub(crate) rotation: [[Written; 3]; 3],
    /// The fourth column.
    pub(crate) translation: [Written; 3],
    /// Whether 0, 0, 0, 1 is written below.
    pub(crate) has_last_row: bool,
}

impl HomogeneousMatrix {
    /// That of a text of numbers alone: sixteen whose last row is 0, 0, 0, 1, or twelve. Of words and
    /// computations nothing is taken.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let numbers = only_numbers(text)?;
        let (rows, []) = numbers.as_chunks::<4>() else {
            return None;
        };
        let (rows, has_last_row) = match rows {
            [first, second, third] if !are_axes(&numbers[..9]) => ([first, second, third], false),
            [first, second, third, last]
                if last.map(|number| number.value) == [0.0, 0.0, 0.0, 1.0] =>
            {
                ([first, second, third], true)
            }
            _ => return None,
        };
        Some(Self {
            rotation: rows.map(|&[x, y, z, _]| [x, y, z]),
            translation: rows.map(|&[.., fourth]| fourth),
            has_last_row,
        })
    }
}

/// Nine numbers that are a rotation already, before a translation of three.
fn are_axes(numbers: &[Written]) -> bool {
    let matrix = Matrix3::from_iterator(numbers.iter().map(|number| number.value));
    (matrix.transpose() * matrix - Matrix3::identity()).amax() < NEARLY_ORTHONORMAL
}

/// Entries of two decimals are off by less.
const NEARLY_ORTHONORMAL: f64 = 0.05;
