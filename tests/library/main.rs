//! Libraries: the table of what they do, which of them one is, and from one to another.

#[cfg(not(target_arch = "wasm32"))]
#[path = "../support/property.rs"]
mod property;
#[path = "../support/mod.rs"]
mod support;
#[cfg(not(target_arch = "wasm32"))]
#[path = "../support/turned.rs"]
mod turned;

#[cfg(not(target_arch = "wasm32"))]
mod build_script;
mod recorded;
mod simulated;

mod edges;
mod identify;
mod numbers;
mod observations;
mod rerun;
mod table;
mod translate;
