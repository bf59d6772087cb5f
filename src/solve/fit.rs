//! Changes that reduce the memory of a run.

use std::fmt;

/// A change that makes a run fit into the memory allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// So many rays.
    Rays(u64),
    /// A solver that keeps no factors.
    ConjugateGradients,
    /// A lower order.
    Order(usize),
    /// A lower order, for runs without a wanted accuracy only.
    OrderAlone(usize),
    /// No cuts of surfaces.
    WholeSurfaces,
    /// Frames that keep nothing for the next ones.
    FreshFrames,
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rays(rays) => write!(f, "--rays {rays}"),
            Self::ConjugateGradients => write!(f, "the solver cg"),
            Self::Order(order) => write!(f, "order {order}"),
            Self::OrderAlone(order) => write!(f, "order {order} without a wanted accuracy"),
            Self::WholeSurfaces => write!(f, "one element a surface"),
            Self::FreshFrames => write!(f, "--animation fresh"),
        }
    }
}

/// The changes in words.
pub(super) fn list(fits: &[Fit]) -> String {
    if fits.is_empty() {
        return "no lower order and no other solver would fit".to_owned();
    }
    let fits: Vec<String> = fits.iter().map(Fit::to_string).collect();
    format!("what would fit: {}", fits.join(", or "))
}
