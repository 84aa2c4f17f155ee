//! Which characters are letters, by JavaScript: that spares the wasm 2 kB of tables, compressed.
//!
//! This takes the place of `src/letter.rs`, which does the same natively.

use js_sys::RegExp;

thread_local! {
    static LETTER: RegExp = RegExp::new(r"\p{Alphabetic}", "u");
    static LETTER_OR_NUMBER: RegExp = RegExp::new(r"[\p{Alphabetic}\p{N}]", "u");
}

/// Whether a character is a letter; most are told without a call.
pub(crate) fn is_alphabetic(character: char) -> bool {
    character.is_ascii_alphabetic()
        || !character.is_ascii()
            && (is_common(character) || {
                LETTER.with(|letter| letter.test(&String::from(character)))
            })
}

/// Whether a character is a letter or a number.
pub(crate) fn is_alphanumeric(character: char) -> bool {
    character.is_ascii_alphanumeric()
        || !character.is_ascii()
            && (is_common(character) || {
                LETTER_OR_NUMBER.with(|letter| letter.test(&String::from(character)))
            })
}

/// Whether a character is a letter of a script in which long texts are written.
fn is_common(character: char) -> bool {
    matches!(
        character,
        'À'..='Ö' | 'Ø'..='ö' | 'ø'..='ˁ' | 'α'..='ω' | 'А'..='ҁ' | 'ぁ'..='ゖ' | 'ァ'..='ヺ' | '一'..='鿿' | '가'..='힣'
    )
}
