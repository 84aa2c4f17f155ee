//! From one library or convention to another: the numbers, the matrix and the product of both ends.

use super::{TEXT, between, body_to_world, translate, with_plain_quaternions};
use crate::simulated::{active_matrix, hamilton};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::Matrix3;
use quatlas::{
    Change, ComponentSign, Convention, CosineMatrix, Direction, Endpoint, Family, Handedness,
    LibraryEndpoint, ProductOrder, Side, TaggedQuaternion, library,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn ends() -> Vec<Endpoint> {
    let of_libraries = with_plain_quaternions().flat_map(|library| {
        Direction::ALL.map(|direction| {
            Endpoint::Library(LibraryEndpoint {
                id: library.id.to_owned(),
                order: None,
                direction: Some(direction),
            })
        })
    });
    let of_conventions = all_conventions().into_iter().map(Endpoint::convention);
    of_libraries.chain(of_conventions).collect()
}

/// From every end to three that differ in everything, and back.
#[wasm_bindgen_test(unsupported = test)]
fn both_ends_are_one_attitude_and_the_way_back_is_exact() {
    let partners = ["openvins", "directxmath", "basilisk"].map(Endpoint::library);
    for end in ends() {
        for partner in &partners {
            for (from, to) in [(&end, partner), (partner, &end)] {
                let there = translate(TEXT, from, to);
                let expected = body_to_world(&there.from);
                let what = format!("{from:?} {to:?}");
                let got = body_to_world(&there.to);
                assert_close(&what, got.as_slice(), expected.as_slice(), 1e-15);
                let array = there.to.array.map(|number| format!("{number:?}")).join(" ");
                let back = translate(&array, to, from);
                assert_eq!(back.to.array, [0.1, 0.7, -0.5, 0.5], "{what}");
                assert_eq!(back.change, there.change, "{what}");
                assert_eq!(back.product, there.product, "{what}");
            }
        }
    }
}

/// The product of one end, translated, is the product of the other in the order that is said.
#[wasm_bindgen_test(unsupported = test)]
fn a_product_is_written_in_the_order_that_is_said() {
    let product = |hand: Handedness, a, b| match hand {
        Handedness::Right => hamilton(a, b),
        Handedness::Left => hamilton(b, a),
    };
    let (a, b) = ([0.8, 0.2, -0.4, 0.4], [0.1, 0.7, -0.5, 0.5]);
    let mut seen = [0, 0, 0];
    for from in ends() {
        for to in ["openvins", "directxmath", "basilisk", "scipy"].map(Endpoint::library) {
            let report = translate(TEXT, &from, &to);
            let (Some(here), Some(there)) = (report.from.handedness, report.to.handedness) else {
                assert_eq!(report.product, ProductOrder::NotEstablished);
                seen[2] += 1;
                continue;
            };
            let is_conjugated = report.from.sign != report.to.sign;
            let over = |[w, x, y, z]: [f64; 4]| {
                if is_conjugated {
                    [w, -x, -y, -z]
                } else {
                    [w, x, y, z]
                }
            };
            let expected = over(product(here, a, b));
            let got = match report.product {
                ProductOrder::Same => product(there, over(a), over(b)),
                ProductOrder::Reversed => product(there, over(b), over(a)),
                other => panic!("{other:?}: both are known"),
            };
            assert_close(&format!("{from:?}"), &got, &expected, 1e-15);
            seen[usize::from(report.product == ProductOrder::Reversed)] += 1;
        }
    }
    assert!(seen.iter().all(|&count| count > 10), "{seen:?}");
}

/// The matrix that an end prints is `R` or `C` of its own numbers.
#[wasm_bindgen_test(unsupported = test)]
fn the_printed_matrix_is_that_of_the_ends_own_numbers() {
    for end in ends() {
        let report = translate(TEXT, &end, &Endpoint::library("eigen"));
        let q = &report.from.components;
        let Some(printed) = report.from.matrix else {
            continue;
        };
        let active = active_matrix([q.w, q.x, q.y, q.z]);
        let expected = match printed.form {
            CosineMatrix::Hamilton => active,
            CosineMatrix::Shuster => active.transpose(),
        };
        let got = Matrix3::from(printed.rows).transpose();
        assert_close(
            &format!("{end:?}"),
            got.as_slice(),
            expected.as_slice(),
            1e-15,
        );
        // Read back as nine numbers, it is the same attitude.
        let rows = printed
            .rows
            .concat()
            .iter()
            .map(|n| format!("{n:?}"))
            .collect::<Vec<_>>();
        let again = translate(&rows.join(" "), &end, &Endpoint::library("eigen"));
        let (one, other) = (body_to_world(&report.to), body_to_world(&again.to));
        assert_close("read back", one.as_slice(), other.as_slice(), 1e-15);
    }
}

/// Between the 32 conventions it is what `to_convention` does.
#[wasm_bindgen_test(unsupported = test)]
fn between_conventions_it_is_the_same_as_ever() {
    for one in all_conventions() {
        for other in all_conventions() {
            let [from, to] = [one, other].map(Endpoint::convention);
            let expected = TaggedQuaternion::from_array([0.1, 0.7, -0.5, 0.5], one)
                .to_convention(other)
                .to_array();
            assert_eq!(
                translate(TEXT, &from, &to).to.array,
                expected,
                "{one} to {other}"
            );
        }
    }
}

/// Without documentation: R(q) body to world, C(q) world to body.
#[wasm_bindgen_test(unsupported = test)]
fn customary_directions() {
    let direction = |id: &str| {
        assert_eq!(library(id).expect(id).direction, None);
        between(TEXT, id, "eigen").from.direction
    };
    assert_eq!(direction("orekit"), Direction::WorldToBody);
    assert_eq!(direction("directxmath"), Direction::BodyToWorld);
    assert_eq!(direction("scipy"), Direction::BodyToWorld);
}

#[wasm_bindgen_test(unsupported = test)]
fn families_that_labels_do_not_name() {
    let family = |id| between(TEXT, id, "eigen").from;
    let directx = family("directxmath");
    assert_eq!(
        (directx.family, directx.first_to_act),
        (Some(Family::ReversedProduct), Some(Side::Left))
    );
    assert_eq!(directx.sign, ComponentSign::Canonical);
    let basilisk = family("basilisk");
    assert_eq!(
        (basilisk.family, basilisk.direction),
        (Some(Family::TransposedMatrix), Direction::WorldToBody)
    );
    assert_eq!(basilisk.sign, ComponentSign::Canonical);
    // Neither is conjugated on the way to Eigen, though one has ij = −k and the other prints C.
    assert_eq!(between(TEXT, "directxmath", "eigen").change, Change::Copied);
    assert_eq!(between(TEXT, "basilisk", "eigen").change, Change::Reordered);
    assert_eq!(
        between(TEXT, "directxmath", "eigen").product,
        ProductOrder::Reversed
    );
    assert_eq!(
        between(TEXT, "basilisk", "eigen").product,
        ProductOrder::Same
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_established_is_said() {
    let report = between(TEXT, "ros-geometry-msgs", "scipy");
    assert!(!report.from.assumed.is_empty());
    assert_eq!(report.from.matrix, None);
    assert_eq!(report.product, ProductOrder::NotEstablished);
    assert!(between(TEXT, "eigen", "scipy").from.assumed.is_empty());
}

/// What was chosen stands in the report, also where its numbers are those of another convention.
#[wasm_bindgen_test(unsupported = test)]
fn an_active_convention_stays_active() {
    let active: Convention = "xyzw left active body-to-world global"
        .parse()
        .expect("five words");
    let report = translate(
        TEXT,
        &Endpoint::convention(active),
        &Endpoint::library("eigen"),
    );
    assert_eq!(report.from.convention, active);
    assert_eq!(report.from.direction, Direction::WorldToBody);
}
