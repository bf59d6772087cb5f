//! Area as a discrete measure: points and weights that integrate products of two basis functions over an
//! element,
//!
//! ```text
//! ∫ f g dA = Σ_a w_a f(x_a) g(x_a) ,   w_a > 0 .
//! ```
//!
//! On a flat patch the area element is linear along each direction of the chart, and d + 1 Gauss points per
//! direction are exact for f, g of degree d. On a curved patch the number follows from the spectrum of the
//! area element; where 64 points per direction do not resolve it (at cusps and creases) the worst cell is
//! halved repeatedly, up to a bound.

use super::patch::{Node, Patch};
use super::rule::UnitRule;
use super::spectrum::Spectrum;

/// Most cells that a curved patch is cut into until its area element is resolved: a bound of time, where it
/// has a crease or a pole.
const MOST_CELLS: usize = 64;

/// Coefficients of an area element below this part of its mean are rounding: 45 · 2⁻⁵².
const ROUNDING: f64 = 1e-14;

/// Points of an element with their weights.
#[derive(Clone, Debug)]
pub struct Measure {
    /// All points.
    pub points: Vec<WeightedNode>,
}

/// A point of a sum over area.
#[derive(Clone, Copy, Debug)]
pub struct WeightedNode {
    /// The point.
    pub node: Node,
    /// Its weight: the area for which it stands (scene length²) in an integral, a number in a mean.
    pub weight: f64,
}

impl Measure {
    /// The measure that is exact for products of two functions of `degree` along each direction of the charts
    /// of `patches`.
    pub fn new(patches: &[Patch], degree: usize) -> Self {
        let mut measure = Self { points: Vec::new() };
        for patch in patches {
            if patch.is_flat() {
                measure.add(patch, [degree + 1; 2]);
            } else {
                measure.add_curved(patch, degree);
            }
        }
        measure
    }

    /// Σ w_a, the area (scene length²).
    pub(crate) fn area(&self) -> f64 {
        self.points.iter().map(|point| point.weight).sum()
    }

    fn add_curved(&mut self, patch: &Patch, degree: usize) {
        for (spectrum, cell) in resolved_cells(patch, degree) {
            // More points than the degree needs, since functions with high peaks amplify what lies below
            // rounding.
            self.add(&cell, spectrum.degrees.map(|area| degree + area / 2 + 4 + degree / 4));
        }
    }

    fn add(&mut self, patch: &Patch, points: [usize; 2]) {
        let [along, across] = points.map(UnitRule::of);
        for (s, ws) in along.iter() {
            for (t, wt) in across.iter() {
                let node = patch.node(s, t);
                self.points.push(WeightedNode { node, weight: ws * wt * node.area });
            }
        }
    }
}

/// Cells that cover a curved patch, each with a resolved area element unless there would be too many.
fn resolved_cells(patch: &Patch, degree: usize) -> Vec<(Spectrum, Patch)> {
    // A function of degree d may reach d² times its mean at a collapsed corner, more where the area element
    // vanishes.
    let negligible = ROUNDING * mean_area(patch) / ((degree + 1) as f64).powi(2);
    let resolve = |cell: Patch| (Spectrum::of(&cell, negligible.max(ROUNDING * mean_area(&cell))), cell);
    let mut cells = vec![resolve(patch.clone())];
    while cells.len() < MOST_CELLS {
        let unresolved = cells.iter().enumerate().filter(|(_, (spectrum, _))| !spectrum.is_resolved());
        let worst = unresolved.max_by(|a, b| a.1.0.tail().total_cmp(&b.1.0.tail()));
        let Some(worst) = worst.map(|(index, _)| index) else { break };
        let (spectrum, cell) = cells.swap_remove(worst);
        cells.extend(cell.halves(spectrum.worse()).map(resolve));
    }
    cells
}

/// Area of a patch to a few digits (scene length²).
fn mean_area(patch: &Patch) -> f64 {
    let rule = UnitRule::of(4);
    let row = |(s, ws)| rule.iter().map(|(t, wt)| ws * wt * patch.node(s, t).area).sum::<f64>();
    rule.iter().map(row).sum()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};
    use std::sync::Arc;

    use radiosity_geom::shapes::{Cone, Cylinder, FULL_TURN, Sphere, Torus};
    use radiosity_geom::{DVec3, Rect, Surface};

    use super::*;

    fn whole(surface: impl Surface + 'static) -> Patch {
        Patch::curved(Arc::new(surface), &Rect::FULL)
    }

    #[test]
    fn areas_in_closed_form() {
        let sphere = Sphere::new(DVec3::ONE, 2.0, DVec3::X, [-2.0, 2.0], FULL_TURN).expect("a sphere");
        let torus = Torus::new(DVec3::ONE, DVec3::X, 2.0, 1.9, FULL_TURN, FULL_TURN).expect("a torus");
        for (patch, exact) in [(whole(sphere), 16.0 * PI), (whole(torus), TAU * TAU * 2.0 * 1.9)] {
            for degree in [0, 3, 20] {
                let area = Measure::new(std::slice::from_ref(&patch), degree).area();
                assert!((area - exact).abs() < 1e-13 * exact, "{degree}: {area} {exact}");
            }
        }
    }

    #[test]
    fn the_area_element_of_ruled_shapes_is_a_polynomial() {
        let cylinder = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, FULL_TURN).expect("a cylinder");
        let cone = Cone::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a cone");
        let degrees = |patch: &Patch| Spectrum::of(patch, 1e-14 * mean_area(patch)).degrees;
        assert_eq!(degrees(&whole(cylinder)), [0, 0]);
        assert_eq!(degrees(&whole(cone)), [0, 1]);
    }
}
