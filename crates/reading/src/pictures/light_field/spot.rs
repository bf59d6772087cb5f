//! Spots of which light is known: nodes of lattices, and single places.

pub(crate) use super::lattice::NodeIndex;
use crate::pictures::eye::SeenPlace;

/// A spot on a surface, with which it moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Spot {
    /// A node of a lattice.
    Node(NodeIndex),
    /// A place at which light is gathered alone.
    Place(PlaceKey),
}

/// A place that is known by its surface and its parameters there, to the bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct PlaceKey {
    surface: usize,
    parameters: [u64; 2],
    error_factor: u64,
}

impl Spot {
    /// Index of the surface.
    pub(crate) fn surface(&self) -> usize {
        match self {
            Self::Node(node) => node.surface,
            Self::Place(place) => place.surface,
        }
    }
}

impl PlaceKey {
    /// The key of a place with this factor on the error of its light.
    pub(super) fn of(seen: &SeenPlace, error_factor: f64) -> Self {
        let parameters = seen.place.parameters.map(f64::to_bits);
        Self { surface: seen.place.surface, parameters, error_factor: error_factor.to_bits() }
    }

    /// Parameters of the place.
    pub(super) fn parameters(&self) -> [f64; 2] {
        self.parameters.map(f64::from_bits)
    }

    /// Factor on the error of its light.
    pub(super) fn error_factor(&self) -> f64 {
        f64::from_bits(self.error_factor)
    }
}
