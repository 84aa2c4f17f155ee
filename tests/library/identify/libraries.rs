//! Every library that was run is told from what it printed: from all of it, and by the shortest way.

use crate::recorded::{for_each, numbers};
use quatlas::{
    BehaviourAxis, ComponentOrder, IdentifyReport, IdentifyRequest, Library, MatrixLayout, Outcome,
    Probe, ProbeKind, Request, analyze,
};
use serde_json::Value;
use std::cell::RefCell;
use wasm_bindgen_test::wasm_bindgen_test;

fn identify(request: &IdentifyRequest) -> IdentifyReport {
    match analyze(&Request::Identify(request.clone())) {
        Outcome::Identify(report) => *report,
        other => panic!("{other:?}"),
    }
}

fn text(numbers: &[f64]) -> String {
    let parts: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
    parts.join(" ")
}

fn named([w, x, y, z]: [f64; 4]) -> String {
    format!("w: {w:?}, x: {x:?}, y: {y:?}, z: {z:?}")
}

fn four(value: &Value) -> Option<[f64; 4]> {
    numbers(value)?.try_into().ok()
}

/// What one library printed, as somebody at its console would see it: the recorder noted components
/// by name; in which order they went in and came out it measured once.
struct Console<'a> {
    observed: &'a Value,
    inputs: &'a Value,
    constructor: Option<ComponentOrder>,
    array: Option<ComponentOrder>,
}

impl<'a> Console<'a> {
    fn of(observed: &'a Value, inputs: &'a Value) -> Self {
        // By what was printed, not by what the record says.
        let made = four(&observed["constructed1234"]);
        let constructor = made.map(|[_, x, _, z]| {
            if (z / x - 2.0).abs() < 1e-3 {
                ComponentOrder::ScalarFirst
            } else {
                ComponentOrder::ScalarLast
            }
        });
        let [w, ..] = four(&inputs["a"]).expect("a");
        let array = four(&observed["arrayOfA"]).map(|printed| {
            if (printed[0] - w).abs() < 1e-5 {
                ComponentOrder::ScalarFirst
            } else {
                ComponentOrder::ScalarLast
            }
        });
        Self {
            observed,
            inputs,
            constructor,
            array,
        }
    }

    fn write(order: Option<ComponentOrder>, q: [f64; 4]) -> String {
        let [w, x, y, z] = q;
        match order {
            Some(ComponentOrder::ScalarFirst) => text(&q),
            Some(ComponentOrder::ScalarLast) => text(&[x, y, z, w]),
            None => named(q),
        }
    }

    fn given(&self, name: &str) -> String {
        Self::write(self.constructor, four(&self.inputs[name]).expect(name))
    }

    fn printed(&self, value: &Value) -> Option<String> {
        four(value).map(|q| Self::write(self.array, q))
    }

    /// What it printed for a kind of probe; `None` where that was not recorded.
    fn answer(&self, kind: ProbeKind) -> Option<Probe> {
        let observed = self.observed;
        let vector = |value: &Value| numbers(value).map(|numbers| text(&numbers));
        Some(match kind {
            ProbeKind::Product => Probe::Product {
                a: self.given("a"),
                b: self.given("b"),
                printed: self.printed(&observed["productAB"])?,
            },
            ProbeKind::Rotate => Probe::Rotate {
                quaternion: self.given("a"),
                vector: vector(&self.inputs["v"])?,
                printed: vector(&observed["rotateAV"])?,
            },
            ProbeKind::Matrix => Probe::Matrix {
                quaternion: self.given("a"),
                printed: vector(&observed["matrixA"])?,
                layout: MatrixLayout::Rows,
            },
            ProbeKind::FromMatrix => Probe::FromMatrix {
                matrix: vector(&self.inputs["fromMatrix"][0])?,
                layout: MatrixLayout::Rows,
                printed: self.printed(observed["fromMatrix"].get(0)?)?,
            },
            ProbeKind::Components => Probe::Components {
                quaternion: self.given("a"),
                printed: vector(&observed["arrayOfA"])?,
            },
            ProbeKind::QuarterTurn | ProbeKind::Perturb => return None,
        })
    }

    fn ij(&self) -> Option<Probe> {
        Some(Probe::Product {
            a: "i".to_owned(),
            b: "j".to_owned(),
            printed: named(four(&self.observed["productIJ"])?),
        })
    }
}

/// The choices that a record establishes.
fn established(library: &Library) -> Vec<BehaviourAxis> {
    let unestablished = library.unestablished();
    let of_library = &BehaviourAxis::ALL[..5];
    of_library
        .iter()
        .copied()
        .filter(|axis| !unestablished.contains(axis))
        .collect()
}

#[track_caller]
fn assert_identified(library: &Library, report: &IdentifyReport, can_tell: &[BehaviourAxis]) {
    let id = &library.id;
    assert_eq!(report.contradiction, None, "{id}");
    assert!(
        report.libraries.iter().any(|found| found.id == *id),
        "{id}: {report:#?}"
    );
    for axis in can_tell {
        assert!(report.settled.contains(axis), "{id}: {axis:?} {report:#?}");
    }
    let left = &report.remaining;
    if let Some(hand) = library.handedness {
        assert!(
            left.handedness == [hand] || !can_tell.contains(&BehaviourAxis::Handedness),
            "{id}"
        );
    }
}

const KINDS: [ProbeKind; 5] = [
    ProbeKind::Components,
    ProbeKind::Product,
    ProbeKind::Rotate,
    ProbeKind::Matrix,
    ProbeKind::FromMatrix,
];

/// Which choices the recorded numbers can tell at all: a library whose printed numbers have names
/// tells no order.
fn can_tell(library: &Library, console: &Console<'_>) -> Vec<BehaviourAxis> {
    let has = |kind| console.answer(kind).is_some();
    let mut axes = established(library);
    axes.retain(|axis| match axis {
        BehaviourAxis::Constructor => {
            console.constructor.is_some()
                && (has(ProbeKind::Rotate) || has(ProbeKind::Matrix) || has(ProbeKind::Product))
        }
        BehaviourAxis::Array => console.array.is_some() && KINDS.iter().any(|&kind| has(kind)),
        BehaviourAxis::Handedness => has(ProbeKind::Product) || console.ij().is_some(),
        BehaviourAxis::Rotate => has(ProbeKind::Rotate),
        BehaviourAxis::Matrix => has(ProbeKind::Matrix) || has(ProbeKind::FromMatrix),
        BehaviourAxis::Attitude | BehaviourAxis::Perturbation | BehaviourAxis::IncrementSign => {
            false
        }
    });
    axes
}

#[wasm_bindgen_test(unsupported = test)]
fn every_library_is_told_from_all_that_it_printed() {
    let count = RefCell::new(0);
    for_each(|library, observed, inputs| {
        let console = Console::of(observed, inputs);
        let mut answers: Vec<Probe> = KINDS
            .iter()
            .filter_map(|&kind| console.answer(kind))
            .collect();
        answers.extend(console.ij());
        let report = identify(&IdentifyRequest::new(answers));
        assert_identified(library, &report, &can_tell(library, &console));
        *count.borrow_mut() += 1;
    });
    assert!(*count.borrow() >= 60);
}

/// The tool asks; what a library cannot answer is marked so and costs nothing but a click.
#[wasm_bindgen_test(unsupported = test)]
fn every_library_is_told_in_at_most_four_probes() {
    let all = RefCell::new(Vec::new());
    for_each(|library, observed, inputs| {
        let console = Console::of(observed, inputs);
        let wanted = can_tell(library, &console);
        let mut request = IdentifyRequest::new(vec![]);
        let report = loop {
            let report = identify(&request);
            if wanted.iter().all(|axis| report.settled.contains(axis)) {
                break report;
            }
            let kind = report.next.as_ref().expect(library.id).probe.kind();
            let answer = console.answer(kind).or_else(|| {
                let is_first = kind == ProbeKind::Product && request.observations.is_empty();
                is_first.then(|| console.ij()).flatten()
            });
            // A kind that is asked again was answered with names, which tell no order.
            let is_new = request.observations.iter().all(|told| told.kind() != kind);
            match answer.filter(|_| is_new) {
                Some(answer) => request.observations.push(answer),
                None => request.unavailable.push(kind),
            }
        };
        assert_identified(library, &report, &wanted);
        let probes = request.observations.len();
        assert!(probes <= 4, "{}: {probes}", library.id);
        all.borrow_mut().push(probes);
    });
    let all = all.into_inner();
    let sum: usize = all.iter().sum();
    // Three are enough for most: a product, a rotated vector, a matrix.
    assert!(
        sum <= 3 * all.len(),
        "{sum} probes for {} libraries",
        all.len()
    );
}
