//! The sentences of problems: what is wrong, what was expected, what to try.

// Of whole blocks.
#[cfg(feature = "whole")]
mod block;

// Of Euler sequences and their frames.
mod euler;

// Of named frames and the poses between them.
#[cfg(feature = "whole")]
mod frames;

// Of labels and comments.
mod label;

// Of translation and identification.
mod library;

// Of single characters.
mod mark;

// Of matrices.
pub(crate) mod matrix;

// Of rates, small turns and times.
#[cfg(feature = "whole")]
mod motion;

// Of quaternions whose norm is not that of a rotation.
mod norm;

// Of rotations and what stands for them.
mod rotation;

// Of any text.
pub(crate) mod text;
