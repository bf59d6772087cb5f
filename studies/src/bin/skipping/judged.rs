//! The pairs that are judged, and what a converged run says is hidden of them.

use std::collections::HashMap;

use cpu_time::ProcessTime;
use radiosity::Work;
use radiosity::kernel::Accuracy;
use radiosity::transport;
use radiosity::visibility::{Shadows, Visibility};

use crate::naive;
use crate::subject::Subject;

/// Accuracy of what counts as exact where everything is planar, and elsewhere.
const EXACT: [f64; 2] = [1e-5, 3e-4];
/// Where most elements bend, or pairs are more than this, some are judged, by points of a sequence for each
/// pair of their patches.
const MOST_PAIRS: usize = 1 << 12;
/// About so many then.
const JUDGED: usize = 128;
const SCATTERED: usize = 1 << 19;
/// Part of a block that is hidden at least of a pair that counts as shaded then.
const SHADED: f64 = 1e-3;
/// An odd number whose multiples spread the pairs taken over all rows.
const SPREAD: usize = 0x9E37_79B1;
/// Runs shorter than this are repeated, and the shortest counts (s).
const SHORT: f64 = 0.5;
const REPEATS: usize = 3;

/// A pair of elements, receiver before emitter.
pub(crate) type Pair = (usize, usize);
/// Blocks of pairs.
pub(crate) type Table = HashMap<Pair, Vec<f64>>;

/// Some pairs of a scene, what reaches over each without shadows, and what of it is hidden.
pub(crate) struct Judged<'a> {
    pub(crate) subject: &'a Subject,
    /// Pairs for each one that is judged.
    pub(crate) every: usize,
    /// Whether all are, by the library itself.
    pub(crate) all: bool,
    /// Judged pairs that anything is hidden of, ascending.
    pub(crate) shaded: Vec<Pair>,
    open: Table,
    shades: Table,
    /// √Σ ‖G‖² over the shaded pairs.
    scale: f64,
}

/// Blocks with their shadows and what they took.
pub(crate) struct Found {
    blocks: Table,
    pub(crate) rays: u64,
    pub(crate) seconds: f64,
}

/// Whether a pair of n elements is one of the one in `every` that are taken, a power of two.
pub(crate) fn is_taken([i, j]: [usize; 2], n: usize, every: usize) -> bool {
    (i * n + j).wrapping_mul(SPREAD) >> 20 & (every - 1) == 0
}

impl<'a> Judged<'a> {
    pub(crate) fn of(subject: &'a Subject) -> Self {
        let n = subject.elements.list().len();
        let [mostly, planar] = subject.is_planar();
        let pairs = n * (n + 1) / 2;
        let all = mostly && pairs <= MOST_PAIRS;
        let every = if all { 1 } else { (pairs / JUDGED).next_power_of_two() };
        let exact = if planar { EXACT[0] } else { EXACT[1] };
        let mut judged = Self {
            subject,
            every,
            all,
            shaded: Vec::new(),
            open: Table::new(),
            shades: Table::new(),
            scale: 0.0,
        };
        judged.open = judged.assemble(Shadows::Off, Accuracy { eps: exact, shadow_eps: exact }).blocks;
        let least = if all { 10.0 * exact } else { SHADED };
        judged.shades = if all { judged.differences(exact) } else { judged.sums() };
        // What differs by more than the rules may: something is hidden.
        let is_shaded =
            |pair: &Pair| square(&judged.shades[pair]) > least.powi(2) * square(&judged.open[pair]);
        let mut shaded: Vec<Pair> = judged.open.keys().copied().filter(is_shaded).collect();
        shaded.sort_unstable();
        let left = |pair: &Pair| square(&difference(&judged.open[pair], &judged.shades[pair]));
        judged.scale = shaded.iter().map(left).sum::<f64>().sqrt();
        judged.shaded = shaded;
        judged
    }

    /// The shadows of all pairs, by what the library leaves of them.
    fn differences(&self, exact: f64) -> Table {
        let found = self.assemble(Shadows::Auto, Accuracy { eps: exact, shadow_eps: exact }).blocks;
        self.open.keys().map(|pair| (*pair, shade(&self.open[pair], found.get(pair)))).collect()
    }

    /// The shadows of all pairs, each summed by itself.
    fn sums(&self) -> Table {
        let list = self.subject.elements.list();
        let visibility = Visibility::new(&self.subject.scene, Shadows::Rays, SHADED);
        let shade = |pair: &Pair| naive::scattered([&list[pair.0], &list[pair.1]], &visibility, SCATTERED);
        self.open.keys().map(|pair| (*pair, shade(pair))).collect()
    }

    /// The blocks of all pairs that are judged, as the library makes them to this accuracy.
    pub(crate) fn blocks(&self, hiding: Shadows, accuracy: Accuracy) -> Found {
        let mut found = self.assemble(hiding, accuracy);
        for _ in 1..if found.seconds < SHORT { REPEATS } else { 1 } {
            found.seconds = found.seconds.min(self.assemble(hiding, accuracy).seconds);
        }
        found
    }

    fn assemble(&self, hiding: Shadows, accuracy: Accuracy) -> Found {
        let Subject { scene, elements, .. } = self.subject;
        let visibility = Visibility::new(scene, hiding, accuracy.shadow_eps);
        let list = elements.list();
        let is_apart = |i: usize, j: usize| !list[i].bounds().overlaps(&list[j].bounds());
        let wanted =
            |i: usize, j: usize| is_taken([i, j], list.len(), self.every) && (self.all || is_apart(i, j));
        let start = ProcessTime::now();
        let blocks = transport::assemble(
            transport::Demand::all(elements, &visibility, accuracy).of(&wanted),
            None,
            &Work::alone(),
        );
        let seconds = start.elapsed().as_secs_f64();
        let rays = blocks.statistics.rays;
        Found {
            blocks: blocks.iter().map(|block| ((block.row, block.column), block.values.to_vec())).collect(),
            rays,
            seconds,
        }
    }

    /// Relative error of the shadows of blocks, whose kernel was integrated as that of `open`.
    pub(crate) fn error(&self, found: &Found, open: &Found) -> f64 {
        self.error_of(|pair| {
            let none = || vec![0.0; self.shades[pair].len()];
            open.blocks.get(pair).map_or_else(none, |open| shade(open, found.blocks.get(pair)))
        })
    }

    /// Relative error of other shadows.
    pub(crate) fn error_of(&self, other: impl Fn(&Pair) -> Vec<f64>) -> f64 {
        let missed = |pair: &Pair| square(&difference(&other(pair), &self.shades[pair]));
        self.shaded.iter().map(missed).sum::<f64>().sqrt() / self.scale
    }
}

/// S = G⁰ − G of a pair; no block is a block of zeros.
fn shade(open: &[f64], found: Option<&Vec<f64>>) -> Vec<f64> {
    found.map_or_else(|| open.to_vec(), |found| difference(open, found))
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn square(block: &[f64]) -> f64 {
    block.iter().map(|x| x * x).sum()
}
