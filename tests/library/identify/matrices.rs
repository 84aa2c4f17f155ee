//! Libraries of rotation matrices, by their own probes (specification, FX-07).

use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    Direction, Field, Function, IncrementSign, MatricesReport, MatricesRequest, MatrixConvention,
    MatrixObservationReport, MatrixProbe, Outcome, Perturbation, Request, analyze,
};
use std::f64::consts::FRAC_PI_2;
use wasm_bindgen_test::wasm_bindgen_test;

fn identify(observations: Vec<MatrixProbe>) -> MatricesReport {
    match analyze(&Request::Matrices(MatricesRequest { observations })) {
        Outcome::Matrices(report) => *report,
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

    fn yawed(&self) -> MatrixProbe {
        MatrixProbe::Yawed {
            printed: printed(&self.matrix(&turn(Vector3::z() * FRAC_PI_2))),
        }
    }

    /// World, body and camera: the camera is rolled on the body.
    fn chain(&self) -> MatrixProbe {
        let (body, camera) = (turn(Vector3::z() * FRAC_PI_2), turn(Vector3::x() * 0.8));
        let [wb, bc, wc] = [body, camera, body * camera].map(|matrix| self.matrix(&matrix));
        let [a, b] = match self.convention.direction {
            Direction::WorldToBody => [wb, bc],
            Direction::BodyToWorld => [bc, wb],
        };
        MatrixProbe::Chain {
            a: printed(&a),
            b: printed(&b),
            printed: printed(&wc),
        }
    }

    fn increment(&self) -> MatrixProbe {
        let body = turn(Vector3::z() * FRAC_PI_2);
        let small = turn(Vector3::x() * 0.01);
        let small = match self.sign {
            IncrementSign::Physical => small,
            IncrementSign::Formal => small.transpose(),
        };
        let after = match self.perturbation {
            Perturbation::Local => body * small,
            Perturbation::Global => small * body,
        };
        MatrixProbe::Increment {
            matrix: printed(&self.matrix(&body)),
            rotation_vector: "0.01 0 0".to_owned(),
            printed: printed(&self.matrix(&after)),
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn sixteen_libraries_of_matrices_are_told() {
    let mut told = 0;
    for library in Simulated::all() {
        let report = identify(vec![library.yawed(), library.chain(), library.increment()]);
        assert_eq!(report.possible, 1, "{report:#?}");
        let left = &report.remaining;
        assert_eq!(left.function, [library.convention.function]);
        assert_eq!(left.direction, [library.convention.direction]);
        assert_eq!(
            left.operator == [Direction::BodyToWorld],
            library.is_body_to_world()
        );
        assert_eq!(left.perturbation, [library.perturbation]);
        assert_eq!(left.increment_sign, [library.sign]);
        let alone: Vec<usize> = report
            .observations
            .iter()
            .map(|observation| match observation {
                MatrixObservationReport::Told(told) => told.possible,
                other => panic!("{other:?}"),
            })
            .collect();
        // The increment alone leaves either operator, with the axes that belong to it.
        assert_eq!(alone, [8, 8, 4]);
        told += 1;
    }
    assert_eq!(told, 16);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_tells_nothing_of_matrices_says_so() {
    let yawed = |printed: &str| MatrixProbe::Yawed {
        printed: printed.to_owned(),
    };
    let rolled = "1 0 0 0 0 -1 0 1 0";
    let report = identify(vec![
        yawed(""),
        yawed(rolled),
        MatrixProbe::Chain {
            a: rolled.to_owned(),
            b: rolled.to_owned(),
            printed: "1 0 0 0 -1 0 0 0 -1".to_owned(),
        },
        yawed("0 0 1 0"),
        MatrixProbe::Increment {
            matrix: rolled.to_owned(),
            rotation_vector: "0.01 0".to_owned(),
            printed: rolled.to_owned(),
        },
    ]);
    assert_eq!(report.possible, 16);
    use MatrixObservationReport::{Empty, Problem, Unexplained};
    let [
        Empty,
        Unexplained,
        Unexplained,
        Problem(printed),
        Problem(turn),
    ] = &report.observations[..]
    else {
        panic!("{report:#?}")
    };
    assert_eq!(printed.problem.field, Field::Printed);
    assert_eq!(turn.problem.field, Field::RotationVector);
    // One says body to world and the other the reverse.
    let report = identify(vec![
        yawed("0 -1 0; 1 0 0; 0 0 1"),
        yawed("0 1 0; -1 0 0; 0 0 1"),
    ]);
    assert_eq!(report.possible, 0);
    assert_eq!(report.remaining.operator, []);
}
