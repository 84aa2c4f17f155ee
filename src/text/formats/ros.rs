//! ROS and what belongs to it.

use crate::convention::angle::AngleUnit::{Degrees, Radians};
use crate::convention::order::ComponentOrder::{ScalarFirst, ScalarLast};
use crate::text::record::format::{Angles, Field, Format, Letters, Part, Unit};

/// Yaw, pitch, roll in this order, about moving z, y, x.
const YAW_PITCH_ROLL: Part = Part::Euler(Angles::new("ZYX", Unit::Always(Radians)));

/// Roll, pitch, yaw about the fixed axes x, y, z.
const ROLL_PITCH_YAW: Part = Part::Euler(Angles::new("xyz", Unit::Usually(Radians)));

pub(crate) const ROS: &[Format] = &[
    // `- Rotation: in Quaternion [x, y, z, w]`, and below it `in RPY (radian)`, `in RPY (degree)` (tf_echo of
    // geometry, tf2_echo of geometry2: about the fixed axes).
    Format {
        id: "tf2",
        name: "tf_echo",
        marks: &["~in Quaternion", "~in RPY|~Translation:"],
        order: Some(ScalarLast),
        fields: &[
            Field::Under("quaternion", &[Part::Quaternion(Some(ScalarLast))]),
            Field::Under("rpy", &[ROLL_PITCH_YAW]),
        ],
    },
    // `Setting goal: Frame:map, Position(x, y, z), Orientation(x, y, z, w) = Angle: 1.2` (RViz, tool of goals).
    Format {
        id: "ros-geometry-msgs",
        name: "RViz",
        marks: &["~Setting goal", "~Frame:", "~Orientation("],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `Orientation  x; y; z; w` of a row of a display (RViz, tree of TF).
    Format {
        id: "ros-geometry-msgs",
        name: "RViz",
        marks: &["~Orientation\t|~Orientation ", "~; "],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `(trans, rot) = listener.lookupTransform(…)` (tf, listener.py).
    Format {
        id: "tf-transformations",
        name: "tf",
        marks: &["lookuptransform"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `sim.getObjectQuaternion(h, -1)` gives x, y, z, w (CoppeliaSim, API).
    Format {
        id: "coppeliasim",
        name: "CoppeliaSim",
        marks: &["getobjectquaternion|simxgetobjectquaternion|simgetobjectquaternion"],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `r.as_quat()` gives x, y, z, w unless it is told otherwise (SciPy, Rotation); what holds the call may put
    // them in another order.
    Format {
        id: "scipy-scalar-first",
        name: "SciPy",
        marks: &["~.as_quat(scalar_first=True)\n"],
        order: Some(ScalarFirst),
        fields: &[],
    },
    Format {
        id: "scipy",
        name: "SciPy",
        marks: &[
            "~.as_quat()\n|~.as_quat())\n|~.as_quat() = |~.as_quat(): |~ R.from_quat(|~ Rotation.from_quat(",
        ],
        order: Some(ScalarLast),
        fields: &[],
    },
    // `euler_from_quaternion(q)` prints roll, pitch, yaw in radians (tf.transformations, transformations.py).
    Format {
        id: "tf-transformations",
        name: "tf.transformations",
        marks: &["euler_from_quaternion|euler_from_matrix"],
        order: None,
        fields: &[Field::Under(
            "euler_from_quaternion|euler_from_matrix",
            &[ROLL_PITCH_YAW],
        )],
    },
    // `p.getEulerFromQuaternion(q)`: the same (PyBullet).
    Format {
        id: "pybullet",
        name: "PyBullet",
        marks: &["geteulerfromquaternion|pybullet"],
        order: None,
        fields: &[Field::Under("getEulerFromQuaternion", &[ROLL_PITCH_YAW])],
    },
    // `p.getBasePositionAndOrientation(body)`: `((x, y, z), (x, y, z, w))` (PyBullet quickstart guide).
    Format {
        id: "pybullet",
        name: "PyBullet",
        marks: &["getbasepositionandorientation"],
        order: Some(ScalarLast),
        fields: &[Field::Groups(&[
            &[Part::Position],
            &[Part::Quaternion(Some(ScalarLast))],
        ])],
    },
    // `static_transform_publisher 0.1 0 0.2 1.57 0 0 base_link laser 50`: x y z yaw pitch roll, or x y z qx qy
    // qz qw (geometry2, static_transform_publisher; the period at the end is of ROS 1).
    Format {
        id: "ros-static-transform-publisher",
        name: "static_transform_publisher",
        marks: &["static_transform_publisher"],
        order: Some(ScalarLast),
        fields: &[
            Field::Under(
                "args|arguments|static_transform_publisher",
                &[Part::Position, YAW_PITCH_ROLL],
            ),
            Field::Under(
                "args|arguments|static_transform_publisher",
                &[Part::Position, Part::Quaternion(Some(ScalarLast))],
            ),
        ],
    },
    // `<origin xyz="0 0 0.1" rpy="0 1.57 0"/>` (URDF: radians about fixed x, y, z).
    Format {
        id: "urdf-rpy",
        name: "URDF",
        marks: &["<origin"],
        order: None,
        fields: &[Field::Under("rpy", &[ROLL_PITCH_YAW])],
    },
    // `<pose>0 0 0.1 0 1.57 0</pose>`; since 1.9 `degrees='true'` and `rotation_format='quat_xyzw'`
    // (sdformat_spec, pose.sdf).
    Format {
        id: "sdf-pose",
        name: "SDFormat",
        marks: &["<pose"],
        order: None,
        fields: &[
            Field::Under("pose", &[Part::Position, ROLL_PITCH_YAW]),
            Field::Under(
                "pose",
                &[Part::Position, Part::Quaternion(Some(ScalarLast))],
            ),
        ],
    },
    // `VERTEX_SE3:QUAT id x y z qx qy qz qw`, and an edge with its information matrix (g2o).
    Format {
        id: "g2o-se3-quat",
        name: "g2o",
        marks: &["vertex|edge", "se3"],
        order: Some(ScalarLast),
        fields: &[
            Field::Under(
                "quat",
                &[
                    Part::Skip(1),
                    Part::Position,
                    Part::Quaternion(Some(ScalarLast)),
                ],
            ),
            Field::Under(
                "quat",
                &[
                    Part::Skip(2),
                    Part::Position,
                    Part::Quaternion(Some(ScalarLast)),
                    Part::Skip(21),
                ],
            ),
        ],
    },
    // `<body pos="0 0 1" quat="1 0 0 0">`: w first; euler about moving x, y, z, degrees unless the compiler
    // says otherwise (MuJoCo XML reference, compiler: angle, eulerseq).
    Format {
        id: "mujoco-mjcf",
        name: "MuJoCo",
        marks: &[
            "<body|<geom|<site|<camera|<frame|<inertial|<compiler|<joint|<freejoint|<key|<default",
            "quat|euler|axisangle|xyaxes|zaxis",
        ],
        order: Some(ScalarFirst),
        fields: &[
            Field::Under("quat", &[Part::Quaternion(Some(ScalarFirst))]),
            Field::Under(
                "euler",
                &[Part::Euler(
                    Angles::new("XYZ", Unit::Usually(Degrees)).lettered(Letters::SmallMove),
                )],
            ),
            Field::Under("axisangle", &[Part::AxisAngle(Unit::Usually(Degrees))]),
            Field::Under("xyaxes", &[Part::XyAxes]),
        ],
    },
];
