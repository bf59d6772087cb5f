//! Light at a point by rays, with an error that is known.
//!
//! Of N cosine-distributed rays from x each first meets the front of a surface at y; M = N/2 further ones go
//! to points y of the emitters, of density q(y) (`light::lamps`). With the density κ(x, y) of the former and
//! both combined by the balance heuristic,
//!
//! ```text
//! E(x) ≈ 1/N Σ_cosine ( ρ E₁(y) + E₀(y) κ/(κ + q M/N) )  +  1/N Σ_emitters E₀(y) V κ/(κ + q M/N)     W m⁻² .
//! ```
//!
//! E₁(y) = S_h(y) + E₀(z) V κ(y, z)/q(z) is the irradiance of y: S_h ≥ 0, the polynomials of the light that
//! was reflected at least once, and the direct light by one ray to a point z of an emitter, so that shadow
//! edges are sharp there too. The polynomials E_h of all light take its place near an emitter, where one ray
//! says little, and on elements that are small as seen from x: these are right in the mean. Where only
//! reflected light is gathered, for pictures, they are left only on elements that x nearly touches. The
//! estimate has no bias beside that of these polynomials; emitters may be near or far, curved, partly hidden.
//! Over a patch x is spread over it. Eight sequences, shifted independently, tell the standard deviation s of
//! their mean; rays are doubled until s is below the accuracy asked for, or many times the usual number are
//! sent.
//!
//! What surfaces that glow reflect is found by as many rays to them as go to emitters, in the same way
//! (`super::glow`).
//!
//! The light of luminaires at x is exact ([`radiosity_light::point_lights`]); E₁(y) has that of one of them,
//! by a ray.
//!
//! *Trusted*, readings of all light at y that may be far from what polynomials say, y on a large element beside x
//! or near an emitter, go on from there (`super::trusted_light`), and take polynomials of all light nowhere.
//!
//! Gathered twice, E₁(y) is itself estimated so, by one ray of either kind.
//!
//! *Walked*, what is reflected at y is added by a walk from there (`super::walked_light`): nothing of the polynomials
//! is left, and the mean has no bias but that of stopping where eight sequences agree. Walks are doubled while they
//! come to few surfaces; what is read with too few tells a deviation that is too large.
//!
//! References: P. Shirley, C. Wang, K. Zimmerman, *Monte Carlo techniques for direct lighting calculations*,
//! ACM TOG 15 (1996); E. Veach, L. Guibas, SIGGRAPH 1995, 419-428 (the balance heuristic).

use std::ops::Range;

use radiosity_elements::Element;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_geom::DVec3;
use radiosity_light::direct::DirectLight;
use radiosity_light::lamps::{Lamps, Shares, Target};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_light::tolerances::DARK;
use radiosity_transport::tolerances::BATCHES;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt_at;

use crate::gather::bends::{Part, SentLight, bends};
use crate::gather::glow::glowing;
use crate::gather::ray_count::{MOST_SURFACES, most_rays, most_walks};
use crate::gather::read_irradiance::{Deviation, ReadIrradiance};
use crate::gather::receiver::Receiver;
use crate::gather::sent_rays::{AimedRays, LampLight, Met, RayMix, SentRays};
use crate::gather::walked_light::{Draws, Scores, WalkedLight};
use crate::solution::{Solution, SurfacePlace};

/// Cosine-distributed rays of each sequence before the error is first looked at; in pictures, where readings
/// beside each other are averaged. Half of the former took errors of 2 % for 1 % at bright points of a
/// classroom.
const FIRST: u64 = 64;
const FIRST_OF_MANY: u64 = 32;

/// [`FIRST`] of walks. Chosen: a few of them bring much of the light, and without any the error looks small. As many
/// are sent at once at first, in case that they are long.
const FIRST_WALKS: u64 = 256;
const FEWEST_WALKS: u64 = 16;

/// Factor on the standard deviation of so few sequences where it decides that rays are enough: those whose
/// sequences agree by chance stop first. Measured in a classroom.
const CAUTION: f64 = 1.25;

/// Rays to emitters, and to what glows, for each cosine-distributed one, M/N.
const TO_LAMPS: f64 = 0.5;

/// Distance of an emitter, in its radii, within which polynomials say more of its light than one ray.
/// Measured in a shop with tubes: with 2 and 1 the readings took more rays, and erred more.
const NEAR: f64 = 4.0;

/// Square root of the area of an element, over its distance, up to which its polynomials are right in the
/// mean. Measured in a shop, a classroom and a temple: with 0.25 and 2 for 1 the error was the same, the time
/// up to twice as long and the same.
const SMALL: f64 = 1.0;

/// Bend of the light on an element up to which its polynomials are used. Measured in sixty random rooms of diffuse
/// lamps: without a limit the largest error of a room was 2.0 %, with 0.3 and 0.1 1.3 and 1.4 %, in the same time.
const SMOOTH: f64 = 0.3;

/// [`SMALL`] where only reflected light is gathered, for pictures: there polynomials are left only where
/// things nearly touch, and shadows matter most. Measured at the teapot: errors of 0.55, 0.50, 0.41 and 0.36
/// % in 14, 17, 23 and 28 s with polynomials everywhere, 10, 4 and 1.
const SMALL_BEHIND_PIXELS: f64 = 10.0;

/// Light that the surfaces reflect which rays meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// The polynomials of the solution.
    Polynomials,
    /// These where they are trusted, elsewhere rays that go on until they are.
    Trusted,
    /// Gathered in its turn by one ray of either kind.
    Gathered,
    /// By rays that go on until they end.
    Walked,
}

/// A solution whose light is gathered by rays.
#[derive(Debug)]
pub struct RayGather<'a> {
    /// Light that surfaces reflect.
    solution: &'a Solution,
    rays: SentRays<'a>,
    /// Elements that reflect much more than most (`super::glow`).
    glowing: Lamps,
    /// Direct light of points by cells; None where rays find it.
    direct: Option<DirectLight<'a>>,
    /// Bend of the light that each element reflects (`super::bends`).
    bends: Vec<f64>,
    /// Mean radiosity per band (W m⁻²).
    scale: Vec<f64>,
    eps: f64,
    /// Irradiance per band below which errors are to be small relative to this (W m⁻²).
    dark: Vec<f64>,
    beyond: Beyond,
}

/// Cosine-distributed rays of a receiver.
#[derive(Clone, Copy)]
struct Sending {
    /// Light of what they meet.
    beyond: Beyond,
    /// Rays of each sequence before the error is looked at.
    first: u64,
    held: Held,
}

impl Sending {
    /// Whether rays go on from what they meet.
    fn goes_on(&self) -> bool {
        matches!(self.beyond, Beyond::Walked | Beyond::Trusted)
    }

    /// Sources of the light where a ray ends.
    fn end_light(&self, chance: u64) -> EndLight {
        match self.beyond {
            Beyond::Polynomials => EndLight::Direct { chance, held: self.held },
            _ => EndLight::Gathered(chance),
        }
    }
}

/// Rays to what is bright, beside cosine-distributed ones.
#[derive(Clone, Copy)]
struct Aims<'s> {
    /// Emitters; None where their light is known.
    lamps: Option<&'s Shares<'s>>,
    /// Elements that glow.
    glowing: &'s Shares<'s>,
}

impl<'s> Aims<'s> {
    fn to_lamps(self) -> Option<AimedRays<'s>> {
        self.lamps.map(|shares| AimedRays { shares, ratio: TO_LAMPS })
    }

    fn to_glowing(self) -> AimedRays<'s> {
        AimedRays { shares: self.glowing, ratio: TO_LAMPS }
    }
}

/// Elements all of whose light is that of their polynomials.
#[derive(Clone, Copy)]
struct Held {
    /// Square root of the area of an element, over its distance, up to which it is.
    small: f64,
    /// Bend of the light on it up to which it is.
    smooth: f64,
}

/// Numbers of cosine-distributed rays of each sequence.
#[derive(Clone, Copy)]
struct RayCounts {
    /// Sent at once at first.
    first: u64,
    /// Least before the error is looked at.
    least: u64,
    /// Most of all sequences.
    most: u64,
}

/// Sources of the irradiance where a ray ends.
#[derive(Clone, Copy)]
enum EndLight {
    /// The polynomials of the element.
    Polynomials,
    /// Direct light by rays that `chance` chooses, the rest by the polynomials; all by these where it is `held`.
    Direct { chance: u64, held: Held },
    /// All by rays that this number chooses.
    Gathered(u64),
}

/// Light by the rays that were sent so far.
struct Estimate {
    /// Irradiance per band (W m⁻²).
    irradiance: Vec<f64>,
    deviation: Deviation,
    /// Deviation relative to the irradiance, or to what counts as dark, which decides whether it is small enough.
    missed: f64,
}

/// Where a cosine-distributed ray starts.
struct Start {
    receiver: ReceiverPoint,
    /// Weight of its light in that of the whole receiver.
    weight: f64,
    direction: DVec3,
}

impl<'a> RayGather<'a> {
    /// The light of `solution`, gathered to about the relative accuracy `eps`, with the light of what rays meet
    /// taken from `beyond`; where the number of reflections is limited, from the polynomials.
    pub fn new(solution: &'a Solution, visibility: &'a Visibility, eps: f64, beyond: Beyond) -> Self {
        let scale = solution.mean_radiosity();
        let beyond = if solution.is_truncated() { Beyond::Polynomials } else { beyond };
        // What is darker than most would take most of the walks, and counts little in the L2 mean.
        let dark = match beyond {
            Beyond::Walked => solution.mean_arriving(),
            _ => scale.iter().map(|scale| DARK * scale).collect(),
        };
        let usual = solution.mean_arriving();
        let bends = bends(solution, &usual, SentLight::All, Part::Highest);
        let glowing = glowing(solution, &usual);
        let rays = SentRays::among(solution.elements(), &solution.emitters(), visibility, &scale);
        Self { solution: solution.sent(), rays, glowing, direct: None, bends, scale, eps, dark, beyond }
    }

    /// As made, but errors are to be small relative to the irradiance `dark` (W m⁻² per band) where less arrives.
    pub(super) fn with_dark(self, dark: Vec<f64>) -> Self {
        Self { dark, ..self }
    }

    /// As made, but the direct light of points is taken from `direct`.
    pub(super) fn beside(self, direct: DirectLight<'a>) -> Self {
        Self { direct: Some(direct), ..self }
    }

    /// Rays among the surfaces.
    pub(super) fn rays(&self) -> &SentRays<'a> {
        &self.rays
    }

    /// Direct light (W m⁻² per band) of a point by cells; None where rays find it.
    pub(super) fn direct_by_cells(&self, receiver: &ReceiverPoint) -> Option<Vec<f64>> {
        let direct = self.direct.as_ref()?;
        Some(direct.irradiance(receiver, &direct.around(&receiver.site())))
    }

    /// All light of a receiver, by rays alone. It depends on nothing but the receiver.
    pub fn read(&self, origin: &Receiver) -> ReadIrradiance {
        let shares = self.rays.lamps.seen_from(&origin.middle());
        self.gathered(self.one(), origin, Some(&shares), &vec![0.0; self.scale.len()])
    }

    /// The reflected light of a receiver alone, accurate relative to this and the light `other` (W m⁻² per band).
    pub(super) fn reflected_alone(&self, origin: &Receiver, other: &[f64]) -> ReadIrradiance {
        self.gathered(self.one(), origin, None, other)
    }

    /// The reflected light of a point alone, one of many, accurate relative to this and the light `other` (W m⁻²
    /// per band); from polynomials where these are trusted.
    pub fn reflected(&self, receiver: &ReceiverPoint, other: &[f64]) -> ReadIrradiance {
        let beyond = if self.beyond == Beyond::Trusted { Beyond::Polynomials } else { self.beyond };
        let of_many = Sending {
            beyond,
            first: FIRST_OF_MANY,
            held: Held { small: SMALL_BEHIND_PIXELS, smooth: f64::INFINITY },
        };
        self.gathered(of_many, &Receiver::Point(*receiver), None, other)
    }

    /// Rays of a receiver on its own.
    fn one(&self) -> Sending {
        Sending { beyond: self.beyond, first: FIRST, held: Held { small: SMALL, smooth: SMOOTH } }
    }

    /// Numbers of rays, of which `first` are sent before the error is looked at where they do not go on.
    fn counts(&self, first: u64) -> RayCounts {
        match self.beyond {
            Beyond::Walked => {
                RayCounts { first: FEWEST_WALKS, least: FIRST_WALKS, most: most_walks(self.eps) }
            }
            _ => RayCounts { first, least: first, most: most_rays(self.eps) },
        }
    }

    /// Reflected light by these rays, and direct light where there are `shares`; `other` light (W m⁻² per band) arrives
    /// too.
    fn gathered(
        &self,
        sending: Sending,
        origin: &Receiver,
        shares: Option<&Shares>,
        other: &[f64],
    ) -> ReadIrradiance {
        let middle = origin.middle();
        let [position, normal] = [middle.position, middle.normal].map(|vector| vector.to_array());
        let number = number_of(position.into_iter().chain(normal));
        let bands = self.scale.len();
        let mut sums = vec![0.0; BATCHES * bands];
        let lit = shares.and(self.lit(origin));
        let aims = Aims { lamps: shares, glowing: &self.glowing.seen_from(&middle) };
        let RayCounts { first, least, most } = self.counts(sending.first);
        let (mut sent, mut now) = (0, first);
        let (mut surfaces, mut are_whole) = (0, true);
        loop {
            for (batch, sums) in sums.chunks_exact_mut(bands).enumerate() {
                let own = number.wrapping_add(batch as u64);
                let mut scores = Scores { sums, surfaces: 0, are_whole: true };
                if sending.goes_on() {
                    self.walk_around(origin, aims, own, sent..sent + now, &mut scores);
                } else {
                    self.send_around(sending, origin, aims, own, sent..sent + now, scores.sums);
                }
                let [first, end] = [sent, sent + now].map(|count| (count as f64 * TO_LAMPS) as u64);
                if !aims.glowing.is_empty() {
                    self.send_to_glowing(sending, origin, aims.glowing, own, first..end, &mut scores);
                }
                surfaces += scores.surfaces;
                are_whole &= scores.are_whole;
                if shares.is_some() {
                    self.add_points(origin, lit.as_deref(), own, sent..sent + now, scores.sums);
                }
                if let Some(shares) = shares.filter(|shares| !shares.is_empty()) {
                    self.send_to_lamps(origin, shares, own, first..end, scores.sums);
                }
            }
            sent += now;
            let Estimate { irradiance, mut deviation, missed } = self.estimate(&sums, sent, other);
            let is_last = BATCHES as u64 * 2 * sent > most || 2 * surfaces > MOST_SURFACES || !are_whole;
            if is_last || (sent >= least && CAUTION * missed <= self.eps) {
                if !are_whole {
                    (deviation.relative, deviation.absolute) = (f64::INFINITY, f64::INFINITY);
                }
                return ReadIrradiance { irradiance, deviation: Some(deviation) };
            }
            now = sent;
        }
    }

    /// Sends the cosine-distributed rays of these numbers.
    fn send_around(
        &self,
        sending: Sending,
        origin: &Receiver,
        aims: Aims,
        number: u64,
        rays: Range<u64>,
        sums: &mut [f64],
    ) {
        let offset: [f64; 4] = shift(number);
        let mut radiosity = vec![0.0; sums.len()];
        for index in rays {
            let Start { receiver, weight, direction } =
                start(origin, index, &offset, || shifted(kronecker::point(index), &[offset[0], offset[1]]));
            radiosity.fill(0.0);
            check_interrupt_at(index);
            let chance = number_of([f64::from_bits(number), index as f64]);
            if let Some(met) = self.rays.met(&receiver, direction) {
                let left = aims.to_glowing().left(&receiver, &met);
                self.add_reflected_by(&met, sending.end_light(chance), left, &mut radiosity);
                self.add_emitted_by(&receiver, &met, aims.to_lamps(), &mut radiosity);
            }
            sums.iter_mut().zip(&radiosity).for_each(|(sum, radiosity)| *sum += weight * radiosity);
        }
    }

    /// Sends rays to what glows, those that belong to the cosine-distributed ones of these numbers.
    fn send_to_glowing(
        &self,
        sending: Sending,
        origin: &Receiver,
        glowing: &Shares,
        number: u64,
        rays: Range<u64>,
        scores: &mut Scores,
    ) {
        let number = number_of([f64::from_bits(number), 6.0]);
        let [a, b, c, d, e, ..]: [f64; 8] = offsets(number);
        let aimed = AimedRays { shares: glowing, ratio: TO_LAMPS };
        let walked = self.walked();
        for index in rays {
            check_interrupt_at(index);
            let (receiver, weight) = origin.at(shifted(kronecker::point(index), &[d, e]));
            let target = glowing.target(shifted(kronecker::point(index), &[a, b, c]));
            let Some(met) = self.rays.met_at(&receiver, &target) else { continue };
            let weight = weight * target.place.weight * aimed.left(&receiver, &met);
            let chance = number_of([f64::from_bits(number), index as f64]);
            if sending.goes_on() {
                let further = number_of([f64::from_bits(chance), 5.0]);
                walked.add(met, weight, Draws::of(chance), further, scores);
            } else {
                self.add_reflected_by(&met, sending.end_light(chance), weight, scores.sums);
            }
        }
    }

    /// Walks from what rays meet.
    fn walked(&self) -> WalkedLight<'_> {
        WalkedLight::new(self.solution, &self.rays, self.beyond == Beyond::Trusted)
    }

    /// Begins the walks of these numbers.
    fn walk_around(
        &self,
        origin: &Receiver,
        aims: Aims,
        number: u64,
        walks: Range<u64>,
        scores: &mut Scores,
    ) {
        let offset: [f64; 4] = shift(number);
        let further: [f64; 8] = offsets(number);
        let walked = self.walked();
        for index in walks {
            if !scores.are_whole {
                return;
            }
            let [a, b, polar, turn, choice, s, t, dice] = shifted(kronecker::point(index), &further);
            let Start { receiver, weight, direction } = start(origin, index, &offset, || [a, b]);
            let Some(met) = self.rays.met(&receiver, direction) else { continue };
            let share = weight * self.rays.exitance_left(&receiver, &met, aims.to_lamps());
            for (sum, band) in scores.sums.iter_mut().zip(self.solution.bands()) {
                *sum += share * band.coating.exitance[met.element];
            }
            let weight = weight * aims.to_glowing().left(&receiver, &met);
            let draws = Draws { direction: [polar, turn], target: [choice, s, t], dice };
            let chance = number_of([f64::from_bits(number), index as f64]);
            walked.add(met, weight, draws, chance, scores);
        }
    }

    /// Adds `factor` times what the place that a ray met reflects and lets through.
    fn add_reflected_by(&self, met: &Met, end_light: EndLight, factor: f64, radiosity: &mut [f64]) {
        let Met { element, ref place, distance, .. } = *met;
        let solution = self.solution;
        let irradiance = self.arriving(element, place, &|| met.there(), distance, end_light);
        let beyond = solution.behind(element, place).map(|(behind, place)| {
            self.arriving(behind, &place, &|| met.beyond(&place), distance, end_light)
        });
        for (index, (out, band)) in radiosity.iter_mut().zip(solution.bands()).enumerate() {
            let coating = &band.coating;
            *out += factor * coating.reflectance_at(element, place.parameters) * irradiance[index];
            if let Some(beyond) = &beyond {
                *out += factor * coating.transmittance(element) * beyond[index];
            }
        }
    }

    /// Adds the exitance of what a cosine-distributed ray met with the weight that the balance heuristic leaves beside
    /// the rays `to_lamps`; nothing where there are none.
    fn add_emitted_by(
        &self,
        receiver: &ReceiverPoint,
        met: &Met,
        to_lamps: Option<AimedRays>,
        radiosity: &mut [f64],
    ) {
        let exitance = self.rays.exitance_left(receiver, met, to_lamps);
        for (out, band) in radiosity.iter_mut().zip(self.solution.bands()) {
            *out += exitance * band.coating.exitance[met.element];
        }
    }

    /// An estimate of the irradiance (W m⁻²) per band where a ray ends, so far from where it began.
    fn arriving(
        &self,
        element: usize,
        place: &SurfacePlace,
        there: &dyn Fn() -> ReceiverPoint,
        distance: f64,
        end_light: EndLight,
    ) -> Vec<f64> {
        let mut irradiance = vec![0.0; self.solution.bands().len()];
        match end_light {
            EndLight::Polynomials => self.add_held(element, place, &mut irradiance),
            EndLight::Direct { chance, held } => {
                if self.is_held(element, &there(), distance, held) {
                    self.add_held(element, place, &mut irradiance);
                } else {
                    self.add_reflected(element, place, 1.0, &mut irradiance);
                    self.add_direct(&there(), chance, &mut irradiance);
                }
            }
            EndLight::Gathered(chance) => self.add_estimate(&there(), chance, &mut irradiance),
        }
        irradiance
    }

    /// Whether readings take all light at a point of an element from its polynomials, because it is near an
    /// emitter or seen small from this distance, and light bends little there. Never among luminaires: before one
    /// of them light peaks, which no polynomial follows.
    fn is_held(&self, element: usize, there: &ReceiverPoint, distance: f64, held: Held) -> bool {
        self.rays.points.is_empty()
            && self.bends[element] < held.smooth
            && (is_small(&self.solution.elements().list()[element], held.small * distance)
                || self.rays.lamps.is_near(there, NEAR))
    }

    /// Adds the polynomials E_h ≥ 0 of all light.
    fn add_held(&self, element: usize, place: &SurfacePlace, irradiance: &mut [f64]) {
        let mut held = vec![0.0; irradiance.len()];
        self.solution.irradiance_bands(element, place, &mut held);
        irradiance.iter_mut().zip(held).for_each(|(sum, held)| *sum += held.max(0.0));
    }

    /// Adds `factor` times the polynomials S_h ≥ 0 of reflected light.
    fn add_reflected(&self, element: usize, place: &SurfacePlace, factor: f64, irradiance: &mut [f64]) {
        let mut held = vec![0.0; irradiance.len()];
        self.solution.indirect_bands(element, place, &mut held);
        irradiance.iter_mut().zip(held).for_each(|(sum, held)| *sum += factor * held.max(0.0));
    }

    /// Adds an estimate of the direct light by one ray to an emitter, and one to a luminaire.
    fn add_direct(&self, receiver: &ReceiverPoint, chance: u64, irradiance: &mut [f64]) {
        self.add_point(receiver, chance, irradiance);
        let shares = self.rays.lamps.seen_from(receiver);
        if shares.is_empty() {
            return;
        }
        let Draws { direction: [polar, turn], target: [choice, s, t], .. } = Draws::of(chance);
        let is_near = self.rays.lamps.is_near(receiver, NEAR);
        for LampLight { element, share } in
            self.rays.direct(receiver, &shares, [choice, s, t, polar, turn], is_near)
        {
            let bands = irradiance.iter_mut().zip(self.solution.bands());
            bands.for_each(|(sum, band)| *sum += share * band.coating.exitance[element]);
        }
    }

    /// Adds an estimate of the irradiance by one ray of each kind that `chance` chooses; what the cosine-distributed
    /// one meets has the light of the polynomials.
    fn add_estimate(&self, receiver: &ReceiverPoint, chance: u64, irradiance: &mut [f64]) {
        self.add_point(receiver, chance, irradiance);
        let shares = self.rays.lamps.seen_from(receiver);
        let draws = Draws::of(chance);
        let direction = lambert(receiver.normal, draws.direction);
        let to_lamps = Some(AimedRays { shares: &shares, ratio: 1.0 });
        if let Some(met) = self.rays.met(receiver, direction) {
            self.add_reflected_by(&met, EndLight::Polynomials, 1.0, irradiance);
            self.add_emitted_by(receiver, &met, to_lamps, irradiance);
        }
        if !shares.is_empty() {
            let mix = RayMix { cosine: 1.0, to_lamps: 1.0 };
            self.add_lamp(receiver, &shares.target(draws.target), mix, 1.0, irradiance);
        }
    }

    /// Adds an estimate of the light of the luminaires by one ray, to one of them.
    fn add_point(&self, receiver: &ReceiverPoint, chance: u64, irradiance: &mut [f64]) {
        let own = number_of([f64::from_bits(chance), 1.0]);
        self.rays.points.add_one(receiver, self.rays.visibility, 1.0, own, irradiance);
    }

    /// The light of the luminaires at a receiver that is a point.
    fn lit(&self, origin: &Receiver) -> Option<Vec<f64>> {
        let Receiver::Point(receiver) = origin else { return None };
        let mut lit = vec![0.0; self.scale.len()];
        self.rays.points.add(receiver, self.rays.visibility, &mut lit);
        Some(lit)
    }

    /// Adds the light of the luminaires for the cosine-distributed rays of these numbers: `lit` at a point;
    /// over a patch that of a ray from each point where one of those starts.
    fn add_points(
        &self,
        origin: &Receiver,
        lit: Option<&[f64]>,
        number: u64,
        rays: Range<u64>,
        sums: &mut [f64],
    ) {
        if let Some(lit) = lit {
            let count = (rays.end - rays.start) as f64;
            sums.iter_mut().zip(lit).for_each(|(sum, lit)| *sum += count * lit);
            return;
        }
        let [s, t] = shift(number);
        for index in rays {
            let (receiver, weight) = origin.at(shifted(kronecker::point(index), &[s, t]));
            let chance = number_of([f64::from_bits(number), index as f64, 1.0]);
            self.rays.points.add_one(&receiver, self.rays.visibility, weight, chance, sums);
        }
    }

    /// Sends rays to the emitters, those that belong to the cosine-distributed ones of these numbers.
    fn send_to_lamps(
        &self,
        origin: &Receiver,
        shares: &Shares,
        number: u64,
        rays: Range<u64>,
        sums: &mut [f64],
    ) {
        let [a, b, c, d] = shift(number_of([f64::from_bits(number)]));
        let [s] = shift(number_of([f64::from_bits(number), 1.0]));
        for index in rays {
            let (receiver, weight) = origin.at(shifted(kronecker::point(index), &[d, s]));
            let target = shares.target(shifted(kronecker::point(index), &[a, b, c]));
            self.add_lamp(&receiver, &target, RayMix { cosine: 1.0, to_lamps: TO_LAMPS }, weight, sums);
        }
    }

    /// Adds `scale` times the light of one ray to an emitter.
    fn add_lamp(&self, receiver: &ReceiverPoint, target: &Target, mix: RayMix, scale: f64, sums: &mut [f64]) {
        let Some(LampLight { element, share }) = self.rays.lamp_light(receiver, target, mix) else { return };
        for (sum, band) in sums.iter_mut().zip(self.solution.bands()) {
            *sum += scale * share * band.coating.exitance[element];
        }
    }

    /// The estimate by the sums of the batches.
    fn estimate(&self, sums: &[f64], sent: u64, other: &[f64]) -> Estimate {
        let bands = self.scale.len();
        let (n, rays) = (BATCHES as f64, sent as f64);
        let mut found = Estimate {
            irradiance: Vec::with_capacity(bands),
            deviation: Deviation { relative: 0.0, absolute: 0.0, is_dark: false },
            missed: 0.0,
        };
        for (band, other) in other.iter().enumerate() {
            let batches = || sums.iter().skip(band).step_by(bands).map(|sum| sum / rays);
            let mean = batches().sum::<f64>() / n;
            let square = batches().map(|batch| (batch - mean).powi(2)).sum::<f64>();
            // What one ray is worth, of something a quarter as bright as the scene on the whole.
            let one = 0.25 * self.scale[band] / (n * rays);
            let error = (square / (n * (n - 1.0))).sqrt() + one;
            let least = DARK * self.scale[band];
            found.deviation.is_dark |= mean + other < least;
            found.deviation.relative += (error / (mean + other).max(least)).powi(2);
            found.deviation.absolute += error * error;
            found.missed += (error / (mean + other).max(self.dark[band])).powi(2);
            found.irradiance.push(mean);
        }
        found.deviation.relative = (found.deviation.relative / bands as f64).sqrt();
        found.deviation.absolute = (found.deviation.absolute / bands as f64).sqrt();
        found.missed = (found.missed / bands as f64).sqrt();
        found
    }
}

/// The start of a ray of this index: over a patch its place and its direction come from one sequence in four
/// dimensions with the shifts `offset`, at a point the numbers `turned` give the direction.
fn start(origin: &Receiver, index: u64, offset: &[f64; 4], turned: impl FnOnce() -> [f64; 2]) -> Start {
    let (place, direction) = match origin {
        Receiver::Point(_) => ([0.5; 2], turned()),
        Receiver::Patch(..) => {
            let [s, t, polar, turn] = shifted(kronecker::point(index), offset);
            ([s, t], [polar, turn])
        }
    };
    let (receiver, weight) = origin.at(place);
    Start { receiver, weight, direction: lambert(receiver.normal, direction) }
}

/// Shifts of a sequence in eight dimensions.
fn offsets(number: u64) -> [f64; 8] {
    let [first, second]: [[f64; 4]; 2] = [4.0, 5.0].map(|k| shift(number_of([f64::from_bits(number), k])));
    std::array::from_fn(|k| if k < 4 { first[k] } else { second[k - 4] })
}

/// Whether an element is smaller than a square of this width.
fn is_small(element: &Element, width: f64) -> bool {
    element.area < width * width
}
