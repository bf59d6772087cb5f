//! Placements of grids of texels on surfaces.

use radiosity_geom::ROUNDING;

/// Placement of a grid of texels on a surface; see [`Pattern`](crate::Pattern).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Offset (o_s, o_t), in grids.
    pub offset: [f64; 2],
    /// Scale (k_s, k_t) > 0: number of grids along u and along v.
    pub scale: [f64; 2],
    /// Continuation of the grid beyond its border.
    pub wrap: Wrap,
}

/// Continuation of a grid of texels beyond its border.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The grid, repeated.
    #[default]
    Repeat,
    /// The grid, mirrored at its border.
    Mirror,
    /// The texels of the border, continued.
    Clamp,
}

impl Default for Placement {
    /// The grid once over the whole surface.
    fn default() -> Self {
        Self { offset: [0.0; 2], scale: [1.0; 2], wrap: Wrap::Repeat }
    }
}

impl Placement {
    /// Index of the texel at a parameter along an axis of `count` texels.
    pub(super) fn texel(&self, axis: usize, count: usize, parameter: f64) -> usize {
        let all = count as f64;
        let place = (self.offset[axis] + self.scale[axis] * 0.5 * (parameter + 1.0)) * all;
        // The end of the surface belongs to its last texel, not to the first of a grid that is not there.
        let ends_there = parameter >= 1.0 && place == place.floor();
        let place = if ends_there { place - 1.0 } else { place.floor() };
        let place = match self.wrap {
            Wrap::Repeat => place.rem_euclid(all),
            Wrap::Clamp => place.clamp(0.0, all - 1.0),
            Wrap::Mirror => {
                let place = place.rem_euclid(2.0 * all);
                if place < all { place } else { 2.0 * all - 1.0 - place }
            }
        };
        place as usize
    }

    /// The parameters along an axis between texels that differ, within (−1, 1), ascending.
    pub(super) fn breaks(&self, axis: usize, count: usize) -> Vec<f64> {
        let (offset, scale, all) = (self.offset[axis], self.scale[axis], count as f64);
        let ends = [offset * all, (offset + scale) * all];
        let (low, high) = (ends[0].ceil() as i64, ends[1].floor() as i64);
        let (low, high) = match self.wrap {
            // The texels of the border go on.
            Wrap::Clamp => (low.max(1), high.min(count as i64 - 1)),
            _ => (low, high),
        };
        // A border of the grid mirrors a texel on itself.
        let differs = |k: &i64| self.wrap != Wrap::Mirror || k % count as i64 != 0;
        let at = |k: i64| 2.0 * (k as f64 / all - offset) / scale - 1.0;
        (low..=high).filter(differs).map(at).filter(|x| x.abs() < 1.0 - ROUNDING).collect()
    }

    /// The part of the surface along an axis that each of `count` texels takes; all of them together take 1.
    pub(super) fn shares(&self, axis: usize, count: usize) -> Vec<f64> {
        let mut shares = vec![0.0; count];
        let mut start = -1.0;
        for end in self.breaks(axis, count).into_iter().chain([1.0]) {
            shares[self.texel(axis, count, 0.5 * (start + end))] += 0.5 * (end - start);
            start = end;
        }
        shares
    }
}
