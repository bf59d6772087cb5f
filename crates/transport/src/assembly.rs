//! All blocks: by rules where these reach the accuracy, by rays elsewhere.

use radiosity_kernel::Blocks;
use radiosity_work::Work;

use crate::kept_blocks::KeptBlocks;
use crate::schedule::{Demand, Unreached, by_rules};
use crate::unreached;

/// The blocks of a demand. Those that `kept` holds, which was moved to this scene, are not integrated again: the
/// result is the same to the bit.
pub fn assemble(demand: Demand, mut kept: Option<&mut KeptBlocks>, work: &Work<'_>) -> Blocks {
    let unreached = Unreached::of(demand.visibility);
    let (mut blocks, left) = by_rules(demand, unreached, kept.as_deref_mut(), work);
    if !left.is_empty() {
        unreached::add(&mut blocks, &left, demand, kept, work);
    }
    blocks
}
