//! Cuts of the parameter square [−1, 1]² into cells.
//!
//! Each direction is cut into n parts, which are equal unless something divides a surface (`dividers`). With layers the
//! outermost parts are cut again, geometrically towards the sides of the square: with h the width of such a part, 1 at
//! the most, the ends are
//!
//! ```text
//! −1, −1 + h q^L, … , −1 + h q ,      and mirrored ,
//! ```
//!
//! which makes n + 2L intervals. Near a side where surfaces meet, radiosity behaves like c + rᵞ with
//! 0 < γ < 1; polynomials on cells whose size is a fixed part of their distance from it converge
//! exponentially there.

use radiosity_geom::Rect;
use serde::{Deserialize, Serialize};

/// Smallest width q^L of a layer's cell: an area of 10⁻¹⁴ beside the whole is still told from rounding.
/// Smaller cells carry nothing.
const SMALLEST_CELL: f64 = 1e-7;

/// Cells graded towards the sides of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layers {
    /// Number of layers L at each side; 0 is none.
    pub count: usize,
    /// q, 0 < q < 1: distance of a layer from the side over that of the next layer.
    pub ratio: f64,
}

impl Layers {
    /// No grading.
    pub const NONE: Self = Self { count: 0, ratio: 0.25 };

    /// Most layers of the ratio q whose cells are wide enough to compute with.
    pub(crate) fn most(ratio: f64) -> usize {
        (SMALLEST_CELL.ln() / ratio.ln()).floor() as usize
    }

    /// Whether 0 < q < 1 and the smallest cell is wide enough to compute with.
    pub(crate) fn is_valid(&self) -> bool {
        self.ratio > 0.0 && self.ratio < 1.0 && self.ratio.powf(self.count as f64) >= SMALLEST_CELL
    }
}

/// Ends of `parts` ≥ 1 equal intervals of [−1, 1], ascending.
pub(crate) fn equal_parts(parts: usize) -> Vec<f64> {
    (0..=parts).map(|k| -1.0 + 2.0 * k as f64 / parts as f64).collect()
}

/// Ends of intervals of [−1, 1], ascending from −1 to 1, with layers at the lower and the upper side in the outermost.
pub(crate) fn with_layers(ends: &[f64], sides: [Layers; 2]) -> Vec<f64> {
    let inner = &ends[1..ends.len() - 1];
    let outermost = [1.0 + ends[1], 1.0 - ends[ends.len() - 2]].map(|width| width.min(1.0));
    let distances = |side: usize| {
        let Layers { count, ratio } = sides[side];
        (1..=count).map(move |k| outermost[side] * ratio.powf(k as f64))
    };
    let low = distances(0).rev().map(|distance| -1.0 + distance);
    let high = distances(1).map(|distance| 1.0 - distance);
    [-1.0].into_iter().chain(low).chain(inner.iter().copied()).chain(high).chain([1.0]).collect()
}

/// The cells between the breaks along u and v, v running fastest.
pub(crate) fn cells_between([u, v]: &[Vec<f64>; 2]) -> impl Iterator<Item = Rect> + use<> {
    let pairs = |breaks: &[f64]| -> Vec<[f64; 2]> { breaks.windows(2).map(|w| [w[0], w[1]]).collect() };
    let (u, v) = (pairs(u), pairs(v));
    u.into_iter().flat_map(move |u| v.clone().into_iter().map(move |v| Rect { u, v }))
}

/// The cells of a uniform cut of [−1, 1]², v running fastest.
pub fn cells_of(cells: [usize; 2]) -> impl Iterator<Item = Rect> {
    cells_between(&cells.map(equal_parts))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn one_layer_of_an_uncut_direction() {
        // 0, .075, .925, 1 in [0, 1].
        let expected = [-1.0, -0.85, 0.85, 1.0];
        let breaks = with_layers(&equal_parts(1), [Layers { count: 1, ratio: 0.15 }; 2]);
        assert_eq!(breaks.len(), expected.len());
        assert!(breaks.iter().zip(expected).all(|(b, e)| (b - e).abs() < 1e-15), "{breaks:?}");
    }

    #[test]
    fn layers_cut_only_the_outermost_parts() {
        let expected = [-1.0, -0.875, -0.5, 0.0, 0.5, 0.875, 1.0];
        assert_eq!(with_layers(&equal_parts(4), [Layers { count: 1, ratio: 0.25 }; 2]), expected);
    }

    #[test]
    fn layers_at_both_sides_suit_the_parts_there() {
        let expected = [-1.0, -0.75, 0.0, 0.75, 0.9375, 1.0];
        let layer = Layers { count: 1, ratio: 0.25 };
        assert_eq!(with_layers(&[-1.0, 0.0, 0.75, 1.0], [layer; 2]), expected);
        assert_eq!(with_layers(&[-1.0, 1.0], [Layers::NONE; 2]), [-1.0, 1.0]);
        assert_eq!(with_layers(&[-1.0, 1.0], [Layers::NONE, layer]), [-1.0, 0.75, 1.0]);
    }

    #[test]
    fn ratios_and_layers_that_make_no_cells_are_told() {
        let valid = |count, ratio| Layers { count, ratio }.is_valid();
        assert!(valid(8, 0.25) && valid(0, 0.5) && Layers::NONE.is_valid());
        assert!(
            !valid(1, 0.0) && !valid(1, 1.0) && !valid(1, -0.5) && !valid(8, 0.01) && !valid(1, f64::NAN)
        );
    }

    proptest! {
        #[test]
        fn cells_cover_the_square(
            parts in prop::array::uniform2(1..5usize), count in 0..=5usize, ratio in 0.1..0.9,
        ) {
            let breaks = parts.map(|parts| with_layers(&equal_parts(parts), [Layers { count, ratio }; 2]));
            for (breaks, parts) in breaks.iter().zip(parts) {
                prop_assert_eq!(breaks.len() - 1, parts + 2 * count);
                prop_assert!(breaks.windows(2).all(|w| w[0] < w[1]));
                prop_assert!(breaks.iter().zip(breaks.iter().rev()).all(|(a, b)| (a + b).abs() < 1e-15));
            }
            let cells: Vec<Rect> = cells_between(&breaks).collect();
            let area: f64 = cells.iter().map(|c| (c.u[1] - c.u[0]) * (c.v[1] - c.v[0])).sum();
            prop_assert!((area - 4.0).abs() < 1e-13);
        }
    }
}
