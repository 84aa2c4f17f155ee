//! Words of a declaration, which say nothing about its numbers.

use crate::text::grammar::lex::{Bracket, Token, TokenKind};

const WORDS: [&str; 8] = [
    "auto",
    "const",
    "constexpr",
    "final",
    "let",
    "mut",
    "static",
    "var",
];

/// How many tokens after its first words a declaration is looked for its equals sign.
const LONGEST_DECLARATION: usize = 64;

/// The tokens without `const auto` in `const auto q = …` and without `new` in `new Quaternion(…)`.
///
/// Only where something is declared or made: in `rpy var: …` and `static ZYX …` the same words say
/// something of the numbers.
pub(crate) fn without_words<'t>(tokens: &[Token<'t>]) -> Vec<Token<'t>> {
    let mut bare: Vec<Token<'t>> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let rest = &tokens[at..];
        let count = match rest {
            [new, made, ..] if is_word(new) && new.text == "new" && is_word(made) => 1,
            _ => words_of_declaration(rest, bare.last()),
        };
        if count == 0 {
            // Of words that declare nothing all stay.
            let stay = rest.iter().take_while(|token| is_spare(token)).count();
            bare.extend(&rest[..stay.max(1)]);
            at += stay.max(1);
        } else {
            at += count;
        }
    }
    bare
}

fn is_word(token: &Token<'_>) -> bool {
    token.kind == TokenKind::Word
}

fn is_spare(token: &Token<'_>) -> bool {
    is_word(token) && WORDS.contains(&token.text)
}

/// How many tokens at the start are the first words of a declaration.
fn words_of_declaration(tokens: &[Token<'_>], before: Option<&Token<'_>>) -> usize {
    let starts =
        before.is_none_or(|before| matches!(before.kind, TokenKind::Comma | TokenKind::Open(_)));
    let count = tokens.iter().take_while(|token| is_spare(token)).count();
    let rest = &tokens[count..];
    if starts && (assigns(rest) || constructs(rest)) {
        count
    } else {
        0
    }
}

/// `Eigen::Quaterniond q(…)`
fn constructs(tokens: &[Token<'_>]) -> bool {
    matches!(tokens, [made, name, open, ..]
        if is_word(made)
            && is_word(name)
            && matches!(open.kind, TokenKind::Open(Bracket::Round | Bracket::Curly)))
}

/// `q = …`, `double q[4] = …`, `q: Quat<f64> = …`: an equals sign before any number outside brackets.
fn assigns(tokens: &[Token<'_>]) -> bool {
    let is_name = |token: &Token<'_>| is_word(token) || matches!(token.kind, TokenKind::Open(_));
    if !tokens.first().is_some_and(is_name) {
        return false;
    }
    let mut depth = 0_usize;
    for token in tokens.iter().take(LONGEST_DECLARATION) {
        match token.kind {
            TokenKind::Open(_) => depth += 1,
            TokenKind::Close(_) => depth = depth.saturating_sub(1),
            _ if depth > 0 => {}
            TokenKind::Equals => return true,
            TokenKind::Word | TokenKind::Colon | TokenKind::Times => {}
            _ => return false,
        }
    }
    false
}
