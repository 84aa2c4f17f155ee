//! The numbers that stand in a text, whether it can be read or not: no suggestion makes others of them.

use crate::character::is_blank;
use crate::character::is_dash;
use crate::character::plain_character;
use crate::problem::suggestion::{Remedy, Suggestion};
use crate::text::grammar::blank::{YamlDash, without_comments};

/// Whether the numbers of a suggestion are those of the text, in their order and with their signs,
/// but for what the remedy says that it changes.
pub(crate) fn keeps_numbers(text: &str, suggestion: &Suggestion) -> bool {
    let typed = || typed_numbers(text);
    let rewritten = || typed_numbers(&suggestion.text);
    // A dash stays what it is, a minus or the mark of an item, and no number is joined to a comment.
    let is_laid_out_alike = || {
        let outside = |text: &str| typed_numbers(&without_comments(text));
        YamlDash::of(text) == YamlDash::of(&suggestion.text)
            && outside(text) == outside(&suggestion.text)
    };
    match suggestion.remedy {
        // These write other numbers by their names.
        Remedy::DecimalPoints
        | Remedy::WriteZero
        | Remedy::WriteIdentity
        | Remedy::RestoreAxis
        | Remedy::NearestRotation => true,
        // These are names.
        Remedy::RenameFrame | Remedy::AddPose => true,
        Remedy::AddZeros => rewritten().starts_with(&typed()),
        Remedy::AsYaw | Remedy::ThisRotation => {
            let mut typed = typed().into_iter();
            rewritten()
                .iter()
                .all(|kept| typed.any(|number| number == *kept))
        }
        Remedy::AsQuaternion
        | Remedy::AsAxisAngle
        | Remedy::AsEulerAngles
        | Remedy::OtherOrder
        | Remedy::WithSequence => rewritten() == typed(),
        Remedy::MatchBrackets
        | Remedy::PlainCharacters
        | Remedy::RemoveMark
        | Remedy::AttachSign
        | Remedy::SeparateNumbers
        | Remedy::AddSign
        | Remedy::NameNumber
        | Remedy::SameUnit => rewritten() == typed() && is_laid_out_alike(),
    }
}

/// Every number with the signs before it, also where spaces stand between them: a dash of any kind may
/// be a minus. A plus that comes first changes nothing.
pub(crate) fn typed_numbers(text: &str) -> Vec<String> {
    let mut numbers = Vec::new();
    let mut signs = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let character = plain_character(first);
        let mut length = first.len_utf8();
        if character.is_ascii_digit() {
            length = number_length(rest);
            let digits: String = rest[..length].chars().map(plain_character).collect();
            numbers.push(std::mem::take(&mut signs) + &digits);
        } else if is_dash(character) {
            signs.push('-');
        } else if character == '+' && !signs.is_empty() {
            signs.push('+');
        } else if !is_blank(character) && !matches!(character, '+' | '.') {
            signs.clear();
        }
        rest = &rest[length..];
    }
    numbers
}

/// Digits and points, and the sign of an exponent.
fn number_length(text: &str) -> usize {
    let mut before = '0';
    let end = text.char_indices().find(|&(_, character)| {
        let character = plain_character(character);
        let is_exponent = matches!(character, 'e' | 'E') && before.is_ascii_digit();
        let is_sign = matches!(character, '-' | '+' | '−') && matches!(before, 'e' | 'E');
        let belongs = character.is_ascii_digit() || character == '.' || is_exponent || is_sign;
        before = character;
        !belongs
    });
    end.map_or(text.len(), |(at, _)| at)
}
