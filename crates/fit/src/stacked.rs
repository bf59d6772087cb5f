//! Flat sheets that lie in one plane and share some area of it, such as a body on a floor or a picture on a
//! wall.
//!
//! The sign of the gap between two such sheets is lost, and with it what each of them sees. It is restored as
//! follows. A face that shares its border with others is on their side: the bottom of a box on a floor
//! belongs up to the box, the wall of a room beside another room to its own room. A sheet by itself lies on
//! the front of a larger one, as a picture on a wall. Otherwise the gap as typed decides, if it is more than
//! rounding; if nothing decides, the scene is refused. The smaller sheet is moved off the larger by a small
//! gap for which the rules of transport hold: a face on a floor exchanges light with the floor alone, as it
//! does in the limit of no gap.

mod sheet;

use std::cmp::Ordering;
use std::collections::HashMap;
use std::sync::Arc;

use radiosity_geom::{Aabb, Bvh, DVec3, SAME_AREA, touching};

use crate::bodies::{self, Beside};
use crate::{coincident::Occupied, gap};

pub use sheet::Sheet;

use crate::sides::are_sides_of_one;

/// Distance by which a sheet is moved off another, in multiples of the least gap: half as much again, so that
/// rounding of the moved corners leaves the gap above the least. Larger gaps would let more light past.
const OFF: f64 = 1.5;

/// A sheet that lies on another one, both by index, and how it has to be moved off it.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The sheet that is moved.
    pub sheet: usize,
    /// The sheet that it lies on.
    pub on: usize,
    /// The step (scene length).
    pub by: DVec3,
    /// Whether both are taken for the skins of one shell, back to back, though they were typed face to face.
    pub is_turned: bool,
}

/// The moves of all sheets that lie on others, by index; sheets for which nothing decides have none.
pub fn steps(sheets: &[Sheet]) -> Vec<Step> {
    let mut steps: HashMap<usize, Step> = HashMap::new();
    for Layer { sheet, lower } in layers(sheets) {
        for Support { sheet: on, direction, is_turned } in lower {
            // A sheet on another one moves along with it.
            let off = OFF * gap::least(sheets[sheet].extent(), sheets[on].extent());
            let by = off * direction + steps.get(&on).map_or(DVec3::ZERO, |step| step.by);
            let step = Step { sheet, on, by, is_turned };
            let known = steps.entry(sheet).or_insert(step);
            if by.length_squared() > known.by.length_squared() {
                *known = step;
            }
        }
    }
    let mut steps: Vec<Step> = steps.into_values().collect();
    steps.sort_unstable_by_key(|step| step.sheet);
    steps
}

/// Moves sheets that lie on others off them, and returns the moves.
pub fn set_apart(sheets: &mut [Sheet]) -> Vec<Step> {
    let steps = steps(sheets);
    for Step { sheet, by, .. } in &steps {
        if let Some(Ok(moved)) = sheets[*sheet].shape.with_corners(&|x| x + *by) {
            sheets[*sheet].shape = Arc::from(moved);
        }
    }
    steps
}

/// A sheet that lies on others.
struct Layer {
    /// Its index.
    sheet: usize,
    /// The sheets that it lies on.
    lower: Vec<Support>,
}

/// A sheet that another one lies on.
struct Support {
    /// Its index.
    sheet: usize,
    /// Unit vector from it towards the other one.
    direction: DVec3,
    /// Whether both are taken for the skins of one shell though they were typed face to face.
    is_turned: bool,
}

/// The sheets that lie on others, lower ones first.
fn layers(sheets: &[Sheet]) -> Vec<Layer> {
    let occupied: Vec<Occupied> = sheets.iter().map(|sheet| Occupied::new(&sheet.shape)).collect();
    let boxes: Vec<Aabb> = occupied.iter().map(|occupied| *occupied.bounds()).collect();
    let tree = Bvh::build(&boxes);
    let mut lower: HashMap<usize, Vec<Support>> = HashMap::new();
    // Heights are kept: that of a floor is asked for with each body on it.
    let mut bodies: HashMap<usize, f64> = HashMap::new();
    for own in 0..sheets.len() {
        for other in tree.search(|near| near.overlaps(&boxes[own])).filter(|other| *other < own) {
            let is_pair = are_sides_of_one([&sheets[own].name, &sheets[other].name]);
            let stays = sheets[own].stays && sheets[other].stays;
            if is_pair || stays || !occupied[own].coincides(&occupied[other]) {
                continue;
            }
            let (sheet, on) = match sheets[own].order(&sheets[other]) {
                Ordering::Greater => (own, other),
                Ordering::Less => (other, own),
                Ordering::Equal => continue,
            };
            let up = sheets[on].normal();
            let mut height = |index: usize| {
                let way = sheets[index].region().map_or(0.0, |region| region.normal().dot(up).signum());
                way * *bodies.entry(index).or_insert_with(|| body(index, sheets, &tree, &boxes[index]))
            };
            let pair = Pair { sheet: &sheets[sheet], on: &sheets[on], bodies: [sheet, on].map(&mut height) };
            if let Some(direction) = pair.direction(&occupied[sheet], &occupied[on]) {
                let is_turned = pair.is_turned(direction);
                // Where the smaller one stays, the larger one goes the other way.
                let (sheet, on, direction) =
                    if sheets[sheet].stays { (on, sheet, -direction) } else { (sheet, on, direction) };
                lower.entry(sheet).or_default().push(Support { sheet: on, direction, is_turned });
            }
        }
    }
    let mut layers: Vec<Layer> = lower.into_iter().map(|(sheet, lower)| Layer { sheet, lower }).collect();
    layers.sort_by(|a, b| sheets[a.sheet].order(&sheets[b.sheet]).then(a.sheet.cmp(&b.sheet)));
    layers
}

/// A sheet and the larger one that it lies on.
struct Pair<'a> {
    sheet: &'a Sheet,
    on: &'a Sheet,
    /// Heights, over the front of the larger sheet, of what shares its border with either; 0 without such
    /// surfaces.
    bodies: [f64; 2],
}

impl Pair<'_> {
    /// The unit vector from the larger sheet towards the smaller one; None if nothing decides.
    fn direction(&self, own: &Occupied, other: &Occupied) -> Option<DVec3> {
        let (up, normal) = (self.on.normal(), self.sheet.normal());
        let common = own.common_area(other);
        let is_within = common > (1.0 - SAME_AREA) * self.sheet.area();
        let is_copy = is_within && common > (1.0 - SAME_AREA) * self.on.area();
        let is_alike = normal.dot(up) > 0.0;
        if is_copy && self.bodies[0] * self.bodies[1] > 0.0 {
            // The inner and the outer skin of one shell, back to back.
            return (!is_alike).then_some(-up);
        }
        // A face with its body behind it stands on a sheet with its body in front (box on tile), and on loose
        // tiles.
        let stands_on = self.bodies[1] < 0.0 && self.bodies[0] * normal.dot(up) >= 0.0;
        let is_tile = self.bodies[0] == 0.0 && is_within && !self.sheet.two_sided;
        if !is_alike && stands_on && (is_tile || self.bodies[0] != 0.0 && !is_within) {
            return Some(up);
        }
        if self.bodies[0] != 0.0 {
            return Some(self.bodies[0].signum() * up);
        }
        let by_sign = |least: f64| {
            let height = self.sheet.typed_height(self.on);
            (height.abs() > least).then(|| height.signum() * up)
        };
        let rounding = touching(0.0, self.reach());
        match (self.sheet.two_sided, self.on.two_sided) {
            // Two plates in one plane: either may be in front, but typing one twice is a mistake.
            (true, true) if self.is_typed_twice() => None,
            (true, true) => by_sign(0.0).or((!is_copy).then_some(up)),
            _ if is_copy => by_sign(rounding),
            (true, false) => Some(up),
            (false, false) if is_within && is_alike => Some(up),
            (false, true) if is_within => by_sign(rounding).or(Some(normal)),
            (false, _) => by_sign(rounding),
        }
    }

    /// Whether the skins of a shell, set apart back to back along `direction`, were typed face to face.
    fn is_turned(&self, direction: DVec3) -> bool {
        let is_shell =
            self.bodies[0] * self.bodies[1] > 0.0 && self.sheet.normal().dot(self.on.normal()) < 0.0;
        is_shell && direction.dot(self.on.normal()) < 0.0 && self.sheet.typed_height(self.on) > 0.0
    }

    /// The largest distance from the origin of a typed corner of the larger sheet.
    fn reach(&self) -> f64 {
        self.on.typed.corners().iter().map(|x| x.length()).fold(0.0, f64::max)
    }

    /// Whether both sheets have the same corners to the last bit.
    fn is_typed_twice(&self) -> bool {
        let [own, other] = [self.sheet, self.on].map(|sheet| sheet.typed.corners());
        own.iter().all(|x| other.contains(x))
    }
}

/// Height of the body of a sheet, as [`bodies::height`] finds it; 0 of curved ones.
fn body(own: usize, sheets: &[Sheet], tree: &Bvh, bounds: &Aabb) -> f64 {
    let Some(region) = sheets[own].region() else { return 0.0 };
    let tolerance = touching(region.extent(), bounds.center().length());
    let beside = |other: usize| {
        let is_flipped = sheets[own].flip != sheets[other].flip;
        Some(Beside { sheet: other, outline: sheets[other].region()?.outer(), is_flipped })
    };
    let others = tree.near(bounds).into_iter().filter(|other| *other != own).filter_map(beside);
    bodies::height(region.outer(), tolerance, others, |other| {
        let corners = sheets[other].shape.corners();
        corners.iter().map(|x| region.height(*x)).sum::<f64>() / corners.len() as f64
    })
}

#[cfg(test)]
mod tests {
    use radiosity_geom::{Surface, shapes::Polygon};

    use super::*;

    fn sheet(name: &str, corners: &[[f64; 3]]) -> Sheet {
        let corners = corners.iter().map(|x| DVec3::from_array(*x)).collect();
        let shape: Arc<dyn Surface> = Arc::new(Polygon::new(corners, Vec::new()).expect("a polygon"));
        let (typed, name) = (Arc::clone(&shape), name.to_owned());
        Sheet { typed, shape, two_sided: false, flip: false, stays: false, name }
    }

    /// A square from `low` to `high` at height z, front up.
    fn square(name: &str, low: f64, high: f64, z: f64) -> Sheet {
        sheet(name, &[[low, low, z], [high, low, z], [high, high, z], [low, high, z]])
    }

    fn down(sheet: Sheet) -> Sheet {
        Sheet { flip: true, ..sheet }
    }

    /// A wall over an edge of a square, so that the square is a face of a body.
    fn wall(low: f64, high: f64, z: f64) -> Sheet {
        sheet("wall", &[[low, low, z], [high, low, z], [high, low, z + 1.0], [low, low, z + 1.0]])
    }

    fn height(sheet: &Sheet) -> f64 {
        sheet.shape.corners()[0].z
    }

    /// The heights that the sheets get to.
    fn heights(mut sheets: Vec<Sheet>) -> Vec<f64> {
        set_apart(&mut sheets);
        sheets.iter().map(height).collect()
    }

    #[test]
    fn the_bottom_of_a_box_is_lifted_off_its_floor_into_the_box() {
        let mut sheets =
            vec![square("floor", 0.0, 4.0, 0.0), down(square("bottom", 1.0, 2.0, 0.0)), wall(1.0, 2.0, 0.0)];
        let steps = set_apart(&mut sheets);
        assert!(matches!(steps[..], [Step { sheet: 1, on: 0, .. }]));
        let gap = height(&sheets[1]);
        assert!(gap > 0.0 && gap < 1e-6 && height(&sheets[0]) == 0.0);
    }

    #[test]
    fn a_sheet_that_may_be_turned_over_by_mistake_stays() {
        assert_eq!(
            heights(vec![square("floor", 0.0, 4.0, 0.0), down(square("rug", 1.0, 2.0, 0.0))]),
            [0.0, 0.0]
        );
        assert_eq!(heights(vec![square("floor", 0.0, 4.0, 0.0), square("copy", 0.0, 4.0, 0.0)]), [0.0, 0.0]);
        assert_eq!(heights(vec![square("one", 0.0, 4.0, 0.0), square("other", 2.0, 6.0, 0.0)]), [0.0, 0.0]);
    }

    #[test]
    fn a_picture_hangs_before_its_wall() {
        let found = heights(vec![square("picture", 1.0, 2.0, 0.0), square("wall", 0.0, 4.0, 0.0)]);
        assert!(found[0] > 0.0 && found[1] == 0.0);
        let found = heights(vec![square("picture", 1.0, 2.0, 0.0), down(square("wall", 0.0, 4.0, 0.0))]);
        assert_eq!(found, [0.0, 0.0], "it shows the wall its face");
    }

    #[test]
    fn boxes_of_one_size_stand_on_each_other_in_either_order() {
        let faces = || {
            [
                square("top", 0.0, 1.0, 0.0),
                wall(0.0, 1.0, -1.0),
                down(square("bottom", 0.0, 1.0, 0.0)),
                wall(0.0, 1.0, 0.0),
            ]
        };
        let gap = |sheets: &[Sheet]| {
            let of =
                |name: &str| height(sheets.iter().find(|sheet| sheet.name == name).expect("it is there"));
            of("bottom") - of("top")
        };
        let (mut one, mut other) = (faces().to_vec(), faces().to_vec());
        other.reverse();
        set_apart(&mut one);
        set_apart(&mut other);
        assert!(gap(&one) > 0.0 && gap(&one) == gap(&other));
    }

    #[test]
    fn rooms_side_by_side_keep_their_walls() {
        // The wall between two rooms, once for each of them, its fronts towards their insides.
        let one = sheet("one", &[[0.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 3.0, 3.0], [0.0, 0.0, 3.0]]);
        let other =
            down(sheet("other", &[[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 2.0, 3.0], [0.0, 0.0, 3.0]]));
        let floor = |x: f64, y: f64| sheet("floor", &[[0.0; 3], [x, 0.0, 0.0], [x, y, 0.0], [0.0, y, 0.0]]);
        let mut sheets = vec![one, floor(4.0, 3.0), other, down(floor(-4.0, 2.0))];
        assert!(sheets[0].normal().x > 0.0 && sheets[2].normal().x < 0.0);
        set_apart(&mut sheets);
        let place = |index: usize| sheets[index].shape.corners()[0].x;
        assert!(place(2) < place(0), "each room has its own wall: their backs are together");
    }

    #[test]
    fn the_skins_of_a_shell_stand_back_to_back() {
        // A floor seen from above and the same from below, each with a wall of its own above it.
        let [inner, outer] = [square("inner", 0.0, 1.0, 0.0), down(square("outer", 0.0, 1.0, 0.0))];
        let found = heights(vec![inner, down(wall(0.0, 1.0, 0.0)), outer, wall(0.0, 1.0, 0.0)]);
        assert!(found[2] < found[0], "{found:?}");
    }

    /// The bottom of a box that was typed within rounding over that of a recess is taken for a skin of a shell;
    /// one that was typed below it is one.
    #[test]
    fn skins_that_were_typed_face_to_face_are_told() {
        let is_turned = |typed: f64| {
            let outer = down(Sheet {
                typed: square("typed", 0.0, 1.0, typed).shape,
                ..square("outer", 0.0, 1.0, 0.0)
            });
            let inner = square("inner", 0.0, 1.0, 0.0);
            let sheets = [inner, down(wall(0.0, 1.0, 0.0)), outer, wall(0.0, 1.0, 0.0)];
            steps(&sheets).iter().any(|step| step.is_turned)
        };
        assert_eq!([1e-12, 0.0, -1e-12].map(is_turned), [true, false, false]);
    }

    #[test]
    fn a_lid_under_a_slab_stays_under_it() {
        let found =
            heights(vec![square("slab", 0.0, 4.0, 1.0), square("lid", 1.0, 2.0, 1.0), wall(1.0, 2.0, 0.0)]);
        assert!(found[1] < found[0], "{found:?}");
    }

    #[test]
    fn rounding_tells_nothing() {
        let copy = Sheet { typed: square("typed", 0.0, 4.0, 1e-16).shape, ..square("copy", 0.0, 4.0, 0.0) };
        assert_eq!(heights(vec![square("sheet", 0.0, 4.0, 0.0), copy]), [0.0, 0.0]);
        let told = Sheet { typed: square("typed", 0.0, 4.0, -1e-10).shape, ..square("copy", 0.0, 4.0, 0.0) };
        let found = heights(vec![square("sheet", 0.0, 4.0, 0.0), down(told)]);
        assert!(found[0] != found[1]);
    }

    #[test]
    fn layers_lie_on_each_other() {
        let found = heights(vec![
            square("floor", 0.0, 4.0, 0.0),
            Sheet { two_sided: true, ..square("board", 0.5, 3.0, 0.0) },
            down(square("bottom", 1.0, 2.0, 0.0)),
            wall(1.0, 2.0, 0.0),
        ]);
        assert!(found[0] < found[1] && found[1] < found[2], "{found:?}");
    }

    #[test]
    fn the_sheet_that_may_move_does_whichever_is_larger() {
        let sheets = |still: usize| {
            let mut sheets = [square("board", 0.0, 4.0, 0.0), square("picture", 1.0, 2.0, 0.0)];
            sheets[still].stays = true;
            heights(sheets.to_vec())
        };
        assert!(matches!(sheets(0)[..], [0.0, up] if up > 0.0));
        assert!(matches!(sheets(1)[..], [down, 0.0] if down < 0.0));
        let both = [square("board", 0.0, 4.0, 0.0), square("picture", 1.0, 2.0, 0.0)];
        assert_eq!(heights(both.map(|sheet| Sheet { stays: true, ..sheet }).to_vec()), [0.0, 0.0]);
    }

    #[test]
    fn two_sides_of_one_sheet_stay_together() {
        let sheets = vec![square("sheet", 0.0, 1.0, 0.0), down(square("sheet:back", 0.0, 1.0, 0.0))];
        assert_eq!(heights(sheets), [0.0, 0.0]);
    }
}
