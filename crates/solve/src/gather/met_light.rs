//! The light where rays end: what the place that a ray meets emits, reflects and lets through.
//!
//! E₁(y) = S_h(y) + E₀(z) V κ(y, z)/q(z) is the irradiance of y: S_h ≥ 0, the polynomials of the light that
//! was reflected at least once, and the direct light by one ray to a point z of an emitter, of density q(z), so that
//! shadow edges are sharp there too. The polynomials E_h of all light take its place on elements that are small as
//! seen from where the ray began: these are right in the mean. Not so near an emitter, although one ray says little
//! there: before a large window all of a room is near, and readings erred by up to 3 %. Where only reflected light is
//! gathered, for pictures, they are left only on elements that the ray nearly touches.
//!
//! Of the light of luminaires E₁(y) has that of one of them, by a ray.

use radiosity_elements::Element;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::number_of;
use radiosity_light::lamps::Target;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;
use smallvec::{SmallVec, smallvec};

use crate::gather::bends::{Part, SentLight, bends};
use crate::gather::glow::Glow;
use crate::gather::known_lamps::KnownLamps;
use crate::gather::lit_cells::LitCells;
use crate::gather::sent_rays::{AimedRays, LampLight, Met, NEAR, RayMix, SentRays};
use crate::gather::walked_light::Draws;
use crate::solution::{Solution, SurfacePlace};

/// Bands whose light takes no memory of its own for a ray: red, green and blue, and one more.
const FEW_BANDS: usize = 4;

/// The light of a solution as rays meet it, which all who gather it by rays share.
#[derive(Debug)]
pub(super) struct MetLight<'a> {
    /// The solution that is read.
    pub(super) solution: &'a Solution,
    /// Light that surfaces reflect.
    pub(super) sent: &'a Solution,
    pub(super) rays: SentRays<'a>,
    /// Direct light by cells.
    pub(super) lit_cells: LitCells,
    /// Emitters that send light without shadows by a closed form.
    pub(super) known_lamps: KnownLamps,
    /// Elements that reflect more than most.
    pub(super) glow: Glow,
    /// Mean radiosity per band (W m⁻²).
    pub(super) scale: Vec<f64>,
    /// Mean irradiance per band of all surfaces (W m⁻²).
    pub(super) usual: Vec<f64>,
    /// Bend of the light that each element reflects (`super::bends`).
    bends: Vec<f64>,
}

/// Elements all of whose light is that of their polynomials.
#[derive(Clone, Copy)]
pub(super) struct Held {
    /// Square root of the area of an element, over its distance, up to which it is.
    small: f64,
    /// Bend of the light on it up to which it is.
    smooth: f64,
    /// Whether the direct light of others is that of cells.
    pub(super) cells: bool,
}

impl Held {
    /// Limits of readings. Widths measured in a shop, a classroom and a temple: with 0.25 and 2 for 1 the error was
    /// the same, the time up to twice as long and the same. Bends measured in sixty random rooms of diffuse lamps:
    /// without a limit the largest error of a room was 2.0 %, with 0.3 and 0.1 1.3 and 1.4 %, in the same time.
    pub(super) const READ: Self = Self { small: 1.0, smooth: 0.3, cells: false };

    /// Limits where only reflected light is gathered, for pictures: polynomials are left only where things nearly
    /// touch, and shadows matter most. Measured at the teapot: errors of 0.55, 0.50, 0.41 and 0.36 % in 14, 17, 23 and
    /// 28 s with polynomials everywhere, 10, 4 and 1.
    pub(super) const BEHIND_PIXELS: Self = Self { small: 10.0, smooth: f64::INFINITY, cells: false };

    /// These, with the direct light of others by cells.
    pub(super) fn beside_cells(self) -> Self {
        Self { cells: true, ..self }
    }
}

/// Sources of the light that is reflected where rays end.
#[derive(Clone, Copy)]
pub(super) enum Ending {
    /// The polynomials, and direct light by a ray where that is not held by them.
    Polynomials(Held),
    /// Gathered in its turn by one ray of either kind.
    Gathered,
}

impl Ending {
    /// Sources of the light where the ray ends that `chance` belongs to.
    pub(super) fn of_ray(self, chance: u64) -> EndLight {
        match self {
            Self::Polynomials(held) => EndLight::Direct { chance, held },
            Self::Gathered => EndLight::Gathered(chance),
        }
    }
}

/// Sources of the irradiance where a ray ends.
#[derive(Clone, Copy)]
pub(super) enum EndLight {
    /// The polynomials of the element.
    Polynomials,
    /// Direct light by rays that `chance` chooses, the rest by the polynomials; all by these where it is `held`.
    Direct { chance: u64, held: Held },
    /// All by rays that this number chooses.
    Gathered(u64),
}

impl<'a> MetLight<'a> {
    /// The light of `solution` behind these obstacles.
    pub(super) fn of(solution: &'a Solution, visibility: &'a Visibility) -> Self {
        let (scale, usual) = (solution.mean_radiosity(), solution.mean_arriving());
        let rays = SentRays::among(solution.elements(), &solution.emitters(), visibility, &scale);
        Self {
            solution,
            sent: solution.sent(),
            lit_cells: LitCells::of(&rays),
            rays,
            known_lamps: KnownLamps::of(solution.elements(), &solution.emitters()),
            glow: Glow::of(solution, &usual),
            bends: bends(solution, &usual, SentLight::All, Part::Highest),
            scale,
            usual,
        }
    }

    /// Adds `factor` times what the place that a ray met reflects and lets through.
    pub(super) fn add_reflected_by(
        &self,
        met: &Met,
        end_light: EndLight,
        factor: f64,
        radiosity: &mut [f64],
    ) {
        let Met { element, ref place, distance, .. } = *met;
        let solution = self.sent;
        let irradiance = self.arriving(element, place, &|| met.there(), distance, end_light);
        let beyond = solution.behind(element, place).map(|(behind, place)| {
            self.arriving(behind, &place, &|| met.beyond(&place), distance, end_light)
        });
        for (index, (out, band)) in radiosity.iter_mut().zip(solution.bands()).enumerate() {
            let coating = &band.coating;
            *out += factor * coating.reflectance_at(element, place.parameters) * irradiance[index];
            if let Some(beyond) = &beyond {
                *out += factor * coating.transmittance(element) * beyond[index];
            }
        }
    }

    /// Adds `factor` times the exitance of what a cosine-distributed ray met with the weight that the balance heuristic
    /// leaves beside the rays `to_lamps`; nothing where there are none.
    pub(super) fn add_emitted_by(
        &self,
        receiver: &ReceiverPoint,
        met: &Met,
        to_lamps: Option<AimedRays>,
        factor: f64,
        sums: &mut [f64],
    ) {
        let exitance = factor * self.rays.exitance_left(receiver, met, to_lamps);
        for (out, band) in sums.iter_mut().zip(self.sent.bands()) {
            *out += exitance * band.coating.exitance[met.element];
        }
    }

    /// Adds `scale` times the light of one ray to an emitter.
    pub(super) fn add_lamp(
        &self,
        receiver: &ReceiverPoint,
        target: &Target,
        mix: RayMix,
        scale: f64,
        sums: &mut [f64],
    ) {
        let Some(LampLight { element, share }) = self.rays.lamp_light(receiver, target, mix) else { return };
        for (sum, band) in sums.iter_mut().zip(self.sent.bands()) {
            *sum += scale * share * band.coating.exitance[element];
        }
    }

    /// Adds an estimate of the light of the luminaires by one ray, to one of them.
    pub(super) fn add_point(&self, receiver: &ReceiverPoint, chance: u64, irradiance: &mut [f64]) {
        let own = number_of([f64::from_bits(chance), 1.0]);
        self.rays.points.add_one(receiver, self.rays.visibility, 1.0, own, irradiance);
    }

    /// An estimate of the irradiance (W m⁻²) per band where a ray ends, so far from where it began.
    fn arriving(
        &self,
        element: usize,
        place: &SurfacePlace,
        there: &dyn Fn() -> ReceiverPoint,
        distance: f64,
        end_light: EndLight,
    ) -> SmallVec<[f64; FEW_BANDS]> {
        let mut irradiance = smallvec![0.0; self.sent.bands().len()];
        match end_light {
            EndLight::Polynomials => self.hold(element, place, &mut irradiance),
            EndLight::Direct { chance, held } => {
                if self.is_held(element, distance, held) {
                    self.hold(element, place, &mut irradiance);
                } else {
                    self.hold_reflected(element, place, &mut irradiance);
                    let by_cells = || self.lit_cells.at(self.sent, &self.rays, element, place, distance);
                    match if held.cells { by_cells() } else { None } {
                        Some(lit) => irradiance.iter_mut().zip(lit).for_each(|(sum, lit)| *sum += lit),
                        None => self.add_direct(&there(), chance, &mut irradiance),
                    }
                }
            }
            EndLight::Gathered(chance) => self.add_estimate(&there(), chance, &mut irradiance),
        }
        irradiance
    }

    /// Whether readings take all light of an element from its polynomials, because it is seen small from this distance
    /// and light bends little on it. Never among luminaires: before one of them light peaks, which no polynomial
    /// follows.
    fn is_held(&self, element: usize, distance: f64, held: Held) -> bool {
        self.rays.points.is_empty()
            && self.bends[element] < held.smooth
            && is_small(&self.sent.elements().list()[element], held.small * distance)
    }

    /// Puts the polynomials E_h ≥ 0 of all light into `irradiance` (W m⁻² per band).
    fn hold(&self, element: usize, place: &SurfacePlace, irradiance: &mut [f64]) {
        self.sent.irradiance_bands(element, place, irradiance);
        irradiance.iter_mut().for_each(|held| *held = held.max(0.0));
    }

    /// Puts the polynomials S_h ≥ 0 of reflected light into `irradiance` (W m⁻² per band).
    fn hold_reflected(&self, element: usize, place: &SurfacePlace, irradiance: &mut [f64]) {
        self.sent.indirect_bands(element, place, irradiance);
        irradiance.iter_mut().for_each(|held| *held = held.max(0.0));
    }

    /// Adds an estimate of the direct light by one ray to an emitter, and one to a luminaire.
    fn add_direct(&self, receiver: &ReceiverPoint, chance: u64, irradiance: &mut [f64]) {
        self.add_point(receiver, chance, irradiance);
        let shares = self.rays.lamps.seen_from(receiver);
        if shares.is_empty() {
            return;
        }
        let Draws { direction: [polar, turn], target: [choice, s, t], .. } = Draws::of(chance);
        let is_near = self.rays.lamps.is_near(receiver, NEAR);
        for LampLight { element, share } in
            self.rays.direct(receiver, &shares, [choice, s, t, polar, turn], is_near)
        {
            let bands = irradiance.iter_mut().zip(self.sent.bands());
            bands.for_each(|(sum, band)| *sum += share * band.coating.exitance[element]);
        }
    }

    /// Adds an estimate of the irradiance by one ray of each kind that `chance` chooses; what the cosine-distributed
    /// one meets has the light of the polynomials.
    fn add_estimate(&self, receiver: &ReceiverPoint, chance: u64, irradiance: &mut [f64]) {
        self.add_point(receiver, chance, irradiance);
        let shares = self.rays.lamps.seen_from(receiver);
        let draws = Draws::of(chance);
        let direction = lambert(receiver.normal, draws.direction);
        let to_lamps = Some(AimedRays { shares: &shares, ratio: 1.0 });
        if let Some(met) = self.rays.met(receiver, direction) {
            self.add_reflected_by(&met, EndLight::Polynomials, 1.0, irradiance);
            self.add_emitted_by(receiver, &met, to_lamps, 1.0, irradiance);
        }
        if !shares.is_empty() {
            let mix = RayMix { cosine: 1.0, to_lamps: 1.0 };
            self.add_lamp(receiver, &shares.target(draws.target), mix, 1.0, irradiance);
        }
    }
}

/// Whether an element is smaller than a square of this width.
fn is_small(element: &Element, width: f64) -> bool {
    element.area < width * width
}
