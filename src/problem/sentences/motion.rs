//! The sentences of rates, small turns and times.

use crate::problem::fault::Fault;
use crate::problem::{ProblemCode, Span};

impl Fault {
    pub(crate) fn not_a_duration(span: Span) -> Self {
        Self::new(
            ProblemCode::OutOfBounds,
            span,
            "nothing moves in this time",
            "a duration above zero",
            "write a positive number: 10 s, 500 ms or 2 min",
        )
    }

    pub(crate) fn not_a_covariance(span: Span, what: &'static str) -> Self {
        Self::new(
            ProblemCode::NotACovariance,
            span,
            what,
            "a symmetric matrix whose variances are not negative, nor smaller than they are correlated",
            "write its nine numbers row by row, or the three variances",
        )
    }

    pub(crate) fn turns_too_far(span: Span) -> Self {
        Self::new(
            ProblemCode::OutOfBounds,
            span,
            "more than 100 turns in this time",
            "a duration in which the body can be followed",
            "write a shorter time, or check the unit of the rate",
        )
    }

    pub(crate) fn too_far(span: Span) -> Self {
        Self::new(
            ProblemCode::OutOfBounds,
            span,
            "more than 1000 times the way",
            "a part of the way, from 0 at p to 1 at q, or some way beyond",
            "write a number such as 0.3",
        )
    }

    pub(crate) fn too_fast(span: Span) -> Self {
        Self::new(
            ProblemCode::OutOfBounds,
            span,
            "a number above 1e9",
            "numbers in radians, degrees or turns",
            "check the unit, and the exponents",
        )
    }
}
