//! Notations that neither the grammar nor the records know, as the same text in one that they do: LaTeX, and
//! JSON that says in words what it holds.
//!
//! Every byte keeps its place, so that what is marked is marked where it was typed; what says nothing becomes
//! spaces.

// JSON that says in words what it holds.
mod json;

// LaTeX.
mod latex;

use crate::problem::is_too_long;
use crate::text::notation::json::of_json;
use crate::text::notation::latex::of_latex;

/// The text in a notation that is read; `None` where it stands in one, or is too long to be read.
pub(crate) fn in_known_notation(text: &str) -> Option<String> {
    if is_too_long(text) {
        return None;
    }
    of_json(text).or_else(|| of_latex(text))
}
