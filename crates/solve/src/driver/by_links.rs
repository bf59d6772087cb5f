//! Hierarchical radiosity as a run: refined by the light of the whole scene, then solved for each light
//! group.

use std::sync::Arc;

use radiosity_elements::Elements;
use radiosity_elements::coating::Coating;
use radiosity_kernel::PairCounts;
use radiosity_light::first_bounce::DirectLightEntry;
use radiosity_light::point_lights::PointLights;
use radiosity_published::hierarchy::{
    BandSystem, Hierarchy, HierarchyOptions, LinkedElements, leaf_elements, solve_hierarchically,
};
use radiosity_scene::Scene;
use radiosity_solvers::Settings;
use radiosity_solvers::method::{Access, Method};
use radiosity_work::ranks::Ranks;
use radiosity_work::{Stage, Work};

use super::emission::Emission;
use super::failure::Failure;
use super::linking::Linking;
use super::options::Options;
use super::outcome::{Outcome, Stages, timed};
use super::solve_band::SolveCost;
use super::transport_choice::TransportChoice;
use crate::checks::{Balance, Checks, largest_bound};
use crate::solution::Solution;
use crate::solution::group_light::GroupLight;
use crate::system::Coefficients;

/// The greatest power of a link at which clusters are linked from 1½ sums of their radii on, and how this
/// distance grows with smaller powers. Chosen: the error of clusters falls with it, and not with the power.
const USUAL: f64 = 1e-3;
const FARTHER: f64 = 0.3;

/// Solves `scene` by links.
///
/// # Errors
/// As for [`super::solve`].
pub(super) fn solve_by_links(scene: &Scene, options: &Options, work: &Work<'_>) -> Result<Outcome, Failure> {
    options.in_threads(work.ranks, || by_links(scene, options, work))?
}

fn by_links(scene: &Scene, options: &Options, work: &Work<'_>) -> Result<Outcome, Failure> {
    let (mut seconds, how) = (Stages::default(), linking(options));
    let link = || work.during(Stage::Blocks, || solve_hierarchically(scene, &how, work.observer));
    let found = timed(&mut seconds.blocks, link)?;
    let hierarchy = found.hierarchy();
    let cut = || work.during(Stage::Elements, || leaf_elements(scene, hierarchy));
    let elements = Arc::new(timed(&mut seconds.elements, cut)?);
    let links = LinkedElements::new(hierarchy, &elements);
    let (solver, ranks) = (how.solver, work.ranks);
    let run = Run { scene, options, solver, hierarchy, links: &links, elements: &elements, ranks };
    let (groups, costs) = timed(&mut seconds.solve, || work.during(Stage::Solve, || run.groups()))?;
    let solution = Solution::of_groups(Arc::clone(&elements), scene, groups);
    let powers = solution.powers().unwrap_or_default();
    let bound = || largest_bound(&solution, &links, work.ranks);
    let check = || Checks::with_powers(&solution, &links, powers, bound());
    let checks = work.during(Stage::Checks, check);
    let slowest = costs.into_iter().max_by_key(|effort| effort.iterations);
    let (solver, iterations) =
        slowest.map_or((how.solver.name, 0), |effort| (effort.solver, effort.iterations));
    let counts = found.counts();
    Ok(Outcome {
        residual: solution.bands().iter().map(|band| band.coefficients.residual).fold(0.0, f64::max),
        checks,
        solution,
        pairs: PairCounts::default(),
        samples: counts.links as u64,
        distinct: counts.links as u64,
        rays: (counts.links * how.rays_per_link) as u64,
        unknowns: elements.coefficients(),
        functionals: Vec::new(),
        accuracy_reached: 0.0,
        worst_error: None,
        solver,
        iterations,
        split: false,
        converged: true,
        choice: TransportChoice { sampled: false, why: "hierarchical radiosity was asked for".to_owned() },
        sampling: None,
        links: Some(counts),
        shots: None,
        seconds,
    })
}

/// Options of hierarchical radiosity that follow from these.
fn linking(options: &Options) -> HierarchyOptions {
    let usual = HierarchyOptions::default();
    let solver = if options.solver.access == Access::BySize { usual.solver } else { options.solver };
    let farther = (USUAL / options.eps).max(1.0).powf(FARTHER);
    let Linking { measure, least_area, rays_per_link } = options.linking;
    HierarchyOptions {
        measure,
        eps: options.eps,
        least_area,
        rays_per_link,
        separation: usual.separation * farther,
        solver,
        tolerance: options.tolerance,
        ..usual
    }
}

/// A linked scene that is solved.
struct Run<'a> {
    scene: &'a Scene,
    options: &'a Options,
    solver: &'static Method,
    hierarchy: &'a Hierarchy,
    links: &'a LinkedElements<'a>,
    elements: &'a Elements,
    ranks: &'a Ranks,
}

impl Run<'_> {
    /// The light of each group, with the cost of each of its bands.
    fn groups(&self) -> Result<(Vec<GroupLight>, Vec<SolveCost>), Failure> {
        let balance = Balance::of(self.elements, self.links);
        let (mut groups, mut costs) = (Vec::new(), Vec::new());
        for emission in Emission::all(self.scene, self.elements.list()) {
            let mut light = Vec::with_capacity(emission.coatings.len());
            for (band, coating) in emission.coatings.iter().enumerate() {
                let (coefficients, cost) = self.band(band, coating)?;
                light.push(coefficients);
                costs.push(cost);
            }
            // Links carry the light of surfaces alone.
            let of_surfaces = Emission { points: PointLights::default(), ..emission };
            groups.push(of_surfaces.lit(&balance, &DirectLightEntry::Carried, light, None));
        }
        Ok((groups, costs))
    }

    /// The light of one band.
    fn band(&self, band: usize, coating: &Coating) -> Result<(Coefficients, SolveCost), Failure> {
        let surfaces = self.scene.surfaces.len();
        let (mut reflectance, mut exitance) = (vec![0.0; surfaces], vec![0.0; surfaces]);
        for (index, element) in self.elements.list().iter().enumerate() {
            reflectance[element.surface] = coating.reflectance[index];
            exitance[element.surface] = coating.exitance[index];
        }
        let system = BandSystem::new(self.hierarchy, &reflectance, &exitance);
        let settings = Settings::default()
            .with_tolerance(self.options.tolerance)
            .with_max_iterations(self.options.max_iterations)
            .with_threads(self.ranks.threads(self.options.threads));
        let settings = self.options.relaxing.set(settings);
        let solved = system.solve(self.solver, &settings);
        let failed = |source| Failure::Solver { band: self.scene.bands[band].clone(), source };
        let (radiosity, report) = solved.map_err(failed)?;
        let carried = |radiosity: &[f64]| self.links.irradiance(&self.hierarchy.exchange(radiosity));
        let (irradiance, direct) = (carried(&radiosity), carried(system.exitance()));
        let residual = system.residual(&radiosity);
        let list = self.elements.list();
        let coefficients = Coefficients::of_irradiance(list, coating, irradiance, direct, residual);
        let (solver, iterations) = (report.method, report.iterations);
        Ok((coefficients, SolveCost { solver, iterations, converged: true }))
    }
}
