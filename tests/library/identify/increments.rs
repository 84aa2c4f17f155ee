//! Small turns: which turn of the body an increment is, told with the quarter turn alone.

use crate::identify::identify;
use crate::simulated::{Named, hamilton};
use crate::support::{all_conventions, wxyz};
use quatlas::{
    BehaviourAxis, ComponentSign, IdentifyReport, IncrementSign, MatrixConvention, Perturbation,
    Probe, ProbeKind, Rotation, TaggedQuaternion,
};
use wasm_bindgen_test::wasm_bindgen_test;

const HALVES: Named = [0.5; 4];

/// `Exp` of a turn by 0.1 rad about x.
fn exponential() -> Named {
    let (sine, cosine) = 0.05_f64.sin_cos();
    [cosine, sine, 0.0, 0.0]
}

/// That of the turn back.
fn inverse_exponential() -> Named {
    let [w, x, y, z] = exponential();
    [w, -x, -y, -z]
}

fn named([w, x, y, z]: Named) -> String {
    format!("w: {w:?}, x: {x:?}, y: {y:?}, z: {z:?}")
}

fn perturb(printed: Named) -> Probe {
    Probe::Perturb {
        quaternion: named(HALVES),
        rotation_vector: "0.1 0 0".to_owned(),
        printed: named(printed),
    }
}

fn quarter_turn(sign: f64) -> Probe {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    Probe::QuarterTurn {
        printed: named([half, 0.0, 0.0, sign * half]),
    }
}

/// All that is settled of how the library is used.
fn of_use(report: &IdentifyReport) -> Option<(ComponentSign, Perturbation, IncrementSign)> {
    let left = &report.remaining;
    match (
        &left.attitude[..],
        &left.perturbation[..],
        &left.increment_sign[..],
    ) {
        ([attitude], [axes], [sign]) => Some((*attitude, *axes, *sign)),
        _ => None,
    }
}

/// The increment stands on the left of the numbers as they are, `T_cw ← Exp(δ) T_cw`: alone, that may be
/// the quaternion of the body turned on the world's axes.
#[wasm_bindgen_test(unsupported = test)]
fn an_increment_without_a_sign_is_told_by_the_quarter_turn() {
    let (exp, inverse) = (exponential(), inverse_exponential());
    let (canonical, conjugated) = (ComponentSign::Canonical, ComponentSign::Conjugated);
    let (local, global) = (Perturbation::Local, Perturbation::Global);
    let (physical, formal) = (IncrementSign::Physical, IncrementSign::Formal);
    for (printed, with_z, with_minus_z) in [
        (
            hamilton(exp, HALVES),
            (canonical, global, physical),
            (conjugated, local, formal),
        ),
        (
            hamilton(HALVES, exp),
            (canonical, local, physical),
            (conjugated, global, formal),
        ),
        (
            hamilton(inverse, HALVES),
            (canonical, global, formal),
            (conjugated, local, physical),
        ),
        (
            hamilton(HALVES, inverse),
            (canonical, local, formal),
            (conjugated, global, physical),
        ),
    ] {
        let alone = identify(vec![perturb(printed)]);
        let left = &alone.remaining;
        let counts = (
            left.attitude.len(),
            left.perturbation.len(),
            left.increment_sign.len(),
        );
        assert_eq!(counts, (2, 2, 2), "open together");
        assert_eq!(alone.settled, []);
        assert!(
            !alone.sentence.contains("small rotation"),
            "{}",
            alone.sentence
        );
        for (sign, expected) in [(1.0, with_z), (-1.0, with_minus_z)] {
            // In either order.
            for observations in [
                vec![perturb(printed), quarter_turn(sign)],
                vec![quarter_turn(sign), perturb(printed)],
            ] {
                let report = identify(observations);
                assert_eq!(of_use(&report), Some(expected), "{printed:?} {sign}");
                assert_eq!(report.contradiction, None);
            }
        }
    }
}

/// About its own axis a quaternion is turned alike on both sides.
#[wasm_bindgen_test(unsupported = test)]
fn a_small_turn_about_the_axis_of_the_attitude_has_a_sign_and_no_axes() {
    let report = identify(vec![
        quarter_turn(-1.0),
        Probe::Perturb {
            quaternion: "w: 1, x: 0, y: 0, z: 0".to_owned(),
            rotation_vector: "0 0 0.1".to_owned(),
            printed: "w: 0.99875, x: 0, y: 0, z: 0.04998".to_owned(),
        },
    ]);
    assert_eq!(report.remaining.increment_sign, [IncrementSign::Formal]);
    assert_eq!(report.remaining.perturbation.len(), 2);
    assert!(
        report
            .sentence
            .contains("adds small rotations with the formal sign (phi turns the body by -phi)"),
        "{}",
        report.sentence
    );
}

/// The tool's own questions: what is asked after the small turn is the quarter turn, and only then the
/// sentence says on whose axes, and which sign.
#[wasm_bindgen_test(unsupported = test)]
fn after_a_small_turn_the_quarter_turn_is_asked() {
    let text = str::to_owned;
    let mut observations = vec![
        Probe::Product {
            a: text("0 1 0 0"),
            b: text("0 0 1 0"),
            printed: text("0 0 0 1"),
        },
        Probe::Rotate {
            quaternion: text("0.5 0.5 0.5 0.5"),
            vector: text("1 2 3"),
            printed: text("3 1 2"),
        },
        Probe::Matrix {
            quaternion: text("0.5 0.5 0.5 0.5"),
            printed: text("0 0 1\n1 0 0\n0 1 0"),
            layout: quatlas::MatrixLayout::AsWritten,
        },
        // Exp(φ) q as the numbers stand.
        Probe::Perturb {
            quaternion: text("0.5 0.5 0.5 0.5"),
            rotation_vector: text("0.1 0 0"),
            printed: text("0.474385 0.524365 0.474385 0.524365"),
        },
    ];
    let report = identify(observations.clone());
    assert_eq!(report.possible, 2);
    assert_eq!(report.settled, BehaviourAxis::ALL[..5]);
    assert!(
        !report.sentence.contains("small rotation") && !report.sentence.contains("coordinates")
    );
    let next = report.next.expect("one more question");
    assert_eq!(next.probe.kind(), ProbeKind::QuarterTurn);
    assert_eq!((next.answers, next.leaves), (2, 1.0));
    let mut sentence = |printed: &str| {
        observations.truncate(4);
        observations.push(Probe::QuarterTurn {
            printed: text(printed),
        });
        let report = identify(observations.clone());
        assert_eq!((report.possible, report.next), (1, None));
        report.sentence
    };
    let common = "The library multiplies Hamilton (i*j = k), takes w x y z in its constructor, stores and \
                  prints w x y z, rotates a column vector by R(q), prints R(q) as the matrix of q (for \
                  column vectors), lets the right operand b of a*b act first, ";
    assert_eq!(
        sentence("0.7071 0 0 -0.7071"),
        format!(
            "{common}uses quaternions that take world coordinates to body coordinates and adds small \
             rotations about the axes of the body with the formal sign (phi turns the body by -phi). That is \
             Hamilton."
        )
    );
    assert_eq!(
        sentence("0.7071 0 0 0.7071"),
        format!(
            "{common}uses quaternions that take body coordinates to world coordinates and adds small \
             rotations about the axes of the world with the physical sign (phi turns the body by phi). That is \
             Hamilton."
        )
    );
}

/// What the core itself adds, in each of the 32 conventions and with both signs: by its rules, and not by
/// those of the simulated libraries (specification, FX-26, step 6).
#[wasm_bindgen_test(unsupported = test)]
fn what_every_convention_adds_is_told() {
    let yawed =
        Rotation::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).expect("an axis");
    for convention in all_conventions() {
        for sign in IncrementSign::ALL {
            let q = TaggedQuaternion::new(0.5, 0.5, 0.5, 0.5, convention);
            let by_name = |q: &TaggedQuaternion| named(wxyz(&q.components));
            let added = q.plus([0.1, 0.0, 0.0], sign).expect("finite");
            let report = identify(vec![
                Probe::Perturb {
                    quaternion: by_name(&q),
                    rotation_vector: "0.1 0 0".to_owned(),
                    printed: by_name(&added),
                },
                Probe::QuarterTurn {
                    printed: by_name(&yawed.to_tagged(convention)),
                },
            ]);
            let attitude = convention.component_sign();
            // With σ = 1 the formal sign is the physical one.
            let told = match attitude {
                ComponentSign::Canonical => IncrementSign::Physical,
                ComponentSign::Conjugated => sign,
            };
            assert_eq!(
                of_use(&report),
                Some((attitude, convention.perturbation, told)),
                "{convention:?} {sign:?}"
            );
        }
    }
}

/// A matrix of world to body that is multiplied by `Exp(δ)` turns the body by −δ, whatever the signs of
/// the quaternion beside it: the formal sign of matrices (τ = −1).
#[wasm_bindgen_test(unsupported = test)]
fn the_formal_sign_of_a_matrix_is_told_of_its_canonical_quaternion() {
    let rotation = |components: Named| {
        let [w, x, y, z] = components;
        let q = TaggedQuaternion::new(w, x, y, z, quatlas::Convention::HAMILTON);
        Rotation::from_tagged(&q).expect("not zero")
    };
    let before = rotation(HALVES).to_tagged_matrix(MatrixConvention::WORLD_TO_BODY);
    for axes in Perturbation::ALL {
        let after = before
            .plus([0.1, 0.0, 0.0], axes, IncrementSign::Formal)
            .expect("finite");
        let after = Rotation::nearest_to_matrix(&after)
            .expect("a rotation")
            .rotation;
        let printed = after.to_tagged(quatlas::Convention::HAMILTON).components;
        let report = identify(vec![perturb(wxyz(&printed)), quarter_turn(1.0)]);
        assert_eq!(
            of_use(&report),
            Some((ComponentSign::Canonical, axes, IncrementSign::Formal))
        );
    }
}

/// Two small turns that disagree, though neither settles any choice: by what one choice makes of one the
/// other, or by what is settled with the other observations.
#[wasm_bindgen_test(unsupported = test)]
fn two_small_turns_that_disagree_say_about_what() {
    let (exp, inverse) = (exponential(), inverse_exponential());
    let (attitude, axes, sign) = (
        BehaviourAxis::Attitude,
        BehaviourAxis::Perturbation,
        BehaviourAxis::IncrementSign,
    );
    let first = hamilton(exp, HALVES);
    for (second, alone, with_the_attitude) in [
        (hamilton(HALVES, exp), axes, &[axes][..]),
        (hamilton(inverse, HALVES), sign, &[sign]),
        // With the inverse of the attitude this is the same; else both others differ.
        (hamilton(HALVES, inverse), attitude, &[axes, sign]),
    ] {
        let about = |observations: Vec<Probe>| {
            let contradiction = identify(observations).contradiction;
            let contradiction = contradiction.expect("they contradict");
            assert_eq!(contradiction.observations, [0, 1]);
            contradiction.about
        };
        assert_eq!(about(vec![perturb(first), perturb(second)]), [alone]);
        assert_eq!(
            about(vec![perturb(first), perturb(second), quarter_turn(1.0)]),
            with_the_attitude
        );
        // Where the others contradict each other too, they settle nothing.
        assert_eq!(
            about(vec![
                perturb(first),
                perturb(second),
                quarter_turn(1.0),
                quarter_turn(-1.0)
            ]),
            [alone]
        );
    }
}
