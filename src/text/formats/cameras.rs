//! Cameras, structure from motion and visual odometry.

use crate::convention::angle::AngleUnit::Radians;
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Field, Format, Part};

pub(crate) const CAMERAS: &[Format] = &[
    // `id qw qx qy qz tx ty tz camera name`: world to camera (COLMAP, doc/format.rst).
    Format {
        id: "colmap-images-txt",
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
        id: "tum-trajectory",
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
    // `name focal w x y z cx cy cz distortion 0`: the place of the camera, not a translation (VisualSFM, NVM).
    Format {
        id: "visualsfm-nvm",
        name: "VisualSFM NVM",
        marks: &["nvm_v3|nvm_v3_r9t"],
        order: None,
        fields: &[Field::Any(&[
            Part::Skip(1),
            Part::Quaternion(Some(ScalarFirst)),
            Part::Centre,
            Part::Skip(2),
        ])],
    },
    // Focal length, principal point, T, C, rotation vector, w x y z, nine numbers row by row, distortion and
    // zeros (VisualSFM, cameras_v2.txt).
    Format {
        id: "visualsfm-cameras",
        name: "VisualSFM",
        marks: &["jpg|jpeg|png"],
        order: None,
        fields: &[Field::Any(&[
            Part::Skip(3),
            Part::Position,
            Part::Centre,
            Part::RotationVector(Radians),
            Part::Quaternion(Some(ScalarFirst)),
            Part::Rows,
            Part::Skip(4),
        ])],
    },
    // `f k1 k2`, three rows, the translation: P = R X + t (Bundler, user's manual).
    Format {
        id: "bundler",
        name: "Bundler",
        marks: &["bundle file"],
        order: None,
        fields: &[Field::Any(&[Part::Skip(3), Part::Rows, Part::Position])],
    },
    // `"token": …, "translation": […], "rotation": [w, x, y, z]` (nuScenes, schema).
    Format {
        id: "nuscenes-rotation",
        name: "nuScenes",
        marks: &[
            "token|ego_pose_token|sensor_token|sample_token",
            "rotation",
            "translation",
        ],
        order: Some(ScalarFirst),
        fields: &[],
    },
    // `rot_0 0.8 rot_1 0.2 rot_2 -0.4 rot_3 0.4`: the scalar first, of any norm (3D Gaussian Splatting, PLY).
    Format {
        id: "gaussian-splat-ply",
        name: "Gaussian splat",
        marks: &["rot_0", "rot_3"],
        order: None,
        fields: &[Field::Named(
            "rot0 rot1 rot2 rot3",
            &[Part::ScaledQuaternion(ScalarFirst)],
        )],
    },
];
