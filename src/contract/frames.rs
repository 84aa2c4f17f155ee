//! What follows from poses between named frames.

use crate::contract::attitude::{Column, Components, Euler, ReadQuaternion, Turn};
use crate::contract::note::Note;
use crate::problem::{Field, Problem};
use serde::{Deserialize, Serialize};

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
