//! Cells under way, of which the worst comes first.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::transport::rules::horizon::cell::Cell;

/// Cells by their errors.
#[derive(Debug, Default)]
pub(super) struct Queue {
    heap: BinaryHeap<Entry>,
    /// Sum of the errors.
    error: f64,
    /// Cells that ever came.
    came: usize,
}

#[derive(Debug)]
struct Entry {
    error: f64,
    place: usize,
    cell: Cell,
}

impl Queue {
    /// Adds a cell.
    pub(super) fn push(&mut self, cell: Cell) {
        let error = cell.error();
        self.error += error;
        self.heap.push(Entry { error, place: self.came, cell });
        self.came += 1;
    }

    /// Takes the worst cell out.
    pub(super) fn pop(&mut self) -> Option<Cell> {
        let Entry { error, cell, .. } = self.heap.pop()?;
        // What rounding leaves of the sum goes with the last of them.
        self.error = if self.heap.is_empty() { 0.0 } else { self.error - error };
        Some(cell)
    }

    /// Sum of the cells' errors.
    pub(super) fn error(&self) -> f64 {
        self.error
    }

    /// How many cells there are.
    pub(super) fn len(&self) -> usize {
        self.heap.len()
    }

    /// All of them.
    pub(super) fn into_cells(self) -> impl Iterator<Item = Cell> {
        self.heap.into_iter().map(|entry| entry.cell)
    }
}

impl Ord for Entry {
    /// Equal errors by age, so that the order does not depend on the heap.
    fn cmp(&self, other: &Self) -> Ordering {
        self.error.total_cmp(&other.error).then(other.place.cmp(&self.place))
    }
}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Entry {}
