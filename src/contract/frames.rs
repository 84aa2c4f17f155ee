//! What is asked of poses between named frames, and what follows from them.

use crate::contract::attitude::{Column, Components, Euler, ReadQuaternion, Turn};
use crate::contract::note::Note;
use crate::contract::text::Text;
use crate::convention::Convention;
use crate::convention::euler_sequence::EulerSequence;
use crate::convention::matrix::MatrixConvention;
use crate::problem::{Field, Problem};
use serde::{Deserialize, Serialize};

/// What is known between named frames, and the pose that is asked for: that of `child` in `parent`.
///
/// It is what takes coordinates in the child to coordinates in the parent, `ᴾR_C` and `ᴾp_C`
/// (Yoosefian 2021, section 2), as is every pose in `poses`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FramesRequest {
    /// What is known, in any order and direction; 32 at most.
    pub poses: Vec<GivenPose>,
    /// The frame that is asked about.
    pub child: String,
    /// The frame in which its pose is asked for.
    pub parent: String,
    /// A point in coordinates of the child, wanted in all frames; empty where there is none.
    #[serde(default)]
    pub point: Text,
    /// What four numbers are declared to mean where a pose does not say it, and the convention of
    /// `declared` in the answer. The body is the child, the world the parent.
    pub convention: Convention,
    /// What nine numbers are declared to mean where a pose does not say it, and the rotation of sixteen;
    /// body to world, which is child to parent, where it is left out.
    #[serde(default)]
    pub matrix: MatrixConvention,
    /// The sequence of the Euler angles in the answer; intrinsic ZYX where it is left out.
    #[serde(default)]
    pub euler: EulerSequence,
}

/// The pose of one frame in another, as it is known.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GivenPose {
    /// The name of the frame in which the pose is given.
    pub parent: String,
    /// The name of the frame whose pose it is.
    pub child: String,
    /// The attitude of the child in the parent in any accepted form, or a text that holds a position too,
    /// such as a matrix of sixteen numbers.
    pub rotation: Text,
    /// The origin of the child in coordinates of the parent; empty where it is not known, or where the
    /// text of the rotation has it.
    #[serde(default)]
    pub position: Text,
    /// What four numbers are declared to mean; that of the request where it is left out.
    #[serde(default)]
    pub convention: Option<Convention>,
    /// What nine or sixteen numbers are declared to mean; that of the request where it is left out.
    #[serde(default)]
    pub matrix: Option<MatrixConvention>,
}

impl FramesRequest {
    /// The request without a point, with matrices child to parent and the Euler angles of the aerospace
    /// sequence.
    ///
    /// ```
    /// use quatlas::{Convention, FramesRequest, GivenPose, Outcome, Request, analyze};
    /// // A JPL filter, parent to child: the body I is turned by 90° about z in G, the camera C is 1 ahead of it.
    /// let poses = vec![
    ///     GivenPose::new("G", "I", "0 0 √½ √½", "5 0 0"),
    ///     GivenPose::new("I", "C", "0 0 0 1", "1 0 0"),
    /// ];
    /// let request = FramesRequest::new(poses, "C", "G", Convention::JPL);
    /// let Outcome::Frames(report) = analyze(&Request::Frames(request)) else { panic!("answered") };
    /// // Ahead of the body is the y axis of G; as Hamilton's, or body to world, it would be at (5, −1, 0).
    /// assert_eq!(report.answer.expect("they are joined").position, Some([5.0, 1.0, 0.0]));
    /// ```
    #[must_use]
    pub fn new(poses: Vec<GivenPose>, child: &str, parent: &str, convention: Convention) -> Self {
        Self {
            poses,
            child: child.to_owned(),
            parent: parent.to_owned(),
            point: String::new(),
            convention,
            matrix: MatrixConvention::default(),
            euler: EulerSequence::default(),
        }
    }

    /// The text of a field of the question.
    #[must_use]
    pub fn text(&self, field: Field) -> &str {
        match field {
            Field::Parent => &self.parent,
            Field::Child => &self.child,
            _ => &self.point,
        }
    }
}

impl GivenPose {
    /// The text of a field.
    #[must_use]
    pub fn text(&self, field: Field) -> &str {
        match field {
            Field::Parent => &self.parent,
            Field::Child => &self.child,
            Field::Position => &self.position,
            _ => &self.rotation,
        }
    }

    /// The pose of `child` in `parent` in the convention of the request.
    #[must_use]
    pub fn new(parent: &str, child: &str, rotation: &str, position: &str) -> Self {
        Self {
            parent: parent.to_owned(),
            child: child.to_owned(),
            rotation: rotation.to_owned(),
            position: position.to_owned(),
            convention: None,
            matrix: None,
        }
    }
}

/// Where one frame stands in another, and every other frame with them.
///
/// Poses and frames are told by their places in the lists, from 0.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FramesReport {
    /// What became of each pose, in their order. The first that is beyond the most that are read has a
    /// problem that says so, and those after it are not here.
    pub poses: Vec<ReadPose>,
    /// Every frame that the poses name: first the parent that is asked for, the others as they come.
    pub frames: Vec<PlacedFrame>,
    /// From the parent that is asked for to the child, over the fewest poses; empty where there is no
    /// answer.
    pub path: Vec<PathStep>,
    /// The pose that is asked for; absent where the question has a problem.
    pub answer: Option<FoundPose>,
    /// One for each pose beyond those that suffice.
    pub loops: Vec<PoseLoop>,
    /// Why the question has no answer, or the point none.
    pub problems: Vec<Problem>,
    /// What a careful reader should know of the question.
    pub notes: Vec<Note>,
}

/// One pose as it was read: of the child, a body, in the parent, a world.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ReadPose {
    /// The rotation; absent where it could not be read, or where nothing was typed at all.
    pub quaternion: Option<ReadQuaternion>,
    /// The factor that it is in a product of Hamilton quaternions, child to parent: with norm 1, and the
    /// sign of what was typed. Its four components are those of the JPL quaternion parent to child too.
    pub unit: Option<Components>,
    /// The turn that carries the axes of the parent onto those of the child.
    pub turn: Option<Turn>,
    /// The origin of the child in coordinates of the parent; absent where it is not known.
    pub position: Option<[f64; 3]>,
    /// Why it could not be read. It takes no part then, and the others do.
    pub problems: Vec<Problem>,
    /// What a careful reader should know of its texts.
    pub notes: Vec<Note>,
}

/// A frame, where it stands in the first of the list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PlacedFrame {
    /// Its name.
    pub name: String,
    /// The matrix that takes its coordinates to those of the first frame, row by row: its columns are its
    /// axes. Absent where nothing joins the two.
    pub matrix: Option<[[f64; 3]; 3]>,
    /// Its origin in coordinates of the first frame.
    pub origin: Option<[f64; 3]>,
    /// The point that was given, in coordinates of this frame.
    pub point: Option<[f64; 3]>,
}

/// One step from the parent that is asked for towards the child.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PathStep {
    /// The pose that is multiplied.
    pub pose: usize,
    /// Whether it is its inverse that is: the step leads from its child to its parent.
    pub inverted: bool,
    /// The frame that it leads to.
    pub frame: usize,
}

/// The pose of the child in the parent.
///
/// Along `parent, A, B, child` its quaternions are `q_PA ∘ q_AB ∘ q_BC` in a convention whose
/// [`chain_first`](crate::Rules::chain_first) is left, such as Hamilton (Cheng 2018, eq. 2.23), and
/// `q_BC ∘ q_AB ∘ q_PA` where that is right, such as JPL (eq. 2.25).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundPose {
    /// The rotation in the declared convention; in each column `image` is the point turned, without the
    /// position.
    pub declared: Column,
    /// The rotation as a Hamilton quaternion, child to parent.
    pub hamilton: Column,
    /// The same rotation as a JPL quaternion, parent to child.
    pub jpl: Column,
    /// The turn that carries the axes of the parent onto those of the child.
    pub turn: Turn,
    /// The rotation as Euler angles in the requested sequence.
    pub euler: Euler,
    /// The origin of the child in coordinates of the parent; absent where a pose on the way has none.
    pub position: Option<[f64; 3]>,
    /// The matrix that takes `(x, y, z, 1)` of the child to that of the parent.
    pub homogeneous: Option<[[f64; 4]; 4]>,
    /// Its inverse, from the parent to the child.
    pub inverse_homogeneous: Option<[[f64; 4]; 4]>,
    /// The position if that of an inverted pose is taken back on the axes of its child in place of those of
    /// its parent, as Yoosefian 2021 prints it (section 2, `ᴳp_I2`).
    pub misprinted_position: Option<[f64; 3]>,
    /// How far that is from the right position; 0 where no pose is inverted.
    pub misprinted_distance: Option<f64>,
}

/// A pose beyond those that suffice, which has to agree with the path over the others.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct PoseLoop {
    /// The pose.
    pub pose: usize,
    /// The frames of the path over the others, from its parent to its child.
    pub frames: Vec<usize>,
    /// How far the attitude of the child by the one is from that by the others, in degrees.
    pub angle_deg: f64,
    /// How far apart they put its origin; absent where a position is not known.
    pub distance: Option<f64>,
    /// The pose whose inverse closes the loop, where it is open: child and parent are exchanged. It is looked
    /// for in the first four open loops.
    pub inverse_closes: Option<usize>,
    /// The pose that closes it with the inverse of its rotation alone: the convention is another one.
    pub transpose_closes: Option<usize>,
}

impl FramesReport {
    /// With every span counted in UTF-16 units of the text it points into.
    pub(crate) fn in_utf16(
        mut self,
        text_of_pose: impl Fn(Field, usize) -> String,
        text_of_question: impl Fn(Field) -> String,
    ) -> Self {
        for (at, pose) in self.poses.iter_mut().enumerate() {
            for problem in &mut pose.problems {
                problem.span = problem.span.in_utf16(&text_of_pose(problem.field, at));
            }
        }
        for problem in &mut self.problems {
            problem.span = problem.span.in_utf16(&text_of_question(problem.field));
        }
        self
    }
}
