//! What the words of a text announce: which description of a rotation its numbers are.
//!
//! It works on tokens, before any arithmetic: `3-2-1` is a sequence here and a difference later.

use crate::angle::AngleUnit;
use crate::constructor::is_derived_label;
use crate::euler_sequence::{EulerFrame, EulerSequence};
use crate::lex::{Bracket, Token, TokenKind};
use crate::matrix_columns::{LabelledVector, labelled_vectors};
use crate::messages::Fault;
use crate::names::component;
use crate::parts::{SpokenPart, named_parts};
use crate::phrases::{
    Form, Phrase, Said, digits_ahead, euler_sequence, is_mark, is_name, is_sequence, phrase_ahead,
    sequence_in_name,
};
use crate::problem::Span;
use crate::tree::Key;

/// What a text says of its numbers in words.
pub(crate) enum Spoken<'s, 't> {
    /// Nothing: the numbers, names and calls must tell it.
    Nothing,
    /// `45deg about z`: what stands before and after the word.
    About {
        before: &'s [Token<'t>],
        word: Span,
        after: &'s [Token<'t>],
    },
    /// `axis [0, 0, 1] angle 45deg`, `roll=10deg pitch=20deg yaw=30deg`, and what labels before them say.
    Parts(Announcement<'t>, Vec<SpokenPart<'s, 't>>),
    /// `x: 0 1 0, y: -1 0 0, z: 0 0 1`
    Vectors(Vec<LabelledVector<'s, 't>>),
    /// `rpy_rate: …`, `R.T = …`: a label of all the numbers that says they are something else.
    Derived(Token<'t>),
    /// Two attributes that are rotations: where the second stands.
    Several(Span),
    /// `rotvec 0 0 0.785`: what is announced and what follows it.
    Announced(Announcement<'t>, &'s [Token<'t>]),
}

/// The words before the numbers.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Announcement<'t> {
    pub(crate) form: Option<Form>,
    pub(crate) frame: Option<EulerFrame>,
    pub(crate) sequence: Option<Sequence<'t>>,
    pub(crate) unit: Option<AngleUnit>,
    /// Whether another unit than that is written as well.
    pub(crate) has_two_units: bool,
    /// A label that names what was made of a rotation.
    derived: Option<Token<'t>>,
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

/// Brackets around a whole text, and labels before it, that are looked behind for words.
const MOST_WRAPPINGS: usize = 3;

pub(crate) fn spoken<'s, 't>(tokens: &'s [Token<'t>], text: &'t str) -> Spoken<'s, 't> {
    let mut tokens = match &attributes(tokens)[..] {
        [] => tokens,
        [only] => only,
        [_, second, ..] => return Spoken::Several(second[0].span.to(second[2].span)),
    };
    let mut labels = Announcement::default();
    for _ in 0..=MOST_WRAPPINGS {
        if let Some(label) = derived_label(tokens) {
            return Spoken::Derived(label);
        }
        if let Some(vectors) = labelled_vectors(tokens) {
            return match labels.derived {
                Some(label) => Spoken::Derived(label),
                None => Spoken::Vectors(vectors),
            };
        }
        if let Some(found) = announcement(tokens, text).or_else(|| comma_initializer(tokens)) {
            let (announcement, length) = found;
            return match labels.derived {
                Some(label) => Spoken::Derived(label),
                None => Spoken::Announced(announcement, &tokens[length..]),
            };
        }
        if let Some(parts) = named_parts(tokens) {
            let word_before = Some(tokens[0]).filter(|word| is_derived_label(word.text));
            return match labels.derived.or(word_before) {
                Some(label) => Spoken::Derived(label),
                None => Spoken::Parts(labels, parts),
            };
        }
        let about = at_depth_zero(tokens).find(|&at| matches!(tokens[at].text, "about" | "around"));
        if let Some(at) = about {
            return Spoken::About {
                before: after_label(&tokens[..at]).unwrap_or(&tokens[..at]),
                word: tokens[at].span,
                after: &tokens[at + 1..],
            };
        }
        tokens = match (inside(tokens), after_label(tokens)) {
            (Some(inner), _) => inner,
            (None, Some(inner)) => {
                labels.take_label(&tokens[0]);
                inner
            }
            (None, None) => break,
        };
    }
    Spoken::Nothing
}

/// The places of the tokens outside all brackets.
pub(crate) fn at_depth_zero<'s>(tokens: &'s [Token<'_>]) -> impl Iterator<Item = usize> + use<'s> {
    let mut depth = 0_usize;
    (0..tokens.len()).filter(move |&at| match tokens[at].kind {
        TokenKind::Open(_) => {
            depth += 1;
            false
        }
        TokenKind::Close(_) => {
            depth = depth.saturating_sub(1);
            false
        }
        _ => depth == 0,
    })
}

/// What stands in brackets that enclose everything.
pub(crate) fn inside<'s, 't>(tokens: &'s [Token<'t>]) -> Option<&'s [Token<'t>]> {
    let [first, inner @ .., last] = tokens else {
        return None;
    };
    let encloses = matches!(first.kind, TokenKind::Open(_))
        && matches!(last.kind, TokenKind::Close(_))
        && at_depth_zero(tokens).next().is_none();
    encloses.then_some(inner)
}

/// What stands after a name of the whole, as in `q = 45deg about z`.
fn after_label<'s, 't>(tokens: &'s [Token<'t>]) -> Option<&'s [Token<'t>]> {
    match tokens {
        [name, mark, rest @ ..]
            if is_name(name) && is_mark(Some(mark)) && component(name.text).is_none() =>
        {
            Some(rest)
        }
        _ => None,
    }
}

/// The only label of tokens, where it names what was made of a rotation.
fn derived_label<'t>(tokens: &[Token<'t>]) -> Option<Token<'t>> {
    let mark = tokens.iter().position(|token| is_mark(Some(token)))?;
    let (label, after) = (&tokens[..mark], &tokens[mark + 1..]);
    // A type or a form before it, or its unit after it, as in `rpy_rate (deg):`.
    let is_alone = at_depth_zero(after).all(|at| !is_mark(after.get(at)));
    let is_beside = label
        .iter()
        .all(|token| !matches!(token.kind, TokenKind::Number(_)));
    let mut words = label.iter().filter(|token| is_name(token));
    let derived = words.find(|word| is_derived_label(word.text))?;
    (is_alone && is_beside).then_some(*derived)
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

/// The `rpy="…"` of elements of URDF, or more than one of them without an element.
fn attributes<'s, 't>(tokens: &'s [Token<'t>]) -> Vec<&'s [Token<'t>]> {
    let is_attribute = |three: &&[Token<'_>]| {
        three[0].text == "rpy" && is_mark(three.get(1)) && three[2].kind == TokenKind::Quoted
    };
    let is_element = |first: &Token<'_>| first.kind == TokenKind::Open(Bracket::Angle);
    let found: Vec<_> = tokens.windows(3).filter(is_attribute).collect();
    if found.len() > 1 || tokens.first().is_some_and(is_element) {
        return found;
    }
    Vec::new()
}

/// The words at the start of a text that announce a form, and how many tokens they are.
fn announcement<'t>(tokens: &[Token<'t>], text: &'t str) -> Option<(Announcement<'t>, usize)> {
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

/// `R << 0, -1, 0, …;` of Eigen, perhaps after the declaration of `R`.
fn comma_initializer<'t>(tokens: &[Token<'t>]) -> Option<(Announcement<'t>, usize)> {
    let is_before = |token: &&Token<'_>| is_name(token) || token.kind == TokenKind::Comma;
    let at = tokens.iter().take_while(is_before).count();
    let shift = tokens.get(at..at + 2)?;
    let is_shift = shift[1].spacing.is_adjacent()
        && shift
            .iter()
            .all(|token| token.kind == TokenKind::Open(Bracket::Angle));
    let announcement = Announcement {
        form: Some(Form::Matrix),
        span: shift[0].span.to(shift[1].span),
        ..Announcement::default()
    };
    (at > 0 && is_shift).then_some((announcement, at + 2))
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
    fn take_label(&mut self, label: &Token<'t>) {
        if is_derived_label(label.text) {
            self.derived = Some(*label);
        }
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
