//! Radiance by direction, of flat surfaces that are no diffuse emitters.

use std::sync::Arc;

use radiosity_geom::DVec3;

use crate::{luminous_area::LuminousArea, outlook::Outlook};

/// Angular distribution of the light of a flat surface that is no diffuse emitter.
#[derive(Clone, Debug, PartialEq)]
pub enum Radiance {
    /// The light of a sky behind an opening.
    Sky(Arc<Outlook>),
    /// The light of a luminaire, from one side of its area.
    Luminaire(Arc<LuminousArea>),
}

impl Radiance {
    /// The light with a factor on each band: a stays, and so does all that follows from it.
    pub(crate) fn dimmed(&self, factors: &[f64]) -> Self {
        match self {
            Self::Sky(outlook) => Self::Sky(Arc::new(outlook.dimmed(factors))),
            Self::Luminaire(area) => Self::Luminaire(Arc::new(area.dimmed(factors))),
        }
    }

    /// Relative radiance a: the radiance in a unit direction from the surface, over that of a diffuse emitter
    /// of its exitance.
    pub fn relative(&self, into: DVec3) -> f64 {
        match self {
            Self::Sky(outlook) => outlook.relative(into),
            Self::Luminaire(area) => area.relative(into),
        }
    }

    /// The outlook of an opening to a sky; none for a luminaire.
    pub fn outlook(&self) -> Option<&Arc<Outlook>> {
        match self {
            Self::Sky(outlook) => Some(outlook),
            Self::Luminaire(_) => None,
        }
    }

    /// Error of the mean of a over a cell by what is between its points, at which a differs by up to
    /// `spread`; `into` are the directions, of any length, from the corners of the cell to the point that
    /// sees it.
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

    /// Whether a may bend at once from one direction to the next, as a table does at its angles.
    pub fn bends(&self) -> bool {
        matches!(self, Self::Luminaire(area) if area.bends())
    }
}
