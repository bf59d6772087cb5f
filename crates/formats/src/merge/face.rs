//! Faces that may be merged: flat polygons without holes.

use std::collections::HashMap;

use glam::DVec3;
use radiosity_fit::outline::{extent, unevenness};
use radiosity_geom::NO_AREA;
use radiosity_geom::area_vector;

use super::corners::Corners;
use crate::model::{Shape, Sides, Surface};
use crate::tolerances::{PLANARITY_OF_FACE, ROUNDINGS_OF_FACE, TILT_OF_FACES};

/// Largest tilt (radians) that rounding explains: narrow faces are tilted by it. With a larger value slivers
/// would join faces at an angle that shows; with a smaller one narrow faces stay by themselves.
const MOST_ROUNDED: f64 = 1e-2;

/// A flat polygon without holes.
#[derive(Debug)]
pub(super) struct Face {
    /// Index of its surface.
    pub(super) surface: usize,
    /// Number of the face's object, material and kind of sides; faces of one key may be merged.
    pub(super) key: usize,
    /// Numbers of the corners, neighbours different.
    pub(super) ring: Vec<u32>,
    /// Unit normal of its front.
    pub(super) normal: DVec3,
    /// Area of the face (length²), and its extent (length).
    pub(super) area: f64,
    pub(super) extent: f64,
    /// Rounding of its corners (length).
    pub(super) rounding: f64,
    /// Tilt that rounding may have given it (radians).
    tilt: f64,
}

impl Face {
    /// All faces without holes that are flat and have an area.
    pub(super) fn all(surfaces: &[Surface], objects: &[usize], corners: &Corners) -> Vec<Face> {
        let mut keys: HashMap<(usize, Option<usize>, u8), usize> = HashMap::new();
        let mut faces = Vec::new();
        for (index, (surface, object)) in surfaces.iter().zip(objects).enumerate() {
            let is_plain = matches!(&surface.shape, Shape::Polygon { holes, .. } if holes.is_empty());
            if !is_plain {
                continue;
            }
            let sides = match surface.sides {
                Sides::Front => 0,
                Sides::Both => 1,
                Sides::Open => 2,
            };
            let next = keys.len();
            let key = *keys.entry((*object, surface.material, sides)).or_insert(next);
            faces.extend(Face::of(index, key, corners));
        }
        faces
    }

    /// The face of a surface; none if it has no area or is not flat.
    fn of(surface: usize, key: usize, corners: &Corners) -> Option<Face> {
        let mut ring = corners.of(surface).to_vec();
        ring.dedup();
        while ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        if ring.len() < 3 {
            return None;
        }
        let points = corners.points(&ring);
        let (extent, area_vector) = (extent(&points), area_vector(&points));
        let (area, rounding) = (area_vector.length(), corners.rounding(&ring));
        let is_flat = unevenness(&points) <= (PLANARITY_OF_FACE * extent).max(ROUNDINGS_OF_FACE * rounding);
        if area.is_nan() || area <= NO_AREA * extent * extent || !is_flat {
            return None;
        }
        let tilt = ROUNDINGS_OF_FACE * rounding * extent / area;
        Some(Face { surface, key, ring, normal: area_vector / area, area, extent, rounding, tilt })
    }

    /// Whether its plane has the direction of another's plane.
    pub(super) fn is_level_with(&self, other: &Face) -> bool {
        let rounded = (self.tilt + other.tilt).min(MOST_ROUNDED);
        self.normal.distance(other.normal) <= TILT_OF_FACES + rounded
    }
}
