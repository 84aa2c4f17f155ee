//! The tree of a text to its quantities: runs of numbers, and single numbers by name.

use crate::convention::angle::AngleUnit;
use crate::problem::Span;
use crate::text::record::outline::{Kind, Member};

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
    pub(crate) follows_bar: bool,
    /// The unit that stands behind one of the numbers.
    pub(crate) unit: Option<AngleUnit>,
    /// Whether commas divide the numbers.
    pub(crate) has_commas: bool,
    /// Whether it stands in a line, in no brackets.
    pub(crate) is_line: bool,
}

/// A word that is a value: `_order: 'XYZ'`.
#[derive(Clone, Debug)]
pub(crate) struct Value<'t> {
    pub(crate) key: &'t str,
    pub(crate) text: &'t str,
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
    others_have_stem: bool,
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
}

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
        found.collect(members, &[""], Holder::Lines);
        found.groups = with_rows_by_name(with_repeated(found.groups));
        found.named = named(&found.groups);
        found
            .groups
            .retain(|group| !(group.numbers.len() == 1 && is_named(group)));
        found
    }

    fn collect(&mut self, members: &[Member<'t>], path: &[&'t str], holder: Holder) {
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
                    });
                    at += 1;
                }
                Kind::Number(_) => {
                    let run = run(rest, holder);
                    self.groups.push(Group {
                        is_line: holder == Holder::Lines,
                        is_computed: run.iter().any(|member| member.is_computed),
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
                            follows_bar: member.follows_bar,
                            unit: alike.iter().find_map(unit),
                            has_commas: true,
                            is_line: false,
                        });
                        at += count;
                    }
                    None => {
                        let inside = if member.is_bracketed {
                            Holder::Bracket
                        } else {
                            Holder::Lines
                        };
                        self.collect(&member.members, &within(member.key), inside);
                        at += 1;
                    }
                },
            }
        }
    }
}

/// Whether lines inside mean anything.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Holder {
    Lines,
    Bracket,
}

fn unit(member: &Member<'_>) -> Option<AngleUnit> {
    member.unit.or_else(|| member.members.iter().find_map(unit))
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
    run.chunk_by(|one, next| one.row == next.row)
        .map(<[_]>::len)
        .collect()
}

fn group_of<'t>(run: &[Member<'t>], path: Vec<&'t str>, scope: usize) -> Group<'t> {
    Group {
        path,
        numbers: run.iter().filter_map(number).collect(),
        rows: row_lengths(run),
        span: run[0].span.to(run[run.len() - 1].span),
        scope,
        is_computed: false,
        follows_bar: run[0].follows_bar,
        unit: run.iter().find_map(unit),
        has_commas: run[1..].iter().any(|member| member.follows_comma),
        is_line: false,
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
    if rows.len() == 1 {
        for next in &members[1..] {
            if next.kind != Kind::Scope || !next.key.is_empty() || next.follows_bar {
                break;
            }
            match pure(next) {
                Some((more, lengths)) if lengths == rows[..1] => {
                    numbers.extend(more);
                    rows.extend(lengths);
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
    let mut lengths = members
        .iter()
        .filter(|member| member.key.is_empty())
        .filter_map(pure)
        .map(|(numbers, _)| numbers.len());
    let first = lengths.next();
    lengths.all(|length| Some(length) == first)
}

/// The numbers of a bracket that holds nothing else, row by row.
fn pure(member: &Member<'_>) -> Option<(Vec<f64>, Vec<usize>)> {
    let members = &member.members;
    if member.kind != Kind::Scope || members.is_empty() {
        return None;
    }
    if members
        .iter()
        .all(|member| number(member).is_some() && member.key.is_empty())
    {
        let numbers: Vec<f64> = members.iter().filter_map(number).collect();
        let rows = row_lengths(members);
        return Some((numbers, rows));
    }
    let inner: Vec<_> = members
        .iter()
        .map(|member| pure(member).filter(|_| member.key.is_empty()))
        .collect::<Option<_>>()?;
    // Brackets around one list, or rows of one length.
    if let [only] = &inner[..] {
        return Some(only.clone());
    }
    let first = inner[0].0.len();
    let same = inner.iter().all(|(numbers, _)| numbers.len() == first);
    same.then(|| {
        let rows = vec![first; inner.len()];
        (
            inner.into_iter().flat_map(|(numbers, _)| numbers).collect(),
            rows,
        )
    })
}

/// The words of a name, in small letters: `m_LocalRotation` is m, local, rotation.
pub(crate) fn words_of(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    let mut characters = name.chars().peekable();
    while let Some(mark) = characters.next() {
        let next_is_small = characters.peek().is_some_and(|next| next.is_lowercase());
        let is_part = mark.is_alphanumeric() || mark == '°' || mark == '±';
        let begins = !before.is_alphanumeric()
            || (before.is_lowercase() && mark.is_uppercase())
            || (before.is_uppercase() && mark.is_uppercase() && next_is_small)
            || (before.is_ascii_digit()
                && mark.is_alphabetic()
                && before != ' '
                && mark.is_uppercase());
        if is_part {
            if begins || words.is_empty() {
                words.push(String::new());
            }
            if let Some(word) = words.last_mut() {
                word.extend(mark.to_lowercase());
            }
        }
        before = mark;
    }
    words
}

/// The names in a key as they are written, in small letters: `CFrame.new` is cframe, new.
pub(crate) fn identifiers_of(key: &str) -> impl Iterator<Item = String> + '_ {
    key.split(|mark: char| !mark.is_alphanumeric() && mark != '_')
        .filter(|name| !name.is_empty())
        .map(str::to_lowercase)
}

/// The name of a single number, and what stands before it: `pose.orientation.x` is x of pose, orientation.
fn name_and_stem(key: &str) -> (String, String) {
    let mut words = words_of(key);
    if words.len() > 1 && words.last().is_some_and(|last| is_addition(last)) {
        words.pop();
    }
    // `a yaw of 12°`
    while words.len() > 1 && words.last().is_some_and(|last| is_filler(last)) {
        words.pop();
    }
    let mut name = words.pop().unwrap_or_default();
    words.retain(|word| !is_filler(word));
    // `q[0]` is q0, `matrix[1][2]` and `M12` are m12.
    let is_place =
        |word: &str| word.len() == 1 && word.starts_with(|first: char| first.is_ascii_digit());
    if is_place(&name) && words.last().is_some_and(|last| is_place(last)) {
        let row = words.pop().unwrap_or_default();
        name = format!("m{row}{name}");
    } else if name.len() == 2 && name.bytes().all(|byte| byte.is_ascii_digit()) {
        name.insert(0, 'm');
    } else if is_place(&name)
        && let Some(of) = words.pop()
    {
        name.insert_str(0, &of);
    }
    // `q_w`, `quat.w`, `qW`: the name says whose component it is.
    if name.len() == 1 && "wxyz".contains(&name) && words.last().is_some_and(|last| last == "q") {
        words.pop();
        name.insert(0, 'q');
    }
    (name, words.join(" "))
}

fn is_filler(word: &str) -> bool {
    [
        "of", "is", "was", "a", "an", "the", "and", "with", "by", "about", "in",
    ]
    .contains(&word)
}

/// What stands behind a name and says its unit or its type.
fn is_addition(word: &str) -> bool {
    [
        "val", "value", "deg", "degrees", "degree", "rad", "radians", "radian", "m", "mm", "°",
    ]
    .contains(&word)
}

fn own_key<'t>(group: &Group<'t>) -> &'t str {
    group.path.last().copied().unwrap_or("")
}

fn is_named(group: &Group<'_>) -> bool {
    !own_key(group).is_empty()
}

/// The single numbers by name, those together that stand together.
fn named<'t>(groups: &[Group<'t>]) -> Vec<Named<'t>> {
    let mut found: Vec<Named<'t>> = Vec::new();
    for group in groups {
        if group.numbers.len() != 1 || !is_named(group) {
            continue;
        }
        let (name, stem) = name_and_stem(own_key(group));
        let member = NamedNumber {
            name,
            value: group.numbers[0],
            span: group.span,
            is_computed: group.is_computed,
            unit: group.unit,
        };
        let path = &group.path[..group.path.len() - 1];
        // Of several that are told in turn, `DesRoll: 1, Roll: 2, DesPitch: …`, that with the same stem.
        let near = found.len().saturating_sub(NEAR);
        let last = found.len().saturating_sub(1);
        let own = (near..found.len()).rev().find(|&at| {
            found[at].scope == group.scope && belongs(&found[at], &stem, &member, at == last)
        });
        if let Some(at) = own {
            found[at].others_have_stem |= !stem.is_empty();
            found[at].members.push(member);
        } else {
            found.push(Named {
                path: path.to_vec(),
                stem,
                members: vec![member],
                scope: group.scope,
                others_have_stem: false,
            });
        }
    }
    found
}

/// How many names a name may stand behind those that it belongs to.
const NEAR: usize = 8;

/// `Position: X 1 Y 2`: only the first is told; `Acc X: 1, Acc Y: 2, q0: 0.5`: the third is not of it.
fn belongs(named: &Named<'_>, stem: &str, member: &NamedNumber, is_last: bool) -> bool {
    let is_new = named.members.iter().all(|own| own.name != member.name);
    let follows = || {
        let last = named.members.last().map_or("", |last| &last.name);
        FOLLOWING.iter().any(|names| {
            let names: Vec<&str> = names.split(' ').collect();
            names.contains(&last) && names.contains(&&*member.name)
        })
    };
    let tells_first_only = stem.is_empty() && !named.others_have_stem && is_last && follows();
    is_new && (stem == named.stem || tells_first_only)
}

/// Names that are told one after the other.
const FOLLOWING: [&str; 5] = [
    "w x y z",
    "roll pitch yaw heading bank",
    "a b c",
    "rx ry rz",
    "i j k real",
];

impl<'t> Quantities<'t> {
    /// With the groups of a table in place of those that stand inside it.
    pub(crate) fn replace(&mut self, inside: impl Fn(Span) -> bool, groups: Vec<Group<'t>>) {
        self.groups.retain(|group| !inside(group.span));
        self.named
            .retain(|named| !named.members.iter().all(|member| inside(member.span)));
        self.named.extend(named(&groups));
    }
}

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
        "" | "r" | "row" | "rows" | "m" => Some("rows"),
        "c" | "col" | "column" | "columns" => Some("columns"),
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

/// The groups with those in place of three or four of them that are the rows or the columns of a matrix.
fn with_rows_by_name(groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
    let groups: Vec<Group<'_>> = groups.into_iter().map(without_numbering).collect();
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
                rows_or_columns(&names).or_else(|| are_axes(&names).then_some("columns"))?;
            (is_one && is_matrix && !(count == 4 && length == 3 && named == "rows"))
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

/// The groups with one in place of single numbers of one name that follow each other: `transform: 0.5` in
/// each of sixteen lines.
fn with_repeated(groups: Vec<Group<'_>>) -> Vec<Group<'_>> {
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

/// Whether a column of this name is a component, an angle or a coordinate.
pub(crate) fn is_usual_name(cell: &str) -> bool {
    const NAMES: &str = "w x y z qw qx qy qz q0 q1 q2 q3 q4 qs qc qr qi qj qk tx ty tz px py pz roll pitch yaw heading \
                         rx ry rz a b c o t phi theta psi phi1 phi2 omega kappa quatw quati quatj quatk \
                         xposition yposition zposition xrotation yrotation zrotation orient1 orient2 orient3 orient4";
    let (name, _) = name_and_stem(cell);
    NAMES.split_whitespace().any(|known| known == name)
}
