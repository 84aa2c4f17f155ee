//! One turn after the other about moving axes.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::text::record::format::{Angles, Part, Unit};
use crate::text::record::found::{Context, Found, label_of};
use crate::text::record::group::Quantities;
use crate::text::record::meaning::Meaning;
use crate::text::record::names::is_factor;
use crate::text::record::parts::{Said, made};
use crate::text::record::quantity::{Group, Named};
use crate::text::vocabulary::is_listed;

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
pub(crate) fn turns(text: &str, quantities: &Quantities<'_>, context: &Context) -> Vec<Found> {
    let (mut css, mut elements) = (Vec::new(), Vec::new());
    for named in &quantities.named {
        if named.stem.ends_with("rotate") {
            add_turns(named, "", &mut css);
        }
    }
    for group in &quantities.groups {
        if group.path.contains(&"rotate") {
            elements.extend(of_element(group));
        }
    }
    let mut found = Vec::new();
    found.extend(together(&css, "", Unit::BySize, context));
    let degrees = Unit::Usually(AngleUnit::Degrees);
    found.extend(together(&elements, "", degrees, context));
    let radians = Unit::Always(AngleUnit::Radians);
    let mut product = Vec::new();
    let are_known = add_product(text, quantities, &mut product);
    let mut signs = product.len().saturating_sub(1);
    // `R_z(0.4) R_y(0.2)` turns forward in one book and back in the other: a comment has to say what it makes.
    if product.is_empty() && context.described.is_some() {
        signs = 0;
        for named in &quantities.named {
            if named.stem.ends_with('r') {
                add_turns(named, "", &mut product);
            }
        }
    }
    if are_known && stands_alone(text, &product, signs) {
        for turn in &mut product {
            turn.is_computed = false;
        }
        found.extend(together(&product, "", radians, context));
    }
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

/// `<rotate sid="rotationZ">0 0 1 25</rotate>`, `axang2rotm([0 0 1 0.4])`: an axis of the coordinates, and the
/// angle.
fn of_element(group: &Group<'_>) -> Option<Turn> {
    let &[x, y, z, angle] = &group.numbers[..] else {
        return None;
    };
    let axis = match [x, y, z] {
        [1.0, 0.0, 0.0] => 'x',
        [0.0, 1.0, 0.0] => 'y',
        [0.0, 0.0, 1.0] => 'z',
        _ => return None,
    };
    Some(Turn {
        axis,
        angle,
        unit: None,
        span: group.span,
        is_computed: group.is_computed,
    })
}

/// What may stand between the angles of a product and behind them.
const WORDS_OF_PRODUCTS: &str = "Eigen AngleAxis AngleAxisd AngleAxisf Vector3d Vector3f UnitX UnitY UnitZ \
    UnitQuaternion from_axis_angle Vector3 x_axis y_axis z_axis na nalgebra axang2rotm axang2quat R_x R_y R_z \
    toRotationMatrix matrix normalized";

/// Adds the factors of a product of calls; whether each of its calls turns about an axis of the coordinates.
fn add_product(text: &str, quantities: &Quantities<'_>, product: &mut Vec<Turn>) -> bool {
    for group in &quantities.groups {
        if !group.path.iter().any(|key| is_factor(key)) {
            continue;
        }
        let turn = match group.numbers[..] {
            // The axis is a letter of the word behind the angle, or of that before it.
            [angle] => {
                let Span { start, end } = group.span;
                let behind = text[end..].split('(').next().unwrap_or("");
                let before = text[..start].rfind('_').map_or("", |at| &text[..at]);
                let word = if behind.contains("::Unit") {
                    behind
                } else {
                    before
                };
                word.chars().last().map(|axis| Turn {
                    axis: axis.to_ascii_lowercase(),
                    angle,
                    unit: group.unit,
                    span: group.span,
                    is_computed: false,
                })
            }
            _ => of_element(group),
        };
        match turn {
            Some(turn) => product.push(turn),
            None => return false,
        }
    }
    true
}

/// Whether nothing but the factors stands in the statement of a product, with so many signs between them.
fn stands_alone(text: &str, product: &[Turn], signs: usize) -> bool {
    let ([first, ..], [.., last]) = (product, product) else {
        return false;
    };
    let mut start = 0;
    let mut found = 0;
    let mut end = text.len();
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'=' | b'\n' | b';' if at < first.span.start => (start, found) = (at + 1, 0),
            b'\n' | b';' if at >= last.span.end => {
                end = at;
                break;
            }
            b'*' => found += 1,
            // No product has so many.
            b'+' | b'/' | b'\'' | b'=' | b'^' => found += product.len(),
            _ => {}
        }
    }
    let mut words = text[start..end].split(|mark: char| !(mark.is_alphanumeric() || mark == '_'));
    found == signs
        && words.all(|word| {
            word.is_empty()
                || word.as_bytes()[0].is_ascii_digit()
                || is_listed(word, WORDS_OF_PRODUCTS)
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
