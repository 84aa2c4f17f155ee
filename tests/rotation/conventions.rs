//! Laws and pins of the conventions: each fails if one sign is turned round.

use crate::support::{all_conventions, assert_close, wxyz};
use quatlas::nalgebra::{Matrix3, Quaternion, Vector3};
use quatlas::{
    ComponentSign, Convention, Direction, Rotation, TaggedQuaternion, hamilton_product, jpl_product,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Two roundings of numbers near 1.
const TWO_ROUNDINGS: f64 = 2.3e-16;

const I: Quaternion<f64> = Quaternion::new(0.0, 1.0, 0.0, 0.0);
const J: Quaternion<f64> = Quaternion::new(0.0, 0.0, 1.0, 0.0);
const K: Quaternion<f64> = Quaternion::new(0.0, 0.0, 0.0, 1.0);

#[wasm_bindgen_test(unsupported = test)]
fn the_hamilton_product_of_i_and_j_is_k() {
    assert_eq!(hamilton_product(&I, &J), K);
    assert_eq!(hamilton_product(&J, &K), I);
    assert_eq!(hamilton_product(&K, &I), J);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_jpl_product_of_i_and_j_is_minus_k() {
    assert_eq!(jpl_product(&I, &J), -K);
    assert_eq!(jpl_product(&J, &K), -I);
    assert_eq!(jpl_product(&K, &I), -J);
}

/// A quarter turn about an axis, counter-clockwise seen from its tip, as a Hamilton quaternion.
fn quarter_turn(axis: usize) -> TaggedQuaternion {
    let mut array = [0.5_f64.sqrt(), 0.0, 0.0, 0.0];
    array[axis + 1] = 0.5_f64.sqrt();
    TaggedQuaternion::from_array(array, Convention::HAMILTON)
}

fn unit(axis: usize) -> Vector3<f64> {
    let mut unit = Vector3::zeros();
    unit[axis] = 1.0;
    unit
}

/// The next axis in the circle x, y, z: a quarter turn about an axis carries the next to the one
/// after it (about z, x to y), and that one to minus the next (about z, y to −x).
fn next(axis: usize) -> usize {
    (axis + 1) % 3
}

#[wasm_bindgen_test(unsupported = test)]
fn a_quarter_turn_about_each_axis_leads_each_body_axis_to_the_world() {
    for axis in 0..3 {
        let rotation = Rotation::from_tagged(&quarter_turn(axis)).expect("a rotation");
        let (second, third) = (next(axis), next(next(axis)));
        assert_eq!(rotation.body_to_world(unit(axis)), unit(axis));
        assert_eq!(rotation.body_to_world(unit(second)), unit(third));
        assert_eq!(rotation.body_to_world(unit(third)), -unit(second));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_numbers_in_jpl_lead_each_world_axis_to_the_body() {
    for axis in 0..3 {
        let jpl = TaggedQuaternion {
            convention: Convention::JPL,
            ..quarter_turn(axis)
        };
        let rotation = Rotation::from_tagged(&jpl).expect("a rotation");
        let (second, third) = (next(axis), next(next(axis)));
        assert_eq!(rotation.world_to_body(unit(axis)), unit(axis));
        assert_eq!(rotation.world_to_body(unit(second)), -unit(third));
        assert_eq!(rotation.world_to_body(unit(third)), unit(second));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn two_different_turns_compose_as_their_matrices_do() {
    // A quarter turn about z and one about x, each written as its matrix by hand.
    let about_z = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    let about_x = Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0);
    let (z, x) = (quarter_turn(2), quarter_turn(0));

    let hamilton =
        Rotation::from_tagged(&z.product(&x).expect("one convention")).expect("not zero");
    assert_close(
        "R(z ⊙ x) = R(z) R(x)",
        hamilton.body_to_world_matrix().as_slice(),
        (about_z * about_x).as_slice(),
        TWO_ROUNDINGS,
    );

    let (z, x) = (
        z.to_convention(Convention::JPL),
        x.to_convention(Convention::JPL),
    );
    let jpl = Rotation::from_tagged(&z.product(&x).expect("one convention")).expect("not zero");
    assert_close(
        "C(z ⊗ x) = C(z) C(x)",
        jpl.world_to_body_matrix().as_slice(),
        (about_z.transpose() * about_x.transpose()).as_slice(),
        TWO_ROUNDINGS,
    );
}

/// Specification, section 2.4: the signs of the stored vector part, row by row; the orders of the
/// first and the last sixteen differ.
const CONJUGATED_ROWS: [usize; 16] = [3, 4, 5, 6, 9, 10, 15, 16, 19, 20, 21, 22, 25, 26, 31, 32];

#[wasm_bindgen_test(unsupported = test)]
fn all_32_conventions_store_the_canonical_quaternion_as_the_table_says() {
    let canonical = TaggedQuaternion::new(0.1, 0.2, 0.3, 0.4, Convention::HAMILTON);
    for (row, convention) in (1..).zip(all_conventions()) {
        let sign = if CONJUGATED_ROWS.contains(&row) {
            -1.0
        } else {
            1.0
        };
        let (x, y, z) = (0.2 * sign, 0.3 * sign, 0.4 * sign);
        let stored = if row <= 16 {
            [0.1, x, y, z]
        } else {
            [x, y, z, 0.1]
        };
        let converted = canonical.to_convention(convention);
        assert_eq!(converted.to_array(), stored, "row {row}: {convention}");
        assert_eq!(
            converted.to_convention(Convention::HAMILTON),
            canonical,
            "row {row}: and back"
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_operator_is_what_its_own_product_does() {
    // S(q) v = q∘x∘q⁻¹, in the convention's own product, is the matrix that `operator` names.
    let attitude = Rotation::from_axis_angle([0.3, -0.5, 0.8], 1.1).expect("an axis");
    let vector = [1.25, -0.5, 2.0];
    for convention in all_conventions() {
        let q = attitude.to_tagged(convention);
        let x = TaggedQuaternion::new(0.0, vector[0], vector[1], vector[2], convention);
        let turned = q
            .product(&x)
            .and_then(|product| product.product(&q.conjugate()))
            .expect("one convention");
        let expected = attitude.matrix(convention.operator()) * Vector3::from(vector);
        assert_close(
            &format!("{convention}"),
            turned.components.vector().as_slice(),
            expected.as_slice(),
            1e-15,
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn hamilton_and_jpl_have_the_same_components_and_opposite_operators() {
    assert_eq!(
        Convention::HAMILTON.component_sign(),
        ComponentSign::Canonical
    );
    assert_eq!(Convention::JPL.component_sign(), ComponentSign::Canonical);
    assert_eq!(Convention::HAMILTON.operator(), Direction::BodyToWorld);
    assert_eq!(Convention::JPL.operator(), Direction::WorldToBody);
}

#[wasm_bindgen_test(unsupported = test)]
fn every_convention_reads_back_from_its_name() {
    for convention in all_conventions() {
        assert_eq!(convention.to_string().parse(), Ok(convention));
    }
    assert_eq!("Hamilton".parse(), Ok(Convention::HAMILTON));
    assert_eq!("Shuster".parse(), Ok(Convention::JPL));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_name_that_says_too_little_or_nothing_is_refused() {
    for name in [
        "",
        "right",
        "right passive body-to-world local",
        "jpl sideways",
        "hamilton jpl",
    ] {
        assert!(name.parse::<Convention>().is_err(), "{name:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn quaternions_of_different_conventions_do_not_multiply() {
    let hamilton = quarter_turn(0);
    let error = hamilton
        .product(&hamilton.to_convention(Convention::JPL))
        .expect_err("two conventions");
    assert_eq!(
        error.to_string(),
        "the left factor is scalar-first right passive body-to-world local and the right factor is \
         scalar-last left passive world-to-body local: convert one of them first"
    );
}

/// The numbers a norm has to survive: see the names.
const SIZES: [f64; 7] = [
    5e-324, // the smallest double
    1e-310, // subnormal
    1e-300, 1e-160, // its square underflows
    1e160,  // its square overflows
    1e300, 1.7e308, // twice it overflows
];

#[wasm_bindgen_test(unsupported = test)]
fn normalising_neither_overflows_nor_underflows() {
    for size in SIZES {
        let q = TaggedQuaternion::new(size, size, -size, size, Convention::HAMILTON);
        let unit = q.normalize().expect("not zero");
        assert_eq!(wxyz(&unit.components), [0.5, 0.5, -0.5, 0.5], "{size:e}");
    }
    let mixed = TaggedQuaternion::new(3e300, 1e-300, 4e300, 0.0, Convention::JPL);
    let unit = mixed.normalize().expect("not zero");
    assert_close(
        "3 : 4",
        &wxyz(&unit.components),
        &[0.6, 0.0, 0.8, 0.0],
        TWO_ROUNDINGS,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn the_inverse_undoes_the_product_at_any_size() {
    for size in [1e-300, 1e-160, 0.3, 7.0, 1e160, 1e300] {
        for convention in [Convention::HAMILTON, Convention::JPL] {
            let q = TaggedQuaternion::new(size, -2.0 * size, 3.0 * size, 0.5 * size, convention);
            let inverse = q.inverse().expect("within range");
            let one = q.product(&inverse).expect("one convention");
            assert_close(
                "q ∘ q⁻¹",
                &wxyz(&one.components),
                &[1.0, 0.0, 0.0, 0.0],
                1e-15,
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn zero_and_numbers_that_are_not_finite_are_no_rotation() {
    for w in [0.0, -0.0, f64::NAN, f64::INFINITY] {
        let q = TaggedQuaternion::new(w, 0.0, 0.0, 0.0, Convention::HAMILTON);
        assert!(Rotation::from_tagged(&q).is_err(), "{w}");
        assert!(q.normalize().is_none(), "{w}");
    }
    assert!(Rotation::from_axis_angle([0.0; 3], 1.0).is_err());
    assert!(Rotation::from_axis_angle([1.0, 0.0, 0.0], f64::NAN).is_err());
    assert!(Rotation::from_rotation_vector_rad([f64::INFINITY, 0.0, 0.0]).is_err());
}
