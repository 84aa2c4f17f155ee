//! What a text says that may be said of the numbers that were read, and was not used.

use crate::analyze::attitude::Attitude;
use crate::character::{begins_name, is_alphabetic, is_digit, is_of_name};
use crate::contract::{Fact, Form, SaidElsewhere};
use crate::convention::Direction;
use crate::problem::{Span, shorten};
use crate::text::{LabelWord, comments_of, meanings_of};

/// How much of a line a note repeats, in characters.
const LONGEST_LINE: usize = 60;

/// How long a name before numbers is at most, in bytes; what is longer is prose.
const LONGEST_NAME: usize = 34;

/// Parts of words, in small letters, that say of numbers that they are not those of the rotation itself. Where they
/// are known to be said of them, the numbers are refused.
const SAYING: [(&str, &str); 34] = [
    ("invers", "an inverse"),
    ("inverted", "an inverse"),
    ("invert(", "an inverse"),
    (".inv()", "an inverse"),
    ("q^-1", "an inverse"),
    ("r^-1", "an inverse"),
    ("<sup>-1", "an inverse"),
    ("逆", "an inverse"),
    ("братн", "an inverse"),
    ("conjug", "a conjugate"),
    ("conj(", "a conjugate"),
    ("konjug", "a conjugate"),
    ("transpos", "a transpose"),
    ("transponi", "a transpose"),
    ("<sup>t<", "a transpose"),
    ("转置", "a transpose"),
    ("転置", "a transpose"),
    ("ранспонир", "a transpose"),
    ("slerp", "a rotation between two"),
    ("multiply", "a factor of a product"),
    ("composerot", "a factor of a product"),
    ("+ frotator", "a part of a sum"),
    ("addactor", "an increment"),
    ("addlocal", "an increment"),
    (".rotate(", "an increment"),
    ("handedness: left", "left-handed axes"),
    ("lefthand", "left-handed axes"),
    ("valid: false", "not valid"),
    ("essential matrix", "another matrix"),
    ("世界坐标系到相机", "world to camera"),
    ("monde vers", "world to camera"),
    ("rows = body", "a transpose"),
    ("rows are", "a transpose"),
    ("cut off", "cut off"),
];

/// The same of what is named, in the heading of numbers or in a text of one line.
const NAMING: [(&str, &str); 12] = [
    ("limit", "a limit"),
    ("tolerance", "a tolerance"),
    ("accuracy", "an accuracy"),
    ("resolution", "a resolution"),
    ("trim", "a trim"),
    ("error", "an error"),
    ("difference", "a difference"),
    ("delta", "a difference"),
    ("off by", "a difference"),
    ("changed by", "a difference"),
    ("ang vel", "a rate"),
    ("max (", "a limit"),
];

/// The first line that may be said of the numbers and was not used.
pub(crate) fn said_elsewhere(text: &str, attitude: &Attitude) -> Option<Fact> {
    // Numbers alone, of which most texts are, say nothing.
    if !text.contains(is_alphabetic) {
        return None;
    }
    let is_one_line = !text.trim().contains('\n');
    // What comments say is used, or the numbers are refused.
    let mut bare = text.to_owned();
    for comment in comments_of(text) {
        let Span { start, end } = comment.span;
        bare.replace_range(start..end, &" ".repeat(end - start));
    }
    for line in bare.lines() {
        let line = line.trim();
        if line.starts_with('%') || line.starts_with("--") {
            continue;
        }
        if let Some(what) = said(line, is_one_line, attitude) {
            return Some(Fact::SaidElsewhere(SaidElsewhere {
                words: shorten(line, LONGEST_LINE),
                what: what.to_owned(),
            }));
        }
    }
    None
}

fn said(line: &str, is_one_line: bool, attitude: &Attitude) -> Option<&'static str> {
    let lower = line.to_ascii_lowercase();
    if is_product(line, &lower) {
        return Some("a product");
    }
    let is_transposed = line.ends_with(".T") || line.contains(".T ") || line.contains(".T)");
    if is_transposed {
        return Some("a transpose");
    }
    // A solver of robots, and its log level.
    let is_of_robot = lower.contains("inverse kinematic") || lower.contains("inverse_kinematic");
    let name = line.find(is_digit).unwrap_or(line.len());
    let is_name =
        name < LONGEST_NAME && (is_one_line && !line.starts_with('[') || line.ends_with(':'));
    let naming: &[_] = if is_name { &NAMING } else { &[] };
    for (part, what) in SAYING.iter().chain(naming) {
        if lower.contains(part) && !is_of_robot {
            return Some(what);
        }
    }
    let convention = attitude.tagged.convention;
    let used = match attitude.form {
        Form::Quaternion => convention.operator(),
        Form::Matrix(read) => read.convention.operator(),
        _ => Direction::BodyToWorld,
    };
    let plain = without_fillers(&lower);
    for word in meanings_of(&plain) {
        match word {
            LabelWord::LeftHanded => return Some(word.in_words()),
            LabelWord::Direction(told) if told != used => return Some(word.in_words()),
            LabelWord::Handedness(told) if told != convention.handedness => {
                return Some(word.in_words());
            }
            _ => {}
        }
    }
    None
}

/// `from the world frame -> the body frame` as `from world to body`.
fn without_fillers(line: &str) -> String {
    let mut plain = String::new();
    for word in line.split([' ', '-', '(', ')']) {
        match word {
            "the" | "frame" | "frames" | "" => continue,
            ">" | "→" => plain.push_str("to"),
            word => plain.push_str(word),
        }
        plain.push(' ');
    }
    plain
}

/// Whether a line multiplies by what has no numbers in it: `q1 * q2`, `R_z @ np.array(…)`, or goes on with a factor;
/// `lower` is the line in small letters.
fn is_product(line: &str, lower: &str) -> bool {
    // Looked for once, however many signs a line has.
    let last = |part: &str| lower.rfind(part);
    let last_turn = last("axis").max(last("axang"));
    let last_call = last("::").max(last("("));
    for (at, mark) in line.char_indices() {
        if !matches!(mark, '*' | '@' | '⊗') {
            continue;
        }
        let (before, after) = (&line[..at], &line[at + mark.len_utf8()..]);
        let is_spaced = before.ends_with(' ') == after.starts_with(' ') || before.is_empty();
        let first = after.trim_start();
        if !is_spaced || !first.starts_with(begins_name) {
            continue;
        }
        let name = before.trim_end().rsplit(|mark| !is_of_name(mark)).next();
        let is_name = name.is_some_and(|name| name.starts_with(is_alphabetic));
        let place = Some(line.len() - first.len());
        // Turns about axes one after the other are read as what they make; `* item` is a list.
        let (is_turn, is_call) = (last_turn >= place, last_call >= place);
        if !is_turn && (is_name || before.is_empty() && is_call) {
            return true;
        }
    }
    false
}
