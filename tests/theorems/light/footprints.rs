//! The floor under a standing box is cut out, as if the floor had a hole there, and nothing else is.

use proptest::prelude::*;
use radiosity::elements::{Discretization, Elements};
use radiosity::scene::Scene;
use radiosity::solve::{Options, Outcome};
use radiosity::visibility::footprints::footprints;
use radiosity::visibility::inspection::Inspection;
use radiosity_geom::DVec2;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

use crate::light::shapes::{Quad, quad, room, upright};

/// A scene of grey quads; those named `lamp` shine.
fn scene(quads: &[Quad]) -> Scene {
    let mut text = "bands = [\"grey\"]\n[materials.grey]\nreflectance = 0.5\n[materials.lamp]\nreflectance = 0\nemission = 1\n".to_owned();
    for (name, vertices) in quads {
        let material = if name.starts_with("lamp") { "lamp" } else { "grey" };
        text += &format!(
            "[[surfaces]]\nname = {name:?}\nmaterial = {material:?}\nquad = {{ vertices = {vertices:?} }}\n"
        );
    }
    typed(&text)
}

fn rectangle([x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> [[f64; 2]; 4] {
    [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
}

/// (surface, area) of each footprint.
fn found(quads: &[Quad]) -> Vec<(String, f64)> {
    let scene = scene(quads);
    let footprints = footprints(&scene);
    footprints.iter().map(|f| (scene.surfaces[f.surface].name.clone(), f.region.area())).collect()
}

#[track_caller]
fn assert_found(quads: &[Quad], expected: &[(&str, f64)]) {
    let found = found(quads);
    let same = |((name, area), (own, exact)): (&(String, f64), &(&str, f64))| {
        name == own && (area - exact).abs() < 1e-9 * exact
    };
    assert!(found.len() == expected.len() && found.iter().zip(expected).all(same), "{found:?}");
}

#[test]
fn a_box_on_the_floor_has_a_footprint_and_one_above_it_has_none() {
    let base = rectangle([1.0, 2.0], [0.5, 2.5]);
    let with = |heights| [room([4.0, 4.0, 3.0]), upright("box", base, heights)].concat();
    assert_found(&with([0.0, 1.0]), &[("floor", 2.0)]);
    assert_found(&with([0.01, 1.0]), &[]);
    // From floor to ceiling, its top in the ceiling being left out.
    let mut column = with([0.0, 3.0]);
    column.pop();
    assert_found(&column, &[("floor", 2.0), ("ceiling", 2.0)]);
}

#[test]
fn open_boxes_and_those_with_a_lamp_inside_cover_nothing() {
    let base = rectangle([1.0, 2.0], [0.5, 2.5]);
    let standing = [room([4.0, 4.0, 3.0]), upright("box", base, [0.0, 1.0])].concat();
    let mut open = standing.clone();
    open.pop();
    assert_found(&open, &[]);
    let mut lit = standing.clone();
    lit.push(quad("lamp", [[1.2, 1.2, 0.5], [1.2, 1.4, 0.5], [1.4, 1.4, 0.5], [1.4, 1.2, 0.5]]));
    assert_found(&lit, &[]);
    // A smaller room within the room, its fronts inside: nothing of the floor is covered.
    let walls = upright("inner", rectangle([1.0, 2.0], [0.5, 2.5]), [0.0, 1.0]);
    let turned = walls.into_iter().map(|(name, [a, b, c, d])| (name, [d, c, b, a]));
    assert_found(&room([4.0, 4.0, 3.0]).into_iter().chain(turned).collect::<Vec<_>>(), &[]);
}

#[test]
fn a_box_that_leans_on_walls_covers_part_of_each() {
    // In the corner of x = 0 and y = 0, without the sides and with its fronts to the room only.
    let mut quads = room([4.0, 4.0, 3.0]);
    let corner = upright("box", rectangle([0.0, 1.0], [0.0, 2.0]), [0.0, 0.5]);
    quads.extend(
        corner.into_iter().filter(|(name, _)| !["box-side-0", "box-side-3"].contains(&name.as_str())),
    );
    assert_found(&quads, &[("floor", 2.0), ("x0", 1.0), ("y0", 0.5)]);
}

#[test]
fn boxes_that_touch_cover_each_other() {
    // The lower one leans on the side x = 2 of the higher one; its own side there is left out.
    let mut quads = room([4.0, 4.0, 3.0]);
    quads.extend(upright("high", rectangle([1.0, 2.0], [1.0, 3.0]), [0.0, 2.0]));
    let low = upright("low", rectangle([2.0, 3.0], [1.5, 2.0]), [0.0, 1.0]);
    quads.extend(low.into_iter().filter(|(name, _)| name != "low-side-3"));
    let mut footprints = found(&quads);
    footprints.sort_by(|a, b| (&a.0, a.1).partial_cmp(&(&b.0, b.1)).expect("areas are numbers"));
    let expected = [("floor", 0.5), ("floor", 2.0), ("high-side-1", 0.5)];
    assert_eq!(footprints.len(), 3, "{footprints:?}");
    for ((name, area), (own, exact)) in footprints.iter().zip(expected) {
        assert!(name == own && (area - exact).abs() < 1e-12, "{footprints:?}");
    }
}

#[test]
fn a_box_across_the_joint_of_two_floors_covers_part_of_both() {
    let base = [
        quad("left", [[0., 0., 0.], [1., 0., 0.], [1., 2., 0.], [0., 2., 0.]]),
        quad("right", [[1., 0., 0.], [2., 0., 0.], [2., 2., 0.], [1., 2., 0.]]),
    ];
    let standing = upright("box", rectangle([0.5, 1.75], [0.5, 1.5]), [0.0, 1.0]);
    assert_found(&[base.to_vec(), standing].concat(), &[("left", 0.5), ("right", 0.75)]);
}

#[test]
fn walls_across_a_room_and_dark_rooms_are_no_footprints() {
    assert_found(&room([4.0, 4.0, 3.0]), &[]);
    let mut divided = room([4.0, 4.0, 3.0]);
    divided.push(quad("wall", [[2., 0., 0.], [2., 4., 0.], [2., 4., 3.], [2., 0., 3.]]));
    divided.push(quad("other", [[2.1, 0., 0.], [2.1, 0., 3.], [2.1, 4., 3.], [2.1, 4., 0.]]));
    // What lies within the wall of 0.1 is covered; the rooms on either side are not, although no lamp shines
    // in either.
    let exact = [("floor", 0.4), ("ceiling", 0.4), ("y0", 0.3), ("y1", 0.3)];
    let mut turned = divided.clone();
    let count = turned.len();
    for (_, vertices) in &mut turned[count - 2..] {
        vertices.reverse();
    }
    assert_found(&turned, &exact);
    assert_found(&divided, &[]);
}

/// The text of the Cornell box; without the holes in its floor if `cut` is not set.
fn cornell(cut: bool) -> Scene {
    let text = radiosity::language::source("cornell-box", &[]).expect("it is built in").text().to_string();
    let start = text.find("holes = [\n").expect("the floor has holes");
    let end = start + text[start..].find("]\n\n").expect("they end") + 2;
    let text = if cut { text } else { text[..start].to_owned() + &text[end..] };
    typed(&text)
}

fn solved(scene: &Scene) -> Outcome {
    outcome_of(scene, &Options { order: 2, threads: 2, ..Options::default() })
}

/// The two declared holes and the two footprints found give the same elements, and so the same solution.
#[test]
fn the_cornell_box_without_holes_is_the_one_with_them() {
    let (declared, bare) = (cornell(true), cornell(false));
    assert!(footprints(&declared).is_empty());
    let names =
        |scene: &Scene| Inspection::of(scene).footprints.iter().map(|f| f.standing.len()).collect::<Vec<_>>();
    assert_eq!(names(&bare), [4, 4], "each where four sides stand");
    let how = Discretization::uniform(2, 2);
    let [a, b] = [&declared, &bare].map(|scene| Elements::new(scene, &how).expect("all have area"));
    assert_eq!(a.list().len(), b.list().len());
    for (a, b) in a.list().iter().zip(b.list()) {
        assert!((a.area - b.area).abs() <= 1e-12 * a.area, "{} {}", a.area, b.area);
    }
    let whole = bare.surfaces[0].shape.region().expect("the floor is flat").area();
    let left = b.of_surface(0).map(|k| b.list()[k].area).sum::<f64>();
    assert!((whole - left - 27633.0 - 27626.5).abs() < 1e-6);
    let [a, b] = [&declared, &bare].map(solved);
    for (a, b) in a.solution.bands().iter().zip(b.solution.bands()) {
        let (a, b) = (&a.coefficients.irradiance, &b.coefficients.irradiance);
        let norm = |x: &mut dyn Iterator<Item = f64>| x.map(|x| x * x).sum::<f64>().sqrt();
        let difference = norm(&mut a.iter().zip(b).map(|(a, b)| a - b));
        assert!(difference <= 1e-12 * norm(&mut a.iter().copied()), "{difference}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Any box that stands on a floor covers its base, wherever and however it is turned.
    #[test]
    fn a_turned_box_covers_its_base(
        at in (1.5..2.5, 1.5..2.5), sides in (0.05..1.0, 0.05..1.0), turn in 0.0..6.3, height in 0.1..2.5,
    ) {
        let (axis, half) = (DVec2::from_angle(turn), DVec2::new(sides.0, sides.1));
        let corner = |[x, y]: [f64; 2]| {
            (DVec2::new(at.0, at.1) + axis.rotate(half * DVec2::new(x, y))).to_array()
        };
        let base = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner);
        let found = found(&[room([4.0, 4.0, 3.0]), upright("box", base, [0.0, height])].concat());
        prop_assert_eq!(found.len(), 1);
        prop_assert!(found[0].0 == "floor" && (found[0].1 - 4.0 * sides.0 * sides.1).abs() < 1e-9);
    }
}
