//! The table of libraries at its edges: matrices to quaternions, norms that are not 1, zero, slerp.

use crate::recorded::{
    SINGLE_PRECISION, assert_same_rotation, for_each, numbers, of, product_of_turns, quaternion,
    vector,
};
use crate::support::assert_close;
use quatlas::nalgebra::Matrix3;
use quatlas::{
    ComponentOrder, Convention, CosineMatrix, HalfTurns, NonUnitResult, ParsedRotation, Rotation,
    SignChoice, SlerpWay, TaggedQuaternion, ZeroResult, libraries, parse_rotation,
};
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn a_matrix_becomes_a_quaternion() {
    for_each(|library, observed, inputs| {
        let (Some(claim), Some(form), Some(printed)) = (
            library.matrix_to_quaternion,
            library.matrix,
            observed["fromMatrix"].as_array(),
        ) else {
            return;
        };
        let id = &library.id;
        let mut is_wrong = [false; 12];
        let mut scalars_are_positive = true;
        let mut largest_are_positive = true;
        for (at, given) in inputs["fromMatrixOf"]
            .as_array()
            .expect("12")
            .iter()
            .enumerate()
        {
            let given = quaternion(given).expect("a quaternion");
            let expected = match form {
                CosineMatrix::Hamilton => given,
                CosineMatrix::Shuster => given.conjugate(),
            };
            let got =
                quaternion(&printed[at]).filter(|got| got.coords.iter().all(|n| n.is_finite()));
            let sign = got.map(|got| got.coords.dot(&expected.coords).signum());
            let is_right = got
                .zip(sign)
                .is_some_and(|(got, sign)| (got - expected * sign).norm() < SINGLE_PRECISION);
            is_wrong[at] = !is_right;
            // Of half turns, q and −q both have a scalar part of 0.
            if let Some(got) = got.filter(|_| is_right && at < 7) {
                scalars_are_positive &= got.w > -SINGLE_PRECISION;
                largest_are_positive &= got.coords[got.coords.iamax()] > 0.0;
            }
        }
        assert!(
            is_wrong[..7].iter().all(|wrong| !wrong),
            "{id}: {is_wrong:?}"
        );
        // The last five are half turns.
        let half_turns = if is_wrong[7..].contains(&true) {
            HalfTurns::Wrong
        } else {
            HalfTurns::Right
        };
        assert_eq!(half_turns, claim.half_turns, "{id}");
        let sign = if scalars_are_positive {
            SignChoice::ScalarNonNegative
        } else if largest_are_positive {
            SignChoice::LargestPositive
        } else {
            SignChoice::Mixed
        };
        assert_eq!(sign, claim.sign, "{id}");
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn quaternions_that_are_not_of_norm_1() {
    for_each(|library, observed, inputs| {
        let id = &library.id;
        let a = quaternion(&inputs["a"]).expect("a");
        let v = vector(&inputs["v"]).expect("v");
        // 2a, where one that is normalised gives the unit matrix and one that is not four times it.
        let classified = |value: &Value, unit: &[f64]| {
            if value.is_string() {
                return Some(NonUnitResult::Refused);
            }
            let numbers = numbers(value)?;
            let is = |factor: f64| {
                numbers
                    .iter()
                    .zip(unit)
                    .all(|(n, u)| (n - factor * u).abs() < 1e-5 * factor)
            };
            Some(if is(1.0) {
                NonUnitResult::Normalised
            } else if is(4.0) {
                NonUnitResult::Scaled
            } else {
                NonUnitResult::Distorted
            })
        };
        if let Some(form) = library.matrix {
            let unit = of(form, &a).transpose();
            let got = classified(&observed["matrix2A"], unit.as_slice());
            assert_eq!(got, library.non_unit.matrix, "{id}: matrix");
        }
        if let Some(form) = library.rotate {
            let got = classified(&observed["rotate2AV"], (of(form, &a) * v).as_slice());
            assert_eq!(got, library.non_unit.rotate, "{id}: rotate");
        }
        let norm = &observed["norm2A"];
        let constructed = match norm.as_f64() {
            Some(norm) if (norm - 2.0).abs() < 1e-5 => Some(NonUnitResult::Kept),
            Some(norm) if (norm - 1.0).abs() < 1e-5 => Some(NonUnitResult::Normalised),
            Some(_) => Some(NonUnitResult::Changed),
            None => norm.is_string().then_some(NonUnitResult::Refused),
        };
        assert_eq!(constructed, library.non_unit.construct, "{id}: construct");
    });
}

fn zero_result(value: &Value, identity: &[f64]) -> Option<ZeroResult> {
    match value {
        Value::Null => return None,
        Value::String(_) => return Some(ZeroResult::Refused),
        _ => {}
    }
    let Some(numbers) = numbers(value) else {
        return Some(ZeroResult::Nan);
    };
    let is = |factor: f64| numbers.iter().zip(identity).all(|(n, i)| *n == factor * i);
    Some(if is(0.0) {
        ZeroResult::Zero
    } else if is(1.0) {
        ZeroResult::Identity
    } else if is(-1.0) {
        ZeroResult::MinusIdentity
    } else if numbers == [0.0, 1.0, 0.0, 0.0] {
        ZeroResult::HalfTurn
    } else {
        ZeroResult::Other
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn the_zero_quaternion() {
    for_each(|library, observed, inputs| {
        let id = &library.id;
        let one = [1.0, 0.0, 0.0, 0.0];
        let v = numbers(&inputs["v"]).expect("v");
        let unit = Matrix3::<f64>::identity();
        let kept = |result: Option<ZeroResult>| match result {
            Some(ZeroResult::Zero) => Some(ZeroResult::Kept),
            other => other,
        };
        let zero = library.zero;
        assert_eq!(
            kept(zero_result(&observed["constructed0"], &one)),
            zero.construct,
            "{id}: construct"
        );
        assert_eq!(
            zero_result(&observed["normalize0"], &one),
            zero.normalize,
            "{id}: normalize"
        );
        assert_eq!(
            zero_result(&observed["inverse0"], &one),
            zero.inverse,
            "{id}: inverse"
        );
        // A call that only raises "not implemented" is none.
        if library.rotate.is_some() {
            let rotate = zero_result(&observed["rotate0V"], &v);
            assert_eq!(rotate, zero.rotate, "{id}: rotate");
        }
        if library.matrix.is_some() {
            let matrix = zero_result(&observed["matrix0"], unit.as_slice());
            assert_eq!(matrix, zero.matrix, "{id}: matrix");
        }
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn slerp_goes_the_short_or_the_long_way() {
    for_each(|library, observed, inputs| {
        let (Some(a_to_b), Some(a_to_minus_b)) = (
            quaternion(&observed["slerpPositive"]),
            quaternion(&observed["slerpNegative"]),
        ) else {
            assert_eq!(library.slerp, None, "{}", library.id);
            return;
        };
        let rotation = |value: &Value| {
            let q = quaternion(value).expect("four numbers");
            let tagged = TaggedQuaternion {
                components: q,
                convention: Convention::HAMILTON,
            };
            Rotation::from_tagged(&tagged).expect("not zero")
        };
        let half_way = rotation(&inputs["a"])
            .slerp(&rotation(&inputs["b"]), 0.5)
            .expect("a part");
        let half_way = half_way.to_tagged(Convention::HAMILTON).components;
        assert_same_rotation(library.id, &a_to_b, &half_way);
        let dot = a_to_b.coords.dot(&a_to_minus_b.coords).abs();
        let way = if (dot - 1.0).abs() < 1e-6 {
            SlerpWay::Short
        } else {
            SlerpWay::Long
        };
        assert_eq!(Some(way), library.slerp, "{}", library.id);
    });
}

/// The parser reads some of the calls with Euler angles: it must mean what the library printed.
#[wasm_bindgen_test(unsupported = test)]
fn euler_calls_that_are_read_mean_what_was_printed() {
    let mut read = Vec::new();
    for library in libraries() {
        for call in library.euler {
            let is_in_degrees = call.call.contains("degrees");
            let angles = if is_in_degrees {
                [17.0, 28.0, 40.0]
            } else {
                [0.3, 0.5, 0.7]
            };
            let text = with_numbers(call.call.split(" in degrees").next().expect("one"), angles);
            let Ok(parsed) = parse_rotation(&text, ComponentOrder::ScalarLast) else {
                continue;
            };
            let ParsedRotation::EulerAngles(euler) = parsed else {
                panic!("{text}: {parsed:?}")
            };
            let got = Rotation::from_euler_rad(euler.sequence, euler.angles_rad).expect("finite");
            let radians = if is_in_degrees {
                angles.map(f64::to_radians)
            } else {
                angles
            };
            let expected = product_of_turns(call.means, &radians);
            let got = got.body_to_world_matrix();
            assert_close(&text, got.as_slice(), expected.as_slice(), 1e-12);
            read.push(text);
        }
    }
    assert!(read.len() > 30, "{read:#?}");
}

/// The letters a, b, c, each alone, replaced by numbers.
fn with_numbers(call: &str, angles: [f64; 3]) -> String {
    let letters: Vec<char> = call.chars().collect();
    let is_word = |at: Option<&char>| at.is_some_and(|c| c.is_alphanumeric() || *c == '_');
    let mut text = String::new();
    for (at, &letter) in letters.iter().enumerate() {
        let is_alone = !is_word(letters.get(at + 1)) && (at == 0 || !is_word(letters.get(at - 1)));
        match "abc".find(letter) {
            Some(place) if is_alone => text += &format!("{:?}", angles[place]),
            _ => text.push(letter),
        }
    }
    text
}
