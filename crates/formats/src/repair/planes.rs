//! Polygons whose vertices lie in no common plane: four that turn one way become a bilinear patch, others
//! triangles.

use std::collections::HashMap;

use glam::DVec3;
use radiosity_fit::outline::is_warped;
use radiosity_fit::plane::Plane;
use radiosity_geom::{PlanarRegion, ShapeError};
use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Shape};
use crate::repair::edit::{Edit, Told};
use crate::repair::record::{RepairKind, Repairs, counted};

/// Makes polygons off their planes into patches and triangles.
pub(super) fn mend(model: &mut Model, repairs: &mut Repairs) {
    let mut edit = Edit::default();
    for (index, surface) in model.surfaces.iter().enumerate() {
        let Shape::Polygon { outline, holes } = &surface.shape else { continue };
        let judged = PlanarRegion::new(outline.clone(), holes.clone());
        let Err(ShapeError::NotPlanar { deviation, .. }) = judged else { continue };
        let shapes = match <[DVec3; 4]>::try_from(outline.as_slice()) {
            Ok(corners) if holes.is_empty() && is_warped(&corners) => vec![Shape::Quad(corners)],
            _ => triangles(outline, holes),
        };
        let text = move |name: &str, names: &[String]| {
            let text =
                NoteText::default().naming(name).then(format!(" is off its plane by {deviation:.1e}; "));
            let text = match names {
                [_] => text.then("it was made a bilinear patch"),
                names => {
                    let count = counted(names.len(), "triangle");
                    text.then(format!("it was cut into {count}, ")).naming_all(names)
                }
            };
            (RepairKind::Plane, text)
        };
        if !shapes.is_empty() {
            edit.tell(index, shapes, Told { others: Vec::new(), text: Box::new(text) });
        }
    }
    edit.apply(model, repairs);
}

/// The triangles between the vertices, as they are seen along the mean normal; none if they cross there.
fn triangles(outline: &[DVec3], holes: &[Vec<DVec3>]) -> Vec<Shape> {
    let Some(plane) = Plane::of(outline) else { return Vec::new() };
    let mut given: HashMap<[u64; 3], DVec3> = HashMap::new();
    let mut level = |ring: &[DVec3]| -> Vec<DVec3> {
        ring.iter()
            .map(|x| {
                let foot = plane.foot(*x);
                given.insert(bits(foot), *x);
                foot
            })
            .collect()
    };
    let (level_outline, level_holes) = (level(outline), holes.iter().map(|hole| level(hole)).collect());
    let Ok(region) = PlanarRegion::new(level_outline, level_holes) else { return Vec::new() };
    let triangle = |corners: [DVec3; 3]| {
        let outline = corners.map(|x| given.get(&bits(x)).copied().unwrap_or(x)).to_vec();
        Shape::Polygon { outline, holes: Vec::new() }
    };
    region.convex_pieces().iter().flat_map(|piece| fan(piece)).map(triangle).collect()
}

/// The triangles of a convex polygon from its first corner.
fn fan(piece: &[DVec3]) -> impl Iterator<Item = [DVec3; 3]> {
    piece.windows(2).skip(1).map(|side| [piece[0], side[0], side[1]])
}

fn bits(x: DVec3) -> [u64; 3] {
    x.to_array().map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use radiosity_geom::area_vector;

    use super::*;
    use crate::model::{Sides, Surface};

    fn mended(outline: Vec<DVec3>, holes: Vec<Vec<DVec3>>) -> (Vec<Shape>, Repairs) {
        let surface = Surface {
            name: "roof".into(),
            material: None,
            shape: Shape::Polygon { outline, holes },
            sides: Sides::Front,
            file: None,
            place: None,
        };
        let mut model = Model { surfaces: vec![surface], ..Model::default() };
        let mut repairs = Repairs::default();
        mend(&mut model, &mut repairs);
        (model.surfaces.into_iter().map(|surface| surface.shape).collect(), repairs)
    }

    fn ring(points: &[[f64; 3]]) -> Vec<DVec3> {
        points.iter().map(|x| DVec3::from_array(*x)).collect()
    }

    #[test]
    fn a_quadrilateral_becomes_a_patch_with_its_own_corners() {
        let corners = ring(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.01], [0.0, 1.0, 0.0]]);
        let (shapes, repairs) = mended(corners.clone(), vec![]);
        assert_eq!(shapes, [Shape::Quad([corners[0], corners[1], corners[2], corners[3]])]);
        assert!(repairs.list[0].text.starts_with(r#""roof" is off its plane by "#), "{repairs:?}");
    }

    #[test]
    fn what_is_flat_but_for_decimals_stays() {
        let corners = ring(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1e-5], [0.0, 1.0, 0.0]]);
        assert!(mended(corners, vec![]).1.is_empty());
    }

    #[test]
    fn a_bent_pentagon_with_a_hole_becomes_triangles_between_its_vertices() {
        let outline =
            ring(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.1], [4.0, 4.0, 0.0], [2.0, 5.0, 0.3], [0.0, 4.0, 0.0]]);
        let hole = ring(&[[1.0, 1.0, 0.0], [2.0, 1.0, 0.1], [1.0, 2.0, 0.0]]);
        let (shapes, _) = mended(outline.clone(), vec![hole.clone()]);
        let mut sum = DVec3::ZERO;
        for shape in &shapes {
            let Shape::Polygon { outline: own, holes } = shape else { panic!("triangles are polygons") };
            assert!(own.len() == 3 && holes.is_empty());
            assert!(own.iter().all(|x| outline.contains(x) || hole.contains(x)));
            sum += area_vector(own);
        }
        // Seen from above: 4 × 4 and a gable of 2, less the hole of ½.
        assert!((sum.z - 17.5).abs() < 1e-9, "{sum}");
    }
}
