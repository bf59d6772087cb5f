//! Blocks as rays find them.

/// A block by rays, or by rules where rays agree.
pub(super) struct RayBlock {
    pub row: usize,
    pub column: usize,
    pub values: Vec<f64>,
    /// Value of one ray in an entry of the block.
    pub one: f64,
    /// Largest error of an entry.
    pub error: f64,
    /// Whether the values are those by rules.
    pub is_by_rules: bool,
    /// Largest error of the view factors of either whole, relative to the largest factor of its row.
    pub relative: f64,
    /// Its part of the error of what its wholes exchange (length²): the squares of these parts add up.
    pub share: f64,
}
