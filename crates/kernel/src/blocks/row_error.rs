//! Errors of what one element exchanges with all, for numbers between constants.

/// Errors of what one element exchanges with all. Both are 0 where closed forms carry all of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RowError {
    /// Sum of the squares of errors of exchanges that rules or rays know (length⁴).
    pub squares: f64,
    /// Sum of what rules exchange that tell no errors, each times the accuracy asked of it (length²).
    pub asked: f64,
}

impl RowError {
    /// Takes the exchange of one block: the error that is known of it and what was asked of it (length²).
    pub fn take(&mut self, known: f64, asked: f64) {
        self.squares += known * known;
        self.asked += asked;
    }
}
