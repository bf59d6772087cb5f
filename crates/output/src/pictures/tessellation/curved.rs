//! Curved surfaces: a grid of their parameters, doubled along u, along v or both until chords are close.

use radiosity_geom::{DVec3, Surface};

use super::corner::Corner;

/// Most cells along a parameter. Chosen.
const FINEST: usize = 512;

/// The cells of a curved surface, two triangles each, such that the middles of their sides and their own lie
/// within `tolerance` (scene length) of the surface's points there.
pub(super) fn facets(shape: &dyn Surface, tolerance: f64) -> Vec<Vec<Corner>> {
    let mut cells = [1, 1];
    loop {
        let grid = Grid { shape, cells };
        let [along, across, inside] = grid.errors();
        let too_coarse = match [along > tolerance, across > tolerance] {
            [false, false] => [inside > tolerance; 2],
            sides => sides,
        };
        let finer = [0, 1].map(|axis| (cells[axis] << usize::from(too_coarse[axis])).min(FINEST));
        if finer == cells {
            return grid.facets();
        }
        cells = finer;
    }
}

struct Grid<'a> {
    shape: &'a dyn Surface,
    /// Number of cells along u and along v.
    cells: [usize; 2],
}

impl Grid<'_> {
    /// The point at a place that is counted in cells.
    fn at(&self, i: f64, j: f64) -> Corner {
        let parameters = [2.0 * i / self.cells[0] as f64 - 1.0, 2.0 * j / self.cells[1] as f64 - 1.0];
        Corner { position: self.shape.jet(parameters[0], parameters[1]).position, parameters }
    }

    fn places(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let [columns, rows] = self.cells;
        (0..rows).flat_map(move |j| (0..columns).map(move |i| [i as f64, j as f64]))
    }

    /// Greatest distances (scene length) of middles of sides along u, of sides along v, and of cells.
    fn errors(&self) -> [f64; 3] {
        let point = |i: f64, j: f64| self.at(i, j).position;
        let apart = |a: DVec3, b: DVec3, middle: DVec3| middle.distance(a.midpoint(b));
        let cell = |[i, j]: [f64; 2]| {
            let (low, beside, above) = (point(i, j), point(i + 1.0, j), point(i, j + 1.0));
            let high = point(i + 1.0, j + 1.0);
            [
                apart(low, beside, point(i + 0.5, j)).max(apart(above, high, point(i + 0.5, j + 1.0))),
                apart(low, above, point(i, j + 0.5)).max(apart(beside, high, point(i + 1.0, j + 0.5))),
                apart(low, high, point(i + 0.5, j + 0.5)),
            ]
        };
        let larger = |a: [f64; 3], b: [f64; 3]| [a[0].max(b[0]), a[1].max(b[1]), a[2].max(b[2])];
        self.places().map(cell).fold([0.0; 3], larger)
    }

    fn facets(&self) -> Vec<Vec<Corner>> {
        let around = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let cell = |[i, j]: [f64; 2]| around.map(|[x, y]| self.at(i + x, j + y)).to_vec();
        self.places().map(cell).collect()
    }
}
