//! The whole road: a request in, an outcome out.
//!
//! Text is parsed, tagged with its convention, turned into the canonical
//! rotation, and written back in the conventions of the answer. Any step may
//! stop with problems; nothing is thrown and nothing is printed.

// One attitude in all conventions.
#[cfg(feature = "whole")]
pub(crate) mod atlas;

// A text to an attitude, and the attitude to numbers in a convention.
mod attitude;

// From one attitude to another.
#[cfg(feature = "whole")]
pub(crate) mod between;

// Many attitudes one after the other.
#[cfg(feature = "whole")]
pub(crate) mod chain;

// A library's line of code, with numbers.
mod code_line;

// Two quaternions together.
pub(crate) mod compose;

/// What a convention is called and does, and a rotation in the representations that need no text.
pub mod describe;

// Names of frames.
#[cfg(feature = "whole")]
mod frame_names;

// Poses between named frames.
#[cfg(feature = "whole")]
pub(crate) mod frames;

/// Which convention a library uses.
pub mod identify;

// Nine numbers to an attitude, or what is nearest to them.
mod matrix;

// What moves one attitude.
#[cfg(feature = "whole")]
pub(crate) mod motion;

// Which norms are those of rotations.
mod norm;

// What a careful reader should know.
mod notes;

// Which description of an attitude numbers are.
pub(crate) mod numbers;

// Numbers as reports have them.
mod plain_numbers;

// What one attitude means.
pub(crate) mod read;

// A text to an attitude.
mod reading;

// The attitude in a whole block of text.
#[cfg(feature = "whole")]
mod record;

// Which of several rotations in a text is meant.
#[cfg(feature = "whole")]
mod record_choices;

// What a rotation in a block is likely to be.
#[cfg(feature = "whole")]
mod record_kind;

// The numbers of records that have no quaternion.
mod record_numbers;

// What else is told of a block.
#[cfg(feature = "whole")]
mod record_told;

// A turn about an axis, and the rest.
#[cfg(feature = "whole")]
pub(crate) mod swing_twist;

/// From one end of a translation to the other.
pub mod translate;

// What comes of a translation of which a step is left out.
mod translate_mistakes;

// What a text says apart from its numbers.
#[cfg(feature = "whole")]
mod said_elsewhere;

// The text of a vector.
mod vector;

#[cfg(feature = "whole")]
use crate::analyze::atlas::atlas;
#[cfg(feature = "whole")]
use crate::analyze::between::between;
#[cfg(feature = "whole")]
use crate::analyze::chain::chain;
use crate::analyze::compose::compose;
#[cfg(feature = "whole")]
use crate::analyze::frames::frames;
use crate::analyze::identify::identify;
use crate::analyze::identify::matrix_library::identify_matrices;
#[cfg(feature = "whole")]
use crate::analyze::motion::motion;
use crate::analyze::numbers::numbers;
use crate::analyze::read::read;
#[cfg(feature = "whole")]
use crate::analyze::swing_twist::swing_twist;
use crate::analyze::translate::translate;
use crate::contract::request::Request;
use crate::contract::{Outcome, Problems};

/// The answer to a request: a report with notes, or the problems of its texts.
///
/// Nothing that is typed makes it panic, and no number of the answer is NaN, infinite or −0.
///
/// ```
/// use quatlas::{analyze, Convention, Outcome, ReadRequest, Request};
///
/// // Four numbers of a JPL filter: x y z w, world to body; a quarter turn about z.
/// let request = ReadRequest::new("0 0 1/√2 1/√2", "1 0 0", Convention::JPL);
/// let outcome = analyze(&Request::Read(request));
/// let Outcome::Read(report) = outcome else { panic!("{outcome:?}") };
///
/// // The world's x axis, seen from the body, is −y; the body's, seen from the world, is y.
/// assert_eq!(report.jpl.image, Some([0.0, -1.0, 0.0]));
/// assert_eq!(report.hamilton.image, Some([0.0, 1.0, 0.0]));
/// ```
#[must_use]
pub fn analyze(request: &Request) -> Outcome {
    let answered = match request {
        Request::Read(request) => read(request).map(|report| Outcome::Read(Box::new(report))),
        Request::Compose(request) => {
            compose(request).map(|report| Outcome::Compose(Box::new(report)))
        }
        Request::Translate(request) => {
            translate(request).map(|report| Outcome::Translate(Box::new(report)))
        }
        Request::Identify(request) => Ok(Outcome::Identify(Box::new(identify(request)))),
        Request::Matrices(request) => identify_matrices(request)
            .map(Outcome::Matrices)
            .map_err(|problem| vec![problem]),
        Request::Numbers(request) => {
            numbers(request).map(|report| Outcome::Numbers(Box::new(report)))
        }
        #[cfg(feature = "whole")]
        Request::Between(request) => {
            between(request).map(|report| Outcome::Between(Box::new(report)))
        }
        #[cfg(feature = "whole")]
        Request::Chain(request) => chain(request).map(|report| Outcome::Chain(Box::new(report))),
        #[cfg(feature = "whole")]
        Request::Atlas(request) => atlas(request).map(|report| Outcome::Atlas(Box::new(report))),
        #[cfg(feature = "whole")]
        Request::SwingTwist(request) => {
            swing_twist(request).map(|report| Outcome::SwingTwist(Box::new(report)))
        }
        #[cfg(feature = "whole")]
        Request::Frames(request) => Ok(Outcome::Frames(Box::new(frames(request)))),
        #[cfg(feature = "whole")]
        Request::Motion(request) => motion(request).map(|report| Outcome::Motion(Box::new(report))),
    };
    answered.unwrap_or_else(|problems| Outcome::Problems(Problems { problems }))
}
