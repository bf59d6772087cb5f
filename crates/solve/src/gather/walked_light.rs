//! Light at a point by walks, which owes nothing to the polynomials of a solution.
//!
//! ```text
//! E(x) = ⟨ M(y) + ρ E(y) + τ E′(y) ⟩        W m⁻² ,    y what a cosine-distributed ray from x meets first ,
//! ```
//!
//! with the exitance M, and the irradiance E′ of the other side of what lets light through; a walk chooses between
//! both sides in proportion to ρ and τ. From each place y that it comes to, one ray goes to a point z of an emitter,
//! of density q(z), and with the probability p = min(1, k w) a cosine-distributed one goes on, of density κ(y, z);
//! w is the largest product of reflectances so far over these probabilities. Exitance that both find is divided
//! among them by the power heuristic:
//!
//! ```text
//! M V κ q / (q² + p² κ²)   by the ray to the emitter ,      M p κ² / (q² + p² κ²)   by the one that goes on .
//! ```
//!
//! Walks may end before, at light that the polynomials S_h are trusted with (`super::trusted_light`): they add S_h, and
//! the direct light by the ray to the emitter alone. Of many readings direct light of what is far is that of cells
//! (`super::lit_cells`), with which exitance that is met next is counted. Those that only find the light of a narrow
//! gap end outside of it, at the polynomials of all light.
//!
//! No weight exceeds 1/k by going on, so the variance is finite for any reflectance. A walk of n surfaces of the
//! reflectance ρ takes some log(k)/(1 − ρ) + 1/(1 − ρ) steps; beyond `LONGEST` it is given up, and what is read with
//! it is told to have no accuracy.
//!
//! References: E. Veach, *Robust Monte Carlo methods for light transport simulation*, 1997, chapters 9 and 10;
//! E. Veach, L. Guibas, SIGGRAPH 1995, 419-428 (the power heuristic).

use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::{number_of, shift};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_work::interruption::check_interrupt;
use smallvec::SmallVec;

use crate::gather::lit_cells::LitCells;
use crate::gather::sent_rays::{Met, SentRays};
use crate::gather::trusted_light::{WalkEnds, is_trusted};
use crate::solution::{Solution, SurfacePlace};

/// k in p = min(1, k w). Measured: the factor of the least variance in equal time on most of 17 scenes
/// (`docs/theory/error.md`).
const GOING_ON: f64 = 2.0;

/// Most surfaces on a walk. Chosen: where a ten-thousandth is absorbed all but 10⁻¹¹ of the walks are shorter.
const LONGEST: u64 = 1 << 18;

/// Numbers in [0, 1) that choose what a walk does at a surface.
#[derive(Clone, Copy)]
pub(super) struct Draws {
    /// Direction of the cosine-distributed ray.
    pub(super) direction: [f64; 2],
    /// Emitter, and point on it.
    pub(super) target: [f64; 3],
    /// Whether the walk goes on.
    pub(super) dice: f64,
}

impl Draws {
    /// Numbers that follow from `chance`.
    pub(super) fn of(chance: u64) -> Self {
        let [polar, turn, choice, s] = shift(chance);
        let [t, dice] = shift(number_of([f64::from_bits(chance)]));
        Self { direction: [polar, turn], target: [choice, s, t], dice }
    }
}

/// Part of the light of each band that is left.
type Weights = SmallVec<[f64; 4]>;

/// Sums over walks.
pub(super) struct Scores<'s> {
    /// Irradiance per band (W m⁻²).
    pub(super) sums: &'s mut [f64],
    /// Surfaces that walks came to.
    pub(super) surfaces: u64,
    /// Whether no walk was given up.
    pub(super) are_whole: bool,
}

/// Walks among the surfaces of a scene.
pub(super) struct WalkedLight<'a> {
    solution: &'a Solution,
    rays: &'a SentRays<'a>,
    /// Direct light of what is far away, where it is wanted.
    lit_cells: &'a LitCells,
    ends: WalkEnds,
}

impl<'a> WalkedLight<'a> {
    pub(super) fn new(
        solution: &'a Solution,
        rays: &'a SentRays<'a>,
        lit_cells: &'a LitCells,
        ends: WalkEnds,
    ) -> Self {
        Self { solution, rays, lit_cells, ends }
    }

    /// Adds the light that the place `met` reflects and lets through, `weight` times, by a walk from there: `draws`
    /// choose what it does at first, `chance` the rest.
    pub(super) fn add(
        &self,
        mut met: Met,
        weight: f64,
        mut draws: Draws,
        mut chance: u64,
        scores: &mut Scores,
    ) {
        let mut weights: Weights = SmallVec::from_elem(weight, scores.sums.len());
        // The weights of starts differ over a patch; the share of a walk in what is read begins with 1.
        let least = GOING_ON / weight;
        for _ in 0..LONGEST {
            check_interrupt();
            scores.surfaces += 1;
            let Some(there) = self.left(&met, chance, &mut weights) else { return };
            let lit = self.by_cells(&met, &there);
            match self.ends {
                WalkEnds::Trusted { .. } if is_trusted(self.rays, &met, &there) => {
                    self.add_held(&met, &there, &weights, scores.sums, Solution::indirect_bands);
                    match lit {
                        Some(lit) => add_weighted(lit, &weights, scores.sums),
                        None => self.add_direct(&there, &weights, 0.0, &draws, chance, scores.sums),
                    }
                    return;
                }
                WalkEnds::OutOfGap(own) if !own.contains(&met.place.surface) => {
                    self.add_held(&met, &there, &weights, scores.sums, Solution::irradiance_bands);
                    return;
                }
                _ => {}
            }
            let part = (least * largest(&weights)).min(1.0);
            match lit {
                Some(lit) => add_weighted(lit, &weights, scores.sums),
                None => self.add_direct(&there, &weights, part, &draws, chance, scores.sums),
            }
            if draws.dice >= part {
                return;
            }
            let Some(next) = self.rays.met(&there, lambert(there.normal, draws.direction)) else { return };
            if lit.is_none() {
                self.add_exitance(&there, &next, &weights, part, scores.sums);
            }
            weights.iter_mut().for_each(|weight| *weight /= part);
            chance = number_of([f64::from_bits(chance), 3.0]);
            (met, draws) = (next, Draws::of(chance));
        }
        scores.are_whole = false;
    }

    /// Direct light per band (W m⁻²) at the side `there` of what a ray met, by cells; None where it is not to be taken
    /// from them.
    fn by_cells(&self, met: &Met, there: &ReceiverPoint) -> Option<&'a [f64]> {
        let is_wanted =
            matches!(self.ends, WalkEnds::Trusted { by_cells: true }) && there.normal.dot(met.normal) > 0.0;
        let lit = || self.lit_cells.at(self.solution, self.rays, met.element, &met.place, met.distance);
        if is_wanted { lit() } else { None }
    }

    /// The side of a surface from which a walk goes on, with the weights that are left of it; None where nothing
    /// is.
    fn left(&self, met: &Met, chance: u64, weights: &mut Weights) -> Option<ReceiverPoint> {
        let solution = self.solution;
        let Met { element, place, .. } = met;
        let coatings = || solution.bands().iter().map(|band| &band.coating);
        let reflected: Weights = weights
            .iter()
            .zip(coatings())
            .map(|(weight, own)| weight * own.reflectance_at(*element, place.parameters))
            .collect();
        let Some((_, beyond)) = solution.behind(*element, place) else {
            *weights = reflected;
            return (largest(weights) > 0.0).then(|| met.there());
        };
        let through: Weights = weights
            .iter()
            .zip(coatings())
            .map(|(weight, own)| weight * own.transmittance(*element))
            .collect();
        let ways = [largest(&reflected), largest(&through)];
        if ways == [0.0; 2] {
            return None;
        }
        let share = ways[0] / (ways[0] + ways[1]);
        let [choice]: [f64; 1] = shift(number_of([f64::from_bits(chance), 4.0]));
        if choice < share {
            *weights = reflected.iter().map(|weight| weight / share).collect();
            return Some(met.there());
        }
        *weights = through.iter().map(|weight| weight / (1.0 - share)).collect();
        Some(met.beyond(&beyond))
    }

    /// Adds the polynomials `of` reflected light, S_h ≥ 0, or of all light at the side `there` of what a ray met.
    fn add_held(
        &self,
        met: &Met,
        there: &ReceiverPoint,
        weights: &Weights,
        sums: &mut [f64],
        of: impl Fn(&Solution, usize, &SurfacePlace, &mut [f64]),
    ) {
        let mut held: Weights = SmallVec::from_elem(0.0, sums.len());
        let solution = self.solution;
        let own = (met.element, met.place);
        let is_front = there.normal.dot(met.normal) > 0.0;
        let side = if is_front { Some(own) } else { solution.behind(met.element, &met.place) };
        let (element, place): (usize, SurfacePlace) = side.unwrap_or(own);
        of(solution, element, &place, &mut held);
        for ((sum, weight), held) in sums.iter_mut().zip(weights).zip(held) {
            *sum += weight * held.max(0.0);
        }
    }

    /// Adds direct light by a ray to a luminaire, and by one to an emitter beside the part `part` of
    /// cosine-distributed ones.
    fn add_direct(
        &self,
        there: &ReceiverPoint,
        weights: &Weights,
        part: f64,
        draws: &Draws,
        chance: u64,
        sums: &mut [f64],
    ) {
        if !self.rays.points.is_empty() {
            let mut lit: Weights = SmallVec::from_elem(0.0, sums.len());
            let own = number_of([f64::from_bits(chance), 1.0]);
            self.rays.points.add_one(there, self.rays.visibility, 1.0, own, &mut lit);
            sums.iter_mut().zip(weights).zip(lit).for_each(|((sum, weight), lit)| *sum += weight * lit);
        }
        let shares = self.rays.lamps.seen_from(there);
        if shares.is_empty() {
            return;
        }
        let Some(lamp) = self.rays.shining(there, &shares.target(draws.target)) else { return };
        let beside = part * lamp.kernel / lamp.density;
        let share = lamp.relative * lamp.kernel / lamp.density / (1.0 + beside * beside);
        self.add_emitted(lamp.element, share, weights, sums);
    }

    /// Adds the exitance of what a ray meets that goes on from `from` with the probability `part`, beside a ray to
    /// the emitters.
    fn add_exitance(&self, from: &ReceiverPoint, met: &Met, weights: &Weights, part: f64, sums: &mut [f64]) {
        if self.solution.bands().iter().all(|band| band.coating.exitance[met.element] == 0.0) {
            return;
        }
        let density = self.rays.lamps.seen_from(from).density(met.element);
        let beside = density / met.kernel(from);
        let share = self.rays.relative(met) * part / (part * part + beside * beside);
        self.add_emitted(met.element, share, weights, sums);
    }

    /// Adds so much of the exitance of an element.
    fn add_emitted(&self, element: usize, share: f64, weights: &Weights, sums: &mut [f64]) {
        for ((sum, weight), band) in sums.iter_mut().zip(weights).zip(self.solution.bands()) {
            *sum += share * weight * band.coating.exitance[element];
        }
    }
}

/// Adds light per band (W m⁻²) times the weights that are left.
fn add_weighted(light: &[f64], weights: &Weights, sums: &mut [f64]) {
    sums.iter_mut().zip(weights).zip(light).for_each(|((sum, weight), light)| *sum += weight * light);
}

/// The largest weight.
fn largest(weights: &Weights) -> f64 {
    weights.iter().copied().fold(0.0, f64::max)
}
