//! Frames whose blocks are sums of power series against frames that are solved alone.

use radiosity::Work;
use radiosity::scene::Scene;
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::animation::sequence::Sequence;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::visibility::Shadows;
use radiosity_test_support::compare::apart;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::{builtin, typed};

/// Rules far finer than the series, so that the difference of both is that of the series.
fn options(shadows: bool) -> Options {
    let usual = Options::default();
    Options {
        order: 1,
        subdivide: Some(1),
        transport: Transport::Exact,
        direct: Direct::Projected,
        eps: 1e-9,
        shadows: if shadows { usual.shadows } else { Shadows::Off },
        ..usual
    }
}

fn frame(follower: &mut Follower<'_>, number: usize) -> Frame {
    follower.frame(number, &Work::alone()).expect("it can be solved")
}

fn alone(scene: &Scene, options: &Options, number: usize) -> Frame {
    frame(&mut Follower::new(scene, options, FollowMode::Fresh, [0, scene.frames() - 1]), number)
}

/// A closed room with quads that float in it, of which two are moved, one of them along a broken line, and one
/// is turned; numbers of a fixed sequence.
fn random_room(seed: u64) -> Scene {
    let mut random = Random(seed);
    let mut quad = |name: &str, material: &str, z: f64| {
        let (along, turn) = (random.vector(-0.5, 0.5).normalize(), random.vector(-0.5, 0.5));
        let across = along.cross(turn).normalize();
        let [along, across] = [along, across].map(|edge| (0.1 * edge).to_array());
        let origin = [random.between(0.25, 0.65), random.between(0.25, 0.65), z];
        format!(
            "[[surfaces]]\nname = \"{name}\"\nmaterial = \"{material}\"\ntwo_sided = true\n\
             parallelogram = {{ origin = {origin:?}, edge1 = {along:?}, edge2 = {across:?} }}\n"
        )
    };
    let things =
        [quad("shelf", "wall", 0.25), quad("glow", "glow", 0.5), quad("lamp", "lamp", 0.75)].concat();
    let text = format!(
        r#"
frames = 61
materials.wall = {{ reflectance = 0.6 }}
materials.lamp = {{ reflectance = 0, emission = 10 }}
materials.glow = {{ reflectance = 0.3, emission = 2 }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
{things}
[[motion]]
surfaces = "lamp"
translate = {{ points = [[0, 0, 0], [0.06, 0.03, 0], [0.02, 0.06, 0.03]] }}
[[motion]]
surfaces = "glow"
translate = {{ points = [[0, 0, 0], [0, -0.05, 0.04]] }}
[[motion]]
surfaces = "shelf"
rotate = {{ center = [0.4, 0.5, 0.2], axis = [1, 0.5, 2], angles = [0, 30, -15] }}
"#
    );
    typed(&text)
}

/// Every fifth frame against that alone; returns how many blocks were sums of series in all.
fn compared(scene: &Scene, options: &Options, tolerance: f64) -> usize {
    let mut sequence = Sequence::by_series(scene, options, tolerance);
    let mut summed = 0;
    for number in 0..scene.frames() {
        let found = sequence.at(number as f64, &Work::alone()).expect("it can be solved");
        summed += sequence.summed();
        if number % 10 != 7 {
            continue;
        }
        let right = alone(scene, options, number);
        let (apart, told) = (apart(&found.solution, &right.solution), found.interpolated.unwrap_or(0.0));
        // What the solver leaves, and rules.
        assert!(apart <= told + 1e-9, "{number}: {apart:e} > {told:e}");
        assert!(told <= 20.0 * tolerance, "{number}: {told:e}");
    }
    summed
}

#[test]
fn frames_are_those_alone_to_the_error_that_is_told() {
    let sliding = builtin("sliding-light");
    for shadows in [false, true] {
        assert!(compared(&sliding, &options(shadows), 1e-4) > 500);
    }
    for seed in 1..4 {
        assert!(compared(&random_room(seed), &options(false), 1e-5) > 100, "{seed}");
    }
}

#[test]
fn nothing_is_left_of_where_things_were_meanwhile() {
    let (scene, options) = (random_room(5), options(false));
    let mut sequence = Sequence::by_series(&scene, &options, 1e-4);
    let mut light = |number: usize| {
        let solved = sequence.at(number as f64, &Work::alone()).expect("it can be solved");
        let bands = solved.solution.bands().iter();
        let light: Vec<f64> = bands.flat_map(|band| band.coefficients.irradiance.clone()).collect();
        (light, sequence.expanded())
    };
    // The first steps tell how things move: then all pairs are expanded that will be.
    (0..4).for_each(|number| drop(light(number)));
    let first = light(3).0;
    for number in [4, 5, 6, 5, 4] {
        assert_eq!(light(number).1, 0, "one range");
    }
    let again = light(3).0;
    assert!(first.iter().zip(&again).all(|(a, b)| a.to_bits() == b.to_bits()));
}

#[test]
fn what_is_curved_or_moves_like_a_screw_is_integrated() {
    let text = r#"
frames = 21
materials.wall = { reflectance = 0.5 }
materials.lamp = { reflectance = 0, emission = 1 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
SHAPE
[[motion]]
surfaces = "lamp"
MOTION
"#;
    let quad = "parallelogram = { origin = [0.3, 0.4, 0.5], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }";
    let ball = "sphere = { center = [0.4, 0.5, 0.5], radius = 0.1 }";
    let turned = "rotate = { center = [0.5, 0.5, 0.5], axis = [0, 0.1, 1], angles = [0, 40] }";
    let moved = "translate = { points = [[0, 0, 0], [0.02, 0.01, 0]] }";
    let screw = format!("{turned}\n{moved}");
    let cases = [
        (quad, turned, true),
        (quad, &screw, false),
        (ball, moved, false),
        (ball, turned, false),
        (quad, moved, true),
    ];
    for (shape, motion, sums) in cases {
        let text = text.replace("SHAPE", shape).replace("MOTION", motion);
        let scene = typed(&text);
        let options = Options { eps: 1e-5, ..options(false) };
        let mut follower = Follower::new(&scene, &options, FollowMode::Series { tolerance: 1e-4 }, [0, 20]);
        for number in 0..4 {
            let found = frame(&mut follower, number);
            let is_summed = sums && number > 0;
            assert_eq!(found.interpolated.is_some(), is_summed, "{shape} {motion} {number}");
            if !is_summed {
                assert!(
                    apart(&found.solution, &alone(&scene, &options, number).solution) == 0.0,
                    "{shape} {motion} {number}"
                );
            }
        }
    }
}

/// A lamp in a room without bodies that goes along a closed line of many sides, a frame for each, and then
/// straight.
#[test]
fn a_path_that_bends_in_every_frame_is_not_expanded_again_and_again() {
    const SIDES: usize = 64;
    let corner = |k: usize| std::f64::consts::TAU * k as f64 / SIDES as f64;
    let corners = (0..=SIDES).map(corner).map(|angle| [0.1 * angle.cos(), 0.1 * angle.sin()]);
    let straight = (1..=40).map(|k| [0.1, 0.004 * f64::from(k)]);
    let points: Vec<String> = corners.chain(straight).map(|[x, y]| format!("[{x}, {y}, 0]")).collect();
    let text = format!(
        r#"
frames = {}
materials.wall = {{ reflectance = 0.5 }}
materials.lamp = {{ reflectance = 0, emission = 1 }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = {{ origin = [0.4, 0.4, 0.6], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }}
[[motion]]
surfaces = "lamp"
translate = {{ points = [{}] }}
"#,
        points.len(),
        points.join(", ")
    );
    let scene = typed(&text);
    let mut sequence = Sequence::by_series(&scene, &options(false), 1e-3);
    let mut solved = |frames: std::ops::Range<usize>| {
        let (mut expanded, mut summed) = (0, 0);
        for number in frames {
            sequence.at(number as f64, &Work::alone()).expect("it can be solved");
            (expanded, summed) = (expanded + sequence.expanded(), summed + sequence.summed());
        }
        [expanded, summed]
    };
    // The lamp sees the floor and, below it, the four walls: each pair is expanded once and used once.
    let [expanded, summed] = solved(0..SIDES + 1);
    assert!((1..=5).contains(&expanded) && summed == expanded, "{expanded} {summed}");
    let [expanded, summed] = solved(SIDES + 1..scene.frames());
    assert!((1..=5).contains(&expanded) && summed > 30 * expanded, "{expanded} {summed}");
}
