//! Quadrature rules, one for each kind of contact. Identical, common edge, common vertex and far are the four cases of
//! Sauter and Schwab (*Boundary Element Methods*, chapter 5). The others: near pairs, contour integrals of constants,
//! curved patches cut by each other's horizon, and flat elements that lie on each other.

pub(in crate::transport) mod orders;
pub(in crate::transport) mod far;
pub(in crate::transport) mod near;
pub(in crate::transport) mod contour;
pub(in crate::transport) mod common_edge;
pub(in crate::transport) mod common_vertex;
pub(in crate::transport) mod identical;
pub(in crate::transport) mod horizon;
pub(in crate::transport) mod covering;
