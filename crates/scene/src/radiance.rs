//! Radiance by direction, of flat surfaces that are no diffuse emitters.

use std::sync::Arc;

use radiosity_geom::DVec3;

use crate::{luminous_area::LuminousArea, outlook::Outlook};

/// Where the light of a flat surface comes from that is no diffuse emitter.
#[derive(Clone, Debug, PartialEq)]
pub enum Radiance {
    /// A sky behind it.
    Sky(Arc<Outlook>),
    /// A luminaire.
    Luminaire(Arc<LuminousArea>),
}

impl Radiance {
    /// a: the radiance in a unit direction from the surface, over that of a diffuse emitter of its exitance.
    pub fn relative(&self, into: DVec3) -> f64 {
        match self {
            Self::Sky(outlook) => outlook.relative(into),
            Self::Luminaire(area) => area.relative(into),
        }
    }

    /// What it sees, if it is an opening to a sky.
    pub fn outlook(&self) -> Option<&Arc<Outlook>> {
        match self {
            Self::Sky(outlook) => Some(outlook),
            Self::Luminaire(_) => None,
        }
    }

    /// By how much the mean of a cell errs for what is between its points, where a differs by up to `spread`; `into` are the
    /// directions, of any length, from its corners to where it is seen from.
    pub fn left_out(&self, into: &[DVec3], spread: f64) -> f64 {
        match self {
            // Radiance jumps at the horizon.
            Self::Sky(outlook) => {
                let heights = || into.iter().map(|step| outlook.height(-*step));
                let crosses = heights().any(|height| height > 0.0) && heights().any(|height| height < 0.0);
                if crosses { spread } else { 0.0 }
            }
            Self::Luminaire(area) => area.left_out(into),
        }
    }

    /// Whether a may bend at once from one direction to the next.
    pub fn bends(&self) -> bool {
        matches!(self, Self::Luminaire(area) if area.bends())
    }
}
