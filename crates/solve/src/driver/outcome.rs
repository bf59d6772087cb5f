//! The solution with its cost and self-checks.

use std::ops::AddAssign;
use std::time::{Duration, Instant};

use radiosity_kernel::{PairCounts, WorstError};
use radiosity_published::hierarchy::Counts;
use radiosity_scene::Scene;
use serde::Serialize;

use crate::checks::Checks;
use crate::solution::Solution;

use super::cost::{NUMBER, seconds_of_rays, seconds_of_samples};
use super::sampling::Sampling;
use super::shots::Shots;
use super::transport_choice::TransportChoice;
use super::unknowns::Unknowns;

/// The solution with its cost and self-checks.
#[derive(Debug)]
pub struct Outcome {
    /// Polynomials of irradiance and radiosity.
    pub solution: Solution,
    /// Self-checks.
    pub checks: Checks,
    /// Numbers of pairs by how they were treated.
    pub pairs: PairCounts,
    /// Terms of the kernel's quadrature rules.
    pub samples: u64,
    /// Kernel evaluations; fewer than the terms where kernel values repeat.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
    /// Largest error that unresolved parts leave in a block, relative to its scale
    /// ([`BlockStatistics::accuracy_reached`](radiosity_kernel::BlockStatistics)).
    pub accuracy_reached: f64,
    /// The block whose error is the largest multiple of what was asked of it.
    pub worst_error: Option<WorstError>,
    /// Name of the solver that was used, also where the choice was left open.
    pub solver: &'static str,
    /// Iterations, largest over the bands.
    pub iterations: usize,
    /// Relative residual of the original system, largest over the bands.
    pub residual: f64,
    /// Whether direct light was split off.
    pub split: bool,
    /// Whether the solver converged in every band; if not, the solution is its best iterate, or what as many
    /// shots as were asked for give.
    pub converged: bool,
    /// Number of coefficients per band.
    pub unknowns: usize,
    /// The variational functional at the solution, band by band and in each of all light groups; empty where
    /// nothing was solved for, or light was shot.
    pub functionals: Vec<Functional>,
    /// The carrier of the pairs of elements, and the reason for it.
    pub choice: TransportChoice,
    /// Cost and error of the rays, where they carried the pairs.
    pub sampling: Option<Sampling>,
    /// Numbers of links, where hierarchical radiosity found the light.
    pub links: Option<Counts>,
    /// Shots, where light was shot.
    pub shots: Option<Shots>,
    /// Wall time of each stage.
    pub seconds: Stages,
}

/// The light of a frame, without self-checks.
#[derive(Debug)]
pub(crate) struct FrameLight {
    /// Polynomials of irradiance and radiosity.
    pub solution: Solution,
    /// As [`Outcome::residual`].
    pub residual: f64,
    /// As [`Outcome::converged`].
    pub converged: bool,
    /// As [`Outcome::worst_error`].
    pub worst_error: Option<WorstError>,
    /// As [`Outcome::sampling`].
    pub sampling: Option<Sampling>,
    /// As [`Outcome::seconds`].
    pub seconds: Stages,
    /// Unknowns from which the next frame may start.
    pub unknowns: Unknowns,
}

impl FrameLight {
    /// Estimated relative error that rays left, where they carried the pairs; else 0.
    pub(crate) fn noise(&self) -> f64 {
        self.sampling.and_then(|sampling| sampling.error).unwrap_or(0.0)
    }
}

impl Outcome {
    /// Seconds of the kernel's rules, of rays, and of the systems.
    pub fn seconds_by_counts(&self) -> f64 {
        let rays = self.rays.max(self.sampling.map_or(0, |sampling| sampling.rays));
        let in_bands = self.iterations * self.solution.bands().len();
        let numbers = (self.unknowns as f64).powi(2) * in_bands as f64;
        seconds_of_samples(self.samples as f64) + seconds_of_rays(rays as f64) + NUMBER * numbers
    }

    /// The outcome for the same light at the factors of the groups of `scene`, which is the scene of this
    /// solution; None if the light of its groups is not kept apart.
    pub fn relight(&self, scene: &Scene) -> Option<Self> {
        let solution = self.solution.relight(scene)?;
        let residuals = solution.bands().iter().map(|band| band.coefficients.residual);
        Some(Self {
            checks: self.checks.relight(&solution),
            residual: residuals.fold(0.0, f64::max),
            choice: self.choice.clone(),
            functionals: self.functionals.clone(),
            shots: self.shots.clone(),
            solution,
            ..*self
        })
    }
}

/// The variational functional I(y) = ½ ⟨(I − √ρ G √ρ) y, y⟩ − ⟨f, y⟩ at a solution ([`crate::system::ritz`]):
/// lower in a larger space, by half the square of the error of energy.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Functional {
    /// Name of the band.
    pub band: String,
    /// The light group whose emission, not dimmed, is the only one; None for what has no group.
    pub group: Option<String>,
    /// I(y), in the square of the unit of exitance times scene length².
    pub value: f64,
}

/// Wall time per stage.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stages {
    /// Cutting into elements, with their bases.
    pub elements: Duration,
    /// Finding out whether anything can cast a shadow.
    pub visibility: Duration,
    /// Blocks of G, visibility within them included.
    pub blocks: Duration,
    /// Direct light and its first bounce, where they are split off.
    pub direct: Duration,
    /// The linear systems.
    pub solve: Duration,
    /// Estimation of the error from gathered light, where an accuracy is wanted.
    pub estimate: Duration,
}

impl AddAssign for Stages {
    fn add_assign(&mut self, other: Self) {
        let Self { elements, visibility, blocks, direct, solve, estimate } = self;
        *elements += other.elements;
        *visibility += other.visibility;
        *blocks += other.blocks;
        *direct += other.direct;
        *solve += other.solve;
        *estimate += other.estimate;
    }
}

/// Runs `work`, and stores its wall time in `stage`.
pub(crate) fn timed<T>(stage: &mut Duration, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *stage = start.elapsed();
    result
}
