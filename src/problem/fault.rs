//! A problem before it knows which text of a request it stands in.

use crate::problem::{Field, Problem, ProblemCode, Span};

/// A problem before it knows which text it stands in.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    code: ProblemCode,
    span: Span,
    message: String,
    expected: String,
    hint: String,
}

impl Fault {
    pub(crate) fn in_field(self, field: Field) -> Problem {
        Problem {
            code: self.code,
            field,
            span: self.span,
            message: self.message,
            expected: self.expected,
            hint: self.hint,
            suggestion: None,
        }
    }

    pub(crate) fn new(
        code: ProblemCode,
        span: Span,
        message: impl Into<String>,
        expected: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        Self {
            code,
            span,
            message: message.into(),
            expected: expected.into(),
            hint: hint.into(),
        }
    }
}
