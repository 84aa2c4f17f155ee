//! What consoles write around numbers.

use crate::lex::{self, Bracket, MAX_TEXT_BYTES, Token, TokenKind};
use crate::syntax::{self, MAX_DEPTH};
use crate::tree::{Entry, NodeKind};
use nalgebra::Matrix3;
use std::borrow::Cow;
use std::ops::Range;

/// Names before the length of a list, as Node and browsers print them: typed arrays, arrays, and the
/// classes of vectors and matrices that extend them (gl-matrix, OGL, math.gl).
const LIST_NAMES: [&str; 19] = [
    "Array",
    "Float16Array",
    "Float32Array",
    "Float64Array",
    "Int8Array",
    "Int16Array",
    "Int32Array",
    "Uint8Array",
    "Uint8ClampedArray",
    "Uint16Array",
    "Uint32Array",
    "Mat3",
    "Mat4",
    "Matrix3",
    "Matrix4",
    "Vec3",
    "Vec4",
    "Vector3",
    "Vector4",
];

/// Of these the name stays, since each library has its own order of the four numbers.
const QUATERNION_NAMES: [&str; 2] = ["Quat", "Quaternion"];

/// The text with the corners and lines that are drawn around a matrix blanked, every byte at its
/// place.
pub(crate) fn without_wrappers(text: &str) -> Cow<'_, str> {
    let drawn = text.match_indices(|c| ('\u{2500}'..='\u{257f}').contains(&c));
    let drawn = drawn.map(|(at, character)| at..at + character.len());
    let wrappers: Vec<Range<usize>> = drawn.collect();
    if wrappers.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut bare = text.to_owned();
    for wrapper in wrappers {
        let blank = " ".repeat(wrapper.len());
        bare.replace_range(wrapper, &blank);
    }
    Cow::Owned(bare)
}

/// The tokens without the names and lengths that consoles print before lists: `Float32Array(4) [ … ]`,
/// `Mat3(9) [Float32Array] [ … ]`.
///
/// Any other word, and any other number than that of the list's members, stays: `transpose(1) [ … ]`
/// and `sqrt(2) [ … ]` are something else.
pub(crate) fn without_list_names<'t>(tokens: &[Token<'t>]) -> Vec<Token<'t>> {
    let mut bare = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let length = list_name_ahead(&tokens[at..]).unwrap_or_default();
        let stays = length == 0 || QUATERNION_NAMES.contains(&token.text);
        if stays {
            bare.push(*token);
        }
        at += length.max(1);
    }
    bare
}

/// Whether a console printed a text as one list of numbers, by its name and length.
pub(crate) fn names_a_list(text: &str) -> bool {
    let is_named = |tokens: Vec<Token<'_>>| {
        (0..tokens.len()).any(|at| list_name_ahead(&tokens[at..]).is_some())
    };
    lex::tokens(text).is_ok_and(is_named)
}

/// How many tokens at the start are the name and the length of the list that follows.
fn list_name_ahead(tokens: &[Token<'_>]) -> Option<usize> {
    let [name, open, count, close, rest @ ..] = tokens else {
        return None;
    };
    let is_known = LIST_NAMES.contains(&name.text) || QUATERNION_NAMES.contains(&name.text);
    let is_call = name.kind == TokenKind::Word
        && open.kind == TokenKind::Open(Bracket::Round)
        && close.kind == TokenKind::Close(Bracket::Round);
    let TokenKind::Number(count) = count.kind else {
        return None;
    };
    if !(is_known && is_call) {
        return None;
    }
    // The class that it extends: `[Float32Array]`.
    let (length, list) = match rest {
        [open, class, close, list @ ..]
            if open.kind == TokenKind::Open(Bracket::Square)
                && LIST_NAMES.contains(&class.text)
                && close.kind == TokenKind::Close(Bracket::Square) =>
        {
            (7, list)
        }
        _ => (4, rest),
    };
    (members(list)? as f64 == count).then_some(length)
}

/// How many members stand between commas in the list that tokens begin with.
fn members(tokens: &[Token<'_>]) -> Option<usize> {
    let (open, inner) = tokens.split_first()?;
    if open.kind != TokenKind::Open(Bracket::Square) {
        return None;
    }
    let (mut depth, mut members, mut is_new) = (0_usize, 0, true);
    for token in inner {
        match token.kind {
            TokenKind::Close(_) if depth == 0 => return Some(members),
            TokenKind::Comma if depth == 0 => {
                is_new = true;
                continue;
            }
            // Deeper nothing is read, and each of many names would be followed to the end.
            TokenKind::Open(_) if depth == MAX_DEPTH => return None,
            TokenKind::Open(_) => depth += 1,
            TokenKind::Close(_) => depth -= 1,
            _ => {}
        }
        members += usize::from(is_new);
        is_new = false;
    }
    None
}

/// The rotation part of sixteen numbers whose last row and last column are 0, 0, 0, 1.
pub(crate) fn homogeneous(text: &str) -> Option<Matrix3<f64>> {
    if text.len() > MAX_TEXT_BYTES {
        return None;
    }
    let text = without_wrappers(text);
    let tokens = without_list_names(&lex::tokens(&text).ok()?);
    let mut numbers = Vec::new();
    plain_numbers(&syntax::entries(&tokens).ok()?, &mut numbers)?;
    let entry = |row: usize, column: usize| numbers[4 * row + column];
    let is_affine = numbers.len() == 16
        && entry(3, 3) == 1.0
        && (0..3).all(|at| entry(at, 3) == 0.0 && entry(3, at) == 0.0);
    is_affine.then(|| Matrix3::from_fn(entry))
}

/// The numbers in lists of lists; `None` where anything else is among them.
fn plain_numbers(entries: &[Entry<'_>], numbers: &mut Vec<f64>) -> Option<()> {
    for entry in entries {
        match &entry.node.kind {
            _ if entry.key.is_some() => return None,
            NodeKind::List(inner) => plain_numbers(inner, numbers)?,
            NodeKind::Value(_) => numbers.push(entry.node.real().ok()?),
            NodeKind::Word(_) | NodeKind::Call { .. } => return None,
        }
    }
    Some(())
}
