//! All blocks by the rules of 1993, each ordered pair integrated by itself.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_elements::Elements;
use radiosity_kernel::Blocks;
use radiosity_kernel::contact::planes;
use radiosity_kernel::contact::planes::Planes;
use radiosity_kernel::{PairKind, blocks::block::Block};
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::{Stage, Work};
use rayon::prelude::*;

use crate::zatz1993::transfers::chart::{Chart, NoChart};
use crate::zatz1993::transfers::sum::Sees;
use crate::zatz1993::transfers::transfer::{PaperRules, transfer};

/// Outcome for an ordered pair: left out, or its block.
enum Outcome {
    Behind,
    Coplanar,
    Hidden,
    Integrated(Block),
}

/// Integrates each ordered pair with `extra` points per direction above the order, and converts the paper's K
/// to G, which is then not symmetric. Ordered pairs are told; those of the blocks count unordered.
///
/// # Errors
/// [`NoChart`]: a surface that is neither a parallelogram nor curved.
pub fn assemble(
    elements: &Elements,
    visibility: &Visibility,
    rules: PaperRules,
    extra: usize,
    work: &Work<'_>,
) -> Result<Blocks, NoChart> {
    let list = elements.list();
    let charts = list.iter().map(Chart::of).collect::<Result<Vec<_>, _>>()?;
    let pairs: Vec<(usize, usize)> =
        (0..list.len()).flat_map(|i| (0..list.len()).map(move |j| (i, j))).collect();
    let (done, total) = (AtomicUsize::new(0), pairs.len());
    let outcomes: Vec<Outcome> = pairs
        .par_iter()
        .map(|(i, j)| {
            check_interrupt();
            let outcome = integrate(&charts[*i], &charts[*j], i == j, visibility, rules, extra);
            work.report_done(Stage::Blocks, done.fetch_add(1, Ordering::Relaxed) + 1, total);
            outcome
        })
        .collect();
    let mut blocks = Blocks::empty(elements.starts(), false, work.ranks);
    for ((row, column), outcome) in pairs.into_iter().zip(outcomes) {
        if row <= column {
            count(&mut blocks, row == column, &outcome);
        }
        if let Outcome::Integrated(block) = outcome {
            blocks.statistics.take_costs(&block.report);
            blocks.push(row, column, &block.values);
        }
    }
    Ok(blocks)
}

fn count(blocks: &mut Blocks, same: bool, outcome: &Outcome) {
    let pairs = &mut blocks.statistics.pairs;
    pairs.total += usize::from(!same || matches!(outcome, Outcome::Integrated(_)));
    match outcome {
        Outcome::Coplanar => pairs.skipped_coplanar += usize::from(!same),
        Outcome::Behind => pairs.skipped_behind += 1,
        Outcome::Hidden => pairs.skipped_hidden += 1,
        Outcome::Integrated(block) => pairs.take(&block.report),
    }
}

fn integrate(
    receiver: &Chart,
    emitter: &Chart,
    same: bool,
    visibility: &Visibility,
    rules: PaperRules,
    extra: usize,
) -> Outcome {
    let (x, y) = (receiver.element, emitter.element);
    match planes::of(x, y) {
        Planes::Exchanging => {}
        Planes::Behind => return Outcome::Behind,
        Planes::Coplanar => return Outcome::Coplanar,
    }
    let blockers =
        if same { Vec::new() } else { visibility.candidates(&x.hull, &y.hull, [x.surface, y.surface]) };
    if visibility.hidden(&blockers, &x.hull, &y.hull) {
        return Outcome::Hidden;
    }
    let free = |x, y| visibility.free(&blockers, x, y);
    let sees: Option<Sees> = if blockers.is_empty() { None } else { Some(&free) };
    // One point more on one side, so that the points of an element with itself never coincide, where κ is
    // 0/0.
    let emitting = emitter.charted(extra + usize::from(same));
    let transfer = transfer(receiver.charted(extra), emitting, rules, sees);
    let kind = match (same, transfer.edge) {
        (true, _) => PairKind::Same,
        (false, true) => PairKind::Edge,
        (false, false) => PairKind::Separated,
    };
    let mut block = Block::exact(receiver.block(emitter, &transfer.values), kind, transfer.samples);
    (block.report.partly_hidden, block.report.rays) = (!blockers.is_empty(), transfer.rays);
    Outcome::Integrated(block)
}
