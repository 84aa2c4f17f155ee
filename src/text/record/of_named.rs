//! What single numbers are by their names.

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::order::OrderSource;
use crate::text::record::format::{Field, Part};
use crate::text::record::found::{Asked, Context, Found, label_of, stands_under};
use crate::text::record::meaning::{Meaning, Role};
use crate::text::record::names::words_of;
use crate::text::record::parts::made;
use crate::text::record::quantity::{Named, NamedNumber};
use crate::text::vocabulary::is_listed;

/// Adds what numbers by name are.
pub(crate) fn of_named(
    named: &Named<'_>,
    context: &Context,
    fields: &[Asked],
    all: &mut Vec<Found>,
) {
    let mut path = named.path.clone();
    path.push(&named.stem);
    let meaning = Meaning::of(&path).with_remark(named.remark);
    // `mrp roll=1 …`, `velocity: {x: …, w: …}`, `XYZ roll=…`: what stands before the names denies them.
    let is_sequence = |word: &str| word.parse::<EulerSequence>().is_ok();
    if meaning.role == Some(Role::Rate) || named.stem.split(' ').any(is_sequence) {
        return;
    }
    let has_scalar = named.members.iter().any(|member| member.name == "w");
    let mut left: Vec<&NamedNumber> = Vec::new();
    let mut all_names = String::new();
    for member in &named.members {
        all_names.push_str(if left.is_empty() { "" } else { " " });
        all_names.push_str(&member.name);
        left.push(member);
    }
    for (field, format) in fields {
        let (names, parts) = match field {
            Field::OnlyNamed(names, parts) if all_names == *names => (names, parts),
            Field::Named(names, parts) => (names, parts),
            // With a scalar beside them they are no angles.
            Field::NamedUnder(above, names, parts) if stands_under(&path, above) && !has_scalar => {
                (names, parts)
            }
            _ => continue,
        };
        let Some(members) = members_of(&left, names) else {
            continue;
        };
        let is_scale = meaning.role == Some(Role::Scale);
        let parts = match parts {
            [Part::Position] if is_scale => &[Part::Scale][..],
            [Part::Position] if !is_of_vector(&meaning) => continue,
            parts => parts,
        };
        // `euler_123 = {roll: …}`: names that cannot have this sequence.
        let has_sequence = || {
            for key in &path {
                for word in words_of(key) {
                    if word != "xyz" && is_sequence(&word) {
                        return true;
                    }
                }
            }
            false
        };
        let is_other = matches!(
            meaning.role,
            Some(Role::Quaternion | Role::RotationVector | Role::AxisAngle | Role::Matrix)
        );
        // `roll: 0.12 rad/s` is a rate.
        if matches!(parts, [Part::Euler(_)]) && members.iter().any(|member| member.has_length) {
            continue;
        }
        let is_denied = context.letters.is_some() || is_other || has_sequence();
        if matches!(parts, [Part::Euler(_)]) && format.is_none() && is_denied {
            continue;
        }
        let mut numbers = Vec::new();
        let mut unit = None;
        for member in &members {
            numbers.push(member.value);
            unit = unit.or(member.unit);
        }
        let mut said = context.said(&meaning);
        let differs = |other: Option<AngleUnit>| other.is_some() && unit.is_some() && other != unit;
        if differs(context.unit) || members.iter().any(|member| differs(member.unit)) {
            continue;
        }
        // `(yaw, pitch, roll) = (…)`: the order of the names is none of the turns, which they tell.
        if is_listed("roll", names) {
            said.sequence = None;
        }
        said.unit = unit.or(said.unit);
        let of_names = |order| (order, OrderSource::Named);
        if let [Part::Quaternion(Some(order))] = parts {
            said.order = of_names(*order);
        }
        let mut parts = parts.to_vec();
        for part in &mut parts {
            if let Part::Quaternion(order) = part {
                *order = None;
            }
        }
        // Under the name of an orientation four components are one, whatever their norm.
        let is_orientation = matches!(meaning.role, Some(Role::Rotation | Role::Quaternion));
        let any_norm = || {
            matches!(parts[..], [Part::Quaternion(None)] if is_orientation)
                .then(|| made(&[Part::ScaledQuaternion(said.order.0)], &numbers, said))
                .flatten()
        };
        let Some(made) = made(&parts, &numbers, said).or_else(any_norm) else {
            continue;
        };
        left.retain(|member| !is_listed(&member.name, names));
        let mut found = Found {
            label: label_of(&path),
            is_derived: meaning.role == Some(Role::Derived),
            format: *format,
            ..Found::at(members[0].span)
        };
        for member in members {
            found.span = found.span.to(member.span);
            found.is_computed |= member.is_computed;
        }
        found.add_parts(made, all);
    }
}

/// The members with these names, which spaces divide, in their order; `None` where one is not there.
fn members_of<'n>(members: &[&'n NamedNumber], names: &str) -> Option<Vec<&'n NamedNumber>> {
    let mut found = Vec::new();
    for name in names.split(' ') {
        found.push(*members.iter().find(|member| member.name == name)?);
    }
    Some(found)
}

/// Whether x, y and z can be a position here.
fn is_of_vector(meaning: &Meaning) -> bool {
    !matches!(
        meaning.role,
        Some(
            Role::Other
                | Role::Rate
                | Role::Euler
                | Role::Rotation
                | Role::RotationVector
                | Role::Axis
                | Role::Quaternion
                | Role::Scale
                | Role::Vector
        )
    )
}
