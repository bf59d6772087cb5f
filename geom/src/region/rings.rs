//! An outline and its holes in a plane: what they cover, and whether they are simple and nested as they
//! should be.

use glam::DVec2;

use super::places::Places;
use super::ring::Ring;
use crate::tolerances::COINCIDENT;
use crate::{Aabb, ShapeError};

/// An outline and its holes.
#[derive(Clone, Debug)]
pub(super) struct Rings {
    /// The outline first.
    list: Vec<Ring>,
    places: Places,
}

impl PartialEq for Rings {
    fn eq(&self, other: &Self) -> bool {
        self.list == other.list
    }
}

impl Rings {
    /// The vertices of the outline, then of each hole.
    pub(super) fn new(rings: impl IntoIterator<Item = Vec<DVec2>>) -> Self {
        let list: Vec<Ring> = rings.into_iter().map(Ring::new).collect();
        let places = Places::new(list.iter().map(Ring::bounds));
        Self { list, places }
    }

    /// The rings with other vertices.
    pub(super) fn map(&self, other: impl Fn(&[DVec2]) -> Vec<DVec2>) -> Self {
        Self::new(self.list.iter().map(|ring| other(ring.points())))
    }

    pub(super) fn outline(&self) -> &Ring {
        &self.list[0]
    }

    /// The vertices of the outline, then of each hole.
    pub(super) fn points(&self) -> impl Iterator<Item = &[DVec2]> {
        self.list.iter().map(Ring::points)
    }

    /// Area of the outline without clockwise holes.
    pub(super) fn area(&self) -> f64 {
        self.list.iter().map(Ring::signed_area).sum()
    }

    /// Whether `at` lies inside, or up to a distance on a ring.
    pub(super) fn covers(&self, at: DVec2, tolerance: f64) -> bool {
        let may_touch = |b: &Aabb| b.inflate(tolerance).contains(at.extend(0.0));
        self.number_around(at) == 1
            || self.places.any(may_touch, |ring| self.list[ring].touches(at, tolerance))
    }

    /// Whether `at` lies inside the outline and outside all holes.
    pub(super) fn enclose(&self, at: DVec2) -> bool {
        self.outline().encloses(at) && self.number_around(at) == 1
    }

    /// The number of rings that enclose `at`.
    fn number_around(&self, at: DVec2) -> usize {
        let mut around = 0;
        self.places.any(
            |b| b.contains(at.extend(0.0)),
            |ring| {
                around += usize::from(self.list[ring].encloses(at));
                false
            },
        );
        around
    }

    /// Every ring simple, every hole inside the outline and apart from the others.
    pub(super) fn check(&self, names: &[String], extent: f64) -> Result<(), ShapeError> {
        let tolerance = COINCIDENT * extent;
        for (ring, name) in self.list.iter().zip(names) {
            if ring.signed_area().abs() <= tolerance * extent {
                return Err(ShapeError::NoArea { field: name.clone() });
            }
            if let Some((first, second)) = ring.self_contact(tolerance) {
                return Err(ShapeError::SelfCrossing { field: name.clone(), first, second });
            }
        }
        let outline = self.outline();
        for (k, hole) in self.list.iter().enumerate().skip(1) {
            let strays = |at: DVec2| !outline.encloses(at) && !outline.touches(at, tolerance);
            if hole.crosses(outline, tolerance) || hole.samples().any(strays) {
                return Err(ShapeError::HoleOutside { field: names[k].clone() });
            }
            let near = self.places.near(&hole.bounds().inflate(tolerance));
            let earlier = near.into_iter().filter(|other| (1..k).contains(other));
            if let Some(other) =
                earlier.into_iter().find(|other| hole.overlaps(&self.list[*other], tolerance))
            {
                return Err(ShapeError::HolesOverlap {
                    field: names[k].clone(),
                    other: names[other].clone(),
                });
            }
        }
        Ok(())
    }
}
