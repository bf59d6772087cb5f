//! Curved parametric surfaces used as they are: jets, ray hits, contacts.
//!
//! A [`Surface`] maps parameters u, v ∈ [−1, 1]² to points of space. It is never tessellated: its jet (position, tangents,
//! normal, area element) is exact at every parameter, and a ray meets the surface itself. The front is the side that
//! x_u × x_v points to.
//!
//! The modules stand in the order of the nouns they define, and each imports only from those above it.

mod aabb;
mod bernstein;
mod clip;
mod ray;
mod rect;
mod region;
mod roots;
mod separated;
mod shape_error;
mod surface;
mod zeros;

mod bvh;
mod flipped;
pub mod shapes;

pub use aabb::Aabb;
pub use bvh::Bvh;
pub use clip::clip_polygon;
pub use flipped::Flipped;
pub use glam::{DVec2, DVec3};
pub use ray::{Hit, Ray};
pub use rect::Rect;
pub use region::PlanarRegion;
pub use separated::separated;
pub use shape_error::ShapeError;
pub use surface::{Foot, Jet, Surface};
