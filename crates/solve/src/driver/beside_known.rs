//! The systems of one band beside known light: what is near enough to that is not solved for.

use std::ops::Range;

use radiosity_core::norm;
use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_kernel::Blocks;
use radiosity_solvers::{SolveError, Step};
use radiosity_work::Work;

use crate::system::known_light::{KnownLight, NearestLight};
use crate::system::ritz::{Ritz, RitzSolution};
use crate::system::{System, emitted};

use super::options::Options;
use super::solve_band::{SolveCost, SystemsOfBand, solve_band};

/// Systems of one band, all light of which G carries between functions of the elements, with the known light that is
/// nearest to theirs.
pub(super) struct BesideKnown<'a> {
    elements: &'a [Element],
    blocks: &'a Blocks,
    coatings: &'a [&'a Coating],
    /// G e of each.
    arrived: Vec<Vec<f64>>,
    nearest: Vec<NearestLight>,
    /// Numbers of the systems that are solved, ascending.
    open: Vec<usize>,
    /// Whether no solution was known.
    is_first: bool,
}

impl<'a> BesideKnown<'a> {
    /// The systems of some coatings of the same reflection, to be solved to this tolerance.
    pub(super) fn of(
        elements: &'a [Element],
        blocks: &'a Blocks,
        coatings: &'a [&'a Coating],
        known: &mut KnownLight,
        tolerance: f64,
    ) -> Self {
        let is_first = known.is_none();
        let sent: Vec<Vec<f64>> = coatings.iter().map(|own| emitted(elements, own)).collect();
        let arrived = known.carried(blocks, &sent);
        let nearest = known.nearest(coatings[0], blocks.starts(), &sent);
        let mut systems = Self { elements, blocks, coatings, arrived, nearest, open: Vec::new(), is_first };
        systems.open = (0..coatings.len()).filter(|number| !systems.is_near(*number, tolerance)).collect();
        systems
    }

    fn system(&self, number: usize) -> Ritz<'a> {
        let arrived = self.arrived[number].clone();
        Ritz::new(System::carried_by(self.elements, self.blocks, self.coatings[number], arrived), None)
    }

    /// Whether known light leaves no more of a system than a solver does.
    fn is_near(&self, number: usize, tolerance: f64) -> bool {
        self.nearest[number].residual <= tolerance * norm(&self.system(number).right_hand_side())
    }

    /// The light of all systems, and the cost of those that were solved; their light is known from then on.
    ///
    /// # Errors
    /// Those of the solver.
    pub(super) fn found(
        self,
        known: &mut KnownLight,
        options: &Options,
        work: &Work<'_>,
        observe: &mut dyn FnMut(&Step<'_>),
    ) -> Result<(Vec<RitzSolution>, Option<SolveCost>), SolveError> {
        let start = |number: &usize| self.system(*number).starting(&self.nearest[*number].irradiance);
        let before: Option<Vec<Vec<f64>>> = (!self.is_first).then(|| self.open.iter().map(start).collect());
        let of = |range: Range<usize>| self.open[range].iter().map(|number| self.system(*number)).collect();
        let systems = SystemsOfBand { count: self.open.len(), of: &of };
        let mut solved = Vec::with_capacity(self.open.len());
        let mut take = |found: RitzSolution| solved.push(found);
        let cost = solve_band(&systems, options, before.as_deref(), work, observe, &mut take)?.cost;
        let radiosity = |own: &RitzSolution| own.coefficients.radiosity.clone();
        known.carried(self.blocks, &solved.iter().map(radiosity).collect::<Vec<_>>());
        Ok((self.with(solved), cost))
    }

    /// The light of all systems, of which these were solved.
    fn with(&self, solved: Vec<RitzSolution>) -> Vec<RitzSolution> {
        let mut found: Vec<Option<RitzSolution>> = self.coatings.iter().map(|_| None).collect();
        self.open.iter().zip(solved).for_each(|(number, own)| found[*number] = Some(own));
        let known = |number: usize| self.system(number).known(self.nearest[number].clone());
        found.into_iter().enumerate().map(|(number, own)| own.unwrap_or_else(|| known(number))).collect()
    }
}
