//! In which order four numbers are written, and how a text tells it.

use crate::convention::names::serialized_by_name;
use serde::{Deserialize, Serialize};
use strum::{Display, EnumMessage, VariantArray, VariantNames};

/// In which order the four numbers are written.
///
/// It changes no rotation, only the places of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(Display, EnumMessage, VariantArray, VariantNames)]
#[doc(alias("wxyz", "xyzw", "ordering", "scalar_first"))]
pub enum ComponentOrder {
    /// `[w, x, y, z]`
    #[strum(
        to_string = "scalar-first",
        serialize = "wxyz",
        serialize = "w-first",
        serialize = "first"
    )]
    ScalarFirst,
    /// `[x, y, z, w]`
    #[strum(
        to_string = "scalar-last",
        serialize = "xyzw",
        serialize = "w-last",
        serialize = "last"
    )]
    ScalarLast,
}

impl ComponentOrder {
    /// The other one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::ScalarFirst => Self::ScalarLast,
            Self::ScalarLast => Self::ScalarFirst,
        }
    }

    /// `[w, x, y, z]` of four numbers that stand in this order.
    ///
    /// ```
    /// use quatlas::ComponentOrder;
    /// assert_eq!(ComponentOrder::ScalarLast.components([1, 2, 3, 4]), [4, 1, 2, 3]);
    /// ```
    #[must_use]
    pub const fn components<Number: Copy>(self, array: [Number; 4]) -> [Number; 4] {
        let [a, b, c, d] = array;
        match self {
            Self::ScalarFirst => array,
            Self::ScalarLast => [d, a, b, c],
        }
    }

    /// Four numbers `[w, x, y, z]` as they stand in this order.
    ///
    /// ```
    /// use quatlas::ComponentOrder;
    /// assert_eq!(ComponentOrder::ScalarLast.array(["w", "x", "y", "z"]), ["x", "y", "z", "w"]);
    /// ```
    #[must_use]
    pub const fn array<Number: Copy>(self, components: [Number; 4]) -> [Number; 4] {
        let [w, x, y, z] = components;
        match self {
            Self::ScalarFirst => components,
            Self::ScalarLast => [x, y, z, w],
        }
    }
}

/// How a text told which number is the scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum OrderSource {
    /// It did not: the declared order was used.
    Declared,
    /// By names: `w=`, `x:`, `"y":`, or the units i, j, k.
    Named,
    /// By brackets: `[w, [x, y, z]]` or `[[x, y, z], w]`.
    Grouped,
    /// By a constructor whose order is known, such as `Eigen::Quaterniond`.
    Constructor,
    /// By a word beside the numbers: `rotation_xyzw=`, `order: wxyz`.
    Label,
    /// By the format of the text, such as that of a trajectory.
    Format,
}

serialized_by_name!(OrderSource);
