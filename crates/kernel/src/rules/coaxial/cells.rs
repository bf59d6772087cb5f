//! Integral over the unit square on cells that are halved where two Gauss rules differ most.
//!
//! The difference of the rules of 12 and of 8 points, along either direction while the other has 12, tells the
//! error of a cell and the direction to halve it in. Toward a corner or a side where the integrand is not
//! smooth, the halves shrink geometrically, so that the error falls exponentially with the number of cells.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use radiosity_core::gauss::{Legendre, Rule};

/// Points of the rules.
const FINE: usize = 12;
const COARSE: usize = 8;

/// Cells along either direction at first, so that what is seen through a narrow gap is not missed.
const FIRST: usize = 4;

/// Most cells: a tenth of a second. Measured: two hundred reach 1e-12 of tubes with rings at their ends, five
/// hundred of tubes a millionth apart.
const MOST: usize = 1000;

/// Part of what is asked that is aimed at.
const AIMED: f64 = 0.1;

/// Error over the sum of the differences: at a corner where meridians touch, both rules may miss the same.
/// Measured in 160 random scenes: up to 5.6, of a disk beside a cone nearly as flat.
const MISSED: f64 = 6.0;

/// Error over the integral that no rule goes below, some hundred roundings.
const FINEST: f64 = 1e-14;

/// An integral by cells.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// The integral.
    pub value: f64,
    /// Twice the sum of the differences of the rules over all cells, and rounding.
    pub error: f64,
    /// Evaluations of the integrand.
    pub samples: u64,
    /// Number of cells.
    pub cells: usize,
}

/// The cells of the unit square, worst first.
pub(super) struct Cells {
    heap: BinaryHeap<Cell>,
}

/// A rectangle, with its integral and the differences of the rules along either direction.
#[derive(Clone, Copy, Debug)]
struct Cell {
    ranges: [[f64; 2]; 2],
    value: f64,
    differences: [f64; 2],
}

impl Cells {
    /// The integral of `integrand`, which is not negative, to the relative accuracy `eps` or by so many cells
    /// as there may be.
    pub(super) fn integral(eps: f64, integrand: impl Fn(f64, f64) -> f64) -> Found {
        let part = |k: usize| [k as f64 / FIRST as f64, (k + 1) as f64 / FIRST as f64];
        let first = (0..FIRST * FIRST).map(|k| Cell::of([part(k / FIRST), part(k % FIRST)], &integrand));
        let mut all = Self { heap: first.collect() };
        let aim = (AIMED * eps).max(FINEST);
        while all.heap.len() < MOST && all.error() > aim * all.value() {
            let Some(worst) = all.heap.pop() else { break };
            all.heap.extend(worst.halves().map(|ranges| Cell::of(ranges, &integrand)));
        }
        let cells = all.heap.len();
        let made = FIRST * FIRST + 2 * (cells - FIRST * FIRST);
        let samples = made * FINE * (FINE + 2 * COARSE);
        let value = all.value();
        Found { value, error: MISSED * all.error() + FINEST * value, samples: samples as u64, cells }
    }

    fn value(&self) -> f64 {
        self.heap.iter().map(|cell| cell.value).sum()
    }

    fn error(&self) -> f64 {
        self.heap.iter().map(Cell::error).sum()
    }
}

impl Cell {
    fn of(ranges: [[f64; 2]; 2], integrand: &impl Fn(f64, f64) -> f64) -> Self {
        let fine = sum(ranges, integrand, &Legendre::<FINE>::RULE, &Legendre::<FINE>::RULE);
        let along = sum(ranges, integrand, &Legendre::<COARSE>::RULE, &Legendre::<FINE>::RULE);
        let across = sum(ranges, integrand, &Legendre::<FINE>::RULE, &Legendre::<COARSE>::RULE);
        Self { ranges, value: fine, differences: [along, across].map(|other| (other - fine).abs()) }
    }

    fn error(&self) -> f64 {
        self.differences[0] + self.differences[1]
    }

    /// The ranges of its halves, across the direction of the larger difference.
    fn halves(&self) -> [[[f64; 2]; 2]; 2] {
        let across = usize::from(self.differences[1] > self.differences[0]);
        let [low, high] = self.ranges[across];
        let middle = 0.5 * (low + high);
        [[low, middle], [middle, high]].map(|half| {
            let mut ranges = self.ranges;
            ranges[across] = half;
            ranges
        })
    }
}

/// The integral over a rectangle by two rules.
fn sum<const N: usize, const M: usize>(
    [s, t]: [[f64; 2]; 2],
    integrand: &impl Fn(f64, f64) -> f64,
    first: &Rule<N>,
    second: &Rule<M>,
) -> f64 {
    let half = |[low, high]: [f64; 2]| 0.5 * (high - low);
    let at = |range: [f64; 2], node: f64| range[0] + half(range) * (1.0 + node);
    half(s) * half(t) * first.sum(|x| second.sum(|y| integrand(at(s, x), at(t, y))))
}

/// By error, then by place: the order is one and the same whatever the heap did before.
impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        let key = |cell: &Self| [cell.error(), cell.ranges[0][0], cell.ranges[1][0]];
        let mut orders = key(self).into_iter().zip(key(other)).map(|(a, b)| a.total_cmp(&b));
        orders.find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    }
}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cell {}
