//! Changes that reduce the memory of a run.

use radiosity_work::wording::{Wording, set, words};

/// A change that makes a run fit into the memory allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MemoryReduction {
    /// A lower number of rays.
    Rays(u64),
    /// Rays instead of rules.
    SampledTransport,
    /// A solver that keeps no factors.
    ConjugateGradients,
    /// A lower order.
    Order(usize),
    /// A lower order, for runs without a wanted accuracy only.
    OrderAlone(usize),
    /// Surfaces that are not cut.
    WholeSurfaces,
    /// Frames that keep nothing for the next ones.
    FreshFrames,
}

impl MemoryReduction {
    /// The change in words.
    fn wording(&self) -> Wording {
        match self {
            Self::Rays(rays) => set("rays", rays),
            Self::SampledTransport => set("transport", "sampled"),
            Self::ConjugateGradients => words("the solver cg"),
            Self::Order(order) => words(format!("order {order}")),
            Self::OrderAlone(order) => words(format!("order {order} without a wanted accuracy")),
            Self::WholeSurfaces => words("one element a surface"),
            Self::FreshFrames => set("animation", "fresh"),
        }
    }
}

/// The changes in words.
pub(super) fn list(fits: &[MemoryReduction]) -> Wording {
    let fits = fits.iter().map(MemoryReduction::wording).reduce(|list, fit| list + ", or " + fit);
    match fits {
        Some(list) => words("what would fit: ") + list,
        None => words("no lower order and no other solver would fit"),
    }
}
