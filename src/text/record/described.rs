//! What a comment or a setting says that a list of three numbers is.

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::convention::order::ComponentOrder;
use crate::text::vocabulary::comments_of;
use crate::text::vocabulary::constructors::order_in_name;
use crate::text::vocabulary::labels::words_of;

/// What three numbers are, whose name says nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Described {
    Euler(EulerSequence),
    RotationVector,
}

impl Described {
    /// What a comment says that begins with the name of a description, and its unit: `# Euler angles ZYX in
    /// radians`, `// rotation vector, degrees`.
    pub(crate) fn by_comment(text: &str) -> Option<(Self, Option<AngleUnit>)> {
        for name in ["Euler angles ", "rotation vector"] {
            let Some((before, after)) = text.split_once(name) else {
                continue;
            };
            if !before.trim_end().ends_with(['#', '/', '%', '*']) {
                continue;
            }
            let words = words_of(after.lines().next()?);
            let unit = words.iter().find_map(|word| AngleUnit::named(word));
            let described = match name {
                "rotation vector" => Self::RotationVector,
                _ => Self::Euler(sequence(words.first()?, &words)?),
            };
            return Some((described, unit));
        }
        None
    }
}

/// The order of four components that a comment tells by their letters: `% q: x y z w`.
pub(crate) fn order_by_comment(text: &str) -> Option<ComponentOrder> {
    for comment in comments_of(text) {
        let mut letters = String::new();
        for word in words_of(comment.text) {
            if word.len() == 1 && "wxyz".contains(word) {
                letters.push_str(word);
            }
        }
        if letters.len() == 4 {
            return order_in_name(&letters);
        }
    }
    None
}

/// The sequence of these letters, whose axes move or stay as a word says, or else as in `SciPy`.
pub(crate) fn sequence(letters: &str, words: &[&str]) -> Option<EulerSequence> {
    let sequence: EulerSequence = letters.parse().ok()?;
    let frame = match () {
        () if words.contains(&"intrinsic") => EulerFrame::Intrinsic,
        () if words.contains(&"extrinsic") => EulerFrame::Extrinsic,
        () => sequence.frame,
    };
    Some(EulerSequence { frame, ..sequence })
}
