//! The lines along which other planar surfaces stand on a planar surface.

use radiosity_geom::{Aabb, DVec3, PARALLEL_PLANES, PlanarRegion, distance_to_segment, sides, touching};
use radiosity_scene::Scene;

use super::segments::Segments;
use crate::Visibility;

/// A side of a surface that lies in the plane of another surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Start and end.
    pub(super) ends: [DVec3; 2],
    /// Index of the surface it belongs to.
    owner: usize,
}

/// The sides of other surfaces that lie on the face of `surface`; those along its own outline are left out.
pub(super) fn on(scene: &Scene, obstacles: &Visibility, surface: usize, region: &PlanarRegion) -> Vec<Line> {
    let bounds = Aabb::around(region.outer().iter().copied()).inflate(touching(region.extent(), 0.0));
    let own = Segments::new(outline(region));
    let mut found = Vec::new();
    for other in obstacles.near(&bounds).into_iter().filter(|other| *other != surface) {
        let Some(standing) = scene.surfaces[other].shape.region() else { continue };
        if standing.normal().cross(region.normal()).length() < PARALLEL_PLANES {
            continue;
        }
        let tolerance =
            touching(region.extent().min(standing.extent()), region.extent().max(standing.extent()));
        let in_plane = |x: &DVec3| region.height(*x).abs() <= tolerance;
        // Exactly in the plane: a part that is cut out along the lines must not rise above it.
        let onto_plane = |x: DVec3| x - region.height(x) * region.normal();
        let is_own = |line: &[DVec3; 2]| {
            let runs_along =
                |side: &usize| line.iter().all(|x| distance_to_segment(*x, own.list[*side]) <= tolerance);
            own.near(*line, tolerance).iter().any(runs_along)
        };
        let lines = outline(standing).into_iter().filter(|line| line.iter().all(in_plane) && !is_own(line));
        found.extend(lines.map(|ends| Line { ends: ends.map(onto_plane), owner: other }));
    }
    found
}

/// The sides of a region, those of its holes included.
pub(super) fn outline(region: &PlanarRegion) -> Vec<[DVec3; 2]> {
    let rings = std::iter::once(region.outer()).chain(region.holes().iter().map(Vec::as_slice));
    rings.flat_map(sides).collect()
}

/// The owners of the `lines`, whose ends are `ends`, that run along the sides of `face`, ascending.
pub(super) fn around(lines: &[Line], ends: &Segments, face: &PlanarRegion) -> Vec<usize> {
    let tolerance = 2.0 * touching(face.extent(), 0.0);
    let at = |x: DVec3| {
        let is_near = move |line: &usize| distance_to_segment(x, ends.list[*line]) <= tolerance;
        ends.near([x], tolerance).into_iter().filter(is_near)
    };
    let found = outline(face).into_iter().flat_map(|[a, b]| at(a.midpoint(b)));
    let mut owners: Vec<usize> = found.map(|line| lines[line].owner).collect();
    owners.sort_unstable();
    owners.dedup();
    owners
}
