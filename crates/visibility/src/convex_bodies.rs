//! Convex bodies: planar surfaces that close a convex solid, which hides as a whole.
//!
//! From a point x outside, a convex body hides
//!
//! ```text
//! H(x) = the cone from x over its outline ∩ what lies behind every face that x lies in front of ,
//! ```
//!
//! its inside included: on a segment from x the body begins where the last of these faces is passed. The
//! outline consists of the edges between a face that x lies in front of and one that it does not. H is
//! convex, while the shadows of the faces overlap: a block has one shadow volume instead of five.
//!
//! One face may be missing if the whole scene lies on the body's side of its plane, as for a block on a
//! floor: no segment between points of the scene passes there.

use std::collections::HashMap;

use radiosity_geom::{Aabb, COINCIDENT, DVec3, Plane, sides, touching};
use smallvec::SmallVec;

use crate::blocker_edges::BlockerEdge;
use crate::bounding_ball::Ball;
use crate::cloud::Cloud;
use crate::shadow_volume::{HalfSpace, ShadowVolume};

/// Fewest faces of a body, without the missing one: a tetrahedron has four.
const FEWEST: usize = 3;

/// Least depth of a body below each of its faces, over its diameter, far above the [`touching`] within which
/// corners lie behind a face. A flatter group is a sheet with two sides, which hides by its faces.
const THINNEST: f64 = 1e-6;

/// A planar surface without holes, as a face.
#[derive(Debug)]
pub(super) struct Face<'a> {
    /// Index of the surface.
    pub(super) surface: usize,
    /// Corners, counter-clockwise about the normal.
    pub(super) outline: &'a [DVec3],
    /// Unit normal of the front.
    pub(super) normal: DVec3,
}

/// The bodies of a scene.
#[derive(Debug)]
pub(super) struct Bodies {
    list: Vec<Body>,
    /// The body of each surface, by index, if it has one.
    of_surface: Vec<Option<usize>>,
}

#[derive(Debug)]
pub(super) struct Body {
    /// The surfaces of its faces, ascending.
    pub(super) surfaces: Vec<usize>,
    /// Its corners, some more than once.
    pub(super) hull: Vec<DVec3>,
    /// Ball around the corners.
    pub(super) ball: Ball,
    pub(super) bounds: Aabb,
    /// Mean of its corners.
    middle: DVec3,
    /// The planes of its faces, with outward normals; the last one may be the missing face.
    planes: Vec<Plane>,
    is_open: bool,
    edges: Vec<Edge>,
}

/// An edge between two faces, given by their indices.
#[derive(Debug)]
struct Edge {
    ends: [DVec3; 2],
    between: [usize; 2],
}

impl Bodies {
    /// The bodies that `faces` close in a scene of `surfaces` surfaces inside the hull of `cloud`; `twins`
    /// lie beyond their sides.
    pub(super) fn new(faces: &[Face], twins: &[Vec<Option<usize>>], surfaces: usize, cloud: &Cloud) -> Self {
        let mut bodies = Self { list: Vec::new(), of_surface: vec![None; surfaces] };
        let mut seen = vec![false; faces.len()];
        for first in 0..faces.len() {
            let group = group(first, twins, &mut seen);
            if let Some(body) = Body::of(&group, faces, twins, cloud) {
                group
                    .iter()
                    .for_each(|face| bodies.of_surface[faces[*face].surface] = Some(bodies.list.len()));
                bodies.list.push(body);
            }
        }
        bodies
    }

    /// The body that a surface belongs to.
    pub(super) fn of(&self, surface: usize) -> Option<&Body> {
        self.place(surface).map(|body| &self.list[body])
    }

    /// The index of that body.
    pub(super) fn place(&self, surface: usize) -> Option<usize> {
        self.of_surface[surface]
    }
}

/// For each side of each face the face beyond that edge: the only one with a side along it in the other
/// direction.
pub(super) fn twins(faces: &[Face]) -> Vec<Vec<Option<usize>>> {
    let key = |[a, b]: [DVec3; 2]| {
        // A power of two, equal for both directions of an edge; 1.37 keeps round lengths away from where it
        // jumps.
        let tolerance = touching((1.37 * a.distance(b)).log2().floor().exp2(), 0.0);
        [a, b].map(|x| (x / tolerance).round().to_array().map(|x| x as i64))
    };
    let mut runs: HashMap<[[i64; 3]; 2], SmallVec<[usize; 2]>> = HashMap::new();
    for (index, face) in faces.iter().enumerate() {
        sides(face.outline).for_each(|side| runs.entry(key(side)).or_default().push(index));
    }
    let twin = |[a, b]: [DVec3; 2]| {
        let (along, back) = (runs.get(&key([a, b]))?, runs.get(&key([b, a]))?);
        (along.len() == 1 && back.len() == 1).then_some(back[0])
    };
    faces.iter().map(|face| sides(face.outline).map(twin).collect()).collect()
}

/// The faces connected with `first` through edges; empty if `seen` already contains it.
fn group(first: usize, twins: &[Vec<Option<usize>>], seen: &mut [bool]) -> Vec<usize> {
    let (mut group, mut open) = (Vec::new(), vec![first]);
    while let Some(face) = open.pop() {
        if !std::mem::replace(&mut seen[face], true) {
            group.push(face);
            open.extend(twins[face].iter().flatten());
        }
    }
    group
}

impl Body {
    /// The body that a group of faces closes, if any.
    fn of(group: &[usize], faces: &[Face], twins: &[Vec<Option<usize>>], cloud: &Cloud) -> Option<Self> {
        if group.len() < FEWEST {
            return None;
        }
        let mut hull: Vec<DVec3> =
            group.iter().flat_map(|face| faces[*face].outline.iter().copied()).collect();
        hull.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
        hull.dedup();
        let middle = hull.iter().sum::<DVec3>() / hull.len() as f64;
        let ball = Ball::around(&hull);
        let size = 2.0 * ball.radius();
        let plane = |face: &usize| Plane { point: faces[*face].outline[0], normal: faces[*face].normal };
        let mut planes: Vec<Plane> = group.iter().map(plane).collect();
        let places: HashMap<usize, usize> =
            group.iter().enumerate().map(|(own, face)| (*face, own)).collect();
        let (mut edges, mut border) = (Vec::new(), Vec::new());
        for (own, face) in group.iter().enumerate() {
            for (ends, twin) in sides(faces[*face].outline).zip(&twins[*face]) {
                match twin.and_then(|twin| places.get(&twin).copied()) {
                    None => {
                        border.push(ends);
                        edges.push(Edge { ends, between: [own, group.len()] });
                    }
                    Some(other) if own < other => edges.push(Edge { ends, between: [own, other] }),
                    Some(_) => {}
                }
            }
        }
        if !border.is_empty() {
            planes.push(missing_face(&border, cloud, size)?);
        }
        let lies_behind = |plane: &Plane| hull.iter().all(|x| plane.height(*x) <= touching(size, 0.0));
        let is_thick = |plane: &Plane| hull.iter().any(|x| plane.height(*x) < -THINNEST * size);
        let is_convex = planes.iter().all(|plane| lies_behind(plane) && is_thick(plane));
        let mut surfaces: Vec<usize> = group.iter().map(|face| faces[*face].surface).collect();
        surfaces.sort_unstable();
        let (bounds, is_open) = (Aabb::around(hull.iter().copied()), !border.is_empty());
        is_convex.then_some(Self { surfaces, hull, ball, bounds, middle, planes, is_open, edges })
    }

    /// Its edges.
    pub(super) fn blocker_edges(&self) -> impl Iterator<Item = BlockerEdge> {
        let faces = |edge: &Edge| edge.between.map(|face| self.planes[face]);
        self.edges.iter().map(move |edge| BlockerEdge { ends: edge.ends, faces: faces(edge).into() })
    }

    /// The shadow volume of the body from `x`; None where x is not outside, and each face hides by itself.
    pub(super) fn volume(&self, x: DVec3) -> Option<ShadowVolume> {
        let margin = COINCIDENT * x.distance(self.middle);
        let heights: SmallVec<[f64; 8]> = self.planes.iter().map(|plane| plane.height(x)).collect();
        let is_front = |face: usize| heights[face] > margin;
        if (self.is_open && is_front(heights.len() - 1)) || !(0..heights.len()).any(is_front) {
            return None;
        }
        let outline = self.edges.iter().filter(|edge| is_front(edge.between[0]) != is_front(edge.between[1]));
        let fronts = (0..heights.len()).filter(|face| is_front(*face));
        let fronts = fronts.map(|face| HalfSpace { inward: -self.planes[face].normal, depth: heights[face] });
        Some(ShadowVolume::bounded(x, self.middle, outline.map(|edge| edge.ends), fronts))
    }
}

/// The plane of the face that would close a body along `border`, if it is flat and the whole scene lies
/// behind it.
fn missing_face(border: &[[DVec3; 2]], cloud: &Cloud, size: f64) -> Option<Plane> {
    let point = border[0][0];
    let area: DVec3 = border.iter().map(|[a, b]| (b - point).cross(a - point)).sum();
    let plane = Plane { point, normal: area.try_normalize()? };
    let is_flat = border.iter().all(|[a, _]| plane.height(*a).abs() <= touching(size, 0.0));
    (is_flat && cloud.lies_below(0.0, &plane, size)).then_some(plane)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::shapes::Parallelogram;
    use radiosity_geom::{Ray, Surface};

    use super::*;

    /// The faces of a parallelepiped around the origin, their fronts outside; the bottom is the last.
    fn block(axes: [DVec3; 3]) -> Vec<Vec<DVec3>> {
        let [a, b, c] = axes;
        let (a, b) = if a.cross(b).dot(c) < 0.0 { (b, a) } else { (a, b) };
        let face = |n: DVec3, u: DVec3, v: DVec3| vec![n - u - v, n + u - v, n + u + v, n - u + v];
        vec![face(a, b, c), face(-a, c, b), face(b, c, a), face(-b, a, c), face(c, a, b), face(-c, b, a)]
    }

    /// The bodies that the faces with these `outlines` close, in a scene with the further points `others`.
    fn bodies(outlines: &[Vec<DVec3>], others: &[DVec3]) -> Bodies {
        let normal = |outline: &[DVec3]| (outline[1] - outline[0]).cross(outline[2] - outline[0]).normalize();
        let face = |(surface, outline): (usize, &'_ Vec<DVec3>)| (surface, normal(outline));
        let normals: Vec<(usize, DVec3)> = outlines.iter().enumerate().map(face).collect();
        let faces: Vec<Face> = normals
            .iter()
            .zip(outlines)
            .map(|((surface, normal), outline)| Face { surface: *surface, outline, normal: *normal })
            .collect();
        let points: Vec<DVec3> = outlines.iter().flatten().chain(others).copied().collect();
        Bodies::new(&faces, &twins(&faces), outlines.len(), &Cloud::new(points))
    }

    fn is_met(outline: &[DVec3], x: DVec3, y: DVec3) -> bool {
        let face = Parallelogram::new(outline[0], outline[1] - outline[0], outline[3] - outline[0]);
        face.expect("it is one").occludes(&Ray { origin: x, direction: y - x, range: [0.0, 1.0] })
    }

    fn vector() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array)
    }

    #[test]
    fn rooms_lone_plates_and_open_boxes_are_none() {
        let cube = block([DVec3::X, DVec3::Y, DVec3::Z]);
        let room: Vec<Vec<DVec3>> = cube.iter().map(|face| face.iter().rev().copied().collect()).collect();
        let is_none = |outlines: &[Vec<DVec3>], others: &[DVec3]| bodies(outlines, others).list.is_empty();
        assert!(!is_none(&cube, &[-5.0 * DVec3::Z]));
        assert!(is_none(&room, &[]));
        assert!(is_none(&cube[..2], &[]) && is_none(&cube[..4], &[]));
        // Without a bottom, with nothing below it and with something.
        assert!(!is_none(&cube[..5], &[5.0 * DVec3::X - DVec3::Z]));
        assert!(is_none(&cube[..5], &[-1.1 * DVec3::Z]));
        // Faces that are there twice, as front and back.
        let twice: Vec<Vec<DVec3>> = cube.iter().chain(&room).cloned().collect();
        assert!(is_none(&twice, &[]));
    }

    #[test]
    fn from_within_and_from_below_a_missing_face_nothing_is_hidden_as_a_whole() {
        let bodies = bodies(&block([DVec3::X, DVec3::Y, DVec3::Z])[..5], &[]);
        assert!(bodies.list[0].volume(0.5 * DVec3::Z).is_none() && bodies.list[0].volume(DVec3::Z).is_none());
        assert!(bodies.list[0].volume(-2.0 * DVec3::Z).is_none());
        assert!(bodies.list[0].volume(2.0 * DVec3::X).is_some());
    }

    proptest! {
        /// A body hides what its faces hide: all of them, or all but the one that stands on the ground.
        #[test]
        fn a_body_hides_what_its_faces_hide(
            axes in prop::array::uniform3(vector()), x in vector(), y in vector(), stands in any::<bool>(),
        ) {
            let [a, b, c] = axes;
            prop_assume!(a.cross(b).dot(c).abs() > 0.05);
            let faces = block(axes);
            let faces = &faces[..if stands { 5 } else { 6 }];
            let (x, y) = (3.0 * x, 3.0 * y);
            let up = a.cross(b) * a.cross(b).dot(c).signum();
            prop_assume!(!stands || (x + c).dot(up).min((y + c).dot(up)) > 1e-3);
            let bodies = bodies(faces, &[]);
            prop_assert_eq!(bodies.list.len(), 1);
            let Some(volume) = bodies.list[0].volume(x) else { return Ok(()) };
            prop_assert_eq!(volume.hides(y), faces.iter().any(|face| is_met(face, x, y)));
        }
    }
}
