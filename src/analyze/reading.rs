//! A text to an attitude: as a rotation by itself, then as a block that holds one.

use crate::analyze::attitude::{Attitude, Declared, unit_assumed};
#[cfg(feature = "whole")]
use crate::analyze::record::of_record;
#[cfg(feature = "whole")]
use crate::analyze::said_elsewhere::said_elsewhere;
#[cfg(feature = "whole")]
use crate::character::is_alphabetic;
use crate::convention::angle::AngleUnit;
use crate::problem::fault::Fault;
use crate::problem::{Field, Problem};
#[cfg(feature = "whole")]
use crate::problem::{Wanted, is_too_long};
#[cfg(feature = "whole")]
use crate::text::in_known_notation;
use crate::text::mend::unit;
use crate::text::mend::with_suggestion;
#[cfg(feature = "whole")]
use crate::text::{made_above, marked_label};

impl Attitude {
    /// The attitude that a text holds, or its first problem with what to write instead.
    pub(crate) fn of_text(text: &str, field: Field, declared: Declared) -> Result<Self, Problem> {
        #[cfg(feature = "whole")]
        let known = in_known_notation(text);
        #[cfg(feature = "whole")]
        let text = known.as_deref().unwrap_or(text);
        let attitude = Self::read(text, declared).map_err(|fault| {
            let read = |candidate: &str| Self::plain(candidate, declared).map(drop);
            with_suggestion(fault, text, &read).in_field(field)
        })?;
        let attitude = attitude.with_meanings(text);
        #[cfg(feature = "whole")]
        let elsewhere = said_elsewhere(text, &attitude);
        #[cfg(feature = "whole")]
        let attitude = attitude.telling(elsewhere);
        if attitude.unit.is_some() {
            return Ok(attitude);
        }
        let is_read = |text: &str| Self::plain(text, declared).is_ok();
        let texts = unit::inside_functions(text, &is_read);
        Ok(Self {
            unit: texts.map(|texts| unit_assumed(AngleUnit::Radians, texts)),
            ..attitude
        })
    }

    fn read(text: &str, declared: Declared) -> Result<Self, Fault> {
        #[cfg(feature = "whole")]
        if let Some((label, what)) = marked_label(text) {
            let name = &text[label.start..label.end];
            return Err(Fault::other_label(label, name, what, Wanted::Quaternion));
        }
        #[cfg(feature = "whole")]
        if let Some((code, what)) = made_above(text) {
            return Err(Fault::other_comment(code, what, Wanted::Quaternion));
        }
        let plain = Self::plain(text, declared);
        #[cfg(feature = "whole")]
        if may_be_block(text, &plain)
            && let Some(found) = of_record(text, declared, &plain)
        {
            return found;
        }
        plain
    }
}

/// Whether a text may hold more than the rotation that it is read as, or one that it is not read as.
#[cfg(feature = "whole")]
fn may_be_block(text: &str, plain: &Result<Attitude, Fault>) -> bool {
    match plain {
        Ok(_) => text.contains(is_alphabetic) && text.contains([':', '=', '\n', '<', '(']),
        Err(_) => !is_too_long(text) && !text.trim().is_empty(),
    }
}
