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
    // `quatern_b`, `quatern_c`, `quatern_d`: the scalar is not negative (NIfTI-1, nifti1.h).
    Format {
        id: "nifti",
        name: "NIfTI",
        marks: &["quatern_b"],
        order: None,
        fields: &[Field::NamedUnder("quatern", "b c d", &[Part::Imaginary])],
    },
    // `Parameters: x y z tx ty tz` of a versor, whose scalar is not negative (ITK, VersorRigid3DTransform).
    Format {
        id: "itk-versor",
        name: "ITK",
        marks: &["~VersorRigid3DTransform"],
        order: None,
        fields: &[Field::Under(
            "Parameters",
            &[Part::Imaginary, Part::Position],
        )],
    },
    // Each row is its number, the translation, three of the rotation (TM-align, US-align).
    Format {
        id: "tm-align",
        name: "TM-align",
        marks: &["~rotation matrix to rotate", "~t[m]|~t(m)"],
        order: None,
        fields: &[Field::Any(&[Part::HomogeneousRows(15)])],
    },
    // `VIEWPOINT tx ty tz qw qx qy qz` (PCL, PCD file format).
    Format {
        id: "pcd",
        name: "PCD",
        marks: &["viewpoint", "points"],
        order: None,
        fields: &[Field::Under(
            "VIEWPOINT",
            &[Part::Position, Part::Quaternion(Some(ScalarFirst))],
        )],
    },
    // `f 0`, `r x y z`, `t x y z`: about moving x, y, z, degrees (HALCON, write_pose); the last number of a
    // tuple is the same code.
    Format {
        id: "halcon",
        name: "HALCON",
        marks: &["~3D POSE PARAMETERS", "~\nf 0"],
        order: None,
        fields: &[
            Field::Under("r", &[HALCON]),
            Field::Under("t", &[Part::Position]),
        ],
    },
    Format {
        id: "halcon",
        name: "HALCON",
        marks: &["~ := [", "~, 0]"],
        order: None,
        fields: &[Field::Under(
            "pose",
            &[Part::Position, HALCON, Part::Skip(1)],
        )],
    },
];

/// The angles of Bunge as a file has them.
const BUNGE_RADIANS: Part = Part::Euler(Angles::new("ZXZ", Unit::Always(Radians)));

/// Rx Ry Rz, which HALCON calls gba.
const HALCON: Part = Part::Euler(Angles::new("XYZ", Unit::Always(Degrees)));
