//! The sentences of labels and comments that say something else than what is read.

use crate::problem::fault::{Fault, Words};
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, Wanted, shorten};

impl Fault {
    /// A label that names something else than what is wanted: `what`, in words.
    pub(crate) fn other_label(span: Span, name: &str, what: &str, wanted: Wanted) -> Self {
        Self::told(ProblemCode::OtherQuantity, span, || {
            let (name, itself) = (shorten(name, QUOTED_CHARACTERS), itself(wanted));
            Words::new(
                format!("{name} names {what}, not the {itself} itself"),
                format!("the numbers of the {itself}"),
                format!("remove this name if the numbers are the {itself}"),
            )
        })
    }

    /// A comment that says that the numbers are something else.
    pub(crate) fn other_comment(span: Span, what: &str, wanted: Wanted) -> Self {
        Self::told(ProblemCode::OtherQuantity, span, || {
            let itself = itself(wanted);
            Words::new(
                format!("these words speak of {what}, not of the {itself} itself"),
                format!("the numbers of the {itself}"),
                format!("remove the words if the numbers are the {itself}"),
            )
        })
    }

    /// A label or a comment that names an order of components which is none of the two, or both.
    pub(crate) fn other_order(span: Span, wanted: Wanted) -> Self {
        Self::told(ProblemCode::OtherQuantity, span, || {
            let orders = match wanted {
                Wanted::Quaternion => "w x y z or x y z w",
                Wanted::Vector => "x y z",
            };
            Words::new(
                "another order of components, or more than one",
                format!("numbers in the order {orders}"),
                "write the numbers in this order, or name them: x=1, y=2, z=3",
            )
        })
    }

    pub(crate) fn left_handed(span: Span) -> Self {
        Self::new(
            ProblemCode::OtherQuantity,
            span,
            "left-handed axes: the same numbers turn the other way round",
            "numbers for right-handed axes",
            "convert the numbers to right-handed axes first",
        )
    }

    /// A label or a comment that names another convention than is declared: `what`, in words.
    pub(crate) fn told_otherwise(span: Span, what: &str) -> Self {
        Self::told(ProblemCode::OtherQuantity, span, || {
            Words::new(
                format!("these words say {what}, which is not what is declared"),
                "numbers in the declared convention",
                format!("declare {what}, or remove the words if the numbers are as declared"),
            )
        })
    }

    /// A label or a comment of angles or of a vector along the axis that lead from the world to the body.
    pub(crate) fn opposite_attitude(span: Span, what: &str) -> Self {
        Self::told(ProblemCode::OtherQuantity, span, || {
            Words::new(
                format!("these words say {what}; angles and their axes are read as body to world"),
                "the turn of the body as seen from the world",
                "write the opposite turn, or remove the words if this is the turn of the body",
            )
        })
    }
}

/// What is wanted, in a sentence about it.
fn itself(wanted: Wanted) -> &'static str {
    match wanted {
        Wanted::Quaternion => "rotation",
        Wanted::Vector => "vector",
    }
}
