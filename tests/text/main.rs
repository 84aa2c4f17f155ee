//! What is typed or pasted: how it is read, where it is refused, what is offered, and what is answered.

#[cfg(not(target_arch = "wasm32"))]
#[path = "../support/property.rs"]
mod property;
#[path = "../support/rows.rs"]
mod rows;
#[path = "../support/mod.rs"]
mod support;
#[cfg(not(target_arch = "wasm32"))]
#[path = "../support/turned.rs"]
mod turned;

mod asked;
mod checked;

mod attitudes;
mod axis_vectors;
mod calls;
mod cases;
mod comments;
mod composing;
mod euler_angles;
mod formats;
mod function_units;
#[cfg(not(target_arch = "wasm32"))]
mod huge;
mod labels;
mod lists;
mod marks;
mod matrix_columns;
mod misreadings;
mod named_angles;
mod norms;
mod notes;
mod problems;
#[cfg(not(target_arch = "wasm32"))]
mod properties;
mod quaternions;
mod records;
mod reflections;
mod reports;
mod representations;
mod separators;
mod suggestions;
mod turns;
mod words;
