//! Words that say something of their numbers: read as they say, or refused at the word.

use crate::asked::{facts, read};
use crate::checked::{check_read, check_refused};
use quatlas::{Convention, Fact, ProblemCode};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn words_of_declarations_and_arguments_of_templates_say_something() {
    use ProblemCode::{OtherQuantity, UnknownWord};
    check_refused(&[
        ("rpy var: 0.1 0.2 0.3", OtherQuantity, "var", "a variance"),
        ("rpy var = 0.1 0.2 0.3", OtherQuantity, "var", "a variance"),
        ("var rpy: 0.1 0.2 0.3", OtherQuantity, "var", "a variance"),
        (
            "var 0.5 0.5 -0.5 0.5",
            UnknownWord,
            "var",
            "what these numbers are",
        ),
        (
            "let 0.5 0.5 -0.5 0.5",
            UnknownWord,
            "let",
            "what these numbers are",
        ),
        (
            "static ZYX 0.1 0.2 0.3",
            UnknownWord,
            "static",
            "what these numbers are",
        ),
        (
            "rotvec new 0.1 0.2 0.3",
            UnknownWord,
            "new",
            "is not a known number, unit or function",
        ),
        (
            "Quaternion<left>(0.5, 0.5, -0.5, 0.5)",
            UnknownWord,
            "Quaternion<left>(0.5, 0.5, -0.5, 0.5)",
            "is not supported here",
        ),
        (
            "rpy<intrinsic>(0.1, 0.2, 0.3)",
            UnknownWord,
            "rpy<intrinsic>(0.1, 0.2, 0.3)",
            "is not supported here",
        ),
    ]);
    check_read(&[
        ("rotvec<deg>(0, 30, 0)", "30deg about y"),
        ("rotvec<rad>(0, 0.5, 0)", "0.5rad about y"),
        ("(double(0.8), 0, double(0.6), 0)", "w=0.8, x=0, y=0.6, z=0"),
        (
            "(const Eigen::Quaterniond q(0.8, 0, 0.6, 0))",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "{const auto q = [0.8, 0, 0.6, 0]}",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        ("Quaternion<xyzw>(0, 0.6, 0, 0.8)", "w=0.8, x=0, y=0.6, z=0"),
        (
            "Quaternion<double>(w=0.8, x=0, y=0.6, z=0)",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "static const std::float64_t q[4] = {0.8, 0, 0.6, 0};",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "const auto q = Eigen::Quaterniond(0.8, 0, 0.6, 0);",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "let q: Quat<f32> = from_xyzw(0, 0.6, 0, 0.8);",
            "w=0.8, x=0, y=0.6, z=0",
        ),
        (
            "var w = 0.8, x = 0, y = 0.6, z = 0;",
            "w=0.8, x=0, y=0.6, z=0",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_turn_about_an_axis_has_one_angle_and_its_words_bare() {
    use ProblemCode::{Unexpected, UnexpectedEnd, UnknownWord, WrongCount};
    check_refused(&[
        // The angle stands before `about` or behind `by`, not in both places.
        ("30deg about y by 25deg", UnknownWord, "y", "y is not"),
        // In quotes they are values.
        (
            r#"about y "by" 25deg"#,
            UnexpectedEnd,
            "",
            "the angle is missing",
        ),
        (
            r#""rotate" 25deg about y"#,
            WrongCount,
            r#""rotate" 25deg"#,
            "one angle",
        ),
        // A component and a number are no names of the whole.
        ("x = 25deg about y", WrongCount, "x = 25deg", "one angle"),
        ("0: 25deg about y", Unexpected, ":", "unexpected “:”"),
        // Three brackets are looked behind, as below, and not more.
        (
            "[[[[25deg about y]]]]",
            Unexpected,
            "25deg",
            "unexpected angle",
        ),
    ]);
    check_read(&[("[[[25deg about y]]]", "25deg about y")]);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_angle_beside_an_axis_is_no_angle_beside_something_else() {
    use ProblemCode::{MixedNames, Unexpected, UnknownComponent, UnknownWord, WrongCount};
    check_refused(&[
        ("25deg, b=[0, 1, 0]", MixedNames, "25deg", "no name"),
        ("a=25deg [0, 1, 0]", Unexpected, "25deg", "unexpected angle"),
        // `j` is a part of a quaternion.
        ("(j, 25deg)", Unexpected, "25deg", "unexpected angle"),
        (
            "axis-angle [0, 1, 0] half",
            WrongCount,
            "[0, 1, 0] half",
            "this is not an axis and an angle",
        ),
        (
            "axis-angle 2 25deg",
            WrongCount,
            "2 25deg",
            "this is not an axis and an angle",
        ),
        // An axis has no unit.
        (
            "axis_deg=[0, 1, 0], angle=25deg",
            UnknownComponent,
            "axis_deg",
            "not a component",
        ),
        (
            "ZYX [[R.from_rotvec([0, 0.5, 0])]]",
            UnknownWord,
            "[[R.from_rotvec([0, 0.5, 0])]]",
            "R.from_rotvec is not",
        ),
    ]);
    check_read(&[
        ("axis-angle y-25deg", "-25deg about y"),
        ("rotvec_deg 0 25 0 deg", "25deg about y"),
        // The call of OpenCV tells which vector it takes.
        ("Rodrigues(0, 0.5, 0)", "0.5rad about y"),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn only_touching_shifts_behind_a_name_begin_a_matrix() {
    use ProblemCode::{MixedUnits, UnclosedBracket, UnknownWord};
    check_refused(&[
        (
            "R < < 0, 0, 1, 0, 1, 0, -1, 0, 0",
            UnknownWord,
            "R",
            "is not a known number, unit or function",
        ),
        (
            "<< 0, 0, 1, 0, 1, 0, -1, 0, 0",
            UnclosedBracket,
            "<",
            "never closed",
        ),
        (
            "R << 0, 0, 1, 0, 1, 0, -1, 0, 0 deg",
            MixedUnits,
            "<<",
            "the angles have different units",
        ),
    ]);
}

/// Words in quotes are words, and no name of a call; a quote ends in its line.
#[wasm_bindgen_test(unsupported = test)]
fn quotes_make_a_word_of_one_line() {
    use ProblemCode::{UnexpectedCharacter, UnknownWord};
    check_refused(&[
        (
            "'Float64Array'(4) [0.6, 0, 0.8, 0]",
            UnknownWord,
            "'Float64Array'",
            "what these numbers are",
        ),
        (
            "'10' 020 0 0",
            UnknownWord,
            "'10'",
            "what these numbers are",
        ),
        (
            "q' = 0.6 0 0.8 0\np' = 1 0 0 0",
            UnexpectedCharacter,
            "'",
            "unexpected character",
        ),
    ]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_setting_stands_behind_a_call_too_and_its_value_is_a_word() {
    check_read(&[(
        "np.array([0, 0, 0.6, 0.8]), order=xyzw",
        "w=0.8, x=0, y=0, z=0.6",
    )]);
    check_refused(&[(
        "order: 321, roll: 10 deg, pitch: 20 deg, yaw: 30 deg",
        ProblemCode::UnknownComponent,
        "order",
        "not a component",
    )]);
}

#[wasm_bindgen_test(unsupported = test)]
fn forty_characters_of_an_unknown_constructor_are_told() {
    let told = |length: usize| {
        let text = format!("{:a>length$}(1, 0, 0, 0)", "quat");
        let name = format!("{:a>length$}", "quat");
        let told = facts(&read(&text, "1 0 0", Convention::HAMILTON));
        let found = told.into_iter().find_map(|fact| match fact {
            Fact::UnknownConstructor(unknown) => Some(unknown.name),
            _ => None,
        });
        (name, found.expect("a note"))
    };
    let (name, found) = told(40);
    assert_eq!(found, name);
    let (name, found) = told(41);
    assert_eq!(found, format!("{}…", &name[..40]));
}

/// Between a word that announces and the mark of a label nothing is passed over that would change the numbers.
#[wasm_bindgen_test(unsupported = test)]
fn a_label_behind_an_announcement_is_not_passed_over() {
    use ProblemCode::{OtherQuantity, UnknownWord};
    check_refused(&[
        ("rotvec turns: 0 0 0.2", UnknownWord, "turns", "what these"),
        (
            "rotation vector in mrad = 0 0 7",
            UnknownWord,
            "mrad",
            "what these",
        ),
        ("gibbs neg: 0 0 0.3", OtherQuantity, "neg", "a negative"),
        ("mrp inv: 0 0 0.3", OtherQuantity, "inv", "an inverse"),
        (
            "quaternion inverse: 0.8 0 0 0.6",
            OtherQuantity,
            "inverse",
            "an inverse",
        ),
        ("rpy half = 0.1 0.2 0.3", UnknownWord, "half", "what these"),
    ]);
    check_read(&[
        ("rotvec deg: 0 0 7", "7deg about z"),
        ("rotvec (deg): 0 0 7", "7deg about z"),
        ("rotvec tool: 0 0 0.2", "0.2rad about z"),
    ]);
}
