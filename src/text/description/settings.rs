//! Named words that say something of all the numbers beside them: a unit, an order.

use crate::convention::angle::AngleUnit;
use crate::convention::order::ComponentOrder;
use crate::problem::fault::Fault;
use crate::text::description::named_parts;
use crate::text::grammar::lex::{Token, TokenKind};
use crate::text::grammar::tree::Key;
use crate::text::vocabulary::labels::order_alone;
use crate::text::vocabulary::phrases::{is_mark, is_name, is_sequence, names_axes, phrase_ahead};

/// What named words say of all the numbers: `"unit": "deg"`, `order: xyzw`, `degrees=True`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Settings<'t> {
    pub(crate) unit: Option<(AngleUnit, Key<'t>)>,
    pub(crate) order: Option<(ComponentOrder, Key<'t>)>,
    /// The sequence of angles that have names, as written.
    pub(crate) sequence: Option<(&'t str, Key<'t>)>,
}

/// How names end whose value is the order of four components.
const ORDERING: [&str; 4] = ["order", "format", "layout", "convention"];

impl<'t> Settings<'t> {
    /// Takes in what a name and its value say, and whether they say anything.
    fn take(&mut self, name: &Token<'t>, value: &Token<'t>) -> Result<bool, Fault> {
        let key = Key {
            heading: None,
            name: name.text,
            span: name.span,
        };
        let word = value.text.to_ascii_lowercase();
        let is_true = match (value.kind, word.as_str()) {
            (TokenKind::Word, "true") => Some(true),
            (TokenKind::Word, "false") => Some(false),
            _ => None,
        };
        let name = name.text.to_ascii_lowercase().replace('_', "");
        let (unit, order) = match (name.as_str(), is_true) {
            ("unit" | "units" | "angleunit" | "angleunits", _) => (AngleUnit::named(&word), None),
            ("degrees", Some(true)) => (Some(AngleUnit::Degrees), None),
            ("degrees", Some(false)) => (Some(AngleUnit::Radians), None),
            ("scalarfirst", Some(true)) => (None, Some(ComponentOrder::ScalarFirst)),
            ("scalarfirst", Some(false)) => (None, Some(ComponentOrder::ScalarLast)),
            // `order`, `quaternion_order`
            (name, _) if ORDERING.iter().any(|ends| name.ends_with(ends)) => {
                (None, order_alone(&word))
            }
            _ => (None, None),
        };
        if let Some(unit) = unit
            && self
                .unit
                .replace((unit, key))
                .is_some_and(|(other, _)| other != unit)
        {
            return Err(Fault::mixed_units(key.span.to(value.span)));
        }
        if let Some(order) = order
            && self
                .order
                .replace((order, key))
                .is_some_and(|(other, _)| other != order)
        {
            return Err(Fault::unknown_argument(key.span, key.name));
        }
        Ok(unit.is_some() || order.is_some())
    }

    /// Takes in the sequence of named angles that a name and its value say, and whether they do.
    fn take_sequence(&mut self, name: &Token<'t>, value: &Token<'t>) -> Result<bool, Fault> {
        const NAMES: [&str; 7] = [
            "order",
            "sequence",
            "seq",
            "axes",
            "convention",
            "format",
            "type",
        ];
        let lower = name.text.to_ascii_lowercase();
        let is_it = NAMES.iter().any(|known| lower.ends_with(known));
        if !(is_it && names_axes(value.text)) {
            return Ok(false);
        }
        let key = Key {
            heading: None,
            name: name.text,
            span: name.span,
        };
        match self.sequence.replace((value.text, key)) {
            Some((other, _)) if other != value.text => {
                Err(Fault::unknown_argument(key.span, key.name))
            }
            _ => Ok(true),
        }
    }

    /// That nothing is said of a unit, because there is no angle, or its call has a unit.
    pub(crate) fn check_no_unit(&self) -> Result<(), Fault> {
        match self.unit {
            Some((_, key)) => Err(Fault::unknown_argument(key.span, key.name)),
            None => Ok(()),
        }
    }

    /// That nothing is said of a unit or an order, because the numbers have neither.
    pub(crate) fn check_nothing_said(&self) -> Result<(), Fault> {
        self.check_no_unit()?;
        self.check_order(None)
    }

    /// That nothing is said of an order which these numbers do not have.
    pub(crate) fn check_order(&self, own: Option<ComponentOrder>) -> Result<(), Fault> {
        match self.order {
            Some((order, key)) if own != Some(order) => {
                Err(Fault::unknown_argument(key.span, key.name))
            }
            _ => Ok(()),
        }
    }
}

/// The settings among tokens, and the tokens without them; the arguments of calls are left alone.
pub(crate) fn without_settings<'t>(
    tokens: &[Token<'t>],
) -> Result<(Vec<Token<'t>>, Settings<'t>), Fault> {
    let mut settings = Settings::default();
    let mut rest: Vec<Token<'t>> = Vec::new();
    let mut is_call = Vec::new();
    let mut open_calls = 0_usize;
    let has_names = tokens.iter().any(named_parts::is_named_angle);
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        match token.kind {
            TokenKind::Open(_) => {
                let before = at.checked_sub(1).map(|before| &tokens[before..]);
                let calls = before.is_some_and(|from| {
                    from[0].kind == TokenKind::Word
                        && phrase_ahead(from).is_none()
                        && !is_sequence(from[0].text)
                });
                is_call.push(calls);
                open_calls += usize::from(calls);
            }
            TokenKind::Close(_) => {
                open_calls -= usize::from(is_call.pop().unwrap_or_default());
            }
            _ => {}
        }
        if open_calls == 0
            && let Some([name, mark, value]) = tokens.get(at..at + 3)
            && is_name(name)
            && is_mark(Some(mark))
            && is_name(value)
            && (settings.take(name, value)?
                || (has_names && settings.take_sequence(name, value)?))
        {
            at += 3;
            let is_comma = |token: Option<&Token<'_>>| {
                token.is_some_and(|token| token.kind == TokenKind::Comma)
            };
            if is_comma(rest.last()) {
                rest.pop();
            } else if is_comma(tokens.get(at)) {
                at += 1;
            }
            continue;
        }
        rest.push(*token);
        at += 1;
    }
    Ok((rest, settings))
}
