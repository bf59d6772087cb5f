//! The scenes of the folder `shared` beside the repository, where it is there; see what is printed with
//! --nocapture.

use std::path::{Path, PathBuf};
use std::time::Instant;

use radiosity::scene::Scene;
use radiosity::solve::view_factors::ViewFactors;
use radiosity_test_support::solved::usual_factors as factors;

/// The scene's path, if the folder is there.
fn path(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/scenes/rounded").join(name);
    let found = path.exists().then_some(path);
    if found.is_none() {
        println!("skipped: {name} is not beside the repository");
    }
    found
}

fn load(name: &str) -> Option<(Scene, ViewFactors)> {
    let path = path(name)?;
    let scene = radiosity::load(path.to_str().expect("a path in Unicode")).expect("a scene");
    let start = Instant::now();
    let found = factors(&scene);
    println!("{name:24} {:.2} s, {:?}", start.elapsed().as_secs_f64(), scene.fitted.line());
    Some((scene, found))
}

#[test]
fn closed_rooms_are_closed() {
    let rooms = ["cube-1e-7", "f32-room", "f32-L", "box-gap-1e-6", "nobot-gap-1e-7", "stairs-utm"];
    for name in rooms.map(|name| format!("{name}.json")) {
        let Some((_, found)) = load(&name) else { continue };
        let worst = found.row_sums().iter().map(|sum| (sum - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst < 3e-3, "{name}: {worst:e}");
    }
}

#[test]
fn a_part_of_stairs_far_from_the_origin_comes_to_an_end() {
    // Part of the stairs: what its surfaces exchange is less than all.
    let Some((_, found)) = load("hang-min.json") else { return };
    assert!(found.row_sums().iter().all(|sum| *sum < 1.0));
}

#[test]
fn tiny_things_see_huge_ones() {
    // The tiny square is a point before the huge one: Lambert's form, ½π Σ θ Γ·n, of the corners seen from
    // its middle.
    let Some((scene, found)) = load("tiny-on-huge.json") else { return };
    let [tiny, huge] = [0, 1].map(|k| scene.surfaces[k].shape.region().expect("a polygon"));
    let middle = tiny.outer().iter().sum::<radiosity_geom::DVec3>() / 4.0;
    let seen: Vec<_> = huge.outer().iter().map(|x| (*x - middle).normalize()).collect();
    let edges = seen.iter().zip(seen.iter().cycle().skip(1));
    let sum: f64 = edges.map(|(a, b)| a.angle_between(*b) * a.cross(*b).normalize().dot(tiny.normal())).sum();
    let exact = sum.abs() / std::f64::consts::TAU;
    // From corner to corner the direction of the huge square turns little: they lie 1e-9 of its size apart.
    assert!((found.factor(0, 1) - exact).abs() < 1e-3 * exact, "{} {exact}", found.factor(0, 1));
}

#[test]
fn a_far_sun_shines_as_its_angle_says() {
    let Some((scene, found)) = load("sun-disk-8.json") else { return };
    let index = |name: &str| scene.surface_named(name).expect("it is there");
    // sin² of half the angle it is seen under, 0.2666°.
    let exact = 0.2666f64.to_radians().sin().powi(2);
    let factor = found.factor(index("plate"), index("sun"));
    assert!((factor / exact - 1.0).abs() < 1e-4, "{factor} {exact}");
    // A plate of 1 hides the sun from a hundredth of the floor.
    let factor = found.factor(index("floor"), index("sun"));
    assert!((factor / (0.99 * exact) - 1.0).abs() < 1e-3, "{factor} {exact}");
}
