//! Radiant heat: temperatures and net flows of grey diffuse surfaces.
//!
//! Of each surface the temperature T (K) is known, or the flux q (W m⁻²) that it is given and sends out. With
//! the emissivity ε, the radiosity J, the irradiance H and σ T⁴ (Modest, Radiative Heat Transfer, chapter 5),
//!
//! ```text
//! T known:   J = ε σ T⁴ + (1 − ε) H ,     q = J − H ;
//! q known:   J = q + H ,                  σ T⁴ = H + q / ε .
//! ```
//!
//! Both are rows of the one system b = e + ρ G b ([`radiosity_solve::system`]), with e = ε σ T⁴ and
//! ρ = 1 − ε, or e = q and ρ = 1: a surface of known flux reflects all, and its emissivity only enters its
//! temperature. The light of the second kind has no balance of its own, so some surface has to have a
//! temperature, or some heat has to leave the scene.
//!
//! A two-sided surface of known flux is a *shield*: both sides have one temperature, unknown and even over
//! the sheet. Its level σ T⁴ follows from the net flow of both sides together: the light of each shield is
//! solved for at the level 1, and the levels are those at which all flows are as given (`shields`).
//!
//! What leaves the scene goes to surroundings at 0 K. Conduction, convection and heat that is stored have no
//! part in it; where they are known, they are a `heat_flux`.
//!
//! In order: [`HeatError`], `black_body`, `backs` (which of them heat reaches), `roles` (what is known of
//! each surface), `coats` (scenes with the coatings of heat), `closure` (rows that sum to 1), `figures` (of each
//! surface), `levels`, `noise` (that rays leave in them), `field` (σ T⁴ over surfaces), `shields`,
//! `conductances`, `cut` (elements that tell the error), `forecast`, `case` (a scene, its roles and options),
//! `transfers` between its elements and the `finer` ones of a cut, [`Heat`], the balance, [`HeatModel`],
//! transfers that are kept for many of them, [`judging`], what a referee says of one, [`remarks`] on both,
//! `checking`, errors made true by that, and [`ToldHeat`], what files tell of a balance.
//!
//! Imports `core`, `geom`, `solvers`, `work`, `fit`, `scene`, `audit`, `visibility`, `elements`, `kernel` and `solve`.

mod error;
mod black_body;
mod backs;
mod roles;
mod coats;
mod closure;
mod figures;
mod levels;
mod noise;
mod field;
mod shields;
mod conductances;
mod cut;
mod forecast;
mod case;
mod transfers;
mod finer;
mod heat_model;
pub mod judging;
pub mod remarks;
mod checking;
mod told_heat;

use radiosity_audit::Checked;
use radiosity_scene::{Scene, SceneSurface};
use radiosity_solve::solution::Solution;
use radiosity_solve::{Options, Outcome};
use radiosity_work::{Stage, Work};

use backs::with_backs;
pub use black_body::{STEFAN_BOLTZMANN, kelvin};
use case::Case;
pub use conductances::Conductances;
use cut::Cut;
pub use error::HeatError;
pub use figures::SurfaceHeat;
use figures::{ErrorGrowth, add_errors, add_errors_of_blocks, add_errors_of_irradiance, difference, figures};
use finer::Finer;
pub use heat_model::HeatModel;
use noise::Noise;
use roles::named;
pub use told_heat::ToldHeat;
use transfers::Transfers;

/// Largest share of what surfaces exchange that may leave a scene that counts as closed, however large the errors are.
/// Chosen.
const CLOSED: f64 = 1e-3;

/// Errors of blocks over the difference of two balances whose blocks were made apart, at the most: near faces make them
/// alike. Measured between disks at a hundredth of their radius: 6.
const ALIKE: f64 = 10.0;

/// Rounding of the sum of flows over what surfaces exchange: 2⁻⁵² times some thousand terms.
const ROUNDING: f64 = 1e-12;

/// The balance of heat of a scene.
#[derive(Debug)]
pub struct Heat {
    /// The figures of each surface, in the order of the scene, and behind them those of backs of surfaces of one side
    /// that have a temperature, or that heat reaches.
    pub surfaces: Vec<SurfaceHeat>,
    /// Names of surfaces whose level nothing sets: all are adiabatic, and exchange heat with one another alone.
    pub without_level: Vec<String>,
    /// Flow (W) that leaves the scene, Σ Q; in a closed scene how well the balance closes.
    pub lost: f64,
    /// By how much sums of view factors missed 1 before they were made to be 1; None where the scene is not
    /// known to be closed.
    pub moved: Option<f64>,
    /// By how much the row sums of each surface were above 1 before they were bounded; none where they were not.
    excess: Vec<f64>,
    /// Whether all exchanges are exact.
    is_exact: bool,
    /// Whether elements that are cut once more told its errors; without memory or time for them these are those of
    /// the transfers alone.
    pub is_cut: bool,
    /// The error that a referee found, once it looked.
    pub checked: Option<Checked>,
    /// Conductances between all surfaces, if they were asked for.
    pub conductances: Option<Conductances>,
    /// Polynomials of irradiance and radiosity in the single band `heat`, with cost and self-checks.
    pub outcome: Outcome,
    /// The other side of each surface that is a side of a sheet.
    other_sides: Vec<Option<usize>>,
    /// Factors by which the check of a referee made the errors of each surface larger; none before.
    growth: Vec<ErrorGrowth>,
}

/// Options of a balance of heat.
#[derive(Clone, Copy, Debug)]
pub struct HeatOptions {
    /// Options of the radiosity. Direct light is always projected.
    pub options: Options,
    /// Whether the conductances between all surfaces are wanted: one solution for each surface.
    pub conductances: bool,
}

impl Default for HeatOptions {
    /// Order 3, every pair to 1e-4 with its shadows by rules, or by rays and of order 0 where rules would take long,
    /// the system to 1e-12; no conductances.
    fn default() -> Self {
        let options =
            Options { order: 3, eps: 1e-4, shadow_eps: 1e-4, tolerance: 1e-12, ..Options::default() };
        Self { options, conductances: false }
    }
}

impl Heat {
    /// Whether anything is known of the heat of `scene`: some surface has a temperature or a flux.
    pub fn is_known(scene: &Scene) -> bool {
        scene.surfaces.iter().any(|surface| surface.thermal.condition.is_some() && !surface.is_luminaire())
    }

    /// The temperatures and flows of `scene`, with errors from what a balance on elements that are cut once more finds.
    /// In closed scenes the transfers are made to close (`closure`). What the second balance takes is told as
    /// [`Stage::Comparison`].
    ///
    /// # Errors
    /// Surfaces without a temperature, a flux or an emissivity; parts of the scene whose level no temperature
    /// sets; more heat drawn than arrives; too little memory; what [`radiosity_solve::solve()`] refuses.
    pub fn of(scene: &Scene, wanted: &HeatOptions, work: &Work<'_>) -> Result<Self, HeatError> {
        let find = || work.during(Stage::Backs, || with_backs(scene));
        let scene = wanted.options.in_threads(work.ranks, find)?;
        let mut case = wanted.options.in_threads(work.ranks, || Case::of(scene, &wanted.options))??;
        let mut conductances = None;
        let (mut heat, cut) = {
            let mut transfers = Transfers::first(&case, wanted.conductances, work)?;
            let solve = || Self::balanced(&mut case, &mut transfers, work);
            let heat = work.during(Stage::Solve, solve)?;
            if wanted.conductances {
                conductances = Some(transfers.conductances(&case, work)?);
            }
            let cut = Cut::of(&case.roles, transfers.model(), &heat.outcome);
            (heat, cut.filter(|cut| case.forecast(work.ranks).fits(cut, 0)))
        };
        heat.conductances = conductances;
        let mut finer = cut.map(|cut| Finer::of(cut, &case, work)).transpose()?;
        heat.add_errors(finer.as_mut(), &case, work)?;
        Ok(heat)
    }

    /// The balance of a case by these transfers, without errors. Surfaces whose level nothing sets become idle.
    fn balanced(case: &mut Case, transfers: &mut Transfers, work: &Work<'_>) -> Result<Self, HeatError> {
        transfers.settle(case)?;
        let mut outcome = transfers.outcome(case, work)?;
        let Case { scene, roles, choice, .. } = case;
        outcome.choice = choice.clone();
        let surfaces = figures(scene, roles, &outcome.solution)?;
        // What rules or rays missed does not matter where sums tell it.
        outcome.worst_error = outcome.worst_error.filter(|_| !transfers.closure().is_exact);
        Ok(Self {
            lost: surfaces.iter().map(|surface| surface.flow).sum(),
            without_level: named(scene, |surface, _| !surfaces[surface].has_level()),
            surfaces,
            moved: transfers.closure().moved,
            excess: transfers.closure().excess.clone(),
            is_exact: transfers.closure().is_exact,
            is_cut: false,
            checked: None,
            conductances: None,
            outcome,
            other_sides: scene.surfaces.iter().map(|surface| surface.other_side).collect(),
            growth: Vec::new(),
        })
    }

    /// Adds the errors that elements of a cut tell, if there is one. Blocks err by no more than the accuracy that they
    /// have reached, and where they are made anew for all elements, by a few times what both balances differ by.
    fn add_errors(
        &mut self,
        finer: Option<&mut Finer>,
        case: &Case,
        work: &Work<'_>,
    ) -> Result<(), HeatError> {
        let tolerance = case.options.tolerance;
        // The noise of rays tells how far off pairs are.
        let of_pairs = if self.outcome.sampling.is_some() { 0.0 } else { self.outcome.accuracy_reached };
        let reached = case.options.eps.max(of_pairs);
        let reached = if self.is_exact { tolerance } else { reached };
        if let Some(noise) = Noise::of(&self.outcome) {
            noise.add_to(&mut self.surfaces);
        }
        for (own, excess) in self.surfaces.iter_mut().zip(&self.excess) {
            add_errors_of_irradiance(own, excess * own.irradiance.abs());
        }
        let finer = finer.and_then(|finer| Some((finer.factor(case, &self.outcome)?, finer)));
        let Some((factor, finer)) = finer else {
            add_errors_of_blocks(&mut self.surfaces, reached);
            return Ok(());
        };
        self.is_cut = true;
        let others = finer.figures(case, work)?;
        let least = match finer.is_whole() {
            true => reached.min(ALIKE * difference(&self.surfaces, &others)),
            false => reached,
        };
        add_errors(&mut self.surfaces, &others, factor, least.max(tolerance));
        Ok(())
    }

    /// Sum of the sizes of all flows (W).
    pub fn flows(&self) -> f64 {
        self.surfaces.iter().map(|own| own.flow.abs()).sum()
    }

    /// Whether no heat leaves the scene, as far as is known: the flows sum to 0 within their errors, and to less than a
    /// thousandth of what surfaces exchange.
    pub fn is_closed(&self) -> bool {
        let exchanged = |own: &SurfaceHeat| own.area * own.radiosity.max(own.irradiance);
        let exchanged = self.surfaces.iter().filter(|own| own.has_level()).map(exchanged).sum::<f64>();
        let errors = self.surfaces.iter().map(|own| own.flow_error).sum::<f64>();
        self.lost.abs() <= ROUNDING * exchanged + errors.min(CLOSED * exchanged)
    }

    /// Names of the surfaces of `scene`, of which this is the balance, whose backs heat reaches and are adiabatic
    /// because nothing else was said.
    pub fn usual_backs<'a>(&self, scene: &'a Scene) -> Vec<&'a str> {
        let is_told = |own: &SurfaceHeat| own.has_level();
        let has_back = self.other_sides.iter().map(|back| back.filter(|back| is_told(&self.surfaces[*back])));
        let has_back = has_back.zip(&scene.surfaces);
        let is_usual =
            |surface: &SceneSurface| surface.other_side.is_none() && surface.thermal.back.is_none();
        let usual = has_back.filter(|(back, surface)| back.is_some() && is_usual(surface));
        usual.map(|(_, surface)| surface.name.as_str()).collect()
    }

    /// σ T⁴ (W m⁻²) at all places, as the radiosity of a solution over the same elements: what a black
    /// surface of the temperature there would emit. It varies over surfaces of known flux.
    pub fn levels(&self) -> Solution {
        field::levels(&self.outcome.solution, &self.surfaces)
    }
}
