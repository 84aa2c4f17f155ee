//! What a program prints, as data: the words that mark it, its fields, and what they mean.

use crate::convention::angle::AngleUnit;
use crate::convention::order::ComponentOrder;

/// A format, or the prints of one program.
#[derive(Debug)]
pub(crate) struct Format {
    /// Its id in the table of libraries and formats.
    pub(crate) id: &'static str,
    /// What people call it.
    pub(crate) name: &'static str,
    /// The words by which it is known: one of each entry must stand in the text; bars divide them. What
    /// begins with `~` must stand there as it is.
    pub(crate) marks: &'static [&'static str],
    /// The order of four numbers without names; `None` where the format has none of its own.
    pub(crate) order: Option<ComponentOrder>,
    pub(crate) fields: &'static [Field],
}

impl Format {
    /// Whether words mark it; one without is known by its numbers alone, or not at all.
    pub(crate) const fn has_marks(&self) -> bool {
        !self.marks.is_empty()
    }
}

/// Where numbers stand and what they are.
#[derive(Debug)]
pub(crate) enum Field {
    /// Numbers under one of these names, which bars divide.
    Under(&'static str, &'static [Part]),
    /// Numbers whatever their name.
    Any(&'static [Part]),
    /// Single numbers with such names below one of the first names.
    NamedUnder(&'static str, &'static str, &'static [Part]),
    /// Single numbers with these names, which spaces divide, in the order of the parts.
    Named(&'static str, &'static [Part]),
    /// The same in this order, where these are all.
    OnlyNamed(&'static str, &'static [Part]),
    /// A row of the text that begins with numbers.
    Row(&'static [Part]),
    /// Groups that stand behind each other, of which at most the first has a name.
    Groups(&'static [&'static [Part]]),
    /// Three numbers of an axis, and the angle behind their bracket.
    VectorThenAngle(Unit),
    /// The angle, and three numbers of an axis in brackets behind it.
    AngleThenVector(Unit),
    /// The names of what commas divide in a sentence that begins so: `$PASHR,…`.
    Sentence(&'static str, &'static [&'static str]),
    /// Such a row that commas divide.
    CommaRow(&'static [Part]),
}

/// What the next numbers are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Part {
    /// Numbers that say nothing of a rotation.
    Skip(u8),
    Time,
    /// A time that is counted in nanoseconds, by its size.
    Nanoseconds,
    Position,
    /// Where the origin of the body is in the world, whichever way the rotation leads.
    Centre,
    Scale,
    /// Four numbers of any norm in this order.
    ScaledQuaternion(ComponentOrder),
    /// Four numbers in this order, or in that which is declared.
    Quaternion(Option<ComponentOrder>),
    Euler(Angles),
    RotationVector(AngleUnit),
    ModifiedRodrigues,
    /// The vector of a quaternion of norm 1 whose scalar is not negative.
    Imaginary,
    /// Three numbers of an axis, and the angle.
    AxisAngle(Unit),
    /// The same under a name that others use of a quaternion: the axis has length 1, and the four have not.
    UnitAxisAngle(Unit),
    /// The angle, and three numbers of an axis.
    AngleAxis(Unit),
    /// The x axis and the y axis; the third is perpendicular to both.
    XyAxes,
    /// Nine numbers row by row.
    Rows,
    /// Nine numbers column by column.
    Columns,
    /// Twelve or sixteen numbers row by row, the translation in the last column; of fifteen each row has its
    /// number and the translation before the rotation.
    HomogeneousRows(u8),
    /// Twelve or sixteen numbers column by column.
    HomogeneousColumns(u8),
    /// Sixteen numbers, whose translation tells whether rows or columns follow each other.
    Homogeneous(u8),
}

/// The unit of angles: that of the format, which a word in the text may change, or to be seen from their size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unit {
    Always(AngleUnit),
    Usually(AngleUnit),
    BySize,
}

/// Euler angles of a format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Angles {
    /// In the letters of `SciPy`: capitals move, small letters are fixed.
    pub(crate) sequence: &'static str,
    pub(crate) unit: Unit,
    /// Which of the numbers is the angle about each axis of the sequence.
    pub(crate) places: Places,
    /// The sign of each angle of the sequence.
    pub(crate) signs: [i8; 3],
    /// What the letters of a sequence that the text names say of its axes.
    pub(crate) letters: Letters,
}

/// In which order angles stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Places {
    /// In that of the sequence, or so: the place of each of its angles.
    Listed([u8; 3]),
    /// The angle about x, then y, then z, whatever the sequence is.
    ByAxis,
}

/// Which letters of a sequence in a text are axes that move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Letters {
    /// Capitals, as in `SciPy`.
    CapitalsMove,
    /// Small letters, as in `MuJoCo`.
    SmallMove,
    /// All of them, as in three.js.
    AllMove,
    /// None of them, as in Blender.
    AllFixed,
    /// Whatever they are: the name of a call has its own sequence, as `RotationYawPitchRoll` about y, x, z.
    Ignored,
}

impl Angles {
    /// Angles in the order of the sequence, with the usual signs.
    pub(crate) const fn new(sequence: &'static str, unit: Unit) -> Self {
        Self {
            sequence,
            unit,
            places: Places::Listed([0, 1, 2]),
            signs: [1; 3],
            letters: Letters::CapitalsMove,
        }
    }

    pub(crate) const fn placed(self, places: [u8; 3]) -> Self {
        Self {
            places: Places::Listed(places),
            ..self
        }
    }

    pub(crate) const fn by_axis(self) -> Self {
        Self {
            places: Places::ByAxis,
            ..self
        }
    }

    pub(crate) const fn lettered(self, letters: Letters) -> Self {
        Self { letters, ..self }
    }

    pub(crate) const fn signed(self, signs: [i8; 3]) -> Self {
        Self { signs, ..self }
    }
}

impl Part {
    /// How many numbers it takes.
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Skip(count)
            | Self::HomogeneousRows(count)
            | Self::HomogeneousColumns(count)
            | Self::Homogeneous(count) => count as usize,
            Self::Time | Self::Nanoseconds => 1,
            Self::Position
            | Self::Centre
            | Self::Scale
            | Self::Euler(_)
            | Self::RotationVector(_)
            | Self::ModifiedRodrigues
            | Self::Imaginary => 3,
            Self::Quaternion(_)
            | Self::ScaledQuaternion(_)
            | Self::AxisAngle(_)
            | Self::UnitAxisAngle(_)
            | Self::AngleAxis(_) => 4,
            Self::XyAxes => 6,
            Self::Rows | Self::Columns => 9,
        }
    }
}

/// The marks of a format that is only known where it is declared.
pub(crate) const DECLARED_ONLY: &[&str] = &["~\0"];
