//! The light of all bands: solved for, or summed over the first reflections.

use std::ops::Range;

use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_kernel::Blocks;
use radiosity_light::first_bounce::DirectLightEntry;
use radiosity_published::bases::Subspace;
use radiosity_solvers::Step;
use radiosity_solvers::method::Method;
use radiosity_work::{Progress, Work};

use crate::system::known_light::KnownLight;
use crate::system::ritz::{Ritz, RitzSolution};
use crate::system::{Coefficients, System};

use super::beside_known::BesideKnown;
use super::emission::Emission;
use super::failure::Failure;
use super::first_light::EnteringLight;
use super::options::Options;
use super::outcome::Functional;
use super::shooting::ShotLight;
use super::shots::Shots;
use super::solve_band::{SolveCost, SystemsOfBand, solve_band};
use super::unknowns::Unknowns;

/// The data from which the light of all bands follows.
#[derive(Clone, Copy, Debug)]
pub(super) struct BandSystems<'a> {
    pub names: &'a [String],
    pub elements: &'a [Element],
    pub blocks: &'a Blocks,
    /// Span of the functions of the basis; None where they are those of the elements.
    pub subspace: Option<&'a Subspace>,
    pub options: &'a Options,
}

/// The light of all bands.
pub(super) struct SolvedLight {
    /// Coefficients of the light of each emission, band by band.
    pub light: Vec<Vec<Coefficients>>,
    /// Coefficients of the light with one reflection less, where the number of reflections is limited to more
    /// than none.
    pub before: Option<Vec<Vec<Coefficients>>>,
    /// Unknowns of the systems; none where none were solved.
    pub unknowns: Unknowns,
    pub costs: Vec<SolveCost>,
    pub functionals: Vec<Functional>,
    /// Shots, where light was shot.
    pub shots: Option<Shots>,
}

impl SolvedLight {
    /// The light that was shot, with its coefficients.
    pub(super) fn shot(light: Vec<Vec<Coefficients>>, shot: ShotLight) -> Self {
        let unknowns = shot.unknowns();
        let ShotLight { costs, shots, .. } = shot;
        Self { light, before: None, unknowns, costs, functionals: Vec::new(), shots: Some(shots) }
    }
}

impl BandSystems<'_> {
    /// All light of each emission, found from the unknowns of a similar scene where some are given.
    ///
    /// # Errors
    /// A linear solver that fails or does not converge.
    pub(super) fn solved(
        &self,
        emissions: &[Emission],
        first: &[EnteringLight],
        before: &Unknowns,
        work: &Work<'_>,
    ) -> Result<SolvedLight, Failure> {
        let mut light: Vec<Vec<Coefficients>> = emissions.iter().map(|_| Vec::new()).collect();
        let (mut costs, mut functionals, mut unknowns) = (Vec::new(), Vec::new(), Vec::new());
        for (band, name) in self.names.iter().enumerate() {
            let of = |range: Range<usize>| self.systems(band, &emissions[range.clone()], &first[range]);
            let systems = SystemsOfBand { count: emissions.len(), of: &of };
            let mut observe = |step: &Step<'_>| self.tell(band, step, work);
            let mut lit = light.iter_mut().zip(emissions);
            let mut take = |RitzSolution { coefficients, functional }: RitzSolution| {
                let Some((light, emission)) = lit.next() else { return };
                light.push(coefficients);
                functionals.extend(self.functional(band, emission, functional));
            };
            let before = before.band(band);
            let solved = solve_band(&systems, self.options, before, work, &mut observe, &mut take)
                .map_err(|source| Failure::Solver { band: name.clone(), source })?;
            costs.extend(solved.cost);
            unknowns.push(solved.unknowns);
        }
        let unknowns = Unknowns::of(unknowns);
        Ok(SolvedLight { light, before: None, unknowns, costs, functionals, shots: None })
    }

    /// All light of each emission, where G carries all of it between functions of the elements: that which is `known`
    /// to the tolerance of the solver, and what is solved for from the nearest to it, which is known from then on.
    ///
    /// # Errors
    /// As [`BandSystems::solved`].
    pub(super) fn solved_beside(
        &self,
        emissions: &[Emission],
        known: &mut KnownLight,
        work: &Work<'_>,
    ) -> Result<SolvedLight, Failure> {
        let mut light: Vec<Vec<Coefficients>> = emissions.iter().map(|_| Vec::new()).collect();
        let (mut costs, mut functionals) = (Vec::new(), Vec::new());
        for (band, name) in self.names.iter().enumerate() {
            let coatings: Vec<&Coating> = emissions.iter().map(|own| &own.coatings[band]).collect();
            let mut observe = |step: &Step<'_>| self.tell(band, step, work);
            let (elements, blocks) = (self.elements, self.blocks);
            let (found, cost) = BesideKnown::of(elements, blocks, &coatings, known, self.options.tolerance)
                .found(known, self.options, work, &mut observe)
                .map_err(|source| Failure::Solver { band: name.clone(), source })?;
            costs.extend(cost);
            for ((light, emission), RitzSolution { coefficients, functional }) in
                light.iter_mut().zip(emissions).zip(found)
            {
                light.push(coefficients);
                functionals.extend(self.functional(band, emission, functional));
            }
        }
        let unknowns = Unknowns::default();
        Ok(SolvedLight { light, before: None, unknowns, costs, functionals, shots: None })
    }

    /// The value of the functional in a band of an emission, where the solution is its minimum.
    fn functional(&self, band: usize, emission: &Emission, value: f64) -> Option<Functional> {
        let is_symmetric = self.blocks.symmetric() && !emission.coatings[band].transmits();
        let (band, group) = (self.names[band].clone(), emission.group.clone());
        is_symmetric.then_some(Functional { band, group, value })
    }

    /// Tells of an iteration for a band.
    fn tell(&self, band: usize, step: &Step<'_>, work: &Work<'_>) {
        let Step { iteration, residual, .. } = *step;
        work.report(Progress::Iteration { band, of: self.names.len(), iteration, residual });
    }

    /// The light of each emission that was reflected so many times at the most.
    pub(super) fn bounced(
        &self,
        emissions: &[Emission],
        first: &[EnteringLight],
        bounces: usize,
    ) -> SolvedLight {
        let dark = || emissions.iter().map(|_| Vec::new()).collect::<Vec<Vec<Coefficients>>>();
        let (mut light, mut before) = (dark(), (bounces > 0).then(dark));
        for band in 0..self.names.len() {
            for (k, system) in self.systems(band, emissions, first).iter().enumerate() {
                let bounced = system.bounced(bounces);
                light[k].push(bounced.coefficients);
                before.iter_mut().for_each(|own| own[k].extend(bounced.before.clone()));
            }
        }
        let solver = Method::RICHARDSON.name;
        let costs = vec![SolveCost { solver, iterations: bounces, converged: true }];
        SolvedLight {
            light,
            before,
            unknowns: Unknowns::default(),
            costs,
            functionals: Vec::new(),
            shots: None,
        }
    }

    /// The systems of a band, one for each emission.
    fn systems<'a>(
        &'a self,
        band: usize,
        emissions: &'a [Emission],
        first: &[EnteringLight],
    ) -> Vec<Ritz<'a>> {
        let entered = emissions.iter().zip(first).map(|(own, first)| (&own.coatings[band], &first.entry));
        let entered: Vec<(&Coating, &DirectLightEntry)> = entered.collect();
        let systems = System::entered(self.elements, self.blocks, band, &entered);
        systems.into_iter().map(|system| Ritz::new(system, self.subspace)).collect()
    }
}
