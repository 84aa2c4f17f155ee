//! Rows of a file under a line of names: each number gets the name of its column.

use crate::character::is_alphabetic;
use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::text::record::names::{finite_decimal, is_usual_name};
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

/// The last line that tells names, and all names that are told.
type Names = for<'l, 't> fn(&'l [Line<'t>]) -> Option<(usize, Vec<&'t str>)>;

/// Lines that tell names in other words than the names alone.
const NAMED: [(Divided, Names); 2] = [(Divided::Spaces, channels), (Divided::Commas, format_line)];

impl<'t> Table<'t> {
    pub(crate) fn of(text: &'t str, sentences: &[Sentence]) -> Option<Self> {
        for sentence in sentences {
            if let Some(table) = Self::sentence(text, sentence) {
                return Some(table);
            }
        }
        for (way, names) in NAMED {
            if let Some(table) = Self::named(text, way, names) {
                return Some(table);
            }
        }
        for way in WAYS {
            if let Some(table) = Self::divided(text, way) {
                return Some(table);
            }
        }
        None
    }

    /// The numbers of a sentence by the names of its format; its angles are degrees.
    fn sentence(text: &'t str, (begins, names): &Sentence) -> Option<Self> {
        let start = text.find(begins)?;
        let line = text[start..].lines().next()?;
        let inside = line.split('*').next()?;
        let cells = inside[begins.len()..].trim_start_matches(',').split(',');
        let mut groups = Vec::new();
        for (cell, name) in cells.zip(*names) {
            if !name.is_empty()
                && let Some(mut group) = group(text, cell, &[name], Divided::Commas)
            {
                group.unit = Some(AngleUnit::Degrees);
                groups.push(group);
            }
        }
        Some(Self {
            groups,
            rows: vec![Span::from(start..start + line.len())],
            head: Span::from(start..start + begins.len()),
        })
    }

    /// The table whose names are found so, and whose rows have as many cells at their end.
    fn named(text: &'t str, way: Divided, names: Names) -> Option<Self> {
        let lines = lines_of(text, way);
        let (at, names) = names(&lines)?;
        let mut table = Self {
            groups: Vec::new(),
            rows: Vec::new(),
            head: lines[at].0,
        };
        for (span, cells) in &lines[at + 1..] {
            let Some(index) = cells
                .len()
                .checked_sub(names.len())
                .filter(|&index| index <= 1)
            else {
                continue;
            };
            let cells = &cells[index..];
            if !cells.iter().all(|cell| number(cell, way).is_some()) {
                continue;
            }
            if table.rows.is_empty() {
                for (cell, name) in cells.iter().zip(&names) {
                    table.groups.extend(group(text, cell, &[name], way));
                }
                table.head = table.head.to(*span);
            }
            table.rows.push(*span);
        }
        (!table.rows.is_empty()).then_some(table)
    }

    fn divided(text: &'t str, way: Divided) -> Option<Self> {
        let lines = lines_of(text, way);
        let (at, row) = (0..lines.len()).find_map(|at| Some((at, row_below(&lines, at, way)?)))?;
        let count = lines[at].1.len();
        let are_names = |line: usize| {
            let cells = &lines[line].1;
            cells.len() == count && !cells.iter().any(|cell| number(cell, way).is_some())
        };
        // Names above names: the last line of them is the next to the row.
        let at = (at..row).rev().find(|&line| are_names(line)).unwrap_or(at);
        let mut first = at;
        while first > 0 && first + MOST_HEADS > at && are_names(first - 1) {
            first -= 1;
        }
        let mut rows = Vec::new();
        for (span, cells) in &lines[row..] {
            if !is_row(cells, count, way) {
                break;
            }
            rows.push(*span);
        }
        let head = lines[first].0.to(lines[at].0);
        if let Some(matrix) = matrix(&lines[at].1, &lines[row..row + rows.len()], way) {
            return Some(Self {
                rows: vec![matrix.span],
                groups: vec![matrix],
                head,
            });
        }
        let cells = &lines[row].1;
        let mut groups = Vec::new();
        for (column, cell) in cells[cells.len() - count..].iter().enumerate() {
            let mut names = Vec::new();
            for (_, cells) in &lines[first..=at] {
                names.push(cells[column]);
            }
            groups.extend(group(text, cell, &names, way));
        }
        Some(Self { groups, rows, head })
    }
}

/// Which line below names is the first row under them.
fn row_below(lines: &[Line<'_>], at: usize, way: Divided) -> Option<usize> {
    let count = lines[at].1.len();
    if !is_head(&lines[at].1, way) {
        return None;
    }
    for (below, (_, cells)) in lines.iter().enumerate().skip(at + 1).take(MOST_HEADS) {
        if is_row(cells, count, way) {
            return Some(below);
        }
        // Only remarks stand between.
        if cells.len() >= count && cells.iter().any(|cell| number(cell, way).is_some()) {
            return None;
        }
    }
    None
}

/// Whether cells are a row under so many names.
fn is_row(cells: &[&str], count: usize, way: Divided) -> bool {
    // The index of a row has no name.
    let fits = cells.len() == count || (way == Divided::Spaces && cells.len() == count + 1);
    let is_number = |cell: &&&str| number(cell, way).is_some();
    fits && cells.iter().filter(is_number).count() >= FEWEST_COLUMNS
}

/// The rows of a matrix under the names of its axes: `| | x | y | z |`.
fn matrix<'t>(head: &[&str], rows: &[Line<'t>], way: Divided) -> Option<Group<'t>> {
    let names: String = head.concat().to_ascii_lowercase();
    let (mut numbers, mut lengths) = (Vec::new(), Vec::new());
    for (_, cells) in rows {
        let before = numbers.len();
        numbers.extend(cells.iter().filter_map(|cell| number(cell, way)));
        lengths.push(numbers.len() - before);
    }
    let is_square = lengths.iter().all(|length| *length == lengths[0])
        && matches!((rows.len(), lengths[0]), (3, 3 | 4) | (4, 4));
    if !is_square || !["xyz", "xyzt", "xyzw"].contains(&names.as_str()) {
        return None;
    }
    Some(Group {
        numbers,
        rows: lengths,
        is_line: true,
        ..Group::at(rows[0].0.to(rows[rows.len() - 1].0), vec!["", ""])
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
    let mut lines = Vec::new();
    for line in text.split_inclusive('\n') {
        let marks = [' ', '\r', '\n', '#', '%', '/', '*'];
        let inside = line
            .trim_start_matches(marks)
            .trim_end_matches([' ', '\r', '\n']);
        // LAMMPS: `ITEM: ATOMS id type x y z`.
        let inside = inside.strip_prefix("ITEM: ATOMS").unwrap_or(inside);
        let cells = cells(inside, way);
        if !cells.is_empty() {
            lines.push((span_in(text, inside), cells));
        }
    }
    lines
}

/// Where a piece of a text stands in it.
fn span_in(text: &str, piece: &str) -> Span {
    let start = piece.as_ptr() as usize - text.as_ptr() as usize;
    Span::from(start..start + piece.len())
}

fn cells(line: &str, way: Divided) -> Vec<&str> {
    let mark = match way {
        Divided::Bars => '|',
        Divided::Tabs => '\t',
        Divided::Commas => ',',
        Divided::Semicolons => ';',
        Divided::Spaces => return line.split_whitespace().collect(),
        Divided::Anything => {
            let mut cells = Vec::new();
            for cell in line.split(|mark: char| mark.is_whitespace() || ",;[](){}|".contains(mark))
            {
                if !cell.is_empty() {
                    cells.push(cell);
                }
            }
            return cells;
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
    let mut cells = Vec::new();
    for cell in line.split(mark) {
        cells.push(cell.trim().trim_matches(['"', '\'']));
    }
    cells
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
    cell.starts_with(|first: char| is_alphabetic(first) || "_%.".contains(first))
}

/// The number of a cell under the names of its column.
fn group<'t>(text: &str, cell: &str, names: &[&'t str], way: Divided) -> Option<Group<'t>> {
    Some(Group {
        numbers: vec![number(cell, way)?],
        rows: vec![1],
        has_commas: true,
        ..Group::at(span_in(text, cell), [&[""], names].concat())
    })
}

/// The channels of the joints of a BVH, in the order of the numbers of a row.
fn channels<'t>(lines: &[Line<'t>]) -> Option<(usize, Vec<&'t str>)> {
    let mut names = Vec::new();
    let mut last = None;
    for (at, (_, cells)) in lines.iter().enumerate() {
        if let ["CHANNELS", _, own @ ..] | ["CHANNELS", own @ ..] = &cells[..] {
            names.extend_from_slice(own);
            last = Some(at);
        }
    }
    Some((last?, names))
}

/// The names in the line that describes a record of an `ArduPilot` log: `FMT, 70, 28, ATT, QccC, TimeUS,Roll`.
fn format_line<'t>(lines: &[Line<'t>]) -> Option<(usize, Vec<&'t str>)> {
    const BEFORE_NAMES: usize = 5;
    let at = lines
        .iter()
        .position(|(_, cells)| cells.first() == Some(&"FMT") && cells.len() > BEFORE_NAMES)?;
    Some((at, lines[at].1[BEFORE_NAMES..].to_vec()))
}
