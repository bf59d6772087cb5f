//! The term of two edges in the double contour integral, by the form that suits their position.

use crate::rules::contour::segment::Segment;
use crate::rules::contour::{crossing, parallel, skew};
use crate::tolerances::ROUNDING_OF_DIRECTIONS;

/// (d_a·d_b) ∫∫ (ln r + 3/2) ds dt, and the number of logarithms.
pub(super) fn integral(a: &Segment, b: &Segment) -> (f64, u64) {
    let cosine = a.direction.dot(b.direction);
    if cosine.abs() <= ROUNDING_OF_DIRECTIONS {
        return (0.0, 0);
    }
    let b = &if cosine < 0.0 { b.reversed() } else { *b };
    let (integral, terms) = if a.direction.cross(b.direction).length_squared()
        <= ROUNDING_OF_DIRECTIONS * ROUNDING_OF_DIRECTIONS
    {
        (parallel::integral(a, b), 4)
    } else if let Some(integral) = crossing::integral(a, b) {
        (integral, 4)
    } else {
        skew::integral(a, b)
    };
    (cosine * integral, terms)
}

/// The sum of the terms of several edges with one edge.
pub(super) fn integrals(edges: &[Segment], b: &Segment) -> (f64, u64) {
    edges.iter().map(|a| integral(a, b)).fold((0.0, 0), |(x, n), (y, m)| (x + y, n + m))
}
