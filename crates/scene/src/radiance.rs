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

    /// Whether it is that of an opening to a sky.
    pub fn is_of_opening(&self) -> bool {
        self.outlook().is_some()
    }

    /// Unit vector to the zenith of a sky: a jumps between directions that rise and directions that fall. None
    /// for a luminaire.
    pub fn zenith(&self) -> Option<DVec3> {
        self.outlook().map(|outlook| outlook.zenith())
    }

    /// Whether a varies from one direction to the next, and not at the horizon alone.
    pub fn is_graded(&self) -> bool {
        self.outlook().is_none_or(|outlook| outlook.is_graded())
    }

    /// Error of the mean of a over a cell, on one side of the horizon, by what is between its points; `into`
    /// are the directions, of any length, from the corners of the cell to the point that sees it.
    pub fn left_out(&self, into: &[DVec3]) -> f64 {
        match self {
            Self::Sky(outlook) => outlook.left_out(into),
            Self::Luminaire(area) => area.left_out(into),
        }
    }

    /// Whether a may bend at once from one direction to the next, as a table does at its angles.
    pub fn bends(&self) -> bool {
        matches!(self, Self::Luminaire(area) if area.bends())
    }
}
