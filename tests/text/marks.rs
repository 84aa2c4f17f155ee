//! Single characters that change what a text means: dashes that are drawn, signs in a row, marks of a
//! document, and what is not seen.

use crate::checked::refusal;
use crate::support::{assert_close, wxyz};
use quatlas::{
    ComponentOrder, Field, ParsedRotation, ProblemCode, parse_quaternion, parse_rotation,
    parse_vector,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Texts of one field with the place of their problem and a word of its message.
#[track_caller]
fn check_messages(field: Field, code: ProblemCode, texts: &[(&str, &str, &str)]) {
    for (text, place, word) in texts {
        let message = refusal(field, text, code, place).message;
        assert!(message.contains(word), "{text}: {message}");
    }
}

#[track_caller]
fn quaternion(text: &str) -> [f64; 4] {
    let parsed = parse_quaternion(text, ComponentOrder::ScalarFirst);
    wxyz(
        &parsed
            .unwrap_or_else(|problem| panic!("{}", problem.render(text)))
            .quaternion,
    )
}

#[track_caller]
fn check_quaternions(expected: [f64; 4], texts: &[&str]) {
    for text in texts {
        assert_close(text, &quaternion(text), &expected, 2.3e-16);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_line_that_is_drawn_looks_like_a_minus_where_it_may_be_one() {
    let texts = [
        // It touches a number, a letter, a bracket or a sign.
        ("0.6 ─0.8 0 0", "─", "part of a frame, or a sign"),
        ("0.6 ━0.8 0 0", "━", "part of a frame, or a sign"),
        ("0.6 ╌0.8 0 0", "╌", "part of a frame, or a sign"),
        ("0.6 ═0.8 0 0", "═", "part of a frame, or a sign"),
        ("[0.6, ╴0.8, 0, 0]", "╴", "part of a frame, or a sign"),
        ("0.6─0.8 0 0", "─", "part of a frame, or a sign"),
        ("0.6 0.8 0 0─", "─", "part of a frame, or a sign"),
        ("0.6 + ─0.8i", "─", "part of a frame, or a sign"),
        (
            "w: ─0.6, x: 0, y: 0.8, z: 0",
            "─",
            "part of a frame, or a sign",
        ),
        ("90° about ─z", "─", "part of a frame, or a sign"),
        ("about ─z by 90°", "─", "part of a frame, or a sign"),
        ("─90° about z", "─", "part of a frame, or a sign"),
        ("ZYX ──30 20 10 deg", "──", "part of a frame, or a sign"),
        ("rotvec 0 0 ─0.5", "─", "part of a frame, or a sign"),
        ("│0.6 0.8 0 0│", "│", "part of a frame, or a sign"),
        ("│ 0.6 ┼─0.8 0 0 │", "┼─", "part of a frame, or a sign"),
        // It stands apart, among numbers.
        ("0.6 ─ 0.8 0 0", "─", "part of a frame, or a sign"),
        ("0.6 0 ── 0.8 0", "──", "part of a frame, or a sign"),
        ("│ 0.6 │ ─ 0.8 │ 0 │ 0 │", "─", "part of a frame, or a sign"),
        ("─ 0.6 0.8 0 0", "─", "part of a frame, or a sign"),
        // Diagonals are no part of a frame.
        ("1 ╱ 2 0 1", "╱", "unexpected character"),
    ];
    check_messages(Field::Quaternion, ProblemCode::UnexpectedCharacter, &texts);
    check_messages(Field::P, ProblemCode::UnexpectedCharacter, &texts);
    let vectors = [
        ("3 ─2 1", "─", "part of a frame, or a sign"),
        ("3 2 ━1", "━", "part of a frame, or a sign"),
        ("3 ─ 2 1", "─", "part of a frame, or a sign"),
        ("3i ─ 2j + k", "─", "part of a frame, or a sign"),
    ];
    check_messages(Field::Vector, ProblemCode::UnexpectedCharacter, &vectors);
    // Every dash, and every dash beside a bar, which together are no corner.
    for dash in "─━┄┅┈┉╌╍═╴╶╸╺╼╾".chars() {
        let alone = dash.to_string();
        for text in [format!("{dash} 0.6 0.8 0 0"), format!("0.6 {dash} 0.8 0 0")] {
            let refused = [(&*text, &*alone, "part of a frame, or a sign")];
            check_messages(
                Field::Quaternion,
                ProblemCode::UnexpectedCharacter,
                &refused,
            );
        }
    }
    for bar in "│┃┆┇┊┋╎╏║╵╷╹╻╽╿".chars() {
        let run = format!("{bar}─");
        let text = format!("0.6 {run} 0.8 0 0");
        let refused = [(&*text, &*run, "part of a frame, or a sign")];
        check_messages(
            Field::Quaternion,
            ProblemCode::UnexpectedCharacter,
            &refused,
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_frame_around_numbers_is_passed_over() {
    let texts = [
        "│ 0.6 0 -0.8 0 │",
        "┌──────────────┐\n│ 0.6 0 -0.8 0 │\n└──────────────┘",
        "╔═══╦══════╗\n║ w: ║ 0.6  ║\n║ x: ║ 0    ║\n╠═══╬══════╣\n║ y: ║ -0.8 ║\n║ z: ║ 0    ║\n╚═══╩══════╝",
        "┌      ┐\n│  0.6 │\n│  0   │\n│ -0.8 │\n│  0   │\n└      ┘",
        "──────\n0.6 0 -0.8 0\n── ──",
        "├── w: 0.6\n├── x: 0\n├── y: -0.8\n└── z: 0",
        "┏ [0.6, 0, ┃ -0.8, 0] ┛",
    ];
    check_quaternions([0.6, 0.0, -0.8, 0.0], &texts);
    let matrix = "╭ 0 -1 0 ╮\n│ 1  0 0 │\n╰ 0  0 1 ╯";
    let parsed = parse_rotation(matrix, ComponentOrder::ScalarFirst);
    let Ok(ParsedRotation::Matrix(rows)) = parsed else {
        panic!("{parsed:?}")
    };
    assert_eq!((rows[(0, 1)], rows[(1, 0)]), (-1.0, 1.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn three_dashes_are_signs_or_the_mark_of_a_document() {
    let signs = [
        ("---0.6 + 0.8k", "---", "---"),
        ("0.6 0 0.8\n---0", "---", "---"),
        ("ZYX\n30\n20\n---10", "---", "---"),
        ("[0.92,\n(0.1, 0.2,\n---0.38)]", "---", "---"),
        ("--- 0.6 0 0 0.8", "---", "---"),
        ("  ---k", "---", "---"),
        ("- 1\n- 2\n- 3\n---4", "---", "---"),
        // A comment behind the mark has a space before it.
        ("---# c\n- 1\n- 0", "---# c\n-", "----"),
    ];
    check_messages(Field::Quaternion, ProblemCode::Unexpected, &signs);
    let vectors = [("---3 2 1", "---", "---"), ("3i\n---2j + k", "---", "---")];
    check_messages(Field::Vector, ProblemCode::Unexpected, &vectors);
    let documents = [
        "---\n0.6 0 -0.8 0\n---",
        "---\nw: 0.6\nx: 0\ny: -0.8\nz: 0\n---",
        "--- # the first\nw: 0.6\nx: 0\ny: -0.8\nz: 0\n--- ",
        "--- {w: 0.6, x: 0, y: -0.8, z: 0}",
        "---\t[0.6, 0, -0.8, 0]",
        "---\n- 0.6\n- 0\n- -0.8\n- 0",
        "--- # an array\n- 0.6\n- 0\n- -0.8\n- 0\n---",
    ];
    check_quaternions([0.6, 0.0, -0.8, 0.0], &documents);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_dash_of_a_list_has_any_white_space_behind_it() {
    check_quaternions(
        [0.6, 0.0, -0.8, 0.0],
        &[
            "-\t0.6\n-\t0\n-\t-0.8\n-\t0",
            "  - 0.6\n  - 0\n  -\t-0.8\n  - 0",
            "data:\n# w x y z\n- 0.6\n- 0\n\n- -0.8\n- 0",
        ],
    );
}

/// What is not seen and what groups digits, by the words that name it.
const HIDDEN: [(char, &str); 20] = [
    ('\u{b}', "vertical tab U+000B"),
    ('\u{c}', "form feed U+000C"),
    ('\u{85}', "line break U+0085"),
    ('\u{2028}', "line separator U+2028"),
    ('\u{2029}', "paragraph separator U+2029"),
    ('\u{a0}', "no-break space U+00A0"),
    ('\u{ad}', "soft hyphen U+00AD"),
    ('\u{2006}', "U+2006"),
    ('\u{2007}', "figure space U+2007"),
    ('\u{2008}', "U+2008"),
    ('\u{2009}', "thin space U+2009"),
    ('\u{200a}', "hair space U+200A"),
    ('\u{200b}', "zero-width space U+200B"),
    ('\u{200c}', "U+200C"),
    ('\u{200d}', "U+200D"),
    ('\u{202f}', "narrow no-break space U+202F"),
    ('\u{205f}', "U+205F"),
    ('\u{2060}', "word joiner U+2060"),
    ('\u{feff}', "byte order mark U+FEFF"),
    ('\u{200b}', "zero-width space U+200B"),
];

#[wasm_bindgen_test(unsupported = test)]
fn what_is_hardly_seen_inside_a_number_is_named() {
    for (character, name) in HIDDEN {
        let place = character.to_string();
        for text in [
            "1@000 0 0 0",
            "0.7@07 0 0 0.7",
            "[1, 0, 0, 0.5@5]",
            "ZYX 3@0 20 10",
        ] {
            let text = text.replace('@', &place);
            check_messages(
                Field::Quaternion,
                ProblemCode::UnexpectedCharacter,
                &[(&text, &place, name)],
            );
        }
        for text in ["10@000 5", "1@0 2", "3 2 1@5"] {
            let text = text.replace('@', &place);
            check_messages(
                Field::Vector,
                ProblemCode::UnexpectedCharacter,
                &[(&text, &place, name)],
            );
        }
    }
    // Two of them are as good as one; what is not seen joins signs and points as well.
    check_messages(
        Field::Vector,
        ProblemCode::UnexpectedCharacter,
        &[
            ("1\u{202f}\u{200b}000 0 0", "\u{202f}", "U+202F"),
            ("1\u{200b}.5 0 0", "\u{200b}", "U+200B"),
            ("0.\u{2060}5 0 0", "\u{2060}", "U+2060"),
            ("3\u{feff}-2 1", "\u{feff}", "U+FEFF"),
        ],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn three_digits_that_begin_with_a_zero_may_be_thousands() {
    check_messages(
        Field::Vector,
        ProblemCode::Unexpected,
        &[
            ("10 000 5", "10 000", "grouped"),
            ("1 050 2", "1 050", "grouped"),
            ("3 2 -123 000.5", "123 000.5", "grouped"),
        ],
    );
    check_messages(
        Field::Quaternion,
        ProblemCode::Unexpected,
        &[("1 000 0 0 0", "1 000", "grouped")],
    );
    // As headings are written, of numbers with a point, with commas, and on lines of their own.
    for text in [
        "010 000 005",
        "10.0 000 5",
        "10, 000, 5",
        "10\n000\n5",
        "10 0 5",
        "10 0.000 5",
    ] {
        let vector = parse_vector(text).expect(text);
        assert_eq!(vector.as_slice(), [10.0, 0.0, 5.0], "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_hardly_seen_elsewhere_does_no_harm() {
    let texts = [
        "\u{feff}0.6 0 -0.8 0",
        "[0.6,\u{a0}0,\u{202f}-0.8,\u{2009}0]\u{200b}",
        "0.6\u{a0} 0 \u{202f}-0.8\u{2007}\n0",
        "w:\u{a0}0.6\u{200b}, x:\u{2009}0, y: -0.8, z: 0",
        "0.6\u{a0}-0.8\u{a0}j",
        "Float64Array(4)\u{200b} [ 0.6, 0, -0.8, 0 ]",
        "Float64Array(4) \u{feff}[\u{2060}0.6, 0, -0.8, 0 ]",
        // A wide space is seen.
        "0.6\u{2003}0\u{3000}-0.8\u{2002}0",
    ];
    check_quaternions([0.6, 0.0, -0.8, 0.0], &texts);
}

#[wasm_bindgen_test(unsupported = test)]
fn of_signs_in_a_row_only_those_of_a_sum_are_read() {
    let texts = [
        ("0.5 --0.5 0.5 0.5", "--", "--"),
        ("-+0.5 0.5 0.5 0.5", "-+", "-+"),
        ("+-0.5 0.5 0.5 0.5", "+-", "+-"),
        ("0.5, ++0.5, 0.5, 0.5", "++", "++"),
        ("[0.5, 0.5, 0.5, − −0.5]", "− −", "−−"),
        ("0.5--0.5, 0, 0, 0.5", "--", "--"),
        ("0.5+-0.1 0 0 0.8", "+-", "+-"),
        ("0.6--0.8k", "--", "--"),
        ("0.6 -+0.8k", "-+", "-+"),
        ("w=--0.6 x=0 y=0 z=0.8", "--", "--"),
        ("--45° about z", "--", "--"),
        ("rpy 0.1 --0.2 0.3", "--", "--"),
        ("rotvec 0 0 -+0.5", "-+", "-+"),
        ("0 -1 0; --1 0 0; 0 0 1", "--", "--"),
        ("cos(--pi/8) 0 0 sin(pi/8)", "--", "--"),
        ("2*--0.3 0 0 0.8", "--", "--"),
    ];
    let many = "-".repeat(30);
    let shown = format!("several signs ({}…) in a row", "-".repeat(24));
    check_messages(
        Field::Quaternion,
        ProblemCode::Unexpected,
        &[(&format!("{many}1 0 0 0"), &many, &shown)],
    );
    check_messages(Field::Quaternion, ProblemCode::Unexpected, &texts);
    let vectors = [
        ("1 --2 3", "--", "--"),
        ("[1, -+2, 3]", "-+", "-+"),
        ("3i - --2j", "--", "--"),
    ];
    check_messages(Field::Vector, ProblemCode::Unexpected, &vectors);
    check_quaternions(
        [0.6, 0.0, -0.8, 0.0],
        &[
            "0.6 + 0i + -0.8j + 0k",
            "0.6+0i+-0.8j+0k",
            "0.6 +0i +-0.8j",
            "0.6 - 0.8j",
            "0.6 - +0.8j",
            "[1 - 0.4, 0, 0.1 - 0.9, 0]",
            "[1 - +0.4, 0, -(0.8), 0]",
            "2*0.3 0 2*-0.4 0",
        ],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_that_run_together_are_no_difference() {
    let texts = [
        (
            "12.5 0.5000-0.5000 0.5000 0.5000",
            "0.5000-0.5000",
            "may be a difference, or two numbers that run together",
        ),
        (
            "0.5000-0.5000 0.5000 0.5000",
            "0.5000-0.5000",
            "may be a difference, or two numbers that run together",
        ),
        (
            "0.5000-0.5000-0.5000 0.5000",
            "0.5000-0.5000",
            "may be a difference, or two numbers that run together",
        ),
        (
            "0.1 0.2 0.3+0.4 0.5",
            "0.3+0.4",
            "may be a difference, or two numbers that run together",
        ),
        (
            "1.0E-01−2.0E-01 0.3 0.4 0.5",
            "1.0E-01−2.0E-01",
            "may be a difference, or two numbers that run together",
        ),
        (
            "rpy 0.1-0.2 0.3 0.4",
            "0.1-0.2",
            "may be a difference, or two numbers that run together",
        ),
        (
            "ZYX 30°-20° 10° 5°",
            "30°-20",
            "may be a difference, or two numbers that run together",
        ),
        (
            "rotvec 0.1 0.2-0.3 0.4",
            "0.2-0.3",
            "may be a difference, or two numbers that run together",
        ),
        (
            "axis-angle 0 0 1-0.5 0.7",
            "1-0.5",
            "may be a difference, or two numbers that run together",
        ),
        (
            "0 -1 0; 1 0-1 0; 0 0 1",
            "0-1",
            "may be a difference, or two numbers that run together",
        ),
        (
            "[0.5-0.5 0.5 0.5]",
            "0.5-0.5",
            "may be a difference, or two numbers that run together",
        ),
        (
            "-0.5-0.5-0.5-0.5",
            "0.5-0.5",
            "may be a difference, or two numbers that run together",
        ),
        (
            "rpy 0.1-0.2-0.3",
            "0.1-0.2",
            "may be a difference, or two numbers that run together",
        ),
        (
            "0.5 0.5- 0.5 0.5 0.5",
            "-",
            "touches the number before it, not the one after it",
        ),
        (
            "0.5- 0.5 0.5 0.5",
            "-",
            "touches the number before it, not the one after it",
        ),
        (
            "0.5+ 0.5 0.5 0.5",
            "+",
            "touches the number before it, not the one after it",
        ),
    ];
    check_messages(Field::Quaternion, ProblemCode::Unexpected, &texts);
    check_messages(
        Field::Vector,
        ProblemCode::Unexpected,
        &[
            (
                "1.0-2.0 3 4",
                "1.0-2.0",
                "may be a difference, or two numbers that run together",
            ),
            (
                "3 2-1",
                "2-1",
                "may be a difference, or two numbers that run together",
            ),
            (
                "3 2- 1 5",
                "-",
                "touches the number before it, not the one after it",
            ),
        ],
    );
    // What only arithmetic can be, and what commas or units hold apart.
    let third = 1.0 / 3.0;
    check_quaternions(
        [0.75, 0.0, -third, 0.5],
        &[
            "1-1/4 0 -1/3 1-1/2",
            "[1-0.25, 0, 2/3-1, 1- 0.5]",
            "√4-5/4 0 -1/3 0.5",
            "1-0.25 - 1/3 j + 0.5k",
            "0.25+0.5+0i-1/3j+0.5k",
            "(1-0.25) 0 (-1/3) 0.5",
        ],
    );
}
