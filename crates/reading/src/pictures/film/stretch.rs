//! Reflected light at spots in some frames that follow each other: gathered in some, interpolated in others.
//!
//! Spots are the nodes of the light field, which move with their surfaces, and the places at which light is gathered
//! alone, where they are seen at rest. One is gathered in five frames of a span. Where these predict each other,
//!
//! ```text
//! Σ_b |f_b(t_k) − p_b(t_k)| ≤ τ √(E max(E, Ē)) + s ,     k = 1, 3 ,     p_b through f_b(t_0), f_b(t_2), f_b(t_4) ,
//! ```
//!
//! of degree 2 in each band b, with all light E of all bands, its mean Ē in the scene and the deviation s of gathered
//! light, a polynomial of degree 4 gives it in the other frames (`span`). Elsewhere the span is halved, until all of
//! its frames are gathered: beside what moves (`movement`), where the polynomials of the solution, which are known in
//! all frames, tell that light does something between the five, where the spot is covered in one of them, and where
//! some of the frames are at rest and others not. So frames at rest are alike to the bit.

use std::collections::HashMap;

use radiosity_geom::DVec3;
use radiosity_work::Work;
use rayon::prelude::*;

use super::film_error::FilmError;
use super::movement::Movement;
use super::span::{EVEN, ODD, POINTS, Span, interpolated, weights};
use crate::pictures::eye::SeenPlace;
use crate::pictures::light_field::SpotSource;
use crate::pictures::light_field::spot::Spot;
use crate::pictures::light_field::spot_gatherer::{SpotGatherer, SpotLight};
use crate::pictures::picture_light::ComputedLight;

/// Most difference τ of light from its prediction: the polynomial of degree 4 errs by some part of it. Measured in the
/// billiard room, 33 frames: with 7e-3, and half of the next constant, light erred by 0.10 % where it was interpolated.
const SMOOTH: f64 = 1.5e-2;

/// Most difference of the solution's polynomials from those in time, in the same unit. Chosen: their own errors
/// change from frame to frame.
const BUMP: f64 = 6e-2;

/// Spots of which one is gathered although it is interpolated, to tell the error. Chosen.
const TOLD_EACH: usize = 32;

/// Most difference of the parameters of a spot that stays in its place on a surface: roundings.
const STAYS: f64 = 1e-6;

/// Spots in frames that follow each other.
pub(super) struct Stretch<'a> {
    gatherers: Vec<SpotGatherer<'a>>,
    /// Spots that were gathered, of each frame; None where they have no place.
    known: Vec<HashMap<Spot, Option<SpotLight>>>,
    movement: Movement,
    /// Whether the light of a spot may be interpolated over a span, as far as that was asked.
    smooth: HashMap<SpotSpan, bool>,
    error: FilmError,
}

/// A spot in some frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct SpotSpan {
    spot: Spot,
    span: Span,
}

/// A spot in one frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct SpotMoment {
    frame: usize,
    spot: Spot,
}

/// The source of the light of a spot in a frame.
#[derive(Clone, Copy, Debug)]
enum Origin {
    /// It is gathered.
    Gathered,
    /// It is interpolated over a span, where it is smooth.
    Interpolated(Span),
}

/// A span over which light has first to be gathered, to know whether it is smooth.
#[derive(Clone, Copy, Debug)]
struct OpenSpan(Span);

impl<'a> Stretch<'a> {
    /// The spots of the frames of these gatherers, of which those of the first are known so far.
    pub(super) fn new(
        gatherers: Vec<SpotGatherer<'a>>,
        movement: Movement,
        first: HashMap<Spot, Option<SpotLight>>,
    ) -> Self {
        let mut known = vec![HashMap::new(); gatherers.len()];
        known[0] = first;
        Self { gatherers, known, movement, smooth: HashMap::new(), error: FilmError::default() }
    }

    /// The error of what was interpolated, and the spots that were gathered in the last frame.
    pub(super) fn end(mut self) -> (FilmError, HashMap<Spot, Option<SpotLight>>) {
        (self.error, self.known.pop().unwrap_or_default())
    }

    /// These spots in a frame.
    fn spots(&mut self, frame: usize, wanted: &[Spot], work: &Work<'_>) -> Vec<Option<SpotLight>> {
        for gatherer in &mut self.gatherers {
            gatherer.prepare(wanted.iter().map(|spot| spot.surface()));
        }
        let origins = self.origins(frame, wanted, work);
        let is_gathered = |origin: &Origin| matches!(origin, Origin::Gathered);
        let alone = wanted.iter().zip(&origins).filter(|(_, origin)| is_gathered(origin));
        self.gather(alone.map(|(spot, _)| SpotMoment { frame, spot: *spot }).collect(), work);
        let found: Vec<Option<SpotLight>> = wanted
            .par_iter()
            .zip(&origins)
            .map(|(spot, origin)| match origin {
                Origin::Interpolated(span) => self.interpolated(*spot, *span, frame),
                Origin::Gathered => self.known[frame].get(spot)?.clone(),
            })
            .collect();
        let own = || (0..wanted.len()).filter(|index| !is_gathered(&origins[*index]));
        let before = self.error.interpolated();
        let next = before.next_multiple_of(TOLD_EACH) - before;
        let told: Vec<usize> = own().skip(next).step_by(TOLD_EACH).collect();
        self.error.count(0, own().count());
        self.tell(
            frame,
            &told.iter().map(|index| (wanted[*index], found[*index].as_ref())).collect::<Vec<_>>(),
            work,
        );
        found
    }

    /// The sources of the light of these spots in a frame.
    fn origins(&mut self, frame: usize, wanted: &[Spot], work: &Work<'_>) -> Vec<Origin> {
        let whole = Span { first: 0, last: self.gatherers.len() - 1 };
        loop {
            let (found, rough): (Vec<Result<Origin, OpenSpan>>, Vec<Vec<SpotSpan>>) =
                wanted.par_iter().map(|spot| self.origin(*spot, whole, frame)).unzip();
            self.smooth.extend(rough.into_iter().flatten().map(|span| (span, false)));
            if let Ok(origins) = found.iter().copied().collect() {
                return origins;
            }
            let open = wanted.iter().zip(&found).filter_map(|(spot, origin)| {
                let OpenSpan(span) = origin.err()?;
                Some(SpotSpan { spot: *spot, span })
            });
            self.try_smooth(&open.collect::<Vec<_>>(), work);
        }
    }

    /// The source of the light of a spot in a frame, as far as that is known without gathering more; and spans
    /// over which it is not smooth.
    fn origin(&self, spot: Spot, mut span: Span, frame: usize) -> (Result<Origin, OpenSpan>, Vec<SpotSpan>) {
        let mut rough = Vec::new();
        loop {
            let Some(points) = span.points().filter(|points| !points.contains(&frame)) else {
                return (Ok(Origin::Gathered), rough);
            };
            match self.smooth.get(&SpotSpan { spot, span }) {
                Some(true) => return (Ok(Origin::Interpolated(span)), rough),
                None if self.may_be_smooth(spot, span, points) => return (Err(OpenSpan(span)), rough),
                None => rough.push(SpotSpan { spot, span }),
                Some(false) => {}
            }
            span = span.half(frame);
        }
    }

    /// Whether nothing that is known without gathering light speaks against interpolating that of a spot.
    fn may_be_smooth(&self, spot: Spot, span: Span, points: [usize; POINTS]) -> bool {
        let place = |frame: usize| self.gatherers[frame].place(spot);
        let places: Option<Vec<SeenPlace>> = span.frames().map(place).collect();
        let Some(places) = places.filter(|_| self.movement.is_even(span)) else { return false };
        let stays = |one: &SeenPlace| {
            let pairs = one.place.parameters.iter().zip(places[0].place.parameters);
            pairs.into_iter().all(|(one, other)| (one - other).abs() <= STAYS)
        };
        let at: [DVec3; POINTS] = points.map(|frame| places[frame - span.first].place.position);
        places.iter().all(stays)
            && self.movement.passes(spot.surface(), at, span, points)
            && self.has_no_bump(&places, span, points)
    }

    /// Whether the polynomials of the solution at a place, in all frames of a span, are about met by those in five.
    fn has_no_bump(&self, places: &[SeenPlace], span: Span, points: [usize; POINTS]) -> bool {
        let light = |frame: usize| self.gatherers[frame].light();
        let own = |frame: usize| light(frame).polynomials(&places[frame - span.first]);
        let values: Vec<Vec<f64>> = span.frames().map(own).collect();
        let known = points.map(|frame| &values[frame - span.first]);
        span.frames().zip(&values).all(|(frame, own)| {
            let weights = weights(points, frame);
            let predicted = |band: usize| interpolated(weights, known.map(|own| own[band]));
            apart(predicted, own) <= BUMP * light(frame).judged_by(own.iter().sum())
        })
    }

    /// Gathers the light of spots in five frames of spans, and finds out whether it is smooth.
    fn try_smooth(&mut self, open: &[SpotSpan], work: &Work<'_>) {
        let moments = |own: &SpotSpan| {
            let spot = own.spot;
            own.span.points().into_iter().flatten().map(move |frame| SpotMoment { frame, spot })
        };
        self.gather(open.iter().flat_map(moments).collect(), work);
        let smooth: Vec<bool> = open.par_iter().map(|own| self.is_smooth(*own).unwrap_or(false)).collect();
        self.smooth.extend(open.iter().copied().zip(smooth));
    }

    /// Whether the light of a spot in five frames of a span, which is known, is smooth; None where it has no place.
    fn is_smooth(&self, SpotSpan { spot, span }: SpotSpan) -> Option<bool> {
        let points = span.points()?;
        let lights = self.known_in(spot, points)?;
        let even = EVEN.map(|k| points[k]);
        Some(ODD.into_iter().all(|k| {
            let weights = weights(even, points[k]);
            let predicted = |band: usize| interpolated(weights, EVEN.map(|k| lights[k].light.bands[band]));
            let SpotLight { light, lit, .. } = lights[k];
            let judged = self.gatherers[points[k]].light().judged_by(light.bands.iter().sum::<f64>() + lit);
            apart(predicted, &light.bands) <= SMOOTH * judged + light.error
        }))
    }

    /// A spot that is known in some frames.
    fn known_in<const N: usize>(&self, spot: Spot, frames: [usize; N]) -> Option<[&SpotLight; N]> {
        let known = frames.iter().map(|frame| self.known[*frame].get(&spot)?.as_ref());
        known.collect::<Option<Vec<&SpotLight>>>()?.try_into().ok()
    }

    /// A spot in a frame, by those in five.
    fn interpolated(&self, spot: Spot, span: Span, frame: usize) -> Option<SpotLight> {
        let points = span.points()?;
        let lights = self.known_in(spot, points)?;
        let seen = self.gatherers[frame].place(spot)?;
        let weights = weights(points, frame);
        let of = |value: &dyn Fn(&SpotLight) -> f64| interpolated(weights, lights.map(value));
        let band = |band: usize| of(&|own| own.light.bands[band]).max(0.0);
        let bands = (0..lights[0].light.bands.len()).map(band).collect();
        let error = lights.iter().map(|own| own.light.error).fold(0.0, f64::max);
        Some(SpotLight { seen, light: ComputedLight { bands, error }, lit: of(&|own| own.lit) })
    }

    /// Gathers spots that are not known yet.
    fn gather(&mut self, mut moments: Vec<SpotMoment>, work: &Work<'_>) {
        moments.retain(|moment| !self.known[moment.frame].contains_key(&moment.spot));
        moments.sort_unstable();
        moments.dedup();
        for own in moments.chunk_by(|one, other| one.frame == other.frame) {
            let frame = own[0].frame;
            let spots: Vec<Spot> = own.iter().map(|moment| moment.spot).collect();
            let gathered = self.gatherers[frame].spots(&spots, work);
            self.known[frame].extend(spots.into_iter().zip(gathered));
        }
        self.error.count(moments.len(), 0);
    }

    /// Gathers some spots of a frame that are interpolated, to tell the error of these.
    fn tell(&mut self, frame: usize, found: &[(Spot, Option<&SpotLight>)], work: &Work<'_>) {
        let spots: Vec<Spot> = found.iter().map(|(spot, _)| *spot).collect();
        let gathered = self.gatherers[frame].spots(&spots, work);
        for ((_, own), gathered) in found.iter().zip(gathered) {
            let (Some(own), Some(right)) = (own, gathered) else { continue };
            let bands = &right.light.bands;
            let difference = apart(|band| own.light.bands[band], bands);
            self.error.take(difference, bands.iter().sum::<f64>() + right.lit);
        }
    }
}

/// Σ_b |difference| of light from that of each band: colour counts where the sum stays.
fn apart(light: impl Fn(usize) -> f64, bands: &[f64]) -> f64 {
    bands.iter().enumerate().map(|(band, own)| (light(band) - own).abs()).sum()
}

/// One frame of a stretch.
pub(super) struct StretchFrame<'a, 'b> {
    /// The stretch.
    pub stretch: &'a mut Stretch<'b>,
    /// The frame, counted from the first of the stretch.
    pub frame: usize,
}

impl SpotSource for StretchFrame<'_, '_> {
    fn spots(&mut self, wanted: &[Spot], work: &Work<'_>) -> Vec<Option<SpotLight>> {
        let movement = &self.stretch.movement;
        let is_shared =
            |spot: &Spot| matches!(spot, Spot::Node(_)) || movement.is_seen_at_rest(spot.surface());
        let is_shared: Vec<bool> = wanted.iter().map(is_shared).collect();
        let shared = wanted.iter().zip(&is_shared).filter_map(|(spot, is_shared)| is_shared.then_some(*spot));
        let shared: Vec<Spot> = shared.collect();
        let mut found = self.stretch.spots(self.frame, &shared, work).into_iter();
        is_shared.into_iter().map(|is_shared| if is_shared { found.next()? } else { None }).collect()
    }
}
