//! Whether direct light is split off.
//!
//! Split off, D is as sharp as it is in truth, but loses the power that its quadrature misses; projected, it
//! is as smooth as polynomials, and power is kept to rounding. Sharp shadows need the first, furnaces the
//! second.

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

impl Direct {
    /// Whether the direct light of all `emitters`, of one scene, is split off. `plain`: the transfers are
    /// those of the default kernel without changes.
    pub(super) fn splits(self, emitters: &[Emitters<'_>], visibility: &Visibility, plain: bool) -> bool {
        match self {
            Self::Split => true,
            Self::Projected => false,
            Self::Auto if emitters.iter().any(Emitters::are_directed) => true,
            Self::Auto => {
                plain
                    && (luminaires_cast_flat_shadows(emitters, visibility)
                        || casts_flat_shadows(emitters, visibility))
            }
        }
    }
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

/// Whether all emitters and all possible blockers are flat, there is a blocker, and emitters are small.
fn casts_flat_shadows(sources: &[Emitters<'_>], visibility: &Visibility) -> bool {
    let elements = sources.first().map_or(&[][..], |own| own.elements);
    let coatings: Vec<&Coating> = sources.iter().flat_map(|own| own.coatings.iter().copied()).collect();
    // A covered element exchanges light only with what covers it.
    let is_open = |element: &&Element| element.contact.is_none();
    let emits =
        |i: &usize| is_open(&&elements[*i]) && coatings.iter().any(|coating| coating.exitance[*i] > 0.0);
    let emitters: Vec<&Element> = (0..elements.len()).filter(emits).map(|i| &elements[i]).collect();
    let area = |some: &mut dyn Iterator<Item = &Element>| some.map(|element| element.area).sum::<f64>();
    if area(&mut emitters.iter().copied()) > LARGE * area(&mut elements.iter()) {
        return false;
    }
    let mut shadows = false;
    for emitter in &emitters {
        if emitter.plane.is_none() {
            return false;
        }
        for element in elements.iter().filter(is_open) {
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
