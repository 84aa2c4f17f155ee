//! A text that cannot be read, rewritten so that it can be.
//!
//! Only where one way to rewrite it is certain, or does no more than its name says: where two are read,
//! none is offered, and no number that was typed becomes another. Each rewritten text is read before it
//! is offered, so taking it never leads to another problem.

// What numbers may be meant as whose norm is far from 1.
mod meanings;

// Numbers as text.
pub(crate) mod number_text;

// The ways in which a text is rewritten.
pub(crate) mod rewrites;

// The numbers that stand in any text.
pub(crate) mod typed_numbers;

// The texts that say a unit.
pub(crate) mod unit;

// A rotation as a text.
#[cfg(feature = "whole")]
pub(crate) mod written;

use crate::problem::ProblemCode;
use crate::problem::fault::Fault;
use crate::problem::suggestion::Suggestion;
use crate::text::description::ParsedRotation;
use crate::text::description::quaternion::ParsedQuaternion;
use crate::text::mend::meanings::{of_norm, of_two, with_sequences};
use crate::text::mend::rewrites::{Rewrite, rewrites};
use crate::text::mend::typed_numbers::keeps_numbers;

/// Longer texts get no suggestion: the candidates are read on every keystroke.
const LONGEST_TEXT_BYTES: usize = 4096;

/// How many places are mended one after the other.
const MOST_STEPS: usize = 6;

/// Where there are more texts to try, none leads to another place: their number would multiply.
const MOST_TEXTS_OF_A_STEP: usize = 2;

/// The fault with a suggestion, where there is one; `read` tells how a text is read.
pub(crate) fn with_suggestion(
    fault: Fault,
    text: &str,
    read: &dyn Fn(&str) -> Result<(), Fault>,
) -> Fault {
    if text.len() > LONGEST_TEXT_BYTES {
        return fault;
    }
    if cfg!(feature = "whole") && fault.code == ProblemCode::TwoMeanings {
        let Fault { span, .. } = fault;
        return fault.offering(|| of_two(text, span, read));
    }
    if cfg!(feature = "whole") && fault.code == ProblemCode::UnknownSequence {
        let Fault { span, .. } = fault;
        return fault.offering(|| with_sequences(text, span, read));
    }
    fault.suggesting(|fault| {
        rewrites(fault.code).iter().find_map(|&(remedy, rewrite)| {
            let rewritten = mended(fault, text, rewrite, read, MOST_STEPS)?;
            let suggestion = Suggestion::new(remedy, rewritten);
            keeps_numbers(text, &suggestion).then_some(suggestion)
        })
    })
}

/// The texts that say what four numbers are whose norm leaves it open, the likeliest first; `read` tells how
/// a text is read.
pub(crate) fn meanings(
    text: &str,
    parsed: &ParsedQuaternion,
    read: &dyn Fn(&str) -> Option<ParsedRotation>,
) -> Vec<Suggestion> {
    if text.len() > LONGEST_TEXT_BYTES {
        return Vec::new();
    }
    of_norm(text, parsed, read)
}

/// The only text that is read, mending the same kind of problem place by place; `None` where several
/// are.
fn mended(
    fault: &Fault,
    text: &str,
    rewrite: Rewrite,
    read: &dyn Fn(&str) -> Result<(), Fault>,
    steps: usize,
) -> Option<String> {
    let is_mended_so = |next: &Fault| {
        let mut same = rewrites(next.code).iter().map(|&(remedy, _)| remedy);
        rewrites(fault.code)
            .iter()
            .any(|&(remedy, _)| same.any(|other| other == remedy))
    };
    let candidates = rewrite(fault, text);
    let goes_on = steps > 1 && candidates.len() <= MOST_TEXTS_OF_A_STEP;
    let mut only = None;
    for candidate in candidates {
        let found = match read(&candidate) {
            Ok(()) => Some(candidate),
            Err(next) if goes_on && is_mended_so(&next) => {
                mended(&next, &candidate, rewrite, read, steps - 1)
            }
            Err(_) => None,
        };
        if found.is_some() && std::mem::replace(&mut only, found).is_some() {
            return None;
        }
    }
    only
}
