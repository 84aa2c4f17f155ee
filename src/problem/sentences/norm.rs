//! The sentences of quaternions whose norm is not that of a rotation.

use crate::problem::fault::{Fault, Words};
use crate::problem::sentences::matrix::short;
use crate::problem::{ProblemCode, Span};

impl Fault {
    pub(crate) fn zero_quaternion(span: Span) -> Self {
        Self::new(
            ProblemCode::ZeroQuaternion,
            span,
            "all four components are zero: this is not a rotation",
            "at least one component other than zero",
            "write the identity: w=1, x=0, y=0, z=0",
        )
    }

    pub(crate) fn zero_but_for_rounding(span: Span, norm: f64) -> Self {
        Self::told(ProblemCode::FarFromUnit, span, || {
            Words::new(
                format!(
                    "zero but for rounding (norm {}): this is not a rotation",
                    short(norm)
                ),
                "a component that is more than a rounding error",
                "look for where the numbers became zero",
            )
        })
    }

    pub(crate) fn far_from_unit(span: Span, norm: f64) -> Self {
        Self::told(ProblemCode::FarFromUnit, span, || {
            let size = if norm.is_finite() {
                short(norm)
            } else {
                "more than a double holds".to_owned()
            };
            Words::new(
                format!("no quaternion of a rotation: its norm is {size}, far from 1"),
                "w, x, y and z with a norm of about 1; these may be millimetres and an angle",
                "keep the rotation alone, each angle with its name and unit",
            )
        })
    }
}
