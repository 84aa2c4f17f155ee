//! What the page copies, pasted back: the same attitude, whatever is declared, or no rotation.

use crate::asked::{facts, read};
use crate::checked::{attitude, check_read, problem};
use crate::rows::row_major;
use crate::support::assert_close;
use quatlas::nalgebra::Matrix3;
use quatlas::{
    Convention, Direction, Fact, Field, Handedness, Outcome, ReadReport, ReadRequest, Request,
    analyze,
};
use serde::Deserialize;
use wasm_bindgen_test::wasm_bindgen_test;

/// Written by `tests/browser/copied_texts.spec.ts`; the rotations were checked with `SciPy` (`check_copied.py`).
const COPIED: &str = include_str!("../vectors/copied.json");

#[derive(Deserialize)]
struct Copy {
    value: String,
    format: String,
    text: String,
    /// The matrix of the numbers, and which coordinates it takes to which; of what is no rotation there is none.
    rotation: Option<[[f64; 3]; 3]>,
    direction: Option<Direction>,
}

fn copies() -> Vec<Copy> {
    serde_json::from_str(COPIED).expect("JSON")
}

fn matrix(rows: [[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| rows[row][column])
}

const DECLARED: [Convention; 4] = [
    Convention::HAMILTON,
    Convention::HAMILTON_SCALAR_LAST,
    Convention::JPL,
    Convention {
        direction: Direction::BodyToWorld,
        ..Convention::JPL
    },
];

#[wasm_bindgen_test(unsupported = test)]
fn every_copy_of_a_rotation_is_read_as_what_it_was() {
    let mut count = 0;
    for copy in copies() {
        let (Some(rows), Some(direction)) = (copy.rotation, copy.direction) else {
            continue;
        };
        let expected = match direction {
            Direction::BodyToWorld => matrix(rows),
            Direction::WorldToBody => matrix(rows).transpose(),
        };
        for declared in DECLARED {
            // Which coordinates a matrix takes that a program printed its text does not tell.
            if copy.value == "row-matrix" && declared != Convention::HAMILTON {
                continue;
            }
            let what = format!(
                "{} as {}, {declared}: {}",
                copy.value, copy.format, copy.text
            );
            let report = read(&copy.text, "1 0 0", declared);
            let body_to_world = matrix(report.hamilton.matrix);
            assert_close(
                &what,
                &row_major(&body_to_world),
                &row_major(&expected),
                1e-14,
            );
            // Of a norm of 2 it is asked what it is.
            let stops = report.notes.iter().any(|note| note.stops);
            assert!(
                !stops || copy.value == "norm-2",
                "{what}: {:?}",
                report.notes
            );
            count += 1;
        }
    }
    assert!(count > 850, "{count}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_copy_that_is_no_rotation_is_none_and_a_vector_is_one() {
    let mut count = 0;
    for copy in copies() {
        if copy.rotation.is_some() {
            continue;
        }
        problem(Field::Quaternion, &copy.text);
        count += 1;
        if copy.value == "vector" {
            let request = ReadRequest::new("1 0 0 0", &copy.text, Convention::HAMILTON);
            let Outcome::Read(report) = analyze(&Request::Read(request)) else {
                panic!("{}", copy.text);
            };
            // C(q) v of 1, 2, 3, as the page shows it beside q.
            let image = [
                3.248_694_436_848_364_6,
                0.622_236_111_653_688_4,
                1.748_944_446_614_753,
            ];
            assert_close(&copy.text, &report.vector, &image, 0.0);
        }
    }
    assert!(count > 15, "{count}");
}

/// The direction and the product that a report says the text told.
fn told(report: &ReadReport) -> Option<(Direction, Option<Handedness>)> {
    facts(report).iter().find_map(|fact| match fact {
        Fact::DirectionFromText(told) => Some((told.direction, told.handedness)),
        _ => None,
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn a_convention_that_a_copy_tells_wins_and_is_said() {
    use Direction::{BodyToWorld, WorldToBody};
    let (left, right) = (Some(Handedness::Left), Some(Handedness::Right));
    for copy in copies() {
        let (in_hamilton, in_jpl) = match copy.value.as_str() {
            "hamilton" => (None, Some((BodyToWorld, right))),
            "jpl" => (Some((WorldToBody, left)), None),
            "yoosefian" => (Some((BodyToWorld, left)), Some((BodyToWorld, None))),
            // Active from body to world is passive from world to body.
            "active" | "hamilton-conjugate" => {
                (Some((WorldToBody, None)), Some((WorldToBody, right)))
            }
            _ => continue,
        };
        let of = |declared| told(&read(&copy.text, "1 0 0", declared));
        assert_eq!(of(Convention::HAMILTON), in_hamilton, "{}", copy.text);
        assert_eq!(of(Convention::JPL), in_jpl, "{}", copy.text);
    }
    // The product alone tells neither a direction nor, with one, an order.
    for text in [
        "0.1 -0.2 0.4 0.9 # JPL",
        "0.1 -0.2 0.4 0.9 # JPL, world to body",
    ] {
        let said = problem(Field::Quaternion, text).message;
        assert!(said.contains("JPL"), "{text}: {said}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn latex_is_read_as_people_write_it() {
    const ROWS: &str = "0.36 0.48 -0.8; -0.8 0.6 0; 0.48 0.64 0.6";
    for text in [
        r"R = \begin{pmatrix} 0.36 & 0.48 & -0.8 \\ -0.8 & 0.6 & 0 \\ 0.48 & 0.64 & 0.6 \\ \end{pmatrix}",
        r"$$R_{wb} = \left[\begin{array}{ccc} 0.36 & 0.48 & -0.8 \\ -0.8 & 0.6 & 0 \\ 0.48 & 0.64 & 0.6 \end{array}\right]$$",
        "\\[ \\mathbf{R} =\n\\begin{bmatrix}\n0.36&0.48&-0.8\\\\\n-0.8&0.6&0\\\\\n0.48&0.64&0.6\n\\end{bmatrix} \\]",
    ] {
        check_read(&[(text, ROWS)]);
    }
    check_read(&[
        (
            r"q = \begin{bmatrix} 0.6 \\ 0 \\ 0.48 \\ -0.64 \end{bmatrix}",
            "0.6 0 0.48 -0.64",
        ),
        (
            r"q = \begin{bmatrix} 0.6 & 0 & 0.48 & -0.64 \end{bmatrix}^T",
            "0.6 0 0.48 -0.64",
        ),
        (
            r"\mathbf{q} = \left( 0.6, 0, 0.48, -0.64 \right)",
            "0.6 0 0.48 -0.64",
        ),
        (
            r"q = 0.6 + 0.48 \, \mathbf{j} - 0.64\,\mathbf{k}",
            "0.6 0 0.48 -0.64",
        ),
        (
            r"q = \begin{pmatrix} 1 & 2.5 \cdot 10^{-3} & 0 & 0 \end{pmatrix}",
            "1 0.0025 0 0",
        ),
        (
            r"\theta u = \begin{bmatrix} 0.2 & -0.4 & 0.8 \end{bmatrix}^{\top}",
            "rotvec 0.2 -0.4 0.8",
        ),
    ]);
    // What was made of a rotation, or of numbers, is not made here.
    for text in [
        r"R = \begin{bmatrix} 0.36 & 0.48 & -0.8 \\ -0.8 & 0.6 & 0 \\ 0.48 & 0.64 & 0.6 \end{bmatrix}^{\mathsf{T}}",
        r"R^T = \begin{bmatrix} 0.36 & 0.48 & -0.8 \\ -0.8 & 0.6 & 0 \\ 0.48 & 0.64 & 0.6 \end{bmatrix}",
        r"q^{*} = \begin{bmatrix} 0.6 & 0 & 0.48 & -0.64 \end{bmatrix}^{\mathsf{T}}",
        r"q^{-1} = \begin{bmatrix} 0.6 & 0 & 0.48 & -0.64 \end{bmatrix}",
        r"\bar{q} = \begin{bmatrix} 0.6 & 0 & 0.48 & -0.64 \end{bmatrix}",
        r"\dot{q} = \begin{bmatrix} 0.6 & 0 & 0.48 & -0.64 \end{bmatrix}",
        r"q = \begin{pmatrix} \frac{1}{2} & \frac{1}{2} & \frac{1}{2} & -\frac{1}{2} \end{pmatrix}",
        r"R = R_z(0.8) \, R_y(-0.4) \, R_x(0.2)",
    ] {
        problem(Field::Quaternion, text);
    }
}

/// The numbers are those of `SciPy`: `from_euler("ZYX", [0.8, -0.4, 0.2])`, and turns of 0.9 about an axis.
#[wasm_bindgen_test(unsupported = test)]
fn a_product_of_turns_is_read_only_where_it_is_all_there_is() {
    const Z_Y_X: &str =
        "0.8904676905493675 0.16709871096919254 -0.14397038794385558 0.3980173869008816";
    const ABOUT: &str = "0.9004471023526769 0.26097932046673816 0 -0.3479724272889842";
    for (text, expected) in [
        (
            "Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX())",
            Z_Y_X,
        ),
        (
            "axang2rotm([0 0 1 0.8]) * axang2rotm([0 1 0 -0.4]) * axang2rotm([1 0 0 0.2])",
            Z_Y_X,
        ),
        (
            "UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.8) * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -0.4)\n * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.2);",
            Z_Y_X,
        ),
        (
            "let q = UnitQuaternion::from_axis_angle(&Unit::new_normalize(Vector3::new(0.6, 0.0, -0.8)), 0.9);",
            ABOUT,
        ),
        (
            "new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0.6, 0, -0.8), 0.9)",
            ABOUT,
        ),
        (
            "Rotation.from_rotvec(0.9 * np.array([0.6, 0, -0.8]))",
            ABOUT,
        ),
    ] {
        let distance = attitude(text).angle_to_rad(&attitude(expected));
        assert!(distance < 1e-14, "{text}: {distance} rad");
    }
    let (z, y) = (
        "Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ())",
        "Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY())",
    );
    for text in [
        format!("q = ({z} * {y}).inverse();"),
        format!("q = {z}.inverse() * {y};"),
        format!("q = {z} * q0 * {y};"),
        format!("q = q0 * {z} * {y};"),
        format!("q = {z} * {y} * q0;"),
        format!("q = {z} + {y};"),
        format!("q = {z} * Eigen::AngleAxisd(-0.4, Eigen::Vector3d(0.6, 0.8, 0));"),
        "R = inv(axang2rotm([0 0 1 0.8]) * axang2rotm([0 1 0 -0.4]));".to_owned(),
        "R = axang2rotm([0 0 1 0.8]) * axang2rotm([0 1 0 -0.4])';".to_owned(),
        "q = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0.6, 0, 0.8), 0.9).invert();".to_owned(),
        "q = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0.6, 0, 0.8), 0.9).multiply(q0);".to_owned(),
        "M = new THREE.Matrix3().set(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6).transpose();".to_owned(),
        "r = Rotation.from_rotvec(x * 0.9 * np.array([0.6, 0, 0.8]))".to_owned(),
        "r = Rotation.from_rotvec(0.9 * np.array([0.6, 0, 0.8])).inv()".to_owned(),
        "q0.multiply(new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0.6, 0, 0.8), 0.9));".to_owned(),
        "let q = q0 * UnitQuaternion::from_axis_angle(&Unit::new_normalize(Vector3::new(0.6, 0.0, 0.8)), 0.9);".to_owned(),
        "(Vector((0, 0, 1)), 0.5) * (Vector((1, 0, 0)), 0.7)".to_owned(),
    ] {
        problem(Field::Quaternion, &text);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_comment_in_json_says_what_one_in_code_would() {
    const ROWS: &str = r#""R": [[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]]"#;
    check_read(&[
        (
            &format!(r#"{{"comment": "camera to world", {ROWS}, "t": [1, 2, 3]}}"#),
            "0.36 0.48 -0.8; -0.8 0.6 0; 0.48 0.64 0.6",
        ),
        (
            &format!(r#"{{"comment": "world to camera", {ROWS}, "t": [1, 2, 3]}}"#),
            "0.36 -0.8 0.48; 0.48 0.6 0.64; -0.8 0 0.6",
        ),
        (
            r#"{"sequence": "zyx", "frame": "intrinsic", "angles": [0.3, 0.2, 0.1], "unit": "rad"}"#,
            "ZYX 0.3rad 0.2rad 0.1rad",
        ),
    ]);
    problem(
        Field::Quaternion,
        &format!(r#"{{"comment": "inverse of the pose", {ROWS}, "t": [1, 2, 3]}}"#),
    );
}
