//! The exchanges A_i F_ij of pairs of surfaces, each stored once.

use radiosity_elements::Elements;
use radiosity_kernel::{Blocks, PlacedBlock};
use radiosity_transport::{RowExchanges, RowPairs};

/// The exchanges of pairs of surfaces, each with the surface that comes first.
#[derive(Debug)]
pub(super) struct Exchanges {
    rows: Vec<RowExchanges>,
}

impl Exchanges {
    /// The exchanges of so many surfaces by blocks between their elements, of the pairs that are wanted.
    pub(super) fn of_blocks(
        elements: &Elements,
        blocks: &Blocks,
        surfaces: usize,
        is_wanted: &dyn Fn(usize, usize) -> bool,
    ) -> Self {
        let list = elements.list();
        let mut rows: Vec<Vec<(u32, f64)>> = vec![Vec::new(); surfaces];
        for PlacedBlock { row: a, column: b, values } in blocks.gathered().iter() {
            let exchange = values[0] * (list[a].area * list[b].area).sqrt();
            let (i, j) = (list[a].surface, list[b].surface);
            if !is_wanted(i, j) {
                continue;
            }
            // Two different elements of one surface exchange in both directions.
            let twice = if i == j && a != b { 2.0 } else { 1.0 };
            rows[i.min(j)].push((i.max(j) as u32, twice * exchange));
        }
        Self { rows: rows.into_iter().map(Self::summed).collect() }
    }

    /// The exchanges of pairs of surfaces that are one element each.
    pub(super) fn of_facets(rows: Vec<RowPairs>) -> Self {
        Self { rows: rows.into_iter().map(|row| row.exchanges).collect() }
    }

    /// The row of these exchanges, of which several may have one column.
    fn summed(mut all: Vec<(u32, f64)>) -> RowExchanges {
        all.sort_by_key(|(column, _)| *column);
        let mut row = RowExchanges::default();
        for own in all.chunk_by(|a, b| a.0 == b.0) {
            row.push(own[0].0 as usize, own.iter().map(|(_, exchange)| exchange).sum());
        }
        row.shrink();
        row
    }

    /// The exchange of two surfaces; 0 of those that exchange nothing.
    pub(super) fn of(&self, i: usize, j: usize) -> f64 {
        let (row, column) = (i.min(j), i.max(j));
        self.rows[row].of(column, row, self.rows.len()).unwrap_or(0.0)
    }

    /// The exchanges of a surface that are stored, by the others ascending.
    pub(super) fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> {
        let before = self.rows[..i].iter().enumerate();
        let before = before.filter_map(move |(row, own)| Some((row, own.of(i, row, self.rows.len())?)));
        before.chain(self.rows[i].iter())
    }

    /// All rows as [`Exchanges::row`], one after the other, which takes less than each by itself.
    pub(super) fn rows(&self) -> impl Iterator<Item = Vec<(usize, f64)>> + Clone {
        let mut next = vec![0; self.rows.len()];
        (0..self.rows.len()).map(move |i| {
            let mut row: Vec<(usize, f64)> = Vec::new();
            for (k, (own, next)) in self.rows[..i].iter().zip(&mut next).enumerate() {
                while own.at(*next).is_some_and(|(column, _)| column < i) {
                    *next += 1;
                }
                row.extend(
                    own.at(*next).filter(|(column, _)| *column == i).map(|(_, exchange)| (k, exchange)),
                );
            }
            row.extend(self.rows[i].iter());
            row
        })
    }

    /// Folds the exchanges of each surface with `add`, one after the other, from `start` on.
    fn folded(&self, start: f64, add: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let mut all = vec![start; self.rows.len()];
        for (i, row) in self.rows.iter().enumerate() {
            for (j, exchange) in row.iter() {
                all[i] = add(all[i], exchange);
                if i != j {
                    all[j] = add(all[j], exchange);
                }
            }
        }
        all
    }

    /// Σ_j A_i F_ij of each surface (length²).
    pub(super) fn sums(&self) -> Vec<f64> {
        self.folded(0.0, |sum, exchange| sum + exchange)
    }

    /// The largest exchange of each surface (length²).
    pub(super) fn largest(&self) -> Vec<f64> {
        self.folded(0.0, f64::max)
    }
}
