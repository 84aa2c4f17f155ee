//! The name before a member.

use crate::text::grammar::cursor::{Input, token_at};
use crate::text::grammar::lex::{Bracket, TokenKind};
use crate::text::grammar::tree::Key;

/// As in `Eigen::Quaterniond q =`.
const MOST_WORDS_OF_A_KEY: usize = 2;

/// `name:`, `name=`, `"name":` or, in a declaration, `Type name=` and `Type name[4]=`.
pub(crate) fn key_ahead<'t>(input: &Input<'_, 't>) -> Option<(Key<'t>, usize)> {
    let kind = |at: usize| token_at(input, at).map(|token| token.kind);
    let is_name = |at: usize| matches!(kind(at), Some(TokenKind::Word | TokenKind::Quoted));
    let names = (0..MOST_WORDS_OF_A_KEY)
        .take_while(|&at| is_name(at))
        .count();
    let name = token_at(input, names.checked_sub(1)?)?;
    let mut length = names;
    if names > 1 && kind(length) == Some(TokenKind::Open(Bracket::Square)) {
        length += 1;
        if matches!(kind(length), Some(TokenKind::Number(_))) {
            length += 1;
        }
        if kind(length) != Some(TokenKind::Close(Bracket::Square)) {
            return None;
        }
        length += 1;
    }
    let key = Key {
        heading: None,
        name: name.text,
        span: name.span,
    };
    let is_mark = matches!(kind(length), Some(TokenKind::Colon | TokenKind::Equals));
    is_mark.then_some((key, length + 1))
}
