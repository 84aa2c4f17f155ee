//! The 24 Euler sequences: which axes, in which order, and whether they move along.
//!
//! An *intrinsic* sequence turns about the axes of the body, which every turn carries along (the
//! field guide: *successive*); an *extrinsic* one about the axes of the world, which stay (*fixed*).
//! The three angles follow the three letters in both. With `R_n(a)` the right-handed turn by `a`
//! about axis `n`, the attitude body to world is
//!
//! | sequence i-j-k with angles a, b, c | `R_WB` |
//! |---|---|
//! | intrinsic | `R_i(a) R_j(b) R_k(c)` |
//! | extrinsic | `R_k(c) R_j(b) R_i(a)` |
//!
//! so an extrinsic sequence is the intrinsic one read backwards (field guide, Euler angles). What a
//! function or direction changes is only the matrix or quaternion that is made of the attitude,
//! never the angles.

use crate::convention::names;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt;
use std::str::FromStr;
use strum::{VariantArray, VariantNames};

/// A coordinate axis, right-handed in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// The first axis, 1.
    X,
    /// The second axis, 2.
    Y,
    /// The third axis, 3.
    Z,
}

impl Axis {
    /// 0, 1 or 2: the place of this axis in an array of coordinates.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }
}

/// Whether the axes of the turns move along with the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
#[derive(VariantArray, VariantNames)]
#[strum(serialize_all = "kebab-case")]
#[doc(alias("rotating", "static", "moving axes", "fixed axes"))]
pub enum EulerFrame {
    /// About the axes of the body, which move (field guide: *successive*).
    Intrinsic,
    /// About the axes of the world, which stay (field guide: *fixed*).
    Extrinsic,
}

impl EulerFrame {
    /// Both.
    pub const ALL: [Self; 2] = names::all(VariantArray::VARIANTS);

    /// The name that is read back, in JSON and in JavaScript too.
    #[must_use]
    pub const fn name(self) -> &'static str {
        <Self as VariantNames>::VARIANTS[self as usize]
    }
}

/// The axes of the three turns in their order; the 12 that reach every attitude.
///
/// 27 strings of three letters exist. In the other 15 an axis follows itself, so that they are no
/// parametrisation (the field guide's footnote to table 1 counts them as redundant ones).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "lowercase")]
#[derive(VariantArray, VariantNames)]
#[strum(serialize_all = "UPPERCASE")]
#[allow(missing_docs, reason = "the names say it")]
pub enum EulerAxes {
    Xyz,
    Xzy,
    Yxz,
    Yzx,
    Zxy,
    Zyx,
    Xyx,
    Xzx,
    Yxy,
    Yzy,
    Zxz,
    Zyz,
}

impl EulerAxes {
    /// The six Tait-Bryan sequences (three different axes), then the six proper ones.
    pub const ALL: [Self; 12] = names::all(VariantArray::VARIANTS);

    /// The places of those axes in an array of coordinates.
    pub(crate) const fn places(self) -> [usize; 3] {
        let [one, two, three] = self.axes();
        [one.index(), two.index(), three.index()]
    }

    /// The axis of the first, second and third angle.
    #[must_use]
    pub const fn axes(self) -> [Axis; 3] {
        use Axis::{X, Y, Z};
        match self {
            Self::Xyz => [X, Y, Z],
            Self::Xzy => [X, Z, Y],
            Self::Yxz => [Y, X, Z],
            Self::Yzx => [Y, Z, X],
            Self::Zxy => [Z, X, Y],
            Self::Zyx => [Z, Y, X],
            Self::Xyx => [X, Y, X],
            Self::Xzx => [X, Z, X],
            Self::Yxy => [Y, X, Y],
            Self::Yzy => [Y, Z, Y],
            Self::Zxz => [Z, X, Z],
            Self::Zyz => [Z, Y, Z],
        }
    }

    /// The letters in upper case.
    pub(crate) const fn name(self) -> &'static str {
        <Self as VariantNames>::VARIANTS[self as usize]
    }
}

/// These letters are not one of the 24 sequences.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownSequence {
    name: String,
}

impl fmt::Display for UnknownSequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{:?} is no Euler sequence: three axes, none after itself, as in ZYX or xyz",
            self.name
        )
    }
}

impl std::error::Error for UnknownSequence {}

/// Three axes and whether they move: one of 24.
///
/// Displayed and parsed in the manner of `SciPy`: capitals are intrinsic, small letters extrinsic.
/// Digits are axes too and are intrinsic, as in the aerospace books.
///
/// ```
/// use quatlas::{Axis, EulerFrame, EulerSequence};
/// let sequence: EulerSequence = "3-2-1".parse()?;
/// assert_eq!(sequence, EulerSequence::AEROSPACE);
/// assert_eq!(sequence.to_string(), "ZYX");
/// assert_eq!("xyz".parse(), Ok(EulerSequence::ROLL_PITCH_YAW));
/// assert!("XXY".parse::<EulerSequence>().is_err());
/// # Ok::<(), quatlas::UnknownSequence>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EulerSequence {
    /// The axes in the order of the angles.
    pub axes: EulerAxes,
    /// Whether they move along.
    pub frame: EulerFrame,
}

impl Default for EulerSequence {
    /// The aerospace sequence.
    fn default() -> Self {
        Self::AEROSPACE
    }
}

impl EulerSequence {
    /// Yaw, pitch, roll about the moving axes z, y, x: the aerospace sequence 3-2-1.
    #[doc(alias("ypr", "Tait-Bryan"))]
    pub const AEROSPACE: Self = Self {
        axes: EulerAxes::Zyx,
        frame: EulerFrame::Intrinsic,
    };

    /// Roll, pitch, yaw about the fixed axes x, y, z, as in ROS (`tf`, URDF `rpy`).
    ///
    /// The same attitude as [`EulerSequence::AEROSPACE`] with the angles in reverse order.
    #[doc(alias("rpy", "fixed XYZ"))]
    pub const ROLL_PITCH_YAW: Self = Self {
        axes: EulerAxes::Xyz,
        frame: EulerFrame::Extrinsic,
    };

    /// All 24: the intrinsic ones, then the extrinsic ones.
    pub fn all() -> impl Iterator<Item = Self> {
        let of = |frame| EulerAxes::ALL.map(|axes| Self { axes, frame });
        of(EulerFrame::Intrinsic)
            .into_iter()
            .chain(of(EulerFrame::Extrinsic))
    }

    /// The two middle angles, in radians, at which the outer axes are one line: gimbal lock.
    ///
    /// 0 and π where the outer axes are the same, π/2 and −π/2 where they differ.
    #[must_use]
    pub const fn locks_rad(self) -> [f64; 2] {
        if self.is_proper() {
            [0.0, PI]
        } else {
            [FRAC_PI_2, -FRAC_PI_2]
        }
    }

    /// The place of the angle that is set to 0 at gimbal lock: that about the body's own axis, the
    /// last of an intrinsic sequence and the first of an extrinsic one.
    #[must_use]
    pub const fn lost_at_lock(self) -> usize {
        match self.frame {
            EulerFrame::Intrinsic => 2,
            EulerFrame::Extrinsic => 0,
        }
    }

    /// The sequence of the inverse, whose turns follow each other backwards.
    pub(crate) fn backwards(self) -> Self {
        let [first, second, third] = self.axes.axes();
        let mut axes = self.axes;
        for other in EulerAxes::ALL {
            if other.axes() == [third, second, first] {
                axes = other;
            }
        }
        Self { axes, ..self }
    }

    /// Whether both turn about the same axes, in whatever order.
    pub(crate) fn has_axes_of(self, other: Self) -> bool {
        let (own, others) = (self.axes.axes(), other.axes.axes());
        own.iter().all(|axis| others.contains(axis)) && others.iter().all(|axis| own.contains(axis))
    }

    /// Whether the first and the third axis are the same, as in ZYZ: a *proper* Euler sequence.
    #[must_use]
    pub const fn is_proper(self) -> bool {
        let [first, _, third] = self.axes.axes();
        first.index() == third.index()
    }
}

impl fmt::Display for EulerSequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.frame {
            EulerFrame::Intrinsic => f.write_str(self.axes.name()),
            EulerFrame::Extrinsic => f.write_str(&self.axes.name().to_ascii_lowercase()),
        }
    }
}

impl FromStr for EulerSequence {
    type Err = UnknownSequence;

    fn from_str(text: &str) -> Result<Self, UnknownSequence> {
        let unknown = || UnknownSequence {
            name: text.to_owned(),
        };
        let mut letters = String::new();
        let (mut has_small, mut has_others) = (false, false);
        for mark in text.trim().chars().filter(|mark| *mark != '-') {
            if mark.is_ascii_lowercase() {
                has_small = true;
            } else {
                has_others = true;
            }
            letters.push(match mark {
                '1' => 'X',
                '2' => 'Y',
                '3' => 'Z',
                letter => letter.to_ascii_uppercase(),
            });
        }
        let frame = match (has_small, has_others) {
            (true, false) => EulerFrame::Extrinsic,
            (false, _) => EulerFrame::Intrinsic,
            (true, true) => return Err(unknown()),
        };
        for axes in EulerAxes::ALL {
            if axes.name() == letters {
                return Ok(Self { axes, frame });
            }
        }
        Err(unknown())
    }
}
