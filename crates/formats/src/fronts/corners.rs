//! The corners of bodies by number.

use std::collections::HashMap;

use glam::DVec3;
use radiosity_geom::Aabb;

use crate::model::Model;

/// Corners nearer than this part of the model's extent are one corner: coordinates of single precision are
/// rounded to 6·10⁻⁸ of it. With a larger value small things would hang together with what they stand beside.
const ONE_CORNER: f64 = 1e-7;

/// Corners, of which those nearer than rounding are one.
pub(super) struct Corners {
    cell: f64,
    low: DVec3,
    cells: HashMap<[i64; 3], Vec<usize>>,
    points: Vec<DVec3>,
}

impl Corners {
    /// An empty list of corners for a model, whose extent tells the size of rounding.
    pub(super) fn new(model: &Model) -> Self {
        let outlines = model.surfaces.iter().filter_map(|surface| surface.shape.rings().first().copied());
        let bounds = Aabb::around(outlines.flatten().copied());
        let cell = (ONE_CORNER * bounds.diagonal()).max(f64::MIN_POSITIVE);
        let low = if bounds.is_empty() { DVec3::ZERO } else { bounds.min };
        Corners { cell, low, cells: HashMap::new(), points: Vec::new() }
    }

    /// The number of the corner at a place.
    pub(super) fn take(&mut self, x: DVec3) -> usize {
        let steps = (x - self.low) / self.cell;
        let cell = steps.to_array().map(|step| step.floor() as i64);
        // Of the cells beside it only those within reach.
        let reach = |axis: usize| {
            let part = steps[axis] - steps[axis].floor();
            if part < 0.5 { [0, -1] } else { [0, 1] }
        };
        let [i, j, k] = [0, 1, 2].map(reach);
        for [a, b, c] in i.iter().flat_map(|a| j.iter().flat_map(|b| k.map(|c| [*a, *b, c]))) {
            let near = [cell[0].saturating_add(a), cell[1].saturating_add(b), cell[2].saturating_add(c)];
            let mut known = self.cells.get(&near).into_iter().flatten();
            if let Some(corner) = known.find(|corner| self.points[**corner].distance(x) <= 0.5 * self.cell) {
                return *corner;
            }
        }
        self.points.push(x);
        self.cells.entry(cell).or_default().push(self.points.len() - 1);
        self.points.len() - 1
    }
}
