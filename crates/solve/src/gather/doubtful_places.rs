//! Places where the polynomials of a solution say too little of the light: narrow gaps and shadows.
//!
//! In a *gap* of height h between surfaces of the diagonal d about (h/d)² of the light outside comes to its middle.
//! What is met from there is the light of the gap itself, of which polynomials on elements that reach out of it know
//! nothing. Walks (`super::walked_light`) need none.
//!
//! Polynomials and cells err relative to what is bright in the scene. A point in *shadow*,
//!
//! ```text
//! mean over the bands of E(x) / Ē  <  SHADOWED ,     Ē the mean irradiance of all surfaces ,
//! ```
//!
//! mostly sees what is as dark and near, where that is much. It is *doubtful* there, with b the root mean square of the
//! part of the highest degree of the radiosity that an element reflects,
//!
//! ```text
//! ∫ κ(x, y) V(x, y) b(y) dA_y  >  DOUBTFUL E(x)      over the elements that are seen large (`super::trusted_light`) ,
//! ```
//!
//! by a few rays. Then the reflected light is gathered by walks that end at light that is trusted, beside the direct
//! light, which is known.

use radiosity_elements::Element;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_geom::{COINCIDENT, Rect};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::bends::{SentLight, bends};
use crate::gather::ray_gather::{Beyond, RayGather};
use crate::gather::read_irradiance::{Deviation, ReadIrradiance};
use crate::gather::receiver::Receiver;
use crate::gather::trusted_light::is_seen_large;
use crate::solution::Solution;

/// Height of a gap over the diagonals of both surfaces up to which it is narrow: then about its square of the light
/// outside comes to its middle. Chosen.
const NARROW: f64 = 0.03;

/// Height of a gap over the diagonal of the scene up to which it is narrow: mats lie closer, and storeys, however wide,
/// are higher. Chosen.
const NARROW_IN_SCENE: f64 = 0.01;

/// Light over the mean of all surfaces below which it is shadow. Measured on sixty random rooms, 25 of them read by
/// cells: 13 of the 17 readings that were off by more than 1 % were darker, and a seventh of all.
const SHADOWED: f64 = 0.4;

/// Doubt about the light of a point, and about the mean over a patch, over that light, from which on it is read anew.
/// Measured on these rooms: of readings in shadow, all that were off by 14 % or more had a doubt of .04 or more, and a
/// fifth of all; a twelfth of the patches of the Cornell box in shadow have one of .05, a hundredth one of .2.
const DOUBTFUL: f64 = 0.04;
const DOUBTFUL_OVER_PATCH: f64 = 0.2;

/// Light of a patch in a gap, and doubt about the mean over a patch, over the usual light, that count as none. Chosen.
const NOTHING: f64 = 0.01;

/// Rays that find what a point sees near it. Chosen: they take a twentieth of the time of the point.
const LOOKS: u64 = 32;

/// Finest accuracy that is asked of walks in gaps, relative to the light of the whole scene where less arrives.
/// Chosen: a point takes a second at the most. What is left of error is told with each.
const BY_WALKS: f64 = 5e-3;

/// Finest accuracy that is asked in shadow, relative to the least light that is none: .3 % of the usual light.
/// Chosen: a point takes some milliseconds, and what is read anew was off by more.
pub(super) const IN_SHADOW: f64 = 1e-2;

/// The doubtful places of a scene whose surfaces cast shadows.
#[derive(Debug)]
pub(super) struct DoubtfulPlaces<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    /// Light in gaps.
    walks: RayGather<'a>,
    /// Reflected light in shadows, and where there are many receivers in gaps.
    shadows: RayGather<'a>,
    /// Mean irradiance per band of all surfaces (W m⁻²).
    usual: Vec<f64>,
    /// Part of the reflected light of each element in its polynomials of the highest degree, over the usual light.
    bends: Vec<f64>,
}

impl<'a> DoubtfulPlaces<'a> {
    /// The places of a solution that rays read to about the relative accuracy `eps`; None where rays meet nothing, or
    /// masks or the number of reflections tell what is read.
    pub(super) fn of(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Option<Self> {
        let is_plain = visibility.casts() && solution.masked().is_none() && !solution.is_truncated();
        is_plain.then(|| {
            let usual = solution.mean_arriving();
            let bends = bends(solution, &usual, SentLight::Again);
            let lit = usual.iter().map(|usual| SHADOWED * usual).collect();
            let shadows =
                RayGather::new(solution, visibility, eps.max(IN_SHADOW), Beyond::Trusted).with_dark(lit);
            let walks = RayGather::new(solution, visibility, eps.max(BY_WALKS), Beyond::Walked);
            Self { solution, visibility, walks, shadows, usual, bends }
        })
    }

    /// All light of a point in a gap; None elsewhere.
    pub(super) fn in_gap(&self, receiver: &ReceiverPoint) -> Option<ReadIrradiance> {
        self.hold(receiver).then(|| known_beside(self.walks.read(&Receiver::Point(*receiver))))
    }

    /// The reflected light of a point in a gap, one of many, beside the direct light `lit` (W m⁻² per band); None
    /// elsewhere.
    pub(super) fn reflected_in_gap(&self, receiver: &ReceiverPoint, lit: &[f64]) -> Option<ReadIrradiance> {
        let origin = Receiver::Point(*receiver);
        self.hold(receiver).then(|| self.shadows.reflected_alone(&origin, lit))
    }

    /// The light of a receiver in shadow, or of a patch in a gap, where so much is `lit` by emitters and cells
    /// found so much `reflected` light (W m⁻² per band); None elsewhere.
    pub(super) fn in_shadow(
        &self,
        origin: &Receiver,
        lit: &[f64],
        reflected: &[f64],
    ) -> Option<ReadIrradiance> {
        let beside = |light: &[f64]| -> f64 {
            let parts = light.iter().zip(&self.usual);
            parts.map(|(light, usual)| light / usual.max(f64::MIN_POSITIVE)).sum::<f64>() / light.len() as f64
        };
        let (lit_part, reflected_part) = (beside(lit), beside(reflected));
        let all = lit_part + reflected_part;
        if all >= SHADOWED || !self.visibility.has_obstacles() {
            return None;
        }
        let is_near_unknown = |least: f64| self.doubt(&origin.middle()) > least;
        let is_doubtful = match origin {
            Receiver::Point(_) => is_near_unknown(DOUBTFUL * all),
            Receiver::Patch(..) => {
                is_near_unknown(DOUBTFUL_OVER_PATCH * all + NOTHING)
                    || (all > NOTHING && self.hold(&origin.middle()))
            }
        };
        is_doubtful.then(|| known_beside(self.shadows.reflected_alone(origin, lit).with(lit)))
    }

    /// Error that the polynomials of large elements about a point may make there, over the usual light.
    fn doubt(&self, receiver: &ReceiverPoint) -> f64 {
        let rays = self.walks.rays();
        let [position, normal] = [receiver.position, receiver.normal].map(|vector| vector.to_array());
        let offset: [f64; 2] = shift(number_of(position.into_iter().chain(normal)));
        let of_ray = |index: u64| {
            let direction = lambert(receiver.normal, shifted(kronecker::point(index), &offset));
            let met = rays.met(receiver, direction).filter(|met| is_seen_large(rays, met));
            met.map_or(0.0, |met| self.bends[met.element])
        };
        (0..LOOKS).map(of_ray).sum::<f64>() / LOOKS as f64
    }

    /// The part of all surfaces that lies in gaps, judged at the middles of elements.
    pub(super) fn in_gaps(&self) -> f64 {
        let list = self.solution.elements().list();
        let is_in_gap = |element: &&Element| {
            let node = element.patches[0].node(0.5, 0.5);
            self.hold(&ReceiverPoint::on(element.surface, node.position, node.normal))
        };
        let area = |elements: &mut dyn Iterator<Item = &Element>| elements.map(|own| own.area).sum::<f64>();
        area(&mut list.iter().filter(is_in_gap)) / area(&mut list.iter())
    }

    /// Whether a point of a surface lies in a narrow gap under another one; under one that touches it is in none.
    fn hold(&self, receiver: &ReceiverPoint) -> bool {
        let up = receiver.ground.unwrap_or(receiver.normal);
        let extent = |surface: usize| self.solution.elements().shape(surface).bounds(&Rect::FULL).diagonal();
        let diagonal = self.visibility.bounds().diagonal();
        let heights = COINCIDENT * diagonal..=NARROW_IN_SCENE * diagonal;
        receiver.surface.is_some_and(|surface| {
            self.visibility.nearest_from(surface, receiver.position, up).is_some_and(|met| {
                let narrow = || NARROW * extent(surface).min(extent(met.surface));
                met.surface != surface && heights.contains(&met.hit.t) && met.hit.t <= narrow()
            })
        })
    }
}

/// Light that is as well known beside that of the scene as was asked, whatever its relative error.
fn known_beside(read: ReadIrradiance) -> ReadIrradiance {
    let deviation = read.deviation.map(|deviation| Deviation { is_dark: true, ..deviation });
    ReadIrradiance { deviation, ..read }
}
