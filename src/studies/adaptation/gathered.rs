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
//! d is estimated at points x by cosine-distributed rays, at whose ends S_g is gathered: by cells, or where rays are the
//! cheaper reader ([`By`]) by one further ray each. What readings by rays take from the polynomials of all light counts as
//! well ([`RayGather::add_missed`]). Two halves of the rays give d′ and d″, independent of each other: the mean of their product is d², that of a square would have the noise of
//! the rays as well. What follows from d by further reflections is even over the scene, as far as it counts; so the mean of
//! d, and it alone, is taken 1/(1 − q) times, q the mean reflectance that rays meet:
//!
//! ```text
//! ∫ ρ² e² dA ≈ Σ_k ρ² d′d″ ΔA_k + ((1 − q)⁻² − 1) m′m″ Σ_k ρ² ΔA_k + s ,     ΔA_k the area at point k .
//! ```
//!
//! m′ and m″ are means by area. s is the standard deviation of the first sum, so that few points do not promise too much,
//! and the second with (m′ − m″)²/4 in the place of m′m″. Sums run over points that reflect. Rays are doubled while s is much
//! of the sum.
//! Measured in boxes with and without blocks, orders 0 to 4: d alone is 0.45 to 1 times e.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use radiosity_geom::{DVec3, Encounter};

use crate::gather::Gather;
use crate::gather::by_rays::{RayGather, Receiver};
use crate::gather::choice::By;
use crate::light::receiver_point::ReceiverPoint;
use crate::sampling::kronecker;
use crate::sampling::lambert::lambert;
use crate::sampling::shift::{shift, shifted};
use crate::solution::{Place, Solution};
use crate::visibility::Visibility;

use super::points::{Point, points};

/// Rays in all that are sent first, at the most where the estimate is noisy, and where it is larger than wanted as well; the
/// fewest per half and point. Chosen: with four times the first number whose ends gather by cells the estimates of the boxes
/// changed by 5 %.
const BY_CELLS: Numbers = Numbers { first: 1 << 12, noisy: 1 << 14, most: 1 << 16 };
const BY_RAYS: Numbers = Numbers { first: 1 << 16, noisy: 1 << 18, most: 1 << 22 };
const FEWEST: u64 = 4;

/// Part of the estimate that s may be where more rays would say nothing new. Chosen.
const NOISE: f64 = 0.5;

/// Accuracy of gathering by cells: this part of the wanted one, or [`LOOSEST`]. With 9e-3 estimates were a third of the errors.
const OF_WANTED: f64 = 0.3;
const LOOSEST: f64 = 3e-3;

/// Accuracy of light that errors are relative to. Chosen.
const OF_SIZE: f64 = 0.1;

/// Rays that tell the mean reflectance around a point. Chosen.
const MEETING: u64 = 8;

/// Largest mean reflectance that is believed: beyond it noise would be taken for an error. Chosen.
const BRIGHTEST: f64 = 0.9;

/// Numbers of rays.
struct Numbers {
    first: u64,
    noisy: u64,
    most: u64,
}

/// What rays from one point found, per band.
struct Found<'a> {
    point: &'a Point,
    reflectances: Vec<f64>,
    /// Irradiance that was gathered at the point (W m⁻²).
    gathered: Vec<f64>,
    /// d by each half of the rays, times their number (W m⁻²).
    halves: [Vec<f64>; 2],
    /// Mean reflectance that rays meet.
    met: Vec<f64>,
}

/// How light is gathered where rays end.
enum Ends<'a> {
    Cells(Gather<'a>),
    Rays(RayGather<'a>),
}

/// What misses light, and how it is gathered.
struct Missing<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    ends: Ends<'a>,
}

/// Estimated ‖ρ(E − E_g)‖/‖ρ E_g‖ over all surfaces, all bands pooled; no better than tells whether it is below `wanted`, and
/// not much worse. `goes_on` is told the points done and to be done, and may end the work.
pub(super) fn error(
    solution: &Solution,
    visibility: &Visibility,
    wanted: f64,
    goes_on: &(dyn Fn(usize, usize) -> bool + Sync),
) -> f64 {
    let missing = Missing::of(solution, visibility, (OF_WANTED * wanted).min(LOOSEST));
    let points = points(solution.elements().list());
    let reflects =
        |element: &usize| solution.bands().iter().any(|band| band.coating.reflectance[*element] > 0.0);
    let reflecting: Vec<(usize, &Point)> = (0..points.len())
        .filter(reflects)
        .flat_map(|element| points[element].iter().map(move |point| (element, point)))
        .collect();
    if reflecting.is_empty() {
        return 0.0;
    }
    let mut found: Vec<Found> =
        reflecting.par_iter().map(|(element, point)| missing.begin(*element, point)).collect();
    let Numbers { first, noisy, most } = missing.numbers();
    let per_half = |rays: u64| rays.div_ceil(2 * found.len() as u64);
    let (first, noisy, most) = (per_half(first).max(FEWEST), per_half(noisy), per_half(most));
    let (mut sent, mut now) = (0, first);
    loop {
        let (done, all) = (AtomicUsize::new(0), found.len());
        let send = |found: &mut Found| {
            missing.send(found, sent..sent + now);
            goes_on(done.fetch_add(1, Ordering::Relaxed) + 1, all)
        };
        let finishes = found.par_iter_mut().map(send).reduce(|| true, |a, b| a && b);
        sent += now;
        let estimate = Estimate::of(&found, sent, solution.bands().len());
        let enough = if estimate.error() <= wanted { noisy } else { most };
        if !finishes || !estimate.is_noisy() || 2 * sent > enough {
            return estimate.error();
        }
        now = sent;
    }
}

impl<'a> Missing<'a> {
    fn of(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Self {
        let ends = match By::Auto.rays(solution, visibility, eps, false) {
            true => Ends::Rays(RayGather::new(solution, visibility, OF_SIZE, false)),
            false => Ends::Cells(Gather::new(solution, visibility, eps)),
        };
        Self { solution, visibility, ends }
    }

    fn numbers(&self) -> Numbers {
        match self.ends {
            Ends::Cells(_) => BY_CELLS,
            Ends::Rays(_) => BY_RAYS,
        }
    }

    /// What is known of a point of an element before rays are counted.
    fn begin<'p>(&self, element: usize, point: &'p Point) -> Found<'p> {
        let bands = self.solution.bands();
        let gathered = match &self.ends {
            Ends::Cells(gather) => gather.at(&point.vantage()),
            Ends::Rays(gather) => gather.read(&Receiver::Point(point.vantage())).irradiance,
        };
        let reflectances = bands.iter().map(|band| band.coating.reflectance[element]).collect();
        let halves = [vec![0.0; bands.len()], vec![0.0; bands.len()]];
        Found { point, reflectances, gathered, halves, met: self.met(point) }
    }

    /// Mean reflectance that rays from a point meet.
    fn met(&self, point: &Point) -> Vec<f64> {
        let mut met = vec![0.0; self.solution.bands().len()];
        for (element, ..) in self.ends_of(point, 2 * point.index as u64, 0..MEETING) {
            let bands = self.solution.bands().iter();
            met.iter_mut().zip(bands).for_each(|(sum, band)| {
                *sum += band.coating.reflectance[element] / MEETING as f64;
            });
        }
        met
    }

    /// Sends the rays of these numbers of each half.
    fn send(&self, found: &mut Found, rays: Range<u64>) {
        let point = found.point;
        for (half, sums) in found.halves.iter_mut().enumerate() {
            let number = (2 * point.index + half) as u64;
            match &self.ends {
                Ends::Rays(gather) => gather.add_missed(&point.vantage(), number, rays.clone(), sums),
                Ends::Cells(gather) => {
                    for (element, place, vantage) in self.ends_of(point, number, rays.clone()) {
                        self.add(gather, element, (&place, &vantage), sums);
                    }
                }
            }
        }
    }

    /// Elements and places that cosine-distributed rays of these numbers meet from the front.
    fn ends_of(
        &self,
        point: &Point,
        number: u64,
        rays: Range<u64>,
    ) -> impl Iterator<Item = (usize, Place, ReceiverPoint)> {
        let offset: [f64; 2] = shift(number);
        let Place { surface: own, position, .. } = point.place;
        rays.filter_map(move |ray| {
            let direction: DVec3 = lambert(point.normal, shifted(kronecker::point(ray), &offset));
            let Some(Encounter { surface, hit, front: true }) =
                self.visibility.nearest_from(own, position, direction)
            else {
                return None;
            };
            let elements = self.solution.elements();
            let element = elements.at(surface, [hit.u, hit.v])?;
            let jet = elements.shape(surface).jet(hit.u, hit.v);
            let place = Place { surface, parameters: [hit.u, hit.v], position: jet.position };
            Some((element, place, ReceiverPoint::on(surface, jet.position, jet.normal)))
        })
    }

    /// Adds ρ (S_g − S_h) per band at a place of an element to `sums`.
    fn add(
        &self,
        gather: &Gather,
        element: usize,
        (place, vantage): (&Place, &ReceiverPoint),
        sums: &mut [f64],
    ) {
        let bands = self.solution.bands();
        let reflectances = bands.iter().map(|band| band.coating.reflectance[element]);
        if reflectances.clone().all(|reflectance| reflectance == 0.0) {
            return;
        }
        let mut held = vec![0.0; bands.len()];
        self.solution.irradiance_bands(element, place, &mut held);
        let reflection = gather.reflection();
        let gathered = reflection.irradiance(vantage, &reflection.around(&vantage.site()), &held);
        self.solution.indirect_bands(element, place, &mut held);
        for (((sum, reflectance), gathered), held) in
            sums.iter_mut().zip(reflectances).zip(gathered).zip(held)
        {
            *sum += reflectance * (gathered - held.max(0.0));
        }
    }
}

/// What all points say.
struct Estimate {
    bands: Vec<Sums>,
}

impl Estimate {
    /// By so many rays of each half.
    fn of(found: &[Found], rays: u64, bands: usize) -> Self {
        Self { bands: (0..bands).map(|band| Sums::of(found, rays, band)).collect() }
    }

    fn error(&self) -> f64 {
        let size = self.sum(|sums| sums.size);
        if size > 0.0 { (self.sum(Sums::missed) / size).sqrt() } else { 0.0 }
    }

    /// Whether much of the error is noise of the rays.
    fn is_noisy(&self) -> bool {
        self.sum(Sums::noise) > NOISE * self.sum(Sums::missed)
    }

    fn sum(&self, value: impl Fn(&Sums) -> f64) -> f64 {
        self.bands.iter().map(value).sum()
    }
}

/// Sums over the points, of one band.
struct Sums {
    /// Σ ρ² d′d″ ΔA and its standard deviation.
    product: f64,
    deviation: f64,
    /// m′m″ Σ ρ² ΔA, and (m′ − m″)²/4 in the place of m′m″.
    mean: f64,
    doubt: f64,
    /// q, the mean reflectance that rays met.
    met: f64,
    /// Σ (ρ E_g)² ΔA.
    size: f64,
}

impl Sums {
    fn of(found: &[Found], rays: u64, band: usize) -> Self {
        let sum = |value: &dyn Fn(&Found) -> f64| {
            found.iter().map(|found| found.point.area * value(found)).sum::<f64>()
        };
        let half = |found: &Found, half: usize| found.halves[half][band] / rays as f64;
        let product = |found: &Found| found.reflectances[band].powi(2) * half(found, 0) * half(found, 1);
        let area = sum(&|_| 1.0);
        let [first, second] = [0, 1].map(|number| sum(&|found| half(found, number)) / area);
        let reflecting = sum(&|found| found.reflectances[band].powi(2));
        Self {
            product: sum(&product),
            deviation: sum(&|found| found.point.area * product(found).powi(2)).sqrt(),
            mean: first * second * reflecting,
            doubt: (0.5 * (first - second)).powi(2) * reflecting,
            met: sum(&|point| point.met[band]) / area,
            size: sum(&|point| (point.reflectances[band] * point.gathered[band]).powi(2)),
        }
    }

    /// ∫ ρ² e² dA.
    fn missed(&self) -> f64 {
        (self.product + self.further() * self.mean).max(0.0) + self.noise()
    }

    /// What the noise of rays and the choice of points may make of it.
    fn noise(&self) -> f64 {
        self.deviation + self.further() * self.doubt
    }

    /// (1 − q)⁻² − 1.
    fn further(&self) -> f64 {
        (1.0 - self.met.min(BRIGHTEST)).powi(-2) - 1.0
    }
}
