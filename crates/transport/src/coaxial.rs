//! Coaxial surfaces of revolution whose exchange the rule of [`radiosity_kernel::rules::coaxial`] knows:
//! nothing but a coaxial cylinder hides a part of one from the other.
//!
//! The segment between two points keeps to the heights between them, and no farther from the axis than the
//! farther one. So of what may stand between two surfaces, coaxial ones hide nothing that end below or above
//! all of both, that lie no nearer to the axis than either, or that lie within the widest cylinder, the core.
//! Cylinders of the radius of the core, those of the pair included, have to cover all heights of both. Anything
//! else that may stand between, and surfaces that hide parts of themselves, leave the pair to other rules and
//! to rays; so do pairs that nothing stands between and of which neither is an outside, whose angles nothing
//! limits: there the others are as good.

use radiosity_elements::Element;
use radiosity_geom::{Meridian, ROUNDING};
use radiosity_kernel::PairKind;
use radiosity_kernel::blocks::block::Block;
use radiosity_kernel::rules::coaxial::Coaxial;
use radiosity_visibility::Visibility;

/// Parameters u of an element that goes as far round as its surface does.
const ROUND: [f64; 2] = [-1.0, 1.0];

/// Surfaces that stand between two coaxial ones.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Between<'a> {
    /// Surfaces that may.
    pub blockers: &'a [usize],
    /// Surfaces of the pair that may hide a part of it themselves.
    pub own: &'a [usize],
}

/// The block of two elements that carry constants and go all the way round one axis, where the rule knows it,
/// to the relative accuracy `eps`. None too where nothing stands between and the rule does not reach it: others
/// may.
pub(crate) fn block(
    pair: [&Element; 2],
    between: Between,
    visibility: &Visibility,
    eps: f64,
) -> Option<Block> {
    let is_ring =
        |element: &Element| element.basis.len() == 1 && element.is_cell() && element.rect.u == ROUND;
    if !pair.iter().all(|element| is_ring(element)) {
        return None;
    }
    let [first, second] = pair
        .map(|element| visibility.meridian(element.surface).map(|meridian| meridian.part(element.rect.v)));
    let is_same = pair[0].surface == pair[1].surface && pair[0].rect == pair[1].rect;
    let meridians = [first?, second?];
    let coaxial = coaxial(meridians, is_same, pair.map(|element| element.surface), between, visibility)?;
    let found = coaxial.exchange(eps);
    if coaxial.core == 0.0 && found.error > eps * found.value {
        return None;
    }
    let unit = (pair[0].area * pair[1].area).sqrt();
    let kind = if is_same { PairKind::Same } else { PairKind::Separated };
    let mut block = Block::exact(vec![found.value / unit], kind, found.samples);
    (block.report.error, block.report.partly_hidden) = (found.error / unit, coaxial.core > 0.0);
    Some(block)
}

/// For each surface, whether it is best left uncut, as the rule knows what wholes exchange: those of which a
/// coaxial cylinder hides a part from another one, and those whose exchange with one of these the rule knows.
pub(crate) fn best_whole(visibility: &Visibility, surfaces: usize) -> Vec<bool> {
    let known = known_pairs(visibility, surfaces);
    let mut are_hidden = vec![false; surfaces];
    for (pair, _) in known.iter().filter(|(_, found)| found.core > 0.0) {
        pair.iter().for_each(|surface| are_hidden[*surface] = true);
    }
    let mut are_whole = are_hidden.clone();
    for (pair, _) in known.iter().filter(|(pair, _)| pair.iter().any(|surface| are_hidden[*surface])) {
        pair.iter().for_each(|surface| are_whole[*surface] = true);
    }
    are_whole
}

/// The pairs of whole surfaces that the rule knows.
fn known_pairs(visibility: &Visibility, surfaces: usize) -> Vec<([usize; 2], Coaxial)> {
    let rings: Vec<usize> = (0..surfaces).filter(|own| visibility.meridian(*own).is_some()).collect();
    let known = |pair: [usize; 2]| Some((pair, of_surfaces(pair, visibility)?));
    let pairs = rings
        .iter()
        .enumerate()
        .flat_map(|(place, first)| rings[place..].iter().filter_map(move |second| known([*first, *second])));
    pairs.collect()
}

/// Whether the rule knows the exchange of two whole surfaces.
pub(crate) fn knows(pair: [usize; 2], visibility: &Visibility) -> bool {
    of_surfaces(pair, visibility).is_some()
}

/// The coaxial pair of two whole surfaces, if the rule knows it.
fn of_surfaces(pair @ [i, j]: [usize; 2], visibility: &Visibility) -> Option<Coaxial> {
    let meridians = [visibility.meridian(i)?, visibility.meridian(j)?];
    meridians[1].beside(&meridians[0])?;
    let hulls = pair.map(|surface| visibility.hull(surface));
    let blockers = visibility.candidates(hulls[0], hulls[1], pair);
    let own = visibility.hiding_themselves(pair, hulls);
    let between = Between { blockers: &blockers, own: &own };
    coaxial(meridians, i == j, pair, between, visibility)
}

/// The coaxial pair of two meridians on these surfaces, if the rule knows it.
fn coaxial(
    [first, second]: [Meridian; 2],
    is_same: bool,
    surfaces: [usize; 2],
    Between { blockers, own }: Between,
    visibility: &Visibility,
) -> Option<Coaxial> {
    let pair = [first, second.beside(&first)?];
    if !own.is_empty() {
        return None;
    }
    let along = |surface: &usize| visibility.meridian(*surface)?.beside(&first);
    let others: Vec<Meridian> = blockers.iter().map(along).collect::<Option<_>>()?;
    let space = Space::of(&pair);
    let inner: Vec<Meridian> = others.into_iter().filter(|other| space.holds(other)).collect();
    if inner.is_empty() {
        let has_horizon = pair.iter().any(|own| own.normal.x > 0.0);
        return has_horizon.then_some(Coaxial { pair, is_same, core: 0.0 });
    }
    let core = inner.iter().map(|other| other.radii()[1]).fold(0.0, f64::max);
    let walls = inner.into_iter().chain(surfaces.iter().filter_map(along));
    let is_wall = |wall: &Meridian| wall.radii().iter().all(|r| (r - core).abs() <= ROUNDING * core);
    let walls: Vec<[f64; 2]> = walls.filter(is_wall).map(|wall| wall.heights()).collect();
    (core <= space.nearest && space.are_covered(walls)).then_some(Coaxial { pair, is_same, core })
}

/// The space that the segments between two coaxial surfaces may pass.
struct Space {
    /// Range of heights.
    heights: [f64; 2],
    /// Largest distance from the axis, and the least of either surface.
    farthest: f64,
    nearest: f64,
    /// Length that is rounding.
    rounding: f64,
}

impl Space {
    fn of(pair: &[Meridian; 2]) -> Self {
        let [a, b] = pair.map(|own| own.heights());
        let [r, s] = pair.map(|own| own.radii());
        let rounding = ROUNDING * pair[0].size().max(pair[1].size());
        Self {
            heights: [a[0].min(b[0]), a[1].max(b[1])],
            farthest: r[1].max(s[1]),
            nearest: r[0].min(s[0]) + rounding,
            rounding,
        }
    }

    /// Whether a part of a coaxial surface lies in it, but for its border.
    fn holds(&self, other: &Meridian) -> bool {
        let ([low, high], [bottom, top]) = (other.heights(), self.heights);
        let [least, _] = other.radii();
        low < top - self.rounding && high > bottom + self.rounding && least < self.farthest - self.rounding
    }

    /// Whether ranges together cover all heights.
    fn are_covered(&self, mut ranges: Vec<[f64; 2]>) -> bool {
        ranges.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let [bottom, top] = self.heights;
        let reach = |reached: f64, [low, high]: [f64; 2]| {
            if low <= reached + self.rounding { reached.max(high) } else { reached }
        };
        ranges.into_iter().fold(bottom, reach) >= top - self.rounding
    }
}
