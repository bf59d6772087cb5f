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

    /// The interval around 0 in which h₀ + h₁p + h₂p² ≥ 0, where h₀ ≥ 0.
    pub(super) fn above([h0, h1, h2]: [f64; 3]) -> Self {
        if h0 == 0.0 {
            let other = if h2 < 0.0 { -h1 / h2 } else { f64::INFINITY.copysign(h1) };
            return match h1 {
                h1 if h1 > 0.0 => Self { from: 0.0, to: other },
                h1 if h1 < 0.0 => Self { from: other, to: 0.0 },
                _ if h2 >= 0.0 => Self::ALL,
                _ => Self { from: 0.0, to: 0.0 },
            };
        }
        let mut span = Self::ALL;
        for zero in zeros([h0, h1, h2]).into_iter().flatten() {
            if zero > 0.0 { span.to = span.to.min(zero) } else { span.from = span.from.max(zero) }
        }
        span
    }

    /// Whether p lies in it.
    pub fn contains(&self, p: f64) -> bool {
        self.from <= p && p <= self.to
    }

    /// How far it reaches from 0 to the side of `step`; None where 0 is outside.
    pub(crate) fn ahead(&self, step: f64) -> Option<f64> {
        self.contains(0.0).then_some(if step < 0.0 { -self.from } else { self.to })
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

    /// The interval of the images of its ends, in the same order.
    #[must_use]
    pub(super) fn mapped(&self, image: impl Fn(f64) -> f64) -> Self {
        Self { from: image(self.from), to: image(self.to) }
    }
}

/// The real zeros of h₀ + h₁p + h₂p², where h₀ is not 0.
fn zeros([h0, h1, h2]: [f64; 3]) -> [Option<f64>; 2] {
    if h2 == 0.0 {
        return [(h1 != 0.0).then(|| -h0 / h1), None];
    }
    let square = h1 * h1 - 4.0 * h0 * h2;
    if square < 0.0 {
        return [None; 2];
    }
    // The sum of two numbers of one sign, so that no digits are lost; not 0, as h₀ and h₂ are not.
    let sum = -0.5 * (h1 + square.sqrt().copysign(h1));
    [Some(sum / h2), Some(h0 / sum)]
}
