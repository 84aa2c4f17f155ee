//! Members of a text to named components: which number is the scalar, and what is no quaternion.

use crate::convention::order::ComponentOrder;
use crate::convention::order::OrderSource;
use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted, shorten};
use crate::text::description::list::{held, values};
use crate::text::description::named_members::{ORIENTATIONS, named, without_options};
use crate::text::description::vector::{numbers, sum_of_members, vector, without_label};
use crate::text::grammar::tree::{Entry, Key, Node, NodeKind};
use crate::text::vocabulary::constructors::{self, Call, Named};
use crate::text::vocabulary::labels::order_of;
#[cfg(feature = "whole")]
use crate::text::vocabulary::labels::says_nothing;
use nalgebra::Quaternion;

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
    /// Whether the text itself says that its numbers are a quaternion: by a word or a label, a
    /// constructor, the units i, j and k, or names such as `qw`.
    pub is_announced: bool,
    /// The label of the numbers where it says nothing of a rotation, so that only their count does; only with
    /// the feature `whole`.
    pub unexplained_label: Option<String>,
}

/// How much of an unknown constructor's name a note repeats, in characters.
const LONGEST_NAME: usize = 40;

/// What is known of the order so far, on the way from the outer brackets to the inner ones.
#[derive(Clone)]
struct Order {
    declared: ComponentOrder,
    order: ComponentOrder,
    source: OrderSource,
    unknown_constructor: Option<String>,
    named: Named,
    unexplained_label: Option<String>,
}

impl Order {
    fn told(&self, order: ComponentOrder, source: OrderSource) -> Self {
        Self {
            declared: self.declared,
            order,
            source,
            unknown_constructor: None,
            named: self.named,
            unexplained_label: self.unexplained_label.clone(),
        }
    }

    /// With the label of the numbers, where it says nothing.
    #[cfg(feature = "whole")]
    fn labelled(self, label: Option<Key<'_>>) -> Self {
        let unexplained = label.filter(|label| says_nothing(label.name));
        Self {
            unexplained_label: unexplained
                .map(|label| shorten(label.name, LONGEST_NAME))
                .or(self.unexplained_label),
            ..self
        }
    }

    #[cfg(not(feature = "whole"))]
    fn labelled(self, _: Option<Key<'_>>) -> Self {
        self
    }

    /// That the text says more of what the numbers are.
    fn named(mut self, named: Named) -> Self {
        self.named = self.named.max(named);
        self
    }

    fn announced(self) -> Self {
        self.named(Named::Quaternion)
    }

    /// Names have no order of their own, so the declared one stands.
    fn by_names(&self) -> Self {
        let named = self.told(self.declared, OrderSource::Named);
        // No axis and angle has these names.
        if self.named == Named::Rotation {
            return named.announced();
        }
        named
    }

    fn unknown(self, name: &str) -> Self {
        let first = self.unknown_constructor.clone();
        Self {
            unknown_constructor: first.or_else(|| Some(shorten(name, LONGEST_NAME))),
            ..self
        }
    }

    fn with(self, quaternion: Quaternion<f64>) -> ParsedQuaternion {
        ParsedQuaternion {
            quaternion,
            order: self.order,
            order_source: self.source,
            unknown_constructor: self.unknown_constructor,
            is_announced: self.named == Named::Quaternion,
            unexplained_label: self.unexplained_label,
        }
    }
}

/// Whether members stand in a call, where a vector and a number are an axis and an angle.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    Open,
    InCall,
}

pub(crate) fn quaternion(
    entries: &[Entry<'_>],
    span: Span,
    declared: ComponentOrder,
    told: Option<ComponentOrder>,
) -> Result<ParsedQuaternion, Fault> {
    let order = Order {
        declared,
        order: told.unwrap_or(declared),
        source: match told {
            Some(_) => OrderSource::Named,
            None => OrderSource::Declared,
        },
        unknown_constructor: None,
        named: Named::Anything,
        unexplained_label: None,
    };
    read_quaternion(entries, span, order, Place::Open)
}

fn read_quaternion(
    entries: &[Entry<'_>],
    span: Span,
    order: Order,
    place: Place,
) -> Result<ParsedQuaternion, Fault> {
    // A name that only tells what the numbers are is left to the whole core.
    let order = if cfg!(feature = "whole") {
        order.named(said_of(entries))
    } else {
        order
    };
    if let Some(node) = orientation(entries)? {
        return read_members(node, order, place);
    }
    let (entries, label) = without_label(entries, Wanted::Quaternion)?;
    let order = match label.and_then(|label| order_of(label.name)) {
        Some(named) if order.source == OrderSource::Named && order.order != named => {
            let label = label.unwrap_or_default();
            return Err(Fault::unknown_argument(label.span, label.name));
        }
        Some(named) => order.told(named, OrderSource::Named),
        None => order.labelled(label),
    };
    if let [only] = &entries[..]
        && only.key.is_none()
        && matches!(only.node.kind, NodeKind::List(_) | NodeKind::Call { .. })
    {
        return read_members(&only.node, order, place);
    }
    if entries.iter().any(|entry| entry.key.is_some()) {
        let [w, x, y, z] = named(&entries, span, Wanted::Quaternion)?;
        return Ok(order.by_names().with(Quaternion::new(w, x, y, z)));
    }
    if let [first, second] = &entries[..] {
        if let (NodeKind::Value(_), Some(inner)) = (&first.node.kind, held(&second.node))
            && !is_whole(inner)
        {
            let part = vector(inner, second.node.span)?;
            let quaternion = Quaternion::from_parts(first.node.real()?, part);
            check_pair(&order, &quaternion, span, place)?;
            return Ok(order
                .told(ComponentOrder::ScalarFirst, OrderSource::Grouped)
                .with(quaternion));
        }
        if let (Some(inner), NodeKind::Value(_)) = (held(&first.node), &second.node.kind) {
            if place == Place::InCall {
                return Err(Fault::axis_and_angle(span));
            }
            let part = vector(inner, first.node.span)?;
            let quaternion = Quaternion::from_parts(second.node.real()?, part);
            check_pair(&order, &quaternion, span, place)?;
            return Ok(order
                .told(ComponentOrder::ScalarLast, OrderSource::Grouped)
                .with(quaternion));
        }
    }
    let values = values(&entries)?;
    if let Some(sum) = sum_of_members(&entries, &values)? {
        let [x, y, z] = sum.units.unwrap_or_default();
        let quaternion = Quaternion::new(sum.scalar, x, y, z);
        return Ok(order.by_names().announced().with(quaternion));
    }
    let array = numbers(&entries, &values, span, Wanted::Quaternion)?;
    let [w, x, y, z] = order.order.components(array);
    Ok(order.with(Quaternion::new(w, x, y, z)))
}

/// The most that a name of the whole or of a component says, or the heading above it.
fn said_of(entries: &[Entry<'_>]) -> Named {
    let mut said = Named::Anything;
    for entry in entries {
        if let Some(key) = entry.key {
            let path = key.name.rsplit_once(['.', ':']).map(|(path, _)| path);
            for name in [Some(key.name), key.heading, path] {
                said = said.max(name.map_or(Named::Anything, Named::by));
            }
        }
    }
    said
}

/// Whether a list is a quaternion by its count, and no vector part.
fn is_whole(inner: &[Entry<'_>]) -> bool {
    inner.len() == Wanted::Quaternion.count() && inner.iter().all(|entry| entry.key.is_none())
}

/// How far from 1 a length is that was typed as 1 with six decimals.
const TYPED_AS_ONE: f64 = 1e-6;

/// A vector of length 1 and a number that together have another norm may be an axis and its angle,
/// unless a name before them says that they are a quaternion.
fn check_pair(
    order: &Order,
    pair: &Quaternion<f64>,
    span: Span,
    place: Place,
) -> Result<(), Fault> {
    let is_one = |length: f64| (length - 1.0).abs() <= TYPED_AS_ONE;
    let may_be_axis_and_angle = is_one(pair.imag().norm()) && !is_one(pair.norm());
    let is_named = order.source != OrderSource::Declared
        || (order.named == Named::Quaternion && place == Place::Open);
    if may_be_axis_and_angle && !is_named {
        return Err(Fault::axis_angle_or_quaternion(span));
    }
    Ok(())
}

/// What stands in the brackets of a list or a call.
fn read_members(node: &Node<'_>, order: Order, place: Place) -> Result<ParsedQuaternion, Fault> {
    let (name, arguments) = match &node.kind {
        NodeKind::List(inner) => return read_quaternion(inner, node.span, order, place),
        NodeKind::Call {
            name, arguments, ..
        } => (name, arguments),
        NodeKind::Value(_) | NodeKind::Word(_) => {
            return Err(Fault::wrong_count(node.span, Wanted::Quaternion, 1));
        }
    };
    let order = match (scalar_first_argument(arguments)?, constructors::call(name)) {
        (_, Call::Vector) if place == Place::Open => {
            return Err(Fault::vector_for_quaternion(node.span, name));
        }
        (_, Call::Other | Call::Vector) => {
            return Err(Fault::not_applied(node.span, name, Wanted::Quaternion));
        }
        (Some(named), _) | (None, Call::Ordered(named)) => {
            order.told(named, OrderSource::Constructor).announced()
        }
        (None, Call::Unordered) if order.source == OrderSource::Declared => {
            order.unknown(name).announced()
        }
        (None, Call::Unordered) => order.announced(),
        (None, Call::Container) => order,
    };
    let mut members = arguments.clone();
    members.retain(|entry| !is_scalar_first(entry));
    read_quaternion(&without_options(&members)?, node.span, order, Place::InCall)
}

/// `scalar_first=True`, as in `SciPy`'s `from_quat`.
fn scalar_first_argument(arguments: &[Entry<'_>]) -> Result<Option<ComponentOrder>, Fault> {
    let Some(entry) = arguments.iter().find(|entry| is_scalar_first(entry)) else {
        return Ok(None);
    };
    match entry.node.truth() {
        Some(true) => Ok(Some(ComponentOrder::ScalarFirst)),
        Some(false) => Ok(Some(ComponentOrder::ScalarLast)),
        None => Err(Fault::unknown_argument(entry.node.span, "scalar_first")),
    }
}

fn is_scalar_first(entry: &Entry<'_>) -> bool {
    entry.key.is_some_and(|key| key.name == "scalar_first")
}

/// The part of several named ones that is the orientation, as in JSON of a pose; a problem where
/// another part is a rotation too.
fn orientation<'e, 't>(entries: &'e [Entry<'t>]) -> Result<Option<&'e Node<'t>>, Fault> {
    let named = |entry: &Entry<'_>, is_it: &dyn Fn(&str) -> bool| {
        !matches!(entry.node.kind, NodeKind::Word(_))
            && entry.key.is_some_and(|key| is_it(key.name))
    };
    let is_orientation = |name: &str| ORIENTATIONS.contains(&name);
    let found = entries.iter().find(|entry| {
        matches!(entry.node.kind, NodeKind::List(_)) && named(entry, &is_orientation)
    });
    let Some(found) = found.filter(|_| entries.len() > 1) else {
        return Ok(None);
    };
    without_options(entries)?;
    // A word with no name may say something of the numbers: `q: [1, 2, 3, 4] m`.
    for entry in entries {
        if let (NodeKind::Word(word), None) = (&entry.node.kind, entry.key) {
            return Err(Fault::unknown_word(entry.node.span, word));
        }
    }
    let is_rotation = |name: &str| is_orientation(name) || constructors::is_other_label(name);
    let other = entries
        .iter()
        .find(|entry| !std::ptr::eq(*entry, found) && named(entry, &is_rotation));
    match other {
        Some(other) => Err(Fault::several_values(other.node.span)),
        None => Ok(Some(&found.node)),
    }
}
