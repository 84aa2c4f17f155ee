//! Random trees of frames, each pose in another convention and form, against nalgebra's isometries.

use crate::frames::known::is_conjugated;
use crate::frames::{answered, report};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
use quatlas::{Convention, FramesRequest, GivenPose};
use wasm_bindgen_test::wasm_bindgen_test;

/// Twelve poses of lengths up to ten, and the decimals of a matrix.
const CLOSE: f64 = 1e-12;

/// Numbers without order, the same ones each time.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, most: usize) -> usize {
        usize::try_from(self.next()).expect("31 bits") % most
    }

    fn number(&mut self, size: f64) -> f64 {
        let whole = u32::try_from(self.next()).expect("31 bits");
        size * (f64::from(whole) / f64::from(1_u32 << 30) - 1.0)
    }

    fn vector(&mut self, size: f64) -> Vector3<f64> {
        Vector3::new(self.number(size), self.number(size), self.number(size))
    }
}

struct Tree {
    poses: Vec<GivenPose>,
    in_root: Vec<Isometry3<f64>>,
}

fn name(frame: usize) -> String {
    format!("F{frame}")
}

fn tree(chance: &mut Chance, frames: usize, conventions: &[Convention]) -> Tree {
    let mut tree = Tree {
        poses: Vec::new(),
        in_root: vec![Isometry3::identity()],
    };
    for frame in 1..frames {
        let joined = chance.below(frame);
        let turn = UnitQuaternion::from_scaled_axis(chance.vector(1.7));
        let pose = Isometry3::from_parts(Translation3::from(chance.vector(10.0)), turn);
        let is_inverse = chance.below(2) == 1;
        let in_joined = if is_inverse { pose.inverse() } else { pose };
        tree.in_root.push(tree.in_root[joined] * in_joined);
        let (parent, child) = if is_inverse {
            (frame, joined)
        } else {
            (joined, frame)
        };
        let convention = conventions[chance.below(conventions.len())];
        let form = chance.below(4);
        tree.poses
            .push(written(&pose, parent, child, convention, form));
    }
    for at in (1..tree.poses.len()).rev() {
        let other = chance.below(at + 1);
        tree.poses.swap(at, other);
    }
    tree
}

fn written(
    pose: &Isometry3<f64>,
    parent: usize,
    child: usize,
    convention: Convention,
    form: usize,
) -> GivenPose {
    let numbers = |numbers: &[f64]| {
        let all: Vec<_> = numbers.iter().map(|number| format!("{number:?}")).collect();
        all.join(" ")
    };
    let position = numbers(pose.translation.vector.as_slice());
    let (rotation, position) = match form {
        0 => (
            numbers(pose.to_homogeneous().transpose().as_slice()),
            String::new(),
        ),
        1 => {
            let turn = pose.rotation.scaled_axis();
            (format!("rotvec {}", numbers(turn.as_slice())), position)
        }
        _ => {
            let q = pose.rotation.quaternion();
            let sign = if is_conjugated(convention) { -1.0 } else { 1.0 };
            let array = convention
                .order
                .array([q.w, sign * q.i, sign * q.j, sign * q.k]);
            (numbers(&array), position)
        }
    };
    let mut given = GivenPose::new(&name(parent), &name(child), &rotation, &position);
    given.convention = Some(convention);
    given
}

#[wasm_bindgen_test(unsupported = test)]
fn random_trees_are_those_of_nalgebra() {
    let conventions = all_conventions();
    let mut chance = Chance(16);
    for round in 0..60 {
        let frames = 2 + round % 11;
        let Tree { poses, in_root } = tree(&mut chance, frames, &conventions);
        let parent = chance.below(frames);
        let child = (parent + 1 + chance.below(frames - 1)) % frames;
        let declared = conventions[chance.below(conventions.len())];
        let mut request = FramesRequest::new(poses, &name(child), &name(parent), declared);
        request.point = "1.5 -2 0.25".to_owned();
        let report = report(request);
        let answer = answered(&report);
        let expected = in_root[parent].inverse() * in_root[child];
        let rows = answer.homogeneous.expect("all positions are known");
        for (row, wanted) in rows.iter().zip(expected.to_homogeneous().row_iter()) {
            let wanted: Vec<f64> = wanted.iter().copied().collect();
            assert_close("the pose", row, &wanted, CLOSE);
        }
        let inverse = answer.inverse_homogeneous.expect("a position");
        for (row, wanted) in inverse
            .iter()
            .zip(expected.inverse().to_homogeneous().row_iter())
        {
            let wanted: Vec<f64> = wanted.iter().copied().collect();
            assert_close("its inverse", row, &wanted, CLOSE);
        }
        assert!(report.loops.is_empty());
        assert_eq!(
            (report.frames.len(), &report.frames[0].name),
            (frames, &name(parent))
        );
        let point = in_root[child] * Point3::new(1.5, -2.0, 0.25);
        for frame in &report.frames {
            let number: usize = frame.name[1..].parse().expect("a number");
            let in_frame = in_root[number].inverse() * point;
            let told = frame.point.expect("joined");
            assert_close("the point", &told, in_frame.coords.as_slice(), CLOSE);
            let origin = in_root[parent].inverse() * in_root[number];
            let told = frame.origin.expect("joined");
            assert_close(
                "the origin",
                &told,
                origin.translation.vector.as_slice(),
                CLOSE,
            );
        }
        assert_eq!(
            report
                .path
                .last()
                .map(|step| &report.frames[step.frame].name),
            Some(&name(child))
        );
    }
}
