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
    let css: Vec<Turn> = quantities
        .named
        .iter()
        .filter(|named| named.stem.ends_with("rotate"))
        .flat_map(|named| turns_of(named, |name| Some(name.to_owned())))
        .collect();
    let elements: Vec<Turn> = quantities.groups.iter().filter_map(of_element).collect();
    let product: Vec<Turn> = quantities
        .groups
        .iter()
        .filter_map(|group| of_product(group, quantities))
        .collect();
    let mut found: Vec<Found> = [
        (css, Unit::BySize),
        (elements, Unit::Usually(AngleUnit::Degrees)),
        (product, Unit::Always(AngleUnit::Radians)),
    ]
    .into_iter()
    .filter_map(|(turns, unit)| together(&turns, "", unit, context))
    .collect();
    for named in &quantities.named {
        let of_joint = |name: &str| name.strip_suffix("rotation").map(str::to_owned);
        let turns: Vec<Turn> = turns_of(named, of_joint).collect();
        if turns.len() == 3 {
            let label = label_of(&named.path);
            let unit = Unit::Always(AngleUnit::Degrees);
            found.extend(together(&turns, &label, unit, context));
        }
    }
    found
}

/// The turns among numbers by name, whose axes `axis` finds in the names.
fn turns_of<'n>(
    named: &'n Named<'_>,
    axis: impl Fn(&str) -> Option<String> + 'n,
) -> impl Iterator<Item = Turn> + 'n {
    named.members.iter().filter_map(move |member| {
        let axis = axis(&member.name)?;
        ["x", "y", "z"].contains(&axis.as_str()).then(|| Turn {
            axis: axis.chars().next().unwrap_or(' '),
            angle: member.value,
            unit: member.unit,
            span: member.span,
            is_computed: member.is_computed,
        })
    })
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
    let mut letters: String = turns.iter().map(|turn| turn.axis).collect();
    let mut numbers: Vec<f64> = turns.iter().map(|turn| turn.angle).collect();
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
        unit: turns.iter().find_map(|turn| turn.unit).or(context.unit),
        ..context.said(&meaning)
    };
    let made = made(&[Part::Euler(Angles::new("XYZ", unit))], &numbers, said)?;
    Some(Found {
        made: made.into_iter().next()?,
        label: label.to_owned(),
        span: first.span.to(turns.last()?.span),
        is_derived: false,
        is_computed: turns.iter().any(|turn| turn.is_computed),
        format: None,
        has_rows: true,
    })
}
