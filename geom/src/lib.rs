//! Curved parametric surfaces used as they are: jets, ray hits, contacts.
//!
//! A [`Surface`] maps parameters u, v ∈ [−1, 1]² to points of space. It is never tessellated: its jet
//! (position, tangents, normal, area element) is exact at every parameter, and a ray meets the surface
//! itself. The front is the side that x_u × x_v points to.
//!
//! ```
//! use radiosity_geom::{DVec3, Ray, Surface, shapes::{FULL_TURN, Torus}};
//!
//! let ring = Torus::new(DVec3::ZERO, DVec3::Z, 2.0, 0.5, FULL_TURN, FULL_TURN)?;
//! let hit = ring.intersect(&Ray::new(DVec3::new(-9.0, 0.0, 0.0), DVec3::X)).expect("the ring is in the way");
//! assert!((hit.t - 6.5).abs() < 1e-12);
//! assert!(ring.jet(hit.u, hit.v).normal.distance(-DVec3::X) < 1e-12);
//! # Ok::<(), radiosity_geom::ShapeError>(())
//! ```
//!
//! The modules stand in groups; each imports only from groups above its own.

mod tolerances;

mod aabb;
mod arc;
mod bernstein;
mod clip;
mod hull;
mod layers;
mod plane;
mod ray;
mod rect;
mod separated;
mod shape_error;

mod motion;
mod roots;
mod rounding;
mod slabs;
mod touch;
mod zeros;

mod bvh;
mod outline;
mod region;
mod tangent_planes;

mod convex_solid;

mod meridian;

mod surface;

mod ray_tree;

mod patch;

mod adjacency;

mod flipped;
mod placed;
mod shared;
pub mod shapes;

pub use aabb::Aabb;
pub use adjacency::Adjacency;
pub use bvh::Bvh;
pub use clip::{
    area_vector, clip_by_heights, clip_polygon, difference, distance_to_segment, holds, intersection,
    overhang, polygon_area, polygon_width, sides,
};
pub use convex_solid::ConvexSolid;
pub use flipped::Flipped;
pub use glam::{DQuat, DVec2, DVec3};
pub use hull::extreme_points;
pub use layers::{SAME_AREA, layer_order};
pub use meridian::Meridian;
pub use motion::Motion;
pub use outline::Outline;
pub use patch::{Border, Patch};
pub use placed::Placed;
pub use plane::Plane;
pub use ray::{Hit, Ray};
pub use ray_tree::{Encounter, RayTree};
pub use rect::Rect;
pub use region::PlanarRegion;
pub use roots::{bernstein as bernstein_roots, quadratic};
pub use rounding::{coordinate_rounding, unit_roundoff};
pub use separated::{separated, separates, separating};
pub use shape_error::ShapeError;
pub use surface::{Foot, Jet, Surface};
pub use tangent_planes::TangentPlanes;
pub use tolerances::{
    COINCIDENT, LOOSE, NO_AREA, PARALLEL_DIRECTIONS, PARALLEL_PLANES, PLANARITY, ROUNDING, ROUNDING_OF_AREAS,
    ROUNDINGS_OF_PLANE, ROUNDOFF_OF_DOUBLE,
};
pub use touch::touching;
