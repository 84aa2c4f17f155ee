//! Which characters are letters, and which are letters or digits, of any script.
//!
//! In the wasm `src/wasm/letter.rs` stands in its place: JavaScript has the tables that this needs.

/// Whether a character is a letter.
pub(crate) fn is_alphabetic(character: char) -> bool {
    character.is_alphabetic()
}

/// Whether a character is a letter or a number.
pub(crate) fn is_alphanumeric(character: char) -> bool {
    character.is_alphanumeric()
}
