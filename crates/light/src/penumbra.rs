//! Direct light at a point: what each emitter sends without shadows, times the part of it that rays find
//! visible.
//!
//! Definition. With the mean exitance E₀ of the emitter l, its points y and the kernel κ (1 / scene length²),
//! which holds the radiance towards x over that of a diffuse emitter where l is an opening to a sky or a
//! luminous area,
//!
//! ```text
//! D(x) = Σ_l E₀ U_l v_l ,     U_l = ∫ κ(x, y) dA_y ,     v_l = ∫ κ(x, y) V(x, y) dA_y / U_l        W m⁻² .
//! ```
//!
//! Formula. With n points y_k of weight w_k on the emitter of area A, whose mean w is 1,
//!
//! ```text
//! v_l ≈ Σ_k w_k κ(x, y_k) V(x, y_k) / Σ_k w_k κ(x, y_k) ,
//! U_l ≈ A/n Σ_k w_k κ(x, y_k)        where it has no closed form .
//! ```
//!
//! U_l of flat diffuse emitters and of whole curved surfaces has a closed form but for some points near them;
//! that of openings to a sky is a sum over cells, to ε of it or, where an emitter may send but the share s < 0.02 of
//! all light, to 0.02 ε/s (`super::light_sources`). What may stand between a point and an emitter that sends at least
//! a tenth of all light is listed first ([`super::occluders`], `super::blockers`). Where a flat thing or convex body
//! hides all of the emitter v_l = 0; where nothing stands there v_l = 1; where at most 8 shadow volumes of flat things
//! hide a part of a flat diffuse emitter or of an opening, U_l v_l is the sum over what they leave of it: no ray is
//! sent, and D is exact for the former. Else rays ask what is listed. Rays of weaker emitters ask all surfaces.
//!
//! The points y_k are a Kronecker sequence, shifted for each x and l, on the emitter or, within three of its
//! radii, on its cells (`super::lamp_cells`). The first rays are 24 times the share of the emitter in all
//! light, or, where U_l has no closed form, min(32, (0.45 share/ε)^(4/3)), but 4 at least. Then the rays to
//! the emitter of the largest error e_l are doubled, among those with less than 1024, until there is none or
//!
//! ```text
//! Σ_l e_l² ≤ (c ε)² max( D + light beside it , 0.02 Σ_l b_l )² ,     e_l = 0.9 σ_l E₀ U_l n^(−3/4) ,
//! ```
//!
//! with D as the first rays find it, the bound b_l of unshadowed light (`super::lamps`), the factor c of
//! [`RayEffort::error_factor`], all of them and E₀ means over the bands, and
//!
//! ```text
//! σ_l = ½   of even emitters with a closed form ,
//! σ_l² = max( ¼ , n Σ (w κ (V − v_l))² / (Σ w κ)² )   of openings, whose light varies over them ,
//! σ_l² = max( ¼ , (n Σ (w κ V)² − (Σ w κ V)²) / (Σ w κ)² )   where rays tell U_l too .
//! ```
//!
//! Where U_l is known and all rays agree, e_l is 0, or 0.37 E₀ U_l/n if [`RayEffort::sure`]: n rays
//! miss a part f of the emitter with the probability (1 − f)ⁿ, and f (1 − f)ⁿ ≤ 1/(e n).
//!
//! Range of use. Emitters with an exitance; the light of luminaires and of the sun comes on top, by
//! [`crate::point_lights`]. Few rays may miss something small: so each point tells which emitters it sees
//! ([`VisibleEmitters`]), and where points beside each other differ in that, callers ask again with
//! [`RayEffort::sure`].
//!
//! Error. Estimated, no bound: e_l is that of a shadow with a straight edge, where 0.39 to 0.45 n^(−3/4) were
//! measured.
//!
//! References: D. P. Mitchell, *Consequences of stratified sampling in graphics*, SIGGRAPH 96, 277–280
//! (n^(−3/4) at edges); R. Cranley, T. Patterson, *SIAM J. Numer. Anal.* 13 (1976) 904–914 (shifts).

use std::iter;

use radiosity_elements::sampling::shift::{number_of, shift};
use radiosity_geom::DVec3;
use radiosity_visibility::Visibility;
use radiosity_visibility::shadow_volume::ShadowVolume;
use serde::{Deserialize, Serialize};
use smallvec::SmallVec;

use crate::blockers::{BlockerRange, Shadows};
use crate::emitters::{Emitters, Radiances};
use crate::lamp_cells::LampCells;
use crate::lamps::Lamp;
use crate::light_sources::LightSource;
use crate::occluders::{Occluders, Site};
use crate::point_lights::PointLights;
use crate::receiver_point::ReceiverPoint;
use crate::tolerances::DARK;

/// Rays to an emitter that sends all direct light, before they are compared; fewer to weaker ones. A blocker
/// that hides less than a 24th of it may be missed.
const FIRST: f64 = 24.0;
/// Fewest rays to an emitter before they are compared: they find a shadow that is larger than a fourth of it.
const FEWEST: u64 = 4;

/// Share of all light that an emitter sends at least for which it is listed what may stand before it. Chosen:
/// a list costs about as much as [`FEWEST`] rays.
const LISTED: f64 = 0.1;

/// Obstacles listed for a site, at most, that are looked at before a weaker emitter. Chosen: each costs about as
/// much as a ray.
const FEW: usize = 4;

/// Shadow volumes of flat things, at most, that are cut out of a flat emitter. Chosen: the cost doubles with
/// each that overlaps.
const CUT_OUT: usize = 8;

/// Rays to a curved emitter, at most, before they are compared: some more than to a flat one, since half of
/// its points may face away.
const FIRST_TO_CURVED: f64 = 32.0;

/// Part of U by which what blockers leave of it is less where they hide anything: more than rounding. Chosen.
const SEEN_WHOLE: f64 = 1e-9;

/// Most rays to an emitter: a bound of the time of a point, at which n^(−3/4) is 0.6 %.
const MOST: u64 = 1024;

/// Error times n^¾ of n points of the sequence over the standard deviation of what they see, and the least of
/// these. Root mean square errors of the part of a square behind a straight edge, over random edges and
/// shifts, were measured for n = 48 to 384: 0.39 to 0.45 n^(−3/4).
const EDGE: f64 = 0.9;
const LEAST: f64 = 0.5;

/// Light that n rays miss, or see too much, times n: at most (1 − f)ⁿ f n = 1/e of what a part f of an
/// emitter sends.
const MISSED: f64 = 0.37;

/// An emitter is cut into cells within as many of its radii: there one cell would be larger than half its
/// distance.
const NEAR: f64 = 3.0;

/// Direct light by rays.
#[derive(Debug)]
pub struct Penumbra<'a> {
    visibility: &'a Visibility,
    sources: Vec<LightSource<'a>>,
    radiances: &'a Radiances,
    points: &'a PointLights,
    bands: usize,
    /// Accuracy relative to the light that arrives.
    eps: f64,
}

/// Accuracy and certainty that rays have to reach.
#[derive(Clone, Copy, Debug)]
pub struct RayEffort {
    /// Factor on the allowed error.
    pub error_factor: f64,
    /// Whether emitters seen wholly or not at all need as many rays as those in between.
    pub sure: bool,
}

/// Direct light at a point.
#[derive(Clone, Debug)]
pub struct DirectEstimate {
    /// The emitting elements that may send light to it, and the irradiance from each over its exitance.
    pub factors: Vec<EmitterFactor>,
    /// Irradiance from luminaires, per band (W m⁻²).
    pub points: Vec<f64>,
    /// Emitters that the point sees.
    pub visible: VisibleEmitters,
    /// Standard deviation of it, the mean over the bands (W m⁻²).
    pub error: f64,
}

/// The irradiance from an element over its exitance.
#[derive(Clone, Copy, Debug)]
pub struct EmitterFactor {
    /// Index of the element.
    pub element: usize,
    /// Irradiance over exitance, U_l v_l, without a unit.
    pub value: f64,
}

/// Emitters that a point sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum VisibleEmitters {
    /// Some emitters are seen only partly.
    Partial,
    /// Emitters are seen wholly or not at all; the number tells which.
    Sees(u64),
}

/// Obstacles between a point and an emitter, as far as they are known.
#[expect(clippy::large_enum_variant, reason = "one for each beam, made for one point: boxes would cost more")]
enum Obstruction<'a> {
    /// No obstacle stands there.
    Nothing,
    /// Some of these obstacles may stand there.
    Some(Shadows<'a>, BlockerRange),
    /// Any surface may stand there.
    Anything,
}

/// The light between a point and an emitter.
struct EmitterBeam<'a> {
    source: &'a LightSource<'a>,
    /// U_l v_l, where that needs no rays.
    known: Option<f64>,
    between: Obstruction<'a>,
    cells: LampCells<'a>,
    offset: [f64; 3],
    /// U_l, where that needs no rays.
    whole: Option<f64>,
    sent: u64,
    /// Σ w κ and Σ (w κ)² over all rays.
    all: f64,
    all_squares: f64,
    /// Σ w κ and Σ (w κ)² over those that arrive.
    seen: f64,
    squares: f64,
}

impl<'a> Penumbra<'a> {
    /// The direct light of `sources`, to the accuracy `eps` of what arrives.
    pub fn new(sources: &Emitters<'a>, visibility: &'a Visibility, eps: f64) -> Self {
        let (radiances, points, bands) = (sources.radiances, sources.points, sources.coatings.len());
        Self { visibility, sources: LightSource::all(sources, visibility), radiances, points, bands, eps }
    }

    /// Obstacles that may stand between a site and each emitter: with them, points of the site need few rays.
    pub fn around(&self, site: &Site) -> Occluders {
        let senders = self.sources.iter().map(LightSource::sender);
        self.narrowed(&Occluders::new(self.visibility, senders, site), site)
    }

    /// The part of `around` that may stand between a part of the site that this was listed for and each emitter.
    pub fn narrowed(&self, around: &Occluders, part: &Site) -> Occluders {
        let hulls: Vec<&[DVec3]> = self.sources.iter().map(|source| source.extent().hull).collect();
        around.narrowed(self.visibility, &hulls, part)
    }

    /// The direct light at a point where `beside` it other light arrives (W m⁻², mean over the bands); `around`
    /// is what may stand between a site that holds the point and the emitters, where that is known.
    pub fn estimate(
        &self,
        receiver: &ReceiverPoint,
        around: Option<&Occluders>,
        beside: f64,
        effort: RayEffort,
    ) -> DirectEstimate {
        let mut points = vec![0.0; self.bands];
        self.points.add(receiver, self.visibility, &mut points);
        let beside = beside + points.iter().sum::<f64>() / self.bands as f64;
        let bounds: Vec<f64> = self.sources.iter().map(|source| source.lamp.bound(receiver)).collect();
        let all: f64 = bounds.iter().sum();
        let (mut clear, mut open) = (SmallVec::<[EmitterFactor; 16]>::new(), SmallVec::<[usize; 16]>::new());
        let mut arrives = 0.0;
        for index in (0..bounds.len()).filter(|index| bounds[*index] > 0.0) {
            match around.and_then(|around| self.without_rays(receiver, around, index)) {
                Some(value) if value > 0.0 => {
                    let Lamp { element, brightness, .. } = self.sources[index].lamp;
                    arrives += brightness * value;
                    clear.push(EmitterFactor { element, value });
                }
                Some(_) => {}
                None => open.push(index),
            }
        }
        let of = |index: usize| {
            let (source, share) = (&self.sources[index], bounds[index] / all);
            (source, share, self.listed(receiver, around, index, share))
        };
        let some: SmallVec<[(&LightSource, f64, Option<Occluders>); 4]> = open.into_iter().map(of).collect();
        let beams =
            some.iter().map(|(source, share, listed)| self.beam(receiver, source, *share, listed.as_ref()));
        let is_dark = |beam: &EmitterBeam| beam.whole == Some(0.0) || beam.known == Some(0.0);
        let mut beams: SmallVec<[EmitterBeam; 1]> = beams.filter(|beam| !is_dark(beam)).collect();
        arrives += beams.iter().map(|beam| beam.source.lamp.brightness * beam.factor()).sum::<f64>();
        let tolerance = effort.error_factor * self.eps * (beside + arrives).max(DARK * all);
        let error = self.refine(receiver, &mut beams, tolerance, effort.sure);
        let factor =
            |beam: &EmitterBeam| EmitterFactor { element: beam.source.lamp.element, value: beam.factor() };
        DirectEstimate {
            visible: visible_emitters(&beams, &clear),
            factors: beams.iter().map(factor).chain(clear).collect(),
            points,
            error,
        }
    }

    /// U_l v_l of the emitter with this index, where a list for a site of the point says that nothing of it is
    /// hidden, and it has a closed form, or that it is out of sight.
    fn without_rays(&self, receiver: &ReceiverPoint, around: &Occluders, index: usize) -> Option<f64> {
        match around.before(index) {
            None => Some(0.0),
            Some([]) => {
                let polygons = self.sources[index].polygons()?;
                Some(polygons.iter().map(|polygon| receiver.factor(polygon, iter::empty())).sum())
            }
            Some(_) => None,
        }
    }

    /// Obstacles that may stand between a point and the emitter with this index, of the part `share` of all light,
    /// by a list for a site that holds the point, or if that is worth a list.
    fn listed(
        &self,
        receiver: &ReceiverPoint,
        around: Option<&Occluders>,
        index: usize,
        share: f64,
    ) -> Option<Occluders> {
        let is_worth =
            |around: &Occluders| share >= LISTED || around.before(index).is_none_or(|own| own.len() <= FEW);
        match around {
            Some(around) => is_worth(around).then(|| around.alone(index)),
            None => (share >= LISTED).then(|| {
                Occluders::before_one(self.visibility, self.sources[index].sender(), &receiver.site())
            }),
        }
    }

    /// The light from an emitter that sends about the part `share` of all light without shadows: known, or by
    /// the first rays.
    fn beam<'l>(
        &'l self,
        receiver: &'l ReceiverPoint,
        source: &'l LightSource,
        share: f64,
        listed: Option<&'l Occluders>,
    ) -> EmitterBeam<'l> {
        let between =
            listed.map_or(Some(Obstruction::Anything), |listed| self.between(receiver, source, listed));
        // What errs by ε of the least light that counts is exact enough.
        let eps = self.eps * (DARK / share).max(1.0);
        let known = match &between {
            None => Some(0.0),
            Some(Obstruction::Some(shadows, before)) if is_cut_out(shadows, *before) => {
                self.cut_out(receiver, source, shadows.volumes(*before), listed, eps)
            }
            Some(_) => None,
        };
        // A sum over cells costs as much as what is known already.
        let whole = match known {
            Some(known) if known == 0.0 || source.is_opening() => None,
            _ => source.whole(receiver, self.visibility, eps),
        };
        let known = known.or_else(|| whole.filter(|_| matches!(between, Some(Obstruction::Nothing))));
        let place = receiver.position.to_array().into_iter();
        let mut beam = EmitterBeam {
            cells: cells(&source.lamp, receiver),
            offset: shift(number_of(place.chain([source.lamp.element as f64]))),
            source,
            known,
            between: between.unwrap_or(Obstruction::Nothing),
            whole,
            sent: 0,
            all: 0.0,
            all_squares: 0.0,
            seen: 0.0,
            squares: 0.0,
        };
        if whole != Some(0.0) && known.is_none() {
            let first = if whole.is_some() { FIRST * share } else { self.first_to_curved(share) };
            self.send(receiver, &mut beam, (first as u64).max(FEWEST));
        }
        beam
    }

    /// Listed obstacles that stand between a point and an emitter; None where they hide all of it.
    fn between<'l>(
        &'l self,
        receiver: &'l ReceiverPoint,
        source: &LightSource,
        listed: &'l Occluders,
    ) -> Option<Obstruction<'l>> {
        let places = listed.before(0)?;
        let closes = |place: &usize| source.is_closed_by(self.visibility.faces(&listed.obstacles[*place]));
        let places: SmallVec<[usize; 16]> = places.iter().copied().filter(|place| !closes(place)).collect();
        if places.is_empty() {
            return Some(Obstruction::Nothing);
        }
        let mut shadows = Shadows::new(receiver, self.visibility, listed);
        let asked = shadows.ask(&places, source.bounds());
        let before = shadows.narrow_to(asked, &source.extent())?;
        Some(if before.is_empty() { Obstruction::Nothing } else { Obstruction::Some(shadows, before) })
    }

    /// U_l v_l of a flat emitter behind the shadow volumes `volumes` of all that is listed before it, of an opening
    /// to the relative accuracy `eps`; None of others.
    fn cut_out<'s>(
        &self,
        receiver: &ReceiverPoint,
        source: &LightSource,
        volumes: impl Iterator<Item = &'s ShadowVolume> + Clone,
        listed: Option<&Occluders>,
        eps: f64,
    ) -> Option<f64> {
        match source.polygons() {
            Some(polygons) => {
                Some(polygons.iter().map(|polygon| receiver.factor(polygon, volumes.clone())).sum())
            }
            None => source.through_opening(receiver, self.visibility, listed?, eps),
        }
    }

    /// Rays by which a curved emitter of the part `share` of all light errs by the accuracy, if so many are
    /// not too many.
    fn first_to_curved(&self, share: f64) -> f64 {
        (EDGE * LEAST * share / self.eps).powf(4.0 / 3.0).min(FIRST_TO_CURVED)
    }

    /// Doubles the rays to the emitter whose light errs most, until all together err by `tolerance` at most; the error
    /// that is left, the mean over the bands (W m⁻²).
    fn refine(&self, receiver: &ReceiverPoint, beams: &mut [EmitterBeam], tolerance: f64, sure: bool) -> f64 {
        let mut errors: SmallVec<[f64; 16]> = beams.iter().map(|beam| beam.error(sure)).collect();
        loop {
            let all = errors.iter().map(|error| error * error).sum::<f64>().sqrt();
            let open = (0..beams.len()).filter(|k| beams[*k].known.is_none() && beams[*k].sent < MOST);
            let worst = open.max_by(|a, b| errors[*a].total_cmp(&errors[*b]));
            let Some(worst) = worst.filter(|_| all > tolerance) else { return all };
            let beam = &mut beams[worst];
            self.send(receiver, beam, beam.sent);
            errors[worst] = beam.error(sure);
        }
    }

    /// Sends `count` rays more.
    fn send(&self, receiver: &ReceiverPoint, beam: &mut EmitterBeam, count: u64) {
        for index in beam.sent..beam.sent + count {
            let target = beam.cells.target(index, &beam.offset);
            let Some(kernel) = receiver.kernel_to(&target.node) else { continue };
            let into = (receiver.position - target.node.position).normalize_or_zero();
            let value = target.weight * kernel * self.radiances.relative(beam.source.surface, into);
            beam.all += value;
            beam.all_squares += value * value;
            if self.is_free(receiver, beam, target.node.position) {
                beam.seen += value;
                beam.squares += value * value;
            }
        }
        beam.sent += count;
    }

    /// Whether the point `y` of the emitter is seen.
    fn is_free(&self, receiver: &ReceiverPoint, beam: &EmitterBeam, y: DVec3) -> bool {
        match &beam.between {
            Obstruction::Nothing => true,
            Obstruction::Some(shadows, before) => !shadows.hide(*before, y, beam.source.surface),
            Obstruction::Anything => self.visibility.is_free(receiver.surface, receiver.position, y),
        }
    }
}

/// Whether what stands before an emitter is cut out of it: few things, all flat.
fn is_cut_out(shadows: &Shadows, before: BlockerRange) -> bool {
    shadows.are_flat(before) && shadows.volumes(before).count() <= CUT_OUT
}

/// The targets on an emitter as seen from a point.
fn cells<'l>(lamp: &'l Lamp, receiver: &ReceiverPoint) -> LampCells<'l> {
    match lamp.distance(receiver.position) < NEAR * lamp.radius() {
        true => LampCells::near(&lamp.area_map, receiver),
        false => LampCells::whole(&lamp.area_map),
    }
}

/// Which emitters are seen: those of beams, and those that are seen whole.
fn visible_emitters(beams: &[EmitterBeam], whole: &[EmitterFactor]) -> VisibleEmitters {
    if beams.iter().any(EmitterBeam::is_mixed) {
        return VisibleEmitters::Partial;
    }
    let beams = beams.iter().filter(|beam| beam.factor() > 0.0).map(|beam| beam.source.lamp.element);
    let mut seen: SmallVec<[usize; 16]> = beams.chain(whole.iter().map(|own| own.element)).collect();
    seen.sort_unstable();
    VisibleEmitters::Sees(number_of(seen.into_iter().map(|element| element as f64)))
}

impl EmitterBeam<'_> {
    /// U_l, or what rays say of it.
    fn size(&self) -> f64 {
        self.whole.unwrap_or(self.all * self.source.lamp.area / self.sent as f64)
    }

    /// U_l v_l, without a unit.
    fn factor(&self) -> f64 {
        self.known.unwrap_or_else(|| if self.all > 0.0 { self.size() * self.seen / self.all } else { 0.0 })
    }

    /// Error of its light; of light that is seen wholly or not at all only if one must be `sure` of that.
    fn error(&self, sure: bool) -> f64 {
        if self.known.is_some() {
            return 0.0;
        }
        let size = self.source.lamp.brightness * self.size();
        match self.is_mixed() || self.whole.is_none() {
            true => EDGE * self.deviation() * size * (self.sent as f64).powf(-0.75),
            false if sure => MISSED * size / self.sent as f64,
            false => 0.0,
        }
    }

    /// σ: ½ of even emitters whose U_l is known; else the standard deviation of w κ V, or of w κ (V − v) of an
    /// opening, over the mean of w κ, at least ½.
    fn deviation(&self) -> f64 {
        let is_opening = self.source.is_opening();
        if self.all == 0.0 || (self.whole.is_some() && !is_opening) {
            return LEAST;
        }
        let (rays, part) = (self.sent as f64, self.seen / self.all);
        let squares = match is_opening {
            true => (1.0 - 2.0 * part) * self.squares + part * part * self.all_squares,
            false => self.squares - self.seen * self.seen / rays,
        };
        ((squares.max(0.0) * rays).sqrt() / self.all).max(LEAST)
    }

    /// Whether it is seen partly. An opening from which blockers are cut out counts so where they leave anything:
    /// how much they hide is not asked.
    fn is_mixed(&self) -> bool {
        match (self.known, self.whole) {
            (Some(known), Some(whole)) => known > 0.0 && known < (1.0 - SEEN_WHOLE) * whole,
            (Some(known), None) => known > 0.0,
            (None, _) => self.seen > 0.0 && self.seen < self.all,
        }
    }
}
