//! The sentences of problems of Euler sequences and of their frames.

use crate::character::is_alphanumeric;
use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::problem::fault::{Fault, Words};
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, shorten};

impl Fault {
    pub(crate) fn no_sequence(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            "the axes of these angles and their order are missing",
            "a sequence: capitals for moving axes (ZYX), small letters for fixed axes (xyz)",
            "write ZYX 30deg 20deg 10deg, or roll=10deg pitch=20deg yaw=30deg",
        )
    }

    pub(crate) fn sequence_or_number(span: Span) -> Self {
        Self::new(
            ProblemCode::TwoMeanings,
            span,
            "this may be the first number of a quaternion, or an Euler sequence",
            "a sequence with dashes, or a word before the numbers",
            "write 3-2-1 30 20 10 for angles, quaternion 321 30 20 10 for four numbers",
        )
    }

    pub(crate) fn unknown_sequence(span: Span, written: &str) -> Self {
        Self::told(ProblemCode::UnknownSequence, span, || {
            let letters: Vec<char> = written
                .chars()
                .filter(|mark| is_alphanumeric(*mark))
                .collect();
            let follows_itself = letters
                .windows(2)
                .any(|pair| pair[0].eq_ignore_ascii_case(&pair[1]));
            let is_mixed = letters.iter().any(char::is_ascii_lowercase)
                && letters.iter().any(char::is_ascii_uppercase);
            let written = shorten(written, QUOTED_CHARACTERS);
            let (message, hint) = match (letters.len(), follows_itself, is_mixed) {
                (3, true, _) => (
                    format!("{written} is not an Euler sequence: one axis twice in a row"),
                    "write the sequence you mean, such as ZYX or ZXZ",
                ),
                (3, false, true) => (
                    format!(
                        "{written} mixes capitals (moving axes) and small letters (fixed axes)"
                    ),
                    "write ZYX for moving axes (intrinsic), or zyx for fixed axes (extrinsic)",
                ),
                _ => (
                    format!("{written} is not an Euler sequence"),
                    "write a sequence such as ZYX, zyx or 3-2-1",
                ),
            };
            Words::new(message, "three axes, no two equal in a row", hint)
        })
    }

    pub(crate) fn contradicting_frame(span: Span, written: &str) -> Self {
        Self::told(ProblemCode::UnknownSequence, span, || {
            Words::new(
                format!("the first letter of {written} contradicts the word beside it"),
                "s for static (extrinsic) axes, r for rotating (intrinsic) axes, or the word alone",
                "remove the letter or the word",
            )
        })
    }

    pub(crate) fn frame_against_name(span: Span, named: EulerSequence) -> Self {
        Self::told(ProblemCode::UnknownSequence, span, || {
            let (name, letters, frame) = match named.frame {
                EulerFrame::Extrinsic => ("rpy", "intrinsic xyz", "fixed axes x, y, z"),
                EulerFrame::Intrinsic => ("ypr", "extrinsic zyx", "moving axes z, y, x"),
            };
            Words::new(
                format!("{name} means {frame}, which contradicts the word beside it"),
                "a sequence in letters after this word",
                format!("write {letters} if that is what you mean, or {name} alone"),
            )
        })
    }

    pub(crate) fn frame_without_sequence(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            "the order of the axes is missing",
            "a sequence of three axes beside this word",
            "write extrinsic xyz or intrinsic zyx (the same), or remove the word",
        )
    }

    pub(crate) fn sequence_of_two_axes(span: Span, written: &str) -> Self {
        Self::told(ProblemCode::UnknownSequence, span, || {
            let written = shorten(written, QUOTED_CHARACTERS);
            Words::new(
                format!("{written} has one axis twice, but roll, pitch and yaw have three axes"),
                "a sequence of three different axes, or angles without these names",
                format!("write the angles in the order of the axes: {written} 10deg 20deg 30deg"),
            )
        })
    }

    pub(crate) fn sequence_of_named_angles(span: Span, written: &str) -> Self {
        Self::told(ProblemCode::UnknownSequence, span, || {
            let written = shorten(written, QUOTED_CHARACTERS);
            Words::new(
                format!("with roll, pitch and yaw, {written} does not say whether its axes move"),
                "a word that says it, or the names alone (fixed axes x, y, z)",
                format!("write intrinsic {written}: or extrinsic {written}: before them"),
            )
        })
    }
}
