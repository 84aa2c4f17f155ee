//! What stands between tokens: white space, comments, frames that are drawn, and what only lays out a
//! YAML text.
//!
//! Only what can be nothing else is passed over. A line of a frame that touches a number looks like a
//! minus, and a character that is not seen joins two numbers into one.

use crate::character::{
    is_alphabetic, is_blank, is_drawn, is_drawn_bar, is_drawn_dash, is_space_of_numbers, is_unseen,
    is_unseen_break,
};
use crate::problem::Span;

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

/// What is left of `rest`, the end of `text`, behind what only separates tokens.
pub(crate) fn blank<'t>(
    rest: &'t str,
    text: &str,
    mut line: Line,
    touching: Touching,
    yaml_dash: YamlDash,
) -> &'t str {
    let mut left = rest;
    loop {
        let mut length = white(left);
        // A comment does not touch a number: `1.#IND` and `1//2` are something else.
        if length == 0 && (left.len() < rest.len() || touching == Touching::Other) {
            length = match left.chars().next() {
                Some('&') => reference(left),
                Some('/' | '#' | '%') => comment(left),
                _ => frame(left, text),
            };
        }
        if length == 0 && line == Line::Start {
            length = layout(left, yaml_dash);
        }
        if length == 0 {
            return left;
        }
        let (skipped, behind) = left.split_at(length);
        if skipped.contains('\n') {
            line = Line::Start;
        } else if skipped == "-" || skipped.starts_with(is_drawn) {
            line = Line::Inside;
        }
        left = behind;
    }
}

/// The length of the mark `---` of a YAML document at the start of a line, with nothing, a comment or a list
/// behind it, or of the dash of a YAML list.
fn layout(rest: &str, yaml_dash: YamlDash) -> usize {
    if let Some(behind) = rest.strip_prefix("---") {
        let after = behind.trim_start_matches([' ', '\t']);
        let is_alone = after.is_empty() || after.starts_with('\n') || after.starts_with("\r\n");
        if is_alone || after.len() < behind.len() && after.starts_with(['#', '{', '[']) {
            return 3;
        }
    }
    usize::from(yaml_dash == YamlDash::Separates && rest.starts_with('-'))
}

/// The length of the white space that a text begins with.
fn white(rest: &str) -> usize {
    rest.find(|next| !is_blank(next)).unwrap_or(rest.len())
}

/// The length of the sign of a reference: `&Vector3::z_axis()`, `&[1.0, 0.0]`.
fn reference(rest: &str) -> usize {
    let borrowed = rest.strip_prefix('&').unwrap_or_default();
    usize::from(borrowed.starts_with(|next: char| is_alphabetic(next) || next == '['))
}

/// The length of the comment that a text begins with.
///
/// Without the feature `whole` one with letters is no comment, since it may say something of the numbers: what
/// begins it has no meaning then.
fn comment(rest: &str) -> usize {
    let length = if let Some(inside) = rest.strip_prefix("/*") {
        inside.find("*/").map_or(0, |end| end + 4)
    } else if rest.starts_with("//") || rest.starts_with('#') || rest.starts_with("% ") {
        // With a space: `5%` is no comment but something that is not known here.
        rest.find('\n').unwrap_or(rest.len())
    } else {
        0
    };
    if cfg!(feature = "whole") || !rest[..length].contains(is_alphabetic) {
        length
    } else {
        0
    }
}

/// The comments in what stands between tokens.
pub(crate) fn comments_in(gap: &str) -> Vec<Span> {
    let mut found = Vec::new();
    let mut rest = gap;
    while let Some(character) = rest.chars().next() {
        let start = gap.len() - rest.len();
        let mut length = comment(rest);
        if length > 0 {
            found.push(Span::from(start..start + length));
        } else {
            length = character.len_utf8();
        }
        rest = &rest[length..];
    }
    found
}

/// The text with a space in place of each comment.
pub(crate) fn without_comments(text: &str) -> String {
    let mut rest = text;
    let mut bare = String::with_capacity(text.len());
    while let Some(character) = rest.chars().next() {
        let mut length = comment(rest);
        if length > 0 {
            bare.push(' ');
        } else {
            bare.push(character);
            length = character.len_utf8();
        }
        rest = &rest[length..];
    }
    bare
}

/// The drawn characters at the start of a text.
pub(crate) fn drawn_run(text: &str) -> &str {
    let end = text.find(|character| !is_drawn(character));
    &text[..end.unwrap_or(text.len())]
}

/// The length of a part of a frame that touches nothing. Where it only consists of dashes it must have its line for
/// itself, unless a corner or a branch begins it.
fn frame(rest: &str, text: &str) -> usize {
    let before = &text[..text.len() - rest.len()];
    let run = drawn_run(rest);
    let after = &rest[run.len()..];
    let stands_apart = before.chars().next_back().is_none_or(is_blank)
        && after.chars().next().is_none_or(is_blank);
    if run.is_empty() || !stands_apart {
        return 0;
    }
    let is_joint = |character| !is_drawn_dash(character) && !is_drawn_bar(character);
    if !run.contains(is_drawn_dash) || run.contains(is_joint) {
        return run.len();
    }
    let line_before = &before[before.rfind('\n').map_or(0, |newline| newline + 1)..];
    let line_after = &rest[..rest.find('\n').unwrap_or(rest.len())];
    let is_empty = |part: &str| part.chars().all(|c| is_drawn(c) || is_blank(c));
    if is_empty(line_before) && is_empty(line_after) {
        return line_after.len();
    }
    0
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
