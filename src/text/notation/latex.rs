//! LaTeX: matrices, transposes that only make a row a column, powers of ten, letters and spaces.

/// What LaTeX writes and nothing else does.
const MARKS: [&str; 6] = ["\\begin{", "\\math", "\\quad", "\\,", "\\times", "\\left"];

/// What is written for what; what is not here stays, and no backslash is read.
const WRITTEN: &[(&str, &str)] = &[
    ("\\begin{bmatrix}", "["),
    ("\\begin{pmatrix}", "["),
    ("\\begin{matrix}", "["),
    ("\\begin{array}{c}", "["),
    ("\\begin{array}{ccc}", "["),
    ("\\begin{array}{cccc}", "["),
    ("\\begin{array}{rrr}", "["),
    ("\\end{bmatrix}", "]"),
    ("\\end{pmatrix}", "]"),
    ("\\end{matrix}", "]"),
    ("\\end{array}", "]"),
    ("\\\\", ";"),
    ("&", ","),
    ("\\left", ""),
    ("\\right", ""),
    ("\\mathbf", ""),
    ("\\mathrm", ""),
    ("\\boldsymbol", ""),
    ("\\hat", ""),
    ("\\vec", ""),
    ("C(q) v =", "v ="),
    ("R(q) v =", "v ="),
    ("\\theta u =", "rotvec ="),
    ("u = \\begin{bmatrix}", "axis = ["),
    ("\\theta", "angle"),
    ("\\bar{q}", "q_bar"),
    ("\\quad", ""),
    ("\\,", ""),
    ("\\;", ""),
    ("\\!", ""),
    ("\\[", ""),
    ("\\]", ""),
    ("$", ""),
    ("_{", ""),
    ("{", ""),
    ("}", ""),
];

/// What was done with what stands on the left: a transpose, and what makes another rotation of it.
const POWERS: [&str; 9] = [
    "^{\\mathsf{T}}",
    "^{\\mathrm{T}}",
    "^{\\top}",
    "^{T}",
    "^\\top",
    "^T",
    "^{*}",
    "^{-1}",
    "^*",
];

/// How many of the powers are a transpose.
const TRANSPOSES: usize = 6;

/// A factor of powers of ten.
const TEN: [&str; 2] = [" \\times 10^{", " \\cdot 10^{"];

/// The text without LaTeX, byte by byte in place; `None` where it is none.
pub(super) fn of_latex(text: &str) -> Option<String> {
    if !MARKS.iter().any(|mark| text.contains(mark)) {
        return None;
    }
    // Then the numbers are those of what stands on the left, whatever it was made of.
    let tells_direction =
        text.starts_with('%') && (text.contains(" to world") || text.contains(" to body"));
    let mut bare = String::with_capacity(text.len());
    let mut matrix = 0;
    let mut last = None;
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let begins = |from: &&&str| rest.starts_with(**from);
        let mut length = first.len_utf8();
        let mut written = &rest[..length];
        let mut known = WRITTEN.iter().filter(|_| "\\&${}_uCR".contains(first));
        if let Some((from, to)) = known.find(|(from, _)| rest.starts_with(from)) {
            (length, written) = (from.len(), to);
            if to.ends_with('[') {
                matrix = bare.len();
            }
        } else if let Some(ten) = TEN.iter().find(begins) {
            let power = rest[ten.len()..].split('}').next()?;
            bare.push('e');
            (length, written) = (ten.len() + power.len(), power);
        } else if let Some(at) = POWERS.iter().position(|power| rest.starts_with(power)) {
            let is_of_matrix = last == Some(']');
            let has_lines = bare[matrix..].contains(';') && bare[matrix..].contains(',');
            length = POWERS[at].len();
            written = match () {
                () if is_of_matrix && at < TRANSPOSES && !has_lines => "",
                () if !is_of_matrix && tells_direction => "",
                () => "^",
            };
            matrix = bare.len();
            last = None;
        }
        last = written.trim_end().chars().last().or(last);
        bare.push_str(written);
        rest = &rest[length..];
        pad(&mut bare, text.len() - rest.len());
    }
    Some(bare)
}

/// Spaces as far as a place of the text.
pub(super) fn pad(bare: &mut String, end: usize) {
    while bare.len() < end {
        bare.push(' ');
    }
}
