//! Witnesses for Yoosefian 2021. The printed formulas are transcribed to the letter, and stand
//! nowhere else.

use crate::errata::witness::{EXAMPLE, Sides, Witness, exponential, pure, turn};
use crate::rotation::Rotation;
use crate::rotation::quaternion::{hamilton_product, jpl_product};
use nalgebra::{Matrix4, Quaternion, Vector3, Vector4};
use std::f64::consts::FRAC_PI_2;

/// A camera C on an inertial unit I, at two instants in the frame G.
struct Rig {
    /// `ᴳR_I1` and `ᴳR_I2`.
    units: [Rotation; 2],
    /// `ᴳp_I1` and `ᴳp_I2`.
    positions: [Vector3<f64>; 2],
    /// `ᴵR_C`.
    camera: Rotation,
    /// `ᴵp_C`.
    camera_position: Vector3<f64>,
}

impl Rig {
    /// At rest in the origin, the axes of I those of G, the camera yawed and in front of I.
    fn at_rest() -> Self {
        Self {
            units: [Rotation::identity(); 2],
            positions: [Vector3::zeros(); 2],
            camera: turn([0.0, 0.0, 1.0], FRAC_PI_2),
            camera_position: Vector3::x(),
        }
    }

    /// Case G29 of the specification: all angles and distances differ.
    fn moving() -> Self {
        Self {
            units: [
                exponential(Vector3::new(0.1, 0.2, -0.3)),
                exponential(Vector3::new(0.3, -0.1, 0.4)),
            ],
            positions: [Vector3::new(1.0, 2.0, 3.0), Vector3::new(1.5, 1.0, 2.5)],
            camera: exponential(Vector3::new(1.2, -0.4, 0.5)),
            camera_position: Vector3::new(0.1, -0.2, 0.3),
        }
    }

    /// `ᴳp_I1 + ᴳR_I1 ᴵp_C + ᴳR_C1 ᶜ¹p_C2 − last ᴵp_C`.
    fn path(&self, last: &Rotation) -> Vector3<f64> {
        let [first_camera, second_camera] = [0, 1].map(|instant| {
            self.positions[instant] + self.units[instant].body_to_world(self.camera_position)
        });
        let camera_1 = self.units[0] * self.camera;
        let camera_2_in_camera_1 = camera_1.world_to_body(second_camera - first_camera);
        self.positions[0]
            + self.units[0].body_to_world(self.camera_position)
            + camera_1.body_to_world(camera_2_in_camera_1)
            - last.body_to_world(self.camera_position)
    }

    /// `ᴳR_C2`.
    fn second_camera(&self) -> Rotation {
        self.units[1] * self.camera
    }
}

/// E10: the position of I2 along the path by the camera.
pub(crate) fn camera_path() -> Witness {
    let rigs = [Rig::at_rest(), Rig::moving()];
    let statement = |last: fn(&Rig) -> Rotation| {
        rigs.iter().fold(Sides::new(), |sides, rig| {
            sides.vector(&rig.path(&last(rig)), &rig.positions[1])
        })
    };
    Witness::new(
        "a rig at rest, with ᴵR_C a quarter turn about z and ᴵp_C = (1, 0, 0); then ᴳp_I from \
         (1, 2, 3) to (1.5, 1, 2.5) and ᴳR_I from the turn by (0.1, 0.2, −0.3) to that by \
         (0.3, −0.1, 0.4), with ᴵR_C the turn by (1.2, −0.4, 0.5) and ᴵp_C = (0.1, −0.2, 0.3)",
        statement(Rig::second_camera),
        statement(|rig| rig.second_camera() * rig.camera.inverse()),
    )
}

/// `Ω(ω)` of eq. 10.
fn omega_matrix(omega: &Vector3<f64>) -> Matrix4<f64> {
    let (x, y, z) = (omega.x, omega.y, omega.z);
    Matrix4::new(
        0.0, -x, -y, -z, //
        x, 0.0, z, -y, //
        y, -z, 0.0, x, //
        z, y, -x, 0.0,
    )
}

fn scalar_first(q: &Quaternion<f64>) -> Vector4<f64> {
    Vector4::new(q.w, q.i, q.j, q.k)
}

fn scalar_last(q: &Quaternion<f64>) -> Vector4<f64> {
    q.coords
}

/// E11: both products, with all arrays scalar-first, all scalar-last, or only ω as (0, ω).
///
/// One of these six readings is the corrected statement. Of the five others the one that comes
/// closest is given.
pub(crate) fn rate_product() -> Witness {
    let omega = Vector3::new(1.0, 2.0, 3.0);
    let matrix = omega_matrix(&omega);
    let first = matrix * scalar_first(&EXAMPLE);
    let last = matrix * scalar_last(&EXAMPLE);
    let (rate, rate_as_scalar_first) = (
        pure(&omega),
        Quaternion::new(omega.x, omega.y, omega.z, 0.0),
    );
    let (hamilton, jpl) = (
        |right| hamilton_product(&EXAMPLE, right),
        |right| jpl_product(&EXAMPLE, right),
    );
    let readings = [
        Sides::new().vector(&first, &scalar_first(&jpl(&rate_as_scalar_first))),
        Sides::new().vector(&last, &scalar_last(&jpl(&rate))),
        Sides::new().vector(&first, &scalar_first(&hamilton(&rate_as_scalar_first))),
        Sides::new().vector(&last, &scalar_last(&hamilton(&rate))),
    ];
    let closest = readings.into_iter().fold(
        Sides::new().vector(&first, &scalar_first(&jpl(&rate))),
        |closest, reading| {
            if reading.error() < closest.error() {
                reading
            } else {
                closest
            }
        },
    );
    Witness::new(
        "q = (0.8, 0.2, 0.4, 0.4), ω = (1, 2, 3), in the reading that comes closest",
        closest,
        Sides::new().vector(&first, &scalar_first(&hamilton(&rate))),
    )
}
