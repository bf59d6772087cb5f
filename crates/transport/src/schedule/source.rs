//! Where blocks come from.

/// Where the block of a task comes from.
#[derive(Clone, Copy, Debug)]
pub(super) enum Source {
    /// Integrated for this task, at this place among all integrated blocks.
    Own(usize),
    /// Equal to the block of the earlier task `first`, which is at this `place`.
    Copy { first: usize, place: usize },
}

impl Source {
    /// The place of its block among all integrated blocks.
    pub(super) fn place(&self) -> usize {
        let (Source::Own(place) | Source::Copy { place, .. }) = self;
        *place
    }
}
