//! The specification's tests that tell which convention a library has: FX-07, FX-11, FX-19 and FX-26.
//!
//! Each library is simulated in a convention and then told by what it does alone.

mod common;
#[path = "common/reference.rs"]
mod reference;

use common::{all_conventions, assert_close, wasm_bindgen_test};
use quatlas::nalgebra::{Matrix3, Vector3, Vector4};
use quatlas::{
    AngleUnit, AxisVector, ComponentOrder, Convention, Direction, EulerFrame, EulerReading,
    Function, Handedness, IncrementSign, MatrixConvention, Perturbation, Rotation, TaggedMatrix,
    TaggedQuaternion, direction_of_yawed, function_of_chain, increment_of,
};
use reference::{CLOSE, assert_same, elementary, sigma, tau, unit};
use std::f64::consts::{FRAC_PI_2, PI};

fn attitude(v: Vector3<f64>) -> Rotation {
    Rotation::from_rotation_vector_rad(v.into()).expect("finite")
}

fn sign_of(number: f64) -> f64 {
    assert!(number.abs() > 1e-3, "clearly one or the other");
    number.signum()
}

/// FX-07: 16 libraries.
#[wasm_bindgen_test(unsupported = test)]
fn the_convention_of_a_matrix_library_is_told() {
    let yawed = attitude(unit(2) * FRAC_PI_2);
    let rolled = attitude(unit(0) * 0.8);
    let mut told = 0;
    for convention in MatrixConvention::all() {
        let of = |rotation: Rotation| rotation.to_tagged_matrix(convention).entries;
        // (2) Where x goes.
        let image = of(yawed) * unit(0);
        let operator = direction_of_yawed(image.into()).expect("one or the other");
        let seen_tau = sign_of(image.y);
        assert_eq!(seen_tau, tau(convention.function, convention.direction));
        assert_eq!(operator, convention.operator());
        // (3) The labelled chain W → B → C with labels in the library's direction.
        let (m_wb, m_bc, m_wc) = (of(yawed), of(rolled), of(yawed * rolled));
        let (m_ab, m_bc, m_ac) = match convention.direction {
            Direction::WorldToBody => (m_wb, m_bc, m_wc),
            // The labels are C → B → W: A is C.
            Direction::BodyToWorld => (m_bc, m_wb, m_wc),
        };
        let function = function_of_chain(&m_ab, &m_bc, &m_ac, CLOSE).expect("one or the other");
        let direction = match function {
            Function::Passive => operator,
            Function::Active => operator.reversed(),
        };
        let seen = MatrixConvention {
            function,
            direction,
        };
        assert_eq!(seen, convention);
        for axes in [Perturbation::Local, Perturbation::Global] {
            for sign in [IncrementSign::Physical, IncrementSign::Formal] {
                let before = yawed.to_tagged_matrix(convention);
                let after = before.plus([0.01, 0.0, 0.0], axes, sign).expect("finite");
                // (4) The turn that was added, by what (2) and (3) told.
                let [before, after] = [before, after].map(|matrix| {
                    let matrix = TaggedMatrix {
                        convention: seen,
                        ..matrix
                    };
                    Rotation::nearest_to_matrix(&matrix)
                        .expect("a rotation")
                        .rotation
                });
                // Without a sign, τδ is δ where τ = 1.
                let expected = if sign == IncrementSign::Formal && seen_tau < 0.0 {
                    IncrementSign::Formal
                } else {
                    IncrementSign::Physical
                };
                assert_eq!(
                    increment_of(&before, &after, [0.01, 0.0, 0.0]),
                    Some((axes, expected)),
                    "{convention} {sign:?}"
                );
                told += 1;
            }
        }
    }
    assert_eq!(told, 16);
}

/// FX-07: what is neither one nor the other is not told.
#[wasm_bindgen_test(unsupported = test)]
fn what_tells_nothing_of_a_matrix_library_is_not_told() {
    assert_eq!(
        direction_of_yawed([0.0, 0.91, 0.0]),
        Some(Direction::BodyToWorld)
    );
    assert_eq!(direction_of_yawed([0.0, 0.89, 0.0]), None);
    assert_eq!(
        direction_of_yawed([0.0, -0.91, 0.09]),
        Some(Direction::WorldToBody)
    );
    assert_eq!(direction_of_yawed([0.11, -1.0, 0.0]), None);
    assert_eq!(direction_of_yawed([f64::NAN, 1.0, 0.0]), None);
    // Turns about one axis commute; and no chain is whole whose last matrix is another.
    let [once, twice] = [1.0, 2.0].map(|times| elementary(2, 0.3 * times));
    assert_eq!(function_of_chain(&once, &once, &twice, CLOSE), None);
    assert_eq!(
        function_of_chain(&once, &elementary(0, 0.3), &twice, CLOSE),
        None
    );
    // About the body's own axis, twice the turn, and another one.
    let yawed = attitude(unit(2) * FRAC_PI_2);
    let told = |turn: Vector3<f64>, increment: [f64; 3]| {
        increment_of(&yawed, &(yawed * attitude(turn)), increment)
    };
    let physical = Some((Perturbation::Local, IncrementSign::Physical));
    assert_eq!(told(unit(0) * 0.1, [0.1, 0.0, 0.0]), physical);
    assert_eq!(
        told(unit(0) * 0.124, [0.1, 0.0, 0.0]),
        physical,
        "a quarter off"
    );
    assert_eq!(told(unit(0) * 0.126, [0.1, 0.0, 0.0]), None);
    assert_eq!(told(unit(2) * 0.1, [0.0, 0.0, 0.1]), None, "on either axes");
    assert_eq!(told(unit(2) * 0.1, [0.1, 0.0, 0.0]), None);
    assert_eq!(told(unit(0) * 0.1, [f64::INFINITY, 0.0, 0.0]), None);
    assert_eq!(told(unit(0) * 0.0, [0.0; 3]), None);
}

/// What a library that reads angles so prints, with so many decimals.
fn rounded(matrix: Matrix3<f64>, decimals: i32) -> Matrix3<f64> {
    let unit = 10.0_f64.powi(decimals);
    matrix.map(|entry| (entry * unit).round() / unit)
}

/// The matrix of three angles by elementary turns alone.
fn by_elementary_turns(reading: EulerReading, angles: [f64; 3]) -> Matrix3<f64> {
    let axes = reading.sequence.axes.axes();
    let [a, b, c] = [0, 1, 2].map(|slot| {
        let angle_rad = match reading.unit {
            AngleUnit::Radians => angles[slot],
            AngleUnit::Degrees => angles[slot].to_radians(),
        };
        elementary(axes[slot].index(), angle_rad)
    });
    let body_to_world = match reading.sequence.frame {
        EulerFrame::Intrinsic => a * b * c,
        EulerFrame::Extrinsic => c * b * a,
    };
    match reading.direction {
        Direction::BodyToWorld => body_to_world,
        Direction::WorldToBody => body_to_world.transpose(),
    }
}

/// FX-11: 48 libraries, and as many that take degrees, by one print with four decimals.
#[wasm_bindgen_test(unsupported = test)]
fn the_sequence_and_direction_of_an_euler_library_are_told() {
    let all: Vec<EulerReading> = EulerReading::all().collect();
    assert_eq!(all.len(), 96);
    for (angles, margin_deg) in [([0.7, -0.4, 1.1], 9.0_f64), ([30.0, 20.0, 10.0], 2.78)] {
        let prints: Vec<Matrix3<f64>> = all
            .iter()
            .map(|reading| by_elementary_turns(*reading, angles))
            .collect();
        // In degrees the first are small turns, nearly the same in any order.
        let is_told =
            |reading: &EulerReading| angles[0] > 1.0 || reading.unit == AngleUnit::Radians;
        for (reading, print) in all
            .iter()
            .zip(&prints)
            .filter(|(reading, _)| is_told(reading))
        {
            assert_same(
                "the matrix",
                &reading.matrix(angles).expect("finite"),
                print,
                CLOSE,
            );
            let found = EulerReading::recognize(&[(angles, rounded(*print, 4))], 0.01);
            let [(told, off_rad)] = &found[..] else {
                panic!("{reading:?}: {found:?}")
            };
            assert_eq!(told, reading);
            assert!(*off_rad < 2e-4, "{off_rad}");
            // How near the nearest other one is, is what the tolerance may be.
            let found = EulerReading::recognize(&[(angles, *print)], PI);
            assert_eq!(found[0].0, *reading);
            assert!(found[1].1.to_degrees() > margin_deg, "{:?}", found[1]);
            assert!(found.is_sorted_by_key(|(_, off_rad)| *off_rad));
        }
    }
}

/// FX-11 by its steps: a small turn in each slot tells the axes and the direction, one set of angles the
/// frame; nothing that is no rotation is told.
#[wasm_bindgen_test(unsupported = test)]
fn small_turns_in_each_slot_leave_the_two_frames_of_a_sequence() {
    let recognize = |prints: &[([f64; 3], Matrix3<f64>)]| {
        let found = EulerReading::recognize(prints, 1e-3);
        found
            .into_iter()
            .map(|(reading, _)| reading)
            .collect::<Vec<_>>()
    };
    let in_radians = EulerReading::all().filter(|reading| reading.unit == AngleUnit::Radians);
    for reading in in_radians {
        let print = |angles| (angles, by_elementary_turns(reading, angles));
        let slots = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]];
        let mut prints = slots.map(print).to_vec();
        let mut left = recognize(&prints);
        assert_eq!(left.len(), 2, "{reading:?}: {left:?}");
        left.retain(|other| other.sequence.frame == reading.sequence.frame);
        assert_eq!(left, [reading]);
        prints.push(print([0.7, -0.4, 1.1]));
        assert_eq!(recognize(&prints), [reading]);
        // The same print with another sign is that of no library.
        let (angles, matrix) = print([0.7, -0.4, 1.1]);
        assert_eq!(recognize(&[(angles, -matrix)]), []);
        assert_eq!(recognize(&[(angles, matrix * f64::NAN)]), []);
        assert_eq!(recognize(&[([f64::NAN; 3], matrix)]), []);
    }
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
