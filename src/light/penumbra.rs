//! Direct light at a point: what each emitter sends without shadows, times the part of it that rays find visible.
//!
//! ```text
//! D(x) = Σ_l E₀ U_l v_l ,     v_l = Σ_k w_k κ(x, y_k) V(x, y_k) / Σ_k w_k κ(x, y_k) ,     U_l = ∫ κ dA      W m⁻²
//! ```
//!
//! U_l of a flat emitter is exact (Lambert's formula), that of a curved one is the mean of w_k κ times its area. The
//! points y_k are a Kronecker sequence on the emitter, or on its cells where it is near ([`super::lamp_cells`]). Where V is 1
//! or 0 for all of them D is taken for exact; else rays are doubled until 0.9 σ E₀ U_l n^(−3/4) is small beside all light that
//! arrives, reflected light with it: the error behind straight edges, where σ ≤ ½ is the standard deviation of V. For a
//! curved emitter σ ≥ ½ is the relative standard deviation of w κ V, which varies more.
//!
//! For openings to a sky κ holds the light towards x over that of a diffuse emitter, and U_l is a mean as for curved ones. The
//! light of luminaires is exact ([`super::point_lights`]) and comes on top.
//!
//! Few rays may miss something small. So each point tells which emitters it sees ([`Shade`]); where points beside each
//! other differ in that, rays are doubled until one of them is worth no more than the error allowed.

use smallvec::SmallVec;

use crate::elements::Element;
use crate::light::emitters::{Emitters, Radiances};
use crate::light::lamp_cells::LampCells;
use crate::light::lamps::{Lamp, Lamps};
use crate::light::point_lights::PointLights;
use crate::light::receiver_point::ReceiverPoint;
use crate::sampling::shift::{number_of, shift};
use crate::visibility::Visibility;

/// Rays to an emitter that sends all direct light, before they are compared; fewer to weaker ones, but some. Chosen.
const FIRST: f64 = 24.0;
const FEWEST: u64 = 4;

/// Rays to a curved emitter, at most, before they are compared: half of its points may face away. Chosen.
const FIRST_TO_CURVED: f64 = 32.0;

/// Most rays to an emitter. Chosen.
const MOST: u64 = 1024;

/// Error times n^¾ of n points of the sequence over the standard deviation of what they see, and the least of these. Root mean
/// square errors of the part of a square behind a straight edge, over random edges and shifts, were measured for n = 48 to
/// 384: 0.39 to 0.45 n^(−3/4).
const EDGE: f64 = 0.9;
const LEAST: f64 = 0.5;

/// Light that n rays miss, or see too much, times n: at most (1 − f)ⁿ f n = 1/e of what a part f of an emitter sends.
const MISSED: f64 = 0.37;

/// Light that arrives over that without shadows, below which the error counts relative to the latter. Chosen.
const DARK: f64 = 0.02;

/// An emitter is cut into cells within as many of its radii: there one cell would be larger than half its distance.
const NEAR: f64 = 3.0;

/// Direct light by rays.
#[derive(Debug)]
pub(crate) struct Penumbra<'a> {
    elements: &'a [Element],
    visibility: &'a Visibility,
    lamps: Lamps,
    radiances: &'a Radiances,
    points: &'a PointLights,
    bands: usize,
    /// Accuracy relative to the light that arrives.
    eps: f64,
}

/// What rays cost and tell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Care {
    /// Factor on the accuracy.
    pub rough: f64,
    /// Whether emitters seen wholly or not at all need as many rays as those in between.
    pub sure: bool,
}

/// Direct light at a point.
#[derive(Clone, Debug)]
pub(crate) struct Sight {
    /// The emitting elements that may send light to it, and the irradiance from each over its exitance.
    pub factors: Vec<Factor>,
    /// Irradiance from luminaires, per band (W m⁻²).
    pub points: Vec<f64>,
    /// Which of them it sees.
    pub shade: Shade,
}

/// The irradiance from an element over its exitance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factor {
    pub element: usize,
    pub value: f64,
}

/// Which emitters a point sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shade {
    /// Some only partly.
    Partial,
    /// All that belong to this number, wholly.
    Sees(u64),
}

/// Rays from a point to an emitter.
struct Beam<'a> {
    lamp: &'a Lamp,
    cells: LampCells<'a>,
    offset: [f64; 3],
    /// U_l of a flat emitter.
    whole: Option<f64>,
    sent: u64,
    /// Σ w κ over all rays, and over those that arrive; Σ (w κ)² over these.
    all: f64,
    seen: f64,
    squares: f64,
}

impl<'a> Penumbra<'a> {
    /// The direct light of `sources`, to the accuracy `eps` of what arrives.
    pub(crate) fn new(sources: &Emitters<'a>, visibility: &'a Visibility, eps: f64) -> Self {
        let Emitters { elements, ref coatings, radiances, points } = *sources;
        let bands = coatings.len();
        let lamps = Lamps::new(elements, coatings, &vec![1.0; bands]);
        Self { elements, visibility, lamps, radiances, points, bands, eps }
    }

    /// The direct light at a point where `beside` it other light arrives (W m⁻², mean over the bands).
    pub(crate) fn sight(&self, vantage: &ReceiverPoint, beside: f64, care: Care) -> Sight {
        let mut points = vec![0.0; self.bands];
        self.points.add(vantage, self.visibility, &mut points);
        let beside = beside + points.iter().sum::<f64>() / self.bands as f64;
        let bounds: Vec<f64> = self.lamps.list().iter().map(|lamp| lamp.bound(vantage)).collect();
        let all: f64 = bounds.iter().sum();
        let some = self.lamps.list().iter().zip(bounds).filter(|(_, bound)| *bound > 0.0);
        let beams = some.map(|(lamp, bound)| self.beam(vantage, lamp, bound / all));
        let mut beams: Vec<Beam> = beams.filter(|beam| beam.whole != Some(0.0)).collect();
        let arrives: f64 = beams.iter().map(|beam| beam.lamp.brightness * beam.factor()).sum();
        let tolerance = care.rough * self.eps * (beside + arrives).max(DARK * all);
        self.refine(vantage, &mut beams, tolerance, care.sure);
        let factor = |beam: &Beam| Factor { element: beam.lamp.element, value: beam.factor() };
        Sight { shade: shade(&beams), factors: beams.iter().map(factor).collect(), points }
    }

    /// The first rays to an emitter that sends about the part `share` of all light without shadows.
    fn beam<'l>(&'l self, vantage: &ReceiverPoint, lamp: &'l Lamp, share: f64) -> Beam<'l> {
        let position = vantage.position.to_array();
        let whole = self.without_shadows(vantage, lamp);
        let mut beam = Beam {
            cells: cells(lamp, vantage),
            offset: shift(number_of(position.into_iter().chain([lamp.element as f64]))),
            lamp,
            whole,
            sent: 0,
            all: 0.0,
            seen: 0.0,
            squares: 0.0,
        };
        if whole != Some(0.0) {
            let first = if whole.is_some() { FIRST * share } else { self.first_to_curved(share) };
            self.send(vantage, &mut beam, (first as u64).max(FEWEST));
        }
        beam
    }

    /// Rays by which a curved emitter of the part `share` of all light errs by the accuracy, if so many are not too many.
    fn first_to_curved(&self, share: f64) -> f64 {
        (EDGE * LEAST * share / self.eps).powf(4.0 / 3.0).min(FIRST_TO_CURVED)
    }

    /// Doubles the rays to the emitter whose light errs most, until all together err by `tolerance` at most.
    fn refine(&self, vantage: &ReceiverPoint, beams: &mut [Beam], tolerance: f64, sure: bool) {
        let mut errors: SmallVec<[f64; 16]> = beams.iter().map(|beam| beam.error(sure)).collect();
        while errors.iter().map(|error| error * error).sum::<f64>() > tolerance * tolerance {
            let open = (0..beams.len()).filter(|k| beams[*k].sent < MOST);
            let Some(worst) = open.max_by(|a, b| errors[*a].total_cmp(&errors[*b])) else { return };
            let beam = &mut beams[worst];
            self.send(vantage, beam, beam.sent);
            errors[worst] = beam.error(sure);
        }
    }

    /// U_l of a flat diffuse emitter.
    fn without_shadows(&self, vantage: &ReceiverPoint, lamp: &Lamp) -> Option<f64> {
        let element = &self.elements[lamp.element];
        element.plane?;
        if self.radiances.of_surface(element.surface).is_some() {
            return None;
        }
        let nothing = || [].iter();
        Some(element.patches.iter().map(|patch| vantage.factor(&patch.polygon(), nothing())).sum())
    }

    /// Sends `count` rays more.
    fn send(&self, vantage: &ReceiverPoint, beam: &mut Beam, count: u64) {
        for index in beam.sent..beam.sent + count {
            let target = beam.cells.target(index, &beam.offset);
            let Some(kernel) = vantage.kernel_to(&target.node) else { continue };
            let into = (vantage.position - target.node.position).normalize_or_zero();
            let surface = self.elements[beam.lamp.element].surface;
            let value = target.weight * kernel * self.radiances.relative(surface, into);
            beam.all += value;
            if self.visibility.is_free(vantage.surface, vantage.position, target.node.position) {
                beam.seen += value;
                beam.squares += value * value;
            }
        }
        beam.sent += count;
    }
}

/// The targets on an emitter as seen from a point.
fn cells<'l>(lamp: &'l Lamp, vantage: &ReceiverPoint) -> LampCells<'l> {
    match lamp.distance(vantage.position) < NEAR * lamp.radius() {
        true => LampCells::near(&lamp.spread, vantage),
        false => LampCells::whole(&lamp.spread),
    }
}

/// Which emitters are seen.
fn shade(beams: &[Beam]) -> Shade {
    if beams.iter().any(Beam::is_mixed) {
        return Shade::Partial;
    }
    let seen = beams.iter().filter(|beam| beam.seen > 0.0);
    Shade::Sees(number_of(seen.map(|beam| beam.lamp.element as f64)))
}

impl Beam<'_> {
    /// U_l, or what rays say of it.
    fn size(&self) -> f64 {
        self.whole.unwrap_or(self.all * self.lamp.area / self.sent as f64)
    }

    /// U_l v_l.
    fn factor(&self) -> f64 {
        if self.all > 0.0 { self.size() * self.seen / self.all } else { 0.0 }
    }

    /// Error of its light; of light that is seen wholly or not at all only if one must be `sure` of that.
    fn error(&self, sure: bool) -> f64 {
        let size = self.lamp.brightness * self.size();
        match self.is_mixed() || self.whole.is_none() {
            true => EDGE * self.deviation() * size * (self.sent as f64).powf(-0.75),
            false if sure => MISSED * size / self.sent as f64,
            false => 0.0,
        }
    }

    /// σ.
    fn deviation(&self) -> f64 {
        if self.whole.is_some() || self.all == 0.0 {
            return LEAST;
        }
        let rays = self.sent as f64;
        let squares = self.squares - self.seen * self.seen / rays;
        ((squares.max(0.0) * rays).sqrt() / self.all).max(LEAST)
    }

    /// Whether some rays arrive, and some not.
    fn is_mixed(&self) -> bool {
        self.seen > 0.0 && self.seen < self.all
    }
}
