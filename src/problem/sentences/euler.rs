//! The sentences of problems of Euler sequences and of their frames.

use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::problem::fault::Fault;
use crate::problem::{ProblemCode, QUOTED_CHARACTERS, Span, shorten};

impl Fault {
    pub(crate) fn no_sequence(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            "nothing says about which axes these angles turn, and in which order",
            "a sequence of three axes: capitals for axes that move (ZYX), small letters for fixed \
             ones (xyz)",
            "write ZYX 30deg 20deg 10deg, or roll=10deg pitch=20deg yaw=30deg",
        )
    }

    pub(crate) fn sequence_or_number(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            "this is the first number of a quaternion, or the sequence of three Euler angles",
            "a sequence with dashes, or a word before the numbers",
            "write 3-2-1 30 20 10 for the angles, quaternion 321 30 20 10 for the four numbers",
        )
    }

    pub(crate) fn unknown_sequence(span: Span, written: &str) -> Self {
        let letters: Vec<char> = written
            .chars()
            .filter(|mark| mark.is_alphanumeric())
            .collect();
        let follows_itself = letters
            .windows(2)
            .any(|pair| pair[0].eq_ignore_ascii_case(&pair[1]));
        let is_mixed = letters.iter().any(char::is_ascii_lowercase)
            && letters.iter().any(char::is_ascii_uppercase);
        let written = shorten(written, QUOTED_CHARACTERS);
        let (message, hint) = match (letters.len(), follows_itself, is_mixed) {
            (3, true, _) => (
                format!(
                    "{written} is no Euler sequence: an axis follows itself, so two of its turns are one"
                ),
                "write the sequence that is meant, such as ZYX or ZXZ",
            ),
            (3, false, true) => (
                format!(
                    "{written} has capitals and small letters, so it does not say whether its axes move"
                ),
                "write ZYX for axes that move (intrinsic), or zyx for fixed ones (extrinsic)",
            ),
            _ => (
                format!("{written} is no Euler sequence"),
                "write a sequence such as ZYX, zyx or 3-2-1",
            ),
        };
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            message,
            "three axes, none after itself",
            hint,
        )
    }

    pub(crate) fn contradicting_frame(span: Span, written: &str) -> Self {
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            format!("{written} says by its first letter the opposite of the word beside it"),
            "s for static (extrinsic) axes, r for rotating (intrinsic) ones, or the word alone",
            "remove the letter or the word",
        )
    }

    pub(crate) fn frame_against_name(span: Span, named: EulerSequence) -> Self {
        let (name, letters, frame) = match named.frame {
            EulerFrame::Extrinsic => ("rpy", "intrinsic xyz", "fixed axes, x and y and z"),
            EulerFrame::Intrinsic => ("ypr", "extrinsic zyx", "moving axes, z and y and x"),
        };
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            format!("{name} means turns about {frame}, and the word beside it says the opposite"),
            "a sequence in letters after a word for the frame",
            format!("write {letters} if that is what is meant, or {name} alone"),
        )
    }

    pub(crate) fn frame_without_sequence(span: Span) -> Self {
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            "this says whether the axes move, and nothing says in which order the angles turn",
            "a sequence of three axes beside the word",
            "write extrinsic xyz or intrinsic zyx; roll, pitch and yaw without a word mean these two, \
             which are the same",
        )
    }

    pub(crate) fn sequence_of_two_axes(span: Span, written: &str) -> Self {
        let written = shorten(written, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            format!(
                "{written} turns twice about one axis, and roll, pitch and yaw are about three"
            ),
            "a sequence with three different axes, or angles without these names",
            format!("write the angles in the order of the axes: {written} 10deg 20deg 30deg"),
        )
    }

    pub(crate) fn sequence_of_named_angles(span: Span, written: &str) -> Self {
        let written = shorten(written, QUOTED_CHARACTERS);
        Self::new(
            ProblemCode::UnknownSequence,
            span,
            format!(
                "beside roll, pitch and yaw {written} does not say whether its axes move, and the \
                 names alone mean fixed x, y, z (the same as moving z, y, x)"
            ),
            "a word that says whether the axes move, or none of a sequence",
            format!(
                "write intrinsic {written}: or extrinsic {written}: before them, or the names alone"
            ),
        )
    }
}
