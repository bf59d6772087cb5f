//! Places where the polynomials of a solution say too little of the light: narrow gaps, and what is near large elements
//! over which light bends.
//!
//! Of the light of a gap itself, which is all that is met there (`super::narrow_gaps`), polynomials know nothing. Walks
//! (`super::walked_light`) need none.
//!
//! What rays meet or cells are made of has the polynomials of reflected light. A point is *doubtful*, with its light E,
//! the mean irradiance Ē of all surfaces, and b the root mean square of the part of the highest degree of the radiosity
//! that an element reflects, two thirds of it from the third degree on,
//!
//! ```text
//! ∫ κ(x, y) V(x, y) b(y) dA_y  >  min( DOUBTFUL E(x) , UNSURE max(E(x), Ē) )
//! ```
//!
//! over the elements that are seen large (`super::trusted_light`), by a few rays: in shadow a point mostly sees what is
//! as dark and near, and near small things polynomials of large elements miss what these change. A shelf on a wall, or
//! a partition that stands before one, makes a step in what is reflected where it divides an element; seen from it b is
//! all of the radiosity there that varies. Then the reflected light is gathered by walks that end at light that is
//! trusted, beside the direct light, which is known. Elsewhere the integral is the `doubt` that a reading tells.

use std::sync::Arc;

use radiosity_elements::Element;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_work::Pace;

use crate::gather::bends::{Part, SentLight, bends};
use crate::gather::met_light::{EndLight, MetLight};
use crate::gather::narrow_gaps::NarrowGaps;
use crate::gather::ray_gather::{Beyond, RayGather};
use crate::gather::read_irradiance::ReadIrradiance;
use crate::gather::receiver::Receiver;
use crate::gather::sent_rays::Met;
use crate::gather::trusted_light::is_seen_large;

/// Doubt about the light of a point over that light, and over the mean of all surfaces, from which on it is read anew.
/// Measured on sixty random rooms of 780 readings: of the 14 that were off by 3 % or more, and the 49 by 1 %, 12 and 36
/// had one of these doubts, and 135 readings in all.
pub const DOUBTFUL: f64 = 0.02;
const UNSURE: f64 = 0.0075;

/// Order from which on polynomials miss less than they have in the highest degree, and the part of that which they
/// miss. Measured on the floor of the Cornell box: with all, two thirds and half of it nine of ten readings were within
/// .75, .75 and 1.65 %, after 1.9, .8 and .5 ms each.
const FINE: usize = 3;
const OF_FINE: f64 = 2.0 / 3.0;

/// Light over the mean of all surfaces below which a patch lies in shadow, and to which errors are relative where less
/// arrives at what is read anew. Measured on these rooms: errors were largest in darker places.
const SHADOWED: f64 = 0.4;

/// Doubt about the mean over a patch in shadow, over its light, from which on it is read anew. Measured: a hundredth of
/// the patches of the Cornell box have more.
const DOUBTFUL_OVER_PATCH: f64 = 0.2;

/// As [`DOUBTFUL`], of pixels, which are many. Measured in the Cornell box, 256² pixels: with [`DOUBTFUL`] pictures
/// take twice as long, as they do of a soda shop and a teapot. Of pixels that are off by a fifth of themselves 45 are
/// left with .25, 135 with 1 and 197 with 2, where 333 are if none is read anew.
pub const DOUBTFUL_PIXEL: f64 = 0.25;

/// Distance of what a ray met, over the width of the element there, up to which a surface that reaches into the
/// element makes a step of its light; and part of the width that must lie behind that surface. Measured on these rooms:
/// of 32 points two fifths of whose light comes from there 13 were off by 1 %, of all 780 points 49.
const BESIDE: f64 = 0.5;
const DIVIDED: f64 = 0.05;

/// Light of a patch in a gap, and doubt about the mean over a patch, over the usual light, that count as none. Chosen.
const NOTHING: f64 = 0.01;

/// Rays that find what a point sees near it. Chosen: they take a twentieth of the time of the point.
const LOOKS: u64 = 32;
const ONE_LOOK: f64 = 1.0 / LOOKS as f64;

/// Finest accuracy that is asked of walks in gaps, relative to the light of the whole scene where less arrives.
/// Chosen: a point takes a second at the most. What is left of error is told with each.
const BY_WALKS: f64 = 5e-3;

/// Finest accuracy that is asked of what is read anew. Measured on these rooms: with 1e-2 the largest error of a
/// room was that of the rays, with 5e-3 an office of 200 sensors took a quarter longer.
pub(super) const ANEW: f64 = 7e-3;

/// As [`ANEW`], where nothing stands between the walls of a room: few surfaces are cut into few elements, and rays meet
/// them soon. Measured beside a sun's patch: with 7e-3 a reading of 537 lx was 1.2 % off.
const ANEW_BETWEEN_WALLS: f64 = 3e-3;

/// The doubtful places of a scene.
#[derive(Debug)]
pub(super) struct DoubtfulPlaces<'a> {
    light: Arc<MetLight<'a>>,
    gaps: NarrowGaps<'a>,
    /// Light in gaps.
    walks: RayGather<'a>,
    /// Reflected light of what is read anew, and where there are many receivers in gaps.
    shadows: RayGather<'a>,
    /// Part of the reflected light of each element that its polynomials may miss, over the usual light.
    bends: Vec<f64>,
    /// Part of it that varies over the element.
    varying: Vec<f64>,
}

/// Findings of a few rays from a point.
struct Looks {
    /// Error that the polynomials of large elements about the point may make there, over the usual light.
    doubt: f64,
    /// About the light that it receives from what reflects (W m⁻² per band).
    reflected: Vec<f64>,
}

impl<'a> DoubtfulPlaces<'a> {
    /// The places where the polynomials of this `light`, read to about the relative accuracy `eps`, say too little.
    pub(super) fn of(light: Arc<MetLight<'a>>, gaps: NarrowGaps<'a>, eps: f64) -> Self {
        let of_part = |part| bends(light.solution, &light.usual, SentLight::Again, part);
        let [highest, varying] = [Part::Highest, Part::Varying].map(of_part);
        let list = light.solution.elements().list();
        let missed =
            |(bend, own): (f64, &Element)| if own.basis.order() < FINE { bend } else { OF_FINE * bend };
        let bends = highest.into_iter().zip(list).map(missed).collect();
        let lit = light.usual.iter().map(|usual| SHADOWED * usual).collect();
        let gather = |finest: f64, beyond| RayGather::of(Arc::clone(&light), eps.max(finest), beyond);
        let finest = if light.rays.visibility.has_obstacles() { ANEW } else { ANEW_BETWEEN_WALLS };
        let shadows = gather(finest, Beyond::Trusted).with_dark(lit);
        let walks = gather(BY_WALKS, Beyond::Walked);
        Self { light, gaps, walks, shadows, bends, varying }
    }

    /// As made, but readings end at this pace.
    pub(super) fn paced(self, pace: &'a Pace) -> Self {
        Self { walks: self.walks.paced(pace), shadows: self.shadows.paced(pace), ..self }
    }

    /// As made, but errors are to be small relative to the usual irradiance where less arrives.
    pub(super) fn beside_usual_light(self) -> Self {
        Self { walks: self.walks.beside_usual(), shadows: self.shadows.beside_usual(), ..self }
    }

    /// All light of a point in a gap; None elsewhere.
    pub(super) fn in_gap(&self, receiver: &ReceiverPoint) -> Option<ReadIrradiance> {
        self.gaps.hold(receiver).then(|| known_beside(self.walks.read(&Receiver::Point(*receiver))))
    }

    /// Whether a point lies in a gap.
    pub(super) fn is_in_gap(&self, receiver: &ReceiverPoint) -> bool {
        self.gaps.hold(receiver)
    }

    /// The reflected light of a point in a gap, one of many, beside the direct light `lit` (W m⁻² per band); None
    /// elsewhere.
    pub(super) fn reflected_in_gap(&self, receiver: &ReceiverPoint, lit: &[f64]) -> Option<ReadIrradiance> {
        self.gaps.about(receiver).map(|own| self.shadows.reflected_in_gap(receiver, own, lit))
    }

    /// All light of a point, where so much is `lit` by emitters (W m⁻² per band): read anew if it is doubtful, and else
    /// what is `reflected`, with the doubt that is left.
    pub(super) fn point(
        &self,
        receiver: &ReceiverPoint,
        lit: &[f64],
        reflected: impl FnOnce() -> ReadIrradiance,
    ) -> ReadIrradiance {
        let looks = self.looks(receiver, &self.varying);
        let all = self.beside_usual(lit) + self.beside_usual(&looks.reflected);
        if looks.doubt > f64::min(DOUBTFUL * all, UNSURE * all.max(1.0)) {
            return self.read_anew(&Receiver::Point(*receiver), lit);
        }
        self.with_doubt(looks.doubt, reflected().with(lit))
    }

    /// The reflected light of a point, one of many, accurate relative to this and the light `other` (W m⁻² per band),
    /// if there is more than this `doubt` about it over itself and what is `lit`; None elsewhere.
    pub(super) fn reflected_anew(
        &self,
        receiver: &ReceiverPoint,
        lit: &[f64],
        other: &[f64],
        doubt: f64,
    ) -> Option<ReadIrradiance> {
        let allowed = |all: f64| doubt * all;
        self.is_doubtful(receiver, lit, allowed).then(|| self.shadows.reflected_onward(receiver, other))
    }

    /// Whether the polynomials about a point may miss more than is allowed beside all its light, over the usual one; so
    /// much of it is `known` (W m⁻² per band).
    fn is_doubtful(&self, receiver: &ReceiverPoint, known: &[f64], allowed: impl Fn(f64) -> f64) -> bool {
        let looks = self.looks(receiver, &self.varying);
        looks.doubt > allowed(self.beside_usual(known) + self.beside_usual(&looks.reflected))
    }

    /// All light of a patch, where so much is `lit` by emitters and so much `reflected` light was found (W m⁻² per
    /// band): read anew if it lies in shadow and is doubtful, and else these, with the doubt that is left in shadow.
    pub(super) fn patch(&self, origin: &Receiver, lit: &[f64], reflected: &[f64]) -> ReadIrradiance {
        let found = || ReadIrradiance::from(reflected.to_vec()).with(lit);
        let all = self.beside_usual(lit) + self.beside_usual(reflected);
        if all >= SHADOWED || !self.light.rays.visibility.has_obstacles() {
            return found();
        }
        let middle = origin.middle();
        let doubt = self.looks(&middle, &self.bends).doubt;
        let is_near_unknown = doubt > DOUBTFUL_OVER_PATCH * all + NOTHING;
        if is_near_unknown || (all > NOTHING && self.gaps.hold(&middle)) {
            return self.read_anew(origin, lit);
        }
        self.with_doubt(doubt, found())
    }

    /// All light of a receiver, where so much is `lit` by emitters, with reflected light by walks.
    fn read_anew(&self, origin: &Receiver, lit: &[f64]) -> ReadIrradiance {
        known_beside(self.shadows.reflected_alone(origin, lit).with(lit))
    }

    /// The light with a doubt over the usual light, kept as an error in W m⁻², root mean square over the bands.
    fn with_doubt(&self, doubt: f64, mut read: ReadIrradiance) -> ReadIrradiance {
        let squares: f64 = self.light.usual.iter().map(|usual| usual * usual).sum();
        read.uncertainty.doubt = doubt * (squares / self.light.usual.len() as f64).sqrt();
        read
    }

    /// Light per band over the usual light, in the mean.
    fn beside_usual(&self, light: &[f64]) -> f64 {
        let parts = light.iter().zip(&self.light.usual);
        parts.map(|(light, usual)| light / usual.max(f64::MIN_POSITIVE)).sum::<f64>() / light.len() as f64
    }

    /// A few rays from a point; doubt by what is `beside` its surface counts, of the elements that this divides.
    fn looks(&self, receiver: &ReceiverPoint, beside: &[f64]) -> Looks {
        let rays = &self.light.rays;
        let [position, normal] = [receiver.position, receiver.normal].map(|vector| vector.to_array());
        let offset: [f64; 2] = shift(number_of(position.into_iter().chain(normal)));
        let mut looks = Looks { doubt: 0.0, reflected: vec![0.0; self.light.usual.len()] };
        for index in 0..LOOKS {
            let direction = lambert(receiver.normal, shifted(kronecker::point(index), &offset));
            let Some(met) = rays.met(receiver, direction) else { continue };
            self.light.add_reflected_by(&met, EndLight::Polynomials, ONE_LOOK, &mut looks.reflected);
            if is_seen_large(rays, &met) {
                let divided = if self.is_divided(receiver, &met) { beside[met.element] } else { 0.0 };
                looks.doubt += ONE_LOOK * self.bends[met.element].max(divided);
            }
        }
        looks
    }

    /// Whether the surface that a point lies on divides an element that a ray from there met, near where it met it.
    fn is_divided(&self, receiver: &ReceiverPoint, met: &Met) -> bool {
        let own = &self.light.rays.elements.list()[met.element];
        let width = own.area.sqrt();
        let up = receiver.ground.unwrap_or(receiver.normal);
        let lowest =
            || own.hull.iter().map(|corner| (*corner - receiver.position).dot(up)).fold(0.0, f64::min);
        receiver.surface.is_some() && met.distance < BESIDE * width && lowest() < -DIVIDED * width
    }
}

/// Light that is as well known beside that of the scene as was asked, whatever its relative error.
fn known_beside(mut read: ReadIrradiance) -> ReadIrradiance {
    read.uncertainty.deviation.iter_mut().for_each(|deviation| deviation.is_dark = true);
    read
}
