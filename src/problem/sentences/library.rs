//! The sentences of problems of translation and identification.

use crate::problem::fault::{Fault, Words};
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, shorten};

impl Fault {
    pub(crate) fn unknown_library(span: Span, id: &str) -> Self {
        Self::told(ProblemCode::UnknownLibrary, span, || {
            Words::new(
                format!("no library has the id {:?}", shorten(id, QUOTED_CHARACTERS)),
                "the id of a library in the table",
                "choose a library from the list",
            )
        })
    }

    pub(crate) fn unknown_axes(span: Span, message: String) -> Self {
        Self::told(ProblemCode::UnknownAxes, span, || {
            Words::new(
                message,
                "new axes in terms of the old ones, or two named systems of axes",
                "y x -z, or NED to ENU",
            )
        })
    }

    pub(crate) fn one_sided_reflection(span: Span) -> Self {
        Self::new(
            ProblemCode::OneSidedReflection,
            span,
            "only one side changes handedness: a reflection, which has no quaternion",
            "determinants of the same sign for world and body",
            "the same change of axes on both sides",
        )
    }

    pub(crate) fn fits_no_convention(span: Span, what: &'static str, hint: &'static str) -> Self {
        Self::told(ProblemCode::FitsNoConvention, span, || {
            Words::new(
                what,
                "what one of the conventions prints of what was put in",
                hint,
            )
        })
    }

    pub(crate) fn not_a_matrix(span: Span, what: &str) -> Self {
        Self::told(ProblemCode::NotAMatrix, span, || {
            Words::new(
                format!("this is {what}, a matrix is needed here"),
                "nine numbers, three in each row",
                "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]",
            )
        })
    }
}
