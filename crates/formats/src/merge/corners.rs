//! Corners of surfaces, those at one place welded.
//!
//! Two corners are at one place if they differ by what rounding leaves of the coordinates of either's
//! surface, in the precision of its object. What else is in the file, and how large it is, does not matter.

use std::collections::HashMap;

use glam::DVec3;
use radiosity_geom::{Aabb, Bvh, sides, unit_roundoff};

use crate::model::Surface;
use crate::tolerances::ROUNDINGS_OF_CORNERS;

/// Part of the shortest side at a corner that its place may be uncertain by: both ends of a side together
/// leave half of it, and it does not vanish.
const OF_SIDE: f64 = 0.25;

/// The corners of polygons and quads by number.
#[derive(Debug)]
pub(super) struct Corners {
    /// The first corner of each number (length), and its rounding (length).
    points: Vec<DVec3>,
    roundings: Vec<f64>,
    /// The corners of all surfaces one after another, their numbers, and where those of each surface begin.
    given: Vec<DVec3>,
    numbers: Vec<u32>,
    starts: Vec<usize>,
}

impl Corners {
    /// The corners of `surfaces`, holes behind outlines; curved surfaces have none. `objects` names the
    /// object of each.
    pub(super) fn welded(surfaces: &[Surface], objects: &[usize]) -> Corners {
        let (mut given, mut starts) = (Vec::new(), vec![0]);
        for surface in surfaces {
            surface.shape.rings().into_iter().for_each(|ring| given.extend(ring));
            starts.push(given.len());
        }
        let mut places = Places::default();
        let roundoffs = roundoffs(&given, &starts, objects);
        let mut numbers = Vec::with_capacity(given.len());
        for (surface, object) in surfaces.iter().zip(objects) {
            let rings = surface.shape.rings();
            let size = |x: &DVec3| x.abs().element_sum();
            let rounding = roundoffs[*object] * rings.iter().copied().flatten().map(size).fold(0.0, f64::max);
            for ring in rings {
                numbers.extend(shortest(ring).zip(ring).map(|(side, x)| places.take(*x, rounding, side)));
            }
        }
        let firsts = places.welded();
        let (points, roundings) = (places.points, places.roundings);
        let numbers = numbers.into_iter().map(|place: u32| firsts[place as usize]).collect();
        Corners { points, roundings, given, numbers, starts }
    }

    /// Numbers are below this.
    pub(super) fn count(&self) -> usize {
        self.points.len()
    }

    /// The corners of a surface.
    pub(super) fn of(&self, surface: usize) -> &[u32] {
        &self.numbers[self.range(surface)]
    }

    /// The corners of surfaces as they were given: of those at one place the first.
    pub(super) fn given(&self, surfaces: &[usize]) -> HashMap<u32, DVec3> {
        let mut given = HashMap::new();
        for range in surfaces.iter().map(|surface| self.range(*surface)) {
            for (number, x) in self.numbers[range.clone()].iter().zip(&self.given[range]) {
                given.entry(*number).or_insert(*x);
            }
        }
        given
    }

    fn range(&self, surface: usize) -> std::ops::Range<usize> {
        self.starts[surface]..self.starts[surface + 1]
    }

    /// Position of a corner (length).
    pub(super) fn point(&self, corner: u32) -> DVec3 {
        self.points[corner as usize]
    }

    /// Positions of the corners of a ring (length).
    pub(super) fn points(&self, ring: &[u32]) -> Vec<DVec3> {
        ring.iter().map(|corner| self.point(*corner)).collect()
    }

    /// The largest rounding of these corners (length): of the smallest surface that has each.
    pub(super) fn rounding(&self, ring: &[u32]) -> f64 {
        ring.iter().map(|corner| self.roundings[*corner as usize]).fold(0.0, f64::max)
    }
}

/// The unit roundoff of each object.
fn roundoffs(given: &[DVec3], starts: &[usize], objects: &[usize]) -> Vec<f64> {
    let count = objects.iter().max().map_or(0, |last| last + 1);
    let mut points: Vec<Vec<DVec3>> = vec![Vec::new(); count];
    for (object, range) in objects.iter().zip(starts.windows(2)) {
        points[*object].extend(&given[range[0]..range[1]]);
    }
    points.iter().map(|points| unit_roundoff(points)).collect()
}

/// Length of the shorter side at each corner of a ring; sides of no length are left out.
fn shortest(ring: &[DVec3]) -> impl Iterator<Item = f64> {
    let length = |[x, y]: [DVec3; 2]| match x.distance(y) {
        0.0 => f64::INFINITY,
        length => length,
    };
    let lengths: Vec<f64> = sides(ring).map(length).collect();
    let count = lengths.len();
    (0..count).map(move |k| lengths[k].min(lengths[(k + count - 1) % count]))
}

/// Different points, with what is known of the surfaces that have a corner there.
#[derive(Debug, Default)]
struct Places {
    known: HashMap<[u64; 3], u32>,
    points: Vec<DVec3>,
    /// The smallest rounding, and the shortest side (lengths).
    roundings: Vec<f64>,
    shortest: Vec<f64>,
}

impl Places {
    /// The number of a corner of a surface with this rounding.
    fn take(&mut self, x: DVec3, rounding: f64, side: f64) -> u32 {
        // Adding 0 turns −0 into 0.
        let key = (x + DVec3::ZERO).to_array().map(f64::to_bits);
        let next = self.points.len() as u32;
        let number = *self.known.entry(key).or_insert(next);
        if number == next {
            self.points.push(x);
            self.roundings.push(f64::INFINITY);
            self.shortest.push(f64::INFINITY);
        }
        let at = number as usize;
        self.roundings[at] = self.roundings[at].min(rounding);
        self.shortest[at] = self.shortest[at].min(side);
        number
    }

    /// Index of the first point that each point is one with.
    fn welded(&self) -> Vec<u32> {
        let reach = |at: usize| (ROUNDINGS_OF_CORNERS * self.roundings[at]).min(OF_SIDE * self.shortest[at]);
        let boxes: Vec<Aabb> = self.points.iter().map(|x| Aabb { min: *x, max: *x }).collect();
        let tree = Bvh::build(&boxes);
        let mut firsts: Vec<u32> = (0..self.points.len() as u32).collect();
        for (at, x) in self.points.iter().enumerate() {
            let mut first = at;
            tree.overlapping(&boxes[at].inflate(reach(at)), |other| {
                let is_first = other < first && firsts[other] as usize == other;
                if is_first && self.points[other].distance(*x) <= reach(at).min(reach(other)) {
                    first = other;
                }
            });
            firsts[at] = first as u32;
        }
        firsts
    }
}
