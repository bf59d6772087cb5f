//! Pictures of materials: how they lie on surfaces, what is refused, that a solution and printed scenes keep
//! them, and the example.

use std::fs::{self};
use std::path::Path;

use proptest::prelude::*;
use radiosity::reading::files::solution_file::{SolutionFile, read};
use radiosity::scene::{Notation, Scene, SceneError, Source};
use radiosity::solve::Options;
use radiosity_test_support::folders::{self, png};
use radiosity_test_support::grain;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::{sealed, solved_of};

use crate::textures::{CORNERS, reflectance, room};

/// A folder with the scene `room.toml` and the picture `wood.png`, by rows from the top red, green | blue,
/// white.
fn folder(text: &str) -> tempfile::TempDir {
    let colours = [200, 0, 0, 0, 200, 0, 0, 0, 200, 100, 100, 100];
    let wood = png([2, 2], png::ColorType::Rgb, &colours);
    folders::folder(&[("room.toml", text.as_bytes()), ("wood.png", &wood)])
}

fn load(folder: &Path) -> Result<Scene, SceneError> {
    radiosity::load(&folder.join("room.toml").to_string_lossy())
}

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
    fs::write(folder.path().join("grey.png"), png([1, 1], png::ColorType::Grayscale, &[51])).unwrap();
    let scene = load(folder.path()).unwrap();
    let pattern = reflectance(&scene);
    assert_eq!([0, 1].map(|band| pattern.at(band, [0.0; 2])), [0.1, 0.05]);
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
    fs::write(folder.path().join("wood.png"), png([1, 1], png::ColorType::Grayscale, &[255])).unwrap();
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
    fs::write(folder.path().join("wood.png"), png([width, height], png::ColorType::Grayscale, &bytes))
        .unwrap();
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
    let solved = solved_of(scene.clone(), Options { threads: 1, ..Options::default() });
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
        let error = read(&Source::new("room.json", &sealed(&damaged))).expect_err("the picture is damaged");
        assert!(error.to_string().contains("picture") || error.to_string().contains("PNG"), "{error}");
    }
}

#[test]
fn what_is_printed_reads_as_the_same_scene() {
    let folder = folder(&room(VARIED));
    let scene = load(folder.path()).unwrap();
    for (notation, name) in [(Notation::Toml, "again.toml"), (Notation::Json, "again.json")] {
        let path = folder.path().join(name);
        fs::write(&path, radiosity::language::text(&scene, notation).unwrap()).unwrap();
        let again = radiosity::load(&path.to_string_lossy()).unwrap();
        assert_eq!(again.surfaces[0].material, scene.surfaces[0].material, "{name}");
    }
}

#[test]
fn other_programs_get_means_and_are_told() {
    let text = room("reflectance = { cells = [[0.2, 0.4]] }\ntransmittance = 0.1")
        .replace("name = \"floor\"", "name = \"floor\"\ntwo_sided = true\nback_material = \"other\"");
    let text = format!("{text}\n[materials.other]\nreflectance = 0.3\ntransmittance = 0.1\n");
    let model = radiosity::language::model(&typed(&text), None).unwrap();
    let floor = model.materials.iter().find(|own| own.name == "floor").expect("it is there");
    assert!((floor.reflectance[0] - 0.3).abs() < 1e-15);
    let notes: Vec<&str> = model.notes.iter().map(|note| note.text.as_str()).collect();
    for told in ["becomes its mean", "transmittances are left out", "materials of backs are left out"] {
        assert!(notes.iter().any(|note| note.contains(told)), "{told}: {notes:?}");
    }
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
        if let Ok(scene) = radiosity::language::read(&source) {
            prop_assert!(reflectance(&scene).range(0).iter().all(|rho| (0.0..1.0).contains(rho)));
        }
    }
}

#[test]
fn the_example_shows_what_its_picture_is_made_of() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/textured-room.toml");
    let scene = radiosity::load(&path.to_string_lossy()).unwrap();
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
