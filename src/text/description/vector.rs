//! Members of a text to three numbers, and what is read of a vector and of a quaternion alike.

use crate::problem::fault::Fault;
use crate::problem::{Span, Wanted};
use crate::text::description::label;
use crate::text::description::list::{check_separators, held, values};
use crate::text::description::named_members::{component, named, without_options};
use crate::text::grammar::arithmetic::Linear;
use crate::text::grammar::tree::{Entry, Key, Lead, NodeKind};
use crate::text::vocabulary::constructors;
use nalgebra::Vector3;
use std::borrow::Cow;

pub(crate) fn vector(entries: &[Entry<'_>], span: Span) -> Result<Vector3<f64>, Fault> {
    let (entries, _) = without_label(entries, Wanted::Vector)?;
    if let [only] = &entries[..]
        && only.key.is_none()
    {
        match (&only.node.kind, held(&only.node)) {
            (_, Some(inner)) => {
                return vector(&without_options(inner)?, only.node.span);
            }
            (NodeKind::Call { name, .. }, None) => {
                return Err(Fault::not_applied(only.node.span, name, Wanted::Vector));
            }
            _ => {}
        }
    }
    if entries.iter().any(|entry| entry.key.is_some()) {
        let [_, x, y, z] = named(&entries, span, Wanted::Vector)?;
        return Ok(Vector3::new(x, y, z));
    }
    let values = values(&entries)?;
    if let Some(sum) = sum_of_members(&entries, &values)? {
        if sum.scalar != 0.0 {
            return Err(Fault::scalar_in_vector(span));
        }
        return Ok(sum.units.unwrap_or_default().into());
    }
    numbers(&entries, &values, span, Wanted::Vector).map(|xyz: [f64; 3]| xyz.into())
}

/// The members without the name of the whole, as in `q = 0.92 + 0.38k`, and that name.
///
/// In the field of a vector `x = [1, 0, 0]` and `x = 1 0 0` name the whole as well. A name that
/// announces something else, such as `rpy`, is a problem.
pub(super) fn without_label<'e, 't>(
    entries: &'e [Entry<'t>],
    wanted: Wanted,
) -> Result<(Cow<'e, [Entry<'t>]>, Option<Key<'t>>), Fault> {
    let label = match entries {
        [first, rest @ ..] if rest.iter().all(|entry| entry.key.is_none()) => {
            first.key.filter(|key| {
                let holds_all =
                    matches!(first.node.kind, NodeKind::List(_) | NodeKind::Call { .. })
                        || rest.len() + 1 == Wanted::Vector.count();
                component(key.name).is_none() || (wanted == Wanted::Vector && holds_all)
            })
        }
        _ => None,
    };
    let mut entries = Cow::Borrowed(entries);
    if let Some(label) = label {
        if constructors::is_other_label(label.name) {
            return Err(Fault::not_applied(label.span, label.name, wanted));
        }
        label::check(label.name, label.span, wanted)?;
        entries.to_mut()[0].key = None;
    }
    Ok((entries, label))
}

/// As many plain numbers as are wanted.
pub(super) fn numbers<const COUNT: usize>(
    entries: &[Entry<'_>],
    values: &[(Linear, Span)],
    span: Span,
    wanted: Wanted,
) -> Result<[f64; COUNT], Fault> {
    check_separators(entries, span)?;
    if values.len() != COUNT {
        return Err(Fault::wrong_count(span, wanted, values.len()));
    }
    let mut numbers = [0.0; COUNT];
    for (number, (value, _)) in numbers.iter_mut().zip(values) {
        *number = value.scalar;
    }
    Ok(numbers)
}

/// The sum of members such as `0.92` and `+0.38k`, which a list reads apart; `None` where there is
/// no unit.
pub(super) fn sum_of_members(
    entries: &[Entry<'_>],
    values: &[(Linear, Span)],
) -> Result<Option<Linear>, Fault> {
    if values.iter().all(|(value, _)| value.units.is_none()) {
        return Ok(None);
    }
    let mut sum = Linear::real(0.0);
    for (entry, &(value, span)) in entries.iter().zip(values) {
        if matches!(entry.lead, Lead::Bare | Lead::AfterComma) {
            return Err(Fault::missing_sign(span));
        }
        sum = sum.plus(value, span)?;
    }
    Ok(Some(sum))
}
