//! The quantities of a text to what they are: the formats that are marked in it are asked first, then
//! what the names say, then the numbers themselves.

use crate::convention::angle::{AngleUnit, UnitSource};
use crate::convention::order::{ComponentOrder, OrderSource};
use crate::problem::Span;
use crate::text::description::ParsedRotation;
use crate::text::description::quaternion::ParsedQuaternion;
use crate::text::record::format::{Angles, Field, Format, Part, Unit};
use crate::text::record::group::{Group, Named, Quantities, identifiers_of, words_of};
use crate::text::record::meaning::{Meaning, Role};
use crate::text::record::parts::{Made, Said, made, quaternion, rotation_vector};

/// A quantity that was understood.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) made: Made,
    /// The name that stands before it, as written.
    pub(crate) label: String,
    pub(crate) span: Span,
    /// Whether its name says that it was made of a rotation: an inverse, a derivative.
    pub(crate) is_derived: bool,
    /// Whether a sign that computes stands at it.
    pub(crate) is_computed: bool,
    /// The format that said it; one that no word marks is only assumed.
    pub(crate) format: Option<&'static Format>,
    /// What divides the rows of nine numbers.
    pub(crate) has_rows: bool,
}

/// What a text says for all its quantities.
pub(crate) struct Context {
    pub(crate) formats: Vec<&'static Format>,
    pub(crate) declared: ComponentOrder,
    /// The order that the text tells once for all.
    pub(crate) order: Option<ComponentOrder>,
    pub(crate) unit: Option<AngleUnit>,
    /// The letters of a sequence: `_order: 'XYZ'`.
    pub(crate) letters: Option<String>,
}

impl Context {
    /// The order of four numbers whose names say this.
    fn order(&self, meaning: &Meaning) -> (ComponentOrder, OrderSource) {
        let of_formats = self.ordering().and_then(|format| format.order);
        match (meaning.order.or(self.order), of_formats) {
            (Some(order), _) => (order, OrderSource::Label),
            (None, Some(order)) => (order, OrderSource::Format),
            (None, None) => (self.declared, OrderSource::Declared),
        }
    }

    /// The format that says the order of four numbers.
    fn ordering(&self) -> Option<&'static Format> {
        let mut formats = self.formats.iter().copied();
        formats.find(|format| format.order.is_some())
    }

    fn said(&self, meaning: &Meaning) -> Said<'_> {
        Said {
            order: self.order(meaning),
            unit: meaning.unit.or(self.unit),
            sequence: meaning.sequence,
            letters: self.letters.as_deref(),
        }
    }
}

/// A field, and the format of which it is.
type Asked = (&'static Field, Option<&'static Format>);

/// All that is understood of the quantities of a text.
pub(crate) fn found(
    quantities: &Quantities<'_>,
    context: &Context,
    plain: &'static [Field],
) -> Vec<Found> {
    let mut all = Vec::new();
    let fields: Vec<Asked> = context
        .formats
        .iter()
        .copied()
        .flat_map(|format| format.fields.iter().map(move |field| (field, Some(format))))
        .chain(plain.iter().map(|field| (field, None)))
        .collect();
    let together = groups_together(quantities, context, &fields);
    let taken: Vec<Span> = together.iter().map(|found| found.span).collect();
    all.extend(together);
    for group in &quantities.groups {
        if !taken.contains(&group.span) {
            all.extend(of_group(group, context, &fields));
        }
    }
    for named in &quantities.named {
        all.extend(of_named(named, context, &fields));
    }
    all.extend(positions_beside(quantities, &all));
    all.extend(split_quaternion(quantities, context));
    all.extend(axis_beside_angle(quantities, context));
    all.extend(
        quantities
            .named
            .iter()
            .filter_map(|named| turns_by_axis(named, context)),
    );
    all.sort_by_key(|found| found.span.start);
    all
}

fn label_of(path: &[&str]) -> String {
    path.iter()
        .rev()
        .find(|key| !key.is_empty())
        .map_or("", |key| key)
        .to_owned()
}

fn of_group(group: &Group<'_>, context: &Context, fields: &[Asked]) -> Vec<Found> {
    let meaning = Meaning::of(&group.path);
    let said = Said {
        unit: group.unit.or(meaning.unit).or(context.unit),
        ..context.said(&meaning)
    };
    let of_fields = fields.iter().find_map(|(field, format)| {
        let (is_it, parts) = match field {
            Field::Under(names, parts) => (stands_under(&group.path, names), parts),
            Field::Any(parts) => (true, parts),
            Field::Row(parts) => (is_bare(group), parts),
            Field::CommaRow(parts) => (is_bare(group) && group.has_commas, parts),
            Field::Named(..) | Field::NamedUnder(..) | Field::OnlyNamed(..) | Field::Groups(_) => {
                return None;
            }
        };
        let made = is_it.then(|| made(parts, &group.numbers, said)).flatten()?;
        Some((made, *format))
    });
    let (made, format) = of_fields.unwrap_or_else(|| {
        let made = by_name(group, &meaning, said);
        let is_ordered = made.iter().any(|made| {
            matches!(
                made,
                Made::Rotation(ParsedRotation::Quaternion(ParsedQuaternion {
                    order_source: OrderSource::Format,
                    ..
                }))
            )
        });
        (made, is_ordered.then(|| context.ordering()).flatten())
    });
    made.into_iter()
        .map(|made| Found {
            made,
            label: label_of(&group.path),
            span: group.span,
            is_derived: meaning.role == Some(Role::Derived),
            is_computed: group.is_computed,
            format,
            has_rows: format.is_some() || group.rows.len() > 1 || group.numbers.len() != 9,
        })
        .collect()
}

/// Whether numbers begin a line, with no name before them in it.
fn is_bare(group: &Group<'_>) -> bool {
    group.is_line && group.path.last().is_none_or(|key| key.is_empty())
}

/// The quantities of formats that are told by their order alone, as `1,2,3|10,20,30|1,1,1`.
fn groups_together(quantities: &Quantities<'_>, context: &Context, fields: &[Asked]) -> Vec<Found> {
    for (field, format) in fields {
        let Field::Groups(parts) = field else {
            continue;
        };
        for groups in quantities.groups.windows(parts.len()) {
            let are_bare = groups[1..]
                .iter()
                .all(|group| next_key(&group.path).is_none());
            let fits = groups
                .iter()
                .zip(*parts)
                .all(|(group, part)| group.numbers.len() == part.count());
            if !are_bare || !fits {
                continue;
            }
            return groups
                .iter()
                .zip(*parts)
                .filter_map(|(group, part)| {
                    let said = context.said(&Meaning::of(&group.path));
                    let made = made(&[*part], &group.numbers, said)?;
                    Some(Found {
                        made: made.into_iter().next()?,
                        label: label_of(&group.path),
                        span: group.span,
                        is_derived: false,
                        is_computed: group.is_computed,
                        format: *format,
                        has_rows: true,
                    })
                })
                .collect();
        }
    }
    Vec::new()
}

/// The innermost name that says more than that it holds numbers.
fn next_key<'t>(path: &[&'t str]) -> Option<&'t str> {
    const HOLDERS: &str = "array list tuple vector vector3 vec3 vec3f vec4 lvecbase3f double3 float3 data values value \
                           np numpy tensor torch matrix3 float32array float64array jnp eigen f32 f64 double float coords";
    path.iter().rev().copied().find(|key| {
        let mut words = identifiers_of(key);
        !key.is_empty()
            && !words.all(|word| HOLDERS.split_whitespace().any(|holder| holder == word))
    })
}

/// Whether one of these names stands next over numbers; a letter alone only as it is.
fn stands_under(path: &[&str], names: &str) -> bool {
    let Some(key) = next_key(path) else {
        return false;
    };
    names.split('|').any(|name| {
        let lower = name.to_lowercase();
        let parts = words_of(name);
        identifiers_of(key).any(|own| own == lower)
            || (name.len() > 1
                && words_of(key)
                    .windows(parts.len().max(1))
                    .any(|own| own == parts))
    })
}

/// What numbers are by their name and count.
fn by_name(group: &Group<'_>, meaning: &Meaning, said: Said<'_>) -> Vec<Made> {
    let numbers = &group.numbers[..];
    let role = meaning.role;
    let parts = |parts: &[Part]| made(parts, numbers, said);
    let none = vec![Made::Nothing];
    if matches!(role, Some(Role::Other | Role::Time)) {
        return none;
    }
    let three = <[f64; 3]>::try_from(numbers).ok();
    match (numbers.len(), role) {
        (3, Some(Role::Position)) => parts(&[Part::Position]).unwrap_or(none),
        (3, Some(Role::Scale)) => parts(&[Part::Scale]).unwrap_or(none),
        (3, Some(Role::Euler | Role::Rotation))
            if said.sequence.is_some() || said.letters.is_some() =>
        {
            let angles = Angles::new("ZYX", Unit::BySize);
            parts(&[Part::Euler(angles)]).unwrap_or(none)
        }
        (3, Some(Role::RotationVector)) => {
            let unit = said
                .unit
                .map_or(UnitSource::Assumed(AngleUnit::Radians), UnitSource::Written);
            three.map_or(none, |numbers| {
                vec![Made::Rotation(rotation_vector(numbers, unit))]
            })
        }
        (4, Some(Role::AxisAngle)) => parts(&[Part::AxisAngle(Unit::BySize)]).unwrap_or(none),
        (
            4,
            None
            | Some(Role::Rotation | Role::Quaternion | Role::Vector | Role::Derived | Role::Matrix),
        ) => {
            let rotation = quaternion(numbers, said.order);
            rotation.map_or(none, |rotation| vec![Made::Rotation(rotation)])
        }
        (7, _) => parts(&[Part::Position, Part::Quaternion(None)])
            .or_else(|| parts(&[Part::Quaternion(None), Part::Position]))
            .unwrap_or(none),
        (8, _) => parts(&[Part::Time, Part::Position, Part::Quaternion(None)]).unwrap_or(none),
        (9, _) if meaning.by_columns => parts(&[Part::Columns]).unwrap_or(none),
        (9, _) => parts(&[Part::Rows]).unwrap_or(none),
        (12, _) if meaning.by_columns => parts(&[Part::HomogeneousColumns(12)]).unwrap_or(none),
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

/// The only reading that there is.
fn only<const COUNT: usize>(readings: [Option<Vec<Made>>; COUNT]) -> Option<Vec<Made>> {
    let mut found = readings.into_iter().flatten();
    let first = found.next()?;
    found.next().is_none().then_some(first)
}

fn of_named(named: &Named<'_>, context: &Context, fields: &[Asked]) -> Vec<Found> {
    let mut path = named.path.clone();
    path.push(&named.stem);
    let meaning = Meaning::of(&path);
    let mut left: Vec<&_> = named.members.iter().collect();
    let mut all = Vec::new();
    for (field, format) in fields {
        let (names, parts) = match field {
            Field::OnlyNamed(names, parts) if named.members.len() == names.split(' ').count() => {
                (names, parts)
            }
            Field::Named(names, parts) => (names, parts),
            Field::NamedUnder(above, names, parts) if stands_under(&path, above) => (names, parts),
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
        let numbers: Vec<f64> = members.iter().map(|member| member.value).collect();
        let mut said = context.said(&meaning);
        let unit = members.iter().find_map(|member| member.unit);
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
        let Some(made) = made(&parts, &numbers, said) else {
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

/// Three numbers without a name in the brackets that hold four numbers of a quaternion: `((x, y, z), (…))`.
fn positions_beside(quantities: &Quantities<'_>, found: &[Found]) -> Vec<Found> {
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
fn split_quaternion(quantities: &Quantities<'_>, context: &Context) -> Option<Found> {
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
fn axis_beside_angle(quantities: &Quantities<'_>, context: &Context) -> Option<Found> {
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

/// One turn after the other about moving axes, by their names: `rotateY(10deg) rotateX(20deg) rotateZ(30deg)`,
/// and the channels of BVH.
fn turns_by_axis(named: &Named<'_>, context: &Context) -> Option<Found> {
    let of_stem = named.stem.ends_with("rotate");
    let axis = |name: &str| -> Option<char> {
        let letter = if of_stem {
            name
        } else {
            name.strip_suffix("rotation")?
        };
        matches!(letter, "x" | "y" | "z").then(|| letter.chars().next())?
    };
    let turns: Vec<_> = named
        .members
        .iter()
        .filter_map(|member| Some((axis(&member.name)?, member)))
        .collect();
    let [(first, one), (second, two), (third, three)] = turns[..] else {
        return None;
    };
    let letters: String = [first, second, third]
        .iter()
        .map(char::to_ascii_uppercase)
        .collect();
    let meaning = Meaning::default();
    let unit = [one, two, three].iter().find_map(|member| member.unit);
    let said = Said {
        letters: Some(&letters),
        unit: unit.or(context.unit),
        ..context.said(&meaning)
    };
    let angles = Angles::new(
        "XYZ",
        if of_stem {
            Unit::BySize
        } else {
            Unit::Always(AngleUnit::Degrees)
        },
    );
    let numbers = [one.value, two.value, three.value];
    let made = made(&[Part::Euler(angles)], &numbers, said)?;
    Some(Found {
        made: made.into_iter().next()?,
        label: label_of(&named.path),
        span: one.span.to(three.span),
        is_derived: false,
        is_computed: [one, two, three].iter().any(|member| member.is_computed),
        format: None,
        has_rows: true,
    })
}
