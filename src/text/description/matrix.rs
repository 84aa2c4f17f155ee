//! The nine numbers of a matrix: rows in brackets, rows as programs print them, or one after the
//! other.

use crate::character::is_digit;
use crate::problem::fault::Fault;
use crate::problem::{Span, is_too_long};
use crate::text::description::list::{
    check_separators, check_signs, commas_separate, held, members, spaces_separate, values,
};
use crate::text::description::matrix_columns::LabelKind;
use crate::text::grammar::tree::{Entry, Lead, Node, NodeKind};
use crate::text::vocabulary::Telling;
use crate::text::vocabulary::constructors::{self, Call};
use nalgebra::Matrix3;

/// The matrix that members are which nothing but their count or their brackets makes one.
pub(crate) fn unannounced(
    members: &[Entry<'_>],
    span: Span,
) -> Result<Option<Matrix3<f64>>, Fault> {
    if members.iter().any(|entry| entry.key.is_some()) {
        return Ok(None);
    }
    let is_matrix = match rows(members) {
        Rows::InBrackets => true,
        Rows::OfLengths(rows) => rows.iter().all(|row| row.len() > 1) && members.len() > 5,
        Rows::Unmarked => members.len() == 9 && members.iter().all(|entry| is_number(&entry.node)),
    };
    is_matrix.then(|| of_members(members, span)).transpose()
}

/// The matrix of members that are announced as one.
pub(crate) fn matrix(entries: &[Entry<'_>], span: Span) -> Result<Matrix3<f64>, Fault> {
    of_members(&members(entries)?, span)
}

fn of_members(entries: &[Entry<'_>], span: Span) -> Result<Matrix3<f64>, Fault> {
    if let Some(key) = entries.iter().find_map(|entry| entry.key) {
        return Err(Fault::unknown_argument(key.span, key.name));
    }
    let mut numbers = Vec::new();
    let lengths: Vec<usize> = match rows(entries) {
        Rows::InBrackets => {
            let mut lengths = Vec::new();
            for entry in entries {
                let row = held(&entry.node).map_or_else(|| Ok(vec![entry.clone()]), members)?;
                check_separators(&row, entry.node.span)?;
                lengths.push(row.len());
                numbers.extend(values(&row)?);
            }
            lengths
        }
        Rows::OfLengths(rows) => {
            check_signs(entries)?;
            numbers = values(entries)?;
            let mut lengths = Vec::new();
            for row in rows {
                lengths.push(row.len());
            }
            lengths
        }
        Rows::Unmarked => {
            check_separators(entries, span)?;
            numbers = values(entries)?;
            match numbers.len() {
                9 => vec![3; 3],
                found => return Err(Fault::matrix_count(span, found)),
            }
        }
    };
    if lengths != [3, 3, 3] {
        return Err(Fault::matrix_shape(span, &lengths));
    }
    let mut matrix = Matrix3::zeros();
    for (at, (value, span)) in numbers.into_iter().enumerate() {
        if value.units.is_some() {
            return Err(Fault::unit_for_number(span));
        }
        matrix[(at / 3, at % 3)] = value.scalar;
    }
    Ok(matrix)
}

/// What tells where a row ends.
enum Rows<'e, 't> {
    InBrackets,
    /// Commas or semicolons between the rows and spaces inside them, or the other way round.
    OfLengths(Vec<&'e [Entry<'t>]>),
    Unmarked,
}

fn rows<'e, 't>(entries: &'e [Entry<'t>]) -> Rows<'e, 't> {
    if entries.len() > 1 && entries.iter().all(|entry| is_row(&entry.node)) {
        return Rows::InBrackets;
    }
    if !(spaces_separate(entries) && commas_separate(entries)) {
        return Rows::Unmarked;
    }
    let is_after_comma = |entry: &Entry<'_>| entry.lead == Lead::AfterComma;
    let split_by = |starts: &dyn Fn(&Entry<'_>) -> bool| -> Vec<&'e [Entry<'t>]> {
        let mut rows = Vec::new();
        let mut first = 0;
        for at in 1..=entries.len() {
            if at == entries.len() || starts(&entries[at]) {
                rows.push(&entries[first..at]);
                first = at;
            }
        }
        rows
    };
    let by_commas = split_by(&is_after_comma);
    // MATLAB's rows end in semicolons; elsewhere a row ends with its line.
    if by_commas.iter().all(|row| row.len() > 1) {
        return Rows::OfLengths(by_commas);
    }
    Rows::OfLengths(split_by(&|entry| !is_after_comma(entry)))
}

/// What is made a vector by its name may be a column.
fn is_row(node: &Node<'_>) -> bool {
    let is_vector = matches!(node.kind, NodeKind::Call { name, .. } if constructors::call(name) == Call::Vector);
    !is_vector && held(node).is_some_and(|row| row.iter().all(|entry| entry.key.is_none()))
}

fn is_number(node: &Node<'_>) -> bool {
    matches!(&node.kind, NodeKind::Value(value) if value.units.is_none())
}

/// What marks the rows of nine numbers in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RowMarks {
    /// Lines, semicolons, or commas between rows of numbers with spaces.
    Lines,
    /// Brackets within brackets.
    Brackets,
    /// The names of the axes: the vectors are columns.
    AxisNames,
    /// A label that says that they are columns: they were read so.
    Columns,
    /// Nothing: the numbers stand in a row.
    None,
}

impl RowMarks {
    /// Those of a text that may be no matrix.
    pub(crate) fn of(text: &str) -> Self {
        if is_too_long(text) {
            return Self::None;
        }
        match Telling::of(text) {
            Ok(telling) => Self::among(text, &telling),
            Err(_) => Self::in_layout(text),
        }
    }

    pub(crate) fn among(text: &str, telling: &Telling<'_>) -> Self {
        // `Float32Array(9) [ … ]` is one list, wherever its lines are broken.
        if telling.is_one_list {
            return Self::None;
        }
        match LabelKind::of(&telling.tokens) {
            Some(LabelKind::Axis) => Self::AxisNames,
            Some(LabelKind::Column | LabelKind::Row) => Self::Lines,
            None => Self::in_layout(text),
        }
    }

    fn in_layout(text: &str) -> Self {
        let has_digits = |line: &&str| line.contains(is_digit);
        let lines = text.split(['\n', ';']).filter(has_digits).count();
        let has_three = |part: &&str| part.split_whitespace().count() == 3;
        let between_commas = text.split(',').filter(has_three).count();
        if lines >= 3 || between_commas == 3 {
            Self::Lines
        } else if further_rows(text) >= 2 {
            Self::Brackets
        } else {
            Self::None
        }
    }
}

/// How many brackets open right after another of their kind, or after a comma.
fn further_rows(text: &str) -> usize {
    let openings = text.match_indices(['[', '(', '{']);
    let follows = |(at, opening): &(usize, &str)| {
        let before = text[..*at].trim_end();
        let closing = match *opening {
            "[" => ']',
            "(" => ')',
            _ => '}',
        };
        before.ends_with([',', ';', closing])
    };
    openings.filter(follows).count()
}
