//! Orthogonal polynomials and Gauss rules, without std and without allocation.
//!
//! Everything here works on caller slices or on arrays of constant length; nothing is allocated, and
//! the rules of constant length are computed by the compiler:
//!
//! ```
//! use radiosity_core::gauss::Legendre;
//!
//! // ∫₋₁¹ x⁴ dx = 2/5, exact because 4 ≤ 2·3 − 1.
//! let integral: f64 = Legendre::<3>::NODES.iter().zip(Legendre::<3>::WEIGHTS).map(|(x, w)| w * x.powi(4)).sum();
//! assert!((integral - 0.4).abs() < 1e-15);
//! ```
//!
//! Each module uses those before it: [`recurrence`] (three-term tables, tiles, sums), [`jacobi`] (weights and
//! orthonormal polynomials), [`gauss`] (rules), [`legendre`] (the case α = β = 0, its tiles and matrices),
//! [`basis`] (squares and triangles), [`convert`] (Jacobi coefficients to Legendre); [`dot()`] and [`norm`]
//! use none.
#![no_std]

#[cfg(test)]
extern crate std;

mod double;
mod math;

mod dot;

pub mod recurrence;

pub mod jacobi;

pub mod gauss;

pub mod legendre;

pub mod basis;

pub mod convert;

pub use dot::{dot, norm};
