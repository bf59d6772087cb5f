//! Which functions a run sums, and the polynomials on elements that hold them.
//!
//! cos(k x + c) on x ∈ [−1, 1] has the orthonormal Legendre coefficients √(2 (2n + 1)) j_n(k), times a cosine
//! or sine of c, where
//!
//! ```text
//! |j_n(k)| ≤ kⁿ / (2n + 1)!! ,
//! ```
//!
//! and a cell of half width h has k = i π h / 2 for the degree i (DLMF 10.14.4, 10.54.2). The order of a cell
//! is the first at which the rest of this series is below the tolerance.

use std::f64::consts::FRAC_PI_2;

use radiosity_elements::basis::HIGHEST_ORDER;
use radiosity_elements::mesh::{CellRefinement, Mesh, Tree};
use radiosity_elements::space::Space;
use radiosity_elements::{Discretization, usual_mesh};
use radiosity_geom::Rect;
use radiosity_scene::Scene;
use serde::{Deserialize, Serialize};

use super::cells::Cells;
use super::cosines::Cosines;
use super::functions::SurfaceFunctions;
use super::tents::Tents;

/// Error of cosines as polynomials, over the accuracy of the transfers between them: so that only the latter
/// shows.
const OF_ACCURACY: f64 = 1e-3;

/// Least such error: below it is rounding.
const LEAST: f64 = 1e-13;

/// Which functions a run sums.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Basis {
    /// Polynomials of degree --order on each element
    #[default]
    Legendre,
    /// A constant on each of the cells that --subdivide makes: classical radiosity
    Constant,
    /// Tents between the corners of these cells, continuous over each surface
    Linear,
    /// Cosines up to --order over each whole surface
    Harmonic,
}

/// A cut of a scene into elements whose polynomials hold the functions.
#[derive(Clone, Debug)]
pub struct Ground {
    /// Cut of the elements, and their polynomials.
    pub how: Discretization,
    /// Cells and orders, where they are other than follow from that.
    pub mesh: Option<Mesh>,
}

impl Basis {
    /// Its name, as typed.
    pub fn name(self) -> &'static str {
        match self {
            Self::Legendre => "legendre",
            Self::Constant => "constant",
            Self::Linear => "linear",
            Self::Harmonic => "harmonic",
        }
    }

    /// Whether it is that of polynomials of the order asked for.
    pub fn is_polynomial(self) -> bool {
        self == Self::Legendre
    }

    /// Whether the functions are all polynomials of some order on each element, so that they span no less.
    pub fn is_elementwise(self) -> bool {
        matches!(self, Self::Legendre | Self::Constant)
    }

    /// The elements for the cells and degrees that `how` says, if transfers are accurate to `eps`.
    pub fn ground(self, scene: &Scene, how: &Discretization, eps: f64) -> Ground {
        let (space, mesh) = match self {
            Self::Legendre => return Ground { how: *how, mesh: None },
            Self::Constant => (Space::Total, with_order(&usual_mesh(scene, how), 0)),
            // u v has degree 2 in any affine coordinates.
            Self::Linear => (Space::Total, with_order(&usual_mesh(scene, how), 2)),
            Self::Harmonic => {
                (how.space, holding_cosines(usual_mesh(scene, how), (OF_ACCURACY * eps).max(LEAST)))
            }
        };
        let orders = mesh.surfaces().iter().flat_map(|tree| tree.values().into_iter().copied());
        let order = orders.max().unwrap_or(0);
        Ground { how: Discretization { order, space, ..*how }, mesh: Some(mesh) }
    }

    /// The functions on a surface that is cut into `cells`; `degree` and `space` are those of cosines. None
    /// for polynomials.
    pub fn functions(self, cells: &[Rect], degree: usize, space: Space) -> Option<Box<dyn SurfaceFunctions>> {
        match self {
            Self::Legendre => None,
            Self::Constant => Some(Box::new(Cells::new(cells.to_vec()))),
            Self::Linear => Some(Box::new(Tents::new(breaks(cells)))),
            Self::Harmonic => Some(Box::new(Cosines::new(space, degree))),
        }
    }
}

/// The breaks of the grid of these cells.
fn breaks(cells: &[Rect]) -> [Vec<f64>; 2] {
    let along = |of: fn(&Rect) -> [f64; 2]| {
        let mut all: Vec<f64> = cells.iter().flat_map(of).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    };
    [along(|rect| rect.u), along(|rect| rect.v)]
}

/// The cells of `mesh`, all of one order.
fn with_order(mesh: &Mesh, order: usize) -> Mesh {
    mesh.with_orders(&|_, _| order)
}

/// Cells and orders that hold cosines of the degrees that `mesh` states; cells on which no order would do are
/// cut.
fn holding_cosines(mut mesh: Mesh, tolerance: f64) -> Mesh {
    let order = |rect: &Rect, degree: usize| {
        let widths = [rect.u[1] - rect.u[0], rect.v[1] - rect.v[0]];
        order_of_cosine(degree as f64 * FRAC_PI_2 * 0.5 * widths[0].max(widths[1]), tolerance)
    };
    loop {
        let orders = mesh.with_orders(&|rect, degree| order(rect, degree).unwrap_or(usize::MAX));
        let leaves: Vec<Vec<&usize>> = orders.surfaces().iter().map(Tree::values).collect();
        if leaves.iter().flatten().all(|order| **order != usize::MAX) {
            return orders;
        }
        mesh = mesh.refined(&|surface, leaf| match leaves[surface][leaf] {
            &usize::MAX => CellRefinement::Cut(None),
            _ => CellRefinement::Keep,
        });
    }
}

/// The order that holds cos(k x + c) on [−1, 1] to `tolerance` in L²; None if none offered does.
fn order_of_cosine(wave: f64, tolerance: f64) -> Option<usize> {
    // Terms beyond twice the highest order are below any tolerance for waves that the latter holds.
    let mut terms = vec![1.0; 2 * HIGHEST_ORDER + 2];
    for n in 1..terms.len() {
        terms[n] = terms[n - 1] * wave / (2 * n + 1) as f64;
    }
    let sizes = terms.iter().enumerate().map(|(n, term)| (2.0 * (2 * n + 1) as f64).sqrt() * term);
    let sizes: Vec<f64> = sizes.collect();
    let rest = |order: usize| sizes[order + 1..].iter().sum::<f64>();
    (0..=HIGHEST_ORDER).find(|order| rest(*order) <= tolerance && wave < (2 * order + 3) as f64)
}

#[cfg(test)]
mod tests {
    use radiosity_core::legendre;
    use radiosity_elements::rule::UnitRule;

    use super::*;

    /// ‖cos(k x + c) − its projection on degree ≤ N‖ on [−1, 1], by a rule of many points.
    fn error_of(wave: f64, phase: f64, order: usize) -> f64 {
        let rule = UnitRule::of(60);
        let points: Vec<(f64, f64)> = rule.iter().map(|(x, w)| (2.0 * x - 1.0, 2.0 * w)).collect();
        let table: Vec<Vec<f64>> = points
            .iter()
            .map(|(x, _)| {
                let mut values = vec![0.0; order + 1];
                legendre::orthonormal(*x, &mut values);
                values
            })
            .collect();
        let mut rest: Vec<f64> = points.iter().map(|(x, _)| (wave * x + phase).cos()).collect();
        for n in 0..=order {
            let along: f64 = (0..points.len()).map(|k| points[k].1 * rest[k] * table[k][n]).sum();
            rest.iter_mut().zip(&table).for_each(|(rest, row)| *rest -= along * row[n]);
        }
        points.iter().zip(&rest).map(|((_, w), r)| w * r * r).sum::<f64>().sqrt()
    }

    #[test]
    fn the_order_of_a_cosine_holds_it_and_is_no_larger_than_needed() {
        for wave in [0.0, 0.5, 1.6, 3.2, 4.8, 7.9] {
            for tolerance in [1e-3, 1e-6, 1e-12] {
                let Some(order) = order_of_cosine(wave, tolerance) else { continue };
                let worst =
                    |order| (0..8).map(|k| error_of(wave, 0.4 * f64::from(k), order)).fold(0.0, f64::max);
                assert!(worst(order) <= tolerance + 1e-14, "{wave} {tolerance}: {order}");
                if order >= 3 {
                    assert!(worst(order - 3) > tolerance, "{wave} {tolerance}: {order} is more than needed");
                }
            }
        }
    }
}
