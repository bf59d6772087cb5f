//! Points of surfaces at which light is judged.
//!
//! N points, one in each N-th part of the area of all fronts, the surfaces put one after the other: none is
//! likelier than another, and none of the larger surfaces is left out.

use radiosity_geom::Rect;

use crate::random::Random;
use crate::rays::{Place, Rays};
use crate::spot::Spot;
use crate::spread::Spread;

/// Tries to find a point that nothing stands on before a part of the area is left out.
const TRIES: usize = 16;

/// A point of a sample: what is read, and where it lies.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplePoint {
    /// Index of the surface.
    pub surface: usize,
    /// The point.
    pub spot: Spot,
}

/// About `count` points of the fronts that nothing stands on.
pub(crate) fn over_surfaces(rays: &Rays, count: usize, random: &mut Random) -> Vec<SamplePoint> {
    let mut sum = 0.0;
    let sums: Vec<f64> = (0..rays.count())
        .map(|surface| {
            sum += rays.area(surface);
            sum
        })
        .collect();
    let offset = random.next();
    let point = |k: usize| {
        let surface = sums.partition_point(|own| *own <= (k as f64 + offset) / count as f64 * sum);
        let surface = surface.min(rays.count() - 1);
        let spread = Spread::over(rays.shape(surface), Rect::FULL);
        (0..TRIES).find_map(|_| {
            let on = spread.point([random.next(), random.next()])?;
            let place = Place::on(surface, &on);
            let spot = Spot::Point { position: on.point, normal: on.normal };
            rays.is_bare(&place).then_some(SamplePoint { surface, spot })
        })
    };
    (0..count).filter_map(point).collect()
}
