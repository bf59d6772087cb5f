//! The smallest moves of corners that put each into its planes.
//!
//! A plane with the nodes x_i and the normal n is flat when the heights h_i = n·x_i are an affine function of
//! the coordinates (s_i, t_i) across n. With q₀, q₁, q₂ orthonormal vectors that span 1, s, t over its nodes,
//!
//! ```text
//! r = h − Σ_k q_k (q_k·h) = 0 .
//! ```
//!
//! Moves δ change r by J δ = Q (n·δ_i), Q the same projection. The least-squares solution of J δ = −r is
//! δ = −J⁺ r, found by conjugate gradients on the normal equations, started from 0 (CGLS; Björck, *Numerical
//! Methods for Least Squares Problems*, 1996, 7.4). The planes tilt with their nodes, so a few steps of
//! Newton's method follow.

use radiosity_core::{dot, norm};
use radiosity_geom::DVec3;

use super::corners::Corners;
use super::planes::{Plane, Planes};

/// Most steps of Newton's method, each of which squares the relative error: four reach rounding from an error
/// of a tenth. More would only serve planes that turn over, whose corners stay where they were.
const STEPS: usize = 6;

/// Most steps of conjugate gradients: a bound of their time where planes nearly depend on each other. What is
/// left then is taken up by the next step of Newton's method.
const ITERATIONS: usize = 1000;

/// Residual over the initial one at which conjugate gradients end: some 10⁴ roundings, below which products
/// of their vectors gain little. With a looser value Newton's steps no longer square the error.
const LEFT: f64 = 1e-12;

/// Singular values of J below this, with the largest about 1, count as zero: almost parallel planes then
/// share no corner that would have to move far to lie in both, 10⁵ times its height over them. An arbitrary
/// choice: with a larger value planes at a small angle are not made to meet.
const LEAST_SINGULAR: f64 = 1e-5;

/// Largest move of a corner in tolerances of its sheets; a corner that would move farther stays. To lie in
/// two planes at an angle α it moves 1/sin α times as far as it is off them: 16 admits angles down to 3.6°.
/// With a larger value shapes change visibly.
const FARTHEST: f64 = 16.0;

/// The final positions of the nodes; heights below `reach` (scene length) are rounding.
pub(super) fn flattened(corners: &Corners, planes: &Planes, reach: f64) -> Vec<DVec3> {
    let mut places = corners.nodes.clone();
    for _ in 0..STEPS {
        let fits: Vec<Fit> = planes.list.iter().map(|plane| Fit::of(plane, &places)).collect();
        let residuals: Vec<Vec<f64>> = fits.iter().map(|fit| fit.residual(|node| places[node])).collect();
        if residuals.iter().flatten().all(|r| r.abs() <= reach) {
            break;
        }
        let moves = least_moves(&fits, residuals, places.len());
        places.iter_mut().zip(moves).for_each(|(place, step)| *place -= step);
    }
    for (node, place) in places.iter_mut().enumerate() {
        let start = corners.nodes[node];
        if place.distance(start) > FARTHEST * corners.tolerances[node] {
            *place = start;
        }
    }
    places
}

/// A plane with the functions 1, s, t over its nodes.
struct Fit<'a> {
    plane: &'a Plane,
    middle: DVec3,
    /// Values of q₀, q₁, q₂ at each node.
    functions: Vec<[f64; 3]>,
}

impl<'a> Fit<'a> {
    fn of(plane: &'a Plane, places: &[DVec3]) -> Self {
        let count = plane.nodes.len() as f64;
        let middle = plane.nodes.iter().map(|node| places[*node]).sum::<DVec3>() / count;
        let axes = plane.normal.any_orthonormal_pair();
        let across = |axis: DVec3| -> Vec<f64> {
            plane.nodes.iter().map(|node| (places[*node] - middle).dot(axis)).collect()
        };
        let (s, mut t) = (normalized(across(axes.0)), across(axes.1));
        // Twice is enough: the second pass removes the rounding of the first.
        for _ in 0..2 {
            let common = dot(&s, &t);
            t.iter_mut().zip(&s).for_each(|(t, s)| *t -= common * s);
        }
        let t = normalized(t);
        let constant = 1.0 / count.sqrt();
        let functions = s.iter().zip(&t).map(|(s, t)| [constant, *s, *t]).collect();
        Self { plane, middle, functions }
    }

    /// Q h for the heights of `vector`, relative to the middle of the plane's nodes.
    fn residual(&self, vector: impl Fn(usize) -> DVec3) -> Vec<f64> {
        self.projected(
            self.plane
                .nodes
                .iter()
                .map(|node| (vector(*node) - self.middle).dot(self.plane.normal))
                .collect(),
        )
    }

    /// Change J δ of the residual of this plane by the moves δ.
    fn changed(&self, moves: &[DVec3]) -> Vec<f64> {
        self.projected(self.plane.nodes.iter().map(|node| moves[*node].dot(self.plane.normal)).collect())
    }

    /// Projection Q h of the heights h of the nodes.
    fn projected(&self, mut heights: Vec<f64>) -> Vec<f64> {
        for k in 0..3 {
            let part: f64 = heights.iter().zip(&self.functions).map(|(h, q)| h * q[k]).sum();
            heights.iter_mut().zip(&self.functions).for_each(|(h, q)| *h -= part * q[k]);
        }
        heights
    }

    /// Adds Jᵀ y; y is a residual, which Q leaves as it is.
    fn add_transposed(&self, residual: &[f64], moves: &mut [DVec3]) {
        for (node, r) in self.plane.nodes.iter().zip(residual) {
            moves[*node] += *r * self.plane.normal;
        }
    }
}

fn normalized(mut values: Vec<f64>) -> Vec<f64> {
    let length = norm(&values).max(f64::MIN_POSITIVE);
    values.iter_mut().for_each(|value| *value /= length);
    values
}

/// The least-squares solution J⁺ r.
fn least_moves(fits: &[Fit], mut residuals: Vec<Vec<f64>>, nodes: usize) -> Vec<DVec3> {
    let transposed = |residuals: &[Vec<f64>]| {
        let mut moves = vec![DVec3::ZERO; nodes];
        fits.iter().zip(residuals).for_each(|(fit, residual)| fit.add_transposed(residual, &mut moves));
        moves
    };
    let square = |moves: &[DVec3]| moves.iter().map(|x| x.length_squared()).sum::<f64>();
    let mut solution = vec![DVec3::ZERO; nodes];
    let mut gradient = transposed(&residuals);
    let mut direction = gradient.clone();
    let start = square(&gradient);
    let mut left = start;
    for _ in 0..ITERATIONS {
        if left <= LEFT * LEFT * start {
            break;
        }
        let image: Vec<Vec<f64>> = fits.iter().map(|fit| fit.changed(&direction)).collect();
        let length: f64 = image.iter().map(|values| dot(values, values)).sum();
        if length <= LEAST_SINGULAR * LEAST_SINGULAR * square(&direction) {
            break;
        }
        let step = left / length;
        solution.iter_mut().zip(&direction).for_each(|(x, d)| *x += step * *d);
        for (residual, image) in residuals.iter_mut().zip(&image) {
            residual.iter_mut().zip(image).for_each(|(r, a)| *r -= step * a);
        }
        gradient = transposed(&residuals);
        let next = square(&gradient);
        direction.iter_mut().zip(&gradient).for_each(|(d, g)| *d = *g + next / left * *d);
        left = next;
    }
    solution
}
