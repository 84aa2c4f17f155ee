//! The specification's tests that tell which convention a library has: FX-07, FX-11, FX-19 and FX-26.
//!
//! Each library is simulated in a convention and then told by what it does alone.

mod common;
#[path = "common/reference.rs"]
mod reference;

use common::{all_conventions, assert_close, wasm_bindgen_test};
use quatlas::nalgebra::{Matrix3, Vector3, Vector4};
use quatlas::{
    AxisVector, ComponentOrder, Convention, Direction, EulerAxes, EulerFrame, EulerSequence,
    Function, Handedness, IncrementSign, MatrixConvention, Perturbation, Rotation,
    TaggedQuaternion,
};
use reference::{CLOSE, assert_same, elementary, logarithm, sigma, tau, unit, unskew};
use std::f64::consts::FRAC_PI_2;

fn attitude(v: Vector3<f64>) -> Rotation {
    Rotation::from_rotation_vector_rad(v.into()).expect("finite")
}

fn sign_of(number: f64) -> f64 {
    assert!(number.abs() > 1e-3, "clearly one or the other");
    number.signum()
}

/// Local or global, and whether the turn is positive, of a small increment (ε, 0, 0) to a body that is
/// yawed by a quarter turn.
fn axes_and_sign(before: Matrix3<f64>, after: Matrix3<f64>) -> (Perturbation, f64) {
    let on_world = logarithm(&(after * before.transpose()));
    if on_world.y.abs() > on_world.x.abs() {
        (Perturbation::Local, sign_of(on_world.y))
    } else {
        (Perturbation::Global, sign_of(on_world.x))
    }
}

/// FX-07: 16 libraries.
#[wasm_bindgen_test(unsupported = test)]
fn the_convention_of_a_matrix_library_is_told() {
    let yawed = attitude(unit(2) * FRAC_PI_2);
    let rolled = attitude(unit(0) * 0.8);
    for convention in MatrixConvention::all() {
        let of = |rotation: Rotation| rotation.to_tagged_matrix(convention).entries;
        // (2) Where x goes.
        let seen_tau = sign_of((of(yawed) * unit(0)).y);
        assert_eq!(seen_tau, tau(convention.function, convention.direction));
        let to_body_to_world = |m: Matrix3<f64>| if seen_tau > 0.0 { m } else { m.transpose() };
        // (3) The labelled chain W → B → C with labels in the library's direction.
        let (m_wb, m_bc, m_wc) = (of(yawed), of(rolled), of(yawed * rolled));
        let (m_ab, m_bc, m_ac) = match convention.direction {
            Direction::WorldToBody => (m_wb, m_bc, m_wc),
            // The labels are C → B → W: A is C.
            Direction::BodyToWorld => (m_bc, m_wb, m_wc),
        };
        let function = if (m_bc * m_ab - m_ac).amax() < CLOSE {
            Function::Passive
        } else {
            assert_same("active", &(m_ab * m_bc), &m_ac, CLOSE);
            Function::Active
        };
        assert_eq!(function, convention.function, "{convention}");
        for axes in [Perturbation::Local, Perturbation::Global] {
            for sign in [IncrementSign::Physical, IncrementSign::Formal] {
                let before = yawed.to_tagged_matrix(convention);
                let after = before.plus([0.01, 0.0, 0.0], axes, sign).expect("finite");
                // (4) The turn that was added.
                let [before, after] = [before, after].map(|m| to_body_to_world(m.entries));
                let (seen_axes, seen_sign) = axes_and_sign(before, after);
                let expected = match sign {
                    IncrementSign::Physical => 1.0,
                    IncrementSign::Formal => seen_tau,
                };
                assert_eq!(
                    (seen_axes, seen_sign),
                    (axes, expected),
                    "{convention} {sign:?}"
                );
            }
        }
    }
}

/// FX-11: 48 libraries, by the skew part of a small turn in each slot and one set of angles.
#[wasm_bindgen_test(unsupported = test)]
fn the_sequence_and_direction_of_an_euler_library_are_told() {
    let mut told = 0;
    for sequence in EulerSequence::all() {
        for direction in Direction::ALL {
            let library = |angles: [f64; 3]| {
                Rotation::from_euler_rad(sequence, angles)
                    .expect("finite")
                    .matrix(direction)
            };
            let mut seen_axes = [0; 3];
            let mut seen_tau = 0.0;
            for slot in 0..3 {
                let mut angles = [0.0; 3];
                angles[slot] = 0.01;
                let m = library(angles);
                let axis = unskew(&(m - m.transpose()));
                seen_axes[slot] = axis.iamax();
                seen_tau = sign_of(axis.sum());
            }
            let angles = [0.7, -0.4, 1.1];
            let m = library(angles);
            let r = if seen_tau > 0.0 { m } else { m.transpose() };
            let [a, b, c] = [0, 1, 2].map(|slot| elementary(seen_axes[slot], angles[slot]));
            let frame = if (a * b * c - r).amax() < CLOSE {
                EulerFrame::Intrinsic
            } else {
                assert_same("fixed axes", &(c * b * a), &r, CLOSE);
                EulerFrame::Extrinsic
            };
            let axes = EulerAxes::ALL
                .into_iter()
                .find(|axes| axes.axes().map(|axis| axis.index()) == seen_axes)
                .expect("a sequence");
            assert_eq!(EulerSequence { axes, frame }, sequence);
            assert_eq!(seen_tau > 0.0, direction == Direction::BodyToWorld);
            told += 1;
        }
    }
    assert_eq!(told, 48);
}

/// FX-19: the angle of the turn by (0, 0, 0.1) tells which vector it is; a quarter turn tells τ and σ.
#[wasm_bindgen_test(unsupported = test)]
fn which_vector_along_the_axis_a_library_means_is_told_by_its_angle() {
    let angles = [0.1, 0.2, 2.0 * 0.1_f64.atan(), 4.0 * 0.1_f64.atan()];
    let rounded = [0.1, 0.2, 0.19934, 0.39867];
    let readings = AxisVector::readings(Vector3::new(0.0, 0.0, 0.1));
    for ((reading, angle), rounded) in readings.into_iter().zip(angles).zip(rounded) {
        let turn = reading.to_rotation().expect("finite");
        assert_close(
            &format!("{reading:?}"),
            &[turn.angle_rad()],
            &[angle],
            CLOSE,
        );
        assert_close("as printed", &[angle], &[rounded], 5e-6);
        let turned = Rotation::from_axis_angle([0.0, 0.0, 1.0], rounded).expect("an axis");
        let told = AxisVector::recognize(Vector3::new(0.0, 0.0, 0.1), &turned);
        assert_eq!(told.map(|(told, _)| told), Some(reading));
        assert_same(
            "about z",
            &turn.body_to_world_matrix(),
            &elementary(2, angle),
            CLOSE,
        );
    }
    // The way back, for any turn: tan(θ/2) u and tan(θ/4) u.
    for (v, sign) in reference::turns().flat_map(|v| [(v, 1.0), (v, -1.0)]) {
        let (angle, axis) = (v.norm(), v.normalize());
        let q = TaggedQuaternion {
            components: reference::half_angle(&v) * sign,
            convention: Convention::HAMILTON,
        };
        let turn = Rotation::from_tagged(&q).expect("not zero");
        let gibbs = turn.gibbs_vector().expect("not half a turn");
        assert_same("Gibbs", &(gibbs / (angle / 2.0).tan()), &axis, 1e-12);
        let modified = turn.modified_rodrigues_parameters();
        assert_same("MRP", &modified, &(axis * (angle / 4.0).tan()), CLOSE);
        for vector in [
            AxisVector::Gibbs(gibbs),
            AxisVector::ModifiedRodrigues(modified),
        ] {
            let back = vector.to_rotation().expect("finite");
            assert_same("back", &back.rotation_vector_rad(), &v, 1e-13);
        }
    }
    let quarter = attitude(unit(2) * FRAC_PI_2);
    for convention in all_conventions() {
        let q = quarter.to_tagged(convention).components;
        assert_eq!(sign_of(q.k / q.w), sigma(convention), "{convention}");
    }
}

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
        let to_body_to_world = |q: [f64; 4]| {
            let m = library.matrix(q);
            if seen_tau_of_matrix > 0.0 {
                m
            } else {
                m.transpose()
            }
        };
        let after = library.plus(q, [0.01, 0.0, 0.0]);
        let (perturbation, seen_sign) = axes_and_sign(to_body_to_world(q), to_body_to_world(after));
        let is_formal = sign == IncrementSign::Formal;
        assert_eq!(
            seen_sign,
            if is_formal { seen_sigma } else { 1.0 },
            "{convention}"
        );
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
