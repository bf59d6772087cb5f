//! Irradiance at a point from polygons that shine evenly: Lambert's form, of all of a polygon and of its visible part.

pub(crate) mod lambert;
pub mod visible_polygon;
