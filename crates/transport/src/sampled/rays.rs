//! Which rays an estimate takes.

use crate::sampled::tally::Sums;

/// Which rays an estimate of G takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rays {
    /// All.
    All,
    /// Those of even number.
    Even,
    /// Those of odd number.
    Odd,
}

impl Rays {
    /// Of figures of either half, those of the rays that count.
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
