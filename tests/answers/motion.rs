//! What moves one attitude: small turns, rates and time.

use crate::golden::output;
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use quatlas::{
    Convention, Direction, Fact, Field, Function, Handedness, MistakeKind, MotionReport,
    MotionRequest, Outcome, Perturbation, ProblemCode, RateAxes, Request, Rotation, Side, analyze,
};
use wasm_bindgen_test::wasm_bindgen_test;

const ATTITUDE: &str = "rotvec 0.4 -0.7 1.1";
const RATE: &str = "0.11 -0.23 0.37";
const INCREMENT: &str = "0.02 -0.03 0.05";

fn asked(change: impl FnOnce(&mut MotionRequest)) -> MotionRequest {
    let mut request = MotionRequest::new(ATTITUDE, Convention::HAMILTON);
    change(&mut request);
    request
}

#[track_caller]
fn ask(change: impl FnOnce(&mut MotionRequest)) -> MotionReport {
    match analyze(&Request::Motion(asked(change))) {
        Outcome::Motion(report) => *report,
        outcome => panic!("{outcome:?}"),
    }
}

fn flat<const COLUMNS: usize>(rows: &[[f64; COLUMNS]]) -> Vec<f64> {
    rows.concat()
}

/// The conventions of G01 to G08.
fn golden_conventions() -> Vec<(String, Convention)> {
    let mut all = Vec::new();
    for handedness in Handedness::ALL {
        for function in Function::ALL {
            for direction in Direction::ALL {
                all.push(Convention {
                    handedness,
                    function,
                    direction,
                    ..Convention::HAMILTON
                });
            }
        }
    }
    let title = |c: &Convention| {
        let way = match c.direction {
            Direction::BodyToWorld => "B2W",
            Direction::WorldToBody => "W2B",
        };
        format!("{:?} {:?} {way}", c.handedness, c.function)
    };
    let file: serde_json::Value =
        serde_json::from_str(include_str!("../vectors/golden.json")).expect("JSON");
    let cases = file["cases"].as_array().expect("cases");
    let id = |c: &Convention| {
        let case = cases.iter().find(|case| case["title"] == *title(c));
        case.expect("a case")["id"]
            .as_str()
            .expect("an id")
            .to_owned()
    };
    all.iter().map(|c| (id(c), *c)).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn g01_to_g08_increments_and_derivatives_of_all_conventions() {
    let cases = golden_conventions();
    assert_eq!(cases.len(), 8);
    for (id, convention) in cases {
        let close = |name: &str, got: &[f64]| {
            assert_close(&format!("{id} {name}"), got, &output(&id, name), 4e-15);
        };
        for perturbation in Perturbation::ALL {
            let report = ask(|request| {
                request.convention = Convention {
                    perturbation,
                    ..convention
                };
                request.rate = RATE.to_owned();
                request.increment = INCREMENT.to_owned();
            });
            let increment = report.increment.expect("asked");
            close("q_plus_local", &increment.plus[0].quaternion.array);
            close("q_plus_global", &increment.plus[3].quaternion.array);
            // Hamilton and JPL follow with their own numbers, and the side is where δ stands.
            for (place, id) in [(1, "G01"), (2, "G06")] {
                let of = |at: usize| {
                    let q = &increment.plus[at].quaternion;
                    [q.w, q.x, q.y, q.z]
                };
                assert_close(id, &of(place), &output(id, "q_plus_local"), 4e-15);
                assert_close(id, &of(place + 3), &output(id, "q_plus_global"), 4e-15);
            }
            assert_eq!(increment.plus[0].side, convention.increment_side());
            let derivative = report.derivative.expect("asked");
            close("q_dot", &derivative.quaternions[0].quaternion.array);
            close("omega_W", &derivative.world_rad);
            let world = ask(|request| {
                request.convention = convention;
                request.rate = format!("{:?}", derivative.world_rad);
                request.rate_axes = RateAxes::World;
            });
            let by_world = &world.derivative.expect("asked").quaternions[0];
            close("q_dot", &by_world.quaternion.array);
            assert_ne!(by_world.side, derivative.quaternions[0].side);
        }
    }
}

/// Taking the increment away and adding it leads back; a formal increment is σ times the physical one.
#[wasm_bindgen_test(unsupported = test)]
fn minus_is_undone_by_plus_and_the_formal_sign_is_that_of_the_convention() {
    for convention in all_conventions() {
        let increment = |text: &str, sign| {
            let report = ask(|request| {
                request.convention = convention;
                request.increment = text.to_owned();
                request.increment_sign = sign;
            });
            report.increment.expect("asked")
        };
        let physical = increment(INCREMENT, quatlas::IncrementSign::Physical);
        let opposite = increment("-0.02 0.03 -0.05", quatlas::IncrementSign::Physical);
        for (minus, plus) in physical.minus.iter().zip(&opposite.plus) {
            assert_eq!(minus, plus, "{convention}");
        }
        let formal = increment(INCREMENT, quatlas::IncrementSign::Formal);
        let sign = f64::from(physical.plus[0].sign);
        let place = if convention.perturbation == Perturbation::Local {
            0
        } else {
            3
        };
        let expected = if sign > 0.0 { &physical } else { &opposite };
        assert_eq!(
            formal.plus[place].quaternion, expected.plus[place].quaternion,
            "{convention}"
        );
        assert_eq!(formal.body_to_world, expected.body_to_world);
        // The factor times q, or q times it, is q ⊕ δ, by the matrix of the factor.
        let start = ask(|request| request.convention = convention)
            .quaternion
            .components
            .array;
        let sided = &physical.plus[place];
        let by_matrix = sided
            .matrix
            .map(|row| (0..4).map(|at| row[at] * start[at]).sum::<f64>());
        assert_close("M q", &by_matrix, &sided.quaternion.array, 1e-15);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn g24_g26_g31_and_g33_are_in_the_report() {
    let euler = ask(|request| {
        request.quaternion = "ZYX 0.7 -0.4 1.1 rad".to_owned();
        request.rate = format!("{:?}", output("G24", "omega_B"));
    });
    let derivative = euler.derivative.expect("asked");
    assert_close(
        "G24",
        &derivative.euler_rates_rad.expect("free"),
        &[0.2, -0.5, 0.9],
        1e-14,
    );
    assert_close(
        "G24",
        &derivative.world_rad,
        &output("G24", "omega_W"),
        4e-15,
    );
    // −cos of the middle angle.
    assert_close(
        "det",
        &[derivative.euler_determinant],
        &[-(0.4_f64.cos())],
        1e-15,
    );

    let derivative = ask(|request| request.rate = RATE.to_owned())
        .derivative
        .expect("asked");
    assert_close(
        "Jr",
        &flat(&derivative.right_jacobian),
        &output("G26", "Jr"),
        4e-15,
    );
    let inverse = derivative.right_jacobian_inverse.expect("there");
    assert_close("Jr_inv", &flat(&inverse), &output("G26", "Jr_inv"), 4e-15);
    let rate = derivative.vector_rate_rad.expect("there");
    assert_close("v_dot", &rate, &output("G26", "v_dot"), 4e-15);

    let derivative = ask(|request| {
        request.quaternion = "0.8 0.2 0.4 0.4".to_owned();
        request.rate = "1 2 3".to_owned();
    })
    .derivative
    .expect("asked");
    for (place, name, start) in [
        (1, "OmegaH_q", [0.8, 0.2, 0.4, 0.4]),
        (2, "OmegaJ_q_xyzw", [0.2, 0.4, 0.4, 0.8]),
    ] {
        let omega = &derivative.quaternions[place].matrix;
        let got = omega.map(|row| (0..4).map(|at| row[at] * start[at]).sum::<f64>());
        assert_close(name, &got, &output("G31", name), 4e-15);
        let halves = derivative.quaternions[place]
            .quaternion
            .array
            .map(|number| 2.0 * number);
        assert_close(name, &halves, &output("G31", name), 4e-15);
    }

    for (perturbation, name) in Perturbation::ALL
        .into_iter()
        .zip(["R_WB_local", "R_WB_global"])
    {
        let report = ask(|request| {
            request.convention.perturbation = perturbation;
            request.increment = INCREMENT.to_owned();
        });
        let matrix = report.increment.expect("asked").body_to_world;
        assert_close(name, &flat(&matrix), &output("G33", name), 4e-15);
    }
}

fn unit([_, w, x, y, z]: [f64; 5]) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
}

/// The one step of fourth order from the identity is as far from the right end as it is told to be.
#[wasm_bindgen_test(unsupported = test)]
fn g34_the_error_of_one_step_of_fourth_order() {
    let (early, late) = (Vector3::new(0.3, -0.2, 0.5), Vector3::new(0.1, 0.4, -0.6));
    // Both rates stand at the Gauss points of a step, (½ ∓ √3/6) h.
    let middle = (early + late) / 2.0;
    let half = (late - early) * (3.0_f64.sqrt() / 2.0);
    let written = |rate: Vector3<f64>| format!("{:?}", [rate.x, rate.y, rate.z]);
    let path = ask(|request| {
        request.quaternion = "1 0 0 0".to_owned();
        request.rate = written(middle - half);
        request.rate_end = written(middle + half);
        request.duration = "100 ms".to_owned();
        request.steps = 1;
    })
    .path
    .expect("asked");
    let [w, x, y, z] = output("G34", "q_step").try_into().expect("four");
    let one_step = unit([0.0, w, x, y, z]);
    let off = one_step.angle_to(&unit(path.ways[0][1]));
    let [count, step, error, ..] = path.integrators[2][0];
    assert_eq!((count, step), (1.0, 0.1));
    assert!(
        off > 1e-9 && (error - off).abs() < 1e-14,
        "{error:e}, {off:e}"
    );
}

/// M1 of the answers that were computed elsewhere.
#[wasm_bindgen_test(unsupported = test)]
fn what_goes_wrong_with_a_small_turn() {
    let increment = ask(|request| request.increment = INCREMENT.to_owned())
        .increment
        .expect("asked");
    let angle = |kind| {
        let found = increment
            .mistakes
            .iter()
            .find(|mistake| mistake.kind == kind);
        found.expect("told").angle_deg
    };
    assert!((angle(MistakeKind::OtherSide) - 0.18).abs() < 0.005);
    assert!((angle(MistakeKind::OtherSign) - 7.06).abs() < 0.005);
    let size = Vector3::new(0.02_f64, -0.03, 0.05).norm().to_degrees();
    assert!((angle(MistakeKind::HalfForgotten) - size).abs() < 1e-12);
    // [1, δ/2] is off by 4.75e-4, and as a turn by |δ|³/12.
    let [quaternion, matrix, turn] = increment.small_angle_off;
    assert!((quaternion - 4.75e-4).abs() < 5e-7, "{quaternion}");
    assert!(
        (turn - size.to_radians().powi(3) / 12.0).abs() < 2e-8,
        "{turn}"
    );
    let exact = Rotation::from_rotation_vector_rad([0.02, -0.03, 0.05]).expect("finite");
    let small = Matrix3::from_row_slice(&flat(&increment.small_angle_matrix));
    assert!((matrix - (exact.body_to_world_matrix() - small).norm()).abs() < 1e-15);
    assert_eq!(
        increment.small_angle_quaternion.array,
        [1.0, 0.01, -0.015, 0.025]
    );
    assert_close(
        "δq",
        &increment.plus[0].factor.array,
        &[0.999_525_038, 0.009_998_417, -0.014_997_625, 0.024_996_042],
        1e-9,
    );
}

fn ten_seconds(request: &mut MotionRequest) {
    request.rate = RATE.to_owned();
    request.duration = "10 s".to_owned();
    request.steps = 10;
}

fn changing(request: &mut MotionRequest) {
    request.rate = "0.3 -0.2 0.5".to_owned();
    request.rate_end = "0.1 0.4 -0.6 rad/s".to_owned();
    request.duration = "2".to_owned();
    request.steps = 10;
}

/// M3 of the answers that were computed elsewhere.
#[wasm_bindgen_test(unsupported = test)]
fn a_path_over_ten_seconds_and_what_goes_wrong() {
    let path = ask(ten_seconds).path.expect("asked");
    assert_eq!(path.ways[0].len(), 11);
    assert_eq!(path.ways[0][3][0], 3.0);
    assert_close(
        "end",
        &path.turn.rotation_vector_rad,
        &[-0.056_082, 0.260_684, -0.340_053],
        1e-6,
    );
    let angles: Vec<_> = path
        .mistakes
        .iter()
        .map(|mistake| mistake.angle_deg)
        .collect();
    assert!(
        (angles[0] - 5.787).abs() < 5e-4 && (angles[1] - 154.897).abs() < 6e-4,
        "{angles:?}"
    );
    // The ways end as far apart as is told.
    let end = |way: &Vec<[f64; 5]>| unit(*way.last().expect("moments"));
    for (way, mistake) in path.ways[1..].iter().zip(&path.mistakes) {
        let off = end(way).angle_to(&end(&path.ways[0])).to_degrees();
        assert!((off - mistake.angle_deg).abs() < 1e-12, "{mistake:?}");
    }
    // A constant rate is one turn for the first three; q + h q̇ is off.
    for exact in &path.integrators[..3] {
        assert!(
            exact.iter().all(|row| row[2] == 0.0 && row[4] == 0.0),
            "{exact:?}"
        );
    }
    let added = &path.integrators[3];
    let row = added
        .iter()
        .find(|row| row[0] == 10.0)
        .expect("the asked steps");
    assert!((row[2].to_degrees() - 4.205).abs() < 5e-4, "{row:?}");
    assert!(
        (row[3] - ((1.0 + 0.25 * Vector3::new(0.11_f64, -0.23, 0.37).norm_squared()).sqrt() - 1.0))
            .abs()
            < 1e-15
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn steps_have_the_orders_that_they_have() {
    for axes in [RateAxes::Body, RateAxes::World] {
        let path = ask(|request| {
            changing(request);
            request.rate_axes = axes;
        })
        .path
        .expect("asked");
        // Adding and normalising has the second order for a rate that does not change, and the first here.
        let orders = [1.0, 2.0, 4.0, 1.0, 4.0, 4.0, 4.0];
        for (rows, order) in path.integrators.iter().zip(orders) {
            let shown = rows
                .iter()
                .rev()
                .find(|row| row[4] != 0.0)
                .expect("an order");
            assert!((shown[4] - order).abs() < 0.1, "{order}: {rows:?}");
        }
        if axes == RateAxes::Body {
            let error = |kind: usize, count: f64| {
                let mut rows = path.integrators[kind].iter();
                rows.find(|row| row[0] == count).expect("so many steps")[2]
            };
            for (kind, ten, twenty) in [
                (0, 1.26e-1, 6.29e-2),
                (1, 9.24e-4, 2.31e-4),
                (2, 1.18e-6, 7.37e-8),
            ] {
                assert!((error(kind, 10.0) / ten - 1.0).abs() < 5e-3);
                assert!((error(kind, 20.0) / twenty - 1.0).abs() < 5e-3);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn all_conventions_have_one_path_and_one_angle() {
    let of = |convention: Convention, increment: bool| {
        let report = ask(|request| {
            changing(request);
            request.steps = 2;
            request.convention = convention;
            if increment {
                request.increment = INCREMENT.to_owned();
            }
        });
        (report.path.expect("asked"), report.increment)
    };
    let (expected, _) = of(Convention::HAMILTON, false);
    for convention in all_conventions() {
        let (path, increment) = of(convention, true);
        assert_eq!(path.ways, expected.ways, "{convention}");
        assert_eq!(path.mistakes, expected.mistakes, "{convention}");
        assert_eq!(path.integrators, expected.integrators, "{convention}");
        // The end is told in the declared convention.
        let tagged = quatlas::TaggedQuaternion::from_array(path.end.array, convention);
        let end = Rotation::from_tagged(&tagged).expect("not zero");
        let vector: [f64; 3] = end.rotation_vector_rad().into();
        assert_close("end", &vector, &path.turn.rotation_vector_rad, 1e-15);
        let same = Convention {
            perturbation: convention.perturbation,
            ..Convention::HAMILTON
        };
        let (_, of_hamilton) = of(same, true);
        assert_eq!(
            increment.expect("asked").mistakes,
            of_hamilton.expect("asked").mistakes
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_mistake_that_does_not_show_has_the_angle_0() {
    for (attitude, rate) in [
        ("axis-angle 0.36 0.48 0.8 50 deg", "0.72 0.96 1.6"),
        ("0.3 0.5 -0.2 0.7", "0 0 0"),
        ("1 0 0 0", "0.3 0.1 -0.2"),
    ] {
        let report = ask(|request| {
            request.quaternion = attitude.to_owned();
            request.rate = rate.to_owned();
            request.increment = rate.to_owned();
            request.duration = "90".to_owned();
            request.steps = 240;
        });
        let path = report.path.expect("asked");
        assert_eq!(path.mistakes[0].angle_deg, 0.0, "{attitude}");
        assert_eq!(
            report.increment.expect("asked").mistakes[0].angle_deg,
            0.0,
            "{attitude}"
        );
        for mistake in &path.mistakes[1..] {
            assert_eq!(mistake.angle_deg == 0.0, rate == "0 0 0", "{mistake:?}");
        }
    }
    // A changing rate about the axis of the attitude, too.
    let path = ask(|request| {
        request.quaternion = "rotvec 0.1 0.2 -0.2".to_owned();
        request.rate = "1 2 -2".to_owned();
        request.rate_end = "-3 -6 6".to_owned();
        request.duration = "30".to_owned();
    })
    .path
    .expect("asked");
    assert_eq!(path.mistakes[0].angle_deg, 0.0);
}

/// M4: the yaw rate grows beyond all bounds towards gimbal lock, where there is none.
#[wasm_bindgen_test(unsupported = test)]
fn gimbal_lock_as_a_rate() {
    let at = |pitch: &str| {
        let report = ask(|request| {
            request.quaternion = format!("ZYX 0.2 {pitch} 1.1 rad");
            request.rate = "0 0.1 0.1".to_owned();
            request.duration = "1".to_owned();
        });
        (
            report.derivative.expect("asked"),
            report.path.expect("asked"),
        )
    };
    for (pitch, rate) in [
        ("0", 0.1345),
        ("pi/3", 0.2690),
        ("89*pi/180", 7.71),
        ("89.9*pi/180", 77.1),
    ] {
        let yaw = at(pitch).0.euler_rates_rad.expect("free")[0];
        assert!((yaw / rate - 1.0).abs() < 1e-3, "{pitch}: {yaw}");
    }
    let (locked, path) = at("pi/2");
    assert_eq!(locked.euler_rates_rad, None);
    assert!(locked.euler_determinant.abs() < 1e-7);
    assert!(locked.euler.gimbal_lock.is_some());
    assert!(
        path.integrators[5].is_empty(),
        "angles have no derivative there"
    );
    assert!(!path.integrators[6].is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_rotation_vector_of_a_whole_turn_has_no_rate() {
    let derivative = ask(|request| {
        request.quaternion = "rotvec 0 0 2pi".to_owned();
        request.rate = RATE.to_owned();
    })
    .derivative
    .expect("asked");
    assert_eq!(
        (
            derivative.vector_rate_rad,
            derivative.right_jacobian_inverse
        ),
        (None, None)
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn units_are_read_and_without_one_large_numbers_are_asked() {
    let body = |rate: &str| {
        let report = ask(|request| request.rate = rate.to_owned());
        (report.derivative.expect("asked").body_rad, report.notes)
    };
    for text in [
        "60 -30 0 deg/s",
        "10 -5 0 rpm",
        "[pi/3, -pi/6, 0] rad/s",
        "60, -30, 0 °/s ",
        "10 -5 0 RPM",
    ] {
        let (rate, notes) = body(text);
        let third = std::f64::consts::FRAC_PI_3;
        assert_close(text, &rate, &[third, -third / 2.0, 0.0], 1e-15);
        assert!(notes.is_empty(), "{text}: {notes:?}");
    }
    let (_, notes) = body("10 -5 2");
    let Fact::AngleUnitAssumed(unit) = &notes[0].fact else {
        panic!("{notes:?}")
    };
    assert_eq!(
        (notes[0].field, unit.in_degrees.as_deref()),
        (Field::Rate, Some("10 -5 2 deg/s"))
    );
    assert!(
        body(unit.in_radians.as_deref().expect("a text"))
            .1
            .is_empty()
    );
    for (text, seconds) in [
        ("1500 ms", 1.5),
        ("1.5", 1.5),
        ("0.025 min", 1.5),
        ("3/2 s", 1.5),
        ("0.01 h", 36.0),
    ] {
        let path = ask(|request| {
            request.rate = RATE.to_owned();
            request.duration = text.to_owned();
            request.steps = 1;
        })
        .path
        .expect("asked");
        assert_close(text, &[path.ways[0][1][0]], &[seconds], 1e-15);
    }
    let turn = ask(|request| request.increment = "3 0 -4 deg".to_owned())
        .increment
        .expect("asked");
    assert_close(
        "deg",
        &turn.body_rad,
        &[3_f64.to_radians(), 0.0, -(4_f64.to_radians())],
        1e-15,
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn what_cannot_be_answered_is_a_problem_of_its_text() {
    type Change = fn(&mut MotionRequest);
    let cases: [(Change, Field, ProblemCode); 9] = [
        (
            |asked| asked.duration = "0 s".to_owned(),
            Field::Duration,
            ProblemCode::OutOfBounds,
        ),
        (
            |asked| asked.duration = "-2".to_owned(),
            Field::Duration,
            ProblemCode::OutOfBounds,
        ),
        (
            |asked| asked.duration = "3 h".to_owned(),
            Field::Duration,
            ProblemCode::OutOfBounds,
        ),
        (
            |asked| asked.duration = "soon".to_owned(),
            Field::Duration,
            ProblemCode::UnknownWord,
        ),
        (
            |asked| asked.rate = "1 2".to_owned(),
            Field::Rate,
            ProblemCode::WrongCount,
        ),
        (
            |asked| asked.rate = "1e10 0 0".to_owned(),
            Field::Rate,
            ProblemCode::OutOfBounds,
        ),
        (
            |asked| asked.rate_end = "fast".to_owned(),
            Field::RateEnd,
            ProblemCode::UnknownWord,
        ),
        (
            |asked| asked.increment = "1 2 3 4 deg".to_owned(),
            Field::Increment,
            ProblemCode::WrongCount,
        ),
        (
            |asked| asked.quaternion = "0 0 0 0".to_owned(),
            Field::Quaternion,
            ProblemCode::ZeroQuaternion,
        ),
    ];
    for (change, field, code) in cases {
        let request = asked(|request| {
            changing(request);
            change(request);
        });
        let Outcome::Problems(found) = analyze(&Request::Motion(request)) else {
            panic!("{field:?} {code:?}")
        };
        let problem = &found.problems[0];
        assert_eq!((problem.field, problem.code), (field, code), "{problem:?}");
        assert!(
            !problem.message.is_empty() && !problem.expected.is_empty() && !problem.hint.is_empty()
        );
        assert!(problem.span.end > problem.span.start);
    }
}

/// Nothing that is not asked is answered, and no number is NaN, infinite or −0, whatever is.
#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_asked_is_absent_and_every_number_is_plain() {
    let nothing = ask(|_| ());
    assert!(nothing.increment.is_none() && nothing.derivative.is_none() && nothing.path.is_none());
    assert!(
        ask(|request| request.duration = "1".to_owned())
            .path
            .is_none()
    );
    for (attitude, rate, end, duration) in [
        ("1e300 0 0 -1e300", "1e9 -1e9 1e9", "-1e9 1e9 1e9", "1e-8"),
        ("rotvec 1e200 0 0", "1e-300 0 0", "", "1e-99"),
        ("ZYX 0 pi/2 0 rad", "0 0 0", "5e-324 0 0", "1e300"),
        ("0 1 0 0", "-1 -1 -1", "1 1 1", "300"),
    ] {
        let report = ask(|request| {
            request.quaternion = attitude.to_owned();
            request.rate = rate.to_owned();
            request.rate_end = end.to_owned();
            request.duration = duration.to_owned();
            request.increment = rate.to_owned();
            request.steps = 7;
        });
        let json = serde_json::to_string(&report).expect("JSON");
        assert!(
            !json.contains("-0.0,") && !json.contains("-0.0]"),
            "{attitude}: {json}"
        );
        // What is not finite is null in JSON, and then no number.
        let read: MotionReport = serde_json::from_str(&json).expect("numbers");
        assert_eq!(read, report, "{attitude}");
    }
    assert_eq!(
        ask(ten_seconds).derivative.expect("asked").quaternions[0].side,
        Side::Right
    );
}
