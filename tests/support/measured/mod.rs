//! Errors in units of u = 2^-53 against references of 50 digits (see `vectors/README.md`).

pub(crate) mod operations;

use num_bigint::BigInt;
use quatlas::nalgebra::Vector3;
use quatlas::{Convention, EulerSequence, Rotation, TaggedQuaternion};
use serde_json::Value;

/// Half a unit in the last place of 1.
pub(crate) const U: f64 = f64::EPSILON / 2.0;

/// A decimal number, exactly: `digits * 10^exponent`.
pub(crate) struct Reference {
    digits: BigInt,
    exponent: i32,
    /// The nearest double.
    pub(crate) nearest: f64,
}

impl Reference {
    fn parse(text: &str) -> Self {
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let exponent: i32 = exponent.parse().expect("an exponent");
        Self {
            digits: format!("{whole}{fraction}").parse().expect("digits"),
            exponent: exponent - i32::try_from(fraction.len()).expect("few digits"),
            nearest: text.parse().expect("a number"),
        }
    }

    /// `number - self`, rounded only at the end.
    pub(crate) fn difference(&self, number: f64) -> f64 {
        let (mantissa, power) = integer_times_power_of_two(number);
        // Over the common denominator 10^a 2^b both are integers.
        let tens = BigInt::from(10).pow(self.exponent.unsigned_abs());
        let twos = BigInt::from(1) << power.unsigned_abs();
        let (mut left, mut right, mut denominator) =
            (mantissa, self.digits.clone(), BigInt::from(1));
        if self.exponent < 0 {
            left *= &tens;
            denominator *= &tens;
        } else {
            right *= &tens;
        }
        if power < 0 {
            right *= &twos;
            denominator *= &twos;
        } else {
            left *= &twos;
        }
        quotient(&(left - right), &denominator)
    }
}

fn integer_times_power_of_two(number: f64) -> (BigInt, i32) {
    assert!(number.is_finite(), "a result is {number}");
    let (fraction, exponent) = libm::frexp(number);
    #[allow(clippy::cast_possible_truncation, reason = "53 bits are exact")]
    let mantissa = (fraction * 2.0_f64.powi(53)) as i64;
    (mantissa.into(), exponent - 53)
}

/// A quotient of integers that may be too large for doubles.
fn quotient(numerator: &BigInt, denominator: &BigInt) -> f64 {
    let rounded = |number: &BigInt| {
        let excess = number.bits().saturating_sub(1000);
        let kept = number >> excess;
        let value: f64 = kept.to_string().parse().expect("a number");
        (value, i32::try_from(excess).expect("not that large"))
    };
    let ((above, above_excess), (below, below_excess)) = (rounded(numerator), rounded(denominator));
    libm::scalbn(above / below, above_excess - below_excess)
}

pub(crate) struct Case {
    pub(crate) group: String,
    pub(crate) sequence: Option<EulerSequence>,
    pub(crate) input: Vec<f64>,
    pub(crate) output: Vec<Reference>,
}

impl Case {
    fn of(value: &Value) -> Self {
        let text = |name: &str| value[name].as_str();
        let list = |name: &str| value[name].as_array().expect("a list").clone();
        let sequence = text("sequence").map(|letters| {
            let is_extrinsic = text("frame") == Some("extrinsic");
            let letters = if is_extrinsic {
                letters.to_lowercase()
            } else {
                letters.to_owned()
            };
            letters.parse().expect("a sequence")
        });
        Self {
            group: text("group").expect("a group").to_owned(),
            sequence,
            input: list("input")
                .iter()
                .map(|number| number.as_f64().expect("a number"))
                .collect(),
            output: list("output")
                .iter()
                .map(|digits| Reference::parse(digits.as_str().expect("digits")))
                .collect(),
        }
    }

    pub(crate) fn quaternion(&self, place: usize) -> TaggedQuaternion {
        let [w, x, y, z] = self.array(place);
        TaggedQuaternion::new(w, x, y, z, Convention::HAMILTON)
    }

    pub(crate) fn rotation(&self, place: usize) -> Rotation {
        Rotation::from_tagged(&self.quaternion(place)).expect("not zero")
    }

    pub(crate) fn array<const COUNT: usize>(&self, place: usize) -> [f64; COUNT] {
        self.input[place..place + COUNT]
            .try_into()
            .expect("as many numbers")
    }

    pub(crate) fn vector(&self, place: usize) -> Vector3<f64> {
        self.array::<3>(place).into()
    }

    pub(crate) fn sequence(&self) -> EulerSequence {
        self.sequence.expect("a sequence")
    }

    fn differences(&self, got: &[f64]) -> Vec<f64> {
        assert_eq!(got.len(), self.output.len());
        let pairs = self.output.iter().zip(got);
        pairs.map(|(exact, &got)| exact.difference(got)).collect()
    }

    fn size(&self) -> f64 {
        norm(self.output.iter().map(|exact| exact.nearest))
    }
}

fn norm(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let numbers: Vec<f64> = numbers.into_iter().collect();
    let largest = numbers.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let sum: f64 = numbers.iter().map(|n| (n / largest) * (n / largest)).sum();
    largest * sum.sqrt()
}

/// Rotation vectors so long that 106 bits of their length leave nothing of the angle: no bound holds.
pub(crate) const NO_BOUND: &str = "beyond 1e15";

/// The cases of an operation.
pub(crate) fn cases(operation: &str) -> Vec<Case> {
    let file: Value =
        serde_json::from_str(include_str!("../../vectors/accuracy.json")).expect("JSON");
    let cases = file["operations"][operation].as_array().expect("cases");
    cases.iter().map(Case::of).collect()
}

/// How an error is measured, in u.
#[derive(Clone, Copy)]
pub(crate) enum Measure {
    /// The worst relative error of a component.
    EachRelative,
    /// The worst error of a component.
    EachAbsolute,
    /// The norm of the error as a part of the norm of the result.
    Relative,
    /// The same, of the result or its negative.
    RelativeUpToSign,
    /// The norm of the error as a part of the norm of the vector at this place of the input.
    OfInputVector(usize),
    /// The worst error of an angle, all turns the same.
    EachAngle,
    /// The angle of the rotation that three wrong Euler angles amount to.
    EulerRotation,
}

impl Measure {
    /// The error in u. Half of the smallest double is always allowed: no result is nearer.
    pub(crate) fn error(self, case: &Case, got: &[f64]) -> f64 {
        if got.iter().any(|number| !number.is_finite()) {
            return f64::INFINITY;
        }
        let differences = case.differences(got);
        let beyond_smallest = |difference: &f64| {
            if difference.abs() <= 5e-324 {
                0.0
            } else {
                *difference
            }
        };
        let size = case.size();
        let relative = |differences: &[f64]| {
            let error = norm(differences.iter().map(beyond_smallest));
            if error == 0.0 { 0.0 } else { error / size }
        };
        let error = match self {
            Self::EachRelative => differences
                .iter()
                .zip(&case.output)
                .map(|(difference, exact)| match beyond_smallest(difference) {
                    0.0 => 0.0,
                    error => error.abs() / exact.nearest.abs(),
                })
                .fold(0.0, f64::max),
            Self::EachAbsolute => differences
                .iter()
                .fold(0.0_f64, |most, d| most.max(d.abs())),
            Self::Relative => relative(&differences),
            Self::RelativeUpToSign => {
                let negative: Vec<f64> = got.iter().map(|number| -number).collect();
                relative(&differences).min(relative(&case.differences(&negative)))
            }
            Self::OfInputVector(place) => {
                norm(differences) / norm(case.input[place..place + 3].iter().copied())
            }
            Self::EachAngle => differences
                .into_iter()
                .map(|difference| in_one_turn(difference).abs())
                .fold(0.0, f64::max),
            Self::EulerRotation => {
                let [i, j, k] = case.sequence().axes.axes().map(|axis| {
                    let mut unit = [0.0; 3];
                    unit[axis.index()] = 1.0;
                    unit
                });
                let turn = |axis, angle| Rotation::from_axis_angle(axis, angle).expect("an axis");
                let exact: Vec<f64> = case.output.iter().map(|exact| exact.nearest).collect();
                // In an extrinsic sequence the last angle is the outermost.
                let is_extrinsic =
                    case.sequence().to_string() == case.sequence().to_string().to_lowercase();
                let (outer, inner, first, last) = if is_extrinsic {
                    (k, i, exact[2], 2)
                } else {
                    (i, k, exact[0], 0)
                };
                let outermost = turn(outer, first);
                let inner_axis = (outermost * turn(j, exact[1])).body_to_world(inner.into());
                let differences: Vec<f64> = differences.into_iter().map(in_one_turn).collect();
                norm(
                    (Vector3::from(outer) * differences[last]
                        + outermost.body_to_world(j.into()) * differences[1]
                        + inner_axis * differences[2 - last])
                        .iter()
                        .copied(),
                )
            }
        };
        error / U
    }
}

/// A difference of angles without the whole turns.
fn in_one_turn(difference: f64) -> f64 {
    let turns = (difference / std::f64::consts::TAU).round();
    // 2π is 2^-52.7 more than the double, which matters where the angles are an ulp apart.
    difference - turns * std::f64::consts::TAU - turns * 2.449_293_598_294_706_4e-16
}
