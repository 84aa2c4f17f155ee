//! A text to an attitude, and the attitude to numbers in a convention.

use crate::angle::{AngleUnit, UnitSource};
use crate::bare_arguments;
use crate::convention::{ComponentOrder, Convention};
use crate::describe::{HALF_TURN_SCALAR, is_half_turn, rules};
use crate::matrix_reading::of_matrix;
use crate::matrix_rows::RowMarks;
use crate::messages::Fault;
use crate::parse::{ParsedQuaternion, ParsedRotation, parse_rotation};
use crate::problem::{Field, Problem, Span};
use crate::quaternion::{TaggedQuaternion, UNIT_NORM_TOLERANCE};
use crate::report::{
    AngleUnitAssumed, AxesAsColumns, Column, Components, Fact, Form, NearlyHalfTurn, NearlyNoTurn,
    Normalised, Note, OrderAssumed, OrderFromText, OrderSource, PairedMatrix, ReadAxisAngle,
    ReadEulerAngles, ReadGibbsVector, ReadHalfAngleVector, ReadModifiedRodrigues, ReadQuaternion,
    ReadRotationVector, RowsAssumed, UnknownConstructor, UsedNearestRotation, coordinates, plain,
    rows3, rows4,
};
use crate::rotation::Rotation;
use crate::rotation_matrix::MatrixConvention;
use crate::rotation_vector::{AxisVector, half_angle_exponential};
use crate::suggestion::with_suggestion;
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::{PI, TAU};

/// Nearer than this, in radians, to no turn or to half a turn, rounding decides more than the text.
///
/// Near no turn the vector part of length 5e-5 is off by up to √3 · 5e-7 in six decimals, and the
/// axis by a degree. Near half a turn the scalar is 5e-5, which four decimals write as 0, and with
/// it the sign of the axis is lost.
const NEARLY_RAD: f64 = 1e-4;

/// The most that six decimals change a vector of three components.
const ROUNDING_OF_SIX_DECIMALS: f64 = 0.5e-6 * 1.732_050_807_568_877_2;

/// Nine entries that are rounded to doubles are off by less, together; of them nothing is said.
const SMALLEST_CORRECTION_TOLD: f64 = 4.0 * f64::EPSILON;

/// What four numbers and nine numbers are declared to mean.
#[derive(Clone, Copy)]
pub(crate) struct Declared {
    pub(crate) convention: Convention,
    pub(crate) matrix: MatrixConvention,
}

/// An attitude that was read from text.
pub(crate) struct Attitude {
    form: Form,
    /// How the text of a quaternion told its order.
    parsed: Option<ParsedQuaternion>,
    /// The unit of the angles, or of those inside functions, where it was only assumed.
    unit: Option<AngleUnitAssumed>,
    /// What marks the rows of a matrix in the text.
    pub(crate) row_marks: Option<RowMarks>,
    declared: Convention,
    /// As typed, with the order that was used.
    pub(crate) tagged: TaggedQuaternion,
    pub(crate) rotation: Rotation,
}

impl Attitude {
    /// The attitude that a text holds, or its first problem with what to write instead.
    pub(crate) fn of_text(text: &str, field: Field, declared: Declared) -> Result<Self, Problem> {
        let read = |text: &str| Self::read(text, field, declared);
        let attitude = read(text).map_err(|problem| {
            with_suggestion(problem, text, &|candidate| read(candidate).map(drop))
        })?;
        let is_read = |text: &str| read(text).is_ok();
        Ok(Self {
            unit: attitude
                .unit
                .clone()
                .or_else(|| bare_arguments::unit_assumed(text, &is_read)),
            ..attitude
        })
    }

    fn read(text: &str, field: Field, declared: Declared) -> Result<Self, Problem> {
        let Declared { convention, matrix } = declared;
        let span = Span::of_trimmed(text);
        let in_field = |fault: Fault| fault.in_field(field);
        let (form, rotation, unit) = match parse_rotation(text, field, convention.order)? {
            ParsedRotation::Quaternion(parsed) => {
                return Self::of_quaternion(parsed, convention, span).map_err(in_field);
            }
            ParsedRotation::AxisAngle(parsed) => {
                let read = ReadAxisAngle {
                    axis: coordinates(&parsed.axis),
                    angle_rad: plain(parsed.angle_rad),
                };
                let rotation = Rotation::from_axis_angle_in(
                    parsed.unit.unit(),
                    parsed.axis.into(),
                    parsed.angle_rad,
                );
                (Form::AxisAngle(read), rotation, Some(parsed.unit))
            }
            ParsedRotation::RotationVector(parsed) => {
                let read = ReadRotationVector {
                    vector_rad: coordinates(&parsed.vector_rad),
                };
                let rotation = Rotation::from_rotation_vector_rad(parsed.vector_rad.into());
                let is_long = parsed.vector_rad.amax() > TAU;
                let unit = is_long.then_some(parsed.unit);
                (Form::RotationVector(read), rotation, unit)
            }
            ParsedRotation::HalfAngleVector(parsed) => {
                let read = ReadHalfAngleVector {
                    vector_rad: coordinates(&parsed.vector_rad),
                };
                let rotation = half_angle_exponential(parsed.vector_rad.into());
                let is_long = parsed.vector_rad.amax() > PI;
                let unit = is_long.then_some(parsed.unit);
                (Form::HalfAngleVector(read), rotation, unit)
            }
            ParsedRotation::GibbsVector(numbers) => {
                let vector = coordinates(&numbers);
                let form = Form::GibbsVector(ReadGibbsVector { vector });
                (form, AxisVector::Gibbs(numbers).to_rotation(), None)
            }
            ParsedRotation::ModifiedRodrigues(numbers) => {
                let parameters = coordinates(&numbers);
                let form = Form::ModifiedRodrigues(ReadModifiedRodrigues { parameters });
                let rotation = AxisVector::ModifiedRodrigues(numbers).to_rotation();
                (form, rotation, None)
            }
            ParsedRotation::EulerAngles(parsed) => {
                let read = ReadEulerAngles {
                    sequence: parsed.sequence,
                    angles_rad: parsed.angles_rad.map(plain),
                };
                let rotation =
                    Rotation::from_euler_in(parsed.unit.unit(), parsed.sequence, parsed.angles_rad);
                (Form::EulerAngles(read), rotation, Some(parsed.unit))
            }
            ParsedRotation::Matrix(entries) => {
                let (read, rotation) =
                    of_matrix(entries, matrix, span).map_err(|refusal| Problem {
                        suggestion: refusal.suggestion,
                        ..in_field(refusal.fault)
                    })?;
                (Form::Matrix(read), Ok(rotation), None)
            }
        };
        let rotation = rotation.map_err(|_| in_field(Fault::too_large(span)))?;
        let is_matrix = matches!(form, Form::Matrix(_));
        Ok(Self {
            form,
            parsed: None,
            unit: match unit {
                Some(UnitSource::Assumed(unit)) => Some(unit_assumed(text, unit)),
                _ => None,
            },
            row_marks: is_matrix.then(|| RowMarks::of(text)),
            declared: convention,
            tagged: rotation.to_tagged(convention),
            rotation,
        })
    }

    fn of_quaternion(
        parsed: ParsedQuaternion,
        declared: Convention,
        span: Span,
    ) -> Result<Self, Fault> {
        let tagged = TaggedQuaternion {
            components: parsed.quaternion,
            convention: Convention {
                order: parsed.order,
                ..declared
            },
        };
        let rotation = Rotation::from_tagged(&tagged).map_err(|_| Fault::zero_quaternion(span))?;
        Ok(Self {
            form: Form::Quaternion,
            parsed: Some(parsed),
            unit: None,
            row_marks: None,
            declared,
            tagged,
            rotation,
        })
    }

    pub(crate) fn as_read(&self) -> ReadQuaternion {
        let convention = self.tagged.convention;
        ReadQuaternion {
            form: self.form,
            components: Components::of(&self.tagged.components, convention.order),
            order_source: self
                .parsed
                .as_ref()
                .map_or(OrderSource::Declared, |parsed| parsed.order_source),
            convention,
            norm: self.norm(),
        }
    }

    /// Whether the text is a call whose order is not known here, so that the declared one was used.
    pub(crate) fn is_of_unknown_constructor(&self) -> bool {
        let parsed = self.parsed.as_ref();
        parsed.is_some_and(|parsed| parsed.unknown_constructor.is_some())
    }

    /// The norm as typed, where a double can hold it.
    fn norm(&self) -> Option<f64> {
        let norm = self.tagged.norm();
        norm.is_finite().then_some(norm)
    }

    pub(crate) fn column(&self, convention: Convention, vector: Vector3<f64>) -> Column {
        let quaternion = self.tagged.to_convention(convention);
        let unit = self.rotation.to_tagged(convention);
        let direction = convention.operator();
        let shown =
            |tagged: &TaggedQuaternion| Components::of(&tagged.components, convention.order);
        let matrix = self.rotation.matrix(direction);
        Column {
            convention,
            quaternion: shown(&quaternion),
            unit: shown(&unit),
            conjugate: shown(&quaternion.conjugate()),
            inverse: quaternion.inverse().as_ref().map(shown),
            matrix: rows3(&matrix),
            inverse_matrix: rows3(&matrix.transpose()),
            image: self
                .rotation
                .rotate_within_range(vector, direction)
                .as_ref()
                .map(coordinates),
            left_product_matrix: rows4(&quaternion.left_product_matrix()),
            right_product_matrix: rows4(&quaternion.right_product_matrix()),
            rules: rules(convention),
        }
    }

    pub(crate) fn paired(&self, convention: MatrixConvention) -> PairedMatrix {
        PairedMatrix {
            convention,
            rows: rows3(&self.rotation.to_tagged_matrix(convention).entries),
            form: self.declared.cosine_matrix(convention),
        }
    }

    pub(crate) fn notes(&self, field: Field) -> Vec<Note> {
        let mut facts = Vec::new();
        facts.extend(self.order_fact());
        facts.extend(self.unit.clone().map(Fact::AngleUnitAssumed));
        match self.row_marks {
            Some(RowMarks::None) => facts.extend(self.rows_fact()),
            Some(RowMarks::AxisNames) => facts.extend(self.axes_fact()),
            Some(RowMarks::Lines | RowMarks::Brackets) | None => {}
        }
        if let Form::Matrix(matrix) = self.form
            && matrix.correction > SMALLEST_CORRECTION_TOLD
        {
            facts.push(Fact::NearestRotation(UsedNearestRotation {
                orthogonality_error: matrix.orthogonality_error,
                correction: matrix.correction,
            }));
        }
        let norm = self.norm();
        let deviation = norm.map(|norm| norm - 1.0);
        if deviation.is_none_or(|deviation| deviation.abs() > UNIT_NORM_TOLERANCE) {
            facts.push(Fact::Normalised(Normalised { norm, deviation }));
        }
        if self.has_negative_scalar() {
            facts.push(Fact::NegativeScalar);
        }
        facts.extend(self.extreme_fact());
        facts.into_iter().map(|fact| Note { field, fact }).collect()
    }

    /// Of angles more than half a turn has one; where it is only rounding that is half a turn.
    fn has_negative_scalar(&self) -> bool {
        let least = match self.form {
            Form::Quaternion => 0.0,
            _ => -HALF_TURN_SCALAR,
        };
        self.tagged.components.w < least
    }

    /// That the turn is none or half a turn, or nearly.
    fn extreme_fact(&self) -> Option<Fact> {
        if self.rotation.axis().is_none() {
            return Some(Fact::NoTurn);
        }
        if is_half_turn(&self.rotation) {
            return Some(Fact::HalfTurn);
        }
        let unit = self.rotation.to_tagged(self.declared).components;
        let scalar = unit.w.abs();
        let angle_rad = self.rotation.angle_rad();
        if angle_rad < NEARLY_RAD {
            let error = ROUNDING_OF_SIX_DECIMALS / unit.vector().norm();
            return Some(Fact::NearlyNoTurn(NearlyNoTurn {
                angle_rad,
                angle_deg: angle_rad.to_degrees(),
                axis_uncertain_by_deg: (error < 1.0).then(|| libm::asin(error).to_degrees()),
            }));
        }
        // The difference from π by the scalar, which keeps its digits.
        let short_by_rad = 2.0 * libm::asin(scalar);
        (short_by_rad < NEARLY_RAD).then(|| {
            Fact::NearlyHalfTurn(NearlyHalfTurn {
                short_by_rad,
                short_by_deg: short_by_rad.to_degrees(),
            })
        })
    }

    /// That rows were assumed, where columns would be another rotation.
    pub(crate) fn rows_fact(&self) -> Option<Fact> {
        self.transposed_differs_by_deg()
            .map(|columns_differ_by_deg| {
                Fact::RowsAssumed(RowsAssumed {
                    columns_differ_by_deg,
                })
            })
    }

    /// That named axes were taken for columns, where rows would be another rotation.
    fn axes_fact(&self) -> Option<Fact> {
        self.transposed_differs_by_deg()
            .map(|rows_differ_by_deg| Fact::AxesAsColumns(AxesAsColumns { rows_differ_by_deg }))
    }

    /// How far away the opposite turn is, in degrees; `None` where it is the same.
    fn transposed_differs_by_deg(&self) -> Option<f64> {
        let differs_by = self.rotation.angle_to_rad(&self.rotation.inverse());
        (differs_by > UNIT_NORM_TOLERANCE).then(|| plain(differs_by.to_degrees()))
    }

    fn order_fact(&self) -> Option<Fact> {
        let parsed = self.parsed.as_ref()?;
        let (order, source) = (parsed.order, parsed.order_source);
        if source != OrderSource::Declared {
            let differs = order != self.declared.order;
            return differs.then_some(Fact::OrderFromText(OrderFromText { source, order }));
        }
        if let Some(name) = parsed.unknown_constructor.clone() {
            return Some(Fact::UnknownConstructor(UnknownConstructor { name, order }));
        }
        let differs_by = self.rotation.angle_to_rad(&self.read_in_other_order()?);
        Some(if differs_by <= UNIT_NORM_TOLERANCE {
            Fact::OrderInvisible
        } else {
            Fact::OrderAssumed(OrderAssumed {
                order,
                other_order_differs_by_deg: plain(differs_by.to_degrees()),
            })
        })
    }

    /// The attitude if the same four numbers stood in the other order.
    fn read_in_other_order(&self) -> Option<Rotation> {
        let Quaternion { coords } = self.tagged.components;
        let (w, x, y, z) = (coords.w, coords.x, coords.y, coords.z);
        let moved = match self.tagged.convention.order {
            ComponentOrder::ScalarFirst => Quaternion::new(z, w, x, y),
            ComponentOrder::ScalarLast => Quaternion::new(x, y, z, w),
        };
        Rotation::from_tagged(&TaggedQuaternion {
            components: moved,
            ..self.tagged
        })
        .ok()
    }
}

/// The unit that was assumed, and the texts that say it.
fn unit_assumed(text: &str, unit: AngleUnit) -> AngleUnitAssumed {
    let written = |unit: AngleUnit, word: &str| {
        let text = text.trim_end();
        let says_so = |candidate: &String| {
            let read = parse_rotation(candidate, Field::Quaternion, ComponentOrder::ScalarFirst);
            read.is_ok_and(|read| read.unit() == Some(UnitSource::Written(unit)))
        };
        // Once for all at the end, or beside the first number, as in `45 about z`.
        let mut candidates = vec![format!("{text} {word}")];
        candidates.extend(
            text.split_once(char::is_whitespace)
                .map(|(first, rest)| format!("{first} {word} {rest}")),
        );
        candidates.into_iter().find(says_so)
    };
    AngleUnitAssumed {
        unit,
        in_degrees: written(AngleUnit::Degrees, "deg"),
        in_radians: written(AngleUnit::Radians, "rad"),
    }
}
