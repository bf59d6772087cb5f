//! The exchanges of a surface with itself and with those after it.

use serde::{Deserialize, Serialize};

/// The exchanges of a surface with itself and with those after it that exchange anything.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct RowExchanges {
    /// The other surface of each pair, ascending.
    columns: Vec<u32>,
    /// A_i F_ij (length²).
    exchanges: Vec<f64>,
}

impl RowExchanges {
    /// Appends the exchange with a surface that comes after all others.
    pub fn push(&mut self, column: usize, exchange: f64) {
        self.columns.push(column as u32);
        self.exchanges.push(exchange);
    }

    /// Changes the exchange at a place.
    pub(crate) fn set(&mut self, place: usize, exchange: f64) {
        self.exchanges[place] = exchange;
    }

    /// Gives back memory that it has no need of.
    pub fn shrink(&mut self) {
        self.columns.shrink_to_fit();
        self.exchanges.shrink_to_fit();
    }

    /// Number of exchanges.
    pub(crate) fn count(&self) -> usize {
        self.columns.len()
    }

    /// The other surface of the pair at a place, and their exchange (length²).
    pub fn at(&self, place: usize) -> Option<(usize, f64)> {
        Some((*self.columns.get(place)? as usize, self.exchanges[place]))
    }

    /// The exchange with a surface, by its number, of a row of this number among so many (length²).
    pub fn of(&self, column: usize, row: usize, surfaces: usize) -> Option<f64> {
        // Columns ascend by one at the least.
        let least = (self.columns.len() + column).saturating_sub(surfaces);
        let most = (column - row + 1).min(self.columns.len());
        let own = self.columns.get(least..most)?;
        let place = own.binary_search(&(column as u32)).ok()?;
        Some(self.exchanges[least + place])
    }

    /// The other surfaces, and the exchanges (length²).
    pub fn iter(&self) -> impl Iterator<Item = (usize, f64)> {
        self.columns.iter().zip(&self.exchanges).map(|(column, exchange)| (*column as usize, *exchange))
    }
}
