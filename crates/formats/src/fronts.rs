//! Which way the fronts of bodies point.
//!
//! Faces that share a whole side belong together. Where the front of one turns into the back of its
//! neighbour, the lesser area is turned. A closed body shows its fronts outwards, a room, which has
//! everything else inside, inwards.

mod corners;

use std::collections::{BTreeSet, HashMap};

use glam::DVec3;
use radiosity_geom::area_vector;
use radiosity_geom::{Aabb, Bvh, ROUNDING_OF_AREAS, sides};

use crate::model::{Model, Shape, Sides};
use corners::Corners;

/// Most surfaces that are asked whether they lie in a body before it counts as empty: a bound of time, as
/// each takes all faces of the body. A body whose first 64 neighbours lie outside may be taken for empty.
const ASKED: usize = 64;

/// Faces whose fronts point the wrong way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TurnedFaces {
    /// Reason for which the fronts seem to be wrong.
    pub why: TurnReason,
    /// Indices of the faces among the model's surfaces.
    pub surfaces: Vec<usize>,
    /// The index of a surface that they belong to the same body with.
    pub beside: usize,
}

/// Reasons for which fronts seem to point the wrong way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TurnReason {
    /// Neighbours of the faces have more area and show their fronts on the other side.
    Neighbours,
    /// Neighbours of the faces have as much area and show their fronts on the other side: either may be
    /// wrong.
    Halves,
    /// A closed body with nothing in it shows its fronts inwards.
    Inwards,
    /// A room with everything else in it shows its fronts outwards.
    Outwards,
}

/// The faces whose fronts point the wrong way, body by body. Only flat and bilinear one-sided surfaces are
/// looked at.
pub(crate) fn turned(model: &Model) -> Vec<TurnedFaces> {
    let faces = Faces::of(model);
    let middles = Middles::of(model);
    let mut found = Vec::new();
    for body in faces.bodies() {
        let (minority, why) = faces.minority(&body);
        let is_whole = body.is_closed && body.members.len() > 3;
        let beside = body.members[0].face;
        if !minority.is_empty() {
            let beside = body.members.iter().map(|own| own.face).find(|face| !minority.contains(face));
            found.push(TurnedFaces {
                why,
                surfaces: minority.iter().map(|face| faces.list[*face].surface).collect(),
                beside: faces.list[beside.unwrap_or(body.members[0].face)].surface,
            });
        }
        if !is_whole || why == TurnReason::Halves {
            continue;
        }
        let shell = faces.shell(&body, &minority);
        if let Some(why) = shell.fault(model, &middles) {
            let surfaces = body.members.iter().map(|own| faces.list[own.face].surface).collect();
            found.push(TurnedFaces { why, surfaces, beside: faces.list[beside].surface });
        }
    }
    found
}

/// A point of a surface, or in the middle of it.
fn middle(shape: &Shape) -> DVec3 {
    match (shape, shape.rings().first(), shape.mantle()) {
        (_, Some(outline), _) => outline.iter().sum::<DVec3>() / outline.len().max(1) as f64,
        (_, _, Some(mantle)) => mantle.base + 0.5 * mantle.axis,
        _ => shape.numbers().0[0],
    }
}

/// Points in the middle of all surfaces.
struct Middles {
    points: Vec<DVec3>,
    tree: Bvh,
}

impl Middles {
    fn of(model: &Model) -> Self {
        let points: Vec<DVec3> = model.surfaces.iter().map(|surface| middle(&surface.shape)).collect();
        let boxes: Vec<Aabb> = points.iter().map(|x| Aabb { min: *x, max: *x }).collect();
        Middles { points, tree: Bvh::build(&boxes) }
    }

    /// The middles in a box of other surfaces than `own`, in order.
    fn within(&self, bounds: &Aabb, own: &BTreeSet<usize>) -> Vec<DVec3> {
        let others = self.tree.near(bounds).into_iter().filter(|surface| !own.contains(surface));
        others.map(|surface| self.points[surface]).filter(|x| bounds.contains(*x)).collect()
    }
}

/// A face as rings of common corners, the outline first; holes run against it.
struct Face {
    surface: usize,
    rings: Vec<Vec<usize>>,
    /// Corners in space, ring by ring.
    points: Vec<Vec<DVec3>>,
}

impl Face {
    /// Area of the face, holes taken off (length²).
    fn area(&self) -> f64 {
        self.points.iter().map(|ring| area_vector(ring)).sum::<DVec3>().length()
    }
}

struct Faces {
    list: Vec<Face>,
    /// The faces along each side, given by its lower corner and its higher one.
    along: HashMap<[usize; 2], Vec<SideFace>>,
}

/// A face at a side.
#[derive(Clone, Copy)]
struct SideFace {
    face: usize,
    /// Whether its ring runs from the lower corner of the side to the higher one.
    is_forward: bool,
}

impl Faces {
    fn of(model: &Model) -> Self {
        let mut corners = Corners::new(model);
        let mut faces = Faces { list: Vec::new(), along: HashMap::new() };
        for (surface, found) in model.surfaces.iter().enumerate() {
            if found.sides == Sides::Both {
                continue;
            }
            let points = match &found.shape {
                Shape::Polygon { outline, holes } => against(outline, holes),
                Shape::Quad(corners) => vec![corners.to_vec()],
                _ => continue,
            };
            let ring = |ring: &Vec<DVec3>| ring.iter().map(|x| corners.take(*x)).collect::<Vec<_>>();
            let rings: Vec<Vec<usize>> = points.iter().map(ring).collect();
            let face = faces.list.len();
            for ring in &rings {
                for [a, b] in sides(ring).filter(|[a, b]| a != b) {
                    let side = SideFace { face, is_forward: a < b };
                    faces.along.entry([a.min(b), a.max(b)]).or_default().push(side);
                }
            }
            faces.list.push(Face { surface, rings, points });
        }
        faces
    }

    fn bodies(&self) -> Vec<Body> {
        let mut seen = vec![false; self.list.len()];
        let mut bodies = Vec::new();
        for first in 0..self.list.len() {
            if !seen[first] {
                bodies.push(self.body(first, &mut seen));
            }
        }
        bodies
    }

    /// The faces that a face hangs together with, over sides that only two faces have.
    fn body(&self, first: usize, seen: &mut [bool]) -> Body {
        seen[first] = true;
        let mut way: HashMap<usize, bool> = HashMap::from([(first, true)]);
        let members = vec![Member { face: first, is_alike: true }];
        let mut body = Body { members, is_closed: true, is_orientable: true };
        let mut at = 0;
        while let Some(Member { face, is_alike }) = body.members.get(at).copied() {
            at += 1;
            for ring in &self.list[face].rings {
                for [a, b] in sides(ring).filter(|[a, b]| a != b) {
                    let along = self.along.get(&[a.min(b), a.max(b)]).map_or(&[][..], Vec::as_slice);
                    let other = match along {
                        [one, other] if one.face == face && other.face != face => *other,
                        [other, one] if one.face == face && other.face != face => *other,
                        _ => {
                            body.is_closed = false;
                            continue;
                        }
                    };
                    // Faces of one orientation run along their common side in opposite directions.
                    let is_same = other.is_forward != (a < b);
                    let wanted = is_alike == is_same;
                    match way.get(&other.face) {
                        Some(known) => body.is_orientable &= *known == wanted,
                        None => {
                            way.insert(other.face, wanted);
                            seen[other.face] = true;
                            body.members.push(Member { face: other.face, is_alike: wanted });
                        }
                    }
                }
            }
        }
        body.members.sort_unstable();
        body
    }

    /// The faces of the orientation with less area, of the two that the faces of a body have; of equal areas,
    /// the faces against the first one. Empty if all faces have one orientation, or if the body has none.
    fn minority(&self, body: &Body) -> (BTreeSet<usize>, TurnReason) {
        let [mut along, mut against] = [(BTreeSet::new(), 0.0), (BTreeSet::new(), 0.0)];
        for Member { face, is_alike } in &body.members {
            let part = if *is_alike { &mut along } else { &mut against };
            part.0.insert(*face);
            part.1 += self.list[*face].area();
        }
        if !body.is_orientable || along.0.is_empty() || against.0.is_empty() {
            return (BTreeSet::new(), TurnReason::Neighbours);
        }
        let is_tie = (along.1 - against.1).abs() <= ROUNDING_OF_AREAS * (along.1 + against.1);
        match along.1 < against.1 && !is_tie {
            true => (along.0, TurnReason::Neighbours),
            false => (against.0, if is_tie { TurnReason::Halves } else { TurnReason::Neighbours }),
        }
    }

    /// A closed body's faces with the orientation of most of them.
    fn shell(&self, body: &Body, minority: &BTreeSet<usize>) -> ClosedShell {
        let mut rings = Vec::new();
        for Member { face, .. } in &body.members {
            let is_turned = minority.contains(face);
            let ring = |points: &Vec<DVec3>| ShellRing { points: points.clone(), is_turned };
            rings.extend(self.list[*face].points.iter().map(ring));
        }
        let surfaces = body.members.iter().map(|own| self.list[own.face].surface).collect();
        let bounds = Aabb::around(rings.iter().flat_map(|ring| ring.points.iter().copied()));
        ClosedShell { rings, surfaces, bounds }
    }
}

/// The rings of a polygon with holes, these running against the outline.
fn against(outline: &[DVec3], holes: &[Vec<DVec3>]) -> Vec<Vec<DVec3>> {
    let front = area_vector(outline);
    let hole = |hole: &Vec<DVec3>| {
        let is_along = area_vector(hole).dot(front) > 0.0;
        if is_along { hole.iter().rev().copied().collect() } else { hole.clone() }
    };
    std::iter::once(outline.to_vec()).chain(holes.iter().map(hole)).collect()
}

/// Faces that hang together.
struct Body {
    members: Vec<Member>,
    is_closed: bool,
    is_orientable: bool,
}

/// A face of a body.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Member {
    face: usize,
    /// Whether it is oriented as the first one.
    is_alike: bool,
}

/// A closed surface of flat faces.
struct ClosedShell {
    rings: Vec<ShellRing>,
    surfaces: BTreeSet<usize>,
    bounds: Aabb,
}

/// A ring of a face of a shell.
struct ShellRing {
    points: Vec<DVec3>,
    /// Whether the face has to be turned over first.
    is_turned: bool,
}

impl ClosedShell {
    /// Reason for which all fronts of the shell seem to point the wrong way, if there is one.
    fn fault(&self, model: &Model, middles: &Middles) -> Option<TurnReason> {
        let is_outward = self.volume() > 0.0;
        let others = model.surfaces.len() - self.surfaces.len();
        let near = middles.within(&self.bounds, &self.surfaces);
        let is_inside = |x: DVec3| self.winding(x).abs() > 0.5;
        let has_eye = || model.camera.is_some_and(|camera| is_inside(camera.eye));
        let is_occupied = || has_eye() || near.iter().take(ASKED).any(|x| is_inside(*x));
        if is_outward {
            // Everything else is inside.
            let is_room =
                others > 0 && near.len() == others && near.iter().take(ASKED).all(|x| is_inside(*x));
            return is_room.then_some(TurnReason::Outwards);
        }
        let is_empty = near.len() < others
            && !self.surfaces.iter().any(|surface| model.emits(*surface))
            && !is_occupied();
        is_empty.then_some(TurnReason::Inwards)
    }

    /// Six times the volume, positive if the fronts point outwards.
    fn volume(&self) -> f64 {
        let origin = self.bounds.center();
        self.triangles(origin).map(|[a, b, c]| a.dot(b.cross(c))).sum()
    }

    /// Winding number of the shell about a point (Van Oosterom and Strackee, *The solid angle of a plane
    /// triangle*, 1983).
    fn winding(&self, x: DVec3) -> f64 {
        let angle = |[a, b, c]: [DVec3; 3]| {
            let [p, q, r] = [a, b, c].map(DVec3::length);
            let below = p * q * r + a.dot(b) * r + a.dot(c) * q + b.dot(c) * p;
            2.0 * a.dot(b.cross(c)).atan2(below)
        };
        self.triangles(x).map(angle).sum::<f64>() / (4.0 * std::f64::consts::PI)
    }

    /// Triangles from the first corner of each ring, seen from a point.
    fn triangles(&self, origin: DVec3) -> impl Iterator<Item = [DVec3; 3]> {
        self.rings.iter().flat_map(move |ShellRing { points: ring, is_turned }| {
            ring.windows(2).skip(1).map(move |side| {
                let [a, b, c] = [ring[0], side[0], side[1]].map(|x| x - origin);
                if *is_turned { [a, c, b] } else { [a, b, c] }
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Material, Surface};

    /// The faces of a cube, their fronts outwards.
    fn cube(low: DVec3, size: f64) -> Vec<Shape> {
        let [x, y, z] = [size * DVec3::X, size * DVec3::Y, size * DVec3::Z];
        let face = |at: DVec3, a: DVec3, b: DVec3| Shape::Polygon {
            outline: vec![at, at + a, at + a + b, at + b],
            holes: Vec::new(),
        };
        vec![
            face(low, y, x),
            face(low + z, x, y),
            face(low, x, z),
            face(low + y, z, x),
            face(low, z, y),
            face(low + x, y, z),
        ]
    }

    fn over(mut shapes: Vec<Shape>) -> Vec<Shape> {
        shapes.iter_mut().for_each(Shape::turn_over);
        shapes
    }

    fn model(shapes: Vec<Shape>) -> Model {
        let surface = |(k, shape): (usize, Shape)| Surface {
            name: format!("face-{k}"),
            material: None,
            shape,
            sides: Sides::Front,
            file: None,
            place: None,
        };
        Model { surfaces: shapes.into_iter().enumerate().map(surface).collect(), ..Model::default() }
    }

    fn room() -> Vec<Shape> {
        over(cube(DVec3::ZERO, 10.0))
    }

    #[test]
    fn a_room_with_boxes_is_sound_and_so_is_an_empty_one() {
        assert!(turned(&model(room())).is_empty());
        assert!(turned(&model(cube(DVec3::ZERO, 1.0))).is_empty());
        let boxes = [cube(DVec3::splat(2.0), 1.0), cube(DVec3::splat(6.0), 1.0)].concat();
        assert!(turned(&model([room(), boxes.clone()].concat())).is_empty());
        assert!(turned(&model(boxes)).is_empty());
    }

    #[test]
    fn a_box_inside_out_is_found() {
        let scene = model([room(), over(cube(DVec3::splat(2.0), 1.0))].concat());
        assert_eq!(
            turned(&scene),
            [TurnedFaces { why: TurnReason::Inwards, surfaces: (6..12).collect(), beside: 6 }]
        );
    }

    #[test]
    fn a_box_that_emits_inwards_or_holds_something_is_a_room() {
        let mut scene = model([room(), over(cube(DVec3::splat(2.0), 1.0))].concat());
        scene.materials.push(Material { name: "lamp".into(), reflectance: vec![0.0], emission: vec![1.0] });
        scene.surfaces[8].material = Some(0);
        assert!(turned(&scene).is_empty());
        let nested = [room(), over(cube(DVec3::splat(2.0), 3.0)), cube(DVec3::splat(3.0), 1.0)].concat();
        assert!(turned(&model(nested)).is_empty());
    }

    #[test]
    fn a_room_that_looks_outwards_is_found() {
        let scene = model([cube(DVec3::ZERO, 10.0), cube(DVec3::splat(2.0), 1.0)].concat());
        assert_eq!(
            turned(&scene),
            [TurnedFaces { why: TurnReason::Outwards, surfaces: (0..6).collect(), beside: 0 }]
        );
    }

    #[test]
    fn one_face_against_its_neighbours_is_found_also_where_the_body_is_open() {
        let mut shapes = [room(), cube(DVec3::splat(2.0), 1.0)].concat();
        shapes[7].turn_over();
        let found = turned(&model(shapes.clone()));
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].why, found[0].surfaces.as_slice()), (TurnReason::Neighbours, &[7][..]));
        shapes.remove(9);
        assert_eq!(turned(&model(shapes))[0].surfaces, [7]);
    }
}
