//! A rate over time, and the way of a body that has it.

use crate::analyze::motion::turned::{rounding_rad, turned};
use crate::analyze::plain_numbers::plain;
use crate::motion::kinematics::{IntegrationOrder, RateAxes};
use nalgebra::{UnitQuaternion, Vector3};

/// What turns farther has turned so often between two moments that nobody sees how.
pub(super) const MOST_TURNS: f64 = 100.0;

/// Steps of fourth order in all of a path whose rate changes: of a turn of 3 rad they leave 1e-14.
const FINE_STEPS: u32 = 960;

/// So many in that of a mistake, of which nobody asks the last digits.
const MISTAKEN_STEPS: u32 = 240;

/// How many times as many there are in a long one at the most.
const MOST_TIMES: u32 = 8;

/// A longer step than this, in radians, is halved.
const FINE_STEP_RAD: f64 = 0.02;

/// A rate over time.
pub(super) struct Course {
    start: Vector3<f64>,
    /// By how much it grows in a second.
    change: Vector3<f64>,
    pub(super) axes: RateAxes,
    pub(super) seconds: f64,
    fine_steps: u32,
}

impl Course {
    pub(super) fn new(
        start: Vector3<f64>,
        end: Vector3<f64>,
        axes: RateAxes,
        seconds: f64,
    ) -> Self {
        Self {
            start,
            change: (end - start) / seconds,
            axes,
            seconds,
            fine_steps: FINE_STEPS,
        }
    }

    pub(super) fn rate(&self, time: f64) -> Vector3<f64> {
        self.start + self.change * time
    }

    fn is_constant(&self) -> bool {
        self.change.amax() == 0.0
    }

    /// No less than the angle by which the body turns.
    pub(super) fn turn_rad(&self) -> f64 {
        let fastest = self.start.norm().max(self.rate(self.seconds).norm());
        fastest * self.seconds
    }

    /// The same with every rate times a factor, on these axes, as of a mistake.
    pub(super) fn times(&self, factor: f64, axes: RateAxes) -> Self {
        Self {
            start: self.start * factor,
            change: self.change * factor,
            axes,
            seconds: self.seconds,
            fine_steps: MISTAKEN_STEPS,
        }
    }

    /// How many fine steps there are from one moment to the next.
    fn fine_steps(&self, steps: u32) -> u32 {
        if self.is_constant() {
            return 1;
        }
        let mut all = self.fine_steps;
        while all < MOST_TIMES * self.fine_steps && self.turn_rad() > f64::from(all) * FINE_STEP_RAD
        {
            all *= 2;
        }
        all.div_ceil(steps)
    }

    /// The time and the attitude at every moment, of which the first is the beginning.
    pub(super) fn followed(&self, from: &UnitQuaternion<f64>, steps: u32) -> Vec<[f64; 5]> {
        let fine = self.fine_steps(steps);
        let length = self.seconds / f64::from(steps);
        let fine_length = length / f64::from(fine);
        let rate = |time| self.rate(time);
        let mut now = *from;
        let mut moments = Vec::new();
        for moment in 0..=steps {
            let time = length * f64::from(moment);
            moments.push([time, now.w, now.i, now.j, now.k].map(plain));
            if self.is_constant() {
                // From the beginning each time: no error grows.
                let turn = self.start * (length * f64::from(moment + 1));
                now = turned(from, self.axes, turn);
                continue;
            }
            for step in 0..fine {
                let time = time + fine_length * f64::from(step);
                let turn = IntegrationOrder::Fourth.turn_rad(&rate, self.axes, time, fine_length);
                now = turned(&now, self.axes, turn);
            }
            now.renormalize();
        }
        moments
    }

    /// What may be rounding at the end.
    pub(super) fn rounding_rad(&self, steps: u32) -> f64 {
        let all = f64::from(steps) * f64::from(self.fine_steps(steps));
        rounding_rad(self.turn_rad(), all)
    }
}
