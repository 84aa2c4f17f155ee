//! What is said and offered for nine numbers that are no rotation.

use crate::asked::{problems, read, read_request};
use crate::support::assert_close;
use quatlas::{Convention, Outcome, Problem, ProblemCode, ReadRequest, Remedy, Request, analyze};
use wasm_bindgen_test::wasm_bindgen_test;

#[track_caller]
fn problem(text: &str) -> Problem {
    let [problem] = problems(analyze(&read_request(text, "1 0 0", Convention::JPL)))
        .try_into()
        .expect("one problem");
    problem
}

fn offered(text: &str) -> String {
    let suggestion = problem(text).suggestion.expect("a suggestion");
    suggestion.text
}

#[wasm_bindgen_test(unsupported = test)]
fn the_flipped_axis_is_named_and_turned_round() {
    // A turn about each axis with that axis flipped, and the turn itself; 3-4-5 triangles.
    let cases = [
        (
            "x",
            "-1 0 0  0 0.6 -0.8  0 0.8 0.6",
            "1 0 0\n0 0.6 -0.8\n0 0.8 0.6",
        ),
        (
            "y",
            "0.6 0 0.8  0 -1 0  -0.8 0 0.6",
            "0.6 0 0.8\n0 1 0\n-0.8 0 0.6",
        ),
        (
            "z",
            "0.6 -0.8 0  0.8 0.6 0  0 0 -1",
            "0.6 -0.8 0\n0.8 0.6 0\n0 0 1",
        ),
        // Nearer to −I than to I: all three turned round would leave a turn by 106°.
        (
            "x",
            "-1 0 0  0 0.28 -0.96  0 0.96 0.28",
            "1 0 0\n0 0.28 -0.96\n0 0.96 0.28",
        ),
    ];
    for (axis, mirrored, turn) in cases {
        let found = problem(mirrored);
        assert_eq!(found.code, ProblemCode::Reflection);
        assert!(
            found
                .message
                .ends_with(&format!(": the {axis} axis is flipped")),
            "{}",
            found.message
        );
        assert_eq!(offered(mirrored), turn);
        assert_eq!(read(turn, "1 0 0", Convention::JPL).notes, []);
    }
    // Two decimals leave it 2.6° off its opposite.
    for (cosine, is_named) in [("0.999", true), ("0.998", false)] {
        let mirrored = format!("-{cosine} 0.05 0  0.05 {cosine} 0  0 0 1");
        let found = problem(&mirrored);
        let names = found.message.ends_with(": the x axis is flipped");
        assert_eq!(names, is_named, "{}", found.message);
        let turn = format!("{cosine} 0.05 0\n-0.05 {cosine} 0\n0 0 1");
        assert_eq!(offered(&mirrored), turn);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_flip_that_the_matrix_does_not_tell_is_the_one_of_the_smallest_turn() {
    // Yaw 30°, pitch 20°, roll 10°, each column flipped in turn: what is offered is the turn itself.
    let columns = [
        [
            0.813_797_681_349_373_7,
            0.469_846_310_392_954_2,
            -0.342_020_143_325_668_7,
        ],
        [
            -0.440_969_610_529_882_4,
            0.882_564_119_259_385_6,
            0.163_175_911_166_534_82,
        ],
        [
            0.378_522_306_369_792_5,
            0.018_028_311_236_297_29,
            0.925_416_578_398_323_4,
        ],
    ];
    let text = |signs: [f64; 3]| {
        let row = |row: usize| {
            let entries = [0, 1, 2].map(|at| (signs[at] * columns[at][row]).to_string());
            entries.join(" ")
        };
        [0, 1, 2].map(row).join("\n")
    };
    let axes = ["x", "y", "z"];
    for (flipped, axis) in axes.into_iter().enumerate() {
        let signs = [0, 1, 2].map(|at| if at == flipped { -1.0 } else { 1.0 });
        let found = problem(&text(signs));
        assert!(
            found
                .message
                .ends_with(&format!("one axis is flipped, perhaps {axis}"))
        );
        assert_eq!(offered(&text(signs)), text([1.0; 3]));
    }
    // Of an axis at right angles to itself: x would leave a turn by 130°, z by 90°.
    let mirrored = "0.64 0.48 -0.6  0.48 0.36 0.8  -0.6 0.8 0";
    assert!(
        problem(mirrored)
            .message
            .ends_with("one axis is flipped, perhaps z")
    );
    assert_eq!(
        offered(mirrored),
        "0.64 0.48 0.6\n0.48 0.36 -0.8\n-0.6 0.8 0"
    );
    let found = problem(&text([-1.0; 3]));
    assert!(found.message.ends_with("all three axes are flipped"));
    assert_eq!(offered(&text([-1.0; 3])), text([1.0; 3]));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_nearest_rotation_is_offered_with_its_distance_and_read_as_declared() {
    // Half again as long in z, beyond any rounding; the nearest rotation is the quarter turn.
    let text = "0 -1 0  1 0 0  0 0 1.5";
    let found = problem(text);
    assert_eq!(found.code, ProblemCode::NotARotation);
    assert!(
        found.message.contains("a rotation times 1, 1 and 1.5"),
        "{}",
        found.message
    );
    let suggestion = found.suggestion.expect("a suggestion");
    assert_eq!(suggestion.remedy, Remedy::NearestRotation);
    assert_eq!(suggestion.text, "0 -1 0\n1 0 0\n0 0 1");

    // Declared world to body it is the same nine numbers, not their transpose.
    let mut request = ReadRequest::new(text, "1 0 0", Convention::JPL);
    request.matrix = quatlas::MatrixConvention::WORLD_TO_BODY;
    let [found] = problems(analyze(&Request::Read(request.clone())))
        .try_into()
        .expect("one problem");
    let Problem { suggestion, .. } = found;
    request.quaternion = suggestion.expect("a suggestion").text;
    assert_eq!(request.quaternion, "0 -1 0\n1 0 0\n0 0 1");
    let Outcome::Read(report) = analyze(&Request::Read(request)) else {
        panic!("a report")
    };
    assert_eq!(report.jpl.matrix[0], [0.0, -1.0, 0.0]);
    assert_eq!(report.notes, []);
}

/// A tenth away from a rotation is rounding to one decimal, and read; what is farther away is a mistake.
#[wasm_bindgen_test(unsupported = test)]
fn nine_numbers_within_a_tenth_of_a_rotation_are_read() {
    let stretched = |entry: &str| format!("0 -1 0\n1 0 0\n0 0 {entry}");
    for near in ["1.02", "1.099", "0.901"] {
        let report = read(&stretched(near), "1 0 0", Convention::JPL);
        let half = 0.5_f64.sqrt();
        assert_close(
            near,
            &report.hamilton.unit.array,
            &[half, 0.0, 0.0, half],
            1e-15,
        );
    }
    for far in ["1.101", "0.899"] {
        let found = problem(&stretched(far));
        assert_eq!(found.code, ProblemCode::NotARotation, "{far}");
    }
}

/// Columns of one direction: whatever turns that direction right is as near.
#[wasm_bindgen_test(unsupported = test)]
fn of_columns_in_a_line_no_rotation_is_the_nearest() {
    for text in ["1 0 0 0 0 0 0 0 0", "0.6 0.6 0  0.8 0.8 0  0 0 0"] {
        let found = problem(text);
        assert_eq!(found.code, ProblemCode::NotARotation);
        assert!(
            found.message.ends_with("no single rotation is nearest"),
            "{}",
            found.message
        );
        assert_eq!(found.suggestion, None);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn far_from_every_rotation_nothing_is_offered() {
    // Of 1 to 9 the nearest rotation is 15.9 away, and of a mirror image that is no turn there is none.
    for text in ["1 2 3 4 5 6 7 8 9", "1 2 3 4 5 6 7 8 10"] {
        assert_eq!(problem(text).suggestion, None, "{text}");
    }
}
