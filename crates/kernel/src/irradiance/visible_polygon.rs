//! Irradiance at a point from the visible part of an evenly bright polygon; exact behind planar blockers.
//!
//! F(P) is Lambert's formula (`lambert`) for a convex polygon P of exitance 1, clipped at the horizon of x. A
//! convex blocker hides from x what lies in its shadow volume C (`visibility::shadow_volume`). The part of P
//! outside C₁, C₂, … gives
//!
//! ```text
//! F(P; C₁, C₂, …) = F(P; C₂, …) − F(P ∩ C₁; C₂, …) ,
//! ```
//!
//! so a single blocker costs two polygons. Where more than four overlap, P \ C₁ is cut into convex pieces
//! instead, one plane of the shadow volume at a time. Either way overlapping shadows count once. 0 ≤ F ≤ 1.

use radiosity_geom::DVec3;
use radiosity_visibility::blocker_shadow::BlockerShadow;
use radiosity_visibility::bounding_ball::Ball;
use radiosity_visibility::shadow_volume::{Corners, Coverage, ShadowVolume, cut_at_horizon, reach};
use smallvec::SmallVec;

use crate::irradiance::lambert;

/// Most overlapping shadow volumes for which the formula of the header is used: at most 2⁴ polygons. With
/// each further volume their number doubles, while cutting takes one for each plane of a volume.
const FEW: usize = 4;

/// Irradiance at `x` with the unit normal `n` from a convex planar polygon of exitance 1 without blockers.
/// The part below the horizon does not count.
pub fn irradiance(x: DVec3, n: DVec3, polygon: &[DVec3]) -> f64 {
    visible_irradiance(x, n, polygon, [].iter())
}

/// As [`irradiance`], from the part of the polygon outside all `volumes`, which are shadow volumes as seen
/// from `x`.
pub fn visible_irradiance<'a>(
    x: DVec3,
    n: DVec3,
    polygon: &[DVec3],
    volumes: impl Iterator<Item = &'a ShadowVolume>,
) -> f64 {
    let seen: Corners = polygon.iter().map(|corner| corner - x).collect();
    above_horizon(n, seen, volumes)
}

/// As [`irradiance`], from a polygon whose corners `seen` are relative to the point.
pub fn irradiance_seen(n: DVec3, seen: Corners) -> f64 {
    above_horizon(n, seen, [].iter())
}

fn above_horizon<'a>(n: DVec3, mut seen: Corners, volumes: impl Iterator<Item = &'a ShadowVolume>) -> f64 {
    if !seen.iter().all(|a| a.dot(n) >= 0.0) {
        cut_at_horizon(n, &mut seen);
    }
    outside(n, &seen, volumes)
}

/// Irradiance from the part of a polygon above the horizon that lies outside the shadow volumes `volumes`.
fn outside<'a>(n: DVec3, polygon: &[DVec3], volumes: impl Iterator<Item = &'a ShadowVolume>) -> f64 {
    let mut mixed: SmallVec<[&ShadowVolume; 8]> = SmallVec::new();
    for volume in volumes {
        match volume.coverage_seen(polygon) {
            Coverage::Clear => {}
            Coverage::Hidden => return 0.0,
            Coverage::Mixed => mixed.push(volume),
        }
    }
    let Some((first, rest)) = mixed.split_first() else { return lambert::polygon(n, polygon) };
    let rest = || rest.iter().copied();
    if mixed.len() > FEW {
        let mut parts = Vec::new();
        first.divide(polygon, &mut parts);
        return parts.iter().map(|part| outside(n, part, rest())).sum();
    }
    (outside(n, polygon, rest()) - outside(n, &first.hidden_part(polygon), rest())).max(0.0)
}

/// The part of the convex `polygon` inside any of `volumes`, which all have the same tip, as convex polygons
/// without overlaps, relative to that tip; and whether this part is the whole polygon. `ball` contains the
/// polygon.
pub fn inside_any(polygon: &[DVec3], ball: &Ball, volumes: &[BlockerShadow]) -> (Vec<Corners>, bool) {
    let Some(eye) = volumes.first().map(BlockerShadow::eye) else { return (Vec::new(), false) };
    let whole: Corners = polygon.iter().map(|corner| corner - eye).collect();
    let mut mixed: SmallVec<[&BlockerShadow; 8]> = SmallVec::new();
    // The reach of the whole bounds that of every part.
    let reach = reach(&whole);
    for volume in volumes.iter().filter(|volume| !volume.misses(ball)) {
        match volume.coverage_within(&whole, reach) {
            Coverage::Clear => {}
            Coverage::Hidden => return (vec![whole], true),
            Coverage::Mixed => mixed.push(volume),
        }
    }
    let Some((last, others)) = mixed.split_last() else { return (Vec::new(), false) };
    let (mut hidden, mut rest) = (Vec::new(), vec![whole]);
    for volume in others {
        let coverages: SmallVec<[Coverage; 16]> =
            rest.iter().map(|part| volume.coverage_within(part, reach)).collect();
        if coverages.iter().all(|coverage| *coverage == Coverage::Clear) {
            continue;
        }
        let mut kept = Vec::with_capacity(rest.len() + 4);
        for (part, coverage) in rest.into_iter().zip(coverages) {
            match coverage {
                Coverage::Clear => kept.push(part),
                Coverage::Hidden => hidden.push(part),
                Coverage::Mixed => {
                    let inner = volume.divide(&part, &mut kept);
                    hidden.extend((inner.len() > 2).then_some(inner));
                }
            }
        }
        rest = kept;
    }
    let mut is_all = true;
    for part in rest {
        let coverage = last.coverage_within(&part, reach);
        is_all &= coverage == Coverage::Hidden;
        match coverage {
            Coverage::Clear => {}
            Coverage::Hidden => hidden.push(part),
            Coverage::Mixed => hidden.extend(Some(last.hidden_part(&part)).filter(|inner| inner.len() > 2)),
        }
    }
    (hidden, is_all)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use proptest::prelude::*;
    use radiosity_geom::clip_polygon;

    use super::*;

    fn square(center: DVec3, half: f64) -> Vec<DVec3> {
        [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]]
            .map(|[x, y]| center + half * DVec3::new(x, y, 0.0))
            .to_vec()
    }

    fn seen(x: DVec3, lamp: &[DVec3], blockers: &[Vec<DVec3>]) -> f64 {
        let volumes: Vec<ShadowVolume> = blockers.iter().filter_map(|b| ShadowVolume::over(b, x)).collect();
        visible_irradiance(x, DVec3::Z, lamp, volumes.iter())
    }

    /// Below the corner of a rectangle a × b at distance c, with A = a/c, B = b/c: F = 1/(2π) [A/√(1+A²)
    /// atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))].
    #[test]
    fn rectangle_above_its_corner() {
        for (a, b) in [(1.0f64, 1.0f64), (0.3, 2.0), (20.0, 5.0)] {
            let lamp = [[0., 0.], [a, 0.], [a, b], [0., b]].map(|[x, y]| DVec3::new(x, y, 1.0));
            let half = |a: f64, b: f64| a / a.hypot(1.0) * (b / a.hypot(1.0)).atan();
            let exact = (half(a, b) + half(b, a)) / TAU;
            assert!((irradiance(DVec3::ZERO, DVec3::Z, &lamp) - exact).abs() < 1e-15);
        }
    }

    #[test]
    fn behind_the_horizon_is_dark() {
        let wall = [[1., -1., -1.], [1., 1., -1.], [1., 1., 1.], [1., -1., 1.]].map(DVec3::from_array);
        let upper = [[1., -1., 0.], [1., 1., 0.], [1., 1., 1.], [1., -1., 1.]].map(DVec3::from_array);
        let above = irradiance(DVec3::ZERO, DVec3::Z, &upper);
        assert!(above > 0.05);
        assert!((irradiance(DVec3::ZERO, DVec3::Z, &wall) - above).abs() < 1e-15);
        assert_eq!(irradiance(DVec3::ZERO, DVec3::Z, &square(-DVec3::Z, 1.0)), 0.0);
    }

    #[test]
    fn overlapping_blockers_count_once() {
        let lamp = square(DVec3::new(0., 0., 2.), 0.5);
        let plate = square(DVec3::new(1., 0., 1.), 1.0);
        let free = seen(DVec3::ZERO, &lamp, &[]);
        let half = seen(DVec3::ZERO, &lamp, std::slice::from_ref(&plate));
        assert!((half - 0.5 * free).abs() < 1e-15, "the plate hides the half with x > 0");
        let twice = seen(DVec3::ZERO, &lamp, &[plate.clone(), plate.clone()]);
        assert!((twice - half).abs() < 1e-15);
        let both = seen(DVec3::ZERO, &lamp, &[plate.clone(), square(DVec3::new(-1., 0., 1.5), 1.0)]);
        assert!(both.abs() < 1e-15);
        let plates: Vec<_> = (0..12)
            .map(|k| square(DVec3::new(1., 0.3 * f64::from(k % 3), 1.0 + 0.01 * f64::from(k)), 1.0))
            .collect();
        let of_many = seen(DVec3::ZERO, &lamp, &plates);
        let at_once = square(DVec3::new(1., 0.3, 1.0), 1.3);
        let of_one = seen(DVec3::ZERO, &lamp, &[at_once]);
        assert!(
            of_many <= half && of_many >= of_one,
            "twelve plates {of_many}, one {half}, a larger one {of_one}"
        );
        let behind = seen(DVec3::ZERO, &lamp, &[square(DVec3::new(0., 0., 3.), 2.0)]);
        assert!((behind - free).abs() < 1e-15);
    }

    proptest! {
        /// Light that a blocker lets pass, and light that would pass only through its outline, make up all of
        /// it.
        #[test]
        fn a_blocker_and_its_outline_share_the_light(
            x in (-1.0..1.0, -1.0..1.0), center in (-1.0..1.0, -1.0..1.0, 0.3..1.7), half in 0.1..0.8,
        ) {
            let x = DVec3::new(x.0, x.1, 0.0);
            let lamp = square(DVec3::new(0., 0., 2.), 0.7);
            let plate = square(DVec3::new(center.0, center.1, center.2), half);
            // The shadow of the plate in the plane of the lamp.
            let shadow: Vec<DVec3> = plate.iter().map(|p| x + (*p - x) * (2.0 / center.2)).collect();
            let mut through = lamp.clone();
            for k in 0..4 {
                let inward = DVec3::Z.cross(shadow[(k + 1) % 4] - shadow[k]);
                through = clip_polygon(&through, shadow[k], inward);
            }
            let hidden = if through.len() > 2 { irradiance(x, DVec3::Z, &through) } else { 0.0 };
            let passed = seen(x, &lamp, &[plate]);
            prop_assert!((hidden + passed - irradiance(x, DVec3::Z, &lamp)).abs() < 1e-14);
        }
    }
}
