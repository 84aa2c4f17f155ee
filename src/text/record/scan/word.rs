//! Names, what stands in quotes, and tags.

use crate::character::{begins_name, is_alphabetic, is_alphanumeric, is_capital, is_digit};
use crate::problem::Span;
use crate::text::record::names::finite_decimal;
use crate::text::record::scan::lexemes::{element, is_axis, name, types};
use crate::text::record::scan::{Mark, Scanner, Token};
use crate::text::vocabulary::constructors::order_in_name;

impl<'t> Scanner<'t> {
    pub(crate) fn word(&mut self) {
        let rest = self.rest();
        let mut end = name(rest);
        loop {
            let after = &rest[end..];
            let joint = if after.starts_with("::") { 2 } else { 1 };
            let is_joint =
                after.starts_with("::") || after.starts_with('.') || after.starts_with('-');
            let next = after.get(joint..).unwrap_or("");
            // `tf2-echo`, `body-to-world`; `x-0.5` is a difference.
            let is_code = || {
                let own = &next[..name(next)];
                after.starts_with('-') && own.starts_with(is_digit) && own.contains(is_capital)
            };
            if is_joint && (next.starts_with(begins_name) || is_code()) {
                end += joint + name(next);
            } else if is_axis(&rest[..end]) && after.starts_with('\'') {
                // A moved axis: `Z-Y'-X''`.
                end += after.len() - after.trim_start_matches('\'').len();
            } else if element(after) > 0 {
                end += element(after);
            } else if after.starts_with("[]") {
                end += 2;
            } else {
                break;
            }
        }
        // The types in `SIMD3<Float>`, `Matrix{Float64}`, `!!opencv-matrix`: names inside brackets that touch.
        let after = &rest[end..];
        let argument = types(after);
        if after[argument..].starts_with('\'')
            && !after[argument + 1..].starts_with(is_alphanumeric)
        {
            self.push(Mark::Word, end + argument);
            self.push(Mark::Operator, 1);
            return;
        }
        let inside = &after[..argument];
        if order_in_name(inside).is_some() {
            self.push(Mark::Word, end + argument);
            return;
        }
        self.push(Mark::Word, end);
        // `Quaternion<left>`: what is not known of it may change the numbers.
        let is_convention = ["left", "right", "active", "passive", "jpl", "Jpl", "JPL"]
            .iter()
            .any(|word| inside.contains(word));
        if is_convention {
            self.push(Mark::Operator, argument);
        } else {
            self.at += argument;
        }
    }

    pub(crate) fn quote(&mut self, quote: char) {
        let rest = self.rest();
        let inside = &rest[1..];
        if quote == '\'' && matches!(self.touching(), Some(Mark::Close | Mark::Number(_))) {
            // The transpose of MATLAB.
            self.push(Mark::Operator, 1);
            return;
        }
        let Some(length) = inside.find(quote) else {
            self.at += 1;
            return;
        };
        let inside = &inside[..length];
        let numbers = inside
            .split(|mark: char| mark.is_whitespace() || ",;".contains(mark))
            .filter(|part| {
                part.starts_with(|first: char| first.is_ascii_digit() || "+-.$".contains(first))
                    && part.contains(|digit: char| digit.is_ascii_digit() || digit == '$')
            })
            .count();
        let is_flag = inside.starts_with("--") && inside[2..].starts_with(is_alphabetic);
        if is_flag {
            let span = Span::from(self.at + 1..self.at + 1 + length);
            self.tokens.push(Token {
                mark: Mark::Flag,
                text: inside,
                span,
            });
            self.at += length + 2;
            return;
        }
        let is_number = finite_decimal(inside.trim()).is_some();
        if is_number {
            self.at += 1 + inside.len() - inside.trim_start().len();
            let end = self.at - (1 + inside.len() - inside.trim_start().len()) + length + 2;
            self.step();
            self.at = end;
        } else if numbers >= 2 {
            let end = self.at + 1 + length;
            self.push(Mark::Open, 1);
            self.quotes.push(end);
        } else {
            let start = self.at + 1;
            self.tokens.push(Token {
                mark: Mark::Word,
                text: inside,
                span: Span::from(start..start + length),
            });
            self.at += length + 2;
        }
    }

    pub(crate) fn angle(&mut self) {
        let rest = self.rest();
        if let Some(closing) = rest.strip_prefix("</") {
            let is_name = |byte: &u8| *byte != b'>' && *byte != b'\n';
            let name = closing.bytes().take(80).take_while(is_name).count();
            let closes = closing
                .get(name..)
                .is_some_and(|rest| rest.starts_with('>'));
            let length = if closes { name + 1 } else { 0 };
            self.push(Mark::TagClose, 2 + length);
            return;
        }
        let inside = &rest[1..];
        let length = inside.len()
            - inside
                .trim_start_matches(|mark: char| is_alphanumeric(mark) || "_-.:".contains(mark))
                .len();
        let after = inside[length..].trim_start();
        let attribute =
            after.trim_start_matches(|mark: char| is_alphanumeric(mark) || "_-:.".contains(mark));
        let is_tag = length > 0
            && inside.starts_with(is_alphabetic)
            && (after.starts_with('>')
                || after.starts_with("/>")
                || attribute.len() < after.len()
                    && attribute.trim_start().starts_with('=')
                    && attribute.trim_start()[1..]
                        .trim_start()
                        .starts_with(['"', '\'']));
        if is_tag {
            self.push(Mark::TagOpen, 1 + length);
        } else if rest.starts_with("<<")
            && matches!(
                self.tokens.last().map(|last| last.mark),
                Some(Mark::Word | Mark::Close)
            )
        {
            self.push(Mark::Label, 2);
        } else if rest[1..].trim_start_matches(' ').starts_with('<') || rest.starts_with("<<") {
            self.push(Mark::Operator, 1);
        } else {
            self.at += 1;
        }
    }
}
