//! FX-19: which vector along the axis a library means.

use super::{attitude, sign_of};
use crate::reference::{self, CLOSE, assert_same, elementary, sigma, unit};
use crate::support::{all_conventions, assert_close};
use quatlas::nalgebra::Vector3;
use quatlas::{AxisVector, Convention, Rotation, TaggedQuaternion};
use std::f64::consts::FRAC_PI_2;
use wasm_bindgen_test::wasm_bindgen_test;

/// FX-19: the angle of the turn by (0, 0, 0.1) tells which vector it is; a quarter turn tells τ and σ.
#[wasm_bindgen_test(unsupported = test)]
fn which_vector_along_the_axis_a_library_means_is_told_by_its_angle() {
    let angles = [0.1, 0.2, 2.0 * 0.1_f64.atan(), 4.0 * 0.1_f64.atan()];
    let rounded = [0.1, 0.2, 0.19934, 0.39867];
    let readings = AxisVector::readings(Vector3::new(0.0, 0.0, 0.1));
    for ((reading, angle), rounded) in readings.into_iter().zip(angles).zip(rounded) {
        let turn = reading.to_rotation().expect("finite");
        assert_close(
            &format!("{reading:?}"),
            &[turn.angle_rad()],
            &[angle],
            CLOSE,
        );
        assert_close("as printed", &[angle], &[rounded], 5e-6);
        let turned = Rotation::from_axis_angle([0.0, 0.0, 1.0], rounded).expect("an axis");
        let told = AxisVector::recognize(Vector3::new(0.0, 0.0, 0.1), &turned);
        assert_eq!(told.map(|(told, _)| told), Some(reading));
        assert_same(
            "about z",
            &turn.body_to_world_matrix(),
            &elementary(2, angle),
            CLOSE,
        );
    }
    // The way back, for any turn: tan(θ/2) u and tan(θ/4) u.
    for (v, sign) in reference::turns().flat_map(|v| [(v, 1.0), (v, -1.0)]) {
        let (angle, axis) = (v.norm(), v.normalize());
        let q = TaggedQuaternion {
            components: reference::half_angle(&v) * sign,
            convention: Convention::HAMILTON,
        };
        let turn = Rotation::from_tagged(&q).expect("not zero");
        let gibbs = turn.gibbs_vector().expect("not half a turn");
        assert_same("Gibbs", &(gibbs / (angle / 2.0).tan()), &axis, 1e-12);
        let modified = turn.modified_rodrigues_parameters();
        assert_same("MRP", &modified, &(axis * (angle / 4.0).tan()), CLOSE);
        for vector in [
            AxisVector::Gibbs(gibbs),
            AxisVector::ModifiedRodrigues(modified),
        ] {
            let back = vector.to_rotation().expect("finite");
            assert_same("back", &back.rotation_vector_rad(), &v, 1e-13);
        }
    }
    let quarter = attitude(unit(2) * FRAC_PI_2);
    for convention in all_conventions() {
        let q = quarter.to_tagged(convention).components;
        assert_eq!(sign_of(q.k / q.w), sigma(convention), "{convention}");
    }
}
