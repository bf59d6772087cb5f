//! Evaluation of a recurrence of differences, for growing k, that keeps its rounding errors.
//!
//!   D_{k+1} = h_k D_k − (κ_k D_k + σ_k y R_k),   R_{k+1} = R_k + D_{k+1},   R₀ = 1,  D₀ = 0
//!
//! with h_k = 1 or 0, whichever makes κ_k the smaller: h_k D_k is exact and the subtracted term is
//! comparatively small. Both sums lose the most: an error of D affects R at every later step, and near a zero
//! of R both R_k and R_{k−1} are small. Their rounding errors are known exactly (two_sum) and obey the same
//! recurrence, in plain floats. Slopes R′ = dR/dy follow by differentiation, without this correction.

use crate::double::two_sum;

/// The coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) keep: f64,
    pub(crate) kappa: f64,
    pub(crate) sigma: f64,
}

impl Step {
    /// The place of a step that is not made yet.
    pub(crate) const NONE: Step = Step { keep: 0.0, kappa: 0.0, sigma: 0.0 };
}

/// R_k, D_k and dR_k/dy at one point, y its distance from the end of anchorage.
pub(crate) struct Differences {
    y: f64,
    value: f64,
    value_error: f64,
    difference: f64,
    difference_error: f64,
    slope: f64,
    slope_difference: f64,
}

impl Differences {
    /// R₀ = 1 and D₀ = 0 at the distance y.
    pub(crate) const fn new(y: f64) -> Differences {
        Differences {
            y,
            value: 1.0,
            value_error: 0.0,
            difference: 0.0,
            difference_error: 0.0,
            slope: 0.0,
            slope_difference: 0.0,
        }
    }

    /// R_k.
    #[inline(always)]
    pub(crate) const fn value(&self) -> f64 {
        self.value + self.value_error
    }

    /// dR_k/dy.
    #[inline(always)]
    pub(crate) const fn slope(&self) -> f64 {
        self.slope
    }

    /// Advances R and D from k to k + 1.
    #[inline(always)]
    pub(crate) const fn advance(&mut self, step: Step) {
        let Step { keep, kappa, sigma } = step;
        let factor = sigma * self.y;
        let change = kappa * self.difference + factor * self.value;
        let change_error = kappa * self.difference_error + factor * self.value_error;
        let (difference, error) = two_sum(keep * self.difference, -change);
        self.difference = difference;
        self.difference_error = (keep * self.difference_error - change_error) + error;
        let (value, error) = two_sum(self.value, difference);
        self.value = value;
        self.value_error += self.difference_error + error;
    }

    /// Advances R, D and their slopes from k to k + 1.
    #[inline(always)]
    pub(crate) const fn advance_with_slope(&mut self, step: Step) {
        let Step { keep, kappa, sigma } = step;
        let change = kappa * self.slope_difference + sigma * (self.value + self.y * self.slope);
        self.slope_difference = keep * self.slope_difference - change;
        self.slope += self.slope_difference;
        self.advance(step);
    }
}
