//! Tokens to a tree of what stands inside what: brackets, elements, lines below a heading.

// What brackets and elements hold.
mod brackets;

// Headings and what is below them.
mod lines;

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::text::record::scan::{Mark, Token};

/// What a member of an [`Outline`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Number(f64),
    Word,
    Scope,
}

/// A number, a word or what holds such, with what stands before it.
#[derive(Clone, Debug)]
pub(crate) struct Member<'t> {
    pub(crate) kind: Kind,
    /// The words before it, since the last number, bracket or comma: `Position: X`; may be empty.
    pub(crate) key: &'t str,
    pub(crate) text: &'t str,
    pub(crate) span: Span,
    /// The number of its row: lines and semicolons divide them.
    pub(crate) row: u32,
    pub(crate) members: Vec<Self>,
    /// Whether a sign that computes stands beside it.
    pub(crate) is_computed: bool,
    /// Whether a bar or a line of dashes stands before it.
    pub(crate) follows_bar: bool,
    /// The unit that stands behind a number.
    pub(crate) unit: Option<AngleUnit>,
    /// Whether a unit of length stands behind it.
    pub(crate) has_length: bool,
    /// Whether a comma stands before it.
    pub(crate) follows_comma: bool,
    /// Whether brackets or quotes hold it: its lines are of no meaning then.
    pub(crate) is_bracketed: bool,
    /// Whether its name touches its bracket: `name(…)`.
    pub(crate) is_call: bool,
}

/// What opened a scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Opened {
    Text,
    Bracket,
    /// The element of this name is still among its attributes, or not.
    Element,
    /// A heading that is so far indented; whether lines as far indented are inside.
    Heading {
        indent: usize,
        takes_same: bool,
    },
    /// What was typed at a prompt.
    Typed,
}

/// How many scopes may stand inside each other.
const DEEPEST: usize = 48;

/// How many bytes of the words before numbers are their name.
const LONGEST_KEY: usize = 400;

struct Open<'t> {
    opened: Opened,
    member: Member<'t>,
    /// A number in brackets before it, `Float64Array(4) […]`: its count, or a factor, or an index.
    count: Option<f64>,
}

/// The words since the last thing.
#[derive(Default)]
struct Pending<'t> {
    words: Vec<Token<'t>>,
    /// How many words stand before each label mark.
    labels: Vec<usize>,
}

impl<'t> Pending<'t> {
    fn text(words: &[Token<'t>], whole: &'t str) -> &'t str {
        let Some(last) = words.last() else {
            return "";
        };
        // Of a long text only the last words are the name.
        let near = |word: &&Token<'_>| last.span.end - word.span.start <= LONGEST_KEY;
        let first = words.iter().rev().take_while(near).last();
        first.map_or("", |first| &whole[first.span.start..last.span.end])
    }

    fn is_flag(&self) -> bool {
        matches!(&self.words[..], [only] if only.mark == Mark::Flag)
    }

    fn is_label(&self) -> bool {
        self.labels.last() == Some(&self.words.len()) && !self.words.is_empty()
    }
}

/// The members of a text.
pub(crate) fn outline<'t>(text: &'t str, tokens: &[Token<'t>]) -> Vec<Member<'t>> {
    let mut builder = Builder {
        text,
        open: vec![Open {
            opened: Opened::Text,
            member: scope("", text, Span::from(0..text.len()), 0),
            count: None,
        }],
        pending: Pending::default(),
        row: 0,
        is_computed: false,
        follows_bar: false,
        follows_comma: false,
        too_deep: 0,
        prompt: None,
        factor: None,
    };
    for (at, token) in tokens.iter().enumerate() {
        builder.take(token, &tokens[at + 1..]);
    }
    builder.flush();
    while builder.open.len() > 1 {
        builder.close();
    }
    builder.open.swap_remove(0).member.members
}

fn scope<'t>(key: &'t str, text: &'t str, span: Span, row: u32) -> Member<'t> {
    Member {
        kind: Kind::Scope,
        key,
        text,
        span,
        row,
        members: Vec::new(),
        is_computed: false,
        follows_bar: false,
        is_bracketed: false,
        has_length: false,
        is_call: false,
        unit: None,
        follows_comma: false,
    }
}

struct Builder<'t> {
    text: &'t str,
    open: Vec<Open<'t>>,
    pending: Pending<'t>,
    row: u32,
    is_computed: bool,
    follows_bar: bool,
    follows_comma: bool,
    /// How many brackets are open that were too deep.
    too_deep: usize,
    /// Where a line begins that was typed at a prompt.
    prompt: Option<usize>,
    /// A factor of all the numbers that follow: `1.0e+03 *`.
    factor: Option<f64>,
}

impl<'t> Builder<'t> {
    fn take(&mut self, token: &Token<'t>, rest: &[Token<'t>]) {
        match token.mark {
            Mark::Number(value) => self.number(token, value),
            Mark::Word => self.word(token),
            Mark::Flag => {
                self.flush();
                self.pending.words.push(*token);
                self.pending.labels.push(1);
            }
            Mark::Open => self.open(token, Opened::Bracket),
            Mark::TagOpen => self.open(token, Opened::Element),
            Mark::Close => self.close_bracket(),
            Mark::TagClose => self.close_element(),
            Mark::Comma => {
                // `'--x', '0.1'`: a flag is the name of what follows it in a list, too.
                if !self.pending.is_flag() {
                    self.flush();
                }
                self.follows_comma = true;
            }
            Mark::Semicolon => {
                self.flush();
                if !self.divides_single_numbers(rest) {
                    self.row += 1;
                }
            }
            Mark::Bar => {
                self.flush();
                self.follows_bar = true;
                self.row += 1;
            }
            Mark::Label => {
                self.label();
            }
            Mark::Prompt => {
                self.leave_all();
                self.prompt = Some(token.span.end);
            }
            Mark::Factor => self.factor(),
            Mark::Operator => {
                if let Some(before) = self.inside().members.last_mut() {
                    before.is_computed = true;
                }
                self.is_computed = true;
            }
            Mark::Line(indent) => self.line(indent, rest),
        }
    }

    /// Whether a semicolon in a line stands before one number alone: `Orientation 0.1; 0.2; 0.3; 0.9`.
    fn divides_single_numbers(&mut self, rest: &[Token<'t>]) -> bool {
        let is_number = |token: &Token<'_>| matches!(token.mark, Mark::Number(_));
        let is_single = matches!(rest, [number, after @ ..] if is_number(number)
            && after.first().is_none_or(|next| matches!(next.mark, Mark::Semicolon | Mark::Line(_))));
        let inside = self.inside();
        let follows_comma = inside.members.last().is_none_or(|last| last.follows_comma);
        is_single && !inside.is_bracketed && !follows_comma
    }

    fn inside(&mut self) -> &mut Member<'t> {
        let at = self.open.len() - 1;
        &mut self.open[at].member
    }

    fn add(&mut self, mut member: Member<'t>) {
        member.is_computed = std::mem::take(&mut self.is_computed);
        member.follows_bar = std::mem::take(&mut self.follows_bar);
        member.follows_comma = std::mem::take(&mut self.follows_comma);
        self.inside().members.push(member);
    }

    /// Opens a scope; of those that are too deep the members belong to the one that holds them.
    fn push(&mut self, open: Open<'t>) {
        if self.open.len() < DEEPEST {
            self.open.push(open);
        } else if open.opened == Opened::Bracket {
            self.too_deep += 1;
        }
    }

    /// The words before a number or a bracket.
    fn key(&mut self) -> &'t str {
        let pending = std::mem::take(&mut self.pending);
        Pending::text(&pending.words, self.text)
    }

    fn number(&mut self, token: &Token<'t>, value: f64) {
        let key = self.key();
        let value = self.factor.map_or(value, |factor| value * factor);
        let row = self.row;
        self.add(Member {
            kind: Kind::Number(value),
            ..Self::leaf(token, key, row)
        });
    }

    fn leaf(token: &Token<'t>, key: &'t str, row: u32) -> Member<'t> {
        Member {
            kind: Kind::Word,
            ..scope(key, token.text, token.span, row)
        }
    }

    fn word(&mut self, token: &Token<'t>) {
        if self.pending.words.is_empty() && self.take_unit(token) {
            return;
        }
        self.pending.words.push(*token);
    }

    /// A unit behind a number, which is no name of the next one.
    fn take_unit(&mut self, token: &Token<'t>) -> bool {
        let row = self.row;
        let Some(member) = self.inside().members.last_mut() else {
            return false;
        };
        let Kind::Number(value) = member.kind else {
            return false;
        };
        if member.row != row {
            return false;
        }
        // `0.12 rad/s` is no angle.
        if member.unit.is_some() && matches!(token.text, "s" | "sec") {
            member.unit = None;
            member.has_length = true;
            return true;
        }
        let word = token.text.to_ascii_lowercase();
        let (factor, unit) = match word.as_str() {
            "turn" | "turns" => (360.0, Some(AngleUnit::Degrees)),
            "gon" | "grad" | "gradians" => (0.9, Some(AngleUnit::Degrees)),
            "mm" | "cm" | "m" | "meters" | "metres" => (1.0, None),
            "º" | "˚" => (1.0, Some(AngleUnit::Degrees)),
            word => match AngleUnit::named(word) {
                Some(unit) => (1.0, Some(unit)),
                None => return false,
            },
        };
        member.kind = Kind::Number(value * factor);
        member.unit = unit;
        member.has_length = unit.is_none();
        true
    }

    /// A label: what stands before the name that it marks was the value of another one.
    fn label(&mut self) {
        let count = self.pending.words.len();
        if count == 0 {
            return;
        }
        if let Some(&label) = self.pending.labels.last()
            && count >= label + 2
        {
            let last = self.pending.words[count - 1];
            let value = self.pending.words[label..count - 1].to_vec();
            let key = self.pending.words[..label].to_vec();
            self.value(&key, &value);
            self.pending = Pending {
                words: vec![last],
                labels: Vec::new(),
            };
        }
        self.pending.labels.push(self.pending.words.len());
    }

    /// A word with its name, or words alone.
    fn value(&mut self, key: &[Token<'t>], value: &[Token<'t>]) {
        let (Some(first), Some(last)) = (value.first(), value.last()) else {
            return;
        };
        let span = first.span.to(last.span);
        let row = self.row;
        let key = Pending::text(key, self.text);
        let text = Pending::text(value, self.text);
        self.add(Member {
            kind: Kind::Word,
            ..scope(key, text, span, row)
        });
    }

    fn flush(&mut self) {
        let pending = std::mem::take(&mut self.pending);
        let label = pending.labels.last().copied().unwrap_or(0);
        let (key, value) = pending.words.split_at(label.min(pending.words.len()));
        self.value(key, value);
    }

    fn factor(&mut self) {
        let members = &mut self.inside().members;
        if let Some(Member {
            kind: Kind::Number(value),
            ..
        }) = members.last()
        {
            let value = *value;
            if let Some(factor) = members.pop() {
                // What stands before the factor names the numbers.
                self.factor = Some(value);
                if !factor.key.is_empty() {
                    let span = self.span_of(factor.key);
                    self.pending = Pending {
                        words: vec![Token {
                            mark: Mark::Word,
                            text: factor.key,
                            span,
                        }],
                        labels: vec![1],
                    };
                }
            }
        }
    }

    /// The place of a piece of the text; of nothing, the beginning.
    fn span_of(&self, key: &str) -> Span {
        if key.is_empty() {
            return Span::default();
        }
        let start = key.as_ptr() as usize - self.text.as_ptr() as usize;
        Span::from(start..start + key.len())
    }
}
