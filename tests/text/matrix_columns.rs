//! Texts of a matrix by its columns: three vectors with the names of axes or numbers of columns.

use crate::asked::{facts, read, rotation};
use crate::checked::check_refused;
use crate::rows::row_major;
use quatlas::{
    ComponentOrder, Convention, CosineMatrix, Fact, IdentifyRequest, MatrixLayout, Outcome,
    ParsedRotation, Probe, ProblemCode, Request, analyze, parse_quaternion,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// x goes to −z, y to x and z to −y: no two columns, and no column and row, can be confused.
const ROWS: [f64; 9] = [0.0, 1.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0];

const BY_AXES: &[&str] = &[
    "x: 0 0 -1, y: 1 0 0, z: 0 -1 0",
    "x: 0 0 -1 y: 1 0 0 z: 0 -1 0",
    "x: 0 0 -1\ny: 1 0 0\nz: 0 -1 0",
    "y: 1, 0, 0, z: 0, -1, 0, x: 0, 0, -1",
    "x = [0, 0, -1]; y = [1, 0, 0]; z = [0, -1, 0];",
    "R = [X: (0, 0, -1), Y: (1, 0, 0), Z: (0, -1, 0)]",
    "x_axis: 0 0 -1\ny_axis: 1 0 0\nz_axis: 0 -1 0",
    "x axis: 0 0 -1\ny axis: 1 0 0\nz axis: 0 -1 0",
    "x-axis = (0, 0, -1), y-axis = (1, 0, 0), z-axis = (0, -1, 0)",
    "xAxis = vec3(0, 0, -1), yAxis = vec3(1, 0, 0), zAxis = vec3(0, -1, 0)",
    "axis_x: {0; 0; -1} axis_y: {1; 0; 0} axis_z: {0; -1; 0}",
    "e_x = [0 0 -1], e_y = [1 0 0], e_z = [0 -1 0]",
    r#"{"x": [0, 0, -1], "y": [1, 0, 0], "z": [0, -1, 0]}"#,
    r#"{"basis": {"z": [0, -1, 0], "y": [1, 0, 0], "x": [0, 0, -1]}}"#,
    "matrix x: 0 0 -cos(0), y: 1 0 0, z: 0 -1 0",
];

const BY_NUMBERS: &[&str] = &[
    "col(0) [0, 0, -1]\ncol(1) [1, 0, 0]\ncol(2) [0, -1, 0]",
    "column(1) [0 0 -1], column(2) [1 0 0], column(3) [0 -1 0]",
    "col1: 0 0 -1\ncol3: 0 -1 0\ncol2: 1 0 0",
    "column 0 = 0 0 -1; column 1 = 1 0 0; column 2 = 0 -1 0",
    "R: {col_1: [0, 0, -1], col_2: [1, 0, 0], col_3: [0, -1, 0]}",
    "row(0) [0, 1, 0]\nrow(1) [0, 0, -1]\nrow(2) [-1, 0, 0]",
    "row 1: 0 1 0\nrow 3: -1 0 0\nrow 2: 0 0 -1",
];

#[wasm_bindgen_test(unsupported = test)]
fn labelled_vectors_are_the_columns_of_a_matrix() {
    for text in BY_AXES.iter().chain(BY_NUMBERS) {
        let ParsedRotation::Matrix(matrix) = rotation(text) else {
            panic!("{text}: {:?}", rotation(text));
        };
        assert_eq!(row_major(&matrix), ROWS, "{text}");
    }
    // One number each: components, also where a sum stands for one.
    let parts = "x: 1 - 0.4, y: 0, z: 0, w: 0.1 + 0.7";
    let parsed = parse_quaternion(parts, ComponentOrder::ScalarFirst);
    assert_eq!(parsed.map(|parsed| parsed.quaternion.i), Ok(0.6));
}

/// The turned axes as columns are `R_WB`; whoever wrote rows is told how far away that is.
#[wasm_bindgen_test(unsupported = test)]
fn names_of_axes_are_taken_for_columns_with_a_note() {
    let report = read(
        "x: 0 1 0, y: -1 0 0, z: 0 0 1",
        "1 0 0",
        Convention::HAMILTON,
    );
    assert_eq!(report.hamilton.image, Some([0.0, 1.0, 0.0]));
    let [Fact::AxesAsColumns(axes)] = &facts(&report)[..] else {
        panic!("{:?}", report.notes);
    };
    assert!((axes.rows_differ_by_deg - 180.0).abs() < 1e-12);
    for text in BY_AXES {
        let facts = facts(&read(text, "1 0 0", Convention::JPL));
        let [Fact::AxesAsColumns(axes)] = &facts[..] else {
            panic!("{text}: {facts:?}");
        };
        assert!((axes.rows_differ_by_deg - 120.0).abs() < 1e-12, "{text}");
    }
    // Numbers of columns and rows leave nothing to doubt, nor does what is its own transpose.
    for text in BY_NUMBERS {
        let facts = facts(&read(text, "1 0 0", Convention::HAMILTON));
        assert_eq!(facts, [], "{text}");
    }
    let half = read(
        "x: -1 0 0, y: 0 -1 0, z: 0 0 1",
        "1 0 0",
        Convention::HAMILTON,
    );
    assert_eq!(facts(&half), [Fact::HalfTurn]);
}

/// A library that prints its axes by name may mean rows, and one that numbers its columns says so.
#[wasm_bindgen_test(unsupported = test)]
fn what_a_library_prints_by_axes_leaves_its_layout_open() {
    let matrices = |printed: &str| {
        let probe = Probe::Matrix {
            quaternion: "0.5 0.5 0.5 0.5".to_owned(),
            printed: printed.to_owned(),
            layout: MatrixLayout::AsWritten,
        };
        let request = Request::Identify(IdentifyRequest::new(vec![probe]));
        match analyze(&request) {
            Outcome::Identify(report) => report.remaining.matrix,
            other => panic!("{other:?}"),
        }
    };
    let by_name = matrices("x: 0 1 0, y: 0 0 1, z: 1 0 0");
    assert_eq!(by_name, CosineMatrix::ALL);
    let by_number = matrices("col(0) [0, 1, 0], col(1) [0, 0, 1], col(2) [1, 0, 0]");
    assert_eq!(by_number, [CosineMatrix::Hamilton]);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_three_vectors_is_refused() {
    use ProblemCode::{
        DuplicateComponent, MissingComponent, MixedNames, OtherQuantity, Unexpected,
        UnknownComponent, WrongCount,
    };
    check_refused(&[
        (
            "x: 0 0 -1, y: 1 0 0",
            MissingComponent,
            "x: 0 0 -1, y: 1 0 0",
            "z is missing",
        ),
        (
            "col1: 0 0 -1\ncol3: 1 0 0",
            MissingComponent,
            "col1: 0 0 -1\ncol3: 1 0 0",
            "column 2 is missing",
        ),
        (
            "x: 0 0 -1, y: 1 0 0, y: 0 -1 0",
            DuplicateComponent,
            "y:",
            "y appears twice",
        ),
        (
            "x: 0 0 -1, y: 1 0, z: 0 -1 0",
            WrongCount,
            "1 0",
            "2 numbers",
        ),
        (
            "x: 0 0 -1, y: 1 0 0 2, z: 0 -1 0",
            WrongCount,
            "1 0 0 2",
            "4 numbers",
        ),
        (
            "x: 0 - 0 -1, y: 1 0 0, z: 0 -1 0",
            Unexpected,
            "-",
            "ambiguous sign",
        ),
        (
            "x: 0 0 -1deg, y: 1 0 0, z: 0 -1 0",
            Unexpected,
            "-1deg",
            "unexpected angle",
        ),
        (
            "x: 0 0 -1, y: 1 0 0, z: 0 -1 0, w: 1",
            MixedNames,
            "0",
            "no name",
        ),
        (
            "col(0) [0, 0, -1], col(3) [1, 0, 0]",
            UnknownComponent,
            "col(3)",
            "column 3",
        ),
        (
            "inverse: {x: [0, 0, -1], y: [1, 0, 0], z: [0, -1, 0]}",
            OtherQuantity,
            "inverse",
            "inverse",
        ),
        (
            "R.T = {x: [0, 0, -1], y: [1, 0, 0], z: [0, -1, 0]}",
            OtherQuantity,
            "R.T",
            "a transpose",
        ),
    ]);
}
