//! A family of orthonormal polynomials on [−1, 1]: Legendre's, or Jacobi's for one weight.

use radiosity_core::jacobi::{Entry, Table, Weight};
use radiosity_core::legendre;

/// Polynomials p₀ … p_{m−1} that are orthonormal for one weight.
pub(super) enum Family<'a> {
    /// Legendre's, for the weight 1; they need no table.
    Legendre,
    /// Jacobi's, for any other weight.
    Jacobi(Table<'a>),
}

impl<'a> Family<'a> {
    /// The polynomials of a weight, as many as there are entries.
    pub(super) fn new(weight: Weight, entries: &'a mut [Entry]) -> Family<'a> {
        if weight == Weight::LEGENDRE {
            Family::Legendre
        } else {
            Family::Jacobi(Table::new(weight, entries))
        }
    }

    /// Writes p₀(x), p₁(x), ….
    pub(super) fn values(&self, x: f64, out: &mut [f64]) {
        match self {
            Family::Legendre => legendre::orthonormal(x, out),
            Family::Jacobi(table) => table.values(x, out),
        }
    }

    /// Writes p₀(x), p₁(x), … and their derivatives.
    pub(super) fn values_with_derivatives(&self, x: f64, out: &mut [f64], slopes: &mut [f64]) {
        match self {
            Family::Legendre => legendre::orthonormal_with_derivatives(x, out, slopes),
            Family::Jacobi(table) => table.values_with_derivatives(x, out, slopes),
        }
    }

    /// P_n/p_n of the classical polynomial P_n.
    pub(super) fn norm(&self, n: usize) -> f64 {
        match self {
            Family::Legendre => 1.0 / legendre::end(n),
            Family::Jacobi(table) => table.norm(n),
        }
    }
}
