//! From one attitude to another.

use crate::golden::output;
use crate::support::{all_conventions, assert_close, wxyz};
use quatlas::nalgebra::{Quaternion, Vector3};
use quatlas::{
    BetweenReport, BetweenRequest, Column, Convention, EulerSequence, Field, MatrixConvention,
    MistakeKind, MotionRequest, Outcome, Perturbation, ProblemCode, RateAxes, RateBetween, Request,
    Rotation, Side, TaggedQuaternion, Verdict, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

const A: &str = "rotvec 0.4 -0.7 1.1";
const B: &str = "rotvec -0.6 0.25 0.9";

fn request(p: &str, q: &str, part: &str, convention: Convention) -> Request {
    Request::Between(BetweenRequest {
        p: p.to_owned(),
        q: q.to_owned(),
        convention,
        matrix: MatrixConvention::default(),
        euler: EulerSequence::default(),
        part: part.to_owned(),
        duration: String::new(),
    })
}

fn in_time(p: &str, q: &str, duration: &str, convention: Convention) -> Outcome {
    analyze(&Request::Between(BetweenRequest {
        p: p.to_owned(),
        q: q.to_owned(),
        convention,
        matrix: MatrixConvention::default(),
        euler: EulerSequence::default(),
        part: String::new(),
        duration: duration.to_owned(),
    }))
}

#[track_caller]
fn rate_of(p: &str, q: &str, duration: &str, convention: Convention) -> RateBetween {
    match in_time(p, q, duration, convention) {
        Outcome::Between(report) => report.rate.expect("a duration was given"),
        outcome => panic!("{outcome:?}"),
    }
}

#[track_caller]
fn ask(p: &str, q: &str, part: &str, convention: Convention) -> BetweenReport {
    match analyze(&request(p, q, part, convention)) {
        Outcome::Between(report) => *report,
        outcome => panic!("{outcome:?}"),
    }
}

fn plain(p: &str, q: &str) -> BetweenReport {
    ask(p, q, "", Convention::HAMILTON)
}

/// The attitude of a column, by its own convention.
fn attitude(column: &Column) -> Rotation {
    let numbers = TaggedQuaternion::from_array(column.unit.array, column.convention);
    Rotation::from_tagged(&numbers).expect("not zero")
}

fn exponential(vector: [f64; 3]) -> Rotation {
    Rotation::from_rotation_vector_rad(vector).expect("finite")
}

/// G27, and the answers of `reach.md` B1 computed elsewhere.
#[wasm_bindgen_test(unsupported = test)]
fn distances_and_turns_are_those_of_the_golden_case() {
    let report = plain(A, B);
    let golden = |name: &str| output("G27", name);
    let close = |what: &str, got: f64| assert_close(what, &[got], &golden(what), 4e-15);
    close("geodesic", report.local.angle_rad);
    close("geodesic", report.global.angle_rad);
    close("chordal", report.chordal_distance);
    close("quaternion", report.quaternion_distance);
    close(
        "quaternion_second_negated",
        report.negated_quaternion_distance,
    );
    let local = [-0.387_440, 1.273_941, -0.064_952];
    assert_close("local", &report.local.rotation_vector_rad, &local, 5e-7);
    let global = [-1.243_625, 0.308_960, -0.367_691];
    assert_close("global", &report.global.rotation_vector_rad, &global, 5e-7);
    let halfway = [0.860_461, -0.052_897, -0.108_373, 0.495_040];
    assert_close("half way", &report.halfway.unit.array, &halfway, 5e-7);
    assert!((report.local.angle_deg - 76.383_154).abs() < 5e-7);
    assert_eq!(report.verdict, Verdict::Different);
    assert_eq!(
        report.way.unit, report.halfway.unit,
        "half where nothing is said"
    );
}

/// −q swaps the two distances of quaternions and changes no other answer.
#[wasm_bindgen_test(unsupported = test)]
fn the_nearer_of_q_and_minus_q_is_told() {
    let report = plain("1 0 0 0", "-0.8 0 0 -0.6");
    let [near, far] = [
        report.negated_quaternion_distance,
        report.quaternion_distance,
    ];
    assert_close("‖p + q‖", &[near], &[0.4_f64.sqrt()], 1e-15);
    assert_close("‖p − q‖", &[far], &[3.6_f64.sqrt()], 1e-15);
    let other = plain("1 0 0 0", "0.8 0 0 0.6");
    assert_eq!(other.quaternion_distance, near);
    assert_eq!(other.negated_quaternion_distance, far);
    assert_eq!(
        other.local.rotation_vector_rad,
        report.local.rotation_vector_rad
    );
    assert!(attitude(&other.way).angle_to_rad(&attitude(&report.way)) < 1e-15);
}

/// Cheng 2018, eqs. 2.27 and 2.28: multiplied on its side, in its convention's product, the error leads from
/// p to q. In all 32 conventions; and the same numbers in the opposite ones.
#[wasm_bindgen_test(unsupported = test)]
fn the_error_quaternion_leads_from_p_to_q_on_its_side() {
    let (p, q) = (
        exponential([0.4, -0.7, 1.1]),
        exponential([-0.6, 0.25, 0.9]),
    );
    for convention in all_conventions() {
        let report = ask(A, B, "", convention);
        for column in [&report.declared, &report.hamilton, &report.jpl] {
            let used = column.convention;
            assert_eq!(used.perturbation, convention.perturbation);
            let error = TaggedQuaternion::from_array(column.quaternion.array, used);
            let start = p.to_tagged(used);
            let reached = match column.rules.increment {
                Side::Right => start.product(&error),
                Side::Left => error.product(&start),
            };
            let reached = reached.expect("one convention").components;
            let wanted = q.to_tagged(used).components;
            assert!((reached - wanted).norm() < 1e-15, "{used}");
        }
        assert_eq!(report.hamilton.quaternion.w, report.jpl.quaternion.w);
        assert_eq!(report.hamilton.quaternion.x, report.jpl.quaternion.x);
        assert_ne!(report.hamilton.rules.increment, report.jpl.rules.increment);
    }
}

/// The local turn is on the axes of p's body and the global one on the world's: `R_WP` carries one onto the
/// other, and the quaternions of both are products of nalgebra's.
#[wasm_bindgen_test(unsupported = test)]
fn local_and_global_are_one_turn_on_two_sets_of_axes() {
    let report = plain(A, B);
    let carried = exponential([0.4, -0.7, 1.1])
        .body_to_world(Vector3::from(report.local.rotation_vector_rad));
    assert_close(
        "R δ",
        carried.as_slice(),
        &report.global.rotation_vector_rad,
        1e-15,
    );
    let unit = |vector: [f64; 3]| {
        let half = Vector3::from(vector) / 2.0;
        Quaternion::from_parts(half.norm().cos(), half.normalize() * half.norm().sin())
    };
    let (p, q) = (unit([0.4, -0.7, 1.1]), unit([-0.6, 0.25, 0.9]));
    let local = p.conjugate() * q;
    let got = report.hamilton.quaternion;
    assert_close("p* q", &got.array, &wxyz(&local), 1e-15);
    let global = Convention {
        perturbation: Perturbation::Global,
        ..Convention::HAMILTON
    };
    let got = ask(A, B, "", global).hamilton.quaternion;
    let global = q * p.conjugate();
    assert_close("q p*", &got.array, &wxyz(&global), 1e-15);
}

/// A point of the way is one attitude in every convention, at its angle from p.
#[wasm_bindgen_test(unsupported = test)]
fn the_way_is_one_in_all_conventions() {
    let reference = attitude(&ask(A, B, "0.3", Convention::HAMILTON).way);
    let p = exponential([0.4, -0.7, 1.1]);
    for convention in all_conventions() {
        let report = ask(A, B, "3/10", convention);
        assert_eq!(report.part, 0.3);
        assert_eq!(report.way.convention, convention);
        let way = attitude(&report.way);
        assert!(way.angle_to_rad(&reference) < 1e-15, "{convention}");
        let angle = p.angle_to_rad(&way);
        assert!((angle - 0.3 * report.local.angle_rad).abs() < 1e-15);
    }
    let beyond = attitude(&ask(A, B, "-1", Convention::JPL).way);
    assert!((p.angle_to_rad(&beyond) - 1.333_137_526_359_865_5).abs() < 1e-14);
}

/// The question of the short way: the two signs of b are on the long way.
#[wasm_bindgen_test(unsupported = test)]
fn the_way_is_the_short_one() {
    let a = "0.194132737 -0.727670469 -0.560579684 -0.344323376";
    let b = "-0.267723823 0.663392496 0.560265008 0.41753739";
    let report = ask(a, b, "0.3", Convention::HAMILTON);
    let wanted = [0.216_565, -0.709_486, -0.561_365, -0.366_878];
    assert_close("slerp", &report.way.unit.array, &wanted, 1e-6);
    assert!((report.local.angle_deg - 14.0).abs() < 1e-4);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_two_texts_are_to_each_other() {
    use Verdict::{Conjugated, Different, Equal, Opposite, ScalarMoved, ScalarMovedAndConjugated};
    let rows = [
        ("0.1 -0.2 0.4 0.8888194417", "0.1 -0.2 0.4 0.8888", Equal),
        (
            "0.1 -0.2 0.4 0.8888194417",
            "-0.1 0.2 -0.4 -0.8888",
            Opposite,
        ),
        (
            "0.1 -0.2 0.4 0.8888194417",
            "0.1 0.2 -0.4 -0.8888",
            Conjugated,
        ),
        (
            "0.1 -0.2 0.4 0.8888194417",
            "-0.1 -0.2 0.4 0.8888",
            Conjugated,
        ),
        (
            "0.1 -0.2 0.4 0.8888194417",
            "-0.2 0.4 0.8888 0.1",
            ScalarMoved,
        ),
        (
            "0.1 -0.2 0.4 0.8888194417",
            "0.8888 0.1 -0.2 0.4",
            ScalarMoved,
        ),
        (
            "0.1 -0.2 0.4 0.8888194417",
            "0.2 -0.4 -0.8888 0.1",
            ScalarMovedAndConjugated,
        ),
        ("0.1 -0.2 0.4 0.8888194417", "0.1 0.2 0.4 0.8888", Different),
        // The order of an array that is named is not moved.
        (
            "w=0.1 x=-0.2 y=0.4 z=0.8888194417",
            "x=-0.2 y=0.4 z=0.8888 w=0.1",
            Equal,
        ),
        // A matrix and its transpose.
        (
            "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]",
            "[[0, 1, 0], [-1, 0, 0], [0, 0, 1]]",
            Conjugated,
        ),
        // Two triples of Euler angles of one attitude, the second with a pitch beyond 90°.
        (
            "rpy 76.41837 -8.21011 33.69479 deg",
            "rpy -103.582 -171.79 -146.305 deg",
            Equal,
        ),
        // More than half a turn is no other quaternion, where none was typed.
        ("45deg about z", "405deg about z", Equal),
        ("1 0 0 0", "1 0 0 0.001", Different),
    ];
    for (p, q, verdict) in rows {
        assert_eq!(plain(p, q).verdict, verdict, "{p} and {q}");
        assert_eq!(plain(q, p).verdict, verdict, "{q} and {p}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_angles_differ_by_the_shorter_way_round() {
    let report = plain("yaw 359 pitch 0 roll 0 deg", "yaw 1 pitch 0 roll 0 deg");
    assert_close("2°", &report.euler_differences_deg, &[2.0, 0.0, 0.0], 1e-14);
    let back = plain(
        "yaw -179 pitch 10 roll 0 deg",
        "yaw 179 pitch -10 roll 0 deg",
    );
    assert_close(
        "−2°",
        &back.euler_differences_deg,
        &[-2.0, -20.0, 0.0],
        1e-13,
    );
    assert!(report.p_euler.angles_deg[0] < 0.0);
}

/// The questions that need a difference of two attitudes.
#[wasm_bindgen_test(unsupported = test)]
fn angles_between_attitudes_answer_the_questions() {
    let apart = |p: &str, q: &str| plain(p, q).local.angle_deg;
    let two = apart(
        "rpy 76.41837 -8.21011 33.69479 deg",
        "rpy -103.582 -171.79 -146.305 deg",
    );
    assert!((two - 0.00041).abs() < 1e-4, "{two}");
    let locked = apart("rpy 60 -90 15 deg", "rpy 0 -90 75 deg");
    assert!(locked < 1e-6, "{locked}");
    let locked = apart("rpy 60 -90 15 deg", "rpy 15 -90 15 deg");
    assert!((locked - 45.0).abs() < 1e-6, "{locked}");
    let arcs = plain(
        "0.8804762392 0.1159168985 -0.2798481423 0.3647051996",
        "0.8880738340 0 -0.3250575837 0.3250575837",
    );
    assert!((arcs.local.angle_deg - 15.0).abs() < 1e-4);
}

/// The question of the rate between two attitudes: a program that forgot the half angle says half of it, and
/// is 30° short of the 60° then.
#[wasm_bindgen_test(unsupported = test)]
fn the_rate_between_two_attitudes_and_the_half_that_is_forgotten() {
    for duration in ["0.25 s", "250 ms", "0.25", "1/4 sec", " 0.25 s "] {
        let rate = rate_of("1 0 0 0", "60deg about x", duration, Convention::HAMILTON);
        assert_eq!(rate.duration_s, 0.25, "{duration}");
        assert_close("ω", &rate.body_rad, &[4.188_790, 0.0, 0.0], 1e-6);
        assert_eq!(rate.body_rad, rate.world_rad);
        let [forgotten] = rate.mistakes[..] else {
            panic!("{:?}", rate.mistakes);
        };
        assert_eq!(forgotten.kind, MistakeKind::HalfForgotten);
        assert!((forgotten.angle_deg - 30.0).abs() < 1e-13);
    }
    let back = rate_of("60deg about x", "0 0 0 1", "0.25", Convention::JPL);
    assert_close("−ω", &back.body_rad, &[-4.188_790, 0.0, 0.0], 1e-6);
    let none = rate_of(A, A, "2 min", Convention::JPL);
    assert_eq!((none.duration_s, none.body_rad), (120.0, [0.0; 3]));
    assert_eq!(none.mistakes[0].angle_deg, 0.0, "it does not show");
    assert!(plain(A, B).rate.is_none(), "nobody asked");
}

/// One body turns at one rate, whatever the quaternions are: that which Motion leads from p to q by, on
/// either axes.
#[wasm_bindgen_test(unsupported = test)]
fn all_conventions_have_one_rate_and_motion_goes_back_by_it() {
    let reference = rate_of(A, B, "0.5", Convention::HAMILTON);
    // The turns computed elsewhere, in half a second.
    let body = [-0.774_880, 2.547_882, -0.129_904];
    assert_close("body", &reference.body_rad, &body, 1e-6);
    let world = [-2.487_250, 0.617_920, -0.735_382];
    assert_close("world", &reference.world_rad, &world, 1e-6);
    for convention in all_conventions() {
        let rate = rate_of(A, B, "0.5", convention);
        assert_eq!(rate, reference, "{convention}");
        for (numbers, rate_axes) in [
            (rate.body_rad, RateAxes::Body),
            (rate.world_rad, RateAxes::World),
        ] {
            let [x, y, z] = numbers;
            let asked = Request::Motion(MotionRequest {
                rate: format!("{x} {y} {z}"),
                rate_axes,
                duration: "0.5".to_owned(),
                ..MotionRequest::new(A, convention)
            });
            let Outcome::Motion(motion) = analyze(&asked) else {
                panic!("a way");
            };
            let way = motion.path.expect("a rate and a duration");
            let [_, end @ ..] = way.ways[0][way.ways[0].len() - 1];
            let end = TaggedQuaternion::from_array(end, Convention::HAMILTON);
            let end = Rotation::from_tagged(&end).expect("not zero");
            let reached = end.angle_to_rad(&exponential([-0.6, 0.25, 0.9]));
            assert!(reached < 1e-14, "{convention} {reached}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_time_in_which_nothing_moves_is_a_problem() {
    for (duration, code) in [
        ("0", ProblemCode::OutOfBounds),
        ("-1 s", ProblemCode::OutOfBounds),
        ("1e308 h", ProblemCode::Infinite),
        ("1 2", ProblemCode::WrongCount),
    ] {
        let Outcome::Problems(found) = in_time(A, B, duration, Convention::HAMILTON) else {
            panic!("{duration}");
        };
        let [problem] = &found.problems[..] else {
            panic!("{:?}", found.problems);
        };
        assert_eq!(
            (problem.field, problem.code),
            (Field::Duration, code),
            "{duration}"
        );
    }
    // As near to each other as times may be, and as far.
    for duration in ["1e-100", "1e308"] {
        let rate = rate_of(A, B, duration, Convention::HAMILTON);
        assert!(rate.body_rad.iter().all(|number| number.is_finite()));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn each_text_that_cannot_be_read_is_a_problem() {
    let Outcome::Problems(found) = analyze(&request("x", "", "half", Convention::HAMILTON)) else {
        panic!("problems");
    };
    let fields: Vec<Field> = found.problems.iter().map(|problem| problem.field).collect();
    assert_eq!(fields, [Field::P, Field::Q, Field::Part]);
    assert_eq!(found.problems[1].code, ProblemCode::EmptyText);
    for problem in &found.problems {
        assert!(!problem.message.is_empty() && !problem.expected.is_empty());
    }
    for part in ["1e400", "nan", "1 2", " ", "1001", "-1e308"] {
        let outcome = analyze(&request(A, B, part, Convention::HAMILTON));
        assert!(matches!(outcome, Outcome::Problems(_)), "{part}");
    }
}

/// The measures are distances: of nothing 0, the same both ways, and no way round is shorter.
#[wasm_bindgen_test(unsupported = test)]
fn the_measures_are_distances() {
    let texts = [
        A,
        B,
        "1 0 0 0",
        "0.5 -0.5 0.5 0.5",
        "180deg about y",
        "0.1 0.2 0.3 -0.9",
    ];
    let measures = |p: &str, q: &str| {
        let report = plain(p, q);
        let quaternion = report
            .quaternion_distance
            .min(report.negated_quaternion_distance);
        [report.local.angle_rad, report.chordal_distance, quaternion]
    };
    for p in texts {
        assert_close("of nothing", &measures(p, p), &[0.0; 3], 1e-15);
        for q in texts {
            let there = measures(p, q);
            assert_close("both ways", &there, &measures(q, p), 1e-15);
            for r in texts {
                let (first, second) = (measures(p, r), measures(r, q));
                for at in 0..3 {
                    assert!(there[at] <= first[at] + second[at] + 1e-14, "{p} {r} {q}");
                }
            }
        }
    }
}
