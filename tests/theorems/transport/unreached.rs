//! Pairs that no rule reaches go by rays: right against closed forms, with an error that is true.

use std::f64::consts::PI;

use radiosity::SceneBuilder;
use radiosity::geom::DVec3;
use radiosity::geom::shapes::{Cone, FULL_TURN, Sphere, Torus};
use radiosity::kernel::Accuracy;
use radiosity::scene::Scene;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_test_support::scenes::grey;
use radiosity_test_support::shapes::{ball, disk, plate, tube};
use radiosity_test_support::solved::{blocks_of, elements_of, factors_of};

fn scene(build: impl FnOnce(&mut SceneBuilder, &radiosity::scene::NamedMaterial)) -> Scene {
    let (mut builder, grey) = grey();
    build(&mut builder, &grey);
    builder.build().expect("the scene is valid")
}

/// Asks the factors for some accuracies; they keep to what is told, and what is told is not much more than is
/// asked.
fn check(name: &str, scene: &Scene, known: &[(usize, usize, f64)]) {
    for eps in [3e-3, 3e-4] {
        let found = factors_of(scene, Shadows::Auto, eps, eps);
        let told = found.left_in_blocks.max(eps);
        for (i, j, exact) in known {
            let largest = found.row(*i).into_iter().fold(0.0, f64::max);
            let error = (found.factor(*i, *j) - exact).abs() / largest;
            println!("{name}, {eps:.0e}: F({i}, {j}) is {error:.1e} of its row off, {told:.1e} are told");
            assert!(error <= 3.0 * told, "{name}: F({i}, {j}) = {}, not {exact}", found.factor(*i, *j));
        }
        assert!(told <= 10.0 * eps, "{name}: {told} is told where {eps} is asked");
    }
}

#[test]
fn a_ball_in_a_cube_that_touches_all_faces_shares_its_light_among_them() {
    let scene = scene(|builder, grey| {
        let [x, y, z] = [2.0 * DVec3::X, 2.0 * DVec3::Y, 2.0 * DVec3::Z];
        let corner = -DVec3::ONE;
        for (name, origin, a, b) in [
            ("floor", corner, x, y),
            ("ceiling", corner + z, y, x),
            ("front", corner, z, x),
            ("back", corner + y, x, z),
            ("left", corner, y, z),
            ("right", corner + x, z, y),
        ] {
            builder.surface(name, plate(origin, a, b), grey);
        }
        builder.surface("ball", ball(DVec3::ZERO, 1.0), grey);
    });
    // A face of 2 × 2 gets a sixth of what the ball of radius 1 sends.
    let known: Vec<_> = (0..6).flat_map(|face| [(6, face, 1.0 / 6.0), (face, 6, PI / 6.0)]).collect();
    check("ball in a cube", &scene, &known);
}

#[test]
fn spheres_that_nearly_touch_from_inside_see_each_other() {
    for radius in [0.9, 0.999] {
        let scene = scene(|builder, grey| {
            builder.surface("inner", ball(DVec3::ZERO, radius), grey);
            builder.surface("outer", ball(DVec3::ZERO, 1.0), grey).flip();
        });
        let square = radius * radius;
        check("spheres", &scene, &[(0, 1, 1.0), (1, 0, square), (1, 1, 1.0 - square)]);
    }
}

/// A hemisphere of radius r, open above, in a sphere of radius 1. Half of what its inside sends stays there, and all
/// that its outside sends arrives: the sphere sees the inside by r²/4, the outside by r²/2, and itself by the rest.
#[test]
fn a_sphere_sees_itself_past_a_bowl() {
    for radius in [0.5, 0.02] {
        let scene = scene(|builder, grey| {
            let bowl = Sphere::new(DVec3::ZERO, radius, DVec3::Z, [-radius, 0.0], FULL_TURN).expect("a bowl");
            builder.surface("bowl", bowl, grey).flip();
            builder.surface("room", ball(DVec3::ZERO, 1.0), grey).flip();
        });
        let square = radius * radius;
        let known = [(0, 0, 0.5), (0, 1, 0.5), (1, 0, 0.25 * square), (1, 1, 1.0 - 0.75 * square)];
        check("bowl", &scene, &known);
    }
}

/// Of the pairs of a small bowl and a large sphere the rays of the bowl tell nearly all: the sphere, in parts of
/// some thousand times its area, sends few, where the pairs of the bowl stay above what is asked.
#[test]
fn ends_that_tell_little_send_few_rays() {
    let scene = scene(|builder, grey| {
        let bowl = Sphere::new(DVec3::ZERO, 0.015, DVec3::Z, [-0.015, 0.0], FULL_TURN).expect("a bowl");
        builder.surface("bowl", bowl, grey).flip();
        builder.surface("room", ball(DVec3::ZERO, 1.0), grey).flip();
    });
    let visibility = Visibility::new(&scene, Shadows::Auto, 1e-4);
    let blocks = blocks_of(&elements_of(&scene, 2, 2), &visibility, Accuracy { eps: 1e-4, shadow_eps: 1e-4 });
    let [told, rays] = [blocks.statistics.accuracy_reached, blocks.statistics.rays as f64];
    println!("{told:.1e} by {rays:.1e} rays");
    // All eight elements alike would send 18 million: 8 million, as many as the accuracy of 1e-3 gets, grow by 10^0.35.
    assert!(rays < 0.6 * 18e6, "{rays:.1e} rays");
    assert!(told < 3e-3, "{told:.1e} is told");
}

#[test]
fn the_inside_of_a_torus_sees_itself_alone() {
    let scene = scene(|builder, grey| {
        let torus = Torus::new(DVec3::ZERO, DVec3::Z, 1.0, 0.3, FULL_TURN, FULL_TURN).expect("a torus");
        builder.surface("torus", torus, grey).flip();
    });
    check("torus", &scene, &[(0, 0, 1.0)]);
}

#[test]
fn long_cylinders_side_by_side_touch_along_a_line() {
    // Infinitely long F = (√(X² − 1) + asin(1/X) − X)/π, X = 1 + s/d; here s = 0 (Hottel's strings):
    // 1/2 − 1/π. Ends take about r/L of it.
    let (length, exact) = (2000.0, 0.5 - 1.0 / PI);
    let scene = scene(|builder, grey| {
        for (name, x) in [("left", -1.0), ("right", 1.0)] {
            let base = DVec3::new(x, 0.0, 0.0);
            let tube = tube(base, length * DVec3::Z, 1.0);
            builder.surface(name, tube, grey);
        }
    });
    check("cylinders", &scene, &[(0, 1, exact), (1, 0, exact)]);
}

/// Coaxial disks of radii a and b at the distance h: F = (X − √(X² − 4 (b/a)²))/2, X = 1 + (b² + h²)/a²
/// (Howell C-41).
fn coaxial(a: f64, b: f64, h: f64) -> f64 {
    let x = 1.0 + (b * b + h * h) / (a * a);
    0.5 * (x - (x * x - 4.0 * (b / a).powi(2)).sqrt())
}

#[test]
fn a_shallow_wall_meets_a_disk_along_its_rim() {
    let (a, b, h) = (1.0, 0.5, 0.05);
    let scene = scene(|builder, grey| {
        let disk = |z: f64, normal: DVec3, radius: f64| disk(z * DVec3::Z, normal, radius);
        builder.surface("base", disk(0.0, DVec3::Z, a), grey);
        let wall = Cone::new(DVec3::ZERO, h * DVec3::Z, a, b, FULL_TURN).expect("a frustum");
        builder.surface("wall", wall, grey).flip();
        builder.surface("top", disk(h, -DVec3::Z, b), grey);
    });
    let (to_top, slant) = (coaxial(a, b, h), (a + b) * (a - b).hypot(h));
    let (base_to_wall, top_to_wall) = (1.0 - to_top, 1.0 - to_top * (a / b).powi(2));
    let [wall_to_base, wall_to_top] = [base_to_wall * a * a / slant, top_to_wall * b * b / slant];
    let known = [
        (0, 1, base_to_wall),
        (0, 2, to_top),
        (2, 1, top_to_wall),
        (1, 0, wall_to_base),
        (1, 1, 1.0 - wall_to_base - wall_to_top),
    ];
    check("frustum", &scene, &known);
}

#[test]
fn a_closed_pipe_sees_past_a_ball() {
    let (radius, length, within) = (1.0, 4.0, 0.7);
    let scene = scene(|builder, grey| {
        let wall = tube(DVec3::ZERO, length * DVec3::Z, radius);
        builder.surface("wall", wall, grey).flip();
        for (name, z, normal) in [("floor", 0.0, DVec3::Z), ("top", length, -DVec3::Z)] {
            let disk = disk(z * DVec3::Z, normal, radius);
            builder.surface(name, disk, grey);
        }
        let center = 0.5 * length * DVec3::Z;
        let ball = ball(center, within);
        builder.surface("ball", ball, grey);
    });
    for eps in [3e-3, 3e-4] {
        let found = factors_of(&scene, Shadows::Auto, eps, eps);
        let told = found.left_in_blocks.max(eps);
        assert!(told < 3.0 * eps, "{told} is told where {eps} is asked");
        for surface in 0..4 {
            let sum: f64 = found.row(surface).into_iter().sum();
            println!("{eps:.0e}: row {surface} is {:.1e} off", sum - 1.0);
            assert!((sum - 1.0).abs() < 3.0 * told, "row {surface} sums up to {sum}");
        }
    }
}
