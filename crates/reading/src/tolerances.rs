//! Accuracies that pictures of several kinds share.

/// Relative accuracy of recomputed light in pictures and textures: finer than the steps of eight bits, 1/255.
/// A finer one takes longer and shows in none.
pub(crate) const GATHERED_FOR_PICTURES: f64 = 3e-3;
