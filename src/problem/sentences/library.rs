//! The sentences of problems of translation and identification.

use crate::problem::fault::Fault;
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, shorten};

impl Fault {
    pub(crate) fn unknown_library(span: Span, id: &str) -> Self {
        Self::new(
            ProblemCode::UnknownLibrary,
            span,
            format!("no library has the id {:?}", shorten(id, QUOTED_CHARACTERS)),
            "the id of a record of the table of libraries",
            "choose a library from the list",
        )
    }

    pub(crate) fn unknown_axes(span: Span, message: String) -> Self {
        Self::new(
            ProblemCode::UnknownAxes,
            span,
            message,
            "the new axes in terms of the old, or two systems of axes",
            "y x -z, or NED to ENU",
        )
    }

    pub(crate) fn one_sided_reflection(span: Span) -> Self {
        Self::new(
            ProblemCode::OneSidedReflection,
            span,
            "one side changes to axes of the other hand and the other side does not, which makes a \
             reflection, and that has no quaternion",
            "determinants of the same sign for world and body",
            "the same change of axes on both sides",
        )
    }

    pub(crate) fn not_a_matrix(span: Span, what: &str) -> Self {
        Self::new(
            ProblemCode::NotAMatrix,
            span,
            format!("this is {what}, and a matrix is wanted here"),
            "nine numbers, three in each row",
            "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]",
        )
    }
}
