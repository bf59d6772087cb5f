//! Walks: paths of rays from a receiver from surface to surface, against the light.
//!
//! A walk begins with a cosine-distributed ray from the receiver and goes on from where it ends, with the probability
//! of the largest reflectance there, at most [`LIKELIEST`]; through a surface that lets light through it goes on from
//! either side, in proportion to ρ and τ. The first ray ends at once on the surface under a tilted receiver where it
//! begins below that surface's horizon. The product w of the reflectances so far over these probabilities makes sums
//! over the ends y unbiased estimates of the Neumann series:
//!
//! ```text
//! E[ Σ_ends w f(y) ] = (G + GρG + GρGρG + …) f    at the receiver,     (G f)(x) = ∫ κ(x, y) V(x, y) f(y) dA_y .
//! ```

use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::{number_of, shift};
use radiosity_geom::{DVec3, Encounter, Ray};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;

use crate::gather::lune::Lune;
use crate::solution::{Solution, SurfacePlace};

/// Largest probability that a walk goes on: 20 steps in the mean, where surfaces reflect nearly all. What is
/// beyond it weighs as much more.
const LIKELIEST: f64 = 0.95;

/// Walks over the elements of a solution, with the reflectances of its bands.
pub(crate) struct Walks<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
}

/// Where a ray of a walk ends.
pub(crate) struct WalkEnd {
    pub(crate) element: usize,
    /// The side whose light is sent on towards the start of the ray.
    pub(crate) lit: SendingSide,
    /// Number from which whatever is chosen at this end follows.
    pub(crate) chance: u64,
}

/// The side of a surface whose light is sent on: that which a ray met, or the other of one that lets light
/// through.
pub(crate) struct SendingSide {
    pub(crate) element: usize,
    pub(crate) place: SurfacePlace,
    pub(crate) there: ReceiverPoint,
    /// Per band, ρ of the side that a ray met, or τ, over the probability of the choice between them.
    pub(crate) factors: Vec<f64>,
}

impl SendingSide {
    /// The largest factor.
    pub(crate) fn brightest(&self) -> f64 {
        self.factors.iter().copied().fold(0.0, f64::max)
    }
}

/// The front that a ray from a point meets first; None where it begins below the horizon of the ground, and where it
/// meets a back first.
pub(super) fn front_met(
    visibility: &Visibility,
    from: &ReceiverPoint,
    direction: DVec3,
) -> Option<Encounter> {
    if from.ground.is_some_and(|ground| ground.dot(direction) <= 0.0) {
        return None;
    }
    let met = match from.surface {
        Some(surface) => visibility.nearest_from(surface, from.position, direction),
        None => visibility.nearest(&Ray::new(from.position, direction)),
    };
    met.filter(|met| met.front)
}

impl<'a> Walks<'a> {
    pub(crate) fn new(solution: &'a Solution, visibility: &'a Visibility) -> Self {
        Self { solution, visibility }
    }

    /// Walks from a receiver in a direction of its hemisphere, given by a point of the unit square; `visit`
    /// gets every end with its weights w, band by band. `chance` chooses the rest.
    pub(crate) fn walk(
        &self,
        mut from: ReceiverPoint,
        mut direction: [f64; 2],
        mut chance: u64,
        visit: &mut impl FnMut(&WalkEnd, &[f64]),
    ) {
        let mut weights = vec![1.0; self.solution.bands().len()];
        while let Some(end) = self.end(&from, lambert(from.normal, direction), chance) {
            visit(&end, &weights);
            let likely = end.lit.brightest().min(LIKELIEST);
            // Other numbers than those that `visit` makes of `chance`: what the dice allow must not choose
            // its rays.
            let [dice, polar, turn] = shift(number_of([f64::from_bits(chance), 1.0]));
            chance = number_of([f64::from_bits(chance), 2.0]);
            if dice >= likely {
                return;
            }
            let reflected = end.lit.factors.iter().map(|factor| factor / likely);
            weights.iter_mut().zip(reflected).for_each(|(weight, factor)| *weight *= factor);
            (from, direction) = (end.lit.there, [polar, turn]);
        }
    }

    /// Where a ray meets the front of an element.
    fn end(&self, from: &ReceiverPoint, direction: DVec3, chance: u64) -> Option<WalkEnd> {
        check_interrupt();
        let elements = self.solution.elements();
        let below = from.ground.filter(|ground| ground.dot(direction) <= 0.0);
        let (surface, parameters) = match below {
            Some(_) => Lune::of(from, elements).map(|lune| (lune.place.surface, lune.place.parameters))?,
            None => {
                let Encounter { surface, hit, .. } = front_met(self.visibility, from, direction)?;
                (surface, [hit.u, hit.v])
            }
        };
        let element = elements.at(surface, parameters)?;
        let jet = elements.shape(surface).jet(parameters[0], parameters[1]);
        let place = SurfacePlace { surface, parameters, position: jet.position };
        let there = ReceiverPoint::on(surface, jet.position, jet.normal);
        let lit = self.lit(element, &place, &there, chance);
        Some(WalkEnd { element, lit, chance })
    }

    /// The side whose light a place sends on, which `chance` chooses.
    fn lit(&self, element: usize, place: &SurfacePlace, there: &ReceiverPoint, chance: u64) -> SendingSide {
        let coatings = || self.solution.bands().iter().map(|band| &band.coating);
        let mut factors: Vec<f64> =
            coatings().map(|coating| coating.reflectance_at(element, place.parameters)).collect();
        let own = SendingSide { element, place: *place, there: *there, factors: Vec::new() };
        let Some((behind, beyond)) = self.solution.behind(element, place) else {
            return SendingSide { factors, ..own };
        };
        let transmitted: Vec<f64> = coatings().map(|coating| coating.transmittance(element)).collect();
        let [reflects, transmits] =
            [&factors, &transmitted].map(|each| each.iter().copied().fold(0.0, f64::max));
        let share = reflects / (reflects + transmits);
        let [dice]: [f64; 1] = shift(number_of([f64::from_bits(chance), 4.0]));
        if dice < share {
            factors.iter_mut().for_each(|factor| *factor /= share);
            return SendingSide { factors, ..own };
        }
        let factors = transmitted.iter().map(|factor| factor / (1.0 - share)).collect();
        let there = ReceiverPoint::on(beyond.surface, there.position, -there.normal);
        SendingSide { element: behind, place: beyond, there, factors }
    }
}
