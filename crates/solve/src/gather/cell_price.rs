//! About the seconds of one core that gathering by cells takes, from counts alone.
//!
//! ```text
//! once      n elements Σ_lamps (a + b c)               n = 100 (3·10⁻³/ε)^¾ points of an element, twice: their light
//! a point   Σ_lamps (a + b c) + Σ_elements (e + d s + b′ c + f (1 + c) if curved)
//! ```
//!
//! with s surfaces that stand about, c of them curved, and a, b larger for curved lamps; of openings through which the
//! sun shines a is that of all their cells. Measured on fifteen rooms of 30 to 240 elements, the Cornell box
//! and the teapot, at ε = 3·10⁻³ and 9·10⁻⁴: right within a factor of three, where it says a millisecond or more.

use radiosity_elements::Element;
use radiosity_light::emitters::Emitters;
use radiosity_visibility::Visibility;

/// Points of an element whose light is tabulated for this accuracy, and the power of the accuracy by which they and
/// their light take longer.
const NODES: f64 = 100.0;
const AT: f64 = 3e-3;
const POWER: f64 = 0.75;

/// Seconds of the direct light of a flat and of a curved emitter, and for each curved thing that may hide it.
const FLAT_LAMP: f64 = 0.5e-6;
const FLAT_LAMP_BEHIND: f64 = 0.7e-6;
const CURVED_LAMP: f64 = 8e-6;

/// Seconds of the direct light of an opening to a sky that is not uniform, where the sun shines in: its cells are fine
/// about the sun, and tables have more points than are counted here. Measured in two rooms with clear skies, for the
/// tables of elements at ε = 1.25·10⁻³: 1.3 ms; without the sun less than 0.05 ms.
const SUNLIT_OPENING: f64 = 1e-3;

/// Seconds of an element, and for each flat and each curved thing that stands about; of one that is curved for itself
/// and each of the latter.
const FLAT: f64 = 1.5e-6;
const BEHIND_FLAT: f64 = 0.02e-6;
const BEHIND_CURVED: f64 = 1e-6;
const CURVED: f64 = 5e-6;

/// Most curved things that count, as many as were measured: of more, most stand aside.
const MOST_CURVED: f64 = 32.0;

/// Seconds of gathering by cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CellPrice {
    /// For the tables of all elements.
    pub(crate) once: f64,
    /// For each point.
    pub(crate) point: f64,
}

impl CellPrice {
    /// The price of the light of `sources`, gathered `twice` or once to the relative accuracy `eps`.
    pub(crate) fn of(sources: &Emitters<'_>, visibility: &Visibility, eps: f64, twice: bool) -> Self {
        let about = Things::about(visibility);
        let list = sources.elements;
        let direct = about.seconds_of_direct(sources);
        let reflected: f64 =
            list.iter().filter(|element| element.contact.is_none()).map(|own| about.seconds_of(own)).sum();
        let nodes = NODES * list.len() as f64 * (AT / eps).powf(POWER);
        let of_node = if twice { direct + reflected } else { direct };
        Self { once: nodes * of_node, point: direct + reflected }
    }

    /// Seconds of the direct light of a point.
    pub(crate) fn of_direct(sources: &Emitters<'_>, visibility: &Visibility) -> f64 {
        Things::about(visibility).seconds_of_direct(sources)
    }
}

/// Numbers of surfaces that stand about.
struct Things {
    all: f64,
    /// Curved ones, [`MOST_CURVED`] at the most.
    curved: f64,
}

impl Things {
    fn about(visibility: &Visibility) -> Self {
        let (mut all, mut curved) = (0.0, 0.0);
        for surface in visibility.standing() {
            all += 1.0;
            curved += if visibility.pieces(surface).is_none() { 1.0 } else { 0.0 };
        }
        Self { all, curved: f64::min(curved, MOST_CURVED) }
    }

    /// Seconds of the direct light of a point.
    fn seconds_of_direct(&self, sources: &Emitters<'_>) -> f64 {
        let Emitters { elements: list, coatings, radiances, points } = sources;
        let shines = |index: &usize| coatings.iter().any(|coating| coating.exitance[*index] > 0.0);
        let of_lamp = |index: usize| match list[index].plane {
            _ if points.has_sun() && radiances.is_graded(list[index].surface) => SUNLIT_OPENING,
            Some(_) => FLAT_LAMP + FLAT_LAMP_BEHIND * self.curved,
            None => CURVED_LAMP * (1.0 + self.curved),
        };
        (0..list.len()).filter(shines).map(of_lamp).sum()
    }

    /// Seconds of what an element reflects to a point.
    fn seconds_of(&self, element: &Element) -> f64 {
        let about = FLAT + BEHIND_FLAT * self.all + BEHIND_CURVED * self.curved;
        match element.plane {
            Some(_) => about,
            None => about + CURVED * (1.0 + self.curved),
        }
    }
}
