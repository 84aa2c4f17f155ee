//! What is typed.

/// What is typed. From JavaScript it may also be numbers, which are read as they would be typed: a number, a
/// list of them, or rows of them.
pub type Text = String;
