//! Why a rule could not be written.

use core::fmt;

/// Why a rule could not be written into the slices given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RuleError {
    /// The slices are empty: a rule has at least one node.
    Empty,
    /// Slices that must be of equal length are not.
    Lengths,
    /// A part of a rule was asked for that has more nodes than are left.
    Beyond,
    /// An asymptotic rule was asked for too few points for its expansion to hold.
    TooSmall,
    /// A node lies so near an end, an exponent being near −1 or n above 10⁴, that its weight would lose
    /// digits.
    NearEnd,
}

impl fmt::Display for RuleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RuleError::Empty => "a Gauss rule has at least one node; the slices given are empty",
            RuleError::TooSmall => "the asymptotic Gauss–Legendre rule needs more than 100 points",
            RuleError::Beyond => "the rule has not so many nodes from the middle to +1",
            RuleError::Lengths => "the slices for nodes and weights must be of equal length",
            RuleError::NearEnd => {
                "an exponent is too near −1 for this many points: a node would merge with the end"
            }
        })
    }
}

impl core::error::Error for RuleError {}

/// The common length of the two slices of a rule.
pub(super) const fn points(nodes: &[f64], weights: &[f64]) -> Result<usize, RuleError> {
    if nodes.len() != weights.len() {
        return Err(RuleError::Lengths);
    }
    if nodes.is_empty() { Err(RuleError::Empty) } else { Ok(nodes.len()) }
}
