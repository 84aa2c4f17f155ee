//! What is wrong with a text, whichever text of a request it is.

use crate::problem::suggestion::Suggestion;
use crate::problem::{Field, Problem, ProblemCode, Span};
use std::fmt;

/// Why a text has no result: the place, what is wrong, what was expected, what to try.
///
/// A [`Problem`] says besides which text of a request it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The stable name of the kind of problem.
    pub code: ProblemCode,
    /// Where in the text, in bytes.
    pub span: Span,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What was expected at that place.
    pub expected: String,
    /// What to try.
    pub hint: String,
    /// The text to write in its place, where that is certain; none of the functions that only parse
    /// look for one.
    pub suggestion: Option<Box<Suggestion>>,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)
    }
}

impl std::error::Error for Fault {}

impl Fault {
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
            suggestion: None,
        }
    }

    pub(crate) fn in_field(self, field: Field) -> Problem {
        Problem {
            code: self.code,
            field,
            span: self.span,
            message: self.message,
            expected: self.expected,
            hint: self.hint,
            suggestion: self.suggestion,
        }
    }
}
