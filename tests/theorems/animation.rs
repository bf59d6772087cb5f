//! Frames that follow each other against frames that are solved alone.

use radiosity::animation::follower::{Follower, Way};
use radiosity::animation::frame::Frame;
use radiosity::animation::sequence::Sequence;
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Options, Transport};

/// A room with a block, a lamp of two groups under the ceiling, and a panel of two sides between them; `motion` moves them.
fn room(frames: usize, motion: &str) -> Scene {
    let text = format!(
        r#"
frames = {frames}
bands = ["a", "b"]
materials.wall = {{ reflectance = [0.7, 0.4] }}
materials.lamp = {{ reflectance = 0, emission = [10, 5], group = "lamp" }}
materials.glow = {{ reflectance = 0.2, emission = [1, 2], group = "glow" }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
[[surfaces]]
name = "block"
material = "wall"
box = {{ origin = [0.5, 0.5, 0], size = [0.25, 0.3, 0.5] }}
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = {{ origin = [0.2, 0.4, 0.9], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }}
[[surfaces]]
name = "glow"
material = "glow"
parallelogram = {{ origin = [0.05, 0.05, 0.2], edge1 = [0.2, 0, 0], edge2 = [0, 0.2, 0] }}
[[surfaces]]
name = "panel"
material = "wall"
two_sided = true
parallelogram = {{ origin = [0.1, 0.5, 0.6], edge1 = [0.3, 0, 0], edge2 = [0, 0.3, 0] }}
[[motion]]
{motion}
"#
    );
    Scene::from_toml(&text, "room.toml").expect("the room is valid")
}

/// A closed cube with `things` in it, of walls or a lamp of this reflectance.
fn cube(frames: usize, of_lamp: f64, things: &str) -> Scene {
    let text = format!(
        r#"
frames = {frames}
materials.wall = {{ reflectance = 0.5 }}
materials.lamp = {{ reflectance = {of_lamp}, emission = 1 }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
{things}
"#
    );
    Scene::from_toml(&text, "cube.toml").expect("it is valid")
}

const PANEL: &str = "surfaces = 'panel'
translate = { points = [[0, 0, 0], [0.4, 0, 0]] }
rotate = { center = [0.25, 0.65, 0.6], axis = [1, 1, 0], angles = [0, 25] }";
const LAMP: &str = "surfaces = 'lamp'\ntranslate = { points = [[0, 0, 0], [0.1, 0, 0]] }";
const GLOW: &str = "surfaces = 'glow'\ntranslate = { points = [[0, 0, 0], [0.1, 0, 0]] }";

fn options(direct: Direct) -> Options {
    Options { order: 1, subdivide: Some(1), transport: Transport::Exact, direct, ..Options::default() }
}

fn bits(frame: &Frame) -> Vec<u64> {
    let bands = frame.solution.bands().iter();
    let coefficients =
        bands.flat_map(|band| band.coefficients.irradiance.iter().chain(&band.coefficients.direct));
    coefficients.map(|h| h.to_bits()).collect()
}

/// Largest relative L2 difference of the irradiance of any band.
fn apart(frame: &Frame, right: &Frame) -> f64 {
    let pairs = frame.solution.bands().iter().zip(right.solution.bands());
    let relative = pairs.map(|(own, other)| {
        let [own, other] = [own, other].map(|band| &band.coefficients.irradiance);
        let difference: f64 = own.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum();
        (difference / other.iter().map(|h| h * h).sum::<f64>()).sqrt()
    });
    relative.fold(0.0, f64::max)
}

fn frames(scene: &Scene, options: &Options, way: Way, numbers: &[usize]) -> Vec<Frame> {
    let mut follower = Follower::new(scene, options, way, [0, scene.frames() - 1]);
    numbers.iter().map(|frame| follower.frame(*frame, &|_| ()).expect("it can be solved")).collect()
}

#[test]
fn frames_one_after_the_other_are_those_alone_to_the_bit() {
    for (motion, direct) in [(PANEL, Direct::Auto), (PANEL, Direct::Projected), (LAMP, Direct::Projected)] {
        let (scene, options) = (room(40, motion), options(direct));
        // Forwards, backwards, at once to the end, and the same again.
        let numbers = [0, 1, 2, 1, 39, 39, 20, 0];
        let followed = frames(&scene, &options, Way::Selective, &numbers);
        for (number, frame) in numbers.iter().zip(&followed) {
            let alone = frames(&scene, &options, Way::Fresh, &[*number]);
            assert!(bits(frame) == bits(&alone[0]), "{motion} {direct:?} {number}");
        }
        assert!(bits(&followed[0]) != bits(&followed[1]), "{motion}: light moves");
    }
}

#[test]
fn a_curved_thing_that_moves_leaves_other_blocks_as_they_are() {
    let things = r#"
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0.6, 0.6, 0.9], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }
[[surfaces]]
name = "shelf"
material = "wall"
parallelogram = { origin = [0.7, 0.7, 0.2], edge1 = [0.2, 0, 0], edge2 = [0, 0.2, 0] }
[[surfaces]]
name = "board"
material = "wall"
parallelogram = { origin = [0.7, 0.7, 0.4], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }
[[surfaces]]
name = "ball"
material = "wall"
sphere = { center = [0.2, 0.2, 0.3], radius = 0.08 }
[[motion]]
surfaces = "ball"
translate = { points = [[0, 0, 0], [0.1, 0, 0]] }
"#;
    let scene = cube(5, 0.5, things);
    let options = options(Direct::Projected);
    let mut sequence = Sequence::new(&scene, &options);
    for moment in [0.0, 1.0, 4.0] {
        let followed = sequence.at(moment, &|_| ()).expect("it can be solved");
        let alone = Sequence::new(&scene, &options).at(moment, &|_| ()).expect("it can be solved");
        let own = |solved: &radiosity::solved::Solved| {
            solved.outcome.solution.bands()[0].coefficients.irradiance.clone()
        };
        assert_eq!(own(&followed), own(&alone));
    }
    // No ball comes between the shelf and the board.
    let counts = [sequence.recalled(), sequence.integrated()];
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
}

#[test]
fn nothing_drifts_over_a_thousand_frames() {
    let things = r#"
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0.2, 0.4, 0.5], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }
[[motion]]
surfaces = "lamp"
rotate = { center = [0.5, 0.5, 0.5], axis = [0, 0.1, 1], angles = [0, 1000] }
"#;
    let scene = cube(1000, 0.2, things);
    let options = Options { order: 0, ..options(Direct::Projected) };
    let numbers: Vec<usize> = (0..1000).collect();
    let followed = frames(&scene, &options, Way::Selective, &numbers);
    for number in [1, 500, 999] {
        let alone = frames(&scene, &options, Way::Fresh, &[number]);
        assert!(bits(&followed[number]) == bits(&alone[0]), "{number}");
    }
}

#[test]
fn light_along_a_path_is_interpolated_to_what_is_told() {
    // The lamp casts shadows over the panel and the block: told, and solved more often.
    for (motion, most) in [(GLOW, 20), (LAMP, 60)] {
        let (scene, options) = (room(60, motion), Options { eps: 1e-5, ..options(Direct::Projected) });
        let mut follower = Follower::new(&scene, &options, Way::Path { tolerance: 1e-3 }, [0, 59]);
        for number in 0..60 {
            let frame = follower.frame(number, &|_| ()).expect("it can be solved");
            if number % 7 != 3 {
                continue;
            }
            let alone = &frames(&scene, &options, Way::Fresh, &[number])[0];
            match frame.interpolated {
                Some(told) => {
                    assert!(told <= 1e-3 && apart(&frame, alone) <= 1e-3, "{motion} {number} {told}")
                }
                None => assert!(bits(&frame) == bits(alone), "{motion} {number}"),
            }
        }
        assert!(follower.solved() <= most + most / 3, "{motion}: {}", follower.solved());
    }
}

#[test]
fn what_cannot_be_interpolated_is_solved_frame_by_frame() {
    let (scene, options) = (room(12, PANEL), options(Direct::Projected));
    let mut follower = Follower::new(&scene, &options, Way::Path { tolerance: 1e-9 }, [0, 11]);
    let frame = follower.frame(7, &|_| ()).expect("it can be solved");
    assert_eq!((frame.interpolated, follower.error()), (None, None));
    assert!(bits(&frame) == bits(&frames(&scene, &options, Way::Fresh, &[7])[0]));
}

#[test]
fn what_moves_between_the_points_of_a_path_is_seen() {
    // At rest at all moments that are solved first, and away between them.
    let away = "surfaces = 'panel'
translate = { points = [[0, 0, 0], [0, 0, 0], [0.3, 0, 0], [0, 0, 0], [0, 0, 0]], times = [0, 18, 25, 32, 100] }";
    let (scene, options) = (room(101, away), options(Direct::Projected));
    let mut follower = Follower::new(&scene, &options, Way::Path { tolerance: 1e-4 }, [0, 100]);
    for number in [5, 25, 60] {
        let frame = follower.frame(number, &|_| ()).expect("it can be solved");
        let alone = &frames(&scene, &options, Way::Fresh, &[number])[0];
        assert!(apart(&frame, alone) <= 1e-4, "{number}");
    }
    assert!(follower.solved() < 60, "{}", follower.solved());
}
