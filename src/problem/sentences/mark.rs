//! The sentences of problems of single characters: marks that mean nothing here, signs that may mean
//! two things, and what is not seen.

use crate::character::is_dash;
use crate::character::is_space_of_numbers;
use crate::character::is_visible;
use crate::character::{decorates, plain_character};
use crate::problem::fault::{Fault, Words};
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, shorten};

impl Fault {
    pub(crate) fn unexpected_character(span: Span, character: char) -> Self {
        if character == '?' {
            return Self::new(
                ProblemCode::UnexpectedCharacter,
                span,
                "the ? stands for a missing number",
                "a number, such as 0.5, 1/√2 or 45deg",
                "replace the ? by the number",
            );
        }
        Self::told(ProblemCode::UnexpectedCharacter, span, || {
            let shown = if is_visible(character) {
                character.to_string()
            } else {
                format!("U+{:04X}", u32::from(character))
            };
            Words::new(
                format!("unexpected character {shown}"),
                "digits, names, brackets and the signs + - * / √ , : =",
                hint_about(character),
            )
        })
    }

    pub(crate) fn loose_sign(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "ambiguous sign: a minus, a difference or the dash of a list",
            "each sign right before its number",
            "write -0.1 without a space, put commas between numbers, or compute the difference",
        )
    }

    pub(crate) fn repeated_sign(span: Span, signs: &str) -> Self {
        Self::told(ProblemCode::Unexpected, span, || {
            let signs = shorten(signs, QUOTED_CHARACTERS);
            Words::new(
                format!("several signs ({signs}) in a row"),
                "at most one sign before a number",
                "write the one sign you mean",
            )
        })
    }

    pub(crate) fn trailing_sign(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "this sign touches the number before it, not the one after it",
            "each sign right before its number",
            "write -0.1 without a space, put commas between numbers, or compute the difference",
        )
    }

    pub(crate) fn run_together(span: Span, written: &str) -> Self {
        Self::told(ProblemCode::Unexpected, span, || {
            let written = shorten(written, QUOTED_CHARACTERS);
            Words::new(
                format!("{written} may be a difference, or two numbers that run together"),
                "a space or a comma between two numbers",
                "write a space before the sign, or compute the difference",
            )
        })
    }

    pub(crate) fn grouped_digits(span: Span) -> Self {
        Self::new(
            ProblemCode::Unexpected,
            span,
            "this may be one number with grouped digits, or two numbers",
            "digits without spaces, or numbers without leading zeros",
            "write 10000 for 10 000, and 0 for 000",
        )
    }

    pub(crate) fn drawn_line(span: Span, drawn: &str) -> Self {
        Self::told(ProblemCode::UnexpectedCharacter, span, || {
            let drawn = shorten(drawn, QUOTED_CHARACTERS);
            Words::new(
                format!("{drawn} is a line-drawing character: part of a frame, or a sign"),
                "- before a negative number, spaces around a drawn frame",
                "write - for a minus, or a space in its place",
            )
        })
    }

    /// A character that is not seen, or hardly, between the digits of what looks like one number.
    pub(crate) fn hidden_in_number(span: Span, character: char) -> Self {
        Self::told(ProblemCode::UnexpectedCharacter, span, || {
            let named = hidden_name(character);
            let seen = if is_space_of_numbers(character) {
                "may group the digits of one number or separate two"
            } else {
                "is invisible and splits what looks like one number"
            };
            Words::new(
                format!("{named} {seen}"),
                "digits without gaps, or a plain space between two numbers",
                "remove it, or write a plain space between two numbers",
            )
        })
    }
}

/// What to try with a character that means nothing here.
fn hint_about(character: char) -> String {
    let plain = plain_character(character);
    if plain != character {
        return format!("write {plain} instead");
    }
    let hint = if is_dash(character) {
        "write - before a negative number"
    } else if decorates(character) || !is_visible(character) {
        "remove it"
    } else {
        "write the resulting numbers, or remove it"
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
