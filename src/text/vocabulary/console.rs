//! What consoles write around numbers.

use crate::text::grammar::MAX_DEPTH;
use crate::text::grammar::lex::{Bracket, Spacing, Token, TokenKind};
use crate::text::grammar::tree::CallsAreRead;

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

/// The tokens without the numbers in brackets that R prints before its lines, `[1] 0.92 0.10`, which count the
/// numbers before them.
pub(crate) fn without_indices(tokens: Vec<Token<'_>>) -> Vec<Token<'_>> {
    if !index_ahead(&tokens, 0) {
        return tokens;
    }
    let mut bare = Vec::with_capacity(tokens.len());
    let mut at = 0;
    let mut numbers = 0;
    while let Some(token) = tokens.get(at) {
        if index_ahead(&tokens[at..], numbers) {
            at += 3;
            continue;
        }
        numbers += usize::from(matches!(token.kind, TokenKind::Number(_)));
        bare.push(*token);
        at += 1;
    }
    bare
}

/// Whether tokens begin a line with the place of its first number in brackets, behind so many others.
fn index_ahead(tokens: &[Token<'_>], numbers: usize) -> bool {
    let [open, index, close, next, ..] = tokens else {
        return false;
    };
    let TokenKind::Number(place) = index.kind else {
        return false;
    };
    open.kind == TokenKind::Open(Bracket::Square)
        && close.kind == TokenKind::Close(Bracket::Square)
        && [index, close]
            .into_iter()
            .all(|token| token.spacing.is_adjacent())
        && index.text.bytes().all(|digit| digit.is_ascii_digit())
        && place == (numbers + 1) as f64
        && (numbers == 0 || open.spacing == Spacing::NextLine)
        && next.spacing == Spacing::Apart
        && next.kind != TokenKind::Comma
}

/// Whether among tokens are the name and the length that a console prints before a list.
pub(crate) fn names_a_list(tokens: &[Token<'_>]) -> bool {
    (0..tokens.len()).any(|at| list_name_ahead(&tokens[at..]).is_some())
}

/// How many tokens at the start are the name and the length of the list that follows.
fn list_name_ahead(tokens: &[Token<'_>]) -> Option<usize> {
    // Where no calls are read such a name is one of them, with its number, and so nothing else.
    CallsAreRead::here()?;
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
