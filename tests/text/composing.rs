//! Two quaternions together: four products, which are equal, what acts first, which frames meet.

use crate::asked::{compose, read};
use crate::support::{all_conventions, assert_close};
use nalgebra::{Rotation3, Vector3};
use quatlas::{
    Convention, Direction, Fact, Frame, Handedness, Operand, OrderMatters, OutOfRangeNumber,
    Product, Turn,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Four products and a sum, each rounded once, in numbers below 1.
const ROUNDING: f64 = 4.5e-16;

/// A quarter turn about z and a quarter turn about x: they do not commute.
const ABOUT_Z: &str = "√½ + √½ k";
const ABOUT_X: &str = "√½ + √½ i";

fn find(products: &[Product], handedness: Handedness, left: Operand) -> &Product {
    products
        .iter()
        .find(|product| product.convention.handedness == handedness && product.left == left)
        .expect("all four products")
}

#[wasm_bindgen_test(unsupported = test)]
fn the_four_products_of_two_quarter_turns() {
    let report = compose(ABOUT_Z, ABOUT_X, "0 1 0", Convention::HAMILTON);
    // (1 + k)(1 + i)/2 = (1 + i + k + ki)/2, and ki = j for Hamilton, −j for JPL.
    let with_plus_j = [0.5, 0.5, 0.5, 0.5];
    let with_minus_j = [0.5, 0.5, -0.5, 0.5];
    for (handedness, left, expected) in [
        (Handedness::Right, Operand::P, with_plus_j),
        (Handedness::Right, Operand::Q, with_minus_j),
        (Handedness::Left, Operand::P, with_minus_j),
        (Handedness::Left, Operand::Q, with_plus_j),
    ] {
        let product = find(&report.products, handedness, left);
        let [w, x, y, z] = expected;
        let quaternion = &product.quaternion;
        assert_close(
            "product",
            &[quaternion.w, quaternion.x, quaternion.y, quaternion.z],
            &expected,
            ROUNDING,
        );
        let array = match handedness {
            Handedness::Right => [w, x, y, z],
            Handedness::Left => [x, y, z, w],
        };
        assert_close("array", &quaternion.array, &array, ROUNDING);
    }
    assert_eq!(report.order_matters, OrderMatters::Yes);
    let equal_to: Vec<_> = report
        .products
        .iter()
        .map(|product| product.equal_to.clone())
        .collect();
    assert_eq!(equal_to, [vec![0, 3], vec![1, 2], vec![1, 2], vec![0, 3]]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_right_factor_acts_first_in_both_products() {
    let report = compose(ABOUT_Z, ABOUT_X, "0 1 0", Convention::HAMILTON);
    // Hamilton p ⊙ q: first about x, y goes to z; then about z, z stays.
    let hamilton = find(&report.products, Handedness::Right, Operand::P);
    let [after_q, after_both] = hamilton.images.expect("finite");
    assert_close("after q", &after_q, &[0.0, 0.0, 1.0], ROUNDING);
    assert_close("after both", &after_both, &[0.0, 0.0, 1.0], ROUNDING);
    assert_eq!(hamilton.direction, Direction::BodyToWorld);
    assert_eq!(
        hamilton.frames,
        [Frame::SecondBody, Frame::Body, Frame::World]
    );
    assert_eq!(hamilton.first_about_fixed_axes, Operand::Q);

    // JPL p ⊗ q: first C of the turn about x, y goes to −z; then C of the turn about z, z stays.
    let jpl = find(&report.products, Handedness::Left, Operand::P);
    let [after_q, after_both] = jpl.images.expect("finite");
    assert_close("after q", &after_q, &[0.0, 0.0, -1.0], ROUNDING);
    assert_close("after both", &after_both, &[0.0, 0.0, -1.0], ROUNDING);
    assert_eq!(jpl.direction, Direction::WorldToBody);
    assert_eq!(jpl.frames, [Frame::World, Frame::Body, Frame::SecondBody]);
    assert_eq!(jpl.first_about_fixed_axes, Operand::P);
}

#[wasm_bindgen_test(unsupported = test)]
fn equal_numbers_have_transposed_matrices() {
    let report = compose("1 2 -3 4", "2 -1 0.5 3", "1 2 3", Convention::HAMILTON);
    let hamilton = find(&report.products, Handedness::Right, Operand::P);
    let jpl = find(&report.products, Handedness::Left, Operand::Q);
    for row in 0..3 {
        for column in 0..3 {
            assert_eq!(hamilton.matrix[row][column], jpl.matrix[column][row]);
        }
    }
    // (1, 2, −3, 4) ⊙ (2, −1, 0.5, 3), by the table of i, j and k.
    assert_eq!(hamilton.quaternion.array, [-6.5, -8.0, -15.5, 9.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn each_product_has_the_turn_of_its_attitude() {
    // (c + s k) ⊙ (C + S i) = cC + cS i + sS j + sC k, of 15° and 50°; the other order flips j. The
    // numbers of JPL's p ⊗ q are those of q ⊙ p, world to body, and the body turns by the same.
    let (half_z, half_x) = (15.0_f64.to_radians(), 50.0_f64.to_radians());
    let scalar = half_z.cos() * half_x.cos();
    let first_x = Vector3::new(
        half_z.cos() * half_x.sin(),
        half_z.sin() * half_x.sin(),
        half_z.sin() * half_x.cos(),
    );
    let first_z = Vector3::new(first_x.x, -first_x.y, first_x.z);
    for declared in all_conventions() {
        let report = compose("30deg about z", "100deg about x", "1 0 0", declared);
        let of_declared = match report.declared.first_about_fixed_axes {
            Operand::P => first_z,
            Operand::Q => first_x,
        };
        for (product, vector_part) in report
            .products
            .iter()
            .zip([first_x, first_z, first_z, first_x])
            .chain([(&report.declared, of_declared)])
        {
            let angle_rad = 2.0 * scalar.acos();
            let axis = vector_part.normalize();
            let turn = &product.turn;
            assert_close("angle", &[turn.angle_rad], &[angle_rad], 1e-15);
            assert_close(
                "angle in degrees",
                &[turn.angle_deg],
                &[angle_rad.to_degrees()],
                1e-13,
            );
            assert_close(
                "axis",
                &turn.axis.expect("a turn has an axis"),
                axis.as_slice(),
                1e-15,
            );
            assert_close(
                "rotation vector",
                &turn.rotation_vector_rad,
                (angle_rad * axis).as_slice(),
                1e-15,
            );
            let alone = product.quaternion.array.map(|number| number.to_string());
            let alone = read(&alone.join(" "), "1 0 0", product.convention).turn;
            assert_close(
                "turn of the product typed alone",
                &alone.rotation_vector_rad,
                &turn.rotation_vector_rad,
                1e-14,
            );
            for &place in &product.equal_to {
                assert_eq!(report.products[place].turn, *turn);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn turns_that_commute_are_said_to() {
    let about_one_axis = compose("0.6 + 0.8k", "0.8 + 0.6k", "1 0 0", Convention::JPL);
    assert_eq!(about_one_axis.order_matters, OrderMatters::No);
    assert_eq!(about_one_axis.products[0].equal_to, [0, 1, 2, 3]);
    // Half turns about x and y: ij = k and ji = −k are one rotation.
    let half_turns = compose("0 + i", "0 + j", "1 0 0", Convention::JPL);
    assert_eq!(half_turns.order_matters, OrderMatters::OnlyInSign);
    // About axes at 45° they lead to quarter turns about z, one way or the other.
    let half_turns = compose("0 + i", "0 + i + j", "1 0 0", Convention::JPL);
    assert_eq!(half_turns.order_matters, OrderMatters::Yes);
}

#[wasm_bindgen_test(unsupported = test)]
fn small_turns_about_different_axes_do_not_commute() {
    // The products differ by 2e-16 in z, which is less than the rounding of their scalar.
    for (p, q) in [
        ("1 + 1e-8i", "1 + 1e-8j"),
        ("1 + 1e-20k", "0 + i"),
        ("1e200 + 1k", "1e200 + 1i + 1k"),
    ] {
        let report = compose(p, q, "1 0 0", Convention::HAMILTON);
        assert_eq!(report.order_matters, OrderMatters::Yes, "{p} and {q}");
        assert_eq!(report.products[0].equal_to, [0, 3], "{p} and {q}");
    }
    // 1/3 and 2/3 are rounded, and still the axes are parallel.
    let parallel = compose(
        "0.3 + i/3 + 0.1j",
        "1 + 2/3i + 0.2j",
        "1 0 0",
        Convention::JPL,
    );
    assert_eq!(parallel.order_matters, OrderMatters::No);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_product_beyond_a_double_is_that_of_the_unit_quaternions_and_said() {
    let report = compose(
        "1e200 + 1e200k",
        "1e200 + 1e200i",
        "1 0 0",
        Convention::HAMILTON,
    );
    assert_close(
        "units",
        &report.products[0].quaternion.array,
        &[0.5; 4],
        ROUNDING,
    );
    assert!(report.notes.iter().any(|note| {
        matches!(&note.fact, Fact::OutOfRange(fact) if fact.what == OutOfRangeNumber::Product)
    }));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_declared_product_is_in_the_declared_convention() {
    // Left, body to world: by its own product (1 + 2i + 3j + 4k) ⊗ (1 + i) = −1 + 3i − j + 7k.
    let declared = Convention::JPL_BODY_TO_WORLD;
    let report = compose("1 + 2i + 3j + 4k", "1 + i", "1 0 0", declared);
    let product = &report.declared;
    assert_eq!(product.quaternion.array, [3.0, -1.0, 7.0, -1.0]);
    assert_eq!(
        (product.convention, product.direction),
        (declared, Direction::BodyToWorld)
    );
    // Its numbers are the conjugates of Hamilton's p ⊙ q, so it equals none of the four ...
    assert_eq!(product.equal_to, Vec::<usize>::new());
    let hamilton = &report.products[0].quaternion;
    assert_eq!(
        [hamilton.w, hamilton.x, hamilton.y, hamilton.z],
        [-1.0, -3.0, 1.0, -7.0]
    );
    // ... but its matrix is that of p ⊙ q.
    assert_eq!(product.matrix, report.products[0].matrix);

    for (preset, place) in [(Convention::HAMILTON, 0), (Convention::JPL, 2)] {
        let report = compose("1 2 3 4", "5 6 7 8", "1 0 0", preset);
        assert_eq!(report.declared, report.products[place]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_two_turns_one_after_the_other_about_fixed_axes_make_the_product_in_every_convention() {
    for convention in all_conventions() {
        let report = compose("0.3 -0.5 0.7 0.2", "0.6 0.2 -0.1 0.4", "1 0 0", convention);
        let product = &report.declared;
        let text = product.quaternion.array.map(|number| number.to_string());
        let together = read(&text.join(" "), "1 0 0", product.convention).turn;
        let rotation = |turn: &Turn| {
            Rotation3::from_scaled_axis(Vector3::from(turn.rotation_vector_rad)).into_inner()
        };
        let (first, then) = match product.first_about_fixed_axes {
            Operand::P => (&report.p_turn, &report.q_turn),
            Operand::Q => (&report.q_turn, &report.p_turn),
        };
        assert_close(
            "then · first",
            (rotation(then) * rotation(first)).as_slice(),
            rotation(&together).as_slice(),
            1e-14,
        );
    }
}
