//! Frames: poses between them, and other names for their axes.

/// Other names for the same axes.
pub mod axis_mapping;

/// The names of axes in texts.
pub mod axis_names;

// What follows from what is known between frames.
#[cfg(feature = "whole")]
pub(crate) mod network;

/// Poses between named frames.
pub mod pose;
