//! What is refused, and what bounds there are.

use crate::frames::{answered, asked, refusal, report, rig};
use quatlas::{Convention, Field, FramesRequest, GivenPose, ProblemCode, Remedy};
use wasm_bindgen_test::wasm_bindgen_test;

fn straight(parent: &str, child: &str) -> GivenPose {
    GivenPose::new(parent, child, "1 0 0 0", "1 0 0")
}

#[wasm_bindgen_test(unsupported = test)]
fn names_that_no_pose_has_are_refused_with_the_nearest() {
    let report = asked(&rig(), "i_2", "G");
    assert_eq!(refusal(&report), ProblemCode::UnknownFrame);
    let [problem] = &report.problems[..] else {
        panic!("{report:?}");
    };
    assert_eq!(problem.field, Field::Child);
    let suggestion = problem.suggestion.as_ref().expect("I2 is meant");
    assert_eq!(
        (suggestion.remedy, &*suggestion.text),
        (Remedy::RenameFrame, "I2")
    );
    assert_eq!(problem.expected, "G, I1, C1, I2, C2");
    // I3 is another frame than I2.
    let other = asked(&rig(), "I3", "G");
    assert_eq!(other.problems[0].suggestion, None);
    let camera = [straight("world", "left camera")];
    let both = asked(&camera, "LeftCamera", "World");
    let suggested = both
        .problems
        .iter()
        .map(|problem| &*problem.suggestion.as_ref().expect("one").text);
    assert_eq!(suggested.collect::<Vec<_>>(), ["world", "left camera"]);
}

#[wasm_bindgen_test(unsupported = test)]
fn frames_that_do_not_meet_are_refused_with_remedies() {
    let poses = [straight("W", "B"), straight("C", "D")];
    let report = asked(&poses, "D", "W");
    assert_eq!(refusal(&report), ProblemCode::FramesDoNotMeet);
    let [add] = &report.problems[0].choices[..] else {
        panic!("{:?}", report.problems);
    };
    assert_eq!(
        (add.remedy, &*add.text, add.label.as_deref()),
        (Remedy::AddPose, "D", Some("W"))
    );

    let poses = [straight("W", "imu"), straight("IMU", "camera")];
    let report = asked(&poses, "camera", "W");
    let rename = &report.problems[0].choices[0];
    let renamed = (rename.remedy, &*rename.text, rename.label.as_deref());
    assert_eq!(renamed, (Remedy::RenameFrame, "imu", Some("IMU")));
    let poses = [straight("imu", "camera"), straight("W", "IMU")];
    let rename = &asked(&poses, "camera", "W").problems[0].choices[0];
    assert_eq!(
        (&*rename.text, rename.label.as_deref()),
        ("IMU", Some("imu"))
    );
    // Where a pose cannot be read, that is what to mend.
    let poses = [straight("W", "B"), GivenPose::new("B", "C", "none", "")];
    let report = asked(&poses, "C", "W");
    assert_eq!(refusal(&report), ProblemCode::FramesDoNotMeet);
    assert!(report.problems[0].choices.is_empty());
    assert_eq!(report.poses[1].problems[0].field, Field::Rotation);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_pose_is_between_two_names() {
    let poses = [straight("A", "A"), straight(" ", "B"), straight("B", "C")];
    let report = asked(&poses, "C", "B");
    assert!(report.answer.is_some(), "the others are read");
    let code = |at: usize| report.poses[at].problems[0].code;
    assert_eq!(
        (code(0), code(1)),
        (ProblemCode::SameFrame, ProblemCode::UnnamedFrame)
    );
    assert_eq!(report.poses[1].problems[0].field, Field::Parent);
    assert_eq!(refusal(&asked(&poses, "B", "B")), ProblemCode::SameFrame);
    assert_eq!(refusal(&asked(&poses, "", "B")), ProblemCode::UnnamedFrame);
    let nothing = asked(&[GivenPose::default()], "", "");
    assert!(
        nothing.poses[0].problems.is_empty(),
        "a row that is not filled in yet"
    );
    assert_eq!(nothing.problems.len(), 2);
}

#[wasm_bindgen_test(unsupported = test)]
fn one_pose_that_cannot_be_read_leaves_the_others() {
    let mut poses = rig();
    poses.push(GivenPose::new("C2", "lidar", "1 2 3 4 5", "1 2"));
    let report = asked(&poses, "I2", "G");
    answered(&report);
    let fields = report.poses[4].problems.iter().map(|problem| problem.field);
    assert_eq!(
        fields.collect::<Vec<_>>(),
        [Field::Position, Field::Rotation]
    );
    let mut request = FramesRequest::new(rig(), "I2", "G", Convention::HAMILTON);
    request.point = "1 2".to_owned();
    let report = crate::frames::report(request);
    assert_eq!(report.problems[0].field, Field::Point);
    assert!(report.answer.is_some());
}

#[wasm_bindgen_test(unsupported = test)]
fn the_thirty_third_pose_is_not_read() {
    let name = |at: usize| format!("frame {at}");
    let mut poses = Vec::new();
    for at in 0..40 {
        poses.push(straight(&name(at), &name(at + 1)));
    }
    let report = asked(&poses, &name(32), &name(0));
    assert_eq!(answered(&report).position, Some([32.0, 0.0, 0.0]));
    assert_eq!(report.poses.len(), 33);
    let problem = &report.poses[32].problems[0];
    assert_eq!(problem.code, ProblemCode::TooManyPoses);
    assert_eq!(
        refusal(&asked(&poses, &name(33), &name(0))),
        ProblemCode::UnknownFrame
    );
}

/// No number is infinite, and no text too long to answer at once.
#[wasm_bindgen_test(unsupported = test)]
fn what_is_hostile_is_answered() {
    let far = "1.5e308 1.5e308 1.5e308";
    let poses = vec![
        GivenPose::new("A", "B", "rotvec 1 2 3", far),
        GivenPose::new("B", "C", "rotvec 1 2 3", far),
        GivenPose::new("A", "C", "rotvec 1 2 3", "1 2 3"),
        GivenPose::new("C", "D", "rotvec -1 2 3", far),
    ];
    for (child, parent) in [("D", "A"), ("A", "D"), ("C", "B"), ("B", "D")] {
        let mut request = FramesRequest::new(poses.clone(), child, parent, Convention::JPL);
        request.point = far.to_owned();
        let report = report(request);
        let text = serde_json::to_string(&report).expect("JSON");
        let back: quatlas::FramesReport = serde_json::from_str(&text).expect("no number is null");
        assert_eq!(back, report);
    }
    let long = "x".repeat(5000);
    let report = asked(&[straight(&long, "B")], "B", &long);
    assert_eq!(report.poses[0].problems[0].code, ProblemCode::TextTooLong);
    assert_eq!(report.problems[0].code, ProblemCode::TextTooLong);
    let name = "ß <b>&\u{202e}".repeat(15);
    let report = asked(&[straight(&name, "B")], "B", &name);
    assert!(report.answer.is_some());
}
