//! Lines of code at both ends: what one end writes, it reads, and problems stand where they were typed.

use super::{TEXT, answer, between, end, problems, translate, with_quaternions};
use crate::support::assert_close;
use quatlas::{
    ComponentOrder, Direction, Endpoint, Fact, Field, Outcome, Problem, ProblemCode, Request, Span,
    TranslateRequest, analyze, libraries, library,
};
use wasm_bindgen_test::wasm_bindgen_test;

const NUMBERS: [f64; 4] = [0.1, 0.7, -0.5, 0.5];

fn problems_at(text: &str, from: &str) -> Vec<Problem> {
    let [from, to] = [from, "openvins"].map(Endpoint::library);
    problems(TranslateRequest::new(text, from, to))
}

/// With an order and a direction of its own, too.
#[wasm_bindgen_test(unsupported = test)]
fn every_end_reads_the_line_that_it_writes() {
    let partner = Endpoint::library("openvins");
    let orders = [
        None,
        Some(ComponentOrder::ScalarFirst),
        Some(ComponentOrder::ScalarLast),
    ];
    let directions = [
        None,
        Some(Direction::BodyToWorld),
        Some(Direction::WorldToBody),
    ];
    let mut checked = 0;
    for library in with_quaternions() {
        for order in orders {
            for direction in directions {
                let here = end(library.id, order, direction);
                let there = translate("0.1 0.7 -0.5 0.5", &partner, &here).to;
                let line = there.construct.clone().expect("every record has a line");
                let back = translate(&line, &here, &partner);
                let what = format!("{line} at {here:?}");
                assert_eq!(back.from.array, there.array, "{what}");
                assert_close(&what, &back.to.array, &NUMBERS, 1e-15);
                // Shown as what was pasted, it is the same line.
                assert_eq!(back.from.construct.as_deref(), Some(&*line), "{what}");
                checked += 1;
            }
        }
    }
    assert!(checked > 700, "{checked}");
}

/// A constructor keeps the order that it takes; an array that stands alone has that of the end.
#[wasm_bindgen_test(unsupported = test)]
fn a_line_that_is_nothing_but_an_array_has_the_order_of_its_end() {
    let line = |id: &str, order| {
        let here = end(id, Some(order), None);
        let report = translate("0.1 0.7 -0.5 0.5", &Endpoint::library("tf2"), &here);
        report.to.construct.expect("a line")
    };
    let (first, last) = (ComponentOrder::ScalarFirst, ComponentOrder::ScalarLast);
    assert_eq!(line("mujoco", first), "q = np.array([0.5, 0.1, 0.7, -0.5])");
    assert_eq!(line("mujoco", last), "q = np.array([0.1, 0.7, -0.5, 0.5])");
    assert_eq!(
        line("tf-transformations", first),
        "q = [0.5, 0.1, 0.7, -0.5]"
    );
    for order in [first, last] {
        assert_eq!(
            line("eigen", order),
            "Eigen::Quaterniond q(0.5, 0.1, 0.7, -0.5);"
        );
        assert_eq!(line("drake", order), "q = Quaternion(0.5, 0.1, 0.7, -0.5)");
    }
}

/// With a point or an exponent, and no digit more than it takes, in the wasm as natively.
#[wasm_bindgen_test(unsupported = test)]
fn numbers_of_a_line_are_written_as_doubles() {
    let written = [
        ("0", "0.0"),
        ("1", "1.0"),
        ("-20", "-20.0"),
        ("0.1", "0.1"),
        ("0.30000000000000004", "0.30000000000000004"),
        ("0.0001", "0.0001"),
        ("0.00009999999999999999", "9.999999999999999e-5"),
        ("-0.00001", "-1e-5"),
        ("1.5e-7", "1.5e-7"),
        ("123456789012345.6", "123456789012345.6"),
        ("9999999999999998", "9999999999999998.0"),
        ("1e16", "1e16"),
        ("-1234567890123456789012", "-1.2345678901234568e21"),
        ("2.5e200", "2.5e200"),
    ];
    for (number, expected) in written {
        let text = format!("qw: 1, qx: {number}, qy: 0, qz: 1");
        let line = between(&text, "eigen", "eigen").to.construct;
        let expected = format!("Eigen::Quaterniond q(1.0, {expected}, 0.0, 1.0);");
        assert_eq!(line, Some(expected));
    }
}

fn marked(text: &str, from: &str) -> (ProblemCode, String) {
    let [problem] = &problems_at(text, from)[..] else {
        panic!("{text}: one problem is expected")
    };
    assert_eq!(problem.field, Field::Quaternion);
    let place = text.get(problem.span.start..problem.span.end);
    let place = place.unwrap_or_else(|| panic!("{:?} is no place of {text}", problem.span));
    (problem.code, place.to_owned())
}

/// In a line that only its own library reads, at the number that is meant, whatever the spaces.
#[wasm_bindgen_test(unsupported = test)]
fn problems_of_a_line_stand_where_they_were_typed() {
    let lines = [
        ("ahrs", "q = ahrs.Quaternion([{}, 0, 0, 0])"),
        ("drake", "  q  =  Quaternion( {} , 0,\n 0, 0 )"),
        ("anise", "q = Quaternion(0, 0, {}, 0, from_id, to_id)"),
        ("navpy", "🙂, qvec = {}, np.array([0, 0, 0])"),
        (
            "mavlink",
            "ATTITUDE_QUATERNION {q1: 0, q2: 0, q3: {}, q4: 1}",
        ),
        ("unity", "var q = new Quaternion(0f, 0f, 0f, {}f);"),
        ("eigen", "Eigen::Quaterniond q({}, 0, 0, 0);"),
        (
            "apple-simd",
            "let q = simd_quatf(ix: 0, iy: {}, iz: 0, r: 1)",
        ),
    ];
    let long = format!("1{}", "0".repeat(400));
    for (id, line) in lines {
        for (number, code) in [
            ("1e999", ProblemCode::TooLarge),
            (&*long, ProblemCode::TooLarge),
            ("-1e-999", ProblemCode::TooSmall),
        ] {
            let text = line.replace("{}", number);
            let (found, place) = marked(&text, id);
            assert_eq!(found, code, "{text}");
            assert_eq!(
                place.trim_start_matches('-'),
                number.trim_start_matches('-'),
                "{text}"
            );
        }
        // All four are zero: the whole line is at fault.
        let text = line
            .replace("{}", "0")
            .replace(": 1}", ": 0}")
            .replace("r: 1)", "r: 0)");
        assert_eq!(
            marked(&text, id),
            (ProblemCode::ZeroQuaternion, text.trim().to_owned())
        );
    }
}

/// What is offered instead is a line like the one that was typed.
#[wasm_bindgen_test(unsupported = test)]
fn a_suggestion_for_a_line_is_a_line() {
    let text = "q =  Quaternion( 0.5, 1e-999, 0.5, 0.5 )";
    let [problem] = &problems_at(text, "drake")[..] else {
        panic!("one problem")
    };
    let suggestion = problem.suggestion.clone().expect("a zero");
    assert_eq!(suggestion.text, "q =  Quaternion( 0.5, 0, 0.5, 0.5 )");
    assert!(!between(&suggestion.text, "drake", "tf2").from.array[1].is_sign_negative());
    // Where the rotation of no turn is offered, it is that in the line, too.
    let [problem] = &problems_at("q = Quaternion(0, 0, 0, 0)", "drake")[..] else {
        panic!("one problem")
    };
    if let Some(suggestion) = &problem.suggestion {
        let read = between(&suggestion.text, "drake", "tf2");
        assert_eq!(read.from.array, [1.0, 0.0, 0.0, 0.0]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn two_numbers_with_a_space_between_are_not_one() {
    for (id, text) in [
        ("drake", "q = Quaternion(1 0, 0, 0, 0)"),
        ("anise", "q = Quaternion(0, 1 0, 0, 0, from_id, to_id)"),
        ("eigen", "Eigen::Quaterniond q(0. 5, 0, 0, 0);"),
    ] {
        problems_at(text, id);
    }
}

/// Also where its own line would be read whatever the spaces.
#[wasm_bindgen_test(unsupported = test)]
fn a_text_that_is_too_long_is_nobodys_line() {
    let text = format!("q = Quaternion(0.5,{} 0.5, 0.5, 0.5)", " ".repeat(140_000));
    assert_eq!(
        marked(&text, "drake"),
        (ProblemCode::TextTooLong, text.clone())
    );
    let ends = ["drake", "tf2"].map(Endpoint::library);
    let [from, to] = ends;
    let axes = format!("{}y x -z", " ".repeat(140_000));
    let request = TranslateRequest {
        world_axes: axes.clone(),
        ..TranslateRequest::new("1 0 0 0", from, to)
    };
    let Outcome::Problems(found) = analyze(&Request::Translate(request)) else {
        panic!("the axes are too long")
    };
    let [problem] = &found.problems[..] else {
        panic!("one problem")
    };
    assert_eq!(
        (problem.code, problem.field),
        (ProblemCode::TextTooLong, Field::WorldAxes)
    );
    // All of it: of so long a text not even the spaces are looked at.
    assert_eq!(problem.span, Span::from(0..axes.len()));
}

/// The line and the order are those of the library whose call was pasted, not of the one that was chosen.
#[wasm_bindgen_test(unsupported = test)]
fn a_pasted_call_is_read_as_its_own_library_does() {
    // Both write a Quaternion; that of UnityQuaternion takes the scalar last, that of drake first.
    let text = "from UnityQuaternion import Quaternion; q = Quaternion(0, 0, 0.6, 0.8)";
    let own = between("0 0 0.6 0.8", "unityquaternionpy", "tf2");
    assert_eq!(own.to.array, [0.0, 0.0, 0.6, 0.8]);
    let report = between(text, "drake", "tf2");
    assert_eq!(report.proposed.as_deref(), Some("unityquaternionpy"));
    assert_eq!(report.to.array, [0.0, 0.0, 0.6, 0.8]);
    // A call whose order is not known here: that of the constructor of the pasted library counts.
    let call = "manif::SO3d(Quaternion(0, 0, 0.6, 0.8))";
    assert_eq!(
        library("manif").expect("a record").constructor_order,
        Some(ComponentOrder::ScalarLast)
    );
    let report = between(call, "drake", "tf2");
    assert_eq!(report.proposed.as_deref(), Some("manif"));
    assert_eq!(report.to.array, [0.0, 0.0, 0.6, 0.8]);
}

/// So the place of a fragment in a text tells the library, and no length has to.
#[wasm_bindgen_test(unsupported = test)]
fn no_fragment_of_a_library_begins_that_of_another() {
    let compact = |text: &str| text.split_whitespace().collect::<String>();
    for one in libraries() {
        for other in libraries().iter().filter(|other| other.id != one.id) {
            for (long, short) in one
                .pasted
                .iter()
                .flat_map(|long| other.pasted.iter().map(move |short| (long, short)))
            {
                let begins = compact(long).starts_with(&compact(short));
                assert!(!begins, "{long} of {} and {short} of {}", one.id, other.id);
            }
        }
    }
    // Where several stand in a text, the first counts.
    let first = between(
        "tf2::Quaternion q(0, 0, 0.6, 0.8); // Sophus::SO3",
        "eigen",
        "three",
    );
    assert_eq!(first.proposed.as_deref(), Some("tf2"));
    let first = between(
        "Sophus::SO3d q(tf2::Quaternion(0, 0, 0.6, 0.8));",
        "eigen",
        "three",
    );
    assert_eq!(first.proposed.as_deref(), Some("sophus"));
}

/// A convention is no library, so any library is proposed beside it.
#[wasm_bindgen_test(unsupported = test)]
fn a_library_is_proposed_for_a_convention_too() {
    let text = "Eigen::Quaterniond q(0.8, 0, 0, 0.6);";
    let hamilton = Endpoint::convention(quatlas::Convention::HAMILTON);
    let report = translate(text, &hamilton, &Endpoint::library("tf2"));
    assert_eq!(report.proposed.as_deref(), Some("eigen"));
    let plain = translate("0.8 0 0 0.6", &hamilton, &Endpoint::library("tf2"));
    assert_eq!(plain.proposed, None);
}

/// Of the call that rotates and the one that makes the matrix, the first is shown where there is one.
#[wasm_bindgen_test(unsupported = test)]
fn the_usual_call_rotates_a_vector() {
    let mut seen = [0, 0, 0];
    for library in libraries() {
        let usual = between("0.1 0.7 -0.5 0.5", "openvins", library.id).to.usual;
        let (rotate, matrix) = (library.code.rotate, library.code.matrix);
        assert_eq!(usual.as_deref(), rotate.or(matrix), "{}", library.id);
        seen[usize::from(rotate.is_some()) + usize::from(rotate.is_some() && matrix.is_some())] +=
            1;
    }
    assert!(seen[2] > 0, "some have both: {seen:?}");
}

/// Lists of lists may be columns where the language stores them so; rows on lines of their own are rows.
#[wasm_bindgen_test(unsupported = test)]
fn only_lists_of_lists_may_be_columns() {
    let says_so = |text: &str, from: &str| {
        let notes = between(text, from, "scipy").notes;
        let mut facts = notes.iter().map(|note| &note.fact);
        facts.any(|fact| matches!(fact, Fact::RowsAssumed(_)))
    };
    let lists = "[[0, 0.8, -0.6], [-0.6, 0.48, 0.64], [0.8, 0.36, 0.48]]";
    let lines = "0 0.8 -0.6\n-0.6 0.48 0.64\n0.8 0.36 0.48";
    for (id, stores_columns) in [
        ("cglm", true),
        ("nasa-42", true),
        ("eigen", true),
        ("nalgebra", true),
        ("scipy", false),
        ("three", false),
        ("orekit", false),
        ("matlab-aerospace", false),
    ] {
        assert_eq!(says_so(lists, id), stores_columns, "{id}");
        assert!(!says_so(lines, id), "{id}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_pasted_call_proposes_its_library() {
    let proposed = |text, from| between(text, from, "scipy").proposed;
    let eigen = "Eigen::Quaterniond q(0.8, 0, 0, 0.6);";
    assert_eq!(proposed(eigen, "three").as_deref(), Some("eigen"));
    assert_eq!(proposed(eigen, "eigen"), None);
    assert_eq!(
        proposed("new THREE.Quaternion(0, 0, 0.6, 0.8)", "eigen").as_deref(),
        Some("three")
    );
    assert_eq!(proposed("0 0 0.6 0.8", "eigen"), None);
    let matrix = "Rotation.from_matrix([[0, -0.6, 0.8], [0.8, 0.48, 0.36], [-0.6, 0.64, 0.48]])";
    let from_babylon = between(matrix, "babylon", "three");
    assert_eq!(from_babylon.proposed.as_deref(), Some("scipy"));
    // The call tells its order, whatever the end is.
    let report = between(eigen, "three", "three");
    assert_eq!(report.to.array, [0.0, 0.0, 0.6, 0.8]);
    assert!(
        report
            .notes
            .iter()
            .any(|note| matches!(note.fact, Fact::OrderFromText(_)))
    );
}

/// nalgebra's `{:?}` and glam's print columns in lists of lists.
#[wasm_bindgen_test(unsupported = test)]
fn lists_that_may_be_columns_are_read_as_rows_and_that_is_said() {
    let text = "[[0, 0.8, -0.6], [-0.6, 0.48, 0.64], [0.8, 0.36, 0.48]]";
    let says_so = |from| {
        let notes = between(text, from, "scipy").notes;
        notes
            .iter()
            .any(|note| matches!(note.fact, Fact::RowsAssumed(_)))
    };
    assert!(says_so("nalgebra") && says_so("eigen") && !says_so("scipy"));
}

/// Every line of code that this core wrote is read back as the same attitude, at both ends.
#[wasm_bindgen_test(unsupported = test)]
fn every_line_of_code_is_read_back() {
    for library in with_quaternions() {
        let there = between(TEXT, "openvins", library.id);
        let line = there.to.construct.expect(library.id);
        for from in [library.id, "openvins"] {
            // Elsewhere it must say of itself what it is, or be refused.
            let request = TranslateRequest::new(
                &line,
                Endpoint::library(from),
                Endpoint::library("openvins"),
            );
            let Outcome::Translate(back) = answer(request) else {
                assert_ne!(from, library.id, "{line}");
                continue;
            };
            if from == library.id || back.proposed.as_deref() == Some(library.id) {
                let what = format!("{line} at {from}");
                assert_close(&what, &back.to.array, &[0.1, 0.7, -0.5, 0.5], 1e-15);
            }
        }
    }
}
