//! What is understood of a quantity, and what a text says for all of them.

use crate::convention::angle::AngleUnit;
use crate::convention::order::{ComponentOrder, OrderSource};
use crate::problem::Span;
use crate::text::record::described::Described;
use crate::text::record::format::{Field, Format};
use crate::text::record::meaning::Meaning;
use crate::text::record::names::{identifiers_of, is_holder, words_of};
use crate::text::record::parts::{Made, Said};
use crate::text::record::rows::{BY_COLUMNS, BY_ROWS};

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

impl Found {
    /// Nothing in particular at a place.
    pub(crate) fn at(span: Span) -> Self {
        Self {
            made: Made::Nothing,
            label: String::new(),
            span,
            is_derived: false,
            is_computed: false,
            format: None,
            has_rows: true,
        }
    }

    /// Adds what each part of the same numbers is.
    pub(crate) fn add_parts(self, made: Vec<Made>, all: &mut Vec<Self>) {
        for made in made {
            all.push(Self {
                made,
                ..self.clone()
            });
        }
    }
}

/// What a text says for all its quantities.
pub(crate) struct Context {
    pub(crate) formats: Vec<&'static Format>,
    /// The format that is marked in the text and has an order of four numbers; that of one which is only
    /// declared is the declared order.
    pub(crate) ordering: Option<&'static Format>,
    pub(crate) declared: ComponentOrder,
    /// The order that the text tells once for all.
    pub(crate) order: Option<ComponentOrder>,
    pub(crate) unit: Option<AngleUnit>,
    /// What three numbers are whose name says nothing.
    pub(crate) described: Option<Described>,
    /// The letters of a sequence: `_order: 'XYZ'`.
    pub(crate) letters: Option<String>,
}

impl Context {
    /// The order of four numbers whose names say this.
    pub(crate) fn order(&self, meaning: &Meaning) -> (ComponentOrder, OrderSource) {
        let of_formats = self.ordering.and_then(|format| format.order);
        match (meaning.order.or(self.order), of_formats) {
            (Some(order), _) => (order, OrderSource::Label),
            (None, Some(order)) => (order, OrderSource::Format),
            (None, None) => (self.declared, OrderSource::Declared),
        }
    }

    pub(crate) fn said(&self, meaning: &Meaning) -> Said<'_> {
        Said {
            order: self.order(meaning),
            order_of_text: self.order,
            unit: meaning.unit.or(self.unit),
            sequence: meaning.sequence,
            letters: self.letters.as_deref(),
        }
    }
}

/// A field, and the format of which it is.
pub(crate) type Asked = (&'static Field, Option<&'static Format>);

pub(crate) fn label_of(path: &[&str]) -> String {
    path.iter()
        .rev()
        .find(|key| !key.is_empty() && ![BY_ROWS, BY_COLUMNS].contains(key))
        .map_or("", |key| key)
        .to_owned()
}

/// The innermost name that says more than that it holds numbers.
pub(crate) fn next_key<'t>(path: &[&'t str]) -> Option<&'t str> {
    path.iter()
        .rev()
        .copied()
        .find(|key| !key.is_empty() && !is_holder(key))
}

/// Whether one of these names stands next over numbers; a letter alone only as it is.
pub(crate) fn stands_under(path: &[&str], names: &str) -> bool {
    let own = path.iter().rev().copied().find(|key| !key.is_empty());
    let next = next_key(path).filter(|next| Some(*next) != own);
    own.is_some_and(|key| is_one_of(key, names)) || next.is_some_and(|key| is_one_of(key, names))
}

fn is_one_of(key: &str, names: &str) -> bool {
    names.split('|').any(|name| {
        let lower = name.to_ascii_lowercase();
        let parts = words_of(name);
        identifiers_of(key).any(|own| own == lower)
            || (name.len() > 1
                && words_of(key)
                    .windows(parts.len().max(1))
                    .any(|own| own == parts))
    })
}
