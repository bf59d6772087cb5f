//! Orthonormal Jacobi polynomials of any number, tabulated in a slice of the caller.
//!
//! What [`Polynomials`](super::Polynomials) holds for both ends in arrays of constant length, for numbers
//! known at run time.

use super::Weight;
use super::anchored::{Start, anchored, write, write_with_derivatives};
use crate::recurrence::Step;

/// One polynomial: its values at both ends and the steps to the next; made by [`Table::new`].
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    right: Start,
    left: Start,
}

impl Entry {
    /// Placeholder that fills a slice before [`Table::new`] writes it.
    pub const EMPTY: Entry = {
        let nothing = Start { value: 0.0, step: Step::NONE };
        Entry { right: nothing, left: nothing }
    };
}

/// The orthonormal Jacobi polynomials p₀ … p_{m−1} of one weight, m the length of the caller's slice.
///
/// ```
/// use radiosity_core::jacobi::{Entry, Table, Weight};
///
/// let mut entries = [Entry::EMPTY; 3];
/// let table = Table::new(Weight::integer(0, 2), &mut entries);
/// let mut p = [0.0; 3];
/// table.values(1.0, &mut p);
/// assert_eq!(p, [1.5f64.sqrt() / 2.0, 2.5f64.sqrt() / 2.0, 3.5f64.sqrt() / 2.0]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Table<'a> {
    weight: Weight,
    entries: &'a [Entry],
}

impl<'a> Table<'a> {
    /// Writes the entries of a weight.
    pub fn new(weight: Weight, entries: &'a mut [Entry]) -> Table<'a> {
        let ends = anchored(weight, 1.0).zip(anchored(weight.mirrored(), -1.0));
        for (entry, (right, left)) in entries.iter_mut().zip(ends) {
            *entry = Entry { right, left };
        }
        Table { weight, entries }
    }

    /// Writes p_k(x), k = 0 … `out.len()` − 1, for x ∈ [−1, 1].
    ///
    /// # Panics
    /// If more polynomials are asked for than the table has.
    pub fn values(&self, x: f64, out: &mut [f64]) {
        self.check(out.len());
        write(x, self.nearer(x), out);
    }

    /// Writes p_k(x) and p_k′(x), k = 0 … `out.len()` − 1, for x ∈ [−1, 1].
    ///
    /// # Panics
    /// If the slices differ in length, or more polynomials are asked for than the table has.
    pub fn values_with_derivatives(&self, x: f64, out: &mut [f64], slopes: &mut [f64]) {
        assert_eq!(out.len(), slopes.len(), "one derivative per value");
        self.check(out.len());
        write_with_derivatives(x, self.nearer(x), out, slopes);
    }

    /// P_n/p_n = ‖P_n‖ for the classical polynomial with P_n(1) = C(n + α, n); infinite where P_n(1) is too
    /// large.
    ///
    /// # Panics
    /// If the table has no p_n.
    pub fn norm(&self, n: usize) -> f64 {
        let alpha = self.weight.alpha();
        let classical: f64 = (1..=n).map(|k| (k as f64 + alpha) / k as f64).product();
        classical / self.entries[n].right.value
    }

    fn check(&self, count: usize) {
        assert!(
            count <= self.entries.len(),
            "{count} polynomials asked of a table of {}",
            self.entries.len()
        );
    }

    fn nearer(&self, x: f64) -> impl Iterator<Item = Start> {
        self.entries.iter().map(move |entry| if x < 0.0 { entry.left } else { entry.right })
    }
}
