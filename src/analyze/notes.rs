//! What a careful reader should know of an attitude that was read.

use crate::analyze::attitude::Attitude;
use crate::analyze::describe::{HALF_TURN_SCALAR, is_half_turn};
use crate::analyze::plain_numbers::plain;
use crate::contract::{
    AxesAsColumns, Fact, FarFromUnit, Form, NearlyHalfTurn, NearlyNoTurn, Normalised, Note,
    OrderAssumed, OrderFromText, RotationAssumed, RowsAssumed, UnknownConstructor,
    UsedNearestRotation,
};
use crate::convention::Convention;
use crate::convention::order::OrderSource;
use crate::problem::Field;
use crate::rotation::Rotation;
use crate::rotation::quaternion::{TaggedQuaternion, UNIT_NORM_TOLERANCE};
use crate::text::RowMarks;

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

impl Attitude {
    pub(crate) fn notes(&self, field: Field) -> Vec<Note> {
        let mut facts = Vec::new();
        let norm = self.norm();
        let deviation = norm.map(|norm| norm - 1.0);
        let is_far = self.is_far_from_unit();
        if is_far {
            facts.push(Fact::FarFromUnit(FarFromUnit { norm, deviation }));
        }
        let parsed = self.parsed.as_ref().filter(|parsed| !parsed.is_announced);
        let label = parsed.and_then(|parsed| parsed.unexplained_label.clone());
        facts.extend(label.map(|label| Fact::RotationAssumed(RotationAssumed { label })));
        facts.extend(self.order_fact());
        facts.extend(self.unit.clone().map(Fact::AngleUnitAssumed));
        match self.row_marks {
            Some(RowMarks::None) => facts.extend(self.rows_fact()),
            Some(RowMarks::AxisNames) => facts.extend(self.axes_fact()),
            Some(RowMarks::Columns) if cfg!(feature = "whole") => facts.extend(self.columns_fact()),
            Some(RowMarks::Lines | RowMarks::Brackets | RowMarks::Columns) | None => {}
        }
        if let Form::Matrix(matrix) = self.form
            && matrix.correction > SMALLEST_CORRECTION_TOLD
        {
            facts.push(Fact::NearestRotation(UsedNearestRotation {
                orthogonality_error: matrix.orthogonality_error,
                correction: matrix.correction,
            }));
        }
        let is_off = |deviation: f64| deviation.abs() > UNIT_NORM_TOLERANCE;
        if !is_far && deviation.is_none_or(is_off) {
            facts.push(Fact::Normalised(Normalised { norm, deviation }));
        }
        if self.has_negative_scalar() {
            facts.push(Fact::NegativeScalar);
        }
        facts.extend(self.extreme_fact());
        facts.extend_from_slice(&self.told);
        let mut notes = Vec::new();
        for fact in facts {
            let asks = match fact {
                Fact::FarFromUnit(_) => true,
                #[cfg(feature = "whole")]
                Fact::DescriptionsDisagree(_) => true,
                _ => false,
            };
            let note = Note::new(field, fact);
            notes.push(if asks {
                note.suggesting(|| self.meanings.to_vec())
            } else {
                note
            });
        }
        notes
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

    /// That columns were told, where rows would be another rotation.
    fn columns_fact(&self) -> Option<Fact> {
        self.transposed_differs_by_deg()
            .map(|rows_differ_by_deg| Fact::ColumnsFromText(AxesAsColumns { rows_differ_by_deg }))
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
    pub(crate) fn read_in_other_order(&self) -> Option<Rotation> {
        let convention = self.tagged.convention;
        let other = Convention {
            order: convention.order.other(),
            ..convention
        };
        let moved = TaggedQuaternion::from_array(self.tagged.to_array(), other);
        Rotation::from_tagged(&moved).ok()
    }
}
