//! Numbers whose names say that they are the rows or the columns of one matrix.

use crate::character::is_digit;
use crate::text::record::names::{names_of_list, words_of};
use crate::text::record::quantity::{Group, own_key};

/// The groups with those in place of three or four of them that are the rows or the columns of a matrix.
pub(crate) fn with_rows_by_name(mut groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
    groups.retain(|group| own_key(group) != "REMARK");
    for group in &mut groups {
        take_numbering(group);
    }
    let mut all: Vec<Group<'_>> = Vec::new();
    let mut rest = &groups[..];
    while let Some(first) = rest.first() {
        let of_matrix = rows_at_start(rest, 4).or_else(|| rows_at_start(rest, 3));
        let (count, named) = of_matrix.unwrap_or((1, ""));
        let mut group = first.clone();
        for row in &rest[1..count] {
            add(&mut group, row);
        }
        if count > 1 {
            group.path.pop();
            group.path.push(named);
            group.rows = vec![first.numbers.len(); count];
        }
        all.push(group);
        rest = &rest[count..];
    }
    all
}

/// How many groups at the start are the rows or the columns of one matrix, and what it is named.
fn rows_at_start(groups: &[Group<'_>], count: usize) -> Option<(usize, &'static str)> {
    let rows = groups.get(..count)?;
    let length = rows[0].numbers.len();
    let mut names: Vec<String> = Vec::new();
    for row in rows {
        if row.numbers.len() != length || row.scope != rows[0].scope || !matches!(length, 3 | 4) {
            return None;
        }
        names.push(name_of_row(own_key(row)));
    }
    let named = rows_or_columns(&names).or_else(|| are_axes(&names).then_some(BY_COLUMNS))?;
    (!(count == 4 && length == 3 && named == BY_ROWS)).then_some((count, named))
}

/// The last word of a key, or the axis that it names.
fn name_of_row(key: &str) -> String {
    let mut words = words_of(key);
    words.retain(|word| !word.starts_with("vec"));
    for at in 1..words.len() {
        if words[at - 1] == "axis" || words[at] == "axis" {
            return words[at - 1..=at].concat();
        }
    }
    words.pop().unwrap_or_default()
}

/// Numbers that follow those of a group, with their place.
fn add(group: &mut Group<'_>, next: &Group<'_>) {
    group.numbers.extend_from_slice(&next.numbers);
    group.span = group.span.to(next.span);
    group.is_computed |= next.is_computed;
}

/// What a matrix is named whose rows, or columns, have names.
pub(crate) const BY_ROWS: &str = "row by row";
pub(crate) const BY_COLUMNS: &str = "column by column";

/// What the names of three or four groups say of them: `R0`, `R1`, `R2` are rows, `c0`, `c1`, `c2` columns.
fn rows_or_columns(names: &[String]) -> Option<&'static str> {
    let (stem, first) = stem_and_digit(names.first()?)?;
    for (name, expected) in names.iter().zip(first..) {
        if stem_and_digit(name) != Some((stem, expected)) {
            return None;
        }
    }
    match stem {
        "" | "r" | "row" | "rows" | "m" => Some(BY_ROWS),
        "c" | "col" | "column" | "columns" => Some(BY_COLUMNS),
        _ => None,
    }
}

/// A name that ends with a digit, without it.
fn stem_and_digit(name: &str) -> Option<(&str, u8)> {
    let (digit, stem) = name.as_bytes().split_last()?;
    // Behind `9` no digit follows, and the last of `R7`, `R8`, `R9` is compared all the same.
    (digit.is_ascii_digit()).then(|| (&name[..stem.len()], *digit))
}

/// `x_axis`, `y_axis`, `z_axis`, and `w_axis` where there is a translation: the columns.
fn are_axes(names: &[String]) -> bool {
    let mut axes = String::new();
    for name in names {
        let axis = name
            .strip_suffix("axis")
            .or_else(|| name.strip_prefix("axis"));
        axes.push_str(axis.unwrap_or("-"));
    }
    // Godot writes `X: (…), Y: (…), Z: (…), O: (…)`.
    axes == "xyz" || axes == "xyzw" || names.concat() == "xyzo"
}

/// The groups with one in place of single numbers of one name that follow each other: `transform: 0.5` in
/// each of sixteen lines.
pub(crate) fn with_repeated(groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
    let mut all: Vec<Group<'_>> = Vec::new();
    let mut last_is_single = false;
    for group in groups {
        let is_single = group.numbers.len() == 1;
        if let Some(last) = all.last_mut()
            && last_is_single
            && is_single
            && last.scope == group.scope
            && !own_key(last).is_empty()
            && own_key(last) == own_key(&group)
        {
            add(last, &group);
            last.rows = vec![last.numbers.len()];
        } else {
            last_is_single = is_single;
            all.push(group);
        }
    }
    all
}

/// Leaves of a row of a PDB file neither the numbers of its operator before nor its flag behind.
fn take_numbering(group: &mut Group<'_>) {
    if !(5..=6).contains(&group.numbers.len()) {
        return;
    }
    let Some(name) = words_of(own_key(group)).pop() else {
        return;
    };
    let stem = name.trim_end_matches(is_digit);
    if !["biomt", "mtrix", "smtry"].contains(&stem) {
        return;
    }
    let row = match name.as_bytes().last() {
        Some(b'2') => "r2",
        Some(b'3') => "r3",
        _ => "r1",
    };
    group.path.pop();
    group.path.push(row);
    group.numbers = group.numbers[1..5].to_vec();
    group.rows = vec![4];
}

/// The groups with single numbers in place of those whose name is a list of theirs: `(φ₁, Φ, φ₂) = (10, 20, 30)`.
pub(crate) fn with_listed_names(groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
    let mut all: Vec<Group<'_>> = Vec::new();
    for group in groups {
        let Some(names) = names_of_list(own_key(&group), group.numbers.len()) else {
            all.push(group);
            continue;
        };
        for (at, name) in names.into_iter().enumerate() {
            let mut single = group.clone();
            single.path.push(name);
            single.numbers = vec![group.numbers[at]];
            single.rows = vec![1];
            single.scope = usize::MAX - group.span.start;
            all.push(single);
        }
    }
    all
}
