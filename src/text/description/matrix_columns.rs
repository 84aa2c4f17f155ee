//! A matrix by its columns or rows, each under a label: the axes of a body by name, `col(0) …`.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description::axis::{span_of, trimmed};
use crate::text::description::list::members;
use crate::text::description::vector as three_numbers;
use crate::text::grammar;
use crate::text::grammar::lex::{Bracket, Token, TokenKind, last_segment};
use crate::text::grammar::nesting::at_depth_zero;
use crate::text::vocabulary::phrases::{is_mark, is_name};
use nalgebra::Matrix3;

/// What the labels of three vectors are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LabelKind {
    /// `x`, `y_axis`: the axes that are turned, which are the columns.
    Axis,
    /// `col(0)`, `column 1:`
    Column,
    /// `row(0)`, `row 1:`
    Row,
}

/// One vector with its label.
pub(crate) struct LabelledVector<'s, 't> {
    kind: LabelKind,
    /// From 0, of an axis; from 0 or from 1, of columns and rows.
    number: usize,
    label: Span,
    tokens: &'s [Token<'t>],
}

/// The labelled vectors that tokens are, two at least; `None` where they are something else, such as
/// components, which are one number each.
pub(crate) fn labelled_vectors<'s, 't>(
    tokens: &'s [Token<'t>],
) -> Option<Vec<LabelledVector<'s, 't>>> {
    // Without the feature `whole` they are members with names, more than one number under each, which are
    // refused.
    if !cfg!(feature = "whole") {
        return None;
    }
    label_ahead(tokens)?;
    let mut vectors: Vec<LabelledVector<'s, 't>> = Vec::new();
    // Where the numbers of the last one begin.
    let mut start = 0;
    for at in at_depth_zero(tokens) {
        let Some(label) = label_ahead(&tokens[at..]) else {
            continue;
        };
        if let Some(last) = vectors.last_mut() {
            last.tokens = trimmed(&tokens[start..at]);
        }
        start = at + label.length;
        vectors.push(LabelledVector {
            kind: label.kind,
            number: label.number,
            label: span_of(&tokens[at..start], Span::default()),
            tokens: trimmed(&tokens[start..]),
        });
    }
    let is_of_one_kind = vectors.iter().all(|vector| vector.kind == vectors[0].kind);
    let are_vectors = vectors.len() > 1 && vectors.iter().all(LabelledVector::has_numbers);
    (is_of_one_kind && are_vectors).then_some(vectors)
}

impl LabelledVector<'_, '_> {
    fn has_numbers(&self) -> bool {
        let entries = grammar::entries(self.tokens).and_then(|entries| members(&entries));
        entries.is_ok_and(|entries| {
            entries.len() > 1 && entries.iter().all(|entry| entry.key.is_none())
        })
    }
}

/// The matrix whose columns or rows these vectors are.
pub(crate) fn matrix(
    vectors: &[LabelledVector<'_, '_>],
    span: Span,
) -> Result<Matrix3<f64>, Fault> {
    let Some(kind) = vectors.first().map(|vector| vector.kind) else {
        return Err(Fault::matrix_count(span, 0));
    };
    let first = match kind {
        LabelKind::Axis => 0,
        // Numbered from 0 or from 1.
        LabelKind::Column | LabelKind::Row => {
            usize::from(vectors.iter().all(|vector| vector.number > 0))
        }
    };
    let name = |place: usize| kind.name(place + first);
    let mut columns = [None; 3];
    for vector in vectors {
        let place = vector.number - first;
        let Some(column) = columns.get_mut(place) else {
            return Err(Fault::unknown_argument(vector.label, &name(place)));
        };
        let numbers = three_numbers::vector(
            &grammar::entries(vector.tokens)?,
            span_of(vector.tokens, vector.label),
        )?;
        if column.replace(numbers).is_some() {
            return Err(Fault::duplicate_part(vector.label, &name(place)));
        }
    }
    let [Some(x), Some(y), Some(z)] = columns else {
        let mut missing = Vec::new();
        for (place, column) in columns.iter().enumerate() {
            if column.is_none() {
                missing.push(name(place));
            }
        }
        return Err(Fault::missing_vector(span, &missing));
    };
    let matrix = Matrix3::from_columns(&[x, y, z]);
    Ok(match kind {
        LabelKind::Axis | LabelKind::Column => matrix,
        LabelKind::Row => matrix.transpose(),
    })
}

impl LabelKind {
    /// What labels mark the vectors of a text that was read as a matrix.
    pub(crate) fn of(tokens: &[Token<'_>]) -> Option<Self> {
        let mut labels = (0..tokens.len()).filter_map(|at| label_ahead(&tokens[at..]));
        let kind = labels.next()?.kind;
        (labels.count() == 2).then_some(kind)
    }

    fn name(self, number: usize) -> String {
        match self {
            Self::Axis => ["x", "y", "z"]
                .get(number)
                .copied()
                .unwrap_or("")
                .to_owned(),
            Self::Column => format!("column {number}"),
            Self::Row => format!("row {number}"),
        }
    }
}

#[derive(Clone, Copy)]
struct Label {
    kind: LabelKind,
    number: usize,
    /// How many tokens it is, with the mark after it.
    length: usize,
}

fn label_ahead(tokens: &[Token<'_>]) -> Option<Label> {
    let (name, rest) = tokens.split_first()?;
    if !is_name(name) {
        return None;
    }
    let lower = last_segment(name.text).to_ascii_lowercase();
    let numbered = |kind, number: &str, length: usize| {
        let number = match number.as_bytes() {
            [digit @ b'0'..=b'3'] => usize::from(digit - b'0'),
            _ => return None,
        };
        Some(Label {
            kind,
            number,
            length: length + usize::from(is_mark(tokens.get(length))),
        })
    };
    for (kind, word) in [
        (LabelKind::Column, "column"),
        (LabelKind::Column, "col"),
        (LabelKind::Row, "row"),
    ] {
        let Some(end) = lower.strip_prefix(word) else {
            continue;
        };
        return match rest {
            [open, number, close, ..]
                if end.is_empty()
                    && open.kind == TokenKind::Open(Bracket::Round)
                    && close.kind == TokenKind::Close(Bracket::Round) =>
            {
                numbered(kind, number.text, 4)
            }
            [number, mark, ..] if end.is_empty() && is_mark(Some(mark)) => {
                numbered(kind, number.text, 2)
            }
            [mark, ..] if is_mark(Some(mark)) => {
                numbered(kind, end.strip_prefix('_').unwrap_or(end), 1)
            }
            _ => None,
        };
    }
    let number = axis_named(&lower)?;
    let is_axis = |token: &Token<'_>| is_name(token) && token.text.eq_ignore_ascii_case("axis");
    let words = match rest {
        [axis, ..] if is_axis(axis) => 2,
        [dash, axis, ..] if dash.kind == TokenKind::Minus && is_axis(axis) => 3,
        _ => 1,
    };
    is_mark(tokens.get(words)).then_some(Label {
        kind: LabelKind::Axis,
        number,
        length: words + 1,
    })
}

/// The place of the axis with this name in small letters: `x`, `x_axis`, `axis_x`, `e_x`, `x_hat`.
fn axis_named(name: &str) -> Option<usize> {
    const BEFORE: [&str; 4] = ["axis", "basis", "unit", "e"];
    const AFTER: [&str; 3] = ["axis", "basis", "hat"];
    let before = BEFORE.iter().find_map(|word| name.strip_prefix(word));
    let after = AFTER.iter().find_map(|word| name.strip_suffix(word));
    let letter = before.or(after).unwrap_or(name).trim_matches('_');
    ["x", "y", "z"].iter().position(|axis| *axis == letter)
}
