//! Words and names that are known: what announces, what declares, what constructs.

// Calls that make a rotation of something else.
pub(crate) mod calls;

// What consoles write around numbers.
pub(crate) mod console;

// What a call does with its numbers.
pub(crate) mod constructors;

// Words that are decimal numbers.
pub(crate) mod decimal_words;

// Words of a declaration.
pub(crate) mod declaration;

// The lists of the words of labels.
mod label_words;

// What labels say of the numbers under them.
pub(crate) mod labels;

// Words that are known before numbers.
pub(crate) mod phrases;

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::blank::comments_in;
use crate::text::grammar::lex::{self, Bracket, Token, TokenKind};
use crate::text::grammar::separators::grouped;
use crate::text::vocabulary::console::{names_a_list, without_indices, without_list_names};
use crate::text::vocabulary::declaration::without_words;

/// What a text says of its numbers: its tokens without the words of a declaration, and without what a
/// console prints before a list.
pub(crate) struct Telling<'t> {
    pub(crate) tokens: Vec<Token<'t>>,
    /// Whether anything in it can be a word, a unit or a sequence: of numbers alone no word is asked.
    pub(crate) has_words: bool,
    /// Whether a console printed it as one list, by its name and length.
    pub(crate) is_one_list: bool,
    pub(crate) comments: Vec<Comment<'t>>,
}

/// Whether a word is one of these, which spaces divide.
pub(crate) fn is_listed(word: &str, words: &str) -> bool {
    words.split_ascii_whitespace().any(|known| known == word)
}

/// A comment with its marks, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Comment<'t> {
    pub(crate) text: &'t str,
    pub(crate) span: Span,
}

impl<'t> Telling<'t> {
    pub(crate) fn of(text: &'t str) -> Result<Self, Fault> {
        let tokens = lex::tokens(text)?;
        // Without the feature `whole` no comment has words, and a text with an index is refused.
        let (tokens, comments) = if cfg!(feature = "whole") {
            let comments = comments(text, &tokens);
            (without_indices(tokens), comments)
        } else {
            (tokens, Vec::new())
        };
        let tokens = grouped(tokens)?;
        if !has_words(&tokens) {
            return Ok(Self {
                tokens,
                has_words: false,
                is_one_list: false,
                comments,
            });
        }
        let tokens = without_words(&tokens);
        Ok(Self {
            is_one_list: names_a_list(&tokens),
            tokens: without_list_names(&tokens),
            has_words: true,
            comments,
        })
    }
}

/// What looks like a comment in any text.
#[cfg(feature = "whole")]
pub(crate) fn comments_of(text: &str) -> Vec<Comment<'_>> {
    let mut comments = Vec::new();
    for span in comments_in(text) {
        let text = &text[span.start..span.end];
        comments.push(Comment { text, span });
    }
    comments
}

/// The comments of a text, which stand between its tokens.
fn comments<'t>(text: &'t str, tokens: &[Token<'_>]) -> Vec<Comment<'t>> {
    let mut comments = Vec::new();
    let mut start = 0;
    for at in 0..=tokens.len() {
        let next = tokens.get(at).map(|token| token.span);
        let end = next.map_or(text.len(), |next| next.start);
        if end > start {
            for span in comments_in(&text[start..end]) {
                let span = Span::from(start + span.start..start + span.end);
                let text = &text[span.start..span.end];
                comments.push(Comment { text, span });
            }
        }
        start = next.map_or(end, |next| next.end);
    }
    comments
}

/// Names, units, `<<`, and a minus that touches the number before it, as in `3-2-1`.
fn has_words(tokens: &[Token<'_>]) -> bool {
    let mut before = None;
    tokens.iter().any(|token| {
        let follows_number = matches!(before, Some(TokenKind::Number(_)));
        before = Some(token.kind);
        match token.kind {
            TokenKind::Word
            | TokenKind::Quoted
            | TokenKind::Degree
            | TokenKind::Open(Bracket::Angle) => true,
            TokenKind::Minus => follows_number && token.spacing.is_adjacent(),
            _ => false,
        }
    })
}
