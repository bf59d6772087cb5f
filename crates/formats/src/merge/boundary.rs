//! The boundary of a group of faces: simple loops, the outline first.

use std::collections::HashMap;

use glam::{DVec2, DVec3};
use radiosity_geom::{ROUNDING_OF_AREAS, ROUNDINGS_OF_PLANE, sides};

use super::corners::Corners;
use super::crossings::cross;
use super::face::Face;
use crate::tolerances::{PLANARITY_OF_FACE, ROUNDINGS_OF_CORNERS};

/// Width of a slit over its length up to which it closes: decimals that are usual leave less. With a larger
/// value narrow gaps that were meant close.
const SLIT: f64 = 1e-6;

/// A polygon that faces were merged to.
#[derive(Debug)]
pub(super) struct Merged {
    /// Indices of the surfaces that it replaces, ascending.
    pub(super) surfaces: Vec<usize>,
    /// Corners of the outline, counter-clockwise about the front, and of holes, clockwise.
    pub(super) loops: Vec<Vec<u32>>,
}

impl Merged {
    /// The polygon of a group of faces; none if it would not be sound.
    pub(super) fn of(group: &[u32], faces: &[Face], corners: &Corners) -> Option<Merged> {
        let faces: Vec<&Face> = group.iter().map(|face| &faces[*face as usize]).collect();
        let vector: DVec3 = faces.iter().map(|face| face.area * face.normal).sum();
        let sheet = Sheet::of(vector, corners)?;
        let sides = boundary(&faces)?;
        if !is_flat(&sides, &sheet) {
            return None;
        }
        let mut rings = Vec::new();
        let mut area = 0.0;
        for ring in loops(&sides, &successors(&sides, &sheet)?) {
            let (own, length) = sheet.area_and_length(&ring);
            // Both banks of a slit: faces meet there along parts of a side.
            let width = (ROUNDINGS_OF_CORNERS * corners.rounding(&ring)).max(SLIT * length);
            if own.abs() <= 0.5 * width * length {
                continue;
            }
            area += own;
            rings.push((own, ring));
        }
        rings.sort_by(|a, b| b.0.total_cmp(&a.0));
        let outlines = rings.iter().filter(|ring| ring.0 > 0.0).count();
        let parts: f64 = faces.iter().map(|face| face.area * face.normal.dot(sheet.normal)).sum();
        let loops: Vec<Vec<u32>> = rings.into_iter().map(|(_, ring)| ring).collect();
        let rounding = loops.iter().map(|ring| corners.rounding(ring)).fold(0.0, f64::max);
        let is_sound = outlines == 1 && (area - parts).abs() <= ROUNDING_OF_AREAS * parts;
        if !is_sound || cross(&sheet.flat(&loops), ROUNDINGS_OF_CORNERS * rounding) {
            return None;
        }
        let mut surfaces: Vec<usize> = faces.iter().map(|face| face.surface).collect();
        surfaces.sort_unstable();
        Some(Merged { surfaces, loops })
    }
}

/// Sides that only one face has, sorted by their starts. None if two faces have one in the same direction.
fn boundary(faces: &[&Face]) -> Option<Vec<[u32; 2]>> {
    let mut sides: Vec<[u32; 2]> = faces.iter().flat_map(|face| sides(&face.ring)).collect();
    sides.sort_unstable();
    if sides.windows(2).any(|pair| pair[0] == pair[1]) {
        return None;
    }
    Some(sides.iter().copied().filter(|[a, b]| sides.binary_search(&[*b, *a]).is_err()).collect())
}

/// Whether all corners lie in a plane, up to a part of the group's extent or up to rounding.
fn is_flat(sides: &[[u32; 2]], sheet: &Sheet) -> bool {
    let Some([first, _]) = sides.first() else { return false };
    let origin = sheet.corners.point(*first);
    let offsets = || sides.iter().map(|[a, _]| sheet.corners.point(*a) - origin);
    let size = offsets().map(DVec3::length).fold(0.0, f64::max);
    let height = offsets().map(|x| x.dot(sheet.normal).abs()).fold(0.0, f64::max);
    let rounding = sides.iter().map(|side| sheet.corners.rounding(side)).fold(0.0, f64::max);
    height <= (PLANARITY_OF_FACE * size).max(ROUNDINGS_OF_PLANE * rounding)
}

/// Index of the next side of each side along the boundary: around the corner where the side ends, the first
/// one clockwise from the way back. None if faces overlap at a corner: sides that leave it and sides that
/// reach it do not alternate there.
fn successors(sides: &[[u32; 2]], sheet: &Sheet) -> Option<Vec<usize>> {
    // Sides at each corner: the angle, whether it leaves, its index.
    let mut stars: HashMap<u32, Vec<(f64, bool, usize)>> = HashMap::new();
    for (index, [from, to]) in sides.iter().enumerate() {
        for (corner, end, leaves) in [(from, to, true), (to, from, false)] {
            let way = sheet.point(*end) - sheet.point(*corner);
            stars.entry(*corner).or_default().push((f64::atan2(way.y, way.x), leaves, index));
        }
    }
    let mut successors = vec![0; sides.len()];
    for mut star in stars.into_values() {
        // The banks of a slit have one angle: the side that reaches the corner first, counter-clockwise.
        star.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let before = star.iter().cycle().skip(star.len() - 1);
        for ((_, leaves, index), (_, other_leaves, other)) in star.iter().zip(before) {
            match (leaves, other_leaves) {
                (false, true) => successors[*index] = *other,
                (true, false) => {}
                _ => return None,
            }
        }
    }
    Some(successors)
}

/// The plane of a group, with flat coordinates.
struct Sheet<'a> {
    normal: DVec3,
    axes: [DVec3; 2],
    corners: &'a Corners,
}

impl<'a> Sheet<'a> {
    fn of(vector: DVec3, corners: &'a Corners) -> Option<Self> {
        let normal = vector.try_normalize()?;
        let x = normal.any_orthonormal_vector();
        Some(Sheet { normal, axes: [x, normal.cross(x)], corners })
    }

    fn point(&self, corner: u32) -> DVec2 {
        let point = self.corners.point(corner);
        DVec2::new(point.dot(self.axes[0]), point.dot(self.axes[1]))
    }

    fn flat(&self, loops: &[Vec<u32>]) -> Vec<Vec<DVec2>> {
        loops.iter().map(|ring| ring.iter().map(|corner| self.point(*corner)).collect()).collect()
    }

    /// Area of a loop, above 0 if it runs counter-clockwise, and its length.
    fn area_and_length(&self, ring: &[u32]) -> (f64, f64) {
        let Some(first) = ring.first() else { return (0.0, 0.0) };
        let origin = self.corners.point(*first);
        let (mut area, mut length) = (0.0, 0.0);
        for side in sides(ring) {
            let [a, b] = side.map(|corner| self.corners.point(corner) - origin);
            area += 0.5 * a.cross(b).dot(self.normal);
            length += a.distance(b);
        }
        (area, length)
    }
}

/// The loops that sides and their successors form; none visits a corner twice.
fn loops(sides: &[[u32; 2]], successors: &[usize]) -> Vec<Vec<u32>> {
    let mut is_used = vec![false; sides.len()];
    let mut loops = Vec::new();
    for start in 0..sides.len() {
        let mut path: Vec<u32> = Vec::new();
        // Where on the path corners stand. Where one is met again, the loop between is taken out.
        let mut met: HashMap<u32, usize> = HashMap::new();
        let mut side = start;
        while !std::mem::replace(&mut is_used[side], true) {
            let corner = sides[side][0];
            if let Some(place) = met.get(&corner).copied() {
                let ring = path.split_off(place);
                for corner in &ring {
                    met.remove(corner);
                }
                loops.push(ring);
            }
            met.insert(corner, path.len());
            path.push(corner);
            side = successors[side];
        }
        loops.push(path);
    }
    loops.retain(|ring| ring.len() > 2);
    loops
}
