//! What a text holds: runs of numbers, single numbers by name, words with a name.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;

/// Numbers that stand together.
#[derive(Clone, Debug)]
pub(crate) struct Group<'t> {
    /// The names of what holds it from the outermost on; the last is its own, and may be empty.
    pub(crate) path: Vec<&'t str>,
    pub(crate) numbers: Vec<f64>,
    /// How many numbers each row has.
    pub(crate) rows: Vec<usize>,
    pub(crate) span: Span,
    /// Which scope holds it.
    pub(crate) scope: usize,
    /// Whether a sign that computes stands at it or inside.
    pub(crate) is_computed: bool,
    /// Whether it is what a call is given: the rows of a matrix there are those of the library.
    pub(crate) is_of_call: bool,
    /// Whether a call holds it of which is not known what it makes of its numbers.
    pub(crate) is_of_unknown_call: bool,
    /// Whether a unit of length stands behind one of the numbers.
    pub(crate) has_lengths: bool,
    /// The unit that stands behind one of the numbers.
    pub(crate) unit: Option<AngleUnit>,
    /// Whether commas divide the numbers.
    pub(crate) has_commas: bool,
    /// Whether it stands in a line, in no brackets.
    pub(crate) is_line: bool,
    /// What is said behind it in its line.
    pub(crate) remark: &'t str,
}

impl<'t> Group<'t> {
    /// No numbers, at a place and under these names, in a scope of its own.
    pub(crate) fn at(span: Span, path: Vec<&'t str>) -> Self {
        Self {
            path,
            numbers: Vec::new(),
            rows: Vec::new(),
            span,
            scope: usize::MAX,
            is_computed: false,
            is_of_call: false,
            is_of_unknown_call: false,
            has_lengths: false,
            unit: None,
            has_commas: false,
            is_line: false,
            remark: "",
        }
    }
}

/// A word that is a value: `_order: 'XYZ'`.
#[derive(Clone, Debug)]
pub(crate) struct Value<'t> {
    pub(crate) key: &'t str,
    pub(crate) text: &'t str,
    pub(crate) span: Span,
}

/// Single numbers by name that stand together: `x: 1 y: 2 z: 3`.
#[derive(Clone, Debug)]
pub(crate) struct Named<'t> {
    pub(crate) path: Vec<&'t str>,
    /// What the names have in common: `stateEstimate` of `stateEstimate.qx`.
    pub(crate) stem: String,
    pub(crate) members: Vec<NamedNumber>,
    pub(crate) scope: usize,
    /// Whether more than the first have the stem.
    pub(crate) others_have_stem: bool,
    /// What is said behind the last of them in its line.
    pub(crate) remark: &'t str,
}

/// A number by name.
#[derive(Clone, Debug)]
pub(crate) struct NamedNumber {
    /// In small letters.
    pub(crate) name: String,
    pub(crate) value: f64,
    pub(crate) span: Span,
    pub(crate) is_computed: bool,
    pub(crate) unit: Option<AngleUnit>,
    /// Whether a unit of something else than an angle stands behind it.
    pub(crate) has_length: bool,
}

pub(crate) fn own_key<'t>(group: &Group<'t>) -> &'t str {
    group.path.last().copied().unwrap_or("")
}

pub(crate) fn is_named(group: &Group<'_>) -> bool {
    !own_key(group).is_empty()
}
