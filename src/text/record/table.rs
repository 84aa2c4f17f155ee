//! Rows of a file under a line of names: each number gets the name of its column.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::text::grammar::decimal_text::finite_decimal;
use crate::text::record::names::is_usual_name;
use crate::text::record::quantity::Group;

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
#[derive(Clone, Copy, PartialEq, Eq)]
enum Divided {
    /// Bars, as in a table of Markdown.
    Bars,
    Tabs,
    Semicolons,
    Commas,
    Spaces,
    /// White space, commas and brackets.
    Anything,
}

const WAYS: [Divided; 6] = [
    Divided::Bars,
    Divided::Tabs,
    Divided::Semicolons,
    Divided::Commas,
    Divided::Spaces,
    Divided::Anything,
];

/// The fewest columns of a table: a rotation has no fewer numbers.
const FEWEST_COLUMNS: usize = 3;

/// The most lines of names above each other, and the most that stand between them and the first row.
const MOST_HEADS: usize = 4;

/// What a sentence of numbers begins with, and the names of its numbers; an empty one is of something else.
pub(crate) type Sentence = (&'static str, &'static [&'static str]);

/// The cells of a line, and its place.
type Line<'t> = (Span, Vec<&'t str>);

impl<'t> Table<'t> {
    pub(crate) fn of(text: &'t str, sentences: &[Sentence]) -> Option<Self> {
        if let Some(table) = sentences
            .iter()
            .find_map(|sentence| Self::sentence(text, sentence))
        {
            return Some(table);
        }
        let by_channels = || Self::named(text, Divided::Spaces, channels);
        let by_format = || Self::named(text, Divided::Commas, format_line);
        by_channels()
            .or_else(by_format)
            .or_else(|| WAYS.into_iter().find_map(|way| Self::divided(text, way)))
    }

    /// The numbers of a sentence by the names of its format; its angles are degrees.
    fn sentence(text: &'t str, (begins, names): &Sentence) -> Option<Self> {
        let start = text.find(begins)?;
        let line = text[start..].lines().next()?;
        let inside = line.split('*').next()?;
        let cells: Vec<&str> = inside[begins.len()..]
            .trim_start_matches(',')
            .split(',')
            .collect();
        let span = Span::from(start..start + line.len());
        let columns: Vec<Vec<&str>> = names.iter().map(|name| vec![*name]).collect();
        let groups = groups(text, &cells, &columns, Divided::Commas);
        let groups = groups.into_iter().map(|group| Group {
            unit: Some(AngleUnit::Degrees),
            ..group
        });
        Some(Self {
            groups: groups
                .filter(|group| group.path.last() != Some(&""))
                .collect(),
            rows: vec![span],
            head: Span::from(start..start + begins.len()),
        })
    }

    /// The table whose names are found so, and whose rows have as many cells at their end.
    fn named(
        text: &'t str,
        way: Divided,
        names: impl Fn(&[Line<'t>]) -> Option<(usize, Vec<&'t str>)>,
    ) -> Option<Self> {
        let lines = lines_of(text, way);
        let (at, names) = names(&lines)?;
        let rows: Vec<&Line<'t>> = lines[at + 1..]
            .iter()
            .filter(|(_, cells)| {
                let extra = cells.len().checked_sub(names.len());
                extra.is_some_and(|extra| extra <= 1)
                    && cells[cells.len() - names.len()..]
                        .iter()
                        .all(|cell| number(cell, way).is_some())
            })
            .collect();
        let (span, first) = rows.first()?;
        let cells = &first[first.len() - names.len()..];
        let columns = names.iter().map(|name| vec![*name]).collect::<Vec<_>>();
        Some(Self {
            groups: groups(text, cells, &columns, way),
            rows: rows.iter().map(|(span, _)| *span).collect(),
            head: lines[at].0.to(*span),
        })
    }

    fn divided(text: &'t str, way: Divided) -> Option<Self> {
        let lines = lines_of(text, way);
        let is_row = |cells: &[&str], count: usize| {
            // The index of a row has no name.
            let fits = cells.len() == count || (way == Divided::Spaces && cells.len() == count + 1);
            fits && cells
                .iter()
                .filter(|cell| number(cell, way).is_some())
                .count()
                >= FEWEST_COLUMNS
        };
        let (at, row) = (0..lines.len()).find_map(|at| {
            let (_, head) = &lines[at];
            if !is_head(head, way) {
                return None;
            }
            let next = lines[at + 1..].iter().take(MOST_HEADS);
            let row = next
                .clone()
                .position(|(_, cells)| is_row(cells, head.len()))?;
            // Only remarks stand between.
            let between = next.take(row).all(|(_, cells)| {
                cells.iter().all(|cell| number(cell, way).is_none()) || cells.len() < head.len()
            });
            between.then_some((at, at + 1 + row))
        })?;
        let count = lines[at].1.len();
        // Names above names: the last line of them is the next to the row.
        let is_names = |line: &usize| {
            let cells = &lines[*line].1;
            cells.len() == count && cells.iter().all(|cell| number(cell, way).is_none())
        };
        let at = (at..row).rev().find(is_names).unwrap_or(at);
        let first_head = (at.saturating_sub(MOST_HEADS)..at)
            .rev()
            .take_while(|&above| {
                let cells = &lines[above].1;
                cells.len() == count && cells.iter().all(|cell| number(cell, way).is_none())
            })
            .last()
            .unwrap_or(at);
        let rows: Vec<Span> = lines[row..]
            .iter()
            .take_while(|(_, cells)| is_row(cells, count))
            .map(|(span, _)| *span)
            .collect();
        let head = lines[first_head].0.to(lines[at].0);
        if let Some(matrix) = matrix(&lines[at].1, &lines[row..row + rows.len()], way) {
            return Some(Self {
                groups: vec![matrix],
                rows: vec![rows[0].to(rows[rows.len() - 1])],
                head,
            });
        }
        let cells = &lines[row].1;
        let columns: Vec<Vec<&str>> = (0..count)
            .map(|column| {
                (first_head..=at)
                    .map(|line| lines[line].1[column])
                    .collect()
            })
            .collect();
        Some(Self {
            groups: groups(text, &cells[cells.len() - count..], &columns, way),
            rows,
            head,
        })
    }
}

/// The rows of a matrix under the names of its axes: `| | x | y | z |`.
fn matrix<'t>(head: &[&str], rows: &[Line<'t>], way: Divided) -> Option<Group<'t>> {
    let names: String = head.concat().to_ascii_lowercase();
    let numbers: Vec<Vec<f64>> = rows
        .iter()
        .map(|(_, cells)| cells.iter().filter_map(|cell| number(cell, way)).collect())
        .collect();
    let length = numbers[0].len();
    let is_square = numbers.iter().all(|row: &Vec<f64>| row.len() == length)
        && matches!((numbers.len(), length), (3, 3 | 4) | (4, 4));
    (is_square && ["xyz", "xyzt", "xyzw"].contains(&names.as_str())).then(|| Group {
        path: vec!["", ""],
        rows: vec![length; numbers.len()],
        numbers: numbers.concat(),
        span: rows[0].0.to(rows[rows.len() - 1].0),
        scope: usize::MAX,
        is_computed: false,
        is_of_call: false,
        is_of_unknown_call: false,
        has_lengths: false,
        unit: None,
        has_commas: false,
        is_line: true,
    })
}

/// Whether cells are names: of words that only spaces divide, those of a rotation or a position.
fn is_head(cells: &[&str], way: Divided) -> bool {
    let names = cells.iter().filter(|cell| is_name(cell)).count();
    let usual = cells.iter().filter(|cell| is_usual_name(cell)).count();
    let is_sentence = matches!(way, Divided::Spaces | Divided::Anything);
    names >= FEWEST_COLUMNS
        && cells.iter().all(|cell| number(cell, way).is_none())
        && (!is_sentence || usual >= FEWEST_COLUMNS)
}

fn lines_of(text: &str, way: Divided) -> Vec<Line<'_>> {
    text.split_inclusive('\n')
        .map(|line| {
            let start = line.as_ptr() as usize - text.as_ptr() as usize;
            let marks = [' ', '\r', '\n', '#', '%', '/', '*'];
            let mut inside = line
                .trim_start_matches(marks)
                .trim_end_matches([' ', '\r', '\n']);
            // LAMMPS: `ITEM: ATOMS id type x y z`.
            inside = inside.strip_prefix("ITEM: ATOMS").unwrap_or(inside);
            let start = if inside.is_empty() {
                start
            } else {
                inside.as_ptr() as usize - text.as_ptr() as usize
            };
            (Span::from(start..start + inside.len()), cells(inside, way))
        })
        .filter(|(_, cells)| !cells.is_empty())
        .collect()
}

fn cells(line: &str, way: Divided) -> Vec<&str> {
    let mark = match way {
        Divided::Bars => '|',
        Divided::Tabs => '\t',
        Divided::Commas => ',',
        Divided::Semicolons => ';',
        Divided::Spaces => return line.split_whitespace().collect(),
        Divided::Anything => {
            return line
                .split(|mark: char| mark.is_whitespace() || ",;[](){}|".contains(mark))
                .filter(|cell| !cell.is_empty())
                .collect();
        }
    };
    let line = if way == Divided::Bars {
        line.trim_matches('|')
    } else {
        line
    };
    // `|---|---|` divides the names from the rows.
    let is_rule = line.chars().all(|rule| "-:|= ".contains(rule));
    if is_rule || !line.contains(mark) {
        return Vec::new();
    }
    line.split(mark)
        .map(|cell| cell.trim().trim_matches(['"', '\'']))
        .collect()
}

/// The number that a cell is; with a decimal comma where commas do not divide cells.
fn number(cell: &str, way: Divided) -> Option<f64> {
    let point = if way == Divided::Commas {
        cell.to_owned()
    } else {
        cell.replace(',', ".")
    };
    finite_decimal(&point)
}

fn is_name(cell: &str) -> bool {
    cell.starts_with(|first: char| first.is_alphabetic() || "_%.".contains(first))
}

/// The numbers of a row under the names of their columns.
fn groups<'t>(
    text: &'t str,
    cells: &[&'t str],
    columns: &[Vec<&'t str>],
    way: Divided,
) -> Vec<Group<'t>> {
    cells
        .iter()
        .zip(columns)
        .filter_map(|(cell, names)| {
            let start = cell.as_ptr() as usize - text.as_ptr() as usize;
            Some(Group {
                path: std::iter::once("").chain(names.iter().copied()).collect(),
                numbers: vec![number(cell, way)?],
                rows: vec![1],
                span: Span::from(start..start + cell.len()),
                scope: usize::MAX,
                is_computed: false,
                is_of_call: false,
                is_of_unknown_call: false,
                has_lengths: false,
                unit: None,
                has_commas: true,
                is_line: false,
            })
        })
        .collect()
}

/// The channels of the joints of a BVH, in the order of the numbers of a row.
fn channels<'t>(lines: &[Line<'t>]) -> Option<(usize, Vec<&'t str>)> {
    let is_channels = |cells: &[&str]| cells.first() == Some(&"CHANNELS");
    let names: Vec<&str> = lines
        .iter()
        .filter(|(_, cells)| is_channels(cells))
        .flat_map(|(_, cells)| cells.iter().skip(2).copied())
        .collect();
    let last = lines.iter().rposition(|(_, cells)| is_channels(cells))?;
    Some((last, names))
}

/// The names in the line that describes a record of an `ArduPilot` log: `FMT, 70, 28, ATT, QccC, TimeUS,Roll`.
fn format_line<'t>(lines: &[Line<'t>]) -> Option<(usize, Vec<&'t str>)> {
    const BEFORE_NAMES: usize = 5;
    let at = lines
        .iter()
        .position(|(_, cells)| cells.first() == Some(&"FMT") && cells.len() > BEFORE_NAMES)?;
    Some((at, lines[at].1[BEFORE_NAMES..].to_vec()))
}
