//! A x = b, its inputs checked.

use crate::error::SolveError;
use crate::operator::Operator;
use crate::settings::Settings;
use crate::vector::{all_finite, norm};

/// A x = b with lengths that agree and a finite b.
#[derive(Clone, Copy)]
pub(crate) struct Problem<'a> {
    pub(crate) a: &'a dyn Operator,
    pub(crate) b: &'a [f64],
    /// ‖b‖₂.
    pub(crate) norm: f64,
}

impl<'a> Problem<'a> {
    /// Refuses lengths that differ, numbers that are not finite, and settings out of range.
    pub(crate) fn new(
        a: &'a dyn Operator,
        b: &'a [f64],
        x: &[f64],
        settings: &Settings<'_>,
    ) -> Result<Self, SolveError> {
        let expected = a.partition().dim();
        for (what, found) in [("the right-hand side", b.len()), ("the vector of unknowns", x.len())] {
            if found != expected {
                return Err(SolveError::DimensionMismatch { what, expected, found });
            }
        }
        settings.check(expected)?;
        if !all_finite(b) || norm(b).is_infinite() {
            return Err(SolveError::NonFinite { what: "the right-hand side" });
        }
        Ok(Self { a, b, norm: norm(b) })
    }

    pub(crate) fn dim(&self) -> usize {
        self.b.len()
    }

    /// r = b − A x; returns ‖r‖₂ / ‖b‖₂.
    pub(crate) fn residual(&self, x: &[f64], r: &mut [f64]) -> Result<f64, SolveError> {
        self.apply(x, r)?;
        Ok(self.residual_of(r))
    }

    /// r = b − r for the product r = A x; returns ‖r‖₂ / ‖b‖₂.
    pub(crate) fn residual_of(&self, r: &mut [f64]) -> f64 {
        for (r, b) in r.iter_mut().zip(self.b) {
            *r = b - *r;
        }
        self.relative(r)
    }

    /// r = b − A x through those block columns only where x ≠ 0; returns ‖r‖₂ / ‖b‖₂.
    pub(crate) fn residual_by_columns(&self, x: &[f64], r: &mut [f64]) -> Result<f64, SolveError> {
        r.copy_from_slice(self.b);
        for block in 0..self.a.partition().len() {
            let shot: Vec<f64> = x[self.a.partition().range(block)].iter().map(|x| -x).collect();
            if shot.iter().any(|x| *x != 0.0) {
                self.a.shoot(block, &shot, r);
            }
        }
        finite(r)?;
        Ok(self.relative(r))
    }

    /// y = A x, refused unless every entry was written with a finite number.
    pub(crate) fn apply(&self, x: &[f64], y: &mut [f64]) -> Result<(), SolveError> {
        y.fill(f64::NAN);
        self.a.apply(x, y);
        finite(y)
    }

    /// ‖r‖₂ / ‖b‖₂.
    pub(crate) fn relative(&self, r: &[f64]) -> f64 {
        norm(r) / self.norm
    }
}

/// Whether `x` is not a number or above 1e150: a product with it that is not finite is then no fault of the
/// matrix.
pub(crate) fn exploded(x: &[f64]) -> bool {
    let size = norm(x);
    size.is_nan() || size > 1e150
}

/// Refuses a product that is not finite, or was not written.
pub(crate) fn finite(y: &[f64]) -> Result<(), SolveError> {
    if all_finite(y) { Ok(()) } else { Err(SolveError::NonFinite { what: "the product with the matrix" }) }
}
