//! A text to an attitude, and the attitude to numbers in a convention.

use crate::analyze::describe::rules;
use crate::analyze::matrix::of_matrix;
use crate::analyze::norm::{check_norm, is_far_from_unit};
use crate::analyze::plain_numbers::{coordinates, plain, plain3, rows3, rows4};
use crate::contract::{
    AngleUnitAssumed, Column, Components, DirectionFromText, Fact, Form, PairedMatrix,
    ReadAxisAngle, ReadEulerAngles, ReadGibbsVector, ReadHalfAngleVector, ReadModifiedRodrigues,
    ReadQuaternion, ReadRotationVector,
};
use crate::convention::Convention;
use crate::convention::angle::{AngleUnit, UnitSource};
use crate::convention::matrix::MatrixConvention;
use crate::convention::order::OrderSource;
use crate::library::VectorLayout;
use crate::problem::Span;
use crate::problem::fault::Fault;
use crate::problem::suggestion::{Suggestions, suggestions};
use crate::rotation::Rotation;
use crate::rotation::quaternion::TaggedQuaternion;
use crate::rotation::rotation_vector::{AxisVector, half_angle_exponential};
use crate::text::mend::meanings;
use crate::text::mend::unit::{self, UnitTexts};
use crate::text::{
    ParsedQuaternion, ParsedRotation, RotationText, RowMarks, parse_rotation, read_rotation,
};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};

/// What four numbers and nine numbers are declared to mean.
#[derive(Clone, Copy)]
pub(crate) struct Declared {
    pub(crate) convention: Convention,
    pub(crate) matrix: MatrixConvention,
    /// The library that printed the text, where one is declared.
    #[cfg_attr(
        not(feature = "whole"),
        expect(dead_code, reason = "only records of the whole core ask for it")
    )]
    pub(crate) library: Option<DeclaredLibrary>,
}

/// What a declared library says of the text that it printed.
#[derive(Clone, Copy)]
#[cfg_attr(
    not(feature = "whole"),
    expect(dead_code, reason = "only records of the whole core ask for it")
)]
pub(crate) struct DeclaredLibrary {
    pub(crate) id: &'static str,
    /// Which vectors its matrices multiply.
    pub(crate) vectors: VectorLayout,
}

impl Declared {
    /// What is declared where no library is.
    pub(crate) fn plain(convention: Convention, matrix: MatrixConvention) -> Self {
        Self {
            convention,
            matrix,
            library: None,
        }
    }
}

/// An attitude that was read from text.
#[derive(Clone)]
pub(crate) struct Attitude {
    pub(crate) form: Form,
    /// How the text of a quaternion told its order.
    pub(crate) parsed: Option<ParsedQuaternion>,
    /// The unit of the angles, or of those inside functions, where it was only assumed.
    pub(crate) unit: Option<AngleUnitAssumed>,
    /// What marks the rows of a matrix in the text.
    pub(crate) row_marks: Option<RowMarks>,
    /// Texts that say what numbers are that a norm far from 1 leaves open.
    pub(crate) meanings: Suggestions,
    pub(crate) declared: Convention,
    /// As typed, with the order that was used.
    pub(crate) tagged: TaggedQuaternion,
    pub(crate) rotation: Rotation,
    /// What else the text holds.
    pub(crate) told: Vec<Fact>,
}

impl Attitude {
    /// The attitude of a text that is a rotation and nothing else.
    pub(crate) fn plain(text: &str, declared: Declared) -> Result<Self, Fault> {
        let parsed = read_rotation(text, declared.convention.order)?;
        Self::of_parsed(parsed, text, declared)
    }

    /// The attitude of a rotation that was found in a text.
    pub(crate) fn of_parsed(
        RotationText {
            rotation: parsed,
            row_marks,
            told,
        }: RotationText<'_>,
        text: &str,
        declared: Declared,
    ) -> Result<Self, Fault> {
        let span = Span::of_trimmed(text);
        let (convention, matrix, told_convention) =
            told.directed(&parsed, declared.convention, declared.matrix);
        told.check(&parsed, convention, matrix)?;
        let mut told = Vec::new();
        if let Some(other) = told_convention {
            told.push(Fact::DirectionFromText(DirectionFromText {
                direction: other.direction,
                handedness: other.handedness,
            }));
        }
        let (form, rotation, unit) = match parsed {
            ParsedRotation::Quaternion(parsed) => {
                let attitude = Self::of_quaternion(parsed, convention, span)?;
                return Ok(Self { told, ..attitude });
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
                    angles_rad: plain3(parsed.angles_rad),
                };
                let rotation =
                    Rotation::from_euler_in(parsed.unit.unit(), parsed.sequence, parsed.angles_rad);
                (Form::EulerAngles(read), rotation, Some(parsed.unit))
            }
            ParsedRotation::Matrix(entries) => {
                let (read, rotation) = of_matrix(entries, matrix, span)?;
                (Form::Matrix(read), Ok(rotation), None)
            }
        };
        let rotation = rotation.map_err(|_| Fault::too_large(span))?;
        let is_matrix = matches!(form, Form::Matrix(_));
        Ok(Self {
            form,
            parsed: None,
            unit: match unit {
                Some(UnitSource::Assumed(unit)) => {
                    let unit_of = |text: &str| {
                        let read = parse_rotation(text, convention.order);
                        read.ok().and_then(|read| read.unit())
                    };
                    Some(unit_assumed(unit, unit::for_all(text, &unit_of)))
                }
                _ => None,
            },
            row_marks: is_matrix.then_some(row_marks),
            meanings: Suggestions::default(),
            declared: convention,
            tagged: rotation.to_tagged(convention),
            rotation,
            told,
        })
    }

    /// The attitude of a rotation that is computed, as a quaternion of norm 1.
    #[cfg(feature = "whole")]
    pub(crate) fn of_rotation(rotation: Rotation, declared: Convention) -> Self {
        Self {
            form: Form::Quaternion,
            parsed: None,
            unit: None,
            row_marks: None,
            meanings: Suggestions::default(),
            declared,
            tagged: rotation.to_tagged(declared),
            rotation,
            told: Vec::new(),
        }
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
        check_norm(&parsed, tagged.norm(), span)?;
        let rotation = Rotation::from_tagged(&tagged).map_err(|_| Fault::zero_quaternion(span))?;
        Ok(Self {
            form: Form::Quaternion,
            parsed: Some(parsed),
            unit: None,
            row_marks: None,
            meanings: Suggestions::default(),
            declared,
            tagged,
            rotation,
            told: Vec::new(),
        })
    }

    /// With the texts that say what the numbers are, where their norm leaves it open.
    pub(crate) fn with_meanings(self, text: &str) -> Self {
        let read = |text: &str| parse_rotation(text, self.declared.order).ok();
        let meanings = match &self.parsed {
            Some(parsed) if self.is_far_from_unit() => {
                suggestions(|| meanings(text, parsed, &read))
            }
            _ => return self,
        };
        Self { meanings, ..self }
    }

    /// With what else the text holds.
    #[cfg(feature = "whole")]
    pub(crate) fn telling(self, more: impl IntoIterator<Item = Fact>) -> Self {
        let mut told = self.told;
        told.extend(more);
        Self { told, ..self }
    }

    /// Whether the norm leaves it open what the numbers are, which a build without suggestions does not
    /// read.
    pub(crate) fn is_far_from_unit(&self) -> bool {
        let parsed = self.parsed.as_ref().filter(|_| cfg!(feature = "whole"));
        parsed.is_some_and(|parsed| is_far_from_unit(parsed, self.tagged.norm()))
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
    pub(crate) fn norm(&self) -> Option<f64> {
        let norm = self.tagged.norm();
        norm.is_finite().then_some(norm)
    }

    pub(crate) fn column(&self, convention: Convention, vector: Vector3<f64>) -> Column {
        column(&self.tagged, &self.rotation, convention, vector)
    }

    pub(crate) fn paired(&self, convention: MatrixConvention) -> PairedMatrix {
        PairedMatrix {
            convention,
            rows: rows3(&self.rotation.to_tagged_matrix(convention).entries),
            form: self.declared.cosine_matrix(convention),
        }
    }
}

/// One attitude in one convention, by a quaternion of it of any norm.
fn column(
    tagged: &TaggedQuaternion,
    rotation: &Rotation,
    convention: Convention,
    vector: Vector3<f64>,
) -> Column {
    let quaternion = tagged.to_convention(convention);
    let unit = rotation.to_tagged(convention);
    let direction = convention.operator();
    let shown = |tagged: &TaggedQuaternion| Components::of(&tagged.components, convention.order);
    let matrix = rotation.matrix(direction);
    Column {
        convention,
        quaternion: shown(&quaternion),
        unit: shown(&unit),
        conjugate: shown(&quaternion.conjugate()),
        inverse: quaternion.inverse().as_ref().map(shown),
        matrix: rows3(&matrix),
        inverse_matrix: rows3(&matrix.transpose()),
        image: rotation
            .rotate_within_range(vector, direction)
            .as_ref()
            .map(coordinates),
        left_product_matrix: rows4(&quaternion.left_product_matrix()),
        right_product_matrix: rows4(&quaternion.right_product_matrix()),
        rules: rules(convention),
        named: convention.named(),
    }
}

/// The same where nothing is asked of a vector.
#[cfg(feature = "whole")]
pub(crate) fn column_alone(
    tagged: &TaggedQuaternion,
    rotation: &Rotation,
    convention: Convention,
) -> Column {
    let mut column = column(tagged, rotation, convention, Vector3::zeros());
    column.image = None;
    column
}

/// The column of an attitude that was computed, of norm 1.
#[cfg(feature = "whole")]
pub(crate) fn computed_column(rotation: &Rotation, convention: Convention) -> Column {
    column_alone(&rotation.to_tagged(convention), rotation, convention)
}

/// That this unit was assumed, with the texts that say it.
pub(crate) fn unit_assumed(unit: AngleUnit, texts: UnitTexts) -> AngleUnitAssumed {
    AngleUnitAssumed {
        unit,
        in_degrees: texts.in_degrees,
        in_radians: texts.in_radians,
    }
}
