//! The pairs that are judged, and what a converged run says is hidden of them.

use std::collections::HashMap;

use cpu_time::ProcessTime;
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::visibility::{Hiding, Visibility};

use crate::subject::Subject;

/// Accuracy of what counts as exact where everything is planar, and elsewhere.
const EXACT: [f64; 2] = [1e-5, 3e-4];
/// Where most elements bend, about so many pairs are judged.
const JUDGED: usize = 128;
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
    /// One pair in so many is judged.
    pub(crate) every: usize,
    /// Those that anything is hidden of, ascending.
    pub(crate) shaded: Vec<Pair>,
    open: Table,
    shades: Table,
    /// √Σ ‖G‖² over those.
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
        let every = if mostly { 1 } else { (n * (n + 1) / 2 / JUDGED).next_power_of_two() };
        let exact = if planar { EXACT[0] } else { EXACT[1] };
        let mut judged =
            Self { subject, every, shaded: Vec::new(), open: Table::new(), shades: Table::new(), scale: 0.0 };
        let found = judged.assemble(Hiding::Auto, [exact; 2]).blocks;
        judged.open = judged.assemble(Hiding::Off, [exact; 2]).blocks;
        judged.shades = judged.open.keys().map(|pair| (*pair, judged.shade(pair, &found))).collect();
        // What differs by more than the rules may: something is hidden.
        let is_shaded =
            |pair: &Pair| square(&judged.shades[pair]) > (10.0 * exact).powi(2) * square(&judged.open[pair]);
        let mut shaded: Vec<Pair> = judged.open.keys().copied().filter(is_shaded).collect();
        shaded.sort_unstable();
        let squares = shaded.iter().filter_map(|pair| found.get(pair)).map(|block| square(block));
        judged.scale = squares.sum::<f64>().sqrt();
        judged.shaded = shaded;
        judged
    }

    /// The blocks of all pairs that are judged, as the library makes them to `eps` and `shadow_eps`.
    pub(crate) fn blocks(&self, hiding: Hiding, accuracy: [f64; 2]) -> Found {
        let mut found = self.assemble(hiding, accuracy);
        for _ in 1..if found.seconds < SHORT { REPEATS } else { 1 } {
            found.seconds = found.seconds.min(self.assemble(hiding, accuracy).seconds);
        }
        found
    }

    fn assemble(&self, hiding: Hiding, [eps, shadow_eps]: [f64; 2]) -> Found {
        let Subject { scene, elements, .. } = self.subject;
        let accuracy = Accuracy { eps, shadow_eps };
        let visibility = Visibility::new(scene, hiding.shadows(accuracy.shadow_eps));
        let list = elements.list();
        let is_apart = |i: usize, j: usize| !list[i].bounds().overlaps(&list[j].bounds());
        let wanted = |i: usize, j: usize| {
            is_taken([i, j], list.len(), self.every) && (self.every == 1 || is_apart(i, j))
        };
        let start = ProcessTime::now();
        let blocks = Blocks::assemble_pairs(elements, &wanted, &visibility, accuracy, &|_, _| {});
        let seconds = start.elapsed().as_secs_f64();
        let rays = blocks.rays;
        Found {
            blocks: blocks.iter().map(|(i, j, values)| ((i, j), values.to_vec())).collect(),
            rays,
            seconds,
        }
    }

    /// S = G⁰ − G of a pair; no block is a block of zeros.
    fn shade(&self, pair: &Pair, found: &Table) -> Vec<f64> {
        let open = &self.open[pair];
        match found.get(pair) {
            None => open.clone(),
            Some(left) => open.iter().zip(left).map(|(g, v)| g - v).collect(),
        }
    }

    /// Relative error of the shadows of other blocks.
    pub(crate) fn error(&self, found: &Found) -> f64 {
        self.error_of(|pair| self.shade(pair, &found.blocks))
    }

    /// Relative error of other shadows.
    pub(crate) fn error_of(&self, other: impl Fn(&Pair) -> Vec<f64>) -> f64 {
        let missed = |pair: &Pair| {
            let difference: Vec<f64> =
                other(pair).iter().zip(&self.shades[pair]).map(|(a, b)| a - b).collect();
            square(&difference)
        };
        self.shaded.iter().map(missed).sum::<f64>().sqrt() / self.scale
    }
}

fn square(block: &[f64]) -> f64 {
    block.iter().map(|x| x * x).sum()
}
