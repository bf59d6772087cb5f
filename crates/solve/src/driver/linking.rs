//! The links of hierarchical radiosity: when a pair of surfaces or cells is refined, and how its visibility is
//! found.

use radiosity_published::hierarchy::{HierarchyOptions, LinkMeasure};
use serde::{Deserialize, Serialize};

/// The links of hierarchical radiosity, beside `eps`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Linking {
    /// The measure of a pair that is compared with `eps`.
    pub measure: LinkMeasure,
    /// Faces up to this part of the area of all surfaces are not cut.
    pub least_area: f64,
    /// Rays that find the visibility of a link.
    pub rays_per_link: usize,
}

/// Usual least area where links are measured by power: a bound of the number of faces, where light is
/// concentrated.
const LEAST_AREA: f64 = 1e-6;

/// Usual least area where links are measured by form factors, which do not fall as faces do that touch: it
/// alone ends their refinement. Chosen: cells of an eighth of
/// the sides of a cubic room.
const LEAST_AREA_OF_TOUCHING: f64 = 1e-3;

impl Default for Linking {
    /// By power, faces of 1e-6 of the area, sixteen rays.
    fn default() -> Self {
        Self::by(LinkMeasure::default())
    }
}

impl Linking {
    /// The usual links of a measure.
    pub fn by(measure: LinkMeasure) -> Self {
        let least_area = match measure {
            LinkMeasure::Power => LEAST_AREA,
            LinkMeasure::FormFactor => LEAST_AREA_OF_TOUCHING,
        };
        Self { measure, least_area, rays_per_link: HierarchyOptions::default().rays_per_link }
    }

    /// Whether nothing is asked for.
    pub(super) fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}
