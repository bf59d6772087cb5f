//! Cost of whole scenes, of solvers in a room, of shadows by the way they are found, and of a picture by the
//! way it is read. All on one thread, so that the ratios hold on any machine.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use radiosity::Work;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::scene::{Camera, Scene};
use radiosity::solve::{Options, in_threads};
use radiosity::visibility::Shadows;
use radiosity_solvers::method::Method;
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::outcome_of;

fn on_one_thread() -> Options {
    Options { threads: 1, ..Options::default() }
}

fn solve_again(criterion: &mut Criterion, name: &str, scene: &Scene, options: &Options) {
    criterion.bench_function(name, |bench| {
        bench.iter(|| outcome_of(black_box(scene), options));
    });
}

/// Time from the scene in memory to its coefficients, at the defaults.
fn whole_scenes(criterion: &mut Criterion) {
    for name in ["furnace-cube", "furnace-sphere", "empty-box", "occluder-box", "two-boxes"] {
        solve_again(criterion, &format!("whole scene {name}"), &builtin(name), &on_one_thread());
    }
}

/// The empty box at order 6 on 54 elements: 1512 unknowns by each solver, the blocks included.
fn solvers(criterion: &mut Criterion) {
    let scene = builtin("empty-box");
    for name in ["cholesky", "cg", "gauss-seidel", "southwell"] {
        let method = Method::named(name).expect("it is listed");
        let options = Options { order: 6, subdivide: Some(3), solver: method, ..on_one_thread() };
        solve_again(criterion, &format!("solver {name}"), &scene, &options);
    }
}

/// The room with two boxes, by each way to find shadows.
fn shadows(criterion: &mut Criterion) {
    let scene = builtin("two-boxes");
    let ways = [
        ("off", Shadows::Off),
        ("outlines", Shadows::Auto),
        ("exact", Shadows::Exact),
        ("rays", Shadows::Rays),
    ];
    for (name, shadows) in ways {
        let options = Options { order: 2, subdivide: Some(1), shadows, ..on_one_thread() };
        solve_again(criterion, &format!("shadows {name}"), &scene, &options);
    }
}

/// 64 × 48 pixels of the box with a panel, one ray each.
fn pictures(criterion: &mut Criterion) {
    let scene = builtin("occluder-box");
    let options = on_one_thread();
    let outcome = outcome_of(&scene, &options);
    let visibility = options.visibility(&scene);
    let camera = scene.camera.clone().expect("the scene has a camera");
    let camera = Camera { width: 64, height: 48, ..camera };
    for (name, read) in
        [("basis", ReadMode::Basis), ("direct", ReadMode::Direct), ("gather", ReadMode::Gather)]
    {
        let picture = || {
            PictureRequest {
                solution: &outcome.solution,
                visibility: &visibility,
                camera: &camera,
                samples: 1,
                read,
                shown: Quantity::Radiosity,
                is_preview: false,
            }
            .picture(&Work::alone())
        };
        criterion.bench_function(&format!("picture read by {name}"), |bench| {
            bench.iter(|| in_threads(1, || black_box(picture())).expect("a thread can be started"));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = whole_scenes, solvers, shadows, pictures
}
criterion_main!(benches);
