//! What the text of a quaternion or a vector is made of, once its arithmetic is done.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::arithmetic::{Linear, Quantity};
use crate::text::grammar::lex::{Token, TokenKind};
use crate::text::grammar::signs::DoubtfulSign;

/// A piece of text that was understood.
#[derive(Clone, Debug)]
pub(crate) struct Node<'t> {
    pub(crate) kind: NodeKind<'t>,
    pub(crate) span: Span,
}

#[derive(Clone, Debug)]
pub(crate) enum NodeKind<'t> {
    Value(Linear),
    List(Vec<Entry<'t>>),
    Call {
        name: &'t str,
        arguments: Vec<Entry<'t>>,
        #[expect(dead_code, reason = "that it is there is all that it says")]
        read: CallsAreRead,
    },
    Word(&'t str),
}

/// That calls are read.
#[cfg(feature = "whole")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct CallsAreRead;

/// That calls are read, which they are not: there is no value of this, so no call either, and the compiler
/// leaves out all that is made of one.
#[cfg(not(feature = "whole"))]
#[derive(Clone, Copy, Debug)]
pub(crate) enum CallsAreRead {}

impl CallsAreRead {
    #[cfg(feature = "whole")]
    pub(crate) const fn here() -> Option<Self> {
        Some(Self)
    }

    #[cfg(not(feature = "whole"))]
    pub(crate) const fn here() -> Option<Self> {
        None
    }
}

impl<'t> Node<'t> {
    /// What stands between brackets: a list, or what they only group.
    pub(crate) fn of_brackets(entries: Vec<Entry<'t>>, span: Span) -> Self {
        match <[Entry<'t>; 1]>::try_from(entries) {
            // One member alone: brackets that only group.
            Ok(
                [
                    Entry {
                        key: None, node, ..
                    },
                ],
            ) => Node { span, ..node },
            Ok(one) => Node {
                kind: NodeKind::List(one.into()),
                span,
            },
            Err(entries) => Node {
                kind: NodeKind::List(entries),
                span,
            },
        }
    }

    /// Whether what comes next is a factor that only stands beside it.
    ///
    /// `0.38k`, `2pi`, `2√3`: no space between. `sin(pi/8) k`, `k sin(pi/8)`: a unit may stand apart.
    pub(crate) fn is_multiplied_by(&self, next: &Token<'_>) -> bool {
        let NodeKind::Value(value) = self.kind else {
            return false;
        };
        let is_adjacent = next.spacing.is_adjacent();
        match next.kind {
            TokenKind::Word => {
                is_adjacent
                    || Linear::unit(next.text).is_some()
                    || (value.units.is_some() && Linear::is_known(next.text))
            }
            TokenKind::Root => is_adjacent || value.units.is_some(),
            _ => false,
        }
    }
}

/// A member of a list: a node, perhaps with a name before it.
#[derive(Clone, Debug)]
pub(crate) struct Entry<'t> {
    pub(crate) key: Option<Key<'t>>,
    pub(crate) node: Node<'t>,
    pub(crate) lead: Lead,
    /// What a sign of this member may mean besides, where only white space separates the members.
    pub(crate) doubtful_sign: Option<DoubtfulSign>,
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Key<'t> {
    /// The label before it, such as `orientation:` above `x: 0`.
    pub(crate) heading: Option<&'t str>,
    pub(crate) name: &'t str,
    pub(crate) span: Span,
}

/// What stands before a member: nothing, a comma, only white space and then a sign, or only white
/// space. A sum such as `0.92 +0.38k` is first read as two members.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lead {
    First,
    AfterComma,
    Signed,
    Bare,
}

impl Node<'_> {
    /// The value of arithmetic that goes on: a number, a sum of units, or an angle.
    pub(crate) fn operand(&self) -> Result<Linear, Fault> {
        match &self.kind {
            NodeKind::Value(value) => Ok(*value),
            _ => self.value(),
        }
    }

    /// The number, or sum of units, that this is; a problem where it is something else.
    pub(crate) fn value(&self) -> Result<Linear, Fault> {
        match &self.kind {
            NodeKind::Value(value) if matches!(value.quantity, Quantity::Angle(_)) => {
                Err(Fault::angle_for_number(self.span))
            }
            NodeKind::Value(value) => Ok(*value),
            NodeKind::Word(word) | NodeKind::Call { name: word, .. } => {
                Err(Fault::unknown_word(self.span, word))
            }
            NodeKind::List(_) => Err(Fault::list_for_number(self.span)),
        }
    }

    /// The real number that this is, with its unit if it is an angle; a problem where it is
    /// something else.
    pub(crate) fn angle(&self) -> Result<Linear, Fault> {
        let value = self.operand()?;
        match value.units {
            None => Ok(value),
            Some(_) => Err(Fault::unit_for_number(self.span)),
        }
    }

    /// `True` or `false`, not in quotes.
    pub(crate) fn truth(&self) -> Option<bool> {
        match self.kind {
            NodeKind::Word(word) if word.len() < self.span.end - self.span.start => None,
            NodeKind::Word("True" | "true") => Some(true),
            NodeKind::Word("False" | "false") => Some(false),
            _ => None,
        }
    }

    /// The real number that this is; a problem where it is something else.
    pub(crate) fn real(&self) -> Result<f64, Fault> {
        let value = self.value()?;
        match value.units {
            None => Ok(value.scalar),
            Some(_) => Err(Fault::unit_for_number(self.span)),
        }
    }
}
