//! The values of an enum as an array, and the value that has a name.

use std::fmt;
use strum::{EnumMessage, VariantArray};

/// A name that stands for no convention.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownName {
    pub(crate) name: String,
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} names no convention and no axis of one", self.name)
    }
}

impl std::error::Error for UnknownName {}

/// All variants as an array, which can be taken apart and mapped. What uses one of another length does not
/// compile.
pub(crate) const fn all<Choice: Copy, const COUNT: usize>(variants: &[Choice]) -> [Choice; COUNT] {
    let mut all = [variants[0]; COUNT];
    all.copy_from_slice(variants);
    all
}

/// The value with this name or alias, in letters of any size and with space around it.
///
/// (The reader that strum derives takes no space.)
pub(crate) fn named<Choice: VariantArray + EnumMessage + Copy>(
    name: &str,
) -> Result<Choice, UnknownName> {
    let is_name = |known: &&str| known.eq_ignore_ascii_case(name.trim());
    let found = Choice::VARIANTS
        .iter()
        .find(|choice| choice.get_serializations().iter().any(is_name));
    found.copied().ok_or_else(|| UnknownName {
        name: name.to_owned(),
    })
}

/// Serialization by the list of names; what serde derives has the code of a case for each.
macro_rules! serialized_by_name {
    ($kind:ident) => {
        impl serde::Serialize for $kind {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let name = <Self as strum::VariantNames>::VARIANTS[*self as usize];
                serializer.serialize_unit_variant(stringify!($kind), *self as u32, name)
            }
        }
    };
}
pub(crate) use serialized_by_name;
