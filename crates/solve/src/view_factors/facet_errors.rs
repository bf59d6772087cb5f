//! Errors of rows of view factors whose pairs segments have told apart.
//!
//! With e² and e⁴ the means of the square and of the fourth power of errors of the exchanges of surface i,
//!
//! ```text
//! m = (Σ e²)² / Σ e⁴ ,     error_i = MOST_OF √(2 ln(1 + m) Σ e⁴ / Σ e²) / A_i ,
//! ```
//!
//! about the largest of m normal errors as large as the largest ones. Pairs of which a part is hidden have their own
//! errors. Pairs that were taken to be seen or hidden wholly, and are not, err as those found tell that stand for them:
//! half of that by the row of these, half by all rows, as a row may have found none. To the square are added that of
//! points, which tell what nothing hides, and that of the largest part by which segments that agree may be wrong.

use radiosity_transport::{FacetTransport, MixedPair, RowPairs};

use super::row_noise::MOST_OF;

/// Part of what is missed that is told by the own row of a surface. Chosen.
const BY_OWN_ROW: f64 = 0.5;

/// Sums of the errors of each surface.
#[derive(Clone, Debug)]
pub(super) struct FacetErrors {
    rows: Vec<Powers>,
    agreed: Vec<Agreed>,
}

/// Errors of pairs whose segments agree, at the most.
#[derive(Clone, Copy, Debug, Default)]
struct Agreed {
    /// The largest of them (length²).
    largest: f64,
    /// The sum of their squares (length⁴).
    square: f64,
}

impl Agreed {
    fn take(&mut self, error: f64) {
        self.largest = self.largest.max(error);
        self.square += error * error;
    }
}

/// Sums of squares and of fourth powers (length⁴, length⁸).
#[derive(Clone, Copy, Debug, Default)]
struct Powers {
    square: f64,
    fourth: f64,
}

impl Powers {
    fn add(&mut self, other: Self, factor: f64) {
        self.square += factor * other.square;
        self.fourth += factor * other.fourth;
    }

    /// Powers of the pairs that one of a known part stands for, which the `first` segments missed.
    fn missed(pair: &MixedPair, first: u64) -> Self {
        let (v, first) = (f64::from(pair.part), first as i32);
        if v <= 0.0 || v >= 1.0 {
            return Self::default();
        }
        let [seen, hidden] = [v, 1.0 - v].map(|part| part.powi(first));
        let known = (1.0 - seen - hidden).max(f64::MIN_POSITIVE);
        let mean = |power: i32| {
            pair.whole.powi(power) * (seen * (1.0 - v).powi(power) + hidden * v.powi(power)) / known
        };
        Self { square: mean(2), fourth: mean(4) }
    }

    /// Powers of the error of a pair.
    fn known(pair: &MixedPair) -> Self {
        let square = pair.whole * pair.whole * f64::from(pair.variance);
        Self { square, fourth: 3.0 * square * square }
    }
}

impl FacetErrors {
    /// The errors of these rows of pairs, about which so many segments decided first.
    pub(super) fn of(rows: &[RowPairs], first: u64) -> Self {
        let nothing = || vec![Powers::default(); rows.len()];
        let (mut sums, mut missed, mut sizes) = (nothing(), nothing(), nothing());
        let mut agreed = vec![Agreed::default(); rows.len()];
        let unknown = 1.0 / (first as f64 + 2.0);
        for (row, pairs) in rows.iter().enumerate() {
            for (column, pair) in pairs.mixed() {
                if pair.part <= 0.0 || pair.part >= 1.0 {
                    let error = pair.whole * f64::from(pair.variance).sqrt();
                    [row, column].iter().for_each(|end| agreed[*end].take(error));
                    continue;
                }
                for end in [row, column] {
                    sums[end].add(Powers::known(pair), 1.0);
                    missed[end].add(Powers::missed(pair, first), 1.0);
                }
            }
            for (column, exchange) in pairs.decided() {
                [row, column].iter().for_each(|end| agreed[*end].take(exchange * unknown));
            }
            for (column, exchange) in pairs.iter() {
                let square = exchange * exchange;
                [row, column]
                    .iter()
                    .for_each(|end| sizes[*end].add(Powers { square, fourth: square * square }, 1.0));
            }
        }
        let all = |list: &[Powers]| {
            list.iter().fold(Powers::default(), |mut all, own| {
                all.add(*own, 1.0);
                all
            })
        };
        let (found, whole) = (all(&missed), all(&sizes));
        let part =
            |found: f64, whole: f64| if whole > 0.0 { (1.0 - BY_OWN_ROW) * found / whole } else { 0.0 };
        let [squares, fourths] = [part(found.square, whole.square), part(found.fourth, whole.fourth)];
        for ((sum, missed), size) in sums.iter_mut().zip(&missed).zip(&sizes) {
            sum.add(*missed, BY_OWN_ROW);
            sum.add(Powers { square: squares * size.square, fourth: fourths * size.fourth }, 1.0);
        }
        Self { rows: sums, agreed }
    }

    /// About the largest error of a factor of each surface of these areas, whose largest exchanges these are.
    pub(super) fn largest(&self, areas: &[f64], exchanges: &[f64]) -> Vec<f64> {
        let error = |row: usize| {
            let known = largest(&self.rows[row]).hypot(self.agreed[row].largest);
            let by_points = FacetTransport::error_of_points() * exchanges[row];
            (known.hypot(by_points) / areas[row]).max(f64::EPSILON)
        };
        (0..areas.len()).map(error).collect()
    }

    /// About the largest error of the row sums of surfaces of these areas.
    pub(super) fn of_sums(&self, areas: &[f64]) -> f64 {
        let error = |row: usize| (self.rows[row].square + self.agreed[row].square).sqrt() / areas[row];
        let largest = (0..areas.len()).map(error).fold(0.0, f64::max);
        largest.hypot(FacetTransport::error_of_points())
    }
}

/// About the largest of errors of these sums (length²).
fn largest(Powers { square, fourth }: &Powers) -> f64 {
    if *fourth <= 0.0 {
        return 0.0;
    }
    let count = square * square / fourth;
    MOST_OF * (2.0 * count.ln_1p() * fourth / square).sqrt()
}
