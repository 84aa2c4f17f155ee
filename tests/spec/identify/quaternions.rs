//! FX-26: the convention of a library of quaternions.

use super::{attitude, sign_of};
use crate::reference::{CLOSE, assert_same, unit};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Matrix3, Vector4};
use quatlas::{
    ComponentOrder, Convention, Direction, Function, Handedness, IncrementSign, MatrixConvention,
    Rotation, TaggedMatrix, TaggedQuaternion, increment_of,
};
use std::f64::consts::FRAC_PI_2;
use wasm_bindgen_test::wasm_bindgen_test;

/// What can be seen of a quaternion library, and what it is told to be.
struct Library {
    convention: Convention,
    sign: IncrementSign,
    /// Whether its matrix is that of its own operator.
    is_paired_alike: bool,
}

impl Library {
    fn product(&self, p: [f64; 4], q: [f64; 4]) -> [f64; 4] {
        let of = |array| TaggedQuaternion::from_array(array, self.convention);
        of(p).product(&of(q)).expect("one convention").to_array()
    }

    fn array(&self, attitude: &Rotation) -> [f64; 4] {
        attitude.to_tagged(self.convention).to_array()
    }

    fn matrix(&self, q: [f64; 4]) -> Matrix3<f64> {
        let own = MatrixConvention {
            function: self.convention.function,
            direction: self.convention.direction,
        };
        let paired = MatrixConvention {
            direction: if self.is_paired_alike {
                own.direction
            } else {
                own.direction.reversed()
            },
            ..own
        };
        let q = TaggedQuaternion::from_array(q, self.convention);
        let formula = self.convention.cosine_matrix(paired);
        formula.of(&q.components).expect("not zero")
    }

    fn plus(&self, q: [f64; 4], increment: [f64; 3]) -> [f64; 4] {
        let q = TaggedQuaternion::from_array(q, self.convention);
        q.plus(increment, self.sign).expect("finite").to_array()
    }
}

/// FX-26: 128 libraries, by steps 1 to 8.
#[wasm_bindgen_test(unsupported = test)]
fn the_convention_of_a_quaternion_library_is_told() {
    let mut told = 0;
    for (convention, sign, is_paired_alike) in
        all_conventions().into_iter().flat_map(|convention| {
            [IncrementSign::Physical, IncrementSign::Formal]
                .into_iter()
                .flat_map(move |sign| [true, false].map(|alike| (convention, sign, alike)))
        })
    {
        let library = Library {
            convention,
            sign,
            is_paired_alike,
        };
        // 1: the basis array that is the identity.
        let any = [0.3, -0.5, 0.7, 0.2];
        let basis = |place: usize| {
            let mut array = [0.0; 4];
            array[place] = 1.0;
            array
        };
        let order = if library.product(basis(0), any) == any {
            ComponentOrder::ScalarFirst
        } else {
            assert_eq!(library.product(basis(3), any), any);
            ComponentOrder::ScalarLast
        };
        let slot = |name: usize| match order {
            ComponentOrder::ScalarFirst => name,
            ComponentOrder::ScalarLast => (name + 3) % 4,
        };
        // 2: i∘j.
        let k = library.product(basis(slot(1)), basis(slot(2)))[slot(3)];
        let handedness = if k > 0.0 {
            Handedness::Right
        } else {
            Handedness::Left
        };
        // 3: the operator, q∘x∘q⁻¹ by the library's own product.
        let yawed = attitude(unit(2) * FRAC_PI_2);
        let q = library.array(&yawed);
        let inverse = [0, 1, 2, 3].map(|place| {
            if place == slot(0) {
                q[place]
            } else {
                -q[place]
            }
        });
        let image = library.product(library.product(q, basis(slot(1))), inverse);
        let seen_tau = sign_of(image[slot(2)]);
        // 4: the components.
        let seen_sigma = sign_of(q[slot(3)] / q[slot(0)]);
        let eta = if handedness == Handedness::Right {
            1.0
        } else {
            -1.0
        };
        assert_eq!(seen_sigma, eta * seen_tau, "{convention}");
        // 5: the matrix.
        let seen_tau_of_matrix = sign_of((library.matrix(q) * unit(0)).y);
        assert_eq!(
            seen_tau_of_matrix == seen_tau,
            is_paired_alike,
            "{convention}"
        );
        // 6: the increment.
        let attitude_of = |q: [f64; 4]| {
            let matrix = TaggedMatrix {
                entries: library.matrix(q),
                convention: if seen_tau_of_matrix > 0.0 {
                    MatrixConvention::BODY_TO_WORLD
                } else {
                    MatrixConvention::WORLD_TO_BODY
                },
            };
            Rotation::nearest_to_matrix(&matrix)
                .expect("a rotation")
                .rotation
        };
        let after = library.plus(q, [0.01, 0.0, 0.0]);
        let told_of_increment =
            increment_of(&attitude_of(q), &attitude_of(after), [0.01, 0.0, 0.0]);
        let (perturbation, seen_sign) = told_of_increment.expect("one of the four");
        // Without a sign, σδ is δ where σ = 1.
        let is_formal = sign == IncrementSign::Formal && seen_sigma < 0.0;
        let expected = if is_formal {
            IncrementSign::Formal
        } else {
            IncrementSign::Physical
        };
        assert_eq!(seen_sign, expected, "{convention}");
        // 7: the labelled chain, with τ.
        let rolled = attitude(unit(0) * 0.8);
        let [q_wb, q_bc, q_wc] = [yawed, rolled, yawed * rolled].map(|r| library.array(&r));
        let (q_ab, q_bc) = match convention.direction {
            Direction::WorldToBody => (q_wb, q_bc),
            Direction::BodyToWorld => (q_bc, q_wb),
        };
        let is_same = |p: [f64; 4], q: [f64; 4]| {
            let (p, q) = (Vector4::from(p), Vector4::from(q));
            (p - q).amax().min((p + q).amax()) < CLOSE
        };
        let function = if is_same(library.product(q_bc, q_ab), q_wc) {
            Function::Passive
        } else {
            assert!(is_same(library.product(q_ab, q_bc), q_wc), "{convention}");
            Function::Active
        };
        let direction = match (function, seen_tau > 0.0) {
            (Function::Passive, true) | (Function::Active, false) => Direction::BodyToWorld,
            (Function::Passive, false) | (Function::Active, true) => Direction::WorldToBody,
        };
        let seen = Convention {
            order,
            handedness,
            function,
            direction,
            perturbation,
        };
        assert_eq!(seen, convention);
        // 8: the norm of a product, and the sign of q.
        let product = Vector4::from(library.product(q, library.array(&rolled)));
        assert_close("|p∘q|", &[product.norm()], &[1.0], CLOSE);
        let opposite = library.matrix(q.map(|number| -number));
        assert_same("S(−q) = S(q)", &opposite, &library.matrix(q), 0.0);
        told += 1;
    }
    assert_eq!(told, 128);
}
