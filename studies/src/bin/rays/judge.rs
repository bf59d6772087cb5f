//! Irradiance at points with known answers, read from a solution by rays.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::path::Path;

use radiosity::Scene;
use radiosity::elements::patch::Node;
use radiosity::geom::{DVec3, Encounter, Ray};
use radiosity::solve::solution::{Solution, SurfacePlace};
use radiosity::visibility::{Shadows, Visibility};
use rayon::prelude::*;
use serde::Deserialize;

/// Rays of a point, along either side of the square of directions.
const DIRECTIONS: usize = 128;

/// Samples of an emitter's patch along either side.
const SAMPLES: usize = 16;

/// Height over its surface at which a point is read, and distance from a sample of an emitter that a ray must
/// reach (scene length): the faces of rooms are rounded to less.
const ABOVE: f64 = 1e-6;

/// Points with known irradiance.
#[derive(Deserialize)]
pub(crate) struct Points {
    points: Vec<Point>,
}

#[derive(Deserialize)]
struct Point {
    p: [f64; 3],
    n: [f64; 3],
    #[serde(rename = "E")]
    irradiance: f64,
}

/// A solution that is read.
struct Lit<'a> {
    solution: &'a Solution,
    visibility: Visibility,
    /// Samples of the emitters: element and node.
    emitters: Vec<(usize, Node)>,
}

impl Points {
    /// The points of a file.
    pub(crate) fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        Ok(serde_json::from_str(&std::fs::read_to_string(path)?)?)
    }

    /// Points spread over all elements of a scene by area, `count` in all, with the irradiance of `solution`
    /// there (W m⁻²).
    pub(crate) fn of(scene: &Scene, solution: &Solution, count: usize) -> Self {
        let list = solution.elements().list();
        let area: f64 = list.iter().map(|element| element.area).sum();
        let mut spread = Points { points: Vec::new() };
        let mut before = 0.0;
        for element in list.iter().filter(|element| element.contact.is_none()) {
            let [low, high] = [before, before + element.area / area * count as f64];
            before = high;
            for k in low.ceil() as usize..high.ceil() as usize {
                // Anywhere on the element: the additive recurrence by the square root of 2 and of 3.
                let [s, t] = [2f64.sqrt(), 3f64.sqrt()].map(|step| (step * (k + 1) as f64).fract());
                let node = element.patches[k % element.patches.len()].node(s, t);
                let [p, n] = [node.position, node.normal].map(|vector| vector.to_array());
                spread.points.push(Point { p, n, irradiance: 0.0 });
            }
        }
        let known = spread.irradiances(scene, solution);
        spread.points.iter_mut().zip(known).for_each(|(point, irradiance)| point.irradiance = irradiance);
        spread
    }

    /// Irradiances of band 0 by a solution.
    fn irradiances(&self, scene: &Scene, solution: &Solution) -> Vec<f64> {
        let lit = Lit::new(scene, solution);
        self.points.par_iter().map(|point| lit.irradiance(point)).collect()
    }

    /// Relative L2 and median error of the irradiance of band 0.
    pub(crate) fn errors(&self, scene: &Scene, solution: &Solution) -> [f64; 2] {
        let found = self.irradiances(scene, solution);
        let pairs: Vec<(f64, f64)> =
            found.into_iter().zip(&self.points).map(|(found, point)| (found, point.irradiance)).collect();
        let sum = |term: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(term).sum::<f64>();
        let l2 = (sum(&|(a, b)| (a - b).powi(2)) / sum(&|(_, b)| b * b)).sqrt();
        let mean = sum(&|(_, b)| *b) / pairs.len() as f64;
        let bright = pairs.iter().filter(|(_, b)| *b > 0.01 * mean);
        let mut relative: Vec<f64> = bright.map(|(a, b)| (a - b).abs() / b).collect();
        relative.sort_by(f64::total_cmp);
        [l2, relative[relative.len() / 2]]
    }
}

impl<'a> Lit<'a> {
    fn new(scene: &Scene, solution: &'a Solution) -> Self {
        let coating = solution.coatings()[0];
        let list = solution.elements().list();
        let shining = (0..list.len()).filter(|index| coating.exitance[*index] > 0.0);
        let nodes = |index: usize| {
            let patches = list[index].patches.iter();
            patches
                .flat_map(|patch| patch.cell_nodes(SAMPLES))
                .map(move |node| (index, node))
                .collect::<Vec<_>>()
        };
        let emitters = shining.flat_map(nodes).collect();
        Self { solution, visibility: Visibility::new(scene, Shadows::Rays, 1e-3), emitters }
    }

    fn irradiance(&self, point: &Point) -> f64 {
        let normal = DVec3::from_array(point.n).normalize();
        let x = DVec3::from_array(point.p) + ABOVE * normal;
        self.direct(x, normal) + self.reflected(x, normal)
    }

    /// Direct irradiance (W m⁻²) at a point, from samples of the emitters.
    fn direct(&self, x: DVec3, normal: DVec3) -> f64 {
        let list = self.solution.elements().list();
        let coating = self.solution.coatings()[0];
        let share = |(index, node): &(usize, Node)| {
            let step = node.position - x;
            let cosines = [normal.dot(step), -node.normal.dot(step)];
            if cosines.iter().any(|cosine| *cosine <= 0.0) {
                return 0.0;
            }
            let met = self.visibility.nearest(&Ray { range: [0.0, 1.0], ..Ray::new(x, step) });
            let is_free =
                met.is_none_or(|met| met.surface == list[*index].surface || met.hit.t > 1.0 - ABOVE);
            let kernel = cosines[0] * cosines[1] / (PI * step.length_squared().powi(2));
            f64::from(u8::from(is_free)) * coating.exitance[*index] * kernel * node.area
        };
        self.emitters.iter().map(share).sum::<f64>() / (SAMPLES * SAMPLES) as f64
    }

    /// Reflected irradiance (W m⁻²) at a point, from what rays meet, exitance apart: directions are
    /// cosine-distributed, one in each cell of a square.
    fn reflected(&self, x: DVec3, normal: DVec3) -> f64 {
        let (along, across) = normal.any_orthonormal_pair();
        let radiosity = |k: usize| {
            let middle = |cell: usize| (cell as f64 + 0.5) / DIRECTIONS as f64;
            let (polar, turn) = (middle(k / DIRECTIONS), middle(k % DIRECTIONS));
            let (sin, cos) = (TAU * turn).sin_cos();
            let direction = (along * cos + across * sin) * polar.sqrt() + normal * (1.0 - polar).sqrt();
            self.sent_back(&Ray::new(x, direction))
        };
        (0..DIRECTIONS * DIRECTIONS).map(radiosity).sum::<f64>() / (DIRECTIONS * DIRECTIONS) as f64
    }

    /// Reflected radiosity of what a ray meets.
    fn sent_back(&self, ray: &Ray) -> f64 {
        let Some(Encounter { surface, hit, front: true, .. }) = self.visibility.nearest(ray) else {
            return 0.0;
        };
        let Some(element) = self.solution.elements().at(surface, [hit.u, hit.v]) else { return 0.0 };
        let place = SurfacePlace {
            surface,
            parameters: [hit.u, hit.v],
            position: ray.origin + hit.t * ray.direction,
        };
        self.solution.radiosity(0, element, &place) - self.solution.coatings()[0].exitance[element]
    }
}
