//! What is said of a library, and of what it printed.

use crate::identify::{answer, identify};
use crate::simulated::{Noise, Simulated, every_probe};
use quatlas::{
    Behaviour, BehaviourAxis, ComponentOrder, ComponentSign, CosineMatrix, Direction, Function,
    Handedness, IdentifyRequest, Labels, Language, LibraryMatch, MatrixLayout, ObservationReport,
    Probe, ProblemCode, Side,
};
use wasm_bindgen_test::wasm_bindgen_test;

fn hamilton_scalar_first() -> Behaviour {
    Behaviour::all().next().expect("the first of all")
}

#[wasm_bindgen_test(unsupported = test)]
fn what_numbers_cannot_tell_is_said_with_the_labels_that_fit() {
    // The body's quaternion rotates body coordinates to world coordinates ...
    let body_to_world = [
        Labels {
            function: Function::Passive,
            direction: Direction::BodyToWorld,
        },
        Labels {
            function: Function::Active,
            direction: Direction::WorldToBody,
        },
    ];
    // ... or the other way round.
    let world_to_body = [
        Labels {
            function: Function::Passive,
            direction: Direction::WorldToBody,
        },
        Labels {
            function: Function::Active,
            direction: Direction::BodyToWorld,
        },
    ];
    for attitude in ComponentSign::ALL {
        for rotate in CosineMatrix::ALL {
            let behaviour = Behaviour {
                attitude,
                rotate,
                ..hamilton_scalar_first()
            };
            let mut library = Simulated::new(behaviour, Noise::None, 7);
            let answers = every_probe()
                .iter()
                .map(|probe| library.answer(probe))
                .collect();
            let report = identify(answers);
            let is_body_to_world =
                (attitude == ComponentSign::Canonical) == (rotate == CosineMatrix::Hamilton);
            let expected = if is_body_to_world {
                body_to_world
            } else {
                world_to_body
            };
            assert_eq!(report.labels, expected, "{attitude:?} {rotate:?}");
            assert_eq!(report.remaining.direction, [expected[0].direction]);
        }
    }
    assert_eq!(identify(vec![]).labels.len(), 4);
}

#[wasm_bindgen_test(unsupported = test)]
fn names_of_components_leave_the_orders_open() {
    let product = Probe::Product {
        a: "i".to_owned(),
        b: "j".to_owned(),
        printed: "-k".to_owned(),
    };
    let report = identify(vec![product]);
    assert_eq!(report.settled, [BehaviourAxis::Handedness]);
    assert_eq!(report.remaining.handedness, [Handedness::Left]);
    assert_eq!(report.possible, 128);
}

#[wasm_bindgen_test(unsupported = test)]
fn nine_numbers_of_unknown_layout_do_not_settle_the_matrix() {
    let matrix = |layout| Probe::Matrix {
        quaternion: "w: 0.5, x: 0.5, y: 0.5, z: 0.5".to_owned(),
        printed: "0 1 0 0 0 1 1 0 0".to_owned(),
        layout,
    };
    let settled = |layout| identify(vec![matrix(layout)]).remaining.matrix;
    // 120° about (1, 1, 1): R(q) takes x to y, so its first column is y.
    assert_eq!(settled(MatrixLayout::Rows), [CosineMatrix::Shuster]);
    assert_eq!(settled(MatrixLayout::Columns), [CosineMatrix::Hamilton]);
    assert_eq!(settled(MatrixLayout::Unknown).len(), 2);
    // Then another probe is asked for.
    let report = identify(vec![matrix(MatrixLayout::Unknown)]);
    assert!(report.next.is_some());
}

/// Twelve numbers are no matrix here, whatever a fourth row would be.
#[wasm_bindgen_test(unsupported = test)]
fn a_homogeneous_matrix_without_its_last_row_is_refused() {
    let report = identify(vec![Probe::Matrix {
        quaternion: "0.5 0.5 0.5 0.5".to_owned(),
        printed: "0 0 1 0\n1 0 0 0\n0 1 0 0".to_owned(),
        layout: MatrixLayout::Rows,
    }]);
    let [ObservationReport::Problem(found)] = &report.observations[..] else {
        panic!("one problem: {:?}", report.observations)
    };
    assert_eq!(found.problem.code, ProblemCode::NotAMatrix);
    assert_eq!(
        found.problem.message,
        "12 numbers: a quaternion has 4, a matrix 9"
    );
}

/// Sixteen numbers are a rotation only where nothing is moved or projected.
#[wasm_bindgen_test(unsupported = test)]
fn a_homogeneous_matrix_with_more_than_a_rotation_is_refused() {
    let matrix = |[right, below]: [[i32; 3]; 2]| Probe::Matrix {
        quaternion: "0.5 0.5 0.5 0.5".to_owned(),
        printed: format!(
            "0 0 1 {}\n1 0 0 {}\n0 1 0 {}\n{} {} {} 1",
            right[0], right[1], right[2], below[0], below[1], below[2]
        ),
        layout: MatrixLayout::Rows,
    };
    let is_told = |numbers| {
        let report = identify(vec![matrix(numbers)]);
        matches!(report.observations[..], [ObservationReport::Told(_)])
    };
    assert!(is_told([[0; 3]; 2]));
    for at in 0..3 {
        let mut one = [0; 3];
        one[at] = 7;
        assert!(!is_told([one, [0; 3]]), "{at}");
        assert!(!is_told([[0; 3], one]), "{at}");
        assert!(!is_told([one, one]), "{at}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_no_library_prints_and_what_cannot_be_read_stay_in_their_places() {
    let rotate = |printed: &str| Probe::Rotate {
        quaternion: "0.5 0.5 0.5 0.5".to_owned(),
        vector: "1 2 3".to_owned(),
        printed: printed.to_owned(),
    };
    let texts = ["", "3 1 oops", "1 1 -5", "0 0 0", "3 1 2", "-3 -1 -2"];
    let report = identify(texts.map(rotate).to_vec());
    let [empty, problem, wrong, zero, told, mirrored] = &report.observations[..] else {
        panic!("six")
    };
    assert_eq!(*empty, ObservationReport::Empty);
    let ObservationReport::Problem(found) = problem else {
        panic!("{problem:?}")
    };
    assert_eq!((found.problem.span.start, found.problem.span.end), (4, 8));
    let ObservationReport::Unexplained(unexplained) = wrong else {
        panic!("{wrong:?}")
    };
    assert!(unexplained.distance.expect("numbers") > 0.5);
    let ObservationReport::Unexplained(unexplained) = zero else {
        panic!("{zero:?}")
    };
    assert_eq!(unexplained.distance, None);
    let ObservationReport::Told(told) = told else {
        panic!("{told:?}")
    };
    assert_eq!(
        (told.possible, &told.settles[..]),
        (128, &[BehaviourAxis::Rotate][..])
    );
    assert!(matches!(mirrored, ObservationReport::Unexplained(_)));
    // What told nothing takes nothing away.
    assert_eq!(report.remaining.rotate, [CosineMatrix::Hamilton]);
    assert_eq!(report.possible, 128);
}

/// ``OpenVINS`` has no call that rotates, but its matrix is for columns: it does not rotate by R(q).
#[wasm_bindgen_test(unsupported = test)]
fn the_records_that_match_come_with_those_first_that_say_most() {
    let behaviour = Behaviour {
        handedness: Handedness::Left,
        constructor: ComponentOrder::ScalarLast,
        array: ComponentOrder::ScalarLast,
        matrix: CosineMatrix::Shuster,
        ..hamilton_scalar_first()
    };
    let matches = |rotate| {
        let mut library = Simulated::new(
            Behaviour {
                rotate,
                ..behaviour
            },
            Noise::None,
            5,
        );
        let answers = every_probe()
            .iter()
            .map(|probe| library.answer(probe))
            .collect();
        identify(answers).libraries
    };
    let has = |found: &[LibraryMatch], id: &str| found.iter().any(|library| library.id == id);
    let row_vectors = matches(CosineMatrix::Hamilton);
    assert!(has(&row_vectors, "directxmath") && !has(&row_vectors, "openvins"));
    let jpl = matches(CosineMatrix::Shuster);
    assert!(has(&jpl, "openvins") && !has(&jpl, "directxmath"));
    for found in [row_vectors, jpl] {
        assert!(found[0].unestablished.is_empty());
        assert!(found.is_sorted_by_key(|library| library.unestablished.len()));
        assert!(
            found
                .iter()
                .any(|library| !library.unestablished.is_empty())
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_sentence_says_which_vectors_a_matrix_is_for() {
    let sentence = |rotate, matrix| {
        let behaviour = Behaviour {
            rotate,
            matrix,
            ..hamilton_scalar_first()
        };
        let mut library = Simulated::new(behaviour, Noise::None, 3);
        let answers = every_probe()
            .iter()
            .map(|probe| library.answer(probe))
            .collect();
        identify(answers).sentence
    };
    let (r, c) = (CosineMatrix::Hamilton, CosineMatrix::Shuster);
    assert!(sentence(r, r).contains("prints R(q) as the matrix of q (for column vectors)"));
    assert!(sentence(c, c).contains("prints C(q) as the matrix of q (for column vectors)"));
    assert!(sentence(r, c).contains("prints C(q) as the matrix of q, the transpose"));
    assert!(sentence(r, r).ends_with("That is Hamilton."));
    assert!(sentence(c, c).contains("That is not all Hamilton"));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_sentence_says_what_is_settled_and_what_is_not() {
    let behaviour = Behaviour {
        handedness: Handedness::Left,
        ..hamilton_scalar_first()
    };
    let mut library = Simulated::new(behaviour, Noise::None, 3);
    let answers: Vec<Probe> = every_probe()
        .iter()
        .map(|probe| library.answer(probe))
        .collect();
    let mut request = IdentifyRequest::new(answers[..3].to_vec());
    request.name = "  Quux 3.1 ".to_owned();
    let report = answer(request);
    assert_eq!(report.remaining.first_to_act, [Side::Left]);
    assert_eq!(
        report.sentence,
        "Quux 3.1 multiplies Shuster/JPL (i*j = -k), takes w x y z in its constructor, stores and \
         prints w x y z, rotates a column vector by R(q) and lets the left operand a of a*b act \
         first. That is not JPL: the product is Shuster's, but the quaternion rotates by R(q). \
         Not settled: what its matrix is."
    );
}

/// nalgebra's `{:?}` prints columns, gl-matrix stores them: only rows on lines are surely rows.
#[wasm_bindgen_test(unsupported = test)]
fn the_layout_is_taken_from_the_text_where_the_text_shows_it() {
    let settled = |printed: &str, language| {
        let matrix = Probe::Matrix {
            quaternion: "0.5 0.5 0.5 0.5".to_owned(),
            printed: printed.to_owned(),
            layout: MatrixLayout::AsWritten,
        };
        let mut request = IdentifyRequest::new(vec![matrix]);
        request.language = language;
        answer(request).remaining.matrix
    };
    let (r, both) = (vec![CosineMatrix::Hamilton], CosineMatrix::ALL.to_vec());
    let (lines, lists, flat) = (
        "0 0 1\n1 0 0\n0 1 0",
        "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]",
        "0 0 1 1 0 0 0 1 0",
    );
    for (text, language, expected) in [
        (lines, Language::Python, &r),
        (lines, Language::Rust, &r),
        (lists, Language::Python, &r),
        (lists, Language::Rust, &both),
        (lists, Language::Cpp, &both),
        (flat, Language::Python, &both),
        (
            "Float32Array(9) [ 0, 0, 1, 1, 0, 0, 0, 1, 0 ]",
            Language::Javascript,
            &both,
        ),
        ("┌ 0 0 1 ┐\n│ 1 0 0 │\n└ 0 1 0 ┘", Language::Rust, &r),
        ("0 0 1 0\n1 0 0 0\n0 1 0 0\n0 0 0 1", Language::Python, &r),
    ] {
        assert_eq!(settled(text, language), *expected, "{text} {language:?}");
    }
}

/// Which order a constructor takes is the question, so its name answers nothing.
#[wasm_bindgen_test(unsupported = test)]
fn names_of_constructors_tell_nothing_here() {
    let product = |a: &str, b: &str| Probe::Product {
        a: a.to_owned(),
        b: b.to_owned(),
        printed: "Quaternion(4) [ 1, 0, 0, 0 ]".to_owned(),
    };
    let plain = identify(vec![product("0 1 0 0", "0 0 1 0")]);
    let called = identify(vec![product(
        "Quaternion::new(0.0, 1.0, 0.0, 0.0)",
        "Quaternion::new(0.0, 0.0, 1.0, 0.0)",
    )]);
    assert_eq!(plain.remaining, called.remaining);
    assert_eq!(plain.remaining.constructor, [ComponentOrder::ScalarLast]);
}
