//! Walks: unbiased estimates of the irradiance at a point.
//!
//! ```text
//! E(x) = π ⟨ L(y, −ω) ⟩ ,   ω by the cosine from x, y what it meets first ,     π L = M a + ρ E(y) + τ E′(y)
//! ```
//!
//! The light M a of lamps is found by two ways, points on them (n of density p_l per solid angle) and the
//! cosine rays (density p_c = cos θ/π, of which a part q is traced), added by the balance heuristic:
//!
//! ```text
//! E_lamps(x) = Σ_{lamp points} f / (n p_l + q p_c)  +  Σ_{cosine rays} f / (n p_l + q p_c) ,   f = L cos θ V
//! ```
//!
//! At a point that is read, n and q may be large and 1; at hits n is 1. A walk of the weight w goes on from a
//! hit with the probability min(1, k w), k ≤ 1: what is left of a walk adds little noise and most of the rays.
//!
//! Reference: E. Veach, *Robust Monte Carlo methods for light transport simulation*, 1997, chapters 9 and 10.

use std::f64::consts::{PI, TAU};

use radiosity_geom::{DVec3, Ray};

use crate::groups::Groups;
use crate::lamps::Lamps;
use crate::lattice::Draws;
use crate::rays::{Met, Place, Rays};
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
    pub(crate) surroundings: [Spectrum; 2],
    /// Probability k with which a walk of the weight 1 goes on from a hit.
    pub(crate) going_on: f64,
}

/// A point that receives along its normal.
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
    /// Adds the irradiance by lamps and suns at a vertex, from `points` points on lamps of which the draws
    /// `draw` tell one each, beside a part `part` of cosine rays.
    fn add_direct(
        &self,
        vertex: &Vertex,
        weight: Spectrum,
        [points, part]: [f64; 2],
        draw: [f64; 3],
        scores: &mut Scores,
    ) {
        let Vertex { point, normal } = *vertex;
        let lamp = self.lamps.point(self.rays, &self.skins, self.groups, draw, point, normal);
        let Some(lamp) = lamp.filter(|lamp| !lamp.irradiance.is_dark()) else { return };
        scores.rays += 1;
        if !self.rays.is_free(point, normal, lamp.end) {
            return;
        }
        let share = match lamp.density {
            None => 1.0 / points,
            Some(density) => {
                let cosine = normal.dot((lamp.end - point).normalize());
                density / (points * density + part * cosine / PI)
            }
        };
        scores.groups[lamp.group] += share * (weight * lamp.irradiance);
    }

    /// Adds the irradiance by suns at a vertex.
    fn add_suns(&self, vertex: &Vertex, weight: Spectrum, scores: &mut Scores) {
        let Vertex { point, normal } = *vertex;
        let groups = &mut scores.groups;
        let take = |opening, irradiance| groups[self.groups.of_surface(opening)] += weight * irradiance;
        scores.rays += self.suns.at(self.rays, point, normal, take);
    }

    /// Adds what points on lamps tell of the irradiance at a vertex that is read, one of `points` beside each
    /// cosine ray.
    pub(crate) fn add_lamp_point(
        &self,
        vertex: &Vertex,
        weight: f64,
        points: f64,
        draw: [f64; 3],
        scores: &mut Scores,
    ) {
        if !self.lamps.is_empty() {
            self.add_direct(vertex, Spectrum::even(weight), [points, 1.0], draw, scores);
        }
    }

    /// Adds a walk of the irradiance at a vertex that is read, beside `points` points on lamps.
    pub(crate) fn walk(
        &self,
        start: &Vertex,
        weight: f64,
        points: f64,
        draws: &mut Draws<'_>,
        scores: &mut Scores,
    ) {
        let weight = Spectrum::even(weight);
        self.add_suns(start, weight, scores);
        self.go_on(*start, weight, points, 0, draws, scores);
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
            self.add_hit(&vertex, weight, 1.0, 1, draws, scores);
            self.go_on(vertex, weight, 1.0, 1, draws, scores);
        }
    }

    /// Adds the light of suns and of a point on a lamp at a hit, beside a part of cosine rays.
    fn add_hit(
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
            let draw = [draws.next(), draws.next(), draws.next()];
            self.add_direct(vertex, weight, [1.0, part], draw, scores);
        }
    }

    /// The front that a ray met; what else it met is added.
    fn arrive(&self, met: Met, weight: Spectrum, scores: &mut Scores) -> Option<Place> {
        let seen = match met {
            Met::Front(place) => return Some(place),
            Met::Back => self.surroundings[0],
            Met::Nothing => self.surroundings[1],
        };
        scores.groups[0] += seen * weight;
        None
    }

    /// Follows a cosine ray from a vertex, and all that comes after it; `points` points on lamps stand beside it.
    fn go_on(
        &self,
        mut vertex: Vertex,
        mut weight: Spectrum,
        mut points: f64,
        mut depth: usize,
        draws: &mut Draws<'_>,
        scores: &mut Scores,
    ) {
        let mut part = 1.0;
        loop {
            if depth > LONGEST {
                scores.groups[0] += Spectrum::even(f64::NAN);
                return;
            }
            draws.go_to(START + VERTEX * depth);
            let along = cosine_direction(vertex.normal, draws.pair());
            scores.rays += 1;
            let met = self.rays.first(vertex.point, vertex.normal, along);
            let traced = (1.0 / part) * weight;
            let Some(place) = self.arrive(met, traced, scores) else { return };
            let skin = &self.skins[place.surface];
            if skin.emits() {
                let sent = skin.sent(place.parameters, -along);
                let beside = match self.lamps.is_empty() {
                    true => 0.0,
                    false => {
                        let density = self.lamps.density(&place, vertex.point, vertex.normal);
                        points * density * PI / vertex.normal.dot(along)
                    }
                };
                scores.groups[self.groups.of_surface(place.surface)] +=
                    (1.0 / (part + beside)) * (weight * sent);
            }
            draws.go_to(START + VERTEX * depth + LEAVES);
            let Some((next, left)) = self.leave(&place, traced, draws) else { return };
            depth += 1;
            part = (self.going_on * left.largest()).min(1.0);
            self.add_hit(&next, left, part, depth, draws, scores);
            draws.go_to(START + VERTEX * depth + GOES_ON);
            if draws.next() >= part {
                return;
            }
            (vertex, weight, points) = (next, left, 1.0);
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
            return Some((Vertex { point: place.point, normal: place.normal }, (all / ways[0]) * reflected));
        }
        if choice < ways[0] + ways[1] {
            return Some((Vertex { point: place.point, normal: -place.normal }, (all / ways[1]) * through));
        }
        let (from, share) = self.sheets[sheet].leave(self.rays, draws)?;
        let Absorbed::Sheet { emissivity, .. } = skin.absorbed else { return None };
        let vertex = Vertex { point: from.point, normal: from.normal };
        Some((vertex, (all / ways[2] * emissivity * share) * weight))
    }
}

/// The direction of two draws by the cosine about a unit vector.
pub(crate) fn cosine_direction(normal: DVec3, [s, t]: [f64; 2]) -> DVec3 {
    let (x, y) = normal.any_orthonormal_pair();
    let (sine, cosine) = (TAU * t).sin_cos();
    let radius = s.sqrt();
    radius * (cosine * x + sine * y) + (1.0 - s).sqrt() * normal
}
