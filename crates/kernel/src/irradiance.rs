//! Irradiance at a point from a polygon of even exitance: from all of it (Lambert's formula), or from its
//! visible part; from a ball; through an outline of segments and arcs, or such an outline and a polygon or a
//! disk; and from walls, disks and rings by theirs.

pub mod lambert;
pub mod ball;
pub mod visible_polygon;
pub mod outline;
pub mod within;
pub mod within_polygon;
pub mod within_disk;
pub mod swept;
