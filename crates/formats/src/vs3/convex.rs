//! Polygons with holes in convex pieces of three or four corners.

use std::collections::HashMap;

use earcut::Earcut;
use glam::{DVec2, DVec3};
use radiosity_geom::ROUNDING_OF_AREAS;

/// Convex pieces that together are `outline` without `holes`, each seen from the same side counter-clockwise
/// as the outline; none where the outlines cross.
pub(super) fn pieces(outline: &[DVec3], holes: &[Vec<DVec3>]) -> Option<Vec<Vec<DVec3>>> {
    let points: Vec<DVec3> = outline.iter().chain(holes.iter().flatten()).copied().collect();
    let flat = flat(&points, outline)?;
    if holes.is_empty() && matches!(outline.len(), 3 | 4) && is_convex(&flat) {
        return Some(vec![outline.to_vec()]);
    }
    let mut starts = Vec::with_capacity(holes.len());
    let (mut start, mut wanted) = (outline.len(), area(&flat[..outline.len()]));
    for hole in holes {
        starts.push(start);
        wanted -= area(&flat[start..start + hole.len()]).abs();
        start += hole.len();
    }
    let mut corners: Vec<usize> = Vec::new();
    Earcut::new().earcut(flat.iter().map(|p| p.to_array()), &starts, &mut corners);
    let triangles: Vec<[usize; 3]> =
        corners.chunks_exact(3).map(|t| turned([t[0], t[1], t[2]], &flat)).collect();
    let areas: Vec<f64> = triangles.iter().map(|t| turn(&flat, *t)).collect();
    let is_whole = (areas.iter().sum::<f64>() / 2.0 - wanted).abs() <= ROUNDING_OF_AREAS * wanted;
    let sound: Vec<[usize; 3]> = triangles
        .into_iter()
        .zip(&areas)
        .filter(|(_, area)| **area > ROUNDING_OF_AREAS * ROUNDING_OF_AREAS * wanted)
        .map(|(t, _)| t)
        .collect();
    let joined = joined(&sound, &flat);
    (is_whole && wanted > 0.0)
        .then(|| joined.iter().map(|piece| piece.iter().map(|corner| points[*corner]).collect()).collect())
}

/// The points in the plane of the outline, within a square of side 1; the outline runs counter-clockwise.
/// None without a plane.
fn flat(points: &[DVec3], outline: &[DVec3]) -> Option<Vec<DVec2>> {
    let first = *outline.first()?;
    let size = points.iter().map(|p| (*p - first).abs().max_element()).fold(0.0, f64::max);
    let near: Vec<DVec3> = points.iter().map(|p| (*p - first) / size).collect();
    let own = near.get(..outline.len())?;
    let normal: DVec3 = own.iter().zip(own.iter().cycle().skip(1)).map(|(a, b)| a.cross(*b)).sum();
    let weights = normal.abs();
    // The two coordinates that the plane shows largest, so ordered that the outline turns left.
    let (drop, is_up) = match (weights.x >= weights.y, weights.x.max(weights.y) >= weights.z) {
        (true, true) => (0, normal.x > 0.0),
        (false, true) => (1, normal.y > 0.0),
        (_, false) => (2, normal.z > 0.0),
    };
    let [a, b] = if is_up { [(drop + 1) % 3, (drop + 2) % 3] } else { [(drop + 2) % 3, (drop + 1) % 3] };
    let is_sound =
        size.is_finite() && normal.is_finite() && normal.max_element().max(-normal.min_element()) > 0.0;
    is_sound.then(|| near.iter().map(|p| DVec2::new(p[a], p[b])).collect())
}

fn area(ring: &[DVec2]) -> f64 {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() / 2.0
}

/// Twice the area of a triangle, positive if it turns left.
fn turn(flat: &[DVec2], [a, b, c]: [usize; 3]) -> f64 {
    (flat[b] - flat[a]).perp_dot(flat[c] - flat[a])
}

fn turned([a, b, c]: [usize; 3], flat: &[DVec2]) -> [usize; 3] {
    if turn(flat, [a, b, c]) < 0.0 { [a, c, b] } else { [a, b, c] }
}

fn is_convex(ring: &[DVec2]) -> bool {
    let count = ring.len();
    (0..count).all(|k| turn(ring, [k, (k + 1) % count, (k + 2) % count]) > ROUNDING_OF_AREAS)
}

/// Pairs of neighbouring triangles as convex quadrilaterals where they make one, first come first served.
fn joined(triangles: &[[usize; 3]], flat: &[DVec2]) -> Vec<Vec<usize>> {
    let sides = |t: &[usize; 3]| [0, 1, 2].map(|k| (t[k], t[(k + 1) % 3], t[(k + 2) % 3]));
    let mut of_side = HashMap::new();
    for (index, triangle) in triangles.iter().enumerate() {
        for (a, b, c) in sides(triangle) {
            of_side.insert((a, b), (index, c));
        }
    }
    let mut is_taken = vec![false; triangles.len()];
    let mut pieces = Vec::new();
    for (index, triangle) in triangles.iter().enumerate() {
        if std::mem::replace(&mut is_taken[index], true) {
            continue;
        }
        let partner = sides(triangle).into_iter().find_map(|(a, b, c)| {
            let (other, d) = *of_side.get(&(b, a))?;
            let quad = [a, d, b, c];
            (!is_taken[other] && is_convex(&quad.map(|corner| flat[corner]))).then_some((other, quad))
        });
        match partner {
            Some((other, quad)) => {
                is_taken[other] = true;
                pieces.push(quad.to_vec());
            }
            None => pieces.push(triangle.to_vec()),
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(low: f64, high: f64, z: f64) -> Vec<DVec3> {
        vec![
            DVec3::new(low, low, z),
            DVec3::new(high, low, z),
            DVec3::new(high, high, z),
            DVec3::new(low, high, z),
        ]
    }

    fn vector(piece: &[DVec3]) -> DVec3 {
        piece.iter().zip(piece.iter().cycle().skip(1)).map(|(a, b)| a.cross(*b)).sum::<DVec3>() / 2.0
    }

    #[test]
    fn squares_stay_whole_and_frames_become_pieces_that_face_as_they_do() {
        assert_eq!(pieces(&square(0.0, 1.0, 5.0), &[]), Some(vec![square(0.0, 1.0, 5.0)]));
        let frame = pieces(&square(0.0, 3.0, 5.0), &[square(1.0, 2.0, 5.0)]).expect("a frame has pieces");
        assert!(frame.iter().all(|piece| matches!(piece.len(), 3 | 4) && vector(piece).z > 0.0));
        assert!((frame.iter().map(|piece| vector(piece).z).sum::<f64>() - 8.0).abs() < 1e-12);
        assert!(frame.len() <= 6, "{frame:?}");
        let down: Vec<DVec3> = square(0.0, 3.0, 5.0).into_iter().rev().collect();
        let frame = pieces(&down, &[square(1.0, 2.0, 5.0)]).expect("a frame has pieces");
        assert!(frame.iter().all(|piece| vector(piece).z < 0.0));
    }

    #[test]
    fn outlines_that_cross_have_no_pieces() {
        let mut bow = square(0.0, 1.0, 0.0);
        bow.swap(2, 3);
        assert_eq!(pieces(&bow, &[]), None);
        assert_eq!(pieces(&[DVec3::ZERO; 3], &[]), None);
        assert_eq!(pieces(&square(0.0, 1.0, 0.0), &[square(0.5, 2.0, 0.0)]), None);
    }
}
