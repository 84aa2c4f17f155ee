//! Tokens to a rotation: the words, where there are any, are asked first which description it is, then
//! a table of readers.

use crate::convention::angle::AngleUnit;
use crate::convention::order::{ComponentOrder, OrderSource};
use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::description::label;
use crate::text::description::list::{members, sequence_among_numbers};
use crate::text::description::named_members::component;
use crate::text::description::quaternion::ParsedQuaternion;
use crate::text::description::settings::{Settings, without_settings};
use crate::text::description::told::Told;
use crate::text::description::wording::{Spoken, spoken};
use crate::text::description::{
    ParsedRotation, announced_numbers, axis_angle, call, matrix, matrix_columns, named_parts,
    quaternion,
};
use crate::text::grammar;
use crate::text::grammar::lex::Token;
use crate::text::grammar::separators::check_no_complex_number;
use crate::text::grammar::tree::{Entry, Key, NodeKind};
use crate::text::vocabulary::Telling;
use crate::text::vocabulary::phrases::Form;

/// What members are read as; `None` where they are something else.
type Reader = fn(&Members<'_>) -> Result<Option<ParsedRotation>, Fault>;

/// The readers in the order in which they are asked; three know only what stands beside words or
/// units. What none of them knows is a quaternion.
const READERS: [(Asked, Reader); 5] = [
    (Asked::OfWords, angle_beside_axis),
    (Asked::Always, no_sequence_without_word),
    (Asked::OfWords, call),
    (Asked::Always, matrix),
    (Asked::OfWords, no_word_that_is_not_known),
];

/// When a reader is asked.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Asked {
    Always,
    /// Where there is a word or a unit.
    OfWords,
}

/// The members of a text.
struct Members<'t> {
    /// As they were written.
    written: Vec<Entry<'t>>,
    /// Without the brackets around all of them, and without what changes no number.
    bare: Result<Vec<Entry<'t>>, Fault>,
    span: Span,
    said: Said,
}

/// What words said of members.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Said {
    /// There are none.
    Nothing,
    /// Not which description they are.
    NotADescription,
    /// That they are a quaternion.
    Quaternion,
}

impl<'t> Members<'t> {
    fn of(tokens: &[Token<'t>], span: Span, said: Said) -> Result<Self, Fault> {
        check_no_complex_number(tokens)?;
        let written = grammar::entries(tokens)?;
        Ok(Self {
            bare: members(&written),
            written,
            span,
            said,
        })
    }
}

/// What the words of a text make of it.
enum ByWords<'s, 't> {
    /// Angles, with what is said of their unit already used.
    Rotation(ParsedRotation),
    /// What has no unit.
    WithoutUnit(ParsedRotation),
    /// Nothing: these are left for the readers.
    Numbers(&'s [Token<'t>]),
}

/// The rotation that the tokens of a text are; `declared` is the order of a quaternion's numbers where
/// nothing tells it.
pub(crate) fn rotation(
    telling: &Telling<'_>,
    text: &str,
    span: Span,
    declared: ComponentOrder,
    told: &Told<'_>,
) -> Result<ParsedRotation, Fault> {
    if !telling.has_words {
        let members = Members::of(&telling.tokens, span, Said::Nothing)?;
        return by_members(&members, &Settings::default(), declared, told);
    }
    let (tokens, settings) = without_settings(&telling.tokens)?;
    let unit = settings.unit.map(|(unit, _)| unit).or(told.unit);
    match by_words(&tokens, text, span, unit, settings.sequence)? {
        ByWords::Rotation(rotation) => {
            settings.check_order(None)?;
            Ok(rotation)
        }
        ByWords::WithoutUnit(rotation) => {
            settings.check_nothing_said()?;
            Ok(rotation)
        }
        ByWords::Numbers(numbers) => {
            let said = if numbers.len() < tokens.len() {
                Said::Quaternion
            } else {
                Said::NotADescription
            };
            let members = Members::of(numbers, span, said)?;
            by_members(&members, &settings, declared, told)
        }
    }
}

fn by_members(
    members: &Members<'_>,
    settings: &Settings<'_>,
    declared: ComponentOrder,
    told: &Told<'_>,
) -> Result<ParsedRotation, Fault> {
    for (asked, read) in READERS {
        if members.said == Said::Nothing && asked == Asked::OfWords {
            continue;
        }
        if let Some(rotation) = read(members)? {
            settings.check_nothing_said()?;
            return Ok(rotation);
        }
    }
    settings.check_no_unit()?;
    let order = settings.order.map(|(order, _)| order).or(told.order);
    let quaternion = quaternion::quaternion(&members.written, members.span, declared, order)?;
    // Names have no order that another could contradict.
    if quaternion.order_source != OrderSource::Named {
        settings.check_order(Some(quaternion.order))?;
    }
    Ok(ParsedRotation::Quaternion(ParsedQuaternion {
        is_announced: quaternion.is_announced || members.said == Said::Quaternion,
        ..quaternion
    }))
}

fn by_words<'s, 't>(
    tokens: &'s [Token<'t>],
    text: &'t str,
    span: Span,
    unit: Option<AngleUnit>,
    sequence: Option<(&'t str, Key<'t>)>,
) -> Result<ByWords<'s, 't>, Fault> {
    Ok(match spoken(tokens, text) {
        Spoken::About {
            before,
            word,
            after,
        } => ByWords::Rotation(axis_angle::about(before, word, after, unit)?),
        Spoken::Other(label) => return Err(label.fault()),
        Spoken::Several(second) => return Err(Fault::several_values(second)),
        Spoken::Parts(labels, parts) => {
            let announcement = labels.with_unit(unit)?.with_sequence(sequence)?;
            ByWords::Rotation(named_parts::rotation(&parts, &announcement, span)?)
        }
        Spoken::Vectors(vectors) => {
            let matrix = matrix_columns::matrix(&vectors, span)?;
            ByWords::WithoutUnit(ParsedRotation::Matrix(matrix))
        }
        Spoken::Announced(announcement, rest) => match announcement.form {
            Some(Form::Quaternion) | None => ByWords::Numbers(rest),
            Some(form) => {
                let announcement = announcement.with_unit(unit)?.with_sequence(sequence)?;
                ByWords::Rotation(announced_numbers::rotation(
                    &announcement,
                    form,
                    rest,
                    text,
                )?)
            }
        },
        Spoken::Nothing => ByWords::Numbers(tokens),
    })
}

fn angle_beside_axis(members: &Members<'_>) -> Result<Option<ParsedRotation>, Fault> {
    match &members.bare {
        Ok(bare) if members.said != Said::Quaternion => axis_angle::beside(bare),
        _ => Ok(None),
    }
}

/// Refuses `321 30 20 10`, which is a sequence with its angles or a quaternion.
fn no_sequence_without_word(members: &Members<'_>) -> Result<Option<ParsedRotation>, Fault> {
    let bare = members.bare.as_ref().ok();
    let bare = bare.filter(|_| members.said != Said::Quaternion);
    match bare.and_then(|bare| sequence_among_numbers(bare)) {
        Some(first) => Err(Fault::sequence_or_number(first)),
        None => Ok(None),
    }
}

fn call(members: &Members<'_>) -> Result<Option<ParsedRotation>, Fault> {
    call::rotation(&members.written)
}

/// Nine numbers, perhaps under names of the whole, as in `R = [[…], […], […]]`, and in the braces
/// around such names: `{"pose": {"R": [[…], […], […]]}}`.
fn matrix(members: &Members<'_>) -> Result<Option<ParsedRotation>, Fault> {
    let mut bare = members.bare.clone()?;
    let mut labels = Vec::new();
    while let Some(first) = bare.first_mut()
        && let Some(key) = first.key.filter(|key| component(key.name).is_none())
    {
        if cfg!(feature = "whole") {
            labels.push(key);
        }
        first.key = None;
        bare = self::members(&bare)?;
    }
    let matrix = matrix::unannounced(&bare, members.span)?;
    if matrix.is_some() {
        for key in labels {
            label::check(key.name, key.span, Wanted::Quaternion)?;
        }
    }
    Ok(matrix.map(ParsedRotation::Matrix))
}

/// Refuses a word before numbers that announces nothing.
fn no_word_that_is_not_known(members: &Members<'_>) -> Result<Option<ParsedRotation>, Fault> {
    match &members.written[..] {
        [first, _, ..] if first.key.is_none() => match first.node.kind {
            NodeKind::Word(word) => Err(Fault::unknown_keyword(first.node.span, word)),
            _ => Ok(None),
        },
        _ => Ok(None),
    }
}
