//! The words before the numbers: which description of a rotation they announce, its sequence, its unit.

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::description::label::OtherLabel;
use crate::text::grammar::lex::{Token, TokenKind};
use crate::text::grammar::tree::Key;
use crate::text::vocabulary::phrases::{
    Form, Phrase, Said, digits_ahead, euler_sequence, is_mark, is_name, is_sequence, phrase_ahead,
    sequence_in_name,
};

/// The words before the numbers.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Announcement<'t> {
    pub(crate) form: Option<Form>,
    pub(crate) frame: Option<EulerFrame>,
    pub(crate) sequence: Option<Sequence<'t>>,
    pub(crate) unit: Option<AngleUnit>,
    /// Whether another unit than that is written as well.
    pub(crate) has_two_units: bool,
    /// A label that names something else than a rotation.
    pub(crate) other: Option<OtherLabel<'t>>,
    pub(crate) span: Span,
}

/// The axes of Euler angles: as their usual name has them, or as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sequence<'t> {
    Named(EulerSequence),
    Written(&'t str, Span),
    /// In a name, as in `euler_xyz`, where small letters may only be the style of names.
    InName(&'t str, Span),
}

/// The word in a label behind an announcement that would change its numbers: `rotvec in degrees: …`.
pub(crate) fn telling_label<'t>(tokens: &[Token<'t>]) -> Option<Token<'t>> {
    const CHANGES: [&str; 17] = [
        "arcmin",
        "arcsec",
        "clockwise",
        "cw",
        "grad",
        "half",
        "left",
        "minus",
        "mrad",
        "neg",
        "negative",
        "not",
        "rev",
        "shadow",
        "turn",
        "turns",
        "unit",
    ];
    let label = &tokens[..tokens.iter().position(|token| is_mark(Some(token)))?];
    let is_label = label.iter().all(is_name);
    let mut words = label.iter().filter(|_| is_label);
    let tells = |word: &&Token<'_>| {
        let lower = word.text.to_ascii_lowercase();
        CHANGES.contains(&lower.as_str()) || AngleUnit::named(&lower).is_some()
    };
    words.find(tells).copied()
}

/// The words at the start of a text that announce a form, and how many tokens they are.
pub(crate) fn announcement<'t>(
    tokens: &[Token<'t>],
    text: &'t str,
) -> Option<(Announcement<'t>, usize)> {
    let mut words = Announcement::default();
    let mut at = 0;
    loop {
        // `euler: ZYX …`
        let mark = usize::from(at > 0 && is_mark(tokens.get(at)));
        match words.take(&tokens[at + mark..], text) {
            Some(length) => at += mark + length,
            None => break,
        }
    }
    // A frame or a unit alone announces nothing.
    words.form?;
    if is_mark(tokens.get(at)) {
        at += 1;
    }
    words.span = tokens[0].span.to(tokens[at - 1].span);
    Some((words, at))
}

impl<'t> Announcement<'t> {
    /// Takes in what the next tokens say; how many they are, or `None` where they say nothing.
    fn take(&mut self, tokens: &[Token<'t>], text: &'t str) -> Option<usize> {
        let first = tokens.first()?;
        let is_label = is_mark(tokens.get(1));
        let is_free = self.form.is_none_or(|own| own == Form::Euler);
        if self.sequence.is_none() && is_free {
            if let Some(length) = digits_ahead(tokens, self.form) {
                let span = first.span.to(tokens[length - 1].span);
                self.set_sequence(Sequence::Written(&text[span.start..span.end], span));
                return Some(length);
            }
            // `xyz=` is a translation in URDF.
            if is_sequence(first.text) && !(is_label && first.text == "xyz") {
                self.set_sequence(Sequence::Written(first.text, first.span));
                return Some(1);
            }
        }
        if let [open, inner, close, ..] = tokens
            && self.form.is_some()
            && matches!(open.kind, TokenKind::Open(_))
            && matches!(close.kind, TokenKind::Close(_))
            && (inner.angle_unit().is_some() || is_sequence(inner.text))
        {
            return self.take(&[*inner], text).map(|_| 3);
        }
        if self.form.is_some()
            && let Some(unit) = first.angle_unit()
        {
            self.take_unit(Some(unit));
            return Some(1);
        }
        self.take_phrase(tokens)
    }

    fn take_phrase(&mut self, tokens: &[Token<'t>]) -> Option<usize> {
        let Phrase {
            said,
            sequence,
            unit,
            length,
        } = phrase_ahead(tokens)?;
        let next = tokens.get(length);
        // `quaternion: …` and `quaternion(…)` tell themselves.
        let tells_itself =
            is_mark(next) || next.is_some_and(|next| matches!(next.kind, TokenKind::Open(_)));
        let is_free = |form| self.form.is_none_or(|own| own == form);
        match said {
            // One sequence for all, and not another one in a name.
            _ if self.sequence.is_some() && sequence.is_some() => return None,
            Said::Form(Form::Quaternion) if tells_itself => return None,
            // The call of OpenCV, `Rodrigues(…)`, says which vector it takes.
            Said::Form(Form::RodriguesVector) if tells_itself && !is_mark(next) => return None,
            Said::Form(form) if is_free(form) => self.form = Some(form),
            Said::Frame(frame)
                if is_free(Form::Euler) && (self.form.is_some() || !is_mark(next)) =>
            {
                self.frame = Some(frame);
                self.form = Some(Form::Euler);
            }
            Said::Angles(sequence) if self.sequence.is_none() && is_free(Form::Euler) => {
                self.set_sequence(Sequence::Named(sequence));
            }
            Said::Form(_) | Said::Frame(_) | Said::Angles(_) => return None,
        }
        if let Some((letters, span)) = sequence {
            self.set_sequence(Sequence::InName(letters, span));
        }
        self.take_unit(unit);
        Some(length)
    }

    fn take_unit(&mut self, unit: Option<AngleUnit>) {
        self.has_two_units |= self.unit.zip(unit).is_some_and(|(own, other)| own != other);
        self.unit = self.unit.or(unit);
    }

    /// With the unit that a named word says besides.
    pub(crate) fn with_unit(mut self, unit: Option<AngleUnit>) -> Result<Self, Fault> {
        self.take_unit(unit);
        if self.has_two_units {
            return Err(Fault::mixed_units(self.span));
        }
        Ok(self)
    }

    fn set_sequence(&mut self, sequence: Sequence<'t>) {
        self.sequence = Some(sequence);
        self.form = Some(Form::Euler);
    }

    /// Takes in what a label before named parts says.
    pub(crate) fn take_label(&mut self, label: &Token<'t>) {
        self.other = self.other.or_else(|| OtherLabel::of(label));
        if let Some(letters) = sequence_in_name(label.text) {
            self.set_sequence(Sequence::InName(letters, label.span));
        }
        match phrase_ahead(&[*label]).map(|phrase| phrase.said) {
            Some(Said::Form(form)) => self.form = Some(form),
            Some(Said::Frame(frame)) => self.frame = Some(frame),
            Some(Said::Angles(sequence)) => self.set_sequence(Sequence::Named(sequence)),
            None => {}
        }
        self.span = label.span;
    }

    /// With a sequence that a named word says of named angles: `order: XYZ`.
    pub(crate) fn with_sequence(mut self, told: Option<(&'t str, Key<'t>)>) -> Result<Self, Fault> {
        if let Some((written, key)) = told {
            if self.sequence.is_some() {
                return Err(Fault::unknown_argument(key.span, key.name));
            }
            self.sequence = Some(Sequence::InName(written, key.span));
            self.form = self.form.or(Some(Form::Euler));
        }
        Ok(self)
    }

    /// The sequence of Euler angles; a problem where it is none, or is missing, or is known by a
    /// name that a word for its frame contradicts.
    pub(crate) fn euler_sequence(&self) -> Result<EulerSequence, Fault> {
        let Some(sequence) = self.sequence else {
            return Err(Fault::no_sequence(self.span));
        };
        match sequence {
            Sequence::Named(sequence) if self.frame.is_some_and(|own| own != sequence.frame) => {
                Err(Fault::frame_against_name(self.span, sequence))
            }
            Sequence::Named(sequence) => Ok(sequence),
            Sequence::Written(written, span) | Sequence::InName(written, span) => {
                euler_sequence(written, span, self.frame)
            }
        }
    }

    /// The sequence of angles that are named roll, pitch and yaw, which are about x, y and z.
    ///
    /// Without a word: fixed axes x, y, z, which is the same as moving axes z, y, x. Another one must
    /// be told with its frame, because the case of letters is too little against what the names
    /// usually mean.
    pub(crate) fn sequence_of_named_angles(&self) -> Result<EulerSequence, Fault> {
        const USUAL: [EulerSequence; 2] = [EulerSequence::ROLL_PITCH_YAW, EulerSequence::AEROSPACE];
        if self.sequence.is_none() {
            return match self.frame {
                None => Ok(EulerSequence::ROLL_PITCH_YAW),
                Some(_) => Err(Fault::frame_without_sequence(self.span)),
            };
        }
        let found = self.euler_sequence()?;
        let (written, span, is_in_name) = match self.sequence {
            Some(Sequence::Written(written, span)) => (written, span, false),
            Some(Sequence::InName(written, span)) => (written, span, true),
            Some(Sequence::Named(_)) | None => return Ok(found),
        };
        if found.is_proper() {
            return Err(Fault::sequence_of_two_axes(span, written));
        }
        let is_told = self.frame.is_some() || written.starts_with(['s', 'r']);
        let is_style = is_in_name && written.starts_with(['x', 'y', 'z']);
        if is_told || (USUAL.contains(&found) && !is_style) {
            return Ok(found);
        }
        Err(Fault::sequence_of_named_angles(span, written))
    }
}
