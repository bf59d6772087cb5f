//! One step between neighbouring exponents: a sum that runs over the degrees, and a factor for each.

/// Which exponents a step lowers by 1.
#[derive(Clone, Copy, Debug)]
enum Lowered {
    Alpha,
    Beta,
    Both,
}

/// Between (α, β) and (α − 1, β), (α, β − 1) or (α − 1, β − 1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    lowered: Lowered,
    /// s in the factor (2k + s)/s: α + β of the upper pair for one exponent, α + β − 1 for both.
    shift: usize,
}

/// The steps from (a, b) to (m, m), m = min(a, b), and on to (0, 0): max(a, b) of them.
pub(super) fn steps(a: u8, b: u8) -> impl DoubleEndedIterator<Item = Step> {
    let (low, sum) = (a.min(b) as usize, a as usize + b as usize);
    let lowered = if a > b { Lowered::Alpha } else { Lowered::Beta };
    let one = (2 * low + 1..=sum).rev().map(move |shift| Step { lowered, shift });
    let both = (1..=low).rev().map(|i| Step { lowered: Lowered::Both, shift: 2 * i - 1 });
    one.chain(both)
}

impl Step {
    /// The divisor of 2k + s that stands for s: a power of two in (2s, 4s], which rounds nothing.
    ///
    /// It is larger than s so that the scales of high degrees, which fall like n^−max(a,b), stay in range.
    pub(super) fn unit(self) -> f64 {
        4.0 * f64::from(1u32 << self.shift.ilog2())
    }

    /// (2k + s)/unit, exactly.
    fn factor(self, k: usize) -> f64 {
        (2 * k + self.shift) as f64 / self.unit()
    }

    /// x_k ← x_k ± x_{k+1} + … or x_k + x_{k+2} + …
    pub(super) fn sum(self, x: &mut [f64]) {
        let (mut second, mut first) = (0.0, 0.0);
        for x in x.iter_mut().rev() {
            match self.lowered {
                Lowered::Alpha => *x += first,
                Lowered::Beta => *x -= first,
                Lowered::Both => *x += second,
            }
            (second, first) = (first, *x);
        }
    }

    /// x_k ← x_k ∓ x_{k+1} or x_k − x_{k+2}: undoes [`sum`](Step::sum).
    pub(super) fn differences(self, x: &mut [f64]) {
        for k in 1..x.len() {
            match self.lowered {
                Lowered::Alpha => x[k - 1] -= x[k],
                Lowered::Beta => x[k - 1] += x[k],
                Lowered::Both if k > 1 => x[k - 2] -= x[k],
                Lowered::Both => (),
            }
        }
    }

    /// x_k ← (2k + s)/unit · x_k.
    pub(super) fn multiply(self, x: &mut [f64]) {
        x.iter_mut().enumerate().for_each(|(k, x)| *x *= self.factor(k));
    }

    /// Undoes [`multiply`](Step::multiply).
    pub(super) fn divide(self, x: &mut [f64]) {
        x.iter_mut().enumerate().for_each(|(k, x)| *x /= self.factor(k));
    }
}
