//! An interval of displacements p.

/// from ≤ p ≤ to; empty where from > to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Least p, −∞ where there is none.
    pub from: f64,
    /// Largest p, ∞ where there is none.
    pub to: f64,
}

impl Span {
    /// All p.
    pub(super) const ALL: Self = Self { from: f64::NEG_INFINITY, to: f64::INFINITY };
    /// No p.
    const NONE: Self = Self { from: f64::INFINITY, to: f64::NEG_INFINITY };

    /// Where height + p slope ≥ 0.
    pub(super) fn above(height: f64, slope: f64) -> Self {
        let zero = -height / slope;
        match slope {
            slope if slope > 0.0 => Self { from: zero, ..Self::ALL },
            slope if slope < 0.0 => Self { to: zero, ..Self::ALL },
            _ if height >= 0.0 => Self::ALL,
            _ => Self::NONE,
        }
    }

    /// Whether p lies in it.
    pub fn contains(&self, p: f64) -> bool {
        self.from <= p && p <= self.to
    }

    /// The interval that both have in common.
    #[must_use]
    pub(super) fn common(&self, other: &Self) -> Self {
        Self { from: self.from.max(other.from), to: self.to.min(other.to) }
    }

    /// The least interval around both.
    #[must_use]
    pub(super) fn hull(&self, other: &Self) -> Self {
        Self { from: self.from.min(other.from), to: self.to.max(other.to) }
    }

    /// The part of what lies outside that holds zero, if zero lies outside.
    #[must_use]
    pub(super) fn beside_zero(&self) -> Self {
        match self {
            Self { from, to } if from > to => Self::ALL,
            Self { from, .. } if *from > 0.0 => Self { to: *from, ..Self::ALL },
            Self { to, .. } => Self { from: *to, ..Self::ALL },
        }
    }

    /// The interval of p + `step` for its p.
    #[must_use]
    pub(super) fn moved(&self, step: f64) -> Self {
        Self { from: self.from + step, to: self.to + step }
    }
}
