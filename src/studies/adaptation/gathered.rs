//! Error of gathered light.
//!
//! Light that is gathered from a solution with the polynomials S_h of its reflected light,
//!
//! ```text
//! E_g = D + G ρ (D + S_h) ,     (G f)(x) = ∫ κ(x, y) V(x, y) f(y) dA_y ,
//! ```
//!
//! D the direct light, misses the light E that would be right by e = E − E_g. Since E = D + Gρ E, and S_g = E_g − D is
//! gathered reflected light,
//!
//! ```text
//! e = d + G ρ e ,     d = G ρ (S_g − S_h) .
//! ```
//!
//! d is estimated at points x by cosine-distributed rays, at whose ends S_g is gathered by cells. Two halves of the rays
//! give d′ and d″, independent of each other: the mean of their product is d², that of a square would have the noise of
//! the rays as well. What follows from d by further reflections is even over the scene, as far as it counts; so the mean of
//! d, and it alone, is taken 1/(1 − q) times, q the mean reflectance that rays meet:
//!
//! ```text
//! ∫ ρ² e² dA ≈ Σ_k ρ² d′d″ ΔA_k + s + ((1 − q)⁻² − 1) m′m″ Σ_k ρ² ΔA_k ,     ΔA_k the area at point k .
//! ```
//!
//! s is the standard deviation of the first sum, so that few points do not promise too much; m′ and m″ are means by area.
//! Sums run over points that reflect.
//! Measured in boxes with and without blocks, orders 0 to 4: d alone is 0.45 to 1 times e. Errors below about a tenth of that
//! of the polynomials are hidden by the noise of the rays, and estimated too large.

use rayon::prelude::*;

use radiosity_geom::{DVec3, Encounter};

use crate::gather::Gather;
use crate::light::receiver_point::ReceiverPoint;
use crate::sampling::kronecker;
use crate::sampling::lambert::lambert;
use crate::sampling::shift::{shift, shifted};
use crate::solution::{Place, Solution};
use crate::visibility::Visibility;

use super::points::{Point, points};

/// Rays in all, and the fewest per point. Chosen: with four times as many the estimates of the boxes changed by 5 %.
const RAYS: usize = 4096;
const FEWEST: usize = 8;

/// Largest mean reflectance that is believed: beyond it noise would be taken for an error. Chosen.
const BRIGHTEST: f64 = 0.9;

/// What rays from one point found, per band.
struct Found {
    area: f64,
    reflectances: Vec<f64>,
    /// Irradiance that was gathered at the point (W m⁻²).
    gathered: Vec<f64>,
    /// d by each half of the rays (W m⁻²).
    halves: [Vec<f64>; 2],
    /// Mean reflectance that the rays met.
    met: Vec<f64>,
}

/// What misses light, and how it is gathered.
struct Missing<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    gather: Gather<'a>,
    rays: usize,
}

/// Estimated ‖ρ(E − E_g)‖/‖ρ E_g‖ over all surfaces, all bands pooled, by light gathered to about `eps`.
pub(super) fn error(solution: &Solution, visibility: &Visibility, eps: f64, told: &(dyn Fn() + Sync)) -> f64 {
    let points = points(solution.elements().list());
    let count: usize = points.iter().map(Vec::len).sum();
    let rays = RAYS.div_ceil(count).max(FEWEST).next_multiple_of(2);
    let gather = Gather::new(solution, visibility, eps);
    let missing = Missing { solution, visibility, gather, rays };
    let of = |(element, points): (usize, &Vec<Point>)| {
        let reflects = solution.bands().iter().any(|band| band.coating.reflectance[element] > 0.0);
        let points = if reflects { &points[..] } else { &[] };
        let found: Vec<Found> = points.iter().map(|point| missing.at(element, point)).collect();
        told();
        found
    };
    let found: Vec<Vec<Found>> = points.par_iter().enumerate().map(of).collect();
    let found: Vec<Found> = found.into_iter().flatten().collect();
    let sums: Vec<Sums> = (0..solution.bands().len()).map(|band| Sums::of(&found, band)).collect();
    let size: f64 = sums.iter().map(|sums| sums.size).sum();
    let missed: f64 = sums.iter().map(Sums::missed).sum();
    if size > 0.0 { (missed / size).sqrt() } else { 0.0 }
}

impl Missing<'_> {
    fn at(&self, element: usize, point: &Point) -> Found {
        let bands = self.solution.bands();
        let mut halves = [vec![0.0; bands.len()], vec![0.0; bands.len()]];
        let mut met = vec![0.0; bands.len()];
        for (half, found) in halves.iter_mut().enumerate() {
            let offset: [f64; 2] = shift((2 * point.index + half) as u64);
            for ray in 0..self.rays / 2 {
                let direction = lambert(point.normal, shifted(kronecker::point(ray as u64), &offset));
                self.add(point, direction, found, &mut met);
            }
            found.iter_mut().for_each(|sum| *sum *= 2.0 / self.rays as f64);
        }
        met.iter_mut().for_each(|sum| *sum /= self.rays as f64);
        let reflectances = bands.iter().map(|band| band.coating.reflectance[element]).collect();
        let gathered = self.gather.at(&point.vantage());
        Found { area: point.area, reflectances, gathered, halves, met }
    }

    /// Adds ρ (S_g − S_h) where a ray ends to `found`, and ρ to `met`.
    fn add(&self, point: &Point, direction: DVec3, found: &mut [f64], met: &mut [f64]) {
        let Place { surface, position, .. } = point.place;
        let end = self.visibility.nearest_from(surface, position, direction);
        let Some(Encounter { surface, hit, front: true }) = end else { return };
        let elements = self.solution.elements();
        let Some(element) = elements.at(surface, [hit.u, hit.v]) else { return };
        let reflectance = |band: usize| self.solution.bands()[band].coating.reflectance[element];
        if (0..met.len()).all(|band| reflectance(band) == 0.0) {
            return;
        }
        let jet = elements.shape(surface).jet(hit.u, hit.v);
        let place = Place { surface, parameters: [hit.u, hit.v], position: jet.position };
        let missed = self.missed(element, &place, &ReceiverPoint::on(surface, jet.position, jet.normal));
        for (band, missed) in missed.into_iter().enumerate() {
            found[band] += reflectance(band) * missed;
            met[band] += reflectance(band);
        }
    }

    /// S_g − S_h per band at a place of an element.
    fn missed(&self, element: usize, place: &Place, vantage: &ReceiverPoint) -> Vec<f64> {
        let mut held = vec![0.0; self.solution.bands().len()];
        self.solution.irradiance_bands(element, place, &mut held);
        let reflection = self.gather.reflection();
        let mut missed = reflection.irradiance(vantage, &reflection.around(&vantage.site()), &held);
        self.solution.indirect_bands(element, place, &mut held);
        missed.iter_mut().zip(&held).for_each(|(missed, held)| *missed -= held.max(0.0));
        missed
    }
}

/// Sums over the points, of one band.
struct Sums {
    /// Σ ρ² d′d″ ΔA and its standard deviation.
    product: f64,
    deviation: f64,
    /// m′m″ Σ ρ² ΔA.
    mean: f64,
    /// q, the mean reflectance that rays met.
    met: f64,
    /// Σ (ρ E_g)² ΔA.
    size: f64,
}

impl Sums {
    fn of(found: &[Found], band: usize) -> Self {
        let sum =
            |value: &dyn Fn(&Found) -> f64| found.iter().map(|point| point.area * value(point)).sum::<f64>();
        let product = |point: &Found| {
            let [first, second] = &point.halves;
            point.reflectances[band].powi(2) * first[band] * second[band]
        };
        let area = sum(&|_| 1.0);
        let [first, second] = [0, 1].map(|half| sum(&|point| point.halves[half][band]) / area);
        Self {
            product: sum(&product),
            deviation: sum(&|point| point.area * product(point).powi(2)).sqrt(),
            mean: first * second * sum(&|point| point.reflectances[band].powi(2)),
            met: sum(&|point| point.met[band]) / area,
            size: sum(&|point| (point.reflectances[band] * point.gathered[band]).powi(2)),
        }
    }

    /// ∫ ρ² e² dA.
    fn missed(&self) -> f64 {
        let further = (1.0 - self.met.min(BRIGHTEST)).powi(-2) - 1.0;
        self.product.max(0.0) + self.deviation + further * self.mean.max(0.0)
    }
}
