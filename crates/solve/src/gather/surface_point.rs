//! A point of a surface, where its light is the limit from the open side.
//!
//! A point may lie at an edge of its surface, or where other surfaces touch it. It is therefore moved slightly
//! away from these, or inwards.

use std::f64::consts::PI;

use radiosity_elements::Elements;
use radiosity_geom::{DVec3, Rect, Surface, holds, overhang};
use radiosity_light::receiver_point::ReceiverPoint;

use crate::solution::{Band, Solution, SurfacePlace};

/// Part of the scene's diagonal up to which a point lies on a surface: some sixteen roundings of single
/// precision.
pub(super) const ON_SURFACE: f64 = 1e-6;
/// Part of the surface's own diagonal within which a point lies on it, if that is less.
pub(super) const OF_ITS_OWN: f64 = 1e-4;

/// Distance by which points are moved: this part of the scene's diagonal, at most the part [`AT_MOST`] of the
/// way to the middle of the piece. A tenth of [`ON_SURFACE`], so that a moved point is still found on its
/// surface.
pub(super) const INWARDS: f64 = 1e-7;
/// Largest part of the way to the middle of its piece by which a point is moved: small pieces keep their
/// light.
const AT_MOST: f64 = 1e-3;

/// A point of a surface, prepared as a receiver.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint {
    /// The point for which light is computed: the foot of the given point, moved as the module says.
    pub place: SurfacePlace,
    /// Parameters of the foot before it was moved, in [−1, 1]².
    pub foot: [f64; 2],
    /// Index of the element that holds the foot.
    pub element: usize,
    /// Unit normal of the surface at the moved point.
    pub normal: DVec3,
}

/// Directions along each side of the lune that a tilted sensor sees of an emitter that is not diffuse: a jump of
/// radiance within it errs by about half of one.
const LUNE: usize = 64;

/// If the unit directions away from touching surfaces sum up to less than this length, they cancel and the
/// point is moved inwards instead: between two walls face to face, to 6°, there is no way aside.
const ASIDE: f64 = 0.1;

impl SurfacePoint {
    /// The surface point at these parameters of a surface in a scene of this diagonal. None inside a hole
    /// that fills a cell.
    pub fn at(elements: &Elements, surface: usize, parameters: [f64; 2], diagonal: f64) -> Option<Self> {
        Self::within(elements, surface, parameters, INWARDS * diagonal, DVec3::ZERO)
    }

    /// The light of the surface itself (W m⁻² per band) at a sensor just above this point with the unit normal `n`,
    /// where `radiosity` (W m⁻² per band) leaves it: of the hemisphere about n it fills the lune below its own
    /// horizon, at any small height. With θ between the normals, and a what it emits in a direction over its mean,
    ///
    /// ```text
    /// E = B (1 − cos θ)/2 + E₀ ( 1/π ∫₀^θ ∫₀^π a(φ, ψ) sin² ψ sin φ dψ dφ − (1 − cos θ)/2 ) ,
    /// ```
    ///
    /// φ from the sensor's horizon, ψ from the line where it meets the surface's.
    pub fn own_light(&self, solution: &Solution, n: DVec3, radiosity: &[f64]) -> Vec<f64> {
        let SurfacePlace { surface, parameters, .. } = self.place;
        let part = 0.5 * (1.0 - self.normal.dot(n));
        let radiances = solution.emitters().radiances;
        let emitted = match radiances.is_directed(surface) {
            true => self.mean_over_lune(n, |into| radiances.relative(surface, into)),
            false => part,
        };
        let bands = solution.bands().iter().zip(radiosity);
        let of = |(band, radiosity): (&Band, &f64)| {
            part * radiosity + (emitted - part) * band.coating.exitance_at(self.element, parameters)
        };
        bands.map(of).collect()
    }

    /// 1/π ∫ a cos dω over the lune between the horizons of the surface and of a sensor with the unit normal `n`;
    /// a depends on the direction towards the sensor.
    fn mean_over_lune(&self, n: DVec3, a: impl Fn(DVec3) -> f64) -> f64 {
        let along = n.cross(self.normal).normalize_or(n.any_orthonormal_vector());
        // Where the surface rises over the sensor's horizon.
        let level = n.cross(along);
        let tilt = self.normal.angle_between(n);
        let place = |k: usize| (k as f64 + 0.5) / LUNE as f64;
        let each = (0..LUNE * LUNE).map(|k| {
            let (sin, cos) = (PI * place(k / LUNE)).sin_cos();
            let (rise, level_part) = (tilt * place(k % LUNE)).sin_cos();
            let direction = cos * along + sin * (rise * n + level_part * level);
            a(-direction) * sin * sin * rise
        });
        each.sum::<f64>() * tilt / (LUNE * LUNE) as f64
    }

    /// The receiver point here with the unit normal `n`: the surface itself is not seen from it
    /// ([`SurfacePoint::own_light`]).
    pub fn receiver_point(&self, n: DVec3) -> ReceiverPoint {
        let ground = (n != self.normal).then_some(self.normal);
        ReceiverPoint { position: self.place.position, normal: n, ground, surface: Some(self.place.surface) }
    }

    /// The surface point at the parameters `at`, moved by the length `step` along `away`, or inwards if
    /// `away` nearly vanishes.
    pub(super) fn within(
        elements: &Elements,
        surface: usize,
        at: [f64; 2],
        step: f64,
        away: DVec3,
    ) -> Option<Self> {
        let shape = elements.shape(surface);
        let step = step.min(INWARDS / ON_SURFACE * OF_ITS_OWN * extent(shape));
        let start = shape.jet(at[0], at[1]).position;
        let aside = start + step * away.normalize_or_zero();
        let is_free = shape.region().is_some_and(|region| region.contains(aside));
        let parameters = match middle_of_piece(shape, start) {
            Some(_) if away.length() > ASIDE && is_free => {
                let foot = shape.project(aside);
                [foot.u, foot.v]
            }
            Some(middle) => {
                let share = (step / middle.distance(start)).min(AT_MOST);
                let foot = shape.project(start.lerp(middle, share));
                [foot.u, foot.v]
            }
            None => at.map(|x| x * (1.0 - (step / extent(shape)).min(AT_MOST))),
        };
        let jet = shape.jet(parameters[0], parameters[1]);
        let element = elements.at(surface, parameters)?;
        let place = SurfacePlace { surface, parameters, position: jet.position };
        Some(Self { place, foot: at, element, normal: jet.normal })
    }
}

/// Diagonal of the bounding box of a surface (scene length).
pub(super) fn extent(shape: &dyn Surface) -> f64 {
    shape.bounds(&Rect::FULL).diagonal()
}

/// Middle of the convex piece of a planar surface that contains `x` or is nearest to it.
fn middle_of_piece(shape: &dyn Surface, x: DVec3) -> Option<DVec3> {
    let region = shape.region()?;
    let pieces = region.convex_pieces();
    let outside = |piece: &[DVec3]| overhang(piece, region.normal(), x);
    let nearest = || pieces.iter().min_by(|a, b| outside(a).total_cmp(&outside(b)));
    let piece = pieces.iter().find(|piece| holds(piece, region.normal(), x)).or_else(nearest)?;
    Some(piece.iter().sum::<DVec3>() / piece.len() as f64)
}
