//! Bars: what divides two things, the frame of a matrix, or the commas of a program.

use crate::problem::Span;
use crate::text::record::scan::{Mark, Scanner, Token};

impl Scanner<'_> {
    /// A bar divides two things of a line; at its ends it is the frame of a matrix.
    pub(crate) fn bar(&mut self) {
        if let Some(text) = self.joint() {
            let span = Span::from(self.at..self.at + 1);
            self.tokens.push(Token {
                mark: Mark::Comma,
                text,
                span,
            });
            self.at += 1;
            return;
        }
        let is_frame = self.rest()[1..]
            .trim_start_matches([' ', '\t', '\r'])
            .starts_with('\n')
            || self.rest()[1..].trim_start().is_empty()
            || matches!(
                self.tokens.last(),
                Some(Token {
                    mark: Mark::Line(_) | Mark::Label,
                    ..
                })
            );
        if is_frame {
            self.at += 1;
        } else {
            self.push(Mark::Bar, 1);
        }
    }

    /// What a bar is called that touches the numbers in brackets; the third of them, `[0.1|0.2|0.3|0.9]`, marks
    /// a format.
    fn joint(&self) -> Option<&'static str> {
        let number = self.tokens.last()?;
        let touches = matches!(number.mark, Mark::Number(_)) && number.span.end == self.at;
        let mut before = self.tokens.iter().rev().skip(1).step_by(2);
        let mut bars = 0;
        let opening = before.find(|token| {
            bars += 1;
            token.text != BAR
        })?;
        let is_joint = touches && opening.mark == Mark::Open && !self.rest()[1..].starts_with(' ');
        is_joint.then_some(if bars == 3 { TOUCHING_BARS } else { BAR })
    }
}

const BAR: &str = "|";

/// What marks a format among the words of a text.
const TOUCHING_BARS: &str = "touching-bars";
