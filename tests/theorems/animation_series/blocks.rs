//! Blocks of moving elements against those of displaced scenes, and what has no series.

use radiosity::elements::Elements;
use radiosity::elements::space::Space;
use radiosity::geom::DVec3;
use radiosity::kernel::Accuracy;
use radiosity::published::series::{BlockSeries, MovingBlock, SeriesError, Settings, TranslatedPair};
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

fn pair(elements: &Elements, direction: DVec3) -> TranslatedPair<'_> {
    TranslatedPair::new(&elements.list()[0], &elements.list()[1], direction).expect("quads are flat")
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
    let exchanged = TranslatedPair::new(&elements.list()[1], &elements.list()[0], -direction);
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
    let none = TranslatedPair::new(&quads.list()[0], &quads.list()[1], DVec3::ZERO);
    assert_eq!(none.unwrap_err(), SeriesError::Direction);

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
    let told = TranslatedPair::new(&curved.list()[0], &curved.list()[1], DVec3::X).unwrap_err();
    assert_eq!(told, SeriesError::Curved { surface: 1 });

    let series = BlockSeries::new(&pair(&quads, DVec3::X), 0.0, settings).expect("they face each other");
    let told = series.at(5.0).unwrap_err();
    assert_eq!(told, SeriesError::Range { p: 5.0, range: series.range() });
    assert!(told.to_string().contains("expand it anew at p"));
}
