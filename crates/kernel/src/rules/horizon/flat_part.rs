//! W_l(x) of a flat inner patch, however near or touching, by closed forms of what x sees of it.
//!
//! The patch Q is a convex polygon, so that x sees all of it or what a plane leaves of it,
//!
//! ```text
//! Q(x) = { y ∈ Q : n_x·(y − x) > 0 } ,     again a convex polygon,
//! ```
//!
//! and nothing where x lies behind the plane of Q. Of a constant W is Lambert's formula of Q(x)
//! ([`crate::irradiance::lambert`]), of polynomials the polar rule about the foot of x
//! ([`crate::rules::near`]), whose rays are exact at every height. So W is known to rounding at all
//! distances: near a point where the surface of x touches Q the kernel has a peak as wide as the gap, but W,
//! the share of the view that Q fills, is smooth but where the horizon of x reaches a corner of Q (a kink of
//! third order) or all of a side (of second order), and where the contact lies at the border of Q: there W
//! changes within about the gap.
//!
//! Where the foot of x lies so far outside that polynomials extended to it lose digits, Q is apart from x,
//! and a tensor rule sums it.

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::{MOST_POINTS, UnitRule};
use radiosity_geom::{COINCIDENT, DVec3, ROUNDING};
use radiosity_visibility::shadow_volume::{Corners, cut_at_horizon, reach};

use crate::contact::gap::point_to_polygon;
use crate::contact::orientation::{Facing, facing};
use crate::irradiance::lambert;
use crate::moments::integrand::kernel;
use crate::rules::far;
use crate::rules::near::Polar;

/// Kernel values that take as long as a side of Lambert's formula: 30 ns against 10.
const COST_OF_SIDE: u64 = 3;

/// A flat patch of the inner element.
pub(super) struct FlatPart<'a> {
    patch: Patch,
    polygon: Vec<DVec3>,
    basis: &'a AreaBasis,
    polar: Polar<'a>,
    eps: f64,
    /// Least height of points that see it (scene length): those of a surface before it that touches it are
    /// lifted to there.
    lift: f64,
}

impl<'a> FlatPart<'a> {
    /// For errors of about `eps` of the irradiance.
    pub(super) fn new(patch: &Patch, basis: &'a AreaBasis, eps: f64) -> Self {
        let polar = Polar::new(patch, basis, eps);
        Self { patch: patch.clone(), polygon: patch.polygon(), basis, polar, eps, lift: 0.0 }
    }

    /// Seen from a patch with these points: what the patch has in common with the plane is a contact, if some
    /// of them lie before it.
    pub(super) fn before(self, outer: &[Node]) -> Self {
        let level = ROUNDING * self.patch.longest().1;
        let is_before = outer.iter().any(|x| self.polar.height(x) > COINCIDENT * self.patch.longest().1);
        Self { lift: if is_before { level } else { 0.0 }, ..self }
    }

    /// A point of a touching surface, at which rounding decides on which side of the plane it lies, before it.
    fn lifted(&self, x: &Node) -> Node {
        let height = self.polar.height(x);
        if height.abs() >= self.lift {
            return *x;
        }
        Node { position: x.position + (self.lift - height) * self.patch.node(0.5, 0.5).normal, ..*x }
    }

    pub(super) fn may_be_faced_by(&self, outer: &Patch) -> bool {
        facing(outer, &self.patch, false, 0.0) != Facing::Away
    }

    /// Whether `x` may see some of it. A point where the surfaces touch lies in its plane, and sees it on its
    /// horizon.
    pub(super) fn may_be_seen_from(&self, x: &Node) -> bool {
        let corners: Corners = self.polygon.iter().map(|corner| corner - x.position).collect();
        let level = -COINCIDENT * reach(&corners);
        self.polar.height(x) >= level && corners.iter().any(|corner| x.normal.dot(*corner) >= level)
    }

    /// Adds W_l(x) to `out`; returns the number of evaluations.
    pub(super) fn seen_from(&mut self, x: &Node, out: &mut [f64]) -> u64 {
        let x = &self.lifted(x);
        let mut seen: Corners = self.polygon.iter().map(|corner| corner - x.position).collect();
        if self.polar.height(x) > 0.0 && !seen.iter().all(|corner| corner.dot(x.normal) >= 0.0) {
            cut_at_horizon(x.normal, &mut seen);
        }
        if self.polar.height(x) <= 0.0 || seen.len() < 3 {
            return self.polygon.len() as u64;
        }
        if let [sum] = out {
            *sum += self.basis.constant() * lambert::polygon(x.normal, &seen);
            return COST_OF_SIDE * seen.len() as u64;
        }
        seen.iter_mut().for_each(|corner| *corner += x.position);
        if !self.polar.reaches(x.position, self.eps) {
            return self.by_points(x, &seen, out);
        }
        let (column, samples) = self.polar.column_of(&seen, x, self.eps);
        out.iter_mut().zip(column).for_each(|(sum, value)| *sum += value);
        samples
    }

    /// Adds W_l(x) of a polygon apart from x by tensor rules.
    fn by_points(&self, x: &Node, polygon: &[DVec3], out: &mut [f64]) -> u64 {
        let mut values = vec![0.0; out.len()];
        let mut samples = 0;
        let normal = self.patch.node(0.5, 0.5).normal;
        for part in Patch::of_polygon(polygon, normal) {
            let gap = point_to_polygon(x.position, &part.polygon());
            let [along, across] = part.extents().map(|extent| self.rule(gap / extent));
            for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
                let y = part.node(s, t);
                let value = ws * wt * y.area * kernel(x, &y);
                self.basis.raw(self.basis.frame().coordinates(&y), &mut values);
                out.iter_mut().zip(&values).for_each(|(sum, own)| *sum += value * own);
                samples += 1;
            }
        }
        samples
    }

    /// The rule for a direction of so much gap over its extent.
    fn rule(&self, ratio: f64) -> &'static UnitRule {
        let degree = self.basis.total_degree() + 1;
        UnitRule::of(far::points(degree, self.eps, far::rho(ratio)).min(MOST_POINTS))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_elements::basis::Frame;
    use radiosity_geom::DVec2;

    use super::*;

    fn square() -> (Patch, AreaBasis) {
        let corners = [[-1., -1., 0.], [1., -1., 0.], [1., 1., 0.], [-1., 1., 0.]].map(DVec3::from_array);
        let patch = Patch::Flat { corners, normal: DVec3::Z };
        let frame = Frame::bounding(&corners, [DVec3::X, DVec3::Y]);
        let basis = AreaBasis::new(2, frame, std::slice::from_ref(&patch)).expect("it has area");
        (patch, basis)
    }

    /// ∫ κ L_l dA by midpoints.
    fn by_midpoints(patch: &Patch, basis: &AreaBasis, x: &Node) -> Vec<f64> {
        const STEPS: usize = 1500;
        let mut sums = vec![0.0; basis.len()];
        let mut values = sums.clone();
        let place = |k: usize| (k as f64 + 0.5) / STEPS as f64;
        for k in 0..STEPS * STEPS {
            let y = patch.node(place(k / STEPS), place(k % STEPS));
            let weight = y.area / (STEPS * STEPS) as f64 * kernel(x, &y);
            if weight > 0.0 {
                basis.raw(basis.frame().coordinates(&y), &mut values);
                sums.iter_mut().zip(&values).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        sums
    }

    fn node(position: DVec3, normal: DVec3) -> Node {
        Node { position, normal: normal.normalize(), area: 1.0, parameters: DVec2::ZERO }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]
        #[test]
        fn what_is_seen_past_a_horizon_is_its_integral(
            place in prop::array::uniform2(-2.5..2.5f64), height in 0.1..1.0f64, n in prop::array::uniform3(-1.0..1.0f64),
        ) {
            let (patch, basis) = square();
            let n = DVec3::from_array(n);
            prop_assume!(n.length() > 0.1);
            let x = node(DVec3::new(place[0], place[1], height), n);
            let mut found = vec![0.0; basis.len()];
            FlatPart::new(&patch, &basis, 1e-9).seen_from(&x, &mut found);
            for (found, right) in found.iter().zip(by_midpoints(&patch, &basis, &x)) {
                prop_assert!((found - right).abs() < 2e-4, "{found} {right}");
            }
        }
    }

    /// Of all polynomials together as of the constant alone, at every height and far beside it.
    #[test]
    fn constants_among_polynomials_have_lamberts_value() {
        let (patch, basis) = square();
        let alone =
            AreaBasis::new(0, basis.frame().clone(), std::slice::from_ref(&patch)).expect("it has area");
        for height in [1.0, 1e-2, 1e-5, 1e-9] {
            for (place, n) in [
                ([0.1, 0.2], DVec3::new(0.0, 0.0, -1.0)),
                ([0.1, 0.2], DVec3::new(0.3, 0.1, -1.0)),
                ([0.999, -0.3], DVec3::new(-0.5, 0.4, -0.1)),
                ([1.5, 0.0], DVec3::new(-1.0, 0.2, -0.3)),
                ([30.0, 2.0], DVec3::new(-1.0, 0.0, 0.0)),
            ] {
                let x = node(DVec3::new(place[0], place[1], height), n);
                let (mut all, mut one) = (vec![0.0; basis.len()], [0.0]);
                FlatPart::new(&patch, &basis, 1e-11).seen_from(&x, &mut all);
                FlatPart::new(&patch, &alone, 1e-11).seen_from(&x, &mut one);
                assert!((all[0] - one[0]).abs() < 1e-10, "{height:e} {place:?}: {} {}", all[0], one[0]);
            }
        }
    }
}
