//! The specification's model of conventions: tables 2.1 and 2.4, and what each document calls a
//! quaternion of two frames (see `table.md`).

use crate::reference::{
    self, CLOSE, assert_off, assert_quaternion, assert_same, assert_turn, components, conjugate,
    eight, exponential_matrix, half_angle, matrix_of, pairs, sigma, tau, turned, turns, vectors,
};
use crate::support::all_conventions;
use quatlas::nalgebra::{Quaternion, Vector3};
use quatlas::{
    ComponentOrder, ComponentSign, Convention, CosineMatrix, Direction, Function, Handedness,
    MatrixConvention, Perturbation, Rotation, TaggedQuaternion,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn attitude(v: &Vector3<f64>) -> Rotation {
    Rotation::from_rotation_vector_rad((*v).into()).expect("finite")
}

fn is_plus(convention: Convention) -> bool {
    tau(convention.function, convention.direction) > 0.0
}

/// The product of two attitudes' quaternions in a convention.
fn times(first: &Rotation, second: &Rotation, convention: Convention) -> Quaternion<f64> {
    first
        .to_tagged(convention)
        .product(&second.to_tagged(convention))
        .expect("one convention")
        .components
}

/// MODEL-01, MODEL-02 and table 2.1
#[wasm_bindgen_test(unsupported = test)]
fn operator_and_sign_of_the_eight_are_those_of_the_table() {
    use ComponentSign::{Canonical, Conjugated};
    use Direction::{BodyToWorld, WorldToBody};
    let table = [
        (BodyToWorld, Canonical),
        (WorldToBody, Conjugated),
        (WorldToBody, Conjugated),
        (BodyToWorld, Canonical),
        (BodyToWorld, Conjugated),
        (WorldToBody, Canonical),
        (WorldToBody, Canonical),
        (BodyToWorld, Conjugated),
    ];
    for (convention, (operator, sign)) in eight().zip(table) {
        assert_eq!(convention.operator(), operator, "{convention}");
        assert_eq!(convention.component_sign(), sign, "{convention}");
        assert_eq!(sigma(convention) > 0.0, sign == Canonical, "{convention}");
        for v in turns() {
            let q = attitude(&v).to_tagged(convention).components;
            assert_quaternion(&convention.to_string(), &q, &components(convention, &v));
            let operator = if is_plus(convention) { v } else { -v };
            let by_product = matrix_of(convention.handedness, &q);
            assert_same("S(q)", &by_product, &exponential_matrix(&operator), CLOSE);
        }
    }
}

/// MODEL-03, 000-2.24, 000-2.26
#[wasm_bindgen_test(unsupported = test)]
fn the_operator_of_a_product_is_the_product_of_the_operators() {
    for (v, u) in pairs(turns()) {
        for convention in eight() {
            let both = TaggedQuaternion {
                components: times(&attitude(&v), &attitude(&u), convention),
                convention,
            };
            let read = Rotation::from_tagged(&both).expect("not zero");
            let sign = tau(convention.function, convention.direction);
            let expected = exponential_matrix(&(v * sign)) * exponential_matrix(&(u * sign));
            let got = read.matrix(convention.operator());
            assert_same(&convention.to_string(), &got, &expected, CLOSE);
        }
    }
}

/// MODEL-04, 004-Q.8, FX-23, 004-I.1, 004-I.D: passive from scratch, the components of a fixed vector
/// on the other axes; active from scratch, the vector moved by the turn of the axes.
#[wasm_bindgen_test(unsupported = test)]
fn passive_changes_coordinates_and_active_moves_the_vector() {
    for (v, x) in turns().flat_map(|v| vectors().map(move |x| (v, x))) {
        let axes = exponential_matrix(&v);
        let (on_world, on_body) = (axes * x, axes.transpose() * x);
        for convention in eight() {
            // A vector with the coordinates x in the frame that the label begins with.
            let expected = match (convention.function, convention.direction) {
                (Function::Passive, Direction::BodyToWorld) => on_world,
                (Function::Passive, Direction::WorldToBody) => on_body,
                // Moved with the world's axes onto the body's: it has there what it had here.
                (Function::Active, Direction::WorldToBody) => on_world,
                (Function::Active, Direction::BodyToWorld) => on_body,
            };
            let q = attitude(&v).to_tagged(convention).components;
            let image = turned(convention.handedness, &q, &x);
            assert_same(&convention.to_string(), &image, &expected, CLOSE);
            let coordinates = turned(convention.handedness, &conjugate(&q), &image);
            assert_same("back", &coordinates, &x, CLOSE);
        }
    }
}

/// The quaternion with the label `q_X^Y` for an active or passive convention, where the turn v carries X
/// onto Y; from the definition alone.
fn labelled(convention: Convention, v: &Vector3<f64>) -> Quaternion<f64> {
    // Passive X→Y changes coordinates from X to Y: Exp(−v). Active moves X onto Y: Exp(v).
    let operator = match convention.function {
        Function::Passive => -v,
        Function::Active => *v,
    };
    match convention.handedness {
        Handedness::Right => half_angle(&operator),
        Handedness::Left => half_angle(&-operator),
    }
}

/// MODEL-05, 000-2.23, 000-2.25, 004-Q.16a, 004-Q.16b, 004-Q.16c: of labels `q_A^C`.
#[wasm_bindgen_test(unsupported = test)]
fn labelled_quaternions_compose_in_the_order_of_their_function() {
    for (first, second) in pairs(turns()) {
        // A → B by `first`, B → C by `second` on the axes of B.
        let whole = attitude(&first) * attitude(&second);
        for convention in eight() {
            let q_ab = labelled(convention, &first);
            let q_bc = labelled(convention, &second);
            let q_ac = labelled(convention, &whole.rotation_vector_rad());
            let tagged = |components| TaggedQuaternion {
                components,
                convention,
            };
            let (q_ab, q_bc) = (tagged(q_ab), tagged(q_bc));
            let got = match convention.function {
                Function::Passive => q_bc.product(&q_ab),
                Function::Active => q_ab.product(&q_bc),
            };
            let got = got.expect("one convention").components;
            assert_turn(&convention.to_string(), &got, &q_ac);
        }
        // The convention's own quaternion is the label of its direction.
        for convention in eight() {
            let from_to = match convention.direction {
                Direction::WorldToBody => first,
                Direction::BodyToWorld => -first,
            };
            let q = attitude(&first).to_tagged(convention).components;
            assert_turn("label", &q, &labelled(convention, &from_to));
        }
    }
}

/// MODEL-18, 000-S2.6.o, 003-S4.3.a
#[wasm_bindgen_test(unsupported = test)]
fn the_chain_from_world_over_body_to_camera_for_each_of_the_eight() {
    for (first, second) in pairs(turns()) {
        let (r_wb, r_bc) = (attitude(&first), attitude(&second));
        let matrices = exponential_matrix(&first) * exponential_matrix(&second);
        for convention in eight() {
            let product = if is_plus(convention) {
                times(&r_wb, &r_bc, convention)
            } else {
                times(&r_bc, &r_wb, convention)
            };
            let q_wc = TaggedQuaternion {
                components: product,
                convention,
            };
            let r_wc = Rotation::from_tagged(&q_wc).expect("not zero");
            assert_same("R_WC", &r_wc.body_to_world_matrix(), &matrices, CLOSE);
            let by_core = (r_wb * r_bc).to_tagged(convention).components;
            assert_turn(&convention.to_string(), &by_core, &product);
        }
    }
}

/// MODEL-10: two sets of components, four behaviours.
#[wasm_bindgen_test(unsupported = test)]
fn function_and_direction_cannot_be_told_apart_by_numbers() {
    let v = Vector3::new(0.4, -0.7, 1.1);
    let mut sets: Vec<[f64; 4]> = Vec::new();
    let mut behaviours: Vec<(Handedness, Direction)> = Vec::new();
    for convention in eight() {
        let array = attitude(&v).to_tagged(convention).to_array();
        if !sets.contains(&array) {
            sets.push(array);
        }
        let behaviour = (convention.handedness, convention.operator());
        if !behaviours.contains(&behaviour) {
            behaviours.push(behaviour);
        }
        let twin = Convention {
            function: match convention.function {
                Function::Passive => Function::Active,
                Function::Active => Function::Passive,
            },
            direction: convention.direction.reversed(),
            ..convention
        };
        assert_eq!(attitude(&v).to_tagged(twin).to_array(), array);
        assert_eq!(twin.operator(), convention.operator());
    }
    assert_eq!((sets.len(), behaviours.len()), (2, 4));
}

/// MODEL-19, 004-I.O, 002-1, 002-11, and table 2.4: conversion between all 32 × 32.
#[wasm_bindgen_test(unsupported = test)]
fn conversion_conjugates_where_the_signs_differ_and_reorders_where_the_orders_do() {
    let stored = [0.5, -0.1, 0.7, 0.3];
    for (from, to) in pairs(all_conventions()) {
        let (w, vector) = match from.order {
            ComponentOrder::ScalarFirst => (stored[0], [stored[1], stored[2], stored[3]]),
            ComponentOrder::ScalarLast => (stored[3], [stored[0], stored[1], stored[2]]),
        };
        let [x, y, z] = vector.map(|number| number * sigma(from) * sigma(to));
        let expected = match to.order {
            ComponentOrder::ScalarFirst => [w, x, y, z],
            ComponentOrder::ScalarLast => [x, y, z, w],
        };
        let converted = TaggedQuaternion::from_array(stored, from).to_convention(to);
        assert_eq!(converted.to_array(), expected, "{from} to {to}");
        let read = |q: &TaggedQuaternion| Rotation::from_tagged(q).expect("not zero");
        let before = TaggedQuaternion::from_array(stored, from);
        assert_eq!(read(&converted), read(&before), "one attitude");
    }
}

/// MODEL-11, 000-2.20, 000-2.21, 000-2.22, 000-T1, 000-T2.1, 000-T2.2, 000-S2.5.2c, 000-S2.5.2r,
/// 000-2.38, 000-2.39: `q_b^a` of Cheng, with b the world and a the body, has one set of components in
/// both products.
#[wasm_bindgen_test(unsupported = test)]
fn q_b_a_of_cheng_is_right_active_and_left_passive_from_world_to_body() {
    let of_hamilton: Convention = "hamilton active world-to-body".parse().expect("a name");
    for v in turns() {
        let carried = exponential_matrix(&v);
        let q = attitude(&v).to_tagged(of_hamilton).components;
        assert_eq!(q, attitude(&v).to_tagged(Convention::JPL).components);
        assert_same(
            "R(q_b^a)",
            &matrix_of(Handedness::Right, &q),
            &carried,
            CLOSE,
        );
        let opposite = matrix_of(Handedness::Left, &q);
        assert_same("C(q_b^a)", &opposite, &carried.transpose(), CLOSE);
        let other_way = attitude(&-v).to_tagged(of_hamilton).components;
        assert_quaternion("q_b^a = (q_a^b)*", &conjugate(&q), &other_way);
        // To move vectors use R(q); to change the basis from b to a use C(q_b^a).
        for x in vectors() {
            let moved = attitude(&v).body_to_world(x);
            assert_same("moved", &turned(Handedness::Right, &q, &x), &moved, CLOSE);
            let seen = attitude(&v).world_to_body(x);
            assert_same("seen", &turned(Handedness::Left, &q, &x), &seen, CLOSE);
        }
    }
}

/// MODEL-12, 002-S3.1, 002-S3.2, 002-S2.a, 002-18, 002-19, 002-S4
#[wasm_bindgen_test(unsupported = test)]
fn the_jpl_quaternion_of_the_same_directed_matrix_is_the_conjugate() {
    for v in turns() {
        let matrix = exponential_matrix(&v);
        let nearest = Rotation::nearest_to_matrix(&quatlas::TaggedMatrix {
            entries: matrix,
            convention: MatrixConvention::BODY_TO_WORLD,
        });
        let attitude = nearest.expect("a rotation").rotation;
        let q_h = attitude.to_tagged(Convention::HAMILTON);
        let q_j = attitude.to_tagged(Convention::JPL_BODY_TO_WORLD);
        let q = q_h.components;
        assert_eq!(q_j.to_array(), [-q.i, -q.j, -q.k, q.w]);
        assert_same("R_H", &matrix_of(Handedness::Right, &q), &matrix, CLOSE);
        let r_j = matrix_of(Handedness::Left, &q_j.components);
        assert_same("R_J = R_H", &r_j, &matrix, CLOSE);
        // The other reading: JPL from world to body has Hamilton's components.
        let usual = attitude.to_tagged(Convention::JPL);
        assert_eq!(usual.to_array(), [q.i, q.j, q.k, q.w]);
        let mistaken = matrix_of(Handedness::Left, &conjugate(&usual.components));
        if v.norm() > 0.1 && v.norm() < 3.0 {
            assert_off("eq. 18 applied there", &mistaken, &matrix.transpose());
        }
    }
}

/// MODEL-13, MODEL-15, MODEL-16, 004-T2.H, 004-T2.J, 004-T2.L, 004-Q.3p, FX-20
#[wasm_bindgen_test(unsupported = test)]
fn the_named_conventions_of_the_documents_have_the_same_numbers() {
    for v in turns() {
        let (r_wb, r_bw) = (exponential_matrix(&v), exponential_matrix(&-v));
        let of = |convention| attitude(&v).to_tagged(convention).components;
        let q = of(Convention::HAMILTON);
        assert_quaternion("Hamilton", &q, &half_angle(&v));
        assert_same("Hamilton", &matrix_of(Handedness::Right, &q), &r_wb, CLOSE);
        assert_eq!(of(Convention::JPL), q);
        assert_same(
            "Shuster/JPL",
            &matrix_of(Handedness::Left, &q),
            &r_bw,
            CLOSE,
        );
        assert_eq!(of(Convention::MY_LAB), q);
        let paired = CosineMatrix::Shuster.of(&of(Convention::MY_LAB));
        assert_same("My Lab", &paired.expect("not zero"), &r_bw, CLOSE);
        let own = Convention::MY_LAB.cosine_matrix(MatrixConvention {
            function: Function::Active,
            direction: Direction::WorldToBody,
        });
        assert_eq!(own, CosineMatrix::Hamilton);
        let passive: Convention = "hamilton world-to-body".parse().expect("a name");
        let by_hand = CosineMatrix::Hamilton.of(&of(passive)).expect("not zero");
        assert_same("Right passive world to body", &by_hand, &r_bw, CLOSE);
        assert_quaternion("its components", &of(passive), &conjugate(&q));

        // Cheng q_b^a, Yoosefian ᵇq_a, lecture Q_ba, field guide passive q_a^b and active q_b^a: a is
        // the body and b the world. Cheng's JPL q_b^a is the guide's passive left one.
        let spellings = [
            "hamilton active world-to-body",
            "hamilton passive body-to-world",
            "jpl passive world-to-body",
        ];
        for spelling in spellings {
            let convention: Convention = spelling.parse().expect("a name");
            assert_eq!(of(convention), q, "{spelling}");
        }
    }
}

/// MODEL-14: active from body to world is the inverse of active from world to body.
#[wasm_bindgen_test(unsupported = test)]
fn the_other_direction_is_the_inverse_for_active_quaternions_too() {
    for v in turns() {
        for convention in eight() {
            let reversed = Convention {
                direction: convention.direction.reversed(),
                ..convention
            };
            let q = attitude(&v).to_tagged(convention).components;
            let other = attitude(&v).to_tagged(reversed).components;
            assert_eq!(other, conjugate(&q), "{convention}");
            assert_ne!(convention.operator(), reversed.operator());
        }
    }
}

/// 002-S3.a, 004-T1: 16 quaternion conventions, 32 with the perturbation; 8 matrix conventions with it;
/// 12 where active has no direction.
#[wasm_bindgen_test(unsupported = test)]
fn the_conventions_are_as_many_as_the_table_counts() {
    let mut all = all_conventions();
    all.dedup();
    assert_eq!(all.len(), 32, "all different");
    all.retain(|convention| convention.perturbation == Perturbation::Local);
    assert_eq!(all.len(), 16);
    all.retain(|convention| {
        convention.function == Function::Passive || convention.direction == Direction::WorldToBody
    });
    assert_eq!(all.len(), 12);
    let perturbations = Perturbation::ALL.len();
    assert_eq!(MatrixConvention::all().count() * perturbations, 8);
    assert_eq!(quatlas::EulerSequence::all().count(), 24);
}

/// 000-S2.2.n, 004-I.H: the hand of the product is not that of the axes, which are right-handed.
#[wasm_bindgen_test(unsupported = test)]
fn the_axes_are_right_handed_in_both_products() {
    for convention in all_conventions() {
        let q = TaggedQuaternion::from_array([0.3, -0.6, 0.2, 0.9], convention);
        let read = Rotation::from_tagged(&q).expect("not zero");
        let [x, y, z] = [0, 1, 2].map(|n| read.body_to_world(reference::unit(n)));
        assert_same("x × y = z", &x.cross(&y), &z, CLOSE);
        let by_product = matrix_of(convention.handedness, &q.components);
        let operator = read.matrix(convention.operator());
        assert_same("S(q) by its hand", &operator, &by_product, CLOSE);
    }
}
