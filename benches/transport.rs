//! Cost of the transfer between elements, and of whole scenes.

use criterion::{Criterion, criterion_group, criterion_main};
use radiosity::elements::cells::Layers;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::kernel::Accuracy;
use radiosity::solve::Options;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::{blocks_of, outcome_of};

/// Blocks of the empty box, six elements: edge and face pairs, no shadows.
fn blocks_of_the_empty_box(criterion: &mut Criterion) {
    let scene = builtin("empty-box");
    let visibility = Visibility::open(&scene);
    for (order, eps) in [(4, 1e-2), (4, 1e-4), (8, 1e-2), (8, 1e-4)] {
        let how = Discretization {
            order,
            space: Space::Total,
            subdivide: Subdivide::Uniform(1),
            layers: Layers::NONE,
        };
        let elements = Elements::new(&scene, &how).expect("a box has area");
        let accuracy = Accuracy { eps, shadow_eps: 3e-3 };
        criterion.bench_function(&format!("blocks of the empty box, order {order}, eps {eps:e}"), |bench| {
            bench.iter(|| blocks_of(&elements, &visibility, accuracy));
        });
    }
}

/// The Cornell box at the defaults, one thread, with and without shadows: their ratio is the price of
/// visibility.
fn cornell_box(criterion: &mut Criterion) {
    let scene = builtin("cornell-box");
    for shadows in [Shadows::Off, Shadows::Auto] {
        let options = Options { shadows, threads: 1, ..Options::default() };
        let name = format!(
            "solve the Cornell box, {} shadows",
            if shadows == Shadows::Off { "without" } else { "with" }
        );
        criterion.bench_function(&name, |bench| {
            bench.iter(|| outcome_of(&scene, &options));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = blocks_of_the_empty_box, cornell_box
}
criterion_main!(benches);
