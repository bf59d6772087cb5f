//! Outlines of round things as a point sees them: arcs of circles, each joined to the next by a segment.

use core::f64::consts::TAU;

use radiosity_geom::DVec3;
use smallvec::SmallVec;

use crate::shadow_volume::{Corners, ShadowVolume};

/// An arc of a circle, center + cos ψ · a + sin ψ · b with a and b of `axes`.
#[derive(Clone, Copy, Debug)]
pub struct Rim {
    /// Centre of the circle, relative to the point that sees it.
    pub center: DVec3,
    /// Two radii at a right angle; none at a tip.
    pub axes: [DVec3; 2],
    /// ψ at its ends, a turn apart at most.
    pub angles: [f64; 2],
}

impl Rim {
    /// The place at an angle, at a multiple of the radius.
    fn at(&self, angle: f64, reach: f64) -> DVec3 {
        let (sin, cos) = angle.sin_cos();
        self.center + reach * (cos * self.axes[0] + sin * self.axes[1])
    }

    /// Adds corners that stand for the arc, with its ends: kites of the area of its sectors, so many `corners`
    /// for a full turn.
    fn add_corners(&self, corners: usize, out: &mut Corners) {
        let [first, last] = self.angles;
        if first == last {
            return out.push(self.at(first, 1.0));
        }
        let kites = (0.5 * corners as f64 * (last - first).abs() / TAU).ceil().max(1.0);
        let half = 0.5 * (last - first) / kites;
        let outside = half / half.sin();
        let corner = |k: usize| self.at(first + half * k as f64, if k % 2 == 1 { outside } else { 1.0 });
        out.extend((0..=2 * kites as usize).map(corner));
    }
}

/// The outline of a convex thing, all the way round.
#[derive(Clone, Debug)]
pub struct RoundOutline {
    /// Its arcs in order.
    pub rims: SmallVec<[Rim; 2]>,
}

impl RoundOutline {
    /// All of a circle.
    pub(crate) fn circle(center: DVec3, axes: [DVec3; 2]) -> Self {
        Self { rims: SmallVec::from_slice(&[Rim { center, axes, angles: [0.0, TAU] }]) }
    }

    /// The directions within it, as so many `corners` on a full turn show them; None where these bound nothing.
    pub(crate) fn pyramid(&self, eye: DVec3, corners: usize) -> Option<ShadowVolume> {
        let mut outline = Corners::new();
        self.rims.iter().for_each(|rim| rim.add_corners(corners, &mut outline));
        let middle = eye + outline.iter().sum::<DVec3>() / outline.len() as f64;
        let sides =
            (0..outline.len()).map(|k| [outline[k], outline[(k + 1) % outline.len()]].map(|a| eye + a));
        (outline.len() > 2).then(|| ShadowVolume::bounded(eye, middle, sides, std::iter::empty()))
    }
}
