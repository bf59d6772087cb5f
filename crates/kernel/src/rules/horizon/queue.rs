//! The open cells of an outer patch, the worst first, and the sum of their errors.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::rules::horizon::cell::Cell;

/// Cells by error, the worst first.
#[derive(Debug, Default)]
pub(super) struct Queue {
    heap: BinaryHeap<Entry>,
    /// Sum of the errors.
    error: f64,
    /// Number of cells ever added.
    came: usize,
}

#[derive(Debug)]
struct Entry {
    error: f64,
    place: usize,
    cell: Cell,
}

impl Queue {
    pub(super) fn push(&mut self, cell: Cell) {
        let error = cell.error();
        self.error += error;
        self.heap.push(Entry { error, place: self.came, cell });
        self.came += 1;
    }

    pub(super) fn pop(&mut self) -> Option<Cell> {
        let Entry { error, cell, .. } = self.heap.pop()?;
        // The last cell takes the rounding error of the sum with it.
        self.error = if self.heap.is_empty() { 0.0 } else { self.error - error };
        Some(cell)
    }

    pub(super) fn error(&self) -> f64 {
        self.error
    }

    pub(super) fn len(&self) -> usize {
        self.heap.len()
    }

    pub(super) fn into_cells(self) -> impl Iterator<Item = Cell> {
        self.heap.into_iter().map(|entry| entry.cell)
    }
}

impl Ord for Entry {
    /// Of equal errors the older cell comes first: the order does not depend on the heap.
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
