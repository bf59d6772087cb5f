//! The keys by which a solution file and its version are recognised.

/// What the key `format` says.
pub(super) const FORMAT: &str = "radiosity-solution";

/// What the key `format_version` says: the one version that is written and read.
pub const VERSION: u32 = 3;
