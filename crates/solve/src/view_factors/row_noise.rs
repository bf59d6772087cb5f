//! Errors of rows of view factors that rays leave, from the two halves of the rays.
//!
//! With x the exchange of surfaces i and j by either half of the rays, n rays of a surface of area A,
//!
//! ```text
//! e_ij = (x_even − x_odd)/2 ,    v_ij = x/(n_i/A_i + n_j/A_j) ,
//! ```
//!
//! v the variance of x if hits were independent. Spread evenly, rays are better than that, in every row by another
//! factor; a row of few factors tells it badly, and takes part in that of all rows, r̄ = Σ e²/A² / Σ v/A², as if
//! [`ADDED`] more of its largest factors had shown it:
//!
//! ```text
//! r_i = (Σ_j e² + ADDED r̄ max v)/(Σ_j v + ADDED max v) ,   σ_i = √(r_i max v)/A_i ,
//! error_i = MOST_OF √(2 ln(1 + m)) σ_i ,   m = Σ v/max v ,
//! ```
//!
//! about the largest of m errors of that deviation (normal distribution). To its square is added that of 1/(e n) for
//! the n rays of the surface, of which all may miss a part f of what it sees, with the probability (1 − f)ⁿ.

use std::iter::Peekable;

use radiosity_elements::{Element, Elements};
use radiosity_kernel::{Blocks, PlacedBlock};
use radiosity_transport::{Rays, SampledTransport};

/// Factors of the mean kind that a row is taken to have beside its own. Chosen.
const ADDED: f64 = 4.0;

/// The largest of m normal numbers over √(2 ln(1 + m)), on the average: 0.7 for one, 0.9 for a hundred.
pub(super) const MOST_OF: f64 = 0.9;

/// Part of what a surface sees that its rays miss, times their number: f (1 − f)ⁿ ≤ 1/(e n).
const MISSED: f64 = 0.37;

/// Variances of the exchanges of each surface that rays found.
#[derive(Clone, Debug)]
pub(super) struct RowNoise {
    rows: Vec<RowVariance>,
}

/// Sums over the exchanges of a surface (length⁴).
#[derive(Clone, Copy, Debug, Default)]
struct RowVariance {
    /// Σ e².
    squares: f64,
    /// Σ v.
    variances: f64,
    /// max v.
    largest: f64,
    /// Number of rays that the surface sent.
    rays: u64,
}

/// Exchange of two surfaces, by the halves of the rays.
#[derive(Clone, Copy, Debug)]
struct Exchange {
    surface: usize,
    difference: f64,
    variance: f64,
}

impl RowNoise {
    /// The noise of the rays that were sent.
    pub(super) fn of(transport: &SampledTransport, elements: &Elements) -> Self {
        let list = elements.list();
        let surfaces = list.iter().map(|element| element.surface + 1).max().unwrap_or(0);
        let mut noise = Self { rows: vec![RowVariance::default(); surfaces] };
        for (element, rays) in list.iter().zip(transport.sent()) {
            noise.rows[element.surface].rays += rays;
        }
        let density = |element: usize| transport.sent()[element] as f64 / list[element].area;
        let [even, odd] = [Rays::Even, Rays::Odd].map(|rays| transport.blocks(rays));
        let [even, odd] = [&even, &odd].map(Blocks::gathered);
        let [even, odd] = [&even, &odd].map(|blocks| by_rays(blocks, transport, list).peekable());
        let mut row = None;
        let mut exchanges: Vec<Exchange> = Vec::new();
        for Halves { pair: [a, b], by } in (Merged { even, odd }) {
            if row != Some(list[a].surface) {
                noise.take(row, &mut exchanges);
                row = Some(list[a].surface);
            }
            exchanges.push(Exchange {
                surface: list[b].surface,
                difference: 0.5 * (by[0] - by[1]),
                variance: 0.5 * (by[0] + by[1]) / (density(a) + density(b)),
            });
        }
        noise.take(row, &mut exchanges);
        noise
    }

    /// Takes what the elements of a surface exchange with those after them, sums it up by surfaces, and forgets it.
    fn take(&mut self, surface: Option<usize>, exchanges: &mut Vec<Exchange>) {
        exchanges.sort_by_key(|exchange| exchange.surface);
        for own in exchanges.chunk_by(|a, b| a.surface == b.surface) {
            let difference: f64 = own.iter().map(|exchange| exchange.difference).sum();
            let variance: f64 = own.iter().map(|exchange| exchange.variance).sum();
            let ends = [surface, Some(own[0].surface).filter(|other| surface != Some(*other))];
            for end in ends.into_iter().flatten() {
                let row = &mut self.rows[end];
                row.squares += difference * difference;
                row.variances += variance;
                row.largest = row.largest.max(variance);
            }
        }
        exchanges.clear();
    }

    /// About the largest error that rays leave in the factors of each surface of these areas.
    pub(super) fn errors(&self, areas: &[f64]) -> Vec<f64> {
        let sum = |of: &dyn Fn(&RowVariance) -> f64| -> f64 {
            self.rows.iter().zip(areas).map(|(row, area)| of(row) / (area * area)).sum()
        };
        let [squares, variances] = [sum(&|row| row.squares), sum(&|row| row.variances)];
        let mean = if variances > 0.0 { squares / variances } else { 0.0 };
        self.rows.iter().zip(areas).map(|(row, area)| (row.error(mean) / area).hypot(row.missed())).collect()
    }
}

impl RowVariance {
    /// About the largest factor that all rays miss.
    fn missed(&self) -> f64 {
        if self.rays == 0 { 0.0 } else { MISSED / self.rays as f64 }
    }

    /// About the largest error of an exchange (length²), where errors² are `mean` of v in all rows.
    fn error(&self, mean: f64) -> f64 {
        let Self { squares, variances, largest, .. } = *self;
        if largest <= 0.0 {
            return 0.0;
        }
        let ratio = (squares + ADDED * mean * largest) / (variances + ADDED * largest);
        MOST_OF * (2.0 * (variances / largest).ln_1p() * ratio * largest).sqrt()
    }
}

/// Exchange of two elements (length²), by the even and by the odd rays.
struct Halves {
    pair: [usize; 2],
    by: [f64; 2],
}

/// Exchange of two elements by some of the rays (length²).
struct Half {
    pair: [usize; 2],
    exchange: f64,
}

/// The exchanges of pairs that rays carry, in ascending order.
fn by_rays<'a>(
    blocks: &'a Blocks,
    transport: &'a SampledTransport,
    list: &'a [Element],
) -> impl Iterator<Item = Half> + 'a {
    let half = |PlacedBlock { row, column, values }: PlacedBlock<'_>| Half {
        pair: [row, column],
        exchange: values[0] * (list[row].area * list[column].area).sqrt(),
    };
    blocks.iter().map(half).filter(|half| transport.is_by_rays(half.pair))
}

/// Both halves side by side; a pair that one half has not met exchanges nothing by it.
struct Merged<I: Iterator<Item = Half>> {
    even: Peekable<I>,
    odd: Peekable<I>,
}

impl<I: Iterator<Item = Half>> Iterator for Merged<I> {
    type Item = Halves;

    fn next(&mut self) -> Option<Halves> {
        let [even, odd] = [self.even.peek(), self.odd.peek()].map(|half| half.map(|half| half.pair));
        let pair = even.into_iter().chain(odd).min()?;
        let by = [&mut self.even, &mut self.odd]
            .map(|half| half.next_if(|own| own.pair == pair).map_or(0.0, |own| own.exchange));
        Some(Halves { pair, by })
    }
}
