//! Irradiance at a point from a polygon of even exitance: from all of it (Lambert's formula), or from its
//! visible part; and from a ball.

pub mod lambert;
pub mod ball;
pub mod visible_polygon;
