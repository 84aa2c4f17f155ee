//! What stands apart: a position beside a quaternion, a scalar and its vector, an axis and its angle.

use crate::convention::order::{ComponentOrder, OrderSource};
use crate::problem::Span;
use crate::text::description::ParsedRotation;
use crate::text::record::format::{Part, Unit};
use crate::text::record::found::{Context, Found, label_of};
use crate::text::record::group::Quantities;
use crate::text::record::meaning::{Meaning, Role};
use crate::text::record::parts::{Made, made, quaternion};
use crate::text::record::quantity::{Group, Named, NamedNumber};

/// Three numbers without a name in the brackets that hold four numbers of a quaternion: `((x, y, z), (…))`.
pub(crate) fn positions_beside(quantities: &Quantities<'_>, found: &[Found]) -> Vec<Found> {
    let mut quaternions = Vec::new();
    for found in found {
        if matches!(found.made, Made::Rotation(ParsedRotation::Quaternion(_))) {
            quaternions.push(found.span);
        }
    }
    let is_told = |group: &Group<'_>| {
        found
            .iter()
            .any(|found| found.span == group.span && !matches!(found.made, Made::Nothing))
    };
    let mut positions = Vec::new();
    for quaternion in &quantities.groups {
        if !quaternions.contains(&quaternion.span) {
            continue;
        }
        let mut threes = quantities.groups.iter().filter(|group| {
            let is_bare = group.path.last().is_none_or(|key| key.is_empty());
            group.scope == quaternion.scope && group.numbers.len() == 3 && is_bare
        });
        if let (Some(only), None) = (threes.next(), threes.next())
            && let &[x, y, z] = &only.numbers[..]
            && !is_told(only)
        {
            positions.push(Found {
                made: Made::Position([x, y, z]),
                is_computed: only.is_computed,
                ..Found::at(only.span)
            });
        }
    }
    positions
}

/// A scalar and a vector, each under its name, `real: 0.8, imag: (…)`, or behind each other in what is named a
/// quaternion: `Quaternion(0.8, #(…))`, `Quaternion 0.8 (V3 …)`.
pub(crate) fn split_quaternion(quantities: &Quantities<'_>) -> Option<Found> {
    by_names(quantities).or_else(|| by_place(quantities))
}

fn by_names(quantities: &Quantities<'_>) -> Option<Found> {
    let vector = quantities.groups.iter().find(|group| {
        group.numbers.len() == 3 && Meaning::of(&group.path).role == Some(Role::Vector)
    })?;
    let scalar = member(quantities, &|named, name| {
        named.scope == vector.scope && matches!(name, "real" | "s" | "w" | "scalar" | "re")
    })?;
    let is_computed = vector.is_computed || scalar.is_computed;
    grouped(scalar.value, scalar.span, vector, is_computed)
}

fn by_place(quantities: &Quantities<'_>) -> Option<Found> {
    let is_quaternion = |path: &[&str]| Meaning::of(path).role == Some(Role::Quaternion);
    for pair in quantities.groups.windows(2) {
        let (scalar, vector) = (&pair[0], &pair[1]);
        if let &[number] = &scalar.numbers[..]
            && vector.numbers.len() == 3
            && scalar.scope == vector.scope
            && is_quaternion(&scalar.path)
            && let Some(found) = grouped(number, scalar.span, vector, scalar.is_computed)
        {
            return Some(found);
        }
    }
    let scalar = member(quantities, &|_, name| name == "quaternion")?;
    let vector = quantities
        .groups
        .iter()
        .find(|group| group.span.start >= scalar.span.end)?;
    grouped(scalar.value, scalar.span, vector, scalar.is_computed)
}

/// The first of the single numbers that is meant.
fn member<'q>(
    quantities: &'q Quantities<'_>,
    is_it: &dyn Fn(&Named<'_>, &str) -> bool,
) -> Option<&'q NamedNumber> {
    for named in &quantities.named {
        for member in &named.members {
            if is_it(named, &member.name) {
                return Some(member);
            }
        }
    }
    None
}

fn grouped(scalar: f64, span: Span, vector: &Group<'_>, is_computed: bool) -> Option<Found> {
    let &[x, y, z] = &vector.numbers[..] else {
        return None;
    };
    let order = (ComponentOrder::ScalarFirst, OrderSource::Grouped);
    let rotation = quaternion(&[scalar, x, y, z], order)?;
    Some(Found {
        made: Made::Rotation(rotation),
        label: label_of(&vector.path[..vector.path.len() - 1]),
        is_derived: Meaning::of(&vector.path).role == Some(Role::Derived),
        is_computed: is_computed || vector.is_computed,
        ..Found::at(span.to(vector.span))
    })
}

/// An axis and an angle, each under its name.
pub(crate) fn axis_beside_angle(quantities: &Quantities<'_>, context: &Context) -> Option<Found> {
    let role = |path: &[&str]| Meaning::of(path).role;
    let group = quantities.groups.iter().find(|group| {
        let is_openscad = || group.path.ends_with(&["rotate", "v"]);
        let has_unit = Meaning::of(&group.path).unit.is_some();
        group.numbers.len() == 3
            && !has_unit
            && (!group.is_of_call || is_openscad())
            && (role(&group.path) == Some(Role::Axis) || is_openscad())
    });
    let mut axis = group.map(|group| (group.numbers.clone(), group.span));
    let mut angle = None;
    for named in &quantities.named {
        let mut path = named.path.clone();
        path.push(&named.stem);
        let meaning = Meaning::of(&path);
        if let ([x, y, z], None, Some(Role::Axis)) = (&named.members[..], &axis, meaning.role) {
            axis = Some((vec![x.value, y.value, z.value], x.span.to(z.span)));
        }
        let is_rotate = named.path.ends_with(&["rotate"]);
        let member = named
            .members
            .iter()
            .find(|member| member.name == "angle" || member.name == "a" && is_rotate);
        if let (Some(member), None) = (member, &angle) {
            angle = Some((member, meaning));
        }
    }
    let (mut numbers, axis_span) = axis?;
    let (angle, meaning) = angle?;
    numbers.push(angle.value);
    let said = context.said(&meaning);
    Some(Found {
        made: made(&[Part::AxisAngle(Unit::BySize)], &numbers, said)?.pop()?,
        label: "angle".to_owned(),
        is_derived: meaning.role == Some(Role::Derived),
        is_computed: angle.is_computed,
        ..Found::at(angle.span.to(axis_span))
    })
}
