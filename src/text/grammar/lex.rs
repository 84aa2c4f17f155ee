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
use crate::text::grammar::blank::{
    Input, Lexed, Line, Touching, YamlDash, blank, drawn_run, hidden_in_number,
};
use winnow::ascii::{digit0, digit1};
use winnow::combinator::{alt, delimited, not, opt, peek, repeat, terminated};
use winnow::prelude::*;
use winnow::token::{any, one_of, take_while};

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
    let mut input = Input::new(&text[part.start..]);
    let mut tokens = Vec::new();
    let mut line = Line::Start;
    let mut spacing = Spacing::Apart;
    loop {
        let before = text.len() - input.len();
        let touching = match tokens.last().map(|token: &Token<'_>| token.kind) {
            Some(TokenKind::Number(_)) => Touching::Number,
            _ => Touching::Other,
        };
        if blank(&mut input, text, line, touching, yaml_dash).is_some() {
            let skipped = Span::from(before..text.len() - input.len());
            if let Some((span, character)) = hidden_in_number(text, skipped) {
                return Err(Fault::hidden_in_number(span, character));
            }
            spacing = if text[skipped.start..skipped.end].contains('\n') {
                Spacing::NextLine
            } else {
                Spacing::Apart
            };
        }
        if input.is_empty() {
            return Ok(tokens);
        }
        let start = text.len() - input.len();
        let Ok((kind, written)) = token.parse_next(&mut input) else {
            return Err(unknown_mark(text, start));
        };
        let span = Span::from(start..text.len() - input.len());
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

fn token<'t>(input: &mut Input<'t>) -> Lexed<(TokenKind, &'t str)> {
    alt((number, word, quoted, sign)).parse_next(input)
}

fn number<'t>(input: &mut Input<'t>) -> Lexed<(TokenKind, &'t str)> {
    let mantissa = alt(((digit1, opt(('.', digit0))).void(), ('.', digit1).void()));
    let exponent = (one_of(['e', 'E']), opt(one_of(['+', '-', '−'])), digit1);
    // `1.5×10−3`, as copied from a printed page; the sign tells it from a product.
    let printed = ("×10", opt('^'), one_of(['+', '-', '−', '–']), digit1);
    let written = (mantissa, opt(alt((exponent.void(), printed.void()))))
        .take()
        .parse_next(input)?;
    // C and Rust suffixes: 0.5f, 0.5f64, 0.5_f64.
    let _ =
        opt((opt('_'), alt(("f64", "f32", "f", "F")), not(name_character))).parse_next(input)?;
    let plain = written.replace("×10", "e").replace('^', "");
    let value = nearest_double(&plain.replace(['−', '–'], "-"));
    Ok((TokenKind::Number(value), written))
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

/// One character that continues a name.
fn name_character(input: &mut Input<'_>) -> Lexed<char> {
    one_of(is_of_name).parse_next(input)
}

fn name(input: &mut Input<'_>) -> Lexed<()> {
    (
        peek(one_of(begins_name)),
        repeat::<_, _, (), _, _>(1.., name_character),
    )
        .void()
        .parse_next(input)
}

fn word<'t>(input: &mut Input<'t>) -> Lexed<(TokenKind, &'t str)> {
    let number_type = ('<', argument.verify(|name: &str| is_number_type(name)), '>');
    alt((
        terminated(path.take(), number_type),
        // What else an argument may say, as in `Quaternion<xyzw>`, belongs to the name.
        (path, opt(('<', argument, '>'))).take(),
    ))
    .map(|text| (TokenKind::Word, text))
    .parse_next(input)
}

fn path(input: &mut Input<'_>) -> Lexed<()> {
    let segment = (alt(("::", ".")), name);
    (name, repeat::<_, _, (), _, _>(0.., segment))
        .void()
        .parse_next(input)
}

/// The only argument of a template.
fn argument<'t>(input: &mut Input<'t>) -> Lexed<&'t str> {
    repeat::<_, _, (), _, _>(1.., name_character)
        .take()
        .parse_next(input)
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

fn quoted<'t>(input: &mut Input<'t>) -> Lexed<(TokenKind, &'t str)> {
    let inside = |quote: char| take_while(0.., move |c: char| c != quote && c != '\n');
    alt((
        delimited('"', inside('"'), '"'),
        delimited('\'', inside('\''), '\''),
    ))
    .map(|text| (TokenKind::Quoted, text))
    .parse_next(input)
}

fn sign<'t>(input: &mut Input<'t>) -> Lexed<(TokenKind, &'t str)> {
    any.with_taken()
        .verify_map(|(character, text)| {
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
            Some((kind, text))
        })
        .parse_next(input)
}
