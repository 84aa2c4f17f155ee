//! The sentences of problems of single characters: marks that mean nothing here, signs that may mean
//! two things, and what is not seen.

use crate::character::is_dash;
use crate::character::is_space_of_numbers;
use crate::character::is_visible;
use crate::character::{decorates, plain_character};
use crate::problem::fault::Fault;
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, shorten};

impl Fault {
    pub(crate) fn unexpected_character(span: Span, character: char) -> Self {
        if character == '?' {
            return Self::new(
                ProblemCode::UnexpectedCharacter,
                span,
                "a number is missing where the ? stands",
                "a number, such as 0.5, 1/√2 or 45deg",
                "write it in place of the ?",
            );
        }
        let shown = if is_visible(character) {
            character.to_string()
        } else {
            format!("U+{:04X}", u32::from(character))
        };
        Self::new(
            ProblemCode::UnexpectedCharacter,
            span,
            format!("the character {shown} has no meaning here"),
            "digits, names, brackets and the signs + - * / √ , : =",
            hint_about(character),
        )
    }

    pub(crate) fn loose_sign(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "with spaces around this sign it can be a minus, a difference or a dash of a list",
            "numbers whose signs stand right before them",
            "write -0.1 for a negative number, put commas between the numbers, or compute the difference",
        )
    }

    pub(crate) fn repeated_sign(span: Span, signs: &str) -> Self {
        let signs = shorten(signs, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::Unexpected,
            span,
            format!("of the signs {signs} one may be a slip, a dash or a difference"),
            "at most one sign before a number",
            "write the one sign that is meant",
        )
    }

    pub(crate) fn trailing_sign(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "this sign touches the number before it, and not the one behind it",
            "numbers whose signs stand right before them",
            "write -0.1 for a negative number, put commas between the numbers, or compute the difference",
        )
    }

    pub(crate) fn run_together(span: Span, written: &str) -> Self {
        let written = shorten(written, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::Unexpected,
            span,
            format!("{written} can be a difference, or two numbers that run together"),
            "a space or a comma between two numbers",
            "write a space before the sign, or compute the difference",
        )
    }

    pub(crate) fn grouped_digits(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "this can be one number whose digits are grouped, or two numbers",
            "digits that stand together, or numbers without a 0 before them",
            "write 10000 for 10 000, and 0 for 000",
        )
    }

    pub(crate) fn drawn_line(span: Span, drawn: &str) -> Self {
        let drawn = shorten(drawn, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnexpectedCharacter,
            span,
            format!(
                "{drawn} is drawn like the line of a frame, and here it looks like a minus or a mark"
            ),
            "the sign - before a negative number; around a frame, spaces",
            "write - where a minus is meant, or a space where it is none",
        )
    }

    /// A character that is not seen, or hardly, between the digits of what looks like one number.
    pub(crate) fn hidden_in_number(span: Span, character: char) -> Self {
        let named = hidden_name(character);
        let seen = if is_space_of_numbers(character) {
            "may group the digits of one number or separate two"
        } else {
            "is not seen, and separates what looks like one number"
        };
        Self::new(
            ProblemCode::UnexpectedCharacter,
            span,
            format!("{named} {seen}"),
            "digits that stand together, or a plain space between two numbers",
            "remove it inside a number, or write a plain space between two",
        )
    }
}

/// What to try with a character that means nothing here.
fn hint_about(character: char) -> String {
    let plain = plain_character(character);
    if plain != character {
        return format!("write {plain} in its place");
    }
    let hint = if is_dash(character) {
        "write - before the number where a minus is meant"
    } else if decorates(character) || !is_visible(character) {
        "remove it"
    } else {
        "write the numbers that come out of it, or remove it where it means nothing"
    };
    hint.to_owned()
}

/// What a character is called that cannot be shown, with its number.
fn hidden_name(character: char) -> String {
    let name = match character {
        '\u{b}' => "the vertical tab ",
        '\u{c}' => "the form feed ",
        '\u{85}' => "the line break ",
        '\u{2028}' => "the line separator ",
        '\u{2029}' => "the paragraph separator ",
        '\u{a0}' => "the no-break space ",
        '\u{ad}' => "the soft hyphen ",
        '\u{2007}' => "the figure space ",
        '\u{2009}' => "the thin space ",
        '\u{200a}' => "the hair space ",
        '\u{200b}' => "the zero-width space ",
        '\u{202f}' => "the narrow no-break space ",
        '\u{2060}' => "the word joiner ",
        '\u{feff}' => "the byte order mark ",
        _ => "the character ",
    };
    format!("{name}U+{:04X}", u32::from(character))
}
