//! Stages: movers placed by hand against frames of a path and scenes solved alone, and after what is refused.

use std::f64::consts::TAU;

use radiosity::Work;
use radiosity::geom::{DQuat, DVec3};
use radiosity::scene::{FaultKind, Pose, Scene};
use radiosity::solve::animation::error::AnimationError;
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::animation::stage::Stage;
use radiosity::solve::{Options, Transport};
use radiosity::work::interruption::{Interrupted, Interruption};
use radiosity_test_support::compare::{apart, assert_close};
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::outcome_of;

fn exact() -> Options {
    Options { order: 1, subdivide: Some(1), transport: Transport::Exact, ..Options::default() }
}

fn by_rays() -> Options {
    Options { order: 1, transport: Transport::Sampled, rays: Some(20_000), ..Options::default() }
}

fn stage(scene: &Scene, options: &Options) -> Stage {
    Stage::new(scene.clone(), options).expect("things can be moved")
}

fn frame(stage: &mut Stage) -> Frame {
    stage.frame(&Work::alone()).expect("it can be solved")
}

fn shift(x: f64, y: f64, z: f64) -> Pose {
    Pose::rigid(DVec3::ZERO, DQuat::IDENTITY, DVec3::new(x, y, z)).expect("it is a pose")
}

/// Relative error that a frame tells of what it leaves unsolved.
fn told(frame: &Frame) -> f64 {
    frame.interpolated.expect("it follows from the frame before")
}

#[test]
fn a_stage_that_is_led_along_a_path_shows_its_frames() {
    let scene = builtin("blue-panel");
    let animation = scene.animation.as_ref().expect("things move");
    assert!(scene.middle == DVec3::ZERO, "poses of the path are those of the file");
    for options in [exact(), by_rays()] {
        let mut stage = stage(&scene, &options);
        let mut follower = Follower::new(&scene, &options, FollowMode::Incremental, [0, 99]);
        for number in [0, 1, 2, 3, 40, 41, 99, 0] {
            let states = animation.states(number as f64).expect("there is such a frame");
            for (mover, state) in animation.movers.iter().zip(states) {
                stage.move_to(&mover.name, state.pose).expect("it is there");
            }
            let placed = frame(&mut stage);
            let followed = follower.frame(number, &Work::alone()).expect("it can be solved");
            let (apart, told) =
                (apart(&placed.solution, &followed.solution), told(&placed) + told(&followed));
            assert!(apart <= told && told < options.eps, "{number}: {apart:e} > {told:e}");
        }
        assert_eq!(stage.report().moments, 8);
    }
}

/// The stage after forty frames in which the lamp goes round and comes back, with its first and last one.
fn round(scene: &Scene, options: &Options) -> [Frame; 2] {
    const STEPS: u32 = 40;
    let mut stage = stage(scene, options);
    let first = frame(&mut stage);
    let mut last = None;
    for step in 1..=STEPS {
        let angle = if step == STEPS { 0.0 } else { TAU * f64::from(step) / f64::from(STEPS) };
        stage.move_to("lamp", shift(angle.cos() - 1.0, 0.5 * angle.sin(), 0.0)).expect("it is there");
        last = Some(frame(&mut stage));
    }
    [first, last.expect("there are frames")]
}

#[test]
fn a_loop_of_forty_frames_ends_where_it_began() {
    let scene = builtin("sliding-light");
    let [first, last] = round(&scene, &exact());
    let alone = outcome_of(&scene, &Options { tolerance: 1e-12, ..exact() }).solution;
    for frame in [&first, &last] {
        let (apart, told) = (apart(&frame.solution, &alone), told(frame));
        assert!(apart <= told && told < 0.1 * exact().eps, "{apart:e} > {told:e}");
    }
    let [first, last] = round(&scene, &by_rays());
    let apart = apart(&last.solution, &first.solution);
    assert!(apart < 1e-4, "{apart:e}");
}

#[test]
fn light_is_in_proportion_to_the_only_lamp_that_is_dimmed() {
    let mut stage = stage(&builtin("sliding-light"), &exact());
    let bright = frame(&mut stage);
    // Bands that are dimmed unlike each other choose other rules for direct light, to the accuracy of blocks.
    for (factors, accuracy) in [([0.5; 3], 1e-4), ([0.5, 1.0, 0.0], exact().eps), ([1.0; 3], 1e-4)] {
        stage.emit("lamp", &factors).expect("it is there");
        let dim = frame(&mut stage);
        for (band, factor) in factors.into_iter().enumerate() {
            for surface in 0..6 {
                let [dim, bright] = [&dim, &bright].map(|own| own.solution.mean_irradiance(band, surface));
                assert_close(dim, factor * bright, accuracy);
            }
        }
    }
}

/// A room far from the origin with a plate that turns by a quarter in frame 1, about an edge of it.
const FAR: &str = r#"
frames = 2
materials.wall = { reflectance = 0.5 }
materials.lamp = { reflectance = 0, emission = 1 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [1000000, 2000000, 0], size = [1, 1, 1], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [1000000.25, 2000000.25, 0.75], edge1 = [0, 0.5, 0], edge2 = [0.5, 0, 0] }
[[motion]]
name = "plate"
surfaces = "lamp"
rotate = { center = [1000000.25, 2000000.5, 0.75], axis = [0, 1, 0], angles = [0, 90] }
translate = { points = [[0, 0, 0], [0.125, 0, 0]] }
"#;

#[test]
fn poses_are_in_the_coordinates_of_the_file() {
    let scene = typed(FAR);
    assert!(scene.middle.x > 1e5, "coordinates are about the middle");
    let mut stage = stage(&scene, &exact());
    let (center, shift) = (DVec3::new(1_000_000.25, 2_000_000.5, 0.75), DVec3::new(0.125, 0.0, 0.0));
    let quarter = DQuat::from_axis_angle(DVec3::Y, 0.25 * TAU);
    stage.move_to("plate", Pose::rigid(center, quarter, shift).expect("it is a pose")).expect("it is there");
    let placed = frame(&mut stage);
    let alone = outcome_of(&scene.at_frame(1).expect("there is one"), &exact()).solution;
    // Coordinates of 2·10⁶ round to 2e-10.
    let apart = apart(&placed.solution, &alone);
    assert!(apart <= told(&placed) + 1e-8, "{apart:e}");
}

/// A room with a lamp, and a panel that is as large as a shelf in it.
const ROOM: &str = r#"
bands = ["a", "b"]
frames = 1
materials.wall = { reflectance = [0.7, 0.4] }
materials.lamp = { reflectance = 0, emission = [10, 5] }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0.25, 0.5, 0.875], edge1 = [0, 0.25, 0], edge2 = [0.25, 0, 0] }
[[surfaces]]
name = "panel"
material = "wall"
two_sided = true
parallelogram = { origin = [0.125, 0.25, 0.625], edge1 = [0.25, 0, 0], edge2 = [0, 0.25, 0] }
[[surfaces]]
name = "shelf"
material = "wall"
two_sided = true
parallelogram = { origin = [0.625, 0.25, 0.25], edge1 = [0.25, 0, 0], edge2 = [0, 0.25, 0] }
[[motion]]
name = "lamp"
surfaces = "lamp"
emission = { factors = [1, 1] }
[[motion]]
name = "panel"
surfaces = "panel"
translate = { points = [[0, 0, 0], [0, 0, 0]] }
"#;

/// Asserts that a stage has the light of its scene alone, within what it says that it is off by.
fn assert_right(stage: &mut Stage, options: &Options) {
    let found = frame(stage);
    let alone = outcome_of(&found.scene, &Options { tolerance: 1e-12, ..*options }).solution;
    let (apart, told) = (apart(&found.solution, &alone), told(&found));
    assert!(apart <= told && told < 0.1 * options.eps, "{apart:e} > {told:e}");
}

#[test]
fn a_stage_goes_on_after_what_is_refused_and_after_interruptions() {
    let options = exact();
    let mut stage = stage(&typed(ROOM), &options);
    let unknown = stage.move_to("pannel", Pose::REST).expect_err("there is none").to_string();
    assert!(unknown.contains("unknown motion \"pannel\""), "{unknown}");
    stage.emit("pannel", &[1.0; 2]).expect_err("there is none");
    frame(&mut stage);
    let bad_factors: [(&str, &[f64], FaultKind); 4] = [
        ("lamp", &[1.0], FaultKind::WrongCount),
        ("lamp", &[1.0, -0.5], FaultKind::OutOfRange),
        ("lamp", &[1.0, f64::NAN], FaultKind::NotFinite),
        ("panel", &[0.5; 2], FaultKind::Absent),
    ];
    for (mover, factors, kind) in bad_factors {
        stage.emit(mover, factors).expect("it is there");
        assert_eq!(refused(&mut stage), kind, "{mover} {factors:?}");
        stage.emit(mover, &[1.0; 2]).expect("it is there");
    }
    stage.move_to("panel", shift(0.25, 0.0, 0.0)).expect("it is there");
    assert_right(&mut stage, &options);
    stage.move_to("panel", shift(0.5, 0.0, -0.375)).expect("it is there");
    assert_eq!(refused(&mut stage), FaultKind::Coincident, "it is where the shelf is");
    stage.move_to("panel", shift(1e12, 0.0, 0.0)).expect("it is there");
    assert_eq!(refused(&mut stage), FaultKind::OutOfRange);
    stage.move_to("panel", shift(0.25, 0.0, -0.25)).expect("it is there");
    stage.emit("lamp", &[0.5, 2.0]).expect("it is there");
    assert_right(&mut stage, &options);
    stage.move_to("panel", shift(0.0, 0.25, 0.0)).expect("it is there");
    let interruption = Interruption::new();
    interruption.raise();
    let interrupted = interruption.within(|| stage.frame(&Work::alone()));
    assert!(matches!(interrupted, Err(Interrupted)));
    assert_right(&mut stage, &options);
    assert_eq!(stage.report().moments, 4, "those that were refused do not count");
}

/// Kind of the fault for which a stage has no frame.
fn refused(stage: &mut Stage) -> FaultKind {
    match stage.frame(&Work::alone()) {
        Err(AnimationError::Scene(error)) => error.fault.kind,
        Err(error) => panic!("{error}"),
        Ok(_) => panic!("there is a frame"),
    }
}

#[test]
fn a_stage_is_of_a_scene_in_which_something_moves() {
    let error = Stage::new(builtin("furnace-cube"), &Options::default()).expect_err("nothing moves");
    assert!(error.to_string().contains("nothing moves in the scene"), "{error}");
}
