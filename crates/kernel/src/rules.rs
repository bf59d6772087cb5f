//! Quadrature rules, one for each kind of contact. Identical, common edge, common vertex and far are the four
//! cases of Sauter and Schwab (*Boundary Element Methods*, chapter 5). The others: near pairs, contour
//! integrals of constants, curved patches cut by each other's horizon, flat elements that lie on each other,
//! what is seen of the inside of a sphere from itself, and coaxial surfaces of revolution past a cylinder.

pub mod orders;
pub mod far;
pub mod near;
pub mod contour;
pub mod common_edge;
pub mod common_vertex;
pub mod identical;
pub mod coaxial;
pub mod zone;
pub mod horizon;
pub mod covering;
