//! Any text to tokens, whatever language it is of: what is not understood is passed over, nothing fails.

use crate::decimal::nearest_double;
use crate::problem::Span;

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
            indent += inside.len() - own.len();
            inside = own;
        }
        let length = rest.len() - inside.len();
        self.push(Mark::Line(indent), length);
        let prompt = prompt(inside);
        if inside.starts_with(['>', 'I', 'O']) && prompt > 0 {
            self.push(Mark::Prompt, prompt);
        } else {
            self.at += prompt;
        }
        // `$VNQMR,0.1,…`, `ATT, 12.5, …`: the name of a record that commas divide.
        let rest = self.rest();
        let name = name(rest);
        let is_record = name > 1
            && rest[..name]
                .bytes()
                .all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_')
            && rest.starts_with(|first: char| first.is_ascii_uppercase())
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
                || run[rule..].trim().is_empty()
            {
                self.push(Mark::Bar, rule);
            }
        }
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
            '*' if is_checksum(rest) => self.at += 3,
            // Bold face.
            '*' if second == '*' && !rest[2..].starts_with(|mark: char| mark.is_ascii_digit()) => {
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
            '0'..='9' => self.number(0),
            '.' if second.is_ascii_digit() => self.number(0),
            '+' | '-' | '−' => self.sign(first),
            '"' | '\'' | '`' => self.quote(first),
            '[' if index(rest) > 0 => {
                let length = index(rest);
                self.push(Mark::Word, length);
            }
            // The rows and columns of R: `[1,]`, `[,2]`.
            '[' if row_label(rest) > 0 => self.at += row_label(rest),
            '(' | '[' | '{' => self.push(Mark::Open, 1),
            ')' | ']' | '}' => self.push(Mark::Close, 1),
            '<' => self.angle(),
            '/' if second == '>' => self.push(Mark::TagClose, 2),
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
            ) && !second.is_alphabetic() =>
            {
                self.push(Mark::Operator, 1);
            }
            '…' => self.push(Mark::Operator, first.len_utf8()),
            '°' | 'º' | '˚' => self.push(Mark::Word, first.len_utf8()),
            _ if first.is_alphabetic() || first == '_' => self.word(),
            _ => self.at += first.len_utf8(),
        }
    }

    /// A bar divides two things of a line; at its ends it is the frame of a matrix.
    fn bar(&mut self) {
        let is_frame = self.rest()[1..]
            .trim_start_matches([' ', '\t', '\r'])
            .starts_with('\n')
            || self.rest()[1..].trim().is_empty()
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

    fn sign(&mut self, first: char) {
        let length = first.len_utf8();
        let rest = self.rest();
        let after = &rest[length..];
        if after.starts_with("->") || after.starts_with('>') {
            let dashes = rest.len() - rest.trim_start_matches('-').len();
            self.push(Mark::Label, dashes + 1);
            return;
        }
        if rest.starts_with("+-") || rest.starts_with("+/-") {
            // An uncertainty: what follows is named by it.
            self.push(Mark::Word, if rest.starts_with("+-") { 2 } else { 3 });
            return;
        }
        let next = after.chars().next().unwrap_or(' ');
        let flag = rest.trim_start_matches('-');
        if flag.starts_with(|first: char| first.is_alphabetic())
            && !matches!(
                self.touching(),
                Some(Mark::Word | Mark::Number(_) | Mark::Close)
            )
            && first == '-'
        {
            let dashes = rest.len() - flag.len();
            let name = flag.len()
                - flag
                    .trim_start_matches(|mark: char| mark.is_alphanumeric() || "_-".contains(mark))
                    .len();
            self.push(Mark::Flag, dashes + name);
            return;
        }
        let is_number = next.is_ascii_digit() || next == '.';
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
    fn number(&mut self, sign: usize) {
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
        if let Some(b'e' | b'E') = bytes.get(end) {
            let signed = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let exponent = digits(end + 1 + signed);
            if exponent > 0 {
                end += 1 + signed + exponent;
            }
        }
        let mut written = body[..end].replace(',', ".");
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
        let ends = |text: &str| !text.starts_with(|next: char| next.is_alphanumeric());
        if suffix.len() + 1 == after.len() && ends(suffix) {
            self.at += 1;
        } else if let Some(suffix) = ["_f64", "_f32", "f64", "f32"]
            .into_iter()
            .find(|suffix| after.strip_prefix(suffix).is_some_and(ends))
        {
            self.at += suffix.len();
        } else if after.starts_with('.')
            && !after[1..].starts_with(|next: char| next.is_alphanumeric())
        {
            self.at += 1;
        }
    }

    fn word(&mut self) {
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
                after.starts_with('-')
                    && own.starts_with(|first: char| first.is_ascii_digit())
                    && own.contains(|mark: char| mark.is_ascii_uppercase())
            };
            if is_joint
                && (next.starts_with(|first: char| first.is_alphabetic() || first == '_')
                    || is_code())
            {
                end += joint + name(next);
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
            && !after[argument + 1..].starts_with(|next: char| next.is_alphanumeric())
        {
            self.push(Mark::Word, end + argument);
            self.push(Mark::Operator, 1);
            return;
        }
        self.push(Mark::Word, end);
        self.at += argument;
    }

    fn quote(&mut self, quote: char) {
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
                part.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first))
                    && part.contains(|digit: char| digit.is_ascii_digit())
            })
            .count();
        let is_flag = inside.starts_with("--") && inside[2..].starts_with(char::is_alphabetic);
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
        let is_number = inside.trim().parse::<f64>().is_ok_and(f64::is_finite);
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

    fn angle(&mut self) {
        let rest = self.rest();
        if let Some(closing) = rest.strip_prefix("</") {
            let length = closing.find('>').map_or(closing.len(), |at| at + 1);
            self.push(Mark::TagClose, 2 + length);
            return;
        }
        let inside = &rest[1..];
        let length = inside.len()
            - inside
                .trim_start_matches(|mark: char| mark.is_alphanumeric() || "_-.:".contains(mark))
                .len();
        let after = inside[length..].trim_start();
        let attribute = &after[name(after)..];
        let is_tag = length > 0
            && inside.starts_with(|first: char| first.is_alphabetic())
            && (after.starts_with('>')
                || after.starts_with("/>")
                || attribute.len() < after.len()
                    && attribute.trim_start().starts_with('=')
                    && attribute.trim_start()[1..]
                        .trim_start()
                        .starts_with(['"', '\'']));
        if is_tag {
            self.push(Mark::TagOpen, 1 + length);
        } else if rest.starts_with("<<") {
            self.push(Mark::Label, 2);
        } else {
            self.at += 1;
        }
    }
}

/// How many bytes at the start are the index of a member that is labelled: `[0] =`.
fn index(text: &str) -> usize {
    let length = element(text);
    let after = text[length..].trim_start_matches(' ');
    if length > 0 && after.starts_with(['=', ':']) && text[1..].find(']') == Some(length - 2) {
        length
    } else {
        0
    }
}

/// How many bytes at the start are places of an element: `[0]`, `[1][2]`.
fn element(text: &str) -> usize {
    let mut length = 0;
    while let Some(inside) = text[length..].strip_prefix('[') {
        let digits = inside.bytes().take_while(u8::is_ascii_digit).count();
        if !(1..=2).contains(&digits) || !inside[digits..].starts_with(']') {
            break;
        }
        length += digits + 2;
    }
    length
}

/// How many bytes at the start are the number of a row or a column as R prints it.
fn row_label(text: &str) -> usize {
    let Some(end) = text.find(']') else {
        return 0;
    };
    let inside = &text[1..end];
    let is_count =
        |digits: &str| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let is_label = inside.strip_suffix(',').is_some_and(is_count)
        || inside.strip_prefix(',').is_some_and(is_count);
    if is_label { end + 1 } else { 0 }
}

/// Whether the checksum of a sentence follows: `*48`.
fn is_checksum(text: &str) -> bool {
    let digits = text.get(1..3).unwrap_or("");
    let ends = text
        .get(3..)
        .is_none_or(|rest| !rest.starts_with(char::is_alphanumeric));
    ends && digits.len() == 2 && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
}

/// How many bytes at the start are a name.
fn name(text: &str) -> usize {
    text.len()
        - text
            .trim_start_matches(|mark: char| mark.is_alphanumeric() || mark == '_')
            .len()
}

/// How many bytes at the start are types in brackets: names alone, and sizes.
fn types(text: &str) -> usize {
    let close = match text.chars().next() {
        Some('<') => '>',
        Some('{') => '}',
        _ => return 0,
    };
    let Some(end) = text.find(close) else {
        return 0;
    };
    let inside = &text[1..end];
    let is_types = inside.starts_with(char::is_alphabetic)
        && inside
            .chars()
            .all(|mark| mark.is_alphanumeric() || "_:, ".contains(mark))
        && !inside.contains(": ");
    if is_types { end + 1 } else { 0 }
}

/// How many bytes at the start of a line a console wrote: `>>> `, `In [3]: `, `Out[7]= `.
fn prompt(line: &str) -> usize {
    for name in ["In", "Out"] {
        let Some(rest) = line.strip_prefix(name) else {
            continue;
        };
        let rest = rest.trim_start_matches(' ');
        if let Some(inside) = rest.strip_prefix('[')
            && let Some(end) = inside.find(']')
            && inside[..end]
                .trim()
                .bytes()
                .all(|byte| byte.is_ascii_digit())
        {
            let after = inside[end + 1..].trim_start_matches([':', '=']);
            return line.len() - after.len();
        }
    }
    line.len()
        - line
            .trim_start_matches(['>', '#', '%', '$', '/', '*', ' ', '\t'])
            .len()
}

/// How many bytes at the start are a date or a time of day.
fn time(text: &str) -> Option<usize> {
    let length = text
        .find(|mark: char| !(mark.is_ascii_digit() || "-:.TZ/".contains(mark)))
        .unwrap_or(text.len());
    let written = &text[..length];
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let date = written.split(['T', ' ']).next().unwrap_or("");
    let parts: Vec<&str> = date.split(['-', '/']).collect();
    let is_date = parts.len() >= 2
        && parts.iter().all(|part| digits(part) && part.len() <= 4)
        && parts.iter().any(|part| part.len() == 4)
        && (parts.len() == 3 || written.contains('T'));
    let clock: Vec<&str> = written.split(':').collect();
    let is_clock = clock.len() >= 2
        && digits(clock[0])
        && clock[1].get(..2).is_some_and(digits)
        && clock[0].len() <= 2;
    (is_date || is_clock).then_some(length)
}

/// How many bytes at the start are no number though they begin with a digit: `3x3`, `4×4`, `17a3`, `10.0.0.1`.
fn identifier(text: &str) -> Option<usize> {
    let length = text
        .find(|mark: char| !(mark.is_alphanumeric() || "_.×".contains(mark)))
        .unwrap_or(text.len());
    let written = text[..length].trim_end_matches('.');
    let points = written.matches('.').count();
    let number = written.trim_end_matches(['f', 'F', 'd', 'L']);
    let number = ["_f64", "_f32", "f64", "f32"]
        .into_iter()
        .find_map(|suffix| written.strip_suffix(suffix))
        .unwrap_or(number);
    let unit = number.trim_start_matches(|mark: char| mark.is_ascii_digit() || mark == '.');
    let is_exponent = unit.strip_prefix(['e', 'E']).is_some_and(|rest| {
        rest.bytes().all(|byte| byte.is_ascii_digit())
            && (!rest.is_empty() || text[length..].starts_with(['+', '-']))
    });
    let is_known = unit.is_empty()
        || is_exponent
        || ["deg", "rad", "mm", "m", "cm", "s", "ms", "px", "degrees"].contains(&unit);
    (points > 1 || !is_known).then_some(written.len().max(1))
}
