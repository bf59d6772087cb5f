//! The parts of a pair that face each other where a series begins, with points for rules.

use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, touching};
use radiosity_kernel::terms::{Demand, PatchPair};

use super::error::SeriesError;
use super::faces::{Faces, Moving};
use super::pair::MovedPair;
use super::settings::Settings;
use super::span::Span;

/// The parts of a pair that face each other at p = `centre`, to be expanded.
#[derive(Debug)]
pub(crate) struct Facing<'a> {
    pub pair: MovedPair<'a>,
    pub centre: f64,
    pub settings: Settings,
    /// The parts, with points for rules as the settings demand.
    pub parts: Vec<PatchPair>,
    /// t for which they face each other.
    pub span: Span,
    /// The t below which their series converge.
    pub convergence: f64,
}

impl<'a> Facing<'a> {
    /// The parts of `pair` that face each other at p = `centre`.
    ///
    /// # Errors
    /// A tolerance out of range; elements that touch or nearly do there, or of which one passes through the
    /// plane of the other.
    pub(crate) fn of(pair: &MovedPair<'a>, centre: f64, settings: Settings) -> Result<Self, SeriesError> {
        settings.checked()?;
        let MovedPair { receiver, emitter, motion, .. } = *pair;
        let [small, large] = [f64::min, f64::max].map(|of| of(receiver.extent, emitter.extent));
        let degrees = [receiver, emitter].map(|element| element.basis.total_degree());
        let (nearest, eps) = (1.0 - settings.reach(), 0.5 * settings.tolerance);
        let place = pair.place(centre);
        let demand = Demand { place, degrees, nearest, eps };
        let moving = Moving { place, motion, tolerance: touching(small, large) };
        let (parts, span) = (Vec::new(), Span::ALL);
        let mut facing = Self { pair: *pair, centre, settings, parts, span, convergence: f64::INFINITY };
        let surfaces = pair.surfaces();
        for patches in pair.patches() {
            match Faces::of(patches, &moving) {
                None | Some(Faces::Changing) => return Err(SeriesError::Horizon { surfaces, at: centre }),
                Some(Faces::Nothing(span)) => facing.span = facing.span.common(&span),
                Some(Faces::Parts(parts, span)) => {
                    facing.span = facing.span.common(&span);
                    facing.add(&demand, &parts).ok_or(SeriesError::Touching { surfaces, at: centre })?;
                }
            }
        }
        Ok(facing)
    }

    /// Adds the pairs of `parts`; None where they touch.
    fn add(&mut self, demand: &Demand, [of_receiver, of_emitter]: &[Vec<Patch>; 2]) -> Option<()> {
        for p in of_receiver {
            for q in of_emitter {
                self.parts.extend(demand.divided(p, q)?);
                let moved: Vec<DVec3> = q.polygon().iter().map(|y| demand.place.point(*y)).collect();
                let convergence = self.pair.motion.convergence([&p.polygon(), &moved], demand.distance(p, q));
                self.convergence = self.convergence.min(convergence);
            }
        }
        Some(())
    }

    /// Pairs of points at which the kernel will be expanded.
    pub(crate) fn samples(&self) -> u64 {
        self.parts.iter().map(PatchPair::samples).sum()
    }

    /// The t within which rules have points enough.
    pub(super) fn most(&self) -> f64 {
        self.settings.reach() * self.convergence
    }

    /// The p for which the parts face each other, and |t| is at most `radius`.
    pub(super) fn within(&self, radius: f64) -> Span {
        let span = self.span.common(&Span { from: -radius, to: radius });
        span.mapped(|t| self.centre + self.pair.motion.step(t))
    }

    /// The range that the series is expected to have.
    pub(crate) fn range(&self) -> Span {
        self.within(self.most())
    }
}
