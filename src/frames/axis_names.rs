//! The names of axes in texts: `y x -z`, `NED to ENU`, `ROS to Unity`.

use crate::convention::euler_sequence::Axis;
use crate::frames::axis_mapping::{AxisMapping, Sense, SignedAxis};
use crate::problem::{QUOTED_CHARACTERS, shorten};
use std::fmt;
use std::str::FromStr;

/// A text that names no axes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownAxes {
    /// What is wrong with it.
    pub message: String,
}

impl fmt::Display for UnknownAxes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for UnknownAxes {}

/// Axes that go by the name of a library: where x, y and z point.
const NAMED_AXES: [(&str, &str); 8] = [
    ("opencv", "RDF"),
    ("opengl", "RUB"),
    ("godot", "RUB"),
    ("ros", "FLU"),
    ("px4", "FRD"),
    ("aerospace", "FRD"),
    ("unity", "RUF"),
    ("unreal", "FRU"),
];

/// Pairs of opposite directions; a system has one of each of three pairs.
const OPPOSITES: [(char, char); 5] = [('F', 'B'), ('R', 'L'), ('U', 'D'), ('N', 'S'), ('E', 'W')];

impl FromStr for AxisMapping {
    type Err = UnknownAxes;

    /// From the new axes in terms of the old (`y x -z`), or from two systems by where their axes
    /// point (`NED to ENU`, `FRD -> FLU`, `ROS to Unity`).
    ///
    /// The letters are forward, back, left, right, up, down, and north, south, east, west.
    ///
    /// ```
    /// use quatlas::{AxesHand, AxisMapping};
    /// let ros_to_unity: AxisMapping = "ROS to Unity".parse()?;
    /// assert_eq!(ros_to_unity, "-y z x".parse()?);
    /// assert_eq!(ros_to_unity.hand(), AxesHand::Changed);
    /// # Ok::<(), quatlas::UnknownAxes>(())
    /// ```
    fn from_str(text: &str) -> Result<Self, UnknownAxes> {
        let lower = text.trim().to_ascii_lowercase().replace('\u{2212}', "-");
        if matches!(lower.as_str(), "" | "none" | "same") {
            return Ok(Self::NONE);
        }
        let halves = ["->", "\u{2192}", " to "]
            .iter()
            .find_map(|arrow| lower.split_once(arrow));
        match halves {
            Some((from, to)) => between(&system(from)?, &system(to)?),
            None => signed_permutation(&lower),
        }
    }
}

impl fmt::Display for AxisMapping {
    /// `y x -z`, which reads back.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, SignedAxis { axis, sense }) in self.axes.iter().enumerate() {
            f.write_str(if place > 0 { " " } else { "" })?;
            f.write_str(if *sense == Sense::Against { "-" } else { "" })?;
            f.write_str(["x", "y", "z"][axis.index()])?;
        }
        Ok(())
    }
}

/// Where the three axes of a system point, by letters.
fn system(name: &str) -> Result<[char; 3], UnknownAxes> {
    let unknown = || UnknownAxes {
        message: format!(
            "{} is not a known system of axes",
            shorten(name.trim(), QUOTED_CHARACTERS)
        ),
    };
    let trimmed = name.trim().to_ascii_lowercase();
    let named = NAMED_AXES.iter().find(|(known, _)| *known == trimmed);
    let letters = named.map_or(trimmed.to_ascii_uppercase(), |(_, letters)| {
        (*letters).to_owned()
    });
    let mut characters = letters.chars();
    let (Some(x), Some(y), Some(z), None) = (
        characters.next(),
        characters.next(),
        characters.next(),
        characters.next(),
    ) else {
        return Err(unknown());
    };
    // A system of the world has north and east, one of a body has forward and right.
    for whole in [[0, 1, 2], [2, 3, 4]] {
        let mut is_whole = true;
        for place in whole {
            let (one, other) = OPPOSITES[place];
            is_whole &= letters.contains([one, other]);
        }
        if is_whole {
            return Ok([x, y, z]);
        }
    }
    Err(unknown())
}

fn between(from: &[char; 3], to: &[char; 3]) -> Result<AxisMapping, UnknownAxes> {
    let opposite = |letter| {
        OPPOSITES.iter().find_map(|&(one, other)| match letter {
            letter if letter == one => Some(other),
            letter if letter == other => Some(one),
            _ => None,
        })
    };
    let axes = [Axis::X, Axis::Y, Axis::Z];
    let source = |letter: char| {
        axes.into_iter().zip(from).find_map(|(axis, &old)| {
            let sense = if old == letter {
                Sense::Along
            } else if opposite(old) == Some(letter) {
                Sense::Against
            } else {
                return None;
            };
            Some(SignedAxis { axis, sense })
        })
    };
    let [Some(x), Some(y), Some(z)] = [source(to[0]), source(to[1]), source(to[2])] else {
        return Err(UnknownAxes {
            message: "one system is of a body and the other of the world".to_owned(),
        });
    };
    Ok(AxisMapping { axes: [x, y, z] })
}

fn signed_permutation(text: &str) -> Result<AxisMapping, UnknownAxes> {
    let unknown = || UnknownAxes {
        message: "this is not a mapping of axes".to_owned(),
    };
    let compact: String = text
        .chars()
        .filter(|character| !character.is_whitespace() && !",;()[]+".contains(*character))
        .collect();
    let mut axes = Vec::new();
    let mut sense = Sense::Along;
    for character in compact.chars() {
        let axis = match character {
            '-' if sense == Sense::Along => {
                sense = Sense::Against;
                continue;
            }
            'x' => Axis::X,
            'y' => Axis::Y,
            'z' => Axis::Z,
            _ => return Err(unknown()),
        };
        axes.push(SignedAxis { axis, sense });
        sense = Sense::Along;
    }
    let (&[x, y, z], Sense::Along) = (&axes[..], sense) else {
        return Err(unknown());
    };
    let mapping = AxisMapping { axes: [x, y, z] };
    if !mapping.has_every_axis() {
        return Err(UnknownAxes {
            message: "one axis appears twice, so another one is missing".to_owned(),
        });
    }
    Ok(mapping)
}
