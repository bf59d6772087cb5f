//! The width of panels and the threads that faer may use on them.
//!
//! Factorisations run faer's kernels on panels of [`PANEL`] columns, so that the caller's flag and time are
//! asked between steps of at most 2 n [`PANEL`]² operations: half a second at n = 20 000.
//!
//! The number of threads must not change a bit. faer's product of matrices keeps this, but for results of one
//! column, where it splits each sum by the number of threads; hence products of few columns run on one
//! thread, and so do all triangular solves with right-hand sides of a caller.

use faer::Par;

/// Columns of a panel. Chosen: each step is short, and panels cost nothing that shows (benches/README.md).
pub(crate) const PANEL: usize = 1024;

/// Unknowns from which threads are used: two gain 1.4 times at 2000, 1.1 to 1.4 times at 1500, and lose at
/// 100 (`benches/README.md` of the workspace).
const THREADED: usize = 2000;

/// Columns below which a product runs on one thread. Chosen; any number from 2 on keeps the bits.
const NARROW: usize = 64;

/// The threads of a factorisation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Threads(Par);

impl Threads {
    /// Threads for `dim` unknowns, of the current rayon pool: at most `threads` in faer's kernels, 0 for all
    /// there are. They are always said outright, because faer's default is shared by the whole process.
    pub(crate) fn new(dim: usize, threads: usize) -> Self {
        Self(if threads == 1 || dim < THREADED { Par::Seq } else { Par::rayon(threads) })
    }

    /// Threads for a product of so many columns.
    pub(crate) fn for_columns(self, columns: usize) -> Par {
        if columns < NARROW { Par::Seq } else { self.0 }
    }

    /// Whether there is one thread only.
    pub(crate) fn are_alone(self) -> bool {
        matches!(self.0, Par::Seq)
    }
}
