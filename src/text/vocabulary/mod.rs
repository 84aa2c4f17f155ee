//! Words and names that are known: what announces, what declares, what constructs.

// What consoles write around numbers.
pub(crate) mod console;

// What a call does with its numbers.
pub(crate) mod constructors;

// Words of a declaration.
pub(crate) mod declaration;

// Words that are known before numbers.
pub(crate) mod phrases;

use crate::problem::fault::Fault;
use crate::text::grammar::lex::Token;
use crate::text::vocabulary::console::{names_a_list, without_list_names};

/// What a text says of its numbers: its tokens without the words of a declaration, and without what a
/// console prints before a list.
pub(crate) struct Telling<'t> {
    pub(crate) tokens: Vec<Token<'t>>,
    /// Whether a console printed it as one list, by its name and length.
    pub(crate) is_one_list: bool,
}

impl<'t> Telling<'t> {
    pub(crate) fn of(text: &'t str) -> Result<Self, Fault> {
        let tokens = declaration::tokens(text)?;
        Ok(Self {
            is_one_list: names_a_list(&tokens),
            tokens: without_list_names(&tokens),
        })
    }
}
