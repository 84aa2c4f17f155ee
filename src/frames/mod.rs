//! Frames: poses between them, and other names for their axes.

/// Other names for the same axes.
pub mod axis_mapping;

/// Poses between named frames.
pub mod pose;
