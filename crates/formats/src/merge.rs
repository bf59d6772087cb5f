//! Coplanar faces that share sides become polygons with holes: the triangles of a wall become the wall.
//!
//! Faces are merged that belong to one object, have one material and the same sides, meet along whole sides,
//! and lie in a plane:
//!
//! 1. corners that differ by the rounding of their coordinates are one (`corners`);
//! 2. faces grow together over common sides, the largest first, as long as they lie in the first one's plane
//!    (`growth`), so that curvature does not creep in;
//! 3. sides that only one face of a group has are its boundary, traced into simple loops (`boundary`);
//! 4. a group stays as it was if its loops cross or touch but at corners (`crossings`), if not exactly one of
//!    them is an outline, or if the area changes: so every point is covered once;
//! 5. corners in the middle of a straight side are dropped where no other surface has a corner (`straight`).
//!
//! The time is that of sorting.

mod corners;
mod face;
mod growth;
mod crossings;
mod boundary;
mod straight;

use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Shape};
use boundary::Merged;
use corners::Corners;
use face::Face;
use straight::straighten;

/// Merges coplanar faces of each object; `objects` names the object of each surface and is kept in step. A
/// merged surface has the name and the place of its first face.
pub fn coplanar(model: &mut Model, objects: &mut Vec<usize>) {
    let corners = Corners::welded(&model.surfaces, objects);
    let faces = Face::all(&model.surfaces, objects, &corners);
    let groups = growth::groups(&faces, &corners);
    let mut merged: Vec<Merged> =
        groups.iter().filter_map(|group| Merged::of(group, &faces, &corners)).collect();
    if merged.is_empty() {
        return;
    }
    straighten(&mut merged, &corners, model.surfaces.len());
    note(model, &merged);
    replace(model, objects, &merged, &corners);
}

/// Says how many faces became how many polygons.
fn note(model: &mut Model, merged: &[Merged]) {
    let parts: usize = merged.iter().map(|merged| merged.surfaces.len()).sum();
    let is_triangle = |surface: &usize| match &model.surfaces[*surface].shape {
        Shape::Polygon { outline, .. } => outline.len() == 3,
        _ => false,
    };
    let are_triangles = merged.iter().flat_map(|merged| &merged.surfaces).all(is_triangle);
    let what = if are_triangles { "triangles" } else { "faces" };
    let polygons = if merged.len() == 1 { "polygon" } else { "polygons" };
    let text = format!("{parts} coplanar {what} were merged to {} {polygons}", merged.len());
    model.note(NoteText::own(text), None);
}

/// Puts the polygons in the places of their first faces and takes the other faces out. Corners stay as they
/// were given.
fn replace(model: &mut Model, objects: &mut Vec<usize>, merged: &[Merged], corners: &Corners) {
    let mut is_kept = vec![true; model.surfaces.len()];
    for group in merged {
        let mut surfaces = group.surfaces.iter().copied();
        let Some(first) = surfaces.next() else { continue };
        let given = corners.given(&group.surfaces);
        let points = |ring: &Vec<u32>| ring.iter().map(|corner| given[corner]).collect::<Vec<_>>();
        let [outline, holes] =
            [&group.loops[..1], &group.loops[1..]].map(|rings| rings.iter().map(points).collect::<Vec<_>>());
        model.surfaces[first].shape =
            Shape::Polygon { outline: outline.into_iter().next().unwrap_or_default(), holes };
        surfaces.for_each(|surface| is_kept[surface] = false);
    }
    let mut kept = is_kept.iter();
    objects.retain(|_| kept.next().copied().unwrap_or(true));
    let mut kept = is_kept.iter();
    model.surfaces.retain(|_| kept.next().copied().unwrap_or(true));
}
