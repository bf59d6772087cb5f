//! The linear system of one band.

use radiosity_solvers::{Report, Settings, SolveError, Step};

use crate::system::{Coefficients, System};

use super::options::Options;

/// The cost of a band's linear system.
pub(super) struct Effort {
    pub method: &'static str,
    pub iterations: usize,
    pub converged: bool,
}

/// The cost of a finished solver; with `keep_partial` the best iterate of one that did not converge counts too.
fn effort(ended: Result<Report, SolveError>, keep_partial: bool) -> Result<Effort, SolveError> {
    match ended {
        Ok(Report { method, iterations, .. }) => Ok(Effort { method, iterations, converged: true }),
        Err(SolveError::NotConverged { method, iterations, .. }) if keep_partial => {
            Ok(Effort { method, iterations, converged: false })
        }
        Err(error) => Err(error),
    }
}

/// Solves one band. Without light there is nothing to solve, and no effort.
///
/// # Errors
/// Those of the solver.
pub(super) fn solve_band(
    system: &System,
    options: &Options,
    observe: &mut dyn FnMut(&Step<'_>),
) -> Result<(Coefficients, Option<Effort>), SolveError> {
    let right = system.right_hand_side();
    let mut unknowns = vec![0.0; right.len()];
    // Only shooting needs it, and it costs as much as a basis.
    let measure = (options.method.name == "southwell").then(|| system.shooting_measure());
    let mut needed = None;
    if right.iter().any(|value| *value != 0.0) {
        let settings = Settings {
            tolerance: options.tolerance,
            max_iterations: options.max_iterations,
            threads: options.threads,
            measure: measure.as_deref(),
            ..Settings::default()
        };
        let solver = options.method.solver;
        let ended = solver.solve(
            &*system.operator(options.method.name, options.threads)?,
            &right,
            &mut unknowns,
            &settings,
            observe,
        );
        needed = Some(effort(ended, options.keep_partial)?);
    }
    Ok((system.coefficients(&unknowns), needed))
}
