//! What the core says of a text.

use quatlas::{
    AngleUnit, ComponentOrder, ComposeReport, ComposeRequest, Convention, Fact, Outcome,
    ParsedRotation, Problem, ReadReport, ReadRequest, Request, UnitSource, analyze, parse_rotation,
};

pub(crate) const DEGREES: UnitSource = UnitSource::Written(AngleUnit::Degrees);
pub(crate) const RADIANS: UnitSource = UnitSource::Written(AngleUnit::Radians);
pub(crate) const AS_DEGREES: UnitSource = UnitSource::Assumed(AngleUnit::Degrees);
pub(crate) const AS_RADIANS: UnitSource = UnitSource::Assumed(AngleUnit::Radians);

pub(crate) fn read_request(quaternion: &str, vector: &str, convention: Convention) -> Request {
    Request::Read(ReadRequest::new(quaternion, vector, convention))
}

#[track_caller]
pub(crate) fn report(request: ReadRequest) -> ReadReport {
    match analyze(&Request::Read(request)) {
        Outcome::Read(report) => *report,
        other => panic!("no report: {other:?}"),
    }
}

#[track_caller]
pub(crate) fn read(quaternion: &str, vector: &str, convention: Convention) -> ReadReport {
    match analyze(&read_request(quaternion, vector, convention)) {
        Outcome::Read(report) => *report,
        other => panic!("{quaternion:?} has no report: {other:?}"),
    }
}

#[track_caller]
pub(crate) fn compose(p: &str, q: &str, vector: &str, convention: Convention) -> ComposeReport {
    let request = Request::Compose(ComposeRequest::new(p, q, vector, convention));
    match analyze(&request) {
        Outcome::Compose(report) => *report,
        other => panic!("{p:?} and {q:?} have no report: {other:?}"),
    }
}

/// No description but a quaternion's depends on the declared order.
#[track_caller]
pub(crate) fn rotation(text: &str) -> ParsedRotation {
    let [first, last] = ComponentOrder::ALL.map(|declared| {
        parse_rotation(text, declared)
            .unwrap_or_else(|problem| panic!("{text}\n{}", problem.render(text)))
    });
    assert_eq!(first, last, "{text}");
    first
}

/// How the unit of the angles in a text was told.
#[track_caller]
pub(crate) fn unit_of(text: &str) -> UnitSource {
    match rotation(text) {
        ParsedRotation::AxisAngle(parsed) => parsed.unit,
        ParsedRotation::RotationVector(parsed) => parsed.unit,
        ParsedRotation::EulerAngles(parsed) => parsed.unit,
        other => panic!("{text} has no angles: {other:?}"),
    }
}

pub(crate) fn problems(outcome: Outcome) -> Vec<Problem> {
    match outcome {
        Outcome::Problems(found) => found.problems,
        other => panic!("there is a report: {other:?}"),
    }
}

pub(crate) fn facts(report: &ReadReport) -> Vec<Fact> {
    report.notes.iter().map(|note| note.fact.clone()).collect()
}
