//! Surfaces of two sides: materials of backs, what sheets let through, and that the other side stays known
//! whatever is done to a scene.

use radiosity::scene::{FaultKind, Material, Scene, SceneBuilder, SceneError, Source};
use radiosity_geom::{DVec3, shapes::Parallelogram};
use radiosity_test_support::scenes::{material, typed};
use radiosity_test_support::shapes::plate;

const SHADE: &str = r#"
frames = 3
camera = { eye = [1, -3, 2], target = [1, 1, 0] }
[materials.floor]
reflectance = 0.4
[materials.lamp]
reflectance = 0
emission = 10
group = "lamp"
[materials.silk]
reflectance = 0.3
transmittance = 0.4
group = "shade"
emissivity = 0.7
[materials.paper]
reflectance = 0.5
transmittance = 0.4
emissivity = 0.8
temperature = 300
[[surfaces]]
name = "floor"
material = "floor"
two_sided = true
parallelogram = { origin = [0, 0, 0], edge1 = [2, 0, 0], edge2 = [0, 2, 0] }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [1, 1, 2], normal = [0, 0, -1], radius = 0.2 }
[[surfaces]]
name = "shade"
material = "silk"
back_material = "paper"
two_sided = true
parallelogram = { origin = [0.5, 0.5, 1], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }
[[motion]]
surfaces = ["shade"]
translate = { points = [[0, 0, 0], [0, 0, 0.5]] }
"#;

fn shade() -> Scene {
    typed(SHADE)
}

/// Cause where the sides of a sheet let through different parts of the light.
const DIFFER: &str = "the transmittances of its two sides differ";

/// Checks that a scene is refused for statements that do not go together, for this cause.
#[track_caller]
fn assert_conflict(error: &SceneError, cause: &str) {
    let fault = &error.fault;
    assert!(fault.kind == FaultKind::Conflict && fault.to_string().contains(cause), "{fault}");
}

/// Checks that exactly the pairs `name` and `name:back` know each other.
#[track_caller]
fn assert_paired(scene: &Scene) {
    let mut pairs = 0;
    for (index, own) in scene.surfaces.iter().enumerate() {
        let other = match own.name.strip_suffix(":back") {
            Some(front) => scene.surface_named(front).ok(),
            None => scene.surface_named(&format!("{}:back", own.name)).ok(),
        };
        assert_eq!(own.other_side, other, "{}", own.name);
        if let Some(other) = other {
            pairs += 1;
            assert_eq!(scene.surfaces[other].other_side, Some(index));
            assert_eq!(own.material.transmittance, scene.surfaces[other].material.transmittance);
            let [a, b] = [own, &scene.surfaces[other]].map(|side| side.shape.jet(0.3, -0.2));
            assert_eq!(
                (a.position, a.normal),
                (b.position, -b.normal),
                "sides lie together, with the same parameters"
            );
        }
    }
    assert!(pairs > 0);
}

#[test]
fn each_side_has_its_material() {
    let scene = shade();
    assert_paired(&scene);
    let side = |name: &str| &scene.surfaces[scene.surface_named(name).unwrap()];
    let (front, back) = (side("shade"), side("shade:back"));
    assert_eq!(
        (front.material_name.as_deref(), back.material_name.as_deref()),
        (Some("silk"), Some("paper"))
    );
    assert_eq!((front.material.reflectance[0], back.material.reflectance[0]), (0.3, 0.5));
    assert_eq!((front.material.transmittance[0], back.material.transmittance[0]), (0.4, 0.4));
    assert_eq!(front.group.as_ref().map(|own| own.name.as_str()), Some("shade"));
    assert!(back.group.is_none(), "the group is that of the material");
    assert_eq!((front.thermal.emissivity, back.thermal.emissivity), (Some(0.7), Some(0.8)));
    assert!(front.thermal.condition.is_none() && back.thermal.condition.is_some());
    assert_eq!(side("floor:back").material, side("floor").material, "without a material of its own");
}

#[test]
fn what_a_surface_says_goes_before_both_of_its_materials() {
    let text = SHADE.replace("back_material", "group = \"own\"\nadiabatic = true\nback_material");
    let scene = typed(&text);
    for name in ["shade", "shade:back"] {
        let side = &scene.surfaces[scene.surface_named(name).unwrap()];
        assert_eq!(side.group.as_ref().map(|own| own.name.as_str()), Some("own"));
        assert_eq!(side.thermal.condition, Some(radiosity::scene::Condition::HeatFlux(0.0)));
    }
}

#[test]
fn a_flux_is_that_of_both_sides_whatever_their_materials() {
    let text = SHADE.replace("back_material", "flux = 6\nback_material");
    let scene = typed(&text);
    for name in ["shade", "shade:back"] {
        let side = &scene.surfaces[scene.surface_named(name).unwrap()];
        assert_eq!(side.material.emission, [3.0], "half of it from each side of 1 m²");
        assert_eq!(side.flux, Some(vec![3.0]));
    }
    let text = text.replace("back_material = \"paper\"", "back_material = \"lamp\"");
    let error = radiosity::language::read(&Source::new("shade", &text))
        .expect_err("the back emits, and lets nothing through");
    assert_conflict(&error, DIFFER);
}

#[test]
fn the_other_side_stays_known() {
    let scene = shade();
    assert_paired(&scene.at_frame(0).unwrap());
    assert_paired(&scene.at_frame(2).unwrap());
    assert_paired(&scene.dimmed(&[("lamp", 0.5)]).unwrap());
    let red = material(0.1, 0.0).with_transmittance(vec![0.4]).unwrap();
    assert_paired(&scene.with_material("silk", red).unwrap());
    let whole =
        format!("{}\n[[instances]]\npart = \"sheet\"\narray = {{ count = 3, step = [0, 0, 1] }}\n", SHADE)
            + "[[parts.sheet.surfaces]]\nname = \"cloth\"\nmaterial = \"silk\"\ntwo_sided = true\n"
            + "box = { origin = [5, 0, 0], size = [1, 1, 0.5], open = [\"top\"] }\n";
    let scene = typed(&whole);
    assert_eq!(scene.surfaces.len(), 5 + 3 * 10);
    assert_paired(&scene);
}

#[test]
fn sheets_that_lie_on_others_keep_their_other_side() {
    // The mat lies in the plane of the floor, and is set apart from it.
    let text = SHADE.replace(
        "[[motion]]",
        "[[surfaces]]\nname = \"mat\"\nmaterial = \"silk\"\ntwo_sided = true\n\
        parallelogram = { origin = [0.2, 0.2, 0], edge1 = [0.5, 0, 0], edge2 = [0, 0.5, 0] }\n[[motion]]",
    );
    let scene = typed(&text);
    assert!(!scene.fitted.lying.is_empty());
    assert_paired(&scene);
    assert_paired(&scene.at_frame(1).unwrap());
}

fn refused(from: &str, to: &str) -> SceneError {
    assert!(SHADE.contains(from), "{from}");
    radiosity::language::read(&Source::new("shade", &SHADE.replace(from, to))).expect_err(to)
}

#[test]
fn wrong_sides_are_refused_with_a_cure() {
    let one_sided = "material = \"silk\"\nback_material = \"paper\"";
    for (from, to, message, cure, line) in [
        (
            "back_material = \"paper\"\ntwo_sided = true",
            "back_material = \"paper\"",
            "a back material needs a surface of two sides",
            "two_sided = true",
            "back_material",
        ),
        (
            "back_material = \"paper\"\ntwo_sided = true",
            "two_sided = false",
            "a transmittance needs a surface of two sides",
            "two_sided = true",
            "silk",
        ),
        (
            "reflectance = 0.5\ntransmittance = 0.4",
            "reflectance = 0.5\ntransmittance = 0.3",
            "the transmittances of its two sides differ: [0.4] and [0.3]",
            "the same transmittance",
            "paper",
        ),
        (
            "reflectance = 0.5\ntransmittance = 0.4",
            "reflectance = 0.5",
            "differ: [0.4] and [0.0]",
            "the same transmittance",
            "paper",
        ),
        (
            one_sided,
            "material = \"silk\"\nback_material = \"papre\"",
            "unknown material \"papre\"",
            "did you mean \"paper\"",
            "papre",
        ),
    ] {
        let error = refused(from, to);
        assert!(error.to_string().contains(message), "{error}");
        assert!(error.cure().is_some_and(|own| own.contains(cure)), "{:?}", error.cure());
        assert!(error.place.as_ref().is_some_and(|place| place.text.contains(line)), "{:?}", error.place);
    }
}

#[test]
fn painting_keeps_sheets_alike_on_both_sides() {
    let scene = shade();
    let opaque = material(0.1, 0.0);
    let error = scene.with_material("silk", opaque).expect_err("its back lets light through");
    assert_conflict(&error, DIFFER);
    let silk = material(0.1, 0.0).with_transmittance(vec![0.2]).unwrap();
    let error = scene.with_material("lamp", silk.clone()).expect_err("it has one side");
    assert_conflict(&error, "a transmittance");
    assert_paired(&scene.with_material("floor", silk).unwrap());
}

fn sheet() -> Parallelogram {
    plate(DVec3::ZERO, DVec3::X, DVec3::Y)
}

#[test]
fn sheets_made_in_code_are_checked_as_those_of_files() {
    let silk = |tau: f64| material(0.3, 0.0).with_transmittance(vec![tau]).unwrap();
    let build = |tau: f64, is_two_sided: bool| {
        let mut room = SceneBuilder::new("room", ["grey"]);
        let front = room.material("silk", silk(0.4));
        let back = room.material("paper", silk(tau));
        let draft = room.surface("shade", sheet(), &front).back_material(&back);
        if is_two_sided {
            draft.two_sided();
        }
        room.build()
    };
    let scene = build(0.4, true).unwrap();
    assert_paired(&scene);
    assert_eq!(scene.surfaces[1].material_name.as_deref(), Some("paper"));
    assert_conflict(&build(0.3, true).expect_err("it differs"), DIFFER);
    assert_conflict(&build(0.4, false).expect_err("one side"), "a back material");
}

#[test]
fn materials_of_backs_are_checked_though_nothing_else_has_them() {
    let build = |own: Material, name: &str| {
        let mut other = SceneBuilder::new("other", ["a", "b"]);
        let foreign = other.material(name, own);
        let mut room = SceneBuilder::new("room", ["grey"]);
        let front = room.material("silk", material(0.3, 0.0));
        room.surface("shade", sheet(), &front).two_sided().back_material(&foreign);
        room.build()
    };
    let grey = || material(0.2, 0.0);
    assert!(build(grey(), "paper").is_ok());
    assert_eq!(build(Material::black(2), "paper").expect_err("two bands").fault.kind, FaultKind::WrongCount);
    assert_eq!(build(grey(), "silk").expect_err("one name").fault.kind, FaultKind::DuplicateName);
    assert_eq!(build(grey(), " ").expect_err("no name").fault.to_string(), "this text is empty");
}
