//! How many points a rule needs: from analyticity, from charts, by trial, and by subdividing the cube of integration.

pub(in crate::transport) mod analyticity;
pub(in crate::transport) mod subdivided_cube;
pub(in crate::transport) mod chart_orders;
pub(in crate::transport) mod by_trial;
