//! Attitudes in motion: small turns, rates, and steps in time.

/// Euler angle rates.
pub mod euler_rates;

/// Integration of components, of Euler angles and of rotation vectors.
pub mod integration;

/// How attitudes change in time.
pub mod kinematics;

/// Small turns added to attitudes and taken between them.
pub mod perturbation;
