//! The specification: its equations one by one, its golden cases, and the errata of its documents.
//!
//! `table.md` says which test holds which entry.

#[path = "../support/nearest.rs"]
mod nearest;
#[path = "../support/rows.rs"]
mod rows;
#[path = "../support/mod.rs"]
mod support;

mod reference;

mod conventions;
mod errata;
mod euler;
mod euler_rates;
mod golden;
mod identify;
mod lecture;
mod matrices;
mod motion;
mod perturbations;
mod poses;
mod quaternions;
#[cfg(not(target_arch = "wasm32"))]
mod table;
mod vectors;
