//! Numbers whose names say that they are the rows or the columns of one matrix.

use crate::text::record::names::{names_of_list, words_of};
use crate::text::record::quantity::{Group, own_key};

/// The groups with those in place of three or four of them that are the rows or the columns of a matrix.
pub(crate) fn with_rows_by_name(groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
    let groups: Vec<Group<'_>> = groups
        .into_iter()
        .filter(|group| own_key(group) != "REMARK")
        .map(without_numbering)
        .collect();
    let mut all: Vec<Group<'_>> = Vec::new();
    let mut rest = &groups[..];
    while let Some(first) = rest.first() {
        let of_matrix = [4, 3].into_iter().find_map(|count| {
            let rows = rest.get(..count)?;
            let length = first.numbers.len();
            let is_one = rows
                .iter()
                .all(|row| row.numbers.len() == length && row.scope == first.scope);
            let names: Vec<String> = rows
                .iter()
                .map(|row| {
                    let words = words_of(own_key(row));
                    let words = words.iter().filter(|word| !word.starts_with("vec"));
                    let words: Vec<&str> = words.map(String::as_str).collect();
                    let axis = words
                        .windows(2)
                        .find(|pair| pair.contains(&"axis"))
                        .map(|pair| pair.concat());
                    axis.unwrap_or_else(|| words.last().copied().unwrap_or_default().to_owned())
                })
                .collect();
            let is_matrix = matches!((count, length), (3, 3 | 4) | (4, 3 | 4));
            let named =
                rows_or_columns(&names).or_else(|| are_axes(&names).then_some(BY_COLUMNS))?;
            (is_one && is_matrix && !(count == 4 && length == 3 && named == BY_ROWS))
                .then_some((rows, named))
        });
        match of_matrix {
            Some((rows, named)) => {
                let mut path = first.path[..first.path.len() - 1].to_vec();
                path.push(named);
                all.push(Group {
                    path,
                    numbers: rows.iter().flat_map(|row| row.numbers.clone()).collect(),
                    rows: rows.iter().map(|row| row.numbers.len()).collect(),
                    span: rows[0].span.to(rows[rows.len() - 1].span),
                    is_computed: rows.iter().any(|row| row.is_computed),
                    ..first.clone()
                });
                rest = &rest[rows.len()..];
            }
            None => {
                all.push(first.clone());
                rest = &rest[1..];
            }
        }
    }
    all
}

/// What a matrix is named whose rows, or columns, have names.
pub(crate) const BY_ROWS: &str = "row by row";
pub(crate) const BY_COLUMNS: &str = "column by column";

/// What the names of three or four groups say of them: `R0`, `R1`, `R2` are rows, `c0`, `c1`, `c2` columns.
fn rows_or_columns(names: &[String]) -> Option<&'static str> {
    let stems: Vec<(&str, char)> = names
        .iter()
        .map(|name| {
            let last = name.chars().next_back()?;
            Some((&name[..name.len() - last.len_utf8()], last))
        })
        .collect::<Option<_>>()?;
    let (stem, first) = stems[0];
    let goes_on = stems
        .iter()
        .zip(u32::from(first)..)
        .all(|(&(own, last), expected)| own == stem && u32::from(last) == expected);
    match stem {
        _ if !goes_on || !first.is_ascii_digit() => None,
        "" | "r" | "row" | "rows" | "m" => Some(BY_ROWS),
        "c" | "col" | "column" | "columns" => Some(BY_COLUMNS),
        _ => None,
    }
}

/// `x_axis`, `y_axis`, `z_axis`, and `w_axis` where there is a translation: the columns.
fn are_axes(names: &[String]) -> bool {
    let axis = |name: &String| {
        let name = name
            .strip_suffix("axis")
            .or_else(|| name.strip_prefix("axis"));
        name.map(str::to_owned)
    };
    let axes: Option<String> = names.iter().map(axis).collect();
    // Godot writes `X: (…), Y: (…), Z: (…), O: (…)`.
    axes.is_some_and(|axes| axes == "xyz" || axes == "xyzw") || names.concat() == "xyzo"
}

/// The groups with one in place of single numbers of one name that follow each other: `transform: 0.5` in
/// each of sixteen lines.
pub(crate) fn with_repeated(groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
    let is_same = |one: &Group<'_>, next: &Group<'_>| {
        one.numbers.len() == 1
            && next.numbers.len() == 1
            && one.scope == next.scope
            && !own_key(one).is_empty()
            && own_key(one) == own_key(next)
    };
    groups
        .chunk_by(is_same)
        .map(|same| match same {
            [only] => only.clone(),
            _ => Group {
                numbers: same
                    .iter()
                    .flat_map(|group| group.numbers.clone())
                    .collect(),
                rows: vec![same.iter().map(|group| group.numbers.len()).sum()],
                span: same[0].span.to(same[same.len() - 1].span),
                is_computed: same.iter().any(|group| group.is_computed),
                ..same[0].clone()
            },
        })
        .collect()
}

/// A row of a PDB file without the numbers of its operator before and of its flag behind.
fn without_numbering(group: Group<'_>) -> Group<'_> {
    let words = words_of(own_key(&group));
    let is_pdb = words.last().is_some_and(|last| {
        let stem = last.trim_end_matches(|digit: char| digit.is_ascii_digit());
        ["biomt", "mtrix", "smtry"].contains(&stem)
    });
    if !is_pdb || !(5..=6).contains(&group.numbers.len()) {
        return group;
    }
    let name = words.last().map_or("", |last| &last[last.len() - 1..]);
    let row = ["r1", "r2", "r3"]
        .into_iter()
        .find(|row| row.ends_with(name));
    let mut path = group.path.clone();
    path.pop();
    path.push(row.unwrap_or("r1"));
    Group {
        path,
        numbers: group.numbers[1..5].to_vec(),
        rows: vec![4],
        ..group
    }
}

/// The groups with single numbers in place of those whose name is a list of theirs: `(φ₁, Φ, φ₂) = (10, 20, 30)`.
pub(crate) fn with_listed_names(groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
    groups
        .into_iter()
        .flat_map(|group| {
            let key = own_key(&group);
            let Some(names) = names_of_list(key, group.numbers.len()) else {
                return vec![group];
            };
            let scope = usize::MAX - group.span.start;
            names
                .into_iter()
                .zip(group.numbers.clone())
                .map(|(name, number)| {
                    let mut path = group.path.clone();
                    path.push(name);
                    Group {
                        path,
                        numbers: vec![number],
                        rows: vec![1],
                        scope,
                        ..group.clone()
                    }
                })
                .collect()
        })
        .collect()
}
