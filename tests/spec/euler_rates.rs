//! The specification on the rates of Euler angles: FX-10 and 004-EU.13 (see `table.md`).

use crate::reference::{
    CLOSE, SLOPE, assert_order, assert_same, elementary, integrated_entries, slope, unskew,
};
use crate::support::assert_close;
use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{EulerFrame, EulerSequence, NoStep, RateAxes};
use wasm_bindgen_test::wasm_bindgen_test;

const ANGLES: [[f64; 3]; 3] = [[0.7, 0.4, 1.1], [-2.1, 1.3, 0.2], [3.0, 0.9, -1.7]];
const RATES: [f64; 3] = [0.2, -0.5, 0.9];

/// `R_WB` by elementary turns.
fn attitude(sequence: EulerSequence, angles: Vector3<f64>) -> Matrix3<f64> {
    let axes = sequence.axes.axes();
    let turn = |place: usize| elementary(axes[place].index(), angles[place]);
    match sequence.frame {
        EulerFrame::Intrinsic => turn(0) * turn(1) * turn(2),
        EulerFrame::Extrinsic => turn(2) * turn(1) * turn(0),
    }
}

/// The angular velocity of changing angles, by differences.
fn velocity(sequence: EulerSequence, angles: Vector3<f64>, axes: RateAxes) -> Vector3<f64> {
    let r = attitude(sequence, angles);
    let derivative = slope(|time| attitude(sequence, angles + Vector3::from(RATES) * time));
    match axes {
        RateAxes::Body => unskew(&(r.transpose() * derivative)),
        RateAxes::World => unskew(&(derivative * r.transpose())),
    }
}

/// FX-10: for all 24, there and back, on both axes.
#[wasm_bindgen_test(unsupported = test)]
fn angle_rates_make_the_angular_velocity_and_back() {
    for sequence in EulerSequence::all() {
        for angles in ANGLES {
            for axes in [RateAxes::Body, RateAxes::World] {
                let what = format!("{sequence} {axes:?}");
                let expected = velocity(sequence, angles.into(), axes);
                let map = sequence.rate_matrix(angles, axes).expect("finite");
                assert_same(&what, &(map * Vector3::from(RATES)), &expected, SLOPE);
                let back = sequence.angle_rates(angles, expected.into(), axes);
                assert_close(&what, &back.expect("not locked"), &RATES, 1e-9);
            }
        }
    }
}

/// FX-10: the printed rows for 3-2-1, their inverses, and the determinant −cos θ.
#[wasm_bindgen_test(unsupported = test)]
fn the_rates_of_yaw_pitch_and_roll_by_the_printed_formulas() {
    let [d_psi, d_theta, d_phi] = RATES;
    for angles in ANGLES {
        let [psi, theta, phi] = angles;
        let on_body = [
            d_phi - d_psi * theta.sin(),
            d_theta * phi.cos() + d_psi * theta.cos() * phi.sin(),
            -d_theta * phi.sin() + d_psi * theta.cos() * phi.cos(),
        ];
        let on_world = [
            d_phi * psi.cos() * theta.cos() - d_theta * psi.sin(),
            d_phi * psi.sin() * theta.cos() + d_theta * psi.cos(),
            d_psi - d_phi * theta.sin(),
        ];
        for (axes, expected) in [(RateAxes::Body, on_body), (RateAxes::World, on_world)] {
            let map = EulerSequence::AEROSPACE
                .rate_matrix(angles, axes)
                .expect("finite");
            let got = map * Vector3::from(RATES);
            assert_close("ω", got.as_slice(), &expected, CLOSE);
            assert_close("det", &[map.determinant()], &[-theta.cos()], CLOSE);
        }
        let [x, y, z] = on_body;
        let k = y * phi.sin() + z * phi.cos();
        let expected = [
            k / theta.cos(),
            y * phi.cos() - z * phi.sin(),
            x + k * theta.tan(),
        ];
        let got = EulerSequence::AEROSPACE.angle_rates(angles, on_body, RateAxes::Body);
        assert_close("of ω_B", &got.expect("not locked"), &expected, CLOSE);
        let [x, y, z] = on_world;
        let m = x * psi.cos() + y * psi.sin();
        let expected = [
            z + m * theta.tan(),
            y * psi.cos() - x * psi.sin(),
            m / theta.cos(),
        ];
        let got = EulerSequence::AEROSPACE.angle_rates(angles, on_world, RateAxes::World);
        assert_close("of ω_W", &got.expect("not locked"), &expected, CLOSE);
    }
}

/// 004-EU.13, FX-10: at the lock the map has rank 2 in every sequence, and the rates are refused.
#[wasm_bindgen_test(unsupported = test)]
fn at_the_lock_the_rates_are_refused() {
    for sequence in EulerSequence::all() {
        for middle in sequence.locks_rad() {
            let angles = [0.9, middle, -0.3];
            for axes in [RateAxes::Body, RateAxes::World] {
                let map = sequence.rate_matrix(angles, axes).expect("finite");
                assert_eq!(map.rank(1e-9), 2, "{sequence}");
                let refused = sequence.angle_rates(angles, RATES, axes);
                let singular = refused.expect_err("locked");
                assert!(singular.determinant.abs() < 1e-15, "{sequence}");
                let apart = [0.9, middle + 1e-6, -0.3];
                assert!(
                    sequence.angle_rates(apart, RATES, axes).is_ok(),
                    "{sequence}"
                );
            }
        }
    }
}

/// FX-10: Runge-Kutta on the three angles has order 4, for both kinds of sequences and on both axes.
#[wasm_bindgen_test(unsupported = test)]
fn angles_are_integrated_with_order_4() {
    let rate = |time: f64| Vector3::new((1.7 * time).cos(), 0.6 * (2.3 * time).sin(), 0.5);
    let start = Vector3::new(0.7, -0.4, 1.1);
    for (sequence, axes) in [
        ("ZYX", RateAxes::Body),
        ("xyz", RateAxes::World),
        ("ZXZ", RateAxes::Body),
    ] {
        let sequence: EulerSequence = sequence.parse().expect("a sequence");
        let integrate = |steps: u32| {
            let h = 1.0 / f64::from(steps);
            let mut angles = start.into();
            for n in 0..steps {
                angles = sequence
                    .runge_kutta_step(angles, rate, axes, f64::from(n) * h, h)
                    .expect("not locked");
            }
            attitude(sequence, angles.into())
        };
        // Fine steps on the nine entries.
        let r = integrated_entries(attitude(sequence, start), rate, axes, 1.0, 4000);
        let error = |steps: u32| (integrate(steps) - r).norm();
        assert!(error(64) < 1e-5, "{sequence}: it goes there");
        let order = (error(64) / error(128)).log2();
        assert_order(&sequence.to_string(), order, 4.0);
    }
}

/// FX-10: at the lock no step is taken, and none with numbers that are not finite.
#[wasm_bindgen_test(unsupported = test)]
fn at_the_lock_no_step_is_taken() {
    let rate = |_time: f64| Vector3::from(RATES);
    for sequence in EulerSequence::all() {
        let locked = [0.9, sequence.locks_rad()[0], -0.3];
        let step = |angles| sequence.runge_kutta_step(angles, rate, RateAxes::Body, 0.0, 0.1);
        assert_eq!(step(locked), Err(NoStep::Singular), "{sequence}");
        assert_eq!(step([0.1, f64::NAN, 0.2]), Err(NoStep::NotFinite));
        let endless = |time: f64| Vector3::new(0.1, 0.0, 1.0 / (time - 0.05));
        let end = sequence.runge_kutta_step(ANGLES[0], endless, RateAxes::World, 0.0, 0.1);
        assert_eq!(end, Err(NoStep::NotFinite), "{sequence}");
    }
}
