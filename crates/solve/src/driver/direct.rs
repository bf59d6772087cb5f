//! Whether direct light is split off.
//!
//! Split off, D is as sharp as it is in truth, but loses the power that its quadrature misses; projected, it
//! is as smooth as polynomials, and power is kept to rounding. Sharp shadows need the first, furnaces the
//! second. Where rays carry light, they find D of openings and luminous areas too (`gather::direct_by_rays`),
//! and what surfaces reflect of it is carried; light of diffuse emitters is carried from the start. Measured in
//! sixty rooms: with D of those by rays errors are the same, and times 1.2 times as long.

use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_light::emitters::Emitters;
use radiosity_visibility::Visibility;
use serde::{Deserialize, Serialize};

/// Emitting part of the scene's area above which direct light counts as smooth: shadows of large emitters
/// have broad penumbrae, which polynomials follow. An arbitrary choice: with a larger value more scenes split
/// direct light off, which takes longer; with a smaller one shadows are blurred.
const LARGE: f64 = 0.25;

/// Ways in which light that comes straight from emitters enters the solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Direct {
    /// Split where there are openings to a sky or luminous areas, and where luminaires or small flat emitters
    /// cast shadows of flat surfaces; else projected.
    Auto,
    /// An exact source at every point, with its shadows.
    Split,
    /// Carried by the polynomials like all other light.
    Projected,
}

/// Knowledge of direct light before anything is carried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DirectWay {
    /// Nothing of the light of surfaces: it is carried like all other light.
    Carried,
    /// Its coefficients; what surfaces reflect of it is carried.
    Arrived,
    /// Its coefficients and those of its first bounce.
    Split,
}

impl Direct {
    /// The way in which direct light of all `emitters`, of one scene, enters before `transfers` carry the rest.
    pub(super) fn way(
        self,
        emitters: &[Emitters<'_>],
        visibility: &Visibility,
        transfers: Transfers,
    ) -> DirectWay {
        let directed = || emitters.iter().any(Emitters::are_directed);
        let casts_flat_shadows =
            || luminaires_cast_flat_shadows(emitters, visibility) || casts_flat_shadows(emitters, visibility);
        match (self, transfers) {
            (Self::Split, _) => DirectWay::Split,
            (Self::Projected, _) => DirectWay::Carried,
            (Self::Auto, Transfers::Rays) if directed() => DirectWay::Arrived,
            (Self::Auto, Transfers::Rules) if directed() || casts_flat_shadows() => DirectWay::Split,
            (Self::Auto, Transfers::Changed) if directed() => DirectWay::Split,
            (Self::Auto, _) => DirectWay::Carried,
        }
    }
}

/// Carriers of light between elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Transfers {
    /// The default kernel.
    Rules,
    /// The kernel with changes.
    Changed,
    /// Rays.
    Rays,
}

/// Whether all possible blockers between luminaires and elements are flat, and there is one.
fn luminaires_cast_flat_shadows(sources: &[Emitters<'_>], visibility: &Visibility) -> bool {
    let mut shadows = false;
    let pairs = sources.iter().flat_map(|own| own.points.ends().map(|ends| (own.elements, ends)));
    for (elements, ends) in pairs {
        for element in elements.iter().filter(|element| element.contact.is_none()) {
            let blockers = visibility.candidates_before_points(&element.hull, &ends, element.surface);
            if !visibility.are_planar(&blockers) {
                return false;
            }
            shadows |= !blockers.is_empty();
        }
    }
    shadows
}

/// Whether some surfaces emit, on a small part of the scene's area.
fn are_small(sources: &[Emitters<'_>]) -> bool {
    let [mut emitting, mut all] = [0.0; 2];
    for (index, element) in open_elements(sources) {
        let emits = sources.iter().flat_map(|own| &own.coatings).any(|own| own.exitance[index] > 0.0);
        all += element.area;
        emitting += if emits { element.area } else { 0.0 };
    }
    emitting > 0.0 && emitting <= LARGE * all
}

/// The elements that no other surface covers, with their indices: a covered one exchanges light only with what covers
/// it.
fn open_elements<'a>(sources: &[Emitters<'a>]) -> impl Iterator<Item = (usize, &'a Element)> + Clone {
    let elements = sources.first().map_or(&[][..], |own| own.elements);
    elements.iter().enumerate().filter(|(_, element)| element.contact.is_none())
}

/// Whether all emitters and all possible blockers are flat, there is a blocker, and emitters are small.
fn casts_flat_shadows(sources: &[Emitters<'_>], visibility: &Visibility) -> bool {
    if !are_small(sources) {
        return false;
    }
    let coatings: Vec<&Coating> = sources.iter().flat_map(|own| own.coatings.iter().copied()).collect();
    let emits = |(index, _): &(usize, &Element)| coatings.iter().any(|own| own.exitance[*index] > 0.0);
    let emitters = open_elements(sources).filter(emits).map(|(_, element)| element);
    let mut shadows = false;
    for emitter in emitters {
        if emitter.plane.is_none() {
            return false;
        }
        for (_, element) in open_elements(sources) {
            let surfaces = [element.surface, emitter.surface];
            let blockers = visibility.candidates(&element.hull, &emitter.hull, surfaces);
            if blockers.iter().any(|blocker| visibility.pieces(*blocker).is_none()) {
                return false;
            }
            shadows |= !blockers.is_empty();
        }
    }
    shadows
}
