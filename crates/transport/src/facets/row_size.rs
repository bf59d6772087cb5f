//! The size of the row of a facet.

/// The row of a facet as the first segments find it (length²).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RowSize {
    /// Its largest exchange.
    pub largest: f64,
    /// The sum of all of them.
    pub sum: f64,
}

impl RowSize {
    /// Takes an exchange of the row.
    pub(super) fn take(&mut self, exchange: f64) {
        self.largest = self.largest.max(exchange);
        self.sum += exchange;
    }
}
