//! Outlines of round things as a point sees them: arcs of circles, each joined to the next by a segment.

use core::f64::consts::TAU;

use radiosity_geom::{COINCIDENT, DVec3};
use smallvec::SmallVec;

use crate::shadow_volume::{Corners, ShadowVolume, reach};

/// Most halvings of a kite: it is then 10⁻⁴ as wide.
const MOST_HALVINGS: usize = 13;

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
    /// for a full turn, and more where the point is nearer to the arc than its centre.
    fn add_corners(&self, corners: usize, out: &mut Corners) {
        let [first, last] = self.angles;
        out.push(self.at(first, 1.0));
        let kites = (0.5 * corners as f64 * (last - first).abs() / TAU).ceil();
        let place = |k: usize| first + (last - first) * k as f64 / kites;
        let widest = 2.0 * TAU / corners as f64;
        for k in 0..kites as usize {
            self.add_kites([place(k), place(k + 1)], widest, MOST_HALVINGS, out);
        }
    }

    /// Adds the kites over a part of the arc, without its start: none looks wider from the point than `widest`
    /// (rad), or so many halvings do not make it so.
    fn add_kites(&self, [first, last]: [f64; 2], widest: f64, halvings: usize, out: &mut Corners) {
        let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
        let square = |angle: f64| self.at(angle, 1.0).length_squared();
        let gap = square(first).min(square(middle)).min(square(last));
        let width = 2.0 * half * half * self.axes[0].length_squared();
        if halvings > 0 && 2.0 * width > widest * widest * gap {
            self.add_kites([first, middle], widest, halvings - 1, out);
            return self.add_kites([middle, last], widest, halvings - 1, out);
        }
        out.push(self.at(middle, half / half.sin()));
        out.push(self.at(last, 1.0));
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
    /// Sides so short that rounding turns their planes are left out: their neighbours meet there.
    pub(crate) fn pyramid(&self, eye: DVec3, corners: usize) -> Option<ShadowVolume> {
        let mut outline = Corners::new();
        self.rims.iter().for_each(|rim| rim.add_corners(corners, &mut outline));
        let middle = eye + outline.iter().sum::<DVec3>() / outline.len() as f64;
        let least = COINCIDENT * reach(&outline);
        let sides = (0..outline.len()).map(|k| [outline[k], outline[(k + 1) % outline.len()]]);
        let long = sides.filter(|[a, b]| a.distance_squared(*b) > least * least);
        let long = long.map(|side| side.map(|a| eye + a));
        (outline.len() > 2).then(|| ShadowVolume::bounded(eye, middle, long, std::iter::empty()))
    }
}
