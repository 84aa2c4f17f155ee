//! What stands apart: a position beside a quaternion, a scalar and its vector, an axis and its angle.

use crate::convention::order::{ComponentOrder, OrderSource};
use crate::text::description::ParsedRotation;
use crate::text::record::format::{Part, Unit};
use crate::text::record::found::{Context, Found, label_of};
use crate::text::record::group::Quantities;
use crate::text::record::meaning::{Meaning, Role};
use crate::text::record::parts::{Made, made, quaternion};
use crate::text::record::quantity::Group;

/// Three numbers without a name in the brackets that hold four numbers of a quaternion: `((x, y, z), (…))`.
pub(crate) fn positions_beside(quantities: &Quantities<'_>, found: &[Found]) -> Vec<Found> {
    let is_quaternion = |group: &Group<'_>| {
        found.iter().any(|found| {
            found.span == group.span
                && matches!(found.made, Made::Rotation(ParsedRotation::Quaternion(_)))
        })
    };
    let threes = |scope: usize| {
        quantities.groups.iter().filter(move |group| {
            let is_bare = group.path.last().is_none_or(|key| key.is_empty());
            group.scope == scope && group.numbers.len() == 3 && is_bare
        })
    };
    quantities
        .groups
        .iter()
        .filter(|group| is_quaternion(group))
        .filter_map(|quaternion| {
            let mut threes = threes(quaternion.scope);
            let only = threes.next().filter(|_| threes.next().is_none())?;
            let is_told = found
                .iter()
                .any(|found| found.span == only.span && !matches!(found.made, Made::Nothing));
            let numbers = <[f64; 3]>::try_from(&only.numbers[..]).ok()?;
            (!is_told).then(|| Found {
                made: Made::Position(numbers),
                label: String::new(),
                span: only.span,
                is_derived: false,
                is_computed: only.is_computed,
                format: None,
                has_rows: true,
            })
        })
        .collect()
}

/// A scalar and a vector, each under its name: `real: 0.8, imag: (…)`.
pub(crate) fn split_quaternion(quantities: &Quantities<'_>, context: &Context) -> Option<Found> {
    let vector = quantities.groups.iter().find(|group| {
        group.numbers.len() == 3 && Meaning::of(&group.path).role == Some(Role::Vector)
    })?;
    let scalar = quantities
        .named
        .iter()
        .filter(|named| named.scope == vector.scope)
        .flat_map(|named| &named.members)
        .find(|member| matches!(member.name.as_str(), "real" | "s" | "w" | "scalar" | "re"))?;
    let numbers = [
        scalar.value,
        vector.numbers[0],
        vector.numbers[1],
        vector.numbers[2],
    ];
    let _ = context;
    let rotation = quaternion(
        &numbers,
        (ComponentOrder::ScalarFirst, OrderSource::Grouped),
    )?;
    Some(Found {
        made: Made::Rotation(rotation),
        label: label_of(&vector.path[..vector.path.len() - 1]),
        span: scalar.span.to(vector.span),
        is_derived: Meaning::of(&vector.path).role == Some(Role::Derived),
        is_computed: vector.is_computed || scalar.is_computed,
        format: None,
        has_rows: true,
    })
}

/// An axis and an angle, each under its name.
pub(crate) fn axis_beside_angle(quantities: &Quantities<'_>, context: &Context) -> Option<Found> {
    let role = |path: &[&str]| Meaning::of(path).role;
    let group = quantities
        .groups
        .iter()
        .find(|group| group.numbers.len() == 3 && role(&group.path) == Some(Role::Axis));
    let named_axis = || {
        quantities.named.iter().find_map(|named| {
            let mut path = named.path.clone();
            path.push(&named.stem);
            (role(&path) == Some(Role::Axis) && named.members.len() == 3).then(|| {
                let numbers: Vec<f64> = named.members.iter().map(|member| member.value).collect();
                let span = named.members[0].span.to(named.members[2].span);
                (numbers, span)
            })
        })
    };
    let (axis, axis_span) = group
        .map(|group| (group.numbers.clone(), group.span))
        .or_else(named_axis)?;
    let (angle, meaning) = quantities.named.iter().find_map(|named| {
        let member = named.members.iter().find(|member| member.name == "angle")?;
        let mut path = named.path.clone();
        path.push(&named.stem);
        Some((member, Meaning::of(&path)))
    })?;
    let numbers: Vec<f64> = axis.into_iter().chain([angle.value]).collect();
    let made = made(
        &[Part::AxisAngle(Unit::BySize)],
        &numbers,
        context.said(&meaning),
    )?;
    Some(Found {
        made: made.into_iter().next()?,
        label: "angle".to_owned(),
        span: angle.span.to(axis_span),
        is_derived: meaning.role == Some(Role::Derived),
        is_computed: angle.is_computed,
        format: None,
        has_rows: true,
    })
}
