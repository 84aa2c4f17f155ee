//! What must hold for every text, tried on many: native only, with a fixed seed.

mod answered;
mod corpus;
mod each;
mod written;

mod any_input;
mod changed;
mod notation;
mod spellings;
mod suggestions;
