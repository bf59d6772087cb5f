//! Hierarchy traversal: visits the trees of cells for a point, and divides a cell only where its rule is too
//! coarse.
//!
//! The cells of an opening to a sky are cut at the level of the point, where the radiance behind them jumps, and
//! at the receiver's own horizon: on each part what is summed is smooth.
//!
//! A cell may err by a share ε of the irradiance E of the point, other known light included. E is not known
//! beforehand: the first pass takes an upper bound b in its place. If E turns out below 0.4 b, the trees with
//! too coarse cells are visited again.

mod cell_rule;

use std::f64::consts::PI;
use std::iter;

use radiosity_geom::{DVec3, Plane};
use radiosity_scene::Radiance;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;
use smallvec::SmallVec;

use crate::area_light::{AreaLight, irradiance};
use crate::blockers::BlockerRange;
use crate::blockers::Shadows;
use crate::cells::cell::{Cell, Field, POINTS};
use crate::cells::tree::Tree;
use crate::lines::hidden_spans::HiddenSpans;
use crate::lines::line_quadrature::LineQuadrature;
use crate::occluders::Occluders;
use crate::receiver_point::ReceiverPoint;
use crate::tolerances::{
    MOST_QUARTERINGS_OF_CURVED, MOST_QUARTERINGS_OF_FLAT, MOST_QUARTERINGS_OF_OWN, OUTLINE_FROM,
};

/// Most cells per sum: a bound of the time of a point. Further cells are taken undivided, with errors up to
/// all they contribute.
const MOST_CELLS: usize = 20_000;

/// A receiver within this part of the radius of a ball's inside, in position and normal, lies on it: some 10⁷
/// roundings. Farther from it the constant kernel would be off by as much.
const ON_DOME: f64 = 1e-9;

/// Irradiance over its bound below which the sum is repeated: each cell then erred by 1/0.4 of what it may,
/// or more. With a larger value more sums are made twice.
const DARK: f64 = 0.4;

/// Least irradiance over its bound that the accuracy is relative to: deep shadows would take a cell for each
/// glimmer.
const LEAST: f64 = 0.05;

/// The traversal for one receiver point.
pub(crate) struct Traversal<'a> {
    receiver: &'a ReceiverPoint,
    visibility: &'a Visibility,
    occluders: &'a Occluders,
    shadows: Shadows<'a>,
    /// Largest error of a cell so far, in multiples of the scales.
    coarsest: f64,
    /// Cells visited in this sum.
    visited: usize,
}

/// The visit of one tree.
struct Pass<'a> {
    tree: &'a Tree,
    /// Error allowed per cell, in multiples of the channels' scales.
    tolerance: f64,
    deepest: usize,
    /// Whether the point lies on the element's surface.
    own: bool,
    /// The constant kernel 1/(4πR²), if the surface is the inside of a ball that the point lies on.
    dome: Option<f64>,
    out: &'a mut [f64],
}

impl<'a> Traversal<'a> {
    /// Traversal for a receiver point of the site that the occluders were listed for.
    pub(crate) fn new(
        receiver: &'a ReceiverPoint,
        visibility: &'a Visibility,
        occluders: &'a Occluders,
    ) -> Self {
        Self {
            receiver,
            visibility,
            occluders,
            shadows: Shadows::new(receiver, visibility, occluders),
            coarsest: 0.0,
            visited: 0,
        }
    }

    /// Whether all obstacles are planar; then flat cells of even radiosity are exact.
    pub(crate) fn is_flat(&self) -> bool {
        self.shadows.all_flat()
    }

    /// The irradiance from each of `trees`, channel after channel; each cell may err by `share` times the
    /// irradiance of the point, with the known further irradiance `other` included, all in multiples of the
    /// scales. `add` adds the irradiance from one tree with a given tolerance, `level` converts irradiance to
    /// multiples of the scales.
    pub(crate) fn within_share(
        &mut self,
        trees: &[Tree],
        share: f64,
        other: f64,
        add: impl Fn(&mut Self, usize, f64, &mut [f64]),
        level: impl Fn(&[f64]) -> f64,
    ) -> Vec<f64> {
        let bound: f64 = trees.iter().enumerate().map(|(index, tree)| self.bound(index, tree)).sum();
        let channels = trees.first().map_or(1, |tree| tree.scale().len());
        let mut parts = vec![0.0; trees.len() * channels];
        let mut coarsest: SmallVec<[f64; 64]> = SmallVec::new();
        for (index, part) in parts.chunks_exact_mut(channels).enumerate() {
            self.coarsest = 0.0;
            add(self, index, share * (other + bound), part);
            coarsest.push(self.coarsest);
        }
        let level = (other + level(&parts)).max(LEAST * bound);
        if level < DARK * (other + bound) {
            self.visited = 0;
            for (index, part) in parts.chunks_exact_mut(channels).enumerate() {
                if coarsest[index] > share * level {
                    part.fill(0.0);
                    add(self, index, share * level, part);
                }
            }
        }
        parts
    }

    /// Approximate upper bound of the irradiance from element `index`, in multiples of the scales.
    fn bound(&self, index: usize, tree: &Tree) -> f64 {
        if self.is_out_of_sight(index, tree) {
            return 0.0;
        }
        if let Some(radiance) = tree.opening() {
            return self.bound_of_opening(tree, radiance);
        }
        let bound = |cell: &Cell| {
            let is_far = 2.0 * cell.radius < self.distance(cell);
            let is_told = is_far || self.is_like_flat(cell);
            let factor = if is_told { self.weights(cell).iter().sum::<f64>().min(1.0) } else { 1.0 };
            cell.field.brightness * factor
        };
        tree.roots().iter().map(bound).sum()
    }

    /// As [`Traversal::bound`], by the greatest light from the points of each part of an opening and the nearest one.
    fn bound_of_opening(&self, tree: &Tree, radiance: &Radiance) -> f64 {
        let position = self.receiver.position;
        let towards = |y: DVec3| (position - y).normalize_or_zero();
        let bound = |part: &Cell| {
            // Glass that is close by lets most through at the foot of the point.
            let places = part.nodes.iter().map(|node| node.position).chain(part.foot(position));
            let greatest = places.map(|y| radiance.relative(towards(y))).fold(0.0, f64::max);
            part.field.brightness * greatest * self.receiver.factor(&part.hull, iter::empty())
        };
        let of_root = |root: &Cell| match self.at_horizons(tree, root) {
            Some(parts) => parts.iter().map(bound).sum(),
            None => bound(root),
        };
        tree.roots().iter().map(of_root).sum()
    }

    /// Adds the irradiance from element `index` to `out`, per channel; a cell may err by `tolerance` times
    /// the scale.
    pub(crate) fn add(&mut self, index: usize, tree: &Tree, tolerance: f64, out: &mut [f64]) {
        let Some(places) = self.occluders.before(index) else { return };
        if self.is_out_of_sight(index, tree) {
            return;
        }
        let before = self.shadows.ask(places, &tree.bounds);
        let own = self.receiver.surface == Some(tree.surface);
        let deepest = match (own, tree.plane) {
            (true, _) => MOST_QUARTERINGS_OF_OWN,
            (false, None) => MOST_QUARTERINGS_OF_CURVED,
            (false, Some(_)) => MOST_QUARTERINGS_OF_FLAT,
        };
        let dome = if own { self.dome(tree.surface) } else { None };
        let mut pass = Pass { tree, tolerance, deepest, own, dome, out };
        for root in tree.roots() {
            match self.at_horizons(tree, root) {
                Some(parts) => parts.iter().for_each(|part| self.visit(&mut pass, part, before, 0)),
                None => self.visit(&mut pass, root, before, 0),
            }
        }
    }

    /// The parts of a cell of an opening with sky behind them and with ground behind them, above the horizon of
    /// the receiver; None where no horizon crosses it.
    fn at_horizons(&self, tree: &Tree, root: &Cell) -> Option<SmallVec<[Cell; 4]>> {
        let zenith = tree.zenith()?;
        let ReceiverPoint { position, normal, ground, .. } = *self.receiver;
        let crosses = |horizon: &DVec3| root.is_crossed(position, *horizon);
        let own: SmallVec<[DVec3; 3]> =
            [Some(normal), ground].into_iter().flatten().filter(crosses).collect();
        let part = |further: &[DVec3]| root.part(position, &[&own, further].concat(), tree.scale());
        match crosses(&zenith) {
            true => Some([zenith, -zenith].into_iter().flat_map(|side| part(&[side])).collect()),
            false if own.is_empty() => None,
            false => Some(part(&[]).into_iter().collect()),
        }
    }

    /// Irradiance from element `index`, an area light of exitance 1, with the error `tolerance` over its
    /// brightness `brightness`; None where it is too near to be taken as a whole.
    pub(crate) fn lamp(
        &mut self,
        index: usize,
        lamp: &AreaLight,
        brightness: f64,
        tolerance: f64,
    ) -> Option<f64> {
        let Some(places) = self.occluders.before(index) else { return Some(0.0) };
        let (eye, normal) = (self.receiver.position, self.receiver.normal);
        if lamp.center.distance(eye) < OUTLINE_FROM * lamp.radius {
            return None;
        }
        let sides = lamp.outline(eye);
        let corners: Vec<DVec3> = sides.iter().map(|side| side[0]).collect();
        if corners.is_empty() || self.receiver.is_above(&corners) {
            return Some(0.0);
        }
        let is_whole = self.receiver.overlooks(&corners);
        let whole = if is_whole { irradiance(eye, normal, &sides) } else { lamp.most_from(eye) };
        let error = tolerance / (brightness * whole);
        if error >= 1.0 {
            self.coarsest = self.coarsest.max(brightness * whole);
            return Some(if self.shadows.hide_lamp(lamp, places) { 0.0 } else { whole });
        }
        let (plane, lit) = lamp.plane(eye, &sides)?;
        let Some((flat, curved)) = self.shadows.before_lamp(lamp, &plane, places) else { return Some(0.0) };
        let mut spans = HiddenSpans::before_lamp(plane, lit);
        flat.iter().for_each(|volume| spans.add_flat(volume));
        curved.iter().for_each(|surface| self.shadows.add_curved(&mut spans, *surface, None));
        if spans.is_empty() && is_whole {
            return Some(whole);
        }
        self.coarsest = self.coarsest.max(tolerance);
        let [seen, all] = LineQuadrature::of_lamp(self.receiver, &spans).irradiances(error);
        Some(if is_whole && all > 0.0 { whole * seen / all } else { seen })
    }

    fn is_out_of_sight(&self, index: usize, tree: &Tree) -> bool {
        let behind = |plane: Plane| plane.height(self.receiver.position) <= 0.0;
        self.occluders.before(index).is_none() || tree.plane.is_some_and(behind)
    }

    fn visit(&mut self, pass: &mut Pass, cell: &Cell, above: BlockerRange, depth: usize) {
        if !self.receiver.clears(cell.center, cell.radius) && self.receiver.is_above(&cell.hull) {
            return;
        }
        let Some(before) = self.shadows.narrow(above, cell) else { return };
        let position = self.receiver.position;
        let radiance = pass.tree.radiance.as_ref();
        let seen = radiance.map(|radiance| cell.seen(radiance, position, pass.tree.scale()[0]));
        let field = seen.as_ref().unwrap_or(&cell.field);
        let estimate = self.estimate(pass, cell, field, before);
        self.visited += 1;
        check_interrupt();
        if estimate.error <= pass.tolerance || depth == pass.deepest || self.visited > MOST_CELLS {
            // Line quadrature is only as accurate as the tolerance.
            let by_points = before.is_empty() || (cell.is_flat() && self.shadows.are_flat(before));
            let error = if by_points { estimate.error.min(pass.tolerance) } else { pass.tolerance };
            self.coarsest = self.coarsest.max(error);
            let weights = match estimate.error.is_finite() {
                true => estimate.weights,
                false => self.visible(pass, cell, estimate.weights, before),
            };
            pass.take(field, &weights);
            return;
        }
        for quarter in cell.quarters(pass.tree.scale()).iter() {
            self.visit(pass, quarter, before, depth + 1);
        }
    }

    /// The constant kernel of the inside of a ball, if `surface` is a whole one and the point lies on it.
    fn dome(&self, surface: usize) -> Option<f64> {
        let (center, radius) = self.visibility.whole_dome(surface)?;
        let ReceiverPoint { position, normal, ground, .. } = *self.receiver;
        let is_inward = (center - position).distance(radius * normal) <= ON_DOME * radius;
        (ground.is_none() && is_inward).then_some(1.0 / (4.0 * PI * radius * radius))
    }
}

impl Pass<'_> {
    fn take(&mut self, field: &Field, weights: &[f64; POINTS]) {
        for (channel, out) in self.out.iter_mut().enumerate() {
            *out += (0..POINTS).map(|k| weights[k] * field.value(k, channel)).sum::<f64>();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_elements::{Discretization, Elements};
    use radiosity_geom::shapes::{Disk, FULL_TURN};
    use radiosity_scene::{Material, SceneBuilder};
    use radiosity_visibility::Shadows;

    use super::*;

    /// Nothing is sent from the back of a disk, and nothing has to be divided to find that.
    #[test]
    fn cells_that_turn_their_backs_are_not_divided_for_their_errors() {
        let mut builder = SceneBuilder::new("lamp", ["grey"]);
        let glow = builder.material("glow", Material::new(vec![0.0], vec![1.0]).expect("a material"));
        let disk = Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a disk");
        builder.surface("lamp", Arc::new(disk), &glow);
        let scene = builder.build().expect("a scene");
        let elements = Elements::new(&scene, &Discretization::uniform(0, 1)).expect("a disk has area");
        let visibility = Visibility::new(&scene, Shadows::Auto, 1e-3);
        let receiver = ReceiverPoint::free(DVec3::new(0.2, 0.1, -0.3), DVec3::Z);
        let tree = Tree::uniform(&elements.list()[0], 1.0);
        let occluders = Occluders::new(&visibility, [tree.sender()].into_iter(), &receiver.site());
        let mut traversal = Traversal::new(&receiver, &visibility, &occluders);
        let mut light = [0.0];
        traversal.add(0, &tree, 0.0, &mut light);
        assert_eq!(light, [0.0]);
        // As many as are near, in the sense of the rules.
        assert!(traversal.visited < 500, "{} cells", traversal.visited);
    }
}
