//! Quasi-random numbers, and the points and directions that they choose.

pub(crate) mod kronecker;
pub(crate) mod shift;
pub(crate) mod lambert;
pub(crate) mod spread;
