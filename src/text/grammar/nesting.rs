//! What stands inside which brackets.

use crate::text::grammar::lex::{Token, TokenKind};

/// The places of the tokens outside all brackets.
pub(crate) fn at_depth_zero<'s>(tokens: &'s [Token<'_>]) -> impl Iterator<Item = usize> + use<'s> {
    let mut depth = 0_usize;
    (0..tokens.len()).filter(move |&at| match tokens[at].kind {
        TokenKind::Open(_) => {
            depth += 1;
            false
        }
        TokenKind::Close(_) => {
            depth = depth.saturating_sub(1);
            false
        }
        _ => depth == 0,
    })
}

/// What stands in brackets that enclose everything.
pub(crate) fn inside<'s, 't>(tokens: &'s [Token<'t>]) -> Option<&'s [Token<'t>]> {
    let [first, inner @ .., last] = tokens else {
        return None;
    };
    let encloses = matches!(first.kind, TokenKind::Open(_))
        && matches!(last.kind, TokenKind::Close(_))
        && at_depth_zero(tokens).next().is_none();
    encloses.then_some(inner)
}

/// How many tokens there are up to the bracket that closes the first.
pub(crate) fn closed(tokens: &[Token<'_>]) -> Option<usize> {
    let mut depth = 0_usize;
    let end = tokens.iter().position(|token| {
        match token.kind {
            TokenKind::Open(_) => depth += 1,
            TokenKind::Close(_) => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0
    });
    end.map(|end| end + 1)
}
