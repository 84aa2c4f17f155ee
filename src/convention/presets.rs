//! The conventions that have a name.

use crate::convention::Convention;
use crate::convention::names::serialized_by_name;
use serde::Deserialize;
use strum::VariantNames;

/// A convention that has a name of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
#[derive(VariantNames)]
#[strum(serialize_all = "camelCase")]
pub enum NamedConvention {
    /// [`Convention::HAMILTON`].
    Hamilton,
    /// [`Convention::JPL`].
    Jpl,
    /// [`Convention::HAMILTON_SCALAR_LAST`].
    HamiltonScalarLast,
    /// [`Convention::JPL_BODY_TO_WORLD`].
    JplBodyToWorld,
    /// [`Convention::MY_LAB`].
    MyLab,
}

serialized_by_name!(NamedConvention);

impl NamedConvention {
    /// All five; the first two are the presets.
    pub const ALL: [Self; 5] = [
        Self::Hamilton,
        Self::Jpl,
        Self::HamiltonScalarLast,
        Self::JplBodyToWorld,
        Self::MyLab,
    ];

    /// The convention of that name.
    #[must_use]
    pub const fn convention(self) -> Convention {
        match self {
            Self::Hamilton => Convention::HAMILTON,
            Self::Jpl => Convention::JPL,
            Self::HamiltonScalarLast => Convention::HAMILTON_SCALAR_LAST,
            Self::JplBodyToWorld => Convention::JPL_BODY_TO_WORLD,
            Self::MyLab => Convention::MY_LAB,
        }
    }
}

impl Convention {
    /// The name of this convention, whichever its perturbation is.
    ///
    /// ```
    /// use quatlas::{Convention, NamedConvention, Perturbation};
    /// let convention = Convention { perturbation: Perturbation::Global, ..Convention::MY_LAB };
    /// assert_eq!(convention.named(), Some(NamedConvention::MyLab));
    /// ```
    #[must_use]
    pub fn named(self) -> Option<NamedConvention> {
        let is_it = |name: &NamedConvention| {
            let perturbation = self.perturbation;
            self == Self {
                perturbation,
                ..name.convention()
            }
        };
        NamedConvention::ALL.into_iter().find(is_it)
    }

    /// The preset, Hamilton or JPL, that has the same product, function and direction: the same numbers
    /// but for their places.
    ///
    /// ```
    /// use quatlas::{Convention, NamedConvention};
    /// let preset = Convention::HAMILTON_SCALAR_LAST.preset();
    /// assert_eq!(preset, Some(NamedConvention::Hamilton));
    /// assert_eq!(Convention::JPL_BODY_TO_WORLD.preset(), None);
    /// ```
    #[must_use]
    pub fn preset(self) -> Option<NamedConvention> {
        let is_it = |name: &NamedConvention| {
            let Self {
                order,
                perturbation,
                ..
            } = self;
            self == Self {
                order,
                perturbation,
                ..name.convention()
            }
        };
        [NamedConvention::Hamilton, NamedConvention::Jpl]
            .into_iter()
            .find(is_it)
    }

    /// The same convention with the other direction, in which the conjugate of a quaternion is the same
    /// attitude.
    ///
    /// ```
    /// use quatlas::Convention;
    /// assert_eq!(Convention::JPL.reversed(), Convention::JPL_BODY_TO_WORLD);
    /// ```
    #[must_use]
    pub const fn reversed(self) -> Self {
        Self {
            direction: self.direction.reversed(),
            ..self
        }
    }
}
