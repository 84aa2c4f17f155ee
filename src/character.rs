//! What single characters are: dashes, frames that are drawn, spaces that group digits, what is not seen.

/// A letter of any script: one function for all that ask, with its tables once.
pub(crate) fn is_alphabetic(character: char) -> bool {
    character.is_alphabetic()
}

/// A letter or a digit of any script.
pub(crate) fn is_alphanumeric(character: char) -> bool {
    character.is_alphanumeric()
}

/// White space, and what takes no space at all but separates words.
pub(crate) fn is_blank(character: char) -> bool {
    character.is_whitespace() || matches!(character, '\u{200b}' | '\u{2060}' | '\u{feff}')
}

/// What stands between words.
pub(crate) fn parts_words(character: char) -> bool {
    !is_alphanumeric(character)
}

/// What a name consists of.
pub(crate) fn is_of_name(character: char) -> bool {
    is_alphanumeric(character) || character == '_'
}

/// What a name begins with.
pub(crate) fn begins_name(character: char) -> bool {
    is_alphabetic(character) || character == '_'
}

/// A digit of ASCII.
pub(crate) fn is_digit(character: char) -> bool {
    character.is_ascii_digit()
}

/// What a decimal number begins with, behind its sign.
pub(crate) fn begins_number(character: char) -> bool {
    character.is_ascii_digit() || character == '.'
}

/// A capital letter of ASCII.
pub(crate) fn is_capital(character: char) -> bool {
    character.is_ascii_uppercase()
}

/// What is used for a minus, or looks like one.
pub(crate) fn is_dash(character: char) -> bool {
    is_drawn(character)
        || matches!(
            character,
            '-' | '−' | '\u{2010}'..='\u{2015}' | '⁻' | '﹣' | '➖' | '﹘' | '˗' | '~' | '∼' | '±'
        )
}

/// U+FF01 to U+FF5E are the ASCII characters from `!` on, as wide as an ideograph.
pub(crate) fn plain_character(character: char) -> char {
    match character {
        '\u{ff01}'..='\u{ff5e}' => {
            char::from_u32(u32::from(character) - 0xfee0).unwrap_or(character)
        }
        '、' => ',',
        '。' => '.',
        '“' | '”' => '"',
        '‘' | '’' => '\'',
        _ if is_space_of_numbers(character) => ' ',
        _ => character,
    }
}

/// Marks of columns and of items, arrows, and pictures: they tell nothing of the numbers.
pub(crate) fn decorates(mark: char) -> bool {
    matches!(
        mark,
        '$' | '&' | '|' | '¦' | '§' | '¶' | '•' | '‣' | '◦' | '→' | '⇒' | '✓' | '✔' | '➜'
            | '\u{25a0}'..='\u{25ab}' | '\u{25b2}'..='\u{25ff}' | '\u{1f300}'..='\u{1f6ff}'
            | '\u{1f900}'..='\u{1faff}'
    )
}

/// The lines and corners of which frames are drawn; not the diagonals, which stand for nothing.
pub(crate) fn is_drawn(character: char) -> bool {
    matches!(character, '\u{2500}'..='\u{257f}') && !matches!(character, '\u{2571}'..='\u{2573}')
}

/// `─`, in every weight and with gaps: alone it looks like a minus.
pub(crate) fn is_drawn_dash(character: char) -> bool {
    matches!(
        character,
        '─' | '━'
            | '┄'
            | '┅'
            | '┈'
            | '┉'
            | '╌'
            | '╍'
            | '═'
            | '╴'
            | '╶'
            | '╸'
            | '╺'
            | '╼'
            | '╾'
    )
}

pub(crate) fn is_drawn_bar(character: char) -> bool {
    matches!(
        character,
        '│' | '┃'
            | '┆'
            | '┇'
            | '┊'
            | '┋'
            | '╎'
            | '╏'
            | '║'
            | '╵'
            | '╷'
            | '╹'
            | '╻'
            | '╽'
            | '╿'
    )
}

/// Spaces that are narrow, or that keep a number together at the end of a line: they group digits.
pub(crate) fn is_space_of_numbers(character: char) -> bool {
    matches!(
        character,
        '\u{a0}' | '\u{2006}'..='\u{200a}' | '\u{202f}' | '\u{205f}'
    )
}

/// What is not seen at all.
pub(crate) fn is_unseen(character: char) -> bool {
    matches!(
        character,
        '\u{ad}' | '\u{200b}'..='\u{200d}' | '\u{2060}' | '\u{feff}'
    )
}

/// Breaks of a line or a page that most programs show as nothing, or as a box.
pub(crate) fn is_unseen_break(character: char) -> bool {
    matches!(
        character,
        '\u{b}' | '\u{c}' | '\u{85}' | '\u{2028}' | '\u{2029}'
    )
}

/// What is not seen, or turns the writing round, has a name instead.
pub(crate) fn is_visible(character: char) -> bool {
    !character.is_control() && !is_format_character(character)
}

/// Characters without a shape: marks of direction, joiners, spaces of no width, language tags.
const fn is_format_character(character: char) -> bool {
    matches!(
        character,
        '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}'
    )
}
