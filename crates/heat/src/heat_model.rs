//! Transfers that are kept: balances of scenes that differ in their temperatures, fluxes and emissivities alone.
//!
//! The transfers are those of the first scene. Where rules carry them they do not depend on its heat; elements are cut
//! once more where the first balance varies, and what the cut leaves out is told by the variation of each.

use std::sync::Arc;

use radiosity_scene::Scene;
use radiosity_solve::{Failure, Options};
use radiosity_work::{Stage, Work};

use super::Heat;
use super::backs::reached_backs;
use super::case::Case;
use super::cut::Cut;
use super::error::HeatError;
use super::finer::Finer;
use super::transfers::Transfers;

/// The transfers of a scene, found once for any temperatures, fluxes and emissivities.
#[derive(Debug)]
pub struct HeatModel {
    /// The first scene, with its backs.
    scene: Scene,
    /// The surfaces that have these.
    fronts: Vec<usize>,
    options: Options,
    transfers: Transfers,
    finer: Option<Finer>,
}

impl HeatModel {
    /// The transfers of `scene`, and its balance.
    ///
    /// # Errors
    /// As [`Heat::of`].
    pub fn of(scene: &Scene, options: &Options, work: &Work<'_>) -> Result<(Self, Heat), HeatError> {
        let find = || work.during(Stage::Backs, || reached_backs(scene));
        let fronts = options.in_threads(work.ranks, find)?;
        let mut case = options.in_threads(work.ranks, || Case::of(scene.with_backs(&fronts), options))??;
        let mut transfers = Transfers::first(&case, false, work)?.for_many();
        let solve = || Heat::balanced(&mut case, &mut transfers, work);
        let mut heat = work.during(Stage::Solve, solve)?;
        let forecast = case.forecast(work.ranks);
        let cut = Cut::of(&case.roles, transfers.model(), &heat.outcome);
        let cut = cut.filter(|cut| forecast.fits(cut, forecast.of_first()));
        let mut finer = cut.map(|cut| Finer::of(cut, &case, work)).transpose()?.map(Finer::for_many);
        heat.add_errors(finer.as_mut(), &case, work)?;
        let Options { transport, rays, order, .. } = case.options;
        let options = Options { transport, rays, order, ..*options };
        Ok((Self { scene: case.scene, fronts, options, transfers, finer }, heat))
    }

    /// The balance of a scene of the surfaces of the first one, such as [`Scene::with_heat`] makes it.
    ///
    /// # Errors
    /// As [`Heat::of`]; [`Failure::OtherSurface`] for a scene of other surfaces.
    pub fn balance(&mut self, scene: &Scene, work: &Work<'_>) -> Result<Heat, HeatError> {
        work.during(Stage::Solve, || {
            let mut case = Case::of(self.with_own_backs(scene)?, &self.options)?;
            let mut heat = Heat::balanced(&mut case, &mut self.transfers, work)?;
            heat.add_errors(self.finer.as_mut(), &case, work)?;
            Ok(heat)
        })
    }

    /// A scene with backs of the shapes of the first one.
    fn with_own_backs(&self, scene: &Scene) -> Result<Scene, Failure> {
        let fronts = scene.surfaces.len();
        if fronts + self.fronts.len() != self.scene.surfaces.len() {
            let surface = scene.surfaces.last().map(|own| own.name.clone()).unwrap_or_default();
            return Err(Failure::OtherSurface { surface });
        }
        let mut scene = scene.with_backs(&self.fronts);
        let backs = scene.surfaces[fronts..].iter_mut().zip(&self.scene.surfaces[fronts..]);
        backs.for_each(|(own, first)| own.shape = Arc::clone(&first.shape));
        Ok(scene)
    }
}
