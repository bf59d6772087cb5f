//! Sums over hits, by pairs of elements.
//!
//! ```text
//! S_ij^kl = Σ w φ_k(x) φ_l(y) over the rays i → j and j → i, x on i and y on j ,
//! ```
//!
//! for i ≤ j, the two halves of the rays apart. A ray from an element to itself counts in both directions.

use std::collections::HashSet;

use radiosity_core::dot;
use radiosity_elements::Element;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;
use smallvec::{SmallVec, smallvec};

use crate::sampled::hit::Hit;

/// Hits for each entry of a block from which all of its entries are counted. In a classroom and a soda shop,
/// values of 0, 1 and 4 made no difference to the light at points beyond a fiftieth of its error.
const HITS_PER_ENTRY: f64 = 1.0;

/// Values of the functions of an element at a point; of up to order 7 without an allocation.
pub(super) type Values = SmallVec<[f64; 36]>;

/// Sums over hits, by pairs of elements.
///
/// Of pairs with few hits only the entries that are constant on one side are kept, S_ij^0l and S_ij^k0: what
/// varies on both sides is noise there, and it meets the small high coefficients of what is sent.
#[derive(Debug)]
pub(super) struct Tally {
    rows: Vec<Row>,
    /// The pairs of which all entries are counted; none as long as that holds of all.
    full: Option<HashSet<(u32, u32)>>,
}

/// The pairs of one element with itself and with those after it.
#[derive(Clone, Debug, Default)]
struct Row {
    pairs: Vec<Pair>,
    /// The sums of each pair, of one half of the rays, then of the other: row-major, or the first line and
    /// the rest of the first column. Single precision is far below the noise.
    sums: Vec<f32>,
}

/// A pair of a row, and where its sums stand.
#[derive(Clone, Copy, Debug)]
struct Pair {
    column: u32,
    /// Rays that went either way, less those that were taken back.
    hits: i32,
    is_cross: bool,
    /// Where its sums start.
    start: usize,
}

/// Sums over the rays of one pair.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sums<'a> {
    /// The element that comes first.
    pub row: usize,
    /// The other one.
    pub column: usize,
    /// Rays that went either way.
    pub hits: i32,
    /// Whether only the first line and the rest of the first column are known.
    pub is_cross: bool,
    /// S of the one and of the other half of the rays, row-major, or as told by `is_cross`.
    pub halves: [&'a [f32]; 2],
}

impl Sums<'_> {
    /// The sums of a pair on which no ray landed.
    pub(super) fn nothing(row: usize, column: usize) -> Self {
        Self { row, column, hits: 0, is_cross: false, halves: [&[], &[]] }
    }

    /// Its two elements.
    pub(super) fn pair(&self) -> (u32, u32) {
        (self.row as u32, self.column as u32)
    }

    /// Where the entry (k, 0) stands among the sums of a half, of a block of so many columns.
    pub(super) fn place(&self, k: usize, columns: usize) -> usize {
        if self.is_cross && k > 0 { columns + k - 1 } else { k * columns }
    }
}

impl Tally {
    /// A tally without hits, between so many elements.
    pub(super) fn new(elements: usize) -> Self {
        Self { rows: vec![Row::default(); elements], full: None }
    }

    /// Adds `hits`, and takes back those of negative weight; the sums are the same however they are spread
    /// over calls, but for rounding. A pair of which all hits were taken back is forgotten.
    pub(super) fn take(&mut self, list: &[Element], hits: &[Hit]) {
        let sorted = |(place, hit): (usize, &Hit)| SortedHit { pair: key(hit), place: place as u32 };
        let mut order: Vec<SortedHit> = hits.par_iter().enumerate().map(sorted).collect();
        order.par_sort_unstable();
        let of_rows: Vec<&[SortedHit]> = order.chunk_by(|a, b| a.row() == b.row()).collect();
        let mut fresh: Vec<Option<Row>> = vec![None; self.rows.len()];
        let made: Vec<(usize, Row)> = of_rows
            .par_iter()
            .map(|own| {
                check_interrupt();
                let row = own[0].row();
                (row, Row::of(list, row, own, hits, &|column| self.is_cross(list, row, column)))
            })
            .collect();
        made.into_iter().for_each(|(row, made)| fresh[row] = Some(made));
        self.rows.par_iter_mut().zip(fresh).for_each(|(row, fresh)| {
            if let Some(fresh) = fresh {
                *row = row.with(&fresh);
            }
        });
    }

    /// Forgets all hits, and from now on counts all entries only of pairs of which enough are `expected`.
    pub(super) fn settle(&mut self, list: &[Element], expected: &dyn Fn(&Sums) -> f64) {
        let enough = |sums: &Sums| {
            check_interrupt();
            let entries = list[sums.row].basis.len() * list[sums.column].basis.len();
            expected(sums) >= HITS_PER_ENTRY * entries as f64
        };
        let full = self.iter().filter(enough).map(|sums| (sums.row as u32, sums.column as u32)).collect();
        *self = Self { full: Some(full), ..Self::new(self.rows.len()) };
    }

    /// Whether only a cross of the block of a pair is counted.
    fn is_cross(&self, list: &[Element], row: usize, column: usize) -> bool {
        let is_small = [row, column].iter().any(|index| list[*index].basis.len() == 1);
        let full = |full: &HashSet<(u32, u32)>| full.contains(&(row as u32, column as u32));
        row != column && !is_small && self.full.as_ref().is_some_and(|set| !full(set))
    }

    /// Number of pairs between which a ray went.
    pub(super) fn len(&self) -> usize {
        self.rows.iter().map(|row| row.pairs.len()).sum()
    }

    /// The sums of all pairs between which a ray went, by rows and columns ascending.
    pub(super) fn iter(&self) -> impl Iterator<Item = Sums<'_>> {
        self.rows.iter().enumerate().flat_map(|(index, row)| {
            row.pairs.iter().enumerate().map(move |(place, pair)| {
                let (even, odd) = row.sums_of(place).split_at(row.sums_of(place).len() / 2);
                Sums {
                    row: index,
                    column: pair.column as usize,
                    hits: pair.hits,
                    is_cross: pair.is_cross,
                    halves: [even, odd],
                }
            })
        })
    }
}

/// A hit, in the order of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct SortedHit {
    /// The pair ([`key`]).
    pair: u64,
    /// Where the hit stands among those that were sorted.
    place: u32,
}

impl SortedHit {
    /// The element of its pair that comes first.
    fn row(&self) -> usize {
        (self.pair >> 32) as usize
    }

    /// The other element of its pair.
    fn column(&self) -> u32 {
        self.pair as u32
    }
}

/// The pair of a hit: the element that comes first in the upper half.
fn key(hit: &Hit) -> u64 {
    let (row, column) = hit.pair();
    u64::from(row) << 32 | u64::from(column)
}

impl Row {
    /// The sums over `hits` in `order`, all of them of element `row` and those after it.
    fn of(
        list: &[Element],
        row: usize,
        order: &[SortedHit],
        hits: &[Hit],
        is_cross: &dyn Fn(usize) -> bool,
    ) -> Self {
        let mut made = Self::default();
        let mut sums = Vec::new();
        for own in order.chunk_by(|a, b| a.pair == b.pair) {
            let column = own[0].column();
            let is_cross = is_cross(column as usize);
            let [rows, columns] = [row, column as usize].map(|index| list[index].basis.len());
            let size = if is_cross { rows + columns - 1 } else { rows * columns };
            let start = made.sums.len();
            sums.clear();
            sums.resize(2 * size, 0.0);
            let count = own.iter().map(|sorted| hits[sorted.place as usize].count()).sum();
            made.pairs.push(Pair { column, hits: count, is_cross, start });
            for sorted in own {
                let hit = &hits[sorted.place as usize];
                let sums = &mut sums[hit.half as usize * size..][..size];
                add(list, [row, column as usize], hit, is_cross, sums);
            }
            made.sums.extend(sums.iter().map(|sum| *sum as f32));
        }
        made
    }

    fn sums_of(&self, place: usize) -> &[f32] {
        let end = self.pairs.get(place + 1).map_or(self.sums.len(), |next| next.start);
        &self.sums[self.pairs[place].start..end]
    }

    /// The sums of both.
    fn with(&self, other: &Self) -> Self {
        let mut both = Self {
            pairs: Vec::with_capacity(self.pairs.len().max(other.pairs.len())),
            sums: Vec::with_capacity(self.sums.len().max(other.sums.len())),
        };
        let (mut i, mut j) = (0, 0);
        while i < self.pairs.len() || j < other.pairs.len() {
            let column = |row: &Self, place: usize| row.pairs.get(place).map_or(u32::MAX, |pair| pair.column);
            let next = column(self, i).min(column(other, j));
            let start = both.sums.len();
            let (mut hits, mut is_cross) = (0, false);
            for (row, place) in [(self, &mut i), (other, &mut j)] {
                if column(row, *place) != next {
                    continue;
                }
                hits += row.pairs[*place].hits;
                is_cross = row.pairs[*place].is_cross;
                if both.sums.len() == start {
                    both.sums.extend_from_slice(row.sums_of(*place));
                } else {
                    let sums = both.sums[start..].iter_mut().zip(row.sums_of(*place));
                    sums.for_each(|(sum, more)| *sum += more);
                }
                *place += 1;
            }
            match hits {
                0 => both.sums.truncate(start),
                _ => both.pairs.push(Pair { column: next, hits, is_cross, start }),
            }
        }
        both
    }
}

/// Adds w φ_k(x) φ_l(y) of one hit to the sums of elements `row` and `column`.
fn add(list: &[Element], [row, column]: [usize; 2], hit: &Hit, is_cross: bool, sums: &mut [f64]) {
    let ends = if hit.source as usize == row { [hit.from, hit.to] } else { [hit.to, hit.from] };
    let [x, y] = [functions(&list[row], ends[0]), functions(&list[column], ends[1])];
    if is_cross {
        let (line, rest) = sums.split_at_mut(y.len());
        line.iter_mut().zip(&y).for_each(|(sum, y)| *sum += hit.weight * x[0] * y);
        rest.iter_mut().zip(&x[1..]).for_each(|(sum, x)| *sum += hit.weight * x * y[0]);
        return;
    }
    let mut line = |x: &[f64], y: &[f64]| {
        for (sums, x) in sums.chunks_exact_mut(y.len()).zip(x) {
            sums.iter_mut().zip(y).for_each(|(sum, y)| *sum += hit.weight * x * y);
        }
    };
    line(&x, &y);
    if row == column {
        line(&y, &x);
    }
}

/// φ_k at the coordinates of an element's frame.
pub(super) fn functions(element: &Element, coordinates: [f64; 2]) -> Values {
    let count = element.basis.len();
    if count == 1 {
        return smallvec![element.area.sqrt().recip()];
    }
    let mut raw: Values = smallvec![0.0; count];
    element.basis.raw(coordinates, &mut raw);
    let mut values: Values = smallvec![0.0; count];
    // The transform is lower triangular.
    for (k, (value, row)) in values.iter_mut().zip(element.basis.transform().chunks_exact(count)).enumerate()
    {
        *value = dot(&row[..=k], &raw[..=k]);
    }
    values
}
