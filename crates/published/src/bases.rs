//! Bases: the functions whose sums the irradiance of a surface is.
//!
//! The variational form (Szirmay-Kalos 1996) takes any functions f_1 … f_m on the surfaces. Beside Legendre
//! polynomials on each element there are the three of that source:
//!
//! ```text
//! constant    1 on one cell of the surface, 0 elsewhere
//! linear      tents: bilinear between the corners of the cells, 1 at one corner, 0 at all others
//! harmonic    cos(i π u) cos(j π v) over the whole surface, (u, v) ∈ [0, 1]²
//! ```
//!
//! Each spans a [subspace] of polynomials on elements: constants of those of order 0, tents of those of total
//! degree 2, cosines of those of an order at which their expansion has ended ([`basis`]). So their transfers
//! follow from the blocks G between these elements, which are integrated as ever, and their sums are read as
//! polynomials.
//!
//! Reference: L. Szirmay-Kalos, *Application of variational calculus in the radiosity method*, Periodica
//! Polytechnica El. Eng. 40 (1996), 123–138.

mod functions;
mod cells;
mod tents;
mod cosines;
pub mod basis;
mod projection;
pub mod subspace;

pub use basis::Basis;
pub use functions::SurfaceFunctions;
pub use projection::Projection;
pub use subspace::Subspace;
