//! Corners of surfaces, those at one place welded.

use std::collections::HashMap;

use glam::DVec3;
use radiosity_geom::coordinate_rounding;

use crate::model::{Shape, Surface};

/// Corners nearer to each other than this part of the extent are one: some roundings of single precision. Chosen; not
/// tuned.
const NEAR: f64 = 1e-6;

/// Side of a cell over the distance within which corners are one. Chosen; not tuned.
const CELL: f64 = 4.0;

/// The corners of polygons and quads by number.
#[derive(Debug)]
pub(super) struct Corners {
    points: Vec<DVec3>,
    /// The corners of all surfaces one after another, and where those of each begin.
    numbers: Vec<u32>,
    starts: Vec<usize>,
    /// Distance within which corners are one (length).
    pub(super) near: f64,
    /// Extent of all corners (length).
    pub(super) extent: f64,
    /// Rounding of coordinates (length).
    pub(super) rounding: f64,
}

impl Corners {
    /// The corners of `surfaces`, holes behind outlines; curved surfaces have none.
    pub(super) fn welded(surfaces: &[Surface]) -> Corners {
        let (mut all, mut starts) = (Vec::new(), vec![0]);
        for surface in surfaces {
            match &surface.shape {
                Shape::Polygon { outline, holes } => {
                    all.extend(outline.iter().chain(holes.iter().flatten()).copied());
                }
                Shape::Quad(corners) => all.extend(corners),
                _ => {}
            }
            starts.push(all.len());
        }
        let low = all.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        let high = all.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
        let extent = if all.is_empty() { 0.0 } else { low.distance(high) };
        let mut weld = Weld { low, near: NEAR * extent, points: Vec::new(), cells: HashMap::new() };
        let mut exact: HashMap<[u64; 3], u32> = HashMap::new();
        let mut number = |x: &DVec3| {
            // Adding 0 turns −0 into 0.
            let key = (*x + DVec3::ZERO).to_array().map(f64::to_bits);
            *exact.entry(key).or_insert_with(|| weld.number(*x))
        };
        let numbers = all.iter().map(&mut number).collect();
        let rounding = coordinate_rounding(&all, None);
        Corners { numbers, starts, near: weld.near, extent, rounding, points: weld.points }
    }

    /// Number of different corners.
    pub(super) fn count(&self) -> usize {
        self.points.len()
    }

    /// The corners of a surface.
    pub(super) fn of(&self, surface: usize) -> &[u32] {
        &self.numbers[self.starts[surface]..self.starts[surface + 1]]
    }

    /// Where a corner is.
    pub(super) fn point(&self, corner: u32) -> DVec3 {
        self.points[corner as usize]
    }

    /// Where corners are.
    pub(super) fn points(&self, ring: &[u32]) -> Vec<DVec3> {
        ring.iter().map(|corner| self.point(*corner)).collect()
    }
}

/// Welded points in cells. Points that differ are apart by more than `near`, so a cell holds few.
struct Weld {
    low: DVec3,
    near: f64,
    points: Vec<DVec3>,
    cells: HashMap<[i64; 3], Vec<u32>>,
}

impl Weld {
    /// The number of the first point near `x`, or a new one.
    fn number(&mut self, x: DVec3) -> u32 {
        let [low, high] = [-self.near, self.near].map(|reach| self.cell(x + DVec3::splat(reach)));
        for i in low[0]..=high[0] {
            for j in low[1]..=high[1] {
                for k in low[2]..=high[2] {
                    let found = self.cells.get(&[i, j, k]).into_iter().flatten();
                    let near = |number: &&u32| self.points[**number as usize].distance(x) <= self.near;
                    if let Some(number) = found.copied().find(|number| near(&number)) {
                        return number;
                    }
                }
            }
        }
        let number = self.points.len() as u32;
        self.points.push(x);
        let cell = self.cell(x);
        self.cells.entry(cell).or_default().push(number);
        number
    }

    fn cell(&self, x: DVec3) -> [i64; 3] {
        match self.near > 0.0 {
            true => ((x - self.low) / (CELL * self.near)).to_array().map(|c| c.floor() as i64),
            false => [0; 3],
        }
    }
}
