//! How a text speaks of its numbers: which description of a rotation its words announce.
//!
//! It works on tokens, before any arithmetic: `3-2-1` is a sequence here and a difference later.

use crate::problem::Span;
use crate::text::description::announcement::{Announcement, announcement};
use crate::text::description::label::OtherLabel;
use crate::text::description::matrix_columns::{LabelledVector, labelled_vectors};
use crate::text::description::named_members::component;
use crate::text::description::named_parts::{SpokenPart, named_parts};
use crate::text::grammar::lex::{Bracket, Token, TokenKind};
use crate::text::grammar::nesting::{at_depth_zero, inside};
use crate::text::vocabulary::phrases::{Form, is_mark, is_name};

/// What a text says of its numbers in words.
pub(crate) enum Spoken<'s, 't> {
    /// Nothing: the numbers, names and calls must tell it.
    Nothing,
    /// `45deg about z`: what stands before and after the word.
    About {
        before: &'s [Token<'t>],
        word: Span,
        after: &'s [Token<'t>],
    },
    /// `axis [0, 0, 1] angle 45deg`, `roll=10deg pitch=20deg yaw=30deg`, and what labels before them say.
    Parts(Announcement<'t>, Vec<SpokenPart<'s, 't>>),
    /// `x: 0 1 0, y: -1 0 0, z: 0 0 1`
    Vectors(Vec<LabelledVector<'s, 't>>),
    /// `rpy_rate: …`, `R.T = …`: a label of all the numbers that names something else.
    Other(OtherLabel<'t>),
    /// Two attributes that are rotations: where the second stands.
    Several(Span),
    /// `rotvec 0 0 0.785`: what is announced and what follows it.
    Announced(Announcement<'t>, &'s [Token<'t>]),
}

/// Brackets around a whole text, and labels before it, that are looked behind for words.
const MOST_WRAPPINGS: usize = 3;

pub(crate) fn spoken<'s, 't>(tokens: &'s [Token<'t>], text: &'t str) -> Spoken<'s, 't> {
    let mut tokens = match &attributes(tokens)[..] {
        [] => tokens,
        [only] => only,
        [_, second, ..] => return Spoken::Several(second[0].span.to(second[2].span)),
    };
    let mut labels = Announcement::default();
    for _ in 0..=MOST_WRAPPINGS {
        if let Some(other) = other_label(tokens) {
            return Spoken::Other(other);
        }
        if let Some(vectors) = labelled_vectors(tokens) {
            return match labels.other {
                Some(other) => Spoken::Other(other),
                None => Spoken::Vectors(vectors),
            };
        }
        if let Some(found) = announcement(tokens, text).or_else(|| comma_initializer(tokens)) {
            let (announcement, length) = found;
            return match labels.other {
                Some(other) => Spoken::Other(other),
                None => Spoken::Announced(announcement, &tokens[length..]),
            };
        }
        if let Some(parts) = named_parts(tokens) {
            let word_before = || OtherLabel::of(tokens.first().filter(|word| is_name(word))?);
            return match labels.other.or_else(word_before) {
                Some(other) => Spoken::Other(other),
                None => Spoken::Parts(labels, parts),
            };
        }
        let about = at_depth_zero(tokens).find(|&at| matches!(tokens[at].text, "about" | "around"));
        if let Some(at) = about {
            return Spoken::About {
                before: after_label(&tokens[..at]).unwrap_or(&tokens[..at]),
                word: tokens[at].span,
                after: &tokens[at + 1..],
            };
        }
        tokens = match (inside(tokens), after_label(tokens)) {
            (Some(inner), _) => inner,
            (None, Some(inner)) => {
                labels.take_label(&tokens[0]);
                inner
            }
            (None, None) => break,
        };
    }
    Spoken::Nothing
}

/// What stands after a name of the whole, as in `q = 45deg about z`.
fn after_label<'s, 't>(tokens: &'s [Token<'t>]) -> Option<&'s [Token<'t>]> {
    match tokens {
        [name, mark, rest @ ..]
            if is_name(name) && is_mark(Some(mark)) && component(name.text).is_none() =>
        {
            Some(rest)
        }
        _ => None,
    }
}

/// The only label of tokens, where it names something else than a rotation.
fn other_label<'t>(tokens: &[Token<'t>]) -> Option<OtherLabel<'t>> {
    let mark = tokens.iter().position(|token| is_mark(Some(token)))?;
    let (label, after) = (&tokens[..mark], &tokens[mark + 1..]);
    // A type or a form before it, or its unit after it, as in `rpy_rate (deg):`.
    let is_alone = at_depth_zero(after).all(|at| !is_mark(after.get(at)));
    let is_beside = label
        .iter()
        .all(|token| !matches!(token.kind, TokenKind::Number(_)));
    let other = OtherLabel::among(label)?;
    (is_alone && is_beside).then_some(other)
}

/// The `rpy="…"` of elements of URDF, or more than one of them without an element.
fn attributes<'s, 't>(tokens: &'s [Token<'t>]) -> Vec<&'s [Token<'t>]> {
    let is_element = |first: &Token<'_>| first.kind == TokenKind::Open(Bracket::Angle);
    let mut found = Vec::new();
    for three in tokens.windows(3) {
        if three[0].text == "rpy" && is_mark(three.get(1)) && three[2].kind == TokenKind::Quoted {
            found.push(three);
        }
    }
    if found.len() > 1 || tokens.first().is_some_and(is_element) {
        return found;
    }
    Vec::new()
}

/// `R << 0, -1, 0, …;` of Eigen, perhaps after the declaration of `R`.
fn comma_initializer<'t>(tokens: &[Token<'t>]) -> Option<(Announcement<'t>, usize)> {
    let is_before = |token: &&Token<'_>| is_name(token) || token.kind == TokenKind::Comma;
    let at = tokens.iter().take_while(is_before).count();
    let shift = tokens.get(at..at + 2)?;
    let is_shift = shift[1].spacing.is_adjacent()
        && shift
            .iter()
            .all(|token| token.kind == TokenKind::Open(Bracket::Angle));
    let announcement = Announcement {
        form: Some(Form::Matrix),
        span: shift[0].span.to(shift[1].span),
        ..Announcement::default()
    };
    (at > 0 && is_shift).then_some((announcement, at + 2))
}
