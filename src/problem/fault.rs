//! What is wrong with a text, whichever text of a request it is.

use crate::problem::suggestion::{Suggestion, Suggestions, suggestions};
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
    /// What is wrong, in one sentence; without the feature `whole` it is empty, as are the next two.
    pub message: String,
    /// What was expected at that place.
    pub expected: String,
    /// What to try.
    pub hint: String,
    /// The text to write in its place, where that is certain; none of the functions that only parse
    /// look for one.
    pub suggestion: Option<Box<Suggestion>>,
    /// The texts of which one has to be chosen, where what is meant is a question; mostly none.
    pub choices: Suggestions,
}

/// The sentences of a problem.
#[derive(Default)]
pub(crate) struct Words {
    message: String,
    expected: String,
    hint: String,
}

impl Words {
    pub(crate) fn new(
        message: impl Into<String>,
        expected: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        Self {
            message: message.into(),
            expected: expected.into(),
            hint: hint.into(),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)
    }
}

impl std::error::Error for Fault {}

impl Fault {
    /// That of a piece which begins at this byte of the text.
    #[cfg(feature = "whole")]
    pub(crate) fn behind(self, start: usize) -> Self {
        let span = Span::from(start + self.span.start..start + self.span.end);
        Self { span, ..self }
    }

    /// Of sentences that are always the same.
    pub(crate) fn new(
        code: ProblemCode,
        span: Span,
        message: &'static str,
        expected: &'static str,
        hint: &'static str,
    ) -> Self {
        Self::told(code, span, || Words::new(message, expected, hint))
    }

    /// Of sentences that hold something of the text: they are made here and nowhere else, so that a build
    /// without them has nothing of what makes them.
    pub(crate) fn told(code: ProblemCode, span: Span, words: impl FnOnce() -> Words) -> Self {
        let Words {
            message,
            expected,
            hint,
        } = if cfg!(feature = "whole") {
            words()
        } else {
            Words::default()
        };
        Self {
            code,
            span,
            message,
            expected,
            hint,
            suggestion: None,
            choices: Suggestions::default(),
        }
    }

    /// With a text to write instead, where there is one and none was found before; a build without the
    /// sentences looks for none.
    pub(crate) fn suggesting(self, find: impl FnOnce(&Self) -> Option<Suggestion>) -> Self {
        if !cfg!(feature = "whole") || self.suggestion.is_some() {
            return self;
        }
        Self {
            suggestion: find(&self).map(Box::new),
            ..self
        }
    }

    /// With the texts of which one has to be chosen; a build without the sentences looks for none.
    pub(crate) fn offering(self, find: impl FnOnce() -> Vec<Suggestion>) -> Self {
        Self {
            choices: suggestions(find),
            ..self
        }
    }

    pub(crate) fn in_field(self, field: Field) -> Problem {
        Problem {
            code: self.code,
            field,
            at: 0,
            span: self.span,
            message: self.message,
            expected: self.expected,
            hint: self.hint,
            suggestion: self.suggestion,
            choices: self.choices,
        }
    }
}
