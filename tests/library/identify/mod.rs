//! What the tool says of a library, and the way of its own questions.

mod answers;
mod behaviours;
mod contradictions;
mod increments;
mod libraries;
mod matrices;
mod questions;
mod thresholds;

use crate::simulated::Simulated;
use quatlas::{
    Behaviour, BehaviourAxis, IdentifyReport, IdentifyRequest, Outcome, Probe, Request, analyze,
};

pub(crate) fn answer(request: IdentifyRequest) -> IdentifyReport {
    match analyze(&Request::Identify(request)) {
        Outcome::Identify(report) => *report,
        other => panic!("{other:?}"),
    }
}

pub(crate) fn identify(observations: Vec<Probe>) -> IdentifyReport {
    answer(IdentifyRequest::new(observations))
}

/// Whether nothing but this behaviour is left.
#[track_caller]
pub(crate) fn assert_only(report: &IdentifyReport, behaviour: Behaviour) {
    assert_eq!(report.possible, 1, "{behaviour:?}: {report:#?}");
    assert_eq!(report.settled, BehaviourAxis::ALL);
    let left = &report.remaining;
    assert_eq!(left.constructor, [behaviour.constructor]);
    assert_eq!(left.array, [behaviour.array]);
    assert_eq!(left.handedness, [behaviour.handedness]);
    assert_eq!(left.rotate, [behaviour.rotate]);
    assert_eq!(left.matrix, [behaviour.matrix]);
    assert_eq!(left.attitude, [behaviour.attitude]);
    assert_eq!(left.perturbation, [behaviour.perturbation]);
    assert_eq!(left.increment_sign, [behaviour.increment_sign]);
    assert_eq!(report.contradiction, None);
    assert_eq!(report.next, None);
}

/// Whether this behaviour is among what is left.
#[track_caller]
pub(crate) fn assert_among(report: &IdentifyReport, behaviour: Behaviour) {
    let left = &report.remaining;
    assert_eq!(report.contradiction, None, "{behaviour:?}: {report:#?}");
    assert!(
        left.constructor.contains(&behaviour.constructor)
            && left.array.contains(&behaviour.array)
            && left.handedness.contains(&behaviour.handedness)
            && left.rotate.contains(&behaviour.rotate)
            && left.matrix.contains(&behaviour.matrix)
            && left.attitude.contains(&behaviour.attitude)
            && left.perturbation.contains(&behaviour.perturbation)
            && left.increment_sign.contains(&behaviour.increment_sign),
        "{behaviour:?}: {report:#?}"
    );
}

/// Asks what the tool asks until that is known; what was answered, and what is said then.
pub(crate) fn follow(
    library: &mut Simulated,
    until: impl Fn(&IdentifyReport) -> bool,
) -> (Vec<Probe>, IdentifyReport) {
    let mut observations = Vec::new();
    loop {
        let report = identify(observations.clone());
        assert_among(&report, library.behaviour);
        if until(&report) {
            return (observations, report);
        }
        let next = report.next.expect("something to ask");
        observations.push(library.answer(&next.probe));
        assert!(
            observations.len() <= 5,
            "{:?}: {observations:#?}",
            library.behaviour
        );
    }
}
