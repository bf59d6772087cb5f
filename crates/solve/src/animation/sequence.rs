//! Frames solved one after the other, each as it would be alone, or from the one before.
//!
//! Nothing is known of the path: any frame may follow any other. What has not moved keeps its blocks, and
//! rays into whose way nothing has come keep their hits (`crates/transport/src/kept_blocks.rs`);
//! what has is integrated and traced again, and so are the pairs between which it came or went. The solution
//! of a frame does not depend on the frames before it, not in a bit, so nothing can drift.
//!
//! An incremental sequence starts each solution from the light of the frame before and ends it at a residual
//! of the whole system, which does not add up over frames; and its rays stand
//! (`crates/transport/src/sampled/standing.rs`).
//!
//! Whether rays or exact blocks carry the pairs, and how surfaces are cut, is decided once, for the scene at
//! rest.

use std::mem;
use std::sync::Arc;

use radiosity_core::norm;
use radiosity_elements::Element;
use radiosity_kernel::Remainder;
use radiosity_published::expansions::{Expansions, ORDERS, SeriesCounts, known};
use radiosity_scene::{FrameScenes, MoverState, Scene};
use radiosity_transport::{KeptBlocks, RayCounts};
use radiosity_work::Work;

use crate::driver::{Failure, FrameLight, KeptModel, Layout, Model, Options, Standing, Unknowns};

use super::error::AnimationError;
use super::frame::Frame;
use super::light_before::LightBefore;
use super::sequence_report::SequenceReport;
use crate::solution::{Band, Solution};
use crate::system::Coefficients;
use crate::system::vector::relative_distance;

/// Relative residual to which the difference of light is solved for, over the accuracy of the blocks.
/// Chosen: the residuals of a hundred frames do not add up, since each is that of the whole system.
const OF_BLOCK: f64 = 1e-2;

/// As much where rays carry the pairs, whose noise is some hundred times as large.
const OF_NOISY_BLOCK: f64 = 0.1;

/// Frames after which a frame that follows from the one before is solved whole as well, to measure how far it
/// is off.
const MEASURED_EACH: usize = 16;

/// The frames of a scene that moves.
#[derive(Debug)]
pub struct Sequence<'a> {
    frame_scenes: FrameScenes<'a>,
    options: Options,
    layout: Layout,
    kept: Kept,
    report: SequenceReport,
    /// Numbers of series by what they did for the last frame.
    counts: SeriesCounts,
    /// Cost of all solutions so far, in solutions of a frame alone.
    spent: f64,
    /// Bound of the relative difference that series made in the last frame.
    error: Option<f64>,
}

/// The parts of the frame before that are kept.
#[derive(Debug, Default)]
struct Kept {
    /// None where nothing is.
    model: Option<KeptModel>,
    /// Series of what is moved, where blocks may be sums of them.
    expansions: Option<Arc<Expansions>>,
    /// Light of the frames before, where only the difference is solved for.
    light: Option<LightBefore>,
}

impl Kept {
    /// Blocks and rays, but nothing yet.
    fn blocks_and_rays() -> Self {
        Self { model: Some(KeptModel::default()), ..Self::default() }
    }

    /// Blocks, rays that stand, and light, but nothing yet.
    fn light_too() -> Self {
        let model = KeptModel::beside(KeptBlocks::default(), Some(Standing::default()));
        Self { model: Some(model), light: Some(LightBefore::default()), expansions: None }
    }

    /// Blocks, rays and series that are kept.
    fn with_series(expansions: Expansions) -> Self {
        let expansions = Arc::new(expansions);
        let blocks = KeptBlocks::beside(known(&expansions));
        let model = Some(KeptModel::beside(blocks, None));
        Self { model, expansions: Some(expansions), light: None }
    }

    /// Parts of the same kinds, as before any frame.
    fn anew(&self) -> Self {
        match self {
            Self { model: None, .. } => Self::default(),
            Self { expansions: Some(expansions), .. } => Self::with_series(expansions.anew()),
            Self { light: Some(_), .. } => Self::light_too(),
            _ => Self::blocks_and_rays(),
        }
    }
}

impl Sequence<'static> {
    /// The sequence of [`Sequence::incremental`] of a scene that it keeps.
    pub(super) fn incremental_owned(scene: Scene, options: &Options) -> Self {
        Self::following(FrameScenes::owned(scene), options, f64::INFINITY)
    }
}

impl<'a> Sequence<'a> {
    /// The frames of `scene`, all solved with the same options.
    pub fn new(scene: &'a Scene, options: &Options) -> Self {
        Self { kept: Kept::blocks_and_rays(), ..Self::fresh(scene, options) }
    }

    /// The sequence of [`Sequence::new`], to the bit, with nothing kept between frames.
    pub fn fresh(scene: &'a Scene, options: &Options) -> Self {
        Self::of(FrameScenes::of(scene), options)
    }

    fn of(frame_scenes: FrameScenes<'a>, options: &Options) -> Self {
        Self {
            layout: Layout::of(frame_scenes.scene(), options),
            frame_scenes,
            options: *options,
            kept: Kept::default(),
            report: SequenceReport::default(),
            counts: SeriesCounts::default(),
            spent: 0.0,
            error: None,
        }
    }

    /// The frames of `scene`, each found from the one before: the difference of the light is solved for, to a
    /// part of the accuracy of blocks, and rays stand where nothing has come into their way.
    pub fn incremental(scene: &'a Scene, options: &Options) -> Self {
        Self::incremental_within(scene, options, f64::INFINITY)
    }

    /// As [`Sequence::incremental`], solved to this relative residual at least where exact blocks carry the
    /// pairs.
    pub(super) fn incremental_within(scene: &'a Scene, options: &Options, residual: f64) -> Self {
        Self::following(FrameScenes::of(scene), options, residual)
    }

    fn following(frame_scenes: FrameScenes<'a>, options: &Options, residual: f64) -> Self {
        let fresh = Self::of(frame_scenes, options);
        let wanted = match fresh.layout.is_by_rays() {
            true => OF_NOISY_BLOCK * options.eps,
            false => residual.min(OF_BLOCK * options.eps),
        };
        let tolerance = options.tolerance.max(wanted);
        Self { kept: Kept::light_too(), options: Options { tolerance, ..*options }, ..fresh }
    }

    /// As [`Sequence::new`], but blocks between flat elements that are moved, with nothing between them,
    /// are sums of series as far as that pays; they may be off by `tolerance` times their largest entries.
    pub fn by_series(scene: &'a Scene, options: &Options, tolerance: f64) -> Self {
        let kept = Kept::with_series(Expansions::new(tolerance, options.eps));
        Self { kept, ..Self::fresh(scene, options) }
    }

    /// Whether blocks may be sums of series.
    pub(super) fn has_series(&self) -> bool {
        self.kept.expansions.is_some()
    }

    /// The scene with its motions.
    pub(super) fn scene(&self) -> &Scene {
        self.frame_scenes.scene()
    }

    /// The options that every frame is solved with.
    pub(super) fn options(&self) -> &Options {
        &self.options
    }

    /// The light at a moment, a real number of frames.
    ///
    /// # Errors
    /// As [`Scene::at_moment`] and [`solve`](crate::driver::solve); series where rays carry the pairs.
    pub fn at(&mut self, moment: f64, work: &Work<'_>) -> Result<Frame, AnimationError> {
        let still = self.frame_scenes.at(moment)?;
        self.frame(still, Some(moment), work)
    }

    /// The light where the movers have these states, one for each in the order of the scene's animation,
    /// whatever their paths say.
    ///
    /// # Errors
    /// As [`FrameScenes::placed`] and [`solve`](crate::driver::solve); series where rays carry the pairs.
    pub fn placed(&mut self, states: &[MoverState], work: &Work<'_>) -> Result<Frame, AnimationError> {
        let still = self.frame_scenes.placed(states)?;
        self.frame(still, None, work)
    }

    /// The light of a still scene, at a moment if it has one.
    fn frame(&mut self, still: Scene, moment: Option<f64>, work: &Work<'_>) -> Result<Frame, AnimationError> {
        if self.has_series() && self.layout.is_by_rays() {
            return Err(AnimationError::ByRays);
        }
        // It is put back once the frame is solved: what fails or is interrupted leaves nothing that belongs
        // to half a frame.
        let anew = self.kept.anew();
        let mut kept = mem::replace(&mut self.kept, anew);
        kept.expansions.iter().for_each(|expansions| expansions.begin());
        let failed = |failure: Failure| AnimationError::of(moment, failure);
        let Kept { model: before, light: light_before, .. } = &mut kept;
        let model = Model::assemble_again(&still, &self.options, &self.layout, before.as_mut(), work);
        let model = model.map_err(failed)?;
        let start = light_before.as_ref().map(|light| light.start(moment)).unwrap_or_default();
        let mut light = model.frame_light(&start, work).map_err(failed)?;
        if let Some(before) = light_before {
            before.take(moment, mem::take(&mut light.unknowns));
        }
        self.kept = kept;
        let counts = self.kept.expansions.as_ref().map(|expansions| expansions.counts(work.ranks));
        self.counts = counts.unwrap_or_default();
        let traced = || RayCounts { traced: light.sampling.map_or(0, |sampling| sampling.rays), recalled: 0 };
        let rays = self.kept.model.as_ref().map_or_else(traced, |kept| kept.blocks.ray_counts());
        self.spent += self.share(&rays);
        self.error = series_error(&model.blocks().statistics.remainders, &light.solution);
        if self.kept.light.is_some() && self.options.bounces.is_none() {
            let measured = self.measured(&model, &light, work).map_err(failed)?;
            let unsolved = unsolved(&light.solution).max(measured);
            self.report.unsolved = self.report.unsolved.max(unsolved);
            self.error = Some(unsolved);
        }
        self.report.take(&still, &light, rays);
        let frame = Frame::of(still, model.into_visibility(self.kept.model.as_mut()), light);
        Ok(Frame { interpolated: self.error, ..frame })
    }

    /// Difference of the light of a frame from that of its whole solution, every so often; else 0.
    fn measured(&self, model: &Model, light: &FrameLight, work: &Work<'_>) -> Result<f64, Failure> {
        if !(self.report.moments + 1).is_multiple_of(MEASURED_EACH) {
            return Ok(0.0);
        }
        Ok(difference(&light.solution, &model.frame_light(&Unknowns::default(), work)?.solution))
    }

    /// Cost and error of all moments so far.
    pub fn report(&self) -> &SequenceReport {
        &self.report
    }

    /// Cost of all solutions so far, in solutions of a frame alone: by the numbers of blocks that were
    /// integrated, of which an expansion counts for one a term, or of rays that were traced.
    pub(super) fn spent(&self) -> f64 {
        self.spent
    }

    /// Bound of the relative difference between the light of the last frame and that of the frame alone, L2
    /// of its coefficients, that series make, or what is left unsolved; None where there were none.
    pub fn error(&self) -> Option<f64> {
        self.error
    }

    /// The last frame, for which these rays were sent, in solutions of a frame alone.
    fn share(&self, RayCounts { traced, recalled }: &RayCounts) -> f64 {
        let integrals = self.integrated() + self.expanded() * (ORDERS + 1);
        let blocks = self.integrated() + self.summed() + self.recalled();
        let (made, all) = match self.layout.is_by_rays() {
            true => (*traced, traced + recalled),
            false => (integrals as u64, blocks as u64),
        };
        if all == 0 { 1.0 } else { made as f64 / all as f64 }
    }

    /// Blocks that were integrated for the last frame.
    pub fn integrated(&self) -> usize {
        self.kept.model.as_ref().map_or(0, |kept| kept.blocks.integrated()) - self.summed()
    }

    /// Blocks of the last frame that are sums of series.
    pub fn summed(&self) -> usize {
        self.counts.summed
    }

    /// Blocks that were expanded for the last frame.
    pub fn expanded(&self) -> usize {
        self.counts.expanded
    }

    /// Blocks that the last frame has in common with the one before.
    pub fn recalled(&self) -> usize {
        self.kept.model.as_ref().map_or(0, |kept| kept.blocks.recalled())
    }
}

/// Bound of ‖δh‖/‖h‖ by the residual r of the radiosity, the largest of any band:
///
/// ```text
/// δb = (I − S G)⁻¹ r ,     ‖δh‖ ≤ ‖r‖/(1 − max (ρ + τ))
/// ```
fn unsolved(solution: &Solution) -> f64 {
    let starts = solution.elements().starts();
    let ones = solution.elements().constant();
    let of_band = |band: &Band| {
        let Coefficients { direct, residual, .. } = &band.coefficients;
        let emitted = norm(&band.coating.emitted(&starts, &ones));
        let scale = emitted + norm(&band.coating.reflected(&starts, direct));
        carried(residual * scale, band)
    };
    solution.bands().iter().map(of_band).fold(0.0, f64::max)
}

/// ‖h − h′‖/‖h′‖ of two solutions of a scene, the largest of any band.
fn difference(solution: &Solution, other: &Solution) -> f64 {
    let pairs = solution.bands().iter().zip(other.bands());
    let of_band = |(own, other): (&Band, &Band)| {
        relative_distance(&own.coefficients.irradiance, &other.coefficients.irradiance)
    };
    pairs.map(of_band).fold(0.0, f64::max)
}

/// Bound of ‖δh‖/‖h‖ by errors δG of blocks, the largest of any band; None where no block is a sum of a series.
///
/// ```text
/// h = G b + … ,  b = e + S h :     δh = (I − G S)⁻¹ δG b ,     ‖δh‖ ≤ ‖r‖/(1 − max (ρ + τ)) ,
/// r_i = Σ_j ε_ij ‖b_j‖
/// ```
///
/// as ‖G‖ ≤ 1. The remainder ε_ij of a series bounds the norm of δG_ij, by Bessel's inequality: Σ_kl
/// δG_kl² ≤ ∫∫ δκ² dA dA. What the rules miss is an estimate and counts like it, that of the series and what
/// a fresh block is allowed: the error reported is the difference from a fresh frame. Without shadows ‖G‖ may
/// exceed 1 by what bodies hide from each other.
fn series_error(remainders: &[Remainder], solution: &Solution) -> Option<f64> {
    let list = solution.elements().list();
    let bands = solution.bands().iter().map(|band| of_band(remainders, list, band));
    (!remainders.is_empty()).then(|| bands.fold(0.0, f64::max))
}

fn of_band(remainders: &[Remainder], list: &[Element], band: &Band) -> f64 {
    let sizes = sizes(list, band);
    let mut rest = vec![0.0; list.len()];
    for Remainder { places: [i, j], bound } in remainders {
        rest[*i] += bound * sizes[*j];
        rest[*j] += bound * sizes[*i];
    }
    carried(norm(&rest), band)
}

/// ‖r‖/((1 − max (ρ + τ)) ‖h‖) for the size of r.
fn carried(rest: f64, band: &Band) -> f64 {
    let Band { coating, coefficients, .. } = band;
    let most = (0..coating.reflectance.len()).map(|element| coating.most(element)).fold(0.0, f64::max);
    if rest == 0.0 { 0.0 } else { rest / ((1.0 - most) * norm(&coefficients.irradiance)) }
}

/// ‖b_j‖ of each element.
fn sizes(list: &[Element], band: &Band) -> Vec<f64> {
    let mut rest = &band.coefficients.radiosity[..];
    let size = |element: &Element| {
        let (own, others) = rest.split_at(element.basis.len());
        rest = others;
        norm(own)
    };
    list.iter().map(size).collect()
}
