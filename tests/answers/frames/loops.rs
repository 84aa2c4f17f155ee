//! Poses beyond those that suffice: how far they contradict the others, and what would close the loop.

use crate::frames::{CLOSE, asked, rig};
use crate::support::assert_close;
use quatlas::GivenPose;
use wasm_bindgen_test::wasm_bindgen_test;

/// What the rig says of I2 in G, with an error.
fn rig_with(rotation: &str, position: &str) -> Vec<GivenPose> {
    let mut poses = rig();
    poses.push(GivenPose::new("G", "I2", rotation, position));
    poses
}

#[wasm_bindgen_test(unsupported = test)]
fn a_loop_that_closes_is_told_as_closed() {
    let report = asked(&rig_with("rotvec 0.3 -0.1 0.4", "1.5 1 2.5"), "C2", "G");
    let [told] = &report.loops[..] else {
        panic!("{:?}", report.loops);
    };
    assert_close("angle", &[told.angle_deg], &[0.0], 1e-11);
    assert_close("distance", told.distance.as_slice(), &[0.0], CLOSE);
    assert_eq!((told.inverse_closes, told.transpose_closes), (None, None));
    // The shorter way is the answer's, over the pose that was added.
    assert_eq!(
        report.path.iter().map(|step| step.pose).collect::<Vec<_>>(),
        [4, 2]
    );
    assert_eq!(told.pose, 3);
    assert_eq!(told.frames, [2, 1, 0, 3, 4]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_loop_that_is_off_is_told_by_angle_and_distance() {
    let poses = [
        GivenPose::new("A", "B", "30 deg about z", "1 0 0"),
        GivenPose::new("B", "C", "60 deg about z", "2 0 0"),
        GivenPose::new("A", "C", "91 deg about z", "2.73205080757 1 0.25"),
    ];
    let report = asked(&poses, "C", "A");
    let [told] = &report.loops[..] else {
        panic!("{:?}", report.loops);
    };
    assert_close("angle", &[told.angle_deg], &[1.0], 1e-12);
    assert_close("distance", told.distance.as_slice(), &[0.25], 1e-10);
    assert_eq!((told.inverse_closes, told.transpose_closes), (None, None));
    let without = [
        poses[0].clone(),
        poses[1].clone(),
        GivenPose::new("A", "C", "91 deg about z", ""),
    ];
    assert_eq!(asked(&without, "C", "A").loops[0].distance, None);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_pose_that_is_turned_round_is_named() {
    // The third of the rig with its frames exchanged.
    let mut poses = rig_with("rotvec 0.3 -0.1 0.4", "1.5 1 2.5");
    let third = poses[3].clone();
    poses[3] = GivenPose::new("C2", "C1", &third.rotation, &third.position);
    let told = &asked(&poses, "I2", "G").loops[0];
    assert!(told.angle_deg > 10.0, "{told:?}");
    assert_eq!(
        (told.inverse_closes, told.transpose_closes),
        (Some(3), None)
    );

    // The rotation of the first as its inverse, the position as it is.
    poses[3] = third;
    poses[0].rotation = "rotvec -0.1 -0.2 0.3".to_owned();
    let told = &asked(&poses, "I2", "G").loops[0];
    assert_eq!(
        (told.inverse_closes, told.transpose_closes),
        (None, Some(0))
    );
}

/// Loops of frames that are not joined to those of the question are told too.
#[wasm_bindgen_test(unsupported = test)]
fn loops_elsewhere_are_told() {
    let mut poses = rig();
    poses.push(GivenPose::new("X", "Y", "1 0 0 0", "1 0 0"));
    poses.push(GivenPose::new("Y", "X", "1 0 0 0", "1 0 0"));
    let report = asked(&poses, "I2", "G");
    assert!(report.answer.is_some());
    let [told] = &report.loops[..] else {
        panic!("{:?}", report.loops);
    };
    assert_eq!((told.pose, told.distance), (5, Some(2.0)));
    let x = &report.frames[5];
    assert_eq!((&*x.name, x.matrix, x.origin), ("X", None, None));
}
