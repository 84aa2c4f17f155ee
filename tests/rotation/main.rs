//! From numbers to rotations and back: conventions, laws, accuracy, the edges of the core's gates.

#[path = "../support/measured/mod.rs"]
mod measured;
#[path = "../support/nearest.rs"]
mod nearest;
#[cfg(not(target_arch = "wasm32"))]
#[path = "../support/property.rs"]
mod property;
#[path = "../support/rows.rs"]
mod rows;
#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod alignment;
#[cfg(not(target_arch = "wasm32"))]
mod alignment_laws;
mod axes;
mod conventions;
mod copied;
mod gates;
#[cfg(not(target_arch = "wasm32"))]
mod laws;
mod names;
mod peers;
mod random;
