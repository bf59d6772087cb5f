//! Blocks that need not be integrated: those of an earlier scene, and those that are known otherwise.

use std::sync::Arc;

use crate::kept_blocks::{IntegratedBlock, KeptBlocks};
use crate::known::Known;
use crate::schedule::goal::Goal;
use crate::schedule::task::{Schedule, Task};

impl Schedule<'_> {
    /// The block of a task that `kept` holds; that of flat elements with nothing between may be known
    /// otherwise as well.
    pub(super) fn kept_block(
        &self,
        task: &Task,
        goal: Goal,
        kept: &KeptBlocks,
    ) -> Option<Arc<IntegratedBlock>> {
        let request = goal.request(task, self.visibility);
        if let Some(block) = kept.get(&request) {
            return Some(Arc::clone(block));
        }
        let known = kept.known()?;
        let places = task.pair();
        let pair = places.map(|index| &self.list[index]);
        let is_free = task.blockers.is_empty() && task.own.is_empty();
        let are_flat = pair.iter().all(|element| element.plane.is_some() && element.contact.is_none());
        if !is_free || !are_flat {
            return None;
        }
        match known.block(places, pair, goal.accuracy.eps, kept.samples(&request))? {
            Known::Same => kept.get_outdated(&request).cloned(),
            Known::Block { block, remainder } => Some(Arc::new(IntegratedBlock::known(block, remainder))),
        }
    }
}
