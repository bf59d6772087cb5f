//! The refinement of an element: higher orders where its light is smooth, cuts elsewhere.
//!
//! The coefficients s_k of reflected light in the orthonormal polynomials, all bands together, have the part
//! of degree n
//!
//! ```text
//! e_n² = Σ_{k of degree n} s_k² ,     r = min(e_N / e_{N−1}, (e_N / e_{N−2})^½) ,
//! ```
//!
//! of which r tells the decay; the second form where the former is even or odd. A cut into four halves the
//! element, and divides an error of order N by about 2^(N+1); the orders that as many polynomials allow
//! divide it by r^−N and more. So the order rises where r is below [`SMOOTH`]. (Decay of coefficients: C.
//! Mavriplis, *Adaptive mesh strategies for the spectral element method*, 1994.) The cut is across the
//! parameter along which light varies, if it does not vary along both.

use radiosity_elements::Element;
use radiosity_elements::basis::{Frame, HIGHEST_ORDER};
use radiosity_elements::mesh::{Axis, CellRefinement};
use radiosity_elements::space::Space;
use radiosity_geom::{DVec3, PARALLEL_DIRECTIONS, Surface};

use crate::solution::Solution;

/// Decay below which higher orders are better than cuts; see the module.
const SMOOTH: f64 = 0.5;

/// Rise of the order: a step of one gains little beside the time of a run, larger ones may be more than an
/// element needs.
const STEP: usize = 2;

/// Ratio of the squared variations along the parameters from which one of them is cut alone: more than a cut
/// of both would even out at order 2. Chosen.
const ONE_SIDED: f64 = 16.0;

/// The refinement of element `index`.
pub(super) fn refinement(solution: &Solution, starts: &[usize], index: usize) -> CellRefinement {
    let elements = solution.elements();
    let element = &elements.list()[index];
    let order = element.basis.order();
    let squares = squares(solution, starts[index]..starts[index + 1]);
    if element.basis.space() == Space::Total && order < HIGHEST_ORDER && decay(element, &squares) < SMOOTH {
        return CellRefinement::Raise(STEP);
    }
    CellRefinement::Cut(one_axis(element, &squares, elements.shape(element.surface)))
}

/// Squares of the coefficients of reflected light, summed over the bands.
fn squares(solution: &Solution, own: std::ops::Range<usize>) -> Vec<f64> {
    let mut squares = vec![0.0; own.len()];
    for band in solution.bands() {
        let all =
            band.coefficients.irradiance[own.clone()].iter().zip(&band.coefficients.direct[own.clone()]);
        squares.iter_mut().zip(all).for_each(|(square, (all, direct))| *square += (all - direct).powi(2));
    }
    squares
}

/// r of an element of these squared coefficients.
fn decay(element: &Element, squares: &[f64]) -> f64 {
    let order = element.basis.order();
    let of_degree = |degree: usize| {
        let degrees = element.basis.degrees().zip(squares);
        degrees.filter(|((i, j), _)| i + j == degree).map(|(_, square)| square).sum::<f64>().sqrt()
    };
    if order == 0 {
        return f64::INFINITY;
    }
    let highest = of_degree(order);
    let one = highest / of_degree(order - 1);
    let two = if order < 2 { f64::INFINITY } else { (highest / of_degree(order - 2)).sqrt() };
    one.min(two)
}

/// The parameter along which alone light varies.
fn one_axis(element: &Element, squares: &[f64], shape: &dyn Surface) -> Option<Axis> {
    if !element.basis.is_product() || !is_along_parameters(element, shape) {
        return None;
    }
    let mut variations = [0.0; 2];
    for ((i, j), square) in element.basis.degrees().zip(squares) {
        variations[0] += (i * i) as f64 * square;
        variations[1] += (j * j) as f64 * square;
    }
    match variations {
        [u, v] if u > ONE_SIDED * v => Some(Axis::U),
        [u, v] if v > ONE_SIDED * u => Some(Axis::V),
        _ => None,
    }
}

/// Whether the coordinates of the polynomials are those of the surface's parameters.
fn is_along_parameters(element: &Element, shape: &dyn Surface) -> bool {
    let [u, v] = element.rect.center();
    let jet = shape.jet(u, v);
    let parallel = |a: DVec3, b: DVec3| a.cross(b).length() <= PARALLEL_DIRECTIONS * a.length() * b.length();
    match element.basis.frame() {
        Frame::Parameters { .. } => true,
        Frame::Plane { first, second, .. } => parallel(*first, jet.du) && parallel(*second, jet.dv),
    }
}
