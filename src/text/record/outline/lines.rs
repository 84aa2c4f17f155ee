//! Lines: headings hold what is below them.

use crate::text::record::outline::{Builder, Open, Opened, scope};
use crate::text::record::scan::{Mark, Token};

impl<'t> Builder<'t> {
    /// A new line: a heading before it holds the lines that are inside, others end.
    pub(crate) fn line(&mut self, indent: usize, rest: &[Token<'t>]) {
        self.row += 1;
        let first = rest.first().map(|token| token.mark);
        let is_empty = matches!(first, None | Some(Mark::Line(_)));
        let in_bracket = matches!(
            self.open.last().map(|open| open.opened),
            Some(Opened::Bracket)
        );
        if is_empty {
            return;
        }
        if !in_bracket && let Some(start) = self.prompt.take() {
            self.flush();
            let length = self.text[start..].find('\n').unwrap_or(0);
            let key = self.text[start..start + length].trim();
            let member = scope(key, "", self.span_of(key), self.row);
            self.push(Open {
                opened: Opened::Typed,
                member,
                count: None,
            });
            return;
        }
        if in_bracket {
            if !self.pending.is_label() {
                self.flush();
            }
            return;
        }
        let starts_numbers = matches!(first, Some(Mark::Number(_) | Mark::Open));
        let is_heading = is_heading(rest);
        let announces = !self.pending.words.is_empty();
        if announces && (self.pending.is_label() || starts_numbers) {
            let key = self.key();
            let own = self.indent_of(key);
            let takes_same = indent <= own;
            self.leave(own, true);
            let member = scope(key, "", self.span_of(key), self.row);
            self.push(Open {
                opened: Opened::Heading {
                    indent: own,
                    takes_same,
                },
                member,
                count: None,
            });
            if takes_same && is_heading && indent <= own {
                self.close();
            }
        } else {
            self.flush();
        }
        if !starts_numbers {
            self.leave(indent, is_heading);
        }
    }

    /// How far the line of a key is indented.
    pub(crate) fn indent_of(&self, key: &str) -> usize {
        let start = self.span_of(key).start;
        let line = self.text[..start].rfind('\n').map_or(0, |at| at + 1);
        let before = &self.text[line..start];
        before.len() - before.trim_start_matches([' ', '\t', '-']).len()
    }

    /// Closes all headings.
    pub(crate) fn leave_all(&mut self) {
        self.flush();
        while matches!(
            self.open.last().map(|open| open.opened),
            Some(Opened::Heading { .. } | Opened::Typed)
        ) {
            self.close();
        }
    }

    /// Closes the headings that do not hold a line so far indented.
    pub(crate) fn leave(&mut self, line: usize, is_heading: bool) {
        while let Some(Open {
            opened: Opened::Heading { indent, takes_same },
            ..
        }) = self.open.last()
        {
            let holds = line > *indent || (line == *indent && *takes_same && !is_heading);
            if holds {
                break;
            }
            self.close();
        }
    }
}

/// Whether a line is a name and a label and no more.
fn is_heading(tokens: &[Token<'_>]) -> bool {
    let mut ends_with_label = false;
    for token in tokens {
        match token.mark {
            Mark::Line(_) => break,
            Mark::Label => ends_with_label = true,
            Mark::Word => ends_with_label = false,
            _ => return false,
        }
    }
    ends_with_label
}
