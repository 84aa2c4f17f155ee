//! One turn after the other about moving axes.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::text::record::format::{Angles, Part, Unit};
use crate::text::record::found::{Context, Found, label_of};
use crate::text::record::group::Quantities;
use crate::text::record::meaning::Meaning;
use crate::text::record::parts::{Said, made};
use crate::text::record::quantity::{Group, Named};

/// A turn about an axis.
struct Turn {
    axis: char,
    angle: f64,
    unit: Option<AngleUnit>,
    span: Span,
    is_computed: bool,
}

/// The turns of a text, each about an axis of the one before: `rotateY(10deg) rotateX(20deg)` of CSS, the
/// elements `rotate` of COLLADA, the product of angles and axes of Eigen, the channels of BVH.
pub(crate) fn turns(quantities: &Quantities<'_>, context: &Context) -> Vec<Found> {
    let (mut css, mut elements, mut product) = (Vec::new(), Vec::new(), Vec::new());
    for named in &quantities.named {
        if named.stem.ends_with("rotate") {
            add_turns(named, "", &mut css);
        }
    }
    for group in &quantities.groups {
        elements.extend(of_element(group));
        product.extend(of_product(group, quantities));
    }
    let mut found = Vec::new();
    found.extend(together(&css, "", Unit::BySize, context));
    let degrees = Unit::Usually(AngleUnit::Degrees);
    found.extend(together(&elements, "", degrees, context));
    let radians = Unit::Always(AngleUnit::Radians);
    found.extend(together(&product, "", radians, context));
    for named in &quantities.named {
        let mut turns = Vec::new();
        add_turns(named, "rotation", &mut turns);
        if turns.len() == 3 {
            let label = label_of(&named.path);
            let unit = Unit::Always(AngleUnit::Degrees);
            found.extend(together(&turns, &label, unit, context));
        }
    }
    found
}

/// Adds the turns among numbers by name: those whose names are an axis and this behind it.
fn add_turns(named: &Named<'_>, behind_axis: &str, turns: &mut Vec<Turn>) {
    for member in &named.members {
        let axis = match member.name.strip_suffix(behind_axis) {
            Some("x") => 'x',
            Some("y") => 'y',
            Some("z") => 'z',
            _ => continue,
        };
        turns.push(Turn {
            axis,
            angle: member.value,
            unit: member.unit,
            span: member.span,
            is_computed: member.is_computed,
        });
    }
}

/// `<rotate sid="rotationZ">0 0 1 25</rotate>`: an axis of the coordinates, and the angle.
fn of_element(group: &Group<'_>) -> Option<Turn> {
    let is_rotate = group.path.contains(&"rotate");
    let &[x, y, z, angle] = &group.numbers[..] else {
        return None;
    };
    let axis = match [x, y, z] {
        [1.0, 0.0, 0.0] => 'x',
        [0.0, 1.0, 0.0] => 'y',
        [0.0, 0.0, 1.0] => 'z',
        _ => return None,
    };
    is_rotate.then_some(Turn {
        axis,
        angle,
        unit: None,
        span: group.span,
        is_computed: group.is_computed,
    })
}

/// `AngleAxisd(0.1, Vector3d::UnitZ())`: the axis is the word behind the angle.
fn of_product(group: &Group<'_>, quantities: &Quantities<'_>) -> Option<Turn> {
    let &[angle] = &group.numbers[..] else {
        return None;
    };
    if !group.path.iter().any(|key| key.contains("AngleAxis")) {
        return None;
    }
    let values = &quantities.values;
    let next = values.partition_point(|value| value.span.start < group.span.end);
    let next = values.get(next)?;
    let axis = next.text.split_once("Unit")?.1.chars().next()?;
    Some(Turn {
        axis: axis.to_ascii_lowercase(),
        angle,
        unit: group.unit,
        span: group.span,
        is_computed: false,
    })
}

/// Up to three turns as angles of a sequence; those that are not there are zero.
fn together(turns: &[Turn], label: &str, unit: Unit, context: &Context) -> Option<Found> {
    let first = turns.first()?;
    let mut letters = String::new();
    let mut numbers = Vec::new();
    let mut found = Found {
        label: label.to_owned(),
        ..Found::at(first.span)
    };
    let mut told_unit = None;
    for turn in turns {
        letters.push(turn.axis);
        numbers.push(turn.angle);
        found.span = found.span.to(turn.span);
        found.is_computed |= turn.is_computed;
        told_unit = told_unit.or(turn.unit);
    }
    for axis in ['x', 'y', 'z'] {
        if letters.len() < 3 && !letters.contains(axis) {
            letters.push(axis);
            numbers.push(0.0);
        }
    }
    let letters = letters.to_ascii_uppercase();
    let meaning = Meaning::default();
    let said = Said {
        sequence: None,
        letters: Some(&letters),
        unit: told_unit.or(context.unit),
        ..context.said(&meaning)
    };
    found.made = made(&[Part::Euler(Angles::new("XYZ", unit))], &numbers, said)?.pop()?;
    Some(found)
}
