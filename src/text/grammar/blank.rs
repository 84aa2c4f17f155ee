//! What stands between tokens: white space, comments, frames that are drawn, and what only lays out a
//! YAML text.
//!
//! Only what can be nothing else is passed over. A line of a frame that touches a number looks like a
//! minus, and a character that is not seen joins two numbers into one.

use crate::character::{
    is_blank, is_drawn, is_drawn_bar, is_drawn_dash, is_space_of_numbers, is_unseen,
    is_unseen_break,
};
use crate::problem::Span;
use winnow::ascii::{line_ending, space0};
use winnow::combinator::{alt, eof, fail, peek, terminated};
use winnow::error::EmptyError;
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Stream};
use winnow::token::{one_of, take_till, take_until, take_while};

pub(crate) type Input<'t> = LocatingSlice<&'t str>;

/// What stands at a place, or that it does not: why is never asked, and reasons that nobody reads are code.
pub(crate) type Lexed<T> = Result<T, EmptyError>;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum YamlDash {
    IsMinus,
    Separates,
}

impl YamlDash {
    /// It separates where every line begins with a dash and a space, as `rostopic echo` prints
    /// arrays; blank lines, comments and headings may stand between.
    pub(crate) fn of(text: &str) -> Self {
        let is_heading = |line: &str| {
            line.is_empty() || line.starts_with('#') || line.ends_with(':') || is_document(line)
        };
        let mut lines = text.lines().map(str::trim).filter(|line| !is_heading(line));
        let items = lines.clone().count();
        let is_item = |line: &str| {
            line.strip_prefix('-')
                .is_some_and(|item| item.starts_with(char::is_whitespace))
        };
        if items > 1 && lines.all(is_item) {
            Self::Separates
        } else {
            Self::IsMinus
        }
    }
}

/// `---`, alone or with a comment.
fn is_document(line: &str) -> bool {
    line.strip_prefix("---").is_some_and(|rest| {
        rest.is_empty() || (rest.starts_with([' ', '\t']) && rest.trim_start().starts_with('#'))
    })
}

/// Whether only white space stands before a place in its line.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Line {
    Start,
    Inside,
}

/// What stands right before a place.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Touching {
    Number,
    Other,
}

/// Skips what separates tokens of `text`, of which `input` is the rest; `None` where there is nothing
/// to skip.
pub(crate) fn blank<'t>(
    input: &mut Input<'t>,
    text: &'t str,
    mut line: Line,
    touching: Touching,
    yaml_dash: YamlDash,
) -> Option<Line> {
    let before = input.len();
    loop {
        // A comment does not touch a number: `1.#IND` and `1//2` are something else.
        let is_first = input.len() == before;
        let start = input.checkpoint();
        let skipped = if is_first && touching == Touching::Number {
            alt((white, layout(line, yaml_dash))).parse_next(input)
        } else {
            let drawn = |input: &mut Input<'t>| frame(input, text);
            alt((white, reference, comment, drawn, layout(line, yaml_dash))).parse_next(input)
        };
        match skipped {
            Ok(text) if text.contains('\n') => line = Line::Start,
            Ok(text) if text == "-" || text.starts_with(is_drawn) => line = Line::Inside,
            Ok(_) => {}
            Err(_) => {
                // What only looked like something to skip is not skipped.
                input.reset(&start);
                return (input.len() < before).then_some(line);
            }
        }
    }
}

/// The mark `---` of a YAML document at the start of a line, with nothing, a comment or a list behind
/// it, and the dash of a YAML list.
fn layout<'t>(line: Line, yaml_dash: YamlDash) -> impl FnMut(&mut Input<'t>) -> Lexed<&'t str> {
    move |input| {
        if line == Line::Inside {
            return fail.parse_next(input);
        }
        let alone = (space0, alt((line_ending, eof))).void();
        let before_a_list = (one_of([' ', '\t']), space0, one_of(['#', '{', '['])).void();
        let document = terminated("---", peek(alt((alone, before_a_list))));
        match yaml_dash {
            YamlDash::Separates => alt((document, "-")).parse_next(input),
            YamlDash::IsMinus => { document }.parse_next(input),
        }
    }
}

fn white<'t>(input: &mut Input<'t>) -> Lexed<&'t str> {
    take_while(1.., is_blank).parse_next(input)
}

/// The sign of a reference: `&Vector3::z_axis()`, `&[1.0, 0.0]`.
fn reference<'t>(input: &mut Input<'t>) -> Lexed<&'t str> {
    let borrowed = one_of(|next: char| next.is_alphabetic() || next == '[');
    terminated("&", peek(borrowed)).parse_next(input)
}

/// Without the feature `whole` one with letters is no comment, since it may say something of the numbers: what
/// begins it has no meaning then.
fn comment<'t>(input: &mut Input<'t>) -> Lexed<&'t str> {
    let is_passed_over =
        |text: &&str| cfg!(feature = "whole") || !text.contains(char::is_alphabetic);
    alt((
        // With a space: `5%` is no comment but something that is not known here.
        (alt(("//", "#", "% ")), take_till(0.., '\n')).take(),
        ("/*", take_until(0.., "*/"), "*/").take(),
    ))
    .verify(is_passed_over)
    .parse_next(input)
}

/// The comments in what stands between tokens.
pub(crate) fn comments_in(gap: &str) -> Vec<Span> {
    let mut found = Vec::new();
    let mut input = Input::new(gap);
    while let Some(character) = input.chars().next() {
        let start = gap.len() - input.len();
        let before = input.checkpoint();
        if comment.parse_next(&mut input).is_ok() {
            found.push(Span::from(start..gap.len() - input.len()));
        } else {
            input.reset(&before);
            input.next_slice(character.len_utf8());
        }
    }
    found
}

/// The text with a space in place of each comment.
pub(crate) fn without_comments(text: &str) -> String {
    let mut input = Input::new(text);
    let mut bare = String::with_capacity(text.len());
    while let Some(character) = input.chars().next() {
        let start = input.checkpoint();
        if comment.parse_next(&mut input).is_ok() {
            bare.push(' ');
        } else {
            input.reset(&start);
            bare.push(character);
            input.next_slice(character.len_utf8());
        }
    }
    bare
}

/// The drawn characters at the start of a text.
pub(crate) fn drawn_run(text: &str) -> &str {
    let end = text.find(|character| !is_drawn(character));
    &text[..end.unwrap_or(text.len())]
}

/// A part of a frame that touches nothing. Where it only consists of dashes it must have its line for
/// itself, unless a corner or a branch begins it.
fn frame<'t>(input: &mut Input<'t>, text: &'t str) -> Lexed<&'t str> {
    let (before, rest) = text.split_at(text.len() - input.len());
    let run = drawn_run(rest);
    let after = &rest[run.len()..];
    let stands_apart = before.chars().next_back().is_none_or(is_blank)
        && after.chars().next().is_none_or(is_blank);
    if run.is_empty() || !stands_apart {
        return fail.parse_next(input);
    }
    let is_joint = |character| !is_drawn_dash(character) && !is_drawn_bar(character);
    if !run.contains(is_drawn_dash) || run.contains(is_joint) {
        return Ok(input.next_slice(run.len()));
    }
    let line_before = &before[before.rfind('\n').map_or(0, |newline| newline + 1)..];
    let line_after = &rest[..rest.find('\n').unwrap_or(rest.len())];
    let is_empty = |part: &str| part.chars().all(|c| is_drawn(c) || is_blank(c));
    if is_empty(line_before) && is_empty(line_after) {
        return Ok(input.next_slice(line_after.len()));
    }
    fail.parse_next(input)
}

/// The first character inside a number that is not seen there, or hardly: nothing but such characters
/// stand between two digits. What is not seen at all joins a number to a sign and a point as well.
pub(crate) fn hidden_in_number(text: &str, skipped: Span) -> Option<(Span, char)> {
    let (before, after) = (&text[..skipped.start], &text[skipped.end..]);
    let between = &text[skipped.start..skipped.end];
    let first = between.chars().next()?;
    let (before, after) = (before.chars().next_back()?, after.chars().next()?);
    let joins = if between.chars().all(is_unseen) {
        let is_of_number = |character: char| character.is_ascii_digit() || character == '.';
        is_of_number(before) && (is_of_number(after) || "+-−–".contains(after))
    } else {
        let is_hidden = |character| {
            is_unseen(character) || is_space_of_numbers(character) || is_unseen_break(character)
        };
        between.chars().all(is_hidden) && before.is_ascii_digit() && after.is_ascii_digit()
    };
    joins.then(|| {
        let end = skipped.start + first.len_utf8();
        (Span::from(skipped.start..end), first)
    })
}
