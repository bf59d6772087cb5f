//! I − Qᵀ √ρ G √ρ Q: the matrix of a subspace, by products with that of the elements.

use radiosity_solvers::{Dense, Operator, Partition, SolveError};
use radiosity_work::ranks::Ranks;

use super::reduction::Reduction;

/// The matrix of a subspace.
pub(super) struct Projected<'a> {
    reduction: &'a Reduction<'a>,
    /// I − √ρ G √ρ.
    elements: Box<dyn Operator + 'a>,
    partition: Partition,
}

impl<'a> Projected<'a> {
    pub(super) fn new(reduction: &'a Reduction<'a>, elements: Box<dyn Operator + 'a>) -> Self {
        Self { reduction, elements, partition: Partition::new(&reduction.sizes()) }
    }

    /// Qᵀ √ρ G √ρ Q x.
    fn reflected(&self, x: &[f64]) -> Vec<f64> {
        let own = self.reduction.extended(x);
        let mut image = vec![0.0; own.len()];
        self.elements.apply(&own, &mut image);
        image.iter_mut().zip(&own).for_each(|(image, x)| *image = x - *image);
        self.reduction.restricted(&image)
    }

    /// The matrix entry by entry, where these ranks hold the blocks of the elements.
    ///
    /// # Errors
    /// Values that are not finite.
    pub(super) fn entries(&self, ranks: &Ranks) -> Result<Dense, SolveError> {
        let dim = self.partition.dim();
        let column = |j: &usize, _: &Ranks| {
            let mut unit = vec![0.0; dim];
            unit[*j] = 1.0;
            let mut image = vec![0.0; dim];
            self.apply(&unit, &mut image);
            image
        };
        let columns: Vec<usize> = (0..dim).collect();
        let mut values = ranks.each(&columns, column).concat();
        if self.symmetric() {
            mirror(&mut values, dim);
        }
        Dense::new(self.partition.clone(), values, self.symmetric())
    }
}

/// Copies the upper triangle to the lower one.
fn mirror(values: &mut [f64], dim: usize) {
    for j in 0..dim {
        for i in 0..j {
            values[i * dim + j] = values[j * dim + i];
        }
    }
}

impl Operator for Projected<'_> {
    fn partition(&self) -> &Partition {
        &self.partition
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let reflected = self.reflected(x);
        y.iter_mut().zip(x).zip(reflected).for_each(|((y, x), r)| *y = x - r);
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        let mut sent = vec![0.0; y.len()];
        sent[self.partition.range(column)].copy_from_slice(x);
        let reflected = self.reflected(&sent);
        y.iter_mut().zip(sent).zip(reflected).for_each(|((y, x), r)| *y += x - r);
    }

    fn symmetric(&self) -> bool {
        self.elements.symmetric()
    }
}
