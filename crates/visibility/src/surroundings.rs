//! Surroundings of a point: what is met first in directions evenly about it.
//!
//! A point in a room meets fronts alone, but for sheets of one side. One outside meets backs of walls, or nothing; one
//! in a solid backs, and the front of what the solid stands on.

use radiosity_geom::{DVec3, Ray};
use serde::{Deserialize, Serialize};

use crate::{Visibility, golden_spiral};

/// Directions about a point. Chosen: a hole of a tenth of them is seen, and they take some microseconds.
const DIRECTIONS: usize = 64;

/// Numbers of the directions from a point in which something is met first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Surroundings {
    /// A front, either side of a sheet with two sides among them.
    pub fronts: u32,
    /// The back of a surface of one side.
    pub backs: u32,
}

impl Visibility {
    /// The surroundings of `point`; one on the front of a surface with this unit normal meets that front in the half of
    /// the directions behind it.
    pub fn surroundings(&self, point: DVec3, on: Option<(usize, DVec3)>) -> Surroundings {
        let mut found = Surroundings::default();
        for direction in (0..DIRECTIONS).map(|place| golden_spiral::direction(place, DIRECTIONS)) {
            let front = match on {
                Some((_, normal)) if direction.dot(normal) <= 0.0 => Some(true),
                Some((surface, _)) => self.nearest_from(surface, point, direction).map(|met| met.front),
                None => self.nearest(&Ray::new(point, direction)).map(|met| met.front),
            };
            match front {
                Some(true) => found.fronts += 1,
                Some(false) => found.backs += 1,
                None => (),
            }
        }
        found
    }
}
