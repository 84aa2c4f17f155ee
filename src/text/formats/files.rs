//! Other files.

use crate::text::record::format::{Field, Format, Part};

pub(crate) const FILES: &[Format] = &[
    // Eighteen numbers, the first nine column by column (PyMOL, set_view).
    Format {
        id: "pymol-set-view",
        name: "PyMOL",
        marks: &["set view"],
        order: None,
        fields: &[Field::Under("set_view", &[Part::Columns, Part::Skip(9)])],
    },
];
