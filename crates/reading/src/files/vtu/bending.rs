//! Cells near enough to a curved patch, by the distance of the polynomials through the cells' nodes from it.
//!
//! With (p + 1)² even nodes the interpolant's error is largest about half-way between nodes next to the
//! sides. It is measured at all points half-way between nodes along one direction or both.

use radiosity_elements::patch::{Direction, Patch};
use radiosity_geom::DVec3;

/// Distance from the surface, over the extent of the element, up to which a cell is near enough. Chosen:
/// finer than a pixel of any picture.
const NEAR: f64 = 1e-6;

/// Degree up to which a cell is tried before it is cut. Chosen: a turn of 45° is then good to 1e-6 of its
/// radius.
const CURVED_DEGREE: usize = 5;

/// Most cells of an element: at creases no cut is fine enough. Chosen.
const MOST_CELLS: usize = 1024;

/// Cells over a patch, of one degree.
pub(super) struct BentCells {
    pub(super) degree: usize,
    pub(super) cells: Vec<Patch>,
    /// Greatest distance from the surface found (scene length).
    pub(super) deviation: f64,
}

impl BentCells {
    /// The cells of `patch`, of at least `least` ≥ 1 degrees; `extent` is that of the element (scene length).
    pub(super) fn over(patch: &Patch, least: usize, extent: f64) -> Self {
        let near = NEAR * extent;
        let whole = |degree: usize| (degree, Deviation::of(patch, degree));
        let degrees = least..=least.max(CURVED_DEGREE);
        if let Some((degree, found)) = degrees.map(whole).find(|(_, found)| found.largest <= near) {
            return Self { degree, cells: vec![patch.clone()], deviation: found.largest };
        }
        let degree = least.max(CURVED_DEGREE);
        let mut bent = Self { degree, cells: Vec::new(), deviation: 0.0 };
        let mut waiting = vec![patch.clone()];
        while let Some(cell) = waiting.pop() {
            let found = Deviation::of(&cell, degree);
            if found.largest <= near || bent.cells.len() + waiting.len() >= MOST_CELLS {
                bent.deviation = bent.deviation.max(found.largest);
                bent.cells.push(cell);
            } else {
                waiting.extend(cell.halves(found.worse));
            }
        }
        bent
    }
}

/// The distance of an interpolant from its patch.
struct Deviation {
    largest: f64,
    /// The direction along which the distance is larger.
    worse: Direction,
}

impl Deviation {
    fn of(patch: &Patch, degree: usize) -> Self {
        let weights = half_way(degree);
        let position = |s: f64, t: f64| patch.node(s, t).position;
        let node = |k: usize| k as f64 / degree as f64;
        let middle = |k: usize| (k as f64 + 0.5) / degree as f64;
        // Along s at the nodes of t, along t at the nodes of s, and half-way between both: rows by s.
        let nodes: Vec<Vec<DVec3>> =
            (0..=degree).map(|i| (0..=degree).map(|j| position(node(i), node(j))).collect()).collect();
        let along: Vec<Vec<DVec3>> = weights.iter().map(|own| mixed(own, &nodes)).collect();
        let across: Vec<Vec<DVec3>> = nodes.iter().map(|row| between(&weights, row)).collect();
        let both: Vec<Vec<DVec3>> = along.iter().map(|row| between(&weights, row)).collect();
        let distance = |rows: &[Vec<DVec3>], s: &dyn Fn(usize) -> f64, t: &dyn Fn(usize) -> f64| {
            let row = |(i, row): (usize, &Vec<DVec3>)| {
                row.iter().enumerate().map(|(j, x)| x.distance(position(s(i), t(j)))).fold(0.0, f64::max)
            };
            rows.iter().enumerate().map(row).fold(0.0, f64::max)
        };
        let along = distance(&along, &middle, &node);
        let across = distance(&across, &node, &middle);
        let largest = distance(&both, &middle, &middle).max(along).max(across);
        let worse = if along >= across { Direction::Along } else { Direction::Across };
        Self { largest, worse }
    }
}

/// L_i((k + ½)/p) in row k and column i, of the polynomials that are 1 at the node i/p and 0 at the others.
fn half_way(degree: usize) -> Vec<Vec<f64>> {
    let weight = |k: usize, i: usize| {
        let others = (0..=degree).filter(|j| *j != i);
        others.map(|j| (k as f64 + 0.5 - j as f64) / (i as f64 - j as f64)).product()
    };
    (0..degree).map(|k| (0..=degree).map(|i| weight(k, i)).collect()).collect()
}

/// Σ_i weights[i] · rows[i].
fn mixed(weights: &[f64], rows: &[Vec<DVec3>]) -> Vec<DVec3> {
    let column = |j: usize| rows.iter().zip(weights).map(|(row, weight)| row[j] * *weight).sum();
    (0..rows[0].len()).map(column).collect()
}

/// The interpolants of one row, half-way between its nodes.
fn between(weights: &[Vec<f64>], row: &[DVec3]) -> Vec<DVec3> {
    weights.iter().map(|own| row.iter().zip(own).map(|(x, weight)| *x * *weight).sum()).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_geom::Rect;
    use radiosity_geom::shapes::{Bilinear, Cylinder, FULL_TURN, Sphere};

    use super::*;

    fn quarter_turn() -> Patch {
        let angle = [0.0, std::f64::consts::FRAC_PI_2];
        let wall = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, angle).expect("a cylinder");
        Patch::curved(Arc::new(wall), &Rect::FULL)
    }

    /// The chord of a circle of radius 1 over the angle φ is 1 − cos ½φ from it, and less along the radius
    /// only.
    #[test]
    fn a_chord_is_its_sagitta_away() {
        let found = Deviation::of(&quarter_turn(), 1);
        let sagitta = 1.0 - std::f64::consts::FRAC_PI_4.cos();
        assert!((found.largest - sagitta).abs() < 1e-14, "{}", found.largest);
        assert_eq!(found.worse, Direction::Along);
    }

    /// max |f − p| ≤ max |f^(p+1)| h^(p+1) / (4 (p + 1)) for p + 1 even nodes at the distance h.
    #[test]
    fn deviations_stay_below_the_bound_of_even_nodes() {
        for degree in 1..=12 {
            let step = std::f64::consts::FRAC_PI_2 / degree as f64;
            let bound = step.powi(degree as i32 + 1) / (4.0 * (degree + 1) as f64);
            let found = Deviation::of(&quarter_turn(), degree).largest;
            assert!(found <= 1.5 * bound + 1e-14 && found > 0.05 * bound, "{degree}: {found} {bound}");
        }
    }

    #[test]
    fn what_is_a_polynomial_is_one_cell() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::ONE, DVec3::Y];
        let saddle = Patch::curved(Arc::new(Bilinear::new(corners).expect("a saddle")), &Rect::FULL);
        for least in [1, 4] {
            let bent = BentCells::over(&saddle, least, 1.0);
            assert_eq!((bent.degree, bent.cells.len()), (least, 1));
            assert!(bent.deviation < 1e-15);
        }
    }

    #[test]
    fn spheres_are_cut_until_they_are_near() {
        let sphere = Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("a sphere");
        let bent = BentCells::over(&Patch::curved(Arc::new(sphere), &Rect::FULL), 3, 2.0);
        assert!(bent.deviation <= 2e-6 && bent.cells.len() <= 64, "{} cells", bent.cells.len());
        assert_eq!(bent.degree, CURVED_DEGREE);
    }
}
