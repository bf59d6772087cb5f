//! Diagonal blocks and their inverses.

use nalgebra::{DMatrix, DVectorViewMut, Dyn, LU};

use crate::error::SolveError;
use crate::operator::Operator;
use crate::partition::Partition;
use crate::problem::finite;
use crate::settings::Granularity;

/// The inverse of one diagonal block, or of its diagonal alone.
pub(crate) enum Pivot {
    /// The block D, factored.
    Block(LU<f64, Dyn, Dyn>),
    /// The block D as it is, column by column: its unknowns are relaxed one by one.
    Coefficients(Vec<f64>),
}

impl Pivot {
    /// Reads diagonal block `block` of `a`.
    ///
    /// # Errors
    /// [`SolveError::NonFinite`], or [`SolveError::Singular`] if a pivot is exactly 0.
    pub(crate) fn read(a: &dyn Operator, block: usize, granularity: Granularity) -> Result<Self, SolveError> {
        let size = a.partition().size(block);
        let values = diagonal_block(a, block)?;
        let singular = || SolveError::Singular { what: format!("diagonal block {block}") };
        if granularity == Granularity::Coefficient {
            let invertible = (0..size).all(|k| values[k * size + k] != 0.0);
            return if invertible { Ok(Self::Coefficients(values)) } else { Err(singular()) };
        }
        let factored = DMatrix::from_vec(size, size, values).lu();
        if factored.is_invertible() { Ok(Self::Block(factored)) } else { Err(singular()) }
    }

    /// All diagonal blocks of `a`, in order.
    pub(crate) fn read_all(a: &dyn Operator, granularity: Granularity) -> Result<Vec<Self>, SolveError> {
        (0..a.partition().len()).map(|block| Self::read(a, block, granularity)).collect()
    }

    /// r := D⁻¹ r for all blocks of a whole vector.
    pub(crate) fn divide_all(pivots: &[Self], partition: &Partition, r: &mut [f64]) {
        for (block, pivot) in pivots.iter().enumerate() {
            pivot.divide(&mut r[partition.range(block)]);
        }
    }

    /// r := D⁻¹ r, or r_k := r_k / d_kk.
    pub(crate) fn divide(&self, r: &mut [f64]) {
        match self {
            // nalgebra solves nothing for no unknowns.
            Self::Block(_) if r.is_empty() => {}
            Self::Block(factored) => {
                let size = r.len();
                // Always solved: the block was refused unless it is invertible.
                factored.solve_mut(&mut DVectorViewMut::from_slice(r, size));
            }
            Self::Coefficients(values) => {
                let size = r.len();
                for (k, r) in r.iter_mut().enumerate() {
                    *r /= values[k * size + k];
                }
            }
        }
    }
}

/// Diagonal block `block` of `a`, column by column, refused unless finite.
pub(crate) fn diagonal_block(a: &dyn Operator, block: usize) -> Result<Vec<f64>, SolveError> {
    let mut values = vec![f64::NAN; a.partition().size(block).pow(2)];
    a.diagonal(block, &mut values);
    finite(&values)?;
    Ok(values)
}
