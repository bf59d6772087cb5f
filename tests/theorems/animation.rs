//! Frames that follow each other against frames that are solved alone.

use std::collections::{BTreeMap, BTreeSet};

use radiosity::Work;
use radiosity::scene::Scene;
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::animation::sequence::Sequence;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::solvers::method::Method;
use radiosity_test_support::compare::apart;
use radiosity_test_support::scenes::{lamps_room, typed};

/// A room with a block, a lamp of two groups under the ceiling, and a panel of two sides between them;
/// `motion` moves them.
fn room(frames: usize, motion: &str) -> Scene {
    let text = lamps_room([[10.0, 5.0], [1.0, 2.0]], "", "");
    typed(&format!("frames = {frames}\n{text}[[motion]]\n{motion}\n"))
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
    typed(&text)
}

const PANEL: &str = "surfaces = 'panel'
translate = { points = [[0, 0, 0], [0.4, 0, 0]] }
rotate = { center = [0.25, 0.65, 0.6], axis = [1, 1, 0], angles = [0, 25] }";
const LAMP: &str = "surfaces = 'lamp'\ntranslate = { points = [[0, 0, 0], [0.1, 0, 0]] }";
const BENT: &str = "surfaces = 'lamp'\ntranslate = { points = [[0, 0, 0], [0.1, 0, 0], [0.1, -0.1, 0]] }";
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

fn frames(scene: &Scene, options: &Options, way: FollowMode, numbers: &[usize]) -> Vec<Frame> {
    let mut follower = Follower::new(scene, options, way, [0, scene.frames() - 1]);
    numbers.iter().map(|frame| follower.frame(*frame, &Work::alone()).expect("it can be solved")).collect()
}

/// The frames of these numbers, each solved by itself, once.
fn alone(scene: &Scene, options: &Options, numbers: &[usize]) -> BTreeMap<usize, Frame> {
    let numbers: Vec<usize> = BTreeSet::from_iter(numbers.iter().copied()).into_iter().collect();
    let frames = frames(scene, options, FollowMode::Fresh, &numbers);
    numbers.into_iter().zip(frames).collect()
}

#[test]
fn frames_one_after_the_other_are_those_alone_to_the_bit() {
    for (motion, direct) in [(PANEL, Direct::Auto), (PANEL, Direct::Projected), (LAMP, Direct::Projected)] {
        let (scene, options) = (room(40, motion), options(direct));
        // Forwards, backwards, at once to the end, and the same again.
        let numbers = [0, 1, 2, 1, 39, 39, 20, 0];
        let followed = frames(&scene, &options, FollowMode::Selective, &numbers);
        let alone = alone(&scene, &options, &numbers);
        for (number, frame) in numbers.iter().zip(&followed) {
            assert!(bits(frame) == bits(&alone[number]), "{motion} {direct:?} {number}");
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
        let followed = sequence.at(moment, &Work::alone()).expect("it can be solved");
        let alone = Sequence::fresh(&scene, &options).at(moment, &Work::alone()).expect("it can be solved");
        assert!(bits(&followed) == bits(&alone));
    }
    // No ball comes between the shelf and the board.
    let counts = [sequence.recalled(), sequence.integrated()];
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
}

/// A ball, a post and a plate in a closed cube, of which `motion` moves some.
fn things(frames: usize, motion: &str) -> Scene {
    let things = r#"
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0.6, 0.6, 0.9], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }
[[surfaces]]
name = "ball"
material = "wall"
sphere = { center = [0.3, 0.3, 0.3], radius = 0.12 }
[[surfaces]]
name = "post"
material = "wall"
cylinder = { base = [0.7, 0.3, 0.1], axis = [0, 0, 0.5], radius = 0.05 }
[[surfaces]]
name = "plate"
material = "wall"
two_sided = true
parallelogram = { origin = [0.2, 0.6, 0.5], edge1 = [0.2, 0, 0], edge2 = [0, 0.2, 0.1] }
[[surfaces]]
name = "tile"
material = "wall"
parallelogram = { origin = [0.1, 0.1, 0], edge1 = [0.2, 0, 0], edge2 = [0, 0.2, 0] }
"#;
    cube(frames, 0.3, &format!("{things}\n{motion}"))
}

fn by_rays() -> Options {
    Options { order: 1, transport: Transport::Sampled, rays: Some(20_000), ..Options::default() }
}

#[test]
fn rays_that_are_kept_give_what_fresh_ones_would_to_the_bit() {
    let motions = [
        "[[motion]]\nsurfaces = 'plate'\ntranslate = { points = [[0, 0, 0], [0.4, 0, 0]] }\nrotate = { center = [0.3, 0.7, 0.5], axis = [1, 1, 0], angles = [0, 200] }",
        "[[motion]]\nsurfaces = 'ball'\ntranslate = { points = [[0, 0, 0], [0.3, 0.3, 0.2]] }",
        "[[motion]]\nsurfaces = 'lamp'\ntranslate = { points = [[0, 0, 0], [-0.5, -0.4, 0]] }\n[[motion]]\nsurfaces = 'post'\nrotate = { center = [0.5, 0.5, 0.5], axis = [0, 0, 1], angles = [0, 90] }",
        // Over the floor, and out of the cube: what lies on it changes, and how large the scene is.
        "[[motion]]\nsurfaces = 'tile'\ntranslate = { points = [[0, 0, 0], [0.5, 0.3, 0]] }",
        "[[motion]]\nsurfaces = 'plate'\ntranslate = { points = [[0, 0, 0], [0, 0, 2]] }",
    ];
    // Forwards by small steps, backwards, at once to the end, and the same again.
    let numbers = [0, 1, 2, 3, 2, 39, 39, 20, 0];
    for motion in motions {
        let scene = things(40, motion);
        let mut alone = Follower::new(&scene, &by_rays(), FollowMode::Fresh, [0, 39]);
        let alone: Vec<Vec<u64>> = numbers
            .iter()
            .map(|frame| bits(&alone.frame(*frame, &Work::alone()).expect("it can be solved")))
            .collect();
        for threads in [1, 3] {
            let options = Options { threads, ..by_rays() };
            let mut follower = Follower::new(&scene, &options, FollowMode::Selective, [0, 39]);
            for (number, alone) in numbers.iter().zip(&alone) {
                let frame = follower.frame(*number, &Work::alone()).expect("it can be solved");
                assert!(bits(&frame) == *alone, "{motion} {threads} {number}");
            }
            let rays = follower.report().rays;
            assert!(rays.recalled > rays.traced / 4, "{motion}: {rays:?}");
        }
        assert!(alone[0] != alone[5], "{motion}: light moves");
    }
}

#[test]
fn no_more_rays_are_traced_than_meet_what_moves() {
    // A speck far from everything: all rays but its own, and those that meet it, are kept.
    let motion = "[[surfaces]]\nname = 'speck'\nmaterial = 'wall'\nsphere = { center = [0.9, 0.1, 0.9], radius = 0.001 }
[[motion]]\nsurfaces = 'speck'\ntranslate = { points = [[0, 0, 0], [0.01, 0, 0]] }";
    let scene = things(5, motion);
    let mut sequence = Sequence::new(&scene, &by_rays());
    sequence.at(0.0, &Work::alone()).expect("it can be solved");
    let first = sequence.report().rays;
    assert_eq!(first.recalled, 0);
    sequence.at(1.0, &Work::alone()).expect("it can be solved");
    let traced = sequence.report().rays.traced - first.traced;
    // A speck sends the fewest rays there are, 4 in the pilot round and 16 after it; what else is traced are
    // rays of elements that send some more than before.
    assert!((20..first.traced / 50).contains(&traced), "{traced} of {}", first.traced);
}

#[test]
fn rays_of_pairs_that_no_rule_reaches_are_kept_as_well() {
    let scene =
        things(20, "[[motion]]\nsurfaces = 'tile'\ntranslate = { points = [[0, 0, 0.2], [0, 0, 0.3]] }");
    let options = Options { eps: 1e-2, shadow_eps: 1e-1, ..options(Direct::Projected) };
    let mut sequence = Sequence::new(&scene, &options);
    for moment in [3.0, 4.0, 9.0] {
        let frame = sequence.at(moment, &Work::alone()).expect("it can be solved");
        let alone = Sequence::fresh(&scene, &options).at(moment, &Work::alone()).expect("it can be solved");
        assert!(bits(&frame) == bits(&alone), "{moment}");
    }
    let rays = sequence.report().rays;
    assert!(rays.recalled > rays.traced / 4, "{rays:?}");
}

#[test]
fn what_pauses_away_from_rest_is_not_integrated_again() {
    let pause = "surfaces = 'panel'
translate = { points = [[0, 0, 0], [0.2, 0, 0], [0.2, 0, 0], [0.4, 0, 0]], times = [0, 4, 8, 12] }
rotate = { center = [0.25, 0.65, 0.6], axis = [1, 1, 0], angles = [0, 25, 25, 50], times = [0, 4, 8, 12] }";
    let scene = room(13, pause);
    for options in [options(Direct::Projected), by_rays()] {
        let mut sequence = Sequence::new(&scene, &options);
        let known = sequence.at(5.0, &Work::alone()).expect("it can be solved");
        let rays = sequence.report().rays;
        let again = sequence.at(7.0, &Work::alone()).expect("it can be solved");
        assert!(bits(&known) == bits(&again));
        assert_eq!(sequence.integrated(), 0);
        assert!(sequence.recalled() > 0);
        assert_eq!(sequence.report().rays.traced, rays.traced);
        // Gone on, it is integrated.
        sequence.at(9.0, &Work::alone()).expect("it can be solved");
        assert!(sequence.integrated() > 0);
    }
}

#[test]
fn the_mesh_stays_while_things_turn() {
    // Lying across the cube the board is longer than half of it along an axis, and is cut; turned by 45° it
    // is not.
    let things = r#"
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0.4, 0.4, 0.9], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }
[[surfaces]]
name = "board"
material = "wall"
parallelogram = { origin = [0.225, 0.45, 0.5], edge1 = [0.55, 0, 0], edge2 = [0, 0.1, 0] }
[[motion]]
surfaces = "board"
rotate = { center = [0.5, 0.5, 0.5], axis = [0, 0, 1], angles = [0, 90] }
"#;
    let scene = cube(3, 0.5, things);
    let options = Options { subdivide: None, ..options(Direct::Projected) };
    let alone = |frame: usize| {
        let still = scene.at_frame(frame).expect("there is such a frame");
        radiosity::solve(&still, &options, &Work::alone())
            .expect("it can be solved")
            .solution
            .elements()
            .list()
            .len()
    };
    assert!(alone(0) > alone(1), "the scene of a frame alone would be cut otherwise");
    let count = |frame: &Frame| frame.solution.elements().list().len();
    let (fresh, followed) = (FollowMode::Fresh, FollowMode::Selective);
    let [fresh, followed] = [fresh, followed].map(|way| frames(&scene, &options, way, &[0, 1, 2]));
    for (fresh, followed) in fresh.iter().zip(&followed) {
        assert!(bits(fresh) == bits(followed));
        assert_eq!(count(followed), alone(0));
    }
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
    let followed = frames(&scene, &options, FollowMode::Selective, &numbers);
    for number in [1, 500, 999] {
        let alone = frames(&scene, &options, FollowMode::Fresh, &[number]);
        assert!(bits(&followed[number]) == bits(&alone[0]), "{number}");
    }
    let followed = frames(&scene, &options, FollowMode::Incremental, &numbers);
    for number in [1, 500, 999] {
        let alone = frames(&scene, &options, FollowMode::Fresh, &[number]);
        let (apart, told) = (apart(&followed[number].solution, &alone[0].solution), told(&followed[number]));
        assert!(apart <= told && told < 1e-4, "{number}: {apart:e} {told:e}");
    }
}

#[test]
fn light_along_a_path_is_interpolated_to_what_is_told() {
    // The lamp casts shadows over the panel and the block: told, and solved more often. Its path bends between
    // two frames.
    for (motion, most) in [(GLOW, 26), (BENT, 60)] {
        let (scene, options) = (room(60, motion), Options { eps: 1e-4, ..options(Direct::Projected) });
        let mut follower = Follower::new(&scene, &options, FollowMode::Path { tolerance: 1e-3 }, [0, 59]);
        for number in 0..60 {
            let frame = follower.frame(number, &Work::alone()).expect("it can be solved");
            if number % 7 != 3 {
                continue;
            }
            let alone = &frames(&scene, &options, FollowMode::Fresh, &[number])[0];
            let told = frame.interpolated.expect("each frame has an error");
            let apart = apart(&frame.solution, &alone.solution);
            assert!(told <= 2e-3 && apart <= told.min(1e-3), "{motion} {number} {told} {apart}");
        }
        // No frame is solved twice, or in vain.
        assert!(follower.solved() <= most, "{motion}: {}", follower.solved());
    }
}

#[test]
fn frames_of_a_path_are_the_same_in_whatever_order_they_are_asked_for() {
    for motion in [GLOW, BENT] {
        let (scene, options) = (room(60, motion), Options { eps: 1e-4, ..options(Direct::Projected) });
        let way = FollowMode::Path { tolerance: 1e-3 };
        let forwards = frames(&scene, &options, way, &(0..60).collect::<Vec<_>>());
        let numbers = [59, 3, 31, 30, 29, 3, 0, 44, 45, 59];
        for (number, frame) in numbers.iter().zip(frames(&scene, &options, way, &numbers)) {
            let known = &forwards[*number];
            // They follow from other frames.
            let told = frame.interpolated.zip(known.interpolated).map(|(own, other)| own + other);
            let apart = apart(&frame.solution, &known.solution);
            assert!(told.is_some_and(|told| told <= 4e-3 && apart <= told), "{motion} {number} {apart}");
        }
    }
}

#[test]
fn what_cannot_be_interpolated_is_solved_frame_by_frame() {
    let (scene, options) = (room(12, PANEL), options(Direct::Projected));
    let mut follower = Follower::new(&scene, &options, FollowMode::Path { tolerance: 1e-9 }, [0, 11]);
    let frame = follower.frame(7, &Work::alone()).expect("it can be solved");
    assert_eq!(follower.segments(), Some(0));
    let alone = &frames(&scene, &options, FollowMode::Fresh, &[7])[0];
    let (told, apart) = (frame.interpolated.expect("an error"), apart(&frame.solution, &alone.solution));
    assert!(told <= 1e-8 && apart <= told, "{told} {apart}");
}

#[test]
fn what_moves_between_the_points_of_a_path_is_seen() {
    // At rest at all moments that are solved first, and away between them.
    let away = "surfaces = 'panel'
translate = { points = [[0, 0, 0], [0, 0, 0], [0.3, 0, 0], [0, 0, 0], [0, 0, 0]], times = [0, 18, 25, 32, 100] }";
    let (scene, options) = (room(101, away), options(Direct::Projected));
    let mut follower = Follower::new(&scene, &options, FollowMode::Path { tolerance: 1e-4 }, [0, 100]);
    for number in [5, 25, 60] {
        let frame = follower.frame(number, &Work::alone()).expect("it can be solved");
        let alone = &frames(&scene, &options, FollowMode::Fresh, &[number])[0];
        assert!(apart(&frame.solution, &alone.solution) <= 1e-4, "{number}");
    }
    assert!(follower.solved() < 60, "{}", follower.solved());
}

/// The error that a frame tells of what it leaves unsolved.
fn told(frame: &Frame) -> f64 {
    frame.interpolated.expect("light that follows from the frame before has an error")
}

#[test]
fn light_that_follows_from_the_frame_before_is_that_alone_within_what_is_told() {
    let numbers = [0, 1, 2, 9, 9, 3, 0];
    let ways =
        [(LAMP, Direct::Projected), (LAMP, Direct::Auto), (PANEL, Direct::Auto), (GLOW, Direct::Projected)];
    for (motion, direct) in ways {
        let (scene, options) = (room(12, motion), Options { eps: 1e-4, ..options(direct) });
        let followed = frames(&scene, &options, FollowMode::Incremental, &numbers);
        let alone = alone(&scene, &options, &numbers);
        for (frame, number) in followed.iter().zip(numbers) {
            let apart = apart(&frame.solution, &alone[&number].solution);
            assert!(apart <= told(frame) && told(frame) < 1e-4, "{motion} {number}: {apart:e}");
        }
    }
}

#[test]
fn solvers_find_the_difference_from_the_frame_before() {
    let (scene, numbers) = (room(12, PANEL), [0, 1, 11]);
    for name in ["gauss-seidel", "southwell", "cg", "lu"] {
        let solver = Method::named(name).expect("it is one of the list");
        let options = Options { solver, max_iterations: 10_000, ..options(Direct::Projected) };
        let followed = frames(&scene, &options, FollowMode::Incremental, &numbers);
        let alone = frames(&scene, &options, FollowMode::Fresh, &numbers);
        for (frame, alone) in followed.iter().zip(&alone) {
            let apart = apart(&frame.solution, &alone.solution);
            assert!(apart <= told(frame) && told(frame) < 1e-3, "{name}: {apart:e} {}", told(frame));
        }
    }
}

#[test]
fn rays_that_stand_give_the_light_of_fresh_ones_within_their_noise_and_come_back() {
    let flight = "[[motion]]\nsurfaces = 'ball'\ntranslate = { points = [[0, 0, 0], [0.3, 0.3, 0.2]] }";
    let turn = "[[motion]]\nsurfaces = 'lamp'\ntranslate = { points = [[0, 0, 0], [-0.5, -0.4, 0]] }\n[[motion]]\nsurfaces = 'plate'\nrotate = { center = [0.3, 0.7, 0.5], axis = [1, 1, 0], angles = [0, 200] }";
    // Over the floor: what lies on it changes. Out of the cube: so does how large the scene is.
    let slide = "[[motion]]\nsurfaces = 'tile'\ntranslate = { points = [[0, 0, 0], [0.5, 0.3, 0]] }";
    let away = "[[motion]]\nsurfaces = 'plate'\ntranslate = { points = [[0, 0, 0], [0, 0, 2]] }";
    let numbers = [0, 1, 2, 39, 20, 3, 0];
    for motion in [flight, turn, slide, away] {
        let scene = things(40, motion);
        let alone = frames(&scene, &by_rays(), FollowMode::Fresh, &numbers);
        let [single, many] = [1, 3].map(|threads| {
            let options = Options { threads, ..by_rays() };
            frames(&scene, &options, FollowMode::Incremental, &numbers)
        });
        for (((frame, other), alone), number) in single.iter().zip(&many).zip(&alone).zip(numbers) {
            assert!(bits(frame) == bits(other), "{motion} {number}: threads");
            let apart = apart(&frame.solution, &alone.solution);
            assert!(apart <= 2.0 * (frame.rays + alone.rays), "{motion} {number}: {apart} {}", frame.rays);
        }
        let back = apart(&single[6].solution, &single[0].solution);
        assert!(back <= 1e-3 || motion == slide, "{motion}: {back}");
    }
}
