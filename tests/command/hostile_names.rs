//! Names that would end a script, a cell of a table or an element, in the outputs of all verbs that write
//! them.

use std::fs;
use std::path::Path;

use radiosity_test_support::folders::folder;
use serde_json::Value;

use crate::program::{done, radiosity};

/// A name; units have 16 characters at the most.
const NAME: &str = "</script><script>alert(1)</script>|`<&>\"'-->{{script}}";
const UNIT: &str = "</script>|`<&>";

/// A solved lamp over a floor whose names all are the above.
fn folder_with_solution() -> tempfile::TempDir {
    // A text of JSON is one of TOML.
    let name = serde_json::to_string(NAME).expect("text");
    let scene = format!(
        "
        title = {name}
        unit = '{UNIT}'
        bands = [{name}]
        camera = {{ eye = [0, -3, 1], target = [0, 0, 0.5], width = 16, height = 12 }}
        [materials.{name}]
        reflectance = 0.5
        [materials.lamp]
        reflectance = 0
        emission = 10
        group = {name}
        [[surfaces]]
        name = {name}
        material = {name}
        quad = {{ vertices = [[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]] }}
        [[surfaces]]
        name = 'lamp'
        material = 'lamp'
        quad = {{ vertices = [[-1,-1,1],[-1,1,1],[1,1,1],[1,-1,1]] }}
        "
    );
    let folder = folder(&[("odd.toml", scene)]);
    written(folder.path(), &["solve", "odd.toml", "--order", "1"], "odd.json");
    folder
}

/// The output `name` of a command.
#[track_caller]
fn written(folder: &Path, args: &[&str], name: &str) -> Vec<u8> {
    done(folder, &[args, &["-q", "-o", name]].concat());
    fs::read(folder.join(name)).expect("it was written")
}

#[track_caller]
fn text(folder: &Path, args: &[&str], name: &str) -> String {
    String::from_utf8(written(folder, args, name)).expect("UTF-8")
}

/// A page with hostile names has as many scripts as one with plain names, and the names in its header.
#[test]
fn scripts_of_a_page_do_not_end_in_a_name() {
    let folder = folder_with_solution();
    let render = |scene| ["render", scene, "--read", "basis", "--size", "16x12"];
    let page = text(folder.path(), &render("odd.json"), "odd.html");
    let plain = text(folder.path(), &render("furnace-cube"), "plain.html");
    for tag in ["<script", "</script", "<!--", "<title>", "</title>"] {
        assert_eq!(page.matches(tag).count(), plain.matches(tag).count(), "{tag}");
    }
    let (_, rest) = page.split_once("id=\"header\">").expect("a header");
    let (header, _) = rest.split_once("</script>").expect("its end");
    let header: Value = serde_json::from_str(header).expect("JSON");
    assert_eq!((&header["title"], &header["unit"]), (&NAME.into(), &UNIT.into()));
    assert_eq!((&header["bands"][0], &header["parts"][0]["group"]), (&NAME.into(), &NAME.into()));
    assert_eq!(header["surfaces"][0]["name"], NAME);
}

#[test]
fn reports_show_names_as_they_are() {
    let folder = folder_with_solution();
    let page = text(folder.path(), &["report", "odd.json"], "report.html");
    assert!(!page.contains("<script") && !page.contains("</script"));
    let cell = "<td>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;|`&lt;&amp;&gt;&quot;&#39;--&gt;{{script}}</td>";
    assert!(page.contains(cell), "{page}");
    let page = text(folder.path(), &["report", "odd.json"], "report.md");
    // A row has as many cells as its head: no bar of a name divides one.
    let mut cells = 0;
    for line in page.lines().map(|line| line.replace("\\|", "")) {
        let bars = line.matches('|').count();
        assert!(cells == 0 || bars == 0 || bars == cells, "{line}");
        cells = bars;
    }
    assert!(page.contains("\\</script\\>\\<script\\>alert(1)\\</script\\>\\|\\`\\<\\&\\>"), "{page}");
}

#[test]
fn grids_and_textures_keep_names_whole() {
    let folder = folder_with_solution();
    let grid = text(folder.path(), &["relight", "odd.json", "--set", &format!("{NAME}=1")], "odd.vtu");
    let document = roxmltree::Document::parse(&grid).expect("it is well-formed");
    let arrays = document.descendants().filter_map(|node| node.attribute("Name"));
    let expected = format!("irradiance {NAME}");
    assert!(arrays.into_iter().any(|name| name == expected), "{grid}");
    let render = ["render", "odd.json", "--read", "basis", "--size", "16x16"];
    let glb = written(folder.path(), &render, "odd.glb");
    let length = u32::from_le_bytes(glb[12..16].try_into().expect("four bytes")) as usize;
    let tree: Value = serde_json::from_slice(&glb[20..20 + length]).expect("JSON");
    assert_eq!(
        (&tree["meshes"][0]["name"], &tree["scenes"][0]["extras"]["unit"]),
        (&NAME.into(), &UNIT.into())
    );
    assert_eq!(tree["scenes"][0]["extras"]["bands"][0], NAME);
}

/// Names of other programs that command a terminal, or forge lines, are escaped wherever they are shown; letters and
/// quotes stay.
#[test]
fn names_of_other_programs_command_no_terminal() {
    let escape = '\u{1b}';
    let obj = format!("o Tür{escape}[2J 'é'\nusemtl a{escape}b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"materials":[{"name":"m\u001b[1m"}],
        "nodes":[{"mesh":0,"name":"a\nwarning: b\u001b[2J"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],"buffers":[{"uri":"a.bin","byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]}"#;
    let corners = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].map(f32::to_le_bytes).concat();
    let parts = [("a.obj", obj.into_bytes()), ("a.gltf", gltf.as_bytes().to_vec()), ("a.bin", corners)];
    let folder = folder(&parts);
    for (args, shown) in [
        (&["check", "a.obj"][..], r"Tür\u{1b}[2J 'é'"),
        (&["check", "a.gltf"], r"a\nwarning: b\u{1b}[2J"),
        (&["view-factors", "a.gltf", "--format", "csv"], r"a\nwarning: b\u{1b}[2J"),
        (&["view-factors", "a.obj", "--pairs", "Tür,b"], r"Tür\u{1b}[2J 'é'"),
        (&["heat", "a.gltf"], r"a\\nwarning: b\\u{1b}[2J"),
    ] {
        let output = radiosity(folder.path(), args);
        let told = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
        assert!(told.contains(shown), "{args:?}: {told}");
        let forged = told.lines().any(|line| line.starts_with("warning: b"));
        assert!(!told.contains(escape) && !forged, "{args:?}: {told:?}");
    }
}

/// Paths command no terminal either.
#[test]
fn paths_command_no_terminal() {
    let folder = folder(&[("a\u{1b}[2J.toml", "frames = 1\u{1b}\n")]);
    for args in [&["check", "a\u{1b}[2J.toml"], &["check", "none\u{1b}[2J.toml"]] {
        let output = radiosity(folder.path(), args);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(
            !output.status.success() && told.contains(r"\u{1b}[2J.toml") && !told.contains('\u{1b}'),
            "{told:?}"
        );
    }
}
