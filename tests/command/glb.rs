//! Light baked into binary glTF: a file that our own reader takes, with the surfaces where they were and
//! their light in a texture. `tests/external/glb.py` has the Khronos validator and a viewer read such files.

use std::fs::{self, File};
use std::io::Cursor;
use std::path::Path;

use radiosity::output::files::exr_file::read_exr;
use radiosity::output::files::glb::texture_size;
use radiosity::reading::pictures::lightmap::Lightmap;
use radiosity::reading::pictures::raster::Raster;
use radiosity_test_support::folders::folder;
use radiosity_test_support::scenes::builtin;
use serde_json::Value;

use crate::program::{done, refused};

const ROOM: &str = r#"
bands = ["r", "g", "b"]
materials.white = { reflectance = [0.5, 0.4, 0.3] }
materials.lamp = { reflectance = 0, emission = [10, 9, 8], group = "lamps" }
[[surfaces]]
name = "floor"
material = "white"
polygon = { vertices = [[0,0,0],[4,0,0],[4,3,0],[0,3,0]], holes = [[[1,1,0],[2,1,0],[1.5,2,0]]] }
[[surfaces]]
name = "wall"
material = "white"
polygon = { vertices = [[0,3,0],[4,3,0],[4,3,2],[2,3,3],[0,3,2]] }
[[surfaces]]
name = "ball"
material = "white"
sphere = { center = [3, 1, 1], radius = 0.5 }
[[surfaces]]
name = "lamp"
material = "lamp"
quad = { vertices = [[1,1,4],[1,2,4],[2,2,4],[2,1,4]] }
"#;

/// The JSON and the binary of a GLB, whose lengths are checked.
fn chunks(path: &Path) -> (Value, Vec<u8>) {
    let bytes = fs::read(path).expect("it was written");
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
    assert_eq!((&bytes[..4], number(4), number(8)), (&b"glTF"[..], 2, bytes.len()));
    let length = number(12);
    assert_eq!((&bytes[16..20], length % 4), (&b"JSON"[..], 0));
    let start = 20 + length;
    assert_eq!((&bytes[start + 4..start + 8], number(start)), (&b"BIN\0"[..], bytes.len() - start - 8));
    (serde_json::from_slice(&bytes[20..start]).expect("JSON"), bytes[start + 8..].to_vec())
}

/// The numbers of an accessor, four bytes each.
fn numbers<T>(tree: &Value, binary: &[u8], accessor: &Value, number: fn([u8; 4]) -> T) -> Vec<T> {
    let accessor = &tree["accessors"][accessor.as_u64().expect("an index") as usize];
    let view = &tree["bufferViews"][accessor["bufferView"].as_u64().expect("an index") as usize];
    let count = |value: &Value| value.as_u64().expect("a count") as usize;
    let width = match accessor["type"].as_str() {
        Some("VEC3") => 3,
        Some("VEC2") => 2,
        _ => 1,
    };
    let length = 4 * width * count(&accessor["count"]);
    let offset = count(&accessor["byteOffset"]);
    assert!(offset + length <= count(&view["byteLength"]), "the accessor lies in its view");
    let start = count(&view["byteOffset"]) + offset;
    binary[start..start + length].chunks_exact(4).map(|x| number(x.try_into().expect("four bytes"))).collect()
}

fn linear(path: &Path) -> Raster {
    let bands = ["r", "g", "b"].map(str::to_owned);
    read_exr(File::open(path).expect("it was written"), &bands).expect("our own picture")
}

#[test]
fn our_own_reader_finds_the_surfaces_where_they_were() {
    let folder = folder(&[("room.toml", ROOM)]);
    let path = folder.path();
    done(path, &["render", "room.toml", "-q", "--read", "basis", "--size", "64x64", "-o", "room.glb"]);
    // +z is up in the scene, +y in glTF, which the reader turns back.
    let scene = radiosity::load(path.join("room.glb").to_str().expect("text")).expect("it is glTF");
    let flat = |axis: usize, place: f64| -> f64 {
        let on_it = scene.surfaces.iter().filter(|surface| {
            let jet = surface.shape.jet(0.0, 0.0);
            jet.normal[axis].abs() > 1.0 - 1e-9 && (jet.position[axis] - place).abs() < 1e-6
        });
        on_it.map(|surface| surface.shape.area()).sum()
    };
    for (name, area, expected) in
        [("floor", flat(2, 0.0), 11.5), ("wall", flat(1, 3.0), 10.0), ("lamp", flat(2, 4.0), 1.0)]
    {
        assert!((area - expected).abs() < 1e-5, "{name}: {area}");
    }
    let whole: f64 = scene.surfaces.iter().map(|surface| surface.shape.area()).sum();
    let ball = std::f64::consts::PI;
    assert!((whole - 22.5 - ball).abs() < 2e-2 * ball, "{whole}");
}

#[test]
fn meshes_have_places_in_the_texture_and_the_texture_has_the_light() {
    let folder = folder(&[("room.toml", ROOM)]);
    let path = folder.path();
    let [_, told] = done(
        path,
        &["render", "room.toml", "--read", "basis", "--size", "64x64", "--exposure", "0.1", "-o", "room.glb"],
    );
    assert!(told.contains("room.glb") && told.contains("room.exr"), "{told}");
    let (tree, binary) = chunks(&path.join("room.glb"));
    let names: Vec<&str> =
        tree["meshes"].as_array().unwrap().iter().map(|m| m["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["floor", "wall", "ball", "lamp"]);
    let raster = linear(&path.join("room.exr"));
    let [width, height] = raster.size();
    let scene = radiosity::load(path.join("room.toml").to_str().expect("text")).expect("a scene");
    let forecast = texture_size(Lightmap::sizes(&scene, 64 * 64));
    assert_eq!(forecast, [width, height].map(|count| count as usize), "memory is reckoned for these");
    let texels: Vec<&[f64]> = raster.pixels().collect();
    let at = |place: &[f32]| {
        let texel = |x: f32, count: u32| ((x * count as f32) as usize).min(count as usize - 1);
        texels[texel(place[1], height) * width as usize + texel(place[0], width)]
    };
    for mesh in tree["meshes"].as_array().unwrap() {
        let primitive = &mesh["primitives"][0];
        let floats = |name: &str| numbers(&tree, &binary, &primitive["attributes"][name], f32::from_le_bytes);
        let (positions, places) = (floats("POSITION"), floats("TEXCOORD_0"));
        assert_eq!([positions.len() / 3, floats("NORMAL").len() / 3], [places.len() / 2; 2]);
        let indices = numbers(&tree, &binary, &primitive["indices"], u32::from_le_bytes);
        assert!(indices.iter().all(|index| (*index as usize) < places.len() / 2));
        assert!(places.iter().all(|x| (0.0..=1.0).contains(x)));
        for place in places.chunks_exact(2) {
            let light = at(place);
            match mesh["name"].as_str() {
                // A black lamp sends what it emits.
                Some("lamp") => {
                    assert!(light.iter().zip([10.0, 9.0, 8.0]).all(|(a, b)| (a - b).abs() < 1e-4))
                }
                name => assert!(light.iter().all(|x| *x < 5.0), "{name:?}: {light:?}"),
            }
        }
    }
    let image = &tree["bufferViews"][tree["images"][0]["bufferView"].as_u64().unwrap() as usize];
    let start = image["byteOffset"].as_u64().unwrap() as usize;
    let png = &binary[start..start + image["byteLength"].as_u64().unwrap() as usize];
    let info = png::Decoder::new(Cursor::new(png)).read_info().expect("a picture").info().clone();
    assert_eq!([info.width, info.height], [width, height]);
    assert_eq!(tree["scenes"][0]["extras"]["exposure"], 0.1);
    assert_eq!(tree["scenes"][0]["extras"]["linear"], "room.exr");
}

/// Of a room whose lamp is a fifth of its surfaces, seen by its camera or one that is chosen.
#[test]
fn textures_are_exposed_as_the_picture() {
    let lamp = "quad = { vertices = [[0,0,4],[0,3,4],[4,3,4],[4,0,4]] }";
    let room = ROOM.replace("quad = { vertices = [[1,1,4],[1,2,4],[2,2,4],[2,1,4]] }", lamp);
    let camera = "camera = { eye = [2, -4, 2], target = [2, 1.5, 1], width = 64, height = 48 }\n";
    let folder = folder(&[("bare.toml", room.clone()), ("seen.toml", format!("{camera}{room}"))]);
    let path = folder.path();
    for scene in ["bare", "seen"] {
        let [picture, texture, page] = ["png", "glb", "html"].map(|ending| {
            let (scene, name) = (format!("{scene}.toml"), format!("x.{ending}"));
            let render = ["render", &scene, "--read", "basis", "-o", &name, "--report", "x.json"];
            done(path, &render);
            let report: Value = serde_json::from_slice(&fs::read(path.join("x.json")).unwrap()).unwrap();
            report["exposure"]["factor"].as_f64().expect("a number")
        });
        let (tree, _) = chunks(&path.join("x.glb"));
        assert_eq!(tree["scenes"][0]["extras"]["exposure"], texture);
        for other in [texture, page] {
            assert!((other / picture - 1.0).abs() < 0.01, "{scene}: {picture} {texture} {page}");
        }
    }
}

#[test]
fn textures_are_linear_in_the_light_and_even_in_a_furnace() {
    let folder = folder(&[("room.toml", ROOM)]);
    let path = folder.path();
    done(path, &["solve", "room.toml", "-q", "-o", "s.json"]);
    let bake = ["render", "s.json", "-q", "--read", "basis", "--size", "48x48"];
    done(path, &[&bake[..], &["-o", "day.glb"]].concat());
    done(path, &[&bake[..], &["--set", "lamps=0.25", "-o", "dim.glb"]].concat());
    let [day, dim] = ["day.exr", "dim.exr"].map(|name| linear(&path.join(name)));
    let pairs = || day.pixels().flatten().zip(dim.pixels().flatten());
    assert!(pairs().all(|(day, dim)| (0.25 * day - dim).abs() < 1e-5));
    assert!(pairs().any(|(day, _)| *day > 0.1), "there is light");
    let cube = ["render", "furnace-cube", "-q", "--read", "basis", "--size", "48x48", "-o", "even.glb"];
    done(path, &cube);
    let even = File::open(path.join("even.exr")).expect("it was written");
    let band = builtin("furnace-cube").bands;
    let even = read_exr(even, &band).expect("our own picture");
    for (light, coverage) in even.pixels().zip(even.coverage()) {
        // B = E₀/(1 − ρ), with E₀ = 1 and ρ = ½.
        assert!(*coverage == 0.0 || light.iter().all(|x| (x - 2.0).abs() < 1e-2), "{light:?}");
    }
}

#[test]
fn what_is_drawn_on_pictures_has_no_place_in_textures() {
    let folder = folder(&[("room.toml", ROOM)]);
    let path = folder.path();
    let bake = ["render", "room.toml", "-q", "-o", "room.glb"];
    for (more, part) in [
        (&["--false-colour"][..], "--false-colour"),
        (&["--wireframe"], "--wireframe"),
        (&["--importance"], "--importance"),
        (&["--isolines"], "--isolines"),
        (&["--band", "r"], "--band"),
        (&["--range", "0,1"], "--range"),
        (&["--log"], "--log"),
        (&["--samples", "4"], "--samples"),
    ] {
        refused(path, &[&bake[..], more].concat(), &["room.glb", part, ".png"]);
    }
    fs::create_dir(path.join("room.exr")).expect("it can be made");
    refused(path, &bake, &["room.exr: cannot be written"]);
    assert!(!path.join("room.glb").exists(), "nothing is half-written");
}
