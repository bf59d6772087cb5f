//! The rays that an estimate takes.

use crate::sampled::tally::Sums;

/// The rays that an estimate of G takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rays {
    /// All rays.
    All,
    /// Rays of even number.
    Even,
    /// Rays of odd number.
    Odd,
}

impl Rays {
    /// Sum of the figures of the halves that count.
    pub(super) fn of(self, [even, odd]: [f64; 2]) -> f64 {
        match self {
            Self::All => even + odd,
            Self::Even => even,
            Self::Odd => odd,
        }
    }

    /// The sums of a pair over the rays that count.
    pub(super) fn sums(self, sums: &Sums) -> impl Iterator<Item = f64> {
        let [even, odd] = sums.halves;
        even.iter().zip(odd).map(move |(even, odd)| self.of([*even, *odd].map(f64::from)))
    }

    /// Share of all rays that count.
    pub(super) fn share(self) -> f64 {
        if self == Self::All { 1.0 } else { 0.5 }
    }
}
