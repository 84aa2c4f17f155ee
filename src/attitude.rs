//! A text to an attitude, and the attitude to numbers in a convention.

use crate::angle::UnitSource;
use crate::convention::{ComponentOrder, ComponentSign, Convention};
use crate::euler_sequence::EulerSequence;
use crate::kinematics::RateAxes;
use crate::matrix_rows::RowMarks;
use crate::messages::Fault;
use crate::nearest_rotation::NoNearestRotation;
use crate::parse::{ParsedQuaternion, ParsedRotation, parse_rotation};
use crate::perturbation::Side;
use crate::problem::{Field, Problem, Span};
use crate::quaternion::{TaggedQuaternion, UNIT_NORM_TOLERANCE};
use crate::report::{
    AngleUnitAssumed, Column, Components, Euler, Fact, Form, Normalised, Note, OrderAssumed,
    OrderFromText, OrderSource, ReadAxisAngle, ReadEulerAngles, ReadGimbalLock, ReadMatrix,
    ReadQuaternion, ReadRotationVector, RowsAssumed, Rules, Turn, UnknownConstructor,
    UsedNearestRotation, coordinates, plain, rows3, rows4,
};
use crate::rotation::Rotation;
use crate::rotation_matrix::{MatrixConvention, TaggedMatrix};
use crate::scaling::{UNIT_ROUNDOFF, times_power_of_two, working_scale};
use nalgebra::{Matrix3, Quaternion, Vector3};
use std::f64::consts::TAU;

/// A scalar part this small is a rounded cosine of 90°: the turn is half a turn.
const HALF_TURN_SCALAR: f64 = UNIT_ROUNDOFF;

/// A matrix this far from the nearest rotation (Frobenius norm) is not one with rounded entries: two
/// decimals are off by 0.015 at most.
const LARGEST_CORRECTION: f64 = 0.1;

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
    /// How the unit of the angles was told, where there are any.
    unit: Option<UnitSource>,
    /// What marks the rows of a matrix in the text.
    pub(crate) row_marks: Option<RowMarks>,
    declared: Convention,
    /// As typed, with the order that was used.
    pub(crate) tagged: TaggedQuaternion,
    pub(crate) rotation: Rotation,
}

impl Attitude {
    pub(crate) fn of_text(text: &str, field: Field, declared: Declared) -> Result<Self, Problem> {
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
                let rotation = Rotation::from_axis_angle(parsed.axis.into(), parsed.angle_rad);
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
            ParsedRotation::EulerAngles(parsed) => {
                let read = ReadEulerAngles {
                    sequence: parsed.sequence,
                    angles_rad: parsed.angles_rad.map(plain),
                };
                let rotation = Rotation::from_euler_rad(parsed.sequence, parsed.angles_rad);
                (Form::EulerAngles(read), rotation, Some(parsed.unit))
            }
            ParsedRotation::Matrix(entries) => {
                let (read, rotation) = of_matrix(entries, matrix, span).map_err(in_field)?;
                (Form::Matrix(read), Ok(rotation), None)
            }
        };
        let rotation = rotation.map_err(|_| in_field(Fault::too_large(span)))?;
        let is_matrix = matches!(form, Form::Matrix(_));
        Ok(Self {
            form,
            parsed: None,
            unit,
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
            left_product_matrix: rows4(&unit.left_product_matrix()),
            right_product_matrix: rows4(&unit.right_product_matrix()),
        }
    }

    pub(crate) fn notes(&self, field: Field) -> Vec<Note> {
        let mut facts = Vec::new();
        facts.extend(self.order_fact());
        if let Some(UnitSource::Assumed(unit)) = self.unit {
            facts.push(Fact::AngleUnitAssumed(AngleUnitAssumed { unit }));
        }
        if self.row_marks == Some(RowMarks::None) {
            facts.extend(self.rows_fact());
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
        if self.parsed.is_some() && self.tagged.components.w < 0.0 {
            facts.push(Fact::NegativeScalar);
        }
        if self.rotation.axis().is_none() {
            facts.push(Fact::NoTurn);
        } else if self.rotation.to_tagged(self.declared).components.w.abs() <= HALF_TURN_SCALAR {
            facts.push(Fact::HalfTurn);
        }
        facts.into_iter().map(|fact| Note { field, fact }).collect()
    }

    /// That rows were assumed, where columns would be another rotation.
    pub(crate) fn rows_fact(&self) -> Option<Fact> {
        let columns = self.rotation.inverse();
        let differs_by = self.rotation.angle_to_rad(&columns);
        (differs_by > UNIT_NORM_TOLERANCE).then(|| {
            Fact::RowsAssumed(RowsAssumed {
                columns_differ_by_deg: plain(differs_by.to_degrees()),
            })
        })
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

fn of_matrix(
    entries: Matrix3<f64>,
    convention: MatrixConvention,
    span: Span,
) -> Result<(ReadMatrix, Rotation), Fault> {
    let typed = TaggedMatrix {
        entries,
        convention,
    };
    let is_near = |entries| {
        Rotation::nearest_to_matrix(&TaggedMatrix {
            entries,
            convention,
        })
        .is_ok_and(|nearest| nearest.correction <= LARGEST_CORRECTION)
    };
    // Divided by a power of two, so that no length overflows or vanishes.
    let exponent = working_scale(entries.as_slice());
    let scaled = entries.map(|entry| times_power_of_two(entry, exponent));
    let scaled_lengths = [0, 1, 2].map(|column| scaled.column(column).norm());
    let lengths = scaled_lengths.map(|length| times_power_of_two(length, -exponent));
    let nearest = Rotation::nearest_to_matrix(&typed).map_err(|reason| match reason {
        NoNearestRotation::Reflection if is_near(-entries) => Fault::reflection(span),
        NoNearestRotation::Reflection => Fault::not_a_rotation(span, lengths),
        NoNearestRotation::NotFinite => Fault::too_large(span),
        NoNearestRotation::Singular if entries.amax() == 0.0 => Fault::zero_matrix(span),
        NoNearestRotation::Singular => Fault::singular_matrix(span),
    })?;
    if nearest.correction > LARGEST_CORRECTION {
        let scale = scaled_lengths.iter().sum::<f64>() / 3.0;
        return Err(if is_near(scaled / scale) {
            Fault::scaled_rotation(span, times_power_of_two(scale, -exponent))
        } else {
            Fault::not_a_rotation(span, lengths)
        });
    }
    let read = ReadMatrix {
        rows: rows3(&entries),
        convention,
        orthogonality_error: typed.orthogonality_error(),
        correction: nearest.correction,
    };
    Ok((read, nearest.rotation))
}

pub(crate) fn rules(convention: Convention) -> Rules {
    let side = |is_left| if is_left { Side::Left } else { Side::Right };
    Rules {
        is_canonical: convention.component_sign() == ComponentSign::Canonical,
        operator: convention.operator(),
        labelled_first: side(convention.first_label_is_left()),
        chain_first: side(convention.first_in_chain_is_left()),
        increment: convention.increment_side(),
        body_rate: convention.rate_side(RateAxes::Body),
    }
}

pub(crate) fn euler(rotation: &Rotation, sequence: EulerSequence) -> Euler {
    let found = rotation.euler(sequence);
    let angles_rad = found
        .gimbal_lock
        .map_or(found.angles_rad, |lock| lock.canonical_rad);
    Euler {
        sequence,
        angles_rad: angles_rad.map(plain),
        angles_deg: angles_rad.map(|angle| plain(angle.to_degrees())),
        gimbal_lock: found.gimbal_lock.map(|lock| ReadGimbalLock {
            survivor: lock.survivor,
            survivor_deg: plain(lock.survivor_rad.to_degrees()),
            lost: sequence.lost_at_lock(),
            distance_deg: plain(lock.distance_rad.to_degrees()),
        }),
    }
}

pub(crate) fn turn(rotation: &Rotation) -> Turn {
    let angle_rad = rotation.angle_rad();
    Turn {
        gibbs_vector: rotation.gibbs_vector().as_ref().map(coordinates),
        modified_rodrigues_parameters: coordinates(&rotation.modified_rodrigues_parameters()),
        angle_rad: plain(angle_rad),
        angle_deg: plain(angle_rad.to_degrees()),
        axis: rotation.axis().as_ref().map(coordinates),
        rotation_vector_rad: coordinates(&rotation.rotation_vector_rad()),
    }
}
