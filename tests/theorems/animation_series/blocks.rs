//! Blocks of moving elements against those of displaced scenes, and what has no series.

use proptest::prelude::*;
use radiosity::elements::Elements;
use radiosity::elements::space::Space;
use radiosity::geom::DVec3;
use radiosity::kernel::Accuracy;
use radiosity::published::series::{
    BlockSeries, MovedPair, MovingBlock, RelativeMotion, SeriesError, Settings,
};
use radiosity::visibility::Visibility;
use radiosity_test_support::compare::farthest;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::{blocks_of, elements_of};

use super::quads::{Quad, elements, scene};

const FLOOR: Quad =
    Quad { centre: DVec3::ZERO, along: DVec3::new(1.0, 0.2, 0.0), across: DVec3::new(0.0, 1.0, 0.0) };
const LAMP: Quad = Quad {
    centre: DVec3::new(0.3, 0.1, 1.5),
    along: DVec3::new(0.0, 0.3, 0.05),
    across: DVec3::new(0.4, 0.0, 0.0),
};
const WALL: Quad = Quad {
    centre: DVec3::new(1.4, 0.0, 1.0),
    along: DVec3::new(0.0, 0.0, 1.0),
    across: DVec3::new(0.0, 0.8, 0.0),
};

/// The block of the first two quads by the rules of whole scenes.
fn integrated(quads: &[Quad], space: Space, order: usize) -> Vec<f64> {
    let visibility = Visibility::open(&scene(quads));
    let accuracy = Accuracy { eps: 1e-11, shadow_eps: 1e-3 };
    let elements = elements(quads, space, order);
    let blocks = blocks_of(&elements, &visibility, accuracy);
    let [rows, columns] = [0, 1].map(|k| elements.list()[k].basis.len());
    let column = |l: usize| {
        let mut unit = vec![0.0; blocks.dim()];
        unit[rows + l] = 1.0;
        blocks.apply(&unit)
    };
    let table: Vec<Vec<f64>> = (0..columns).map(column).collect();
    (0..rows).flat_map(|k| table.iter().map(move |column| column[k])).collect()
}

fn pair(elements: &Elements, direction: DVec3) -> MovedPair<'_> {
    MovedPair::new(&elements.list()[0], &elements.list()[1], RelativeMotion::Translation(direction))
        .expect("quads are flat")
}

#[test]
fn blocks_are_those_of_the_displaced_scene() {
    let direction = DVec3::new(0.5, -0.4, -0.3);
    for (space, order) in [(Space::Total, 0), (Space::Total, 3), (Space::Tensor, 2)] {
        let elements = elements(&[FLOOR, LAMP], space, order);
        let mut block =
            MovingBlock::new(pair(&elements, direction), Settings { orders: 10, tolerance: 1e-6 });
        for step in 0..=20 {
            let p = 0.05 * f64::from(step);
            let found = block.at(p).expect("the lamp shines on the floor");
            let exact = integrated(&[FLOOR, LAMP.moved(p * direction)], space, order);
            let largest = exact.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            let error = farthest(&found.values, &exact);
            assert!(error <= found.error, "{space:?} {order}, at {p}: {error:e} > {:e}", found.error);
            assert!(found.error < 2e-6 * largest, "{space:?} {order}, at {p}: {:e}", found.error);
        }
        assert!((2..10).contains(&block.expansions()), "{} expansions", block.expansions());
    }
}

/// A hinge askew beside the lamp.
const HINGE: [DVec3; 2] = [DVec3::new(1.0, 0.4, 0.3), DVec3::new(0.2, -0.5, 1.2)];

fn turned_pair(elements: &Elements, [axis, centre]: [DVec3; 2]) -> MovedPair<'_> {
    let motion = RelativeMotion::Rotation { axis, centre };
    MovedPair::new(&elements.list()[0], &elements.list()[1], motion).expect("quads are flat")
}

#[test]
fn blocks_are_those_of_the_turned_scene() {
    let [axis, centre] = HINGE;
    for (space, order) in [(Space::Total, 0), (Space::Total, 3), (Space::Tensor, 2)] {
        let elements = elements(&[FLOOR, LAMP], space, order);
        let settings = Settings { orders: 10, tolerance: 1e-6 };
        let mut block = MovingBlock::new(turned_pair(&elements, HINGE), settings);
        for step in -10..=10 {
            let angle = 0.05 * f64::from(step);
            let found = block.at(angle).expect("the lamp shines on the floor");
            let exact = integrated(&[FLOOR, LAMP.turned(axis, centre, angle)], space, order);
            let largest = exact.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            let error = farthest(&found.values, &exact);
            assert!(error <= found.error, "{space:?} {order}, at {angle}: {error:e} > {:e}", found.error);
            assert!(found.error < 2e-6 * largest, "{space:?} {order}, at {angle}: {:e}", found.error);
        }
        assert!((2..10).contains(&block.expansions()), "{} expansions", block.expansions());
    }
}

/// A lamp that looks down swings about a line in its plane, beside it: its far side goes under the floor's
/// plane, or the floor's far side gets in front of it.
#[test]
fn a_series_ends_where_the_first_corner_of_what_turns_reaches_a_plane() {
    let level = Quad { along: DVec3::new(0.0, 0.3, 0.0), ..LAMP };
    let elements = elements(&[WALL, level], Space::Total, 1);
    // The wall is upright, at x = 1.4, and the lamp hangs from y = 0.1, z = 1.5 on an axis across the wall.
    let across = [DVec3::X, DVec3::new(0.0, 0.1, 1.5)];
    let settings = Settings { orders: 8, tolerance: 1e-4 };
    // It is level: what it sees of the wall changes, and comes to an edge.
    let told = BlockSeries::new(&turned_pair(&elements, across), 0.0, settings).unwrap_err();
    assert_eq!(told, SeriesError::Horizon { surfaces: [0, 1], at: 0.0 });
    // On an upright axis the lamp turns in its plane, which goes on cutting the wall in one line.
    let upright = [DVec3::Z, level.centre];
    let series = BlockSeries::new(&turned_pair(&elements, upright), 0.0, settings).expect("it stays");
    for angle in [-0.1, 0.05, 0.12] {
        let found = series.at(angle).expect("in the range");
        let turned = level.turned(DVec3::Z, level.centre, angle);
        let exact = integrated(&[WALL, turned], Space::Total, 1);
        assert!(farthest(&found.values, &exact) <= found.error, "at {angle}");
    }
}

/// A small lamp at the height 2 over the middle of a floor of 2 × 2 faces all of it until it has turned so far
/// that its plane meets a side: tan θ = (2 − 0.1 sin θ)/(1 + 0.1 − 0.1 cos θ) about the lamp's own side.
#[test]
fn the_range_of_a_rotation_ends_at_a_horizon() {
    let floor = Quad { along: DVec3::X, across: DVec3::Y, ..FLOOR };
    let lamp = Quad {
        centre: DVec3::new(0.0, 0.0, 2.0),
        along: DVec3::new(0.0, 0.1, 0.0),
        across: DVec3::new(0.1, 0.0, 0.0),
    };
    let elements = elements(&[floor, lamp], Space::Total, 0);
    let settings = Settings { orders: 8, tolerance: 0.5 };
    let limit = 2f64.atan();
    // About its middle: the plane through (0, 0, 2), turned by θ, meets x = 1, z = 0 at tan θ = 2.
    let pair = turned_pair(&elements, [DVec3::Y, lamp.centre]);
    let series = BlockSeries::new(&pair, limit - 0.1, settings).expect("all of the floor is before it");
    assert!((series.range().to - limit).abs() < 1e-12, "{:?} {limit}", series.range());
    let told = BlockSeries::new(&pair, limit + 0.1, settings).unwrap_err();
    assert_eq!(told, SeriesError::Horizon { surfaces: [0, 1], at: limit + 0.1 });
    // The other side of the floor is behind it as well from there on.
    let behind = std::f64::consts::PI - limit;
    let series = BlockSeries::new(&pair, behind + 0.1, settings).expect("nothing is before it");
    assert!((series.range().from - behind).abs() < 1e-12 && series.at(behind + 0.2).is_ok());
    assert!(series.sum(behind + 0.1).iter().all(|x| *x == 0.0));
}

/// The lamp looks down at a wall that reaches above it, and moves level: the part of the wall that it sees
/// stays.
#[test]
fn a_part_that_stays_is_cut_out() {
    let level = Quad { along: DVec3::new(0.0, 0.3, 0.0), ..LAMP };
    let elements = elements(&[WALL, level], Space::Total, 2);
    let direction = DVec3::new(-0.6, 0.8, 0.0);
    let series = BlockSeries::new(&pair(&elements, direction), 0.0, Settings { orders: 12, tolerance: 1e-7 });
    let series = series.expect("the part below the lamp stays");
    for p in [-0.1, 0.0, 0.05, 0.15] {
        let found = series.at(p).expect("in the range");
        let exact = integrated(&[WALL, level.moved(p * direction)], Space::Total, 2);
        assert!(farthest(&found.values, &exact) <= found.error, "at {p}");
    }
    let down = BlockSeries::new(&pair(&elements, DVec3::NEG_Z), 0.0, Settings { orders: 4, tolerance: 1e-4 });
    assert_eq!(down.unwrap_err(), SeriesError::Horizon { surfaces: [0, 1], at: 0.0 });
}

#[test]
fn the_error_falls_like_the_first_power_left_out() {
    let elements = elements(&[FLOOR, LAMP], Space::Total, 2);
    let direction = DVec3::new(0.6, 0.0, -0.8);
    for orders in [1, 2, 4, 6] {
        let series = |centre: f64, orders: usize| {
            let settings = Settings { orders, tolerance: 1e-15 };
            BlockSeries::new(&pair(&elements, direction), centre, settings).expect("they face each other")
        };
        let reference = series(0.0, orders);
        let error = |p: f64| {
            let missed = farthest(&reference.sum(p), &series(p, 0).terms()[0]);
            let bound = reference.remainder(p);
            assert!(missed <= bound && bound < 300.0 * missed, "{orders}, {p}: {missed:e}, {bound:e}");
            missed
        };
        let order = (error(0.1) / error(0.05)).log2();
        assert!((order - (orders + 1) as f64).abs() < 0.4, "order {order} of a series to {orders}");
    }
}

#[test]
fn exchanged_elements_have_the_transposed_block() {
    let elements = elements(&[FLOOR, LAMP], Space::Total, 2);
    let (direction, settings) = (DVec3::new(0.6, 0.0, -0.8), Settings { orders: 6, tolerance: 1e-5 });
    let there = BlockSeries::new(&pair(&elements, direction), 0.0, settings).expect("they face each other");
    let exchanged =
        MovedPair::new(&elements.list()[1], &elements.list()[0], RelativeMotion::Translation(-direction));
    let back = BlockSeries::new(&exchanged.expect("flat"), 0.0, settings).expect("they face each other");
    for (one, other) in there.terms().iter().zip(back.terms()) {
        let turned: Vec<f64> = (0..36).map(|k| other[k % 6 * 6 + k / 6]).collect();
        let largest = one.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        assert!(farthest(one, &turned) <= 1e-13 * largest);
    }
}

#[test]
fn what_has_no_series_is_told() {
    let quads = elements(&[FLOOR, LAMP], Space::Total, 1);
    let no_axis = RelativeMotion::Rotation { axis: DVec3::ZERO, centre: DVec3::X };
    for motion in [RelativeMotion::Translation(DVec3::ZERO), no_axis] {
        let none = MovedPair::new(&quads.list()[0], &quads.list()[1], motion);
        assert_eq!(none.unwrap_err(), SeriesError::Direction);
    }

    let useless = Settings { orders: 4, tolerance: 0.0 };
    let told = BlockSeries::new(&pair(&quads, DVec3::X), 0.0, useless).unwrap_err();
    assert_eq!(told, SeriesError::Tolerance { tolerance: 0.0 });

    let settings = Settings { orders: 4, tolerance: 1e-4 };
    let beside = Quad { centre: DVec3::new(1.0, 0.0, 1.0), ..WALL };
    let square = Quad { along: DVec3::X, ..FLOOR };
    let touching = elements(&[square, beside], Space::Total, 1);
    let told = BlockSeries::new(&pair(&touching, DVec3::X), 0.0, settings).unwrap_err();
    assert_eq!(told, SeriesError::Touching { surfaces: [0, 1], at: 0.0 });

    let ball = "bands = [\"grey\"]
[[surfaces]]
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
[[surfaces]]
sphere = { center = [0, 0, 3], radius = 1 }";
    let scene = typed(ball);
    let curved = elements_of(&scene, 1, 1);
    let told = MovedPair::new(&curved.list()[0], &curved.list()[1], RelativeMotion::Translation(DVec3::X))
        .unwrap_err();
    assert_eq!(told, SeriesError::Curved { surface: 1 });

    let series = BlockSeries::new(&pair(&quads, DVec3::X), 0.0, settings).expect("they face each other");
    let told = series.at(5.0).unwrap_err();
    assert_eq!(told, SeriesError::Range { p: 5.0, range: series.range() });
    assert!(told.to_string().contains("expand it anew at p"));
}

fn vector() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(DVec3::from_array)
}

/// A quad of edges from 0.4 to 1.6 about this centre.
fn quad(centre: DVec3) -> impl Strategy<Value = Quad> {
    (vector(), vector()).prop_filter_map("edges are not parallel", move |(a, b)| {
        let along = a.try_normalize()?;
        let across = b.reject_from_normalized(along).try_normalize()?;
        Some(Quad { centre, along: 0.2 * (1.0 + a.length()) * along, across: 0.5 * across })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn blocks_are_within_their_bound(
        receiver in quad(DVec3::ZERO),
        emitter in quad(DVec3::new(0.3, -0.2, 2.4)),
        axis in vector(),
        centre in vector(),
        turns: bool,
        orders in 0usize..12,
        share in -1.0..1.0,
    ) {
        prop_assume!(axis.length() > 0.1);
        let elements = elements(&[receiver, emitter], Space::Total, 1);
        let motion = match turns {
            true => RelativeMotion::Rotation { axis, centre },
            false => RelativeMotion::Translation(axis),
        };
        let [of_receiver, of_emitter] = elements.list() else { panic!("two quads are two elements") };
        let pair = MovedPair::new(of_receiver, of_emitter, motion).expect("quads are flat");
        let about = |centre, settings| BlockSeries::new(&pair, centre, settings);
        // Pairs of which one crosses the plane of the other have no series.
        let Ok(series) = about(0.0, Settings { orders, tolerance: 1e-3 }) else { return Ok(()) };
        let range = series.range();
        let end = if share < 0.0 { -range.from } else { range.to };
        let p = share * end.min(1.0);
        let found = series.at(p).expect("in the range");
        let exact = about(p, Settings { orders: 0, tolerance: 1e-13 }).expect("in the range");
        let error = farthest(&found.values, &exact.terms()[0]);
        prop_assert!(error <= found.error + 1e-15, "{error:e} {:e}", found.error);
    }
}
