//! Any text to tokens, whatever language it is of: what is not understood is passed over, nothing fails.

// Bars.
mod bars;

// What the beginning of a text is.
pub(crate) mod lexemes;

// Numbers and their signs.
mod number;

// Names, quotes and tags.
mod word;

use crate::character::{begins_number, is_alphabetic, is_capital, is_digit};
use crate::problem::Span;
use crate::text::record::scan::lexemes::{
    element, index, is_checksum, name, part_of_pi, prompt, row_label,
};
use crate::text::vocabulary::labels::is_derived;

/// What a piece of a text is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mark {
    Number(f64),
    /// A name, a path, a time, or anything in quotes.
    Word,
    /// A word that begins with dashes: `--frame-id`.
    Flag,
    Open,
    Close,
    /// `<name`: the attributes follow.
    TagOpen,
    /// `/>`, `</name>`.
    TagClose,
    Comma,
    Semicolon,
    /// `|`, and the lines that divide one thing from the next.
    Bar,
    /// `:`, `=`, an arrow.
    Label,
    /// `*` behind a number and before a line: `1.0e+03 *`.
    Factor,
    /// A sign that computes: the numbers beside it are not those that are meant.
    Operator,
    /// A line begins; how far it is indented.
    Line(usize),
    /// A console asks; what is typed in this line names what it answers.
    Prompt,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Token<'t> {
    pub(crate) mark: Mark,
    pub(crate) text: &'t str,
    pub(crate) span: Span,
}

/// How a text writes its decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Decimals {
    Point,
    /// `0,5 0,5`: every comma touches a digit on both sides, and no point does.
    Comma,
}

/// The tokens of a text.
pub(crate) fn scan(text: &str) -> Vec<Token<'_>> {
    let mut scanner = Scanner {
        text,
        at: 0,
        decimals: decimals(text),
        tokens: Vec::new(),
        quotes: Vec::new(),
    };
    scanner.line();
    while scanner.at < text.len() {
        scanner.step();
    }
    scanner.tokens
}

/// A comma is decimal where all are, and something else divides the numbers.
fn decimals(text: &str) -> Decimals {
    let bytes = text.as_bytes();
    let digit = |at: Option<usize>| {
        at.and_then(|at| bytes.get(at))
            .is_some_and(u8::is_ascii_digit)
    };
    let between = |at: usize| digit(at.checked_sub(1)) && digit(Some(at + 1));
    let marks = |mark: u8| {
        bytes
            .iter()
            .enumerate()
            .filter(move |&(_, &byte)| byte == mark)
    };
    let commas = marks(b',').count();
    let all_decimal = commas > 1 && marks(b',').all(|(at, _)| between(at));
    let no_points = !marks(b'.').any(|(at, _)| between(at));
    // `1,0,0,0` has no other mark between its numbers.
    let runs = text
        .split(|mark: char| mark.is_whitespace() || mark == ';')
        .all(|run| run.matches(',').count() <= 1);
    if all_decimal && no_points && runs {
        Decimals::Comma
    } else {
        Decimals::Point
    }
}

struct Scanner<'t> {
    text: &'t str,
    at: usize,
    decimals: Decimals,
    tokens: Vec<Token<'t>>,
    /// Where the quotes end whose inside is read.
    quotes: Vec<usize>,
}

impl<'t> Scanner<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn push(&mut self, mark: Mark, length: usize) {
        let span = Span::from(self.at..self.at + length);
        self.tokens.push(Token {
            mark,
            text: &self.text[span.start..span.end],
            span,
        });
        self.at += length;
    }

    /// The mark of the token that touches this place.
    fn touching(&self) -> Option<Mark> {
        let last = self.tokens.last()?;
        (last.span.end == self.at).then_some(last.mark)
    }

    /// The beginning of a line: its indentation, and the dashes, prompts and comment signs of it.
    fn line(&mut self) {
        let rest = self.rest();
        let blank = rest.len() - rest.trim_start_matches([' ', '\t', '\r']).len();
        let mut inside = &rest[blank..];
        let mut indent = blank;
        // A list of YAML is inside of what stands above it, wherever its dash is.
        while let Some(item) = inside
            .strip_prefix("- ")
            .or_else(|| inside.strip_prefix("-\t"))
        {
            let own = item.trim_start_matches([' ', '\t']);
            // Before several numbers a dash may be a sign.
            let mut line = own.lines().next().unwrap_or("").split_whitespace();
            let is_number = |word: &str| word.starts_with(is_digit);
            if line.next().is_some_and(is_number) && line.next().is_some_and(is_number) {
                break;
            }
            indent += inside.len() - own.len();
            inside = own;
        }
        let length = rest.len() - inside.len();
        self.push(Mark::Line(indent), length);
        let prompt = prompt(inside);
        if inside.starts_with(['>', 'I']) && prompt > 0 {
            self.push(Mark::Prompt, prompt);
        } else {
            self.at += prompt;
        }
        // The name stands before the middle row: `R = | 1 0 0 |`, as PCL prints it.
        if self.follows_frame(rest) {
            let line = self.rest().lines().next().unwrap_or("");
            if let Some(frame) = line.find(['|', '⎢', '⎜']) {
                let before = &line[..frame];
                if before.trim_end().ends_with('=') && !before.contains(['.', ',']) {
                    self.at += frame;
                }
            }
        }
        // `$VNQMR,0.1,…`, `ATT, 12.5, …`: the name of a record that commas divide.
        let rest = self.rest();
        let name = name(rest);
        let is_record = name > 1
            && rest[..name]
                .bytes()
                .all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_')
            && rest.starts_with(is_capital)
            && rest[name..].starts_with(',');
        if is_record {
            self.push(Mark::Word, name);
            self.push(Mark::Label, 1);
        }
        if self.rest().starts_with("---") || self.rest().starts_with("===") {
            let run = self.rest();
            let rule = run.len() - run.trim_start_matches(['-', '=']).len();
            if run[rule..]
                .trim_start_matches([' ', '\t', '\r'])
                .starts_with('\n')
                || run[rule..].trim_start().is_empty()
            {
                self.push(Mark::Bar, rule);
            }
        }
    }

    /// Whether the line before this one begins with the frame of a matrix.
    fn follows_frame(&self, line: &str) -> bool {
        let start = self.text.len() - line.len();
        let before = self.text[..start].strip_suffix('\n').unwrap_or("");
        let before = &before[before.rfind('\n').map_or(0, |at| at + 1)..];
        before.trim_start().starts_with(['|', '⎡', '⎛', '⎢', '⎜'])
    }

    fn step(&mut self) {
        if self.quotes.last() == Some(&self.at) {
            self.quotes.pop();
            self.push(Mark::Close, 1);
            return;
        }
        let rest = self.rest();
        let Some(first) = rest.chars().next() else {
            return;
        };
        let second = rest[first.len_utf8()..].chars().next().unwrap_or(' ');
        match first {
            '\n' => {
                self.at += 1;
                self.line();
            }
            '\\' if second == '\n' => self.at += 2,
            // A type of YAML: `!!opencv-matrix`.
            '!' if second == '!' => {
                let tag = rest.find(char::is_whitespace).unwrap_or(rest.len());
                self.at += tag;
            }
            // The colours of a terminal: `ESC[0;34m`.
            '\u{1b}' => {
                let code = rest.bytes().take(16);
                let end = code.take_while(|byte| !byte.is_ascii_alphabetic()).count();
                let end = if end < 16 && end < rest.len() { end } else { 0 };
                self.at += end + 1;
            }
            '*' if is_checksum(rest) => self.at += 3,
            // The type of a value of Maya: `setAttr ".r" -type "double3" 1 2 3`.
            '-' if rest.starts_with("-type \"double3\"") => self.at += "-type \"double3\"".len(),
            // Bold face.
            '*' if second == '*' && !rest[2..].starts_with(is_digit) => {
                self.at += 2;
            }
            // What a name is explained by; a line of its own is read.
            '#' if matches!(
                self.tokens.last(),
                Some(Token {
                    mark: Mark::Label,
                    ..
                })
            ) =>
            {
                self.at += rest.find('\n').unwrap_or(rest.len());
            }
            _ if first.is_whitespace() => self.at += first.len_utf8(),
            '$' if let Some((length, value)) = part_of_pi(rest) => {
                self.push(Mark::Number(value), length);
            }
            '0'..='9' => self.number(0),
            '.' if second.is_ascii_digit() => self.number(0),
            '+' | '-' | '−' => self.sign(first),
            '"' | '\'' | '`' => self.quote(first),
            '[' if index(rest) > 0 => {
                let length = index(rest);
                self.push(Mark::Word, length);
            }
            // An index of R before a line of numbers, of which only that of the first line is none of them.
            '[' if matches!(
                self.tokens.last().map(|last| last.mark),
                Some(Mark::Line(_))
            ) && element(rest) > 0
                && rest[element(rest)..].starts_with(' ') =>
            {
                if rest.starts_with("[1]") {
                    self.at += 3;
                } else {
                    self.push(Mark::Operator, element(rest));
                }
            }
            // The rows and columns of R: `[1,]`, `[,2]`.
            '[' if row_label(rest) > 0 => self.at += row_label(rest),
            '(' | '[' | '{' => self.push(Mark::Open, 1),
            ')' | ']' | '}' => self.push(Mark::Close, 1),
            // `( x y z <| angle )`, as JOML prints it.
            '<' if second == '|' => self.push(Mark::Comma, 2),
            '<' => self.angle(),
            // What it says of all the numbers is asked elsewhere.
            '/' if second == '*' => self.at += rest.find("*/").map_or(2, |end| end + 2),
            '/' if second == '>' => self.push(Mark::TagClose, 2),
            // What was, and what is.
            '=' if second == '>' && self.follows_value() => self.push(Mark::Bar, 2),
            '→' | '⇒' if self.follows_value() => self.push(Mark::Bar, first.len_utf8()),
            '=' if second == '>' => self.push(Mark::Label, 2),
            '=' if second == '=' => self.push(Mark::Operator, 2),
            ':' | '=' => self.push(Mark::Label, 1),
            '→' | '⇒' => self.push(Mark::Label, first.len_utf8()),
            '±' => self.push(Mark::Word, first.len_utf8()),
            ',' => self.push(Mark::Comma, 1),
            ';' => self.push(Mark::Semicolon, 1),
            '|' => self.bar(),
            // The end of a tag, or of something that angle brackets hold.
            '>' => self.push(Mark::Comma, 1),
            '*' | '×' | '·' | '^' | '√' => self.operator(first),
            '/' if matches!(
                self.tokens.last(),
                Some(Token {
                    mark: Mark::Number(_),
                    ..
                })
            ) && !is_alphabetic(second) =>
            {
                self.push(Mark::Operator, 1);
            }
            // A line that is drawn may be a minus.
            '\u{2500}'..='\u{257f}' | '—' | '‒' | '―'
                if second.is_ascii_digit()
                    || second == '.'
                    || self.is_between_numbers(first.len_utf8()) =>
            {
                self.push(Mark::Operator, first.len_utf8());
            }
            '…' => self.push(Mark::Operator, first.len_utf8()),
            '°' | 'º' | '˚' => self.push(Mark::Word, first.len_utf8()),
            // Numbers were left out.
            '.' if rest.starts_with("..")
                && matches!(
                    self.tokens.last().map(|last| last.mark),
                    Some(Mark::Number(_) | Mark::Comma)
                ) =>
            {
                self.push(Mark::Operator, 2);
            }
            // What is done with a list: `[…].T`, `(…).inv()`.
            '.' if self.touching() == Some(Mark::Close) => {
                let length = 1 + name(&rest[1..]);
                if &rest[..length] == ".T" || is_derived(&rest[..length]) {
                    self.push(Mark::Operator, length);
                } else {
                    self.at += 1;
                }
            }
            // A mark that touches a number may change it.
            '~' | '%' | '?' | '!' | '&'
                if second.is_ascii_digit() || matches!(self.touching(), Some(Mark::Number(_))) =>
            {
                self.push(Mark::Operator, 1);
            }
            _ if is_alphabetic(first) || first == '_' => self.word(),
            // What is not known between two digits, such as what is not seen.
            _ if !first.is_ascii()
                && second.is_ascii_digit()
                && matches!(self.touching(), Some(Mark::Number(_))) =>
            {
                self.push(Mark::Operator, first.len_utf8());
            }
            _ => self.at += first.len_utf8(),
        }
    }

    /// Whether numbers stand before this place.
    fn follows_value(&self) -> bool {
        let is_number = |token: &Token<'_>| matches!(token.mark, Mark::Number(_));
        match &self.tokens[..] {
            [.., last] if is_number(last) => true,
            [.., inside, last] => last.mark == Mark::Close && is_number(inside),
            _ => false,
        }
    }

    /// Whether a number stands before this place, and one behind so many bytes in the same line.
    fn is_between_numbers(&self, length: usize) -> bool {
        let last = self.tokens.last().map(|last| last.mark);
        let after = self.rest()[length..].trim_start_matches(' ');
        matches!(last, Some(Mark::Number(_))) && after.starts_with(begins_number)
    }

    fn operator(&mut self, first: char) {
        let length = first.len_utf8();
        let line = self.rest()[length..].trim_start_matches([' ', '\t', '\r']);
        let is_factor = first == '*' && line.starts_with('\n');
        self.push(
            if is_factor {
                Mark::Factor
            } else {
                Mark::Operator
            },
            length,
        );
    }
}
