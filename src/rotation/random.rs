//! Attitudes drawn at random.

use crate::rotation::Rotation;
use crate::rotation::precise::UNIT_ROUNDOFF;
use nalgebra::Quaternion;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use std::f64::consts::TAU;

impl Rotation {
    /// An attitude drawn at random, of which none is more likely than another: uniform on SO(3).
    ///
    /// The same for the same seed on every machine and in every version; other seeds, neighbours too, give
    /// others that are independent. Of three numbers between 0 and 1 from xoshiro256++ (Blackman & Vigna
    /// 2021), whose state is that of the seed by `SplitMix64`, the quaternion is
    /// `[√a cos(2πc), √(1−a) sin(2πb), √(1−a) cos(2πb), √a sin(2πc)]` (Shoemake 1992, by subgroups). Uniform
    /// Euler angles crowd at gimbal lock, and four uniform numbers in the corners of their cube.
    ///
    /// ```
    /// use quatlas::{Rotation, nalgebra::Vector3};
    /// let (one, again, other) = (Rotation::random(7), Rotation::random(7), Rotation::random(8));
    /// assert_eq!(one, again);
    /// assert!(one.angle_to_rad(&other) > 0.1);
    /// // The mean height of where x points is 0, and half of them are above 1/2 or below −1/2.
    /// let heights: Vec<f64> = (0..1000).map(|seed| Rotation::random(seed).body_to_world(Vector3::x()).z).collect();
    /// assert!(heights.iter().sum::<f64>().abs() < 60.0);
    /// let steep = heights.iter().filter(|height| height.abs() > 0.5).count();
    /// assert!(steep.abs_diff(500) < 50);
    /// ```
    #[must_use]
    #[doc(alias("uniform", "Haar measure"))]
    pub fn random(seed: u64) -> Self {
        let mut generator = Xoshiro256PlusPlus::seed_from_u64(seed);
        let [part, first, second] = [0; 3].map(|_| between_0_and_1(generator.next_u64()));
        let (sine, cosine) = libm::sincos(TAU * first);
        let (last_sine, last_cosine) = libm::sincos(TAU * second);
        let (small, large) = ((1.0 - part).sqrt(), part.sqrt());
        Self::from_canonical(&Quaternion::new(
            large * last_cosine,
            small * sine,
            small * cosine,
            large * last_sine,
        ))
    }
}

/// The upper 53 bits, which a double holds exactly, as a part of 1: less than 1.
fn between_0_and_1(bits: u64) -> f64 {
    (bits >> 11) as f64 * UNIT_ROUNDOFF
}
