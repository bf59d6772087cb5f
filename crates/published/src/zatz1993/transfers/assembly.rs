//! All blocks by the rules of 1993, each ordered pair integrated by itself.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_elements::Element;
use radiosity_kernel::contact::planes;
use radiosity_kernel::contact::planes::Planes;
use radiosity_kernel::{Blocks, PairKind, blocks::block::Block};
use radiosity_transport::Demand;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::{Stage, Work};
use rayon::prelude::*;

use super::piece::Piece;
use super::rules::PaperRules;
use super::sum::{Sees, Sum};
use super::transfer::{Rule, Tile};

/// An element with the pieces that cover it.
struct TiledElement<'a> {
    element: &'a Element,
    tiles: Vec<Tile<'a>>,
}

/// Outcome for an ordered pair: left out, or its block.
enum Outcome {
    Unwanted,
    Behind,
    Coplanar,
    Hidden,
    Integrated(Block),
}

/// The blocks of a demand, whose accuracies the rules ignore: each ordered pair integrated with `extra`
/// points per direction above the order. They are not symmetric. Ordered pairs are told; those of the blocks
/// count unordered.
pub fn assemble(demand: Demand<'_>, rules: PaperRules, extra: usize, work: &Work<'_>) -> Blocks {
    let Demand { elements, wanted, visibility, .. } = demand;
    let (list, rule) = (elements.list(), Rule { rules, extra });
    let tiled = |element| {
        check_interrupt();
        TiledElement { element, tiles: Piece::all(element).into_iter().map(|p| rule.tile(p)).collect() }
    };
    let tiled: Vec<TiledElement> = list.par_iter().map(tiled).collect();
    let pairs: Vec<(usize, usize)> =
        (0..list.len()).flat_map(|i| (0..list.len()).map(move |j| (i, j))).collect();
    let (done, total) = (AtomicUsize::new(0), pairs.len());
    let outcomes: Vec<Outcome> = pairs
        .par_iter()
        .map(|(i, j)| {
            check_interrupt();
            let outcome = match wanted(*i.min(j), *i.max(j)) {
                true => integrated(&tiled[*i], &tiled[*j], i == j, visibility, rule),
                false => Outcome::Unwanted,
            };
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
    blocks
}

fn count(blocks: &mut Blocks, same: bool, outcome: &Outcome) {
    let pairs = &mut blocks.statistics.pairs;
    pairs.total += usize::from(!same || matches!(outcome, Outcome::Integrated(_)));
    match outcome {
        Outcome::Unwanted => pairs.skipped_black += usize::from(!same),
        Outcome::Coplanar => pairs.skipped_coplanar += usize::from(!same),
        Outcome::Behind => pairs.skipped_behind += 1,
        Outcome::Hidden => pairs.skipped_hidden += 1,
        Outcome::Integrated(block) => pairs.take(&block.report),
    }
}

fn integrated(
    receiver: &TiledElement,
    emitter: &TiledElement,
    same: bool,
    visibility: &Visibility,
    rule: Rule,
) -> Outcome {
    let (x, y) = (receiver.element, emitter.element);
    match planes::of(x, y) {
        Planes::Exchanging => {}
        Planes::Behind => return Outcome::Behind,
        Planes::Coplanar => return Outcome::Coplanar,
    }
    // Where surfaces lie on each other, no light comes between them.
    if x.contact.is_some() || y.contact.is_some() {
        return Outcome::Hidden;
    }
    let blockers =
        if same { Vec::new() } else { visibility.candidates(&x.hull, &y.hull, [x.surface, y.surface]) };
    if visibility.hidden(&blockers, &x.hull, &y.hull) {
        return Outcome::Hidden;
    }
    let free = |x, y| visibility.free(&blockers, x, y);
    let sees: Option<Sees> = if blockers.is_empty() { None } else { Some(&free) };
    let mut sum = Sum::new([x.basis.len(), y.basis.len()], sees);
    let mut kind = if same { PairKind::Same } else { PairKind::Separated };
    for (k, p) in receiver.tiles.iter().enumerate() {
        for (l, q) in emitter.tiles.iter().enumerate() {
            if same && k == l {
                rule.add_own(&mut sum, p);
            } else {
                kind = kind.max(rule.add(&mut sum, p, q));
            }
        }
    }
    let mut block = Block::exact(sum.values, kind, sum.samples);
    (block.report.partly_hidden, block.report.rays) = (!blockers.is_empty(), sum.rays);
    Outcome::Integrated(block)
}
