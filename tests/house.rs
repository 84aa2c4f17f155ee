//! The rooms of the house: which room of `src` may use which, and that no two files use each other,
//! not even round about. Native only, as it reads the sources.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Every room with those that it may use, from the ground up: a room uses only rooms above its line.
///
/// A room is a folder of `src`, or a file beside the folders. `lib.rs` stands over all of them and hands
/// their names on; no room uses it. Rooms of which there is no folder yet are planned: what will be in
/// them may use no more than this.
const ROOMS: &[(&str, &[&str])] = &[
    ("character", &[]),
    ("decimal", &[]),
    ("convention", &[]),
    ("problem", &["character", "convention"]),
    ("rotation", &["convention"]),
    ("motion", &["convention", "rotation"]),
    ("frames", &["convention", "rotation", "problem"]),
    ("library", &["convention"]),
    ("errata", &["convention", "rotation"]),
    // Planned: many rotations at once, as slices of numbers; no text.
    ("batch", &["convention", "rotation"]),
    // Planned: files of poses, one file a format.
    (
        "trajectory",
        &[
            "decimal",
            "convention",
            "problem",
            "rotation",
            "frames",
            "library",
        ],
    ),
    // Planned: the grammar of pasted formulas, and what they compute.
    (
        "formula",
        &["character", "decimal", "convention", "problem", "rotation"],
    ),
    (
        "text/grammar",
        &["character", "decimal", "convention", "problem"],
    ),
    (
        "text/vocabulary",
        &["character", "convention", "problem", "text/grammar"],
    ),
    (
        "text/description",
        &[
            "character",
            "convention",
            "problem",
            "text/grammar",
            "text/vocabulary",
        ],
    ),
    (
        "text/record",
        &[
            "character",
            "decimal",
            "convention",
            "problem",
            "text/grammar",
            "text/vocabulary",
            "text/description",
        ],
    ),
    ("text/formats", &["convention", "text/record"]),
    (
        "text",
        &[
            "character",
            "decimal",
            "convention",
            "problem",
            "text/grammar",
            "text/vocabulary",
            "text/description",
            "text/record",
            "text/formats",
        ],
    ),
    (
        "contract",
        &[
            "convention",
            "problem",
            "rotation",
            "motion",
            "frames",
            "library",
        ],
    ),
    // Planned: the formula of a value, in symbols and in numbers.
    ("explain", &["convention", "rotation", "motion", "contract"]),
    (
        "analyze",
        &[
            "character",
            "decimal",
            "convention",
            "problem",
            "rotation",
            "motion",
            "frames",
            "library",
            "errata",
            "trajectory",
            "formula",
            "text",
            "contract",
            "explain",
        ],
    ),
    (
        "wasm",
        &[
            "decimal",
            "convention",
            "problem",
            "rotation",
            "motion",
            "library",
            "batch",
            "trajectory",
            "text",
            "contract",
            "analyze",
        ],
    ),
];

/// The crates of JavaScript, and the condition that a build is for it.
const OF_JAVASCRIPT: [&str; 6] = [
    "js_sys",
    "serde_wasm_bindgen",
    "strsim",
    "target_arch",
    "tsify",
    "wasm_bindgen",
];

/// The one mention of JavaScript outside `wasm`: it makes the TypeScript types of what crosses.
const TYPES: &str = "#[cfg_attr(target_arch = \"wasm32\", derive(tsify::Tsify))]";

/// Where the rotation has its methods.
const METHODS_OF_ROTATION: [&str; 2] = ["rotation", "motion"];

fn source_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The code of every file of `src` by its path, such as `text/mod.rs`, without comments, and without the
/// tests at its end; lines are where they were.
fn files() -> BTreeMap<String, String> {
    fn add(folder: &Path, found: &mut BTreeMap<String, String>) {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                add(&path, found);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let name = path.strip_prefix(source_folder()).expect("below src");
                let text = fs::read_to_string(&path).expect("a text");
                let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
                let bare = |line: &str| line.split("//").next().unwrap_or_default().to_owned();
                let lines: Vec<String> = code.lines().map(bare).collect();
                let name = name.to_string_lossy().replace('\\', "/");
                found.insert(name, lines.join("\n"));
            }
        }
    }
    let mut found = BTreeMap::new();
    add(&source_folder(), &mut found);
    found
}

/// The room of a file: the longest name of the table that its path begins with.
fn room_of(file: &str) -> Option<&'static str> {
    let path = file.trim_end_matches(".rs");
    let is_in = |room: &str| path == room || path.starts_with(&format!("{room}/"));
    let rooms = ROOMS.iter().map(|&(room, _)| room);
    rooms
        .filter(|room| is_in(room))
        .max_by_key(|room| room.len())
}

/// The paths behind every `crate::` with their lines; `crate::a::{b, c::d}` are two.
fn paths(code: &str) -> Vec<(String, usize)> {
    let mut found = Vec::new();
    for (at, mark) in code.match_indices("crate::") {
        let line = code[..at].lines().count().max(1);
        let mut open = vec![String::new()];
        let mut path = String::new();
        for character in code[at + mark.len()..].chars() {
            match character {
                '{' => open.push(std::mem::take(&mut path)),
                ',' | '}' if open.len() > 1 => {
                    found.push((open.concat() + &path, line));
                    path.clear();
                    if character == '}' {
                        open.pop();
                    }
                }
                _ if character.is_alphanumeric() || "_:".contains(character) => {
                    path.push(character);
                }
                _ if character.is_whitespace() && open.len() > 1 => {}
                _ => break,
            }
        }
        found.push((open.concat() + &path, line));
    }
    found
}

/// The file in which a path ends: that of its longest part that is a file.
fn file_of(path: &str, files: &BTreeMap<String, String>) -> Option<String> {
    let names: Vec<&str> = path.split("::").filter(|name| !name.is_empty()).collect();
    (1..=names.len()).rev().find_map(|count| {
        let start = names[..count].join("/");
        let candidates = [format!("{start}.rs"), format!("{start}/mod.rs")];
        candidates.into_iter().find(|file| files.contains_key(file))
    })
}

/// What each file uses, and in which line.
fn uses(files: &BTreeMap<String, String>) -> Vec<(&str, usize, String)> {
    let mut found = Vec::new();
    for (file, code) in files.iter().filter(|(file, _)| *file != "lib.rs") {
        for (path, line) in paths(code) {
            if path.is_empty() {
                continue;
            }
            let used = file_of(&path, files).unwrap_or_else(|| format!("lib.rs, for {path}"));
            let use_of_it = (file.as_str(), line, used);
            if use_of_it.2 != *file && found.last() != Some(&use_of_it) {
                found.push(use_of_it);
            }
        }
    }
    found
}

#[test]
fn a_room_uses_only_the_rooms_that_its_line_names() {
    let files = files();
    assert!(files.len() > 80, "{} files", files.len());
    let uses = uses(&files);
    assert!(uses.len() > 300, "{} uses", uses.len());
    let mut wrong: Vec<String> = Vec::new();
    for (file, line, used) in &uses {
        let allowed = match (room_of(file), room_of(used)) {
            (Some(room), Some(other)) => {
                let rooms = ROOMS.iter().find(|(name, _)| *name == room);
                room == other || rooms.is_some_and(|(_, may_use)| may_use.contains(&other))
            }
            _ => false,
        };
        if !allowed {
            wrong.push(format!("src/{file}:{line} uses {used}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_table_leads_down_only() {
    for (at, (room, may_use)) in ROOMS.iter().enumerate() {
        for used in *may_use {
            let below = ROOMS[..at].iter().any(|(other, _)| other == used);
            assert!(
                below,
                "{room} may use {used}, which does not stand before it"
            );
        }
    }
}

#[test]
fn every_file_is_in_a_room() {
    let files = files();
    let homeless: Vec<_> = files
        .keys()
        .filter(|file| *file != "lib.rs" && room_of(file).is_none())
        .collect();
    assert!(homeless.is_empty(), "{homeless:?}");
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let files = files();
    let uses = uses(&files);
    let mut tied: Vec<_> = uses.iter().collect();
    // Files that use nothing that is left, and files that nothing left uses, are in no circle.
    loop {
        let before = tied.len();
        let using: BTreeSet<&str> = tied.iter().map(|(file, _, _)| *file).collect();
        tied.retain(|(_, _, used)| using.contains(used.as_str()));
        let used: BTreeSet<String> = tied.iter().map(|(_, _, used)| used.clone()).collect();
        tied.retain(|(file, _, _)| used.contains(*file));
        if tied.len() == before {
            break;
        }
    }
    let places: Vec<_> = tied
        .into_iter()
        .map(|(file, line, used)| format!("src/{file}:{line} uses {used}"))
        .collect();
    assert!(places.is_empty(), "{places:#?}");
}

/// Paths from the parent would pass the test of the rooms unseen.
#[test]
fn paths_begin_at_the_crate() {
    let found = lines_with(&files(), |_, line| line.contains("super::"));
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn one_room_knows_javascript() {
    let found = lines_with(&files(), |file, line| {
        let is_known = OF_JAVASCRIPT.iter().any(|name| line.contains(name));
        is_known && room_of(file) != Some("wasm") && file != "lib.rs" && line.trim() != TYPES
    });
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn rotations_have_their_methods_in_two_rooms() {
    let found = lines_with(&files(), |file, line| {
        let is_there = room_of(file).is_some_and(|room| METHODS_OF_ROTATION.contains(&room));
        line.starts_with("impl Rotation") && !is_there
    });
    assert!(found.is_empty(), "{found:#?}");
}

/// The places of the lines that are `wrong`.
fn lines_with(files: &BTreeMap<String, String>, wrong: fn(&str, &str) -> bool) -> Vec<String> {
    let mut found = Vec::new();
    for (file, code) in files {
        for (at, line) in code.lines().enumerate() {
            if wrong(file, line) {
                found.push(format!("src/{file}:{} {}", at + 1, line.trim()));
            }
        }
    }
    found
}
