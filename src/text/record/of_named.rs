//! What single numbers are by their names.

use crate::convention::angle::AngleUnit;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::order::OrderSource;
use crate::problem::Span;
use crate::text::record::format::{Field, Part};
use crate::text::record::found::{Asked, Context, Found, label_of, stands_under};
use crate::text::record::meaning::{Meaning, Role};
use crate::text::record::names::words_of;
use crate::text::record::parts::made;
use crate::text::record::quantity::Named;

pub(crate) fn of_named(named: &Named<'_>, context: &Context, fields: &[Asked]) -> Vec<Found> {
    let mut path = named.path.clone();
    path.push(&named.stem);
    let meaning = Meaning::of(&path);
    // `mrp roll=1 …`, `velocity: {x: …, w: …}`, `XYZ roll=…`: what stands before the names denies them.
    let is_sequence = |word: &str| word.parse::<EulerSequence>().is_ok();
    if meaning.role == Some(Role::Rate) || named.stem.split(' ').any(is_sequence) {
        return Vec::new();
    }
    let has_scalar = named.members.iter().any(|member| member.name == "w");
    let mut left: Vec<&_> = named.members.iter().collect();
    let mut all = Vec::new();
    for (field, format) in fields {
        let (names, parts) = match field {
            Field::OnlyNamed(names, parts)
                if named
                    .members
                    .iter()
                    .map(|member| member.name.as_str())
                    .eq(names.split(' ')) =>
            {
                (names, parts)
            }
            Field::Named(names, parts) => (names, parts),
            // With a scalar beside them they are no angles.
            Field::NamedUnder(above, names, parts) if stands_under(&path, above) && !has_scalar => {
                (names, parts)
            }
            _ => continue,
        };
        let wanted: Vec<&str> = names.split(' ').collect();
        let members: Option<Vec<_>> = wanted
            .iter()
            .map(|name| left.iter().find(|member| member.name == *name).copied())
            .collect();
        let Some(members) = members else {
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
            let words = path.iter().flat_map(|key| words_of(key));
            words
                .filter(|word| word != "xyz")
                .any(|word| is_sequence(&word))
        };
        let is_other = matches!(
            meaning.role,
            Some(Role::Quaternion | Role::RotationVector | Role::AxisAngle | Role::Matrix)
        );
        let is_denied = context.letters.is_some() || is_other || has_sequence();
        if matches!(parts, [Part::Euler(_)]) && format.is_none() && is_denied {
            continue;
        }
        let numbers: Vec<f64> = members.iter().map(|member| member.value).collect();
        let mut said = context.said(&meaning);
        let unit = members.iter().find_map(|member| member.unit);
        let differs = |other: Option<AngleUnit>| other.is_some() && unit.is_some() && other != unit;
        if differs(context.unit) || members.iter().any(|member| differs(member.unit)) {
            continue;
        }
        said.unit = unit.or(said.unit);
        let of_names = |order| (order, OrderSource::Named);
        if let [Part::Quaternion(Some(order))] = parts {
            said.order = of_names(*order);
        }
        let parts: Vec<Part> = parts
            .iter()
            .map(|part| match part {
                Part::Quaternion(Some(_)) => Part::Quaternion(None),
                other => *other,
            })
            .collect();
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
        left.retain(|member| !wanted.contains(&member.name.as_str()));
        let span = members
            .iter()
            .map(|member| member.span)
            .reduce(Span::to)
            .unwrap_or_default();
        all.extend(made.into_iter().map(|made| Found {
            made,
            label: label_of(&path),
            span,
            is_derived: meaning.role == Some(Role::Derived),
            is_computed: members.iter().any(|member| member.is_computed),
            format: *format,
            has_rows: true,
        }));
    }
    all
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
