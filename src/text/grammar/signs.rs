//! Signs that may mean two things: several in a row, and those between numbers that run together.

use crate::problem::QUOTED_CHARACTERS;
use crate::problem::fault::Fault;
use crate::text::grammar::arithmetic::Linear;
use crate::text::grammar::lex::{Token, TokenKind, texts_of};

/// A sign that may mean something else, where only white space separates numbers.
#[derive(Clone, Debug)]
pub(crate) struct DoubtfulSign {
    pub(crate) fault: Fault,
    pub(crate) meanings: Meanings,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meanings {
    /// A sign, a difference, or a dash between two members.
    SignOrDash,
    /// A difference, or the sign of a number that runs into the one before it.
    DifferenceOrTwoNumbers,
}

impl DoubtfulSign {
    pub(crate) const fn apart(fault: Fault) -> Self {
        Self {
            fault,
            meanings: Meanings::SignOrDash,
        }
    }
}

/// Two signs or more before one number: `--0.5`, `-+0.5`.
#[derive(Clone, Debug)]
pub(crate) struct RepeatedSign {
    fault: Fault,
    /// A plus and then a minus.
    is_plus_minus: bool,
}

impl RepeatedSign {
    pub(crate) fn of(signs: &[Token<'_>]) -> Option<Self> {
        let [first, .., last] = signs else {
            return None;
        };
        let shown = &signs[..signs.len().min(QUOTED_CHARACTERS + 1)];
        let written = texts_of(shown).concat();
        let kinds = [first.kind, last.kind];
        Some(Self {
            fault: Fault::repeated_sign(first.span.to(last.span), &written),
            is_plus_minus: signs.len() == 2 && kinds == [TokenKind::Plus, TokenKind::Minus],
        })
    }

    /// That they are what programs write in a sum of negative terms, as in `0.92 +-0.38k`.
    pub(crate) fn check(self, value: &Linear) -> Result<(), Fault> {
        if self.is_plus_minus && value.units.is_some() {
            Ok(())
        } else {
            Err(self.fault)
        }
    }
}

/// `0.5000-0.5000`: two numbers as they are typed, of which columns of fixed width are made. Of
/// `1-1/3` and `√2-1` nothing but arithmetic can be.
pub(crate) fn run_together(
    augend: &[Token<'_>],
    sign: Token<'_>,
    addend: &[Token<'_>],
) -> Option<DoubtfulSign> {
    let [.., one] = typed_number(augend)? else {
        return None;
    };
    let [other, ..] = typed_number(addend)? else {
        return None;
    };
    let written = [one.text, sign.text, other.text].concat();
    Some(DoubtfulSign {
        fault: Fault::run_together(one.span.to(other.span), &written),
        meanings: Meanings::DifferenceOrTwoNumbers,
    })
}

/// The tokens of a number that is not computed, without its unit.
fn typed_number<'s, 't>(tokens: &'s [Token<'t>]) -> Option<&'s [Token<'t>]> {
    let tokens = match tokens {
        [number @ .., unit] if unit.angle_unit().is_some() => number,
        _ => tokens,
    };
    let (last, signs) = tokens.split_last()?;
    let is_typed = matches!(last.kind, TokenKind::Number(_))
        && signs
            .iter()
            .all(|sign| matches!(sign.kind, TokenKind::Plus | TokenKind::Minus));
    is_typed.then_some(tokens)
}
