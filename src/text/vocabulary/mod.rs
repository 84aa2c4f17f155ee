//! Words and names that are known: what announces, what declares, what constructs.

// What consoles write around numbers.
pub(crate) mod console;

// What a call does with its numbers.
pub(crate) mod constructors;

// Words of a declaration.
pub(crate) mod declaration;

// Words that are known before numbers.
pub(crate) mod phrases;
