//! Orthonormal Jacobi polynomials: ∫₋₁¹ p_m p_n (1 − x)^α (1 + x)^β dx = δ_mn, p_n(1) > 0.
//!
//! p_n(−1) = (−1)ⁿ times the value at +1 for exchanged exponents. At single points values come from the
//! recurrence anchored at the nearer end (module `anchored`), in tiles from the three-term recurrence (module
//! `recurrence`).

use super::Weight;
use super::anchored::{Anchor, Start, anchored, write, write_with_derivatives};
use super::monic::Monic;
use crate::double::Double;
use crate::recurrence::{Recurrence, Step};

/// Writes p₀(x) … p_{m−1}(x), m = `out.len()`, for x ∈ [−1, 1].
///
/// Makes the coefficients as it goes; where many points share a weight, [`Polynomials`] and
/// [`Table`](super::Table) keep them.
pub fn orthonormal(weight: Weight, x: f64, out: &mut [f64]) {
    let (end, turn) = if x < 0.0 { (weight.mirrored(), -1.0) } else { (weight, 1.0) };
    write(x, anchored(end, turn), out);
}

/// One end: the steps along k and the value of p_k there.
#[derive(Clone, Copy, Debug)]
struct End<const N: usize> {
    steps: [Step; N],
    value: [f64; N],
}

impl<const N: usize> End<N> {
    /// The end +1 of a weight.
    const fn right(weight: Weight) -> End<N> {
        let mut end = End { steps: [Step::NONE; N], value: [0.0; N] };
        let mut anchor = Anchor::new(weight);
        let mut k = 0;
        while k < N {
            end.value[k] = anchor.end();
            end.steps[k] = anchor.advance();
            k += 1;
        }
        end
    }

    /// The end −1 of a weight.
    const fn left(weight: Weight) -> End<N> {
        let mut end = End::right(weight.mirrored());
        let mut k = 1;
        while k < N {
            end.value[k] = -end.value[k];
            k += 2;
        }
        end
    }

    /// Values at the end, and steps to the next.
    #[inline(always)]
    fn iter(&self) -> impl Iterator<Item = Start> {
        self.value.iter().zip(&self.steps).map(|(&value, &step)| Start { value, step })
    }
}

/// The first N orthonormal Jacobi polynomials of one weight: p₀ … p_{N−1}.
///
/// The constructor is `const`; the tables then cost nothing at run time.
///
/// ```
/// use radiosity_core::jacobi::{Polynomials, Weight};
///
/// const P: Polynomials<3> = Polynomials::new(Weight::integer(0, 2));
/// let mut p = [0.0; 3];
/// P.values(1.0, &mut p);
/// // p_n(1) = √(n + 3/2)/2 for the weight (1 + x)².
/// assert_eq!(p, [1.5f64.sqrt() / 2.0, 2.5f64.sqrt() / 2.0, 3.5f64.sqrt() / 2.0]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Polynomials<const N: usize> {
    weight: Weight,
    recurrence: Recurrence<N>,
    right: End<N>,
    left: End<N>,
}

impl<const N: usize> Polynomials<N> {
    /// The polynomials of a weight.
    pub const fn new(weight: Weight) -> Polynomials<N> {
        let right = End::right(weight);
        let recurrence = recurrence(weight, if N > 0 { right.value[0] } else { 0.0 });
        Polynomials { weight, recurrence, right, left: End::left(weight) }
    }

    /// The weight they are orthonormal for.
    pub const fn weight(&self) -> Weight {
        self.weight
    }

    /// Their three-term recurrence, for tiles and sums.
    pub const fn recurrence(&self) -> &Recurrence<N> {
        &self.recurrence
    }

    /// p_k(1).
    pub const fn right(&self) -> &[f64; N] {
        &self.right.value
    }

    /// p_k(−1).
    pub const fn left(&self) -> &[f64; N] {
        &self.left.value
    }

    /// ‖P_k‖ of the classical polynomial with P_k(1) = C(k + α, k), so that p_k = P_k/‖P_k‖.
    pub fn norms(&self) -> [f64; N] {
        let mut norms = self.right.value;
        let mut classical = 1.0;
        for (k, norm) in norms.iter_mut().enumerate() {
            *norm = classical / *norm;
            classical *= (k as f64 + self.weight.alpha() + 1.0) / (k as f64 + 1.0);
        }
        norms
    }

    /// Writes p_k(x) for x ∈ [−1, 1], anchored at the nearer end.
    pub fn values(&self, x: f64, out: &mut [f64; N]) {
        write(x, self.nearer(x).iter(), out);
    }

    /// Writes p_k(x) and p_k′(x) for x ∈ [−1, 1], anchored at the nearer end.
    pub fn values_with_derivatives(&self, x: f64, out: &mut [f64; N], slopes: &mut [f64; N]) {
        write_with_derivatives(x, self.nearer(x).iter(), out, slopes);
    }

    fn nearer(&self, x: f64) -> &End<N> {
        if x < 0.0 { &self.left } else { &self.right }
    }
}

/// a = 1/√γ_{k+1}, b = −δ_k/√γ_{k+1}, c = √(γ_k/γ_{k+1}).
const fn recurrence<const N: usize>(weight: Weight, first: f64) -> Recurrence<N> {
    let monic = Monic::new(weight);
    let symmetric = monic.is_symmetric();
    let mut table = Recurrence { first, a: [0.0; N], b: [0.0; N], c: [0.0; N], symmetric };
    let mut gamma = Double::ZERO;
    let mut k = 0;
    while k < N {
        let next = monic.four_gamma(k + 1);
        let a = Double::new(2.0).div(next.sqrt());
        table.a[k] = a.hi;
        table.b[k] = a.mul(monic.delta(k)).neg().hi;
        table.c[k] = gamma.div(next).sqrt().hi;
        gamma = next;
        k += 1;
    }
    table
}
