//! One attitude in all conventions: which of them is mine?

use crate::analyze::attitude::{Attitude, Declared, column_alone};
use crate::contract::request::AtlasRequest;
use crate::contract::{AtlasReport, Column};
use crate::convention::order::ComponentOrder;
use crate::convention::{Convention, Direction, Function, Handedness};
use crate::problem::{Field, Problem};

pub(crate) fn atlas(request: &AtlasRequest) -> Result<AtlasReport, Vec<Problem>> {
    let declared = Declared::plain(request.convention, request.matrix);
    let attitude = Attitude::of_text(&request.quaternion, Field::Quaternion, declared)
        .map_err(|problem| vec![problem])?;
    let mut rows: Vec<Column> = Vec::new();
    let mut same_as = Vec::new();
    for place in 0..16 {
        let convention = Convention {
            order: ComponentOrder::ALL[place / 8],
            handedness: Handedness::ALL[place / 4 % 2],
            function: Function::ALL[place / 2 % 2],
            direction: Direction::ALL[place % 2],
            perturbation: request.convention.perturbation,
        };
        let row = column_alone(&attitude.tagged, &attitude.rotation, convention);
        let array = row.quaternion.array;
        let first = rows
            .iter()
            .position(|other| other.quaternion.array == array);
        same_as.push(first.unwrap_or(place));
        rows.push(row);
    }
    Ok(AtlasReport {
        quaternion: attitude.as_read(),
        rows,
        same_as,
        paired: attitude.paired(request.matrix),
        notes: attitude.notes(Field::Quaternion),
    })
}
