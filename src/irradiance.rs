//! Irradiance at a point from a polygon of even exitance: from all of it (Lambert's formula), or from its visible part.

pub(crate) mod lambert;
pub mod visible_polygon;
