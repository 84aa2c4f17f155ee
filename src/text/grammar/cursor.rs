//! The tokens on their way through the grammar: how it looks ahead and how it stops.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::arithmetic::Linear;
use crate::text::grammar::lex::Token;
use crate::text::grammar::signs::{DoubtfulSign, RepeatedSign};
use crate::text::grammar::tree::{Node, NodeKind};
use winnow::stream::Stateful;

pub(crate) type Input<'s, 't> = Stateful<&'s [Token<'t>], State>;

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

pub(crate) fn computed<'t>(value: Linear, span: Span) -> Node<'t> {
    Node {
        kind: NodeKind::Value(value),
        span,
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
