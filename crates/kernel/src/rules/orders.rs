//! Numbers of points of rules: from analyticity, from charts, by trial, and by subdividing the cube of
//! integration.

pub(crate) mod analyticity;
pub(crate) mod subdivided_cube;
pub mod chart_orders;
pub mod by_trial;
