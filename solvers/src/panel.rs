//! Products of panels, the step in which factorisations by halves do nearly all their work.
//!
//! A matrix of n columns is factored as its left half, an update of the right half, and the right half
//! (recursion instead of a block size: S. Toledo, *SIAM J. Matrix Anal. Appl.* 18 (1997) 1065-1081). The
//! updates are products of matrices, C ← C − A B, which a library multiplies from the cache. Each is cut into
//! chunks of columns of a fixed number, whatever the number of threads: threads never change a bit.

use std::sync::atomic::{AtomicBool, Ordering};

use ndarray::linalg::general_mat_mul;
use ndarray::{ArrayView2, ArrayViewMut2, Axis};
use rayon::prelude::*;

use crate::settings::Settings;

/// Panels of at most so many columns are factored column by column. Measured: between 8 and 32 the time of
/// `lu` at n = 1000 changes by less than a tenth (`cargo bench -p radiosity-solvers`).
pub(crate) const NARROW: usize = 16;

/// Columns of one chunk: enough for the product to run from the cache. Chosen; not tuned.
pub(crate) const CHUNK: usize = 128;

/// Products of fewer multiplications than this are not shared between threads. Chosen; not tuned.
const SHARED: usize = 1 << 21;

/// With what a matrix is factored, and until when.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Labour<'a> {
    /// Threads of the current pool.
    threads: usize,
    /// Raised by the caller to stop: the factors are then of no meaning.
    cancel: Option<&'a AtomicBool>,
}

impl<'a> Labour<'a> {
    /// One thread, to the end.
    pub(crate) const ALONE: Self = Self { threads: 1, cancel: None };

    /// As the settings say.
    pub(crate) fn of(settings: &Settings<'a>) -> Self {
        Self { threads: settings.threads, cancel: settings.cancel }
    }

    /// Whether the caller has raised the flag.
    pub(crate) fn is_cancelled(self) -> bool {
        self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed))
    }
}

/// Calls `update(first column, chunk)` for all chunks of columns of `c`, until it is cancelled; on several threads
/// where `multiplications` are many.
pub(crate) fn for_chunks(
    c: ArrayViewMut2<'_, f64>,
    multiplications: usize,
    labour: Labour<'_>,
    update: impl Fn(usize, ArrayViewMut2<'_, f64>) + Sync,
) {
    let mut c = c;
    let chunks = c.axis_chunks_iter_mut(Axis(1), CHUNK).enumerate();
    let update = |(chunk, c): (usize, ArrayViewMut2<'_, f64>)| {
        if !labour.is_cancelled() {
            update(chunk * CHUNK, c);
        }
    };
    if labour.threads == 1 || multiplications < SHARED {
        chunks.for_each(update);
        return;
    }
    let chunks: Vec<_> = chunks.collect();
    chunks.into_par_iter().for_each(update);
}

/// C ← C − A B.
pub(crate) fn subtract_product(
    a: &ArrayView2<'_, f64>,
    b: &ArrayView2<'_, f64>,
    c: &mut ArrayViewMut2<'_, f64>,
) {
    general_mat_mul(-1.0, a, b, 1.0, c);
}

/// Column `j` of a matrix whose columns are contiguous.
pub(crate) fn column<'a>(matrix: &'a mut ArrayViewMut2<'_, f64>, j: usize) -> &'a mut [f64] {
    contiguous(matrix.view_mut(), j)
}

/// Columns `j` and `k` > `j` of a matrix whose columns are contiguous.
pub(crate) fn two_columns<'a>(
    matrix: &'a mut ArrayViewMut2<'_, f64>,
    j: usize,
    k: usize,
) -> (&'a [f64], &'a mut [f64]) {
    let (left, right) = matrix.view_mut().split_at(Axis(1), k);
    (contiguous(left, j), contiguous(right, 0))
}

/// Column `j` as a slice.
fn contiguous(matrix: ArrayViewMut2<'_, f64>, j: usize) -> &mut [f64] {
    matrix.index_axis_move(Axis(1), j).into_slice().expect("columns are contiguous")
}

/// Numbers in −½..½ without structure, the same for the same seed.
#[cfg(test)]
pub(crate) fn random(len: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        // Multiplier and increment of D. Knuth's MMIX generator.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    (0..len).map(|_| next()).collect()
}

/// Largest |b − A x|_i / (Σ_j |a_ij x_j| + |b_i|) of the x that `solve` makes of a random b.
#[cfg(test)]
pub(crate) fn worst_backward_error(matrix: &[f64], dim: usize, solve: impl Fn(&mut [f64])) -> f64 {
    let b = random(dim, 2);
    let mut x = b.clone();
    solve(&mut x);
    let terms = |i: usize| (0..dim).map(move |j| (i, j));
    let error = |i: usize| {
        let product: f64 = terms(i).map(|(i, j)| matrix[j * dim + i] * x[j]).sum();
        let scale: f64 = terms(i).map(|(i, j)| (matrix[j * dim + i] * x[j]).abs()).sum();
        (b[i] - product).abs() / (scale + b[i].abs())
    };
    (0..dim).map(error).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicUsize;

    use ndarray::Array2;

    use super::*;

    #[test]
    fn no_chunk_is_updated_once_it_is_cancelled() {
        let mut c = Array2::zeros((4, 5 * CHUNK));
        for (threads, multiplications) in [(1, 0), (2, SHARED)] {
            let (cancel, updated) = (AtomicBool::new(false), AtomicUsize::new(0));
            let labour = Labour { threads, cancel: Some(&cancel) };
            let update = |_: usize, _: ArrayViewMut2<'_, f64>| {
                updated.fetch_add(1, Ordering::Relaxed);
            };
            for_chunks(c.view_mut(), multiplications, labour, update);
            assert_eq!(updated.swap(0, Ordering::Relaxed), 5);
            cancel.store(true, Ordering::Relaxed);
            for_chunks(c.view_mut(), multiplications, labour, update);
            assert_eq!(updated.into_inner(), 0);
        }
    }
}
