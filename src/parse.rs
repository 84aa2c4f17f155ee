//! Text to numbers: everything people paste, and nothing about rotations.
//!
//! What comes in is text as typed; what goes out is four (or three) finite
//! numbers by name, and how the text told which number is which.
//!
//! # What is accepted
//!
//! | form | example |
//! |---|---|
//! | numbers, in any brackets or none | `0.92 0 0 0.38`, `[0, 0, 0.38, 0.92]` |
//! | named components, in any order | `(w=0.92, x=0, y=0, z=0.38)`, `qx: 0 …` |
//! | a ROS message, YAML, JSON, a dictionary | `x: 0.0⏎y: 0.0⏎z: 0.38⏎w: 0.92`, `{"w": 0.92, …}` |
//! | a sum of units, in any order | `0.92 + 0.38k`, `k sin(pi/8) + cos(pi/8)` |
//! | scalar and vector | `0.92 [0, 0, 0.38]`, `[[0, 0, 0.38], 0.92]` |
//! | a constructor call | `Eigen::Quaterniond(0.92, 0, 0, 0.38)`, `Rotation.from_quat([0, 0, 0.38, 0.92])` |
//!
//! # Grammar
//!
//! ```text
//! text     = members
//! members  = { member [","] }              white space, "," and ";" separate
//! member   = { name (":" | "=") } sum
//! sum      = product { ("+" | "-") product }
//! product  = signed { ("*" | "/") signed | atom | "deg" | "°" }
//! signed   = { "+" | "-" } atom
//! atom     = number | "i" | "j" | "k" | "pi" | "tau"
//!          | function "(" sum ")" | "√" atom
//!          | ("(" | "[" | "{") members (")" | "]" | "}")
//!          | name { name } "(" members ")"
//! function = "sqrt" | "abs" | "sin" | "cos" | "tan" | "asin" | "acos" | "atan"
//! ```
//!
//! - `1 -2` is two numbers, as in MATLAB; `1 - 2` and `1-2` are one.
//! - Standing beside means product where nothing else can be meant: `0.38k`, `2pi`, `√2/2 k`. It
//!   binds like `*`, from left to right: `1/2k` is half of k.
//! - `−` (U+2212), `–`, `·`, `×`, `÷`, `√`, `π`, `½` mean what they look like.
//! - Comments (`#`, `//`), declarations (`const Eigen::Quaterniond q(…);`), float suffixes (`0.5f`)
//!   and casts (`np.float64(0.5)`) are read past.
//!
//! # Which number is the scalar
//!
//! Names, units, groups and known constructors tell it; then the text wins over the declared order,
//! and [`ParsedQuaternion::order_source`] says so. Otherwise the declared order is used.

use crate::constructor;
use crate::convention::ComponentOrder;
use crate::lex::{self, MAX_TEXT_BYTES};
use crate::linear::Linear;
use crate::messages::{Fault, Wanted};
use crate::problem::{Field, Problem, Span};
use crate::report::OrderSource;
use crate::syntax;
use crate::tree::{Entry, Lead, NodeKind};
use nalgebra::{Quaternion, Vector3};
use std::borrow::Cow;

/// Four finite numbers, and how the text told which is which.
#[derive(Clone, Debug, PartialEq)]
pub struct ParsedQuaternion {
    /// The components by name.
    pub quaternion: Quaternion<f64>,
    /// The order that was used: the text's own, or else the declared one.
    pub order: ComponentOrder,
    /// How that order was told.
    pub order_source: OrderSource,
    /// The name of a call that is not known here, so that its order is only assumed.
    pub unknown_constructor: Option<String>,
}

/// The quaternion that a text holds.
///
/// `declared` is used where the text itself does not tell its order.
///
/// # Errors
///
/// The first problem of the text; its span counts bytes. A zero quaternion is no problem here.
///
/// ```
/// use quatlas::{ComponentOrder, Field, OrderSource, parse_quaternion};
///
/// // The constructor's order wins: the scalar is the first number.
/// let text = "Eigen::Quaterniond(1/2, -1/2, 1/√2, 0)";
/// let parsed = parse_quaternion(text, Field::Quaternion, ComponentOrder::ScalarLast)?;
/// assert_eq!((parsed.quaternion.w, parsed.quaternion.i), (0.5, -0.5));
/// assert_eq!(parsed.order_source, OrderSource::Constructor);
///
/// let problem = parse_quaternion("1 0 0", Field::Quaternion, ComponentOrder::ScalarFirst);
/// assert_eq!(problem.unwrap_err().to_string(), "3 numbers in place of 4");
/// # Ok::<(), quatlas::Problem>(())
/// ```
pub fn parse_quaternion(
    text: &str,
    field: Field,
    declared: ComponentOrder,
) -> Result<ParsedQuaternion, Problem> {
    let hint = OrderHint {
        order: declared,
        source: OrderSource::Declared,
        unknown_constructor: None,
    };
    read(text, Wanted::Quaternion)
        .and_then(|(entries, span)| quaternion(&entries, span, hint))
        .map_err(|fault| fault.in_field(field))
}

/// The vector that a text holds: three numbers, named components, or a sum of i, j and k.
///
/// # Errors
///
/// The first problem of the text; its span counts bytes.
///
/// ```
/// use quatlas::{Field, parse_vector};
/// assert_eq!(parse_vector("2k - i", Field::Vector)?.as_slice(), [-1.0, 0.0, 2.0]);
/// # Ok::<(), quatlas::Problem>(())
/// ```
pub fn parse_vector(text: &str, field: Field) -> Result<Vector3<f64>, Problem> {
    read(text, Wanted::Vector)
        .and_then(|(entries, span)| vector(&entries, span))
        .map_err(|fault| fault.in_field(field))
}

fn read(text: &str, wanted: Wanted) -> Result<(Vec<Entry<'_>>, Span), Fault> {
    let start = text.len() - text.trim_start().len();
    let span = Span::from(start..text.trim_end().len().max(start));
    if text.len() > MAX_TEXT_BYTES {
        return Err(Fault::text_too_long(span, text.len(), MAX_TEXT_BYTES));
    }
    let tokens = lex::tokens(text)?;
    if tokens.is_empty() {
        return Err(Fault::empty_text(Span::from(0..text.len()), wanted));
    }
    Ok((syntax::entries(&tokens, text)?, span))
}

#[derive(Clone)]
struct OrderHint {
    order: ComponentOrder,
    source: OrderSource,
    unknown_constructor: Option<String>,
}

impl OrderHint {
    /// What a call's name says, where it says anything.
    fn of_call(self, name: &str, arguments: &[Entry<'_>]) -> Self {
        let named = scalar_first_argument(arguments).or_else(|| constructor::order_of(name));
        match named {
            Some(order) => Self {
                order,
                source: OrderSource::Constructor,
                unknown_constructor: None,
            },
            None if constructor::is_container(name) => self,
            None => Self {
                unknown_constructor: self.unknown_constructor.or_else(|| Some(name.to_owned())),
                ..self
            },
        }
    }

    fn with(self, quaternion: Quaternion<f64>) -> ParsedQuaternion {
        ParsedQuaternion {
            quaternion,
            order: self.order,
            order_source: self.source,
            unknown_constructor: self.unknown_constructor,
        }
    }
}

/// `scalar_first=True`, as in `SciPy`'s `from_quat`.
fn scalar_first_argument(arguments: &[Entry<'_>]) -> Option<ComponentOrder> {
    arguments
        .iter()
        .find(|entry| is_option(entry))
        .map(|entry| match entry.node.kind {
            NodeKind::Word("True" | "true") => ComponentOrder::ScalarFirst,
            _ => ComponentOrder::ScalarLast,
        })
}

fn is_option(entry: &Entry<'_>) -> bool {
    entry.key.is_some_and(|key| key.name == "scalar_first")
}

fn quaternion(
    entries: &[Entry<'_>],
    span: Span,
    hint: OrderHint,
) -> Result<ParsedQuaternion, Fault> {
    let entries = &without_label(entries)[..];
    if let [only] = entries
        && only.key.is_none()
    {
        match &only.node.kind {
            NodeKind::List(inner) => return quaternion(inner, only.node.span, hint),
            NodeKind::Call { name, arguments } if arguments.is_empty() => {
                return Err(Fault::unknown_word(only.node.span, name));
            }
            NodeKind::Call { name, arguments } => {
                let hint = hint.of_call(name, arguments);
                let members: Vec<_> = arguments
                    .iter()
                    .filter(|entry| !is_option(entry))
                    .cloned()
                    .collect();
                return quaternion(&members, only.node.span, hint);
            }
            NodeKind::Value(_) | NodeKind::Word(_) => {}
        }
    }
    if entries.iter().any(|entry| entry.key.is_some()) {
        let [w, x, y, z] = named(entries, span, Wanted::Quaternion)?;
        return Ok(OrderHint {
            source: OrderSource::Named,
            unknown_constructor: None,
            ..hint
        }
        .with(Quaternion::new(w, x, y, z)));
    }
    if let [first, second] = entries {
        let grouped = match (&first.node.kind, &second.node.kind) {
            (NodeKind::Value(_), NodeKind::List(inner)) => Some((
                ComponentOrder::ScalarFirst,
                &first.node,
                inner,
                &second.node,
            )),
            (NodeKind::List(inner), NodeKind::Value(_)) => {
                Some((ComponentOrder::ScalarLast, &second.node, inner, &first.node))
            }
            _ => None,
        };
        if let Some((order, scalar, inner, list)) = grouped {
            let part = vector(inner, list.span)?;
            return Ok(OrderHint {
                order,
                source: OrderSource::Grouped,
                unknown_constructor: None,
            }
            .with(Quaternion::from_parts(scalar.real()?, part)));
        }
    }
    let values = values(entries)?;
    if values.iter().any(|(value, _)| value.units.is_some()) {
        let sum = sum_of_members(entries, &values)?;
        let [x, y, z] = sum.units.unwrap_or_default();
        return Ok(OrderHint {
            source: OrderSource::Named,
            unknown_constructor: None,
            ..hint
        }
        .with(Quaternion::new(sum.scalar, x, y, z)));
    }
    let [a, b, c, d] = numbers(&values)
        .try_into()
        .map_err(|found: Vec<f64>| Fault::wrong_count(span, Wanted::Quaternion, found.len()))?;
    let quaternion = match hint.order {
        ComponentOrder::ScalarFirst => Quaternion::new(a, b, c, d),
        ComponentOrder::ScalarLast => Quaternion::new(d, a, b, c),
    };
    Ok(hint.with(quaternion))
}

fn vector(entries: &[Entry<'_>], span: Span) -> Result<Vector3<f64>, Fault> {
    let entries = &without_label(entries)[..];
    if let [only] = entries
        && only.key.is_none()
        && let NodeKind::List(inner)
        | NodeKind::Call {
            arguments: inner, ..
        } = &only.node.kind
    {
        return vector(inner, only.node.span);
    }
    if entries.iter().any(|entry| entry.key.is_some()) {
        let [_, x, y, z] = named(entries, span, Wanted::Vector)?;
        return Ok(Vector3::new(x, y, z));
    }
    let values = values(entries)?;
    if values.iter().any(|(value, _)| value.units.is_some()) {
        let sum = sum_of_members(entries, &values)?;
        if sum.scalar != 0.0 {
            return Err(Fault::scalar_in_vector(span));
        }
        return Ok(sum.units.unwrap_or_default().into());
    }
    let [x, y, z] = numbers(&values)
        .try_into()
        .map_err(|found: Vec<f64>| Fault::wrong_count(span, Wanted::Vector, found.len()))?;
    Ok(Vector3::new(x, y, z))
}

/// The members without the name of the whole, as in `q = 0.92 + 0.38k` or `orientation: [0, 0, 0, 1]`.
fn without_label<'e, 't>(entries: &'e [Entry<'t>]) -> Cow<'e, [Entry<'t>]> {
    let is_label = match entries {
        [first, rest @ ..] => {
            first.key.is_some_and(|key| component(key.name).is_none())
                && rest.iter().all(|entry| entry.key.is_none())
        }
        [] => false,
    };
    let mut entries = Cow::Borrowed(entries);
    if is_label {
        entries.to_mut()[0].key = None;
    }
    entries
}

const COMPONENT_NAMES: [&str; 4] = ["w", "x", "y", "z"];

/// The place of a component in `[w, x, y, z]`, by any of its names.
fn component(name: &str) -> Option<usize> {
    let name = name.rsplit(['.', ':']).next().unwrap_or(name);
    Some(match name.to_ascii_lowercase().as_str() {
        "w" | "qw" | "q_w" => 0,
        "x" | "qx" | "q_x" => 1,
        "y" | "qy" | "q_y" => 2,
        "z" | "qz" | "q_z" => 3,
        _ => return None,
    })
}

fn named(entries: &[Entry<'_>], span: Span, wanted: Wanted) -> Result<[f64; 4], Fault> {
    let mut found = [None; 4];
    for entry in entries {
        let Some(key) = entry.key else {
            return Err(Fault::mixed_names(entry.node.span));
        };
        let Some(place) = component(key.name) else {
            return Err(Fault::unknown_component(key.span, wanted, key.name));
        };
        if place == 0 && wanted == Wanted::Vector {
            return Err(Fault::scalar_in_vector(key.span.to(entry.node.span)));
        }
        let number = entry.node.real()?;
        if found[place].replace(number).is_some() {
            let name = COMPONENT_NAMES[place];
            return Err(Fault::duplicate_component(
                key.span.to(entry.node.span),
                name,
            ));
        }
    }
    let needed = match wanted {
        Wanted::Quaternion => 0..4,
        Wanted::Vector => 1..4,
    };
    let missing: Vec<_> = needed
        .filter(|&place| found[place].is_none())
        .map(|place| COMPONENT_NAMES[place])
        .collect();
    if !missing.is_empty() {
        return Err(Fault::missing_component(span, wanted, &missing));
    }
    Ok(found.map(Option::unwrap_or_default))
}

fn values(entries: &[Entry<'_>]) -> Result<Vec<(Linear, Span)>, Fault> {
    entries
        .iter()
        .map(|entry| Ok((entry.node.value()?, entry.node.span)))
        .collect()
}

fn numbers(values: &[(Linear, Span)]) -> Vec<f64> {
    values.iter().map(|(value, _)| value.scalar).collect()
}

/// The sum of members such as `0.92` and `+0.38k`, which a list reads apart.
fn sum_of_members(entries: &[Entry<'_>], values: &[(Linear, Span)]) -> Result<Linear, Fault> {
    let mut sum = Linear::real(0.0);
    for (entry, &(value, span)) in entries.iter().zip(values) {
        if entry.lead == Lead::Bare {
            return Err(Fault::missing_sign(span));
        }
        sum = sum.plus(value, span)?;
    }
    Ok(sum)
}
