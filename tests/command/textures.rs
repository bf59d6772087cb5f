//! Textures and transmission through the command: what `check` and `convert` tell, and what other verbs
//! refuse.

use std::fs;
use std::path::Path;

use radiosity_test_support::folders::{self, png};
use serde_json::Value;

use crate::program::{done, radiosity, refused};

const ROOM: &str = r#"
camera = { eye = [1, -3, 2], target = [1, 1, 0] }
[variables]
odd = 0.1
[materials.lamp]
reflectance = 0
emission = 10
temperature = 400
emissivity = 0.9
[materials.tiles]
reflectance = { cells = [[0.5, "=odd"]] }
temperature = 300
[materials.slope]
reflectance = 0.2
emission = { polynomial = [[0, 0, 1], [1, 0, 0.5]], factor = 2 }
temperature = 300
[[surfaces]]
name = "floor"
material = "tiles"
parallelogram = { origin = [0, 0, 0], edge1 = [2, 0, 0], edge2 = [0, 2, 0] }
[[surfaces]]
name = "wall"
material = "slope"
parallelogram = { origin = [0, 2, 0], edge1 = [2, 0, 0], edge2 = [0, 0, 2] }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [1, 1, 1], normal = [0, 0, -1], radius = 0.2 }
"#;

fn folder(text: &str) -> tempfile::TempDir {
    let wood = png([2, 1], png::ColorType::Rgb, &[200, 100, 50, 10, 20, 30]);
    folders::folder(&[("room.toml", text.as_bytes()), ("wood.png", &wood)])
}

fn with_picture() -> tempfile::TempDir {
    folder(&ROOM.replace("{ cells = [[0.5, \"=odd\"]] }", "{ image = \"wood.png\" }"))
}

#[test]
fn check_lists_what_varies() {
    let room = folder(ROOM);
    let [text, _] = done(room.path(), &["check", "room.toml"]);
    for line in [
        "varies: reflectance of tiles: 2 × 1 cells; mean 0.3, from 0.1 to 0.5",
        "varies: emission of slope: polynomial of degree 1; mean 2, from 1 to 3",
    ] {
        assert!(text.lines().any(|own| own == line), "{line}:\n{text}");
    }
    let [text, _] = done(room.path(), &["check", "room.toml", "--set", "odd=0.3"]);
    assert!(text.contains("mean 0.4, from 0.3 to 0.5"), "{text}");
    let [text, _] = done(room.path(), &["check", "room.toml", "--format", "json"]);
    let told: Value = serde_json::from_str(&text).unwrap();
    let tiles = &told["materials"]["tiles"];
    assert_eq!(tiles["varies"]["reflectance"]["grid"], serde_json::json!([2, 1]));
    assert_eq!(tiles["varies"]["reflectance"]["range"], serde_json::json!([[0.1, 0.5]]));
    let [text, _] = done(with_picture().path(), &["check", "room.toml"]);
    let line = "varies: reflectance of tiles: picture wood.png, 2 × 1 texels;";
    let line = text.lines().find(|own| own.starts_with(line)).unwrap_or_else(|| panic!("{text}"));
    assert!(line.ends_with("(8 bits, sRGB made linear; luminance of its colours)"), "{line}");
}

#[test]
fn a_scene_with_pictures_stays_in_its_folder() {
    let room = with_picture();
    fs::create_dir(room.path().join("other")).unwrap();
    refused(
        room.path(),
        &["convert", "room.toml", "other/room.toml"],
        &["names pictures beside it", "folder of the scene"],
    );
    done(room.path(), &["convert", "room.toml", "room.json"]);
    let of = |name: &str| {
        done(room.path(), &["check", name])[0].lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(of("room.json"), of("room.toml"));
    let [_, told] = done(room.path(), &["convert", "room.toml", "room.mgf"]);
    assert!(told.contains("room.mgf: what varies over surfaces becomes its mean"), "{told}");
}

#[test]
fn standard_input_starts_from_the_current_folder() {
    let room = with_picture();
    let text = fs::read(room.path().join("room.toml")).unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_radiosity"));
    let piped = command.current_dir(room.path()).args(["check", "-"]).stdin(std::process::Stdio::piped());
    let mut child = piped.stdout(std::process::Stdio::piped()).spawn().unwrap();
    std::io::Write::write_all(&mut child.stdin.take().unwrap(), &text).unwrap();
    let output = child.wait_with_output().unwrap();
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success() && told.contains("picture wood.png"), "{told}");
}

#[test]
fn heat_wants_emissivities_of_textures_and_opaque_sheets() {
    let room = folder(ROOM);
    refused(room.path(), &["heat", "room.toml"], &["no emissivity is given for \"floor\"", "emissivity = "]);
    let stated = ROOM.replace("[materials.tiles]", "[materials.tiles]\nemissivity = 0.8");
    done(folder(&stated).path(), &["heat", "room.toml", "-q"]);
    let sheet = stated.replace("[materials.slope]", "[materials.slope]\ntransmittance = 0.1");
    let sheet = sheet.replace("name = \"wall\"", "name = \"wall\"\ntwo_sided = true");
    refused(
        folder(&sheet).path(),
        &["heat", "room.toml"],
        &["heat would pass through \"wall\", the back of \"wall\"", "leave the transmittance"],
    );
}

#[test]
fn links_take_surfaces_for_opaque_and_alike() {
    let solve = ["solve", "room.toml", "--method", "hierarchical", "-q"];
    let cure = "--method galerkin";
    refused(folder(ROOM).path(), &solve, &["surface 'floor' varies over its area", cure]);
    let even = ROOM.replace("{ cells = [[0.5, \"=odd\"]] }", "0.3");
    refused(folder(&even).path(), &solve, &["surface 'wall' varies over its area", cure]);
    let sheet =
        even.replace("{ polynomial = [[0, 0, 1], [1, 0, 0.5]], factor = 2 }", "1\ntransmittance = 0.2");
    let sheet = sheet.replace("name = \"wall\"", "name = \"wall\"\ntwo_sided = true");
    refused(folder(&sheet).path(), &solve, &["surface 'wall' lets light through", cure]);
}

#[test]
fn view_factors_know_no_textures() {
    let factors = |folder: &Path| radiosity(folder, &["view-factors", "room.toml"]).stdout;
    let even = ROOM.replace("{ cells = [[0.5, \"=odd\"]] }", "0.3");
    let (varied, even) = (factors(folder(ROOM).path()), factors(folder(&even).path()));
    assert!(!even.is_empty() && varied == even);
}

/// Tents and cosines reach over what reflects differently.
#[test]
fn bases_over_several_elements_refuse_what_varies() {
    let room = folder(ROOM);
    for basis in ["linear", "harmonic"] {
        let told = ["surface 'floor'", "--basis legendre"];
        refused(room.path(), &["solve", "room.toml", "--basis", basis], &told);
    }
    done(room.path(), &["solve", "room.toml", "--basis", "constant", "-q", "-o", "room.json"]);
}
