//! Means of irradiance and radiosity over cells of equal parameter size.
//!
//! For each surface and each cell of an m × n cut of [−1, 1]²,
//!
//! ```text
//! mean E = 1/A_cell ∫_{cell ∩ element} E dA ,
//! ```
//!
//! with A_cell the area of the cell within the surface's outer outline, holes included: where something
//! else stands in a hole of the surface nothing arrives, and the mean says so. The integrals are exact
//! for the polynomials on flat surfaces.

use radiosity_geom::{PlanarRegion, Rect, polygon_area};

use crate::elements::cells::cells_of;
use crate::elements::clip_to_cell;
use crate::elements::patch::{Node, Patch};
use crate::elements::rule::UnitRule;
use crate::solution::{Place, Solution};

/// Means over one cell of one surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Index of the surface.
    pub surface: usize,
    /// Place of the cell along u and v.
    pub index: [usize; 2],
    /// Mean irradiance per band (W m⁻²).
    pub irradiance: Vec<f64>,
    /// Mean radiosity per band (W m⁻²).
    pub radiosity: Vec<f64>,
    /// Area of the cell within the outer outline (scene length²).
    pub area: f64,
}

/// The means over `cells` = [along u, along v] of every surface of `solution`, v running fastest.
///
/// Cells without area are left out.
pub fn grid(solution: &Solution, surfaces: usize, cells: [usize; 2]) -> Vec<Cell> {
    let of_surface = |surface| {
        let rects = cells_of(cells).enumerate();
        rects.map(move |(k, rect)| cell(solution, surface, [k / cells[1], k % cells[1]], &rect))
    };
    (0..surfaces).flat_map(of_surface).filter(|cell| cell.area > 0.0).collect()
}

fn cell(solution: &Solution, surface: usize, index: [usize; 2], rect: &Rect) -> Cell {
    let bands = solution.bands();
    let mut sums = vec![0.0; bands.len()];
    let mut radiated = vec![0.0; bands.len()];
    let mut covered = 0.0;
    for element in solution.elements().of_surface(surface) {
        let degree = solution.elements().list()[element].basis.total_degree();
        for patch in solution.elements().patches_over(element, rect) {
            for_each_point(&patch, degree, |node, weight| {
                let place =
                    Place { surface, parameters: node.parameters.to_array(), position: node.position };
                covered += weight;
                for (band, (sum, out)) in sums.iter_mut().zip(&mut radiated).enumerate() {
                    let irradiance = solution.irradiance(band, element, &place);
                    *sum += weight * irradiance;
                    *out += weight * bands[band].coating.radiosity(element, irradiance);
                }
            });
        }
    }
    let area = outer_area(solution, surface, rect).unwrap_or(covered);
    let mean = |sum: Vec<f64>| sum.into_iter().map(|sum| if area > 0.0 { sum / area } else { 0.0 }).collect();
    Cell { surface, index, irradiance: mean(sums), radiosity: mean(radiated), area }
}

fn for_each_point(patch: &Patch, degree: usize, mut visit: impl FnMut(&Node, f64)) {
    let rule = UnitRule::of(if patch.is_flat() { degree / 2 + 2 } else { degree + 4 });
    for (s, ws) in rule.iter() {
        for (t, wt) in rule.iter() {
            let node = patch.node(s, t);
            visit(&node, ws * wt * node.area);
        }
    }
}

/// Area of a cell within the outer outline of a planar surface; None for curved ones.
fn outer_area(solution: &Solution, surface: usize, rect: &Rect) -> Option<f64> {
    let shape = solution.elements().shape(surface);
    let region = shape.region()?;
    let outer = if region.holes().is_empty() {
        region.convex_pieces()
    } else {
        let whole = PlanarRegion::new(region.outer().to_vec(), Vec::new()).ok()?;
        whole.convex_pieces()
    };
    Some(clip_to_cell(shape, &outer, rect).iter().map(|part| polygon_area(part)).sum())
}
