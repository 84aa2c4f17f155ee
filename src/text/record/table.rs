//! Rows of a file under a line of names: each number gets the name of its column.

use crate::decimal::nearest_double;
use crate::problem::Span;
use crate::text::record::group::Group;

/// A row of numbers and the names above them.
pub(crate) struct Table<'t> {
    /// The numbers by name of the first row.
    pub(crate) groups: Vec<Group<'t>>,
    /// The rows as written.
    pub(crate) rows: Vec<Span>,
    /// The names above, as many lines as there are.
    pub(crate) head: Span,
}

/// How the cells of a line are divided.
#[derive(Clone, Copy)]
enum Divided {
    Tabs,
    Commas,
    Semicolons,
    /// White space, commas and brackets.
    Anything,
}

const WAYS: [Divided; 4] = [
    Divided::Tabs,
    Divided::Commas,
    Divided::Semicolons,
    Divided::Anything,
];

/// The fewest columns of a table: a rotation has no fewer numbers.
const FEWEST_COLUMNS: usize = 3;

/// The most lines of names above each other.
const MOST_HEADS: usize = 4;

impl<'t> Table<'t> {
    pub(crate) fn of(text: &'t str) -> Option<Self> {
        WAYS.into_iter().find_map(|way| Self::divided(text, way))
    }

    fn divided(text: &'t str, way: Divided) -> Option<Self> {
        let lines: Vec<(Span, Vec<&'t str>)> = lines(text)
            .map(|span| (span, cells(&text[span.start..span.end], way)))
            .filter(|(_, cells)| !cells.is_empty())
            .collect();
        let is_head = |cells: &[&str]| {
            let names = cells.iter().filter(|cell| is_name(cell)).count();
            cells.len() >= FEWEST_COLUMNS
                && names >= FEWEST_COLUMNS
                && cells.iter().all(|cell| cell.is_empty() || !is_number(cell))
        };
        let is_row = |cells: &[&str], count: usize| {
            cells.len() == count
                && cells.iter().filter(|cell| is_number(cell)).count() >= FEWEST_COLUMNS
        };
        let at = (0..lines.len().saturating_sub(1)).find(|&at| {
            let (_, head) = &lines[at];
            is_head(head) && is_row(&lines[at + 1].1, head.len())
        })?;
        let count = lines[at].1.len();
        let first_head = (at.saturating_sub(MOST_HEADS)..at)
            .rev()
            .take_while(|&above| {
                let cells = &lines[above].1;
                cells.len() == count && cells.iter().all(|cell| !is_number(cell))
            })
            .last()
            .unwrap_or(at);
        let rows: Vec<Span> = lines[at + 1..]
            .iter()
            .take_while(|(_, cells)| is_row(cells, count))
            .map(|(span, _)| *span)
            .collect();
        // A line of names over a matrix, or over lines that go on as something else, is no table.
        let groups = lines[at + 1]
            .1
            .iter()
            .enumerate()
            .filter(|(_, cell)| is_number(cell))
            .map(|(column, cell)| {
                let path = std::iter::once("")
                    .chain((first_head..=at).map(|line| lines[line].1[column]))
                    .collect();
                let start = cell.as_ptr() as usize - text.as_ptr() as usize;
                Group {
                    path,
                    numbers: vec![nearest_double(cell.trim_start_matches('+'))],
                    rows: vec![1],
                    span: Span::from(start..start + cell.len()),
                    scope: usize::MAX,
                    is_computed: false,
                    follows_bar: false,
                    unit: None,
                    has_commas: true,
                }
            })
            .collect();
        Some(Self {
            groups,
            rows,
            head: lines[first_head].0.to(lines[at].0),
        })
    }
}

/// The lines of a text that are not empty, without what marks them as a comment.
fn lines(text: &str) -> impl Iterator<Item = Span> + '_ {
    text.split_inclusive('\n').map(move |line| {
        let start = line.as_ptr() as usize - text.as_ptr() as usize;
        let marks = [' ', '\r', '\n', '#', '%', '/', '*'];
        let inside = line.trim_start_matches(marks);
        let start = start + line.len() - inside.len();
        Span::from(start..start + inside.trim_end_matches([' ', '\r', '\n']).len())
    })
}

fn cells(line: &str, way: Divided) -> Vec<&str> {
    let marks: &[char] = match way {
        Divided::Tabs => &['\t'],
        Divided::Commas => &[','],
        Divided::Semicolons => &[';'],
        Divided::Anything => {
            return line
                .split(|mark: char| mark.is_whitespace() || ",;[](){}|".contains(mark))
                .filter(|cell| !cell.is_empty())
                .collect();
        }
    };
    if !line.contains(marks) {
        return Vec::new();
    }
    line.split(marks)
        .map(|cell| cell.trim().trim_matches(['"', '\'']))
        .collect()
}

fn is_number(cell: &str) -> bool {
    cell.parse::<f64>().is_ok_and(f64::is_finite)
        && cell.contains(|digit: char| digit.is_ascii_digit())
}

fn is_name(cell: &str) -> bool {
    cell.starts_with(|first: char| first.is_alphabetic() || "_%.".contains(first))
}
