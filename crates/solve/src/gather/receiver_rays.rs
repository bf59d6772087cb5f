//! The rays of a receiver: cosine-distributed ones, and those that are aimed at emitters and at what glows.
//!
//! Of N cosine-distributed rays from x each first meets the front of a surface at y; M = N/2 further ones go
//! to points y of the emitters, of density q(y) (`light::lamps`). With the density κ(x, y) of the former and
//! both combined by the balance heuristic,
//!
//! ```text
//! E(x) ≈ 1/N Σ_cosine ( ρ E₁(y) + E₀(y) κ/(κ + q M/N) )  +  1/N Σ_emitters E₀(y) V κ/(κ + q M/N)     W m⁻² ,
//! ```
//!
//! E₁(y) the irradiance of y (`super::met_light`, `super::walked_light`). What surfaces that glow reflect is found by
//! as many rays to them as go to emitters, in the same way (`super::glow`). Over a patch x is spread over it.
//!
//! The light of luminaires at x is exact ([`radiosity_light::point_lights`]); over a patch that of one of them is
//! found by a ray from each x.
//!
//! References: P. Shirley, C. Wang, K. Zimmerman, *Monte Carlo techniques for direct lighting calculations*,
//! ACM TOG 15 (1996); E. Veach, L. Guibas, SIGGRAPH 1995, 419-428 (the balance heuristic).

use std::ops::Range;

use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_geom::DVec3;
use radiosity_light::lamps::Shares;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_work::interruption::check_interrupt_at;

use crate::gather::known_lamps::FarLamps;
use crate::gather::met_light::{Ending, MetLight};
use crate::gather::receiver::Receiver;
use crate::gather::sent_rays::{AimedRays, Met, RayMix, SentRays};
use crate::gather::trusted_light::WalkEnds;
use crate::gather::walked_light::{Draws, Scores, WalkedLight};

/// Rays to emitters, and to what glows, for each cosine-distributed one, M/N.
const TO_LAMPS: f64 = 0.5;

/// How the light is found that is reflected where a ray ends.
#[derive(Clone, Copy)]
pub(super) enum Onward {
    /// There.
    Ends(Ending),
    /// By walks.
    Walks(WalkEnds),
}

/// Rays from a receiver.
pub(super) struct ReceiverRays<'s> {
    light: &'s MetLight<'s>,
    origin: &'s Receiver,
    onward: Onward,
    /// Emitters as targets; None where their light is known.
    lamps: Option<Shares<'s>>,
    /// Emitters whose light is found apart.
    far: Option<FarLamps<'s>>,
    /// Elements that glow for it, as targets.
    glowing: Shares<'s>,
    /// Light of the luminaires at a point (W m⁻² per band); None over patches, and where it is known.
    lit: Option<Vec<f64>>,
}

/// Where a cosine-distributed ray starts.
struct Start {
    receiver: ReceiverPoint,
    /// Weight of its light in that of the whole receiver.
    weight: f64,
    direction: DVec3,
}

impl<'s> ReceiverRays<'s> {
    /// Rays that find the reflected light of a receiver, `onward` from what they meet.
    pub(super) fn reflected(light: &'s MetLight<'s>, origin: &'s Receiver, onward: Onward) -> Self {
        let glowing = light.glow.seen_from(&origin.middle());
        Self { light, origin, onward, lamps: None, far: None, glowing, lit: None }
    }

    /// Rays that find all light of a receiver.
    pub(super) fn all(light: &'s MetLight<'s>, origin: &'s Receiver, onward: Onward) -> Self {
        let far = light.known_lamps.far_from(&light.rays, origin);
        let is_left = |element: usize| far.as_ref().is_none_or(|far| !far.hold(element));
        let lamps = Some(light.rays.lamps.seen_among(&origin.witnesses(), is_left));
        Self { lamps, far, lit: lit(light, origin), ..Self::reflected(light, origin, onward) }
    }

    /// The number from which whatever is chosen follows.
    pub(super) fn number(&self) -> u64 {
        let middle = self.origin.middle();
        let [position, normal] = [middle.position, middle.normal].map(|vector| vector.to_array());
        number_of(position.into_iter().chain(normal))
    }

    /// Adds the light by the rays of these indices of the sequence that `number` chooses, those that are aimed
    /// beside the cosine-distributed ones.
    pub(super) fn add(&self, number: u64, rays: Range<u64>, scores: &mut Scores) {
        match self.onward {
            Onward::Ends(ending) => self.send_around(ending, number, rays.clone(), scores.sums),
            Onward::Walks(ends) => self.walk_around(ends, number, rays.clone(), scores),
        }
        let [first, end] = [rays.start, rays.end].map(|count| (count as f64 * TO_LAMPS) as u64);
        if !self.glowing.is_empty() {
            self.send_to_glowing(number, first..end, scores);
        }
        if let Some(lamps) = &self.lamps {
            self.add_points(number, rays, scores.sums);
            if !lamps.is_empty() {
                self.send_to_lamps(lamps, number, first..end, scores.sums);
            }
        }
    }

    /// Emitters whose light is found apart, by rays to them alone.
    pub(super) fn far(&self) -> Option<&FarLamps<'s>> {
        self.far.as_ref()
    }

    /// Adds the light of what is far by the rays of these indices.
    pub(super) fn add_far(&self, far: &FarLamps, number: u64, rays: Range<u64>, scores: &mut Scores) {
        far.add(&self.light.rays, self.origin, number, rays, scores.sums);
    }

    /// Adds `factor` times the exitance of what a cosine-distributed ray met, unless it is found apart.
    fn add_emitted(&self, receiver: &ReceiverPoint, met: &Met, factor: f64, sums: &mut [f64]) {
        if !self.far.as_ref().is_some_and(|far| far.hold(met.element)) {
            self.light.add_emitted_by(receiver, met, self.to_lamps(), factor, sums);
        }
    }

    fn to_lamps(&self) -> Option<AimedRays<'_>> {
        self.lamps.as_ref().map(|shares| AimedRays { shares, ratio: TO_LAMPS })
    }

    fn to_glowing(&self) -> AimedRays<'_> {
        AimedRays { shares: &self.glowing, ratio: TO_LAMPS }
    }

    /// Sends the cosine-distributed rays of these indices.
    fn send_around(&self, ending: Ending, number: u64, rays: Range<u64>, sums: &mut [f64]) {
        let light = self.light;
        let offset: [f64; 4] = shift(number);
        let mut radiosity = vec![0.0; sums.len()];
        for index in rays {
            let turned = || shifted(kronecker::point(index), &[offset[0], offset[1]]);
            let Start { receiver, weight, direction } = self.start(index, &offset, turned);
            radiosity.fill(0.0);
            check_interrupt_at(index);
            let chance = number_of([f64::from_bits(number), index as f64]);
            if let Some(met) = light.rays.met(&receiver, direction) {
                let left = self.to_glowing().left(&receiver, &met);
                light.add_reflected_by(&met, ending.of_ray(chance), left, &mut radiosity);
                self.add_emitted(&receiver, &met, 1.0, &mut radiosity);
            }
            sums.iter_mut().zip(&radiosity).for_each(|(sum, radiosity)| *sum += weight * radiosity);
        }
    }

    /// Begins the walks of these indices.
    fn walk_around(&self, ends: WalkEnds, number: u64, walks: Range<u64>, scores: &mut Scores) {
        let rays = &self.light.rays;
        let offset: [f64; 4] = shift(number);
        let further: [f64; 8] = offsets(number);
        let walked = self.walked(ends);
        for index in walks {
            if !scores.are_whole {
                return;
            }
            let [a, b, polar, turn, choice, s, t, dice] = shifted(kronecker::point(index), &further);
            let Start { receiver, weight, direction } = self.start(index, &offset, || [a, b]);
            let Some(met) = rays.met(&receiver, direction) else { continue };
            self.add_emitted(&receiver, &met, weight, scores.sums);
            let weight = weight * self.to_glowing().left(&receiver, &met);
            let draws = Draws { direction: [polar, turn], target: [choice, s, t], dice };
            let chance = number_of([f64::from_bits(number), index as f64]);
            walked.add(met, weight, draws, chance, scores);
        }
    }

    /// Walks from what rays meet.
    fn walked(&self, ends: WalkEnds) -> WalkedLight<'_> {
        WalkedLight::new(self.light.sent, &self.light.rays, &self.light.lit_cells, ends)
    }

    /// Sends rays of these indices to what glows.
    fn send_to_glowing(&self, number: u64, rays: Range<u64>, scores: &mut Scores) {
        let number = number_of([f64::from_bits(number), 6.0]);
        let [a, b, c, d, e, ..]: [f64; 8] = offsets(number);
        for index in rays {
            check_interrupt_at(index);
            let (receiver, weight) = self.origin.at(shifted(kronecker::point(index), &[d, e]));
            let target = self.glowing.target(shifted(kronecker::point(index), &[a, b, c]));
            let Some(met) = self.light.rays.met_at(&receiver, &target) else { continue };
            let weight = weight * target.place.weight * self.to_glowing().left(&receiver, &met);
            let chance = number_of([f64::from_bits(number), index as f64]);
            match self.onward {
                Onward::Ends(ending) => {
                    self.light.add_reflected_by(&met, ending.of_ray(chance), weight, scores.sums);
                }
                Onward::Walks(ends) => {
                    let further = number_of([f64::from_bits(chance), 5.0]);
                    self.walked(ends).add(met, weight, Draws::of(chance), further, scores);
                }
            }
        }
    }

    /// Sends rays of these indices to the emitters.
    fn send_to_lamps(&self, lamps: &Shares, number: u64, rays: Range<u64>, sums: &mut [f64]) {
        let [a, b, c, d] = shift(number_of([f64::from_bits(number)]));
        let [s] = shift(number_of([f64::from_bits(number), 1.0]));
        let mix = RayMix { cosine: 1.0, to_lamps: TO_LAMPS };
        for index in rays {
            let (receiver, weight) = self.origin.at(shifted(kronecker::point(index), &[d, s]));
            let target = lamps.target(shifted(kronecker::point(index), &[a, b, c]));
            self.light.add_lamp(&receiver, &target, mix, weight, sums);
        }
    }

    /// Adds the light of the luminaires for the cosine-distributed rays of these indices: at a point that is
    /// known; over a patch that of a ray from each point where one of those starts.
    fn add_points(&self, number: u64, rays: Range<u64>, sums: &mut [f64]) {
        if let Some(lit) = &self.lit {
            let count = (rays.end - rays.start) as f64;
            sums.iter_mut().zip(lit).for_each(|(sum, lit)| *sum += count * lit);
            return;
        }
        let [s, t] = shift(number);
        for index in rays {
            let (receiver, weight) = self.origin.at(shifted(kronecker::point(index), &[s, t]));
            let chance = number_of([f64::from_bits(number), index as f64, 1.0]);
            let SentRays { points, visibility, .. } = &self.light.rays;
            points.add_one(&receiver, visibility, weight, chance, sums);
        }
    }

    /// The start of a ray of this index: over a patch its place and its direction come from one sequence in four
    /// dimensions with the shifts `offset`, at a point the numbers `turned` give the direction.
    fn start(&self, index: u64, offset: &[f64; 4], turned: impl FnOnce() -> [f64; 2]) -> Start {
        let (place, direction) = match self.origin {
            Receiver::Point(_) => ([0.5; 2], turned()),
            Receiver::Patch(..) => {
                let [s, t, polar, turn] = shifted(kronecker::point(index), offset);
                ([s, t], [polar, turn])
            }
        };
        let (receiver, weight) = self.origin.at(place);
        Start { receiver, weight, direction: lambert(receiver.normal, direction) }
    }
}

/// The light of the luminaires at a receiver that is a point.
fn lit(light: &MetLight, origin: &Receiver) -> Option<Vec<f64>> {
    let Receiver::Point(receiver) = origin else { return None };
    let mut lit = vec![0.0; light.scale.len()];
    light.rays.points.add(receiver, light.rays.visibility, &mut lit);
    Some(lit)
}

/// Shifts of a sequence in eight dimensions.
fn offsets(number: u64) -> [f64; 8] {
    let [first, second]: [[f64; 4]; 2] = [4.0, 5.0].map(|k| shift(number_of([f64::from_bits(number), k])));
    std::array::from_fn(|k| if k < 4 { first[k] } else { second[k - 4] })
}
