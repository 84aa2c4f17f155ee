//! Where one frame stands in another, from poses between named frames.

use crate::analyze::attitude::{Attitude, Declared};
use crate::analyze::describe::{euler, turn};
use crate::analyze::frame_names::are_nearly_same;
use crate::analyze::identify::observation::LONGEST_TEXT_BYTES;
use crate::analyze::plain_numbers::{coordinates, plain, rows3};
use crate::analyze::vector::TypedVector;
use crate::contract::{
    Components, Fact, FoundPose, FramesReport, Note, OutOfRange, OutOfRangeNumber, PathStep,
    PlacedFrame, PoseLoop, ReadPose,
};
use crate::contract::{FramesRequest, GivenPose};
use crate::convention::{Convention, Direction};
use crate::frames::network::{Joined, Link, Placement, along, joined, loops, path};
use crate::problem::fault::Fault;
use crate::problem::suggestion::{Remedy, Suggestion};
use crate::problem::{Field, Problem, Span};
use nalgebra::Vector3;

/// More are no rig that somebody types, and all of them are read with every letter.
const MOST_POSES: usize = 32;

pub(crate) fn frames(request: &FramesRequest) -> FramesReport {
    let mut known = Known::default();
    let mut report = FramesReport::default();
    // The parent that is asked for comes first, so that the others are placed in it.
    let parent = request.parent.trim();
    let first = &request.poses[..request.poses.len().min(MOST_POSES)];
    if first
        .iter()
        .any(|pose| pose.parent.trim() == parent || pose.child.trim() == parent)
    {
        known.frame(parent);
    }
    for pose in first {
        let read = known.read(report.poses.len(), pose, request);
        report.poses.push(read);
    }
    if let Some(pose) = request.poses.get(MOST_POSES) {
        let mut read = ReadPose::default();
        let fault = Fault::too_many_poses(Span::of_trimmed(&pose.child));
        tell(&mut read.problems, Field::Child, fault);
        report.poses.push(read);
    }
    for (at, read) in report.poses.iter_mut().enumerate() {
        for problem in &mut read.problems {
            problem.at = u8::try_from(at).unwrap_or_default();
        }
    }
    let joined = joined(&known.links, known.names.len());
    let child = known.child_joined(request, &joined, &mut report);
    let vector = vector(&request.point, Field::Point, &mut report.problems);
    let point = vector.as_ref().map(|typed| typed.vector);
    report.notes.extend(vector.and_then(|typed| typed.note));
    if let Some(child) = child {
        known.answer(request, &joined, child, point, &mut report);
    }
    let in_parent = child
        .zip(point)
        .and_then(|(child, point)| joined[child].pose.point(point));
    for (at, (name, Joined { root, pose, .. })) in known.names.iter().zip(&joined).enumerate() {
        let mut frame = PlacedFrame {
            name: name.clone(),
            matrix: None,
            origin: None,
            point: None,
        };
        if *root == 0 {
            frame.matrix = Some(rows3(&pose.rotation.matrix(Direction::BodyToWorld)));
            frame.origin = pose.origin.as_ref().map(coordinates);
            let here = in_parent.and_then(|point| pose.inverse().point(point));
            // As it was typed, without the rounding of the way there and back.
            let here = if child == Some(at) { point } else { here };
            frame.point = here.as_ref().map(coordinates);
        }
        report.frames.push(frame);
    }
    for found in loops(&known.links, &joined) {
        let of_link = |link: Option<usize>| link.map(|link| known.pose_of[link]);
        let mut frames = vec![known.links[found.link].parent];
        frames.extend(found.path.iter().map(|step| step.to));
        report.loops.push(PoseLoop {
            pose: known.pose_of[found.link],
            frames,
            angle_deg: plain(found.angle_rad.to_degrees()),
            distance: found.distance,
            inverse_closes: of_link(found.inverse_closes),
            transpose_closes: of_link(found.transpose_closes),
        });
    }
    report
}

/// What is read of the poses.
#[derive(Default)]
struct Known {
    names: Vec<String>,
    links: Vec<Link>,
    /// The place of the pose that each link is.
    pose_of: Vec<usize>,
}

impl Known {
    /// The place of a frame in the list, at whose end it is put where it is new.
    fn frame(&mut self, name: &str) -> usize {
        if let Some(at) = self.place(name) {
            return at;
        }
        self.names.push(name.trim().to_owned());
        self.names.len() - 1
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name.trim())
    }

    fn read(&mut self, at: usize, pose: &GivenPose, request: &FramesRequest) -> ReadPose {
        let mut read = ReadPose::default();
        let texts = [&pose.parent, &pose.child, &pose.rotation, &pose.position];
        if texts.iter().all(|text| text.trim().is_empty()) {
            return read;
        }
        let mut frames = [0; 2];
        for (place, field) in [Field::Parent, Field::Child].into_iter().enumerate() {
            if is_name(texts[place], field, &mut read.problems) {
                frames[place] = self.frame(texts[place]);
            }
        }
        let [parent, child] = frames;
        if read.problems.is_empty() && parent == child {
            tell(
                &mut read.problems,
                Field::Child,
                Fault::same_frame(Span::of_trimmed(&pose.child)),
            );
        }
        let position = vector(&pose.position, Field::Position, &mut read.problems);
        let declared = Declared::plain(
            pose.convention.unwrap_or(request.convention),
            pose.matrix.unwrap_or(request.matrix),
        );
        if !is_short(&pose.rotation, Field::Rotation, &mut read.problems) {
            return read;
        }
        let attitude = match Attitude::of_text(&pose.rotation, Field::Rotation, declared) {
            Ok(attitude) => attitude,
            Err(problem) => {
                read.problems.push(problem);
                return read;
            }
        };
        read.notes = attitude.notes(Field::Rotation);
        let mut origin = position_beside(&attitude);
        if let Some(typed) = position {
            if origin.is_some() {
                tell(
                    &mut read.problems,
                    Field::Position,
                    Fault::two_positions(Span::of_trimmed(&pose.position)),
                );
            }
            read.notes.extend(typed.note);
            origin = Some(typed.vector);
        }
        let rotation = attitude.rotation;
        let unit = rotation.to_tagged(Convention::HAMILTON);
        read.quaternion = Some(attitude.as_read());
        read.unit = Some(Components::of(&unit.components, unit.convention.order));
        read.turn = Some(turn(&rotation));
        read.position = origin.as_ref().map(coordinates);
        if read.problems.is_empty() {
            let pose = Placement { rotation, origin };
            self.links.push(Link {
                parent,
                child,
                pose,
            });
            self.pose_of.push(at);
        }
        read
    }

    /// The child that is asked for, joined to the parent, which is the first of the frames; or a problem.
    fn child_joined(
        &self,
        request: &FramesRequest,
        joined: &[Joined],
        report: &mut FramesReport,
    ) -> Option<usize> {
        let known = report.problems.len();
        let mut child = 0;
        for field in [Field::Parent, Field::Child] {
            let name = request.text(field);
            if !is_name(name, field, &mut report.problems) {
                continue;
            }
            match self.place(name) {
                Some(place) => child = place,
                None => {
                    let fault = Fault::unknown_frame(Span::of_trimmed(name), &self.names);
                    let fault = fault.suggesting(|_| {
                        let mut names = self.names.iter();
                        let meant = names.find(|known| are_nearly_same(name, known))?;
                        Some(Suggestion::new(Remedy::RenameFrame, &**meant))
                    });
                    tell(&mut report.problems, field, fault);
                }
            }
        }
        if report.problems.len() > known {
            return None;
        }
        let span = Span::of_trimmed(&request.child);
        let fault = if child == 0 {
            Fault::same_frame(span)
        } else if joined[child].root != 0 {
            let is_whole = report.poses.iter().all(|pose| pose.problems.is_empty());
            let remedies = || {
                if is_whole {
                    self.remedies(joined, child)
                } else {
                    Vec::new()
                }
            };
            Fault::frames_do_not_meet(span).offering(remedies)
        } else {
            return Some(child);
        };
        tell(&mut report.problems, Field::Child, fault);
        None
    }

    /// What joins a child to the first of the frames: one name for two that are nearly the same, or one more
    /// pose.
    fn remedies(&self, joined: &[Joined], child: usize) -> Vec<Suggestion> {
        let mut remedies = Vec::new();
        let mut offer = |remedy, text: usize, label: usize| {
            remedies.push(Suggestion {
                label: Some(self.names[label].clone()),
                ..Suggestion::new(remedy, &*self.names[text])
            });
        };
        let root = joined[child].root;
        for (far, name) in self.names.iter().enumerate() {
            let meets =
                |near: &usize| joined[*near].root == 0 && are_nearly_same(name, &self.names[*near]);
            if joined[far].root == root
                && let Some(near) = (0..self.names.len()).find(meets)
            {
                offer(Remedy::RenameFrame, near, far);
                break;
            }
        }
        offer(Remedy::AddPose, child, 0);
        remedies
    }

    fn answer(
        &self,
        request: &FramesRequest,
        joined: &[Joined],
        child: usize,
        point: Option<Vector3<f64>>,
        report: &mut FramesReport,
    ) {
        let pose = joined[child].pose;
        let path = path(joined, 0, child);
        let attitude = Attitude::of_rotation(pose.rotation, request.convention);
        let column = |convention| attitude.column(convention, point.unwrap_or_default());
        let misprinted = along(&path, &|step| {
            let given = &self.links[step.link].pose;
            if step.is_inverse {
                given.misprinted_inverse()
            } else {
                *given
            }
        });
        let mut is_known = pose.origin.is_none();
        for step in &path {
            is_known &= self.links[step.link].pose.origin.is_some();
            report.path.push(PathStep {
                pose: self.pose_of[step.link],
                inverted: step.is_inverse,
                frame: step.to,
            });
        }
        if is_known {
            let what = OutOfRangeNumber::Position;
            report.notes.push(Note::new(
                Field::Position,
                Fact::OutOfRange(OutOfRange { what }),
            ));
        }
        report.answer = Some(FoundPose {
            declared: column(request.convention),
            hamilton: column(Convention::HAMILTON),
            jpl: column(Convention::JPL),
            turn: turn(&pose.rotation),
            euler: euler(&pose.rotation, request.euler),
            position: pose.origin.as_ref().map(coordinates),
            homogeneous: homogeneous(&pose),
            inverse_homogeneous: homogeneous(&pose.inverse()),
            misprinted_position: misprinted.origin.as_ref().map(coordinates),
            misprinted_distance: misprinted
                .origin
                .zip(pose.origin)
                .map(|(misprinted, origin)| (misprinted - origin).norm())
                .filter(|distance| distance.is_finite()),
        });
    }
}

fn homogeneous(pose: &Placement) -> Option<[[f64; 4]; 4]> {
    let origin = coordinates(&pose.origin?);
    let rows = rows3(&pose.rotation.matrix(Direction::BodyToWorld));
    let mut matrix = [[0.0; 4]; 4];
    for row in 0..3 {
        matrix[row][..3].copy_from_slice(&rows[row]);
        matrix[row][3] = origin[row];
    }
    matrix[3][3] = 1.0;
    Some(matrix)
}

/// The position of the body in the world that a text holds beside its rotation.
fn position_beside(attitude: &Attitude) -> Option<Vector3<f64>> {
    for fact in &attitude.told {
        if let Fact::FoundInText(found) = fact {
            for beside in &found.beside {
                // A scale has none.
                if let Some(position) = beside.body_in_world {
                    let is_finite = position.iter().all(|number| number.is_finite());
                    return is_finite.then(|| position.into());
                }
            }
        }
    }
    None
}

fn tell(problems: &mut Vec<Problem>, field: Field, fault: Fault) {
    problems.push(fault.in_field(field));
}

fn is_name(name: &str, field: Field, problems: &mut Vec<Problem>) -> bool {
    if name.trim().is_empty() {
        tell(
            problems,
            field,
            Fault::unnamed_frame(Span::of_trimmed(name)),
        );
        return false;
    }
    is_short(name, field, problems)
}

fn is_short(text: &str, field: Field, problems: &mut Vec<Problem>) -> bool {
    let is_short = text.len() <= LONGEST_TEXT_BYTES;
    if !is_short {
        let span = Span::of_trimmed(text);
        let fault = Fault::text_too_long(span, text.len(), LONGEST_TEXT_BYTES);
        tell(problems, field, fault);
    }
    is_short
}

/// The vector of a text, if there is one.
fn vector(text: &str, field: Field, problems: &mut Vec<Problem>) -> Option<TypedVector> {
    if text.trim().is_empty() || !is_short(text, field, problems) {
        return None;
    }
    match TypedVector::of_text(text, field) {
        Ok(typed) => Some(typed),
        Err(problem) => {
            problems.push(problem);
            None
        }
    }
}
