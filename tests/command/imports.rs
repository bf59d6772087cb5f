//! Imports of scenes of other programs: upward axes, units, what is near to what, what needs repairs.

use std::fs;

use radiosity::geom::DVec3;
use radiosity_test_support::folders::folder;
use serde_json::Value;

use crate::formats::{cube, each, gltf};
use crate::program::{done, radiosity, refused};

/// The cube as an OBJ with one of its faces painted, each corner where `place` puts it.
fn painted(place: fn(DVec3) -> DVec3) -> String {
    let faces: Vec<[DVec3; 4]> =
        cube().into_iter().map(|face| face.map(|x| place(x * DVec3::new(0.7, 1.3, 2.9)))).collect();
    each(&faces, |k, [a, b, c, d]| {
        let paint = if k == 2 { "red" } else { "white" };
        format!("v {a}\nv {b}\nv {c}\nv {d}\no face-{k}\nusemtl {paint}\nf -4 -3 -2 -1\n")
    })
}

#[test]
fn what_points_upwards_is_said_or_known_of_the_format() {
    let [text, other] = [painted(|x| x), painted(|x| DVec3::new(x.x, x.z, -x.y))];
    let folder = folder(&[
        ("z.obj", text.as_bytes()),
        ("y.obj", other.as_bytes()),
        ("cube.gltf", gltf().0.as_bytes()),
        ("cube.bin", &gltf().1),
    ]);
    let here = folder.path();
    let converted = |args: &[&str]| {
        let [_, told] = done(here, &[&["convert", args[0], "out.json"], &args[1..]].concat());
        (fs::read_to_string(here.join("out.json")).expect("it is written"), told)
    };
    assert_eq!(converted(&["y.obj", "--up", "y"]).0, converted(&["z.obj"]).0);
    assert_eq!(converted(&["y.obj"]).0, converted(&["y.obj", "--up", "z"]).0);
    // The specification of glTF (section 3.4): y points upwards.
    let (turned, told) = converted(&["cube.gltf"]);
    assert!(told.contains("cube.gltf: y points upwards in glTF: the scene was turned"), "{told}");
    let (asked, told) = converted(&["cube.gltf", "--up", "y"]);
    assert!(asked == turned && !told.contains("upwards"), "{told}");
    let (kept, told) = converted(&["cube.gltf", "--up", "z"]);
    assert!(kept != turned && !told.contains("upwards"), "{told}");
    // Of the unit cube 0 ≤ z ≤ 1 becomes −1 ≤ y ≤ 0.
    let reach = |text: &str| {
        let scene: Value = serde_json::from_str(text).expect("JSON");
        let corners = scene["surfaces"]
            .as_array()
            .expect("a list")
            .iter()
            .flat_map(|own| own["quad"]["vertices"].as_array().expect("corners").clone());
        let heights: Vec<f64> = corners.map(|x| x[1].as_f64().expect("a number")).collect();
        [heights.iter().copied().fold(0.0, f64::min), heights.iter().copied().fold(0.0, f64::max)]
    };
    assert_eq!((reach(&turned), reach(&kept)), ([-1.0, 0.0], [0.0, 1.0]));
    refused(here, &["check", "cube.gltf", "--up", "x"], &["y or z"]);
    refused(here, &["check", "cornell-box", "--up", "y"], &["--up", "cornell-box"]);
}

#[test]
fn millimetres_become_the_decimals_that_they_mean() {
    let folder = folder(&[("mm.obj", b"v 0 0 0\nv 9 0 0\nv 9 13 0\nv 0 13 0\nf 1 2 3 4\n")]);
    done(folder.path(), &["convert", "mm.obj", "mm.toml", "--unit", "mm"]);
    let text = fs::read_to_string(folder.path().join("mm.toml")).expect("it is written");
    assert!(text.contains("[[0, 0, 0], [0.009, 0, 0], [0.009, 0.013, 0], [0, 0.013, 0]]"), "{text}");
}

#[test]
fn thin_panels_beside_a_large_ground_stay_apart() {
    let sheet = |name: &str, z: f64, size: f64| {
        let corners = [[-size, -size], [size, -size], [size, size], [-size, size]];
        let vertices = corners.map(|[x, y]| format!("v {x} {y} {z}\n")).concat();
        format!("o {name}\n{vertices}f -4 -3 -2\nf -4 -2 -1\n")
    };
    let text = [sheet("a", 0.0, 1.0), sheet("b", 5e-4, 1.0), sheet("ground", -1.0, 300.0)].concat();
    let folder = folder(&[("site.obj", text.as_bytes())]);
    let [_, told] = done(folder.path(), &["convert", "site.obj", "site.json"]);
    assert!(
        told.contains("6 coplanar triangles were merged to 3 polygons") && !told.contains("coincide"),
        "{told}"
    );
}

#[test]
fn what_is_left_as_it_is_needs_no_repair_under_strict() {
    let fold = "o s\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nf 1 2 3 4\nf 1 2 6 5\n";
    let folder = folder(&[("fold.obj", fold.as_bytes())]);
    let [_, told] = done(folder.path(), &["convert", "fold.obj", "fold.toml", "--strict", "--fix-fronts"]);
    assert!(told.contains("of equal areas; it was left so"), "{told}");
    let strict = radiosity(folder.path(), &["check", "fold.obj", "--strict"]);
    assert_eq!(strict.status.code(), Some(1));
}

/// Two plates that face each other, one of which shines; the other is glossy.
const GLOSSY: &str = r#"<scene version="3.0.0">
  <sensor type="perspective">
    <float name="fov" value="45"/>
    <transform name="to_world"><lookat origin="0, 1, 3" target="0, 1, 0" up="0, 1, 0"/></transform>
  </sensor>
  <bsdf type="roughplastic" id="plastic"><rgb name="diffuse_reflectance" value="0.2, 0.3, 0.7"/></bsdf>
  <shape type="rectangle"><transform name="to_world"><rotate x="1" angle="-90"/></transform><ref id="plastic"/></shape>
  <shape type="rectangle"><transform name="to_world"><rotate x="1" angle="90"/><translate y="2"/></transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="0.5"/></bsdf>
    <emitter type="area"><rgb name="radiance" value="12"/></emitter></shape>
</scene>
"#;

#[test]
fn what_is_left_out_does_not_end_in_nothing_looks_wrong() {
    let plain = GLOSSY.replace("roughplastic", "diffuse").replace("diffuse_reflectance", "reflectance");
    let folder = folder(&[("glossy.xml", GLOSSY), ("plain.xml", &plain)]);
    let [found, _] = done(folder.path(), &["check", "glossy.xml"]);
    assert!(found.contains("specular reflection is left out"), "{found}");
    assert!(
        found.ends_with(
            "nothing else looks wrong: what the import left out, turned or repaired is told above\n"
        ),
        "{found}"
    );
    let [found, _] = done(folder.path(), &["check", "plain.xml"]);
    assert!(found.ends_with("nothing looks wrong\n"), "{found}");
}
