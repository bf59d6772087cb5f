//! An emitter cut into cells that are small beside their distance from a point: targets for rays where it is
//! near.
//!
//! The square of numbers that chooses points of the emitter ([`AreaPreservingMap`]) is quartered until each
//! cell is at most half as large as it is far away. A cell of the share w² of the square, at the distance d,
//! gets the share p ∝ w² (κ + 0.2/(π d²)) of the rays, with the largest kernel κ of its corners and its
//! middle, and their values the weight w²/p.

use std::f64::consts::PI;

use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::Node;
use radiosity_elements::sampling::area_preserving_map::AreaPreservingMap;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::shifted;
use smallvec::{SmallVec, smallvec};

use crate::receiver_point::ReceiverPoint;
use crate::tolerances::MOST_QUARTERINGS_OF_LAMP;

/// Radius of a cell over its distance, at most.
const NEAR: f64 = 0.5;

/// Least part of the kernel face on that counts: a cell whose corners face away may yet be seen. Chosen.
const HIDDEN: f64 = 0.2;

/// Cells of an emitter as seen from a point.
#[derive(Debug)]
pub(super) struct LampCells<'a> {
    area_map: &'a AreaPreservingMap,
    cells: SmallVec<[Cell; 1]>,
    /// Sum of the p before they add up to 1.
    all: f64,
}

/// A square of the numbers that choose points.
#[derive(Debug)]
struct Cell {
    corner: [f64; 2],
    width: f64,
    /// w² (κ + 0.2/(π d²)), up to this cell and with it.
    end: f64,
}

impl<'a> LampCells<'a> {
    /// The whole emitter in one cell.
    pub(super) fn whole(area_map: &'a AreaPreservingMap) -> Self {
        Self { area_map, cells: smallvec![Cell { corner: [0.0; 2], width: 1.0, end: 1.0 }], all: 1.0 }
    }

    /// Cells that are small as seen from a point.
    pub(super) fn near(area_map: &'a AreaPreservingMap, receiver: &ReceiverPoint) -> Self {
        let mut cells = Self { area_map, cells: SmallVec::new(), all: 0.0 };
        cells.divide(receiver, [0.0; 2], 0);
        cells
    }

    fn divide(&mut self, receiver: &ReceiverPoint, corner: [f64; 2], depth: u32) {
        let width = 0.5_f64.powi(depth as i32);
        let at = |[s, t]: [f64; 2]| self.area_map.point([corner[0] + s * width, corner[1] + t * width]).node;
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let (middle, ends) = (at([0.5; 2]), corners.map(at));
        let radius = ends.iter().map(|end| end.position.distance(middle.position)).fold(0.0, f64::max);
        let distance = middle.position.distance(receiver.position);
        if radius > NEAR * distance && depth < MOST_QUARTERINGS_OF_LAMP {
            for [s, t] in corners {
                let corner = [corner[0] + 0.5 * s * width, corner[1] + 0.5 * t * width];
                self.divide(receiver, corner, depth + 1);
            }
            return;
        }
        let face_on = 1.0 / (PI * distance.max(radius).max(f64::MIN_POSITIVE).powi(2));
        let kernel = |node: &Node| receiver.kernel_to(node).unwrap_or(0.0).min(face_on);
        let largest = ends.iter().chain([&middle]).map(kernel).fold(0.0, f64::max);
        self.all += width * width * (largest + HIDDEN * face_on);
        self.cells.push(Cell { corner, width, end: self.all });
    }

    /// The target of a ray, and its weight in the mean over the emitter.
    pub(super) fn target(&self, index: u64, offset: &[f64; 3]) -> WeightedNode {
        if let [cell] = &self.cells[..] {
            let [s, t, _] = *offset;
            return self.area_map.point(cell.point(shifted(kronecker::point(index), &[s, t])));
        }
        let [choice, s, t] = shifted(kronecker::point(index), offset);
        let place =
            self.cells.partition_point(|cell| cell.end <= choice * self.all).min(self.cells.len() - 1);
        let cell = &self.cells[place];
        let before = place.checked_sub(1).map_or(0.0, |before| self.cells[before].end);
        let share = (cell.end - before) / self.all;
        let WeightedNode { node, weight } = self.area_map.point(cell.point([s, t]));
        WeightedNode { node, weight: weight * cell.width.powi(2) / share }
    }
}

impl Cell {
    fn point(&self, [s, t]: [f64; 2]) -> [f64; 2] {
        [self.corner[0] + s * self.width, self.corner[1] + t * self.width]
    }
}
