//! Two opposed plates of one temperature (Sparrow 1960) against integral equations in one variable.

use std::f64::consts::TAU;

use radiosity::Work;
use radiosity::geom::DVec3;
use radiosity::geom::shapes::{Disk, Parallelogram};
use radiosity::scene::{Material, Scene, SceneBuilder};
use radiosity::solve::solved::Solved;
use radiosity::solve::{Direct, Options, Transport};
use radiosity_test_support::opposed::{Opposed, Plates};

const REFLECTANCE: f64 = 0.9;

/// Strips from −1000 to 1000 widths in pieces that grow away from the middle one, `read`.
fn strips(distance: f64) -> Scene {
    let mut scene = SceneBuilder::new("strips", ["grey"]);
    let grey = Material::new(vec![REFLECTANCE], vec![1.0]).expect("0.9 is a reflectance");
    let grey = scene.material("grey", grey);
    let ends = [-1000.0, -30.0, -4.0, 4.0, 30.0, 1000.0];
    for (k, ends) in ends.windows(2).enumerate() {
        let (along, corner) = ((ends[1] - ends[0]) * DVec3::X, DVec3::new(ends[0], -0.5, 0.0));
        let name = if k == 2 { "read".to_owned() } else { format!("lower {k}") };
        let lower = Parallelogram::new(corner, along, DVec3::Y).expect("it has area");
        let upper = Parallelogram::new(corner + distance * DVec3::Z, DVec3::Y, along).expect("it has area");
        scene.surface(name, lower, &grey);
        scene.surface(format!("upper {k}"), upper, &grey);
    }
    scene.build().expect("plates are a scene")
}

fn disks(distance: f64) -> Scene {
    let mut scene = SceneBuilder::new("disks", ["grey"]);
    let grey = Material::new(vec![REFLECTANCE], vec![1.0]).expect("0.9 is a reflectance");
    let grey = scene.material("grey", grey);
    for (name, height, normal) in [("read", 0.0, DVec3::Z), ("other", distance, -DVec3::Z)] {
        let disk = Disk::new(height * DVec3::Z, normal, 1.0, 0.0, [0.0, TAU]).expect("it has area");
        scene.surface(name, disk, &grey);
    }
    scene.build().expect("disks are a scene")
}

/// Mean relative error of the radiosity across a strip, or along a radius.
fn error(scene: &Scene, truth: &Opposed, order: usize, place: impl Fn(f64) -> ([f64; 2], f64)) -> f64 {
    let options = Options {
        order,
        subdivide: Some(1),
        eps: 1e-6,
        transport: Transport::Exact,
        direct: Direct::Projected,
        ..Options::default()
    };
    let solved = Solved::new(scene.clone(), options, &Work::alone()).expect("plates can be solved");
    let read = scene.surface_named("read").expect("it is there");
    let missed = |k: usize| {
        let (parameters, x) = place((k as f64 + 0.5) / 50.0);
        let found = solved.radiosity_at(read, parameters).expect("plates have no holes")[0];
        (found / truth.radiosity(x) - 1.0).abs()
    };
    (0..50).map(missed).sum::<f64>() / 50.0
}

/// At a small reflectance the light that arrives is that of exitance 1: view factors of a point to a strip and
/// to a disk.
#[test]
fn integral_equations_have_known_first_bounces() {
    let reflectance = 1e-9;
    for distance in [0.1f64, 0.5, 2.0] {
        let [strips, disks] =
            [Plates::Strips, Plates::Disks].map(|plates| Opposed::new(plates, distance, reflectance));
        let arrived = |plates: &Opposed, x: f64| (plates.radiosity(x) - 1.0) / reflectance;
        for x in [0.0f64, 0.3, 0.5] {
            let sine = |y: f64| y / y.hypot(distance);
            let exact = 0.5 * (sine(0.5 - x) + sine(0.5 + x));
            assert!((arrived(&strips, x) - exact).abs() < 1e-6, "strips at {distance}, {x}");
        }
        // The factor from a point over a disk: ½ (1 − (h² + x² − 1) / √((h² + x² + 1)² − 4 x²)).
        for x in [0.0f64, 0.5, 1.0] {
            let sum = distance * distance + x * x;
            let exact = 0.5 * (1.0 - (sum - 1.0) / ((sum + 1.0).powi(2) - 4.0 * x * x).sqrt());
            assert!((arrived(&disks, x) - exact).abs() < 1e-6, "disks at {distance}, {x}");
        }
    }
}

/// Order 4 gives under 1 %, as Zatz (1993, 6.1) found, and higher orders converge.
#[test]
fn whole_plates_need_few_polynomials() {
    for (distance, wanted) in [(0.1, [1e-2, 1e-3]), (0.5, [1e-3, 1e-5]), (1.0, [1e-4, 1e-6])] {
        let (scene, truth) = (strips(distance), Opposed::new(Plates::Strips, distance, REFLECTANCE));
        for (order, wanted) in [4, 8].into_iter().zip(wanted) {
            let error = error(&scene, &truth, order, |x| ([0.0, 2.0 * x - 1.0], x - 0.5));
            assert!(error < wanted, "strips at {distance}, order {order}: {error:e}");
        }
    }
    for (distance, wanted) in [(0.5, [1e-3, 1e-5]), (1.0, [1e-4, 1e-6])] {
        let (scene, truth) = (disks(distance), Opposed::new(Plates::Disks, distance, REFLECTANCE));
        for (order, wanted) in [4, 8].into_iter().zip(wanted) {
            // r falls from the rim, v = −1, to the centre, v = 1.
            let error = error(&scene, &truth, order, |x| ([0.2, 1.0 - 2.0 * x], x));
            assert!(error < wanted, "disks at {distance}, order {order}: {error:e}");
        }
    }
}
