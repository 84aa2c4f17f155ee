//! Which characters are letters, by JavaScript: that spares the wasm 1 kB of tables, compressed.
//!
//! This takes the place of `src/letter.rs`, which does the same natively.

use js_sys::RegExp;

thread_local! {
    static LETTER: RegExp = RegExp::new(r"\p{Alphabetic}", "u");
    static LETTER_OR_NUMBER: RegExp = RegExp::new(r"[\p{Alphabetic}\p{N}]", "u");
}

/// Whether a character is a letter.
pub(crate) fn is_alphabetic(character: char) -> bool {
    if character.is_ascii() {
        return character.is_ascii_alphabetic();
    }
    is_common_letter(character)
        .unwrap_or_else(|| LETTER.with(|letter| letter.test(&String::from(character))))
}

/// Whether a character is a letter or a number.
pub(crate) fn is_alphanumeric(character: char) -> bool {
    if character.is_ascii() {
        return character.is_ascii_alphanumeric();
    }
    is_common_letter(character)
        .unwrap_or_else(|| LETTER_OR_NUMBER.with(|letter| letter.test(&String::from(character))))
}

/// The same without a call, of the letters and the marks of which long texts are made; `None` for others.
fn is_common_letter(character: char) -> Option<bool> {
    match character {
        'À'..='Ö'
        | 'Ø'..='ö'
        | 'ø'..='ˁ'
        | 'α'..='ω'
        | 'А'..='ҁ'
        | 'א'..='ת'
        | 'ء'..='ي'
        | 'ぁ'..='ゖ'
        | 'ァ'..='ヺ'
        | '一'..='鿿'
        | '가'..='힣' => Some(true),
        '°'
        | '±'
        | '·'
        | '×'
        | '\u{2010}'..='\u{206f}'
        | '\u{2190}'..='\u{22ff}'
        | '\u{2500}'..='\u{25ff}' => Some(false),
        _ => None,
    }
}
