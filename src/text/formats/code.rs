//! Code of libraries that makes a rotation of an axis, a vector or nine numbers.

use crate::convention::angle::AngleUnit::Radians;
use crate::text::record::format::{Field, Format, Part, Unit};

pub(crate) const CODE: &[Format] = &[
    // `new THREE.Matrix3().set(…)` takes rows, and fills columns; `setFromAxisAngle(new THREE.Vector3(…), angle)`,
    // radians (three.js).
    Format {
        id: "three",
        name: "three.js",
        marks: &["~new THREE.Matrix|~.setFromAxisAngle(new THREE.Vector3("],
        order: None,
        fields: &[
            Field::VectorThenAngle(Unit::Always(Radians)),
            Field::Under("set", &[Part::Rows]),
            Field::Under("set", &[Part::HomogeneousRows(16)]),
        ],
    },
    // The length of a vector is the angle about it (three.js, Eigen).
    Format {
        id: "three",
        name: "three.js",
        marks: &["~.setFromAxisAngle(v.clone().normalize(), v.length())"],
        order: None,
        fields: &[Field::Under("v|Vector3", &[Part::RotationVector(Radians)])],
    },
    Format {
        id: "eigen",
        name: "Eigen",
        marks: &["~AngleAxis", "~(v.norm(), v.normalized())"],
        order: None,
        fields: &[Field::Under(
            "v|Vector3d|Vector3f",
            &[Part::RotationVector(Radians)],
        )],
    },
    // `quaternion([…], "rotvec")`, radians (MATLAB).
    Format {
        id: "matlab",
        name: "MATLAB",
        marks: &["~], \"rotvec\")|~], 'rotvec')"],
        order: None,
        fields: &[Field::Under("quaternion", &[Part::RotationVector(Radians)])],
    },
    // `Rotation.from_rotvec(angle * np.array([…]))`, radians (SciPy).
    Format {
        id: "scipy",
        name: "SciPy",
        marks: &["~from_rotvec(", "~ * np.array("],
        order: None,
        fields: &[Field::VectorThenAngle(Unit::Usually(Radians))],
    },
    // `UnitQuaternion::from_axis_angle(&Unit::new_normalize(Vector3::new(…)), angle)`, radians (nalgebra).
    Format {
        id: "nalgebra",
        name: "nalgebra",
        marks: &["~from_axis_angle(&Unit::new_"],
        order: None,
        fields: &[Field::VectorThenAngle(Unit::Always(Radians))],
    },
];
