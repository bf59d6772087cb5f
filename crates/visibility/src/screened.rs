//! Whether joined surfaces hide two ends from each other. A few rays choose the screens that are tried, and
//! leave out ends that see each other; they never decide that something is hidden.

use std::iter;

use radiosity_geom::{COINCIDENT, DVec3, Ray};

use super::{Visibility, breadth};
use crate::screens::End;
use crate::tolerances::OWN_END;

/// Surfaces along a ray that screens are grown from, at either end: those next to an end hide most. With a
/// larger value a few more pairs are told hidden at once, and all that are not take longer.
const TRIED: usize = 2;

/// Rays besides the one between the middles, from near the corners of either end.
const MORE_RAYS: usize = 3;

/// Where these start between the middle and a corner: near the corner, but not on the border.
const OUTWARDS: f64 = 0.9;

/// Part by which the weights of corners differ, and the golden section, whose multiples spread them.
const UNEVEN: f64 = 0.1;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Visibility {
    /// Whether a screen certainly meets all segments between two ends. Where it is false something may hide
    /// them all the same.
    pub fn are_screened(&self, ends: [End; 2]) -> bool {
        let Some(segment) = self.first_hidden(ends) else { return false };
        let [a, b] = ends;
        let thin = breadth(a.hull()).min(breadth(b.hull()));
        let [x, y] = segment;
        let from_a = self.met_between(a.surface(), x, y).take(TRIED);
        let from_b = self.met_between(b.surface(), y, x).take(TRIED);
        let is_own = |surface: usize| ends.iter().any(|end| end.surface() == Some(surface));
        from_a.chain(from_b).any(|first| !is_own(first) && self.screens.close(ends, first, segment, thin))
    }

    /// The first of a few segments between two ends, in front of both; None where one of them is free.
    fn first_hidden(&self, ends: [End; 2]) -> Option<[DVec3; 2]> {
        if !self.casts() || self.standing.is_empty() {
            return None;
        }
        let [a, b] = ends;
        let mut first = None;
        for k in 0..=MORE_RAYS {
            let [x, y] = [place(a.hull(), k), place(b.hull(), 2 * k)];
            let margin = COINCIDENT * x.distance(y);
            if !(a.faces(y, margin) && b.faces(x, margin)) {
                continue;
            }
            if self.is_free(a.surface(), x, y) {
                return None;
            }
            first = first.or(Some([x, y]));
        }
        first
    }

    /// The surfaces that the segment from `x`, on `surface` if on any, to `y` meets, one after another.
    fn met_between(&self, surface: Option<usize>, x: DVec3, y: DVec3) -> impl Iterator<Item = usize> {
        let mut last = None;
        iter::from_fn(move || {
            let range = [last.map_or(0.0, |t| t + COINCIDENT), 1.0 - OWN_END];
            let ray = Ray { origin: x, direction: y - x, range };
            let met = match (last, surface) {
                (None, Some(surface)) => self.nearest_from(surface, x, y - x),
                _ => self.nearest(&ray),
            };
            let met = met.filter(|met| met.hit.t <= ray.range[1])?;
            last = Some(met.hit.t);
            Some(met.surface)
        })
    }
}

/// A place near the middle of a hull, or near one of its corners. Corners weigh differently, as symmetric
/// things would be met right on the sides that join their faces, where it is not certain what is met.
fn place(hull: &[DVec3], k: usize) -> DVec3 {
    let weight = |corner: usize| 1.0 + UNEVEN * (GOLDEN * corner as f64).fract();
    let weights: f64 = (0..hull.len()).map(weight).sum();
    let middle = hull.iter().enumerate().map(|(corner, x)| x * weight(corner)).sum::<DVec3>() / weights;
    if k == 0 { middle } else { middle.lerp(hull[k % hull.len()], OUTWARDS) }
}
