//! Four numbers beside a quaternion, and nine beside any attitude: on the same axes or on others.

use super::{components, elementary, matrix_of, numbers, numbers_in, rows};
use quatlas::nalgebra::Matrix3;
use quatlas::{
    ComponentOrder, Convention, Direction, NumbersMeaning, NumbersReport, OtherAxes, Reading,
};
use wasm_bindgen_test::wasm_bindgen_test;

/// Three different angles.
fn attitude() -> Matrix3<f64> {
    elementary(2, 0.7) * elementary(1, -0.4) * elementary(0, 1.1)
}

#[track_caller]
fn only(report: &NumbersReport) -> &Reading {
    assert!(report.decides, "{report:#?}");
    &report.readings[0]
}

/// The matrix by which other axes multiply, from its text.
fn factor(axes: Option<&OtherAxes>) -> Matrix3<f64> {
    let Some(axes) = axes else {
        return Matrix3::identity();
    };
    matrix_of(axes.factor.as_deref().expect("a turn"))
}

/// R(q) of w x y z, which may have any norm.
fn matrix_of_components(q: [f64; 4]) -> Matrix3<f64> {
    let norm = q.iter().map(|number| number * number).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|number| number / norm);
    Matrix3::new(
        1.0 - 2.0 * (y * y + z * z),
        2.0 * (x * y - w * z),
        2.0 * (x * z + w * y),
        2.0 * (x * y + w * z),
        1.0 - 2.0 * (x * x + z * z),
        2.0 * (y * z - w * x),
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        1.0 - 2.0 * (x * x + y * y),
    )
}

/// 24 orders of four numbers.
fn orders() -> Vec<[usize; 4]> {
    let places = [0, 1, 2, 3];
    let mut orders = Vec::new();
    for a in places {
        for b in places {
            for c in places {
                let order = [a, b, c, 6 - (a + b + c).min(6)];
                let mut sorted = order;
                sorted.sort_unstable();
                if sorted == places {
                    orders.push(order);
                }
            }
        }
    }
    orders
}

/// All 384 rewritings, by names and by numbers: what is told of them makes them.
#[wasm_bindgen_test(unsupported = test)]
fn every_signed_permutation_of_four_numbers_is_told() {
    let orders = orders();
    assert_eq!(orders.len(), 24);
    let q = components(&attitude());
    let typed = q.map(|number| format!("{number:.6}")).join(", ");
    for order in orders {
        for signs in 0..16 {
            let sign = |at: usize| if signs >> at & 1 == 1 { -1.0 } else { 1.0 };
            let array = [0, 1, 2, 3].map(|at| sign(at) * q[order[at]]);
            let names = [0, 1, 2, 3].map(|at| {
                let minus = if sign(at) < 0.0 { "-" } else { "" };
                format!("{minus}q{}", order[at] + 1)
            });
            let by_names = numbers(&format!("({})", names.join(", ")), "");
            assert_eq!(by_names.quaternion, None);
            let of_names = only(&by_names);
            assert_eq!(of_names.text, None);
            let NumbersMeaning::Quaternion { order: told_order } = of_names.meaning else {
                panic!("{of_names:?}")
            };
            let seen = match told_order {
                ComponentOrder::ScalarFirst => array,
                ComponentOrder::ScalarLast => [array[3], array[0], array[1], array[2]],
            };
            let described = match of_names.direction {
                Direction::BodyToWorld => attitude(),
                Direction::WorldToBody => attitude().transpose(),
            };
            let made = factor(of_names.world.as_ref()) * described * factor(of_names.body.as_ref());
            assert!(
                (made - matrix_of_components(seen)).norm() < 1e-12,
                "{names:?}: {of_names:?}"
            );
            // The same by numbers; of so many some are enough.
            if (signs + order[0]) % 7 != 0 {
                continue;
            }
            let typed_too = array.map(|number| format!("{number:.6}")).join(" ");
            let by_numbers = numbers(&typed_too, &typed);
            let of_numbers = only(&by_numbers);
            assert_eq!(told(of_names), told(of_numbers), "{names:?}");
            assert_eq!(of_names.direction, of_numbers.direction);
            let back = matrix_of(of_numbers.text.as_deref().expect("of numbers"));
            assert!((back - attitude()).norm() < 1e-5, "{of_numbers:?}");
        }
    }
}

fn other(axes: &str, factor: &str) -> Option<OtherAxes> {
    Some(OtherAxes {
        axes: axes.to_owned(),
        factor: Some(factor.to_owned()),
    })
}

/// What four numbers are, and on which axes.
type Told = (NumbersMeaning, Option<OtherAxes>, Option<OtherAxes>);

fn quaternion(order: ComponentOrder, world: Option<OtherAxes>, body: Option<OtherAxes>) -> Told {
    (NumbersMeaning::Quaternion { order }, world, body)
}

fn told(reading: &Reading) -> Told {
    (
        reading.meaning.clone(),
        reading.world.clone(),
        reading.body.clone(),
    )
}

/// By hand, with Hamilton's product: i ∘ q = (−x, w, −z, y), q ∘ i = (−x, w, z, −y).
#[wasm_bindgen_test(unsupported = test)]
fn what_a_rewriting_is_has_a_name() {
    use ComponentOrder::{ScalarFirst as First, ScalarLast as Last};
    use Direction::{BodyToWorld, WorldToBody};
    let half_turn = || other("x -y -z", "180deg about [1, 0, 0]");
    for (text, meaning, direction) in [
        (
            "(q0, q1, q2, q3)",
            quaternion(First, None, None),
            BodyToWorld,
        ),
        ("-w, -x, -y, -z", quaternion(First, None, None), BodyToWorld),
        (
            "(w, -x, -y, -z)",
            quaternion(First, None, None),
            WorldToBody,
        ),
        (
            "-q.w, q.x, q.y, q.z",
            quaternion(First, None, None),
            WorldToBody,
        ),
        ("x y z w", quaternion(Last, None, None), BodyToWorld),
        (
            "[-q[1], -q[2], -q[3], q[0]]",
            quaternion(Last, None, None),
            WorldToBody,
        ),
        (
            "(-q2, q1, -q4, q3)",
            quaternion(First, half_turn(), None),
            BodyToWorld,
        ),
        (
            "(-q2, q1, q4, -q3)",
            quaternion(First, None, half_turn()),
            BodyToWorld,
        ),
        // x reversed on both sides, which is a turn of both by 180° about it.
        (
            "qw, qx, -qy, -qz",
            quaternion(
                First,
                other("-x y z", "180deg about [1, 0, 0]"),
                other("-x y z", "180deg about [1, 0, 0]"),
            ),
            BodyToWorld,
        ),
        // y and z exchanged, the hand changed on both sides: (w, −M v).
        (
            "w, -x, -z, -y",
            quaternion(
                First,
                other("x z y", "180deg about [0, 1, -1]"),
                other("x z y", "180deg about [0, 1, -1]"),
            ),
            BodyToWorld,
        ),
        // A cycle of the axes: the new x is the old y.
        (
            "w, y, z, x",
            quaternion(
                First,
                other("y z x", "120deg about [-1, -1, -1]"),
                other("y z x", "120deg about [1, 1, 1]"),
            ),
            BodyToWorld,
        ),
    ] {
        let report = numbers(text, "");
        let reading = only(&report);
        assert_eq!(
            (told(reading), reading.direction),
            (meaning, direction),
            "{text}"
        );
        assert!(reading.off_deg < 1e-9);
    }
    // Of an array with the scalar last the same places are others: w is the fourth.
    let report = numbers_in("(q1, q2, q3, q4)", "", Convention::JPL);
    assert_eq!(told(only(&report)), quaternion(Last, None, None));
    let report = numbers_in("(w, x, y, z)", "", Convention::JPL);
    assert_eq!(told(only(&report)), quaternion(First, None, None));
}

/// Names that are none of four different components are no rewriting.
#[wasm_bindgen_test(unsupported = test)]
fn other_names_are_no_rewriting() {
    for text in [
        "(q1, q1, q2, q3)",
        "(q1, q2, q3)",
        "(q0, q1, q2, q4)",
        "(w, x, y, q3)",
        "(a, b, c, d)",
        "(wx, x, y, z)",
    ] {
        let request = quatlas::NumbersRequest::new(text, "1 0 0 0", Convention::HAMILTON);
        let outcome = quatlas::analyze(&quatlas::Request::Numbers(request));
        assert!(
            matches!(outcome, quatlas::Outcome::Problems(_)),
            "{text}: {outcome:?}"
        );
    }
}

/// What a text says of its order is no question.
#[wasm_bindgen_test(unsupported = test)]
fn an_order_that_the_text_tells_counts() {
    let [w, x, y, z] = components(&attitude()).map(|number| format!("{number:.6}"));
    let typed = [&w, &x, &y, &z].map(String::as_str).join(" ");
    let named = numbers(&format!("w: {x}, x: {y}, y: {z}, z: {w}"), &typed);
    // The same four numbers without names are x y z w, and with them nothing so simple.
    let plain = numbers(&[&x, &y, &z, &w].map(String::as_str).join(" "), &typed);
    assert_eq!(
        told(only(&plain)),
        quaternion(ComponentOrder::ScalarLast, None, None)
    );
    let (meaning, world, body) = told(only(&named));
    let order = ComponentOrder::ScalarFirst;
    assert_eq!(meaning, NumbersMeaning::Quaternion { order });
    assert!(world.is_some() && body.is_some(), "{named:?}");
}

/// Nothing near: how far each plain reading is, the nearest first.
#[wasm_bindgen_test(unsupported = test)]
fn another_attitude_is_none_of_them() {
    let q = components(&(attitude() * elementary(1, 0.1)));
    let [w, x, y, z] = components(&attitude());
    let text = |q: [f64; 4]| q.map(|number| format!("{number:.6}")).join(" ");
    let report = numbers(&text(q), &text([w, x, y, z]));
    assert_eq!((report.fitting, report.readings.len()), (0, 4));
    let first = &report.readings[0];
    assert_eq!(
        told(first),
        quaternion(ComponentOrder::ScalarFirst, None, None)
    );
    assert!(
        (first.off_deg - 0.1_f64.to_degrees()).abs() < 1e-3,
        "{first:?}"
    );
}

/// Nine numbers, with the scale to four decimals.
fn matrix(scale: f64, world: Option<OtherAxes>, body: Option<OtherAxes>) -> Told {
    let scale = (scale * 1e4).round() / 1e4;
    (NumbersMeaning::Matrix { scale }, world, body)
}

fn told_of_matrix(reading: &Reading) -> Told {
    let NumbersMeaning::Matrix { scale } = reading.meaning else {
        panic!("{reading:?}")
    };
    matrix(scale, reading.world.clone(), reading.body.clone())
}

fn flipped(axes: &str) -> Option<OtherAxes> {
    Some(OtherAxes {
        axes: axes.to_owned(),
        factor: None,
    })
}

/// Transposed, scaled, reflected on one side or on both, and all at once.
#[wasm_bindgen_test(unsupported = test)]
fn what_a_matrix_is_beside_the_attitude_is_told() {
    let q = components(&attitude())
        .map(|number| format!("{number:.8}"))
        .join(" ");
    let diagonal = |x, y, z| Matrix3::from_diagonal(&quatlas::nalgebra::Vector3::new(x, y, z));
    let flip_y = diagonal(1.0, -1.0, 1.0);
    let flip_z = diagonal(1.0, 1.0, -1.0);
    let r = attitude();
    use Direction::{BodyToWorld, WorldToBody};
    let on_z = || other("x y -z", "180deg about [0, 0, 1]");
    for (seen, meaning, direction) in [
        (r, matrix(1.0, None, None), BodyToWorld),
        (r.transpose(), matrix(1.0, None, None), WorldToBody),
        (2.5 * r, matrix(2.5, None, None), BodyToWorld),
        (0.01 * r.transpose(), matrix(0.01, None, None), WorldToBody),
        // The third column, and the second row.
        (
            r * flip_z,
            matrix(1.0, None, flipped("x y -z")),
            BodyToWorld,
        ),
        (
            flip_y * r,
            matrix(1.0, flipped("x -y z"), None),
            BodyToWorld,
        ),
        (
            -3.0 * r,
            matrix(3.0, None, flipped("-x -y -z")),
            BodyToWorld,
        ),
        // Another handedness on both sides.
        (
            flip_z * r * flip_z,
            matrix(1.0, on_z(), on_z()),
            BodyToWorld,
        ),
        (
            2.0 * flip_z * r.transpose() * flip_z,
            matrix(2.0, on_z(), on_z()),
            WorldToBody,
        ),
    ] {
        let report = numbers(&rows(&seen, 8), &q);
        let reading = only(&report);
        assert_eq!(reading.direction, direction, "{seen}: {reading:?}");
        assert_eq!(told_of_matrix(reading), meaning, "{seen}");
        let back = matrix_of(reading.text.as_deref().expect("of numbers"));
        assert!((back - r).norm() < 1e-5, "{reading:?}");
    }
}

/// Nine numbers are read as they are declared: of world to body the plain reading is the transpose.
#[wasm_bindgen_test(unsupported = test)]
fn nine_numbers_are_read_as_declared() {
    let flip_z = Matrix3::from_diagonal(&quatlas::nalgebra::Vector3::new(1.0, 1.0, -1.0));
    let q = components(&attitude())
        .map(|number| format!("{number:.8}"))
        .join(" ");
    let request = quatlas::NumbersRequest {
        matrix: quatlas::MatrixConvention::WORLD_TO_BODY,
        ..quatlas::NumbersRequest::new(
            &rows(&(attitude().transpose() * flip_z), 8),
            &q,
            Convention::HAMILTON,
        )
    };
    let quatlas::Outcome::Numbers(report) = quatlas::analyze(&quatlas::Request::Numbers(request))
    else {
        panic!("read")
    };
    let reading = only(&report);
    assert_eq!(reading.direction, Direction::BodyToWorld);
    // The third column of R_BW is the third row of R_WB: of the world.
    assert_eq!(
        told_of_matrix(reading),
        matrix(1.0, flipped("x y -z"), None)
    );
}
