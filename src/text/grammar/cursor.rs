//! The tokens on their way through the grammar: how it looks ahead and how it stops.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::arithmetic::Linear;
use crate::text::grammar::lex::Token;
use crate::text::grammar::signs::{DoubtfulSign, RepeatedSign};
use crate::text::grammar::tree::{Node, NodeKind};
use winnow::error::{ErrMode, ParserError};
use winnow::stream::{Stateful, Stream as _};

pub(crate) type Input<'s, 't> = Stateful<&'s [Token<'t>], State>;
pub(crate) type Parsed<T> = Result<T, ErrMode<Stop>>;

#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) text_end: usize,
    pub(crate) depth: usize,
    pub(crate) spaces: Spaces,
    /// The first sign of this member that may mean something else.
    pub(crate) doubtful_sign: Option<DoubtfulSign>,
    /// Signs that follow each other, until it is known of what.
    pub(crate) repeated_sign: Option<RepeatedSign>,
}

/// Whether white space separates numbers, as in a list, or not, as in a function's argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spaces {
    Separate,
    Ignored,
}

/// Why reading stopped: a fault with its sentence.
#[derive(Clone, Debug)]
pub(crate) struct Stop(Option<Fault>);

impl Stop {
    pub(crate) fn into_fault(error: ErrMode<Self>) -> Fault {
        error
            .into_inner()
            .ok()
            .and_then(|stop| stop.0)
            .unwrap_or_else(|| Fault::unexpected_end(Span::default()))
    }
}

impl<'s, 't> ParserError<Input<'s, 't>> for Stop {
    type Inner = Self;

    fn from_input(input: &Input<'s, 't>) -> Self {
        Self(Some(match input.peek_token() {
            Some(token) => unexpected(&token),
            None => Fault::unexpected_end(end_of(input)),
        }))
    }

    fn into_inner(self) -> Result<Self::Inner, Self> {
        Ok(self)
    }
}

pub(crate) fn stop<T>(fault: Fault) -> Parsed<T> {
    Err(ErrMode::Cut(Stop(Some(fault))))
}

pub(crate) fn computed<'t>(value: Result<Linear, Fault>, span: Span) -> Parsed<Node<'t>> {
    match value {
        Ok(value) => Ok(Node {
            kind: NodeKind::Value(value),
            span,
        }),
        Err(fault) => stop(fault),
    }
}

pub(crate) fn unexpected(token: &Token<'_>) -> Fault {
    Fault::unexpected(token.span, token.text)
}

/// The empty place where the text ends.
pub(crate) fn end_of(input: &Input<'_, '_>) -> Span {
    Span::from(input.state.text_end..input.state.text_end)
}

pub(crate) fn token_at<'t>(input: &Input<'_, 't>, offset: usize) -> Option<Token<'t>> {
    input.input.get(offset).copied()
}
