//! The linear systems of one band: one matrix, a right-hand side for each light group.

use std::ops::Range;
use std::time::Duration;

use radiosity_solvers::method::Access;
use radiosity_solvers::{Report, Settings, SolveError, Step};
use radiosity_work::interruption::{self, Interruption, check_interrupt};
use radiosity_work::{Deadline, Work};

use crate::system::ritz::{Ritz, RitzSolution};

use super::options::Options;
use super::unknowns::has_sizes_of;

/// Least time of a linear system, after a deadline too, so that a small scene has a result. Chosen: a person
/// waits as long without noticing.
pub(super) const LEAST: Duration = Duration::from_secs(1);

/// Systems that are held at a time: enough to fill the bundles in which they pass the blocks. Chosen: each takes four
/// vectors.
const AT_A_TIME: usize = 64;

/// The systems of one band, which differ in their emission alone, made when they are wanted.
pub(super) struct SystemsOfBand<'s, 'a> {
    pub count: usize,
    /// The systems of a range of numbers.
    pub of: &'s dyn Fn(Range<usize>) -> Vec<Ritz<'a>>,
}

/// Systems of which the first ones are made, all of them where they are few.
struct Made<'m, 's, 'a> {
    systems: &'m SystemsOfBand<'s, 'a>,
    some: Vec<Ritz<'a>>,
}

impl<'m, 's, 'a> Made<'m, 's, 'a> {
    fn of(systems: &'m SystemsOfBand<'s, 'a>) -> Self {
        Self { systems, some: (systems.of)(0..systems.count.min(AT_A_TIME)) }
    }

    /// Passes the systems on, some after the others, with their numbers; those beyond the first are made anew.
    fn each(&self, visit: &mut dyn FnMut(Range<usize>, &[Ritz<'a>])) {
        visit(0..self.some.len(), &self.some);
        let count = self.systems.count;
        for start in (self.some.len()..count).step_by(AT_A_TIME) {
            let range = start..count.min(start + AT_A_TIME);
            visit(range.clone(), &(self.systems.of)(range));
        }
    }
}

/// The cost of a band's linear system.
pub(super) struct SolveCost {
    pub solver: &'static str,
    pub iterations: usize,
    pub converged: bool,
}

/// The solutions of the systems of a band.
pub(super) struct SolvedBand {
    /// The unknowns of each system.
    pub unknowns: Vec<Vec<f64>>,
    /// None where nothing shines.
    pub cost: Option<SolveCost>,
}

/// The cost of a finished solver; with `keep_partial` the best iterate of one that did not converge counts
/// too, if it has one: a factorisation that ran out of time has none.
fn cost_of(
    ended: Result<Vec<Report>, SolveError>,
    keep_partial: bool,
) -> Result<Option<SolveCost>, SolveError> {
    match ended {
        Ok(reports) => Ok(reports.into_iter().max_by_key(|report| report.iterations).map(
            |Report { method: solver, iterations, .. }| SolveCost { solver, iterations, converged: true },
        )),
        Err(SolveError::NotConverged { method: solver, iterations, residual, .. })
            if keep_partial && residual.is_finite() =>
        {
            Ok(Some(SolveCost { solver, iterations, converged: false }))
        }
        Err(error) => Err(error),
    }
}

/// Solves the systems of one band, and passes their solutions on one after the other. Without light there is nothing to
/// solve, and no cost. Several ranks, whose clocks differ, go on to the end.
///
/// Iterations start from the unknowns `before` of each system, those of a similar scene: what is then solved
/// for is the difference, and a solver that is left open multiplies.
///
/// # Errors
/// Those of the solver.
pub(super) fn solve_band(
    systems: &SystemsOfBand<'_, '_>,
    options: &Options,
    before: Option<&[Vec<f64>]>,
    work: &Work<'_>,
    observe: &mut dyn FnMut(&Step<'_>),
    take: &mut dyn FnMut(RitzSolution),
) -> Result<SolvedBand, SolveError> {
    let made = Made::of(systems);
    let mut rights: Vec<Vec<f64>> = Vec::with_capacity(systems.count);
    made.each(&mut |_, some| rights.extend(some.iter().map(Ritz::right_hand_side)));
    let before = before.filter(|before| has_sizes_of(before, &rights));
    let is_lit = |right: &[f64]| right.iter().any(|value| *value != 0.0);
    let are_lit: Vec<bool> = rights.iter().map(|right| is_lit(right)).collect();
    let lit_count = are_lit.iter().filter(|own| **own).count();
    let dim = rights.first().map_or(0, Vec::len);
    let mut unknowns = match before {
        None => vec![0.0; lit_count * dim],
        Some(before) => {
            let known = before.iter().zip(&rights).filter(|(_, right)| is_lit(right));
            known.flat_map(|(own, _)| own).copied().collect()
        }
    };
    let mut lit = Vec::with_capacity(unknowns.len());
    rights.into_iter().filter(|right| is_lit(right)).for_each(|right| lit.extend(right));
    let mut cost = None;
    if !lit.is_empty() {
        let first = &made.some[0];
        let threads = work.ranks.threads(options.threads);
        // Where iterations have a start few suffice, and where time is limited they have their best so far.
        let iterates = before.is_some() || work.deadline.is_some_and(Deadline::has_instant);
        let asked = match options.solver.access {
            Access::BySize if iterates => first.multiplying(),
            _ => options.solver,
        };
        let (operator, preconditioner) = match before {
            Some(_) if asked.only_multiplies() => first.product(options.preconditioner.into(), threads)?,
            // Where iterations have a start, few products suffice.
            Some(_) => first.operator(asked, options.preconditioner.into(), 1, threads)?,
            None => first.operator(asked, options.preconditioner.into(), lit_count, threads)?,
        };
        let solver = first.solver(asked, operator.symmetric());
        // Only shooting needs it, and it costs as much as a basis.
        let measure = (solver.access == Access::Columns).then(|| first.shooting_measure());
        let interruption = interruption::current();
        let mut settings = Settings::default()
            .with_tolerance(options.tolerance)
            .with_max_iterations(options.max_iterations)
            .with_threads(threads)
            .with_preconditioner(preconditioner)
            .with_cancel(interruption.as_ref().map(Interruption::flag))
            .with_time_budget(work.left().map(|left| left.max(LEAST)));
        settings.measure = measure.as_deref();
        let settings = options.relaxing.set(settings);
        let mut observe = |step: &Step<'_>| {
            check_interrupt();
            observe(step);
        };
        let ended = solver.solver.solve_many(&*operator, &lit, &mut unknowns, &settings, &mut observe);
        // Where it was cancelled.
        check_interrupt();
        cost = cost_of(ended, options.keep_partial)?;
    }
    drop(lit);
    let mut columns = unknowns.chunks_exact(dim.max(1));
    let own = |is_lit: &bool| {
        let own = if *is_lit { columns.next() } else { None };
        own.map_or_else(|| vec![0.0; dim], <[f64]>::to_vec)
    };
    let unknowns: Vec<Vec<f64>> = are_lit.iter().map(own).collect();
    made.each(&mut |range, some| {
        Ritz::found_of_each(some, &unknowns[range]).into_iter().for_each(&mut *take);
    });
    Ok(SolvedBand { unknowns, cost })
}
