//! Who touches whom: the Cornell box, and pairs in random places.

use crate::scenes::{cornell_corners, cornell_faces};
use proptest::prelude::*;
use radiosity_geom::shapes::{Bilinear, Cylinder, Disk, FULL_TURN, Parallelogram, Polygon, Sphere, Trimmed};
use radiosity_geom::{Adjacency, Bvh, DVec3, Motion, Patch, Placed, Rect, Surface, separated};

fn adjacency(a: &dyn Surface, b: &dyn Surface) -> Option<Adjacency> {
    Adjacency::of(&Patch::whole(a), &Patch::whole(b))
}

#[test]
fn the_blocks_stand_on_the_floor() {
    let faces = cornell_faces();
    let floor = &faces["floor"];
    let standing: Vec<&String> = faces
        .iter()
        .filter(|(_, face)| adjacency(floor, *face) == Some(Adjacency::Tee))
        .map(|(name, _)| name)
        .collect();
    assert_eq!(standing.len(), 8);
    assert!(standing.iter().all(|name| name.contains("_block_side")));
}

#[test]
fn the_walls_of_the_box_share_edges_and_the_light_lies_in_the_ceiling() {
    let faces = cornell_faces();
    let walls = ["floor", "ceiling", "left_wall", "right_wall", "back_wall"];
    let edges = |a: &str, b: &str| adjacency(&faces[a], &faces[b]) == Some(Adjacency::Edge);
    for (k, a) in walls.iter().enumerate() {
        for b in &walls[k + 1..] {
            let opposite = [["floor", "ceiling"], ["left_wall", "right_wall"]].contains(&[*a, *b]);
            assert_ne!(edges(a, b), opposite, "{a} {b}");
        }
    }
    assert_eq!(adjacency(&faces["ceiling"], &faces["light"]), Some(Adjacency::Overlap));
    assert_eq!(adjacency(&faces["short_block_top"], &faces["ceiling"]), None);
    assert!(edges("short_block_side1", "short_block_side2"));
}

#[test]
fn cutting_the_light_out_of_the_ceiling_makes_them_neighbours() {
    let corners = cornell_corners();
    let ceiling = Box::new(Bilinear::new(corners["ceiling"]).unwrap());
    let cut = Trimmed::new(ceiling, vec![corners["light"].to_vec()]).unwrap();
    let light = Bilinear::new(corners["light"]).unwrap();
    assert_eq!(adjacency(&cut, &light), Some(Adjacency::Edge));
}

#[test]
fn nothing_stands_between_floor_and_ceiling_but_the_blocks() {
    let (corners, faces) = (cornell_corners(), cornell_faces());
    let boxes: Vec<_> = faces.values().map(|face| face.bounds(&Rect::FULL)).collect();
    let bvh = Bvh::build(&boxes);
    let names: Vec<&String> = faces.keys().collect();
    let shaft = faces["floor"].bounds(&Rect::FULL).union(faces["ceiling"].bounds(&Rect::FULL));
    let mut between = Vec::new();
    bvh.overlapping(&shaft, |k| {
        if !separated(&corners["floor"], &corners["ceiling"], &corners[names[k]], 1e-6) {
            between.push(names[k].as_str());
        }
    });
    // The walls bound the shaft; the left one, twisted, bulges into it by millimetres.
    between.retain(|name| *name != "left_wall");
    between.sort_unstable();
    assert_eq!(between.len(), 10);
    assert!(between.iter().all(|name| name.contains("_block_")));
}

#[test]
fn curved_neighbours() {
    let axis = 2.0 * DVec3::Z;
    let wall = Cylinder::new(DVec3::ZERO, axis, 1.0, [0.0, 2.0]).unwrap();
    let next = Cylinder::new(DVec3::ZERO, axis, 1.0, [2.0, 3.0]).unwrap();
    let lid = Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, [0.0, 2.0]).unwrap();
    assert_eq!(adjacency(&wall, &next), Some(Adjacency::Edge));
    assert_eq!(adjacency(&wall, &lid), Some(Adjacency::Edge));
    // A ball over a plate does not touch it; a table through it crosses.
    let ball = Sphere::new(DVec3::Z, 1.0, DVec3::X, [-1.0, 1.0], FULL_TURN).unwrap();
    let plate = Parallelogram::new(DVec3::new(-2.0, -2.0, -0.1), 4.0 * DVec3::X, 4.0 * DVec3::Y).unwrap();
    assert_eq!(adjacency(&ball, &plate), None);
    let table = Parallelogram::new(DVec3::new(-2.0, -2.0, 0.3), 4.0 * DVec3::X, 4.0 * DVec3::Y).unwrap();
    let Some(Adjacency::Crossing { at }) = adjacency(&ball, &table) else { panic!() };
    assert!((at.z - 0.3).abs() < 1e-3 && (at.distance(DVec3::Z) - 1.0).abs() < 3e-2);
}

/// Parts of closed surfaces meet across the seam where u = −1 and u = 1 as they do elsewhere.
#[test]
fn parts_meet_across_the_closing_seam() {
    let wall = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, FULL_TURN).unwrap();
    let ball = Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).unwrap();
    let (first, last, below, above) = ([-1.0, -0.5], [0.5, 1.0], [-1.0, 0.0], [0.0, 1.0]);
    for surface in [&wall as &dyn Surface, &ball] {
        let part = |u, v| Patch::Curved(surface, Rect { u, v });
        assert_eq!(Adjacency::of(&part(first, below), &part(last, below)), Some(Adjacency::Edge));
        assert_eq!(Adjacency::of(&part(first, below), &part(last, above)), Some(Adjacency::Vertex));
    }
    let fin = Parallelogram::new(DVec3::X, DVec3::X, DVec3::Z).unwrap();
    for u in [first, last] {
        let part = Patch::Curved(&wall, Rect { u, v: [-1.0, 1.0] });
        assert_eq!(Adjacency::of(&part, &Patch::whole(&fin)), Some(Adjacency::Edge), "{u:?}");
    }
}

fn motion() -> impl Strategy<Value = Motion> {
    (prop::array::uniform3(-5.0..5.0), prop::array::uniform3(0.1..1.0), -3.0..3.0, 0.01..100.0)
        .prop_map(|(t, axis, angle, scale)| Motion::new(t.into(), axis.into(), angle, scale).unwrap())
}

fn placed(surface: impl Surface + 'static, motion: Motion) -> Placed {
    Placed::new(Box::new(surface), motion)
}

proptest! {
    /// A hinge of two unit squares, opened by any angle, anywhere: one edge.
    #[test]
    fn hinges_are_found(motion in motion(), angle in 0.2..2.9_f64) {
        let (sin, cos) = angle.sin_cos();
        let a = Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
        let b = Parallelogram::new(DVec3::ZERO, DVec3::Y, DVec3::new(cos, 0.0, sin)).unwrap();
        prop_assert_eq!(adjacency(&placed(a, motion), &placed(b, motion)), Some(Adjacency::Edge));
    }

    /// A wall standing somewhere inside a floor.
    #[test]
    fn standing_walls_are_found(motion in motion(), x in 0.1..0.5, y in 0.1..0.8, length in 0.1..0.4, tilt in -0.5..0.5) {
        let floor = Polygon::new(vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y], vec![]).unwrap();
        let wall = Parallelogram::new(DVec3::new(x, y, 0.0), length * DVec3::X, DVec3::new(0.0, tilt, 1.0)).unwrap();
        let found = adjacency(&placed(floor, motion), &placed(wall, motion));
        prop_assert_eq!(found, Some(Adjacency::Tee));
    }

    /// A wall that stands on a floor and reaches beyond it, at one end or at both, or across a hole.
    #[test]
    fn walls_beyond_the_floor_are_found(motion in motion(), start in -0.9..0.9_f64, length in 0.2..3.0_f64, y in 0.1..0.3) {
        let outline = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let hole = [(0.4, 0.05), (0.6, 0.05), (0.6, 0.5), (0.4, 0.5)].map(|(x, y)| DVec3::new(x, y, 0.0));
        let floor = Polygon::new(outline, vec![hole.to_vec()]).unwrap();
        let wall = Parallelogram::new(DVec3::new(start, y, 0.0), length * DVec3::X, DVec3::Z).unwrap();
        let over = |low: f64, high: f64| (start + length).min(high) - start.max(low);
        // Far enough on the floor, or clearly beside it.
        let most = over(0.0, 0.4).max(over(0.6, 1.0));
        prop_assume!(most.abs() > 1e-3);
        let found = adjacency(&placed(floor, motion), &placed(wall, motion));
        prop_assert_eq!(found == Some(Adjacency::Tee), most > 0.0);
    }

    /// A short square against a long one: the short edge lies along part of the long.
    #[test]
    fn partial_edges_are_found(motion in motion(), start in 0.1..0.5, length in 0.1..0.4) {
        let long = Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
        let short = Parallelogram::new(start * DVec3::X, length * DVec3::X, DVec3::Z).unwrap();
        let found = adjacency(&placed(long, motion), &placed(short, motion));
        prop_assert_eq!(found, Some(Adjacency::Tee));
    }

    /// Squares with one corner in common, and squares with none.
    #[test]
    fn corners_and_gaps_are_found(motion in motion(), lift in 0.3..1.0, distance in 0.05..3.0_f64) {
        let square = || Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
        let corner = Parallelogram::new(DVec3::ZERO, DVec3::new(-1.0, 0.2, lift), DVec3::new(0.1, -1.0, lift)).unwrap();
        let found = adjacency(&placed(square(), motion), &placed(corner, motion));
        prop_assert_eq!(found, Some(Adjacency::Vertex));
        let above = Parallelogram::new(distance * DVec3::Z, DVec3::X, DVec3::Y).unwrap();
        prop_assert_eq!(adjacency(&placed(square(), motion), &placed(above, motion)), None);
    }

    /// Squares in one plane that share a strip or a corner, however narrow, and squares that only touch.
    #[test]
    fn overlaps_in_a_plane_are_found(motion in motion(), x in 1e-4..0.9_f64, y in -0.9..0.9_f64) {
        let square = |x, y| placed(Parallelogram::new(DVec3::new(x, y, 0.0), DVec3::X, DVec3::Y).unwrap(), motion);
        prop_assert_eq!(adjacency(&square(0.0, 0.0), &square(1.0 - x, y)), Some(Adjacency::Overlap));
        prop_assert_eq!(adjacency(&square(0.0, 0.0), &square(1.0, y)), Some(Adjacency::Tee));
    }

    /// Squares passing through each other, and lying in each other.
    #[test]
    fn faults_are_found(motion in motion(), x in 0.1..0.9, y in 0.1..0.5) {
        let square = || Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
        let through = Parallelogram::new(DVec3::new(x, y, -0.5), DVec3::Z, 0.3 * DVec3::Y).unwrap();
        let crossed = matches!(adjacency(&placed(square(), motion), &placed(through, motion)), Some(Adjacency::Crossing { .. }));
        prop_assert!(crossed);
        let inside = Parallelogram::new(0.5 * DVec3::new(x, y, 0.0), 0.4 * DVec3::X, 0.5 * DVec3::Y).unwrap();
        prop_assert_eq!(adjacency(&placed(square(), motion), &placed(inside, motion)), Some(Adjacency::Overlap));
        prop_assert_eq!(adjacency(&placed(square(), motion), &placed(square(), motion)), Some(Adjacency::Overlap));
    }
}
