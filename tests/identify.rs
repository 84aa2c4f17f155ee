//! Which convention a library uses, told from what it prints.

mod common;

use common::wasm_bindgen_test;
use quatlas::{
    Behaviour, IdentifyReport, IdentifyRequest, ObservationReport, Outcome, Probe, Request, analyze,
};

fn identify(observations: Vec<Probe>) -> IdentifyReport {
    let request = Request::Identify(IdentifyRequest::new(observations));
    match analyze(&request) {
        Outcome::Identify(report) => *report,
        other => panic!("{other:?}"),
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn nothing_observed() {
    let report = identify(vec![]);
    assert_eq!(report.possible, 128);
    eprintln!("{report:#?}");
}
