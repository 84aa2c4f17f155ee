//! Where one more turn changes the sign of q, and quarter turns in degrees, which are exact.

use crate::asked::{compose, facts, read};
use crate::support::{all_conventions, assert_close};
use quatlas::{Convention, Fact, Field, MatrixConvention, Outcome, ReadRequest, Request, analyze};
use wasm_bindgen_test::wasm_bindgen_test;

fn tells_the_sign(text: &str, convention: Convention) -> bool {
    facts(&read(text, "1 0 0", convention)).contains(&Fact::NegativeScalar)
}

#[wasm_bindgen_test(unsupported = test)]
fn angles_that_lead_to_a_negative_scalar_are_told() {
    let texts = [
        "405deg about z",
        "-405° about [1, 2, 2]",
        "181° about x",
        "270 deg about y",
        "360° about z",
        "4 rad about x",
        "rotvec 0 0 4",
        "rotvec 0 0 200 deg",
        "ZYX 400° 0 0",
        "rpy 20° 30° 350°",
        // Each angle within half a turn, and the product of the half angles beyond.
        "ZYX 170° 80° -170°",
        "R.from_euler('z', 300, degrees=True)",
    ];
    let others = [
        "45deg about z",
        "-170° about x",
        "180° about x",
        "-180° about y",
        "540.0000001deg about z",
        "720° about z",
        "765° about z",
        "pi rad about x",
        "3.141592653589793 about x",
        "rotvec 0 0 3",
        "rotvec pi 0 0",
        "ZYX 170° 80° 170°",
        "ZYX 180° 0 0",
        "rpy 0 180° 180°",
        // Half a turn, whose scalar of -5e-17 is only rounded.
        "ZYX pi 1e-16 -pi",
    ];
    for convention in [Convention::HAMILTON, Convention::JPL] {
        for text in texts {
            assert!(tells_the_sign(text, convention), "{text}");
        }
        for text in others {
            assert!(!tells_the_sign(text, convention), "{text}");
        }
    }
    // cos and sin of 202.5°, whose turn is by 45°.
    let report = read("405deg about z", "1 0 0", Convention::HAMILTON);
    let expected = [-0.923_879_532_511_286_7, 0.0, 0.0, -0.382_683_432_365_089_8];
    assert_close("q", &report.hamilton.unit.array, &expected, 2e-16);
    assert_close("turn", &[report.turn.angle_deg], &[45.0], 1e-14);
    // Each operand tells its own.
    let report = compose("405deg about z", "45deg about z", "1 0 0", Convention::JPL);
    let told: Vec<Field> = report
        .notes
        .iter()
        .filter(|note| note.fact == Fact::NegativeScalar)
        .map(|note| note.field)
        .collect();
    assert_eq!(told, [Field::P]);
}

/// A matrix tells no sign of q.
#[wasm_bindgen_test(unsupported = test)]
fn the_scalar_of_a_matrix_is_not_negative() {
    let matrices = [
        // Quarter turns about z, both ways, and three turns by 120° and 240°.
        "0 1 0; -1 0 0; 0 0 1",
        "0 -1 0; 1 0 0; 0 0 1",
        "0 0 1; 1 0 0; 0 1 0",
        "0 -1 0; 0 0 -1; 1 0 0",
        "0 0 -1; -1 0 0; 0 1 0",
        // About (1, 2, 2) by 170° and by 190°, about (-3, 1, 2) by 203°, about (2, -5, 1) by -157°.
        "-0.764274 0.325303 0.556834; 0.556834 -0.102671 0.824254; 0.325303 0.940020 -0.102671",
        "-0.764274 0.556834 0.325303; 0.325303 -0.102671 0.940020; 0.556834 0.824254 -0.102671",
        "0.314105 -0.202682 -0.927501; -0.620391 -0.783326 -0.038924; -0.718646 0.587640 -0.371789",
        "-0.664438 -0.568831 0.484721; -0.711506 0.679916 -0.177409; -0.228653 -0.462759 -0.856488",
        "1 0 0; 0 -1 0; 0 0 -1",
    ];
    for convention in all_conventions() {
        for matrix in [MatrixConvention::default(), MatrixConvention::WORLD_TO_BODY] {
            for text in matrices {
                let mut request = ReadRequest::new(text, "1 0 0", convention);
                request.matrix = matrix;
                let Outcome::Read(report) = analyze(&Request::Read(request)) else {
                    panic!("{text} is not read")
                };
                assert!(report.declared.unit.w >= 0.0, "{text} in {convention}");
                assert!(!facts(&report).contains(&Fact::NegativeScalar), "{text}");
            }
        }
    }
}

/// A text, its quaternion w x y z and the rows of its matrix body to world.
type Exact = (&'static str, [f64; 4], [[f64; 3]; 3]);

#[wasm_bindgen_test(unsupported = test)]
fn quarter_turns_in_degrees_are_exact() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let cases: [Exact; 9] = [
        (
            "90° about z",
            [half, 0.0, 0.0, half],
            [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        ),
        (
            "-90 deg about x",
            [half, -half, 0.0, 0.0],
            [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
        ),
        (
            "180° about y",
            [0.0, 0.0, 1.0, 0.0],
            [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
        ),
        (
            "270° about y",
            [-half, 0.0, half, 0.0],
            [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
        ),
        (
            "360° about z",
            [-1.0, 0.0, 0.0, 0.0],
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        ),
        (
            "-450° about z",
            [-half, 0.0, 0.0, half],
            [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        ),
        (
            "720° about z",
            [1.0, 0.0, 0.0, 0.0],
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        ),
        // Yaw, pitch and roll by quarter turns: the columns are the body's axes in the world.
        (
            "ZYX 90 0 90 deg",
            [0.5, 0.5, 0.5, 0.5],
            [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        ),
        (
            "rpy 180° 360° -90°",
            [0.0, half, -half, 0.0],
            [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
        ),
    ];
    for (text, unit, rows) in cases {
        let report = read(text, "1 0 0", Convention::HAMILTON);
        let array = report.hamilton.unit.array;
        let opposite = unit.map(|number| 0.0 - number);
        assert!(
            array == unit || (text.starts_with("rpy") && array == opposite),
            "{text}: {array:?}"
        );
        assert_close(
            text,
            report.hamilton.matrix.as_flattened(),
            rows.as_flattened(),
            0.0,
        );
    }
    // No turn at all, not one by 1e-14°.
    assert!(facts(&read("360° about x", "1 0 0", Convention::JPL)).contains(&Fact::NoTurn));
    // A little more than a quarter turn is not rounded to one.
    let near = read("90.00000000000003° about z", "1 0 0", Convention::HAMILTON);
    assert_ne!(near.hamilton.matrix[0][0], 0.0);
}

/// What is printed of the smallest angles is read back.
#[wasm_bindgen_test(unsupported = test)]
fn the_smallest_angle_in_degrees_is_read_back() {
    for radians in ["5e-324", "1e-323", "3.5e-323", "4.4e-320"] {
        let text = format!("rotvec {radians} 0 0");
        let report = read(&text, "1 0 0", Convention::HAMILTON);
        let degrees = format!("rotvec {:e} 0 0 deg", report.turn.angle_deg);
        let back = read(&degrees, "1 0 0", Convention::HAMILTON);
        assert_eq!(back.turn.angle_rad, report.turn.angle_rad, "{degrees}");
        let about = format!("{:e}deg about x", report.turn.angle_deg);
        let back = read(&about, "1 0 0", Convention::HAMILTON);
        assert_eq!(back.turn.angle_rad, report.turn.angle_rad, "{about}");
    }
}
