//! Orders to 20 and thin rooms: the constant must be kept, c = G c, whatever the order.

use radiosity::kernel::{Accuracy, PlacedBlock};
use radiosity::scene::Scene;
use radiosity::visibility::Visibility;

use crate::row::Row;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::{blocks_of, elements_of};
use radiosity_test_support::walls::walls;

/// A closed box of some size, seen from inside.
fn room(sides: [f64; 3]) -> Scene {
    let faces = walls(sides).map(|wall| format!("[[surfaces]]\n{wall}"));
    typed(&format!("bands = [\"grey\"]\n{}", faces.concat()))
}

/// Largest |c − G c| in multiples of what the blocks of its row may miss.
fn opening(scene: &Scene, order: usize, eps: f64) -> f64 {
    let elements = elements_of(scene, order, 1);
    let visibility = Visibility::open(scene);
    let blocks = blocks_of(&elements, &visibility, Accuracy { eps, shadow_eps: eps });
    let (ones, list) = (elements.constant(), elements.list());
    let mapped = blocks.apply(&ones);
    let row = |i: usize| {
        let allowed: f64 = blocks
            .iter()
            .filter(|block| block.row == i || block.column == i)
            .map(|PlacedBlock { row: a, column: b, values }| {
                let top = values.iter().fold(0.0f64, |top, x| top.max(x.abs()));
                (eps * top.max(1e-2) + 1e-13) * list[if a == i { b } else { a }].area.sqrt()
            })
            .sum();
        let range = blocks.starts()[i]..blocks.starts()[i + 1];
        range.map(|k| (ones[k] - mapped[k]).abs() / allowed).fold(0.0, f64::max)
    };
    (0..list.len()).map(row).fold(0.0, f64::max)
}

fn cube(orders: impl Iterator<Item = usize>, accuracies: &[f64]) {
    let row = Row::new(
        "closure of the cube, c = G c",
        "orders to 20, eps 1e-4 to 1e-12",
        1.0,
        "of what blocks may miss",
    );
    let scene = room([1.0; 3]);
    for order in orders {
        for eps in accuracies {
            row.add(opening(&scene, order, *eps), || format!("order {order}, eps {eps:e}"));
        }
    }
}

fn thin(count: usize, order: usize) {
    let row = Row::new(
        "closure of thin boxes and shafts",
        format!("sides to 1 : 1e4, orders to {order}"),
        1.0,
        "of what blocks may miss",
    );
    let mut random = Random(5);
    for _ in 0..count {
        let sides = [1.0, random.power(-4.0, 0.0), random.power(-4.0, 0.0)];
        let (order, eps) =
            ((random.between(0.0, order as f64 + 1.0)) as usize, random.pick(&[1e-3, 1e-6, 1e-9]));
        row.add(opening(&room(sides), order, eps), || format!("{sides:?}, order {order}, eps {eps:e}"));
    }
}

#[test]
fn orders_keep_the_constant() {
    cube([0, 1, 7].into_iter(), &[1e-4, 1e-12]);
    thin(6, 3);
}

#[test]
#[ignore = "orders to 20 take half a minute"]
fn orders_keep_the_constant_to_twenty() {
    cube(0..=20, &[1e-4, 1e-8, 1e-12]);
    thin(100, 6);
}
