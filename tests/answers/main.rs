//! What the requests of attitudes answer, against the golden cases and against other formulas.

#[path = "../support/mod.rs"]
mod support;

mod atlas;
mod between;
mod chain;
mod frames;
mod golden;
mod motion;
mod motion_of_vectors;
mod swing_twist;
