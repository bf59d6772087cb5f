//! Cost of ten light groups in a solution, of dimming one of them then, and of a new reflectance. A closed
//! room of 1060 unknowns a band under ten lamps, three bands, on one thread.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use radiosity::geom::DVec3;
use radiosity::geom::shapes::Parallelogram;
use radiosity::solve::{Direct, Model, Options};
use radiosity::{Material, Scene, SceneBuilder, Work};
use radiosity_test_support::shapes::plate;
use radiosity_test_support::solved::{outcome_of, solved_of};

const LAMPS: usize = 10;

fn parallelogram(origin: [f64; 3], first: [f64; 3], second: [f64; 3]) -> Parallelogram {
    let [origin, first, second] = [origin, first, second].map(DVec3::from_array);
    plate(origin, first, second)
}

/// A unit cube whose walls have 4 × 4 elements, with lamps below its ceiling, each a group of its own if they
/// are `grouped`.
fn room(is_grouped: bool) -> Scene {
    let mut room = SceneBuilder::new("room", ["r", "g", "b"]);
    let material = |reflectance: f64, emission| Material::new(vec![reflectance; 3], emission);
    let wall = room.material("wall", material(0.5, vec![0.0; 3]).expect("it is valid"));
    let lamp = room.material("lamp", material(0.1, vec![10.0, 9.0, 7.0]).expect("it is valid"));
    let walls = [
        ("floor", parallelogram([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])),
        ("ceiling", parallelogram([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0])),
        ("west", parallelogram([0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])),
        ("east", parallelogram([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0])),
        ("south", parallelogram([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])),
        ("north", parallelogram([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])),
    ];
    for (name, shape) in walls {
        room.surface(name, shape, &wall).subdivide(4, 4);
    }
    for k in 0..LAMPS {
        let [x, y] = [0.1 + 0.17 * (k % 5) as f64, 0.3 + 0.3 * (k / 5) as f64];
        let shape = parallelogram([x, y, 0.9], [0.0, 0.1, 0.0], [0.1, 0.0, 0.0]);
        let surface = room.surface(format!("lamp {k}"), shape, &lamp).subdivide(1, 1);
        if is_grouped {
            surface.group(format!("lamp {k}"));
        }
    }
    room.build().expect("the room is valid")
}

fn options(direct: Direct) -> Options {
    Options { direct, threads: 1, ..Options::default() }
}

/// All work, without groups and with ten.
fn groups(criterion: &mut Criterion) {
    for (name, direct) in [("projected", Direct::Projected), ("split", Direct::Split)] {
        for (number, is_grouped) in [("no", false), ("ten", true)] {
            let scene = room(is_grouped);
            criterion.bench_function(&format!("groups {number}, {name}"), |bench| {
                bench.iter(|| outcome_of(black_box(&scene), &options(direct)));
            });
        }
    }
}

/// Time of dimming one of the ten lamps, self-checks included.
fn dimming(criterion: &mut Criterion) {
    let solved = solved_of(room(true), options(Direct::Projected));
    criterion.bench_function("dimming one of ten", |bench| {
        bench.iter(|| solved.relight(black_box(&[("lamp 3", 0.3)])).expect("it is a group"));
    });
}

/// Time of solving for another reflectance of all walls, from a model in memory, self-checks included.
fn reflectance(criterion: &mut Criterion) {
    for (name, direct) in [("projected", Direct::Projected), ("split", Direct::Split)] {
        let scene = room(false);
        let model = Model::assemble(&scene, &options(direct), &Work::alone()).expect("it has blocks");
        let white = Material::new(vec![0.7; 3], vec![0.0; 3]).expect("it is valid");
        let painted = scene.with_material("wall", white).expect("the walls have it");
        criterion.bench_function(&format!("reflectance, {name}"), |bench| {
            bench.iter(|| model.solve(black_box(&painted), &Work::alone()).expect("it is solved"));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = groups, dimming, reflectance
}
criterion_main!(benches);
