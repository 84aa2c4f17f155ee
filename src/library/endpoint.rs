//! One end of a translation: a library, or a convention on the five axes.

use crate::convention::family::Family;
use crate::convention::matrix::{CosineMatrix, MatrixConvention};
use crate::convention::order::ComponentOrder;
use crate::convention::side::Side;
use crate::convention::{Convention, Direction, Function, Handedness, Perturbation};
use crate::library::{Essentials, VectorLayout, essentials};
use serde::{Deserialize, Serialize};

/// Where numbers come from, or where they go.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Endpoint {
    /// A library of the table.
    Library(LibraryEndpoint),
    /// Any of the 32 conventions; its matrix is the one that the quaternion acts with.
    Convention(ConventionEndpoint),
}

/// A library, and what is said of the numbers beyond its record.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct LibraryEndpoint {
    /// The id of its record.
    pub id: String,
    /// The order in which the numbers stand, where it is not that in which the library prints them or
    /// else of its array; also in a line of code that is nothing but an array.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub order: Option<ComponentOrder>,
    /// Which coordinates to which the quaternion takes when it acts. Where it is left out, it is
    /// what the library's documentation says, or else the custom: body to world for `R(q)`, world to
    /// body for `C(q)`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<Direction>,
}

/// A convention as an end of a translation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ConventionEndpoint {
    /// What four numbers mean.
    pub convention: Convention,
}

impl Endpoint {
    /// The library with this id, as its record says.
    #[must_use]
    pub fn library(id: &str) -> Self {
        Self::Library(LibraryEndpoint {
            id: id.to_owned(),
            order: None,
            direction: None,
        })
    }

    /// A convention.
    #[must_use]
    pub const fn convention(convention: Convention) -> Self {
        Self::Convention(ConventionEndpoint { convention })
    }
}

/// Something that a translation needs and that is not established for a library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Assumption {
    /// The order of the numbers: taken as x y z w.
    Order,
    /// What the quaternion does to a vector: taken as `R(q)`.
    Action,
}

/// What numbers mean at one end.
#[derive(Clone, Debug)]
pub(crate) struct Meaning {
    pub(crate) library: Option<&'static Essentials>,
    /// The convention, where that is the end.
    pub(crate) declared: Option<Convention>,
    pub(crate) order: ComponentOrder,
    pub(crate) handedness: Option<Handedness>,
    /// What the quaternion multiplies a column with when it acts.
    pub(crate) action: CosineMatrix,
    /// Which coordinates to which that takes.
    pub(crate) direction: Direction,
    pub(crate) matrix: Option<PrintedAs>,
    pub(crate) assumed: Vec<Assumption>,
}

/// What the printed matrix of a quaternion is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PrintedAs {
    pub(crate) form: CosineMatrix,
    pub(crate) vectors: VectorLayout,
}

impl Meaning {
    /// Whether four numbers stand for an attitude here.
    pub(crate) fn has_quaternion(&self) -> bool {
        self.library.is_none_or(|library| library.numbers.is_none())
    }

    /// How product and action belong together, where the product is established.
    pub(crate) fn family(&self) -> Option<Family> {
        Some(Family::of(self.handedness?, self.action))
    }

    /// The operand of a product that acts first on a vector, where the product is established.
    pub(crate) fn first_to_act(&self) -> Option<Side> {
        self.family().map(Family::first_to_act)
    }

    /// `None` for an id that no library has.
    pub(crate) fn of(endpoint: &Endpoint) -> Option<Self> {
        match endpoint {
            Endpoint::Library(endpoint) => Self::of_library(endpoint),
            Endpoint::Convention(endpoint) => Some(Self::of_convention(endpoint.convention)),
        }
    }

    fn of_convention(convention: Convention) -> Self {
        let action = match convention.handedness {
            Handedness::Right => CosineMatrix::Hamilton,
            Handedness::Left => CosineMatrix::Shuster,
        };
        Self {
            library: None,
            declared: Some(convention),
            order: convention.order,
            handedness: Some(convention.handedness),
            action,
            direction: convention.operator(),
            matrix: Some(PrintedAs {
                form: action,
                vectors: VectorLayout::Column,
            }),
            assumed: Vec::new(),
        }
    }

    fn of_library(endpoint: &LibraryEndpoint) -> Option<Self> {
        let mut libraries = essentials().iter();
        let library = libraries.find(|library| library.id == endpoint.id)?;
        let mut assumed = Vec::new();
        // A record without a quaternion leaves nothing open of one: that of its numbers is by R(q).
        let has_quaternion = library.numbers.is_none();
        let order = endpoint.order.or(library.order()).unwrap_or_else(|| {
            assumed.extend(has_quaternion.then_some(Assumption::Order));
            ComponentOrder::ScalarLast
        });
        let action = library.action().unwrap_or_else(|| {
            assumed.extend(has_quaternion.then_some(Assumption::Action));
            CosineMatrix::Hamilton
        });
        let customary = match action {
            CosineMatrix::Hamilton => Direction::BodyToWorld,
            CosineMatrix::Shuster => Direction::WorldToBody,
        };
        let matrix = library.matrix.zip(library.vectors);
        Some(Self {
            library: Some(library),
            declared: None,
            order,
            handedness: library.handedness,
            action,
            direction: endpoint
                .direction
                .or(library.direction)
                .unwrap_or(customary),
            matrix: matrix.map(|(form, vectors)| PrintedAs { form, vectors }),
            assumed,
        })
    }

    /// The convention with these numbers and this action. Its product is the one that belongs to the
    /// action, which need not be the library's: a product changes no components.
    pub(crate) const fn numbers(&self) -> Convention {
        Convention {
            order: self.order,
            handedness: match self.action {
                CosineMatrix::Hamilton => Handedness::Right,
                CosineMatrix::Shuster => Handedness::Left,
            },
            function: Function::Passive,
            direction: self.direction,
            perturbation: Perturbation::Local,
        }
    }

    /// Which coordinates to which a matrix of this form takes a column.
    pub(crate) fn direction_of(&self, form: CosineMatrix) -> Direction {
        if form == self.action {
            self.direction
        } else {
            self.direction.reversed()
        }
    }

    /// What nine numbers that were printed here mean.
    pub(crate) fn matrix_convention(&self) -> MatrixConvention {
        let form = self.matrix.map_or(self.action, |printed| printed.form);
        MatrixConvention {
            function: Function::Passive,
            direction: self.direction_of(form),
        }
    }
}
