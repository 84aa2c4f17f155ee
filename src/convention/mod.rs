#![doc = include_str!("conventions.md")]

/// The unit of an angle.
pub mod angle;

/// The 24 Euler sequences.
pub mod euler_sequence;

/// How a product and a matrix belong together.
pub mod family;

/// What nine numbers mean.
pub mod matrix;

/// The conventions that have a name.
pub mod presets;

/// In which order four numbers are written.
pub mod order;

// The values of the choices and their names.
pub(crate) mod names;

/// The side on which a small turn stands.
pub mod side;

pub use crate::convention::names::UnknownName;
use crate::convention::order::ComponentOrder;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use strum::{Display, EnumMessage, VariantArray, VariantNames};

/// Which product the quaternions have.
///
/// It says nothing about the handedness of the axes, which are right-handed in
/// both cases (Cheng 2018, section 2.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(Display, EnumMessage, VariantArray, VariantNames)]
#[doc(alias("algebra", "ij=k", "ij=-k", "flipped"))]
pub enum Handedness {
    /// `ij = k`: the Hamilton product `p ⊙ q`.
    #[strum(
        to_string = "right",
        serialize = "hamilton-product",
        serialize = "ij=k"
    )]
    Right,
    /// `ij = -k`: the JPL (Shuster) product `p ⊗ q = q ⊙ p`.
    #[strum(
        to_string = "left",
        serialize = "shuster-product",
        serialize = "jpl-product",
        serialize = "ij=-k"
    )]
    Left,
}

/// What stays and what is turned when the quaternion acts on a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
// JavaScript has a global `Function` of its own.
#[serde(rename = "RotationFunction", rename_all = "kebab-case")]
#[derive(Display, EnumMessage, VariantArray, VariantNames)]
#[doc(alias("alias", "alibi"))]
pub enum Function {
    /// The vector stays and its coordinates change from the axes of the first
    /// frame to the axes of the second (also called *alias*).
    #[strum(to_string = "passive", serialize = "alias")]
    Passive,
    /// The axes stay and the vector is moved, by the turn that carries the axes
    /// of the first frame onto those of the second (also called *alibi*).
    #[strum(to_string = "active", serialize = "alibi")]
    Active,
}

impl Function {
    /// The direction of the passive matrix or quaternion that has the same numbers: the active one
    /// from X to Y is the inverse of the passive one.
    pub(crate) const fn passive_direction(self, direction: Direction) -> Direction {
        match self {
            Self::Passive => direction,
            Self::Active => direction.reversed(),
        }
    }
}

/// From which frame to which the quaternion leads.
///
/// It also names a rotation matrix: the one with this direction is the passive
/// one, which takes coordinates in the first frame to coordinates in the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(Display, EnumMessage, VariantArray, VariantNames)]
#[doc(alias("directionality", "B2W", "W2B", "local-to-global", "global-to-local"))]
pub enum Direction {
    /// From the body frame B to the world frame W.
    #[strum(
        to_string = "body-to-world",
        serialize = "b2w",
        serialize = "local-to-global"
    )]
    BodyToWorld,
    /// From the world frame W to the body frame B.
    #[strum(
        to_string = "world-to-body",
        serialize = "w2b",
        serialize = "global-to-local"
    )]
    WorldToBody,
}

impl Direction {
    /// The opposite direction.
    #[must_use]
    pub const fn reversed(self) -> Self {
        match self {
            Self::BodyToWorld => Self::WorldToBody,
            Self::WorldToBody => Self::BodyToWorld,
        }
    }
}

/// On which axes a small turn is expressed when it is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(Display, EnumMessage, VariantArray, VariantNames)]
#[doc(alias("error-state", "tangent space"))]
pub enum Perturbation {
    /// On the axes of the body.
    #[strum(to_string = "local", serialize = "body")]
    Local,
    /// On the axes of the world.
    #[strum(to_string = "global", serialize = "world")]
    Global,
}

/// The values of each of the five choices as an array, their names and what reads these.
macro_rules! choices {
    ($($choice:ident),+) => { $(
        impl $choice {
            /// Both values, in the order in which the documentation lists them.
            pub const ALL: [Self; 2] = names::all(VariantArray::VARIANTS);

            /// The name that [`Display`](std::fmt::Display) writes and JavaScript uses.
            #[must_use]
            pub const fn name(self) -> &'static str {
                <Self as VariantNames>::VARIANTS[self as usize]
            }
        }

        impl FromStr for $choice {
            type Err = UnknownName;

            fn from_str(name: &str) -> Result<Self, UnknownName> {
                names::named(name)
            }
        }
    )+ };
}

choices!(
    ComponentOrder,
    Handedness,
    Function,
    Direction,
    Perturbation
);

/// Whether the components are those of the canonical quaternion or of its conjugate.
///
/// This is the sign σ of the specification: two conventions give one attitude
/// the same numbers if and only if their signs agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, VariantArray)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[doc(alias = "sigma")]
pub enum ComponentSign {
    /// σ = +1: the components of the canonical quaternion.
    Canonical,
    /// σ = −1: its vector part has the other sign.
    Conjugated,
}

impl ComponentSign {
    /// Both.
    pub const ALL: [Self; 2] = names::all(VariantArray::VARIANTS);
}

/// What four numbers mean: five independent choices.
///
/// The presets are [`Convention::HAMILTON`] and [`Convention::JPL`]; there are
/// 32 combinations in all, and every one can be built.
///
/// Displayed as its five names. Parsed from all five names, or from a preset's
/// name followed by those that differ, in any order:
///
/// ```
/// use quatlas::{Convention, Direction};
///
/// // JPL as in Yoosefian 2021, eq. 18: the direction is body to world.
/// let convention: Convention = "jpl body-to-world".parse()?;
/// assert_eq!(convention, Convention { direction: Direction::BodyToWorld, ..Convention::JPL });
/// assert_eq!(convention.to_string(), "scalar-last left passive body-to-world local");
/// # Ok::<(), quatlas::UnknownName>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Convention {
    /// In which order the four numbers are written.
    pub order: ComponentOrder,
    /// Which product: `ij = k` or `ij = -k`.
    pub handedness: Handedness,
    /// Whether the coordinates change or the vector moves.
    pub function: Function,
    /// From which frame to which.
    pub direction: Direction,
    /// On which axes a small turn is expressed.
    pub perturbation: Perturbation,
}

impl Convention {
    /// Hamilton: `[w, x, y, z]`, `ij = k`, body coordinates to world coordinates.
    ///
    /// Eigen, ROS, Ceres and most others, some of them with the scalar last.
    pub const HAMILTON: Self = Self {
        order: ComponentOrder::ScalarFirst,
        handedness: Handedness::Right,
        function: Function::Passive,
        direction: Direction::BodyToWorld,
        perturbation: Perturbation::Local,
    };

    /// JPL (Shuster): `[x, y, z, w]`, `ij = -k`, world coordinates to body coordinates.
    ///
    /// MSCKF, `OpenVINS` and the attitude literature of spaceflight.
    #[doc(alias = "shuster")]
    pub const JPL: Self = Self {
        order: ComponentOrder::ScalarLast,
        handedness: Handedness::Left,
        function: Function::Passive,
        direction: Direction::WorldToBody,
        perturbation: Perturbation::Local,
    };

    /// JPL as in Yoosefian 2021, eq. 18: body to world, so that its matrix is Hamilton's and its
    /// numbers are the conjugate.
    pub const JPL_BODY_TO_WORLD: Self = Self {
        direction: Direction::BodyToWorld,
        ..Self::JPL
    };

    /// The field guide's "My Lab": active, world to body; the numbers are Hamilton's.
    ///
    /// The guide pairs it with the passive matrix of the same direction, `R_BW`.
    pub const MY_LAB: Self = Self {
        function: Function::Active,
        direction: Direction::WorldToBody,
        ..Self::HAMILTON
    };

    /// Hamilton with the scalar last, as Eigen and ROS store it.
    pub const HAMILTON_SCALAR_LAST: Self = Self {
        order: ComponentOrder::ScalarLast,
        ..Self::HAMILTON
    };

    /// Which matrix the quaternion acts with: `q∘v∘q⁻¹` takes the coordinates of `v` in this
    /// direction, `∘` being the convention's own product.
    ///
    /// Body to world is τ = +1 of the specification (section 1.3), world to body τ = −1.
    #[must_use]
    #[doc(alias = "tau")]
    pub const fn operator(self) -> Direction {
        self.function.passive_direction(self.direction)
    }

    /// Whether, of two labelled quaternions, that of A to B stands on the left in that of A to C.
    ///
    /// Active: `q_AC = q_AB∘q_BC`. Passive: `q_AC = q_BC∘q_AB` (specification, table 2.1). Here A to
    /// C means what the direction says, coordinates or axes that lead from A to C.
    #[must_use]
    pub const fn first_label_is_left(self) -> bool {
        matches!(self.function, Function::Active)
    }

    /// Whether, along the chain W–B–C, the quaternion of B in W stands on the left in that of C in W.
    ///
    /// `q_WB∘q_BC` where the operator is body to world, `q_BC∘q_WB` where it is world to body; the
    /// quaternions of the pairs (W, B), (B, C), (W, C), whichever way their labels read
    /// (specification, MODEL-18).
    #[must_use]
    pub const fn first_in_chain_is_left(self) -> bool {
        matches!(self.operator(), Direction::BodyToWorld)
    }

    /// The sign σ of the vector part against the canonical quaternion (specification, 1.3).
    #[must_use]
    #[doc(alias = "sigma")]
    pub const fn component_sign(self) -> ComponentSign {
        match (self.handedness, self.operator()) {
            (Handedness::Right, Direction::BodyToWorld)
            | (Handedness::Left, Direction::WorldToBody) => ComponentSign::Canonical,
            (Handedness::Right, Direction::WorldToBody)
            | (Handedness::Left, Direction::BodyToWorld) => ComponentSign::Conjugated,
        }
    }
}

impl fmt::Display for Convention {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} {} {} {} {}",
            self.order, self.handedness, self.function, self.direction, self.perturbation
        )
    }
}

impl FromStr for Convention {
    type Err = UnknownName;

    fn from_str(text: &str) -> Result<Self, UnknownName> {
        let unknown = || UnknownName {
            name: text.to_owned(),
        };
        let mut words = text.split_whitespace().peekable();
        let preset = words
            .next_if(|word| preset(word).is_some())
            .and_then(preset);
        let mut order = preset.map(|preset| preset.order);
        let mut handedness = preset.map(|preset| preset.handedness);
        let mut function = preset.map(|preset| preset.function);
        let mut direction = preset.map(|preset| preset.direction);
        let mut perturbation = preset.map(|preset| preset.perturbation);
        for word in words {
            if let Ok(named) = word.parse() {
                order = Some(named);
            } else if let Ok(named) = word.parse() {
                handedness = Some(named);
            } else if let Ok(named) = word.parse() {
                function = Some(named);
            } else if let Ok(named) = word.parse() {
                direction = Some(named);
            } else {
                perturbation = Some(word.parse()?);
            }
        }
        Ok(Self {
            order: order.ok_or_else(unknown)?,
            handedness: handedness.ok_or_else(unknown)?,
            function: function.ok_or_else(unknown)?,
            direction: direction.ok_or_else(unknown)?,
            perturbation: perturbation.ok_or_else(unknown)?,
        })
    }
}

fn preset(name: &str) -> Option<Convention> {
    match name.to_ascii_lowercase().as_str() {
        "hamilton" => Some(Convention::HAMILTON),
        "jpl" | "shuster" => Some(Convention::JPL),
        "jpl-eq18" => Some(Convention::JPL_BODY_TO_WORLD),
        "my-lab" => Some(Convention::MY_LAB),
        "eigen" | "ros" => Some(Convention::HAMILTON_SCALAR_LAST),
        _ => None,
    }
}
