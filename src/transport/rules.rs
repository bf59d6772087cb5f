//! Quadrature rules, one for each case of contact (the four of Sauter and Schwab, *Boundary Element Methods*, chapter 5, and those
//! that curved surfaces add): identical, common edge, common vertex, far; near without contact, contours of constants, patches
//! whose horizons cut each other, and flat elements that cover each other.

pub(in crate::transport) mod orders;
pub(in crate::transport) mod far;
pub(in crate::transport) mod near;
pub(in crate::transport) mod contour;
pub(in crate::transport) mod common_edge;
pub(in crate::transport) mod common_vertex;
pub(in crate::transport) mod identical;
pub(in crate::transport) mod horizon;
pub(in crate::transport) mod covering;
