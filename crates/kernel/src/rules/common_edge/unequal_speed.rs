//! A common edge that the two charts run through at different speeds.
//!
//! The rule of [`crate::rules::common_edge`] needs the same point of the edge at s = u. Hence the emitter is
//! re-parametrised:
//!
//! ```text
//! u = σ(s) where q(σ(s), 0) = p(s, 0) ,     σ′ = |p_s| / |q_u|
//! ```
//!
//! and σ′ multiplies its area element. σ is analytic where both speeds are; it is interpolated at Chebyshev
//! points.

use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;
use radiosity_work::interruption::check_interrupt;

use crate::contact::patches::sides;
use crate::moments::Moments;
use crate::moments::integrand::Sees;

/// Chebyshev points of the interpolant of σ: 32 reach rounding where it converges like 3.2⁻ⁿ or faster. With
/// more each node costs more.
const POINTS: usize = 32;

/// Adds two patches oriented with their common edge at t = 0, `points` as in [`crate::rules::common_edge`].
pub fn integrate(moments: &mut Moments, p: &Patch, q: &Patch, points: [usize; 3], sees: Option<Sees>) {
    let seam = UnequalSpeed::new(p, q);
    let rules = points.map(UnitRule::of);
    for (x, wx) in rules[0].iter() {
        for ((a, wa), (b, wb)) in rules[2].iter().flat_map(|a| rules[2].iter().map(move |b| (a, b))) {
            check_interrupt();
            for (t, v, z) in [(x, x * a, x * b), (x * a, x, x * b), (x * a, x * b, x)] {
                let weight = wx * wa * wb * x * x * (1.0 - z);
                for (y, wy) in rules[1].iter() {
                    let base = (1.0 - z) * y;
                    for (s, u) in [(base, base + z), (base + z, base)] {
                        moments.scattered(&p.node(s, t), &seam.node(u, v), weight * wy, sees);
                    }
                }
            }
        }
    }
}

/// The emitter, re-parametrised along the edge.
pub struct UnequalSpeed<'a> {
    p: &'a Patch,
    q: &'a Patch,
    /// σ at the Chebyshev points ½(1 − cos(πk/(n − 1))).
    values: Vec<f64>,
}

impl<'a> UnequalSpeed<'a> {
    /// For an emitter `q` whose edge t = 0 coincides with that of `p`.
    pub fn new(p: &'a Patch, q: &'a Patch) -> Self {
        let edges = sides(q);
        let value = |k: usize| match k {
            0 => 0.0,
            k if k == POINTS - 1 => 1.0,
            k => 0.5 * (1.0 + edges[0].nearest(p.node(chebyshev(k), 0.0).position)),
        };
        Self { p, q, values: (0..POINTS).map(value).collect() }
    }

    /// The node at (s, v), s in the receiver's parameter along the edge.
    pub fn node(&self, s: f64, v: f64) -> Node {
        let u = self.sigma(s);
        let node = self.q.node(u, v);
        let speed = tangent(self.p, s).length() / tangent(self.q, u).length();
        Node { area: node.area * speed, ..node }
    }

    /// σ by the barycentric formula.
    fn sigma(&self, s: f64) -> f64 {
        let (mut above, mut below) = (0.0, 0.0);
        for (k, value) in self.values.iter().enumerate() {
            let distance = s - chebyshev(k);
            if distance == 0.0 {
                return *value;
            }
            let end = if k == 0 || k == POINTS - 1 { 0.5 } else { 1.0 };
            let weight = if k % 2 == 0 { end } else { -end } / distance;
            above += weight * value;
            below += weight;
        }
        above / below
    }
}

fn chebyshev(k: usize) -> f64 {
    0.5 - 0.5 * (std::f64::consts::PI * k as f64 / (POINTS - 1) as f64).cos()
}

/// ∂x/∂s at (s, 0).
fn tangent(patch: &Patch, s: f64) -> DVec3 {
    match patch {
        Patch::Flat { corners: [a, b, ..], .. } => *b - *a,
        Patch::Curved { surface, origin, along, .. } => {
            let at = *origin + *along * s;
            let jet = surface.jet(at.x, at.y);
            jet.du * along.x + jet.dv * along.y
        }
    }
}
