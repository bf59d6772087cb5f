//! The keys by which a solution file and its version are recognised.

/// Value of the key `format`.
pub(super) const FORMAT: &str = "radiosity-solution";

/// Value of the key `format_version`: the only version that is written and read.
pub(super) const VERSION: u32 = 6;
