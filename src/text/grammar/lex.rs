//! Text to tokens, each with its place.
//!
//! What programs and people write differently is made one here: unicode signs,
//! float suffixes, comments, the dashes of a YAML list. Nothing here knows what
//! a quaternion is.

use crate::character::{begins_name, is_alphabetic, is_of_name};
use crate::convention::angle::AngleUnit;
use crate::decimal::nearest_double;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::blank::{Line, Touching, YamlDash, blank, drawn_run, hidden_in_number};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TokenKind {
    Number(f64),
    /// A word or a path such as `Eigen::Quaterniond`.
    Word,
    /// A word in quotes: a key of JSON or of a Python dictionary.
    Quoted,
    Plus,
    Minus,
    Times,
    Divide,
    Root,
    Degree,
    Comma,
    Colon,
    Equals,
    Open(Bracket),
    Close(Bracket),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bracket {
    Round,
    Square,
    Curly,
    Angle,
}

impl Bracket {
    pub(crate) const fn opening(self) -> &'static str {
        match self {
            Self::Round => "(",
            Self::Square => "[",
            Self::Curly => "{",
            Self::Angle => "<",
        }
    }

    pub(crate) const fn closing(self) -> &'static str {
        match self {
            Self::Round => ")",
            Self::Square => "]",
            Self::Curly => "}",
            Self::Angle => ">",
        }
    }
}

/// Whether white space stands before a token; it decides whether `1 -2` is one number or two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spacing {
    Adjacent,
    Apart,
    /// Apart, and on another line.
    NextLine,
}

impl Spacing {
    pub(crate) fn is_adjacent(self) -> bool {
        self == Self::Adjacent
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Token<'t> {
    pub(crate) kind: TokenKind,
    /// As written; without the quotes, and without a type of numbers such as `<double>`.
    pub(crate) text: &'t str,
    pub(crate) span: Span,
    pub(crate) spacing: Spacing,
}

impl Token<'_> {
    /// The unit of angle that this is: `°`, `deg`, `rad`.
    pub(crate) fn angle_unit(&self) -> Option<AngleUnit> {
        match self.kind {
            TokenKind::Degree => Some(AngleUnit::Degrees),
            TokenKind::Word => AngleUnit::named(&self.text.to_ascii_lowercase()),
            _ => None,
        }
    }
}

/// The texts of tokens, as written.
pub(crate) fn texts_of<'t>(tokens: &[Token<'t>]) -> Vec<&'t str> {
    let mut texts = Vec::new();
    for token in tokens {
        texts.push(token.text);
    }
    texts
}

/// The last name of a path: `Quaterniond` of `Eigen::Quaterniond`, `x` of `pose.orientation.x`.
pub(crate) fn last_segment(path: &str) -> &str {
    path.rsplit([':', '.']).next().unwrap_or(path)
}

pub(crate) fn tokens(text: &str) -> Result<Vec<Token<'_>>, Fault> {
    tokens_within(text, Span::from(0..text.len()))
}

/// The tokens of a part of a text, with their places in the whole.
pub(crate) fn tokens_within(whole: &str, part: Span) -> Result<Vec<Token<'_>>, Fault> {
    let text = &whole[..part.end];
    let yaml_dash = YamlDash::of(&text[part.start..]);
    let mut rest = &text[part.start..];
    let mut tokens = Vec::new();
    let mut line = Line::Start;
    let mut spacing = Spacing::Apart;
    loop {
        let before = text.len() - rest.len();
        let touching = match tokens.last().map(|token: &Token<'_>| token.kind) {
            Some(TokenKind::Number(_)) => Touching::Number,
            _ => Touching::Other,
        };
        rest = blank(rest, text, line, touching, yaml_dash);
        let start = text.len() - rest.len();
        if start > before {
            let skipped = Span::from(before..start);
            if let Some((span, character)) = hidden_in_number(text, skipped) {
                return Err(Fault::hidden_in_number(span, character));
            }
            spacing = if text[skipped.start..skipped.end].contains('\n') {
                Spacing::NextLine
            } else {
                Spacing::Apart
            };
        }
        if rest.is_empty() {
            return Ok(tokens);
        }
        let Some(Lexed {
            kind,
            written,
            length,
        }) = token(rest)
        else {
            return Err(unknown_mark(text, start));
        };
        let span = Span::from(start..start + length);
        rest = &rest[length..];
        if let TokenKind::Number(value) = kind {
            check_literal(value, written, span)?;
            if let Some(before) = tokens.last()
                && spacing == Spacing::Apart
                && is_group_of_thousands(before, written)
            {
                return Err(Fault::grouped_digits(before.span.to(span)));
            }
            if let Some(whole) = mixed_number(&tokens, value, written, spacing) {
                return Err(Fault::mixed_number(whole.to(span)));
            }
            if let [.., first, one, second, two] = &tokens[..]
                && [one, two].into_iter().all(|divide| divide.text == "/")
                && [first.text.len(), second.text.len(), written.len()].contains(&4)
                && [one, second, two]
                    .into_iter()
                    .all(|token| token.spacing.is_adjacent())
            {
                return Err(Fault::date(first.span.to(span)));
            }
        }
        // Two numbers that touch (`0.5.5`, `1½`) were not meant as two, and `0.92(3)` is a number
        // with its uncertainty, not a product.
        let needs_space = matches!(kind, TokenKind::Number(_) | TokenKind::Open(Bracket::Round));
        if needs_space && spacing.is_adjacent() && touching == Touching::Number {
            return Err(Fault::unexpected(span, written));
        }
        tokens.push(Token {
            kind,
            text: written,
            span,
            spacing,
        });
        spacing = Spacing::Adjacent;
        line = Line::Inside;
    }
}

/// What stands at a place where no token does.
fn unknown_mark(text: &str, start: usize) -> Fault {
    let character = text[start..].chars().next().unwrap_or(' ');
    let span = Span::from(start..start + character.len_utf8());
    let drawn = drawn_run(&text[start..]);
    if !drawn.is_empty() {
        return Fault::drawn_line(Span::from(start..start + drawn.len()), drawn);
    }
    match character {
        '∞' => Fault::infinite(span),
        '.' if text[span.end..].starts_with(is_alphabetic) => Fault::method(span),
        _ if hidden_in_number(text, span).is_some() => Fault::hidden_in_number(span, character),
        _ => Fault::unexpected_character(span, character),
    }
}

/// What stands at a place.
struct Lexed<'t> {
    kind: TokenKind,
    /// What becomes the text of the token.
    written: &'t str,
    /// How much of the text it is.
    length: usize,
}

fn token(rest: &str) -> Option<Lexed<'_>> {
    let first = rest.chars().next()?;
    match first {
        '0'..='9' | '.' => number(rest),
        '"' | '\'' => quoted(rest, first),
        _ if name(rest) > 0 => Some(word(rest)),
        _ => sign(rest, first),
    }
}

/// How many digits a text begins with.
fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

fn number(rest: &str) -> Option<Lexed<'_>> {
    let mut length = digits(rest);
    if let Some(part) = rest[length..].strip_prefix('.') {
        let part = digits(part);
        if length + part == 0 {
            return None;
        }
        length += 1 + part;
    }
    length += exponent(&rest[length..]);
    let written = &rest[..length];
    // C and Rust suffixes: 0.5f, 0.5f64, 0.5_f64.
    let after = &rest[length..];
    let suffixed = after.strip_prefix('_').unwrap_or(after);
    for suffix in ["f64", "f32", "f", "F"] {
        if let Some(after) = suffixed.strip_prefix(suffix)
            && !after.starts_with(is_of_name)
        {
            length = rest.len() - after.len();
        }
    }
    let plain = written.replace("×10", "e").replace('^', "");
    let value = nearest_double(&plain.replace(['−', '–'], "-"));
    Some(Lexed {
        kind: TokenKind::Number(value),
        written,
        length,
    })
}

/// The length of an exponent: `e-3`, or as copied from a printed page `×10−3`, where the sign tells it from a
/// product.
fn exponent(text: &str) -> usize {
    let of_digits = match text.strip_prefix(['e', 'E']) {
        Some(signed) => signed.strip_prefix(['+', '-', '−']).unwrap_or(signed),
        None => match text.strip_prefix("×10") {
            Some(signed) => {
                let signed = signed.strip_prefix('^').unwrap_or(signed);
                signed.strip_prefix(['+', '-', '−', '–']).unwrap_or("")
            }
            None => "",
        },
    };
    match digits(of_digits) {
        0 => 0,
        count => text.len() - of_digits.len() + count,
    }
}

/// A literal that a double cannot hold is a problem, not an infinity or a zero.
fn check_literal(value: f64, written: &str, span: Span) -> Result<(), Fault> {
    let mantissa = written.split(['e', 'E', '×']).next().unwrap_or(written);
    if value.is_infinite() {
        return Err(Fault::too_large(span));
    }
    if value == 0.0 && mantissa.contains(|digit| matches!(digit, '1'..='9')) {
        return Err(Fault::too_small(span));
    }
    Ok(())
}

/// Whether digits behind a number are its thousands, as in `10 000`: three that begin with a 0, which
/// nobody writes before a number of its own.
fn is_group_of_thousands(before: &Token<'_>, written: &str) -> bool {
    let is_group = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    matches!(before.kind, TokenKind::Number(_))
        && is_group(before.text)
        && (1..=3).contains(&before.text.len())
        && !before.text.starts_with('0')
        && written
            .split('.')
            .next()
            .is_some_and(|whole| whole.len() == 3 && is_group(whole))
        && written.starts_with('0')
}

/// Where the whole number stands of one with a fraction, `1 1/2` or `1 ½`, which may be two numbers; the last
/// number of it comes after `before`.
fn mixed_number(before: &[Token<'_>], last: f64, written: &str, spacing: Spacing) -> Option<Span> {
    let is_whole = |token: &Token<'_>| {
        let is_digits = token.text.bytes().all(|digit| digit.is_ascii_digit());
        matches!(token.kind, TokenKind::Number(value) if is_digits && value >= 1.0)
    };
    let (before, spacing) = match before {
        [before @ .., above, divide]
            if divide.kind == TokenKind::Divide
                && matches!(above.kind, TokenKind::Number(above) if above < last) =>
        {
            (before, above.spacing)
        }
        _ if written == "½" => (before, spacing),
        _ => return None,
    };
    let (whole, earlier) = before.split_last()?;
    let is_divisor = earlier
        .last()
        .is_some_and(|token| matches!(token.kind, TokenKind::Divide | TokenKind::Times));
    (spacing == Spacing::Apart && is_whole(whole) && !is_divisor).then_some(whole.span)
}

/// The length of the name that a text begins with.
fn name(text: &str) -> usize {
    if text.starts_with(begins_name) {
        text.find(|next| !is_of_name(next)).unwrap_or(text.len())
    } else {
        0
    }
}

/// A path that begins with a name, with the only argument of a template.
fn word(rest: &str) -> Lexed<'_> {
    let mut length = name(rest);
    loop {
        let after = &rest[length..];
        let Some(next) = after.strip_prefix("::").or_else(|| after.strip_prefix('.')) else {
            break;
        };
        match name(next) {
            0 => break,
            segment => length = rest.len() - next.len() + segment,
        }
    }
    let mut written = &rest[..length];
    let inside = rest[length..].strip_prefix('<').unwrap_or_default();
    let end = inside.find(|next| !is_of_name(next)).unwrap_or_default();
    if end > 0 && inside[end..].starts_with('>') {
        length += end + 2;
        if !is_number_type(&inside[..end]) {
            // What else an argument may say, as in `Quaternion<xyzw>`, belongs to the name.
            written = &rest[..length];
        }
    }
    Lexed {
        kind: TokenKind::Word,
        written,
        length,
    }
}

/// `double`, `f32`, `Scalar`, and a size such as 3: they change no number.
fn is_number_type(name: &str) -> bool {
    const TYPES: [&str; 12] = [
        "double",
        "f32",
        "f64",
        "float",
        "float32",
        "float32_t",
        "float64",
        "float64_t",
        "number",
        "real",
        "scalar",
        "t",
    ];
    TYPES.contains(&name.to_ascii_lowercase().as_str())
        || name.bytes().all(|byte| byte.is_ascii_digit())
}

fn quoted(rest: &str, quote: char) -> Option<Lexed<'_>> {
    let inside = &rest[1..];
    let end = inside.find([quote, '\n'])?;
    inside[end..].starts_with(quote).then(|| Lexed {
        kind: TokenKind::Quoted,
        written: &inside[..end],
        length: end + 2,
    })
}

fn sign(rest: &str, character: char) -> Option<Lexed<'_>> {
    let kind = match character {
        '+' => TokenKind::Plus,
        '-' | '−' | '–' => TokenKind::Minus,
        '*' | '·' | '×' | '⋅' | '∗' => TokenKind::Times,
        '/' | '÷' | '∕' | '⁄' => TokenKind::Divide,
        '√' => TokenKind::Root,
        '°' | '˚' => TokenKind::Degree,
        ',' | ';' => TokenKind::Comma,
        ':' => TokenKind::Colon,
        '=' => TokenKind::Equals,
        '½' => TokenKind::Number(0.5),
        '(' => TokenKind::Open(Bracket::Round),
        '[' => TokenKind::Open(Bracket::Square),
        '{' => TokenKind::Open(Bracket::Curly),
        '<' => TokenKind::Open(Bracket::Angle),
        '>' => TokenKind::Close(Bracket::Angle),
        ')' => TokenKind::Close(Bracket::Round),
        ']' => TokenKind::Close(Bracket::Square),
        '}' => TokenKind::Close(Bracket::Curly),
        _ => return None,
    };
    let length = character.len_utf8();
    Some(Lexed {
        kind,
        written: &rest[..length],
        length,
    })
}
