//! Walks: unbiased estimates of the irradiance at a point.
//!
//! ```text
//! E(x) = π ⟨ L(y, −ω) ⟩ ,   ω by the cosine from x, y what it meets first ,     π L = M a + ρ E(y) + τ E′(y)
//! ```
//!
//! The light M a of lamps is found in two ways, by one point on them (of the density p_l per solid angle) and by the
//! cosine ray (of the density p_c = cos θ/π, traced with the probability q), which the power heuristic adds up:
//!
//! ```text
//! E_lamps(x) = f p_l / (p_l² + q² p_c²) at the point on a lamp  +  f q p_c / (p_l² + q² p_c²) at the end of the ray ,
//! f = L cos θ V
//! ```
//!
//! By the balance heuristic, f / (p_l + q p_c), the rare rays that end on a small lamp would bring a hundredth of its
//! light; where none of them ends there all shifts were that much too low, and told of no spread.
//!
//! A walk of the weight w goes on from a hit with the probability q = min(1, k w); the ray of the point that is read
//! is traced always.
//!
//! Reference: E. Veach, *Robust Monte Carlo methods for light transport simulation*, 1997, chapters 9 and 10.

use std::f64::consts::{PI, TAU};

use radiosity_geom::{DVec3, Ray};

use crate::groups::Groups;
use crate::lamps::Lamps;
use crate::lattice::Draws;
use crate::rays::{Place, Rays};
use crate::sheets::Sheet;
use crate::skin::{Absorbed, Skin};
use crate::spectrum::Spectrum;
use crate::suns::Suns;

/// Most vertices of a walk: a longer one is caught where nothing absorbs, and tells no number. Chosen: out of
/// a hole of a ten-thousandth of a white cavity all but 10⁻¹¹ of the walks are shorter.
const LONGEST: usize = 1 << 18;

/// Draws that tell where a walk starts.
const START: usize = 2;

/// Draws of a vertex: its direction, whether the walk goes on, a lamp and a point on it, what becomes of light at
/// the hit that follows, and where it leaves a sheet.
const VERTEX: usize = 10;

/// Places of these draws in those of a vertex.
const GOES_ON: usize = 2;
const LAMP: usize = 3;
const LEAVES: usize = 6;

/// The scene as walks know it, some bands of it.
#[derive(Debug)]
pub(crate) struct Ground<'a> {
    pub(crate) rays: &'a Rays,
    pub(crate) groups: &'a Groups,
    pub(crate) skins: Vec<Skin>,
    pub(crate) lamps: Lamps,
    pub(crate) suns: Suns,
    pub(crate) sheets: &'a [Sheet],
    /// π times the radiance of all that is no front: of black backs and of what surrounds the scene (W m⁻²).
    pub(crate) surroundings: Spectrum,
    /// Probability k with which a walk of the weight 1 goes on from a hit.
    pub(crate) going_on: f64,
}

/// A point that receives along its normal, just before any surface that it lies on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    pub(crate) point: DVec3,
    pub(crate) normal: DVec3,
}

/// Sums over walks, by light group, and the number of rays.
#[derive(Clone, Debug)]
pub(crate) struct Scores {
    pub(crate) groups: Vec<Spectrum>,
    /// Part of the places where walks may start that nothing stands on.
    pub(crate) bare: f64,
    pub(crate) rays: u64,
}

impl Scores {
    /// No walks, of so many groups.
    pub(crate) fn none(groups: usize) -> Self {
        Self { groups: vec![Spectrum::default(); groups], bare: 1.0, rays: 0 }
    }

    /// Whether a walk was caught, so that they tell no number.
    pub(crate) fn are_lost(&self) -> bool {
        self.groups[0].sum().is_nan()
    }
}

impl Ground<'_> {
    /// Adds the irradiance at a vertex by the point on a lamp of three draws, beside a part of cosine rays.
    fn add_lamp(&self, vertex: &Vertex, weight: Spectrum, part: f64, draws: [f64; 3], scores: &mut Scores) {
        let Vertex { point, normal } = *vertex;
        let lamp = self.lamps.point(self.rays, &self.skins, self.groups, draws, point, normal);
        let Some(lamp) = lamp.filter(|lamp| !lamp.irradiance.is_dark()) else { return };
        scores.rays += 1;
        let is_seen = match lamp.surface {
            Some(surface) => self.rays.sees(point, surface, lamp.end),
            None => self.rays.is_free(point, lamp.end),
        };
        if !is_seen {
            return;
        }
        let beside = |density: f64| part * lamp.cosine / (PI * density);
        let share = lamp.density.map_or(1.0, |density| (1.0 + beside(density).powi(2)).recip());
        scores.groups[lamp.group] += share * (weight * lamp.irradiance);
    }

    /// Adds the irradiance by suns at a vertex.
    fn add_suns(&self, vertex: &Vertex, weight: Spectrum, scores: &mut Scores) {
        let Vertex { point, normal } = *vertex;
        let groups = &mut scores.groups;
        let take = |opening, irradiance| groups[self.groups.of_surface(opening)] += weight * irradiance;
        scores.rays += self.suns.at(self.rays, point, normal, take);
    }

    /// Adds a walk of the irradiance at a vertex.
    pub(crate) fn walk(&self, start: Vertex, weight: f64, draws: &mut Draws<'_>, scores: &mut Scores) {
        self.go_on(start, Spectrum::even(weight), 0, draws, scores);
    }

    /// Adds a walk of π times the radiance that comes against a ray.
    pub(crate) fn look(&self, ray: &Ray, draws: &mut Draws<'_>, scores: &mut Scores) {
        scores.rays += 1;
        let weight = Spectrum::even(1.0);
        let Some(place) = self.arrive(self.rays.met(ray), weight, scores) else { return };
        let back = -ray.direction.normalize();
        let sent = self.skins[place.surface].sent(place.parameters, back);
        scores.groups[self.groups.of_surface(place.surface)] += sent;
        draws.go_to(START + LEAVES);
        if let Some((vertex, weight)) = self.leave(&place, weight, draws) {
            self.go_on(vertex, weight, 1, draws, scores);
        }
    }

    /// Adds the irradiance at a vertex by suns and by a point on a lamp, beside a part of cosine rays.
    fn add_direct(
        &self,
        vertex: &Vertex,
        weight: Spectrum,
        part: f64,
        depth: usize,
        draws: &mut Draws<'_>,
        scores: &mut Scores,
    ) {
        self.add_suns(vertex, weight, scores);
        if !self.lamps.is_empty() {
            draws.go_to(START + VERTEX * depth + LAMP);
            let draws = [draws.next(), draws.next(), draws.next()];
            self.add_lamp(vertex, weight, part, draws, scores);
        }
    }

    /// The front that a ray met; what else it met is added.
    fn arrive(&self, met: Option<Place>, weight: Spectrum, scores: &mut Scores) -> Option<Place> {
        if met.is_none() {
            scores.groups[0] += self.surroundings * weight;
        }
        met
    }

    /// Adds the irradiance at a vertex by a walk from it, whose cosine ray is traced for certain.
    fn go_on(
        &self,
        mut vertex: Vertex,
        mut weight: Spectrum,
        mut depth: usize,
        draws: &mut Draws<'_>,
        scores: &mut Scores,
    ) {
        let mut part = 1.0;
        self.add_direct(&vertex, weight, part, depth, draws, scores);
        loop {
            if depth > LONGEST {
                scores.groups[0] += Spectrum::even(f64::NAN);
                return;
            }
            draws.go_to(START + VERTEX * depth);
            let along = cosine_direction(vertex.normal, draws.pair());
            scores.rays += 1;
            let met = self.rays.first(vertex.point, along);
            let traced = (1.0 / part) * weight;
            let Some(place) = self.arrive(met, traced, scores) else { return };
            let skin = &self.skins[place.surface];
            if skin.emits() {
                let sent = skin.sent(place.parameters, -along);
                let beside = match self.lamps.is_empty() {
                    true => 0.0,
                    false => {
                        let density = self.lamps.density(&place, vertex.point, vertex.normal);
                        density * PI / vertex.normal.dot(along)
                    }
                };
                scores.groups[self.groups.of_surface(place.surface)] +=
                    (part / (part * part + beside * beside)) * (weight * sent);
            }
            draws.go_to(START + VERTEX * depth + LEAVES);
            let Some((next, left)) = self.leave(&place, traced, draws) else { return };
            depth += 1;
            part = (self.going_on * left.largest()).min(1.0);
            self.add_direct(&next, left, part, depth, draws, scores);
            draws.go_to(START + VERTEX * depth + GOES_ON);
            if draws.next() >= part {
                return;
            }
            (vertex, weight) = (next, left);
        }
    }

    /// Where a walk leaves a surface that it arrived at with a weight, and the weight that it leaves with; None
    /// where it ends.
    fn leave(&self, place: &Place, weight: Spectrum, draws: &mut Draws<'_>) -> Option<(Vertex, Spectrum)> {
        let skin = &self.skins[place.surface];
        let reflected = weight * skin.reflectance(place.parameters);
        let through = weight * skin.transmittance;
        let (kept, sheet) = match skin.absorbed {
            Absorbed::Kept => (0.0, 0),
            Absorbed::Sheet { sheet, emissivity } => (emissivity * weight.largest(), sheet),
        };
        let ways = [reflected.largest(), through.largest(), kept];
        let all: f64 = ways.iter().sum();
        if all <= 0.0 {
            return None;
        }
        let choice = if ways[0] == all { 0.0 } else { all * draws.next() };
        if choice < ways[0] {
            return Some((self.vertex(place, place.normal), (all / ways[0]) * reflected));
        }
        if choice < ways[0] + ways[1] {
            return Some((self.vertex(place, -place.normal), (all / ways[1]) * through));
        }
        let (from, share) = self.sheets[sheet].leave(self.rays, draws)?;
        let Absorbed::Sheet { emissivity, .. } = skin.absorbed else { return None };
        Some((self.vertex(&from, from.normal), (all / ways[2] * emissivity * share) * weight))
    }

    /// The vertex of a walk that leaves a place by a unit normal of either side.
    fn vertex(&self, place: &Place, normal: DVec3) -> Vertex {
        Vertex { point: self.rays.left(place, normal), normal }
    }
}

/// The direction of two draws by the cosine about a unit vector.
pub(crate) fn cosine_direction(normal: DVec3, [s, t]: [f64; 2]) -> DVec3 {
    let (x, y) = normal.any_orthonormal_pair();
    let (sine, cosine) = (TAU * t).sin_cos();
    let radius = s.sqrt();
    radius * (cosine * x + sine * y) + (1.0 - s).sqrt() * normal
}
