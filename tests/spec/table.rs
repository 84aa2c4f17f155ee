//! The table of the specification names tests that exist: native only, as it reads the tests' sources.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

const TABLE: &str = include_str!("table.md");

/// The inventory of the specification: 86 + 34 + 60 + 77 of four documents, 26 completions, 19 of the
/// model, 3 recipes.
const IDS: usize = 305;

/// Ids without numbers that a test could hold.
const WITHOUT_TEST: usize = 10;

/// The ids of the table with what stands in their last column.
fn rows() -> Vec<(&'static str, &'static str)> {
    let cells = |line: &'static str| {
        let row = line.strip_prefix("| ")?.strip_suffix(" |")?;
        Some((row.split_once(" | ")?.0, row.rsplit_once(" | ")?.1))
    };
    TABLE
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| id |"))
        .filter_map(cells)
        .collect()
}

/// The names between backticks.
fn named_tests(cell: &str) -> impl Iterator<Item = &str> {
    let pieces = cell.split('`').enumerate();
    pieces.filter_map(|(at, piece)| (at % 2 == 1).then_some(piece))
}

/// The sources of the tests by the paths of their modules, which begin with the crate: `spec::euler`.
fn sources() -> BTreeMap<String, String> {
    let mut sources = BTreeMap::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")];
    let root = folders[0].clone();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of tests") {
            let path = entry.expect("a file or a folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let source = fs::read_to_string(&path).expect("a text");
                let file = path.strip_prefix(&root).expect("below").with_extension("");
                let module = file.iter().map(|name| name.to_string_lossy());
                sources.insert(module.collect::<Vec<_>>().join("::"), source);
            }
        }
    }
    sources
}

/// Whether a source has a test with this name: the line above it is the attribute.
fn has_test(source: &str, function: &str) -> bool {
    let head = format!("fn {function}() {{");
    let lines: Vec<&str> = source.lines().collect();
    lines
        .windows(2)
        .any(|pair| pair[1] == head && pair[0].starts_with("#[") && pair[0].contains("test"))
}

#[test]
fn every_id_stands_once_and_all_are_there() {
    let rows = rows();
    let ids: BTreeSet<&str> = rows.iter().map(|(id, _)| *id).collect();
    assert_eq!((rows.len(), ids.len()), (IDS, IDS));
}

#[test]
fn every_id_has_a_test_that_exists_or_a_reason() {
    let sources = sources();
    let mut without = 0;
    for (id, cell) in rows() {
        let mut tests = 0;
        for name in named_tests(cell) {
            let (file, function) = name.rsplit_once("::").expect("crate::file::function");
            let source = sources
                .get(file)
                .unwrap_or_else(|| panic!("{id}: no file {file}"));
            assert!(has_test(source, function), "{id}: no test {name}");
            tests += 1;
        }
        if tests == 0 {
            let is_reason = cell.starts_with("no numbers: ") || cell.starts_with("not here: ");
            assert!(is_reason, "{id}: {cell:?} is neither a test nor a reason");
            without += 1;
        }
    }
    assert_eq!(without, WITHOUT_TEST);
}

#[test]
fn an_id_that_a_test_names_stands_in_the_table_with_that_test() {
    let rows: BTreeMap<&str, &str> = rows().into_iter().collect();
    let is_id = |word: &&str| {
        let kinds = ["000-", "002-", "003-", "004-", "FX-", "MODEL-", "NUM-"];
        kinds.iter().any(|kind| word.starts_with(kind))
    };
    for (file, source) in sources() {
        let mut cited: Vec<&str> = Vec::new();
        for line in source.lines() {
            if let Some(comment) = line.strip_prefix("/// ") {
                let words = comment.split([' ', ',', ':', '(', ')']);
                cited.extend(
                    words
                        .map(|word| word.trim_end_matches(['.', ';']))
                        .filter(is_id),
                );
            } else if let Some(function) = line.strip_prefix("fn ") {
                let function = function.split('(').next().unwrap_or_default();
                if has_test(&source, function) {
                    for id in &cited {
                        let cell = rows.get(id).unwrap_or_else(|| panic!("{file}: no id {id}"));
                        let name = format!("{file}::{function}");
                        let is_named = named_tests(cell).any(|test| test == name);
                        assert!(is_named, "{id} does not name {name}");
                    }
                }
                cited.clear();
            } else if !line.starts_with("#[") {
                cited.clear();
            }
        }
    }
}
