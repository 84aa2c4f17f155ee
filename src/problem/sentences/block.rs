//! The sentences of problems of whole blocks that programs print.

use crate::problem::fault::{Fault, Words};
use crate::problem::{ProblemCode, Span};

impl Fault {
    pub(crate) fn several_rotations(span: Span, count: usize) -> Self {
        Self::told(ProblemCode::SeveralRotations, span, || {
            Words::new(
                format!("{count} rotations stand here, and they are not the same one"),
                "a text with one rotation",
                "choose which one is meant, or keep only its lines",
            )
        })
    }

    pub(crate) fn no_rotation_in_row(span: Span) -> Self {
        Self::new(
            ProblemCode::WrongCount,
            span,
            "the names above this row tell of no rotation",
            "columns of a quaternion, of angles or of a matrix",
            "add the columns of the rotation and their names: qx qy qz qw",
        )
    }

    pub(crate) fn unknown_orientation(span: Span) -> Self {
        Self::new(
            ProblemCode::OtherQuantity,
            span,
            "the text says that the orientation is not known: the numbers only fill its place",
            "the numbers of a rotation that was measured",
            "remove this if the numbers are meant all the same",
        )
    }

    pub(crate) fn several_rows(span: Span, count: usize) -> Self {
        Self::told(ProblemCode::SeveralRotations, span, || {
            Words::new(
                format!("{count} rows of a file: a trajectory, not one rotation"),
                "one row",
                "choose a row, or keep only the first row of the file",
            )
        })
    }

    /// Letters and signs that say how numbers are made of others.
    pub(crate) fn formula(span: Span) -> Self {
        Self::new(
            ProblemCode::Formula,
            span,
            "a formula, without the numbers of a rotation",
            "numbers in place of the letters",
            "write the numbers that it gives",
        )
    }
}
