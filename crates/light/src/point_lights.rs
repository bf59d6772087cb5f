//! Luminaires without an area and the sun as sources of direct light: points and lines that send an intensity
//! in each direction, near or at infinity.
//!
//! ```text
//! D(x) = Σ_l s_l d_l(ω) cos θ V(x, p_l) / |p_l − x|²        W m⁻²
//! ```
//!
//! with the position p, the strength s of a band (W/sr) and the relative intensity d of each luminaire
//! ([`radiosity_scene::Distribution`]), the direction ω from it to x, and V by one ray to the true surfaces:
//! D is exact. The irradiance of a line is the mean over its points (`luminous_line`). The sun gives s cos θ
//! where the first thing before it is an opening to the sky, with the strength s (W m⁻²) behind that; without
//! shadows the first opening before it gives so, whatever else stands there.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use radiosity_elements::sampling::shift::shift;
use radiosity_geom::{Aabb, DVec3, Encounter, Rect, distance_to_segment};
use radiosity_scene::{Luminaire, Radiance, Scene, SceneSurface};
use radiosity_visibility::Visibility;

use crate::luminous_line::{LuminousLine, irradiance};
use crate::receiver_point::ReceiverPoint;

/// Solid angle (sr) that all light would fill at the greatest intensity, below which a beam is narrow. Chosen: a
/// diffuse emitter has π, a spot of 60° 0.84.
const NARROW: f64 = 1.0;

/// Breadth of a cell over that of a beam across it, below which points of the cell lie in the beam: the spot of 10°
/// that shines 3 m down on a patch 3 m wide, 0.52 m broad there, is found by the cells of three levels, 0.37 m wide.
/// Chosen.
const FOUND: f64 = 0.75;

/// Most levels of cells that are made so that beams are found: down to an eighth. Chosen.
const MOST_LEVELS: u32 = 3;

/// The luminaires that shine and are no areas, and the sun.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointLights {
    list: Vec<PointLight>,
    /// The sun, once for each sky that openings see.
    suns: Vec<SunBeam>,
}

/// The sun as it shines through openings.
#[derive(Clone, Debug, PartialEq)]
struct SunBeam {
    /// Unit vector to it.
    direction: DVec3,
    /// Irradiance per band (W m⁻²) across the beam behind openings, by their surfaces; 0 behind those that
    /// are dark.
    strengths: BTreeMap<usize, Vec<f64>>,
    /// Flux per band (W) through all of them.
    flux: Vec<f64>,
    /// Breadth of the narrowest of them (scene length).
    breadth: f64,
}

impl SunBeam {
    /// Beams of the sun in a scene, without dark ones, through the surfaces at a factor of each.
    fn through(scene: &Scene, factor: impl Fn(&SceneSurface) -> f64) -> Vec<Self> {
        let mut beams: Vec<Self> = Vec::new();
        for (index, surface) in scene.surfaces.iter().enumerate() {
            let factor = factor(surface);
            let beam = surface
                .radiance
                .as_ref()
                .and_then(Radiance::outlook)
                .and_then(|own| Some((own, own.beam()?)));
            let Some((outlook, (direction, strength))) = beam else { continue };
            let strength: Vec<f64> = strength.into_iter().map(|strength| factor * strength).collect();
            let area = surface.shape.area() * outlook.incidence(direction);
            let place = beams.iter().position(|beam| beam.direction == direction).unwrap_or(beams.len());
            if place == beams.len() {
                let flux = vec![0.0; strength.len()];
                beams.push(Self { direction, strengths: BTreeMap::new(), flux, breadth: f64::INFINITY });
            }
            let beam = &mut beams[place];
            let length = surface.shape.bounds(&Rect::FULL).diagonal();
            beam.breadth = beam.breadth.min(surface.shape.area() / length);
            beam.flux.iter_mut().zip(&strength).for_each(|(flux, strength)| *flux += area * strength);
            beam.strengths.insert(index, strength);
        }
        beams.retain(|beam| beam.flux.iter().any(|flux| *flux > 0.0));
        beams
    }

    /// Adds `scale` times its irradiance at a point.
    fn add(&self, receiver: &ReceiverPoint, visibility: &Visibility, scale: f64, sums: &mut [f64]) {
        let cosine = receiver.normal.dot(self.direction);
        if cosine <= 0.0 || receiver.ground.is_some_and(|ground| ground.dot(self.direction) <= 0.0) {
            return;
        }
        if let Some(strength) = self.arriving(receiver, visibility) {
            let factor = scale * cosine;
            sums.iter_mut().zip(strength).for_each(|(sum, strength)| *sum += factor * strength);
        }
    }

    /// Irradiance per band (W m⁻²) across it at a point: what the first surface before the sun lets through,
    /// or the first opening where there are no shadows.
    fn arriving(&self, receiver: &ReceiverPoint, visibility: &Visibility) -> Option<&Vec<f64>> {
        let mut met = visibility.met_along(receiver.surface, receiver.position, self.direction);
        let behind = |met: Encounter| self.strengths.get(&met.surface).filter(|_| met.front);
        if visibility.casts() { behind(met.next()?) } else { met.find_map(behind) }
    }
}

/// A luminaire at its factor.
#[derive(Clone, Debug)]
struct PointLight {
    luminaire: Luminaire,
    /// From its middle to an end, of a line.
    half: DVec3,
    /// Strength per band (W/sr), dimmed.
    strength: Vec<f64>,
}

impl PartialEq for PointLight {
    /// Whether both send the same light, whatever they are called.
    fn eq(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|light| &light.luminaire);
        let is_there = own.position == others.position && own.extent == others.extent;
        is_there && own.is_aimed_as(others) && self.strength == other.strength
    }
}

impl PointLight {
    /// Breadth (scene length) of its beam where it is nearest to a box; None where it is not narrow.
    fn breadth_of_beam(&self, bounds: &Aabb) -> Option<f64> {
        let distribution = &self.luminaire.distribution;
        let filled = distribution.flux_factor() / distribution.peak();
        let cosine = 1.0 - filled / TAU;
        let distance = bounds.distance_squared(self.luminaire.position).sqrt() - self.half.length();
        (filled < NARROW).then(|| 2.0 * distance.max(0.0) * (1.0 - cosine * cosine).sqrt() / cosine)
    }

    /// A luminaire at a factor; None where it is dark, or its light comes out of an area.
    fn of(luminaire: &Luminaire, factor: f64) -> Option<Self> {
        let shines = luminaire.emits() && factor > 0.0 && !luminaire.extent.is_area();
        shines.then(|| Self {
            luminaire: luminaire.clone(),
            half: luminaire.half_line(),
            strength: luminaire.strength.iter().map(|strength| factor * strength).collect(),
        })
    }

    /// Irradiance at a point over its strength.
    fn irradiance(&self, receiver: &ReceiverPoint, visibility: &Visibility) -> f64 {
        if self.half != DVec3::ZERO {
            return LuminousLine::new(&self.luminaire, self.half, receiver).irradiance(visibility);
        }
        let factor = self.factor(receiver, 0.5);
        factor.filter(|_| self.is_seen(receiver, 0.5, visibility)).unwrap_or(0.0)
    }

    /// Point of the line at a part of its length.
    fn at(&self, part: f64) -> DVec3 {
        self.luminaire.position + (2.0 * part - 1.0) * self.half
    }

    /// Irradiance at a point without shadows over its strength, if all its light came from its point at a
    /// `part` of its length; None where it is 0.
    fn factor(&self, receiver: &ReceiverPoint, part: f64) -> Option<f64> {
        let step = self.at(part) - receiver.position;
        let is_below = receiver.ground.is_some_and(|ground| ground.dot(step / step.length()) <= 0.0);
        let factor = irradiance(&self.luminaire, self.at(part), receiver);
        (!is_below && factor > 0.0).then_some(factor)
    }

    /// Whether nothing stands between its point at a `part` of its length and a point.
    fn is_seen(&self, receiver: &ReceiverPoint, part: f64, visibility: &Visibility) -> bool {
        !visibility.casts() || visibility.is_free(receiver.surface, receiver.position, self.at(part))
    }

    /// Strength, summed over the bands.
    fn brightness(&self) -> f64 {
        self.strength.iter().sum()
    }

    fn add(&self, factor: f64, sums: &mut [f64]) {
        sums.iter_mut().zip(&self.strength).for_each(|(sum, strength)| *sum += factor * strength);
    }
}

impl PointLights {
    /// The luminaires of a scene, and the sun behind its openings, at the factors of their groups.
    pub fn of(scene: &Scene) -> Self {
        let list = scene.luminaires.iter().filter_map(|own| PointLight::of(own, own.factor())).collect();
        Self { list, suns: SunBeam::through(scene, SceneSurface::factor) }
    }

    /// The members of a light group, or of no group for None, not dimmed.
    pub fn of_group(scene: &Scene, group: Option<&str>) -> Self {
        let members = scene.luminaires.iter().filter(|own| own.is_in(group));
        let list = members.filter_map(|own| PointLight::of(own, 1.0)).collect();
        Self { list, suns: SunBeam::through(scene, |own| f64::from(own.is_in(group))) }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty() && self.suns.is_empty()
    }

    /// Levels of quarters of a thing in this box in which beams of the sun, and narrow ones of luminaires, that light
    /// a part of it alone do not pass between the points.
    pub(crate) fn levels_of_beams(&self, bounds: &Aabb) -> usize {
        let narrow = self.list.iter().filter_map(|light| light.breadth_of_beam(bounds));
        let narrowest = narrow.chain(self.suns.iter().map(|sun| sun.breadth)).fold(f64::INFINITY, f64::min);
        let reaches = |level: &u32| bounds.diagonal() <= FOUND * narrowest * f64::from(1 << level);
        (0..MOST_LEVELS).find(reaches).unwrap_or(MOST_LEVELS) as usize
    }

    /// Their number.
    pub fn count(&self) -> usize {
        self.list.len() + self.suns.len()
    }

    /// Whether the sun is among them.
    pub fn has_sun(&self) -> bool {
        !self.suns.is_empty()
    }

    /// Where the luminaires are: the ends of each, which are one of a point.
    pub fn ends(&self) -> impl Iterator<Item = [DVec3; 2]> {
        self.list.iter().map(|light| [light.at(0.0), light.at(1.0)])
    }

    /// Whether a luminaire is within a distance (scene length) of a point.
    pub fn is_within(&self, point: DVec3, distance: f64) -> bool {
        self.ends().any(|[start, end]| match start == end {
            true => point.distance(start) <= distance,
            false => distance_to_segment(point, [start, end]) <= distance,
        })
    }

    /// Their flux in a band (W).
    pub fn flux(&self, band: usize) -> f64 {
        let factor = |light: &PointLight| light.luminaire.distribution.flux_factor();
        let luminaires: f64 = self.list.iter().map(|light| factor(light) * light.strength[band]).sum();
        luminaires + self.suns.iter().map(|sun| sun.flux[band]).sum::<f64>()
    }

    /// Adds their irradiance (W m⁻²) per band at a point to `sums`.
    pub fn add(&self, receiver: &ReceiverPoint, visibility: &Visibility, sums: &mut [f64]) {
        for light in &self.list {
            let factor = light.irradiance(receiver, visibility);
            light.add(factor, sums);
        }
        self.suns.iter().for_each(|sun| sun.add(receiver, visibility, 1.0, sums));
    }

    /// Adds an estimate of `scale` times the same by a ray to the sun, and one to a luminaire and a part of
    /// its length that `chance` chooses, in proportion to the light without shadows.
    pub fn add_one(
        &self,
        receiver: &ReceiverPoint,
        visibility: &Visibility,
        scale: f64,
        chance: u64,
        sums: &mut [f64],
    ) {
        self.suns.iter().for_each(|sun| sun.add(receiver, visibility, scale, sums));
        let [choice, part] = shift(chance);
        let factors = || self.list.iter().filter_map(|light| Some((light, light.factor(receiver, part)?)));
        let all: f64 = factors().map(|(light, factor)| factor * light.brightness()).sum();
        let mut rest = choice * all;
        let mut chosen = None;
        for (light, factor) in factors() {
            let own = factor * light.brightness();
            chosen = Some((light, factor * all / own));
            if rest < own {
                break;
            }
            rest -= own;
        }
        if let Some((light, factor)) = chosen.filter(|(light, _)| light.is_seen(receiver, part, visibility)) {
            light.add(scale * factor, sums);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_geom::shapes::Parallelogram;
    use radiosity_scene::{Distribution, Material, SceneBuilder, Strength};

    use super::*;

    /// A lamp 3 above a floor, of the intensity cosⁿ γ.
    fn lamp(exponent: f64) -> PointLights {
        let mut builder = SceneBuilder::new("floor", ["grey"]);
        let black = builder.material("black", Material::black(1));
        let floor = Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y).expect("a floor");
        builder.surface("floor", Arc::new(floor), &black);
        let strength = Strength::Intensity(vec![1.0]);
        let lamp = Luminaire::new("lamp", 3.0 * DVec3::Z, Distribution::Power { exponent }, strength);
        builder.luminaire(lamp.expect("a lamp"));
        PointLights::of(&builder.build().expect("a scene"))
    }

    fn levels(lights: &PointLights, side: f64) -> usize {
        lights.levels_of_beams(&Aabb { min: DVec3::ZERO, max: side * (DVec3::X + DVec3::Y) })
    }

    /// cos⁶⁰ γ fills 2π/61, a cone of 10.4°, which is 1.10 broad 3 below.
    #[test]
    fn cells_are_made_until_they_are_narrower_than_a_beam() {
        let narrow = lamp(60.0);
        assert_eq!(
            [0.01, 0.58, 0.59, 1.16, 1.17, 3.0, 9.0].map(|side| levels(&narrow, side)),
            [0, 0, 1, 1, 2, 3, 3]
        );
        assert_eq!(levels(&lamp(1.0), 9.0), 0, "it is no beam");
    }
}
