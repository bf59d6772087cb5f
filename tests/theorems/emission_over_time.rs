//! Emission over time: frames against scenes in which it is typed directly, the linearity of light in it, and
//! what is refused.

use std::sync::Arc;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use radiosity::Solution;
use radiosity::Work;
use radiosity::geom::{DQuat, DVec3};
use radiosity::reading::files::solution_file::{SolutionFile, read as read_solution};
use radiosity::scene::{
    Clock, Curve, EmissionTrack, FrameScenes, MoverDraft, MoverState, Notation, Pose, RigidPath, Scene,
    SceneBuilder, SceneError, SceneSurface, Source,
};
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::animation::sequence::Sequence;
use radiosity::solve::{Direct, Options, Transport};
use radiosity_test_support::compare::{apart, assert_close};
use radiosity_test_support::scenes::{lamps_room, material, parsed, typed};
use radiosity_test_support::shapes::{ball, plate};
use radiosity_test_support::solved::{outcome_of, solved_of};

/// A room with a block and a panel, a lamp and a glow in groups of their own, and a spot without one, each of
/// this emission in two bands.
fn text(lamp: [f64; 2], glow: [f64; 2], spot: [f64; 2]) -> String {
    let material = format!("materials.spot = {{ reflectance = 0, emission = {spot:?} }}");
    let surface = r#"
[[surfaces]]
name = "spot"
material = "spot"
parallelogram = { origin = [0.7, 0.1, 0.8], edge1 = [0, 0.1, 0], edge2 = [0.1, 0, 0] }
"#;
    lamps_room([lamp, glow], &material, surface)
}

const LAMP: [f64; 2] = [10.0, 5.0];
const GLOW: [f64; 2] = [1.0, 2.0];
const SPOT: [f64; 2] = [3.0, 0.0];

fn room(frames: usize, motions: &str) -> Scene {
    typed(&format!("frames = {frames}\n{}{motions}", text(LAMP, GLOW, SPOT)))
}

/// All lamps of the room change, one by its group: frames 0 to 8, in frame 4 all are off.
const DIMMED: &str = r#"
[[motion]]
groups = "lamp"
emission = { factors = [1, 0, [0.5, 0.25]] }
[[motion]]
surfaces = "glow"
emission = { factors = [[0, 2], 0, 0], times = [2, 4, 5] }
[[motion]]
surfaces = "spot"
emission = { factors = [1, 1, 0, 0, 4], times = [0, 2, 3, 7, 8] }
"#;

/// Factors of the lamp, the glow and the spot in a frame of [`DIMMED`], all of them exact.
fn dimmed(frame: usize) -> [[f64; 2]; 3] {
    let t = frame as f64;
    let lamp = if t <= 4.0 { [1.0 - t / 4.0; 2] } else { [0.5, 0.25].map(|most| most * (t - 4.0) / 4.0) };
    let glow = [0.0, if t <= 2.0 { 2.0 } else { (4.0 - t).max(0.0) }];
    let spot = if t <= 2.0 {
        1.0
    } else if t < 8.0 {
        0.0
    } else {
        4.0
    };
    [lamp, glow, [spot; 2]]
}

/// The room as a frame of [`DIMMED`] shows it, typed.
fn typed_frame(frame: usize) -> Scene {
    let times = |emission: [f64; 2], factors: [f64; 2]| [emission[0] * factors[0], emission[1] * factors[1]];
    let [lamp, glow, spot] = dimmed(frame);
    typed(&text(times(LAMP, lamp), times(GLOW, glow), times(SPOT, spot)))
}

fn exact(direct: Direct) -> Options {
    Options { order: 1, subdivide: Some(1), transport: Transport::Exact, direct, ..Options::default() }
}

fn by_rays() -> Options {
    Options { order: 1, transport: Transport::Sampled, rays: Some(20_000), ..Options::default() }
}

fn bits(solution: &Solution) -> Vec<u64> {
    let bands = solution.bands().iter().map(|band| &band.coefficients);
    let all = bands.flat_map(|own| own.irradiance.iter().chain(&own.direct).chain(&own.radiosity));
    all.map(|x| x.to_bits()).collect()
}

fn frames(scene: &Scene, options: &Options, mode: FollowMode, numbers: &[usize]) -> Vec<Frame> {
    let mut follower = Follower::new(scene, options, mode, [0, scene.frames() - 1]);
    numbers.iter().map(|frame| follower.frame(*frame, &Work::alone()).expect("it can be solved")).collect()
}

/// Forwards, backwards, at once to the end, and the same again.
const NUMBERS: [usize; 8] = [0, 1, 4, 5, 4, 8, 8, 0];

#[test]
fn frames_are_scenes_in_which_the_emission_is_typed_to_the_bit() {
    let scene = room(9, DIMMED);
    for options in [exact(Direct::Auto), exact(Direct::Projected), by_rays()] {
        let alone: Vec<Vec<u64>> =
            (0..9).map(|k| bits(&outcome_of(&typed_frame(k), &options).solution)).collect();
        assert!(alone[0] != alone[1] && alone[4].iter().all(|x| f64::from_bits(*x) == 0.0));
        let mut modes = vec![FollowMode::Fresh, FollowMode::Selective];
        // Nothing moves: no block is a sum.
        modes.extend(
            (options.transport == Transport::Exact).then_some(FollowMode::Series { tolerance: 1e-4 }),
        );
        for mode in modes {
            for (number, frame) in NUMBERS.iter().zip(frames(&scene, &options, mode, &NUMBERS)) {
                assert!(bits(&frame.solution) == alone[*number], "{mode:?} {number} {:?}", options.transport);
            }
        }
    }
}

#[test]
fn what_is_dimmed_and_moved_keeps_the_blocks_that_nothing_moves_past() {
    let motions = format!(
        "{DIMMED}[[motion]]\nsurfaces = 'panel'\ntranslate = {{ points = [[0, 0, 0], [0.4, 0, 0]] }}\n\
         rotate = {{ center = [0.25, 0.65, 0.6], axis = [1, 1, 0], angles = [0, 25] }}\n"
    );
    let scene = room(9, &motions);
    for options in [exact(Direct::Projected), by_rays()] {
        let fresh = frames(&scene, &options, FollowMode::Fresh, &NUMBERS);
        let kept = frames(&scene, &options, FollowMode::Selective, &NUMBERS);
        for ((fresh, kept), number) in fresh.iter().zip(&kept).zip(NUMBERS) {
            assert!(bits(&fresh.solution) == bits(&kept.solution), "{number} {:?}", options.transport);
        }
    }
    // A lamp that slides while it fades: its blocks are sums of series.
    let slides = "[[motion]]\nsurfaces = 'lamp'\ntranslate = { points = [[0, 0, 0], [0.1, 0, 0]] }\n\
                  emission = { factors = [0, 1] }\n";
    let scene = room(60, slides);
    let numbers = [0, 1, 2, 3, 30, 31, 59];
    let options = exact(Direct::Projected);
    let fresh = frames(&scene, &options, FollowMode::Fresh, &numbers);
    let series = frames(&scene, &options, FollowMode::Series { tolerance: 1e-6 }, &numbers);
    for ((fresh, series), number) in fresh.iter().zip(&series).zip(numbers) {
        let (apart, told) = (apart(&series.solution, &fresh.solution), series.interpolated.unwrap_or(0.0));
        assert!(apart <= told + 1e-9, "{number}: {apart:e} > {told:e}");
    }
}

#[test]
fn nothing_is_integrated_or_traced_where_emission_alone_changes() {
    let scene = room(9, DIMMED);
    let mut sequence = Sequence::new(&scene, &exact(Direct::Projected));
    sequence.at(0.0, &Work::alone()).expect("it can be solved");
    sequence.at(1.0, &Work::alone()).expect("it can be solved");
    assert_eq!(sequence.integrated(), 0);
    assert!(sequence.recalled() > 0);
}

#[test]
fn light_that_follows_from_the_frame_before_goes_out_and_comes_back() {
    let scene = room(9, DIMMED);
    for options in [exact(Direct::Auto), exact(Direct::Projected), by_rays()] {
        let fresh = frames(&scene, &options, FollowMode::Fresh, &NUMBERS);
        let followed = frames(&scene, &options, FollowMode::Incremental, &NUMBERS);
        for ((fresh, followed), number) in fresh.iter().zip(&followed).zip(NUMBERS) {
            if number == 4 {
                assert!(bits(&followed.solution).iter().all(|x| f64::from_bits(*x) == 0.0), "it is dark");
                continue;
            }
            // By rays that stand each has noise of its own; else the difference is solved to 1e-5.
            let most = if fresh.rays > 0.0 { 2.0 * (fresh.rays + followed.rays) } else { 1e-4 };
            let apart = apart(&followed.solution, &fresh.solution);
            assert!(apart <= most, "{number} {:?}: {apart:e}", options.transport);
        }
    }
}

#[test]
fn light_between_bends_of_the_emission_is_interpolated() {
    let scene = room(
        161,
        &DIMMED.replace("[2, 4, 5]", "[40, 80, 100]").replace("[0, 2, 3, 7, 8]", "[0, 40, 60, 140, 160]"),
    );
    for options in [exact(Direct::Projected), exact(Direct::Auto), by_rays()] {
        let mut path = Follower::new(&scene, &options, FollowMode::Path { tolerance: 1e-4 }, [0, 160]);
        let numbers = [0, 7, 33, 40, 61, 79, 80, 81, 99, 120, 147, 160];
        let fresh = frames(&scene, &options, FollowMode::Fresh, &numbers);
        for (number, fresh) in numbers.iter().zip(&fresh) {
            let frame = path.frame(*number, &Work::alone()).expect("it can be solved");
            // By rays each frame has noise of its own.
            let told = frame.interpolated.expect("an error");
            let most = if fresh.rays > 0.0 { 2.0 * fresh.rays + 2.0 * frame.rays } else { told };
            // By rays less is solved for.
            let expected = if fresh.rays > 0.0 { 1e-3 } else { 1e-4 };
            assert!(told <= expected || *number == 80, "{number}: {told}");
            assert!(apart(&frame.solution, &fresh.solution) <= most || *number == 80, "{number}");
            if *number == 80 {
                let whole =
                    |own: &Frame| own.solution.mean_irradiance(0, 0) + own.solution.mean_irradiance(1, 1);
                assert_eq!([whole(&frame), whole(fresh)], [0.0; 2]);
            }
        }
        // Linear between the bends at 0, 40, 60, 80, 100, 140 and 160: each five frames to look at, three points
        // more and a frame between.
        assert!(path.solved() <= 6 * 9 + 6, "{}", path.solved());
    }
}

#[test]
fn bends_are_those_of_paths_and_of_emission() {
    let motions = "[[motion]]\nsurfaces = 'lamp'\ntranslate = { points = [[0,0,0], [0.1,0,0]], times = [1, 3] }\n\
                   emission = { factors = [1, 0, 1], times = [0, 2, 3] }\n\
                   [[motion]]\nsurfaces = 'glow'\nemission = { factors = [1, 0], times = [0.25, 3.5] }\n";
    let scene = typed(&format!("frames = 9\nfps = 2\n{}{motions}", text(LAMP, GLOW, SPOT)));
    assert_eq!(scene.animation.unwrap().bends(), [0.0, 0.5, 2.0, 4.0, 6.0, 7.0]);
}

/// The emission of a surface and some of its points, to the bit.
fn held(surface: &SceneSurface) -> (Vec<u64>, Vec<[u64; 3]>) {
    let places = [-1.0, -0.3, 0.4, 1.0];
    let points = places.iter().flat_map(|u| places.iter().map(|v| surface.shape.jet(*u, *v).position));
    let emitted = surface.material.emission.iter().chain(surface.flux.iter().flatten());
    (emitted.map(|x| x.to_bits()).collect(), points.map(|x| x.to_array().map(f64::to_bits)).collect())
}

/// A room with light of every kind: a flux of two sides, a pattern, a window with a sun, a point, an area.
const EVERY_LIGHT: &str = r#"
frames = 3
bands = ["a", "b"]
materials.wall = { reflectance = 0.5 }
materials.slope = { reflectance = 0.1, emission = { polynomial = [[0, 0, 2.0], [1, 0, 1.5]] } }
sky = { model = "clear", illuminance = [800, 1000], ground = 0.2, sun = { elevation = 30, azimuth = 180, illuminance = [4000, 5000] } }
[[surfaces]]
name = "floor"
material = "wall"
parallelogram = { origin = [0, 0, 0], edge1 = [4, 0, 0], edge2 = [0, 4, 0] }
[[surfaces]]
name = "ball"
material = "wall"
flux = [7, 9]
two_sided = true
parallelogram = { origin = [1, 1, 0.5], edge1 = [0.5, 0, 0], edge2 = [0, 0.5, 0] }
[[surfaces]]
name = "slope"
material = "slope"
parallelogram = { origin = [3, 3, 1], edge1 = [0, 0.5, 0], edge2 = [0.5, 0, 0] }
[[surfaces]]
name = "window"
material = "wall"
opening = true
quad = { vertices = [[3, 0, 1], [1, 0, 1], [1, 0, 2.2], [3, 0, 2.2]] }
[[luminaires]]
name = "bulb"
position = [3, 1, 2]
flux = [10, 20]
point = {}
[[luminaires]]
name = "disk"
position = [1, 3, 2]
extent = 0.3
flux = [30, 40]
spot = { exponent = 2 }
"#;

fn every_light(motion: &str) -> Scene {
    typed(&format!("{EVERY_LIGHT}{motion}"))
}

/// The mean irradiance of the floor in both bands.
fn on_floor(scene: &Scene) -> [f64; 2] {
    let solution = outcome_of(scene, &exact(Direct::Split)).solution;
    [0, 1].map(|band| solution.mean_irradiance(band, 0))
}

#[test]
fn light_of_every_kind_is_multiplied_band_by_band() {
    let names = [
        ("surfaces", "ball"),
        ("surfaces", "slope"),
        ("surfaces", "window"),
        ("luminaires", "bulb"),
        ("luminaires", "disk"),
    ];
    let motion = |(key, name): (&str, &str), factors: &str| {
        format!("[[motion]]\nname = '{name}'\n{key} = '{name}'\nemission = {{ factors = [1, {factors}] }}\n")
    };
    let all = |factors: &str| every_light(&names.map(|name| motion(name, factors)).concat());
    let rest = on_floor(&all("1"));
    assert!(rest.iter().all(|light| *light > 1.0), "{rest:?}");
    // All of them alike: all light is, but for roundings: bands weigh otherwise, by which openings are cut otherwise.
    let scene = all("[0.5, 0.25]");
    let found = on_floor(&scene.at_frame(2).unwrap());
    for (found, right) in found.iter().zip([0.5 * rest[0], 0.25 * rest[1]]) {
        assert_close(*found, right, 1e-9);
    }
    // Each by itself: what one adds, half of it is left, but for cells, which are divided by what arrives in
    // all. What is not dimmed stays to the bit.
    for own in names {
        let light = |factors: &str| on_floor(&every_light(&motion(own, factors)).at_frame(2).unwrap());
        let [off, half] = [light("0"), light("0.5")];
        for band in 0..2 {
            assert!(off[band] < rest[band] * (1.0 - 1e-6), "{own:?}: it shines on the floor");
            assert_close(half[band], 0.5 * (off[band] + rest[band]), 1e-4);
        }
        let scene = every_light(&motion(own, "0.5"));
        for (still, rest) in scene.at_frame(2).unwrap().surfaces.iter().zip(&scene.surfaces) {
            assert!(still.name.starts_with(own.1) || held(still) == held(rest), "{own:?} {}", still.name);
        }
    }
    let still = scene.at_frame(2).unwrap();
    let [ball, slope] = ["ball:back", "slope"].map(|name| still.surface_named(name).unwrap());
    assert_eq!(still.surfaces[ball].flux, Some(vec![0.5 * 3.5, 0.25 * 4.5]));
    assert_eq!(still.surfaces[slope].exitance_at(1, [-1.0, 0.3]), 0.25 * 0.5);
    assert_eq!([0, 1].map(|band| still.luminaires[0].flux(band)), [5.0, 5.0]);
}

#[test]
fn what_is_at_factor_one_stays_to_the_bit() {
    let scene = every_light(
        "[[motion]]\nsurfaces = ['ball', 'slope', 'window']\nluminaires = '*'\nemission = { factors = [1, 1, 0.3], times = [0, 1, 2] }\n",
    );
    for moment in [0.0, 0.3, 0.77, 1.0] {
        let still = scene.at_moment(moment).unwrap();
        for (own, rest) in still.surfaces.iter().zip(&scene.surfaces) {
            assert_eq!(held(own), held(rest));
            assert!(own.material == rest.material && own.emission_factors.is_none());
        }
        for (own, rest) in still.luminaires.iter().zip(&scene.luminaires) {
            assert_eq!(own.strength, rest.strength);
        }
    }
}

#[test]
fn names_mean_groups_as_well() {
    let path = "translate = { points = [[0, 0, 0], [0.01, 0, 0]] }";
    let moved = |which: &str| {
        let scene = room(3, &format!("[[motion]]\n{which}\n{path}\n"));
        let animation = scene.animation.as_ref().unwrap();
        let names = animation.movers[0].surfaces.iter().map(|index| scene.surfaces[*index].name.clone());
        names.collect::<Vec<_>>().join(" ")
    };
    assert_eq!(moved("groups = 'lamp'"), "lamp");
    assert_eq!(moved("groups = ['lamp', 'g*']\nsurfaces = 'lamp'"), "lamp glow");
}

#[test]
fn a_light_group_that_is_off_is_still_one() {
    let scene = room(9, DIMMED);
    let names = |scene: &Scene| -> Vec<String> {
        scene.light_groups().iter().map(|group| group.name.clone()).collect()
    };
    let dark = scene.at_frame(4).unwrap();
    assert_eq!(names(&dark), ["lamp", "glow"]);
    assert!(dark.require_light().is_ok() && dark.surfaces.iter().all(|own| !own.material.emits()));
    // Factors of groups and of motions multiply.
    let set = scene.dimmed(&[("lamp", 0.5)]).unwrap();
    let lamp = scene.surface_named("lamp").unwrap();
    assert_eq!(set.at_frame(2).unwrap().surfaces[lamp].exitance(0), 10.0 * 0.5 * 0.5);
    // A solution of the dark frame is read back.
    let solved = solved_of(dark.dimmed(&[("lamp", 0.5)]).unwrap(), exact(Direct::Projected));
    let text = serde_json::to_string(&SolutionFile::new(&solved)).unwrap();
    let again = read_solution(&Source::new("a.json", &text)).unwrap();
    assert_eq!(names(&again.scene), ["lamp", "glow"]);
    assert_eq!(serde_json::to_string(&SolutionFile::new(&again)).unwrap(), text);
}

#[test]
fn texts_and_sources_keep_the_emission() {
    let curved = "[[motion]]\nsurfaces = 'lamp'\nemission = { factors = [1, [0.3, 0.2], 1, 0.5], times = [0, 1, 2, 8], curve = 'spline' }\n";
    let scene = room(9, curved);
    for notation in [Notation::Toml, Notation::Json] {
        let again = parsed(&Source::new("room", &radiosity::language::text(&scene, notation).unwrap()));
        for moment in [0.0, 0.4, 1.0, 3.7, 8.0] {
            let [one, other] =
                [&scene, &again].map(|own| own.animation.as_ref().unwrap().states(moment).unwrap());
            assert_eq!(one, other);
        }
    }
    let still = scene.at_moment(3.7).unwrap();
    let again = parsed(still.source.as_ref().unwrap());
    for (one, other) in still.surfaces.iter().zip(&again.surfaces) {
        assert_eq!(held(one), held(other));
    }
}

#[test]
fn scenes_made_in_code_are_dimmed_as_those_of_files() {
    let track = |factors: &[f64]| {
        let factors: Vec<Vec<f64>> = factors.iter().map(|own| vec![*own]).collect();
        EmissionTrack::new(&factors, vec![0.0, 10.0], Curve::Line).unwrap()
    };
    let build = |mover: MoverDraft| {
        let mut room = SceneBuilder::new("room", ["grey"]);
        let white = room.material("white", material(0.5, 8.0));
        let dark = room.material("dark", material(0.5, 0.0));
        room.surface("floor", plate(DVec3::ZERO, DVec3::X, DVec3::Y), &dark);
        room.surface("ball", ball(DVec3::Z, 0.25), &white).group("balls");
        room.clock(Clock::new(11, 1.0).unwrap());
        room.moves(mover);
        room.build()
    };
    let fading = || MoverDraft::new("fade", RigidPath::REST).emission(track(&[1.0, 0.0]));
    for mover in [fading().surface("ball"), fading().group("balls")] {
        let scene = build(mover).unwrap();
        assert_eq!(scene.at_frame(5).unwrap().surfaces[1].material.emission, [4.0]);
        assert!(!scene.animation.unwrap().movers[0].has_path());
    }
    let refused = |mover: MoverDraft| build(mover).unwrap_err().to_string();
    assert_eq!(
        refused(fading().surface("floor")),
        "room: motion \"fade\": nothing that the motion names emits light"
    );
    assert_eq!(refused(fading().group("ball")), "room: motion \"fade\": unknown light group \"ball\"");
    let two = EmissionTrack::new(&[vec![1.0; 2], vec![0.0; 2]], vec![0.0, 1.0], Curve::Line).unwrap();
    let two = MoverDraft::new("fade", RigidPath::REST).emission(two).surface("ball");
    assert_eq!(
        refused(two),
        "room: motion \"fade\": the list of factors of a time takes 1, one of each band, found 2"
    );
}

fn read(motion: &str) -> Result<Scene, SceneError> {
    let camera = "camera = { eye = [0.5, 0.1, 0.5], target = [0.5, 1, 0.5] }";
    let text = format!("frames = 11\n{camera}\n{}{motion}\n", text(LAMP, GLOW, SPOT));
    radiosity::language::read(&Source::new("room.toml", &text))
}

/// Whatever is wrong is told where it stands, with a cure.
#[test]
fn emissions_that_make_no_sense_are_refused() {
    let cases: [(&str, &str, &str); 17] = [
        ("surfaces = 'lmap'\nDIM", "unknown surface \"lmap\"", "did you mean \"lamp\"?"),
        ("groups = 'lamps'\nDIM", "unknown light group \"lamps\"", "did you mean \"lamp\"?"),
        ("DIM", "nothing moves", "say what moves"),
        ("surfaces = 'lamp'", "nothing says how it moves", "emission = { factors = [1, 0] }"),
        ("surfaces = 'block'\nDIM", "nothing that the motion names emits light", "emission above 0"),
        ("surfaces = 'block'\nDIM\nPATH", "nothing that the motion names emits light", "leave emission out"),
        (
            "surfaces = ['lamp', 'panel']\nDIM",
            "\"panel\" emits nothing that could change, and the motion has no path",
            "take it out of the motion, or add translate",
        ),
        (
            "surfaces = 'lamp'\ncamera = true\nDIM",
            "the camera emits nothing that could change, and the motion has no path",
            "add translate or rotate",
        ),
        ("camera = true\nDIM\nPATH", "nothing that the motion names emits light", "leave emission out"),
        (
            "surfaces = 'lamp'\nemission = { factors = [1] }",
            "factors takes at least two, found 1",
            "give at least two",
        ),
        (
            "surfaces = 'lamp'\nemission = { factors = [1, -0.5] }",
            "the factor is -0.5, outside factor ≥ 0",
            "choose a value with factor ≥ 0",
        ),
        (
            "surfaces = 'lamp'\nemission = { factors = [1, nan] }",
            "NaN is not a finite number",
            "write a finite number",
        ),
        (
            "surfaces = 'lamp'\nemission = { factors = [1, [1, 1, 0]] }",
            "the list of factors of a time takes one number for all bands or 2, one per band, found 3",
            "give one number for all bands or 2",
        ),
        (
            "surfaces = 'lamp'\nemission = { factors = [1, 0], times = [3, 2] }",
            "the times do not ascend: 2 follows 3",
            "larger than the one before",
        ),
        ("surfaces = 'lamp'\nemission = { }", "the key \"factors\" is missing", "a list with one per band"),
        (
            "surfaces = 'lamp'\nemission = { factor = [1, 0] }",
            "unknown key \"factor\"",
            "did you mean \"factors\"?",
        ),
        (
            "name = 'swing'\nsurfaces = 'lamp'\nPATH\n[[motion]]\ngroups = 'lamp'\nDIM",
            "surface \"lamp\" belongs to the motion \"swing\" already",
            "a motion may turn, translate and dim at once",
        ),
    ];
    for (motion, message, cure) in cases {
        let motion = motion.replace("DIM", "emission = { factors = [1, 0] }");
        let motion = motion.replace("PATH", "translate = { points = [[0,0,0],[1,0,0]] }");
        let error = read(&format!("[[motion]]\n{motion}")).expect_err(&motion);
        assert!(error.to_string().ends_with(message), "{motion}: {error}");
        assert!(error.to_string().contains(": motion \""), "{motion}: {error}");
        assert!(error.cure().is_some_and(|found| found.contains(cure)), "{motion}: {:?}", error.cure());
        let first = text(LAMP, GLOW, SPOT).lines().count();
        assert!(error.place.is_some_and(|place| place.line > first), "{motion}");
    }
    // Colours alone make the scene one of three bands.
    let colours = "frames = 2\nmaterials.lamp = { reflectance = 0, emission = 1 }\n[[surfaces]]\nname = 'lamp'\nmaterial = 'lamp'\n\
                   sphere = { center = [0,0,0], radius = 1 }\n[[motion]]\nsurfaces = 'lamp'\nemission = { factors = [1, [1, 0.6, 0.3]] }\n";
    let sunset = typed(colours).at_frame(1).unwrap();
    assert_eq!((sunset.bands.len(), &sunset.surfaces[0].material.emission), (3, &vec![1.0, 0.6, 0.3]));
}

const SWING: &str = "[[motion]]\nname = 'swing'\nsurfaces = 'lamp'\n\
                     rotate = { center = [0.3, 0.5, 1], axis = [0, 1, 0], angles = [0, 10] }\n\
                     translate = { points = [[0, 0, 0], [0.1, 0, -0.1]] }\nemission = { factors = [1, [0.5, 0.2]] }\n\
                     [[motion]]\nname = 'panel'\nsurfaces = 'panel'\ntranslate = { points = [[0, 0, 0], [0.2, 0, 0]] }\n";

#[test]
fn movers_that_are_placed_make_the_scene_of_the_moment_that_has_their_states() {
    let scene = room(11, SWING);
    let (mut placed, mut at) = (FrameScenes::of(&scene), FrameScenes::of(&scene));
    for moment in [0.0, 3.0, 7.25, 10.0] {
        let states = scene.animation.as_ref().unwrap().states(moment).unwrap();
        let (own, other) = (placed.placed(&states).unwrap(), at.at(moment).unwrap());
        assert_eq!(
            own.surfaces.iter().map(held).collect::<Vec<_>>(),
            other.surfaces.iter().map(held).collect::<Vec<_>>()
        );
        assert!(own.name == scene.name && own.source.is_none() && own.animation.is_none());
    }
    // What stays where it was is the same in memory.
    let lamp = scene.surface_named("lamp").unwrap();
    let shift = |x: f64| Pose::rigid(DVec3::ZERO, DQuat::IDENTITY, DVec3::new(x, 0.0, 0.0)).unwrap();
    let state = |x: f64, factors: &[f64]| MoverState { pose: shift(x), factors: factors.to_vec() };
    let first = placed.placed(&[state(0.05, &[]), MoverState::REST]).unwrap();
    let next = placed.placed(&[state(0.05, &[0.0, 2.0]), state(0.1, &[])]).unwrap();
    let same = |index: usize| Arc::ptr_eq(&first.surfaces[index].shape, &next.surfaces[index].shape);
    let panel = scene.surface_named("panel").unwrap();
    assert!(same(lamp) && !same(panel) && (0..lamp).all(same));
    assert_eq!(first.surfaces[lamp].material, scene.surfaces[lamp].material);
    assert_eq!(next.surfaces[lamp].material.emission, [0.0, 10.0]);
    let corner = |scene: &Scene| scene.surfaces[lamp].shape.jet(-1.0, -1.0).position;
    assert!(corner(&first).distance(corner(&scene) + DVec3::new(0.05, 0.0, 0.0)) < 1e-15);
}

#[test]
fn states_that_cannot_be_are_refused_without_a_frame() {
    let scene = room(11, SWING);
    let refused = |states: &[MoverState]| {
        let error = FrameScenes::of(&scene).placed(states).unwrap_err();
        (error.to_string(), error.cure().unwrap_or_default())
    };
    let dims = |factors: &[f64]| MoverState { pose: Pose::REST, factors: factors.to_vec() };
    let moves = |shift: [f64; 3]| MoverState {
        pose: Pose::rigid(DVec3::ZERO, DQuat::IDENTITY, DVec3::from_array(shift)).unwrap(),
        factors: Vec::new(),
    };
    let told = |states: &[MoverState], message: &str, cure: &str| {
        let (found, advice) = refused(states);
        assert!(found.ends_with(message), "{found}");
        assert!(advice.contains(cure), "{advice}");
        assert!(!found.contains("frame"), "{found}");
    };
    told(&[MoverState::REST], "the list of states takes 2, one for each mover, found 1", "give 2");
    let rest = || MoverState::REST;
    told(
        &[dims(&[1.0]), rest()],
        "motion \"swing\": the list of factors takes 2 numbers, one per band, found 1",
        "give 2",
    );
    told(
        &[dims(&[1.0, -1.0]), rest()],
        "motion \"swing\": the factor is -1, outside factor ≥ 0",
        "factor ≥ 0",
    );
    told(&[dims(&[1.0, f64::NAN]), rest()], "motion \"swing\": NaN is not a finite number", "finite");
    told(
        &[rest(), dims(&[1.0, 0.5])],
        "motion \"panel\": nothing that moves with it emits light",
        "leave its factors empty",
    );
    // The lamp into the place of the spot is another size; the panel onto itself is at rest.
    let far = &[moves([1e12, 0.0, 0.0]), rest()];
    told(far, "it is 1.0e12 away from the origin, too far for its size", "keep the pose near the scene");
    let balls = typed(
        "frames = 1\nmaterials.white = { reflectance = 0.5 }\n[[surfaces]]\nname = \"a\"\nsphere = { center = [0, 0, 0], radius = 1 }\n\
         [[surfaces]]\nname = \"b\"\nsphere = { center = [4, 0, 0], radius = 1 }\n\
         [[motion]]\nsurfaces = [\"b\"]\ntranslate = { points = [[0, 0, 0], [0, 0, 4]] }\n",
    );
    let error = FrameScenes::of(&balls).placed(&[moves([-4.0, 0.0, 0.0])]).unwrap_err();
    assert!(error.to_string().ends_with("surface \"b\": it coincides with surface \"a\""), "{error}");
    assert!(error.cure().unwrap().contains("place it a millionth of its size"));
    let still = balls.at_frame(0).unwrap();
    let error = FrameScenes::of(&still).placed(&[]).unwrap_err();
    assert!(error.to_string().ends_with("movers are placed, yet nothing moves in the scene"), "{error}");
}

#[test]
fn poses_are_rigid_or_refused() {
    let pose = |rotation: DQuat, shift: [f64; 3]| Pose::rigid(DVec3::X, rotation, DVec3::from_array(shift));
    let quarter = DQuat::from_axis_angle(DVec3::Z, 90f64.to_radians());
    let turned = pose(quarter, [0.0, 0.0, 2.0]).unwrap();
    assert!(turned.point(DVec3::ZERO).distance(DVec3::new(1.0, -1.0, 2.0)) < 1e-15);
    assert!(pose(DQuat::IDENTITY, [0.0; 3]).unwrap().is_rest());
    // A quaternion of single precision turns as well, without a change of lengths.
    let rough = DQuat::from_xyzw(0.0, 0.0, f64::from(0.5f32.sqrt()), f64::from(0.5f32.sqrt()));
    assert!((pose(rough, [0.0; 3]).unwrap().vector(DVec3::X).length() - 1.0).abs() < 1e-15);
    let double = pose(quarter * 2.0, [0.0; 3]).unwrap_err();
    assert_eq!(double.to_string(), "the length of the quaternion is 2, outside 1, to 1e-6");
    assert!(pose(quarter, [f64::INFINITY, 0.0, 0.0]).is_err());
    // In other coordinates the same points go to the same places.
    let middle = DVec3::new(4e3, -2e3, 7.0);
    let (about, x) = (turned.about(middle), DVec3::new(0.3, 0.2, -5.0));
    assert!(about.point(x - middle).distance(turned.point(x) - middle) < 1e-11);
    let shift = pose(DQuat::IDENTITY, [0.1, 0.2, 0.3]).unwrap();
    assert_eq!(shift.about(middle), shift);
}

proptest! {
    #![proptest_config(Config { cases: 6, rng_seed: RngSeed::Fixed(7), failure_persistence: None, ..Config::default() })]

    /// h = Σ f h over lamps and bands: light is linear in emission.
    #[test]
    fn light_is_linear_in_emission(factors in prop::array::uniform3(prop::array::uniform2(0.0..3.0f64))) {
        let scene = room(2, "[[motion]]\nsurfaces = 'lamp'\nemission = { factors = [1, 1] }\n\
                             [[motion]]\nsurfaces = 'glow'\nemission = { factors = [1, 1] }\n\
                             [[motion]]\nsurfaces = 'spot'\nemission = { factors = [1, 1] }\n");
        let options = Options { order: 0, ..exact(Direct::Projected) };
        let light = |states: [[f64; 2]; 3]| -> Vec<Vec<f64>> {
            let states = states.map(|own| MoverState { pose: Pose::REST, factors: own.to_vec() });
            let still = FrameScenes::of(&scene).placed(&states).unwrap();
            let solution = outcome_of(&still, &options).solution;
            solution.bands().iter().map(|band| band.coefficients.irradiance.clone()).collect()
        };
        let found = light(factors);
        let alone = [0, 1, 2].map(|lamp| {
            let mut off = [[0.0; 2]; 3];
            off[lamp] = [1.0; 2];
            light(off)
        });
        for (band, found) in found.iter().enumerate() {
            for (index, found) in found.iter().enumerate() {
                let parts = [0, 1, 2].map(|lamp| factors[lamp][band] * alone[lamp][band][index]);
                let sum: f64 = parts.iter().sum();
                prop_assert!((found - sum).abs() <= 1e-9 * (sum.abs() + 1e-3), "{found} {sum}");
            }
        }
    }
}

#[test]
fn rays_are_spread_anew_where_another_lamp_takes_over() {
    // Two small lamps, each in a corner of its own behind a screen.
    let scene = typed(
        r#"
        frames = 11
        camera = { eye = [1, 1, 1], target = [2, 2, 1] }
        materials.wall = { reflectance = 0.6 }
        materials.lamp = { reflectance = 0, emission = 100 }
        [[surfaces]]
        name = "room"
        material = "wall"
        box = { origin = [0, 0, 0], size = [8, 6, 3], inward = true }
        [[surfaces]]
        name = "screen"
        material = "wall"
        two_sided = true
        quad = { vertices = [[4, 0.5, 0.1], [4, 5.5, 0.1], [4, 5.5, 2.8], [4, 0.5, 2.8]] }
        [[surfaces]]
        name = "left"
        material = "lamp"
        quad = { vertices = [[1, 1, 2.9], [1, 1.1, 2.9], [1.1, 1.1, 2.9], [1.1, 1, 2.9]] }
        [[surfaces]]
        name = "right"
        material = "lamp"
        quad = { vertices = [[7, 5, 2.9], [7, 5.1, 2.9], [7.1, 5.1, 2.9], [7.1, 5, 2.9]] }
        [[motion]]
        name = "out"
        surfaces = "left"
        emission = { factors = [1, 0] }
        [[motion]]
        name = "in"
        surfaces = "right"
        emission = { factors = [0, 1] }
        "#,
    );
    let numbers: Vec<usize> = (0..11).collect();
    for way in [FollowMode::Incremental, FollowMode::Path { tolerance: 1e-4 }] {
        let followed = frames(&scene, &by_rays(), way, &numbers);
        let alone = frames(&scene, &by_rays(), FollowMode::Fresh, &numbers);
        for ((frame, alone), number) in followed.iter().zip(&alone).zip(&numbers) {
            let apart = apart(&frame.solution, &alone.solution);
            assert!(apart <= 2.0 * (frame.rays + alone.rays), "{way:?} {number}: {apart} {}", frame.rays);
            assert!(frame.rays <= 2.0 * alone.rays, "{way:?} {number}: {} {}", frame.rays, alone.rays);
        }
    }
}
