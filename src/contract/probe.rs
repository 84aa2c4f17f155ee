//! What was tried on a library, as texts.

use crate::contract::text::Text;
use crate::problem::Field;
use serde::{Deserialize, Serialize};

/// A kind of probe.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum ProbeKind {
    /// Four numbers into the constructor, and printed.
    Components,
    /// `a * b`, such as i * j.
    Product,
    /// A vector rotated by a quaternion.
    Rotate,
    /// The matrix of a quaternion.
    Matrix,
    /// The quaternion of a matrix.
    FromMatrix,
    /// The quaternion of a body that was turned by +90° about the world's z axis.
    QuarterTurn,
    /// A quaternion after a small turn was added, by the library's own call.
    Perturb,
}

/// An observation as texts: what went in and what was printed.
///
/// A quaternion in plain numbers stands as the library takes or prints it; with names (`w: 1, x: 0,
/// …`) its order is no question. An observation whose `printed` is empty is not made yet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(
    tag = "probe",
    rename_all = "kebab-case",
    rename_all_fields = "camelCase"
)]
pub enum Probe {
    /// Four numbers into the constructor, and printed.
    Components {
        /// The quaternion that went in.
        quaternion: Text,
        /// The quaternion as printed.
        printed: Text,
    },
    /// `a * b`.
    Product {
        /// The left operand.
        a: Text,
        /// The right operand.
        b: Text,
        /// The quaternion as printed.
        printed: Text,
    },
    /// A vector rotated by a quaternion.
    Rotate {
        /// The quaternion that went in.
        quaternion: Text,
        /// The vector that went in.
        vector: Text,
        /// The vector as printed.
        printed: Text,
    },
    /// The matrix of a quaternion.
    Matrix {
        /// The quaternion that went in.
        quaternion: Text,
        /// Nine numbers as printed.
        printed: Text,
        /// How they were printed.
        #[serde(default)]
        layout: MatrixLayout,
    },
    /// The quaternion of a matrix.
    FromMatrix {
        /// Nine numbers that went in.
        matrix: Text,
        /// How they went in.
        #[serde(default)]
        layout: MatrixLayout,
        /// The quaternion as printed.
        printed: Text,
    },
    /// The quaternion of a body that was turned by +90° about the world's z axis.
    QuarterTurn {
        /// The quaternion as printed.
        printed: Text,
    },
    /// A quaternion after a small turn was added, by the library's own call.
    Perturb {
        /// The quaternion that went in.
        quaternion: Text,
        /// The rotation vector that was added, in radians: three numbers.
        rotation_vector: Text,
        /// The quaternion as printed.
        printed: Text,
    },
}

impl Probe {
    /// Its kind.
    #[must_use]
    pub const fn kind(&self) -> ProbeKind {
        match self {
            Self::Components { .. } => ProbeKind::Components,
            Self::Product { .. } => ProbeKind::Product,
            Self::Rotate { .. } => ProbeKind::Rotate,
            Self::Matrix { .. } => ProbeKind::Matrix,
            Self::FromMatrix { .. } => ProbeKind::FromMatrix,
            Self::QuarterTurn { .. } => ProbeKind::QuarterTurn,
            Self::Perturb { .. } => ProbeKind::Perturb,
        }
    }

    /// What goes in, as texts.
    #[must_use]
    pub fn inputs(&self) -> Vec<&str> {
        match self {
            Self::Components { quaternion, .. } | Self::Matrix { quaternion, .. } => {
                vec![quaternion]
            }
            Self::Product { a, b, .. } => vec![a, b],
            Self::Rotate {
                quaternion, vector, ..
            } => vec![quaternion, vector],
            Self::FromMatrix { matrix, .. } => vec![matrix],
            Self::QuarterTurn { .. } => Vec::new(),
            Self::Perturb {
                quaternion,
                rotation_vector,
                ..
            } => vec![quaternion, rotation_vector],
        }
    }

    /// Whether the same goes in, whatever comes out.
    #[must_use]
    pub fn asks_the_same(&self, other: &Self) -> bool {
        let (own, others) = (self.inputs(), other.inputs());
        self.kind() == other.kind()
            && own.len() == others.len()
            && own
                .iter()
                .zip(&others)
                .all(|(own, other)| own.split_whitespace().eq(other.split_whitespace()))
    }

    /// The text of a field; what was printed where it has no such field.
    #[must_use]
    pub fn text(&self, field: Field) -> &str {
        match (self, field) {
            (
                Self::Components { quaternion, .. }
                | Self::Rotate { quaternion, .. }
                | Self::Matrix { quaternion, .. }
                | Self::Perturb { quaternion, .. },
                Field::Quaternion,
            ) => quaternion,
            (Self::Product { a, .. }, Field::A) => a,
            (Self::Product { b, .. }, Field::B) => b,
            (Self::Rotate { vector, .. }, Field::Vector) => vector,
            (Self::FromMatrix { matrix, .. }, Field::Matrix) => matrix,
            (
                Self::Perturb {
                    rotation_vector, ..
                },
                Field::RotationVector,
            ) => rotation_vector,
            _ => self.printed(),
        }
    }

    /// What was printed, as text.
    #[must_use]
    pub fn printed(&self) -> &str {
        match self {
            Self::Components { printed, .. }
            | Self::Product { printed, .. }
            | Self::Rotate { printed, .. }
            | Self::Matrix { printed, .. }
            | Self::FromMatrix { printed, .. }
            | Self::QuarterTurn { printed }
            | Self::Perturb { printed, .. } => printed,
        }
    }
}

/// How nine numbers were printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum MatrixLayout {
    /// As the text shows: row by row where the rows stand on lines of their own, and in lists of lists,
    /// which only in Rust, C and C++ may be columns as well; not known where nine numbers stand in a row.
    #[default]
    AsWritten,
    /// Row by row.
    Rows,
    /// Column by column.
    Columns,
    /// One or the other.
    Unknown,
}
