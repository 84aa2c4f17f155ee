//! Numbers and their signs.

use crate::character::{begins_number, is_alphabetic, is_alphanumeric, is_of_name};
use crate::decimal::nearest_double;
use crate::text::record::scan::lexemes::{identifier, time};
use crate::text::record::scan::{Decimals, Mark, Scanner, Token};

impl<'t> Scanner<'t> {
    pub(crate) fn sign(&mut self, first: char) {
        let length = first.len_utf8();
        let rest = self.rest();
        let after = &rest[length..];
        let is_digit = |text: &str| text.starts_with(begins_number);
        if after.starts_with("->") || after.starts_with('>') {
            let dashes = after.len() - after.trim_start_matches('-').len();
            self.push(Mark::Label, length + dashes + 1);
            return;
        }
        let is_uncertainty = !is_digit(rest.get(2..).unwrap_or(""))
            || matches!(self.touching(), Some(Mark::Number(_)));
        if rest.starts_with("+-") && is_uncertainty || rest.starts_with("+/-") {
            // An uncertainty: what follows is named by it.
            self.push(Mark::Word, if rest.starts_with("+-") { 2 } else { 3 });
            return;
        }
        let next = after.chars().next().unwrap_or(' ');
        // Dashes before a number may be signs, or a mark of something.
        let dashes = rest.len() - rest.trim_start_matches('-').len();
        let number = rest[dashes..].trim_start_matches(' ');
        if dashes > 2 && is_digit(number) || dashes == 2 && is_digit(&rest[dashes..]) {
            self.push(Mark::Operator, dashes);
            return;
        }
        let flag = &rest[dashes..];
        if dashes > 2 && !flag.starts_with(is_alphabetic) {
            self.at += dashes;
            return;
        }
        if flag.starts_with(is_alphabetic)
            && !matches!(
                self.touching(),
                Some(Mark::Word | Mark::Number(_) | Mark::Close)
            )
            && first == '-'
        {
            let dashes = rest.len() - flag.len();
            let name = flag.len()
                - flag
                    .trim_start_matches(|mark: char| is_of_name(mark) || mark == '-')
                    .len();
            self.push(Mark::Flag, dashes + name);
            return;
        }
        let is_number = next.is_ascii_digit() || next == '.';
        // A sign apart from its number, or two of them, may be anything.
        let is_apart = next == ' '
            && is_digit(after.trim_start())
            && matches!(
                self.tokens.last().map(|last| last.mark),
                Some(Mark::Label | Mark::Comma | Mark::Open)
            );
        let is_double = after.starts_with(['+', '-', '−']) && {
            let mut marks = after.chars();
            marks.next();
            is_digit(marks.as_str())
        };
        if is_apart || is_double {
            self.push(Mark::Operator, length);
            return;
        }
        match self.touching() {
            // `0.5-0.5` ran together, or is a difference; behind a name it is a part of it.
            Some(Mark::Number(_) | Mark::Close) => self.push(Mark::Operator, length),
            _ if is_number => self.number(length),
            _ if next.is_whitespace()
                && after
                    .trim_start()
                    .starts_with(|mark: char| mark.is_ascii_digit() || ".(+-".contains(mark))
                && matches!(
                    self.tokens.last(),
                    Some(Token {
                        mark: Mark::Number(_) | Mark::Close,
                        ..
                    })
                ) =>
            {
                // Between lists a dash only divides: `1, 2, 3 - 4, 5, 6`.
                let before = self
                    .tokens
                    .len()
                    .checked_sub(2)
                    .map(|at| self.tokens[at].mark);
                let is_list = before == Some(Mark::Comma);
                self.push(if is_list { Mark::Bar } else { Mark::Operator }, length);
            }
            _ => self.at += length,
        }
    }

    /// A number, of which `sign` bytes are its sign, or a time, or an identifier of digits.
    pub(crate) fn number(&mut self, sign: usize) {
        let rest = self.rest();
        let body = &rest[sign..];
        if sign == 0
            && let Some(length) = time(body).or_else(|| identifier(body))
        {
            self.push(Mark::Word, length);
            return;
        }
        let bytes = body.as_bytes();
        let digits = |from: usize| {
            bytes[from..]
                .iter()
                .take_while(|byte| byte.is_ascii_digit())
                .count()
        };
        let mut end = digits(0);
        let is_point =
            |byte: u8| byte == b'.' || (byte == b',' && self.decimals == Decimals::Comma);
        if bytes.get(end).copied().is_some_and(is_point) {
            end += 1;
            end += digits(end);
        }
        if let Some(mark @ (b'e' | b'E' | b'D')) = bytes.get(end) {
            let signed = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let exponent = digits(end + 1 + signed);
            // `-4.2D-01` of Fortran; without a sign it may be a name.
            if exponent > 0 && (*mark != b'D' || signed > 0) {
                end += 1 + signed + exponent;
            }
        }
        let mut written = body[..end].replace(',', ".").replace('D', "e");
        // `1.5*^-2` of Mathematica.
        if let Some(power) = body[end..].strip_prefix("*^") {
            let signed = usize::from(power.starts_with('-'));
            let exponent = digits(end + 2 + signed);
            if exponent > 0 {
                let length = 2 + signed + exponent;
                written = format!("{written}e{}", &body[end + 2..end + length]);
                end += length;
            }
        }
        let magnitude = nearest_double(&written);
        let negative = rest.starts_with(['-', '−']);
        let value = if negative { -magnitude } else { magnitude };
        if !value.is_finite() {
            self.push(Mark::Word, sign + end);
            return;
        }
        self.push(Mark::Number(value), sign + end);
        // A suffix, or a full stop behind the last number of a sentence.
        let after = self.rest();
        let suffix = after.trim_start_matches(['f', 'F', 'd', 'L', '_']);
        let ends = |text: &str| !text.starts_with(is_alphanumeric);
        if suffix.len() + 1 == after.len() && ends(suffix) {
            self.at += 1;
        } else if let Some(suffix) = ["_f64", "_f32", "f64", "f32"]
            .into_iter()
            .find(|suffix| after.strip_prefix(suffix).is_some_and(ends))
        {
            self.at += suffix.len();
        } else if after.starts_with('.') && !after[1..].starts_with(is_alphanumeric) {
            self.at += 1;
        }
    }
}
