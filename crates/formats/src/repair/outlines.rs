//! Outlines that touch or cross themselves, and holes that cross or leave them.
//!
//! The even–odd rule tells the inside: it finds the holes of bridged outlines whichever way they run, and it
//! is the rule by which the renderers of these formats test points. The front stays that of the outline's
//! net area.

use radiosity_fit::overlay::{Part, crosses_itself, enclosed, has_seam, without};
use radiosity_fit::plane::Plane;
use radiosity_geom::{PlanarRegion, ShapeError};
use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Shape};
use crate::repair::edit::{Edit, Told};
use crate::repair::record::{RepairKind, Repairs, counted};

/// Makes each outline that touches or crosses itself into outlines that do not, with holes.
pub(super) fn mend(model: &mut Model, asked: Option<f64>, repairs: &mut Repairs) {
    let mut edit = Edit::default();
    for (index, surface) in model.surfaces.iter().enumerate() {
        let Shape::Polygon { outline, holes } = &surface.shape else { continue };
        let Some((parts, cause)) = faulty(outline, holes, asked) else { continue };
        let count = parts.iter().map(|part| part.holes.len()).sum::<usize>();
        let text = move |name: &str, names: &[String]| {
            let text = NoteText::from("the outline of ").naming(name).then(" ").then(cause).then("; ");
            let text = match names {
                [] => text.then("it encloses no area and was removed"),
                [_] if count > 0 => {
                    text.then(format!("it was made an outline with {}", counted(count, "hole")))
                }
                [_] => text.then("it was led around what it encloses"),
                names => text.then("it was cut into ").naming_all(names),
            };
            let kind = if names.is_empty() { RepairKind::Sliver } else { RepairKind::Outline };
            (kind, text)
        };
        let shapes = parts.into_iter().map(shape).collect();
        edit.tell(index, shapes, Told { others: Vec::new(), text: Box::new(text) });
    }
    edit.apply(model, repairs);
}

fn shape(part: Part) -> Shape {
    Shape::Polygon { outline: part.outline, holes: part.holes }
}

/// The parts of a polygon whose rings touch or cross, and what they do; None if nothing is wrong with them.
fn faulty(
    outline: &[glam::DVec3],
    holes: &[Vec<glam::DVec3>],
    asked: Option<f64>,
) -> Option<(Vec<Part>, &'static str)> {
    let is_bent = match PlanarRegion::new(outline.to_vec(), holes.to_vec()) {
        Ok(_) => return None,
        // A quadrilateral off its plane becomes a bilinear patch.
        Err(ShapeError::NotPlanar { .. }) if outline.len() == 4 && holes.is_empty() => return None,
        Err(error) => matches!(error, ShapeError::NotPlanar { .. }),
    };
    let plane = Plane::of(outline)?;
    if is_bent {
        let level = |ring: &[glam::DVec3]| ring.iter().map(|x| plane.foot(*x)).collect::<Vec<_>>();
        let level = PlanarRegion::new(level(outline), holes.iter().map(|hole| level(hole)).collect());
        if level.is_ok() {
            return None;
        }
    }
    let own = enclosed(&plane, &[outline], asked);
    let cut: Vec<Part> = holes.iter().flat_map(|hole| enclosed(&plane, &[hole], asked)).collect();
    let is_simple =
        matches!(own.as_slice(), [part] if part.holes.is_empty() && part.outline.len() == outline.len());
    let cause = match () {
        () if is_simple && !holes.is_empty() => "and its holes overlap",
        () if has_seam(&plane, outline, asked) => "runs along a seam and back",
        () if crosses_itself(&plane, outline, &own) => "crosses itself",
        () => "touches itself",
    };
    let parts = if cut.is_empty() { own } else { without(&plane, &own, &cut, asked) };
    Some((parts, cause))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::model::{Sides, Surface};

    fn flat(points: &[[f64; 2]]) -> Vec<DVec3> {
        points.iter().map(|[x, y]| DVec3::new(*x, 0.5, *y)).collect()
    }

    fn mended(outline: Vec<DVec3>, holes: Vec<Vec<DVec3>>) -> (Vec<Part>, String) {
        let mut model = Model {
            surfaces: vec![Surface {
                name: "face".into(),
                material: None,
                shape: Shape::Polygon { outline, holes },
                sides: Sides::Front,
                file: None,
                place: None,
            }],
            ..Model::default()
        };
        let mut repairs = Repairs::default();
        mend(&mut model, None, &mut repairs);
        let text = repairs.list.iter().map(|repair| repair.text.as_str()).collect::<Vec<_>>().join("|");
        let part = |surface: Surface| match surface.shape {
            Shape::Polygon { outline, holes } => {
                PlanarRegion::new(outline.clone(), holes.clone()).expect("what was mended is sound");
                Part { outline, holes }
            }
            _ => unreachable!("polygons stay polygons"),
        };
        (model.surfaces.into_iter().map(part).collect(), text)
    }

    fn area(parts: &[Part]) -> f64 {
        let region =
            |part: &Part| PlanarRegion::new(part.outline.clone(), part.holes.clone()).unwrap().area();
        parts.iter().map(region).sum()
    }

    fn normal(part: &Part) -> DVec3 {
        PlanarRegion::new(part.outline.clone(), Vec::new()).unwrap().normal()
    }

    const FRAME: [[f64; 2]; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

    #[test]
    fn a_bridged_outline_gets_its_hole_whichever_way_it_runs() {
        let [a, b, c, d] = FRAME;
        for hole in [
            [[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0]],
            [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]],
        ] {
            let [p, q, r, s] = hole;
            let ring = flat(&[a, b, c, d, a, p, q, r, s, p]);
            let front = Plane::of(&flat(&FRAME)).unwrap().normal();
            let (parts, text) = mended(ring, vec![]);
            assert_eq!(
                text,
                r#"the outline of "face" runs along a seam and back; it was made an outline with 1 hole"#
            );
            assert!(parts.len() == 1 && parts[0].outline == flat(&FRAME) && area(&parts) == 15.0);
            assert!(hole.iter().all(|x| parts[0].holes[0].contains(&flat(&[*x])[0])));
            assert_eq!(normal(&parts[0]), front);
        }
    }

    #[test]
    fn two_holes_on_one_seam_and_two_seams_are_found() {
        let [a, b, c, d] = FRAME;
        let one = [[1.0, 1.0], [1.0, 1.5], [1.5, 1.5], [1.5, 1.0]];
        let two = [[2.0, 2.0], [2.0, 3.0], [3.0, 3.0], [3.0, 2.0]];
        let chain = [
            a, one[0], one[1], one[2], two[0], two[1], two[2], two[3], two[0], one[2], one[3], one[0], a, b,
            c, d,
        ];
        let (parts, _) = mended(flat(&chain), vec![]);
        assert!(parts.len() == 1 && parts[0].holes.len() == 2 && area(&parts) == 14.75);
        let seams = [
            a, one[0], one[1], one[2], one[3], one[0], a, b, c, two[2], two[3], two[0], two[1], two[2], c, d,
        ];
        let (parts, _) = mended(flat(&seams), vec![]);
        assert!(parts.len() == 1 && parts[0].holes.len() == 2 && area(&parts) == 14.75);
    }

    #[test]
    fn an_outline_that_touches_itself_in_a_vertex_gets_a_hole_or_falls_in_two() {
        let [a, b, c, d] = FRAME;
        let (parts, text) = mended(flat(&[a, [1.0, 2.0], [2.0, 1.0], a, b, c, d]), vec![]);
        assert_eq!(text, r#"the outline of "face" touches itself; it was made an outline with 1 hole"#);
        assert!(parts.len() == 1 && parts[0].holes.len() == 1 && (area(&parts) - 14.5).abs() < 1e-12);
        let eight =
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0], [1.0, 1.0], [0.0, 1.0]];
        let (parts, text) = mended(flat(&eight), vec![]);
        assert_eq!(text, r#"the outline of "face" touches itself; it was cut into "face-1" and "face-2""#);
        assert!(parts.len() == 2 && area(&parts) == 2.0);
    }

    #[test]
    fn a_bow_tie_becomes_two_triangles_with_the_front_of_its_net_area() {
        let tie = [[0.0, 0.0], [3.0, 3.0], [3.0, 0.0], [0.0, 2.0]];
        let (parts, text) = mended(flat(&tie), vec![]);
        assert_eq!(text, r#"the outline of "face" crosses itself; it was cut into "face-1" and "face-2""#);
        let net = radiosity_geom::area_vector(&flat(&tie));
        assert!(parts.len() == 2 && parts.iter().all(|part| normal(part).dot(net) > 0.0));
        // Corners of both triangles are those that were given, and the crossing at 1.2.
        let corners: Vec<DVec3> = parts.iter().flat_map(|part| part.outline.clone()).collect();
        assert!(tie.iter().all(|x| corners.contains(&flat(&[*x])[0])));
        assert!((area(&parts) - (0.5 * 2.0 * 1.2 + 0.5 * 3.0 * 1.8)).abs() < 1e-11);
    }

    #[test]
    fn holes_that_overlap_or_leave_the_outline_are_cut_out_together() {
        let hole = |low: f64, high: f64| flat(&[[low, low], [high, low], [high, high], [low, high]]);
        let (parts, text) = mended(flat(&FRAME), vec![hole(1.0, 2.0), hole(1.5, 3.0)]);
        assert!(text.contains("and its holes overlap"), "{text}");
        assert!(parts.len() == 1 && (area(&parts) - (16.0 - 1.0 - 2.25 + 0.25)).abs() < 1e-11);
        let (parts, _) = mended(flat(&FRAME), vec![hole(3.0, 5.0)]);
        assert!(parts.len() == 1 && (area(&parts) - 15.0).abs() < 1e-11);
        let (parts, text) = mended(flat(&FRAME), vec![hole(-1.0, 5.0)]);
        assert!(parts.is_empty() && text.ends_with("it encloses no area and was removed"), "{text}");
    }

    #[test]
    fn holes_that_touch_are_sound() {
        let hole = |low: f64, high: f64| flat(&[[low, low], [high, low], [high, high], [low, high]]);
        assert!(mended(flat(&FRAME), vec![hole(0.0, 1.0), hole(1.0, 2.0)]).1.is_empty());
    }
}
