//! Members with names: which component each is, and which of several values is meant.

use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::description::label;
use crate::text::grammar::lex::last_segment;
use crate::text::grammar::tree::{Entry, Key, NodeKind};
use crate::text::vocabulary::labels::{LabelWord, meanings_of};
use crate::text::vocabulary::phrases::is_sequence;

/// Names of that part of a message which is the quaternion, or holds it.
pub(crate) const ORIENTATIONS: [&str; 6] = [
    "orientation",
    "rotation",
    "quaternion",
    "quat",
    "pose",
    "transform",
];

/// Names of members that change no number: what programs print beside a rotation.
const HARMLESS: [&str; 27] = [
    "child",
    "child_frame_id",
    "class",
    "comment",
    "copy",
    "description",
    "device",
    "dtype",
    "frame_id",
    "header",
    "id",
    "iseuler",
    "ismatrix3",
    "isquaternion",
    "isvector3",
    "label",
    "name",
    "parent",
    "requires_grad",
    "seq",
    "shape",
    "stamp",
    "time",
    "timestamp",
    "topic",
    "type",
    "uuid",
];

/// Words in the value of such a member that may change the numbers all the same.
const TELLING: [&str; 9] = [
    "col", "deg", "hamilton", "jpl", "left", "rad", "trinsic", "wxyz", "xyzw",
];

/// Of these members the value may be a sentence about the numbers.
const DESCRIBING: [&str; 4] = ["comment", "description", "label", "name"];

/// Whether words say something of a convention, or that the numbers were made of a rotation.
fn tells(words: &str) -> bool {
    let is_told =
        |meaning: &LabelWord| !matches!(meaning, LabelWord::Rotation | LabelWord::Quantity(_));
    cfg!(feature = "whole") && meanings_of(words).iter().any(is_told)
}

fn is_harmless(entry: &Entry<'_>, name: &str) -> bool {
    let name = last_segment(name).to_ascii_lowercase();
    let may_change = match entry.node.kind {
        NodeKind::Word(word) if matches!(name.as_str(), "seq" | "type") => {
            let word = word.to_ascii_lowercase();
            is_sequence(&word)
                || tells(&word)
                || TELLING.iter().any(|telling| word.contains(telling))
        }
        NodeKind::Word(word) => DESCRIBING.contains(&name.as_str()) && tells(word),
        _ => false,
    };
    !may_change && (HARMLESS.contains(&name.as_str()) || name.ends_with("covariance"))
}

/// The members that are numbers or hold numbers; a problem where a word may change them.
pub(crate) fn without_options<'t>(entries: &[Entry<'t>]) -> Result<Vec<Entry<'t>>, Fault> {
    let mut members = Vec::new();
    for entry in entries {
        match entry.key {
            Some(key) if is_harmless(entry, key.name) => {}
            Some(key)
                if component(key.name).is_none()
                    && matches!(entry.node.kind, NodeKind::Word(_)) =>
            {
                return Err(Fault::unknown_argument(key.span, key.name));
            }
            _ => members.push(entry.clone()),
        }
    }
    Ok(members)
}

const COMPONENT_NAMES: [&str; 4] = ["w", "x", "y", "z"];

/// The place of a component in `[w, x, y, z]`, by any of its names.
pub(crate) fn component(name: &str) -> Option<usize> {
    Some(match last_segment(name).to_ascii_lowercase().as_str() {
        "w" | "qw" | "q_w" | "_w" => 0,
        "x" | "qx" | "q_x" | "_x" => 1,
        "y" | "qy" | "q_y" | "_y" => 2,
        "z" | "qz" | "q_z" | "_z" => 3,
        _ => return None,
    })
}

pub(crate) fn named(entries: &[Entry<'_>], span: Span, wanted: Wanted) -> Result<[f64; 4], Fault> {
    without_options(entries)?;
    let entries = of_one_value(entries, wanted)?;
    let mut found = [None; 4];
    for entry in without_options(entries)? {
        let Some(key) = entry.key else {
            return Err(Fault::mixed_names(entry.node.span));
        };
        let Some(place) = component(key.name) else {
            return Err(Fault::unknown_component(key.span, wanted, key.name));
        };
        let whole = key.span.to(entry.node.span);
        if place == 0 && wanted == Wanted::Vector {
            return Err(Fault::scalar_in_vector(whole));
        }
        if found[place].replace(entry.node.real()?).is_some() {
            return Err(Fault::duplicate_component(whole, COMPONENT_NAMES[place]));
        }
    }
    let mut missing = Vec::new();
    let mut numbers = [0.0; 4];
    for place in 4 - wanted.count()..4 {
        match found[place] {
            Some(number) => numbers[place] = number,
            None => missing.push(COMPONENT_NAMES[place]),
        }
    }
    if !missing.is_empty() {
        return Err(Fault::missing_component(span, wanted, &missing));
    }
    Ok(numbers)
}

/// The members of one value, where headings (`orientation:`) or paths (`pose.orientation.x`) tell
/// several apart: those of the orientation, or a problem where none
/// or more than one is.
fn of_one_value<'e, 't>(
    entries: &'e [Entry<'t>],
    wanted: Wanted,
) -> Result<&'e [Entry<'t>], Fault> {
    let path = |key: Key<'t>| {
        key.name
            .rsplit_once(['.', ':'])
            .map_or("", |(path, _)| path)
    };
    let starts = |at: usize| {
        let Some(key) = entries[at].key else {
            return false;
        };
        let before = at.checked_sub(1).and_then(|before| entries[before].key);
        key.heading.is_some() || before.is_some_and(|before| path(before) != path(key))
    };
    let mut groups = Vec::new();
    let mut start = 0;
    for at in 1..entries.len() {
        if starts(at) {
            groups.push(&entries[start..at]);
            start = at;
        }
    }
    groups.push(&entries[start..]);
    let [_, second, ..] = groups[..] else {
        if let Some(key) = entries.first().and_then(|entry| entry.key) {
            label::check(key.heading.unwrap_or_else(|| path(key)), key.span, wanted)?;
        }
        return Ok(entries);
    };
    let mut orientation = None;
    for group in groups {
        let is_orientation = group[0].key.is_some_and(|key| {
            let heading = key.heading.unwrap_or_else(|| path(key));
            ORIENTATIONS.contains(&last_segment(heading))
        });
        if is_orientation && orientation.replace(group).is_some() {
            return Err(Fault::several_values(group[0].node.span));
        }
    }
    orientation.ok_or_else(|| Fault::several_values(second[0].node.span))
}
