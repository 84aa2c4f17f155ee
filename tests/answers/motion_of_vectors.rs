//! A covariance on other axes, and how the image of a point changes with the attitude.

use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Matrix3, Quaternion, Vector3};
use quatlas::{
    ComponentOrder, Convention, Direction, Field, Handedness, MotionReport, MotionRequest, Outcome,
    Perturbation, ProblemCode, RateAxes, Request, Rotation, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

const VECTOR: [f64; 3] = [0.4, -0.7, 1.1];
const ATTITUDE: &str = "rotvec 0.4 -0.7 1.1";
const COVARIANCE: &str = "0.4 0.1 -0.2 0.1 0.9 0.3 -0.2 0.3 0.6";

fn outcome(convention: Convention, change: impl FnOnce(&mut MotionRequest)) -> Outcome {
    let mut request = MotionRequest::new(ATTITUDE, convention);
    change(&mut request);
    analyze(&Request::Motion(request))
}

#[track_caller]
fn ask(convention: Convention, change: impl FnOnce(&mut MotionRequest)) -> MotionReport {
    match outcome(convention, change) {
        Outcome::Motion(report) => *report,
        outcome => panic!("{outcome:?}"),
    }
}

fn matrix() -> Matrix3<f64> {
    let rotation = Rotation::from_rotation_vector_rad(VECTOR).expect("a rotation");
    rotation.matrix(Direction::BodyToWorld)
}

fn rows(matrix: &Matrix3<f64>) -> Vec<f64> {
    matrix.transpose().iter().copied().collect()
}

/// A body turned by 90° about y: `R P Rᵀ`, where `R P` is no covariance. By hand: x of the world is z of the body,
/// and z of the world is −x of the body.
#[wasm_bindgen_test(unsupported = test)]
fn a_covariance_of_the_body_is_turned_into_the_world() {
    let report = ask(Convention::HAMILTON, |asked| {
        asked.quaternion = "90 deg about y".to_owned();
        asked.covariance = COVARIANCE.to_owned();
    });
    let covariance = report.covariance.expect("asked");
    let in_world = [0.6, 0.3, 0.2, 0.3, 0.9, -0.1, 0.2, -0.1, 0.4];
    assert_close("in the world", &covariance.world.concat(), &in_world, 1e-15);
    assert_eq!(
        covariance.body,
        [[0.4, 0.1, -0.2], [0.1, 0.9, 0.3], [-0.2, 0.3, 0.6]]
    );
}

/// It is one covariance in every convention, and is taken back from the axes of the world.
#[wasm_bindgen_test(unsupported = test)]
fn all_conventions_have_one_covariance() {
    let variances = Matrix3::from_diagonal(&Vector3::new(1.0, 4.0, 9.0));
    let (turned, back) = (
        matrix() * variances * matrix().transpose(),
        matrix().transpose() * variances * matrix(),
    );
    for convention in all_conventions() {
        let report = ask(convention, |asked| asked.covariance = "1 4 9".to_owned());
        let covariance = report.covariance.expect("asked");
        let (typed, other, right) = match convention.perturbation {
            Perturbation::Local => (covariance.body, covariance.world, turned),
            Perturbation::Global => (covariance.world, covariance.body, back),
        };
        assert_close("typed", &typed.concat(), &rows(&variances), 0.0);
        assert_close("turned", &other.concat(), &rows(&right), 1e-14);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_no_covariance_is_a_problem_of_its_text() {
    for (text, code) in [
        ("1 0.2 0 0.1 1 0 0 0 1", ProblemCode::NotACovariance),
        ("1 -1 1", ProblemCode::NotACovariance),
        ("1 2 0 2 1 0 0 0 1", ProblemCode::NotACovariance),
        // Every two of them might be correlated so, and not all three.
        (
            "1 -0.9 -0.9 -0.9 1 -0.9 -0.9 -0.9 1",
            ProblemCode::NotACovariance,
        ),
        ("1e308 1e308 1e308", ProblemCode::TooLarge),
        ("1 2", ProblemCode::NotAMatrix),
        ("large", ProblemCode::UnknownWord),
    ] {
        let outcome = outcome(Convention::JPL, |asked| asked.covariance = text.to_owned());
        let Outcome::Problems(found) = outcome else {
            panic!("{text}")
        };
        let problem = &found.problems[0];
        assert_eq!(
            (problem.field, problem.code),
            (Field::Covariance, code),
            "{text}"
        );
        assert!(!problem.hint.is_empty() && problem.span.end > problem.span.start);
    }
    for (text, right) in [
        (
            "1 0.1 0.2 2 0.3 3",
            [1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 3.0],
        ),
        ("0.5", [0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5]),
    ] {
        let report = ask(Convention::HAMILTON, |asked| {
            asked.covariance = text.to_owned();
        });
        let covariance = report.covariance.expect("asked");
        assert_close(text, &covariance.body.concat(), &right, 0.0);
    }
    let zero = ask(Convention::JPL, |asked| {
        asked.covariance = "0 0 0".to_owned();
    });
    assert_eq!(zero.covariance.expect("asked").body, [[0.0; 3]; 3]);
}

/// FX-06 and FX-25 against differences: of `R x` by small turns, and of `q∘x∘q*` by each number of q.
#[wasm_bindgen_test(unsupported = test)]
fn the_image_of_a_point_changes_as_differences_do() {
    const STEP: f64 = 1e-5;
    let (text, point) = ("0.3 -1.2 2", Vector3::new(0.3, -1.2, 2.0));
    let rotation = Rotation::from_rotation_vector_rad(VECTOR).expect("a rotation");
    for convention in all_conventions() {
        let report = ask(convention, |asked| asked.point = text.to_owned());
        let of_point = report.point.expect("asked");
        assert_close("R x", &of_point.world, (matrix() * point).as_slice(), 1e-14);
        for (axes, told) in [
            (RateAxes::Body, of_point.by_body_turn),
            (RateAxes::World, of_point.by_world_turn),
        ] {
            for column in 0..3 {
                let at = |step: f64| {
                    let mut turn = [0.0; 3];
                    turn[column] = step;
                    let turned = rotation.turned_by_rad(turn, axes).expect("a rotation");
                    turned.body_to_world(point)
                };
                let difference = (at(STEP) - at(-STEP)) / (2.0 * STEP);
                let told = told.map(|row| row[column]);
                assert_close(
                    &format!("{convention:?}"),
                    &told,
                    difference.as_slice(),
                    1e-9,
                );
            }
        }
        let unit = report.quaternion.components.array;
        for column in 0..4 {
            let at = |step: f64| {
                let mut array = unit;
                array[column] += step;
                let [w, x, y, z] = match convention.order {
                    ComponentOrder::ScalarFirst => array,
                    ComponentOrder::ScalarLast => [array[3], array[0], array[1], array[2]],
                };
                let q = Quaternion::new(w, x, y, z);
                let pure = Quaternion::from_imag(point);
                match convention.handedness {
                    Handedness::Right => q * pure * q.conjugate(),
                    Handedness::Left => q.conjugate() * pure * q,
                }
                .imag()
            };
            let difference = (at(STEP) - at(-STEP)) / (2.0 * STEP);
            let told = of_point.by_components.map(|row| row[column]);
            assert_close(
                &format!("{convention:?}"),
                &told,
                difference.as_slice(),
                1e-9,
            );
        }
    }
}
