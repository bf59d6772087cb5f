//! All blocks: by rules where these reach the accuracy, by rays elsewhere.

use radiosity_elements::Elements;
use radiosity_kernel::Accuracy;
use radiosity_kernel::Blocks;
use radiosity_visibility::Visibility;
use radiosity_work::Work;

use crate::kept_blocks::KeptBlocks;
use crate::schedule::{Demand, Unreached, by_rules};
use crate::unreached;
use crate::unreached::Whole;

/// The blocks of all pairs.
pub fn assemble(elements: &Elements, visibility: &Visibility, accuracy: Accuracy, work: &Work<'_>) -> Blocks {
    assemble_pairs(elements, &|_, _| true, visibility, accuracy, work)
}

/// The blocks of all pairs of which at least one element `sends` light.
pub fn assemble_senders(
    elements: &Elements,
    sends: &(dyn Fn(usize) -> bool + Sync),
    visibility: &Visibility,
    accuracy: Accuracy,
    work: &Work<'_>,
) -> Blocks {
    assemble_pairs(elements, &|a, b| sends(a) || sends(b), visibility, accuracy, work)
}

/// The blocks of the pairs that are `wanted`.
pub fn assemble_pairs(
    elements: &Elements,
    wanted: &(dyn Fn(usize, usize) -> bool + Sync),
    visibility: &Visibility,
    accuracy: Accuracy,
    work: &Work<'_>,
) -> Blocks {
    let unreached = Unreached::of(visibility);
    assembled(Demand { elements, wanted, visibility, accuracy, unreached }, Whole::Element, None, work)
}

/// The blocks of [`assemble_senders`], to the bit; those that `kept` holds, which was moved to this scene,
/// are not integrated again.
pub fn assemble_again(
    elements: &Elements,
    sends: &(dyn Fn(usize) -> bool + Sync),
    visibility: &Visibility,
    accuracy: Accuracy,
    kept: &mut KeptBlocks,
    work: &Work<'_>,
) -> Blocks {
    let wanted = |a: usize, b: usize| sends(a) || sends(b);
    let unreached = Unreached::of(visibility);
    let demand = Demand { elements, wanted: &wanted, visibility, accuracy, unreached };
    assembled(demand, Whole::Element, Some(kept), work)
}

/// The blocks of elements that carry constants, accurate for the view factors of their surfaces.
pub fn assemble_factors(
    elements: &Elements,
    wanted: &(dyn Fn(usize, usize) -> bool + Sync),
    visibility: &Visibility,
    accuracy: Accuracy,
    work: &Work<'_>,
) -> Blocks {
    let unreached = Unreached::of(visibility);
    assembled(Demand { elements, wanted, visibility, accuracy, unreached }, Whole::Surface, None, work)
}

fn assembled(demand: Demand, whole: Whole, mut kept: Option<&mut KeptBlocks>, work: &Work<'_>) -> Blocks {
    let (mut blocks, left) = by_rules(demand, kept.as_deref_mut(), work);
    if !left.is_empty() {
        unreached::add(&mut blocks, &left, demand, whole, kept, work);
    }
    blocks
}
