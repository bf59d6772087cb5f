//! Pictures: radiosities in files against closed forms, borders of elements, and what is refused.

use std::fs::{self, File};
use std::io::{BufReader, Cursor, Read};
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::DeflateDecoder;
use radiosity::output::files::exr_file::read_exr;
use radiosity::output::pictures::wireframe::wireframe;
use radiosity::reading::pictures::pixel_grid::PixelGrid;
use radiosity::reading::pictures::seen_surfaces::SeenSurfaces;
use radiosity::visibility::Visibility;
use radiosity::work::ranks::Ranks;
use radiosity_test_support::folders::folder;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::elements_of;

use crate::program::{self, done, radiosity};

/// Width and height of a PNG.
fn png_size(path: &Path) -> [u32; 2] {
    let file = BufReader::new(File::open(path).expect("it was written"));
    let reader = png::Decoder::new(file).read_info().expect("it is a PNG");
    [reader.info().width, reader.info().height]
}

/// Some rays meet the edges of the room exactly, where two walls shine on each other from no distance.
#[test]
fn radiosities_of_the_furnace_are_two_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    for (read, samples) in [("basis", "3"), ("direct", "1"), ("gather", "1")] {
        let picture = ["render", "furnace-cube", "--size", "20x16", "--eps", "1e-5", "-o", "f.exr"];
        done(folder.path(), &[&picture[..], &["--read", read, "--samples", samples]].concat());
        let file = BufReader::new(File::open(folder.path().join("f.exr")).unwrap());
        let raster = read_exr(file, &["grey".to_owned()]).expect("it is ours");
        assert_eq!(raster.size(), [20, 16]);
        let seen: Vec<f64> = raster.field(None).seen().collect();
        assert!(seen.len() > 100, "the camera looks into the cube");
        let farthest = seen.iter().map(|radiosity| (radiosity - 2.0).abs()).fold(0.0, f64::max);
        // B = 1 / (1 − ½) everywhere; what is gathered in pictures is good to 3e-3.
        assert!(farthest < if read == "gather" { 6e-3 } else { 1e-3 }, "{read}: {farthest}");
    }
}

/// B = 1 / (1 − ½) in the furnace; a draft is good to a few parts in a hundred.
#[test]
fn previews_say_what_they_are_and_take_few_pixels_unless_told() {
    let folder = tempfile::tempdir().unwrap();
    for (size, expected) in [(&["--size", "40x30"][..], [40, 30]), (&[], [111, 111])] {
        let asked = ["render", "furnace-cube", "--preview", "-o", "p.exr"];
        let [_, told] = done(folder.path(), &[&asked[..], size].concat());
        assert!(told.contains("a preview: light from lamps recomputed"), "{told}");
        let file = BufReader::new(File::open(folder.path().join("p.exr")).unwrap());
        let raster = read_exr(file, &["grey".to_owned()]).expect("it is ours");
        assert_eq!(raster.size(), expected);
        let farthest = raster.field(None).seen().map(|found| (found - 2.0).abs()).fold(0.0, f64::max);
        assert!(farthest < 0.1, "{farthest}");
    }
    let [_, told] = done(folder.path(), &["render", "cornell-box", "--preview", "--audit", "0.1"]);
    assert!(told.contains("checked at"), "{told}");
    for other in [&["--importance"][..], &["--read", "gather"], &["-o", "p.glb"], &["-o", "p.html"]] {
        let output =
            radiosity(folder.path(), &[&["render", "furnace-cube", "--preview"][..], other].concat());
        assert_eq!(output.status.code(), Some(2), "{other:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("--preview"), "{other:?}");
    }
}

#[test]
fn a_picture_does_not_differ_from_itself() {
    let folder = tempfile::tempdir().unwrap();
    let at = ["render", "empty-box", "--size", "40x30", "--samples", "1"];
    done(folder.path(), &[&at[..], &["-o", "a.exr"]].concat());
    // The file holds 32 bits.
    let [_, told] = done(folder.path(), &[&at[..], &["--difference", "a.exr", "-o", "d.png"]].concat());
    assert!(told.contains("difference: rms 0.0000 %, largest 0.0000 %"), "{told}");
    let [_, told] = done(folder.path(), &[&at[..], &["--difference", "a.exr", "--order", "0"]].concat());
    assert!(!told.contains("rms 0.0"), "{told}");
}

#[test]
fn pictures_of_solution_files_are_compared() {
    let folder = tempfile::tempdir().unwrap();
    done(folder.path(), &["solve", "empty-box", "--order", "1", "-o", "s.json"]);
    let at = ["render", "empty-box", "--size", "20x15", "--samples", "1", "--difference", "s.json"];
    let [_, told] = done(folder.path(), &[&at[..], &["--order", "1"]].concat());
    assert!(told.contains("difference: rms 0.0000 %, largest 0.0000 %"), "{told}");
    let [_, told] = done(folder.path(), &[&at[..], &["--order", "0"]].concat());
    assert!(!told.contains("rms 0.0"), "{told}");
    let output =
        radiosity(folder.path(), &["render", "furnace-cube", "--size", "8x6", "--difference", "s.json"]);
    assert_eq!(output.status.code(), Some(0), "names and areas are those of the cube");
    let output =
        radiosity(folder.path(), &["render", "cornell-box", "--size", "8x6", "--difference", "s.json"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("s.json: it has other bands"));
}

#[test]
fn convergence_draws_other_ways_beside_rising_orders() {
    let folder = tempfile::tempdir().unwrap();
    let asked = ["convergence", "furnace-cube", "--max-order", "1", "--format", "csv", "-q"];
    let output = radiosity(folder.path(), &[&asked[..], &["--with", "hierarchical,hp"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let table = String::from_utf8_lossy(&output.stdout);
    let ways: Vec<&str> = table.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    assert_eq!(ways, [&["uniform"; 2][..], &["hierarchical"; 4], &["hp"; 4]].concat());
    let drawn = fs::read_to_string(folder.path().join("furnace-cube.svg")).unwrap();
    assert!(drawn.contains("hierarchical, constants") && drawn.contains("refined for gathered light"));
    refused(&["convergence", "--with", "uniform"], &["hierarchical, hp, sampled"]);
}

#[test]
fn convergence_draws_all_bases() {
    let folder = tempfile::tempdir().unwrap();
    let asked =
        ["convergence", "empty-box", "--max-order", "2", "--bases", "--format", "csv", "-q", "-o", "b.svg"];
    let output = radiosity(folder.path(), &asked);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let table = String::from_utf8_lossy(&output.stdout);
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let ways: Vec<&str> = rows.iter().map(|row| row[0]).collect();
    assert_eq!(ways, [&["uniform"; 3][..], &["constant"; 5], &["linear"; 5], &["harmonic"; 3]].concat());
    // The errors of energy of all bases fall with their unknowns, down to that of the reference.
    for way in ["constant", "harmonic"] {
        let errors = rows.iter().filter(|row| row[0] == way).map(|row| row[10].parse().ok());
        let errors: Vec<f64> = errors.flatten().collect();
        assert!(errors.len() > 2 && errors.windows(2).all(|pair| pair[1] < pair[0]), "{errors:?}");
    }
    let drawn = fs::read_to_string(folder.path().join("b.svg")).unwrap();
    for label in ["constants on cells", "tents on cells", "cosines over surfaces"] {
        assert!(drawn.contains(label), "{label}");
    }
}

#[test]
fn importance_is_drawn_of_a_solution_too() {
    let folder = tempfile::tempdir().unwrap();
    done(folder.path(), &["solve", "cornell-box", "--order", "0", "-o", "s.json"]);
    for scene in ["cornell-box", "s.json"] {
        done(
            folder.path(),
            &["render", scene, "--importance", "--for", "picture", "--size", "16x16", "-o", "i.exr"],
        );
    }
    refused(&["render", "--importance", "--show", "irradiance"], &["cannot be used with", "--show"]);
}

#[test]
fn a_solution_file_is_a_reference() {
    let folder = tempfile::tempdir().unwrap();
    done(folder.path(), &["solve", "empty-box", "--order", "2", "-o", "s.json"]);
    let at = ["convergence", "empty-box", "--max-order", "2", "--format", "csv", "--reference", "s.json"];
    let output = radiosity(folder.path(), &at);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let table = String::from_utf8_lossy(&output.stdout);
    let errors: Vec<f64> =
        table.lines().skip(1).map(|line| line.split(',').nth(8).unwrap().parse().unwrap()).collect();
    assert_eq!(errors.len(), 3);
    assert!(errors[0] > errors[1] && errors[1] > 0.01, "{errors:?}");
    assert!(errors[2] < 1e-12, "the same run: {errors:?}");
    assert!(fs::read_to_string(folder.path().join("empty-box.svg")).unwrap().contains("s.json"));
    let output = radiosity(folder.path(), &["convergence", "furnace-cube", "--reference", "s.json"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("it has other materials"));
}

/// The square without its camera.
fn without_camera() -> String {
    let (start, rest) = SQUARE.split_once("[camera]").expect("there is one");
    format!("{start}{}", &rest[rest.find("[materials").expect("it follows")..])
}

/// Moved to where coordinates are large, which are told as they are in the file.
#[test]
fn a_view_is_chosen_that_sees_the_scene_and_told_as_it_would_be_typed() {
    let far = without_camera().replace("[[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]]", FAR_SQUARE);
    let folder = folder(&[("s.toml", far)]);
    let picture = ["render", "s.toml", "--read", "basis", "--size", "16x16"];
    let [_, told] = done(folder.path(), &[&picture[..], &["-o", "a.exr"]].concat());
    let view = told.split_once("no camera in the scene: seen from ").expect("it is told").1;
    let view = view.lines().next().expect("a line").replace("to target", "target");
    let typed: Vec<String> = view.split(", ").flat_map(|part| part.split(' ').map(str::to_owned)).collect();
    let [eye, from, target, to, fov, degrees] = typed.iter().map(String::as_str).collect::<Vec<_>>()[..]
    else {
        panic!("{view}");
    };
    assert_eq!([eye, target, fov], ["eye", "target", "fov"]);
    let view = ["--eye", from, "--target", to, "--fov", degrees, "-o", "b.exr"];
    let [_, told] = done(folder.path(), &[&picture[..], &view].concat());
    assert!(!told.contains("no camera"), "what is typed need not be told: {told}");
    let [chosen, typed] = ["a.exr", "b.exr"].map(|name| fs::read(folder.path().join(name)).unwrap());
    assert!(chosen == typed);
    let raster = read_exr(Cursor::new(chosen), &["grey".to_owned()]).expect("it is ours");
    assert!(raster.field(None).seen().count() > 40, "much of the picture shows the square");
}

const FAR_SQUARE: &str = "[[5999,-3001,70],[6001,-3001,70],[6001,-2999,70],[5999,-2999,70]]";

/// The camera of the square sees [−½, ½]²; from four times as high it sees [−2, 2]², as it does through four times the
/// tangent of half its angle.
#[test]
fn views_that_are_typed_take_the_place_of_the_camera() {
    let folder = folder(&[("s.toml", SQUARE)]);
    let seen = |view: &[&str]| {
        let picture = ["render", "s.toml", "--read", "basis", "--samples", "1", "-o", "s.exr"];
        done(folder.path(), &[&picture[..], view].concat());
        let file = BufReader::new(File::open(folder.path().join("s.exr")).unwrap());
        read_exr(file, &["grey".to_owned()]).expect("it is ours").field(None).seen().count()
    };
    let all = 48 * 48;
    assert_eq!(seen(&[]), all);
    assert_eq!(seen(&["--eye", "0,0,4"]), all / 4);
    assert_eq!(seen(&["--fov", "126.86989764584402"]), all / 4);
    // Turned upside down and to the rim: [½, 3/2] × [−½, ½].
    assert_eq!(seen(&["--eye", "1,0,1", "--target", "1,0,0", "--view-up", "0,-1,0"]), all / 2);
    let refused = |view: &[&str], parts: &[&str]| {
        program::refused(folder.path(), &[&["render", "s.toml"], view].concat(), parts);
    };
    refused(&["--eye", "0,0"], &["--eye", "expected three numbers"]);
    refused(&["--fov", "180"], &["--fov", "expected degrees above 0 and below 180"]);
    refused(&["--eye", "0,0,0"], &["eye and target are the same point"]);
    refused(&["--view-up", "0,0,1"], &["the up vector lies along the view"]);
}

/// Texts of a PNG by their keywords.
fn png_texts(path: &Path) -> Vec<[String; 2]> {
    let file = BufReader::new(File::open(path).expect("it was written"));
    let reader = png::Decoder::new(file).read_info().expect("it is a PNG");
    let texts = reader.info().utf8_text.iter();
    texts.map(|text| [text.keyword.clone(), text.get_text().expect("it is plain")]).collect()
}

/// The square is as bright all over: nothing shines on it. It emits, and nothing else is seen.
#[test]
fn exposures_are_told_in_exposure_values() {
    let folder = folder(&[("s.toml", SQUARE.replace("emission = 1", "emission = 8"))]);
    let exposed = |exposure: &[&str]| {
        let picture = ["render", "s.toml", "--read", "basis", "-o", "s.png", "--report", "s.json"];
        let [_, told] = done(folder.path(), &[&picture[..], exposure].concat());
        let path = folder.path().join("s.png");
        let [[keyword, text]] = &png_texts(&path)[..] else { panic!("one text") };
        assert_eq!(keyword, "Exposure");
        assert!(told.contains(&format!("wrote s.png; {text}\n")), "{told}");
        let report: serde_json::Value =
            serde_json::from_slice(&fs::read(folder.path().join("s.json")).unwrap()).unwrap();
        (text.clone(), report["exposure"].clone(), png_colours(&path))
    };
    let chosen = exposed(&[]);
    assert_eq!(chosen.0, "exposure -3.00 EV, chosen: radiosity of 8 W/m² is white");
    assert_eq!(chosen.1, serde_json::json!({"factor": 0.125, "ev": -3.0, "automatic": true}));
    assert_eq!(exposed(&["--exposure", "auto"]), chosen);
    let typed = exposed(&["--exposure", "-4EV"]);
    assert_eq!(typed.0, "exposure -4.00 EV: radiosity of 16 W/m² is white");
    assert_eq!(exposed(&["--exposure", "0.0625"]), typed);
    // Half of white: sRGB 188.
    assert!(typed.2.iter().flatten().all(|code| (187..=188).contains(code)), "{:?}", typed.2);
    refused(
        &["render", "--exposure", "-3"],
        &["--exposure", "expected auto, exposure values such as -6.5EV"],
    );
}

/// A lamp that fills a ninth of the view is a million times as bright as what it lights.
#[test]
fn lamps_do_not_darken_a_picture() {
    let folder = folder(&[("s.toml", below_a_lamp())]);
    done(folder.path(), &["render", "s.toml", "--samples", "1", "-o", "s.exr"]);
    let [_, told] = done(folder.path(), &["render", "s.toml", "--report", "s.json", "-o", "s.png"]);
    let file = BufReader::new(File::open(folder.path().join("s.exr")).unwrap());
    let raster = read_exr(file, &["grey".to_owned()]).expect("it is ours");
    let lit: Vec<f64> = raster.field(None).seen().filter(|radiosity| *radiosity < 9e5).collect();
    let (brightest, mean) =
        (lit.iter().fold(0.0, |a, b| f64::max(a, *b)), lit.iter().sum::<f64>() / lit.len() as f64);
    let report: serde_json::Value =
        serde_json::from_slice(&fs::read(folder.path().join("s.json")).unwrap()).unwrap();
    let white = 1.0 / report["exposure"]["factor"].as_f64().expect("a number");
    assert!(mean < white && white <= brightest, "{mean} {white} {brightest}: {told}");
}

/// Comments within pictures are of their values.
#[test]
fn values_are_named_with_their_unit() {
    let lux = SQUARE.replace("bands = [\"grey\"]", "bands = [\"lm\"]\nunit = \"lx\"");
    let folder = folder(&[("s.toml", lux)]);
    for (show, says) in [
        ("irradiance", "illuminance in lx, linear"),
        ("radiosity", "radiosity in lx, linear; radiance is radiosity / pi"),
    ] {
        done(folder.path(), &["render", "s.toml", "--read", "basis", "--show", show, "-o", "s.exr"]);
        let bytes = fs::read(folder.path().join("s.exr")).unwrap();
        let has = |text: &str| bytes.windows(text.len()).any(|part| part == text.as_bytes());
        assert!(has(says) && !has("W/m"), "{show}");
    }
}

#[test]
fn a_legend_stands_beside_false_colours() {
    let folder = tempfile::tempdir().unwrap();
    let at = ["render", "empty-box", "--size", "60x120", "--samples", "1", "--wireframe"];
    done(folder.path(), &[&at[..], &["-o", "plain.png"]].concat());
    assert_eq!(png_size(&folder.path().join("plain.png")), [60, 120]);
    let coded = ["--false-color", "--range", "0,1.5", "--band", "grey", "-o", "coded.png"];
    done(folder.path(), &[&at[..], &coded].concat());
    let [width, height] = png_size(&folder.path().join("coded.png"));
    assert!(width > 100 && height == 120);
}

/// The room's walls have ρ = ½ and emit nothing, its ceiling emits 1.
#[test]
fn irradiance_is_shown_apart_from_reflectance_and_emission() {
    let folder = tempfile::tempdir().unwrap();
    let at = ["render", "empty-box", "--size", "30x40", "--samples", "1"];
    let [b, e] = ["radiosity", "irradiance"].map(|shown| {
        done(folder.path(), &[&at[..], &["--show", shown, "-o", "shown.exr"]].concat());
        let file = BufReader::new(File::open(folder.path().join("shown.exr")).unwrap());
        read_exr(file, &["grey".to_owned()]).expect("it is ours").field(None)
    });
    let (mut emitting, mut dark) = (0, 0);
    for (b, e) in b.seen().zip(e.seen()) {
        // The file holds 32 bits.
        let is = |expected: f64| (b / expected - 1.0).abs() < 1e-6;
        match is(0.5 * e) {
            true => dark += 1,
            false => emitting += usize::from(is(1.0 + 0.5 * e)),
        }
    }
    assert_eq!(dark + emitting, b.seen().count());
    assert!(dark > 100 && emitting > 100, "{dark} pixels of walls, {emitting} of the ceiling");
}

/// Colours of the pixels of a PNG.
fn png_colours(path: &Path) -> std::collections::BTreeSet<[u8; 3]> {
    let file = BufReader::new(File::open(path).expect("it was written"));
    let mut reader = png::Decoder::new(file).read_info().expect("it is a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("it fits")];
    reader.next_frame(&mut bytes).expect("a picture");
    bytes.as_chunks().0.iter().copied().collect()
}

/// The square without light of its own, below a lamp that is a million times as bright.
fn below_a_lamp() -> String {
    let lamp = "
        [materials.lamp]
        reflectance = 0
        emission = 1e6
        [[surfaces]]
        material = \"lamp\"
        two_sided = true
        quad = { vertices = [[-0.2,-0.2,0.1],[0.1,-0.2,0.1],[0.1,0.1,0.1],[-0.2,0.1,0.1]] }
    ";
    SQUARE.replace("emission = 1", "emission = 0") + lamp
}

#[test]
fn pixels_know_whether_they_see_an_emitter_or_one_surface() {
    let scene = typed(&below_a_lamp());
    let visibility = Visibility::open(&scene);
    let camera = scene.camera.clone().expect("there is one");
    let seen_surfaces =
        SeenSurfaces::through(&camera, &PixelGrid::new(3), &scene, &visibility, Ranks::alone());
    // The lamp is seen from x = (½ − 0.2/0.9) 48 = 13.33 to (½ + 0.1/0.9) 48 = 29.33, and as high as broad.
    let lamp = 17 * 17;
    assert_eq!(seen_surfaces.emitters().iter().filter(|emitter| **emitter).count(), lamp);
    assert_eq!(seen_surfaces.parts().iter().filter(|part| **part == Some(0)).count(), 48 * 48 - lamp);
    assert_eq!(seen_surfaces.parts().iter().filter(|part| part.is_none()).count(), lamp);
}

#[test]
fn emitters_do_not_take_the_colours() {
    let folder = folder(&[("s.toml", below_a_lamp())]);
    done(folder.path(), &["render", "s.toml", "--false-colour", "--samples", "1", "-o", "all.png"]);
    assert!(png_colours(&folder.path().join("all.png")).len() > 100, "the square has many colours");
}

/// A square before a camera that sees it and nothing else, of 48 × 48 pixels.
const SQUARE: &str = "
    bands = [\"grey\"]
    [camera]
    eye = [0, 0, 1]
    target = [0, 0, 0]
    up = [0, 1, 0]
    fov = 53.13010235415598
    width = 48
    height = 48
    [materials.grey]
    reflectance = 0.5
    emission = 1
    [[surfaces]]
    material = \"grey\"
    quad = { vertices = [[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]] }
";

#[test]
fn borders_cover_a_pixel_along_their_length() {
    let scene = typed(SQUARE);
    let visibility = Visibility::open(&scene);
    let camera = scene.camera.clone().expect("there is one");
    // The picture shows [−½, ½]²; of 4 × 4 elements the borders at 0 cross it, those at ±½ lie on its rim.
    for (cuts, length) in [(1, 0.0), (2, 96.0), (3, 192.0)] {
        let elements = elements_of(&scene, 0, cuts);
        for samples in [1, 3, 4] {
            let coverage = wireframe(&elements, &visibility, &camera, samples, Ranks::alone());
            let sum: f64 = coverage.iter().sum();
            // Crossings are counted once.
            assert!((sum - length).abs() <= 0.04 * length, "{cuts} cuts, {samples} samples: {sum}");
            assert!(coverage.iter().all(|part| (0.0..=1.0).contains(part)));
        }
    }
}

#[track_caller]
fn refused(args: &[&str], parts: &[&str]) {
    let folder = folder(&[("text.exr", "no picture")]);
    program::refused(folder.path(), args, parts);
}

#[test]
fn kinds_of_pictures_are_told_by_their_endings() {
    refused(&["render", "-o", "box.jpg"], &["box.jpg: the ending names no kind of picture", ".png", ".exr"]);
    refused(&["render", "-o", "box"], &["box: the ending names no kind of picture"]);
    refused(&["render", "-o", "box.exr", "--wireframe"], &["an .exr holds the values", ".png"]);
    refused(
        &["heat", "oven", "--picture", "x.pdf"],
        &["x.pdf: the ending names no format", "help: end the name in .png\n"],
    );
    refused(&["convergence", "-o", "box.pdf"], &["box.pdf: the ending names no kind of drawing", ".svg"]);
}

#[test]
fn pages_refuse_what_they_do_not_show() {
    for option in [["--wireframe"].as_slice(), &["--difference", "a.exr"], &["--false-colour", "--isolines"]]
    {
        let name = option.last().expect("an option");
        let name = if name.starts_with("--") { name } else { option[0] };
        let parts = [format!("box.html: a page to walk through has no {name}"), format!("leave out {name}")];
        refused(&[&["render", "-o", "box.html"], option].concat(), &parts.each_ref().map(String::as_str));
    }
    refused(&["render", "-o", "box.html", "--importance"], &["shows light", "leave out --importance"]);
    refused(&["render", "-o", "box.html", "--log"], &["add --false-colour"]);
    refused(&["render", "-o", "box.html", "--false-colour", "--band", "uv"], &["no band \"uv\""]);
}

/// Text of a script element of a page.
fn script<'a>(page: &'a str, id: &str) -> &'a str {
    let (_, rest) = page.split_once(&format!("id=\"{id}\">")).expect("the element is there");
    rest.split_once("</script>").expect("it ends").0
}

/// Everywhere in the furnace 2 arrives: the halves that the page holds, each the difference from the one
/// before it, say so.
#[test]
fn a_page_holds_the_light_of_its_scene() {
    let folder = tempfile::tempdir().unwrap();
    done(
        folder.path(),
        &["render", "furnace-cube", "--size", "16x12", "--show", "irradiance", "-o", "a.html"],
    );
    let page = fs::read_to_string(folder.path().join("a.html")).unwrap();
    assert!(!page.contains("http:") && !page.contains("https:") && !page.contains("{{"));
    let header: serde_json::Value = serde_json::from_str(script(&page, "header")).unwrap();
    assert_eq!(header["quantity"], "irradiance");
    assert_eq!(header["camera"]["width"], 16);
    let light = STANDARD.decode(script(&page, "light")).unwrap();
    let mut bytes = Vec::new();
    DeflateDecoder::new(&light[..]).read_to_end(&mut bytes).unwrap();
    let (low, high) = bytes.split_at(bytes.len() / 2);
    let scale = header["scale"].as_f64().unwrap();
    let mut texels = low.iter().zip(high).map(|(low, high)| u16::from_le_bytes([*low, *high]));
    for surface in header["surfaces"].as_array().unwrap() {
        let [columns, rows] = [0, 1].map(|axis| surface["texels"][axis].as_u64().unwrap());
        let mut above = 0_u16;
        for _ in 0..rows {
            let mut own = above;
            for column in 0..columns {
                own = own.wrapping_add(texels.next().unwrap());
                above = if column == 0 { own } else { above };
                let value = f64::from(half::f16::from_bits(own)) * scale;
                assert!((value - 2.0).abs() < 0.01, "{value}");
            }
        }
    }
    assert_eq!(texels.next(), None);
}

#[test]
fn styles_that_cannot_be_are_refused() {
    refused(&["render", "--false-colour", "--band", "uv"], &["no band \"uv\"", "R_620nm, G_540nm, B_460nm"]);
    for option in [["--range", "0,1"].as_slice(), &["--band", "grey"], &["--log"], &["--isolines=1,2"]] {
        let parts = ["--range, --band, --log, --isolines speak of false colours", "add --false-colour"];
        refused(&[&["render"], option].concat(), &parts);
    }
    refused(&["render", "--difference", "text.exr", "--log"], &["--log, --isolines speak of false colours"]);
    refused(
        &["render", "--false-colour", "--log", "--range", "0,9"],
        &["no logarithm of 0", "lower end above 0"],
    );
    refused(&["render", "--false-colour", "--isolines", "cornell-box"], &["goes before --isolines"]);
    refused(&["render", "--show", "light"], &["radiosity", "irradiance"]);
    refused(&["render", "--false-colour", "--range", "2,1"], &["two numbers that ascend"]);
    refused(&["render", "--difference", "none.exr"], &["none.exr: ", "radiosity render -o FILE.exr"]);
    refused(&["render", "--difference", "text.exr"], &["text.exr: it is no OpenEXR picture"]);
    refused(&["render", "--order", "auto", "--accuracy", "2"], &["above 0 and below 1"]);
    refused(&["convergence", "--accuracy", "0.1"], &["chooses none", "--max-order"]);
    refused(&["convergence", "--max-order", "21"], &["from 0 to 20"]);
}

#[test]
fn pictures_of_other_sizes_are_not_compared() {
    let folder = tempfile::tempdir().unwrap();
    done(folder.path(), &["render", "furnace-cube", "--size", "8x6", "-o", "a.exr"]);
    let output = radiosity(folder.path(), &["render", "furnace-cube", "--difference", "a.exr"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("help: add --size 8x6"));
}
