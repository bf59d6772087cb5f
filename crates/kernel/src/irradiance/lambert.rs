//! Lambert's formula: the irradiance from a polygon of exitance 1, as a sum over its sides.
//!
//! ```text
//! E = 1/(2π) | Σ_k θ_k n·(u_k × u_{k+1}) / sin θ_k | ,     u_k = a_k/|a_k| ,   cos θ_k = u_k·u_{k+1} ,
//! ```
//!
//! with the corners a_k relative to the receiver point; the polygon lies above the horizon. 0 ≤ E ≤ 1. θ/sin
//! θ is analytic in y = sin² θ/2 = (1 − cos θ)/2 except at y = 1:
//!
//! ```text
//! θ/sin θ = asin √y / √(y (1 − y)) = Σ_k 4ᵏ (k!)²/(2k + 1)! yᵏ .
//! ```
//!
//! * θ ≤ 60°, y ≤ ¼: a polynomial of degree 13 that interpolates it at the Chebyshev points of [0, ¼]. Its
//!   error is 5e-17, since the singularity y = 1 lies seven half widths from the middle of the interval.
//! * 60° < θ ≤ 120°: the half angle, θ/sin θ = (θ/2)/sin(θ/2) / cos(θ/2) with cos θ/2 = √((1 + cos θ)/2).
//! * beyond 120°, where 1 + cos θ cancels: θ itself, from sine and cosine.
//!
//! Reference: P. Schröder, P. Hanrahan, *On the form factor between two polygons*, SIGGRAPH 93 (1993).

use core::f64::consts::TAU;

use radiosity_geom::DVec3;

/// Coefficients of the polynomial in y, in pairs of an even and an odd power: the interpolant of the header.
const SERIES: [[f64; 2]; 7] = [
    [0.999_999_999_999_999_96, 0.666_666_666_666_732_2],
    [0.533_333_333_316_350_1, 0.457_142_858_871_963_3],
    [0.406_349_114_763_685_2, 0.369_411_264_931_380_3],
    [0.340_933_293_249_351_9, 0.319_072_287_622_392_4],
    [0.291_800_580_741_102_7, 0.335_112_561_753_491],
    [0.035_139_155_368_524_88, 0.977_655_558_002_273_1],
    [-1.113_286_127_178_430_7, 1.553_779_294_309_343_6],
];

/// Corners that are computed side by side: those of a quadrilateral.
const LANES: usize = 4;

/// Irradiance from a polygon of exitance 1 above the horizon of the unit normal `n`; corners relative to the
/// point.
pub fn polygon(n: DVec3, corners: &[DVec3]) -> f64 {
    let Some(last) = corners.last() else { return 0.0 };
    if corners.len() <= LANES {
        // A corner that is repeated adds a side of no length.
        return quad(n, std::array::from_fn(|k| corners[k.min(corners.len() - 1)]));
    }
    let (mut sum, mut u) = (0.0, last.normalize_or_zero());
    for corner in corners {
        let v = corner.normalize_or_zero();
        sum += side(n, u, v);
        u = v;
    }
    sum.abs() / TAU
}

/// As [`polygon`], for four corners at once.
fn quad(n: DVec3, corners: [DVec3; LANES]) -> f64 {
    let [mut x, mut y, mut z] = [corners.map(|a| a.x), corners.map(|a| a.y), corners.map(|a| a.z)];
    for k in 0..LANES {
        let scale = (x[k] * x[k] + y[k] * y[k] + z[k] * z[k]).sqrt().recip();
        let scale = if scale < f64::INFINITY { scale } else { 0.0 };
        (x[k], y[k], z[k]) = (x[k] * scale, y[k] * scale, z[k] * scale);
    }
    let (mut rise, mut cosine) = ([0.0; LANES], [0.0; LANES]);
    for k in 0..LANES {
        let next = (k + 1) % LANES;
        rise[k] = n.x * (y[k] * z[next] - z[k] * y[next])
            + n.y * (z[k] * x[next] - x[k] * z[next])
            + n.z * (x[k] * y[next] - y[k] * x[next]);
        cosine[k] = x[k] * x[next] + y[k] * y[next] + z[k] * z[next];
    }
    if cosine.iter().all(|cosine| *cosine >= 0.5) {
        let terms: [f64; LANES] = std::array::from_fn(|k| rise[k] * series(cosine[k]));
        return ((terms[0] + terms[1]) + (terms[2] + terms[3])).abs() / TAU;
    }
    let unit = |k: usize| DVec3::new(x[k], y[k], z[k]);
    (0..LANES).map(|k| side(n, unit(k), unit((k + 1) % LANES))).sum::<f64>().abs() / TAU
}

/// θ n·(u × v)/sin θ of a side between the unit vectors `u` and `v`, for angles θ that differ from 180° by
/// more than rounding; 0 for a side that is seen end on.
pub fn side(n: DVec3, u: DVec3, v: DVec3) -> f64 {
    let (cross, cosine) = (u.cross(v), u.dot(v));
    let rise = n.dot(cross);
    if cosine >= 0.5 {
        return rise * series(cosine);
    }
    if cosine >= -0.5 {
        let half = (0.5 + 0.5 * cosine).sqrt();
        return rise * series(half) / half;
    }
    let sine = cross.length();
    if sine > 0.0 { rise * sine.atan2(cosine) / sine } else { 0.0 }
}

/// θ/sin θ for cos θ ≥ ½.
#[inline]
fn series(cosine: f64) -> f64 {
    let y = 0.5 - 0.5 * cosine;
    let square = y * y;
    let [even, odd] = SERIES
        .iter()
        .rev()
        .fold([0.0; 2], |[even, odd], pair| [even * square + pair[0], odd * square + pair[1]]);
    even + y * odd
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratio_of_angle_and_sine_is_met_to_rounding() {
        for k in 1..3000 {
            let angle = 1e-3 * f64::from(k) * std::f64::consts::FRAC_PI_3;
            let v = DVec3::new(angle.cos(), angle.sin(), 0.0);
            let error = (side(DVec3::Z, DVec3::X, v) / angle - 1.0).abs();
            assert!(error < 1e-15, "{angle}: {error:e}");
        }
        assert_eq!(side(DVec3::Z, DVec3::X, DVec3::X), 0.0);
        assert_eq!(side(DVec3::Z, DVec3::X, -DVec3::X), 0.0);
    }

    #[test]
    fn corners_side_by_side_count_as_one_by_one() {
        let corners =
            [[-0.3, -1.0, 0.8], [2.0, -0.7, 1.1], [1.5, 0.9, 0.2], [-0.4, 1.2, 0.5]].map(DVec3::from_array);
        for (far, tolerance) in [(0.0, 1e-15), (1e3, 1e-18)] {
            let seen = corners.map(|corner| corner + far * DVec3::new(0.2, 0.1, 1.0));
            for polygon_of in [&seen[..], &seen[1..]] {
                // A corner in the middle of a side changes nothing, but comes as a fifth, or fourth.
                let middle = 0.5 * (polygon_of[0] + polygon_of[1]);
                let split =
                    [&polygon_of[..1], &[middle, middle.lerp(polygon_of[1], 0.3)], &polygon_of[1..]].concat();
                let (whole, parts) = (polygon(DVec3::Z, polygon_of), polygon(DVec3::Z, &split));
                assert!((whole - parts).abs() < tolerance, "{far}: {whole:e} {parts:e}");
                assert!(whole > 1e2 * tolerance);
            }
        }
    }
}
