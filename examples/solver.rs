//! A solver of one's own, chosen as those of the crate are.
//!
//! ```text
//! cargo run --release --example solver
//! ```

#![expect(clippy::print_stdout, reason = "two lines for people")]

use std::error::Error;

use radiosity::solvers::method::{Access, Method, Needs};
use radiosity::solvers::{Operator, Report, Settings, SolveError, Solver, Step};
use radiosity::{Options, Work, builtin, solve};

/// Steepest descent: x ← x + (r·r / r·A r) r with the residual r = b − A x.
struct Descent;

impl Solver for Descent {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
        let (mut product, mut history) = (vec![0.0; b.len()], Vec::new());
        loop {
            a.apply(x, &mut product);
            let r: Vec<f64> = b.iter().zip(&product).map(|(b, ax)| b - ax).collect();
            history.push((dot(&r, &r) / dot(b, b)).sqrt());
            observer(&Step::new(history.len() - 1, history[history.len() - 1], x));
            if history[history.len() - 1] <= settings.tolerance {
                return Ok(Report::new("descent", history));
            }
            a.apply(&r, &mut product);
            let length = dot(&r, &r) / dot(&r, &product);
            x.iter_mut().zip(&r).for_each(|(x, r)| *x += length * r);
        }
    }
}

static DESCENT: Method = Method {
    name: "descent",
    aliases: &[],
    summary: "steepest descent",
    needs: Needs::PositiveDefinite,
    access: Access::Products,
    cost: "n² for each step",
    storage: "2 n",
    solver: &Descent,
};

fn main() -> Result<(), Box<dyn Error>> {
    let scene = builtin("cornell-box")?;
    for method in [&DESCENT, &Method::CG] {
        let outcome = solve(&scene, &Options { solver: method, ..Options::default() }, &Work::alone())?;
        println!("{}: {} iterations, residual {:.1e}", method.name, outcome.iterations, outcome.residual);
    }
    Ok(())
}
