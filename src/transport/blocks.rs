//! The transfer matrix G by blocks: one triangle where G is symmetric, zero blocks left out.

pub(crate) mod block;
pub(crate) mod miss;
pub(crate) mod pair_counts;
pub(crate) mod reciprocity;
pub(crate) mod remainder;

use std::borrow::Cow;

use rayon::prelude::*;

use crate::transport::blocks::pair_counts::PairCounts;
use block::Block;
use miss::Miss;
use reciprocity::Reciprocity;
use remainder::Remainder;

/// Chunks of blocks that are multiplied in parallel: enough for some cores, few enough for the sums of their results.
const CHUNKS: usize = 32;

/// The transfer matrix G by blocks: one triangle where G is symmetric, zero blocks left out.
#[derive(Debug)]
pub struct Blocks {
    starts: Vec<usize>,
    stored: Vec<Stored>,
    /// Blocks of which only the first line and the first column are not zero.
    crosses: Vec<Stored>,
    symmetric: bool,
    /// The values of all blocks, one after the other.
    values: Vec<f64>,
    /// Whether all blocks of an element's row were computed.
    complete: Vec<bool>,
    /// Numbers of pairs by contact and by reason of being skipped.
    pub pairs: PairCounts,
    /// Terms of all rules; logarithms for contour integrals. Blocks that are copies count like those they were copied
    /// from.
    pub samples: u64,
    /// G c as integrated, c the coefficients of the constant 1, where G was corrected afterwards.
    pub(crate) integrated: Option<Vec<f64>>,
    /// Kernel evaluations or logarithms: fewer than the terms where kernel values repeat.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
    /// Reciprocity, from a sample of pairs that were integrated both ways.
    pub reciprocity: Reciprocity,
    /// Estimate of the largest error of a block that rules or rays leave ([`Miss::error`]); zero if all were resolved.
    pub accuracy_reached: f64,
    /// The block whose error is the largest multiple of what was asked of it.
    pub miss: Option<Miss>,
    /// Of blocks that are known otherwise than by integrals.
    pub(crate) remainders: Vec<Remainder>,
}

/// The block of receiver `row` and emitter `column`, row-major from `start` on; `row ≤ column` where G is symmetric.
#[derive(Debug)]
struct Stored {
    row: u32,
    column: u32,
    start: usize,
}

impl Blocks {
    /// No blocks yet. `starts` are the first coefficients of the elements, and the dimension at the end. If G is
    /// `symmetric`, each block also stands for its transpose.
    pub(crate) fn empty(starts: Vec<usize>, symmetric: bool) -> Self {
        Self {
            complete: vec![true; starts.len() - 1],
            starts,
            stored: Vec::new(),
            crosses: Vec::new(),
            symmetric,
            values: Vec::new(),
            pairs: PairCounts::default(),
            samples: 0,
            distinct: 0,
            integrated: None,
            rays: 0,
            reciprocity: Reciprocity::default(),
            accuracy_reached: 0.0,
            miss: None,
            remainders: Vec::new(),
        }
    }

    /// Appends a block, unless it is zero.
    pub(crate) fn push(&mut self, row: usize, column: usize, values: &[f64]) {
        if values.iter().any(|value| *value != 0.0) {
            let start = self.values.len();
            self.stored.push(Stored { row: row as u32, column: column as u32, start });
            self.values.extend_from_slice(values);
        }
    }

    /// Records that some blocks of an element's row were left out.
    pub(crate) fn leave_open(&mut self, element: usize) {
        self.complete[element] = false;
    }

    /// Whether all blocks of an element's row were computed.
    pub fn is_complete(&self, element: usize) -> bool {
        self.complete[element]
    }

    /// Whether G is symmetric; it is, except by the rules of 1993 ([`crate::zatz1993::transfers`]).
    pub fn symmetric(&self) -> bool {
        self.symmetric
    }

    /// Takes the error of a block into account.
    pub(crate) fn tell(&mut self, miss: Miss) {
        self.accuracy_reached = self.accuracy_reached.max(miss.error);
        if self.miss.is_none_or(|worst| miss.excess() > worst.excess()) {
            self.miss = Some(miss);
        }
    }

    /// Adds what it took to integrate a block.
    pub(crate) fn take_costs(&mut self, block: &Block) {
        self.samples += block.samples;
        self.distinct += block.distinct;
        self.rays += block.rays;
    }

    /// Numbers that are stored.
    pub fn stored_numbers(&self) -> usize {
        self.values.len()
    }

    /// Number of coefficients.
    pub fn dim(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }

    /// The first coefficient of each element, and the dimension at the end.
    pub fn starts(&self) -> &[usize] {
        &self.starts
    }

    /// G c for the coefficients c of the constant 1, by G as it was integrated, before any correction.
    pub fn integrated_constant(&self, ones: &[f64]) -> Vec<f64> {
        self.integrated.clone().unwrap_or_else(|| self.apply(ones))
    }

    /// Whether rays carried the pairs, and G was corrected afterwards.
    pub fn is_by_rays(&self) -> bool {
        self.integrated.is_some()
    }

    /// Stores a block of a symmetric G of which only the first line and the first column differ from zero: first the
    /// line, then the rest of the column.
    pub(crate) fn push_cross(&mut self, row: usize, column: usize, values: &[f64]) {
        let start = self.values.len();
        self.crosses.push(Stored { row: row as u32, column: column as u32, start });
        self.values.extend_from_slice(values);
    }

    /// y = G x.
    pub fn apply(&self, x: &[f64]) -> Vec<f64> {
        if !self.crosses.is_empty() {
            return self.apply_in_chunks(x);
        }
        let mut y = vec![0.0; self.dim()];
        self.stored.iter().for_each(|block| self.add(block, x, &mut y));
        y
    }

    /// y = G x of a symmetric G, in parallel: sums over a fixed number of chunks of blocks, so that threads change no
    /// bit.
    pub(crate) fn apply_in_chunks(&self, x: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.dim()];
        self.add_chunks(&self.stored, &|block, y| self.add(block, x, y), &mut sum);
        self.add_chunks(&self.crosses, &|block, y| self.add_cross(block, x, y), &mut sum);
        sum
    }

    /// Adds to `sum` what `add` makes of all blocks of a list, chunk by chunk in parallel.
    fn add_chunks(&self, list: &[Stored], add: &(dyn Fn(&Stored, &mut [f64]) + Sync), sum: &mut [f64]) {
        let chunks = list.par_chunks(list.len().div_ceil(CHUNKS).max(1));
        let parts = chunks.map(|blocks| {
            let mut y = vec![0.0; self.dim()];
            blocks.iter().for_each(|block| add(block, &mut y));
            y
        });
        for part in parts.collect::<Vec<_>>() {
            sum.iter_mut().zip(part).for_each(|(sum, y)| *sum += y);
        }
    }

    /// As [`Blocks::add`] for a block stored as a cross, whose row comes before its column.
    fn add_cross(&self, Stored { row, column, start }: &Stored, x: &[f64], y: &mut [f64]) {
        let (rows, columns) = (self.range(*row as usize), self.range(*column as usize));
        let values = &self.values[*start..][..rows.len() + columns.len() - 1];
        let (line, rest) = values.split_at(columns.len());
        let (first, later) = y.split_at_mut(columns.start);
        let (own, other) = (&mut first[rows.clone()], &mut later[..columns.len()]);
        let (sent, received) = (&x[rows], &x[columns]);
        let (mut along, mut below) = (0.0, 0.0);
        for ((g, x), y) in line.iter().zip(received).zip(&mut *other) {
            along += g * x;
            *y += g * sent[0];
        }
        for ((g, x), y) in rest.iter().zip(&sent[1..]).zip(&mut own[1..]) {
            below += g * x;
            *y += g * received[0];
        }
        own[0] += along;
        other[0] += below;
    }

    /// Adds G_ij x_j to y_i and, of a symmetric G, G_ijᵀ x_i to y_j.
    fn add(&self, Stored { row, column, start }: &Stored, x: &[f64], y: &mut [f64]) {
        let (row, column) = (*row as usize, *column as usize);
        let (rows, columns) = (self.range(row), self.range(column));
        let values = &self.values[*start..][..rows.len() * columns.len()];
        for (k, line) in values.chunks_exact(columns.len()).enumerate() {
            y[rows.start + k] += line.iter().zip(&x[columns.clone()]).map(|(g, x)| g * x).sum::<f64>();
        }
        if self.symmetric && row != column {
            self.scatter(row, column, values, x, y);
        }
    }

    /// y = Gᵀ x.
    pub fn apply_transposed(&self, x: &[f64]) -> Vec<f64> {
        if self.symmetric {
            return self.apply(x);
        }
        let mut y = vec![0.0; self.dim()];
        self.full().for_each(|(row, column, values)| self.scatter(row, column, values, x, &mut y));
        y
    }

    /// Adds G_ijᵀ x_i to y_j.
    fn scatter(&self, row: usize, column: usize, values: &[f64], x: &[f64], y: &mut [f64]) {
        let columns = self.range(column);
        for (emitted, line) in x[self.range(row)].iter().zip(values.chunks_exact(columns.len())) {
            y[columns.clone()].iter_mut().zip(line).for_each(|(y, g)| *y += g * emitted);
        }
    }

    /// The nonzero blocks as (receiver, emitter, values row-major). Where G is symmetric, receiver ≤ emitter and each
    /// block stands for its transpose too.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, Cow<'_, [f64]>)> {
        let full = self.full().map(|(row, column, values)| (row, column, Cow::Borrowed(values)));
        full.chain(
            self.crosses
                .iter()
                .map(|cross| (cross.row as usize, cross.column as usize, Cow::Owned(self.filled(cross)))),
        )
    }

    /// The entries of a block that is stored as a cross, row-major.
    fn filled(&self, Stored { row, column, start }: &Stored) -> Vec<f64> {
        let [rows, columns] = [row, column].map(|element| self.range(*element as usize).len());
        let values = &self.values[*start..][..rows + columns - 1];
        let mut block = vec![0.0; rows * columns];
        block[..columns].copy_from_slice(&values[..columns]);
        for (k, value) in values[columns..].iter().enumerate() {
            block[(k + 1) * columns] = *value;
        }
        block
    }

    /// The blocks that are stored whole, as [`Blocks::iter`].
    fn full(&self) -> impl Iterator<Item = (usize, usize, &[f64])> {
        self.stored.iter().map(|stored| {
            let (row, column) = (stored.row as usize, stored.column as usize);
            let length = self.range(row).len() * self.range(column).len();
            (row, column, &self.values[stored.start..stored.start + length])
        })
    }

    fn range(&self, element: usize) -> std::ops::Range<usize> {
        self.starts[element]..self.starts[element + 1]
    }
}
