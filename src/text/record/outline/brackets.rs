//! What brackets and elements hold.

use crate::character::is_digit;
use crate::problem::Span;
use crate::text::record::outline::{Builder, Kind, Member, Open, Opened, Pending, scope};
use crate::text::record::scan::{Mark, Token};

impl<'t> Builder<'t> {
    pub(crate) fn open(&mut self, token: &Token<'t>, opened: Opened) {
        let key = if opened == Opened::Element {
            self.flush();
            token.text.trim_start_matches('<')
        } else {
            self.key()
        };
        let mut member = scope(key, "", token.span, self.row);
        member.is_bracketed = opened == Opened::Bracket;
        member.is_call =
            token.text == "(" && !key.is_empty() && self.span_of(key).end == token.span.start;
        member.is_computed = std::mem::take(&mut self.is_computed);
        member.follows_bar = std::mem::take(&mut self.follows_bar);
        let count = self.count_before(token.span.start);
        self.push(Open {
            opened,
            member,
            count,
        });
    }

    /// The number in brackets under a name that stands before a list; of a name in quotes it is no count.
    fn count_before(&mut self, start: usize) -> Option<f64> {
        let text = self.text;
        let last = self.inside().members.last()?;
        let [only] = &last.members[..] else {
            return None;
        };
        let Kind::Number(count) = only.kind else {
            return None;
        };
        let between = text.get(only.span.end..start)?;
        let is_before = last.is_bracketed
            && !last.key.is_empty()
            && only.key.is_empty()
            && between.trim_start_matches([' ', ')']).is_empty()
            && between.starts_with(')');
        let name = last.key.to_ascii_lowercase();
        let is_list = ["array", "tensor", "list"]
            .iter()
            .any(|list| name.contains(list));
        is_before.then_some(if last.is_call && is_list {
            count
        } else {
            f64::NAN
        })
    }

    pub(crate) fn close(&mut self) {
        self.flush();
        if self.open.len() > 1
            && let Some(Open {
                mut member, count, ..
            }) = self.open.pop()
        {
            member.is_computed |= count.is_some_and(|count| count != member.members.len() as f64);
            // Haskell: `V3 (-0.7) 0.5 0.1`.
            if member.is_bracketed
                && (member.key.is_empty() || self.text[..member.span.start].ends_with(' '))
                && self.text[member.span.start..].starts_with("(-")
                && let [only] = &member.members[..]
                && matches!(only.kind, Kind::Number(_))
                && only.key.is_empty()
            {
                let number = Member {
                    row: member.row,
                    key: member.key,
                    ..only.clone()
                };
                self.inside().members.push(number);
                return;
            }
            let last = member.members.last().map_or(member.span, |last| last.span);
            member.span = member.span.to(last);
            // Its own row: what follows in this line is beside it.
            self.inside().members.push(member);
        }
    }

    pub(crate) fn close_bracket(&mut self) {
        if self.too_deep > 0 {
            self.too_deep -= 1;
            self.flush();
            return;
        }
        let Some(at) = self
            .open
            .iter()
            .rposition(|open| open.opened == Opened::Bracket)
        else {
            self.flush();
            return;
        };
        while self.open.len() > at + 1 {
            self.close();
        }
        // A word in brackets, `(xyzw)`, `[deg]`, belongs to the name before it.
        if let Some(name) = self.remark() {
            self.open.pop();
            self.pending = name;
            return;
        }
        let key_is_done = self.is_computed;
        self.close();
        self.is_computed = key_is_done;
    }

    /// The words of a bracket that holds nothing else, with those before it.
    pub(crate) fn remark(&mut self) -> Option<Pending<'t>> {
        let open = self.open.last()?;
        let is_words = open
            .member
            .members
            .iter()
            .all(|member| member.kind == Kind::Word && member.key.is_empty());
        if !is_words || open.opened != Opened::Bracket {
            return None;
        }
        let mut words = Vec::new();
        let mut add = |text: &'t str, span: Span| {
            words.push(Token {
                mark: Mark::Word,
                text,
                span,
            });
        };
        let key = open.member.key;
        if !key.is_empty() {
            add(key, self.span_of(key));
        }
        // The time of a log says nothing of what follows.
        let is_time = |text: &str| text.starts_with(is_digit);
        for member in &open.member.members {
            if !is_time(member.text) {
                add(member.text, member.span);
            }
        }
        for word in &self.pending.words {
            if !is_time(word.text) {
                add(word.text, word.span);
            }
        }
        self.pending = Pending::default();
        Some(Pending {
            words,
            labels: Vec::new(),
        })
    }

    pub(crate) fn close_element(&mut self) {
        let Some(at) = self
            .open
            .iter()
            .rposition(|open| open.opened == Opened::Element)
        else {
            self.flush();
            return;
        };
        while self.open.len() > at {
            self.close();
        }
    }
}
