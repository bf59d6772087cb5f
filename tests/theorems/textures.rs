//! Patterns of materials: how pictures, cells and polynomials lie on surfaces, what is refused, and that a solution keeps them.

use std::fs::{self, File};
use std::path::Path;

use proptest::prelude::*;
use radiosity::output::solution_file::{SolutionFile, read};
use radiosity::scene::{
    Import, Notation, Pattern, Placement, Polynomial, Scene, SceneError, Source, Term, Wrap,
};
use radiosity::solve::Options;
use radiosity::solved::Solved;

/// A scene with a floor of this material, and a lamp.
fn room(material: &str) -> String {
    format!(
        r#"
camera = {{ eye = [1, -3, 2], target = [1, 1, 0] }}
[materials.lamp]
reflectance = 0
emission = 10
[materials.floor]
{material}
[[surfaces]]
name = "floor"
material = "floor"
parallelogram = {{ origin = [0, 0, 0], edge1 = [2, 0, 0], edge2 = [0, 2, 0] }}
[[surfaces]]
name = "lamp"
material = "lamp"
disk = {{ center = [1, 1, 1], normal = [0, 0, -1], radius = 0.2 }}
"#
    )
}

#[track_caller]
fn typed(material: &str) -> Scene {
    Scene::from_toml(&room(material), "room").unwrap_or_else(|error| panic!("{error}\n{material}"))
}

fn reflectance(scene: &Scene) -> &Pattern {
    let floor = scene.surface_named("floor").expect("it is there");
    scene.surfaces[floor].material.reflectance_pattern.as_deref().expect("it varies")
}

/// Writes an 8-bit PNG.
fn write_png(path: &Path, [width, height]: [u32; 2], colour: png::ColorType, bytes: &[u8]) {
    let mut encoder = png::Encoder::new(File::create(path).unwrap(), width, height);
    encoder.set_color(colour);
    encoder.write_header().and_then(|mut writer| writer.write_image_data(bytes)).unwrap();
}

/// A folder with the scene `room.toml` and the picture `wood.png`, by rows from the top red, green | blue, white.
fn folder(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.toml"), text).unwrap();
    let colours = [200, 0, 0, 0, 200, 0, 0, 0, 200, 100, 100, 100];
    write_png(&folder.path().join("wood.png"), [2, 2], png::ColorType::Rgb, &colours);
    folder
}

fn load(folder: &Path) -> Result<Scene, SceneError> {
    Scene::load(&folder.join("room.toml").to_string_lossy())
}

const CORNERS: [[f64; 2]; 4] = [[-0.5, 0.5], [0.5, 0.5], [-0.5, -0.5], [0.5, -0.5]];

#[test]
fn the_top_of_a_picture_is_where_v_is_largest() {
    let text = r#"reflectance = { image = "wood.png", encoding = "linear" }"#;
    let folder = folder(&format!("bands = [\"r\", \"g\", \"b\"]\n{}", room(text)));
    let scene = load(folder.path()).unwrap();
    let pattern = reflectance(&scene);
    let (full, half) = (200.0 / 255.0, 100.0 / 255.0);
    for (band, expected) in
        [[full, 0.0, 0.0, half], [0.0, full, 0.0, half], [0.0, 0.0, full, half]].into_iter().enumerate()
    {
        assert_eq!(CORNERS.map(|corner| pattern.at(band, corner)), expected, "band {band}");
    }
    assert_eq!((pattern.bands(), pattern.grid()), (3, Some([2, 2])));
    let floor = &scene.surfaces[scene.surface_named("floor").unwrap()];
    for mean in &floor.material.reflectance {
        assert!((mean - (full + half) / 4.0).abs() < 1e-15);
    }
}

#[test]
fn one_band_is_the_luminance_of_a_picture() {
    let folder = folder(&room(r#"reflectance = { image = "wood.png", encoding = "linear", factor = 0.5 }"#));
    let scene = load(folder.path()).unwrap();
    assert_eq!(scene.bands, ["grey"], "a picture alone makes no colours");
    let full = 0.5 * 200.0 / 255.0;
    let found = CORNERS.map(|corner| reflectance(&scene).at(0, corner));
    let expected = [0.2126 * full, 0.7152 * full, 0.0722 * full, 0.5 * 100.0 / 255.0];
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-15, "{found} {expected}");
    }
    let picture = reflectance(&scene).picture().expect("it is of a file");
    assert!(picture.path.ends_with("wood.png"));
    assert_eq!(picture.remarks, ["8 bits, linear", "luminance of its colours"]);
}

#[test]
fn grey_pictures_fit_any_bands_and_are_coloured_by_factors() {
    let text = room(r#"reflectance = { image = "grey.png", encoding = "linear", factor = [0.5, 0.25] }"#);
    let folder =
        folder(&format!("bands = [\"a\", \"b\"]\n{text}").replace("emission = 10", "emission = [1, 2]"));
    write_png(&folder.path().join("grey.png"), [1, 1], png::ColorType::Grayscale, &[51]);
    let scene = load(folder.path()).unwrap();
    let pattern = reflectance(&scene);
    assert_eq!([0, 1].map(|band| pattern.at(band, [0.0; 2])), [0.1, 0.05]);
}

#[test]
fn cells_are_typed_as_one_reads_a_picture() {
    let scene = typed("reflectance = { cells = [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]] }");
    let at = |u: f64, v: f64| reflectance(&scene).at(0, [u, v]);
    assert_eq!([-0.8, 0.0, 0.8].map(|u| at(u, 0.5)), [0.1, 0.2, 0.3]);
    assert_eq!([-0.8, 0.0, 0.8].map(|u| at(u, -0.5)), [0.4, 0.5, 0.6]);
    let scene = typed("reflectance = { cells = [[[0.1]], [[0.2]], [[0.3]]], factor = [1, 2, 3] }");
    assert_eq!(scene.bands.len(), 3, "lists for each band make three");
    let found = [0, 1, 2].map(|band| reflectance(&scene).at(band, [0.0; 2]));
    assert_eq!(found, [0.1, 2.0 * 0.2, 3.0 * 0.3]);
}

#[test]
fn polynomials_are_sums_of_their_terms() {
    let scene =
        typed("reflectance = { polynomial = [[0, 0, 0.5], [1, 2, 0.25], [0, 1, -0.125]], factor = 0.5 }");
    for [u, v] in CORNERS {
        let expected = 0.5 * (0.5 + 0.25 * u * v * v - 0.125 * v);
        assert!((reflectance(&scene).at(0, [u, v]) - expected).abs() < 1e-15);
    }
    assert_eq!(reflectance(&scene).degree(), Some(3));
    assert_eq!(scene.surfaces[0].material.reflectance, [0.25]);
    let scene = typed("reflectance = 0\nemission = { polynomial = [[[0, 0, 1]], [[2, 0, 3]], []] }");
    assert_eq!(scene.surfaces[0].material.emission, [1.0, 1.0, 0.0]);
}

#[test]
fn numbers_of_patterns_may_be_formulas() {
    let text = format!(
        "{}\n[variables]\nwhite = 0.5\nodd = 1\n",
        room(
            r#"reflectance = { cells = [["=white", "=white/2"]], scale = ["=odd", 1], offset = [0, "=odd - 1"], factor = "=odd" }
emission = { polynomial = [["=odd", 0, "=white"], [0, 0, 1]] }"#
        )
    );
    let source = Source::new("room", &text);
    for (white, set) in [(0.5, &[][..]), (0.25, &[("white", 0.25)])] {
        let scene = Scene::parse(&source.clone().set(set.iter().copied())).unwrap();
        let material = &scene.surfaces[0].material;
        assert_eq!(reflectance(&scene).at(0, [-0.5, 0.0]), white);
        assert_eq!(reflectance(&scene).at(0, [0.5, 0.0]), white / 2.0);
        let emission = material.emission_pattern.as_deref().expect("it varies");
        assert_eq!(emission.at(0, [1.0, 0.0]), 1.0 + white);
    }
}

/// The place on a line of grids, 0 to 1 in the grid, by the definition of each wrap.
fn wrapped(s: f64, wrap: Wrap) -> f64 {
    match wrap {
        Wrap::Repeat => s - s.floor(),
        Wrap::Mirror => {
            let t = (s / 2.0 - (s / 2.0).floor()) * 2.0;
            if t < 1.0 { t } else { 2.0 - t }
        }
        Wrap::Clamp => s.clamp(0.0, 1.0),
    }
}

fn wraps() -> impl Strategy<Value = Wrap> {
    prop::sample::select(vec![Wrap::Repeat, Wrap::Mirror, Wrap::Clamp])
}

proptest! {
    #[test]
    fn grids_lie_as_their_placement_says(
        [columns, rows] in prop::array::uniform2(1usize..6),
        scale in prop::array::uniform2(0.1..5.0f64),
        offset in prop::array::uniform2(-3.0..3.0f64),
        wrap in wraps(),
        [u, v] in prop::array::uniform2(-1.0..1.0f64),
    ) {
        let values: Vec<f64> = (0..columns * rows).map(|k| k as f64).collect();
        let placement = Placement { offset, scale, wrap };
        let pattern = Pattern::texels(columns, vec![values.clone()], placement).unwrap();
        let place = |axis: usize, x: f64, count: usize| {
            wrapped(offset[axis] + scale[axis] * (x + 1.0) / 2.0, wrap) * count as f64
        };
        let (s, t) = (place(0, u, columns), place(1, v, rows));
        // On a border either side may be meant.
        prop_assume!([s, t].iter().all(|x| (x - x.round()).abs() > 1e-9 || wrap == Wrap::Clamp));
        let [i, j] = [(s, columns), (t, rows)].map(|(x, count)| (x as usize).min(count - 1));
        prop_assert_eq!(pattern.at(0, [u, v]), values[i + columns * j]);
    }

    #[test]
    fn between_breaks_nothing_changes_and_the_mean_is_that_of_the_pieces(
        columns in 1usize..5,
        values in prop::collection::vec(0.0..1.0f64, 4 * 3),
        scale in prop::array::uniform2(0.1..4.0f64),
        offset in prop::array::uniform2(-2.0..2.0f64),
        wrap in wraps(),
    ) {
        let values = values[..3 * columns].to_vec();
        let pattern = Pattern::texels(columns, vec![values], Placement { offset, scale, wrap }).unwrap();
        let pieces = pattern.breaks().map(|breaks| {
            let ends: Vec<f64> = [-1.0].into_iter().chain(breaks).chain([1.0]).collect();
            ends.windows(2).map(|ends| [ends[0], ends[1]]).collect::<Vec<_>>()
        });
        let mut mean = 0.0;
        for [u0, u1] in &pieces[0] {
            for [v0, v1] in &pieces[1] {
                let at = |a: f64, b: f64| pattern.at(0, [u0 + a * (u1 - u0), v0 + b * (v1 - v0)]);
                let middle = at(0.5, 0.5);
                for (a, b) in [(0.01, 0.01), (0.99, 0.01), (0.3, 0.99)] {
                    prop_assert_eq!(at(a, b), middle);
                }
                mean += 0.25 * (u1 - u0) * (v1 - v0) * middle;
            }
        }
        prop_assert!((pattern.mean(0) - mean).abs() < 1e-12);
    }
}

#[test]
fn ranges_of_polynomials_are_those_of_their_extremes() {
    let terms =
        |list: &[(u32, u32, f64)]| Polynomial::new(list.iter().map(|&(u, v, factor)| Term { u, v, factor }));
    // 3 u² − u⁴ − v: from −1 at u = 0, v = 1 to 3 at |u| = 1, v = −1.
    let pattern = Pattern::polynomial(vec![terms(&[(2, 0, 3.0), (4, 0, -1.0), (0, 1, -1.0)])]);
    let [least, most] = pattern.range(0);
    assert!((least + 1.0).abs() < 1e-7 && (most - 3.0).abs() < 1e-7, "{least} {most}");
    assert!(least <= -1.0 && most >= 3.0, "they are bounds");
}

/// The message and the cure of a wrong material.
fn refused(material: &str) -> (String, String) {
    let error = Scene::from_toml(&room(material), "room").expect_err(material);
    (error.to_string(), error.cure().unwrap_or_default())
}

#[test]
fn wrong_patterns_are_refused_with_a_cure() {
    for (material, message, cure) in [
        ("reflectance = { }", "\"image\" is missing", "cells"),
        (
            "reflectance = { cells = [[0.5]], polynomial = [] }",
            "\"cells\" and \"polynomial\" are both given",
            "leave one",
        ),
        ("reflectance = { cells = [[0.5]], encoding = \"srgb\" }", "\"cells\" and \"encoding\"", "leave one"),
        ("reflectance = { polynomial = [], scale = 2 }", "\"polynomial\" and \"scale\"", "leave one"),
        ("reflectance = { cells = [[0.5, 0.5], [0.5]] }", "a row of cells takes 2 numbers", "give 2"),
        ("reflectance = { cells = [] }", "the list of cells takes rows", "give rows"),
        ("reflectance = { cells = [[]] }", "the list of cells takes rows", "give rows"),
        (
            "reflectance = { cells = [[0.5, 1]] }",
            "the reflectance is 1 in the texel of column 2, row 1 from the top, outside 0 ≤ ρ < 1",
            "factor = 0.90",
        ),
        (
            "reflectance = { cells = [[0.5], [-0.1]] }",
            "is -0.1 in the texel of column 1, row 2 from the top",
            "nowhere below 0",
        ),
        ("reflectance = { cells = [[0.5]], factor = 2 }", "the reflectance is 1 in", "times the factor"),
        ("reflectance = { cells = [[0.5]], factor = -1 }", "the factor is -1", "factor ≥ 0"),
        (
            "reflectance = { cells = [[0.5]], factor = [1, 1] }",
            "the factor takes one for all bands or 3",
            "give one",
        ),
        (
            "reflectance = { cells = [[[0.5]], [[0.5]]] }",
            "the list of cells takes one for all bands or 3",
            "give one",
        ),
        ("reflectance = { cells = [[0.5]], scale = 0 }", "the scale is 0", "scale > 0"),
        ("reflectance = { cells = [[0.5]], scale = [1, -1] }", "the scale is -1", "scale > 0"),
        (
            "reflectance = { cells = [[0.5]], scale = 1e7 }",
            "the number of texels across the surface is 10000000",
            "10⁶",
        ),
        (
            "reflectance = { cells = [[0.5]], wrap = \"tile\" }",
            "there is no wrap \"tile\"",
            "repeat, mirror, clamp",
        ),
        (
            "reflectance = { image = \"a.png\", encoding = \"sRGB\" }",
            "there is no encoding \"sRGB\"",
            "did you mean \"srgb\"?",
        ),
        (
            "reflectance = { image = \"a.png\" }",
            "\"a.png\" cannot be included: the text is not that of a file",
            "read the scene from its file",
        ),
        ("reflectance = { polynomial = [[0, 0]] }", "a term takes three numbers", "give three numbers"),
        ("reflectance = { polynomial = [[0.5, 0, 1]] }", "0.5 is not a whole number", "give 0, 1, 2"),
        ("reflectance = { polynomial = [[21, 0, 0.1]] }", "the power is 21", "0 ≤ power ≤ 20"),
        (
            "reflectance = { polynomial = [[0, 0, 0.5], [1, 0, 0.5]] }",
            "at u = 1.0000",
            "scale the pattern down",
        ),
        (
            "reflectance = 0.5\nemission = { polynomial = [[1, 1, 1]] }",
            "the emission is -1",
            "nowhere below 0",
        ),
        ("reflectance = 0.5\nemission = { cells = [[-2]] }", "the emission is -2", "nowhere below 0"),
        (
            "reflectance = { cells = [[0.5]] }\ntransmittance = 0.5",
            "outside ρ + τ < 1",
            "scale the pattern down",
        ),
        (
            "reflectance = 0.5\ntransmittance = 0.5",
            "the sum of reflectance and transmittance is 1",
            "ρ + τ < 1",
        ),
        ("reflectance = 0.5\ntransmittance = -0.1", "the transmittance is -0.1", "0 ≤ τ < 1"),
        (
            "reflectance = 0.5\ntransmittance = [0.1, 0.2]",
            "the transmittance takes",
            "give one number for all bands",
        ),
    ] {
        let (found, mended) = refused(material);
        assert!(found.contains(message), "{material}: {found}");
        assert!(mended.contains(cure), "{material}: {mended}");
        assert!(found.starts_with("room:"), "{found} has a place");
    }
}

#[test]
fn a_flux_and_a_pattern_of_emission_are_refused() {
    let text = room("reflectance = 0.1\nemission = { cells = [[1, 2]] }");
    let text = text.replace("name = \"floor\"", "name = \"floor\"\nflux = 10");
    let error = Scene::from_toml(&text, "room").expect_err("both are given");
    assert!(error.to_string().contains("a flux is given"), "{error}");
    assert!(error.cure().is_some_and(|cure| cure.contains("`factor`")));
}

#[test]
fn pictures_that_cannot_be_read_are_named_with_their_place() {
    let refused = |picture: Option<&[u8]>, bands: &str| {
        let folder = folder(&format!("{bands}\n{}", room("reflectance = { image = \"wood.png\" }")));
        match picture {
            Some(bytes) => fs::write(folder.path().join("wood.png"), bytes).unwrap(),
            None if bands.is_empty() => fs::remove_file(folder.path().join("wood.png")).unwrap(),
            None => {}
        }
        let error = load(folder.path()).expect_err("it is wrong");
        let place = error.place.as_ref().expect("it has a place");
        assert!(place.text.contains("wood.png"), "{}", place.text);
        (error.to_string(), error.cure().unwrap_or_default())
    };
    for (picture, bands, message, cure) in [
        (None, "", "wood.png\" cannot be read", "check the path"),
        (Some(&b"\xff\xd8\xff\xe0"[..]), "", "it is a JPEG, not PNG or OpenEXR", "magick"),
        (Some(b"\x89PNG\r\n\x1a\n"), "", "it is damaged or cut off", "write it again"),
        (
            None,
            "bands = [\"a\", \"b\"]",
            "it is coloured, and there are 2 bands",
            "three for red, green and blue",
        ),
    ] {
        let (found, mended) = refused(picture, bands);
        assert!(found.contains(message), "{found}");
        assert!(mended.contains(cure), "{mended}");
    }
    // White is too bright for a reflectance.
    let folder = folder(&room("reflectance = { image = \"wood.png\" }"));
    write_png(&folder.path().join("wood.png"), [1, 1], png::ColorType::Grayscale, &[255]);
    let error = load(folder.path()).expect_err("a reflectance of 1");
    assert!(error.to_string().contains("the reflectance is 1 in the texel of column 1, row 1"), "{error}");
    assert!(error.cure().is_some_and(|cure| cure.contains("factor = 0.90")));
}

#[test]
fn paths_start_from_the_folder_of_their_file() {
    let main = room("reflectance = 0.5").replace("material = \"floor\"", "material = \"parquet\"");
    let folder = folder(&format!("include = [\"paints/wood.toml\"]\n{main}"));
    fs::create_dir(folder.path().join("paints")).unwrap();
    let paint = "materials.parquet = { reflectance = { image = \"../wood.png\" } }";
    fs::write(folder.path().join("paints/wood.toml"), paint).unwrap();
    assert_eq!(reflectance(&load(folder.path()).unwrap()).grid(), Some([2, 2]));
}

#[test]
fn large_pictures_are_averaged_and_told() {
    let folder = folder(&room("reflectance = { image = \"wood.png\", encoding = \"linear\", factor = 0.5 }"));
    let [width, height] = [4096, 2048];
    let bytes: Vec<u8> = (0..width * height).map(|index| if index % 2 == 0 { 255 } else { 0 }).collect();
    write_png(&folder.path().join("wood.png"), [width, height], png::ColorType::Grayscale, &bytes);
    let scene = load(folder.path()).unwrap();
    let pattern = reflectance(&scene);
    assert_eq!(pattern.grid(), Some([2048, 1024]));
    assert_eq!(pattern.range(0), [0.25, 0.25]);
    let remarks = &pattern.picture().expect("it is of a file").remarks;
    assert!(remarks.contains(&"averaged from 4096 × 2048 to 2048 × 1024 texels".to_owned()), "{remarks:?}");
}

const VARIED: &str = r#"reflectance = { image = "wood.png", scale = [2, 1.5], wrap = "mirror", factor = 0.9 }
emission = { polynomial = [[0, 0, 1], [2, 1, 0.3]] }"#;

#[test]
fn a_solution_needs_no_picture() {
    let folder = folder(&room(VARIED));
    let scene = load(folder.path()).unwrap();
    let solved = Solved::new(scene.clone(), Options { threads: 1, ..Options::default() }, &|_| {}).unwrap();
    let text = serde_json::to_string(&SolutionFile::new(&solved)).unwrap();
    folder.close().unwrap();
    let reread = read(&Source::new("room.json", &text)).unwrap();
    for (own, other) in scene.surfaces.iter().zip(&reread.scene.surfaces) {
        assert_eq!(own.material, other.material);
        assert_eq!(own.other_side, other.other_side);
    }
    assert!(reread.scene.surfaces[0].material.is_patterned());
    let again = serde_json::to_string(&SolutionFile::new(&reread)).unwrap();
    assert_eq!(text, again, "and it is written as it was read");
    let (before, after) = text.split_once("\"base64\":\"").expect("it holds the picture");
    for damaged in [format!("{before}\"base64\":\"?{after}"), format!("{before}\"base64\":\"AAAA{after}")] {
        let error = read(&Source::new("room.json", &damaged)).expect_err("the picture is damaged");
        assert!(error.to_string().contains("picture") || error.to_string().contains("PNG"), "{error}");
    }
}

#[test]
fn what_is_printed_reads_as_the_same_scene() {
    let folder = folder(&room(VARIED));
    let scene = load(folder.path()).unwrap();
    for (notation, name) in [(Notation::Toml, "again.toml"), (Notation::Json, "again.json")] {
        let path = folder.path().join(name);
        fs::write(&path, scene.text(notation).unwrap()).unwrap();
        let again = Scene::load(&path.to_string_lossy()).unwrap();
        assert_eq!(again.surfaces[0].material, scene.surfaces[0].material, "{name}");
    }
}

#[test]
fn other_programs_get_means_and_are_told() {
    let text = room("reflectance = { cells = [[0.2, 0.4]] }\ntransmittance = 0.1")
        .replace("name = \"floor\"", "name = \"floor\"\ntwo_sided = true\nback_material = \"other\"");
    let text = format!("{text}\n[materials.other]\nreflectance = 0.3\ntransmittance = 0.1\n");
    let model = Scene::from_toml(&text, "room").unwrap().model().unwrap();
    let floor = model.materials.iter().find(|own| own.name == "floor").expect("it is there");
    assert!((floor.reflectance[0] - 0.3).abs() < 1e-15);
    let notes: Vec<&str> = model.notes.iter().map(|note| note.text.as_str()).collect();
    for told in ["becomes its mean", "transmittances are left out", "materials of backs are left out"] {
        assert!(notes.iter().any(|note| note.contains(told)), "{told}: {notes:?}");
    }
    assert_eq!(Import::default().format_of("room.toml"), None);
}

#[test]
fn all_copies_of_a_part_share_a_pattern() {
    let text = r#"
[materials.tile]
reflectance = { cells = [[0.2, 0.4], [0.4, 0.2]] }
[[parts.cube.surfaces]]
name = "side"
material = "tile"
box = { origin = [0, 0, 0], size = [1, 1, 1] }
[[instances]]
part = "cube"
name = "cube"
array = { count = 3, step = [2, 0, 0] }
"#;
    let scene = Scene::from_toml(text, "cubes").unwrap();
    assert_eq!(scene.surfaces.len(), 18);
    let patterns: Vec<_> =
        scene.surfaces.iter().map(|own| own.material.reflectance_pattern.clone().unwrap()).collect();
    assert!(patterns.iter().all(|own| std::sync::Arc::ptr_eq(own, &patterns[0])));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn changed_pictures_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 5, 3);
        encoder.set_color(png::ColorType::Rgb);
        encoder.write_header().and_then(|mut writer| writer.write_image_data(&[120; 45])).unwrap();
        for (index, byte) in changes {
            let index = index.index(bytes.len());
            bytes[index] = byte;
        }
        let source = Source::new("room.toml", &room("reflectance = { image = \"wood.png\" }")).with_picture("wood.png", bytes);
        if let Ok(scene) = Scene::parse(&source) {
            prop_assert!(reflectance(&scene).range(0).iter().all(|rho| (0.0..1.0).contains(rho)));
        }
    }
}

#[path = "../../examples/wood/grain.rs"]
mod grain;

#[test]
fn the_example_shows_what_its_picture_is_made_of() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/textured-room.toml");
    let scene = Scene::load(&path.to_string_lossy()).unwrap();
    scene.require_light().unwrap();
    let pattern = reflectance(&scene);
    let [columns, rows] = grain::SIZE;
    assert_eq!(pattern.grid(), Some([columns, rows]));
    let texels = grain::texels();
    let placement = pattern.placement().expect("it is a grid");
    for (index, texel) in texels.chunks_exact(3).enumerate() {
        // The texel of the lowest picture of the many, seen from its upper left.
        let place = |axis: usize, index: usize, count: usize| {
            2.0 * ((index as f64 + 0.5) / count as f64) / placement.scale[axis] - 1.0
        };
        let (column, row) = (index % columns, rows - 1 - index / columns);
        let parameters = [place(0, column, columns), place(1, row, rows)];
        for (band, code) in texel.iter().enumerate() {
            let light = ((f64::from(*code) / 255.0 + 0.055) / 1.055).powf(2.4);
            assert!((pattern.at(band, parameters) - light).abs() < 1e-12);
        }
    }
    let shade = &scene.surfaces[scene.surface_named("shade:back").unwrap()];
    assert!(shade.material.transmits());
}
