//! Coplanar faces become polygons with holes.

use std::collections::HashSet;

use glam::{DQuat, DVec3};
use proptest::prelude::*;
use radiosity_formats::merge;
use radiosity_formats::model::{Model, Shape, Sides, Surface};
use radiosity_test_support::random::seeded;

use crate::measures::notes;
use crate::meshes::shapes::region;

/// A model of polygons, surfaces of the object `a`.
fn model(faces: &[Vec<DVec3>]) -> Model {
    let surface = |(index, outline): (usize, &Vec<DVec3>)| Surface {
        name: format!("a-{}", index + 1),
        material: None,
        shape: Shape::Polygon { outline: outline.clone(), holes: Vec::new() },
        sides: Sides::Open,
        file: None,
        place: None,
    };
    Model {
        bands: vec!["grey".to_owned()],
        surfaces: faces.iter().enumerate().map(surface).collect(),
        ..Model::default()
    }
}

/// Merges the coplanar faces of each object; the first letter of a name is its object.
fn coplanar(model: &mut Model) {
    let object = |surface: &Surface| usize::from(surface.name.starts_with('b'));
    let mut objects = model.surfaces.iter().map(object).collect();
    merge::coplanar(model, &mut objects);
}

/// Squares of a grid, each as two triangles, moved by `place`.
fn grid(cells: &[[i32; 2]], place: impl Fn(DVec3) -> DVec3) -> Vec<Vec<DVec3>> {
    let point = |i: i32, j: i32| place(DVec3::new(f64::from(i), f64::from(j), 0.0));
    cells
        .iter()
        .flat_map(|[i, j]| {
            let [a, b, c, d] = [point(*i, *j), point(i + 1, *j), point(i + 1, j + 1), point(*i, j + 1)];
            // Diagonals of both directions.
            if (i + j) % 2 == 0 { [vec![a, b, c], vec![a, c, d]] } else { [vec![a, b, d], vec![b, c, d]] }
        })
        .collect()
}

fn all(side: i32) -> Vec<[i32; 2]> {
    (0..side * side).map(|k| [k % side, k / side]).collect()
}

fn tilted(x: DVec3) -> DVec3 {
    DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 1.1) * x + DVec3::new(7.0, -3.0, 0.3)
}

/// Rounded to single precision.
fn rounded(x: DVec3) -> DVec3 {
    DVec3::from_array(tilted(x).to_array().map(|c| f64::from(c as f32)))
}

#[test]
fn a_wall_with_a_window_is_one_polygon() {
    let mut cells = all(3);
    cells.retain(|cell| *cell != [1, 1]);
    for place in [|x| x, tilted, rounded] as [fn(DVec3) -> DVec3; 3] {
        let mut wall = model(&grid(&cells, place));
        coplanar(&mut wall);
        assert_eq!(notes(&wall), ["16 coplanar triangles were merged to 1 polygon"]);
        let Shape::Polygon { outline, holes } = &wall.surfaces[0].shape else { panic!("a polygon") };
        assert_eq!((outline.len(), holes.len(), holes[0].len()), (4, 1, 4));
        let region = region(&wall.surfaces[0]);
        assert!((region.area() - 8.0).abs() < 1e-5);
        assert!(
            region.normal().distance(tilted(DVec3::Z) - tilted(DVec3::ZERO)) < 1e-5
                || place(DVec3::ZERO) == DVec3::ZERO
        );
    }
}

#[test]
fn loops_that_touch_at_a_corner_are_each_simple() {
    // Two holes that touch, one of them touching the outline.
    let mut cells = all(4);
    cells.retain(|cell| ![[1, 1], [2, 2]].contains(cell));
    let mut touching = model(&grid(&cells, tilted));
    coplanar(&mut touching);
    let region = region(&touching.surfaces[0]);
    assert_eq!((touching.surfaces.len(), region.holes().len()), (1, 2));
    assert!((region.area() - 14.0).abs() < 1e-9);
    // The ends of a bent strip touch: its outline touches itself around a hole.
    let strip = [[1, 0], [0, 0], [0, 1], [0, 2], [1, 2], [2, 2], [2, 1]];
    let mut strip = model(&grid(&strip, |x| x));
    coplanar(&mut strip);
    let region = crate::meshes::shapes::region(&strip.surfaces[0]);
    assert_eq!((strip.surfaces.len(), region.holes().len(), region.area()), (1, 1, 7.0));
}

#[test]
fn corners_that_others_have_stay() {
    let floor = grid(&all(2), |x| x);
    // A wall of two squares on one side; at (1, 0, 0) they meet without being coplanar with the floor.
    let wall = grid(&all(2), |x| DVec3::new(x.x, 0.0, x.y));
    let mut both = model(&[floor.clone(), wall].concat());
    coplanar(&mut both);
    let lengths = |model: &Model| -> Vec<usize> {
        model.surfaces.iter().map(|surface| region(surface).outer().len()).collect()
    };
    assert_eq!(lengths(&both), [4, 4], "both go straight on there");
    let post = vec![DVec3::X, DVec3::new(1.0, 0.0, 1.0), DVec3::new(1.0, -1.0, 0.0)];
    let mut with_post = model(&[floor, vec![post]].concat());
    coplanar(&mut with_post);
    assert_eq!(lengths(&with_post), [5, 3], "the post has a corner there");
}

#[test]
fn only_what_belongs_together_is_merged() {
    let faces = grid(&all(1), |x| x);
    let count = |change: &dyn Fn(&mut Surface)| {
        let mut model = model(&faces);
        change(&mut model.surfaces[1]);
        coplanar(&mut model);
        model.surfaces.len()
    };
    assert_eq!(count(&|_| {}), 1);
    assert_eq!(count(&|surface| surface.material = Some(0)), 2);
    assert_eq!(count(&|surface| surface.sides = Sides::Both), 2);
    assert_eq!(count(&|surface| surface.name = "b-2".to_owned()), 2);
    let turn = |surface: &mut Surface| {
        if let Shape::Polygon { outline, .. } = &mut surface.shape {
            outline.reverse();
        }
    };
    assert_eq!(count(&turn), 2, "one is turned over");
    let lift = |surface: &mut Surface| {
        if let Shape::Polygon { outline, .. } = &mut surface.shape {
            outline[2].z = 2e-4;
        }
    };
    assert_eq!(count(&lift), 2, "one is tilted");
}

#[test]
fn layers_and_backs_do_not_mix() {
    let front = grid(&all(2), |x| x);
    let back: Vec<Vec<DVec3>> = front.iter().map(|outline| outline.iter().rev().copied().collect()).collect();
    let mut two = model(&[front.clone(), back].concat());
    coplanar(&mut two);
    assert_eq!(two.surfaces.len(), 2, "front and back are a polygon each");
    assert!(two.surfaces.iter().all(|surface| (region(surface).area() - 4.0).abs() < 1e-12));
    let mut twice = model(&[front.clone(), front.clone()].concat());
    coplanar(&mut twice);
    assert_eq!(twice.surfaces.len(), 16, "which layer a side belongs to is not told");
    let area: f64 = twice.surfaces.iter().map(|surface| region(surface).area()).sum();
    assert!((area - 8.0).abs() < 1e-12);
}

#[test]
fn what_overlaps_itself_stays_as_it_is() {
    // A strip of squares that winds once around and goes on over its beginning, which it does not share.
    let ring = [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2]];
    let mut faces = grid(&ring, |x| x);
    let over = |x: DVec3| DVec3::new(0.0, 2.0, 0.0) + DVec3::new(x.x, x.y * -1.7, 0.0);
    let [a, b, c, d] =
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| over(DVec3::new(x, y, 0.0)));
    faces.push(vec![d, c, b, a]);
    let before = faces.len();
    let mut spiral = model(&faces);
    coplanar(&mut spiral);
    assert_eq!(spiral.surfaces.len(), before);
}

#[test]
fn slits_of_sides_that_meet_in_parts_close() {
    // A large triangle meets two smaller ones along its side, and others hold them together.
    let p = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let faces = [
        vec![p(0.0, 0.0), p(2.0, 0.0), p(2.0, 1.0), p(0.0, 1.0)],
        vec![p(0.0, 1.0), p(1.0, 1.0), p(1.0, 2.0), p(0.0, 2.0)],
        vec![p(1.0, 1.0), p(2.0, 1.0), p(2.0, 2.0), p(1.0, 2.0)],
        vec![p(2.0, 0.0), p(3.0, 1.0), p(2.0, 1.0)],
        vec![p(2.0, 1.0), p(3.0, 1.0), p(2.0, 2.0)],
    ];
    let mut model = model(&faces);
    coplanar(&mut model);
    assert_eq!(model.surfaces.len(), 1);
    let region = region(&model.surfaces[0]);
    assert_eq!((region.area(), region.holes().len()), (5.0, 0));
}

/// Corners of all faces, as bits.
fn corners(faces: &[Vec<DVec3>]) -> HashSet<[u64; 3]> {
    faces.iter().flatten().map(|x| x.to_array().map(f64::to_bits)).collect()
}

/// A polygon's fan of triangles around its first corner.
fn fan(outline: &[DVec3]) -> Vec<Vec<DVec3>> {
    outline[1..].windows(2).map(|side| vec![outline[0], side[0], side[1]]).collect()
}

#[test]
fn what_is_small_beside_a_large_ground_keeps_its_corners() {
    // A plate whose corner is cut off by 21 mm, and a sheet half a millimetre above it, once in decimals and
    // once in single precision, each with a ground of 20 km in the same object.
    let p = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let plate =
        [p(0.1, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 0.985, 0.0), p(0.985, 1.0, 0.0), p(0.1, 1.0, 0.0)];
    let above = plate.map(|x| x + 5e-4 * DVec3::Z);
    let ground = [p(-1e4, -1e4, -1.0), p(1e4, -1e4, -1.0), p(1e4, 1e4, -1.0), p(-1e4, 1e4, -1.0)];
    let single = |x: DVec3| DVec3::from_array(x.to_array().map(|c| f64::from(c as f32)));
    for place in [|x| x, single] as [fn(DVec3) -> DVec3; 2] {
        let faces: Vec<Vec<DVec3>> = [fan(&plate), fan(&above), fan(&ground)].concat();
        let faces: Vec<Vec<DVec3>> =
            faces.iter().map(|face| face.iter().map(|x| place(*x)).collect()).collect();
        let mut site = model(&faces);
        coplanar(&mut site);
        let merged: Vec<Vec<DVec3>> = site.surfaces.iter().map(|own| region(own).outer().to_vec()).collect();
        assert_eq!(merged.iter().map(Vec::len).collect::<Vec<_>>(), [5, 5, 4]);
        assert_eq!(corners(&merged), corners(&faces));
    }
}

#[test]
fn a_dome_around_all_bends_no_gentle_roof() {
    // Of three strips the last rises by 1.8 mm in 20 m, beside a face of 50 km: the level ones are one.
    let p = |x: f64, z: f64| [DVec3::new(x, 0.0, z), DVec3::new(x, 10.0, z)];
    let strip = |[a, d]: [DVec3; 2], [b, c]: [DVec3; 2]| vec![a, b, c, d];
    let roof = [p(0.0, 3.0), p(10.0, 3.0), p(20.0, 3.0), p(40.0, 3.0018)];
    let roof: Vec<Vec<DVec3>> = roof.windows(2).map(|ends| strip(ends[0], ends[1])).collect();
    let dome = vec![5e4 * DVec3::X, 5e4 * DVec3::Y, 5e4 * DVec3::Z];
    let mut site = model(&[roof, vec![dome]].concat());
    coplanar(&mut site);
    assert_eq!(site.surfaces.len(), 3);
}

#[test]
fn corners_that_single_precision_rounded_apart_are_one() {
    // The shared side is off by a rounding in one of two squares.
    let third = f64::from(1.0f32 / 3.0);
    let off = f64::from(1.0f32 / 3.0 + f32::EPSILON / 4.0);
    assert_ne!(third, off);
    let square = |low: f64, high: f64| {
        [[low, 0.1], [high, 0.1], [high, 0.7], [low, 0.7]]
            .map(|[x, y]| DVec3::new(f64::from(x as f32), f64::from(y as f32), 0.0))
            .to_vec()
    };
    let faces = [square(-0.2, third), square(off, 0.9)];
    let mut wall = model(&faces);
    coplanar(&mut wall);
    assert_eq!(wall.surfaces.len(), 1);
    let outline = region(&wall.surfaces[0]).outer().to_vec();
    assert!(outline.len() == 4 && corners(&[outline]).is_subset(&corners(&faces)));
}

proptest! {
    #![proptest_config(seeded(96, 7))]

    #[test]
    fn random_walls_keep_their_area_and_are_sound(
        is_there in prop::collection::vec(prop::bool::weighted(0.7), 36),
        axis in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        angle in 0.0..6.0f64,
        is_single: bool,
    ) {
        let cells: Vec<[i32; 2]> =
            all(6).into_iter().zip(&is_there).filter(|(_, is_there)| **is_there).map(|(cell, _)| cell).collect();
        prop_assume!(!cells.is_empty());
        let turn = DQuat::from_axis_angle(DVec3::from_array(axis).normalize_or(DVec3::X), angle);
        let place = |x: DVec3| {
            let x = turn * x + DVec3::new(5.0, 1.0, -2.0);
            if is_single { DVec3::from_array(x.to_array().map(|c| f64::from(c as f32))) } else { x }
        };
        let mut wall = model(&grid(&cells, place));
        let bare = |model: &Model| model.surfaces.iter().map(|surface| region(surface).area()).sum::<f64>();
        let before = bare(&wall);
        coplanar(&mut wall);
        let rounding = if is_single { 1e-6 } else { 1e-12 };
        prop_assert!((bare(&wall) / before - 1.0).abs() < rounding);
        // Cells that hang together by sides are one polygon.
        let mut open = cells.clone();
        let mut islands = 0;
        while let Some(first) = open.pop() {
            islands += 1;
            let mut next = vec![first];
            while let Some([i, j]) = next.pop() {
                let (joined, rest): (Vec<_>, Vec<_>) =
                    open.into_iter().partition(|[k, l]: &[i32; 2]| (i - k).abs() + (j - l).abs() == 1);
                (open, next) = (rest, [next, joined].concat());
            }
        }
        prop_assert_eq!(wall.surfaces.len(), islands);
    }
}
