//! The rows of G that each rank holds.

use std::ops::Range;

use radiosity_work::ranks::{Ranks, shares};

/// The rows of elements that a rank holds, and those of the others: runs of elements, in order, with about as
/// many coefficients.
#[derive(Clone, Debug)]
pub struct HeldRows {
    ranks: Ranks,
    /// The elements at which the rows of each rank end.
    ends: Vec<usize>,
    /// The coefficients at which they end.
    coefficients: Vec<usize>,
    /// The elements of this rank.
    own: Range<usize>,
    /// Their coefficients.
    own_coefficients: Range<usize>,
}

impl HeldRows {
    /// For elements of which these are the first coefficients, and the dimension at the end.
    pub fn of(ranks: &Ranks, starts: &[usize]) -> Self {
        let sizes: Vec<f64> = starts.windows(2).map(|range| (range[1] - range[0]) as f64).collect();
        let ends = shares::ends(&sizes, ranks.count());
        let coefficients: Vec<usize> = ends.iter().map(|end| starts[*end]).collect();
        let [own, own_coefficients] = [&ends, &coefficients].map(|ends| shares::range(ends, ranks.number()));
        Self { ranks: ranks.clone(), ends, coefficients, own, own_coefficients }
    }

    /// The ranks.
    pub fn ranks(&self) -> &Ranks {
        &self.ranks
    }

    /// The coefficients of this rank.
    pub(crate) fn coefficients(&self) -> Range<usize> {
        self.own_coefficients.clone()
    }

    /// Whether an element is of this rank.
    pub fn has(&self, element: usize) -> bool {
        self.own.contains(&element)
    }

    /// The rank of an element.
    pub fn rank(&self, element: usize) -> usize {
        shares::owner(&self.ends, element)
    }

    /// Fills in the coefficients of the elements of other ranks.
    pub fn complete(&self, coefficients: &mut [f64]) {
        self.ranks.complete(coefficients, &self.coefficients);
    }
}
