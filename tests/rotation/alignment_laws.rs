//! Laws of powers, weighted means and attitudes from vectors, tried on many: native only, with a fixed seed.

use crate::laws::{CASES, CLOSE, is_near, is_same, rotation, small_vector};
use crate::property::for_all;
use proptest::prelude::*;
use quatlas::nalgebra::Vector3;
use quatlas::{RateAxes, Rotation};

#[test]
fn powers_add_and_multiply_and_turn_with_the_axis() {
    let part = -2.0..3.0_f64;
    for_all(
        CASES,
        (rotation(), rotation(), part.clone(), part),
        |(a, turn, s, t)| {
            prop_assume!(a.angle_rad() < 3.1);
            let power = |one: &Rotation, t: f64| one.power(t).expect("finite");
            is_same(&(power(&a, s) * power(&a, t)), &power(&a, s + t))?;
            is_same(&power(&a, -t), &power(&a, t).inverse())?;
            is_same(&power(&a, 3.0), &(a * a * a))?;
            let moved = turn * a * turn.inverse();
            is_same(&power(&moved, t), &(turn * power(&a, t) * turn.inverse()))?;
            let along = Rotation::identity().slerp(&a, t).expect("a part");
            is_same(&power(&a, t), &along)
        },
    );
}

#[test]
fn two_vectors_have_the_shortest_turn_between_them() {
    let vector = || prop::array::uniform3(-1.0..1.0_f64);
    for_all(
        CASES,
        (vector(), vector(), rotation(), 0.1..10.0_f64),
        |(body, world, turn, size)| {
            let (b, w) = (Vector3::from(body), Vector3::from(world));
            prop_assume!(b.norm() > 0.1 && w.norm() > 0.1 && b.angle(&w) < 3.1);
            let between = |b: Vector3<f64>, w: Vector3<f64>| {
                Rotation::from_two_vectors(b.into(), w.into()).expect("directions")
            };
            let shortest = between(b, w);
            let off = shortest.body_to_world(b.normalize()) - w.normalize();
            prop_assert!(off.amax() <= CLOSE, "{off}");
            prop_assert!(shortest.rotation_vector_rad().dot(&w).abs() <= CLOSE);
            is_same(&between(b * size, w), &shortest)?;
            is_same(&between(w, b), &shortest.inverse())?;
            let both = between(turn.body_to_world(b), turn.body_to_world(w));
            is_same(&both, &(turn * shortest * turn.inverse()))
        },
    );
}

#[test]
fn an_alignment_turns_with_its_vectors_and_none_fits_better() {
    let vectors = || prop::array::uniform4(prop::array::uniform3(-1.0..1.0_f64));
    let weights = prop::array::uniform4(0.1..3.0_f64);
    for_all(
        CASES,
        (vectors(), vectors(), weights, rotation(), small_vector()),
        |(body, noise, weights, turn, step)| {
            let turned = |one: &Rotation, all: [[f64; 3]; 4]| {
                all.map(|vector| one.body_to_world(vector.into()).into())
            };
            let fit = |body: &[[f64; 3]], world: &[[f64; 3]]| {
                Rotation::align_vectors(body, world, Some(&weights))
            };
            // An exact fit, and one with noise of a tenth.
            let world: [[f64; 3]; 4] = turned(&turn, body);
            let exact = fit(&body, &world);
            prop_assume!(exact.is_ok_and(|fit| fit.sensitivity.amax() < 10.0));
            let exact = exact.expect("one attitude");
            is_same(&exact.rotation, &turn)?;
            is_near(exact.rssd, 0.0)?;
            let noisy: [[f64; 3]; 4] = std::array::from_fn(|at| {
                (Vector3::from(world[at]) + Vector3::from(noise[at]) / 10.0).into()
            });
            let best = fit(&body, &noisy).expect("one attitude");
            let both = fit(&turned(&turn, body), &noisy).expect("one attitude");
            prop_assert!(best.rotation.angle_to_rad(&(both.rotation * turn)) <= 10.0 * CLOSE);
            let other = best
                .rotation
                .turned_by_rad(step, RateAxes::World)
                .expect("finite");
            let sum: f64 = (0..4)
                .map(|at| {
                    let seen = other.body_to_world(body[at].into());
                    weights[at] * (Vector3::from(noisy[at]) - seen).norm_squared()
                })
                .sum();
            prop_assert!(best.rssd.powi(2) <= sum + CLOSE, "{} and {sum}", best.rssd);
            Ok(())
        },
    );
}

#[test]
fn a_weighted_mean_counts_each_as_often_as_its_weight() {
    let near = prop::array::uniform3(small_vector());
    for_all(CASES, (rotation(), near), |(base, vectors)| {
        let all = vectors.map(|v| base.turned_by_rad(v, RateAxes::Body).expect("finite"));
        let mean = |weights| Rotation::mean_weighted(&all, weights).expect("near each other");
        let [a, b, c] = all;
        let often = Rotation::mean(&[a, b, b, c, c, c]).expect("near each other");
        is_same(&mean(&[0.5, 1.0, 1.5]), &often)?;
        let even = Rotation::mean(&all).expect("near each other");
        is_same(&mean(&[1.0; 3]), &even)?;
        is_same(&mean(&[0.0, 2.0, 0.0]), &b)
    });
}
