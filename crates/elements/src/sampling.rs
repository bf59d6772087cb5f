//! Quasi-random numbers, and the points and directions that they choose.

pub mod kronecker;
pub mod shift;
pub mod lambert;
pub mod area_preserving_map;
