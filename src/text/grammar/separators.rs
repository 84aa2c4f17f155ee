//! Commas and semicolons that say more than that numbers follow each other: `(0.92; 0.1, -0.2, 0.38)` is a
//! scalar and a vector, `0,7;0,7` are two numbers with decimal commas.

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::lex::{Bracket, Spacing, Token, TokenKind};

/// The tokens with brackets around the vector that a semicolon parts from its scalar.
pub(crate) fn grouped<'t>(tokens: Vec<Token<'t>>) -> Result<Vec<Token<'t>>, Fault> {
    if !cfg!(feature = "whole") {
        return match asks_whole_core(&tokens) {
            Some(token) => Err(Fault::commas_and_semicolons(token.span)),
            None => Ok(tokens),
        };
    }
    if !tokens.iter().any(|token| token.kind == TokenKind::Comma) {
        return Ok(tokens);
    }
    let mut vectors = Vec::new();
    let mut group = Group::new(0);
    let mut around = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        match token.kind {
            TokenKind::Open(_) => {
                group.take(at, token);
                around.push(std::mem::replace(&mut group, Group::new(at + 1)));
            }
            TokenKind::Close(_) => {
                // What closes nothing is a problem of the grammar.
                let Some(outer) = around.pop() else {
                    return Ok(tokens);
                };
                vectors.extend(group.vector(&tokens, at)?);
                group = outer;
            }
            _ => group.take(at, token),
        }
    }
    if around.is_empty() {
        vectors.extend(group.vector(&tokens, tokens.len())?);
    }
    Ok(match vectors[..] {
        [vector] => with_brackets(&tokens, vector),
        // Several are no one quaternion, with brackets or without.
        _ => tokens,
    })
}

/// The first sign that a text needs more than is looked at without the feature `whole`: semicolons between numbers
/// with commas, a comma right between a zero and a digit, a number in brackets at the start.
fn asks_whole_core<'s, 't>(tokens: &'s [Token<'t>]) -> Option<&'s Token<'t>> {
    if let [open, .., close] = tokens.get(..3)?
        && open.text == "["
        && close.text == "]"
    {
        return Some(open);
    }
    let (mut has_commas, mut semicolon) = (false, None);
    for three in tokens.windows(3) {
        let [before, comma, after] = three else {
            continue;
        };
        match comma.text {
            "," if before.text == "0" && after.spacing.is_adjacent() && after.text != "0" => {
                return Some(comma);
            }
            "," => has_commas = true,
            ";" => semicolon = Some(comma),
            _ => {}
        }
    }
    semicolon.filter(|_| has_commas)
}

/// What stands between two brackets, or in the whole text.
struct Group {
    start: usize,
    /// Between semicolons: where each begins, and how many members it has.
    parts: Vec<(usize, usize)>,
    has_commas: bool,
    has_marks: bool,
    /// Whether a member stands between the last separator and here.
    is_in_item: bool,
}

impl Group {
    fn new(start: usize) -> Self {
        Self {
            start,
            parts: vec![(start, 0)],
            has_commas: false,
            has_marks: false,
            is_in_item: false,
        }
    }

    fn take(&mut self, at: usize, token: &Token<'_>) {
        match token.kind {
            TokenKind::Comma if token.text == ";" => {
                self.parts.push((at + 1, 0));
                self.is_in_item = false;
            }
            TokenKind::Comma => {
                self.has_commas = true;
                self.is_in_item = false;
            }
            TokenKind::Colon | TokenKind::Equals => self.has_marks = true,
            _ => {
                if let Some((_, count)) = self.parts.last_mut().filter(|_| !self.is_in_item) {
                    *count += 1;
                }
                self.is_in_item = true;
            }
        }
    }

    /// Where the vector stands that a semicolon parts from its scalar; a problem where commas may be those of
    /// decimals. Parts of one length, three at least, are the rows of a matrix.
    fn vector(&self, tokens: &[Token<'_>], end: usize) -> Result<Option<(usize, usize)>, Fault> {
        let tokens = &tokens[..end];
        if self.has_marks || !self.has_commas {
            return Ok(None);
        }
        if self.parts.len() == 1 {
            return match decimal_pairs(&tokens[self.start..]) {
                Some(fault) => Err(fault),
                None => Ok(None),
            };
        }
        let mut parts = Vec::new();
        for part in &self.parts {
            if part.1 > 0 {
                parts.push(part);
            }
        }
        let fault = || {
            let place = &tokens[self.start..];
            let span = place
                .first()
                .zip(place.last())
                .map(|(one, other)| one.span.to(other.span));
            Fault::commas_and_semicolons(span.unwrap_or_default())
        };
        match parts[..] {
            [] | [_] => Ok(None),
            [(start, 3), (next, 1)] if cfg!(feature = "whole") => Ok(Some((*start, next - 1))),
            [(_, 1), (start, 3)] if cfg!(feature = "whole") => {
                let has_end = tokens.last().is_some_and(|last| last.text == ";");
                Ok(Some((*start, end - usize::from(has_end))))
            }
            [(_, first), ..] if *first > 2 && parts.iter().all(|(_, count)| count == first) => {
                Ok(None)
            }
            _ => Err(fault()),
        }
    }
}

/// The problem of four whole numbers that may be two with decimal commas, as in `0,7,0,7`: commas without any
/// space, one of them behind a zero, and not of norm 1.
fn decimal_pairs(tokens: &[Token<'_>]) -> Option<Fault> {
    let mut numbers = Vec::new();
    for item in tokens.split(|token| token.kind == TokenKind::Comma) {
        // More than four are no pairs.
        if numbers.len() == 5 {
            return None;
        }
        numbers.push(whole_number(item)?);
    }
    let [whole, part, other_whole, other_part] = numbers[..] else {
        return None;
    };
    let is_decimal = |whole: f64, part: f64| whole == 0.0 && part > 0.0;
    let is_apart = |token: &Token<'_>| !token.spacing.is_adjacent();
    let norm_squared: f64 = numbers.iter().map(|number| number * number).sum();
    let may_be = is_decimal(whole, part) || is_decimal(other_whole, other_part);
    let span = tokens.first()?.span.to(tokens.last()?.span);
    (may_be && norm_squared != 1.0 && !tokens.iter().skip(1).any(is_apart))
        .then(|| Fault::decimal_pairs(span))
}

/// The number that tokens are, if it is typed with digits alone.
fn whole_number(tokens: &[Token<'_>]) -> Option<f64> {
    let (sign, number) = match tokens {
        [number] => (1.0, number),
        [minus, number] if minus.kind == TokenKind::Minus => (-1.0, number),
        _ => return None,
    };
    match number.kind {
        TokenKind::Number(value) if number.text.bytes().all(|digit| digit.is_ascii_digit()) => {
            Some(sign * value)
        }
        _ => None,
    }
}

/// The tokens with square brackets around a part of them.
fn with_brackets<'t>(tokens: &[Token<'t>], (start, end): (usize, usize)) -> Vec<Token<'t>> {
    let bracket = |kind, at: usize, text| Token {
        kind,
        text,
        span: Span::from(at..at),
        spacing: Spacing::Apart,
    };
    let vector = &tokens[start..end];
    let (first, last) = (vector[0].span.start, vector[vector.len() - 1].span.end);
    let open = bracket(TokenKind::Open(Bracket::Square), first, "[");
    let close = bracket(TokenKind::Close(Bracket::Square), last, "]");
    [&tokens[..start], &[open], vector, &[close], &tokens[end..]].concat()
}

/// That a text is no complex number of a program, `0.6+0.8j` or `(0.6+0.8i)`, which has no other units.
pub(crate) fn check_no_complex_number(tokens: &[Token<'_>]) -> Result<(), Fault> {
    let mut units = tokens
        .iter()
        .filter(|token| matches!(token.text, "i" | "j" | "k"));
    let (Some(unit), None) = (units.next(), units.next()) else {
        return Ok(());
    };
    if unit.text != "k" && tokens.windows(4).any(is_complex) {
        return Err(Fault::complex_number(unit.span));
    }
    Ok(())
}

/// `0.6+0.8j` without any space.
fn is_complex(tokens: &[Token<'_>]) -> bool {
    let [real, rest @ ..] = tokens else {
        return false;
    };
    let is_number = |token: &Token<'_>| matches!(token.kind, TokenKind::Number(_));
    let [sign, imaginary, unit] = rest else {
        return false;
    };
    is_number(real)
        && matches!(sign.kind, TokenKind::Plus | TokenKind::Minus)
        && is_number(imaginary)
        && matches!(unit.text, "i" | "j")
        && rest.iter().all(|token| token.spacing.is_adjacent())
}
