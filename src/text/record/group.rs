//! The tree of a text to its quantities: runs of numbers, and single numbers by name.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::text::record::meaning::may_compute;
use crate::text::record::named::named;
use crate::text::record::outline::{Kind, Member};
use crate::text::record::quantity::{Group, Named, Value, is_named};
use crate::text::record::remark::remark_behind;
use crate::text::record::rows::{with_listed_names, with_repeated, with_rows_by_name};

/// All quantities of a text.
#[derive(Default)]
pub(crate) struct Quantities<'t> {
    pub(crate) groups: Vec<Group<'t>>,
    pub(crate) values: Vec<Value<'t>>,
    pub(crate) named: Vec<Named<'t>>,
    scopes: usize,
}

impl<'t> Quantities<'t> {
    pub(crate) fn of(members: &[Member<'t>]) -> Self {
        let mut found = Self::default();
        found.collect(members, &[""], Holder::Lines, Call::None);
        found.groups = with_rows_by_name(with_repeated(found.groups));
        found.groups = with_listed_names(found.groups);
        found.named = named(&found.groups);
        found
            .groups
            .retain(|group| !(group.numbers.len() == 1 && is_named(group)));
        found
    }

    fn collect(&mut self, members: &[Member<'t>], path: &[&'t str], holder: Holder, call: Call) {
        let scope = self.scopes;
        self.scopes += 1;
        let rows_are_alike = holder == Holder::Lines || are_alike(members);
        let mut at = 0;
        while let Some(member) = members.get(at) {
            let within = |key: &'t str| {
                let mut path = path.to_vec();
                path.push(key);
                path
            };
            let rest = &members[at..];
            match member.kind {
                Kind::Word => {
                    self.values.push(Value {
                        key: member.key,
                        text: member.text,
                        span: member.span,
                    });
                    at += 1;
                }
                Kind::Number(_) => {
                    let run = run(rest, holder);
                    self.groups.push(Group {
                        is_line: holder == Holder::Lines,
                        is_computed: run.iter().any(|member| member.is_computed),
                        is_of_call: call != Call::None,
                        is_of_unknown_call: call == Call::Unknown,
                        ..group_of(run, within(member.key), scope)
                    });
                    at += run.len();
                }
                Kind::Scope => match alike(if rows_are_alike { rest } else { &rest[..1] }) {
                    Some((count, numbers, rows)) => {
                        let alike = &rest[..count];
                        self.groups.push(Group {
                            path: within(member.key),
                            numbers,
                            rows,
                            span: alike[0].span.to(alike[count - 1].span),
                            scope,
                            is_computed: alike.iter().any(is_computed),
                            is_of_call: call.with(member) != Call::None,
                            is_of_unknown_call: call.with(member) == Call::Unknown,
                            has_lengths: alike.iter().any(has_length),
                            unit: alike.iter().find_map(unit),
                            has_commas: true,
                            is_line: false,
                            remark: "",
                        });
                        at += count;
                    }
                    None => {
                        let inside = if member.is_bracketed {
                            Holder::Bracket
                        } else {
                            Holder::Lines
                        };
                        let call = call.with(member);
                        self.collect(&member.members, &within(member.key), inside, call);
                        at += 1;
                    }
                },
            }
        }
    }
}

impl<'t> Quantities<'t> {
    /// The rows of a file without names above them, of which only the first is left; none where there is one.
    pub(crate) fn take_first_row(&mut self, text: &str) -> Vec<Span> {
        let is_file = |group: &&mut Group<'_>| {
            let first = group.rows[0];
            group.is_line
                && group.rows.len() > 1
                && first >= FEWEST_OF_A_ROW
                && group.rows.iter().all(|row| *row == first)
        };
        let Some(group) = self.groups.iter_mut().find(is_file) else {
            return Vec::new();
        };
        let inside = &text[group.span.start..group.span.end];
        let mut rows = Vec::new();
        for line in inside.lines() {
            if !line.trim().is_empty() {
                let start = line.as_ptr() as usize - text.as_ptr() as usize;
                rows.push(Span::from(start..start + line.len()));
            }
        }
        if rows.len() != group.rows.len() {
            return Vec::new();
        }
        let first = group.rows[0];
        group.numbers.truncate(first);
        group.rows = vec![first];
        group.span = rows[0];
        rows
    }

    /// How many numbers stand together, or have names together, at most.
    pub(crate) fn most_numbers(&self) -> usize {
        let mut most = 0;
        for group in &self.groups {
            most = most.max(group.numbers.len());
        }
        for named in &self.named {
            most = most.max(named.members.len());
        }
        most
    }

    /// With what is said behind them in their lines.
    pub(crate) fn take_remarks(&mut self, text: &'t str) {
        let behind = |end: usize| {
            let remark = remark_behind(text, end);
            &text[remark.start..remark.end]
        };
        for group in &mut self.groups {
            group.remark = behind(group.span.end);
        }
        for named in &mut self.named {
            if let Some(last) = named.members.last() {
                named.remark = behind(last.span.end);
            }
        }
    }

    /// With the groups of a table in place of those that stand inside it.
    pub(crate) fn replace(&mut self, inside: impl Fn(Span) -> bool, groups: Vec<Group<'t>>) {
        self.groups.retain(|group| !inside(group.span));
        self.named
            .retain(|named| !named.members.iter().all(|member| inside(member.span)));
        self.named.extend(named(&groups));
        let runs = groups.into_iter().filter(|group| group.numbers.len() > 1);
        self.groups.extend(runs);
    }
}

/// Whether a call holds numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Call {
    None,
    Known,
    Unknown,
}

impl Call {
    /// What holds the members of one that this holds.
    fn with(self, member: &Member<'_>) -> Self {
        match (self, member.is_call) {
            (own, false) => own,
            (Self::Unknown, true) => Self::Unknown,
            (_, true) if may_compute(member.key) => Self::Unknown,
            (_, true) => Self::Known,
        }
    }
}

/// The fewest numbers of a row of a file: three of a position and four of a quaternion.
const FEWEST_OF_A_ROW: usize = 7;

/// Whether lines inside mean anything.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Holder {
    Lines,
    Bracket,
}

fn unit(member: &Member<'_>) -> Option<AngleUnit> {
    member.unit.or_else(|| member.members.iter().find_map(unit))
}

fn has_length(member: &Member<'_>) -> bool {
    member.has_length || member.members.iter().any(has_length)
}

fn is_computed(member: &Member<'_>) -> bool {
    member.is_computed || member.members.iter().any(is_computed)
}

/// Numbers one after the other, of which only the first may have a name; rows that differ in length are
/// of different things.
fn run<'m, 't>(members: &'m [Member<'t>], holder: Holder) -> &'m [Member<'t>] {
    let goes_on = |member: &&Member<'_>| {
        matches!(member.kind, Kind::Number(_)) && member.key.is_empty() && !member.follows_bar
    };
    let length = 1 + members[1..].iter().take_while(goes_on).count();
    let run = &members[..length];
    if holder == Holder::Bracket {
        return run;
    }
    let rows = row_lengths(run);
    let first = rows[0];
    let mut same: usize = rows.iter().take_while(|row| **row == first).sum();
    // Under a name of its own line the next line is something else, but for the rows of a matrix.
    if !run[0].key.is_empty() && first < 3 {
        same = first;
    }
    &run[..same]
}

fn row_lengths(run: &[Member<'_>]) -> Vec<usize> {
    let mut lengths = Vec::new();
    let mut row = None;
    for member in run {
        match lengths.last_mut() {
            Some(length) if row == Some(member.row) => *length += 1,
            _ => lengths.push(1),
        }
        row = Some(member.row);
    }
    lengths
}

fn group_of<'t>(run: &[Member<'t>], path: Vec<&'t str>, scope: usize) -> Group<'t> {
    Group {
        path,
        numbers: numbers_of(run),
        rows: row_lengths(run),
        span: run[0].span.to(run[run.len() - 1].span),
        scope,
        is_computed: false,
        is_of_call: false,
        is_of_unknown_call: false,
        has_lengths: run.iter().any(has_length),
        unit: run.iter().find_map(unit),
        has_commas: run[1..].iter().any(|member| member.follows_comma),
        is_line: false,
        remark: "",
    }
}

fn number(member: &Member<'_>) -> Option<f64> {
    match member.kind {
        Kind::Number(value) => Some(value),
        Kind::Word | Kind::Scope => None,
    }
}

/// The brackets at the start that hold only numbers, as many of each as of the first: how many they are,
/// and their numbers row by row.
fn alike(members: &[Member<'_>]) -> Option<(usize, Vec<f64>, Vec<usize>)> {
    let (mut numbers, mut rows) = pure(&members[0])?;
    let mut count = 1;
    // What follows a call of three numbers is something else: `RollPitchYaw(0.1, 0.2, 0.3), [1, 2, 3]`.
    let is_call = members[0].is_call && numbers.len() == 3;
    if rows.len() == 1 && !is_call {
        for next in &members[1..] {
            if next.kind != Kind::Scope || !next.key.is_empty() || next.follows_bar {
                break;
            }
            match pure(next) {
                Some((more, lengths)) if lengths == rows[..1] => {
                    numbers.extend_from_slice(&more);
                    rows.extend_from_slice(&lengths);
                }
                _ => break,
            }
            count += 1;
        }
    }
    Some((count, numbers, rows))
}

/// Whether all brackets in a bracket hold as many numbers: `[[1, 2], [3, 4, 5]]` has no rows.
fn are_alike(members: &[Member<'_>]) -> bool {
    let mut first = None;
    for member in members {
        if member.key.is_empty()
            && let Some((numbers, _)) = pure(member)
            && *first.get_or_insert(numbers.len()) != numbers.len()
        {
            return false;
        }
    }
    true
}

/// The numbers of a bracket that holds nothing else, row by row.
fn pure(member: &Member<'_>) -> Option<(Vec<f64>, Vec<usize>)> {
    let members = &member.members;
    if member.kind != Kind::Scope || members.is_empty() {
        return None;
    }
    let is_number = |member: &Member<'_>| number(member).is_some() && member.key.is_empty();
    if members.iter().all(is_number) {
        return Some((numbers_of(members), row_lengths(members)));
    }
    let (mut numbers, mut rows) = (Vec::new(), Vec::new());
    for inner in members {
        let (own, lengths) = pure(inner).filter(|_| inner.key.is_empty())?;
        // Brackets around one list, or rows of one length.
        if members.len() == 1 {
            return Some((own, lengths));
        }
        rows.push(own.len());
        numbers.extend_from_slice(&own);
    }
    rows.iter()
        .all(|row| *row == rows[0])
        .then_some((numbers, rows))
}

fn numbers_of(members: &[Member<'_>]) -> Vec<f64> {
    let mut numbers = Vec::new();
    for member in members {
        numbers.extend(number(member));
    }
    numbers
}
