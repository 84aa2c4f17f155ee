//! Poses between named frames: what follows from them, what contradicts, and what is refused.

mod known;
mod limits;
mod loops;
mod questions;
mod trees;

use quatlas::{
    Convention, FoundPose, FramesReport, FramesRequest, GivenPose, Outcome, ProblemCode, Request,
    analyze,
};

/// A few dozen roundings of numbers of the size of ten.
pub(crate) const CLOSE: f64 = 1e-13;

pub(crate) fn report(request: FramesRequest) -> FramesReport {
    match analyze(&Request::Frames(request)) {
        Outcome::Frames(report) => *report,
        other => panic!("{other:?}"),
    }
}

/// The pose of `child` in `parent`, from poses in Hamilton's convention.
pub(crate) fn asked(poses: &[GivenPose], child: &str, parent: &str) -> FramesReport {
    let poses = poses.to_vec();
    report(FramesRequest::new(
        poses,
        child,
        parent,
        Convention::HAMILTON,
    ))
}

#[track_caller]
pub(crate) fn answered(report: &FramesReport) -> &FoundPose {
    assert_eq!(report.problems, []);
    report.answer.as_ref().expect("an answer")
}

/// The code of the only problem of the question.
#[track_caller]
pub(crate) fn refusal(report: &FramesReport) -> ProblemCode {
    assert_eq!(report.answer, None);
    assert!(report.path.is_empty());
    let [problem] = &report.problems[..] else {
        panic!("{:?}", report.problems);
    };
    assert!(
        !problem.message.is_empty() && !problem.expected.is_empty() && !problem.hint.is_empty()
    );
    problem.code
}

/// The rig of Yoosefian 2021, figure 1, with the numbers of golden case G29.
pub(crate) fn rig() -> Vec<GivenPose> {
    let camera = |body: &str, camera: &str| {
        GivenPose::new(body, camera, "rotvec 1.2 -0.4 0.5", "0.1 -0.2 0.3")
    };
    let second_in_first = "0.828301195197473 -0.30331114248264973 0.4710833056692918
        0.4977750903949278 0.7843045622195928 -0.37025168880621506
        -0.25717132308396895 0.541173451425144 0.8006211376524094";
    vec![
        GivenPose::new("G", "I1", "rotvec 0.1 0.2 -0.3", "1 2 3"),
        camera("I1", "C1"),
        camera("I2", "C2"),
        GivenPose::new(
            "C1",
            "C2",
            second_in_first,
            "0.48949580643994545 -0.9478975237392575 0.6323416684139177",
        ),
    ]
}
