//! A label of numbers: whether it names what they are read as.

use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::grammar::lex::Token;
use crate::text::vocabulary::labels::{LabelWord, other_than_rotation, other_than_vector};
use crate::text::vocabulary::phrases::is_name;

/// A name of a label, and what it names in place of a rotation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OtherLabel<'t> {
    name: Token<'t>,
    other: LabelWord,
}

impl<'t> OtherLabel<'t> {
    pub(crate) fn of(name: &Token<'t>) -> Option<Self> {
        let other = other_than_rotation(name.text)?;
        Some(Self { name: *name, other })
    }

    /// That of several words which name something else together: the one that does alone, or the last.
    pub(crate) fn among(label: &[Token<'t>]) -> Option<Self> {
        // Without the feature `whole` only plain labels are read at all (`told.rs`).
        if !cfg!(feature = "whole") {
            return None;
        }
        let mut names: Vec<Token<'t>> = Vec::new();
        let mut words = Vec::new();
        for token in label {
            if is_name(token) {
                names.push(*token);
                words.push(token.text);
            }
        }
        let other = other_than_rotation(&words.join(" "))?;
        let is_it = |name: &&Token<'t>| other_than_rotation(name.text) == Some(other);
        let name = *names.iter().find(is_it).or(names.last())?;
        Some(Self { name, other })
    }

    pub(crate) fn fault(self) -> Fault {
        fault(
            self.other,
            self.name.span,
            self.name.text,
            Wanted::Quaternion,
        )
    }
}

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
