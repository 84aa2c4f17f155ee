//! The sentences of problems of named frames and the poses between them.

use crate::problem::fault::{Fault, Words};
use crate::problem::{ProblemCode, Span, shorten};

/// How many characters of names a sentence lists.
const LONGEST_LIST: usize = 80;

impl Fault {
    pub(crate) fn unnamed_frame(span: Span) -> Self {
        Self::new(
            ProblemCode::UnnamedFrame,
            span,
            "this frame has no name",
            "any name, the same wherever the frame is meant",
            "world, or I1",
        )
    }

    pub(crate) fn same_frame(span: Span) -> Self {
        Self::new(
            ProblemCode::SameFrame,
            span,
            "a frame has no pose in itself",
            "the name of another frame",
            "change one of the two names",
        )
    }

    pub(crate) fn unknown_frame(span: Span, names: &[String]) -> Self {
        Self::told(ProblemCode::UnknownFrame, span, || {
            Words::new(
                "no pose is known of a frame with this name",
                shorten(&names.join(", "), LONGEST_LIST),
                "write one of these, or add a pose of this frame",
            )
        })
    }

    pub(crate) fn frames_do_not_meet(span: Span) -> Self {
        Self::new(
            ProblemCode::FramesDoNotMeet,
            span,
            "no poses lead from the one frame to the other",
            "a pose of a frame on the one side in a frame on the other",
            "add one, or write the same name where the same frame is meant",
        )
    }

    pub(crate) fn two_positions(span: Span) -> Self {
        Self::new(
            ProblemCode::TwoMeanings,
            span,
            "the text of the rotation holds a position already",
            "one position",
            "remove one of the two",
        )
    }

    pub(crate) fn too_many_poses(span: Span) -> Self {
        Self::new(
            ProblemCode::TooManyPoses,
            span,
            "this pose and those after it are not read",
            "at most 32 poses",
            "remove poses that do not lie on the way",
        )
    }
}
