//! Numbers with a unit that no rotation has: of rates, small turns and times.
//!
//! It stands once, behind the numbers.

use std::f64::consts::{PI, TAU};

/// A unit by one of its names, and how many of those in which reports are it is. A name that ends with
/// another stands before it.
pub(crate) type Unit = (&'static str, f64);

/// Of angular velocities, in rad/s.
pub(crate) const OF_RATES: &[Unit] = &[
    ("rad/sec", 1.0),
    ("rad/s", 1.0),
    ("deg/sec", PI / 180.0),
    ("deg/s", PI / 180.0),
    ("°/s", PI / 180.0),
    ("dps", PI / 180.0),
    ("rpm", TAU / 60.0),
    ("RPM", TAU / 60.0),
];

/// Of small turns, in rad.
pub(crate) const OF_TURNS: &[Unit] = &[
    ("mrad", 1e-3),
    ("rad", 1.0),
    ("deg", PI / 180.0),
    ("°", PI / 180.0),
];

/// Of times, in s.
pub(crate) const OF_TIMES: &[Unit] = &[
    ("ms", 1e-3),
    ("us", 1e-6),
    ("µs", 1e-6),
    ("μs", 1e-6),
    ("ns", 1e-9),
    ("min", 60.0),
    ("sec", 1.0),
    ("s", 1.0),
    ("h", 3600.0),
];

/// The text without the unit at its end, and that unit; none where none is written.
pub(crate) fn without_unit<'text>(text: &'text str, units: &[Unit]) -> (&'text str, Option<f64>) {
    let text = text.trim_end();
    for &(name, size) in units {
        if let Some(numbers) = text.strip_suffix(name) {
            return (numbers, Some(size));
        }
    }
    (text, None)
}
