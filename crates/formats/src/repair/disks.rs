//! Disks and rings in the plane of other flat faces.
//!
//! `radiosity` sets apart polygons by itself, but not disks. A disk that shows its front to a larger face,
//! such as the foot of a glass on a shelf, gets no light and is removed; any other is raised off the larger
//! face, before its own front, by a gap that lets no light through. A polygon on a larger disk fares alike.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use glam::DVec3;
use radiosity_fit::sides::are_sides_of_one;
use radiosity_geom::layer_order;
use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Shape, Sides};
use crate::repair::edit::Edit;
use crate::repair::record::{RepairKind, Repairs};
use crate::repair::sheets::{Sheet, Sheets};
use crate::tolerances::RAISED;

/// Part of the area that polygons inscribed in circles may miss: those of 64 corners miss 0.16 %, and both a
/// disk and what it lies on may. With a larger value disks that stand out a little would count as within.
const MISSED: f64 = 1e-2;

/// Removes or raises disks that lie on other faces, and polygons that lie on disks.
pub(super) fn mend(model: &mut Model, repairs: &mut Repairs) {
    if !model.surfaces.iter().any(|surface| matches!(surface.shape, Shape::Disk { .. })) {
        return;
    }
    let sheets = Sheets::of(model);
    let StackedFaces { hidden, raised } = StackedFaces::of(model, &sheets);
    let mut edit = Edit::default();
    let mut say = |[sheet, on]: [usize; 2], what: &str| {
        let [surface, other] = [sheet, on].map(|index| &model.surfaces[sheets.list[index].surface]);
        let text = NoteText::default().naming(&surface.name).then(" lies on ").naming(&other.name).then(what);
        let names = vec![surface.name.clone(), other.name.clone()];
        repairs.say(RepairKind::Overlap, names, Some(surface), text);
    };
    for (sheet, on) in &hidden {
        say([*sheet, *on], " face down; it was removed");
        edit.replace(sheets.list[*sheet].surface, Vec::new());
    }
    for (sheet, on) in &raised {
        say([*sheet, on[0]], "; it was raised slightly");
    }
    for (index, by) in moves(&sheets, &raised, |surface| model.surfaces[surface].sides == Sides::Both) {
        let shape = &mut model.surfaces[index].shape;
        *shape = shape.map(|x| x + by, |vector| vector, |direction| direction, |length| length);
    }
    edit.apply(model, repairs);
}

/// Faces that lie on larger ones.
struct StackedFaces {
    /// Faces that no light reaches, each with a face that it lies on.
    hidden: BTreeMap<usize, usize>,
    /// All other faces, each with all faces that it lies on.
    raised: BTreeMap<usize, Vec<usize>>,
}

impl StackedFaces {
    fn of(model: &Model, sheets: &Sheets) -> Self {
        let (mut hidden, mut raised) = (BTreeMap::new(), BTreeMap::<usize, Vec<usize>>::new());
        for index in 0..sheets.list.len() {
            for other in sheets.later(index) {
                let [first, second] = [index, other].map(|index| &sheets.list[index]);
                let is_sheet = are_sides_of_one(
                    [first, second].map(|sheet| model.surfaces[sheet.surface].name.as_str()),
                );
                if is_sheet || !(first.is_round || second.is_round) {
                    continue;
                }
                let common = first.common_area(second);
                if common <= 0.0 {
                    continue;
                }
                let [sheet, on] = if order(second, first).is_lt() { [other, index] } else { [index, other] };
                let [small, large] = [sheet, on].map(|index| &sheets.list[index]);
                let is_within = common > (1.0 - MISSED) * small.area;
                match is_within && is_shown(model, small, large) {
                    true => drop(hidden.insert(sheet, on)),
                    false => raised.entry(sheet).or_default().push(on),
                }
            }
        }
        raised.retain(|sheet, on| {
            on.retain(|other| !hidden.contains_key(other));
            !on.is_empty() && !hidden.contains_key(sheet)
        });
        StackedFaces { hidden, raised }
    }
}

/// Whether the only front of a face, which emits nothing, is towards the front of a larger one.
fn is_shown(model: &Model, small: &Sheet, large: &Sheet) -> bool {
    let is_one_sided = |sheet: &Sheet| model.surfaces[sheet.surface].sides != Sides::Both;
    let is_dark = !model.emits(small.surface);
    is_dark && !small.is_alike(large) && is_one_sided(small) && is_one_sided(large)
}

/// Displacements of faces that lie on others, by the index of the surface (length): a face that lies on one
/// that moves moves along.
fn moves(
    sheets: &Sheets,
    raised: &BTreeMap<usize, Vec<usize>>,
    is_two_sided: impl Fn(usize) -> bool,
) -> Vec<(usize, DVec3)> {
    let mut indices: Vec<usize> = raised.keys().copied().collect();
    indices.sort_by(|a, b| order(&sheets.list[*b], &sheets.list[*a]));
    let mut by: BTreeMap<usize, DVec3> = BTreeMap::new();
    for index in indices {
        let sheet = &sheets.list[index];
        let mut largest = DVec3::ZERO;
        for on in &raised[&index] {
            let other = &sheets.list[*on];
            // What has two fronts lies before the front of the larger face.
            let up = if is_two_sided(sheet.surface) { other.normal() } else { sheet.normal() };
            let step = RAISED * sheet.extent * up + by.get(on).copied().unwrap_or(DVec3::ZERO);
            largest = if step.length() > largest.length() { step } else { largest };
        }
        by.insert(index, largest);
    }
    by.into_iter().map(|(index, by)| (sheets.list[index].surface, by)).collect()
}

/// Upper faces first; of equal ones the later.
fn order(a: &Sheet, b: &Sheet) -> Ordering {
    layer_order(b.area, a.area).then(b.surface.cmp(&a.surface))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Surface;

    fn disk(name: &str, radius: f64, up: f64) -> Surface {
        let shape = Shape::Disk { center: DVec3::ZERO, normal: up * DVec3::Z, radius, inner: 0.0 };
        Surface { name: name.into(), material: None, shape, sides: Sides::Front, file: None, place: None }
    }

    fn floor() -> Surface {
        let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let outline = vec![corner(-2.0, -2.0), corner(2.0, -2.0), corner(2.0, 2.0), corner(-2.0, 2.0)];
        let shape = Shape::Polygon { outline, holes: Vec::new() };
        Surface { name: "floor".into(), material: None, shape, sides: Sides::Front, file: None, place: None }
    }

    fn mended(surfaces: Vec<Surface>) -> (Vec<Surface>, Vec<String>) {
        let mut model = Model { surfaces, ..Model::default() };
        let mut repairs = Repairs::default();
        mend(&mut model, &mut repairs);
        (model.surfaces, repairs.list.into_iter().map(|repair| repair.text.to_string()).collect())
    }

    fn height(surface: &Surface) -> f64 {
        match surface.shape {
            Shape::Disk { center, .. } => center.z,
            _ => 0.0,
        }
    }

    #[test]
    fn a_foot_goes_and_a_plate_is_raised() {
        let (left, told) = mended(vec![floor(), disk("foot", 0.5, -1.0)]);
        assert_eq!(
            (left, told),
            (vec![floor()], vec![r#""foot" lies on "floor" face down; it was removed"#.into()])
        );
        let (left, told) = mended(vec![disk("plate", 0.5, 1.0), floor()]);
        assert!(height(&left[0]) > 0.0 && height(&left[0]) < 1e-6);
        assert_eq!(told, [r#""plate" lies on "floor"; it was raised slightly"#]);
    }

    #[test]
    fn plates_are_stacked_and_what_is_apart_stays() {
        let (left, _) = mended(vec![disk("plate", 0.5, 1.0), floor(), disk("cup", 0.1, 1.0)]);
        assert!(height(&left[2]) > height(&left[0]));
        let Surface { shape: Shape::Disk { normal, radius, inner, .. }, .. } = disk("", 0.5, 1.0) else {
            panic!()
        };
        let shape = Shape::Disk { center: DVec3::new(9.0, 0.0, 0.0), normal, radius, inner };
        let beside = vec![floor(), Surface { shape, ..disk("plate", 0.5, 1.0) }];
        assert_eq!(mended(beside.clone()), (beside, Vec::new()));
        // A disk that touches the border from outside.
        let shape = Shape::Disk { center: DVec3::new(2.5, 0.0, 0.0), normal, radius, inner };
        let beside = vec![floor(), Surface { shape, ..disk("plate", 0.5, 1.0) }];
        assert_eq!(mended(beside.clone()), (beside, Vec::new()));
    }
}
