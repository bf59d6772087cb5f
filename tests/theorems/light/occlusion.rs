//! View factors behind blockers, against sums and differences of exact factors of rectangles and those of
//! spheres, and the balance of closed rooms with boxes in them.

use std::collections::HashMap;

use proptest::prelude::*;
use radiosity::Work;
use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::kernel::{Accuracy, PlacedBlock, polygon_exchange};
use radiosity::scene::Scene;
use radiosity::solve::view_factors::{Options, ViewFactors};
use radiosity::transport;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::factors_of;

use crate::light::shapes::{Quad, level, quad, room, upright};

pub(crate) fn factors(quads: &[Quad], hiding: Shadows, eps: f64) -> ViewFactors {
    let mut text = String::new();
    for (name, vertices) in quads {
        text += &format!("[[surfaces]]\nname = {name:?}\nquad = {{ vertices = {vertices:?} }}\n");
    }
    let scene = typed(&text);
    factors_of(&scene, hiding, eps, 3e-3)
}

/// ∫∫κ of two quads with nothing between.
fn exchange(a: &Quad, b: &Quad) -> f64 {
    let corners = |quad: &Quad| quad.1.map(DVec3::from_array);
    polygon_exchange(&corners(a), &corners(b))
}

/// Scenes whose first two surfaces have a factor that is a sum of exact ones: name, scene, A₀F₀₁.
fn cases() -> Vec<(&'static str, Vec<Quad>, f64)> {
    let (unit, low, high) = ([0.0, 1.0], [0.0, 0.5], [0.5, 1.0]);
    let floor = level("floor", unit, unit, 0.0, true);
    let lamp = level("lamp", unit, unit, 1.0, false);
    let part = |x, y, z, up| level("part", x, y, z, up);
    let half = exchange(&floor, &part(high, unit, 1.0, false));
    let wall = |name: &str, x: f64| quad(name, [[x, 0., 0.], [x, 1., 0.], [x, 1., 1.], [x, 0., 1.]]);
    let halves = exchange(&part(low, unit, 0.0, true), &part(low, unit, 1.0, false)) * 2.0;
    // A frame flush before the lamp leaves a window of it; its sides overlap in projection, as plates do.
    let frame = [([0.0, 0.3], unit), ([0.7, 1.0], unit), (unit, [0.0, 0.2]), (unit, [0.6, 1.0])];
    let door: Vec<Quad> = frame
        .iter()
        .enumerate()
        .map(|(k, (x, y))| level(&format!("frame-{k}"), *x, *y, 1.0 - 3e-8 * (k + 1) as f64, false))
        .collect();
    let window = exchange(&floor, &part([0.3, 0.7], [0.2, 0.6], 1.0, false));
    let front = quad("front", [[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]]);
    let upper = quad("upper", [[0., 0., 0.5], [0., 1., 0.5], [0., 1., 1.], [0., 0., 1.]]);
    let apart = level("apart", [0.0, 2.0], unit, 0.0, true);
    let thick = [wall("thick-0", 0.4), {
        let mut other = wall("thick-1", 0.6);
        other.1.reverse();
        other
    }];
    let chamber = |x| exchange(&part(x, unit, 0.0, true), &part(x, unit, 1.0, false));
    let chambers = [[0.0, 0.4], [0.4, 0.6], [0.6, 1.0]].into_iter().map(chamber).sum();
    vec![
        (
            "plate flush before half the emitter",
            vec![floor.clone(), lamp.clone(), level("plate", low, unit, 1.0 - 1e-7, false)],
            half,
        ),
        (
            "plate flush before half the receiver",
            vec![lamp.clone(), floor.clone(), level("plate", low, unit, 1e-7, true)],
            exchange(&lamp, &part(high, unit, 0.0, true)),
        ),
        ("wall from floor to lamp", vec![floor.clone(), lamp.clone(), wall("wall", 0.5)], halves),
        ("two walls", [vec![floor.clone(), lamp.clone()], thick.to_vec()].concat(), chambers),
        ("doorway of four overlapping plates", [vec![floor.clone(), lamp.clone()], door].concat(), window),
        (
            "lower half of a wall behind a board",
            vec![
                apart.clone(),
                front,
                quad("board", [[1e-7, 0., 0.], [1e-7, 1., 0.], [1e-7, 1., 0.5], [1e-7, 0., 0.5]]),
            ],
            exchange(&apart, &upper),
        ),
        ("plate that hides all", vec![floor, lamp, level("plate", [-0.5, 1.5], [-0.5, 1.5], 0.5, true)], 0.0),
    ]
}

#[test]
fn exact_shadows_leave_the_exact_factors() {
    for (name, quads, exact) in cases() {
        let found = factors(&quads, Shadows::Exact, 1e-6);
        let (own, other) = (found.factor(0, 1) * found.areas[0], found.factor(1, 0) * found.areas[1]);
        assert!(
            (own - exact).abs() <= 1e-6 && (own - other).abs() < 1e-15,
            "{name}: {own} instead of {exact}"
        );
    }
}

#[test]
fn shadows_at_defaults_leave_them_to_three_digits() {
    for (name, quads, exact) in cases() {
        for hiding in [Shadows::Rays, Shadows::Auto] {
            let found = factors(&quads, hiding, 1e-3);
            let own = found.factor(0, 1) * found.areas[0];
            assert!((own - exact).abs() <= 1e-3, "{name}, {hiding:?}: {own} instead of {exact}");
        }
    }
}

/// In a sphere about another the inner one sees all of the outer, which sees itself past the inner one:
/// F₀₁ = 1, F₁₀ = r²/R², F₁₁ = 1 − r²/R².
#[test]
fn a_ball_in_a_sphere_hides_a_part_of_it() {
    let text = "[[surfaces]]\nsphere = { center = [0, 0, 0], radius = 0.5 }
                [[surfaces]]\nflip = true\nsphere = { center = [0, 0, 0], radius = 1 }";
    let scene = typed(text);
    for (hiding, eps, shadow_eps) in [(Shadows::Rays, 1e-3, 3e-3), (Shadows::Auto, 1e-6, 1e-5)] {
        let most = if hiding == Shadows::Rays { 1e-3 } else { shadow_eps };
        let accuracy = Accuracy { eps, shadow_eps };
        let options = Options { accuracy, shadows: hiding, threads: 2, ..Options::default() };
        let found = ViewFactors::new(&scene, &options, &Work::alone()).expect("both have area");
        for (i, j, exact) in [(0, 0, 0.0), (0, 1, 1.0), (1, 0, 0.25), (1, 1, 0.75)] {
            let own = found.factor(i, j);
            assert!((own - exact).abs() <= most, "{hiding:?} {i} {j}: {own} instead of {exact}");
        }
    }
}

/// Row sums less 1 of all surfaces, the largest in size.
pub(crate) fn closure(found: &ViewFactors) -> f64 {
    found.row_sums().iter().map(|sum| (sum - 1.0).abs()).fold(0.0, f64::max)
}

/// Closed rooms: with a box on the floor, one that hovers a hair above it, a thin wall, and a lamp close
/// above a table.
#[test]
fn closed_rooms_keep_all_light() {
    let base = [[0.9, 0.8], [2.1, 1.2], [1.7, 2.4], [0.5, 2.0]];
    let square = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]];
    let wall = vec![
        quad("wall", [[2., 0., 0.], [2., 2.5, 0.], [2., 2.5, 3.], [2., 0., 3.]]),
        quad("wall:back", [[2., 0., 0.], [2., 0., 3.], [2., 2.5, 3.], [2., 2.5, 0.]]),
    ];
    let table = vec![
        level("table", [1.0, 3.0], [1.0, 3.0], 1.0, true),
        level("table:back", [1.0, 3.0], [1.0, 3.0], 1.0, false),
        level("lamp", [1.5, 2.0], [1.5, 2.0], 1.001, false),
        level("lamp:back", [1.5, 2.0], [1.5, 2.0], 1.001, true),
    ];
    let contents = [
        ("box", upright("box", base, [0.0, 1.1])),
        ("square box", upright("box", square, [0.0, 2.0])),
        ("hovering box", upright("box", base, [1e-3, 1.1])),
        ("thin wall", wall),
        ("lamp on a table", table),
    ];
    for (name, content) in contents {
        let quads = [room([4.0, 3.5, 3.0]), content].concat();
        let usual = closure(&factors(&quads, Shadows::Auto, 1e-3));
        assert!(usual <= 1e-3, "{name}: {usual:e}");
    }
    let exact = closure(&factors(
        &[room([4.0, 3.5, 3.0]), upright("box", base, [0.0, 1.1])].concat(),
        Shadows::Exact,
        1e-7,
    ));
    assert!(exact <= 1e-5, "{exact:e}");
}

/// A closed room of which one wall is bent, as those of measured rooms are, with boxes before it.
#[test]
fn a_bent_wall_keeps_all_light() {
    let ([a, b, c], d) = ([4.0, 3.5, 3.0], 3.98);
    let mut quads = room([a, b, c]);
    let corners = [
        ("floor", [[0., 0., 0.], [a, 0., 0.], [d, b, 0.], [0., b, 0.]]),
        ("x1", [[a, 0., 0.], [a, 0., c], [a, b, c], [d, b, 0.]]),
        ("y1", [[0., b, 0.], [d, b, 0.], [a, b, c], [0., b, c]]),
    ];
    for (name, corners) in corners {
        quads.iter_mut().filter(|quad| quad.0 == name).for_each(|quad| quad.1 = corners);
    }
    let base = [[0.9, 0.8], [2.1, 1.2], [1.7, 2.4], [0.5, 2.0]];
    let before = [[2.5, 1.5], [3.5, 1.7], [3.4, 3.0], [2.2, 2.5]];
    for content in [Vec::new(), upright("box", base, [0.0, 1.1]), upright("box", before, [0.3, 2.0])] {
        let found = closure(&factors(&[quads.clone(), content].concat(), Shadows::Auto, 1e-3));
        assert!(found <= 1e-3, "{found:e}");
    }
}

/// A lamp flush in a ceiling, and one a hair below it, let no light past them.
#[test]
fn flush_lamps_leak_nothing() {
    let mut flush = room([4.0, 3.5, 3.0]);
    flush.remove(1);
    let pane = |name: &str, x, y| level(name, x, y, 3.0, false);
    flush.extend([
        pane("lamp", [1.5, 2.5], [1.0, 2.0]),
        pane("south", [0.0, 4.0], [0.0, 1.0]),
        pane("north", [0.0, 4.0], [2.0, 3.5]),
        pane("west", [0.0, 1.5], [1.0, 2.0]),
        pane("east", [2.5, 4.0], [1.0, 2.0]),
    ]);
    let below = [
        level("lamp", [1.5, 2.5], [1.0, 2.0], 2.999, false),
        level("lamp:back", [1.5, 2.5], [1.0, 2.0], 2.999, true),
    ];
    let hung = [room([4.0, 3.5, 3.0]), below.to_vec()].concat();
    for (name, quads) in [("flush", flush), ("hung", hung)] {
        let chest = upright("box", [[0.9, 0.8], [2.1, 1.2], [1.7, 2.4], [0.5, 2.0]], [0.0, 1.1]);
        let found = closure(&factors(&[quads, chest].concat(), Shadows::Auto, 1e-3));
        assert!(found <= 1e-3, "{name}: {found:e}");
    }
}

/// Two boxes on a floor: face to face without the faces that touch, a hair apart, and edge to edge.
#[test]
fn nothing_leaks_between_touching_boxes() {
    let square = |x: f64, y: f64| [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
    let pair =
        |base| [upright("low", square(1.0, 1.0), [0.0, 1.0]), upright("high", base, [0.0, 1.5])].concat();
    let mut joined = pair(square(2.0, 1.0));
    joined.retain(|(name, _)| name != "low-side-1" && name != "high-side-3");
    joined.push(quad("step", [[2., 2., 1.], [2., 1., 1.], [2., 1., 1.5], [2., 2., 1.5]]));
    for (name, boxes) in
        [("joined", joined), ("apart", pair(square(2.0 + 1e-3, 1.0))), ("edge", pair(square(2.0, 2.0)))]
    {
        let quads = [room([4.0, 3.5, 3.0]), boxes].concat();
        for (hiding, eps, most) in [(Shadows::Auto, 1e-3, 1e-3), (Shadows::Exact, 1e-4, 1e-3)] {
            let found = closure(&factors(&quads, hiding, eps));
            assert!(found <= most, "{name}, {hiding:?}: {found:e}");
        }
    }
}

/// Errors of the blocks of `scene` at the usual accuracy against those at `finest`, relative to the largest
/// entry of the row, the largest.
fn largest_error(scene: &Scene, order: usize, finest: f64) -> f64 {
    let how = Discretization {
        subdivide: Subdivide::Auto { occluded: true, near_layers: false },
        ..Discretization::uniform(order, 1)
    };
    let elements = Elements::new(scene, &how).expect("all have area");
    let blocks = |accuracy: Accuracy| {
        let visibility = Visibility::new(scene, Shadows::Auto, accuracy.shadow_eps);
        transport::assemble(transport::Demand::all(&elements, &visibility, accuracy), None, &Work::alone())
    };
    let usual = blocks(Accuracy { eps: 1e-3, shadow_eps: 3e-3 });
    let exact = blocks(Accuracy { eps: finest, shadow_eps: finest });
    let usual: HashMap<(usize, usize), std::borrow::Cow<'_, [f64]>> =
        usual.iter().map(|block| ((block.row, block.column), block.values)).collect();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.map(f64::abs).fold(0.0, f64::max);
    let mut rows = vec![0.0f64; elements.list().len()];
    for PlacedBlock { row, column, values } in exact.iter() {
        for k in [row, column] {
            rows[k] = rows[k].max(largest(&mut values.iter().copied()));
        }
    }
    let error = |PlacedBlock { row: i, column: j, values }: PlacedBlock<'_>| {
        let found = &usual[&(i, j)];
        largest(&mut values.iter().zip(found.iter()).map(|(a, b)| a - b)) / rows[i].min(rows[j])
    };
    exact.iter().map(error).fold(0.0, f64::max)
}

#[test]
fn blocks_of_any_order_keep_the_accuracy_of_shadows() {
    for order in [0, 2] {
        let scene = builtin("occluder-box");
        let error = largest_error(&scene, order, 1e-4);
        assert!(error <= 3e-3, "order {order}: {error:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// Rays find what outlines find, behind a plate that hovers anywhere, in any turn.
    #[test]
    fn rays_and_outlines_agree(
        at in (0.1..0.9, 0.1..0.9, 0.25..0.75),
        sides in prop::array::uniform2((-0.4..0.4, -0.4..0.4, -0.15..0.15)),
    ) {
        let at = DVec3::from(at);
        let [a, b] = sides.map(DVec3::from);
        prop_assume!(a.cross(b).length() > 1e-3);
        let plate = [at - a - b, at + a - b, at + a + b, at - a + b].map(|x| x.to_array());
        let unit = [0.0, 1.0];
        let quads = vec![
            level("floor", unit, unit, 0.0, true),
            level("lamp", unit, unit, 1.0, false),
            quad("plate", plate),
        ];
        let exact = factors(&quads, Shadows::Exact, 1e-5).factor(0, 1);
        let found = factors(&quads, Shadows::Rays, 1e-3).factor(0, 1);
        prop_assert!((found - exact).abs() <= 1e-3, "{found} instead of {exact}");
    }

    /// A box anywhere in a room takes light away and adds none, and what it takes it receives.
    #[test]
    fn blockers_only_take(
        at in (1.2..2.3, 1.2..2.3), sides in (0.1..0.8, 0.1..0.8), turn in 0.0..1.5f64,
        low in prop_oneof![Just(0.0), 1e-3..1.0], height in 0.2..1.5,
    ) {
        let (sin, cos) = turn.sin_cos();
        let corner = |[x, y]: [f64; 2]| {
            let (x, y) = (x * sides.0, y * sides.1);
            [at.0 + cos * x - sin * y, at.1 + sin * x + cos * y]
        };
        let base = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner);
        let quads = [room([4.0, 3.5, 3.0]), upright("box", base, [low, low + height])].concat();
        let found = factors(&quads, Shadows::Auto, 1e-3);
        let free = factors(&quads, Shadows::Off, 1e-3);
        for i in 0..quads.len() {
            let sum: f64 = found.row(i).iter().sum();
            prop_assert!((sum - 1.0).abs() <= 5e-3, "row {i}: {sum}");
            for j in 0..quads.len() {
                let (f, most) = (found.factor(i, j), free.factor(i, j));
                prop_assert!((0.0..=1.0).contains(&f) && f <= most + 1e-12, "{i} {j}: {f} of {most}");
            }
        }
    }
}

/// A wall whose upper edge alone is seen, behind a plate: rough sums pass by all that is seen.
#[test]
fn pairs_that_hardly_see_each_other_end() {
    let quads = [
        level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true),
        quad("wall", [[2., 0., -0.95], [2., 0., 0.05], [2., 1., 0.05], [2., 1., -0.95]]),
        quad("plate", [[1.5, 0.3, 0.0], [1.5, 0.3, 0.02], [1.5, 0.7, 0.02], [1.5, 0.7, 0.0]]),
    ];
    let free = exchange(&quads[0], &quads[1]);
    let found = |hiding, eps| factors(&quads, hiding, eps).factor(0, 1);
    let (usual, fine) = (found(Shadows::Auto, 1e-3), found(Shadows::Exact, 1e-7));
    assert!(0.5 * free < fine && fine < free, "{free:e} {fine:e}");
    assert!((usual - fine).abs() < 3e-6, "{usual:e} {fine:e}");
}
