//! Tokens to a small tree: numbers already computed, lists, names and calls.
//!
//! The grammar is in the documentation of [`text`](mod@crate::text).

// The arithmetic of typed text.
pub(crate) mod arithmetic;

// What stands between tokens.
pub(crate) mod blank;

// The tokens on their way through the grammar.
mod cursor;

// The name before a member.
mod key;

// Text to tokens.
pub(crate) mod lex;

// What stands inside which brackets.
pub(crate) mod nesting;

// Commas and semicolons that say more.
pub(crate) mod separators;

// Signs that may mean two things.
pub(crate) mod signs;

// The members that a text consists of.
pub(crate) mod tree;

use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::arithmetic::Linear;
use crate::text::grammar::cursor::{Input, Spaces, State, computed, end_of, token_at, unexpected};
use crate::text::grammar::key::key_ahead;
use crate::text::grammar::lex::{Bracket, Spacing, Token, TokenKind};
use crate::text::grammar::signs::{DoubtfulSign, RepeatedSign};
use crate::text::grammar::tree::{CallsAreRead, Entry, Key, Lead, Node, NodeKind};
use winnow::stream::{Stateful, Stream as _};

/// How many brackets may be open at once; a quaternion needs about four.
pub(crate) const MAX_DEPTH: usize = 32;

/// Reads all tokens of a text, or of a part of it.
pub(crate) fn entries<'t>(tokens: &[Token<'t>]) -> Result<Vec<Entry<'t>>, Fault> {
    members(tokens, Spaces::Separate)
}

/// Reads the tokens between the brackets of a function.
pub(crate) fn arguments<'t>(tokens: &[Token<'t>]) -> Result<Vec<Entry<'t>>, Fault> {
    members(tokens, Spaces::Ignored)
}

fn members<'t>(tokens: &[Token<'t>], spaces: Spaces) -> Result<Vec<Entry<'t>>, Fault> {
    let state = State {
        text_end: tokens.last().map_or(0, |last| last.span.end),
        depth: 0,
        spaces,
        doubtful_sign: None,
        repeated_sign: None,
    };
    let mut input = Stateful {
        input: tokens,
        state,
    };
    let entries = list(&mut input)?;
    match input.peek_token() {
        None => Ok(entries),
        Some(token) => Err(match token.kind {
            TokenKind::Close(_) => Fault::unmatched_bracket(token.span, token.text, None),
            _ => unexpected(&token),
        }),
    }
}

/// Members until the end of the text or a closing bracket.
fn list<'t>(input: &mut Input<'_, 't>) -> Result<Vec<Entry<'t>>, Fault> {
    let mut entries = Vec::new();
    let mut lead = Lead::First;
    while let Some(token) = input.peek_token() {
        match token.kind {
            TokenKind::Close(_) => break,
            TokenKind::Comma => {
                // `0.7,0.1,,-0.5,0.5`: a number is missing.
                if lead == Lead::AfterComma && token.text == "," {
                    return Err(unexpected(&token));
                }
                input.next_token();
                if lead == Lead::Bare {
                    lead = Lead::AfterComma;
                }
            }
            _ => {
                let is_sign = matches!(token.kind, TokenKind::Plus | TokenKind::Minus);
                if lead == Lead::Bare && is_sign {
                    lead = Lead::Signed;
                }
                entries.push(entry(input, lead)?);
                lead = Lead::Bare;
            }
        }
    }
    Ok(entries)
}

fn entry<'t>(input: &mut Input<'_, 't>, lead: Lead) -> Result<Entry<'t>, Fault> {
    let mut key: Option<Key<'t>> = None;
    // A label before another name is a heading: `orientation:` above `x: 0`.
    while let Some((found, length)) = key_ahead(input) {
        input.next_slice(length);
        key = Some(Key {
            heading: key.map(|label| label.name),
            ..found
        });
    }
    input.state.doubtful_sign = None;
    let node = sum(input)?;
    Ok(Entry {
        key,
        node,
        lead,
        doubtful_sign: input.state.doubtful_sign.take(),
    })
}

fn sum<'t>(input: &mut Input<'_, 't>) -> Result<Node<'t>, Fault> {
    let before = input.input;
    let mut left = product(input)?;
    let mut last = &before[..before.len() - input.input.len()];
    while let Some(sign) = input.peek_token() {
        if !matches!(sign.kind, TokenKind::Plus | TokenKind::Minus) {
            break;
        }
        // In a list `1 -2` is two numbers; `1 - 2`, `1-2` and `1- 2` are one.
        let is_apart = !sign.spacing.is_adjacent();
        let next = token_at(input, 1);
        let touches_next = next.is_some_and(|next| next.spacing.is_adjacent());
        let separates = input.state.spaces == Spaces::Separate;
        if separates && is_apart && touches_next {
            break;
        }
        input.next_token();
        let before = input.input;
        let right = product(input)?;
        let addend = &before[..before.len() - input.input.len()];
        let (augend_value, addend_value) = (left.operand()?, right.operand()?);
        let is_sign = |next: &Token<'_>| matches!(next.kind, TokenKind::Plus | TokenKind::Minus);
        if let Some(second) = next.filter(is_sign)
            && touches_next
        {
            RepeatedSign::of(&[sign, second]).map_or(Ok(()), |signs| signs.check(&addend_value))?;
        }
        if separates && input.state.doubtful_sign.is_none() {
            input.state.doubtful_sign = match (is_apart, touches_next) {
                (true, _) => Some(DoubtfulSign::apart(Fault::loose_sign(sign.span))),
                (false, false) => Some(DoubtfulSign::apart(Fault::trailing_sign(sign.span))),
                (false, true) => signs::run_together(last, sign, addend),
            };
        }
        let span = left.span.to(right.span);
        let sum = match sign.kind {
            TokenKind::Minus => augend_value.plus(addend_value.negated(), span)?,
            _ => augend_value.plus(addend_value, span)?,
        };
        left = computed(sum, span);
        last = addend;
    }
    Ok(left)
}

fn product<'t>(input: &mut Input<'_, 't>) -> Result<Node<'t>, Fault> {
    let outer = input.state.repeated_sign.take();
    let product = factors(input)?;
    if let Some(signs) = std::mem::replace(&mut input.state.repeated_sign, outer) {
        signs.check(&product.operand()?)?;
    }
    Ok(product)
}

fn factors<'t>(input: &mut Input<'_, 't>) -> Result<Node<'t>, Fault> {
    let mut left = signed(input)?;
    while let Some(next) = input.peek_token() {
        let (value, span) = match (next.kind, next.angle_unit()) {
            (TokenKind::Times | TokenKind::Divide, _) => {
                input.next_token();
                // MATLAB prints `1.0e+03 *` above the lines that it multiplies.
                let line_ends = input
                    .peek_token()
                    .is_some_and(|next| next.spacing == Spacing::NextLine);
                if line_ends {
                    return Err(Fault::factor_before_line(left.span.to(next.span)));
                }
                let right = signed(input)?;
                let span = left.span.to(right.span);
                let (first, second) = (left.operand()?, right.operand()?);
                let value = match next.kind {
                    TokenKind::Divide => first.over(second, right.span, span)?,
                    _ => first.times(second, span)?,
                };
                (value, span)
            }
            (_, Some(unit)) => {
                input.next_token();
                let span = left.span.to(next.span);
                (left.operand()?.angle(unit, span)?, span)
            }
            _ if left.is_multiplied_by(&next) => {
                let right = atom(input)?;
                let span = left.span.to(right.span);
                (left.operand()?.times(right.operand()?, span)?, span)
            }
            _ => break,
        };
        left = computed(value, span);
    }
    Ok(left)
}

/// Signs and then an atom; a loop, so that a million signs need no stack.
fn signed<'t>(input: &mut Input<'_, 't>) -> Result<Node<'t>, Fault> {
    let before = input.input;
    while let Some(token) = input.peek_token() {
        if !matches!(token.kind, TokenKind::Plus | TokenKind::Minus) {
            break;
        }
        input.next_token();
        let is_loose = input
            .peek_token()
            .is_some_and(|next| !next.spacing.is_adjacent());
        if is_loose && input.state.spaces == Spaces::Separate {
            let fault = || DoubtfulSign::apart(Fault::loose_sign(token.span));
            input.state.doubtful_sign.get_or_insert_with(fault);
        }
    }
    let signs = &before[..before.len() - input.input.len()];
    let node = atom(input)?;
    let Some(first) = signs.first() else {
        return Ok(node);
    };
    if let Some(repeated) = RepeatedSign::of(signs) {
        input.state.repeated_sign.get_or_insert(repeated);
    }
    let value = node.operand()?;
    let minuses = signs
        .iter()
        .filter(|sign| sign.kind == TokenKind::Minus)
        .count();
    let value = if minuses % 2 == 0 {
        value
    } else {
        value.negated()
    };
    Ok(computed(value, first.span.to(node.span)))
}

fn atom<'t>(input: &mut Input<'_, 't>) -> Result<Node<'t>, Fault> {
    let Some(token) = input.next_token() else {
        return Err(Fault::unexpected_end(end_of(input)));
    };
    match token.kind {
        TokenKind::Number(value) => Ok(computed(Linear::real(value), token.span)),
        TokenKind::Word => word(input, token),
        TokenKind::Root => root(input, token),
        TokenKind::Open(bracket) => {
            let (entries, span) = bracketed(input, token, bracket)?;
            Ok(Node::of_brackets(entries, span))
        }
        TokenKind::Close(_) => match input.state.depth {
            0 => Err(Fault::unmatched_bracket(token.span, token.text, None)),
            _ => Err(unexpected(&token)),
        },
        TokenKind::Quoted => match arithmetic::not_finite(&token) {
            Some(fault) => Err(fault),
            None => Ok(Node {
                kind: NodeKind::Word(token.text),
                span: token.span,
            }),
        },
        _ => Err(unexpected(&token)),
    }
}

fn word<'t>(input: &mut Input<'_, 't>, token: Token<'t>) -> Result<Node<'t>, Fault> {
    let name = token.text;
    if let Some(value) = Linear::unit(name).or_else(|| Linear::constant(name)) {
        return Ok(computed(value, token.span));
    }
    if let Some(fault) = arithmetic::not_finite(&token) {
        return Err(fault);
    }
    // A declaration `Eigen::Quaterniond q(...)`: the variable's name says nothing.
    let declares = token_at(input, 0).is_some_and(|next| next.kind == TokenKind::Word)
        && token_at(input, 1).is_some_and(|next| matches!(next.kind, TokenKind::Open(_)));
    if declares {
        input.next_token();
    }
    let Some(Token {
        kind: TokenKind::Open(bracket),
        ..
    }) = input.peek_token()
    else {
        return Ok(Node {
            kind: NodeKind::Word(name),
            span: token.span,
        });
    };
    if bracket == Bracket::Angle || (Linear::is_function(name) && bracket != Bracket::Round) {
        return Err(Fault::unknown_word(token.span, name));
    }
    let Some(opening) = input.next_token() else {
        return Err(Fault::unexpected_end(end_of(input)));
    };
    let outer = input.state.spaces;
    if Linear::is_function(name) {
        input.state.spaces = Spaces::Ignored;
    }
    let inside = bracketed(input, opening, bracket);
    input.state.spaces = outer;
    let (arguments, span) = inside?;
    let span = token.span.to(span);
    if !Linear::is_function(name) {
        let Some(read) = CallsAreRead::here() else {
            return Err(Fault::unknown_word(span, name));
        };
        return Ok(Node {
            kind: NodeKind::Call {
                name,
                arguments,
                read,
            },
            span,
        });
    }
    match arguments.as_slice() {
        [
            Entry {
                key: None, node, ..
            },
        ] => Ok(computed(
            Linear::call(name, node.operand()?, node.span, span)?,
            span,
        )),
        _ => Err(Fault::argument_count(span, name)),
    }
}

/// `√2`, `√(2)`, `√√2`
fn root<'t>(input: &mut Input<'_, 't>, first: Token<'t>) -> Result<Node<'t>, Fault> {
    let mut roots = 1;
    while input
        .peek_token()
        .is_some_and(|next| next.kind == TokenKind::Root)
    {
        input.next_token();
        roots += 1;
    }
    let argument = atom(input)?;
    let span = first.span.to(argument.span);
    let mut value = argument.operand()?;
    for _ in 0..roots {
        value = Linear::call("sqrt", value, argument.span, span)?;
    }
    Ok(computed(value, span))
}

/// The members between an opening bracket, already read, and its closing one.
fn bracketed<'t>(
    input: &mut Input<'_, 't>,
    opening: Token<'t>,
    bracket: Bracket,
) -> Result<(Vec<Entry<'t>>, Span), Fault> {
    if input.state.depth == MAX_DEPTH {
        return Err(Fault::nested_too_deep(opening.span, MAX_DEPTH));
    }
    input.state.depth += 1;
    let entries = list(input)?;
    input.state.depth -= 1;
    match input.next_token() {
        Some(token) if token.kind == TokenKind::Close(bracket) => {
            Ok((entries, opening.span.to(token.span)))
        }
        Some(token) => Err(Fault::unmatched_bracket(
            token.span,
            token.text,
            Some(bracket.closing()),
        )),
        None => Err(Fault::unclosed_bracket(
            opening.span,
            bracket.opening(),
            bracket.closing(),
        )),
    }
}
