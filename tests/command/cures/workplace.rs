//! The folder in which commands of the tables run: right files, and files with one fault each.

use std::path::Path;

use radiosity_test_support::folders::folder;
use tempfile::TempDir;

use super::{CUBE, ROOM};
use crate::program;

/// Two plates, the upper of which shines and falls.
const MOVES: &str = r#"title = "two plates"
bands = ["grey"]
frames = 2
[camera]
eye = [0.5, -2, 0.5]
target = [0.5, 0.5, 0.2]
[materials.white]
reflectance = 0.5
[materials.lamp]
reflectance = 0
emission = 1
[[surfaces]]
name = "floor"
material = "white"
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
[[surfaces]]
name = "plate"
material = "lamp"
quad = { vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]] }
[[motion]]
name = "fall"
surfaces = ["plate"]
translate = { points = [[0, 0, 0], [0, 0, -0.1]] }
"#;

/// The walls of [`CUBE`], and two of them by themselves, between which light is soon gone.
const BOX: &str = r#"name = "room"
material = "white"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
"#;
const PLATES: &str = r#"name = "room-bottom"
material = "white"
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
[[surfaces]]
name = "room-top"
material = "white"
quad = { vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]] }
"#;

const BALL: &str = r#"[[surfaces]]
name = "ball"
material = "white"
sphere = { center = [0.5, 0.5, 0.5], radius = 0.1 }
"#;

const SHEET: &str = r#"[[surfaces]]
name = "sheet"
material = "white"
[surfaces.extrusion]
curve = [[3, 0, 0], [3, 0.3, 0.2], [3, 0.6, 0.2], [3, 1, 0]]
direction = [1, 0, 0]
"#;

/// Where the plate falls to.
const OTHER: &str = r#"[[surfaces]]
name = "other"
material = "lamp"
quad = { vertices = [[0, 0, 0.9], [0, 1, 0.9], [1, 1, 0.9], [1, 0, 0.9]] }
"#;

const BEHIND: &str = r#"[[surfaces]]
name = "behind"
material = "white"
quad = { vertices = [[0, 0, 3], [1, 0, 3], [1, 1, 3], [0, 1, 3]] }
"#;

const POINT: &str = r#"[[luminaires]]
name = "spot"
position = [0.5, 0.5, 0.5]
point = {}
flux = 1
"#;

const HUNG: &str = r#"[[luminaires]]
name = "spot"
position = [0.5, 0.5, 0.5]
photometry = "point.ies"
extent = "file"
"#;

const MASK: &str = r#"[[masks]]
emitter = "plate"
receiver = "floor"
"#;

/// A narrow beam down to a floor.
const BEAM: &str = r#"[[luminaires]]
name = "beam"
position = [0.5, 0.5, 0.9]
aim = [0.05, 0.02, -1]
spot = { angle = 20, edge = 1 }
flux = 1
"#;

/// A lamp near a floor, and its back.
const TORCH: &str = r#"[materials.lamp]
reflectance = 0
emission = 1
[[surfaces]]
name = "torch"
material = "lamp"
quad = { vertices = [[0.5, 0.5, 0.02], [0.5, 0.6, 0.02], [0.6, 0.6, 0.02], [0.6, 0.5, 0.02]] }
[[surfaces]]
name = "hood"
material = "lamp"
quad = { vertices = [[0.5, 0.5, 0.0201], [0.6, 0.5, 0.0201], [0.6, 0.6, 0.0201], [0.5, 0.6, 0.0201]] }
"#;

/// A lamp over a shelf in a room that reflects nearly all light, every pair of which has a mask of one cell.
const SHELF: &str = r#"bands = ["grey"]
[camera]
eye = [1.9, 1.9, 0.5]
target = [0, 0, 1]
[materials.white]
reflectance = 0.9999
[materials.lamp]
reflectance = 0
emission = 100
[[surfaces]]
name = "room"
material = "white"
box = { origin = [-2, -2, 0], size = [4, 4, 3], inward = true }
[[surfaces]]
name = "shelf"
material = "white"
two_sided = true
quad = { vertices = [[-0.5, -0.5, 1], [0.5, -0.5, 1], [0.5, 0.5, 1], [-0.5, 0.5, 1]] }
[[surfaces]]
name = "lamp"
material = "lamp"
quad = { vertices = [[-0.3, -0.3, 2], [-0.3, 0.3, 2], [0.3, 0.3, 2], [0.3, -0.3, 2]] }
[[masks]]
emitter = "*"
receiver = "*"
cells = 1
"#;

/// Two plates that face each other in part, over a narrow gap.
const GAP: &str = r#"bands = ["grey"]
[materials.a]
reflectance = 0.9
emissivity = 0.1
[[surfaces]]
name = "hot"
material = "a"
temperature = 900
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
[[surfaces]]
name = "lid"
material = "a"
temperature = 300
quad = { vertices = [[0.9, 0, 0.02], [0.9, 1, 0.02], [2, 1, 0.02], [2, 0, 0.02]] }
"#;

const OVEN: &str = r#"bands = ["grey"]
[materials.a]
reflectance = 0.5
[[surfaces]]
name = "oven"
material = "a"
temperature = 300
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
"#;

const COOL: &str = r#"bands = ["grey"]
[materials.a]
reflectance = 0.5
[[surfaces]]
name = "floor"
material = "a"
temperature = 300
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
[[surfaces]]
name = "lid"
material = "a"
heat_flux = -9
quad = { vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]] }
"#;

/// A floor whose paint stands outside its folder.
const FLOOR: &str = r#"include = ["../paint.toml"]
[[surfaces]]
name = "floor"
material = "white"
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
"#;

const EVEN: &str = r#"{"materials": {"a": {"reflectance": 0.5, "emission": 1}}, "surfaces": [{"name": "s", "material": "a",
"quad": {"vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]]}}]}"#;

const IES: &str =
    "IESNA:LM-63-2002\nTILT=NONE\n1 2000 1.0\n3 1\n1 1\n0 0 0\n1.0 1.0 20\n0 45 90\n0\n500 300 0\n";

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n\
                   property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

const MGF: &str = "v a =\nv b =\n p 1 0 0\nv c =\n p 0 1 0\nf a b c\n";

/// A command that writes a solution, and fails as its solver did not converge.
const UNFINISHED: &str = "solve room.toml -o part.json --solver jacobi --max-iterations 1 --keep-partial";

/// Commands that make the files in which solutions, pictures and records are.
const MADE: &[&str] = &[
    "solve room.toml -o lit.json",
    "render room.toml -o lit.exr --size 8x8",
    "render blank.toml -o blank.exr --size 8x8",
    "solve groups.toml -o groups.json",
    "solve vars.toml -o vars.json",
    "solve flat.toml -o flat.json",
    "solve flat.toml -o tensor.json --tensor --order 12",
    "solve flat.toml -o mask.json --shadows mask --order 2",
    "render room.toml -o p.png --size 8x8 --order 2 --checkpoint used",
];

/// `text` with `old`, which it must contain, replaced by `new`.
fn with(text: &str, old: &str, new: &str) -> String {
    assert!(text.contains(old), "{old:?} is not in\n{text}");
    text.replace(old, new)
}

/// The lines of `text` but those of the table `header`, which end with the next one.
fn without_table(text: &str, header: &str) -> String {
    let (before, rest) = text.split_once(header).expect("the table");
    let (_, after) = rest.split_once("\n[").expect("another table");
    format!("{before}[{after}")
}

/// Scenes of radiosity.
fn scenes() -> Vec<(&'static str, String)> {
    let blank = with(CUBE, BOX, PLATES);
    let plates = &with(&blank, "[1, 1, 0.5]", "[1, 1, 0.1]");
    let warm = with(CUBE, "emission = 1", "temperature = 300");
    let (still, _) = MOVES.split_once("[[motion]]").expect("a motion");
    let flat = with(still, "frames = 2\n", "");
    let masked = format!("{flat}{MASK}");
    let two_bands = with(&flat, "bands = [\"grey\"]", "bands = [\"a\", \"b\"]");
    let coloured = with(OVEN, "bands = [\"grey\"]", "bands = [\"grey\", \"red\"]");
    let coloured = with(&coloured, "reflectance = 0.5", "reflectance = [0.5, 0.2]");
    let dim = with(CUBE, "emission = 1\n", "");
    let beam = format!("{dim}{BEAM}");
    let lid = "[[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]]";
    vec![
        ("room.toml", plates.clone()),
        ("blank.toml", blank.clone()),
        ("cube.toml", CUBE.to_owned()),
        ("mirror.toml", with(CUBE, "reflectance = 0.5", "reflectance = 0.99999")),
        ("endless.toml", with(CUBE, "reflectance = 0.5", "reflectance = 0.999999")),
        ("coarse.toml", with(plates, "quad =", "order = 0\nquad =")),
        ("distant.toml", with(plates, lid, &lid.replace(" 1]", " 30]"))),
        ("beam.toml", beam.clone()),
        ("beam-cut.toml", with(&beam, "box =", "subdivide = [4, 4]\nbox =")),
        ("torch.toml", format!("{dim}{TORCH}")),
        ("unsettled.toml", SHELF.to_owned()),
        ("finer.toml", with(SHELF, "cells = 1", "cells = 3")),
        ("settled.toml", with(SHELF, "emitter = \"*\"", "emitter = \"lamp\"")),
        ("gap.toml", GAP.to_owned()),
        ("hung.toml", ROOM.to_owned()),
        ("moves.toml", MOVES.to_owned()),
        ("spun.toml", with(MOVES, "translate = {", "scale = 2\ntranslate = {")),
        ("away.toml", with(MOVES, "[0, 0, -0.1]", "[1e12, 0, 0]")),
        ("onto.toml", with(MOVES, "[[motion]]", &format!("{OTHER}[[motion]]"))),
        ("blind.toml", without_table(plates, "[camera]")),
        (
            "turned.toml",
            with(&with(plates, "[0.2, 0.2, 0.5]\ntarget", "[9, 9, 9]\ntarget"), "[1, 1, 0.1]", "[19, 19, 9]"),
        ),
        ("bare.toml", with(plates, "material = \"white\"\n", "")),
        ("dark.toml", with(plates, "emission = 1", "emission = 0")),
        ("planeless.toml", without_table(plates, "[planes.desk]")),
        ("round.toml", format!("{CUBE}{BALL}")),
        ("vary.toml", with(&flat, "reflectance = 0.5", "reflectance = { cells = [[0.2, 0.8]] }")),
        ("groups.toml", with(plates, "emission = 1", "emission = 1\ngroup = \"sun\"")),
        (
            "vars.toml",
            with(
                plates,
                "[materials.white]\nreflectance = 0.5",
                "[variables]\nwidth = 0.5\n[materials.white]\nreflectance = \"=width\"",
            ),
        ),
        ("apart.toml", format!("{flat}{BEHIND}{}", with(MASK, "\"floor\"", "\"behind\""))),
        ("lampmask.toml", masked),
        ("sourced.toml", format!("{flat}{POINT}")),
        ("bezier.toml", format!("{flat}{SHEET}")),
        ("bands.toml", two_bands),
        ("backs.toml", with(&flat, "[0, 1, 1], [1, 1, 1], [1, 0, 1]", "[1, 0, 1], [1, 1, 1], [0, 1, 1]")),
        (
            "idle.toml",
            format!(
                "{}{}",
                with(&flat, "reflectance = 0.5", "reflectance = 0"),
                with(MASK, "\"plate\"\nreceiver = \"floor\"", "\"floor\"\nreceiver = \"plate\"")
            ),
        ),
        ("dull.toml", with(plates, "reflectance = 0.5", "reflectance = 0.4")),
        ("flat.toml", flat),
        ("pointed.toml", format!("{CUBE}{HUNG}")),
        ("oval.toml", format!("{CUBE}{}", with(HUNG, "point.ies", "oval.ies"))),
        ("boxed.toml", format!("{CUBE}{}", with(HUNG, "\"file\"", "[0.2, 0.1]"))),
        ("pict.toml", with(plates, "reflectance = 0.5", "reflectance = { image = \"wood.png\" }")),
        (
            "glow.toml",
            with(
                &with(&warm, "reflectance = 0.5", "reflectance = 0.5\ntransmittance = 0.1"),
                "name = \"room\"\n",
                "name = \"room\"\ntwo_sided = true\n",
            ),
        ),
        ("warm.toml", warm),
        ("oven.toml", OVEN.to_owned()),
        ("level.toml", with(OVEN, "temperature = 300", "heat_flux = 3")),
        ("grey.toml", with(&coloured, "reflectance =", "emissivity = 0.5\nreflectance =")),
        ("black.toml", coloured),
        ("cool.toml", COOL.to_owned()),
        ("cold.toml", with(COOL, "-9", "-9000")),
        ("shared.toml", with(COOL, "name = \"lid\"", "name = \"a\"")),
        ("empty.toml", "bands = [\"grey\"]\n".to_owned()),
        ("grey-part.toml", "bands = [\"grey\"]\n".to_owned()),
        ("red.toml", "bands = [\"red\"]\n".to_owned()),
        ("circle.toml", "include = [\"circle.toml\"]\n".to_owned()),
        ("both.toml", format!("include = [\"red.toml\"]\n{plates}")),
        ("alike.toml", format!("include = [\"grey-part.toml\"]\n{plates}")),
        ("broken.toml", "bands = 3\n".to_owned()),
        ("far/outside.toml", "include = [\"../room.toml\"]\n".to_owned()),
        ("far/inner.toml", "include = [\"../broken.toml\"]\n".to_owned()),
        ("paint.toml", "[materials.white]\nreflectance = 0.5\nemission = 1\n".to_owned()),
        ("far/known.toml", FLOOR.to_owned()),
        ("far/unknown.toml", with(FLOOR, "\"white\"", "\"whit\"")),
        ("even.json", EVEN.to_owned()),
        ("odd.json", "{\"surfaces\": [{]}".to_owned()),
        ("twice.json", "{\"title\": \"a\", \"title\": \"b\"}".to_owned()),
        ("lists.csv", "floor,0,0,0\nfloor,1,0,0\nfloor,0,1,0\n".to_owned()),
        ("list.csv", "floor,0,0\n".to_owned()),
    ]
}

/// Files of other programs.
fn foreign() -> Vec<(&'static str, String)> {
    let deep = format!("o {}\n", "a".repeat(90)).repeat(60);
    vec![
        ("scene.dxf", "0\n".to_owned()),
        ("scene.obj", TRIANGLE.to_owned()),
        ("lie.ply", TRIANGLE.to_owned()),
        ("lie.txt", TRIANGLE.to_owned()),
        ("gap.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 4\n".to_owned()),
        ("scene.ply", PLY.to_owned()),
        ("m.toml", "[materials.\"*\"]\nreflectance = 0.5\nemission = 1\n".to_owned()),
        ("scene.xml", "<scene version=\"3.0.0\"><shape type=\"disk\"/></scene>\n".to_owned()),
        ("page.xml", "<html/>\n".to_owned()),
        ("shallow.mgf", format!("o a\n{MGF}o\n")),
        ("deep.mgf", format!("{deep}{MGF}")),
        ("point.ies", IES.to_owned()),
        ("oval.ies", with(IES, "\n0 0 0\n", "\n-0.5 -0.2 0\n")),
    ]
}

/// A point in the middle of a unit cube, which is also what standard input holds.
const POINT_ROW: &str = "0.5,0.5,0.5,0,0,1\n";

/// Points, and what is none.
fn points() -> Vec<(&'static str, String)> {
    let header = |names: &str| format!("{names}\n0,0,0,0,0,0,1\n");
    vec![
        ("points.csv", POINT_ROW.to_owned()),
        ("middle.csv", "0.5,0.5,15,1,0,0\n".to_owned()),
        ("far.csv", "0.5,0.5,0.5,0,0,1\n9,0,0,0,0,1\n".to_owned()),
        ("semi.csv", "0.5;0.5;0.5;0;0;1\n".to_owned()),
        ("few.csv", "0.5,0.5,0.5\n".to_owned()),
        ("two.csv", header("x,x,y,z,nx,ny,nz")),
        ("head.csv", header("x,y,z,nx,ny,w,v")),
        ("nothing.csv", "# nothing\n".to_owned()),
        ("right.csv", "0.5,0.5,0,0,0,1\n".to_owned()),
        ("norm.csv", "0.5,0.5,0,1,0,0\n".to_owned()),
    ]
}

/// The folder with all that commands of the tables name.
pub(super) fn files() -> TempDir {
    let texts: Vec<_> = [scenes(), foreign(), points()].concat();
    let folder = folder(&texts);
    let nested = (0..40).map(|k| (format!("n{k}.mgf"), format!("i n{}.mgf\n", k + 1).into_bytes()));
    let bytes = [
        ("latin.csv", &b"x,y,z,nx,ny,nz,\xff\xfe\n"[..]),
        ("wood.png", b"\xff\xd8\xff\xe0\0\x10JFIF\0"),
        ("nopic.exr", b"nothing"),
    ];
    let bytes = bytes.map(|(name, bytes)| (name.to_owned(), bytes.to_vec()));
    for (name, content) in nested.chain(bytes) {
        std::fs::write(folder.path().join(name), content).expect("a file can be written");
    }
    std::fs::create_dir(folder.path().join("sub")).expect("a folder can be made");
    MADE.iter().for_each(|line| drop(program::done(folder.path(), &words(line))));
    assert!(!typed(folder.path(), UNFINISHED).status.success(), "it did not converge");
    folder
}

/// The words of a command, which is typed without quotes.
pub(super) fn words(line: &str) -> Vec<&str> {
    line.split(' ').collect()
}

/// Exit status and output of a command in such a folder.
pub(super) fn typed(folder: &Path, line: &str) -> std::process::Output {
    program::fed(folder, &words(line), POINT_ROW)
}
