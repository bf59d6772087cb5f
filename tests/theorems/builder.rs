//! Scenes made in code: refused for the faults of scene files, and solved as theorems say.

use proptest::prelude::*;
use radiosity::reading::files::solution_file::{SolutionFault, SolutionFile, read};
use radiosity::scene::{
    Camera, Fault, FaultKind, Material, NamedMaterial, Scene, SceneBuilder, SceneError, Source,
};
use radiosity::solve::Options;
use radiosity_geom::shapes::Parallelogram;
use radiosity_geom::{DVec3, Flipped, Surface};
use radiosity_test_support::scenes::{material, typed};
use radiosity_test_support::shapes::faces;
use radiosity_test_support::shapes::{ball, plate};
use radiosity_test_support::solved::{outcome_of, solved_of};

fn square(height: f64) -> Parallelogram {
    plate(height * DVec3::Z, DVec3::X, DVec3::Y)
}

/// A builder of one band with a floor, changed by `change`, which gets the floor's material.
fn built(change: impl FnOnce(&mut SceneBuilder, &NamedMaterial)) -> Result<Scene, SceneError> {
    let mut builder = SceneBuilder::new("room", ["grey"]);
    let white = builder.material("white", material(0.5, 1.0));
    builder.surface("floor", square(0.0), &white);
    change(&mut builder, &white);
    builder.build()
}

/// The fault of such a scene, which has no place and is told of `owner`.
#[track_caller]
fn fault(owner: Option<&str>, change: impl FnOnce(&mut SceneBuilder, &NamedMaterial)) -> Fault {
    let error = built(change).expect_err("the scene is refused");
    assert_eq!((error.origin.as_str(), error.owner.as_deref()), ("room", owner));
    assert_eq!(error.place, None);
    error.fault
}

#[test]
fn names_are_given_once_and_say_something() {
    let twice = |name: &str| format!("the name {name:?} is given twice");
    let found = fault(Some("surface \"floor\""), |room, white| {
        room.surface("floor", square(1.0), white);
    });
    assert_eq!(found.to_string(), twice("floor"));
    let found = fault(Some("surface \"floor:back\""), |room, white| {
        room.surface("roof", square(1.0), white).two_sided();
        room.surface("floor:back", square(2.0), white);
        room.surface("floor:back", square(3.0), white);
    });
    assert_eq!(found.to_string(), twice("floor:back"));
    let found = fault(Some("material \"white\""), |room, _| {
        room.material("white", material(0.2, 0.0));
    });
    assert_eq!(found.to_string(), twice("white"));
    let found = fault(Some("surface \" \""), |room, white| {
        room.surface(" ", square(1.0), white);
    });
    assert_eq!(found.to_string(), "this text is empty");
    let bands = |names: &[&str]| SceneBuilder::new("room", names.to_vec()).build().unwrap_err().fault;
    assert_eq!(bands(&["red", "red"]).to_string(), twice("red"));
    assert_eq!(bands(&[]).to_string(), "the list of bands takes at least one name, found 0");
}

#[test]
fn surfaces_do_not_lie_in_one_another() {
    let found = fault(Some("surface \"rug\""), |room, white| {
        room.surface("rug", Flipped::new(Box::new(square(0.0))), white);
    });
    assert_eq!(
        (found.kind, found.to_string().as_str()),
        (FaultKind::Coincident, "coincides with surface \"floor\"")
    );
    let message = built(|room, white| {
        room.surface("rug", square(0.0), white);
    });
    let message = message.unwrap_err().to_string();
    assert_eq!(message, "room: surface \"rug\": coincides with surface \"floor\"");
}

#[test]
fn materials_have_a_number_in_range_for_each_band() {
    let with = |reflectance: Vec<f64>, emission: Vec<f64>| {
        fault(Some("material \"odd\""), |room, _| {
            let mut odd = Material::black(1);
            (odd.reflectance, odd.emission) = (reflectance, emission);
            room.material("odd", odd);
        })
    };
    let found = with(vec![1.0], vec![0.0]);
    assert!(
        found.kind == FaultKind::OutOfRange && found.to_string().starts_with("the reflectance"),
        "{found}"
    );
    let found = with(vec![-0.1], vec![0.0]);
    assert!(
        found.kind == FaultKind::OutOfRange && found.to_string().starts_with("the reflectance"),
        "{found}"
    );
    let found = with(vec![0.5], vec![-1.0]);
    assert!(found.kind == FaultKind::OutOfRange && found.to_string().starts_with("the emission"), "{found}");
    assert_eq!(with(vec![0.5], vec![f64::NAN]).kind, FaultKind::NotFinite);
    let found = with(vec![0.5; 3], vec![0.0; 3]);
    assert!(found.kind == FaultKind::WrongCount && found.to_string().ends_with("found 3"), "{found}");
    let found = with(vec![0.5], vec![]);
    assert!(found.kind == FaultKind::WrongCount && found.to_string().starts_with("the emission"), "{found}");
}

/// A material of another scene comes along with all it must satisfy here.
#[test]
fn foreign_materials_are_checked_as_well() {
    let mut other = SceneBuilder::new("other", ["r", "g"]);
    let two = other.material("two", Material::black(2));
    let namesake = other.material("white", material(0.1, 0.0));
    let found = fault(Some("material \"two\""), |room, _| {
        room.surface("wall", square(1.0), &two);
    });
    assert!(found.kind == FaultKind::WrongCount && found.to_string().ends_with("found 2"), "{found}");
    let found = fault(Some("material \"white\""), |room, _| {
        room.surface("wall", square(1.0), &namesake);
    });
    assert_eq!(found.kind, FaultKind::DuplicateName);
}

#[test]
fn wishes_of_surfaces_are_in_range() {
    let found = fault(Some("surface \"wall\""), |room, white| {
        room.surface("wall", square(1.0), white).order(21);
    });
    assert!(found.kind == FaultKind::OutOfRange && found.to_string().starts_with("the order"), "{found}");
    for (u, v) in [(0, 1), (1, 257)] {
        let found = fault(Some("surface \"wall\""), |room, white| {
            room.surface("wall", square(1.0), white).subdivide(u, v);
        });
        assert!(
            found.kind == FaultKind::OutOfRange && found.to_string().starts_with("the number of elements"),
            "{found}"
        );
    }
    let found = fault(Some("surface \"dust\""), |room, white| {
        let dust = plate(DVec3::Z, 1e-40 * DVec3::X, 1e-40 * DVec3::Y);
        room.surface("dust", dust, white);
    });
    assert!(
        found.kind == FaultKind::OutOfRange && found.to_string().starts_with("the extent of the surface"),
        "{found}"
    );
}

#[test]
fn cameras_have_a_view() {
    let with = |camera: Camera| {
        fault(Some("camera"), |room, _| {
            room.camera(camera);
        })
    };
    let down = Camera::new(3.0 * DVec3::Z, DVec3::ZERO);
    assert_eq!(with(down.clone()).to_string(), "the up vector lies along the view");
    let up = Camera { up: DVec3::Y, ..down };
    assert_eq!(
        with(Camera { target: up.eye, ..up.clone() }).to_string(),
        "eye and target are the same point"
    );
    assert_eq!(with(Camera { fov: 180.0, ..up.clone() }).kind, FaultKind::OutOfRange);
    assert_eq!(with(Camera { width: 0, ..up.clone() }).kind, FaultKind::OutOfRange);
    assert_eq!(with(Camera { eye: DVec3::NAN, ..up.clone() }).kind, FaultKind::NotFinite);
    let scene = built(|room, _| {
        room.camera(up.clone());
    });
    assert_eq!(scene.unwrap().camera, Some(up));
}

#[test]
fn a_scene_has_a_surface() {
    let error = SceneBuilder::new("void", ["grey"]).build().unwrap_err();
    assert_eq!(error.to_string(), "void: the scene has no surface");
}

/// Options of a surface mean in code what they mean in a file.
#[test]
fn options_mean_what_they_mean_in_files() {
    let text = "bands = [\"grey\"]
        [materials.white]
        reflectance = 0.5
        emission = 1
        [[surfaces]]
        name = \"floor\"
        material = \"white\"
        group = \"lamps\"
        two_sided = true
        flip = true
        order = 4
        subdivide = [2, 3]
        parallelogram = { origin = [0, 0, 0], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }";
    let typed = typed(text);
    let mut builder = SceneBuilder::new("room", ["grey"]);
    let white = builder.material("white", material(0.5, 1.0));
    builder.surface("floor", square(0.0), &white).group("lamps").two_sided().flip().order(4).subdivide(2, 3);
    let built = builder.build().expect("the room is right");
    assert_eq!(built.surfaces.len(), typed.surfaces.len());
    for (ours, theirs) in built.surfaces.iter().zip(&typed.surfaces) {
        assert_eq!((&ours.name, &ours.material), (&theirs.name, &theirs.material));
        assert_eq!((&ours.material_name, &ours.group), (&theirs.material_name, &theirs.group));
        assert_eq!((ours.order, ours.subdivide), (theirs.order, theirs.subdivide));
        assert_eq!(ours.shape.jet(0.3, -0.2), theirs.shape.jet(0.3, -0.2));
        assert_eq!(ours.place, None);
    }
}

/// The unit cube from inside, each wall of exitance `emission` and reflectance `reflectance`.
fn cube(reflectance: f64, emission: f64) -> SceneBuilder {
    let mut room = SceneBuilder::new("cube", ["grey"]);
    let white = room.material("white", material(reflectance, emission));
    for (index, wall) in faces(DVec3::ZERO, DVec3::AXES).into_iter().enumerate() {
        room.surface(format!("wall {index}"), wall, &white);
    }
    room
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// In a closed room of one material B = E₀/(1 − ρ) everywhere, and all that is emitted is absorbed.
    #[test]
    fn a_cube_of_one_material_is_a_furnace(reflectance in 0.0..0.9, emission in 0.1..10.0) {
        let scene = cube(reflectance, emission).build().expect("the cube is right");
        let outcome = outcome_of(&scene, &Options { order: 1, ..Options::default() });
        let exact = emission / (1.0 - reflectance);
        for (index, wall) in scene.surfaces.iter().enumerate() {
            let mean = outcome.solution.mean_irradiance(0, index);
            prop_assert!((mean / exact - 1.0).abs() < 1e-2, "{mean} instead of {exact} on {}", wall.name);
        }
        let checks = outcome.checks;
        prop_assert!((checks.energy_in / (6.0 * emission) - 1.0).abs() < 1e-12);
        prop_assert!((checks.energy_absorbed / checks.energy_in - 1.0).abs() < 1e-2);
    }
}

/// A ball of the same material in the cube leaves the furnace a furnace.
#[test]
fn a_ball_in_a_furnace_changes_nothing() {
    let mut room = cube(0.5, 1.0);
    let white = room.material("paint", material(0.5, 1.0));
    let ball = ball(DVec3::splat(0.5), 0.25);
    let area = ball.area();
    room.surface("ball", ball, &white);
    let scene = room.build().expect("the room is right");
    let outcome = outcome_of(&scene, &Options::default());
    for (index, surface) in scene.surfaces.iter().enumerate() {
        let mean = outcome.solution.mean_irradiance(0, index);
        assert!((mean / 2.0 - 1.0).abs() < 1e-2, "{mean} on {}", surface.name);
    }
    assert!((outcome.checks.energy_in / (6.0 + area) - 1.0).abs() < 1e-9);
}

/// A solution file of a built scene has no text to be read from again, and says so.
#[test]
fn solution_files_of_built_scenes_hold_no_text() {
    let scene = cube(0.5, 1.0).build().expect("the cube is right");
    let options = Options { order: 0, ..Options::default() };
    let solved = solved_of(scene, options);
    let text = serde_json::to_string(&SolutionFile::new(&solved)).expect("is written");
    let error = read(&Source::new("cube.json", &text)).expect_err("it cannot be read back");
    assert!(matches!(error.fault, SolutionFault::NoScene), "{error}");
    assert!(error.cure().contains("built in code"), "{}", error.cure());
}
