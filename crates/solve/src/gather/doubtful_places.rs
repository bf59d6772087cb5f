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
//! mostly sees what is as dark and near, where that is much. There the reflected light is gathered by walks that end
//! at light that is trusted (`super::trusted_light`), beside the direct light, which is known.

use radiosity_elements::Element;
use radiosity_geom::Rect;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::ray_gather::{Beyond, RayGather};
use crate::gather::read_irradiance::{Deviation, ReadIrradiance};
use crate::gather::receiver::Receiver;
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

/// Part of the light of a point in shadow that must be reflected for it to be doubtful: of less, a fifth of it is below
/// what is asked for. Chosen.
const REFLECTED: f64 = 0.02;

/// Finest accuracy that is asked of walks in either, relative to the light of the whole scene where less arrives, and
/// in shadow to what is none. Chosen: a point takes a second at the most. What is left of error is told with each.
pub(super) const BY_WALKS: f64 = 5e-3;

/// The doubtful places of a scene whose surfaces cast shadows.
#[derive(Debug)]
pub(super) struct DoubtfulPlaces<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    /// Light in gaps.
    walks: RayGather<'a>,
    /// Reflected light in shadows.
    shadows: RayGather<'a>,
    /// Mean irradiance per band of all surfaces (W m⁻²).
    usual: Vec<f64>,
}

impl<'a> DoubtfulPlaces<'a> {
    /// The places of a solution that rays read to about the relative accuracy `eps`; None where rays meet nothing, or
    /// masks or the number of reflections tell what is read.
    pub(super) fn of(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Option<Self> {
        let is_plain = visibility.casts() && solution.masked().is_none() && !solution.is_truncated();
        is_plain.then(|| {
            let usual = solution.mean_arriving();
            let eps = eps.max(BY_WALKS);
            let lit = usual.iter().map(|usual| SHADOWED * usual).collect();
            let shadows = RayGather::new(solution, visibility, eps, Beyond::Trusted).with_dark(lit);
            let walks = RayGather::new(solution, visibility, eps, Beyond::Walked);
            Self { solution, visibility, walks, shadows, usual }
        })
    }

    /// All light of a receiver in a gap; None elsewhere.
    pub(super) fn in_gap(&self, origin: &Receiver) -> Option<ReadIrradiance> {
        self.hold(&origin.middle()).then(|| known_beside(self.walks.read(origin)))
    }

    /// The reflected light of a point in a gap, one of many, beside the direct light `lit` (W m⁻² per band); None
    /// elsewhere.
    pub(super) fn reflected_in_gap(&self, receiver: &ReceiverPoint, lit: &[f64]) -> Option<ReadIrradiance> {
        self.hold(receiver).then(|| self.walks.reflected(receiver, lit))
    }

    /// The light of a receiver in shadow, where so much is `lit` by emitters and cells found so much `reflected` light
    /// (W m⁻² per band); None elsewhere.
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
        let is_doubtful =
            self.visibility.has_obstacles() && all < SHADOWED && reflected_part > REFLECTED * all;
        is_doubtful.then(|| known_beside(self.shadows.reflected_alone(origin, lit).with(lit)))
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

    /// Whether a point of a surface lies in a narrow gap under another one.
    fn hold(&self, receiver: &ReceiverPoint) -> bool {
        let up = receiver.ground.unwrap_or(receiver.normal);
        let extent = |surface: usize| self.solution.elements().shape(surface).bounds(&Rect::FULL).diagonal();
        let most = NARROW_IN_SCENE * self.visibility.bounds().diagonal();
        receiver.surface.is_some_and(|surface| {
            self.visibility.nearest_from(surface, receiver.position, up).is_some_and(|met| {
                let narrow = || NARROW * extent(surface).min(extent(met.surface));
                met.surface != surface && met.hit.t <= most && met.hit.t <= narrow()
            })
        })
    }
}

/// Light that is as well known beside that of the scene as was asked, whatever its relative error.
fn known_beside(read: ReadIrradiance) -> ReadIrradiance {
    let deviation = read.deviation.map(|deviation| Deviation { is_dark: true, ..deviation });
    ReadIrradiance { deviation, ..read }
}
