//! One golden case, and what the golden tests share.

mod matrices;
mod motion;
mod quaternions;

use crate::support::assert_close;
use quatlas::nalgebra::Matrix3;
use quatlas::{
    ComponentOrder, Convention, Direction, Function, Handedness, Perturbation, Rotation,
    TaggedQuaternion,
};
use serde_json::Value;

/// A case, with its own tolerance.
pub(crate) struct Case {
    pub(crate) id: String,
    pub(crate) value: Value,
    pub(crate) tolerance: f64,
}

impl Case {
    pub(crate) fn all() -> Vec<Self> {
        let file: Value =
            serde_json::from_str(include_str!("../../vectors/golden.json")).expect("JSON");
        let cases = file["cases"].as_array().expect("a list of cases");
        cases
            .iter()
            .map(|value| Self {
                id: value["id"].as_str().expect("an id").to_owned(),
                value: value.clone(),
                tolerance: value["tol"].as_f64().expect("a tolerance"),
            })
            .collect()
    }

    #[track_caller]
    pub(crate) fn find(id: &str) -> Self {
        Self::all()
            .into_iter()
            .find(|case| case.id == id)
            .unwrap_or_else(|| panic!("{id} is not in golden.json"))
    }

    /// The numbers of an input or output, a matrix row by row.
    #[track_caller]
    pub(crate) fn numbers(&self, part: &str, name: &str) -> Vec<f64> {
        fn flatten(value: &Value) -> Vec<f64> {
            match value {
                Value::Array(members) => members.iter().flat_map(flatten).collect(),
                number => vec![number.as_f64().expect("a number")],
            }
        }
        flatten(&self.value[part][name])
    }

    #[track_caller]
    pub(crate) fn input<const COUNT: usize>(&self, name: &str) -> [f64; COUNT] {
        self.numbers("input", name)
            .try_into()
            .expect("as many numbers")
    }

    /// A matrix among the inputs or outputs.
    #[track_caller]
    pub(crate) fn matrix(&self, part: &str, name: &str) -> Matrix3<f64> {
        Matrix3::from_row_slice(&self.numbers(part, name))
    }

    #[track_caller]
    pub(crate) fn number(&self, name: &str) -> f64 {
        let [number] = self.input(name);
        number
    }

    #[track_caller]
    pub(crate) fn check(&self, name: &str, got: &[f64]) {
        let expected = self.numbers("output", name);
        assert_close(
            &format!("{} {name}", self.id),
            got,
            &expected,
            self.tolerance,
        );
    }

    pub(crate) fn convention(&self) -> Convention {
        let axis = |name: &str| {
            self.value["convention"][name]
                .as_str()
                .expect("a name")
                .to_owned()
        };
        Convention {
            order: ComponentOrder::ScalarFirst,
            handedness: match axis("handedness").as_str() {
                "Right" => Handedness::Right,
                _ => Handedness::Left,
            },
            function: match axis("function").as_str() {
                "Passive" => Function::Passive,
                _ => Function::Active,
            },
            direction: match axis("direction").as_str() {
                "B2W" => Direction::BodyToWorld,
                _ => Direction::WorldToBody,
            },
            perturbation: Perturbation::Local,
        }
    }
}

pub(crate) fn exponential(vector: [f64; 3]) -> Rotation {
    Rotation::from_rotation_vector_rad(vector).expect("finite")
}

pub(crate) fn hamilton([w, x, y, z]: [f64; 4]) -> TaggedQuaternion {
    TaggedQuaternion::new(w, x, y, z, Convention::HAMILTON)
}

pub(crate) fn rotation(array: [f64; 4]) -> Rotation {
    Rotation::from_tagged(&hamilton(array)).expect("not zero")
}
