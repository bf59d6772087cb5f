//! Blocks from rays against exact ones; what they keep: symmetry, closure, bits; and the error that is told.

use std::f64::consts::PI;

use radiosity::SceneBuilder;
use radiosity::Work;
use radiosity::geom::DVec3;
use radiosity::geom::shapes::{FULL_TURN, Sphere};
use radiosity::scene::Scene;
use radiosity::solve::{Options, Outcome, Transport, solve};
use radiosity::visibility::{Shadows, Visibility};
use radiosity::work::ranks::Ranks;
use radiosity::work::{Deadline, Progress};
use radiosity::{
    kernel::{Accuracy, Blocks},
    transport::{Rays, SampledTransport},
};
use radiosity_test_support::scenes::grey;
use radiosity_test_support::scenes::{builtin, material, typed};
use radiosity_test_support::shapes::{ball, disk, plate, tube};
use radiosity_test_support::solved::{blocks_of, elements_of, outcome_of};

/// The blocks of a scene by `rays` rays from each element.
fn sampled(scene: &Scene, order: usize, rays: u64) -> Blocks {
    let visibility = Visibility::new(scene, Shadows::Rays, 1e-3);
    let elements = elements_of(scene, order, 1);
    let mut transport = SampledTransport::new(&elements, &visibility, Ranks::alone());
    transport.send(&vec![rays; elements.list().len()], &mut |_| true);
    transport.blocks(Rays::All)
}

/// Relative L2 difference of all entries of two matrices of blocks, by what they make of unit vectors.
fn difference(a: &Blocks, b: &Blocks) -> f64 {
    let (mut far, mut all) = (0.0, 0.0);
    for k in 0..a.dim() {
        let mut unit = vec![0.0; a.dim()];
        unit[k] = 1.0;
        for (x, y) in a.apply(&unit).iter().zip(b.apply(&unit)) {
            far += (x - y).powi(2);
            all += y * y;
        }
    }
    (far / all).sqrt()
}

/// A closed can whose wall is seen from inside.
fn can() -> Scene {
    let (mut builder, grey) = grey();
    let wall = tube(DVec3::ZERO, 2.0 * DVec3::Z, 1.0);
    let top = 2.0 * DVec3::Z;
    builder.surface("wall", wall, &grey).flip();
    builder.surface("floor", disk(DVec3::ZERO, DVec3::Z, 1.0), &grey);
    builder.surface("top", disk(top, -DVec3::Z, 1.0), &grey);
    builder.build().expect("a can")
}

/// A room turned out of all planes of the coordinates, with a ball in it.
fn turned_room() -> Scene {
    let (mut builder, grey) = grey();
    let x = DVec3::new(0.8, 0.5, 0.3).normalize();
    let y = x.cross(DVec3::new(0.1, 0.2, 1.0)).normalize();
    let z = x.cross(y);
    let at = |u: f64, v: f64, w: f64| DVec3::new(3.1, -2.7, 0.9) + x * u + y * v + z * w;
    for (name, corner, first, second) in [
        ("floor", at(0.0, 0.0, 0.0), x, y),
        ("ceiling", at(0.0, 0.0, 1.0), y, x),
        ("left", at(0.0, 0.0, 0.0), y, z),
        ("right", at(1.0, 0.0, 0.0), z, y),
        ("front", at(0.0, 0.0, 0.0), z, x),
        ("back", at(0.0, 1.0, 0.0), x, z),
    ] {
        builder.surface(name, plate(corner, first, second), &grey);
    }
    builder.surface(
        "ball",
        Sphere::new(at(0.4, 0.5, 0.6), 0.2, z, [-0.2, 0.2], FULL_TURN).expect("a ball"),
        &grey,
    );
    builder.build().expect("a room")
}

#[test]
fn rays_find_the_exact_blocks_and_find_them_better_the_more_there_are() {
    for (scene, order) in [(builtin("furnace-cube"), 2), (can(), 1), (turned_room(), 1)] {
        let visibility = Visibility::new(&scene, Shadows::Rays, 5e-4);
        let elements = elements_of(&scene, order, 1);
        // A few parts in a thousand are left to the rays that are judged.
        let accuracy = Accuracy { eps: 1e-5, shadow_eps: 5e-4 };
        let exact = blocks_of(&elements, &visibility, accuracy);
        let [few, many] = [1_000, 64_000].map(|rays| difference(&sampled(&scene, order, rays), &exact));
        println!("{}: {few:.2e} by 1000 rays from each element, {many:.2e} by 64 000", scene.name);
        // 64 times as many rays: by N^-½ an eighth; halves of it are left to chance.
        assert!(many < few / 5.0, "{}: {few} then {many}", scene.name);
        assert!(many < 0.01, "{}: {many}", scene.name);
    }
}

#[test]
fn no_ray_leaves_a_closed_room() {
    // Rays start within rounding of edges and corners, too: where one escaped, a row sum would be below 1.
    for scene in [builtin("furnace-cube"), can(), turned_room()] {
        let visibility = Visibility::new(&scene, Shadows::Rays, 1e-3);
        let elements = elements_of(&scene, 0, 2);
        let mut transport = SampledTransport::new(&elements, &visibility, Ranks::alone());
        transport.send(&vec![20_000; elements.list().len()], &mut |_| true);
        for (element, share) in elements.list().iter().zip(transport.shares_lost()) {
            assert!(share == 0.0, "{}: surface {} loses {share}", scene.name, element.surface);
        }
    }
}

#[test]
fn what_crosses_a_wall_hides_what_it_encloses() {
    // A box through the wall x = 1 and a ball sunk into the floor: of the wall's and the floor's rays those
    // are lost that start inside, where all backs absorb; of what is outside the room all but those of the
    // faces that cross the wall.
    let (mut builder, grey) = grey();
    let cube = builtin("furnace-cube");
    for surface in &cube.surfaces {
        builder.surface(&surface.name, surface.shape.clone(), &grey);
    }
    let [x, y, z] = [0.4 * DVec3::X, 0.2 * DVec3::Y, 0.3 * DVec3::Z];
    let corner = DVec3::new(0.8, 0.4, 0.5);
    for (name, corner, first, second) in [
        ("bottom", corner, y, x),
        ("top", corner + z, x, y),
        ("left", corner, x, z),
        ("right", corner + y, z, x),
        ("inner end", corner, z, y),
        ("outer end", corner + x, y, z),
    ] {
        builder.surface(name, plate(corner, first, second), &grey);
    }
    let (radius, height) = (0.2, 0.1);
    let center = DVec3::new(0.4, 0.5, height);
    let ball = ball(center, radius);
    builder.surface("ball", ball, &grey);
    let scene = builder.build().expect("a room");
    let visibility = Visibility::new(&scene, Shadows::Rays, 1e-3);
    let elements = elements_of(&scene, 0, 1);
    let mut transport = SampledTransport::new(&elements, &visibility, Ranks::alone());
    transport.send(&vec![20_000; elements.list().len()], &mut |_| true);
    let shares = transport.shares_lost();
    let below = 0.5 * (1.0 - height / radius);
    for (element, share) in elements.list().iter().zip(shares) {
        let name = scene.surfaces[element.surface].name.as_str();
        let middle = element.patches[0].node(0.5, 0.5).position;
        let lost = match name {
            "outer end" => 1.0,
            "bottom" | "top" | "left" | "right" => 0.5,
            "ball" => below,
            "inner end" => 0.0,
            _ if (middle.x - 1.0).abs() < 1e-9 => 0.2 * 0.3,
            _ if middle.z.abs() < 1e-9 => PI * (radius * radius - height * height),
            _ => 0.0,
        };
        println!("{name}: {share} of the rays lost, {lost} by area");
        assert!((share - lost).abs() < 5e-3, "{name}: {share} instead of {lost}");
        assert!(lost > 0.0 || share == 0.0, "{name}: {share} leak");
    }
}

#[test]
fn a_stopped_run_counts_the_rays_that_were_sent() {
    let scene = builtin("occluder-box");
    let planned = 8_000_000;
    let options = Options {
        transport: Transport::Sampled,
        rays: Some(planned),
        subdivide: Some(1),
        ..Options::default()
    };
    // The second round is the last.
    let deadline = Deadline::default();
    let observe = |progress| {
        if let Progress::Rays { error: Some(error), .. } = progress {
            assert!(error < 0.1, "{error}");
            deadline.wish();
        }
    };
    let outcome = solve(&scene, &options, &Work::alone().observed_by(&observe).until(&deadline));
    let outcome = outcome.expect("the scene can be solved");
    let sampling = outcome.sampling.expect("rays carried the light");
    assert!(sampling.planned > planned && sampling.rays < sampling.planned, "{sampling:?}");
    assert!(sampling.rays > planned / 8 && sampling.error.is_some_and(|error| error < 0.05), "{sampling:?}");
    let exact = solved(&scene, Transport::Exact, None);
    assert!(surfaces_apart(&scene, &outcome, &exact) < 0.01);
}

#[test]
fn row_sums_agree_with_what_rays_meet() {
    let blocks = sampled(&turned_room(), 1, 2_000);
    let elements = elements_of(&turned_room(), 1, 1);
    let ones = elements.constant();
    let (corrected, integrated) = (blocks.apply(&ones), blocks.integrated_constant(&ones));
    let sum = |of: &[f64], element: usize| {
        let range = blocks.starts()[element]..blocks.starts()[element + 1];
        let own = ones[range.clone()].iter().zip(&of[range]);
        own.map(|(c, gc)| c * gc).sum::<f64>() / elements.list()[element].area
    };
    let walls = 0..6;
    assert!(walls.clone().all(|wall| (sum(&corrected, wall) - 1.0).abs() < 1e-5));
    // The check is of the integrals before that, and can fail.
    assert!(walls.clone().any(|wall| (sum(&integrated, wall) - 1.0).abs() > 1e-4));
    assert!(walls.clone().all(|wall| (sum(&integrated, wall) - 1.0).abs() < 0.1));
}

#[test]
fn threads_and_rounds_change_no_bit() {
    let scene = turned_room();
    let values = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let blocks = pool.install(|| sampled(&scene, 1, 10_000));
        blocks.iter().flat_map(|block| block.values.to_vec()).collect::<Vec<f64>>()
    };
    let alone = values(1);
    assert_eq!(alone, values(2));
    assert_eq!(alone, values(5));
}

fn solved(scene: &Scene, transport: Transport, rays: Option<u64>) -> Outcome {
    let options = Options { transport, rays, threads: 2, ..Options::default() };
    outcome_of(scene, &options)
}

/// Relative L2 difference of the mean irradiances of the surfaces, by area.
fn surfaces_apart(scene: &Scene, a: &Outcome, b: &Outcome) -> f64 {
    let (mut far, mut all) = (0.0, 0.0);
    for (index, surface) in scene.surfaces.iter().enumerate() {
        let [a, b] = [a, b].map(|outcome| outcome.solution.mean_irradiance(0, index));
        far += surface.shape.area() * (a - b).powi(2);
        all += surface.shape.area() * b * b;
    }
    (far / all).sqrt()
}

#[test]
fn the_error_told_is_that_of_a_hundred_times_as_many_rays() {
    for name in ["cornell-box", "two-boxes", "occluder-box", "teapot", "furnace-cube"] {
        let scene = builtin(name);
        let told = solved(&scene, Transport::Sampled, Some(10_000));
        let fine = solved(&scene, Transport::Sampled, Some(1_000_000));
        let error = told.sampling.and_then(|sampling| sampling.error).expect("rays carried the light");
        let truth = surfaces_apart(&scene, &told, &fine);
        println!("{name}: told {error:.2e} of elements, surfaces are off by {truth:.2e}");
        // Means over surfaces are better than those over their elements, which the figure is of.
        assert!(truth < 2.0 * error, "{name}: {truth} beyond what is told, {error}");
    }
}

/// A room under so many lamps, each a light group of its own, the first the largest.
fn room_of_groups(lamps: usize) -> Scene {
    let mut text = String::from("[materials.white]\nreflectance = 0.5\n");
    let mut add = |name: &str, vertices: &str, material: &str, more: &str| {
        text += &format!("[[surfaces]]\nname = \"{name}\"\nmaterial = \"{material}\"\n{more}");
        text += &format!("quad = {{ vertices = [{vertices}] }}\n");
    };
    for (name, vertices) in [
        ("floor", "[0,0,0],[9,0,0],[9,9,0],[0,9,0]"),
        ("ceiling", "[0,0,3],[0,9,3],[9,9,3],[9,0,3]"),
        ("west", "[0,0,0],[0,9,0],[0,9,3],[0,0,3]"),
        ("east", "[9,0,0],[9,0,3],[9,9,3],[9,9,0]"),
        ("south", "[0,0,0],[0,0,3],[9,0,3],[9,0,0]"),
        ("north", "[0,9,0],[9,9,0],[9,9,3],[0,9,3]"),
    ] {
        add(name, vertices, "white", "");
    }
    for lamp in 0..lamps {
        let [x, y] = [lamp % 10, lamp / 10].map(|place| 0.4 + 0.8 * place as f64);
        let half = 0.3 / (1.0 + lamp as f64 / 10.0);
        let [left, right, low, high] = [x - half, x + half, y - half, y + half];
        let corners =
            format!("[{left},{low},2.9],[{left},{high},2.9],[{right},{high},2.9],[{right},{low},2.9]");
        add(&format!("lamp{lamp}"), &corners, "lamp", &format!("group = \"group{lamp}\"\n"));
    }
    typed(&(text + "[materials.lamp]\nreflectance = 0.1\nemission = 1.0\n"))
}

#[test]
fn the_error_told_is_that_of_the_light_group_that_errs_most() {
    let scene = room_of_groups(100);
    let of = |transport, rays| {
        let options =
            Options { transport, rays, order: 0, subdivide: Some(2), threads: 2, ..Options::default() };
        outcome_of(&scene, &options)
    };
    let (told, exact) = (of(Transport::Sampled, Some(100_000)), of(Transport::Exact, None));
    let elements = told.solution.elements();
    let mut worst: f64 = 0.0;
    for (own, right) in told.solution.groups().iter().zip(exact.solution.groups()) {
        let [own, right] = [own, right].map(|light| elements.means(&light.bands[0].irradiance));
        let (mut far, mut all) = (0.0, 0.0);
        for ((own, right), element) in own.iter().zip(&right).zip(elements.list()) {
            far += element.area * (own - right).powi(2);
            all += element.area * right.powi(2);
        }
        worst = worst.max((far / all).sqrt());
    }
    let error = told.sampling.and_then(|sampling| sampling.error).expect("rays carried the light");
    println!("told {error:.3}, the worst of 100 groups errs by {worst:.3}");
    assert!(told.solution.groups().len() == 100 && worst < 2.0 * error && error < 3.0 * worst);
}

#[test]
fn surfaces_are_as_bright_as_by_exact_transport() {
    for name in ["cornell-box", "two-boxes", "occluder-box", "furnace-cube"] {
        let scene = builtin(name);
        let exact = solved(&scene, Transport::Exact, None);
        let rays = solved(&scene, Transport::Sampled, Some(400_000));
        let apart = surfaces_apart(&scene, &rays, &exact);
        println!("{name}: {apart:.2e} apart");
        assert!(apart < 0.01, "{name}: {apart}");
        assert!(exact.sampling.is_none() && rays.sampling.is_some_and(|sampling| sampling.rays >= 400_000));
    }
}

#[test]
fn a_closed_room_keeps_its_power() {
    // Walls that reflect nearly all, at an order that few rays support: noise must not feed itself.
    for order in [1, 2] {
        let mut builder = SceneBuilder::new("white room", ["grey"]);
        let white = builder.material("white", material(0.95, 1.0));
        let room = builtin("furnace-cube");
        for surface in &room.surfaces {
            builder.surface(&surface.name, surface.shape.clone(), &white).order(order).subdivide(3, 3);
        }
        let scene = builder.build().expect("a room");
        let outcome = solved(&scene, Transport::Sampled, Some(20_000));
        let checks = outcome.checks;
        println!("order {order}: {:.1e} of the power lost", checks.energy_lost / checks.energy_in);
        assert!(checks.energy_lost.abs() < 1e-3 * checks.energy_in, "{checks:?}");
        // B = E₀/(1 − ρ) everywhere.
        let worst = (0..6).map(|wall| (outcome.solution.mean_irradiance(0, wall) / 20.0 - 1.0).abs());
        assert!(worst.fold(0.0, f64::max) < 1e-3);
    }
}

#[test]
fn a_floor_under_a_small_lamp_is_lit_by_the_rays_of_the_lamp() {
    // Hardly any ray of the floor meets the lamp: what is known of its row sum must not spoil what the lamp's
    // own rays tell.
    let mut builder = SceneBuilder::new("lamp", ["grey"]);
    let dark = builder.material("dark", material(0.3, 0.0));
    let lamp = builder.material("lamp", material(0.0, 1000.0));
    let floor = plate(DVec3::ZERO, DVec3::X, DVec3::Y);
    builder.surface("floor", floor, &dark).subdivide(4, 4);
    let corner = DVec3::new(0.495, 0.495, 0.9);
    let square = plate(corner, 0.01 * DVec3::Y, 0.01 * DVec3::X);
    builder.surface("lamp", square, &lamp);
    let scene = builder.build().expect("a lamp over a floor");
    let exact = solved(&scene, Transport::Exact, None);
    let rays = solved(&scene, Transport::Sampled, Some(200_000));
    let [exact, found] = [&exact, &rays].map(|outcome| outcome.solution.mean_irradiance(0, 0));
    println!("floor {found:.5} by rays, {exact:.5} exactly");
    assert!((found / exact - 1.0).abs() < 0.02, "{found} and {exact}");
}
