//! Numbers of the types of algebra as the plain ones of a report, where −0 is 0.

use crate::contract::Components;
use crate::convention::order::ComponentOrder;
use crate::rotation::precise::Norm;
use nalgebra::{Matrix3, Matrix4, Quaternion, Vector3};

/// The number itself, with −0 written as 0.
pub(crate) fn plain(number: f64) -> f64 {
    number + 0.0
}

pub(crate) fn plain3([x, y, z]: [f64; 3]) -> [f64; 3] {
    [plain(x), plain(y), plain(z)]
}

pub(crate) fn plain4([w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [plain(w), plain(x), plain(y), plain(z)]
}

impl Components {
    pub(crate) fn of(quaternion: &Quaternion<f64>, order: ComponentOrder) -> Self {
        let components = plain4([quaternion.w, quaternion.i, quaternion.j, quaternion.k]);
        let [w, x, y, z] = components;
        let array = order.array(components);
        let norm = Norm::of(&array).value();
        Self {
            w,
            x,
            y,
            z,
            norm: norm.is_finite().then_some(norm),
            array,
        }
    }
}

pub(crate) fn coordinates(vector: &Vector3<f64>) -> [f64; 3] {
    plain3([vector.x, vector.y, vector.z])
}

pub(crate) fn rows3(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    matrix.transpose().map(plain).into()
}

pub(crate) fn rows4(matrix: &Matrix4<f64>) -> [[f64; 4]; 4] {
    matrix.transpose().map(plain).into()
}
