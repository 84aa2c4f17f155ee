//! What numbers are that stand together.

use crate::convention::angle::{AngleUnit, UnitSource};
use crate::convention::order::OrderSource;
use crate::text::description::ParsedRotation;
use crate::text::description::quaternion::ParsedQuaternion;
use crate::text::record::described::Described;
use crate::text::record::format::{Angles, Field, Format, Part, Unit};
use crate::text::record::found::{Asked, Context, Found, label_of, stands_under};
use crate::text::record::group::Quantities;
use crate::text::record::meaning::{Meaning, Role};
use crate::text::record::parts::{Made, Said, made, quaternion, rotation_vector};
use crate::text::record::quantity::{Group, own_key};
use crate::text::vocabulary::constructors::{Call, call};
use nalgebra::Vector4;

/// Adds what a group is.
pub(crate) fn of_group(
    group: &Group<'_>,
    context: &Context,
    fields: &[Asked],
    all: &mut Vec<Found>,
) {
    let meaning = Meaning::of(&group.path).with_remark(group.remark);
    let said = Said {
        unit: group.unit.or(meaning.unit).or(context.unit),
        ..context.said(&meaning)
    };
    let mut of_fields = None;
    for (field, format) in fields {
        let (is_it, parts) = match field {
            Field::Under(names, parts) => (stands_under(&group.path, names), parts),
            Field::Any(parts) => (true, parts),
            Field::Row(parts) => (is_bare(group), parts),
            Field::CommaRow(parts) => (is_bare(group) && group.has_commas, parts),
            Field::Named(..)
            | Field::NamedUnder(..)
            | Field::OnlyNamed(..)
            | Field::Groups(_)
            | Field::VectorThenAngle(_)
            | Field::AngleThenVector(_)
            | Field::Sentence(..) => continue,
        };
        if is_it && let Some(made) = made(parts, &group.numbers, said) {
            of_fields = Some((made, *format));
            break;
        }
    }
    let (made, format) = of_fields.unwrap_or_else(|| {
        let made = by_name(group, &meaning, context, said);
        let is_ordered = made.iter().any(|made| {
            matches!(
                made,
                Made::Rotation(ParsedRotation::Quaternion(ParsedQuaternion {
                    order_source: OrderSource::Format,
                    ..
                }))
            )
        });
        (made, context.ordering.filter(|_| is_ordered))
    });
    let found = Found {
        label: label_of(&group.path),
        is_derived: meaning.role == Some(Role::Derived),
        is_computed: group.is_computed || (group.is_of_unknown_call && format.is_none()),
        format,
        has_rows: format.is_some() || group.rows.len() > 1 || !is_square(group, &made),
        ..Found::at(group.span)
    };
    found.add_parts(made, all);
}

/// Whether numbers of a matrix may be rows or columns as well: a translation would tell which.
fn is_square(group: &Group<'_>, made: &[Made]) -> bool {
    let has_translation = made
        .iter()
        .any(|made| matches!(made, Made::Position(numbers) if *numbers != [0.0; 3]));
    match group.numbers.len() {
        9 => true,
        16 => !has_translation,
        _ => false,
    }
}

/// Whether numbers begin a line, with no name before them in it.
fn is_bare(group: &Group<'_>) -> bool {
    group.is_line && group.path.last().is_none_or(|key| key.is_empty())
}

/// The quantities of formats that are told by their order alone, as `1,2,3|10,20,30|1,1,1`.
pub(crate) fn groups_together(
    quantities: &Quantities<'_>,
    context: &Context,
    fields: &[Asked],
) -> Vec<Found> {
    for (field, format) in fields {
        let Field::Groups(all_parts) = field else {
            continue;
        };
        for groups in quantities.groups.windows(all_parts.len()) {
            let are_bare = groups[1..].iter().all(|group| {
                group.path.last().is_none_or(|key| key.is_empty())
                    && group.path.len() <= groups[0].path.len() + 1
            });
            if !are_bare {
                continue;
            }
            if let Some(found) = of_groups(groups, all_parts, context, *format) {
                return found;
            }
        }
    }
    Vec::new()
}

/// What groups are, each of which has parts of its own; `None` where one has not.
fn of_groups(
    groups: &[Group<'_>],
    all_parts: &[&[Part]],
    context: &Context,
    format: Option<&'static Format>,
) -> Option<Vec<Found>> {
    let mut all = Vec::new();
    for (group, parts) in groups.iter().zip(all_parts) {
        let said = context.said(&Meaning::of(&group.path));
        let found = Found {
            label: label_of(&group.path),
            is_computed: group.is_computed,
            format,
            ..Found::at(group.span)
        };
        found.add_parts(made(parts, &group.numbers, said)?, &mut all);
    }
    Some(all)
}

/// An axis in brackets and the angle behind or before them, `(Vector((0, 0, 1)), 0.5)`, or a factor of them before
/// it; no more than one, whose product with others is another rotation.
pub(crate) fn vector_then_angle(
    text: &str,
    quantities: &Quantities<'_>,
    context: &Context,
    fields: &[Asked],
) -> Option<Found> {
    let (unit, format, angle_first) = fields.iter().find_map(|(field, format)| match field {
        Field::VectorThenAngle(unit) => Some((*unit, *format, false)),
        Field::AngleThenVector(unit) => Some((*unit, *format, true)),
        _ => None,
    })?;
    let [one, other] = &quantities.groups[..] else {
        return None;
    };
    let (before, behind) = (&text[..one.span.start], &text[other.span.end..]);
    let mut beside = (before.bytes().rev()).take_while(|byte| !b"=;\n".contains(byte));
    let mut statement = behind.bytes().take_while(|byte| !b";\n".contains(byte));
    if one.is_of_unknown_call
        || beside.any(|byte| byte == b'*')
        || statement.any(|byte| b"*.".contains(&byte))
    {
        return None;
    }
    let is_factor = before.ends_with('(') && text[one.span.end..].starts_with(" *");
    let (part, numbers) = match (&one.numbers[..], &other.numbers[..]) {
        (&[angle], &[x, y, z]) if angle_first && !one.is_computed => {
            (Part::AxisAngle(unit), [x, y, z, angle])
        }
        (&[x, y, z], &[angle]) if !angle_first && !one.is_computed => {
            (Part::AxisAngle(unit), [x, y, z, angle])
        }
        (&[factor], &[x, y, z]) if is_factor => (
            Part::RotationVector(AngleUnit::Radians),
            [factor * x, factor * y, factor * z, 0.0],
        ),
        _ => return None,
    };
    let said = context.said(&Meaning::of(&one.path));
    Some(Found {
        made: made(&[part], &numbers[..part.count()], said)?.pop()?,
        format,
        ..Found::at(one.span.to(other.span))
    })
}

/// What numbers are by their name and count.
fn by_name(group: &Group<'_>, meaning: &Meaning, context: &Context, said: Said<'_>) -> Vec<Made> {
    let numbers = &group.numbers[..];
    let role = meaning.role;
    let parts = |parts: &[Part]| made(parts, numbers, said);
    let none = vec![Made::Nothing];
    if matches!(role, Some(Role::Other | Role::Rate | Role::Time)) {
        return none;
    }
    // A component is one number, and lengths are no components.
    let own = own_key(group).to_ascii_lowercase();
    let is_component = ["w", "x", "y", "z"].contains(&own.as_str()) && numbers.len() > 3;
    let is_unnamed = ["let", "var", "const", "static", "auto"].contains(&own.as_str());
    if is_component || is_unnamed || (group.has_lengths && numbers.len() == 4) {
        return none;
    }
    // Rows of different lengths: only the last of a list that was wrapped is shorter.
    let is_wrapped = group.rows.split_last().is_none_or(|(last, before)| {
        let first = before.first().unwrap_or(last);
        before.iter().all(|row| row == first) && last <= first
    });
    if !is_wrapped && numbers.len() <= 8 {
        return none;
    }
    // Two orders are told.
    if let (Some(own), Some(all)) = (meaning.order, said.order_of_text)
        && own != all
        && numbers.len() == 4
    {
        return none;
    }
    // A matrix has no unit.
    if group.unit.is_some() && numbers.len() == 9 {
        return none;
    }
    // `rvecs`, `axes`: several of something else.
    let is_several = matches!(
        role,
        Some(Role::RotationVector | Role::Euler | Role::Axis | Role::Scale | Role::AxisAngle)
    );
    if is_several && numbers.len() >= 9 {
        return none;
    }
    if let Some(several) = several_quaternions(group, said) {
        return several;
    }
    let three = <[f64; 3]>::try_from(numbers).ok();
    let says_nothing = matches!(role, None | Some(Role::Vector | Role::Angle | Role::Euler));
    match (context.described, three) {
        (Some(Described::Euler(sequence)), Some(_)) if says_nothing => {
            let said = Said {
                sequence: Some(sequence),
                ..said
            };
            let angles = Angles::new("ZYX", Unit::BySize);
            return made(&[Part::Euler(angles)], numbers, said).unwrap_or(none);
        }
        (Some(Described::RotationVector), Some(numbers)) if says_nothing => {
            return vec![Made::Rotation(rotation_vector(numbers, vector_unit(said)))];
        }
        _ => {}
    }
    match (numbers.len(), role) {
        (3, Some(Role::Position)) => parts(&[Part::Position]).unwrap_or(none),
        (3, Some(Role::Scale)) => parts(&[Part::Scale]).unwrap_or(none),
        (3, Some(Role::Euler | Role::Rotation)) if said.sequence.is_some() => {
            let angles = Angles::new("ZYX", Unit::BySize);
            parts(&[Part::Euler(angles)]).unwrap_or(none)
        }
        (3, Some(Role::Euler)) => three.map_or(none, |three| vec![Made::Angles(three, said.unit)]),
        (3, Some(Role::RotationVector)) => three.map_or(none, |numbers| {
            vec![Made::Rotation(rotation_vector(numbers, vector_unit(said)))]
        }),
        (4, Some(Role::AxisAngle)) => parts(&[Part::AxisAngle(Unit::BySize)]).unwrap_or(none),
        (4, None | Some(Role::Rotation | Role::Quaternion | Role::Derived | Role::Matrix))
            if !meaning.by_columns =>
        {
            let rotation = quaternion(numbers, said.order)
                .map(|rotation| of_unknown_constructor(rotation, group));
            rotation.map_or(none, |rotation| vec![Made::Rotation(rotation)])
        }
        (6, _) if said.sequence.is_some() => {
            let angles = Angles::new("ZYX", Unit::BySize);
            parts(&[Part::Position, Part::Euler(angles)]).unwrap_or(none)
        }
        (7, _) => parts(&[Part::Position, Part::Quaternion(None)])
            .or_else(|| parts(&[Part::Quaternion(None), Part::Position]))
            .unwrap_or(none),
        (8, _) => parts(&[Part::Time, Part::Position, Part::Quaternion(None)]).unwrap_or(none),
        (9, _) if meaning.by_columns => parts(&[Part::Columns]).unwrap_or(none),
        // Which of nine numbers in a row are a row of a matrix is the library's.
        (9, _) if group.is_of_call && group.rows.len() == 1 => none,
        (9, _) => parts(&[Part::Rows]).unwrap_or(none),
        (12, _) if meaning.by_columns => parts(&[Part::HomogeneousColumns(12)]).unwrap_or(none),
        // Of bare numbers no other reading may be possible.
        (12, None) if own.is_empty() => match parts(&[Part::Rows, Part::Position]) {
            Some(_) => none,
            None => parts(&[Part::HomogeneousRows(12)]).unwrap_or(none),
        },
        (12, _) => only([
            parts(&[Part::HomogeneousRows(12)]),
            parts(&[Part::Rows, Part::Position]),
            parts(&[Part::Position, Part::Rows]),
        ])
        .unwrap_or(none),
        (16, _) if meaning.by_columns => parts(&[Part::HomogeneousColumns(16)]).unwrap_or(none),
        (16, _) => parts(&[Part::HomogeneousRows(16)])
            .or_else(|| parts(&[Part::HomogeneousColumns(16)]))
            .unwrap_or(none),
        _ => none,
    }
}

/// With the name of the call that makes it, where its order is not known.
fn of_unknown_constructor(rotation: ParsedRotation, group: &Group<'_>) -> ParsedRotation {
    match rotation {
        ParsedRotation::Quaternion(parsed)
            if group.is_of_call && parsed.order_source == OrderSource::Declared =>
        {
            let unknown = own_key(group)
                .split([' ', '\t', '='])
                .find(|name| matches!(call(name), Call::Unordered));
            ParsedRotation::Quaternion(ParsedQuaternion {
                unknown_constructor: unknown.map(str::to_owned),
                ..parsed
            })
        }
        other => other,
    }
}

/// What two decimals change a norm of four numbers by, at most.
const ROUNDING_OF_TWO_DECIMALS: f64 = 0.01;

/// Rows of four numbers of norm 1 that are no matrix.
fn several_quaternions(group: &Group<'_>, said: Said<'_>) -> Option<Vec<Made>> {
    let (rows, rest) = group.numbers.as_chunks::<4>();
    if rows.len() < 2 || !rest.is_empty() || group.rows.iter().any(|row| *row != 4) {
        return None;
    }
    let is_matrix = |part: Part| made(&[part], &group.numbers, said).is_some();
    if is_matrix(Part::Homogeneous(16)) || is_matrix(Part::HomogeneousRows(12)) {
        return None;
    }
    let mut several = Vec::new();
    for row in rows {
        // Those of a projective matrix may nearly have it.
        let norm = Vector4::from(*row).norm();
        if (norm - 1.0).abs() > ROUNDING_OF_TWO_DECIMALS {
            return None;
        }
        several.push(Made::Rotation(quaternion(row, said.order)?));
    }
    Some(several)
}

/// The unit of a rotation vector whose name tells none.
fn vector_unit(said: Said<'_>) -> UnitSource {
    said.unit
        .map_or(UnitSource::Assumed(AngleUnit::Radians), UnitSource::Written)
}

/// The only reading that there is.
fn only(readings: [Option<Vec<Made>>; 3]) -> Option<Vec<Made>> {
    match readings {
        [Some(only), None, None] | [None, Some(only), None] | [None, None, Some(only)] => {
            Some(only)
        }
        _ => None,
    }
}
