//! The solution on the leaves of a hierarchy.

use super::network::{Counts, Hierarchy, Leaf};

/// The light of one band on all leaves.
#[derive(Clone, Debug)]
pub(crate) struct LeafLight {
    /// Irradiance of each leaf (W m⁻²).
    pub irradiance: Vec<f64>,
    /// Radiosity of each leaf (W m⁻²).
    pub radiosity: Vec<f64>,
}

/// Irradiance and radiosity on the leaves, per band.
#[derive(Debug)]
pub struct Hierarchical {
    hierarchy: Hierarchy,
    bands: Vec<LeafLight>,
}

impl Hierarchical {
    /// The light of all bands over a hierarchy.
    pub(crate) fn new(hierarchy: Hierarchy, bands: Vec<LeafLight>) -> Self {
        Self { hierarchy, bands }
    }

    /// The tree and its links.
    pub fn hierarchy(&self) -> &Hierarchy {
        &self.hierarchy
    }

    /// The leaves, surface by surface.
    pub fn leaves(&self) -> &[Leaf] {
        self.hierarchy.leaves()
    }

    /// The numbers of nodes, links and rounds.
    pub fn counts(&self) -> Counts {
        self.hierarchy.counts()
    }

    /// Irradiance of each leaf in a band (W m⁻²).
    pub fn irradiance(&self, band: usize) -> &[f64] {
        &self.bands[band].irradiance
    }

    /// Radiosity of each leaf in a band (W m⁻²).
    pub fn radiosity(&self, band: usize) -> &[f64] {
        &self.bands[band].radiosity
    }

    /// Mean irradiance of a surface in a band (W m⁻²); 0 for one without area.
    pub fn mean_irradiance(&self, band: usize, surface: usize) -> f64 {
        let (mut power, mut area) = (0.0, 0.0);
        for leaf in self.hierarchy.of_surface(surface) {
            let own = self.leaves()[leaf].area;
            power += own * self.bands[band].irradiance[leaf];
            area += own;
        }
        if area > 0.0 { power / area } else { 0.0 }
    }
}
