//! The quantities of a text to what they are: the formats that are marked in it are asked first, then
//! what the names say, then the numbers themselves.

use crate::problem::Span;
use crate::text::record::apart::{axis_beside_angle, positions_beside, split_quaternion};
use crate::text::record::format::Field;
use crate::text::record::found::{Asked, Context, Found};
use crate::text::record::group::Quantities;
use crate::text::record::of_group::{groups_together, of_group, vector_then_angle};
use crate::text::record::of_named::of_named;
use crate::text::record::turns::turns;

/// All that is understood of the quantities of a text.
pub(crate) fn found(
    text: &str,
    quantities: &Quantities<'_>,
    context: &Context,
    plain: &'static [Field],
) -> Vec<Found> {
    let mut fields: Vec<Asked> = Vec::new();
    for &format in &context.formats {
        for field in format.fields {
            fields.push((field, Some(format)));
        }
    }
    for field in plain {
        fields.push((field, None));
    }
    let mut all = groups_together(quantities, context, &fields);
    let taken = all.len();
    for group in &quantities.groups {
        if !all[..taken].iter().any(|found| found.span == group.span) {
            of_group(group, context, &fields, &mut all);
        }
    }
    for named in &quantities.named {
        of_named(named, context, &fields, &mut all);
    }
    all.extend(positions_beside(quantities, &all));
    all.extend(split_quaternion(quantities));
    all.extend(axis_beside_angle(quantities, context));
    all.extend(vector_then_angle(text, quantities, context, &fields));
    let turns = turns(text, quantities, context);
    // What several turns make is one rotation.
    let mut spans: Vec<Span> = Vec::new();
    for turn in &turns {
        let place = spans.partition_point(|span| span.start <= turn.span.start);
        spans.insert(place, turn.span);
    }
    all.retain(|found| {
        let after = spans.partition_point(|span| span.start <= found.span.start);
        let before = after.checked_sub(1).map(|at| spans[at]);
        before.is_none_or(|span| found.span.end > span.end)
    });
    all.extend(turns);
    in_order(all)
}

/// The same as they follow each other in the text. Places are moved, which are small, and not what is found.
fn in_order(mut all: Vec<Found>) -> Vec<Found> {
    let mut order: Vec<usize> = Vec::new();
    for (at, found) in all.iter().enumerate() {
        let place = order.partition_point(|&other| all[other].span.start <= found.span.start);
        order.insert(place, at);
    }
    let mut sorted = Vec::new();
    for at in order {
        let span = all[at].span;
        sorted.push(std::mem::replace(&mut all[at], Found::at(span)));
    }
    sorted
}
