//! Errors of rows of view factors whose pairs segments have told apart.
//!
//! With the deviations e of the exchanges of surface i,
//!
//! ```text
//! m = (Σ e²)² / Σ e⁴ ,     error_i = MOST_OF √(2 ln(1 + m) Σ e⁴ / Σ e²) / A_i ,
//! ```
//!
//! about the largest of m normal errors as large as the largest ones. Pairs of which a part is hidden have their own
//! errors, and such as the first segments alone decide about stand for those that these took to be hidden wholly: half
//! of that by the row of these, half by all rows, as a row may have found none.
//!
//! Pairs between which something can stand, of exchange x, and of which n segments agree, may be hidden in part
//! nevertheless. With ρ such pairs that show it for each of which segments agree, and all parts as likely, that
//! is so with probability ρ/(n + 1) about, and the exchange then errs by more than t with (1 − t/x)ⁿ⁺¹ ≈
//! exp(−t/s), s = x/(n + 2). ρ is that of the row and of [`ADDED`] pairs more that are as those of all rows. Of
//! a row
//!
//! ```text
//! s̄² = Σ s⁴/(n + 1) / Σ s²/(n + 1) ,     W = ρ (Σ s²/(n + 1))² / Σ s⁴/(n + 1) ,
//! missed_i = s̄ ln(1 + W/RARE) / 3 A_i ,
//! ```
//!
//! a third of the error that one row among 1/RARE has. To the squares is added that of points, which tell what nothing
//! hides.

use radiosity_transport::{FacetExchanges, FacetTransport, MixedPair};

use super::row_noise::MOST_OF;

/// Part of what is missed that is told by the own row of a surface. Chosen.
const BY_OWN_ROW: f64 = 0.5;

/// Pairs of the mean kind that a row is taken to have beside its own. Chosen.
const ADDED: f64 = 16.0;

/// Rows that may err by more than three times what is told. Chosen.
const RARE: f64 = 0.01;

/// Most pairs of which a part is seen to be hidden for each of which segments agree: of no fewer segments than a pair
/// has at the least.
const MOST_MIXED: f64 = 8.0;

/// Errors of the rows of view factors.
#[derive(Clone, Debug)]
pub(super) struct FacetErrors {
    rows: Vec<RowErrors>,
}

/// Errors of the exchanges of a surface.
#[derive(Clone, Copy, Debug, Default)]
struct RowErrors {
    /// Errors of pairs of which a part is hidden.
    known: Powers,
    /// Errors of pairs that were taken to be hidden wholly, told by these.
    missed: Powers,
    /// Exchanges.
    sizes: Powers,
    /// Σ s²/(n + 1), Σ s⁴/(n + 1) over pairs whose segments agree.
    agreed: Powers,
    /// Number of pairs whose segments agree, and of those of which a part is hidden.
    agreeing: f64,
    mixed: f64,
}

/// Sums of squares and of fourth powers (length⁴, length⁸).
#[derive(Clone, Copy, Debug, Default)]
struct Powers {
    square: f64,
    fourth: f64,
}

impl Powers {
    /// Of one number (length²).
    fn of(number: f64) -> Self {
        let square = number * number;
        Self { square, fourth: square * square }
    }

    fn add(&mut self, other: Self, factor: f64) {
        self.square += factor * other.square;
        self.fourth += factor * other.fourth;
    }

    /// Powers of so many pairs that one of a known part stands for.
    fn missed(pair: &MixedPair, count: f64) -> Self {
        let mut missed = Self::default();
        missed.add(Self::of(f64::from(pair.part) * pair.whole), count);
        missed
    }

    /// Powers of the deviation of a pair.
    fn known(pair: &MixedPair) -> Self {
        Self::of(pair.whole * f64::from(pair.variance).sqrt())
    }

    /// About the largest of errors of these sums (length²).
    fn largest(&self) -> f64 {
        let Self { square, fourth } = self;
        if *fourth <= 0.0 {
            return 0.0;
        }
        let count = square * square / fourth;
        MOST_OF * (2.0 * count.ln_1p() * fourth / square).sqrt()
    }
}

impl RowErrors {
    /// Takes a pair that was looked at again, and stands for so many that were not.
    fn take(&mut self, pair: &MixedPair, missed: f64) {
        if pair.is_mixed() {
            self.mixed += 1.0;
            self.known.add(Powers::known(pair), 1.0);
            self.missed.add(Powers::missed(pair, missed), 1.0);
            return;
        }
        // s/x = 1/(n + 2).
        let scale = f64::from(pair.variance).sqrt();
        self.agreeing += 1.0;
        self.agreed.add(Powers::of(pair.whole * scale), scale / (1.0 - scale));
    }

    fn add(&mut self, other: &Self) {
        self.missed.add(other.missed, 1.0);
        self.sizes.add(other.sizes, 1.0);
        self.agreeing += other.agreeing;
        self.mixed += other.mixed;
    }

    /// Adds what is told by all rows.
    fn pool(&mut self, all: &Self) {
        let part =
            |found: f64, whole: f64| if whole > 0.0 { (1.0 - BY_OWN_ROW) * found / whole } else { 0.0 };
        let square = self.sizes.square * part(all.missed.square, all.sizes.square);
        let fourth = self.sizes.fourth * part(all.missed.fourth, all.sizes.fourth);
        self.known.add(self.missed, BY_OWN_ROW);
        self.known.add(Powers { square, fourth }, 1.0);
        let mixed = (self.mixed + ADDED * (all.mixed + 1.0) / (all.agreeing + 1.0)) / (self.agreeing + ADDED);
        let Powers { square, fourth } = self.agreed;
        let mixed = mixed.min(MOST_MIXED);
        self.agreed = Powers { square: mixed * square, fourth: mixed * fourth };
    }

    /// About the largest error of an exchange that segments that agree miss (length²).
    fn missed(&self) -> f64 {
        let Powers { square, fourth } = self.agreed;
        if fourth <= 0.0 {
            return 0.0;
        }
        (fourth / square).sqrt() * (square * square / fourth / RARE).ln_1p() / 3.0
    }
}

impl FacetErrors {
    /// The errors of these exchanges between surfaces of these areas.
    pub(super) fn of(exchanges: &FacetExchanges, areas: &[f64]) -> Self {
        let rows = &exchanges.rows;
        let mut found = vec![RowErrors::default(); rows.len()];
        for (row, pairs) in rows.iter().enumerate() {
            for (column, pair) in pairs.mixed() {
                let missed = exchanges.stands_for(pair, areas[row].min(areas[column]));
                [row, column].iter().for_each(|end| found[*end].take(pair, missed));
            }
            for (column, exchange) in pairs.exchanges.iter() {
                [row, column].iter().for_each(|end| found[*end].sizes.add(Powers::of(exchange), 1.0));
            }
        }
        let mut all = RowErrors::default();
        found.iter().for_each(|row| all.add(row));
        found.iter_mut().for_each(|row| row.pool(&all));
        Self { rows: found }
    }

    /// About the largest error of a factor of each surface of these areas, whose largest exchanges these are.
    pub(super) fn largest(&self, areas: &[f64], exchanges: &[f64]) -> Vec<f64> {
        let rows = self.rows.iter().zip(areas).zip(exchanges);
        let error = |((row, area), exchange): ((&RowErrors, &f64), &f64)| {
            let by_points = FacetTransport::error_of_points() * exchange;
            (row.known.largest().hypot(row.missed()).hypot(by_points) / area).max(f64::EPSILON)
        };
        rows.map(error).collect()
    }

    /// About the largest error of the row sums of surfaces of these areas.
    pub(super) fn of_sums(&self, areas: &[f64]) -> f64 {
        // E e² = 2 s² of an exponential law.
        let error =
            |(row, area): (&RowErrors, &f64)| (row.known.square + 2.0 * row.agreed.square).sqrt() / area;
        let largest = self.rows.iter().zip(areas).map(error).fold(0.0, f64::max);
        largest.hypot(FacetTransport::error_of_points())
    }
}
