//! Occlusion correction by outlines: what planar blockers take away from the transfer between two elements of
//! which at least one is flat, or both lie on the inside of one sphere.
//!
//! ```text
//! G = G⁰ − S ,     S_kl = ∫ φ_k(x) ∫_{H(x)} φ_l(y) κ(x, y) dA_y dA_x ,
//! ```
//!
//! where G⁰ is the unobstructed block and H(x) the part of the inner element that is hidden from the outer
//! point x. H(x) consists of polygons, found by clipping ([`radiosity_kernel::irradiance::visible_polygon`]).
//! It lies behind a blocker, away from x, so that the inner integral is smooth even where the one over all y
//! is singular. Constants are integrated by Lambert's formula, higher functions by Gauss rules over the
//! polygons, halved while they are near ([`radiosity_kernel::rules::far`]).
//!
//! The outer element is the one farther from the blockers relative to its size: the shadows on the other then
//! move smoothly with x. A curved element is always the outer one; its points see the part of the flat one
//! above their tangent planes. The inner integral jumps along sides of blockers that stand on the outer
//! element: it is cut along them. It has kinks where an edge of one blocker passes a corner of another or of
//! the element: cells are halved until two levels agree.

mod edges;
mod kinks;
mod sides;
mod cell_cut;
mod correction;
mod correction_sums;

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_kernel::blocks::block::{Block, take_symmetric_part};
use radiosity_kernel::rules::zone::Zone;
use radiosity_visibility::Visibility;
use rayon::prelude::*;

use correction::Correction;
pub(crate) use correction::Limit;
use correction_sums::{CorrectionSums, Occlusion};
use sides::Sides;

use crate::tolerances::LOOSEST_OF_OUTLINES;

/// Number of outer patches from which they are summed in parallel: fewer are done before threads share them.
const MANY: usize = 8;

/// The correction for `blockers`, all of them with outlines, between two elements of which at least one is
/// flat, or that lie on the inside of one sphere.
fn occlusion(pair: [&Element; 2], blockers: &[usize], visibility: &Visibility, limit: Limit) -> Occlusion {
    let blockers = visibility.by_place(blockers);
    let accuracy = limit.error / limit.entry;
    let Sides { side, outer, inner } = Sides::of(pair, &blockers, visibility, accuracy);
    let bodies = visibility.one_of_each_body(&blockers);
    let correction = Correction::new(pair, side, &inner, &bodies, visibility, limit);
    let area = |patch: &Patch| patch.node(0.5, 0.5).area;
    let whole: f64 = outer.iter().map(area).sum();
    let add = |sums: &mut CorrectionSums, patch: &Patch| {
        sums.add(patch, &bodies, limit.error * (area(patch) / whole).sqrt());
    };
    let mut sums = CorrectionSums::new(&correction);
    if outer.len() < MANY {
        outer.iter().for_each(|patch| add(&mut sums, patch));
        return sums.finish();
    }
    // Partial sums are added in the order of the patches: the same result on any number of threads.
    let sum_of = |patch: &Patch| {
        let mut part = CorrectionSums::new(&correction);
        add(&mut part, patch);
        part
    };
    let parts: Vec<CorrectionSums> = outer.par_iter().map(sum_of).collect();
    parts.iter().for_each(|part| sums.merge(part));
    sums.finish()
}

/// Whether the elements of a pair lie on the inside of one sphere, over rectangles of longitude and latitude.
pub(crate) fn share_sphere(pair: [&Element; 2]) -> bool {
    let [first, second] = pair.map(|element| Zone::of(element, LOOSEST_OF_OUTLINES));
    first.zip(second).is_some_and(|(first, second)| first.shares_inside(&second))
}

/// The block between two elements with planar `blockers`, its correction accurate to `limit`. `unshaded`
/// makes the unobstructed block.
pub(crate) fn occluded_block(
    pair: [&Element; 2],
    blockers: &[usize],
    visibility: &Visibility,
    limit: Limit,
    unshaded: impl FnOnce() -> Block,
) -> Block {
    let mut occlusion = occlusion(pair, blockers, visibility, limit);
    if std::ptr::eq(pair[0], pair[1]) {
        // The inner integrals are better than the outer ones.
        take_symmetric_part(&mut occlusion.values, pair[0].basis.len());
    }
    if occlusion.dark {
        let mut block = Block::hidden(occlusion.values.len(), 0);
        block.report.samples = occlusion.samples;
        return block;
    }
    let mut block = unshaded();
    block.values.iter_mut().zip(&occlusion.values).for_each(|(value, hidden)| *value -= hidden);
    if let [factor] = &mut block.values[..] {
        *factor = factor.max(0.0);
    }
    block.report.partly_hidden = occlusion.hides;
    block.report.error += occlusion.error;
    block.report.samples += occlusion.samples;
    block.report.distinct += occlusion.samples;
    block
}
