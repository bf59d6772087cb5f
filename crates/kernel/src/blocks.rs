//! The transfer matrix G by blocks: one triangle where G is symmetric, zero blocks left out.
//!
//! Ranks share G by rows of elements: each holds the blocks of its own rows, and of its own columns where a
//! block stands for its transpose too. A product is summed on the rank that holds its row, in the order of
//! all blocks, and then completed by those of the others ([`HeldRows`]).

pub mod block;
mod block_list;
pub mod bounded_rows;
pub mod held_rows;
mod lanes;
pub(crate) mod worst_error;
pub(crate) mod placed_block;
pub(crate) mod pair_counts;
pub(crate) mod remainder;
pub(crate) mod row_error;
pub(crate) mod statistics;

use std::borrow::Cow;
use std::collections::HashMap;
use std::ops::Range;

use radiosity_core::dot;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::Ranks;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use block_list::{BlockList, Run, Stored};
use held_rows::HeldRows;
use lanes::Lanes;
use placed_block::PlacedBlock;
use statistics::BlockStatistics;

/// The transfer matrix G by blocks: one triangle where G is symmetric, zero blocks left out.
#[derive(Clone, Debug)]
pub struct Blocks {
    starts: Vec<usize>,
    /// The part of this rank.
    held: HeldRows,
    stored: BlockList,
    /// Blocks of which only the first line and the first column are not zero.
    crosses: BlockList,
    symmetric: bool,
    /// Whether all elements carry constants.
    are_constants: bool,
    /// The values of the blocks that this rank holds, one after the other.
    values: Vec<f64>,
    /// Numbers that all ranks store, each block counted once.
    numbers: usize,
    /// Whether all blocks of an element's row were computed.
    complete: Vec<bool>,
    /// G c as integrated, c the coefficients of the constant 1, where G was corrected afterwards.
    pub integrated: Option<Vec<f64>>,
    /// Their counts, costs and errors.
    pub statistics: BlockStatistics,
}

/// The entry of a block between constants.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct FirstEntry {
    /// Index of the receiver.
    pub row: usize,
    /// Index of the emitter.
    pub column: usize,
    /// G of the two constants.
    pub value: f64,
}

/// A block on its way to other ranks.
#[derive(Serialize, Deserialize)]
struct Row {
    place: usize,
    pair: [usize; 2],
    values: Vec<f64>,
}

/// Blocks of all ranks by their places.
fn in_order(parts: Vec<Vec<Row>>) -> Vec<Row> {
    let mut all: Vec<Row> = parts.into_iter().flatten().collect();
    all.sort_by_key(|row| row.place);
    all
}

impl Blocks {
    /// No blocks yet, to be held by these ranks. `starts` are the first coefficients of the elements, and the
    /// dimension at the end. If G is `symmetric`, each block also stands for its transpose.
    pub fn empty(starts: Vec<usize>, symmetric: bool, ranks: &Ranks) -> Self {
        Self {
            complete: vec![true; starts.len() - 1],
            held: HeldRows::of(ranks, &starts),
            are_constants: starts.iter().copied().eq(0..starts.len()),
            starts,
            stored: BlockList::default(),
            crosses: BlockList::default(),
            symmetric,
            values: Vec::new(),
            numbers: 0,
            integrated: None,
            statistics: BlockStatistics::default(),
        }
    }

    /// Appends a block, unless it is zero. All ranks append the same blocks; where one does not hold a block,
    /// it may know of its values only whether they are zero ([`Blocks::pass`]).
    pub fn push(&mut self, row: usize, column: usize, values: &[f64]) {
        if values.iter().any(|value| *value != 0.0) {
            match self.holds(row, column) {
                true => self.keep(row, column, values),
                false => self.pass(row, column),
            }
        }
    }

    /// Counts a block that differs from zero and is held by other ranks.
    pub fn pass(&mut self, row: usize, column: usize) {
        self.stored.all += 1;
        self.numbers += self.range(row).len() * self.range(column).len();
    }

    fn keep(&mut self, row: usize, column: usize, values: &[f64]) {
        let (place, start) = (self.stored.all, self.values.len());
        self.stored.push(Stored { row: row as u32, column: column as u32, start, place }, values.len());
        self.values.extend_from_slice(values);
        self.pass(row, column);
    }

    /// Whether this rank holds the block of a pair.
    pub fn holds(&self, row: usize, column: usize) -> bool {
        self.held.has(row) || (self.symmetric && self.held.has(column))
    }

    /// The rows of this rank, and those of all.
    pub fn held(&self) -> &HeldRows {
        &self.held
    }

    /// Records that some blocks of an element's row were left out.
    pub fn leave_open(&mut self, element: usize) {
        self.complete[element] = false;
    }

    /// Whether all blocks of an element's row were computed.
    pub fn is_complete(&self, element: usize) -> bool {
        self.complete[element]
    }

    /// Whether G is symmetric; it is, except by the rules of 1993 (`published::zatz1993::transfers`).
    pub fn symmetric(&self) -> bool {
        self.symmetric
    }

    /// Numbers that are stored, by all ranks together, each block counted once.
    pub fn stored_numbers(&self) -> usize {
        self.numbers
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

    /// Stores a block of a symmetric G of which only the first line and the first column differ from zero:
    /// first the line, then the rest of the column.
    pub fn push_cross(&mut self, row: usize, column: usize, values: &[f64]) {
        if self.holds(row, column) {
            let (place, start) = (self.crosses.all, self.values.len());
            self.crosses.push(Stored { row: row as u32, column: column as u32, start, place }, values.len());
            self.values.extend_from_slice(values);
        }
        self.pass_cross(row, column);
    }

    /// Counts a block stored as a cross by other ranks.
    pub fn pass_cross(&mut self, row: usize, column: usize) {
        self.crosses.all += 1;
        self.numbers += self.range(row).len() + self.range(column).len() - 1;
    }

    /// Appends all blocks of `others`, which are of the same elements.
    pub fn append(&mut self, others: &Self) {
        let before = self.values.len();
        let (whole, crosses) = (self.stored.all, self.crosses.all);
        for block in others.blocks() {
            let values = others.entries(&block).len();
            self.stored.push(block.after(before, whole), values);
        }
        for cross in others.cross_blocks() {
            let values = others.line_and_rest(&cross).len();
            self.crosses.push(cross.after(before, crosses), values);
        }
        self.stored.all += others.stored.all;
        self.crosses.all += others.crosses.all;
        self.values.extend_from_slice(&others.values);
        self.numbers += others.numbers;
    }

    /// All blocks, held by every rank.
    pub fn gathered(&self) -> Cow<'_, Self> {
        let ranks = self.held.ranks();
        if ranks.are_alone() {
            return Cow::Borrowed(self);
        }
        let stored = in_order(ranks.all(self.rows(self.blocks(), Self::entries)));
        let crosses = in_order(ranks.all(self.rows(self.cross_blocks(), Self::line_and_rest)));
        let mut all = Self {
            complete: self.complete.clone(),
            integrated: self.integrated.clone(),
            statistics: self.statistics.clone(),
            ..Self::empty(self.starts.clone(), self.symmetric, Ranks::alone())
        };
        stored.iter().for_each(|Row { pair: [row, column], values, .. }| all.keep(*row, *column, values));
        crosses
            .iter()
            .for_each(|Row { pair: [row, column], values, .. }| all.push_cross(*row, *column, values));
        Cow::Owned(all)
    }

    /// All blocks, held by every rank, in place of these.
    pub fn into_gathered(self) -> Self {
        if self.held.ranks().are_alone() { self } else { self.gathered().into_owned() }
    }

    /// The blocks of a list that are in the rows of this rank.
    fn rows<'a>(
        &'a self,
        list: impl Iterator<Item = Stored>,
        values: impl Fn(&'a Self, &Stored) -> &'a [f64],
    ) -> Vec<Row> {
        let own = list.filter(|stored| self.held.has(stored.row as usize));
        let row = |stored: Stored| Row {
            place: stored.place,
            pair: [stored.row as usize, stored.column as usize],
            values: values(self, &stored).to_vec(),
        };
        own.map(row).collect()
    }

    /// y = G x.
    pub fn apply(&self, x: &[f64]) -> Vec<f64> {
        check_interrupt();
        if self.crosses.all > 0 {
            return self.apply_in_chunks(x);
        }
        let mut own = vec![0.0; self.held.coefficients().len()];
        self.stored.runs().for_each(|run| self.add_run(run, x, &mut own));
        self.completed(&own)
    }

    /// y = G x of a symmetric G, in parallel: sums over a fixed number of chunks of blocks, so that threads
    /// change no bit.
    pub fn apply_in_chunks(&self, x: &[f64]) -> Vec<f64> {
        let mut own = vec![0.0; self.held.coefficients().len()];
        self.add_chunks(self.stored.chunks(self.size()), &|run, y| self.add_run(run, x, y), &mut own);
        let add = |run: Run<'_>, y: &mut [f64]| {
            run.blocks(self.cross_size()).for_each(|cross| self.add_cross(&cross, x, y));
        };
        self.add_chunks(self.crosses.chunks(self.cross_size()), &add, &mut own);
        self.completed(&own)
    }

    /// y = G x for each of several x, which pass the blocks together where they are many. Few have the bits of
    /// [`Blocks::apply`], so that light does not depend on groups that are dark.
    pub fn apply_to_each(&self, all: &[Vec<f64>]) -> Vec<Vec<f64>> {
        if all.len() <= lanes::WIDTH {
            return all.iter().map(|x| self.apply(x)).collect();
        }
        let bundles = all.par_chunks(lanes::WIDTH).map(|bundle| self.apply_to_lanes(&Lanes::of(bundle)));
        let products = bundles.collect::<Vec<_>>();
        let each = |(bundle, product): (&[Vec<f64>], Lanes)| {
            (0..bundle.len()).map(move |lane| product.lane(lane)).collect::<Vec<_>>()
        };
        let own = all.chunks(lanes::WIDTH).zip(products).flat_map(each);
        own.map(|own| self.completed(&own)).collect()
    }

    /// The rows of this rank of G x in each lane.
    fn apply_to_lanes(&self, x: &Lanes) -> Lanes {
        check_interrupt();
        let mut own = Lanes::zero(self.held.coefficients().len());
        for block in self.blocks() {
            self.add_to_lanes(&block, self.entries(&block), x, &mut own);
        }
        for cross in self.cross_blocks() {
            self.add_to_lanes(&cross, &self.filled(&cross), x, &mut own);
        }
        own
    }

    /// As [`Blocks::add`] for the entries of a block, in each lane.
    fn add_to_lanes(&self, stored: &Stored, entries: &[f64], x: &Lanes, own: &mut Lanes) {
        let (row, column) = (stored.row as usize, stored.column as usize);
        let (rows, columns) = (self.range(row), self.range(column));
        if self.held.has(row) {
            own.add_product(self.place(&rows), entries, x, columns.clone());
        }
        if self.symmetric && row != column && self.held.has(column) {
            own.add_transposed_product(self.place(&columns), entries, x, rows);
        }
    }

    /// A product of which this rank has summed its `own` rows.
    fn completed(&self, own: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.dim()];
        all[self.held.coefficients()].copy_from_slice(own);
        self.held.complete(&mut all);
        all
    }

    /// Adds to `sum`, the rows of this rank, what `add` makes of all runs, chunk by chunk in parallel.
    fn add_chunks(
        &self,
        chunks: Vec<Vec<Run<'_>>>,
        add: &(dyn Fn(Run<'_>, &mut [f64]) + Sync),
        sum: &mut [f64],
    ) {
        let length = sum.len();
        let parts = chunks.into_par_iter().map(|runs| {
            check_interrupt();
            let mut y = vec![0.0; length];
            runs.into_iter().for_each(|run| add(run, &mut y));
            y
        });
        for part in parts.collect::<Vec<_>>() {
            sum.iter_mut().zip(part).for_each(|(sum, y)| *sum += y);
        }
    }

    /// As [`Blocks::add`] for all blocks of a run.
    fn add_run(&self, run: Run<'_>, x: &[f64], own: &mut [f64]) {
        match self.are_constants {
            true => self.add_constants(run, x, own),
            false => run.blocks(self.size()).for_each(|block| self.add(&block, x, own)),
        }
    }

    /// As [`Blocks::add`] for a run of blocks between constants.
    fn add_constants(&self, run: Run<'_>, x: &[f64], own: &mut [f64]) {
        let (row, first) = (run.row as usize, self.held.coefficients().start);
        let mut sum = 0.0;
        for (column, value) in run.columns.iter().zip(&self.values[run.start..]) {
            let column = *column as usize;
            sum += value * x[column];
            if self.symmetric && column != row {
                // Columns of other ranks wrap around.
                own.get_mut(column.wrapping_sub(first)).into_iter().for_each(|y| *y += value * x[row]);
            }
        }
        own.get_mut(row.wrapping_sub(first)).into_iter().for_each(|y| *y += sum);
    }

    /// As [`Blocks::add`] for a block stored as a cross, whose row comes before its column.
    fn add_cross(&self, stored: &Stored, x: &[f64], own: &mut [f64]) {
        let (row, column) = (stored.row as usize, stored.column as usize);
        let (rows, columns) = (self.range(row), self.range(column));
        let (line, rest) = self.line_and_rest(stored).split_at(columns.len());
        if self.held.has(row) {
            let (x, y) = (&x[columns.clone()], &mut own[self.place(&rows)]);
            y[0] += dot(line, x);
            add_multiple(rest, x[0], &mut y[1..]);
        }
        if self.held.has(column) {
            let (x, y) = (&x[rows], &mut own[self.place(&columns)]);
            add_multiple(line, x[0], y);
            y[0] += dot(rest, &x[1..]);
        }
    }

    /// Adds G_ij x_j to y_i and, of a symmetric G, G_ijᵀ x_i to y_j, where these are among the rows of this
    /// rank, `own`.
    fn add(&self, stored: &Stored, x: &[f64], own: &mut [f64]) {
        let (row, column) = (stored.row as usize, stored.column as usize);
        let (rows, columns) = (self.range(row), self.range(column));
        let lines = self.entries(stored).chunks_exact(columns.len());
        if self.held.has(row) {
            let y = own[self.place(&rows)].iter_mut();
            y.zip(lines.clone()).for_each(|(y, line)| *y += dot(line, &x[columns.clone()]));
        }
        if self.symmetric && row != column && self.held.has(column) {
            let y = &mut own[self.place(&columns)];
            lines.zip(&x[rows]).for_each(|(line, x)| add_multiple(line, *x, y));
        }
    }

    /// Where the coefficients of an element of this rank stand among those of its rows.
    fn place(&self, coefficients: &Range<usize>) -> Range<usize> {
        let first = self.held.coefficients().start;
        coefficients.start - first..coefficients.end - first
    }

    /// y = Gᵀ x.
    pub fn apply_transposed(&self, x: &[f64]) -> Vec<f64> {
        if self.symmetric {
            return self.apply(x);
        }
        let mut y = vec![0.0; self.dim()];
        for PlacedBlock { row, column, values } in self.gathered().full() {
            let columns = self.range(column);
            let lines = values.chunks_exact(columns.len()).zip(&x[self.range(row)]);
            lines.for_each(|(line, x)| add_multiple(line, *x, &mut y[columns.clone()]));
        }
        y
    }

    /// The nonzero blocks that this rank holds. Where G is symmetric, receiver ≤ emitter and each block
    /// stands for its transpose too.
    pub fn iter(&self) -> impl Iterator<Item = PlacedBlock<'_>> {
        let cross = |cross: Stored| PlacedBlock {
            row: cross.row as usize,
            column: cross.column as usize,
            values: Cow::Owned(self.filled(&cross)),
        };
        self.full().chain(self.cross_blocks().map(cross))
    }

    /// Changes the values of the blocks that this rank holds and that are stored whole; `change` gets the receiver and
    /// the emitter of each.
    pub fn change(&mut self, mut change: impl FnMut(usize, usize, &mut [f64])) {
        let Self { stored, starts, values, .. } = self;
        let size = |row: usize, column: usize| {
            (starts[row + 1] - starts[row]) * (starts[column + 1] - starts[column])
        };
        for Stored { row, column, start, .. } in stored.runs().flat_map(|run| run.blocks(size)) {
            let (row, column) = (row as usize, column as usize);
            change(row, column, &mut values[start..][..size(row, column)]);
        }
    }

    /// The entries of a block that is stored as a cross, row-major.
    fn filled(&self, stored: &Stored) -> Vec<f64> {
        let [rows, columns] = [stored.row, stored.column].map(|element| self.range(element as usize).len());
        let values = self.line_and_rest(stored);
        let mut block = vec![0.0; rows * columns];
        block[..columns].copy_from_slice(&values[..columns]);
        for (k, value) in values[columns..].iter().enumerate() {
            block[(k + 1) * columns] = *value;
        }
        block
    }

    /// The first entries of all blocks that differ from zero.
    pub fn first_entries(&self) -> Vec<FirstEntry> {
        let first = |Stored { row, column, start, place }: Stored| {
            let (row, column) = (row as usize, column as usize);
            (place, FirstEntry { row, column, value: self.values[start] })
        };
        let is_own = |stored: &Stored| self.held.has(stored.row as usize);
        let in_order = |own: Vec<(usize, FirstEntry)>| {
            let mut all = self.held.ranks().all(own).concat();
            all.sort_by_key(|(place, _)| *place);
            all
        };
        let stored = in_order(self.blocks().filter(is_own).map(first).collect());
        let crosses = in_order(self.cross_blocks().filter(is_own).map(first).collect());
        stored.into_iter().chain(crosses).map(|(_, first)| first).collect()
    }

    /// The blocks G_ii of all elements that see themselves.
    pub fn diagonal(&self) -> HashMap<usize, Vec<f64>> {
        let own = self.iter().filter(|block| block.row == block.column);
        let own: Vec<(usize, Vec<f64>)> = own.map(|block| (block.row, block.values.into_owned())).collect();
        self.held.ranks().all(own).into_iter().flatten().collect()
    }

    /// The blocks that are stored whole, as [`Blocks::iter`].
    fn full(&self) -> impl Iterator<Item = PlacedBlock<'_>> {
        self.blocks().map(|stored| PlacedBlock {
            row: stored.row as usize,
            column: stored.column as usize,
            values: Cow::Borrowed(self.entries(&stored)),
        })
    }

    /// The blocks that this rank holds and that are stored whole.
    fn blocks(&self) -> impl Iterator<Item = Stored> {
        self.stored.runs().flat_map(|run| run.blocks(self.size()))
    }

    /// The blocks that this rank holds and that are stored as crosses.
    fn cross_blocks(&self) -> impl Iterator<Item = Stored> {
        self.crosses.runs().flat_map(|run| run.blocks(self.cross_size()))
    }

    /// Numbers of a block that is stored whole.
    fn size(&self) -> impl Fn(usize, usize) -> usize {
        |row, column| self.range(row).len() * self.range(column).len()
    }

    /// Numbers of a block that is stored as a cross.
    fn cross_size(&self) -> impl Fn(usize, usize) -> usize {
        |row, column| self.range(row).len() + self.range(column).len() - 1
    }

    /// The entries of a block that is stored whole.
    fn entries(&self, Stored { row, column, start, .. }: &Stored) -> &[f64] {
        &self.values[*start..][..self.range(*row as usize).len() * self.range(*column as usize).len()]
    }

    /// The first line of a block that is stored as a cross, and the rest of its first column.
    fn line_and_rest(&self, Stored { row, column, start, .. }: &Stored) -> &[f64] {
        &self.values[*start..][..self.range(*row as usize).len() + self.range(*column as usize).len() - 1]
    }

    fn range(&self, element: usize) -> Range<usize> {
        self.starts[element]..self.starts[element + 1]
    }
}

/// y ← y + a x.
fn add_multiple(a: &[f64], x: f64, y: &mut [f64]) {
    y.iter_mut().zip(a).for_each(|(y, a)| *y += a * x);
}
