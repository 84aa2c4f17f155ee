//! The arithmetic of typed text: a real number, or a sum `a + bi + cj + dk`.
//!
//! A product of two imaginary units is refused, because its sign is what the
//! conventions disagree about; so nothing here depends on a convention.

use crate::convention::angle::{AngleUnit, degrees_in_radians, turn_in_radians};
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::text::grammar::lex::{Token, last_segment};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI, TAU};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Linear {
    pub(crate) scalar: f64,
    /// The coefficients of i, j and k, where at least one of these units was written.
    pub(crate) units: Option<[f64; 3]>,
    pub(crate) quantity: Quantity,
}

/// Whether a number was given with a unit of angle, and so cannot be a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Number,
    /// A number made of π: radians, if it is an angle.
    OfPi,
    /// In the unit of the text: degrees stay degrees until the whole angle is known.
    Angle(AngleUnit),
}

impl Linear {
    pub(crate) const fn real(scalar: f64) -> Self {
        Self {
            scalar,
            units: None,
            quantity: Quantity::Number,
        }
    }

    const fn of_pi(scalar: f64) -> Self {
        Self {
            quantity: Quantity::OfPi,
            ..Self::real(scalar)
        }
    }

    pub(crate) fn unit(name: &str) -> Option<Self> {
        let units = match name {
            "i" => [1.0, 0.0, 0.0],
            "j" => [0.0, 1.0, 0.0],
            "k" => [0.0, 0.0, 1.0],
            _ => return None,
        };
        Some(Self {
            units: Some(units),
            ..Self::real(0.0)
        })
    }

    pub(crate) fn constant(name: &str) -> Option<Self> {
        match last_segment(name) {
            "pi" | "PI" | "Pi" | "π" | "M_PI" => Some(Self::of_pi(PI)),
            "M_PI_2" | "FRAC_PI_2" => Some(Self::of_pi(FRAC_PI_2)),
            "M_PI_4" | "FRAC_PI_4" => Some(Self::of_pi(FRAC_PI_4)),
            "tau" | "TAU" | "τ" => Some(Self::of_pi(TAU)),
            "SQRT1_2" | "M_SQRT1_2" | "FRAC_1_SQRT_2" => Some(Self::real(FRAC_1_SQRT_2)),
            _ => None,
        }
    }

    pub(crate) fn is_function(name: &str) -> bool {
        function(name).is_some() || is_cast(name)
    }

    /// Whether it is a function of an angle: a sine, a cosine or a tangent.
    pub(crate) fn takes_angle(name: &str) -> bool {
        matches!(last_segment(name), "sin" | "cos" | "tan")
    }

    /// Whether a word stands for a number or makes one.
    pub(crate) fn is_known(name: &str) -> bool {
        Self::is_function(name) || Self::constant(name).is_some()
    }

    /// A function of one real number; `argument_span` is where the number stands.
    pub(crate) fn call(
        name: &str,
        argument: Self,
        argument_span: Span,
        span: Span,
    ) -> Result<Self, Fault> {
        let Some(function) = function(name) else {
            return Ok(argument);
        };
        if argument.units.is_some() {
            return Err(Fault::product_of_units(argument_span));
        }
        let argument = argument.radians();
        let value = function(argument.scalar);
        if value.is_nan() {
            return Err(Fault::no_real_value(span, name));
        }
        let result = if is_to_radians(name) {
            Self::of_pi(value)
        } else {
            Self::real(value)
        };
        result.checked(span)
    }

    pub(crate) fn plus(self, other: Self, span: Span) -> Result<Self, Fault> {
        let units = match (self.units, other.units) {
            (Some(a), Some(b)) => Some([a[0] + b[0], a[1] + b[1], a[2] + b[2]]),
            (units, None) | (None, units) => units,
        };
        Self {
            scalar: self.scalar + other.scalar,
            units,
            quantity: self.quantity_of_sum(other, span)?,
        }
        .checked(span)
    }

    /// Only zero may stand without a unit beside an angle with one.
    fn quantity_of_sum(self, other: Self, span: Span) -> Result<Quantity, Fault> {
        let is_zero = |term: Self| term.quantity == Quantity::Number && term.scalar == 0.0;
        match (self.quantity, other.quantity) {
            (Quantity::Angle(one), Quantity::Angle(two)) if one != two => {
                Err(Fault::mixed_units(span))
            }
            (Quantity::Angle(_), Quantity::Number) if !is_zero(other) => {
                Err(Fault::angle_and_number(span))
            }
            (Quantity::Number, Quantity::Angle(_)) if !is_zero(self) => {
                Err(Fault::angle_and_number(span))
            }
            (Quantity::Angle(AngleUnit::Degrees), Quantity::OfPi)
            | (Quantity::OfPi, Quantity::Angle(AngleUnit::Degrees)) => {
                Err(Fault::mixed_units(span))
            }
            (one, two) => Ok(one.with(two)),
        }
    }

    pub(crate) fn negated(self) -> Self {
        Self {
            scalar: -self.scalar,
            units: self.units.map(|[i, j, k]| [-i, -j, -k]),
            ..self
        }
    }

    pub(crate) fn times(self, other: Self, span: Span) -> Result<Self, Fault> {
        let (factor, linear) = match (self.units, other.units) {
            (Some(_), Some(_)) => return Err(Fault::product_of_units(span)),
            (None, _) => (self.scalar, other),
            (_, None) => (other.scalar, self),
        };
        if let (Quantity::Angle(_), Quantity::Angle(_)) = (self.quantity, other.quantity) {
            return Err(Fault::second_unit(span));
        }
        let product = linear.map_checked(span, factor != 0.0, &|number| number * factor)?;
        Ok(Self {
            quantity: self.quantity.with(other.quantity),
            ..product
        })
    }

    pub(crate) fn over(self, other: Self, other_span: Span, span: Span) -> Result<Self, Fault> {
        if other.units.is_some() {
            return Err(Fault::product_of_units(other_span));
        }
        if other.scalar == 0.0 {
            return Err(Fault::division_by_zero(other_span));
        }
        if matches!(other.quantity, Quantity::Angle(_)) {
            return Err(Fault::second_unit(other_span));
        }
        self.map_checked(span, true, &|number| number / other.scalar)
    }

    /// An angle of so many degrees or radians.
    pub(crate) fn angle(self, unit: AngleUnit, span: Span) -> Result<Self, Fault> {
        if matches!(self.quantity, Quantity::Angle(_)) {
            return Err(Fault::second_unit(span));
        }
        if (self.quantity, unit) == (Quantity::OfPi, AngleUnit::Degrees) {
            return Err(Fault::degrees_of_pi(span));
        }
        Ok(Self {
            quantity: Quantity::Angle(unit),
            ..self
        })
    }

    /// The same in radians, of any size.
    pub(crate) fn radians(self) -> Self {
        self.map_degrees(degrees_in_radians)
    }

    /// The same turn in radians: whole turns of many are left out, exactly.
    pub(crate) fn turn(self) -> Self {
        self.map_degrees(turn_in_radians)
    }

    fn map_degrees(self, in_radians: impl Fn(f64) -> f64) -> Self {
        if self.quantity != Quantity::Angle(AngleUnit::Degrees) {
            return self;
        }
        Self {
            scalar: in_radians(self.scalar),
            ..self
        }
    }

    /// Applies a scaling to every part; a part that was not zero must not become zero by rounding.
    fn map_checked(
        self,
        span: Span,
        keeps_non_zero: bool,
        scale: &dyn Fn(f64) -> f64,
    ) -> Result<Self, Fault> {
        let mut parts = self.parts();
        for part in &mut parts {
            let before = *part;
            *part = scale(before);
            if keeps_non_zero && before != 0.0 && *part == 0.0 {
                return Err(Fault::too_small(span));
            }
        }
        let [scalar, i, j, k] = parts;
        let scaled = Self {
            scalar,
            units: self.units.and(Some([i, j, k])),
            ..self
        };
        scaled.checked(span)
    }

    fn checked(self, span: Span) -> Result<Self, Fault> {
        if self.parts().iter().all(|part| part.is_finite()) {
            Ok(self)
        } else {
            Err(Fault::too_large(span))
        }
    }

    fn parts(&self) -> [f64; 4] {
        let [i, j, k] = self.units.unwrap_or_default();
        [self.scalar, i, j, k]
    }
}

impl Quantity {
    fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Angle(_), _) => self,
            (_, Self::Angle(_)) | (Self::Number, _) => other,
            (Self::OfPi, _) => self,
        }
    }
}

fn function(name: &str) -> Option<fn(f64) -> f64> {
    Some(match last_segment(name) {
        "sqrt" => libm::sqrt,
        "abs" => libm::fabs,
        "sin" => libm::sin,
        "cos" => libm::cos,
        "tan" => libm::tan,
        "asin" => libm::asin,
        "acos" => libm::acos,
        "atan" => libm::atan,
        _ if is_to_radians(name) => degrees_in_radians,
        _ => return None,
    })
}

fn is_to_radians(name: &str) -> bool {
    matches!(last_segment(name), "deg2rad" | "radians" | "degToRad")
}

/// Casts that printed arrays carry, such as `np.float64(0.5)`: the number itself.
fn is_cast(name: &str) -> bool {
    matches!(
        last_segment(name),
        "float64" | "float32" | "float" | "double"
    )
}

/// How programs print what is no finite number.
pub(crate) fn not_finite(token: &Token<'_>) -> Option<Fault> {
    match token.text.to_ascii_lowercase().as_str() {
        "nan" => Some(Fault::not_a_number(token.span, token.text)),
        "inf" | "infinity" => Some(Fault::infinite(token.span)),
        _ => None,
    }
}
