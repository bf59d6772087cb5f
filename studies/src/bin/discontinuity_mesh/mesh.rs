//! Scenes whose flat receivers are cut along critical lines, and further into pieces of a length.

use std::sync::Arc;

use radiosity::Scene;
use radiosity::scene::SceneSurface;
use radiosity_geom::shapes::Polygon;
use radiosity_geom::{Aabb, DVec3, Plane, clip_polygon, difference, polygon_width, sides};

use crate::critical::{Body, lines};

/// Breadth of the thinnest piece, in parts of the size of the scene: a line that would cut off less is left
/// out, and misses the light of a strip as thin.
const THINNEST: f64 = 1e-3;

/// The scene with its flat receivers in pieces no longer than `length` (scene length), cut along the critical
/// lines of the lamps and of the occluders, each made up of the surfaces whose names start so.
pub(crate) fn meshed(scene: &Scene, occluders: &[&str], length: f64) -> Scene {
    let knife = Knife::new(scene, occluders, length);
    let mut cut = scene.clone();
    for (index, own) in scene.surfaces.iter().enumerate() {
        if own.exitance(0) > 0.0 || own.other_side.is_some() {
            continue;
        }
        for (k, piece) in knife.pieces(own).into_iter().enumerate() {
            let mut surface = own.clone();
            surface.name = format!("{}/{k}", own.name);
            surface.shape = Arc::new(Polygon::new(piece, Vec::new()).expect("a piece has area"));
            // The first piece stands where the surface stood: others keep their indices.
            match k {
                0 => cut.surfaces[index] = surface,
                _ => cut.surfaces.push(surface),
            }
        }
    }
    cut
}

/// Lamps and occluders, along whose critical lines surfaces are cut.
struct Knife<'a> {
    lamps: Vec<Body>,
    /// Occluders, with the start of the names of their surfaces.
    occluders: Vec<(&'a str, Body)>,
    length: f64,
    thinnest: f64,
}

impl<'a> Knife<'a> {
    fn new(scene: &Scene, occluders: &[&'a str], length: f64) -> Self {
        let lamps = scene.surfaces.iter().filter(|own| own.exitance(0) > 0.0);
        let occluder = |start: &&'a str| {
            let faces = scene.surfaces.iter().filter(|own| own.name.starts_with(start)).filter_map(outline);
            (*start, Body::of_faces(&faces.collect::<Vec<_>>()))
        };
        let size = Aabb::around(scene.surfaces.iter().flat_map(|own| own.shape.corners())).diagonal();
        Self {
            lamps: lamps.filter_map(|own| Some(Body::of_faces(&[outline(own)?]))).collect(),
            occluders: occluders.iter().map(occluder).collect(),
            length,
            thinnest: THINNEST * size,
        }
    }

    /// The pieces of a surface; none of one that is not flat.
    fn pieces(&self, surface: &SceneSurface) -> Vec<Vec<DVec3>> {
        let Some(corners) = outline(surface) else { return Vec::new() };
        let plane = Plane { point: corners[0], normal: surface.shape.jet(0.0, 0.0).normal };
        let others = self.occluders.iter().filter(|(start, _)| !surface.name.starts_with(start));
        let shadows =
            others.flat_map(|(_, body)| self.lamps.iter().flat_map(|lamp| lines(lamp, body, plane)));
        let mut shadows: Vec<[DVec3; 2]> = shadows.collect();
        // Long lines first: they make fewer pieces.
        shadows.sort_by(|[a, b], [c, d]| c.distance(*d).total_cmp(&a.distance(*b)));
        let pieces = shadows.into_iter().fold(whole(surface, corners, plane.normal), |pieces, line| {
            pieces.into_iter().flat_map(|piece| parted(piece, line, plane, self.thinnest)).collect()
        });
        pieces.into_iter().flat_map(|piece| halved(piece, self.length)).collect()
    }
}

/// The outline of a flat surface.
fn outline(surface: &SceneSurface) -> Option<Vec<DVec3>> {
    Some(surface.shape.region()?.outer().to_vec())
}

/// A surface without its holes, as convex pieces.
fn whole(surface: &SceneSurface, outline: Vec<DVec3>, normal: DVec3) -> Vec<Vec<DVec3>> {
    let holes = surface.shape.region().map_or(&[][..], |region| region.holes());
    holes.iter().fold(vec![outline], |pieces, hole| {
        // Holes run clockwise.
        let hole: Vec<DVec3> = hole.iter().rev().copied().collect();
        pieces.iter().flat_map(|piece| difference(piece, &hole, normal)).collect()
    })
}

/// The two parts of a convex piece that a line passes through; the piece where it passes by, or would cut
/// off a part thinner than `thinnest`.
fn parted(piece: Vec<DVec3>, [from, to]: [DVec3; 2], plane: Plane, thinnest: f64) -> Vec<Vec<DVec3>> {
    let across = plane.normal.cross(to - from);
    let parts = [across, -across].map(|side| clip_polygon(&piece, from, side));
    let are_broad = parts.iter().all(|part| part.len() > 2 && polygon_width(part) > thinnest);
    if are_broad && meets(&piece, [from, to], plane.normal, thinnest) { parts.into() } else { vec![piece] }
}

/// Whether a line is longer than `least` within a convex piece.
fn meets(piece: &[DVec3], [from, to]: [DVec3; 2], normal: DVec3, least: f64) -> bool {
    let (mut start, mut end) = (0.0f64, 1.0f64);
    for [corner, next] in sides(piece) {
        let inward = normal.cross(next - corner);
        let [at, then] = [from, to].map(|x| (x - corner).dot(inward));
        match (at >= 0.0, then >= 0.0) {
            (true, true) => {}
            (false, false) => return false,
            (false, true) => start = start.max(at / (at - then)),
            (true, false) => end = end.min(at / (at - then)),
        }
    }
    (end - start) * from.distance(to) > least
}

/// A convex piece, halved across its longest side until it is no longer than `length` along that.
fn halved(piece: Vec<DVec3>, length: f64) -> Vec<Vec<DVec3>> {
    let longest = sides(&piece).max_by(|[a, b], [c, d]| a.distance(*b).total_cmp(&c.distance(*d)));
    let Some(along) = longest.and_then(|[a, b]| (b - a).try_normalize()) else { return Vec::new() };
    let ends = piece.iter().map(|x| (*x - piece[0]).dot(along));
    let [low, high] = ends.fold([0.0f64; 2], |[low, high], x| [low.min(x), high.max(x)]);
    if high - low <= length {
        return vec![piece];
    }
    let middle = piece[0] + 0.5 * (low + high) * along;
    let parts = [along, -along].map(|side| clip_polygon(&piece, middle, side));
    parts.into_iter().flat_map(|part| halved(part, length)).collect()
}
