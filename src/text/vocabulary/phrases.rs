//! The words that are known before numbers, and the names of Euler sequences.

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::{EulerFrame, EulerSequence};
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::lex::{Token, TokenKind, last_segment, texts_of};
use crate::text::vocabulary::labels::other_than_rotation;

/// What numbers can be announced as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    Quaternion,
    AxisAngle,
    AngleAxis,
    RotationVector,
    HalfAngleVector,
    GibbsVector,
    ModifiedRodrigues,
    /// The rotation vector in `OpenCV` and others, the Gibbs vector in textbooks.
    RodriguesVector,
    Euler,
    Matrix,
}

/// What a phrase says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Said {
    Form(Form),
    Frame(EulerFrame),
    /// Euler angles whose name tells their sequence.
    Angles(EulerSequence),
}

impl Said {
    /// What words say, written together in small letters.
    fn of(words: &str) -> Option<Self> {
        Some(match words {
            "quaternion" | "quat" => Self::Form(Form::Quaternion),
            "axisangle" | "axang" => Self::Form(Form::AxisAngle),
            "angleaxis" => Self::Form(Form::AngleAxis),
            "rotvec" | "rotationvector" | "rvec" => Self::Form(Form::RotationVector),
            "halfangle" | "halfanglevector" => Self::Form(Form::HalfAngleVector),
            "gibbs"
            | "gibbsvector"
            | "crp"
            | "rodriguesparameters"
            | "classicalrodriguesparameters" => Self::Form(Form::GibbsVector),
            "mrp"
            | "mrps"
            | "modifiedrodrigues"
            | "modifiedrodriguesparameters"
            | "modifiedrodriguesvector" => Self::Form(Form::ModifiedRodrigues),
            "rodrigues" | "rodriguesvector" => Self::Form(Form::RodriguesVector),
            "euler" | "eulerangle" | "eulerangles" => Self::Form(Form::Euler),
            "matrix" | "rotationmatrix" | "rotmat" | "dcm" => Self::Form(Form::Matrix),
            "intrinsic" | "rotating" | "moving" => Self::Frame(EulerFrame::Intrinsic),
            "extrinsic" | "fixed" => Self::Frame(EulerFrame::Extrinsic),
            "rpy" | "rollpitchyaw" => Self::Angles(EulerSequence::ROLL_PITCH_YAW),
            "ypr" | "yawpitchroll" => Self::Angles(EulerSequence::AEROSPACE),
            _ => return None,
        })
    }

    /// What a label says that ends in such words, as `imu_rpy:` does; `rpy_rate:` is something else.
    fn of_label(label: &str) -> Option<Self> {
        const WORDS: [&str; 11] = [
            "halfangle",
            "gibbs",
            "mrp",
            "axisangle",
            "angleaxis",
            "rotvec",
            "rotationvector",
            "rpy",
            "ypr",
            "euler",
            "matrix",
        ];
        let word = WORDS.iter().find(|word| label.ends_with(**word));
        word.and_then(|word| Self::of(word))
    }
}

/// Up to three words that belong together, and what they say.
pub(crate) struct Phrase<'t> {
    pub(crate) said: Said,
    /// The letters of a label such as `euler_zyx`.
    pub(crate) sequence: Option<(&'t str, Span)>,
    /// A unit at the end, as in `rpy_deg`.
    pub(crate) unit: Option<AngleUnit>,
    pub(crate) length: usize,
}

const MOST_WORDS: usize = 3;

/// The longest phrase at the start that says something.
pub(crate) fn phrase_ahead<'t>(tokens: &[Token<'t>]) -> Option<Phrase<'t>> {
    if let Some(phrase) = euler_label(tokens) {
        return Some(phrase);
    }
    for count in (1..=MOST_WORDS).rev() {
        let Some((words, length)) = joined(tokens, count) else {
            continue;
        };
        let (words, unit) = without_unit(&words);
        let said = match Said::of(words) {
            None if is_mark(tokens.get(length)) => {
                // `imu rate rpy:` is something else, as `rpy_rate:` is.
                let is_rotation =
                    || other_than_rotation(&texts_of(&tokens[..length]).join(" ")).is_none();
                Said::of_label(words).filter(|_| !cfg!(feature = "whole") || is_rotation())
            }
            said => said,
        };
        if let Some(said) = said {
            return Some(Phrase {
                said,
                sequence: None,
                unit,
                length,
            });
        }
    }
    None
}

/// `euler_zyx`, `euler_angles_ZYX_deg`
fn euler_label<'t>(tokens: &[Token<'t>]) -> Option<Phrase<'t>> {
    let name = tokens.first().filter(|token| is_name(token))?;
    let mut parts = last_segment(name.text).split('_');
    let first = parts.next()?.to_ascii_lowercase();
    let mut next = parts.next()?;
    if first == "euler" && matches!(next.to_ascii_lowercase().as_str(), "angle" | "angles") {
        next = parts.next()?;
    }
    let unit = match parts.next() {
        Some(unit) => Some(AngleUnit::named(&unit.to_ascii_lowercase())?),
        None => None,
    };
    let is_it = first == "euler" && is_sequence(next) && parts.next().is_none();
    is_it.then_some(Phrase {
        said: Said::Form(Form::Euler),
        sequence: Some((next, name.span)),
        unit,
        length: 1,
    })
}

/// So many words in small letters and without what stands between them: `axis-angle`, `axis_angle`,
/// `roll, pitch, yaw`; and how many tokens they are.
fn joined(tokens: &[Token<'_>], count: usize) -> Option<(String, usize)> {
    let mut words = String::new();
    let mut at = 0;
    for word in 0..count {
        if word > 0 && matches!(tokens.get(at)?.kind, TokenKind::Minus | TokenKind::Comma) {
            at += 1;
        }
        let token = tokens.get(at).filter(|token| is_name(token))?;
        at += 1;
        let is_label = is_mark(tokens.get(at));
        words.push_str(if is_label {
            last_segment(token.text)
        } else {
            token.text
        });
    }
    // `rotvec<deg>` says its unit as `rotvec_deg` does.
    let between = ['_', '-', ' ', '<', '>'];
    Some((words.to_ascii_lowercase().replace(between, ""), at))
}

fn without_unit(words: &str) -> (&str, Option<AngleUnit>) {
    const UNITS: [(&str, AngleUnit); 4] = [
        ("degrees", AngleUnit::Degrees),
        ("deg", AngleUnit::Degrees),
        ("radians", AngleUnit::Radians),
        ("rad", AngleUnit::Radians),
    ];
    let found = UNITS.iter().find_map(|(name, unit)| {
        let rest = words.strip_suffix(name)?;
        (!rest.is_empty()).then_some((rest, Some(*unit)))
    });
    found.unwrap_or((words, None))
}

pub(crate) fn is_name(token: &Token<'_>) -> bool {
    matches!(token.kind, TokenKind::Word | TokenKind::Quoted)
}

pub(crate) fn is_mark(token: Option<&Token<'_>>) -> bool {
    token.is_some_and(|token| matches!(token.kind, TokenKind::Colon | TokenKind::Equals))
}

/// Three letters of axes, perhaps after the s or r of transforms3d; not yet whether they are one of
/// the 24.
pub(crate) fn is_sequence(word: &str) -> bool {
    let is_axis = |letter: char| matches!(letter, 'x' | 'y' | 'z' | 'X' | 'Y' | 'Z');
    let letters = match word.strip_prefix(['s', 'r']) {
        Some(rest) if rest.chars().all(|letter| letter.is_ascii_lowercase()) => rest,
        _ => word,
    };
    letters.len() == 3 && letters.chars().all(is_axis)
}

/// Whether a word is a sequence in letters or in digits, `3-2-1` and `321` included.
pub(crate) fn names_axes(word: &str) -> bool {
    is_sequence(word) || word.parse::<EulerSequence>().is_ok()
}

/// The letters of a sequence in a name: `my_euler_xyz`, `orderZYX`, `euler_321`.
pub(crate) fn sequence_in_name(name: &str) -> Option<&str> {
    let is_euler = name.to_ascii_lowercase().contains("euler");
    name.split(['_', '-', ' ', '.', ':']).find_map(|word| {
        let (before, end) = word.split_at_checked(word.len().checked_sub(3)?)?;
        let is_capital = |letter: char| matches!(letter, 'X' | 'Y' | 'Z');
        let is_end =
            before.ends_with(|mark: char| mark.is_ascii_lowercase()) && end.chars().all(is_capital);
        match () {
            () if is_sequence(word) || (is_euler && names_axes(word)) => Some(word),
            () => is_end.then_some(end),
        }
    })
}

/// How many tokens at the start are a sequence with dashes, `3-2-1` or `Z-Y-X`, or `321` after
/// `euler`.
///
/// Three digits that are no sequence are a difference unless Euler angles are announced.
pub(crate) fn digits_ahead(tokens: &[Token<'_>], form: Option<Form>) -> Option<usize> {
    let is_euler = form == Some(Form::Euler);
    let are_axes = |text: &str, count: usize| {
        let is_axis = |mark| matches!(mark, '1'..='3' | 'x'..='z' | 'X'..='Z');
        text.len() == count && text.chars().all(is_axis)
    };
    if let [number, _, ..] = tokens
        && is_euler
        && are_axes(number.text, 3)
    {
        return Some(1);
    }
    let (digits, rest) = tokens.split_at_checked(5)?;
    let is_in_form = digits.iter().enumerate().all(|(at, token)| {
        let touches = at == 0 || token.spacing.is_adjacent();
        let is_right_kind = match at % 2 {
            0 => are_axes(token.text, 1),
            _ => token.kind == TokenKind::Minus,
        };
        touches && is_right_kind
    });
    let written = texts_of(digits).concat();
    let is_known = is_euler
        || written
            .replace(['−', '–'], "-")
            .parse::<EulerSequence>()
            .is_ok();
    let next = rest.first()?;
    let goes_on = match next.kind {
        TokenKind::Plus | TokenKind::Minus => rest
            .get(1)
            .is_some_and(|after| !after.spacing.is_adjacent()),
        // A factor: `3-2-1 k` is a number of k.
        TokenKind::Word => matches!(next.text, "i" | "j" | "k"),
        TokenKind::Times | TokenKind::Divide | TokenKind::Close(_) => true,
        _ => false,
    };
    let is_apart =
        is_mark(Some(next)) || next.kind == TokenKind::Comma || !next.spacing.is_adjacent();
    (is_in_form && is_known && is_apart && !goes_on).then_some(5)
}

/// The sequence that letters or digits name; a word for the frame wins over the letters' case.
pub(crate) fn euler_sequence(
    written: &str,
    span: Span,
    frame: Option<EulerFrame>,
) -> Result<EulerSequence, Fault> {
    let unknown = || Fault::unknown_sequence(span, written);
    let by_letter = match written.split_at_checked(1) {
        Some(("s", axes)) => Some((EulerFrame::Extrinsic, axes)),
        Some(("r", axes)) => Some((EulerFrame::Intrinsic, axes)),
        _ => None,
    };
    if let Some((told, axes)) = by_letter {
        if frame.is_some_and(|frame| frame != told) {
            return Err(Fault::contradicting_frame(span, written));
        }
        let sequence: EulerSequence = axes.parse().map_err(|_| unknown())?;
        return Ok(EulerSequence {
            frame: told,
            ..sequence
        });
    }
    let plain = written.replace(['−', '–'], "-");
    match frame {
        Some(frame) => {
            let capitals = plain.to_ascii_uppercase();
            let sequence: EulerSequence = capitals.parse().map_err(|_| unknown())?;
            Ok(EulerSequence { frame, ..sequence })
        }
        None => plain.parse().map_err(|_| unknown()),
    }
}
