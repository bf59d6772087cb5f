//! Errors of cutting a scene into elements.

use super::basis::HIGHEST_ORDER;
use super::cells::Layers;

/// Why a scene could not be cut into elements.
#[derive(Debug, thiserror::Error)]
pub enum ElementError {
    /// A degree above the highest offered.
    #[error("order {order} is above the highest offered, {HIGHEST_ORDER}: choose a lower one")]
    Order {
        /// The degree asked for.
        order: usize,
    },
    /// Layers that cannot be made.
    #[error(
        "{} layers of ratio {}: the ratio has to lie between 0 and 1, and its power to the number of layers above 1e-7",
        layers.count, layers.ratio
    )]
    Layers {
        /// The layers asked for.
        layers: Layers,
    },
    /// A surface without area, or so thin that its rounded points cannot distinguish polynomials of its
    /// degree.
    #[error(
        "surface '{surface}' has no area, or is too thin for polynomials of order {order}: lower its order or remove it"
    )]
    Thin {
        /// Name of the surface.
        surface: String,
        /// The degree asked for.
        order: usize,
    },
}
