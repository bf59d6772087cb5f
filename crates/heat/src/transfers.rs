//! The transfers between the elements of a scene, which serve any temperatures, fluxes and emissivities.
//!
//! They follow from the geometry and the accuracy alone; only rays are spread by what surfaces reflect.

use std::sync::OnceLock;

use radiosity_elements::mesh::Mesh;
use radiosity_solve::solution::Solution;
use radiosity_solve::{KnownLight, Model, Options, Outcome};
use radiosity_work::{Stage, Work};

use super::case::Case;
use super::closure::{Closure, close};
use super::coats::{all_emit, radiant};
use super::conductances::Conductances;
use super::error::HeatError;
use super::levels::Exchange;
use super::shields;

/// The transfers of a scene, with rows that close where it is closed.
#[derive(Debug)]
pub(super) struct Transfers {
    model: Model,
    closure: Closure,
    exchange: OnceLock<Exchange>,
    /// Light of cases, from which that of others follows; None where there are no others.
    known: Option<KnownLight>,
}

impl Transfers {
    /// The transfers between the elements of a case.
    ///
    /// # Errors
    /// Too little memory, also for conductances where these are wanted; what the model refuses.
    pub(super) fn first(case: &Case, has_conductances: bool, work: &Work<'_>) -> Result<Self, HeatError> {
        if has_conductances {
            case.forecast(work.ranks).require_conductances()?;
        }
        let Case { scene, roles, options, .. } = case;
        Self::closed(Model::assemble(&all_emit(scene, roles), options, work)?, case, options, work)
    }

    /// The transfers between the elements of a mesh.
    ///
    /// # Errors
    /// As [`Transfers::first`].
    pub(super) fn on(
        mesh: &Mesh,
        case: &Case,
        options: &Options,
        work: &Work<'_>,
    ) -> Result<Self, HeatError> {
        let model = Model::assemble_on(mesh, &all_emit(&case.scene, &case.roles), options, work)?;
        Self::closed(model, case, options, work)
    }

    fn closed(model: Model, case: &Case, options: &Options, work: &Work<'_>) -> Result<Self, HeatError> {
        let model = model.without_spectral_bound();
        let make = || work.during(Stage::Closure, || close(&case.scene, model, options));
        let (model, closure) = options.in_threads(work.ranks, make)?;
        Ok(Self { model, closure, exchange: OnceLock::new(), known: None })
    }

    /// These, for one case after another.
    pub(super) fn for_many(self) -> Self {
        Self { known: Some(KnownLight::default()), ..self }
    }

    /// The elements and their blocks.
    pub(super) fn model(&self) -> &Model {
        &self.model
    }

    /// How well the rows close.
    pub(super) fn closure(&self) -> &Closure {
        &self.closure
    }

    /// Makes surfaces of a case idle whose level nothing sets ([`Exchange::settle`]).
    pub(super) fn settle(&self, case: &mut Case) -> Result<(), HeatError> {
        let exchange = self.exchange.get_or_init(|| Exchange::of(&self.model));
        exchange.settle(&case.scene, &mut case.roles, &case.options)
    }

    /// The light of a case of these surfaces with its self-checks, its shields at their levels.
    ///
    /// # Errors
    /// What the solver refuses.
    pub(super) fn outcome(&mut self, case: &Case, work: &Work<'_>) -> Result<Outcome, HeatError> {
        let Case { scene, roles, options, .. } = case;
        self.model.set_tolerance(options.tolerance);
        let radiant = radiant(scene, roles);
        let outcome = match &mut self.known {
            Some(known) => self.model.solve_beside(&radiant, known, work)?,
            None => self.model.solve(&radiant, work)?,
        };
        Ok(match shields::lit(radiant, roles, &outcome.solution) {
            Some(lit) => outcome.relight(&lit).expect("each shield is a group"),
            None => outcome,
        })
    }

    /// The light of a case as [`Transfers::outcome`] finds it.
    ///
    /// # Errors
    /// What the solver refuses.
    pub(super) fn light(&mut self, case: &Case, work: &Work<'_>) -> Result<Solution, HeatError> {
        let Case { scene, roles, options, .. } = case;
        self.model.set_tolerance(options.tolerance);
        let radiant = radiant(scene, roles);
        let solution = self.model.light_of(&radiant, self.known.as_mut(), work)?;
        Ok(match shields::lit(radiant, roles, &solution) {
            Some(lit) => solution.relight(&lit).expect("each shield is a group"),
            None => solution,
        })
    }

    /// The conductances between the surfaces of a case.
    ///
    /// # Errors
    /// Surfaces without an emissivity; what the solver refuses.
    pub(super) fn conductances(&self, case: &Case, work: &Work<'_>) -> Result<Conductances, HeatError> {
        let find = || Conductances::of(&case.scene, &case.roles, &self.model, work);
        let found = || work.during(Stage::Solve, find);
        case.options.in_threads(work.ranks, found)?
    }
}
