//! Golden cases of increments, rates, rotation vectors, distances and paths: numbers that were not
//! made by quatlas.

use crate::golden::{Case, exponential, hamilton};
use crate::rows::row_major;
use crate::support::{assert_close, wxyz};
use quatlas::nalgebra::{Vector3, Vector4};
use quatlas::{
    Convention, EulerSequence, IncrementSign, IntegrationOrder, Perturbation, Pose, RateAxes,
    Rotation, TaggedQuaternion, compose_rotation_vectors, left_jacobian, left_jacobian_inverse,
    right_jacobian, right_jacobian_inverse,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn cases_of_conventions() -> impl Iterator<Item = Case> {
    (1..=8).map(|number| Case::find(&format!("G{number:02}")))
}

#[wasm_bindgen_test(unsupported = test)]
fn g01_to_g08_a_turn_of_the_body_is_added_on_its_axes_and_on_the_worlds() {
    for case in cases_of_conventions() {
        for (name, perturbation) in [
            ("q_plus_local", Perturbation::Local),
            ("q_plus_global", Perturbation::Global),
        ] {
            let convention = Convention {
                perturbation,
                ..case.convention()
            };
            let q = exponential(case.input("v_WB")).to_tagged(convention);
            let delta: [f64; 3] = case.input("delta");
            let after = q.plus(delta, IncrementSign::Physical).expect("finite");
            case.check(name, &after.to_array());

            let given: [f64; 4] = case.numbers("output", name).try_into().expect("four");
            let difference = TaggedQuaternion::from_array(given, convention)
                .minus(&q, IncrementSign::Physical)
                .expect("not zero");
            assert_close(name, difference.as_slice(), &delta, case.tolerance);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g01_to_g08_the_derivative_of_a_quaternion_for_the_rate_of_its_body() {
    for case in cases_of_conventions() {
        let attitude = exponential(case.input("v_WB"));
        let rate: [f64; 3] = case.input("omega_B");
        let in_world = attitude.body_to_world(rate.into());
        case.check("omega_W", in_world.as_slice());
        let q = attitude.to_tagged(case.convention());
        let by_body = q.derivative(rate, RateAxes::Body);
        case.check("q_dot", &wxyz(&by_body));
        let by_world = q.derivative(in_world.into(), RateAxes::World);
        case.check("q_dot", &wxyz(&by_world));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g24_angular_velocity_of_the_rates_of_yaw_pitch_and_roll() {
    let case = Case::find("G24");
    let angles: [f64; 3] = case.input("angles");
    let rates: [f64; 3] = case.input("rates");
    for (name, axes) in [("omega_B", RateAxes::Body), ("omega_W", RateAxes::World)] {
        let map = EulerSequence::AEROSPACE
            .rate_matrix(angles, axes)
            .expect("finite");
        case.check(name, (map * Vector3::from(rates)).as_slice());
        let omega: [f64; 3] = case.numbers("output", name).try_into().expect("three");
        let back = EulerSequence::AEROSPACE
            .angle_rates(angles, omega, axes)
            .expect("not locked");
        assert_close(name, &back, &rates, case.tolerance);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g25_the_rotation_vector_of_two_turns() {
    let case = Case::find("G25");
    let v = compose_rotation_vectors(case.input("a"), case.input("b")).expect("finite");
    case.check("v", v.as_slice());
    let matrix = exponential(v.into()).body_to_world_matrix();
    case.check("R", &row_major(&matrix));
}

#[wasm_bindgen_test(unsupported = test)]
fn g26_the_jacobian_of_the_exponential_and_its_inverse() {
    let case = Case::find("G26");
    let v = Vector3::from(case.input::<3>("v"));
    case.check("Jr", &row_major(&right_jacobian(&v)));
    // J_l(v) = J_r(-v).
    case.check("Jr", &row_major(&left_jacobian(&-v)));
    let inverse = right_jacobian_inverse(&v).expect("not a whole turn");
    case.check("Jr_inv", &row_major(&inverse));
    let of_left = left_jacobian_inverse(&-v).expect("not a whole turn");
    case.check("Jr_inv", &row_major(&of_left));
    let rate = Vector3::from(case.input::<3>("omega_B"));
    case.check("v_dot", (inverse * rate).as_slice());
}

#[wasm_bindgen_test(unsupported = test)]
fn g27_four_distances_between_two_attitudes() {
    let case = Case::find("G27");
    let (a, b) = (exponential(case.input("a")), exponential(case.input("b")));
    let opposite = TaggedQuaternion {
        components: -b.to_tagged(Convention::HAMILTON).components,
        convention: Convention::HAMILTON,
    };
    let opposite = Rotation::from_tagged(&opposite).expect("not zero");
    case.check("geodesic", &[a.angle_to_rad(&b)]);
    case.check("chordal", &[a.chordal_distance(&b)]);
    case.check("quaternion", &[a.quaternion_distance(&b)]);
    case.check(
        "quaternion_second_negated",
        &[a.quaternion_distance(&opposite)],
    );
    case.check("quaternion_min", &[a.shorter_quaternion_distance(&b)]);
    case.check(
        "quaternion_min",
        &[a.shorter_quaternion_distance(&opposite)],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn g29_the_position_of_a_body_along_the_path_of_its_camera() {
    let case = Case::find("G29");
    let pose = |parent: &str, child: &str, rotation: &str, position: &str| {
        Pose::new(
            parent,
            child,
            exponential(case.input(rotation)),
            case.input(position),
        )
    };
    let first = pose("G", "I1", "v_GI1", "p_GI1");
    let second = pose("G", "I2", "v_GI2", "p_GI2");
    let first_camera = pose("I1", "C1", "v_IC", "p_IC");
    let second_camera = pose("I2", "C2", "v_IC", "p_IC");

    let seen = |body: &Pose, camera: &Pose| body.then(camera).expect("the frames meet");
    let moved = seen(
        &seen(&first, &first_camera).inverse(),
        &seen(&second, &second_camera),
    );
    case.check(
        "R_C2_C1",
        &row_major(&moved.rotation.world_to_body_matrix()),
    );
    case.check("p_C1_C2", moved.position.as_slice());

    // From I1 over the two cameras to I2, as in Yoosefian's path 2.
    let path = seen(&seen(&first, &first_camera), &moved);
    let end = seen(&path, &second_camera.inverse());
    assert_eq!((end.parent.as_str(), end.child.as_str()), ("G", "I2"));
    case.check("p_GI2_corrected", end.position.as_slice());
    // The printed formula turns the lever arm by the camera's attitude instead of the body's.
    let lever = second_camera.position;
    let printed = path.position - path.rotation.body_to_world(lever);
    case.check("p_GI2_as_printed", printed.as_slice());
}

#[wasm_bindgen_test(unsupported = test)]
fn g31_the_rate_matrices_of_hamilton_and_jpl() {
    let case = Case::find("G31");
    let rate: [f64; 3] = case.input("omega");
    for (name, convention) in [
        ("OmegaH_q", Convention::HAMILTON),
        ("OmegaJ_q_xyzw", Convention::JPL),
    ] {
        // Hamilton and JPL give one attitude the same components, in another order.
        let array = hamilton(case.input("q_wxyz"))
            .to_convention(convention)
            .to_array();
        let product = convention.rate_matrix(rate, RateAxes::Body) * Vector4::from(array);
        case.check(name, product.as_slice());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g34_one_step_of_fourth_order_from_the_rates_at_the_gauss_points() {
    let case = Case::find("G34");
    let step = case.number("h");
    let early = Vector3::from(case.input::<3>("omega_a"));
    let late = Vector3::from(case.input::<3>("omega_b"));
    let rate = |time: f64| if time < step / 2.0 { early } else { late };
    let after = Rotation::identity()
        .step(rate, RateAxes::Body, 0.0, step, IntegrationOrder::Fourth)
        .expect("finite");
    case.check("theta", after.rotation_vector_rad().as_slice());
    case.check("q_step", &after.to_tagged(Convention::HAMILTON).to_array());

    // On the world's axes the two rates change places.
    let reversed = |time: f64| if time < step / 2.0 { late } else { early };
    let after = Rotation::identity()
        .step(
            reversed,
            RateAxes::World,
            0.0,
            step,
            IntegrationOrder::Fourth,
        )
        .expect("finite");
    case.check("theta", after.rotation_vector_rad().as_slice());
}
