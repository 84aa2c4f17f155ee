//! The build script: what it makes of records, and what it says where one is wrong.

#[expect(dead_code, clippy::print_stdout, reason = "its main, for cargo")]
#[path = "../../src/library/build.rs"]
mod build;

use build::in_rust;

const ONE: &str = r#"{
    "id": "one", "name": "One", "group": "graphics", "language": "c", "version": "1", "known": "run"
}"#;

/// What is said of a table whose second record is this.
fn said_of(second: &str) -> String {
    in_rust(&format!("[{ONE}, {second}]")).expect_err(second)
}

#[test]
fn a_wrong_record_is_named_with_its_member() {
    let wrong = [
        r#""arayOrder": "scalar-last" => .arayOrder: unknown field `arayOrder`, expected one of"#,
        r#""arrayOrder": "xyzw" => .arrayOrder: unknown variant `xyzw`, expected `scalar-first`"#,
        r#""rotate": "Q" => .rotate: unknown variant `Q`, expected `R` or `C`"#,
        r#""words": "Two" => .words: invalid type: string "Two", expected a sequence"#,
        r#""zero": { "inverse": "0" } => .zero.inverse: unknown variant `0`"#,
        r#""euler": [{ "call": "q(a, b, c)" }] => .euler[0]: missing field `means`"#,
        r#""id": "two" => : duplicate field `id`"#,
    ];
    for case in wrong {
        let (member, expected) = case.split_once(" => ").expect("an arrow");
        let two = ONE.replace("one", "two");
        let said = said_of(&two.replacen('{', &format!("{{ {member},"), 1));
        assert!(said.starts_with(&format!("\"two\"{expected}")), "{said}");
    }
}

#[test]
fn what_is_missing_is_said_of_its_record() {
    let said = said_of(r#"{ "id": "two", "name": "Two" }"#);
    assert!(said.starts_with("\"two\": missing field `group`"), "{said}");
    let said = in_rust("[{]").expect_err("no JSON");
    assert!(said.contains("line 1 column 3"), "{said}");
}

#[test]
fn a_record_is_written_with_what_it_leaves_out() {
    let written = in_rust(&format!("[{}]", ONE.replace("One", r#"\"O\u006ee\""#))).expect("right");
    let expected = r#"&[Library { id: "one", name: "\"One\"", words: &[], kind: None, group: Group::Graphics, "#;
    assert!(written.starts_with(expected), "{written}");
    assert!(
        written.contains("rotate: None, matrix: None, "),
        "{written}"
    );
}
