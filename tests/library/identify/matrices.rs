//! Libraries of rotation matrices, by their own probes (specification, FX-07).

use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    Direction, Field, Function, IncrementSign, MatricesReport, MatricesRequest, MatrixConvention,
    Outcome, Perturbation, ProblemCode, Request, analyze,
};
use std::f64::consts::FRAC_PI_2;
use wasm_bindgen_test::wasm_bindgen_test;

fn identify(request: MatricesRequest) -> MatricesReport {
    match analyze(&Request::Matrices(request)) {
        Outcome::Matrices(report) => report,
        other => panic!("{other:?}"),
    }
}

/// The turn by a rotation vector, body to world (Rodrigues).
fn turn(vector: Vector3<f64>) -> Matrix3<f64> {
    let angle = vector.norm();
    let k = (vector / angle).cross_matrix();
    Matrix3::identity() + k * angle.sin() + k * k * (1.0 - angle.cos())
}

/// Rows with six decimals, some of which are 1e-17.
fn printed(matrix: &Matrix3<f64>) -> String {
    let rows = matrix.row_iter();
    let rows: Vec<String> = rows
        .map(|row| format!("[{:.6}, {:.6}, {:.6}]", row[0], row[1], row[2]))
        .collect();
    format!("[{}]", rows.join(", "))
}

/// A library in one of 16 behaviours, by matrices alone.
struct Simulated {
    convention: MatrixConvention,
    perturbation: Perturbation,
    sign: IncrementSign,
}

impl Simulated {
    fn all() -> impl Iterator<Item = Self> {
        MatrixConvention::all().flat_map(|convention| {
            let axes = [Perturbation::Local, Perturbation::Global];
            axes.into_iter().flat_map(move |perturbation| {
                let signs = [IncrementSign::Physical, IncrementSign::Formal];
                signs.map(|sign| Self {
                    convention,
                    perturbation,
                    sign,
                })
            })
        })
    }

    /// By the four rows of the field guide's table.
    fn is_body_to_world(&self) -> bool {
        let is_passive = self.convention.function == Function::Passive;
        is_passive == (self.convention.direction == Direction::BodyToWorld)
    }

    /// Its matrix of a body with these axes in the world.
    fn matrix(&self, body_to_world: &Matrix3<f64>) -> Matrix3<f64> {
        if self.is_body_to_world() {
            *body_to_world
        } else {
            body_to_world.transpose()
        }
    }

    /// World, body and camera, which is rolled on the body; and a small turn of the yawed body.
    fn prints(&self) -> MatricesRequest {
        let (body, camera) = (turn(Vector3::z() * FRAC_PI_2), turn(Vector3::x() * 0.8));
        let [wb, bc, wc] = [body, camera, body * camera].map(|matrix| self.matrix(&matrix));
        let [a, b] = match self.convention.direction {
            Direction::WorldToBody => [wb, bc],
            Direction::BodyToWorld => [bc, wb],
        };
        let small = turn(Vector3::x() * 0.01);
        let small = match self.sign {
            IncrementSign::Physical => small,
            IncrementSign::Formal => small.transpose(),
        };
        let after = match self.perturbation {
            Perturbation::Local => body * small,
            Perturbation::Global => small * body,
        };
        MatricesRequest {
            yawed: printed(&wb),
            a: printed(&a),
            b: printed(&b),
            product: printed(&wc),
            matrix: printed(&wb),
            rotation_vector: "0.01 0 0".to_owned(),
            printed: printed(&self.matrix(&after)),
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn sixteen_libraries_of_matrices_are_told() {
    let mut told = 0;
    for library in Simulated::all() {
        let report = identify(library.prints());
        assert_eq!(report.function, Some(library.convention.function));
        assert_eq!(report.direction, Some(library.convention.direction));
        let is_body_to_world = report.operator == Some(Direction::BodyToWorld);
        assert_eq!(is_body_to_world, library.is_body_to_world());
        assert_eq!(report.perturbation, Some(library.perturbation));
        assert_eq!(report.increment_sign, Some(library.sign));
        // Without the yawed body it is not known what is before and what after.
        let report = identify(MatricesRequest {
            yawed: String::new(),
            ..library.prints()
        });
        assert_eq!(report.function, Some(library.convention.function));
        let others = (report.operator, report.direction, report.perturbation);
        assert_eq!(others, (None, None, None));
        told += 1;
    }
    assert_eq!(told, 16);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_tells_nothing_of_matrices_is_left_out() {
    let rolled = "1 0 0 0 0 -1 0 1 0".to_owned();
    let none = identify(MatricesRequest::default());
    assert_eq!(
        (none.operator, none.function, none.increment_sign),
        (None, None, None)
    );
    // Turns about one axis, and a small turn of which no operator is known.
    let report = identify(MatricesRequest {
        yawed: String::new(),
        a: rolled.clone(),
        b: rolled.clone(),
        product: "1 0 0 0 -1 0 0 0 -1".to_owned(),
        matrix: rolled.clone(),
        rotation_vector: "0.01 0 0".to_owned(),
        printed: rolled.clone(),
    });
    assert_eq!(report, none);
    let problem = |request| match analyze(&Request::Matrices(request)) {
        Outcome::Problems(problems) => problems.problems[0].field,
        other => panic!("{other:?}"),
    };
    let product = "0 0 1 0".to_owned();
    assert_eq!(
        problem(MatricesRequest {
            product,
            ..MatricesRequest::default()
        }),
        Field::Product
    );
    assert_eq!(
        problem(MatricesRequest {
            yawed: "0 -1 0 1 0 0 0 0 1".to_owned(),
            matrix: rolled.clone(),
            rotation_vector: "0.01 0".to_owned(),
            printed: rolled,
            ..MatricesRequest::default()
        }),
        Field::RotationVector
    );
}

/// What no library prints counts for none: a body that is not yawed or is mirrored, a product that is neither,
/// and a matrix that stayed where a small turn was added.
#[wasm_bindgen_test(unsupported = test)]
fn what_fits_no_convention_of_matrices_is_a_problem() {
    let (yawed, rolled) = ("0 -1 0 1 0 0 0 0 1", "1 0 0 0 0 -1 0 1 0");
    let told = |change: &dyn Fn(&mut MatricesRequest)| {
        let mut request = MatricesRequest::default();
        change(&mut request);
        match analyze(&Request::Matrices(request)) {
            Outcome::Problems(problems) => {
                let problem = &problems.problems[0];
                assert_eq!(problem.code, ProblemCode::FitsNoConvention);
                problem.field
            }
            other => panic!("{other:?}"),
        }
    };
    for other in [
        rolled,
        "0 1 0 1 0 0 0 0 1",
        "0 0 1 1 0 0 0 1 0",
        "1 0 0 0 1 0 0 0 1",
    ] {
        let field = told(&|request| request.yawed = other.to_owned());
        assert_eq!(field, Field::Yawed, "{other}");
    }
    let field = told(&|request| {
        request.a = yawed.to_owned();
        request.b = rolled.to_owned();
        request.product = "1 0 0 0 1 0 0 0 1".to_owned();
    });
    assert_eq!(field, Field::Product);
    let field = told(&|request| {
        request.yawed = yawed.to_owned();
        request.matrix = yawed.to_owned();
        request.rotation_vector = "0.01 0 0".to_owned();
        request.printed = yawed.to_owned();
    });
    assert_eq!(field, Field::Printed);
}
