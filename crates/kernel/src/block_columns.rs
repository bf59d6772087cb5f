//! The transfer matrix G column by column, as light is shot.

use radiosity_elements::columns::transposed;
use radiosity_work::interruption::check_interrupt;

use crate::blocks::Blocks;
use crate::blocks::placed_block::PlacedBlock;

/// The blocks of G by columns: all there from the beginning, or integrated when a column is first asked for.
pub trait BlockColumns: Sync {
    /// The first coefficient of each element, and the dimension at the end.
    fn starts(&self) -> &[usize];

    /// The nonzero blocks of the column of an element, each at the place of its receiver.
    fn column(&self, element: usize) -> Vec<PlacedBlock<'_>>;

    /// Number of columns that were integrated so far.
    fn integrated(&self) -> usize;
}

/// Blocks that are all there, with the places of each column.
#[derive(Debug)]
pub struct ByColumn<'a> {
    starts: &'a [usize],
    blocks: Vec<PlacedBlock<'a>>,
    /// The blocks of each element's column: their numbers, and whether each stands there as its transpose.
    columns: Vec<Vec<Place>>,
}

/// A block in a column.
#[derive(Clone, Copy, Debug)]
struct Place {
    number: usize,
    is_transposed: bool,
}

impl<'a> ByColumn<'a> {
    /// The columns of blocks that one rank holds all.
    pub fn of(blocks: &'a Blocks) -> Self {
        let all: Vec<PlacedBlock<'a>> = blocks.iter().collect();
        let mut columns = vec![Vec::new(); blocks.starts().len() - 1];
        for (number, PlacedBlock { row, column, .. }) in all.iter().enumerate() {
            columns[*column].push(Place { number, is_transposed: false });
            if blocks.symmetric() && row != column {
                columns[*row].push(Place { number, is_transposed: true });
            }
        }
        Self { starts: blocks.starts(), blocks: all, columns }
    }
}

impl BlockColumns for ByColumn<'_> {
    fn starts(&self) -> &[usize] {
        self.starts
    }

    fn column(&self, element: usize) -> Vec<PlacedBlock<'_>> {
        check_interrupt();
        let block = |Place { number, is_transposed }: &Place| {
            let PlacedBlock { row, column, values } = &self.blocks[*number];
            let (row, column) = (*row, *column);
            placed([row, column], values, self.starts[column + 1] - self.starts[column], *is_transposed)
        };
        self.columns[element].iter().map(block).collect()
    }

    fn integrated(&self) -> usize {
        self.columns.len()
    }
}

/// The block of these elements with so many columns, in place or as its transpose.
pub fn placed<'a>(
    [row, column]: [usize; 2],
    values: &'a [f64],
    columns: usize,
    is_transposed: bool,
) -> PlacedBlock<'a> {
    match is_transposed {
        false => PlacedBlock { row, column, values: values.into() },
        true => PlacedBlock { row: column, column: row, values: transposed(values, columns).into() },
    }
}
