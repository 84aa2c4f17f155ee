//! Golden cases: numbers that were not made by quatlas (see `vectors/README.md`).

use crate::golden::{Case, exponential, hamilton, rotation};
use crate::rows::row_major;
use crate::support::{assert_close, wxyz};
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    ComponentOrder, Convention, Direction, Handedness, TaggedQuaternion, hamilton_product,
    jpl_product,
};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn all_34_cases_are_there_once_and_in_order() {
    let ids: Vec<String> = Case::all().into_iter().map(|case| case.id).collect();
    let expected: Vec<String> = (1..=34).map(|number| format!("G{number:02}")).collect();
    assert_eq!(ids, expected);
}

#[wasm_bindgen_test(unsupported = test)]
fn g01_to_g08_one_attitude_in_each_handedness_function_and_direction() {
    let cases = (1..=8).map(|number| Case::find(&format!("G{number:02}")));
    for case in cases {
        let convention = case.convention();
        let stored_last = Convention {
            order: ComponentOrder::ScalarLast,
            ..convention
        };
        let attitude = exponential(case.input("v_WB"));
        let mounted = exponential(case.input("v_BC"));
        let q_wb = attitude.to_tagged(convention);
        let q_bc = mounted.to_tagged(convention);
        case.check("q_WB_wxyz", &q_wb.to_array());
        case.check("q_WB_xyzw", &attitude.to_tagged(stored_last).to_array());
        case.check("q_BC_wxyz", &q_bc.to_array());

        let operator = attitude.matrix(convention.operator());
        case.check("S", &row_major(&operator));
        let x: Vector3<f64> = case.input::<3>("x").into();
        case.check("S_x", (operator * x).as_slice());

        // The chain W-B-C in the convention's own product (specification, table 2.1).
        let q_wc = match convention.operator() {
            Direction::BodyToWorld => q_wb.product(&q_bc),
            Direction::WorldToBody => q_bc.product(&q_wb),
        };
        case.check("q_WC_wxyz", &q_wc.expect("one convention").to_array());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g09_both_products_of_two_quaternions() {
    let case = Case::find("G09");
    let p = hamilton(case.input("p")).components;
    let q = hamilton(case.input("q")).components;
    case.check("hamilton", &wxyz(&hamilton_product(&p, &q)));
    case.check("jpl", &wxyz(&jpl_product(&p, &q)));
}

#[wasm_bindgen_test(unsupported = test)]
fn g10_product_matrices_in_both_hands_and_orders() {
    let case = Case::find("G10");
    for (hand, handedness) in [("Right", Handedness::Right), ("Left", Handedness::Left)] {
        for (place, order) in [
            ("first", ComponentOrder::ScalarFirst),
            ("last", ComponentOrder::ScalarLast),
        ] {
            let q = TaggedQuaternion {
                convention: Convention {
                    order,
                    handedness,
                    ..Convention::HAMILTON
                },
                ..hamilton(case.input("q"))
            };
            let left = q.left_product_matrix().transpose();
            let right = q.right_product_matrix().transpose();
            case.check(&format!("{hand}_w{place}_L"), left.as_slice());
            case.check(&format!("{hand}_w{place}_R"), right.as_slice());
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g11_a_quaternion_that_is_not_of_norm_1() {
    let case = Case::find("G11");
    let attitude = rotation(case.input("q"));
    case.check("R", &row_major(&attitude.body_to_world_matrix()));
    // Yoosefian's eq. 2 is the square of the norm times the rotation.
    let scaled = attitude.body_to_world_matrix() * 30.0;
    case.check("M", &row_major(&scaled));
}

#[wasm_bindgen_test(unsupported = test)]
fn g16_half_a_turn_has_the_axis_up_to_its_sign() {
    let case = Case::find("G16");
    let q: [f64; 4] = case
        .numbers("output", "q")
        .try_into()
        .expect("four numbers");
    let attitude = rotation(q);
    let matrix: [f64; 9] = case.input("M");
    assert_close(
        "G16 M",
        &row_major(&attitude.body_to_world_matrix()),
        &matrix,
        case.tolerance,
    );
    case.check("log_plus", attitude.rotation_vector_rad().as_slice());
    let opposite = rotation(q.map(|number| -number));
    case.check("log_plus", (-opposite.rotation_vector_rad()).as_slice());
}

#[wasm_bindgen_test(unsupported = test)]
fn g17_the_logarithm_just_before_half_a_turn() {
    let case = Case::find("G17");
    let attitude = rotation(case.input("q"));
    case.check("v", attitude.rotation_vector_rad().as_slice());
}

#[wasm_bindgen_test(unsupported = test)]
fn g18_a_tiny_rotation_vector_keeps_its_digits() {
    let case = Case::find("G18");
    let v: [f64; 3] = case.input("v");
    let attitude = exponential(v);
    case.check("q", &attitude.to_tagged(Convention::HAMILTON).to_array());
    case.check("R", &row_major(&attitude.body_to_world_matrix()));
    let back = attitude.rotation_vector_rad();
    for (got, wanted) in back.iter().zip(v) {
        assert!((got / wanted - 1.0).abs() < 1e-15, "relative: {back:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g19_a_rotation_vector_longer_than_half_a_turn_is_wrapped() {
    let case = Case::find("G19");
    let attitude = exponential(case.input("v"));
    case.check("q", &attitude.to_tagged(Convention::HAMILTON).to_array());
    case.check("R", &row_major(&attitude.body_to_world_matrix()));
    case.check("wrapped", attitude.rotation_vector_rad().as_slice());
}

#[wasm_bindgen_test(unsupported = test)]
fn g28_the_example_of_the_lecture() {
    let case = Case::find("G28");
    let attitude = exponential(case.input("v"));
    let point: Vector3<f64> = case.input::<3>("p_a").into();
    case.check("Q_ab", &attitude.to_tagged(Convention::HAMILTON).to_array());
    case.check("Q_P_Qinv", attitude.body_to_world(point).as_slice());
    case.check("Qinv_P_Q", attitude.world_to_body(point).as_slice());
    case.check("p_b", attitude.world_to_body(point).as_slice());
}

#[wasm_bindgen_test(unsupported = test)]
fn g30_the_matrix_is_the_right_one_and_not_a_misprinted_one() {
    let case = Case::find("G30");
    let matrix = rotation(case.input("q")).body_to_world_matrix();
    case.check("R", &row_major(&matrix));
    for misprint in ["printed_qw2_minus_1", "printed_appendix_B"] {
        let printed = Matrix3::from_row_slice(&case.numbers("output", misprint));
        assert!((matrix - printed).amax() > 0.3, "{misprint}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g32_one_attitude_in_the_named_conventions() {
    let case = Case::find("G32");
    let attitude = exponential(case.input("v_WB"));
    let named = [
        ("hamilton_B2W_wxyz", "hamilton"),
        ("eigen_ros_B2W_xyzw", "hamilton scalar-last"),
        ("jpl_W2B_xyzw", "jpl"),
        ("jpl_B2W_xyzw", "jpl body-to-world"),
        ("hamilton_W2B_wxyz", "hamilton world-to-body"),
        ("mylab_active_W2B_wxyz", "hamilton active world-to-body"),
    ];
    for (name, convention) in named {
        let convention: Convention = convention.parse().expect("a convention");
        case.check(name, &attitude.to_tagged(convention).to_array());
    }
    case.check(
        "mylab_matrix_R_WtoB",
        &row_major(&attitude.world_to_body_matrix()),
    );
}
