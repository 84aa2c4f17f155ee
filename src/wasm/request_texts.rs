//! The texts of a request: how long they are is known before they are copied.
//!
//! The memory of wasm grows and never shrinks. So of a text that is longer than is read, one piece after
//! the other passes through, only to be counted.

use crate::problem::fault::Fault;
use crate::problem::{Field, MAX_TEXT_BYTES, Problem, ProblemCode, Span};
use js_sys::{JsString, Uint8Array};
use std::cell::{Cell, RefCell};
use wasm_bindgen::prelude::*;

/// The most bytes that all texts of a request have together: hundreds of texts of the greatest length.
const MOST_BYTES_OF_ALL: usize = 256 * MAX_TEXT_BYTES;

/// UTF-16 units that pass through at once, and before which the two halves of a character never part.
const PIECE: u32 = 65_536;

/// The first units of characters that take two, U+D800 to U+DBFF.
const FIRST_HALVES: (f64, f64) = (55_296.0, 56_319.0);

/// What is known of the texts of one request.
#[derive(Default)]
pub(crate) struct Texts {
    too_long: RefCell<Vec<TooLong>>,
    bytes: Cell<usize>,
}

/// A text of which only the beginning was copied.
struct TooLong {
    /// Where the request holds it.
    path: String,
    bytes: usize,
    /// All of it, in UTF-16 units.
    span: Span,
}

impl Texts {
    /// The text, or as much of one that is too long as tells the core so; nothing where all texts together
    /// are too many.
    pub(crate) fn read(&self, text: &JsString, path: &str) -> Option<String> {
        let read = if text.length() as usize > MAX_TEXT_BYTES {
            self.too_long.borrow_mut().push(TooLong::of(text, path));
            beginning(text, MAX_TEXT_BYTES + 1)
        } else {
            JsValue::from(text).as_string().unwrap_or_default()
        };
        self.counted(read)
    }

    /// The text; nothing where all texts together are too many.
    pub(crate) fn counted(&self, read: String) -> Option<String> {
        self.bytes.set(self.bytes.get() + read.len());
        (self.bytes.get() <= MOST_BYTES_OF_ALL).then_some(read)
    }

    /// A problem of a text that is too long, as it is of the whole text, of which so many bytes are read.
    pub(crate) fn of_whole_text(&self, problem: Problem, path: &str, most_bytes: usize) -> Problem {
        let too_long = self.too_long.borrow();
        let Some(whole) = too_long.iter().find(|text| text.path == path) else {
            return problem;
        };
        if problem.code == ProblemCode::TextTooLong {
            let fault = Fault::text_too_long(whole.span, whole.bytes, most_bytes);
            return Problem {
                at: problem.at,
                ..fault.in_field(problem.field)
            };
        }
        Problem {
            span: whole.span,
            ..problem
        }
    }
}

impl TooLong {
    fn of(text: &JsString, path: &str) -> Self {
        let encoder = TextEncoder::new();
        let bytes = pieces(text)
            .into_iter()
            .map(|piece| encoder.encode(&piece).length() as usize);
        Self {
            path: path.to_owned(),
            bytes: bytes.sum(),
            span: Span::from(0..text.length() as usize),
        }
    }
}

#[wasm_bindgen]
extern "C" {
    type TextEncoder;

    #[wasm_bindgen(constructor)]
    fn new() -> TextEncoder;

    #[wasm_bindgen(method)]
    fn encode(this: &TextEncoder, text: &JsString) -> Uint8Array;
}

fn pieces(text: &JsString) -> Vec<JsString> {
    let mut pieces = Vec::new();
    let mut start = 0;
    while start < text.length() {
        let end = end_of_piece(text, start);
        pieces.push(text.slice(start, end));
        start = end;
    }
    pieces
}

/// The first units of a text.
pub(crate) fn beginning(text: &JsString, units: usize) -> String {
    String::from(text.slice(0, u32::try_from(units).unwrap_or(u32::MAX)))
}

fn end_of_piece(text: &JsString, start: u32) -> u32 {
    let end = text.length().min(start.saturating_add(PIECE));
    let last = text.char_code_at(end - 1);
    if (FIRST_HALVES.0..=FIRST_HALVES.1).contains(&last) && end < text.length() {
        end - 1
    } else {
        end
    }
}

/// The member of a request that a problem is about.
pub(crate) const fn member_of(field: Field) -> &'static str {
    match field {
        Field::Quaternion => "quaternion",
        Field::P => "p",
        Field::Q => "q",
        Field::Vector => "vector",
        Field::From => "from.id",
        Field::To => "to.id",
        Field::WorldAxes => "worldAxes",
        Field::BodyAxes => "bodyAxes",
        Field::A => "a",
        Field::B => "b",
        Field::Matrix => "matrix",
        Field::RotationVector => "rotationVector",
        Field::Printed => "printed",
        Field::Numbers => "numbers",
        Field::Yawed => "yawed",
        Field::Product => "product",
        #[cfg(feature = "whole")]
        Field::Part => "part",
        #[cfg(feature = "whole")]
        Field::Axis => "axis",
        #[cfg(feature = "whole")]
        Field::Factor => "factors",
        #[cfg(feature = "whole")]
        Field::Parent => "parent",
        #[cfg(feature = "whole")]
        Field::Child => "child",
        #[cfg(feature = "whole")]
        Field::Rotation => "rotation",
        #[cfg(feature = "whole")]
        Field::Position => "position",
        #[cfg(feature = "whole")]
        Field::Point => "point",
        #[cfg(feature = "whole")]
        Field::Rate => "rate",
        #[cfg(feature = "whole")]
        Field::RateEnd => "rateEnd",
        #[cfg(feature = "whole")]
        Field::Duration => "duration",
        #[cfg(feature = "whole")]
        Field::Increment => "increment",
        #[cfg(feature = "whole")]
        Field::Covariance => "covariance",
    }
}
