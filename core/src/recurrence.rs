//! Three-term recurrences of orthonormal polynomials.
//!
//! ```text
//! p₀ = first,   p_{k+1}(x) = (a_k x + b_k) p_k(x) − c_k p_{k−1}(x)
//! ```
//!
//! Each polynomial system is a table of a, b, c. Evaluation for growing k is stable on [−1, 1]; its error
//! grows like k² ulp towards the ends and like k ulp inside. Near ±1 the forms anchored at the ends are more
//! accurate (`legendre::orthonormal`, `jacobi::Polynomials::values`).
//!
//! Sums Σ f_k p_k follow Clenshaw: s_k = f_k + (a_k x + b_k) s_{k+1} − c_{k+1} s_{k+2},
//! downwards, Σ = first · s₀.
//!
//! A tile is a block of W points treated side by side, W = 8 or 16: `out[k][l] = p_k(x[l])`. Its loops run
//! over lanes innermost and vectorise on every target; a tile of 16 fills from the first-level cache, so
//! consume it before making the next.
//!
//! Reference: W. Gautschi, Orthogonal Polynomials: Computation and Approximation (2004), §1.3 and §2.1.8.

mod differences;

pub(crate) use self::differences::{Differences, Step};

/// The coefficients that carry p₀ to p₁ … p_N; row k leads to p_{k+1}.
#[derive(Clone, Copy, Debug)]
pub struct Recurrence<const N: usize> {
    pub(crate) first: f64,
    pub(crate) a: [f64; N],
    pub(crate) b: [f64; N],
    pub(crate) c: [f64; N],
    /// All b are zero.
    pub(crate) symmetric: bool,
}

impl<const N: usize> Recurrence<N> {
    /// Writes p₀(x) … p_{N−1}(x).
    pub fn values(&self, x: f64, out: &mut [f64; N]) {
        let (mut before, mut last) = (0.0, self.first);
        for (k, p) in out.iter_mut().enumerate() {
            *p = last;
            (before, last) = (last, self.factor(k, x) * last - self.c[k] * before);
        }
    }

    /// Σ f_k p_k(x), k = 0 … N − 1.
    pub fn sum(&self, f: &[f64; N], x: f64) -> f64 {
        self.sum_tile(f, &[x])[0]
    }

    /// `out[k][l]` = `p_k(x[l])`.
    #[inline]
    pub fn tile<const W: usize>(&self, x: &[f64; W], out: &mut [[f64; W]; N]) {
        let (mut before, mut last) = ([0.0; W], [self.first; W]);
        for (k, row) in out.iter_mut().enumerate() {
            *row = last;
            let mut next = [0.0; W];
            for l in 0..W {
                next[l] = self.factor(k, x[l]) * last[l] - self.c[k] * before[l];
            }
            (before, last) = (last, next);
        }
    }

    /// `out[k][l]` = `p_k(x[l])` and `slopes[k][l]` = `p_k′(x[l])`.
    #[inline]
    pub fn tile_with_derivatives<const W: usize>(
        &self,
        x: &[f64; W],
        out: &mut [[f64; W]; N],
        slopes: &mut [[f64; W]; N],
    ) {
        let (mut before, mut last) = ([0.0; W], [self.first; W]);
        let (mut slope_before, mut slope) = ([0.0; W], [0.0; W]);
        for k in 0..N {
            (out[k], slopes[k]) = (last, slope);
            let (mut next, mut slope_next) = ([0.0; W], [0.0; W]);
            for l in 0..W {
                let factor = self.factor(k, x[l]);
                next[l] = factor * last[l] - self.c[k] * before[l];
                slope_next[l] = self.a[k] * last[l] + (factor * slope[l] - self.c[k] * slope_before[l]);
            }
            (before, last) = (last, next);
            (slope_before, slope) = (slope, slope_next);
        }
    }

    /// Σ f_k `p_k(x[l])`, k = 0 … N − 1, at every lane.
    #[inline]
    pub fn sum_tile<const W: usize>(&self, f: &[f64; N], x: &[f64; W]) -> [f64; W] {
        let (mut above, mut last) = ([0.0; W], [0.0; W]);
        for k in (0..N).rev() {
            let back = if k + 1 < N { self.c[k + 1] } else { 0.0 };
            let mut next = [0.0; W];
            for l in 0..W {
                next[l] = f[k] + (self.factor(k, x[l]) * last[l] - back * above[l]);
            }
            (above, last) = (last, next);
        }
        last.map(|sum| self.first * sum)
    }

    /// a_k x + b_k.
    #[inline(always)]
    fn factor(&self, k: usize, x: f64) -> f64 {
        if self.symmetric { self.a[k] * x } else { self.a[k] * x + self.b[k] }
    }
}
