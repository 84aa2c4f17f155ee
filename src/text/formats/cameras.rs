//! Cameras, structure from motion and visual odometry.

use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Field, Format, Part};

pub(crate) const CAMERAS: &[Format] = &[
    // `id qw qx qy qz tx ty tz camera name`: world to camera (COLMAP, doc/format.rst).
    Format {
        id: "colmap-images",
        name: "COLMAP images.txt",
        marks: &["jpg|png|jpeg|bmp|tif|tiff|image id|images txt"],
        order: None,
        fields: &[Field::Row(&[
            Part::Skip(1),
            Part::Quaternion(Some(ScalarFirst)),
            Part::Position,
            Part::Skip(1),
        ])],
    },
    // `Rigid3d(rotation_xyzw=[…], translation=[…])`: the order is in the name (pycolmap).
    Format {
        id: "colmap-rigid3d",
        name: "COLMAP Rigid3d",
        marks: &["rigid3d"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `nanoseconds,px,py,pz,qw,qx,qy,qz,…` (EuRoC MAV dataset, state_groundtruth_estimate0).
    Format {
        id: "euroc-groundtruth",
        name: "EuRoC ground truth",
        marks: &[],
        order: None,
        fields: &[
            Field::CommaRow(&[
                Part::Nanoseconds,
                Part::Position,
                Part::Quaternion(Some(ScalarFirst)),
            ]),
            Field::CommaRow(&[
                Part::Nanoseconds,
                Part::Position,
                Part::Quaternion(Some(ScalarFirst)),
                Part::Skip(9),
            ]),
        ],
    },
    // `timestamp tx ty tz qx qy qz qw` (TUM RGB-D benchmark, file formats).
    Format {
        id: "tum-rgbd-trajectory",
        name: "TUM trajectory",
        marks: &[],
        order: None,
        fields: &[Field::Row(&[
            Part::Skip(1),
            Part::Position,
            Part::Quaternion(Some(ScalarLast)),
        ])],
    },
    // Twelve numbers row by row, perhaps the number of the frame before them (KITTI odometry, poses).
    Format {
        id: "kitti-odometry-poses",
        name: "KITTI poses",
        marks: &[],
        order: None,
        fields: &[Field::Row(&[Part::Skip(1), Part::HomogeneousRows(12)])],
    },
];
