//! The geometry of transport: blocks G between elements, each unordered pair once.
//!
//! ```text
//! G_ij^kl = ∫∫ φ_k(x) φ_l(y) κ(x, y) V(x, y) dA_x dA_y ,     G_ji = G_ijᵀ .
//! ```
//!
//! Reflectance enters afterwards, per band. G has no scale: it is invariant under similarity. In a
//! closed scene G maps the coefficients c of the constant 1 to themselves, and ‖G‖ ≤ 1 always.

mod block;
mod chart;
mod clip;
mod curved;
mod edge;
mod edge_table;
mod facing;
mod horizon;
mod integrand;
mod moments;
mod own;
mod pair;
mod same;
mod seam;
mod separated;
mod touch;
mod vertex;

use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_geom::DVec3;
use rayon::prelude::*;
use serde::Serialize;

pub use block::{Accuracy, Kind};
pub use integrand::kernel;

use crate::elements::{Element, Elements};
use crate::visibility::Visibility;
use block::Block;

/// How many pairs of elements went which way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct PairCounts {
    /// Unordered pairs, curved elements with themselves included.
    pub total: usize,
    /// One lies behind the other.
    pub skipped_facing: usize,
    /// Both lie in one plane.
    pub skipped_coplanar: usize,
    /// One blocker hides one from the other.
    pub skipped_hidden: usize,
    /// Nothing that either sends can come back; none are skipped for this yet.
    pub skipped_black: usize,
    /// Equal to an earlier pair up to similarity; none are shared yet.
    pub repeated: usize,
    /// Curved elements with themselves.
    pub same: usize,
    /// Hardest contact: a common edge.
    pub edge: usize,
    /// Hardest contact: a common corner.
    pub vertex: usize,
    /// Cut so that edges of contact match.
    pub contact: usize,
    /// Near, therefore split.
    pub split: usize,
    /// Apart.
    pub separated: usize,
    /// Pairs in which visibility was sampled (counted above as well).
    pub partly_hidden: usize,
    /// Pairs with a near part left at the smallest size, accuracy unknown (counted above as well).
    pub unresolved: usize,
}

/// All blocks of G, one triangle, zero blocks left out.
#[derive(Debug)]
pub struct Blocks {
    starts: Vec<usize>,
    stored: Vec<Stored>,
    /// How many pairs went which way.
    pub pairs: PairCounts,
    /// Terms of the rules.
    pub samples: u64,
    /// Kernel evaluations: less than the terms where the kernel is known to repeat.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
    /// Estimate of the largest error that parts left unresolved make in a block, relative to the larger of the
    /// block's largest entry and a hundredth of its row's; zero where every part was resolved.
    pub accuracy_reached: f64,
}

/// The block of receiver `row` and emitter `column`, `row ≤ column`.
#[derive(Debug)]
struct Stored {
    row: usize,
    column: usize,
    values: Vec<f64>,
}

/// What became of a pair.
enum Outcome {
    Facing,
    Coplanar,
    Hidden,
    Integrated(Block),
}

impl Blocks {
    /// Integrates all pairs. `progress` hears (pairs done, pairs in all), from any thread.
    pub fn assemble(
        elements: &Elements,
        visibility: &Visibility,
        accuracy: Accuracy,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Self {
        let list = elements.list();
        let pairs: Vec<(usize, usize)> =
            (0..list.len()).flat_map(|i| (i..list.len()).map(move |j| (i, j))).collect();
        let (done, total) = (AtomicUsize::new(0), pairs.len());
        let outcomes: Vec<Outcome> = pairs
            .par_iter()
            .map(|(i, j)| {
                let outcome = integrate(&list[*i], &list[*j], i == j, visibility, accuracy);
                progress(done.fetch_add(1, Ordering::Relaxed) + 1, total);
                outcome
            })
            .collect();
        let mut blocks = Self {
            starts: starts(list),
            stored: Vec::new(),
            pairs: PairCounts::default(),
            samples: 0,
            distinct: 0,
            rays: 0,
            accuracy_reached: 0.0,
        };
        let mut errors = Vec::new();
        for ((row, column), outcome) in pairs.into_iter().zip(outcomes) {
            if let Outcome::Integrated(block) = &outcome {
                errors.push((row, column, block.error));
            }
            blocks.take(row, column, outcome);
        }
        blocks.accuracy_reached = blocks.largest_error(&errors);
        blocks
    }

    /// Number of coefficients.
    pub fn dim(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }

    /// Where the coefficients of each element start; one more entry, the dimension, at the end.
    pub fn starts(&self) -> &[usize] {
        &self.starts
    }

    /// y = G x.
    pub fn apply(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.dim()];
        for Stored { row, column, values } in &self.stored {
            let (rows, columns) = (self.range(*row), self.range(*column));
            for (k, line) in values.chunks_exact(columns.len()).enumerate() {
                y[rows.start + k] += line.iter().zip(&x[columns.clone()]).map(|(g, x)| g * x).sum::<f64>();
            }
            if row != column {
                for (k, line) in values.chunks_exact(columns.len()).enumerate() {
                    let emitted = x[rows.start + k];
                    y[columns.clone()].iter_mut().zip(line).for_each(|(y, g)| *y += g * emitted);
                }
            }
        }
        y
    }

    /// The nonzero blocks as (receiver, emitter, values row-major), receiver ≤ emitter; the transpose
    /// of each stands for the opposite direction.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, &[f64])> {
        self.stored.iter().map(|stored| (stored.row, stored.column, stored.values.as_slice()))
    }

    /// The largest of (row, column, absolute error) relative to the scale of its block.
    fn largest_error(&self, errors: &[(usize, usize, f64)]) -> f64 {
        let mut rows = vec![0.0f64; self.starts.len() - 1];
        let mut largest = HashMap::new();
        for Stored { row, column, values } in &self.stored {
            let most = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
            rows[*row] = rows[*row].max(most);
            rows[*column] = rows[*column].max(most);
            largest.insert((*row, *column), most);
        }
        let relative = |(row, column, error): &(usize, usize, f64)| {
            let block = largest.get(&(*row, *column)).copied().unwrap_or(0.0);
            let scale = block.max(1e-2 * rows[*row].max(rows[*column]));
            if *error > 0.0 { error / scale.max(f64::MIN_POSITIVE) } else { 0.0 }
        };
        errors.iter().map(relative).fold(0.0, f64::max)
    }

    fn range(&self, element: usize) -> std::ops::Range<usize> {
        self.starts[element]..self.starts[element + 1]
    }

    fn take(&mut self, row: usize, column: usize, outcome: Outcome) {
        self.pairs.total += 1;
        match outcome {
            Outcome::Coplanar if row == column => self.pairs.total -= 1,
            Outcome::Coplanar => self.pairs.skipped_coplanar += 1,
            Outcome::Facing => self.pairs.skipped_facing += 1,
            Outcome::Hidden => self.pairs.skipped_hidden += 1,
            Outcome::Integrated(block) => self.store(row, column, block),
        }
    }

    fn store(&mut self, row: usize, column: usize, block: Block) {
        let counter = match block.kind {
            Kind::Separated => &mut self.pairs.separated,
            Kind::Split => &mut self.pairs.split,
            Kind::Vertex => &mut self.pairs.vertex,
            Kind::Edge => &mut self.pairs.edge,
            Kind::Contact => &mut self.pairs.contact,
            Kind::Same => &mut self.pairs.same,
        };
        *counter += 1;
        self.pairs.partly_hidden += usize::from(block.partly_hidden);
        self.pairs.unresolved += usize::from(block.unresolved);
        self.samples += block.samples;
        self.distinct += block.distinct;
        self.rays += block.rays;
        if block.values.iter().any(|value| *value != 0.0) {
            self.stored.push(Stored { row, column, values: block.values });
        }
    }
}

fn starts(list: &[Element]) -> Vec<usize> {
    let mut starts = vec![0];
    for element in list {
        starts.push(starts[starts.len() - 1] + element.basis.len());
    }
    starts
}

fn integrate(
    receiver: &Element,
    emitter: &Element,
    same: bool,
    visibility: &Visibility,
    accuracy: Accuracy,
) -> Outcome {
    if let Some(outcome) = planes_exchange_nothing(receiver, emitter) {
        return outcome;
    }
    let surfaces = [receiver.surface, emitter.surface];
    let blockers = visibility.candidates(&receiver.hull, &emitter.hull, surfaces);
    if same {
        return Outcome::Integrated(curved::self_block(receiver, &blockers, visibility, accuracy));
    }
    if visibility.hidden(&blockers, &receiver.hull, &emitter.hull) {
        return Outcome::Hidden;
    }
    let flat = receiver.plane.is_some() && emitter.plane.is_some();
    let block = if flat { block::block } else { curved::block };
    Outcome::Integrated(block(receiver, emitter, &blockers, visibility, accuracy))
}

/// Whether the plane of either element leaves nothing of the other in front of it.
fn planes_exchange_nothing(receiver: &Element, emitter: &Element) -> Option<Outcome> {
    let tolerance = 1e-9 * receiver.bounds().union(emitter.bounds()).diagonal();
    let range = |plane: &(DVec3, DVec3), other: &Element| {
        let heights = other.hull.iter().map(|point| (point - plane.0).dot(plane.1));
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)))
    };
    for (plane, other) in [(&receiver.plane, emitter), (&emitter.plane, receiver)] {
        let Some(plane) = plane else { continue };
        let (low, high) = range(plane, other);
        if high <= tolerance {
            return Some(if low >= -tolerance { Outcome::Coplanar } else { Outcome::Facing });
        }
    }
    None
}
