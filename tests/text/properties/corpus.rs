//! Texts that nobody should write: those of the tests, changed in a few places.

use proptest::prelude::*;
use std::fs;

/// The files whose strings are texts that are read or refused.
const FILES: [&str; 12] = [
    "text/quaternions.rs",
    "text/notes.rs",
    "text/representations.rs",
    "text/euler_angles.rs",
    "text/misreadings.rs",
    "library/identify/answers.rs",
    "library/identify/questions.rs",
    "library/translate/mod.rs",
    "library/translate/ends.rs",
    "library/translate/mistakes.rs",
    "library/translate/axes.rs",
    "library/translate/lines.rs",
];

/// Longer ones take more time than they tell.
const LONGEST: usize = 400;

/// Pieces of what people type, in any order: most of it is wrong, some of it is right.
pub(crate) const PIECES: &[&str] = &[
    "0",
    "1",
    "0.5",
    "-",
    "+",
    "*",
    "/",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ";",
    ":",
    "=",
    " ",
    "\n",
    "i",
    "j",
    "k",
    "w",
    "x",
    "y",
    "z",
    "qw",
    "sqrt",
    "√",
    "cos(",
    "pi",
    "1e308",
    "1e-308",
    "5e-324",
    "nan",
    "inf",
    "°",
    "deg",
    "🙂",
    "\"",
    "'",
    "#",
    "//",
    "---",
    "- ",
    "½",
    "e",
    ".",
    "Eigen::Quaterniond(",
    "from_quat(",
    "scalar_first=True",
    "np.array(",
    "−",
    "1.7e308",
    " about ",
    "axis-angle ",
    "angle=",
    "rotvec ",
    "rpy ",
    "ZYX ",
    "xyz ",
    "3-2-1 ",
    "euler ",
    "matrix ",
    "rad",
    " 1 0 0",
    "AngleAxisd(",
    "from_euler('zyx', ",
    "\r\n",
    "\t",
    "\u{a0}",
    "\u{200b}",
    "\u{feff}",
    "\u{2500}",
    "│",
    "┌",
    "Float32Array(4) [",
    "Mat3(9) [",
    "sqrt(2) [",
    "1e999",
    "-0",
    "0x1F",
    "0,5",
    "％",
    "１",
    "é",
    "\\",
    "/*",
    "*/",
    "turns",
    "q_inv ",
    "R.T ",
    "column_major ",
    "% ",
    "\u{301}",
    "degrees=True",
    "w: ",
    "roll=",
    "[[",
    "]]",
    "1/",
    "°/s",
    "gibbs ",
    "mrp ",
    "---\n",
    "\n- ",
];

/// The inputs of `text/problems/` and the strings of the tests about reading.
pub(crate) fn corpus() -> Vec<String> {
    let folder = format!("{}/tests", env!("CARGO_MANIFEST_DIR"));
    let read = |path: &std::path::Path| fs::read_to_string(path).expect("a readable file");
    let mut texts = Vec::new();
    for entry in fs::read_dir(format!("{folder}/text/problems")).expect("the folder") {
        let path = entry.expect("an entry").path();
        let file = read(&path);
        let (input, _) = file.split_once("\n---\n").expect("a line ---");
        let directive = |text: &&str| text.starts_with('@');
        let (_, input) = input
            .split_once('\n')
            .filter(|(first, _)| directive(first))
            .unwrap_or(("", input));
        texts.push(input.to_owned());
    }
    for file in FILES {
        texts.extend(strings(&read(format!("{folder}/{file}").as_ref())));
    }
    texts.retain(|text| text.len() <= LONGEST);
    texts.sort();
    texts.dedup();
    texts
}

/// The strings of a Rust file, without what stands in comments.
fn strings(source: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = source;
    while let Some(at) = rest.find(['"', '/', '\'']) {
        let before = &rest[..at];
        let tail = &rest[at..];
        rest = if tail.starts_with("//") {
            tail.split_once('\n').map_or("", |(_, next)| next)
        } else if tail.starts_with("'\"'") || tail.starts_with("'\\") {
            &tail[3..]
        } else if let Some(tail) = tail.strip_prefix('"') {
            let hashes = before.len() - before.trim_end_matches('#').len();
            let is_raw = before[..before.len() - hashes].ends_with('r');
            let (text, next) = if is_raw {
                let end = format!("\"{}", "#".repeat(hashes));
                let (text, next) = tail.split_once(&end).expect("an end");
                (text.to_owned(), next)
            } else {
                unescaped(tail)
            };
            found.push(text);
            next
        } else {
            &tail[1..]
        };
    }
    found
}

/// The text up to the closing quote, and what follows it.
fn unescaped(tail: &str) -> (String, &str) {
    let mut text = String::new();
    let mut marks = tail.chars();
    while let Some(mark) = marks.next() {
        match mark {
            '"' => break,
            '\\' => match marks.next() {
                Some('n') => text.push('\n'),
                Some('t') => text.push('\t'),
                Some('r') => text.push('\r'),
                Some('0') => text.push('\0'),
                Some('u') => {
                    let code: String = marks
                        .by_ref()
                        .skip(1)
                        .take_while(|&mark| mark != '}')
                        .collect();
                    let code = u32::from_str_radix(&code, 16).expect("a code point");
                    text.push(char::from_u32(code).expect("a character"));
                }
                Some('\n') => {
                    let next = marks.as_str().trim_start();
                    marks = next.chars();
                }
                Some(other) => text.push(other),
                None => break,
            },
            other => text.push(other),
        }
    }
    (text, marks.as_str())
}

/// What is done to a text in one place.
#[derive(Clone, Copy, Debug)]
enum Edit {
    Insert(&'static str),
    Remove,
    Replace(&'static str),
    Repeat,
    Exchange,
}

/// The text changed in up to three places; now and then as it is.
pub(crate) fn changed(text: &str) -> impl Strategy<Value = String> + use<> {
    let marks: Vec<char> = text.chars().collect();
    let edit = prop_oneof![
        4 => prop::sample::select(PIECES).prop_map(Edit::Insert),
        2 => Just(Edit::Remove),
        3 => prop::sample::select(PIECES).prop_map(Edit::Replace),
        1 => Just(Edit::Repeat),
        1 => Just(Edit::Exchange),
    ];
    let place = (any::<prop::sample::Index>(), any::<prop::sample::Index>());
    prop::collection::vec((edit, place), 0..4).prop_map(move |edits| {
        let mut marks = marks.clone();
        for (edit, (one, other)) in edits {
            let (one, other) = (one.index(marks.len() + 1), other.index(marks.len() + 1));
            let range = one.min(other)..one.max(other).min(one.min(other) + 8);
            match edit {
                Edit::Insert(piece) => drop(marks.splice(one..one, piece.chars())),
                Edit::Remove => drop(marks.drain(range)),
                Edit::Replace(piece) => drop(marks.splice(range, piece.chars())),
                Edit::Repeat => {
                    let again = marks[range].to_vec();
                    drop(marks.splice(other..other, again));
                }
                Edit::Exchange if one < marks.len() && other < marks.len() => {
                    marks.swap(one, other);
                }
                Edit::Exchange => {}
            }
        }
        marks.into_iter().collect()
    })
}
