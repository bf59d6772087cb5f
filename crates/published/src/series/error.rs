//! Why a block has no series, or none at a displacement.

use super::span::Span;

/// Why a block has no series, or none at a displacement. Surfaces are told by their indices in the scene.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SeriesError {
    /// A direction or an axis of length zero or not finite.
    #[error(
        "a translation needs a direction and a rotation an axis: give three numbers that are not all zero"
    )]
    Direction,
    /// A tolerance that no rule reaches, or none at all.
    #[error("a tolerance of {tolerance} cannot be reached: choose 1e-15 ≤ tolerance < 1")]
    Tolerance {
        /// The tolerance asked for.
        tolerance: f64,
    },
    /// A curved element.
    #[error("surface {surface} is curved: series are for flat surfaces, integrate its pairs anew")]
    Curved {
        /// Index of the surface.
        surface: usize,
    },
    /// Elements that touch or nearly do.
    #[error("surfaces {} and {} touch or nearly do at p = {at}: integrate the pair anew", surfaces[0], surfaces[1])]
    Touching {
        /// Indices of the surfaces of the receiver and of the emitter.
        surfaces: [usize; 2],
        /// The displacement p.
        at: f64,
    },
    /// A surface that passes through the plane of the other.
    #[error(
        "one of the surfaces {} and {} passes through the plane of the other at p = {at}: integrate the pair anew",
        surfaces[0], surfaces[1]
    )]
    Horizon {
        /// Indices of the surfaces of the receiver and of the emitter.
        surfaces: [usize; 2],
        /// The displacement p.
        at: f64,
    },
    /// A displacement outside the range of the expansion.
    #[error("p = {p} lies outside the range of the series, {} ≤ p ≤ {}: expand it anew at p", range.from, range.to)]
    Range {
        /// The displacement asked for.
        p: f64,
        /// Where the series may be evaluated.
        range: Span,
    },
}
