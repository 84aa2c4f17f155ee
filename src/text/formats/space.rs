//! Spacecraft: attitude files and kernels.

use crate::text::record::format::Format;

pub(crate) const SPACE: &[Format] = &[];
