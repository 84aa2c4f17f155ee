//! A label of numbers: whether it names what they are read as.

use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::grammar::lex::Token;
use crate::text::vocabulary::labels::{LabelWord, other_than_rotation, other_than_vector};
use crate::text::vocabulary::phrases::is_name;

/// That a label names nothing else than what is wanted.
pub(crate) fn check(name: &str, span: Span, wanted: Wanted) -> Result<(), Fault> {
    let other = match wanted {
        Wanted::Quaternion => other_than_rotation(name),
        Wanted::Vector => other_than_vector(name),
    };
    match other {
        Some(other) => Err(fault(other, span, name, wanted)),
        None => Ok(()),
    }
}

fn fault(other: LabelWord, span: Span, name: &str, wanted: Wanted) -> Fault {
    match other {
        LabelWord::OtherOrder => Fault::other_order(span, wanted),
        LabelWord::LeftHanded => Fault::left_handed(span),
        _ => Fault::other_label(span, name, other.in_words(), wanted),
    }
}

/// The problem of a label of several words that name something else than a rotation together, at the one that
/// does alone.
pub(crate) fn fault_of_words(label: &[Token<'_>]) -> Option<Fault> {
    let names: Vec<&Token<'_>> = label.iter().filter(|token| is_name(token)).collect();
    let together = names
        .iter()
        .map(|name| name.text)
        .collect::<Vec<_>>()
        .join(" ");
    let other = other_than_rotation(&together)?;
    let is_it = |name: &&&Token<'_>| other_than_rotation(name.text) == Some(other);
    let name = names.iter().find(is_it).or(names.last())?;
    Some(fault(other, name.span, name.text, Wanted::Quaternion))
}
