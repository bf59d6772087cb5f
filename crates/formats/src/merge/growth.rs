//! Groups of faces in one plane that hang together by their sides.

use radiosity_geom::{ROUNDINGS_OF_PLANE, sides};

use super::corners::Corners;
use super::face::Face;
use crate::tolerances::PLANARITY_OF_FACE;

/// Faces at a side beyond which it joins nothing: walls and partitions that meet are fewer, and the
/// pairs grow with their square.
const MOST_AT_SIDE: usize = 16;

/// A side of a face.
struct Side {
    /// Faces of one joint may be joined along it.
    joint: Joint,
    face: u32,
    is_forward: bool,
}

/// A side at which faces of one key meet.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Joint {
    /// Key of the faces.
    key: usize,
    /// Corners at the ends of the side, ascending.
    ends: [u32; 2],
}

/// Groups of two or more faces, each a list of faces.
pub(super) fn groups(faces: &[Face], corners: &Corners) -> Vec<Vec<u32>> {
    let neighbours = neighbours(faces);
    let mut seeds: Vec<u32> = (0..faces.len() as u32).collect();
    seeds.sort_by(|a, b| faces[*b as usize].area.total_cmp(&faces[*a as usize].area));
    let mut is_taken = vec![false; faces.len()];
    let mut groups = Vec::new();
    for seed in seeds {
        if is_taken[seed as usize] {
            continue;
        }
        is_taken[seed as usize] = true;
        let first = &faces[seed as usize];
        let origin = corners.point(first.ring[0]);
        let mut group = vec![seed];
        let mut next = 0;
        while let Some(face) = group.get(next).copied() {
            next += 1;
            for other in neighbours.of(face) {
                let joined = &faces[*other as usize];
                let rounded = ROUNDINGS_OF_PLANE * first.rounding.max(joined.rounding);
                let is_near = |x: &u32| {
                    let way = corners.point(*x) - origin;
                    way.dot(first.normal).abs()
                        <= (PLANARITY_OF_FACE * first.extent.max(way.length())).max(rounded)
                };
                if !is_taken[*other as usize]
                    && joined.is_level_with(first)
                    && joined.ring.iter().all(is_near)
                {
                    is_taken[*other as usize] = true;
                    group.push(*other);
                }
            }
        }
        if group.len() > 1 {
            groups.push(group);
        }
    }
    groups
}

/// The neighbours of each face.
struct Neighbours {
    pairs: Vec<(u32, u32)>,
    starts: Vec<usize>,
}

impl Neighbours {
    fn of(&self, face: u32) -> impl Iterator<Item = &u32> {
        let range = self.starts[face as usize]..self.starts[face as usize + 1];
        self.pairs[range].iter().map(|(_, other)| other)
    }
}

/// Faces that meet over a whole side, level, and no third one level with them there.
fn neighbours(faces: &[Face]) -> Neighbours {
    let mut pairs = Vec::new();
    for joint in sides_of(faces).chunk_by(|a, b| a.joint == b.joint) {
        if joint.len() > MOST_AT_SIDE {
            continue;
        }
        for side in joint {
            let own = &faces[side.face as usize];
            let level = || joint.iter().filter(|x| faces[x.face as usize].is_level_with(own));
            let mut opposite = level().filter(|x| x.is_forward != side.is_forward);
            let is_single = level().filter(|x| x.is_forward == side.is_forward).count() == 1;
            if let (Some(other), None, true) = (opposite.next(), opposite.next(), is_single) {
                pairs.push((side.face, other.face));
            }
        }
    }
    pairs.sort_unstable();
    let starts = (0..=faces.len() as u32).map(|face| pairs.partition_point(|pair| pair.0 < face)).collect();
    Neighbours { pairs, starts }
}

/// All sides of all faces, sides of one joint one after another.
fn sides_of(faces: &[Face]) -> Vec<Side> {
    let mut all = Vec::new();
    for (index, face) in faces.iter().enumerate() {
        for [a, b] in sides(&face.ring) {
            all.push(Side {
                joint: Joint { key: face.key, ends: [a.min(b), a.max(b)] },
                face: index as u32,
                is_forward: a < b,
            });
        }
    }
    all.sort_unstable_by_key(|side| (side.joint, side.face, side.is_forward));
    all
}
