//! Southwell: always relax where the residual is largest.
//!
//! The residual r = b − A x is what has not been shot. With weights w_l > 0 the measure of an unknown is
//! M_l = w_l |r_l|, that of a block the sum over its unknowns. Each shot takes the block B (or the unknown)
//! of largest measure and sets
//!
//!   δ = ω D_B⁻¹ r_B,   x_B ← x_B + δ,   r ← r − A[:, B] δ,
//!
//! which needs one block column and no other: an operator may compute columns when they are first shot. From
//! x = 0 only shot columns are ever used, also for the final residual. ω > 1 overshoots: it shoots what later
//! shots would send back.
//!
//! With A = I − K and r, x in the coefficients of an orthonormal basis T_l on elements of area element A, the
//! weights w_l = ∬ |T_l| A du dv are those of eq. 25 of H. Zatz, *Galerkin radiosity*, SIGGRAPH 1993, for
//! the progressive refinement of M. Cohen, S. Chen, J. Wallace and D. Greenberg, SIGGRAPH 1988.
//!
//! Converges for every first guess if A is symmetric positive definite and 0 < ω < 2, since every shot lowers
//! (x − x*)ᵀ A (x − x*); with ω = 1 also if Σ_{i≠l} w_i |a_il| < w_l |a_ll| for every l, since every shot
//! then lowers Σ M_l. References: R. V. Southwell, *Relaxation Methods in Engineering Science*, Oxford 1940;
//! S. Gortler, M. Cohen, P. Slusallek, *Radiosity and relaxation methods*, IEEE CG&A 14(6), 1994.

use std::ops::Range;

use crate::diagonal::Pivot;
use crate::error::SolveError;
use crate::iteration::{Iteration, Watch, iterate};
use crate::operator::Operator;
use crate::problem::{Problem, finite};
use crate::ranking::Ranking;
use crate::settings::{Granularity, Settings};
use crate::solver::{Report, Solver, Step};

pub(crate) const NAME: &str = "southwell";

/// Greedy shooting, by block or by coefficient; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Southwell;

impl Solver for Southwell {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let problem = Problem::new(a, b, x, settings)?;
        let mut shots = Shots::new(&problem, settings);
        let sweep = shots.ranking.keys().len().max(1);
        let watch = Watch {
            method: NAME,
            limit: settings.max_iterations.saturating_mul(sweep),
            asked: settings.shots,
            patience: 20 * sweep + 100,
            keep_every: sweep,
        };
        iterate(&problem, &watch, &mut shots, x, settings, observer)
    }
}

struct Shots<'p> {
    problem: &'p Problem<'p>,
    granularity: Granularity,
    relaxation: f64,
    weights: Vec<f64>,
    /// The unshot residual.
    r: Vec<f64>,
    /// Items (blocks or unknowns) by measure.
    ranking: Ranking,
    /// Diagonal blocks of the columns shot so far.
    pivots: Vec<Option<Pivot>>,
    /// Which block columns were shot, or used to recompute the residual.
    used: Vec<bool>,
    /// Columns of entries multiplied.
    products: f64,
}

impl<'p> Shots<'p> {
    fn new(problem: &'p Problem<'p>, settings: &Settings<'_>) -> Self {
        let partition = problem.a.partition();
        let items = match settings.granularity {
            Granularity::Block => partition.len(),
            Granularity::Coefficient => partition.dim(),
        };
        Self {
            problem,
            granularity: settings.granularity,
            relaxation: settings.relaxation,
            weights: settings.measure.map_or_else(|| vec![1.0; problem.dim()], <[f64]>::to_vec),
            r: problem.b.to_vec(),
            ranking: Ranking::new(vec![0.0; items]),
            pivots: (0..partition.len()).map(|_| None).collect(),
            used: vec![false; partition.len()],
            products: 0.0,
        }
    }

    /// The unknowns of one item.
    fn unknowns(&self, item: usize) -> Range<usize> {
        match self.granularity {
            Granularity::Block => self.problem.a.partition().range(item),
            Granularity::Coefficient => item..item + 1,
        }
    }

    /// The block in which an item lies.
    fn block(&self, item: usize) -> usize {
        match self.granularity {
            Granularity::Block => item,
            Granularity::Coefficient => {
                self.problem.a.partition().offsets().partition_point(|offset| *offset <= item) - 1
            }
        }
    }

    /// Measures all items again.
    fn measure(&mut self) {
        for item in 0..self.ranking.keys().len() {
            let range = self.unknowns(item);
            let key = self.r[range.clone()].iter().zip(&self.weights[range]).map(|(r, w)| w * r.abs()).sum();
            if key != self.ranking.keys()[item] {
                self.ranking.set(item, key);
            }
        }
    }

    /// Shoots one item: x and r change together.
    fn shoot(&mut self, item: usize, x: &mut [f64]) -> Result<(), SolveError> {
        let (block, unknowns) = (self.block(item), self.unknowns(item));
        let range = self.problem.a.partition().range(block);
        if self.pivots[block].is_none() {
            self.pivots[block] = Some(Pivot::read(self.problem.a, block, self.granularity)?);
        }
        let mut step = vec![0.0; range.len()];
        let within = unknowns.start - range.start..unknowns.end - range.start;
        step[within].copy_from_slice(&self.r[unknowns.clone()]);
        if let Some(pivot) = &self.pivots[block] {
            pivot.divide(&mut step);
        }
        for (step, x) in step.iter_mut().zip(&mut x[range]) {
            *step *= self.relaxation;
            *x += *step;
            *step = -*step;
        }
        self.used[block] = true;
        self.products += unknowns.len() as f64;
        self.problem.a.shoot(block, &step, &mut self.r);
        finite(&self.r)
    }
}

impl Iteration for Shots<'_> {
    fn renew(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        for (block, used) in self.used.iter_mut().enumerate() {
            *used |= x[self.problem.a.partition().range(block)].iter().any(|x| *x != 0.0);
        }
        self.products += x.iter().filter(|x| **x != 0.0).count() as f64;
        let residual = self.problem.residual_by_columns(x, &mut self.r)?;
        self.measure();
        Ok(residual)
    }

    fn advance(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        let Some((item, _)) = self.ranking.top() else { return Ok(0.0) };
        self.shoot(item, x)?;
        self.measure();
        Ok(self.problem.relative(&self.r))
    }

    fn work(&self) -> f64 {
        self.products / self.problem.dim().max(1) as f64
    }

    fn columns(&self) -> usize {
        self.used.iter().filter(|used| **used).count()
    }

    fn unshot(&self) -> Option<&[f64]> {
        Some(&self.r)
    }
}
