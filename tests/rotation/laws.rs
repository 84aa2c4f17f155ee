//! Laws of attitudes that must hold for every input, tried on many: native only, with a fixed seed.

use crate::property::for_all;
use crate::support::all_conventions;
use proptest::prelude::*;
use quatlas::nalgebra::{Matrix3, Quaternion, Vector3};
use quatlas::{
    Convention, EulerFrame, EulerSequence, IncrementSign, MatrixConvention, Perturbation, RateAxes,
    Rotation, TaggedMatrix, TaggedQuaternion,
};

pub(crate) const CASES: u32 = 500;

/// A few dozen roundings, in radians or as entries of matrices.
pub(crate) const CLOSE: f64 = 1e-14;

/// Quaternions of any direction, neither tiny nor huge.
fn numbers() -> impl Strategy<Value = Quaternion<f64>> {
    prop::array::uniform4(-1.0..1.0_f64)
        .prop_filter("not nearly zero", |numbers| {
            numbers.iter().map(|number| number * number).sum::<f64>() > 1e-2
        })
        .prop_map(|[w, x, y, z]| Quaternion::new(w, x, y, z))
}

fn read(components: Quaternion<f64>, convention: Convention) -> Rotation {
    let q = TaggedQuaternion {
        components,
        convention,
    };
    Rotation::from_tagged(&q).expect("not zero")
}

pub(crate) fn rotation() -> impl Strategy<Value = Rotation> {
    numbers().prop_map(|q| read(q, Convention::HAMILTON))
}

/// Of less than 0.9 rad.
pub(crate) fn small_vector() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-0.5..0.5_f64)
}

fn matrix(rotation: &Rotation) -> Matrix3<f64> {
    rotation.body_to_world_matrix()
}

/// The same attitude, by the matrices.
pub(crate) fn is_same(one: &Rotation, other: &Rotation) -> Result<(), TestCaseError> {
    let difference = (matrix(one) - matrix(other)).amax();
    prop_assert!(difference <= CLOSE, "{one:?} and {other:?}: {difference:e}");
    Ok(())
}

pub(crate) fn is_near(one: f64, other: f64) -> Result<(), TestCaseError> {
    prop_assert!((one - other).abs() <= CLOSE, "{one} and {other}");
    Ok(())
}

#[test]
fn attitudes_are_a_group_and_their_matrices_too() {
    for_all(CASES, (rotation(), rotation(), rotation()), |(a, b, c)| {
        is_same(&((a * b) * c), &(a * (b * c)))?;
        is_same(&(a * Rotation::identity()), &a)?;
        is_same(&(Rotation::identity() * a), &a)?;
        is_same(&(a * a.inverse()), &Rotation::identity())?;
        is_same(&(a.inverse() * a), &Rotation::identity())?;
        is_same(&(a * b).inverse(), &(b.inverse() * a.inverse()))?;
        let difference = matrix(&(a * b)) - matrix(&a) * matrix(&b);
        prop_assert!(difference.amax() <= CLOSE, "R_WC = R_WB R_BC");
        Ok(())
    });
}

#[test]
fn q_and_its_opposite_are_one_attitude_in_every_convention() {
    for_all(CASES, (numbers(), 0.1..10.0_f64), |(q, size)| {
        for convention in all_conventions() {
            let one = read(q, convention);
            let other = read(q * -size, convention);
            is_same(&one, &other)?;
            is_near(one.angle_rad(), other.angle_rad())?;
            is_near(one.angle_to_rad(&other), 0.0)?;
        }
        Ok(())
    });
}

#[test]
fn the_operator_of_a_product_is_the_product_of_the_operators() {
    for_all(CASES, (numbers(), numbers()), |(p, q)| {
        for convention in all_conventions() {
            let of = |components| TaggedQuaternion {
                components,
                convention,
            };
            let both = of(p).product(&of(q)).expect("one convention").components;
            let operator = |q| read(q, convention).matrix(convention.operator());
            let difference = operator(both) - operator(p) * operator(q);
            prop_assert!(difference.amax() <= CLOSE, "{convention}");
        }
        Ok(())
    });
}

#[test]
fn distances_do_not_change_when_both_are_turned() {
    for_all(
        CASES,
        (rotation(), rotation(), rotation()),
        |(a, b, turn)| {
            for (one, other) in [(turn * a, turn * b), (a * turn, b * turn)] {
                is_near(one.angle_to_rad(&other), a.angle_to_rad(&b))?;
                is_near(one.chordal_distance(&other), a.chordal_distance(&b))?;
                let shorter = a.shorter_quaternion_distance(&b);
                is_near(one.shorter_quaternion_distance(&other), shorter)?;
                is_near(one.quaternion_distance(&other), a.quaternion_distance(&b))?;
            }
            Ok(())
        },
    );
}

#[test]
fn distances_are_symmetric_and_no_detour_is_shorter() {
    type Distance = fn(&Rotation, &Rotation) -> f64;
    let distances: [Distance; 4] = [
        Rotation::angle_to_rad,
        Rotation::chordal_distance,
        Rotation::quaternion_distance,
        Rotation::shorter_quaternion_distance,
    ];
    for_all(CASES, (rotation(), rotation(), rotation()), |(a, b, c)| {
        for distance in distances {
            is_near(distance(&a, &b), distance(&b, &a))?;
            is_near(distance(&a, &a), 0.0)?;
            let detour = distance(&a, &c) + distance(&c, &b);
            prop_assert!(distance(&a, &b) <= detour + CLOSE);
        }
        Ok(())
    });
}

#[test]
fn slerp_turns_with_its_ends_and_divides_the_angle() {
    for_all(
        CASES,
        (rotation(), rotation(), rotation(), 0.0..1.0_f64),
        |(a, b, turn, t)| {
            // At half a turn both ways are equally short.
            prop_assume!(a.angle_to_rad(&b) < 3.1);
            let slerp = |a: Rotation, b: Rotation, t: f64| a.slerp(&b, t).expect("a part");
            let part = slerp(a, b, t);
            is_same(&slerp(turn * a, turn * b, t), &(turn * part))?;
            is_same(&slerp(a * turn, b * turn, t), &(part * turn))?;
            is_same(&slerp(b, a, 1.0 - t), &part)?;
            is_near(a.angle_to_rad(&part), t * a.angle_to_rad(&b))?;
            is_near(part.angle_to_rad(&b), (1.0 - t) * a.angle_to_rad(&b))
        },
    );
}

/// Constant angular velocity on the whole line: between any two parts the turn is that between the
/// ends, as many times as the parts are apart.
#[test]
fn slerp_keeps_its_velocity_beyond_its_ends() {
    let line = -3.0..4.0_f64;
    for_all(
        CASES,
        (rotation(), rotation(), line.clone(), line),
        |(a, b, early, late)| {
            prop_assume!(a.angle_to_rad(&b) < 3.1);
            let at = |t: f64| a.slerp(&b, t).expect("a part");
            let velocity = a.turn_to(&b).rotation_vector_rad();
            let turn = Rotation::from_rotation_vector_rad((velocity * (late - early)).into());
            is_same(&(at(early) * turn.expect("finite")), &at(late))?;
            is_same(&b.slerp(&a, 1.0 - late).expect("a part"), &at(late))
        },
    );
}

#[test]
fn the_mean_turns_with_all_and_depends_on_no_order_or_sign() {
    let near = prop::array::uniform3(small_vector());
    for_all(
        CASES,
        (rotation(), near, rotation()),
        |(base, vectors, turn)| {
            let all = vectors.map(|v| base.turned_by_rad(v, RateAxes::Body).expect("finite"));
            let mean = Rotation::mean(&all).expect("near each other");
            let turned = Rotation::mean(&all.map(|one| turn * one)).expect("near each other");
            is_same(&turned, &(turn * mean))?;
            let turned = Rotation::mean(&all.map(|one| one * turn)).expect("near each other");
            is_same(&turned, &(mean * turn))?;
            let [a, b, c] = all;
            let opposite = read(
                -b.to_tagged(Convention::HAMILTON).components,
                Convention::HAMILTON,
            );
            is_same(&Rotation::mean(&[c, opposite, a]).expect("one"), &mean)?;
            let to_mean = all.map(|one| mean.chordal_distance(&one).powi(2));
            for v in vectors {
                // No other attitude has a smaller sum of squares.
                let other = mean.turned_by_rad(v, RateAxes::Body).expect("finite");
                let to_other = all.map(|one| other.chordal_distance(&one).powi(2));
                let (least, sum) = (to_mean.iter().sum::<f64>(), to_other.iter().sum::<f64>());
                prop_assert!(least <= sum + CLOSE, "{least} and {sum}");
            }
            Ok(())
        },
    );
}

#[test]
fn the_nearest_rotation_turns_with_the_matrix() {
    let noise = prop::array::uniform9(-0.2..0.2_f64);
    for_all(
        CASES,
        (rotation(), noise, rotation()),
        |(a, noise, turn)| {
            let nearest = |entries| {
                let matrix = TaggedMatrix {
                    entries,
                    convention: MatrixConvention::BODY_TO_WORLD,
                };
                Rotation::nearest_to_matrix(&matrix).expect("near a rotation")
            };
            let noisy = matrix(&a) + Matrix3::from_row_slice(&noise);
            let one = nearest(noisy);
            let turned = nearest(matrix(&turn) * noisy);
            is_same(&turned.rotation, &(turn * one.rotation))?;
            is_near(turned.correction, one.correction)?;
            let turned = nearest(noisy * matrix(&turn));
            is_same(&turned.rotation, &(one.rotation * turn))?;
            let transposed = nearest(noisy.transpose());
            is_same(&transposed.rotation, &one.rotation.inverse())
        },
    );
}

#[test]
fn euler_angles_in_all_24_sequences_are_the_attitude() {
    for_all(CASES, rotation(), |attitude| {
        for sequence in EulerSequence::all() {
            let angles = attitude.euler(sequence).angles_rad;
            let again = Rotation::from_euler_rad(sequence, angles).expect("finite");
            is_same(&again, &attitude)?;
            // The other frame has the reversed letters and the reversed angles.
            let letters: String = sequence.to_string().chars().rev().collect();
            let mirrored = match sequence.frame {
                EulerFrame::Intrinsic => letters.to_ascii_lowercase(),
                EulerFrame::Extrinsic => letters.to_ascii_uppercase(),
            };
            let mirrored: EulerSequence = mirrored.parse().expect("a sequence");
            let [a, b, c] = angles;
            let again = Rotation::from_euler_rad(mirrored, [c, b, a]).expect("finite");
            is_same(&again, &attitude)?;
        }
        Ok(())
    });
}

#[test]
fn plus_and_minus_undo_each_other_for_quaternions_and_matrices() {
    for_all(
        CASES,
        (rotation(), rotation(), small_vector()),
        |(a, b, delta)| {
            prop_assume!(a.angle_to_rad(&b) < 3.1);
            for sign in [IncrementSign::Physical, IncrementSign::Formal] {
                for convention in all_conventions() {
                    let (p, q) = (a.to_tagged(convention), b.to_tagged(convention));
                    let difference = q.minus(&p, sign).expect("not zero");
                    let there = p.plus(difference.into(), sign).expect("finite");
                    is_same(&Rotation::from_tagged(&there).expect("not zero"), &b)?;
                    let after = p.plus(delta, sign).expect("finite");
                    let back = after.minus(&p, sign).expect("not zero");
                    let error = (back - Vector3::from(delta)).amax();
                    prop_assert!(error <= CLOSE, "{convention}: {error:e}");
                }
                for convention in MatrixConvention::all() {
                    for axes in Perturbation::ALL {
                        let (m, n) = (
                            a.to_tagged_matrix(convention),
                            b.to_tagged_matrix(convention),
                        );
                        let difference = n.minus(&m, axes, sign).expect("rotations");
                        let there = m.plus(difference.into(), axes, sign).expect("finite");
                        let error = (there.entries - n.entries).amax();
                        prop_assert!(error <= CLOSE, "{convention} {axes}: {error:e}");
                        let after = m.plus(delta, axes, sign).expect("finite");
                        let back = after.minus(&m, axes, sign).expect("rotations");
                        let error = (back - Vector3::from(delta)).amax();
                        prop_assert!(error <= CLOSE, "{convention} {axes}: {error:e}");
                    }
                }
            }
            Ok(())
        },
    );
}
