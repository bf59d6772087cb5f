//! The weight (1 − x)^α (1 + x)^β on [−1, 1].

use core::fmt;

/// The weight function (1 − x)^α (1 + x)^β on [−1, 1] with −1 < α, β ≤ [`Weight::LARGEST`].
///
/// β is the exponent at the left end x = −1, α the one at the right end x = +1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weight {
    alpha: f64,
    beta: f64,
}

/// Why a pair (α, β) is no weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum WeightError {
    /// α is NaN, not above −1, or above [`Weight::LARGEST`].
    Alpha,
    /// β is NaN, not above −1, or above [`Weight::LARGEST`].
    Beta,
}

impl Weight {
    /// The largest exponent accepted: up to here no intermediate quantity leaves the range of f64 for
    /// polynomials of moderate degree.
    pub const LARGEST: f64 = 256.0;

    /// The weight 1 of the Legendre polynomials.
    pub const LEGENDRE: Weight = Weight { alpha: 0.0, beta: 0.0 };

    /// The weight (1 − x)^α (1 + x)^β.
    ///
    /// # Errors
    /// [`WeightError`] unless −1 < α, β ≤ [`Weight::LARGEST`]; NaN is refused.
    pub const fn new(alpha: f64, beta: f64) -> Result<Weight, WeightError> {
        if !(alpha > -1.0 && alpha <= Self::LARGEST) {
            return Err(WeightError::Alpha);
        }
        if !(beta > -1.0 && beta <= Self::LARGEST) {
            return Err(WeightError::Beta);
        }
        Ok(Weight { alpha, beta })
    }

    /// The weight (1 − x)^a (1 + x)^b of two small integers; cannot fail.
    pub const fn integer(a: u8, b: u8) -> Weight {
        Weight { alpha: a as f64, beta: b as f64 }
    }

    /// The weight (1 − x)^α (1 + x)^β of exponents known to be valid.
    pub(crate) const fn valid(alpha: f64, beta: f64) -> Weight {
        Weight { alpha, beta }
    }

    /// α, the exponent of 1 − x.
    pub const fn alpha(self) -> f64 {
        self.alpha
    }

    /// β, the exponent of 1 + x.
    pub const fn beta(self) -> f64 {
        self.beta
    }

    /// The mirrored weight, (1 − x)^β (1 + x)^α.
    pub const fn mirrored(self) -> Weight {
        Weight { alpha: self.beta, beta: self.alpha }
    }
}

impl fmt::Display for WeightError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, end) = match self {
            WeightError::Alpha => ("α", "+1"),
            WeightError::Beta => ("β", "−1"),
        };
        write!(f, "{name}, the exponent of the weight at {end}, must lie in (−1, {}]", Weight::LARGEST)
    }
}

impl core::error::Error for WeightError {}
