//! What is said of numbers outside of their name: behind them in their line, and in the code above that printed
//! them.

use crate::character::{is_alphabetic, is_alphanumeric, is_capital, is_digit, is_of_name};
use crate::problem::Span;
use crate::text::record::scan::lexemes::prompt;
use crate::text::vocabulary::labels::is_derived;

/// What is said behind numbers that end there, up to the next name or number: `(scalar last)`, `# xyzw`.
pub(crate) fn remark_behind(text: &str, end: usize) -> Span {
    let rest = text.get(end..).unwrap_or("");
    let line = &rest[..rest.find('\n').unwrap_or(rest.len())];
    // What closes the numbers says nothing.
    let inside =
        line.trim_start_matches(|mark: char| mark.is_whitespace() || ")]}>,;\"'".contains(mark));
    let start = end + line.len() - inside.len();
    Span::from(start..start + length_of_remark(inside))
}

/// How much of the rest of a line is a remark: a comment is one to its end; the name of other numbers is none.
fn length_of_remark(line: &str) -> usize {
    let mut before = ' ';
    // Where what may be a name begins.
    let mut name = 0;
    for (at, mark) in line.char_indices() {
        if begins_comment(&line[at..]) && !is_alphanumeric(before) {
            return line.len();
        }
        let is_number = is_digit(mark) && !is_of_name(before);
        if is_number || "[{<:=\"".contains(mark) {
            return name;
        }
        if ",;)|".contains(mark) {
            name = at + mark.len_utf8();
        }
        before = mark;
    }
    line.len()
}

/// Whether a text begins with the mark of a comment in any language.
fn begins_comment(text: &str) -> bool {
    ["#", "//", "--", "/*", "%"]
        .iter()
        .any(|mark| text.starts_with(mark))
}

/// How many lines above numbers are looked at.
const MOST_LINES: usize = 5;

/// The line of code above numbers that printed them, where it is one: typed at a prompt, or a call with nothing to
/// be named by it.
pub(crate) fn code_above(text: &str, start: usize) -> Option<Span> {
    let mut end = text[..start].rfind('\n')?;
    for _ in 0..MOST_LINES {
        let begin = text[..end].rfind('\n').map_or(0, |at| at + 1);
        let line = text[begin..end].trim();
        let is_code = is_typed(line)
            || (line.contains(['(', '\'']) || line.ends_with(".T"))
                && !line.ends_with([':', '=', ',']);
        if is_code && !is_array(line) {
            return Some(Span::from(begin..end));
        }
        // Other numbers.
        let first = line.trim_start_matches(['[', '(', '-', ' ']);
        if first.starts_with(is_digit) || begin == 0 {
            return None;
        }
        end = begin - 1;
    }
    None
}

/// `3×3 Matrix{Float64}:`, `array([`: what a console prints before numbers.
fn is_array(line: &str) -> bool {
    line.ends_with(['(', '[', ',']) && !is_typed(line)
}

/// Whether a line begins with a prompt: `>>> `, `> `, `In [3]:`, `julia> `, `octave:3> `.
fn is_typed(line: &str) -> bool {
    let first = line.split(' ').next().unwrap_or("");
    let is_prompt = first.ends_with('>') && !first.starts_with('<');
    is_prompt && line.len() > first.len() || line.starts_with("In") && prompt(line) > 0
}

/// What a line of code makes of its matrix or quaternion, by its calls and marks.
pub(crate) fn made_by_code(line: &str) -> Option<&'static str> {
    let mut end = 0;
    for name in line.split(|mark| !is_of_name(mark)) {
        end += name.len();
        let is_call = line[end..].starts_with('(');
        match name {
            "t" if is_call && is_typed(line) => return Some("a transpose"),
            "adjoint" | "ctranspose" if is_call => return Some("a transpose"),
            "T" if line[..end].ends_with(".T") => return Some("a transpose"),
            "solve" | "pinv" | "invert" if is_call => return Some("an inverse"),
            "svd" | "eig" | "eigh" | "qr" | "lu" | "chol" | "cholesky" | "pca" | "expm"
            | "logm"
                if is_call =>
            {
                return Some("another matrix");
            }
            "components_" | "eigenvectors" => return Some("another matrix"),
            "getDifferenceQuaternion" => return Some("a difference"),
            _ if name.len() > 1 && is_derived(name) => return Some("an inverse or a transpose"),
            _ => {}
        }
        end += line[end..].chars().next().map_or(0, char::len_utf8);
    }
    is_transposed(line).then_some("a transpose")
}

/// `R'`, `rotm2quat(R')`: a quote that no other one closes, behind a name or a bracket and before none.
fn is_transposed(line: &str) -> bool {
    let mut quotes = line.match_indices('\'');
    let (Some((at, _)), None) = (quotes.next(), quotes.next()) else {
        return false;
    };
    line[..at].ends_with(|last: char| is_alphanumeric(last) || last == ')')
        && !line[at + 1..].starts_with(is_alphanumeric)
}

/// What the remark behind numbers says that is no word of a label: `rad/s`, `m`, `+ eps …`.
pub(crate) fn made_by_remark(remark: &str) -> Option<&'static str> {
    let words = remark.trim_end_matches(['.', ')', ' ']);
    match words {
        _ if words.contains("/s") => Some("a rate or a derivative"),
        _ if words.starts_with("eps") || words.starts_with('ε') => Some("a dual quaternion"),
        "m" | "mm" | "cm" | "meters" | "metres" => Some("a length"),
        _ if words.starts_with(['+', '*', '×', '⊗', '·']) => Some("a sum or a product"),
        _ => None,
    }
}

/// What the code above the first numbers of a text makes of what they are.
pub(crate) fn made_above(text: &str) -> Option<(Span, &'static str)> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let first = line.trim_start_matches(|mark| !is_digit(mark));
        let at = start + line.len() - first.len();
        let before = line[..line.len() - first.len()].chars().next_back();
        let is_number = !first.is_empty() && before.is_none_or(|before| !is_of_name(before));
        if is_number && !is_typed(line.trim()) {
            let code = code_above(text, at)?;
            return Some((code, made_by_code(&text[code.start..code.end])?));
        }
        start += line.len();
    }
    None
}

/// A label with marks that say that it names something made of others, and what: `q⁻¹`, `R^T`, `q1 - q2`, `2q`.
///
/// Of a long block it need not be the label of the rotation.
pub(crate) fn marked_label(text: &str) -> Option<(Span, &'static str)> {
    if text.lines().count() > MOST_LABELS {
        return None;
    }
    let mut start = 0;
    for line in text.split('\n') {
        // A comment is told of more than one label.
        let is_comment = begins_comment(line.trim_start());
        let end = line.find(['=', ':']).filter(|_| !is_comment);
        if let Some(label) = line.get(..end.unwrap_or(0))
            && let Some(what) = made_by_marks(
                label
                    .trim()
                    .trim_start_matches(['>', ' ', '"'])
                    .trim_end_matches('"'),
            )
        {
            let begin = start + label.len() - label.trim_start().len();
            return Some((Span::from(begin..begin + label.trim().len()), what));
        }
        start += line.len() + 1;
    }
    None
}

/// How many lines a text has at most of which every label is looked at.
const MOST_LABELS: usize = 8;

/// The longest label that is a formula, in bytes.
const LONGEST_FORMULA: usize = 24;

fn made_by_marks(label: &str) -> Option<&'static str> {
    // What stands inside of something else, or of a comment, is none.
    if label.is_empty() || label.len() > LONGEST_FORMULA || label.contains(['{', '"', '#', '/']) {
        return None;
    }
    let has = |marks: &[&str]| marks.iter().any(|mark| label.contains(mark));
    let is_name = |name: &str| name.starts_with(is_alphabetic) && name.chars().all(is_of_name);
    let bare = label.trim_end_matches(['*', '\'']);
    if has(&["⁻", "^-1", "^{-1}", "^(-1)"]) {
        return Some("an inverse");
    }
    // `q'` may be another one than q.
    let is_matrix = bare.starts_with(is_capital);
    if has(&["^T", "^t", "^{T}", "^H"]) || (label.ends_with('\'') && is_name(bare) && is_matrix) {
        return Some("a transpose");
    }
    if has(&["†", "‡", "^*", "\u{304}", "\u{305}"]) || (label.ends_with('*') && is_name(bare)) {
        return Some("a conjugate");
    }
    if has(&["\u{307}", "\u{308}", "∂", "∇"]) {
        return Some("a rate or a derivative");
    }
    if label.starts_with('σ') {
        return Some("a variance, a noise or a bias");
    }
    if has(&["⊗", "⊙", "∘"]) {
        return Some("a product");
    }
    // `2q`, not `3x3`
    let factor = label.trim_start_matches(is_digit);
    if factor.len() < label.len() && matches!(factor, "q" | "Q" | "R") {
        return Some("a multiple");
    }
    // `fx, fy, cx, cy = …`
    let names: Vec<&str> = label.split(',').map(str::trim).collect();
    if names.len() == 4 && names.iter().all(|name| is_name(name)) {
        let mut letters = String::new();
        for name in names {
            letters.push_str(name.trim_start_matches(['q', 'Q', '_']));
        }
        return match letters.to_ascii_lowercase().as_str() {
            "wxyz" | "xyzw" | "0123" | "1234" | "rijk" | "ijkr" => None,
            _ => Some("other quantities"),
        };
    }
    // `q1 - q2`
    let mut parts = label.split(' ');
    let (one, sign, other) = (parts.next()?, parts.next()?, parts.next()?);
    let is_formula = matches!(sign, "-" | "+" | "*" | "−" | "·") && parts.next().is_none();
    (is_formula && is_name(one) && is_name(other)).then_some("a sum or a product")
}
