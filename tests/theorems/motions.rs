//! Moving surfaces: rigid paths, the still scene of each frame, and what is refused.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use radiosity::scene::{
    AxisAngle, Clock, Curve, MoverDraft, Notation, Pose, RigidPath, Scene, SceneBuilder, SceneError,
    SceneSurface, Source, TimeFunction, Turn,
};
use radiosity::visibility::inspection::{Inspection, passages};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::{builtin, material, parsed, typed};
use radiosity_test_support::shapes::{ball, plate};

/// A room with a lamp of two sides, a lamp post in an array, a luminaire and a camera.
const ROOM: &str = r#"
materials.white = { reflectance = 0.5 }
materials.lamp = { reflectance = 0.2, emission = 10 }
camera = { eye = [1, 1, 1], target = [3, 3, 1] }
[[surfaces]]
name = "room"
material = "white"
box = { origin = [0, 0, 0], size = [4, 4, 3], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
two_sided = true
parallelogram = { origin = [0.5, 0.5, 2], edge1 = [0.5, 0, 0], edge2 = [0, 0.5, 0] }
[[luminaires]]
name = "bulb"
position = [2, 2, 2]
flux = 10
point = {}
[[parts.post.surfaces]]
name = "ball"
material = "white"
sphere = { center = [0, 0, 0.2], radius = 0.1 }
[[parts.post.luminaires]]
name = "spot"
position = [0, 0, 1]
flux = 10
spot = { angle = 40 }
[[instances]]
part = "post"
name = "posts"
array = { count = 2, step = [1, 0, 0] }
transform = { translate = [1, 3, 0] }
"#;

fn read(motion: &str) -> Result<Scene, SceneError> {
    radiosity::language::read(&Source::new("room.toml", &format!("frames = 11\n{ROOM}{motion}\n")))
}

fn scene(motion: &str) -> Scene {
    read(motion).unwrap_or_else(|error| panic!("{motion}: {error}"))
}

/// A surface at some of its parameters, to the bit.
fn bits(surface: &SceneSurface) -> Vec<[u64; 3]> {
    let places = [-1.0, -0.3, 0.4, 1.0];
    let points = places.iter().flat_map(|u| places.iter().map(|v| surface.shape.jet(*u, *v).position));
    points.map(|x| x.to_array().map(f64::to_bits)).collect()
}

fn indices(scene: &Scene, names: &[&str]) -> Vec<usize> {
    names.iter().map(|name| scene.surface_named(name).unwrap()).collect()
}

/// Where the path leads of a motion that is typed.
fn pose(motion: &str, moment: f64) -> Pose {
    let scene = scene(&format!("[[motion]]\nsurfaces = [\"lamp\"]\n{motion}"));
    scene.animation.as_ref().unwrap().states(moment).unwrap()[0].pose
}

#[test]
fn a_moved_surface_is_the_one_at_rest_moved() {
    let scene = scene("[[motion]]\nsurfaces = [\"lamp\"]\ntranslate = { points = [[0, 0, 0], [1, 2, -1]] }");
    let lamp = indices(&scene, &["lamp", "lamp:back"]);
    assert_eq!(scene.frames(), 11);
    for frame in 0..11 {
        let still = scene.at_frame(frame).unwrap();
        assert!(still.animation.is_none() && still.surfaces.len() == scene.surfaces.len());
        let movers = scene.movers_at(frame).unwrap();
        for (index, (own, rest)) in still.surfaces.iter().zip(&scene.surfaces).enumerate() {
            assert_eq!(own.name, rest.name);
            let moves = lamp.contains(&index) && frame > 0;
            assert_eq!(movers[index], moves.then_some(0), "{} in frame {frame}", own.name);
            if !moves {
                assert_eq!(bits(own), bits(rest), "{} in frame {frame}", own.name);
                continue;
            }
            let by = 0.1 * frame as f64 * DVec3::new(1.0, 2.0, -1.0);
            let [own, rest] = [own, rest].map(|surface| surface.shape.jet(0.3, -0.6));
            assert!(own.position.distance(rest.position + by) < 1e-15);
            assert_eq!((own.normal, own.area), (rest.normal, rest.area));
        }
    }
}

#[test]
fn frames_do_not_drift_and_come_back_to_the_bit() {
    let scene = scene(
        "[[motion]]\nsurfaces = [\"lamp\"]\n\
         translate = { points = [[0, 0, 0], [1, 0.3, 0.1], [0, 0, 0]], curve = \"spline\" }\n\
         rotate = { center = [0.7, 0.6, 1.9], axis = [1, 2, 3], angles = [0, 360] }",
    );
    assert_eq!(scene.movers_at(10).unwrap(), vec![None; scene.surfaces.len()]);
    let (first, last) = (scene.at_frame(0).unwrap(), scene.at_frame(10).unwrap());
    for ((first, last), rest) in first.surfaces.iter().zip(&last.surfaces).zip(&scene.surfaces) {
        assert_eq!(bits(first), bits(rest));
        assert_eq!(bits(last), bits(rest));
    }
    // The same frame twice is the same, whatever came between.
    let (one, _, other) =
        (scene.at_frame(7).unwrap(), scene.at_frame(3).unwrap(), scene.at_frame(7).unwrap());
    for (one, other) in one.surfaces.iter().zip(&other.surfaces) {
        assert_eq!(bits(one), bits(other));
    }
    assert_eq!(
        pose("rotate = { center = [1, 2, 3], axis = [0, 0, 1], angles = [0, -720] }", 10.0),
        Pose::REST
    );
}

#[test]
fn quarter_turns_go_where_they_should() {
    let turned = "rotate = { center = [1, 1, 0], axis = [0, 0, 5], angles = [0, 90], times = [2, 4] }";
    assert!(pose(turned, 1.0).is_rest() && pose(turned, 2.0).is_rest());
    for moment in [4.0, 10.0] {
        let pose = pose(turned, moment);
        assert!(pose.point(DVec3::new(2.0, 1.0, 7.0)).distance(DVec3::new(1.0, 2.0, 7.0)) < 1e-15);
        assert!(pose.vector(DVec3::X).distance(DVec3::Y) < 1e-15);
    }
    let half = pose(turned, 3.0).vector(DVec3::X);
    assert!(half.distance(DVec3::new(0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0)) < 1e-15);
    // First it turns about the centre, then it is moved.
    let both = pose(
        "rotate = { center = [1, 0, 0], axis = [0, 0, 1], angles = [0, 90] }\ntranslate = { points = [[0,0,0],[0,0,2]] }",
        10.0,
    );
    assert!(both.point(DVec3::ZERO).distance(DVec3::new(1.0, -1.0, 2.0)) < 1e-15);
}

#[test]
fn turns_about_several_axes_meet_their_keys_and_go_the_shorter_way() {
    let turns = "rotate = { center = [0, 0, 0], turns = [[0,0,0,0], [0,0,1,90], [1,0,0,180], [0,0,1,350]], times = [0, 4, 6, 10] }";
    assert!(pose(turns, 0.0).is_rest());
    assert!(
        pose(turns, 2.0).vector(DVec3::X).distance(DVec3::new(0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0)) < 1e-15
    );
    assert!(pose(turns, 4.0).vector(DVec3::X).distance(DVec3::Y) < 1e-15);
    assert!(pose(turns, 6.0).vector(DVec3::Y).distance(-DVec3::Y) < 1e-15);
    let short = pose("rotate = { center = [0, 0, 0], turns = [[0,0,1,0], [0,0,1,350]] }", 5.0);
    let [sine, cosine] = [5.0_f64.to_radians().sin(), 5.0_f64.to_radians().cos()];
    assert!(short.vector(DVec3::X).distance(DVec3::new(cosine, -sine, 0.0)) < 1e-15);
}

#[test]
fn frames_in_a_second_scale_times_but_not_paths() {
    let motion = |rest: &str| {
        let text = format!("fps = 5\nframes = 11\n{ROOM}[[motion]]\nsurfaces = [\"lamp\"]\n{rest}");
        typed(&text).animation.unwrap()
    };
    let by = |animation: &radiosity::scene::Animation, moment: f64| {
        animation.states(moment).unwrap()[0].pose.point(DVec3::ZERO).x
    };
    // Ten frames are two seconds.
    let timed = motion("translate = { points = [[0,0,0], [1,0,0]], times = [1, 2] }");
    assert_eq!([by(&timed, 5.0), by(&timed, 10.0)], [0.0, 1.0]);
    assert!((by(&timed, 7.5) - 0.5).abs() < 1e-15);
    let spread = motion("translate = { points = [[0,0,0], [1,0,0]] }");
    assert_eq!([by(&spread, 0.0), by(&spread, 5.0), by(&spread, 10.0)], [0.0, 0.5, 1.0]);
}

#[test]
fn names_mean_entries_sides_instances_and_endings() {
    let path = "translate = { points = [[0, 0, 0], [0.1, 0, 0]] }";
    let moved = |which: &str| {
        let scene = scene(&format!("[[motion]]\n{which}\n{path}"));
        let mover = &scene.animation.as_ref().unwrap().movers[0];
        let names =
            mover.surfaces.iter().map(|index| scene.surfaces[*index].name.clone()).collect::<Vec<_>>();
        let lamps = mover.luminaires.iter().map(|index| scene.luminaires[*index].name.clone());
        (names.join(" "), lamps.collect::<Vec<_>>().join(" "))
    };
    let told = |surfaces: &str, luminaires: &str| (surfaces.to_owned(), luminaires.to_owned());
    assert_eq!(moved("surfaces = \"lamp\""), told("lamp lamp:back", ""));
    assert_eq!(moved("surfaces = [\"room\"]").0.split(' ').count(), 6);
    assert_eq!(moved("surfaces = [\"room-bottom\"]"), told("room-bottom", ""));
    assert_eq!(moved("instances = [\"posts[1]\"]"), told("posts[1].ball", "posts[1].spot"));
    assert_eq!(
        moved("instances = [\"posts\"]"),
        told("posts[0].ball posts[1].ball", "posts[0].spot posts[1].spot")
    );
    assert_eq!(moved("surfaces = [\"posts*\"]"), told("posts[0].ball posts[1].ball", ""));
    assert_eq!(moved("luminaires = [\"bulb\"]"), told("", "bulb"));
    assert_eq!(
        moved("luminaires = [\"posts*\"]\nsurfaces = \"lamp\""),
        told("lamp lamp:back", "posts[0].spot posts[1].spot")
    );
}

#[test]
fn luminaires_and_the_camera_move_along() {
    let scene = scene(
        "[[motion]]\nname = \"all\"\nluminaires = \"bulb\"\ninstances = \"posts\"\ncamera = true\n\
         rotate = { center = [2, 2, 0], axis = [0, 0, 1], angles = [0, 90] }\n\
         translate = { points = [[0, 0, 0], [0, 0, 0.5]] }",
    );
    let still = scene.at_frame(10).unwrap();
    let place = |x: f64, y: f64, z: f64| DVec3::new(4.0 - y, x, z + 0.5);
    assert!(still.luminaires[0].position.distance(place(2.0, 2.0, 2.0)) < 1e-14);
    assert!(still.luminaires[1].position.distance(place(1.0, 3.0, 1.0)) < 1e-14);
    assert!(still.luminaires[1].aim.distance(-DVec3::Z) < 1e-15);
    let (camera, rest) = (still.camera.clone().unwrap(), scene.camera.clone().unwrap());
    assert!(camera.eye.distance(place(1.0, 1.0, 1.0)) < 1e-14);
    assert!(camera.target.distance(place(3.0, 3.0, 1.0)) < 1e-14);
    assert_eq!((camera.fov, camera.up), (rest.fov, rest.up));
    let ball = &still.surfaces[indices(&still, &["posts[1].ball"])[0]];
    assert!(ball.shape.ball().unwrap().0.distance(place(2.0, 3.0, 0.2)) < 1e-14);
}

#[test]
fn scenes_far_from_the_origin_turn_about_the_same_point() {
    let far = DVec3::new(4e6, -2e6, 0.0);
    let text = |at: DVec3| {
        format!(
            "frames = 5\n[[surfaces]]\nname = \"a\"\nparallelogram = {{ origin = [{}, {}, 0], edge1 = [1,0,0], edge2 = [0,1,0] }}\n\
             [[surfaces]]\nname = \"b\"\nparallelogram = {{ origin = [{}, {}, 1], edge1 = [0.5,0,0], edge2 = [0,0.5,0] }}\n\
             [[motion]]\nsurfaces = [\"b\"]\nrotate = {{ center = [{}, {}, 1], axis = [0, 0, 1], angles = [0, 180] }}\n",
            at.x,
            at.y,
            at.x,
            at.y,
            at.x + 0.5,
            at.y + 0.5
        )
    };
    let [near, far] = [DVec3::ZERO, far].map(|at| typed(&text(at)));
    assert!(far.middle != DVec3::ZERO);
    for frame in 0..5 {
        let [near, far] = [&near, &far].map(|scene| {
            let still = scene.at_frame(frame).unwrap();
            let place = |index: usize| still.surfaces[index].shape.jet(0.1, 0.2).position;
            place(1) - place(0)
        });
        assert!(near.distance(far) < 1e-13, "{}", near.distance(far));
    }
}

#[test]
fn scenes_made_in_code_move_as_those_of_files() {
    let path = || {
        let degrees = TimeFunction::new("angles", vec![0.0, 40.0], vec![0.0, 10.0], Curve::Line).unwrap();
        let points = vec![DVec3::ZERO, DVec3::new(0.3, 0.0, 0.1), DVec3::new(0.1, 0.2, 0.0)];
        let points = TimeFunction::new("points", points, vec![0.0, 5.0, 10.0], Curve::Spline).unwrap();
        RigidPath::turning_along(Turn::about_axis(DVec3::ONE, DVec3::Z, degrees).unwrap(), points)
    };
    let build = |mover: Option<MoverDraft>| {
        let mut room = SceneBuilder::new("room", ["grey"]);
        let white = room.material("white", material(0.5, 1.0));
        room.surface("floor", plate(DVec3::ZERO, DVec3::X, DVec3::Y), &white);
        let ball = ball(DVec3::Z, 0.25);
        room.surface("ball", ball, &white);
        room.clock(Clock::new(11, 1.0).unwrap());
        mover.into_iter().for_each(|mover| {
            room.moves(mover);
        });
        room.build()
    };
    let made = build(Some(MoverDraft::new("ball", path()).surface("ball"))).unwrap();
    let typed = typed(
        "frames = 11\nmaterials.white = { reflectance = 0.5, emission = 1 }\n\
         [[surfaces]]\nname = \"floor\"\nmaterial = \"white\"\nparallelogram = { origin = [0,0,0], edge1 = [1,0,0], edge2 = [0,1,0] }\n\
         [[surfaces]]\nname = \"ball\"\nmaterial = \"white\"\nsphere = { center = [0, 0, 1], radius = 0.25 }\n\
         [[motion]]\nsurfaces = [\"ball\"]\nrotate = { center = [1, 1, 1], axis = [0, 0, 1], angles = [0, 40] }\n\
         translate = { points = [[0, 0, 0], [0.3, 0, 0.1], [0.1, 0.2, 0]], curve = \"spline\" }\n",
    );
    for frame in 0..11 {
        let [made, typed] = [&made, &typed].map(|scene| bits(&scene.at_frame(frame).unwrap().surfaces[1]));
        assert_eq!(made, typed);
    }
    assert_eq!(build(None).unwrap_err().to_string(), "room: nothing moves");
    let unknown = build(Some(MoverDraft::new("ball", path()).surface("bal"))).unwrap_err();
    assert_eq!(unknown.to_string(), "room: motion \"ball\": unknown surface \"bal\"");
}

#[test]
fn a_source_is_read_as_the_still_scene_of_its_moment() {
    let motion = "[[motion]]\nsurfaces = [\"lamp\"]\ntranslate = { points = [[0, 0, 0], [1, 2, -1]] }";
    let scene = scene(motion);
    let still = scene.at_moment(3.25).unwrap();
    let source = still.source.clone().unwrap();
    assert_eq!(source.moment, Some(3.25));
    let again = parsed(&source);
    for (one, other) in still.surfaces.iter().zip(&again.surfaces) {
        assert_eq!(bits(one), bits(other));
    }
    assert_eq!(
        again.at_frame(1).unwrap_err().to_string(),
        "room.toml: a frame is asked for, yet nothing moves in the scene"
    );
}

/// Whatever is wrong is told where it stands, with a cure.
#[test]
fn motions_that_make_no_sense_are_refused() {
    let path = "translate = { points = [[0,0,0],[1,0,0]] }";
    let cases: [(&str, &str, &str); 20] = [
        ("surfaces = [\"lmap\"]\nPATH", "unknown surface \"lmap\"", "did you mean \"lamp\"?"),
        ("surfaces = [\"lamp:back\"]\nPATH", "unknown surface \"lamp:back\"", "surfaces of this scene"),
        ("surfaces = [\"pst*\"]\nPATH", "unknown surface \"pst*\"", "surfaces of this scene"),
        ("instances = [\"post\"]\nPATH", "unknown instance \"post\"", "did you mean \"posts\"?"),
        ("luminaires = [\"lamp\"]\nPATH", "unknown luminaire \"lamp\"", "bulb"),
        ("PATH", "nothing moves", "say what moves"),
        ("surfaces = [\"lamp\"]", "nothing says how it moves", "add translate"),
        ("surfaces = [\"lamp\"]\nPATH\nscale = 2", "a motion keeps all sizes", "leave scale out"),
        ("surfaces = [\"lamp\"]\nmoves = 2", "unknown key \"moves\"", "translate"),
        (
            "surfaces = [\"lamp\"]\ntranslate = { points = [[0,0,0]] }",
            "points takes at least two, found 1",
            "give at least two",
        ),
        (
            "surfaces = [\"lamp\"]\ntranslate = { points = [[0,0,0],[nan,0,0]] }",
            "NaN is not a finite number",
            "write a finite number",
        ),
        (
            "surfaces = [\"lamp\"]\ntranslate = { points = [[0,0,0],[1,0,0]], times = [0] }",
            "times takes one number for each of the 2 points, found 1",
            "give one number for each",
        ),
        (
            "surfaces = [\"lamp\"]\ntranslate = { points = [[0,0,0],[1,0,0]], times = [3, 2] }",
            "the times do not ascend: 2 follows 3",
            "larger than the one before",
        ),
        (
            "surfaces = [\"lamp\"]\ntranslate = { points = [[0,0,0],[1,0,0]], curve = \"splin\" }",
            "there is no curve \"splin\"",
            "did you mean \"spline\"?",
        ),
        (
            "surfaces = [\"lamp\"]\nrotate = { center = [0,0,0], axis = [0,0,0], angles = [0, 90] }",
            "the vector `axis` gives no direction",
            "give the direction of the axis",
        ),
        (
            "surfaces = [\"lamp\"]\nrotate = { center = [0,0,0], turns = [[0,0,1,0],[0,0,0,90]] }",
            "the vector `axis` gives no direction",
            "give the direction of the axis",
        ),
        (
            "surfaces = [\"lamp\"]\nrotate = { center = [0,0,0], axis = [0,0,1], turns = [[0,0,1,0],[0,0,1,90]] }",
            "\"turns\" and \"axis\" are both given",
            "leave one of them out",
        ),
        (
            "surfaces = [\"lamp\"]\nrotate = { axis = [0,0,1], angles = [0, 90] }",
            "the key \"center\" is missing",
            "three numbers in brackets",
        ),
        (
            "surfaces = [\"lamp\"]\nPATH\n[[motion]]\nsurfaces = [\"lamp\"]\nPATH",
            "surface \"lamp\" belongs to the motion \"motion-1\" already",
            "take it out of one of the two",
        ),
        (
            "name = \"a\"\nsurfaces = [\"lamp\"]\nPATH\n[[motion]]\nname = \"a\"\nluminaires = [\"bulb\"]\nPATH",
            "the name \"a\" is given twice",
            "rename this one",
        ),
    ];
    for (motion, message, cure) in cases {
        let motion = format!("[[motion]]\n{}", motion.replace("PATH", path));
        let error = read(&motion).expect_err(&motion);
        assert!(error.to_string().ends_with(message), "{motion}: {error}");
        assert!(error.to_string().contains(": motion \""), "{motion}: {error}");
        assert!(error.cure().is_some_and(|found| found.contains(cure)), "{motion}: {:?}", error.cure());
        assert!(error.place.is_some_and(|place| place.line > ROOM.lines().count()), "{motion}");
    }
}

#[test]
fn frames_that_are_not_there_are_refused() {
    let motion = "[[motion]]\nsurfaces = [\"lamp\"]\ntranslate = { points = [[0,0,0],[1,0,0]] }";
    let scene = scene(motion);
    for (moment, found) in [(-1.0, "-1"), (11.0, "11"), (10.5, "10.5"), (f64::NAN, "NaN")] {
        let error = scene.at_moment(moment).unwrap_err();
        let message = format!("room.toml: there is no frame {found}: frames are counted from 0 to 10");
        assert_eq!(error.to_string(), message);
        assert_eq!(error.cure().as_deref(), Some("choose one from 0 to 10"));
    }
    let refused = |text: String| radiosity::language::read(&Source::new("room.toml", &text)).unwrap_err();
    let error = refused(format!("{ROOM}{motion}"));
    assert!(error.to_string().ends_with("motion \"motion-1\": the key \"frames\" is missing"), "{error}");
    assert!(error.cure().unwrap().contains("frames = …"));
    let error = refused(format!("frames = 0\n{ROOM}{motion}"));
    assert!(error.to_string().contains("the number of frames is 0"), "{error}");
    let error = refused(format!("frames = 10\n{ROOM}"));
    assert!(error.to_string().ends_with("nothing moves"), "{error}");
    let error = refused(format!("frames = 10\nfps = 0\n{ROOM}{motion}"));
    assert!(error.to_string().contains("the rate of frames is 0"), "{error}");
    let error = refused(
        format!("frames = 10\n{ROOM}[[motion]]\ncamera = true\ntranslate = {{ points = [[0,0,0],[1,0,0]] }}")
            .replace("camera = {", "variables = {")
            .replace("eye = [1, 1, 1], target = [3, 3, 1]", "a = 1"),
    );
    assert!(error.to_string().ends_with("the scene has no camera to move"), "{error}");
}

#[test]
fn a_surface_that_moves_into_the_place_of_another_is_refused_with_the_frame() {
    let scene = typed(
        "frames = 3\n[[surfaces]]\nname = \"a\"\nsphere = { center = [0, 0, 0], radius = 1 }\n\
         [[surfaces]]\nname = \"b\"\nsphere = { center = [4, 0, 0], radius = 1 }\n\
         [[motion]]\nsurfaces = [\"b\"]\ntranslate = { points = [[0, 0, 0], [-4, 0, 0]] }\n",
    );
    assert!(scene.at_frame(1).is_ok());
    let error = scene.at_frame(2).unwrap_err();
    assert!(
        error.to_string().ends_with("surface \"b\": in frame 2 it coincides with surface \"a\""),
        "{error}"
    );
    assert!(error.cure().unwrap().contains("lead the path"));
}

#[test]
fn a_surface_that_is_lost_in_rounding_is_refused() {
    let at = |reach: f64| {
        let path = format!("translate = {{ points = [[0, 0, 0], [{reach:e}, 0, 0]] }}");
        scene(&format!("[[motion]]\nsurfaces = [\"lamp\"]\n{path}")).at_frame(10)
    };
    assert!(at(1e5).is_ok());
    for reach in [1e8, 1e18, 1e30] {
        let error = at(reach).unwrap_err();
        assert!(error.to_string().contains("surface \"lamp\": in frame 10 it is"), "{error}");
        assert!(error.cure().unwrap().contains("keep the path near the scene"));
    }
}

/// A box over a floor, at rest at a height, that moves along points; in each frame the gap below it, and what
/// lies on what.
fn box_over_floor(height: f64, points: &str) -> Vec<(f64, String)> {
    let scene = typed(&format!(
        "frames = 5\n[[surfaces]]\nname = \"floor\"\n\
             parallelogram = {{ origin = [-2,-2,0], edge1 = [4,0,0], edge2 = [0,4,0] }}\n\
             [[surfaces]]\nname = \"box\"\nbox = {{ origin = [0,0,{height}], size = [1,1,1] }}\n\
             [[motion]]\nsurfaces = [\"box\"]\ntranslate = {{ points = {points} }}\n"
    ));
    let frame = |frame: usize| {
        let still = scene.at_frame(frame).unwrap();
        let bottom = &still.surfaces[still.surface_named("box-bottom").unwrap()].shape;
        let lying: Vec<String> =
            still.fitted.lying.iter().map(|own| format!("{} on {}", own.surface, own.on)).collect();
        assert_eq!(bits(&still.surfaces[0]), bits(&scene.surfaces[0]), "the floor in frame {frame}");
        (bottom.jet(0.0, 0.0).position.z, lying.join(", "))
    };
    (0..5).map(frame).collect()
}

#[test]
fn sheets_that_come_into_one_plane_are_set_apart_and_what_stands_still_stays() {
    let landing = box_over_floor(1.0, "[[0,0,0], [0,0,-0.5], [0,0,-1], [0.5,0.5,-1], [0,0,0]]");
    for (frame, (height, lying)) in landing.iter().enumerate() {
        match frame {
            2 | 3 => {
                assert!(*height > 1e-9 && *height < 1e-6 && lying == "box-bottom on floor", "{landing:?}")
            }
            _ => assert!(*height >= 0.5 && lying.is_empty(), "{landing:?}"),
        }
    }
    let sliding = box_over_floor(0.0, "[[0,0,0], [0.5,0.5,0], [-1,0,0], [0,0,1], [0,0,0]]");
    let (gap, _) = &sliding[0];
    assert!(*gap > 1e-9 && *gap < 1e-6);
    for (frame, (height, lying)) in sliding.iter().enumerate() {
        let (by, told) = if frame == 3 { (1.0, "") } else { (0.0, "box-bottom on floor") };
        assert_eq!((*height, lying.as_str()), (by + gap, told), "{sliding:?}");
    }
}

#[test]
fn what_passes_through_another_is_told_with_its_frames() {
    let scene = typed(
        "frames = 21\n[[surfaces]]\nname = \"wall\"\nparallelogram = { origin = [0,-2,-2], edge1 = [0,4,0], edge2 = [0,0,4] }\n\
         [[surfaces]]\nname = \"ball\"\nsphere = { center = [-2, 0, 0], radius = 0.5 }\n\
         [[surfaces]]\nname = \"moon\"\nsphere = { center = [-2, 0, 1], radius = 0.1 }\n\
         [[motion]]\nsurfaces = [\"ball\"]\ntranslate = { points = [[0,0,0], [4,0,0]] }\n\
         [[motion]]\nsurfaces = [\"moon\"]\nrotate = { center = [-2, 0, 0], axis = [1, 0, 0], angles = [0, 90] }\n",
    );
    let found = Inspection::of(&scene);
    assert_eq!(found.passages, passages(&scene, [0, 20]));
    assert!(passages(&scene, [0, 6]).is_empty() && passages(&scene, [10, 10]).len() == 1);
    // The ball reaches the wall, in steps of 0.2, at 1.5, and leaves it at 2.5.
    let told: Vec<(&str, Option<&str>, &[usize])> = found
        .passages
        .iter()
        .map(|own| (own.surface.as_str(), own.other.as_deref(), own.frames.as_slice()))
        .collect();
    assert_eq!(told, [("ball", Some("wall"), &[8, 9, 10, 11, 12][..])]);
    let warned = found.warnings.iter().find(|warning| warning.code == "passage").unwrap();
    assert_eq!(
        warned.message,
        "surface \"ball\" passes through \"wall\" in frames 8 to 12: lead its path past that"
    );
}

/// A skylight under a uniform sky sends the illuminance of level ground; a window sees half of the sky and
/// half of the ground, which reflects a fifth.
#[test]
fn an_opening_that_turns_sees_the_sky_from_where_it_is() {
    let scene = typed(
        "frames = 2\nmaterials.glass = { reflectance = 0 }\nsky = { model = \"uniform\", illuminance = 100 }\n\
         [[surfaces]]\nname = \"skylight\"\nmaterial = \"glass\"\nopening = true\n\
         parallelogram = { origin = [0,0,3], edge1 = [0,1,0], edge2 = [1,0,0] }\n\
         [[motion]]\nsurfaces = [\"skylight\"]\nrotate = { center = [0,0,3], axis = [0,1,0], angles = [0, 90] }\n",
    );
    let exitance = |frame: usize| scene.at_frame(frame).unwrap().surfaces[0].material.emission[0];
    assert!((exitance(0) - 100.0).abs() < 1e-6, "{}", exitance(0));
    assert!((exitance(1) - 60.0).abs() < 1e-3, "{}", exitance(1));
}

#[test]
fn motions_of_an_included_file_belong_to_the_scene_and_json_says_the_same() {
    let path = "translate = { points = [[0,0,0],[1,0,0]] }";
    let lamp = format!("{ROOM}[[motion]]\nsurfaces = [\"lamp\"]\n{path}\n");
    let whole =
        format!("frames = 11\ninclude = \"lamp.toml\"\n[[motion]]\nluminaires = [\"bulb\"]\n{path}\n");
    let scene = parsed(&Source::new("room.toml", &whole).including("lamp.toml", &lamp));
    let movers = scene.animation.as_ref().unwrap().movers.iter();
    let told: Vec<(usize, usize)> =
        movers.map(|mover| (mover.surfaces.len(), mover.luminaires.len())).collect();
    assert_eq!(told, [(2, 0), (0, 1)]);
    let typed = read(&format!("[[motion]]\nsurfaces = [\"lamp\"]\n{path}\n")).unwrap();
    let json = radiosity::language::read(&Source::new(
        "room",
        &radiosity::language::text(&typed, Notation::Json).unwrap(),
    ))
    .unwrap();
    let [typed, json] = [&typed, &json].map(|scene| bits(&scene.at_frame(5).unwrap().surfaces[6]));
    assert_eq!(typed, json);
}

#[test]
fn what_is_passed_between_two_frames_is_told_and_what_slides_or_lands_is_not() {
    // A sheet in the plane x = 0 of 2 × 2, and a tile beside it at x = −1, that moves in two frames as told.
    let told = |motion: &str| {
        let scene = typed(&format!(
            "frames = 3\n[[surfaces]]\nname = \"sheet\"\nparallelogram = {{ origin = [0,-1,-1], edge1 = [0,2,0], edge2 = [0,0,2] }}\n\
             [[surfaces]]\nname = \"floor\"\nparallelogram = {{ origin = [-3,-3,-1.5], edge1 = [6,0,0], edge2 = [0,6,0] }}\n\
             [[surfaces]]\nname = \"tile\"\nparallelogram = {{ origin = [-1,-0.1,-0.1], edge1 = [0,0.2,0], edge2 = [0.1,0,0.2] }}\n\
             [[motion]]\nsurfaces = [\"tile\"]\n{motion}\n"
        ));
        let found = passages(&scene, [0, 2]);
        found
            .into_iter()
            .map(|own| (own.other.unwrap_or_default(), own.frames, own.before))
            .collect::<Vec<_>>()
    };
    let through = |before: &[usize]| vec![("sheet".to_owned(), Vec::new(), before.to_vec())];
    // From x = −1 to 1, and back.
    assert_eq!(told("translate = { points = [[0,0,0], [2,0,0], [2,0,0]] }"), through(&[0]));
    assert_eq!(told("translate = { points = [[0,0,0], [2,0,0], [0,0,0]] }"), through(&[0, 1]));
    // Half a turn of radius 0.8 leads through the sheet at y = −0.77; one of 1.41 about y = −1 below its edge.
    assert_eq!(told("rotate = { center = [-0.2,0,0], axis = [0,0,1], angles = [0,0,180] }"), through(&[1]));
    assert!(told("rotate = { center = [0,-1,0], axis = [0,0,1], angles = [0,90,180] }").is_empty());
    // Past the sheet, and along the floor.
    assert!(told("translate = { points = [[0,0,0], [2,3,0], [2,3,0]] }").is_empty());
    assert!(told("translate = { points = [[0,0,-1.4], [0.4,0,-1.4], [0.5,1,-1.4]] }").is_empty());
    // Through the floor, in the first step only.
    assert_eq!(told("translate = { points = [[0,0,0], [0,0,-3], [0,0,-4]] }")[0].0, "floor");
}

#[test]
fn what_stands_on_a_floor_slides_and_turns_over_it_and_is_told_where_it_sinks() {
    // A box and a can on a floor, pushed by steps of more than their width, and turned.
    let told = |motion: &str| {
        let scene = typed(&format!(
            "frames = 5\n[[surfaces]]\nname = \"floor\"\nquad = {{ vertices = [[-4,-4,0], [4,-4,0], [4,4,0], [-4,4,0]] }}\n\
             [[surfaces]]\nname = \"box\"\nbox = {{ origin = [0,0,0], size = [0.3,0.4,0.5], open = [\"bottom\"] }}\n\
             [[surfaces]]\nname = \"can\"\ncylinder = {{ base = [1,1,0], axis = [0,0,0.5], radius = 0.2 }}\n\
             [[motion]]\nsurfaces = [\"box\", \"can\"]\n{motion}\n"
        ));
        passages(&scene, [0, 4]).len()
    };
    assert_eq!(told("translate = { points = [[0,0,0], [2,1,0]] }"), 0);
    assert_eq!(told("rotate = { center = [0.5,0,0], axis = [0,0,1], angles = [0,200] }"), 0);
    assert!(told("translate = { points = [[0,0,0], [0,0,-2]] }") > 0);
}

#[test]
fn built_in_scenes_that_move_look_right_in_every_frame() {
    let moving: Vec<Scene> = radiosity::language::builtins()
        .iter()
        .map(|scene| scene.name)
        .map(|name| builtin(name))
        .filter(|scene| scene.frames() > 0)
        .collect();
    let names: Vec<&str> = moving.iter().map(|scene| scene.name.as_str()).collect();
    assert_eq!(names, ["blue-panel", "sliding-light", "billiard", "billiard-slide", "cathedral"]);
    for scene in &moving {
        assert_eq!(Inspection::of(scene).warnings, [], "{}", scene.name);
        assert!(scene.at_frame(0).is_ok() && scene.at_frame(scene.frames() - 1).is_ok(), "{}", scene.name);
    }
    // As many as in figure 6 of D. Arquès, V. Biri and S. Michelin (2001).
    let [whole, curved] = [false, true].map(|curved| {
        let surfaces = moving[4].surfaces.iter();
        surfaces.filter(|surface| !curved || surface.shape.region().is_none()).count()
    });
    assert!((130..=150).contains(&whole) && curved >= 100, "{whole} surfaces, {curved} of them curved");
}

fn vector(reach: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-reach..reach).prop_map(DVec3::from_array)
}

/// Ascending times from positive steps.
fn times(steps: &[f64]) -> Vec<f64> {
    steps.iter().scan(0.0, |time, step| Some(std::mem::replace(time, *time + step))).collect()
}

/// A path, and the points that it meets at its times.
#[derive(Debug)]
struct Keyed {
    points: Vec<DVec3>,
    times: Vec<f64>,
    center: DVec3,
    path: RigidPath,
}

prop_compose! {
    /// A path with four keys at times up to 4.
    fn path()(
        points in prop::collection::vec(vector(3.0), 4),
        angles in prop::collection::vec(-900.0..900.0f64, 4),
        axes in prop::collection::vec(vector(1.0), 4),
        center in vector(5.0),
        steps in prop::collection::vec(0.1..1.0f64, 4),
        spline in any::<bool>(),
        keyed in any::<bool>(),
    ) -> Keyed {
        let times = times(&steps);
        let curve = if spline { Curve::Spline } else { Curve::Line };
        let shift = TimeFunction::new("points", points.clone(), times.clone(), curve).unwrap();
        let axis = |k: usize| axes[k] + DVec3::new(0.0, 0.0, 2.0);
        let turn = if keyed {
            let key = |k: usize| AxisAngle { axis: axis(k), degrees: angles[k] };
            let keys: Vec<AxisAngle> = (0..4).map(key).collect();
            Turn::by_keys(center, &keys, times.clone())
        } else {
            Turn::about_axis(center, axis(0), TimeFunction::new("angles", angles, times.clone(), curve).unwrap())
        };
        Keyed { points, times, center, path: RigidPath::turning_along(turn.unwrap(), shift) }
    }
}

proptest! {
    #![proptest_config(Config { rng_seed: RngSeed::Fixed(5), failure_persistence: None, ..Config::default() })]

    /// Distances and the sense of turning stay.
    #[test]
    fn poses_are_rigid(keyed in path(), time in -0.5..5.0f64, x in vector(10.0), y in vector(10.0)) {
        let pose = keyed.path.pose(time);
        let [p, q] = [x, y].map(|x| pose.point(x));
        // Coordinates are up to about 30: their rounding is that of the largest.
        prop_assert!((p.distance(q) - x.distance(y)).abs() <= 1e-14 * 30.0);
        let d = pose.vector(y - x);
        prop_assert!(d.distance(q - p) <= 1e-14 * 30.0);
        prop_assert!((d.length() - x.distance(y)).abs() <= 1e-14 * x.distance(y));
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| pose.vector(axis));
        prop_assert!(x.cross(y).distance(z) <= 1e-14);
    }

    /// At the time of each of its points a path has moved the centre of its turns by that point.
    #[test]
    fn paths_meet_their_points(keyed in path()) {
        for (point, time) in keyed.points.iter().zip(&keyed.times) {
            let shown = keyed.path.pose(*time).point(keyed.center);
            prop_assert!(shown.distance(keyed.center + *point) <= 1e-14 * 30.0);
        }
    }
}
