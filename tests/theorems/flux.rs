//! `flux`: the power that a surface emits, given instead of its exitance; and the bands of scenes that name
//! none.

use std::f64::consts::PI;

use radiosity::scene::{FaultKind, Scene, SceneBuilder, SceneError, Source};
use radiosity::solve::Options;
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::{material, typed};
use radiosity_test_support::shapes::plate;
use radiosity_test_support::solved::solved_of;

const MATERIALS: &str =
    "materials.white = { reflectance = 0.5 }\nmaterials.lamp = { reflectance = 0, emission = 3 }\n";

fn read(surface: &str) -> Result<Scene, SceneError> {
    let text = format!("{MATERIALS}[[surfaces]]\nname = \"lamp\"\nmaterial = \"white\"\n{surface}\n");
    radiosity::language::read(&Source::new("lamp.toml", &text))
}

fn scene(surface: &str) -> Scene {
    read(surface).unwrap_or_else(|error| panic!("{surface}: {error}"))
}

/// The power (W) that all surfaces emit in a band.
fn power(scene: &Scene, band: usize) -> f64 {
    scene.surfaces.iter().map(|own| own.exitance(band) * own.shape.area()).sum()
}

#[test]
fn a_surface_emits_its_flux() {
    for (shape, exitance) in [
        ("disk = { center = [0,0,0], normal = [0,0,1], radius = 2 }", 3600.0 / (4.0 * PI)),
        ("two_sided = true\ndisk = { center = [0,0,0], normal = [0,0,1], radius = 2 }", 3600.0 / (8.0 * PI)),
        ("transform = { scale = 3 }\nsphere = { center = [0,0,0], radius = 1 }", 3600.0 / (36.0 * PI)),
        ("box = { origin = [0,0,0], size = [1,2,3] }", 3600.0 / 22.0),
        ("two_sided = true\nbox = { origin = [0,0,0], size = [1,2,3], open = [\"left\"] }", 3600.0 / 32.0),
    ] {
        let scene = scene(&format!("flux = 3600\n{shape}"));
        for surface in &scene.surfaces {
            assert!((surface.exitance(0) / exitance - 1.0).abs() < 1e-12, "{shape}: {}", surface.exitance(0));
            let own = surface.flux.as_ref().expect("its flux is given")[0];
            assert!((own / (exitance * surface.shape.area()) - 1.0).abs() < 1e-12, "{shape}");
            assert_eq!(surface.material.reflectance, [0.5]);
        }
        assert!((power(&scene, 0) / 3600.0 - 1.0).abs() < 1e-12, "{shape}");
    }
}

#[test]
fn all_light_of_a_solution_is_the_flux_of_its_lamps() {
    let text = format!(
        "{MATERIALS}[[surfaces]]\nmaterial = \"white\"\nbox = {{ origin = [0,0,0], size = [2,2,2], inward = true }}\n\
         [[surfaces]]\nname = \"lamp\"\nmaterial = \"white\"\nflux = 40\ngroup = \"lamps\"\ntwo_sided = true\n\
         triangle = {{ vertices = [[0.5,0.5,1.5],[1.5,0.5,1.5],[0.5,1.5,1.5]] }}\n"
    );
    let scene = typed(&text);
    let solved = solved_of(scene, Options { order: 1, eps: 0.1, ..Options::default() });
    assert!((solved.outcome.checks.energy_in - 40.0).abs() < 1e-9);
    let dimmed = solved.relight(&[("lamps", 0.25)]).unwrap();
    assert!((power(&dimmed.scene, 0) - 10.0).abs() < 1e-12);
    assert!((dimmed.outcome.checks.energy_in - 10.0).abs() < 1e-9);
}

#[test]
fn a_flux_may_differ_between_bands() {
    let scene =
        scene("flux = [6, 3, 0]\nparallelogram = { origin = [0,0,0], edge1 = [3,0,0], edge2 = [0,1,0] }");
    assert_eq!(scene.bands, ["r", "g", "b"]);
    assert_eq!(scene.surfaces[0].material.emission, [2.0, 1.0, 0.0]);
    assert_eq!(scene.surfaces[0].flux, Some(vec![6.0, 3.0, 0.0]));
}

#[test]
fn another_material_leaves_the_flux() {
    let scene = scene("flux = 6\nparallelogram = { origin = [0,0,0], edge1 = [3,0,0], edge2 = [0,1,0] }");
    let painted = scene.with_material("white", material(0.8, 7.0)).unwrap();
    assert_eq!(painted.surfaces[0].material, material(0.8, 2.0));
}

#[test]
fn lamps_made_in_code_have_a_flux_too() {
    let lamp = |flux: Vec<f64>, emission: f64| {
        let mut scene = SceneBuilder::new("desk", ["grey"]);
        let white = scene.material("white", material(0.5, emission));
        let square = plate(DVec3::ZERO, DVec3::X, 2.0 * DVec3::Y);
        scene.surface("lamp", square, &white).flux(flux).two_sided();
        scene.build()
    };
    let scene = lamp(vec![8.0], 0.0).unwrap();
    assert_eq!(scene.surfaces.iter().map(|own| own.exitance(0)).collect::<Vec<_>>(), [2.0, 2.0]);
    let two = lamp(vec![8.0, 1.0], 0.0).unwrap_err().fault;
    assert!(two.kind == FaultKind::WrongCount && two.to_string().ends_with("found 2"), "{two}");
    assert_eq!(lamp(vec![-8.0], 0.0).unwrap_err().fault.kind, FaultKind::OutOfRange);
    let error = lamp(vec![8.0], 1.0).unwrap_err();
    assert!(error.to_string().starts_with("desk: surface \"lamp\": a flux is given, yet"), "{error}");
}

#[test]
fn fluxes_that_cannot_be_are_refused_where_they_stand() {
    let square = "parallelogram = { origin = [0,0,0], edge1 = [3,0,0], edge2 = [0,1,0] }";
    for (line, message, cure) in [
        ("flux = -1", "6:8: surface \"lamp\": the flux is -1, outside flux ≥ 0", "choose"),
        ("flux = nan", "6:8: surface \"lamp\": NaN is not a finite number", "finite"),
        (
            "flux = [1, 2]",
            "6:8: surface \"lamp\": the flux takes one number for all bands or 3",
            "give one number",
        ),
        ("flux = \"bright\"", "6:8: surface \"lamp\": expected a number, found a text", "without quotes"),
        (
            "flux = 1e30\ntransform = { scale = 1e-5 }",
            "6:8: surface \"lamp\": the number is 3.33",
            "choose a value",
        ),
    ] {
        let error = read(&format!("{line}\n{square}")).expect_err(line);
        assert!(error.to_string().contains(message), "{line}: {error}");
        assert!(error.cure().unwrap_or_default().contains(cure), "{line}: {:?}", error.cure());
    }
    let text = format!("{MATERIALS}[[surfaces]]\nmaterial = \"lamp\"\nflux = 2\n{square}");
    let error = radiosity::language::read(&Source::new("lamp.toml", &text)).unwrap_err();
    let told =
        "lamp.toml:5:8: surface \"surface-1\": a flux is given, yet the material \"lamp\" emits as well";
    assert_eq!(error.to_string(), told);
    assert!(error.cure().unwrap_or_default().starts_with("leave the flux out, or"));
}

#[test]
fn scenes_of_single_numbers_have_one_band() {
    let square = "[[surfaces]]\nmaterial = \"white\"\nparallelogram = { origin = [0,0,0], edge1 = [3,0,0], edge2 = [0,1,0] }";
    for (texts, bands) in [
        (["reflectance = 0.5", ""], &["grey"][..]),
        (["reflectance = 0.5, emission = 2", ""], &["grey"]),
        (["reflectance = 0.5", "flux = 2"], &["grey"]),
        (["reflectance = [0.5, 0.4, 0.3]", ""], &["r", "g", "b"]),
        (["reflectance = 0.5, emission = [1, 2, 3]", ""], &["r", "g", "b"]),
        (["reflectance = 0.5", "flux = [1, 2, 3]"], &["r", "g", "b"]),
    ] {
        let [material, surface] = texts;
        let text = format!("materials.white = {{ {material} }}\n{square}\n{surface}");
        assert_eq!(typed(&text).bands, bands, "{text}");
        let named = format!("bands = [\"u\", \"v\", \"w\"]\n{text}");
        assert_eq!(typed(&named).bands, ["u", "v", "w"]);
    }
    let list = radiosity::language::read(&Source::new("one.json", "[[[0,0,0],[1,0,0],[0,1,0]]]")).unwrap();
    assert_eq!(list.bands, ["grey"]);
}
