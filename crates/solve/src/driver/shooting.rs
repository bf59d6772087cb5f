//! The light of all bands, shot: progressive refinement.

use std::time::{Duration, Instant};

use radiosity_core::dot;
use radiosity_elements::Element;
use radiosity_kernel::Blocks;
use radiosity_kernel::block_columns::BlockColumns;
use radiosity_solvers::{Report, Settings, SolveError, Step, Stop};
use radiosity_work::interruption::{self, Interruption, check_interrupt};
use radiosity_work::{Progress, Work};

use crate::system::Coefficients;
use crate::system::shooting::Shooting;

use super::emission::Emission;
use super::failure::Failure;
use super::first_light::EnteringLight;
use super::options::Options;
use super::shots::{Shot, Shots};
use super::solve_band::{LEAST, SolveCost};
use super::unknowns::Unknowns;

/// The data from which light is shot.
#[derive(Clone, Copy)]
pub(super) struct Shooter<'a> {
    pub names: &'a [String],
    pub elements: &'a [Element],
    pub emissions: &'a [Emission],
    pub first: &'a [EnteringLight],
    pub options: &'a Options,
}

/// Radiosity that was shot.
pub(super) struct ShotLight {
    /// The radiosity of each emission, band by band, on the elements that send light.
    radiosity: Vec<Vec<Vec<f64>>>,
    pub costs: Vec<SolveCost>,
    pub shots: Shots,
}

impl ShotLight {
    /// The radiosity, of which the next shots may start.
    pub(super) fn unknowns(&self) -> Unknowns {
        let bands = 0..self.radiosity.first().map_or(0, Vec::len);
        Unknowns::of(bands.map(|band| self.radiosity.iter().map(|own| own[band].clone()).collect()).collect())
    }
}

/// Shots in one band and of one emission.
struct Course {
    radiosity: Vec<f64>,
    cost: Option<SolveCost>,
    history: Vec<Shot>,
}

/// Columns of G, and the time that they had taken before the first shot.
#[derive(Clone, Copy)]
pub(super) struct ColumnSource<'a> {
    pub columns: &'a dyn BlockColumns,
    pub before: Duration,
    /// Why all columns were integrated before, if they were.
    pub all_first: Option<&'a str>,
}

impl Shooter<'_> {
    /// Shoots the light of each emission in all bands, from the radiosity `before`, where that of a similar
    /// scene is given.
    ///
    /// # Errors
    /// A solver that does not converge.
    pub(super) fn shot(
        &self,
        source: ColumnSource<'_>,
        before: &Unknowns,
        work: &Work<'_>,
    ) -> Result<ShotLight, Failure> {
        let begun = Instant::now();
        let mut radiosity: Vec<Vec<Vec<f64>>> = self.emissions.iter().map(|_| Vec::new()).collect();
        let (mut costs, mut history, mut unshot) = (Vec::new(), Vec::new(), 0.0f64);
        for (band, name) in self.names.iter().enumerate() {
            for (emission, own) in radiosity.iter_mut().enumerate() {
                let known = before.band(band).and_then(|known| known.get(emission));
                let failed = |source| Failure::Solver { band: name.clone(), source };
                let course = self.course(band, emission, source, known, begun, work).map_err(failed)?;
                own.push(course.radiosity);
                costs.extend(course.cost);
                unshot = unshot.max(course.history.last().map_or(0.0, |last| last.unshot));
                if course.history.len() > history.len() {
                    history = course.history;
                }
            }
        }
        let shots = Shots {
            count: history.len().saturating_sub(1),
            columns: source.columns.integrated(),
            of: self.elements.len(),
            all_first: source.all_first.map(str::to_owned),
            unshot,
            history,
        };
        Ok(ShotLight { radiosity, costs, shots })
    }

    /// The coefficients of the light of each emission, band by band; `blocks` hold all columns that were
    /// shot.
    pub(super) fn light(&self, shot: &ShotLight, blocks: &Blocks) -> Vec<Vec<Coefficients>> {
        let light = |(emission, bands): (usize, &Vec<Vec<f64>>)| {
            let found = |(band, own): (usize, &Vec<f64>)| self.system(band, emission).found(own, blocks);
            bands.iter().enumerate().map(found).collect()
        };
        shot.radiosity.iter().enumerate().map(light).collect()
    }

    fn system(&self, band: usize, emission: usize) -> Shooting<'_> {
        let coating = &self.emissions[emission].coatings[band];
        Shooting::entered(self.elements, band, coating, &self.first[emission].entry)
    }

    /// The shots of an emission in a band.
    fn course(
        &self,
        band: usize,
        emission: usize,
        source: ColumnSource<'_>,
        before: Option<&Vec<f64>>,
        begun: Instant,
        work: &Work<'_>,
    ) -> Result<Course, SolveError> {
        let system = self.system(band, emission);
        let right = system.right_hand_side();
        let before = before.filter(|before| before.len() == right.len());
        let mut radiosity = before.map_or_else(|| vec![0.0; right.len()], Vec::clone);
        if right.iter().all(|value| *value == 0.0) {
            radiosity.fill(0.0);
            return Ok(Course { radiosity, cost: None, history: Vec::new() });
        }
        let (measure, ones) = (system.measure(), system.constant());
        let all = dot(&ones, &right);
        let mut history = Vec::new();
        let mut observe = |step: &Step<'_>| {
            check_interrupt();
            let Step { iteration, residual, unshot, .. } = *step;
            work.report(Progress::Iteration { band, of: self.names.len(), iteration, residual });
            history.push(Shot {
                unshot: unshot.map_or(0.0, |unshot| dot(&ones, unshot) / all),
                columns: source.columns.integrated(),
                seconds: (source.before + begun.elapsed()).as_secs_f64(),
            });
        };
        let interruption = interruption::current();
        let settings = self.settings(work).with_cancel(interruption.as_ref().map(Interruption::flag));
        let matrix = system.matrix(source.columns);
        let solver = self.options.solver.solver;
        let ended =
            solver.solve(&matrix, &right, &mut radiosity, &settings.with_measure(&measure), &mut observe);
        // Where it was cancelled.
        check_interrupt();
        let cost = self.cost(ended)?;
        Ok(Course { radiosity, cost: Some(cost), history })
    }

    fn settings(&self, work: &Work<'_>) -> Settings<'static> {
        let settings = Settings::default()
            .with_tolerance(self.options.tolerance)
            .with_max_iterations(self.options.max_iterations)
            .with_shots(self.options.shots.map(|shots| shots.count))
            .with_time_budget(work.left().map(|left| left.max(LEAST)));
        self.options.relaxing.set(settings)
    }

    /// The cost of shots that ended as was asked.
    fn cost(&self, ended: Result<Report, SolveError>) -> Result<SolveCost, SolveError> {
        match ended {
            Ok(Report { method: solver, iterations, .. }) => {
                Ok(SolveCost { solver, iterations, converged: true })
            }
            Err(SolveError::NotConverged { method: solver, iterations, residual, stop, .. })
                if stop == Stop::Shots || (self.options.keep_partial && residual.is_finite()) =>
            {
                Ok(SolveCost { solver, iterations, converged: false })
            }
            Err(error) => Err(error),
        }
    }
}
