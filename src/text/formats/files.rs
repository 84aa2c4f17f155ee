//! Other files: molecules, crystals.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::ScalarFirst;
use crate::text::record::format::{Angles, Field, Format, Part, Unit};

pub(crate) const FILES: &[Format] = &[
    // Eighteen numbers, the first nine column by column (PyMOL, set_view).
    Format {
        id: "pymol-set-view",
        name: "PyMOL",
        marks: &["set view"],
        order: None,
        fields: &[Field::Under("set_view", &[Part::Columns, Part::Skip(9)])],
    },
    // `c_orient[1] … c_orient[4]` of `compute property/atom quatw quati quatj quatk` (LAMMPS).
    Format {
        id: "lammps-quat",
        name: "LAMMPS",
        marks: &["item", "atoms"],
        order: None,
        fields: &[Field::Named(
            "orient1 orient2 orient3 orient4",
            &[Part::Quaternion(None)],
        )],
    },
    // `phi1 PHI phi2` in radians, then x, y, quality, confidence, phase and more (EDAX, .ang).
    Format {
        id: "edax-ang",
        name: "EDAX .ang",
        marks: &["ncols_odd|xstep|sqrgrid|hexgrid"],
        order: None,
        fields: &[
            Field::Row(&[BUNGE_RADIANS, Part::Skip(5)]),
            Field::Row(&[BUNGE_RADIANS, Part::Skip(6)]),
            Field::Row(&[BUNGE_RADIANS, Part::Skip(7)]),
        ],
    },
    // `Euler1 Euler2 Euler3` in degrees (Oxford Instruments, .ctf).
    Format {
        id: "oxford-ctf",
        name: "Oxford .ctf",
        marks: &["euler1"],
        order: None,
        fields: &[Field::Named(
            "euler1 euler2 euler3",
            &[Part::Euler(Angles::new("ZXZ", Unit::Usually(Degrees)))],
        )],
    },
    // `Rotation (1,)` above rows w x y z (orix).
    Format {
        id: "orix-orientation",
        name: "orix",
        marks: &["~Rotation (1,)|~Orientation (1,)|~Misorientation (1,)"],
        order: Some(ScalarFirst),
        fields: &[],
    },
];

/// The angles of Bunge as a file has them.
const BUNGE_RADIANS: Part = Part::Euler(Angles::new("ZXZ", Unit::Always(Radians)));
