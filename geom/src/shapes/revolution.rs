//! Surface of revolution of a cubic Bézier curve: X(u, v) = o + x(s)(cos φ x̂ + sin φ ŷ) + z(s) ẑ, s = ½(1 +
//! v), φ linear in u.
//!
//! x and z are the distance from the axis and the height along it of the curve; its own azimuth does not
//! matter. The front is the outside where the curve runs up the axis. Area 2π-fold (or less) ∫ x |C′| ds, by
//! quadrature. Range: a curve in one half-plane bounded by the axis; it may end on the axis, where the normal
//! is the limit along the curve.
//!
//! Ray: it is at the height z(s) and the distance x(s) where f(t, s) = (z(s) − z(t), x²(s) − ρ²(t)) vanishes,
//! a polynomial map of degree 2 in t and 6 in s whose zeros are bracketed, piece by piece of the curve and
//! only where the ray is in the ring around the piece. The square loses digits near the axis; Newton steps on
//! x(s) − ρ(t) restore them.

use super::check_finite;
use super::fold::{places, turns_back};
use super::turn::{Profile, Turn};
use crate::bernstein::{evaluate, from_powers, restrict};
use crate::outline::{is_nowhere_below, legs};
use crate::roots::quadratic;
use crate::tolerances::ROUNDING;
use crate::zeros::zeros;
use crate::{Aabb, ConvexSolid, Hit, Jet, Outline, Ray, Rect, ShapeError, Surface};
use glam::{DMat2, DVec2, DVec3};

/// Equal pieces of s into which the curve is cut, to look for rays only where they pass. An arbitrary choice:
/// with fewer, rings are thicker than the curve needs and more rays enter them; with more, a ray is compared
/// with more rings.
const PIECES: usize = 8;

/// A piece of the profile with the box around it.
#[derive(Clone, Debug)]
struct Piece {
    /// z and x² in Bernstein form of degree 6.
    squares: [DVec2; 7],
    /// Least and most distance from the axis and height, with some room.
    x: [f64; 2],
    z: [f64; 2],
}

/// A vase: a curve turned about an axis.
#[derive(Clone, Debug)]
pub struct Revolution {
    turn: Turn,
    /// (x, z) of the control points.
    profile: [DVec2; 4],
    pieces: Vec<Piece>,
    extent: f64,
}

impl Revolution {
    /// The cubic Bézier curve with control points `curve` turned about the line through `center` along
    /// `axis`, with `angle` from and to in radians.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, an axis of no length, a wrong range of angles, a curve that leaves its
    /// half-plane, crosses the axis, spans no area or turns back on a straight line.
    pub fn new(
        curve: [DVec3; 4],
        center: DVec3,
        axis: DVec3,
        angle: [f64; 2],
    ) -> Result<Revolution, ShapeError> {
        for x in curve {
            check_finite("curve", x)?;
        }
        check_finite("center", center)?;
        let turn = Turn::new(center, "axis", axis, angle)?;
        let profile = profile_of(&curve, &turn)?;
        let widest = profile.iter().map(|p| p.x).fold(0.0, f64::max);
        let extent = widest + profile.iter().map(|p| p.distance(profile[0])).fold(0.0, f64::max);
        let pieces = (0..PIECES).map(|k| Piece::new(&profile, k, 1e-7 * extent)).collect();
        Ok(Revolution { turn, profile, pieces, extent })
    }

    /// Newton's method on (x(s) − ρ(t), z(s) − z(t)); `None` where it does not get there.
    fn refine(&self, o: DVec3, w: DVec3, mut t: f64, mut s: f64) -> Option<(f64, f64)> {
        let mut off = f64::INFINITY;
        for _ in 0..4 {
            let local = o + t * w;
            let rho = local.truncate().length();
            let (at, slope) = evaluate(&self.profile, s);
            let gap = at - DVec2::new(rho, local.z);
            off = gap.length();
            if off <= 1e-16 * self.extent {
                break;
            }
            let growth = if rho > 0.0 { (local.x * w.x + local.y * w.y) / rho } else { 0.0 };
            let step = DMat2::from_cols(DVec2::new(-growth, -w.z), slope).inverse() * gap;
            let moved = (step.x * w.length()).hypot(step.y * slope.length());
            if moved.is_finite() && moved < 1e-3 * self.extent {
                (t, s) = (t - step.x, s - step.y);
            }
        }
        (off <= 1e-12 * self.extent).then_some((t, s))
    }
}

impl Surface for Revolution {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let (at, slope) = evaluate(&self.profile, 0.5 * (1.0 + v));
        let jet =
            self.turn.jet(u, Profile { x: at.x.max(0.0), z: at.y, dx: 0.5 * slope.x, dz: 0.5 * slope.y });
        if slope.length() > 1e-12 * self.extent {
            return jet;
        }
        // Where the curve stops for a moment (coinciding control points), the normal a little farther inside.
        let inside = evaluate(&self.profile, 0.5 * (1.0 + (1.0 - 1e-6) * v)).1;
        let normal = self.turn.jet(u, Profile { x: at.x, z: at.y, dx: inside.x, dz: inside.y }).normal;
        Jet { normal, ..jet }
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        // The control points of four pieces keep closer to the curve than those of the whole.
        let pieces = rect.split_v().map(|half| half.split_v());
        let points = pieces.as_flattened().iter().flat_map(|piece| {
            let [low, high] = piece.v.map(|v| 0.5 * (1.0 + v));
            restrict(&self.profile, low, high)
        });
        let points: Vec<DVec2> = points.collect();
        self.turn.bounds(rect.u, |g, h| points.iter().map(|p| p.x * g + p.y * h).fold(f64::MIN, f64::max))
    }

    /// Of a curve that runs along the axis one way, and bends toward it.
    fn solid(&self) -> Option<ConvexSolid> {
        let side = 1.0_f64.copysign(self.profile[3].y - self.profile[0].y);
        let rises = legs(&self.profile).map(|leg| side * leg.y);
        let outline = Outline::cubic(self.profile, side)?;
        is_nowhere_below(rises, ROUNDING * self.extent).then_some(ConvexSolid::Turned {
            origin: self.turn.origin,
            axis: self.turn.axis(),
            outline,
        })
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let (o, w) = (self.turn.local_point(ray.origin), self.turn.local_vector(ray.direction));
        let mut best: Option<Hit> = None;
        for (k, piece) in self.pieces.iter().enumerate() {
            for [enter, leave] in piece.stretches(o, w) {
                let end = best.map_or(ray.range[1], |hit| hit.t);
                if !(enter < leave && ray.range[0] <= leave && enter <= end) {
                    continue;
                }
                let length = leave - enter;
                zeros(&piece.net(o + enter * w, length * w), Hit::SEAM * PIECES as f64, |x, s| {
                    let hit = self
                        .refine(o, w, enter + x * length, (k as f64 + s) / PIECES as f64)
                        .and_then(|(t, s)| self.turn.accept(ray, t, o + t * w, self.extent, 2.0 * s - 1.0));
                    best = hit.map_or(best, |hit| Hit::nearer(best, hit));
                    false
                });
            }
        }
        best
    }
}

impl Piece {
    fn new(profile: &[DVec2; 4], k: usize, room: f64) -> Piece {
        let [low, high] = [k, k + 1].map(|k| k as f64 / PIECES as f64);
        let points = restrict(profile, low, high);
        let [x, z] = [points.map(|p| p.x), points.map(|p| p.y)];
        let (squares, heights) = (product(&x, &x), product(&z, &[1.0; 4]));
        let range = |b: [f64; 4]| {
            let (least, most) = b.iter().fold((b[0], b[0]), |(least, most), x| (least.min(*x), most.max(*x)));
            [least - room, most + room]
        };
        let squares = std::array::from_fn(|k| DVec2::new(heights[k], squares[k]));
        Piece { squares, x: range(x), z: range(z) }
    }

    /// The at most two stretches of t in which the line o + t w is within the ring x₀ ≤ ρ ≤ x₁, z₀ ≤ z ≤ z₁;
    /// empty ones have their ends out of order. ρ² = ρ*² + (t − t*)² |w⊥|² with the least distance ρ* at t*.
    fn stretches(&self, o: DVec3, w: DVec3) -> [[f64; 2]; 2] {
        const NONE: [f64; 2] = [1.0, 0.0];
        let (flat_o, flat_w) = (o.truncate(), w.truncate());
        let speed = flat_w.length_squared().max(f64::MIN_POSITIVE);
        let nearest = -flat_o.dot(flat_w) / speed;
        let least = (flat_o + nearest * flat_w).length_squared();
        let steep = if w.z.abs() > 1e-200 { w.z } else { 1e-200 };
        let [a, b] = self.z.map(|z| (z - o.z) / steep);
        let (low, high) = (a.min(b), a.max(b));
        let outside = self.x[1] * self.x[1] - least;
        if outside < 0.0 {
            return [NONE; 2];
        }
        let reach = (outside / speed).sqrt();
        let hollow = self.x[0] * self.x[0] - least;
        if self.x[0] <= 0.0 || hollow <= 0.0 {
            return [[low.max(nearest - reach), high.min(nearest + reach)], NONE];
        }
        let inner = (hollow / speed).sqrt();
        [
            [low.max(nearest - reach), high.min(nearest - inner)],
            [low.max(nearest + inner), high.min(nearest + reach)],
        ]
    }

    /// The map f over the stretch p + t w, t ∈ [0, 1].
    fn net(&self, p: DVec3, w: DVec3) -> [[DVec2; 7]; 3] {
        let (flat_p, flat_w) = (p.truncate(), w.truncate());
        let rho = from_powers([flat_p.length_squared(), 2.0 * flat_p.dot(flat_w), flat_w.length_squared()]);
        let z = from_powers([p.z, w.z, 0.0]);
        std::array::from_fn(|i| self.squares.map(|at| at - DVec2::new(z[i], rho[i])))
    }
}

/// Distances from the axis and heights of the control points, if they lie in a half-plane and the curve keeps
/// to it.
fn profile_of(curve: &[DVec3; 4], turn: &Turn) -> Result<[DVec2; 4], ShapeError> {
    let field = || "curve".to_string();
    let local = curve.map(|x| turn.local_point(x));
    let farthest = local
        .iter()
        .map(|p| p.truncate())
        .max_by(|a, b| a.length().total_cmp(&b.length()))
        .expect("four points");
    let extent = local.iter().map(|p| p.distance(local[0])).fold(farthest.length(), f64::max);
    let Some(outward) = farthest.try_normalize().filter(|_| farthest.length() > 1e-9 * extent) else {
        return Err(ShapeError::NoArea { field: field() });
    };
    let off = local.map(|p| outward.perp_dot(p.truncate()).abs());
    let (index, deviation) =
        off.into_iter().enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).expect("four points");
    if deviation > 1e-6 * extent {
        return Err(ShapeError::OffMeridian { field: field(), index, deviation });
    }
    let profile = local.map(|p| DVec2::new(outward.dot(p.truncate()), p.z));
    let lowest = least(&profile.map(|p| p.x));
    if lowest < -1e-9 * extent {
        return Err(ShapeError::CrossesAxis { field: field(), depth: -lowest });
    }
    if profile.iter().all(|p| p.distance(profile[0]) <= 1e-9 * extent) {
        return Err(ShapeError::NoArea { field: field() });
    }
    let slopes: Vec<DVec3> = places().map(|s| evaluate(&profile, s).1.extend(0.0)).collect();
    if turns_back(&slopes) {
        return Err(ShapeError::TurnsBack { field: field() });
    }
    Ok(profile)
}

/// The least value of a cubic on [0, 1]: at an end or where the derivative vanishes.
fn least(b: &[f64; 4]) -> f64 {
    let [p, q, r] = std::array::from_fn(|k| b[k + 1] - b[k]);
    let critical =
        quadratic(p - 2.0 * q + r, 2.0 * (q - p), p).into_iter().filter(|x| (0.0..=1.0).contains(x));
    critical.map(|x| evaluate(b, x).0).fold(b[0].min(b[3]), f64::min)
}

/// The product of two cubics in Bernstein form: cₖ = Σ_{i + j = k} C(3, i) C(3, j)/C(6, k) aᵢ bⱼ.
fn product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 7] {
    const THREE: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
    const SIX: [f64; 7] = [1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0];
    let mut c = [0.0; 7];
    for i in 0..4 {
        for j in 0..4 {
            c[i + j] += THREE[i] * THREE[j] / SIX[i + j] * a[i] * b[j];
        }
    }
    c
}

#[cfg(test)]
mod tests {
    use super::super::FULL_TURN;
    use super::*;

    fn turned(curve: [DVec3; 4]) -> Result<Revolution, ShapeError> {
        Revolution::new(curve, DVec3::ZERO, DVec3::Z, FULL_TURN)
    }

    #[test]
    fn errors_name_the_field() {
        let [o, x, z] = [DVec3::ZERO, DVec3::X, DVec3::Z];
        assert!(matches!(
            turned([x, x + DVec3::Y, 2.0 * x, x + z]).unwrap_err(),
            ShapeError::OffMeridian { .. }
        ));
        assert!(matches!(turned([x, o, -x, z - x]).unwrap_err(), ShapeError::CrossesAxis { .. }));
        assert_eq!(turned([o, z, z, 2.0 * z]).unwrap_err(), ShapeError::NoArea { field: "curve".into() });
        assert_eq!(turned([x; 4]).unwrap_err(), ShapeError::NoArea { field: "curve".into() });
        assert_eq!(Revolution::new([x, x, z, z], o, o, FULL_TURN).unwrap_err().field(), "axis");
    }

    #[test]
    fn a_control_point_beyond_the_axis_is_allowed_if_the_curve_stays() {
        let point = |x: f64, z: f64| DVec3::new(x, 0.0, z);
        assert!(turned([point(1.0, 0.0), point(-0.1, 0.3), point(0.5, 0.6), point(1.0, 1.0)]).is_ok());
    }

    #[test]
    fn rays_across_the_axis_see_both_walls() {
        let point = |x: f64, z: f64| DVec3::new(x, 0.0, z);
        let vase = turned([point(1.0, 0.0), point(1.0, 1.0), point(0.5, 1.0), point(0.5, 2.0)]).unwrap();
        // At s = ½ the curve is at x = ¾, z = 1.
        for (from, t) in [(-3.0, 2.25), (0.0, 0.75)] {
            let hit = vase.intersect(&Ray::new(DVec3::new(from, 0.0, 1.0), DVec3::X)).unwrap();
            assert!((hit.t - t).abs() < 1e-14 && hit.v.abs() < 1e-14, "{hit:?}");
        }
    }
}
