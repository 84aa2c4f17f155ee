//! Words and names that are known: what announces, what declares, what constructs.

// Calls that make a rotation of something else.
pub(crate) mod calls;

// What consoles write around numbers.
pub(crate) mod console;

// What a call does with its numbers.
pub(crate) mod constructors;

// Words of a declaration.
pub(crate) mod declaration;

// What the words of labels say.
#[allow(dead_code, reason = "what reads labels asks it next")]
pub(crate) mod labels;

// Words that are known before numbers.
pub(crate) mod phrases;

use crate::problem::fault::Fault;
use crate::text::grammar::lex::{self, Bracket, Token, TokenKind};
use crate::text::vocabulary::console::{names_a_list, without_list_names};
use crate::text::vocabulary::declaration::without_words;

/// What a text says of its numbers: its tokens without the words of a declaration, and without what a
/// console prints before a list.
pub(crate) struct Telling<'t> {
    pub(crate) tokens: Vec<Token<'t>>,
    /// Whether anything in it can be a word, a unit or a sequence: of numbers alone no word is asked.
    pub(crate) has_words: bool,
    /// Whether a console printed it as one list, by its name and length.
    pub(crate) is_one_list: bool,
}

impl<'t> Telling<'t> {
    pub(crate) fn of(text: &'t str) -> Result<Self, Fault> {
        let tokens = lex::tokens(text)?;
        if !has_words(&tokens) {
            return Ok(Self {
                tokens,
                has_words: false,
                is_one_list: false,
            });
        }
        let tokens = without_words(&tokens);
        Ok(Self {
            is_one_list: names_a_list(&tokens),
            tokens: without_list_names(&tokens),
            has_words: true,
        })
    }
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
