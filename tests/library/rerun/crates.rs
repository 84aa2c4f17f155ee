//! The crates of `src/library/observations.json`, run again: what they print today is what was recorded.

use crate::rerun::{Inputs, Library, assert_version, run_again};
use crate::support::wxyz;
use cgmath::{InnerSpace, Matrix, Rotation, Rotation3};
use quatlas::nalgebra as na;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn nalgebra_prints_what_was_recorded() {
    check::<Nalgebra>();
}

#[wasm_bindgen_test(unsupported = test)]
fn glam_prints_what_was_recorded() {
    check::<Glam>();
}

#[wasm_bindgen_test(unsupported = test)]
fn cgmath_prints_what_was_recorded() {
    check::<Cgmath>();
}

#[wasm_bindgen_test(unsupported = test)]
fn quaternion_core_prints_what_was_recorded() {
    check::<QuaternionCore>();
}

/// Nothing differs, and any one recorded number that were another would be seen.
fn check<L: Library>() {
    assert_version::<L>();
    let mut compared = run_again::<L>();
    let found: Vec<_> = compared.iter().flat_map(|one| one.differences()).collect();
    assert!(found.is_empty(), "{}:\n{}", L::ID, found.join("\n"));
    let count: usize = compared.iter().map(|one| one.recorded.len()).sum();
    assert!(count > 150, "{}: {count} numbers", L::ID);
    for one in &mut compared {
        for at in 0..one.recorded.len() {
            let recorded = one.recorded[at];
            one.recorded[at] = if recorded.is_nan() {
                0.0
            } else {
                recorded + 1e-9
            };
            assert_eq!(one.differences().len(), 1, "{}[{at}]", one.name);
            one.recorded[at] = recorded;
        }
    }
}

struct Nalgebra;

impl Library for Nalgebra {
    const ID: &str = "nalgebra";
    const NOT_RERUN: &[(&str, &str)] = &[
        (
            "other serde order",
            "words, read in its source; its serde feature is not built here",
        ),
        (
            "other slerp antipodal try",
            "a bare true: what was asked is not recorded",
        ),
    ];
    type Quaternion = na::UnitQuaternion<f64>;

    fn named([w, x, y, z]: [f64; 4]) -> Self::Quaternion {
        na::UnitQuaternion::new_unchecked(na::Quaternion::new(w, x, y, z))
    }
    fn construct([w, i, j, k]: [f64; 4]) -> Self::Quaternion {
        na::UnitQuaternion::from_quaternion(na::Quaternion::new(w, i, j, k))
    }
    // Recorded of the constructor that does not normalise; the other one makes NaN of zeros.
    fn construct_zero() -> Self::Quaternion {
        Self::named([0.0; 4])
    }
    fn components(q: Self::Quaternion) -> [f64; 4] {
        wxyz(&q)
    }
    fn array(q: Self::Quaternion) -> Option<[f64; 4]> {
        Some(q.coords.into())
    }
    fn product(a: Self::Quaternion, b: Self::Quaternion) -> Self::Quaternion {
        a * b
    }
    fn matrix(q: Self::Quaternion) -> [[f64; 3]; 3] {
        q.to_rotation_matrix().transpose().into_inner().into()
    }
    fn rotate(q: Self::Quaternion, v: [f64; 3]) -> [f64; 3] {
        (q * na::Vector3::from(v)).into()
    }
    fn norm(q: Self::Quaternion) -> f64 {
        q.norm()
    }
    fn about_z(angle: f64) -> Self::Quaternion {
        na::UnitQuaternion::from_axis_angle(&na::Vector3::z_axis(), angle)
    }
    fn from_matrix(rows: [[f64; 3]; 3]) -> Self::Quaternion {
        na::UnitQuaternion::from_matrix(&na::Matrix3::from(rows).transpose())
    }
    fn slerp(a: Self::Quaternion, b: Self::Quaternion, t: f64) -> Self::Quaternion {
        a.slerp(&b, t)
    }
    fn inverse(q: Self::Quaternion) -> Self::Quaternion {
        q.inverse()
    }
    fn normalize(q: Self::Quaternion) -> Self::Quaternion {
        na::UnitQuaternion::new_normalize(q.into_inner())
    }
    fn euler(call: &str, [a, b, c]: [f64; 3]) -> Option<Self::Quaternion> {
        (call == "UnitQuaternion::from_euler_angles(roll=.3,pitch=.5,yaw=.7)")
            .then(|| na::UnitQuaternion::from_euler_angles(a, b, c))
    }
    fn other(text: &str, inputs: &Inputs) -> Option<Vec<f64>> {
        let q = match text {
            "Quaternion::from(vec4) order" => {
                na::Quaternion::from(na::Vector4::new(0.1, 0.2, 0.3, 0.4))
            }
            "from_rotation_matrix sign (direct, fm[1])" => {
                let matrix = na::Matrix3::from(inputs.matrices[1]).transpose();
                let rotation = na::Rotation3::from_matrix_unchecked(matrix);
                na::UnitQuaternion::from_rotation_matrix(&rotation).into_inner()
            }
            _ => return None,
        };
        Some(wxyz(&q).to_vec())
    }
}

struct Glam;

impl Library for Glam {
    const ID: &str = "glam";
    type Quaternion = glam::DQuat;

    fn named([w, x, y, z]: [f64; 4]) -> Self::Quaternion {
        glam::DQuat::from_xyzw(x, y, z, w)
    }
    fn construct([x, y, z, w]: [f64; 4]) -> Self::Quaternion {
        glam::DQuat::from_xyzw(x, y, z, w)
    }
    fn components(q: Self::Quaternion) -> [f64; 4] {
        [q.w, q.x, q.y, q.z]
    }
    fn array(q: Self::Quaternion) -> Option<[f64; 4]> {
        Some(q.to_array())
    }
    fn product(a: Self::Quaternion, b: Self::Quaternion) -> Self::Quaternion {
        a * b
    }
    fn matrix(q: Self::Quaternion) -> [[f64; 3]; 3] {
        glam::DMat3::from_quat(q).transpose().to_cols_array_2d()
    }
    fn rotate(q: Self::Quaternion, v: [f64; 3]) -> [f64; 3] {
        (q * glam::DVec3::from_array(v)).to_array()
    }
    fn norm(q: Self::Quaternion) -> f64 {
        q.length()
    }
    fn about_z(angle: f64) -> Self::Quaternion {
        glam::DQuat::from_axis_angle(glam::DVec3::Z, angle)
    }
    fn from_matrix(rows: [[f64; 3]; 3]) -> Self::Quaternion {
        glam::DQuat::from_mat3(&glam::DMat3::from_cols_array_2d(&rows).transpose())
    }
    fn slerp(a: Self::Quaternion, b: Self::Quaternion, t: f64) -> Self::Quaternion {
        a.slerp(b, t)
    }
    fn inverse(q: Self::Quaternion) -> Self::Quaternion {
        q.inverse()
    }
    fn normalize(q: Self::Quaternion) -> Self::Quaternion {
        q.normalize()
    }
    fn euler(call: &str, [a, b, c]: [f64; 3]) -> Option<Self::Quaternion> {
        use glam::EulerRot::{XYZ, XYZEx, YXZ, ZXZ, ZYX, ZYXEx};
        let order = match call {
            "DQuat::from_euler(EulerRot::XYZ,.3,.5,.7)" => XYZ,
            "DQuat::from_euler(EulerRot::ZYX,.3,.5,.7)" => ZYX,
            "DQuat::from_euler(EulerRot::YXZ,.3,.5,.7)" => YXZ,
            "DQuat::from_euler(EulerRot::XYZEx,.3,.5,.7)" => XYZEx,
            "DQuat::from_euler(EulerRot::ZYXEx,.3,.5,.7)" => ZYXEx,
            "DQuat::from_euler(EulerRot::ZXZ,.3,.5,.7)" => ZXZ,
            _ => return None,
        };
        Some(glam::DQuat::from_euler(order, a, b, c))
    }
}

struct Cgmath;

impl Library for Cgmath {
    const ID: &str = "cgmath";
    type Quaternion = cgmath::Quaternion<f64>;

    fn named([w, x, y, z]: [f64; 4]) -> Self::Quaternion {
        cgmath::Quaternion::new(w, x, y, z)
    }
    fn construct([w, xi, yj, zk]: [f64; 4]) -> Self::Quaternion {
        cgmath::Quaternion::new(w, xi, yj, zk)
    }
    fn components(q: Self::Quaternion) -> [f64; 4] {
        [q.s, q.v.x, q.v.y, q.v.z]
    }
    fn array(q: Self::Quaternion) -> Option<[f64; 4]> {
        Some(q.into())
    }
    fn product(a: Self::Quaternion, b: Self::Quaternion) -> Self::Quaternion {
        a * b
    }
    fn matrix(q: Self::Quaternion) -> [[f64; 3]; 3] {
        cgmath::Matrix3::from(q).transpose().into()
    }
    fn rotate(q: Self::Quaternion, v: [f64; 3]) -> [f64; 3] {
        (q * cgmath::Vector3::from(v)).into()
    }
    fn norm(q: Self::Quaternion) -> f64 {
        q.magnitude()
    }
    fn about_z(angle: f64) -> Self::Quaternion {
        cgmath::Quaternion::from_angle_z(cgmath::Rad(angle))
    }
    fn from_matrix(rows: [[f64; 3]; 3]) -> Self::Quaternion {
        cgmath::Matrix3::from(rows).transpose().into()
    }
    fn slerp(a: Self::Quaternion, b: Self::Quaternion, t: f64) -> Self::Quaternion {
        a.slerp(b, t)
    }
    fn inverse(q: Self::Quaternion) -> Self::Quaternion {
        q.invert()
    }
    fn normalize(q: Self::Quaternion) -> Self::Quaternion {
        q.normalize()
    }
    fn euler(call: &str, angles: [f64; 3]) -> Option<Self::Quaternion> {
        let [x, y, z] = angles.map(cgmath::Rad);
        (call == "Quaternion::from(Euler{x:.3,y:.5,z:.7})")
            .then(|| cgmath::Euler { x, y, z }.into())
    }
}

struct QuaternionCore;

impl Library for QuaternionCore {
    const ID: &str = "quaternion-core";
    type Quaternion = quaternion_core::Quaternion<f64>;

    fn named([w, x, y, z]: [f64; 4]) -> Self::Quaternion {
        (w, [x, y, z])
    }
    fn construct([w, x, y, z]: [f64; 4]) -> Self::Quaternion {
        (w, [x, y, z])
    }
    fn components((w, [x, y, z]): Self::Quaternion) -> [f64; 4] {
        [w, x, y, z]
    }
    // It is a tuple (w, [x, y, z]).
    fn array(_: Self::Quaternion) -> Option<[f64; 4]> {
        None
    }
    fn product(a: Self::Quaternion, b: Self::Quaternion) -> Self::Quaternion {
        quaternion_core::mul(a, b)
    }
    fn matrix(q: Self::Quaternion) -> [[f64; 3]; 3] {
        quaternion_core::to_dcm(q)
    }
    fn rotate(q: Self::Quaternion, v: [f64; 3]) -> [f64; 3] {
        quaternion_core::point_rotation(q, v)
    }
    fn norm(q: Self::Quaternion) -> f64 {
        quaternion_core::norm(q)
    }
    fn about_z(angle: f64) -> Self::Quaternion {
        quaternion_core::from_axis_angle([0.0, 0.0, 1.0], angle)
    }
    fn from_matrix(rows: [[f64; 3]; 3]) -> Self::Quaternion {
        quaternion_core::from_dcm(rows)
    }
    fn slerp(a: Self::Quaternion, b: Self::Quaternion, t: f64) -> Self::Quaternion {
        quaternion_core::slerp(a, b, t)
    }
    fn inverse(q: Self::Quaternion) -> Self::Quaternion {
        quaternion_core::inv(q)
    }
    fn normalize(q: Self::Quaternion) -> Self::Quaternion {
        quaternion_core::normalize(q)
    }
    fn euler(call: &str, angles: [f64; 3]) -> Option<Self::Quaternion> {
        use quaternion_core::RotationSequence::{XYZ, ZYX};
        use quaternion_core::RotationType::{Extrinsic, Intrinsic};
        let (kind, sequence) = match call {
            "from_euler_angles(Intrinsic,ZYX,[.3,.5,.7])" => (Intrinsic, ZYX),
            "from_euler_angles(Intrinsic,XYZ,[.3,.5,.7])" => (Intrinsic, XYZ),
            "from_euler_angles(Extrinsic,XYZ,[.3,.5,.7])" => (Extrinsic, XYZ),
            "from_euler_angles(Extrinsic,ZYX,[.3,.5,.7])" => (Extrinsic, ZYX),
            _ => return None,
        };
        Some(quaternion_core::from_euler_angles(kind, sequence, angles))
    }
    fn other(text: &str, inputs: &Inputs) -> Option<Vec<f64>> {
        let [w, x, y, z] = inputs.a;
        (text == "frame_rotation(a,v)")
            .then(|| quaternion_core::frame_rotation((w, [x, y, z]), inputs.v).to_vec())
    }
}
