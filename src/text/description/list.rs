//! Lists of plain numbers: what holds them and what separates them.

use crate::convention::euler_sequence::EulerSequence;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description::named_members::without_options;
use crate::text::grammar::arithmetic::Linear;
use crate::text::grammar::lex::{Bracket, Token, TokenKind};
use crate::text::grammar::signs::Meanings;
use crate::text::grammar::tree::{Entry, Lead, Node, NodeKind};
use crate::text::vocabulary::Telling;
use crate::text::vocabulary::constructors::{self, Call};

/// What a list, or a call that only holds or makes a vector, holds.
pub(crate) fn held<'e, 't>(node: &'e Node<'t>) -> Option<&'e [Entry<'t>]> {
    match &node.kind {
        NodeKind::List(inner) => Some(inner),
        NodeKind::Call {
            name, arguments, ..
        } => {
            let holds = matches!(constructors::call(name), Call::Vector | Call::Container);
            holds.then_some(arguments)
        }
        NodeKind::Value(_) | NodeKind::Word(_) => None,
    }
}

/// The members inside all the brackets around them.
pub(crate) fn members<'t>(entries: &[Entry<'t>]) -> Result<Vec<Entry<'t>>, Fault> {
    let mut entries = without_options(entries)?;
    while let [only] = &entries[..]
        && only.key.is_none()
        && let Some(inner) = held(&only.node)
    {
        entries = without_options(inner)?;
    }
    Ok(entries)
}

pub(crate) fn values(entries: &[Entry<'_>]) -> Result<Vec<(Linear, Span)>, Fault> {
    check_no_factor(entries)?;
    let mut values = Vec::new();
    for entry in entries {
        values.push((entry.node.value()?, entry.node.span));
    }
    Ok(values)
}

/// The only number there is; a problem where it has a name, or is none, or one of several.
pub(crate) fn number(entries: &[Entry<'_>], span: Span) -> Result<f64, Fault> {
    match entries {
        [only] => match only.key {
            None => only.node.real(),
            Some(key) => Err(Fault::unexpected(key.span, key.name)),
        },
        _ => Err(Fault::not_one_number(span, entries.len())),
    }
}

/// That no number and no call stands before a list: `sqrt(2) [0, 0, 1]`, `transpose(1) [[…], […], […]]`.
pub(crate) fn check_no_factor(entries: &[Entry<'_>]) -> Result<(), Fault> {
    for pair in entries.windows(2) {
        let [before, list] = pair else { continue };
        let touches = list.key.is_none() && list.lead != Lead::AfterComma;
        if !(touches && matches!(list.node.kind, NodeKind::List(_))) {
            continue;
        }
        let span = before.node.span;
        match before.node.kind {
            NodeKind::Value(_) => return Err(Fault::number_before_list(span)),
            NodeKind::Call { name, .. } => return Err(Fault::call_before_list(span, name)),
            NodeKind::List(_) | NodeKind::Word(_) => {}
        }
    }
    Ok(())
}

pub(crate) fn spaces_separate(entries: &[Entry<'_>]) -> bool {
    entries
        .iter()
        .any(|entry| matches!(entry.lead, Lead::Signed | Lead::Bare))
}

pub(crate) fn commas_separate(entries: &[Entry<'_>]) -> bool {
    entries.iter().any(|entry| entry.lead == Lead::AfterComma)
}

/// A sign among numbers that only spaces separate must touch its number, and no other; so must all of
/// those that seem to be one.
pub(crate) fn check_signs(entries: &[Entry<'_>]) -> Result<(), Fault> {
    let doubtful = entries
        .iter()
        .find_map(|entry| entry.doubtful_sign.as_ref());
    match doubtful {
        Some(sign) if spaces_separate(entries) => Err(sign.fault.clone()),
        Some(sign) if entries.len() == 1 && sign.meanings == Meanings::DifferenceOrTwoNumbers => {
            Err(sign.fault.clone())
        }
        _ => Ok(()),
    }
}

/// Commas between all the numbers or between none, and no sign that may be something else.
pub(crate) fn check_separators(entries: &[Entry<'_>], span: Span) -> Result<(), Fault> {
    if spaces_separate(entries) && commas_separate(entries) {
        return Err(Fault::mixed_separators(span));
    }
    check_signs(entries)
}

/// The place of `321` in `321 30 20 10`, which is a sequence with its angles or a quaternion.
pub(crate) fn sequence_among_numbers(members: &[Entry<'_>]) -> Option<Span> {
    let [first, ..] = members else {
        return None;
    };
    let value = first.node.real().ok().filter(|_| members.len() == 4)?;
    let mut names_axes = false;
    for number in 111..=333_u32 {
        names_axes |=
            f64::from(number) == value && number.to_string().parse::<EulerSequence>().is_ok();
    }
    let are_named = members.iter().any(|entry| entry.key.is_some());
    (names_axes && !are_named).then_some(first.node.span)
}

/// The numbers of a text that holds nothing but numbers, brackets and what separates them, with the name
/// that a console prints before a list.
pub(crate) fn only_numbers(text: &str) -> Option<Vec<f64>> {
    let tokens = Telling::of(text).ok()?.tokens;
    let mut numbers = Vec::new();
    let mut before: Option<Token<'_>> = None;
    let mut sign: Option<Token<'_>> = None;
    for token in tokens {
        match token.kind {
            TokenKind::Number(value) => {
                let is_negative = sign.is_some_and(|sign| sign.kind == TokenKind::Minus);
                if sign.is_some() && !token.spacing.is_adjacent() {
                    return None;
                }
                numbers.push(if is_negative { -value } else { value });
                sign = None;
            }
            _ if sign.is_some() => return None,
            // A sign that touches the number before it may be that of a difference.
            TokenKind::Plus | TokenKind::Minus => {
                let touches = token.spacing.is_adjacent()
                    && before.is_some_and(|before| matches!(before.kind, TokenKind::Number(_)));
                if touches {
                    return None;
                }
                sign = Some(token);
            }
            TokenKind::Comma
            | TokenKind::Open(Bracket::Round | Bracket::Square | Bracket::Curly)
            | TokenKind::Close(_) => {}
            _ => return None,
        }
        before = Some(token);
    }
    sign.is_none().then_some(numbers)
}
