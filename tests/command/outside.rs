//! Files outside the folder of a scene: the command reads them and says so; `--inside` and the library refuse
//! them; and no message shows what stands in them.

use std::path::Path;

use radiosity_test_support::folders::folder;

use crate::program::{done, radiosity, refused};

/// A word that stands in broken files outside, and that no message may show.
const SECRET: &str = "hidden-from-scenes";

const FLOOR: &str = "[[surfaces]]
material = \"white\"
parallelogram = { origin = [0, 0, 0], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }
";

const TABLE: &str =
    "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0.1 0.1 0\n1 1 50\n0 45 90\n0\n300 200 0\n";

/// A scene, its text, the word before the path and the path of the file outside that it names, and what that
/// says.
fn scenes() -> Vec<(&'static str, String, &'static str, &'static str, Vec<u8>)> {
    let white = "[materials.white]\nreflectance = 0.5\nemission = 1\n";
    let lamp = "[[luminaires]]\nposition = [0, 0, 1]\nphotometry = \"../lib/lamp.ies\"\n";
    let grain = "[materials.white]\nreflectance = { image = \"../lib/a.png\" }\n";
    let texels = radiosity_test_support::folders::png([2, 1], png::ColorType::Grayscale, &[200, 20]);
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
               element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let mesh = "<shape type=\"ply\"><string name=\"filename\" value=\"../lib/a.ply\"/></shape>";
    let buffer: Vec<u8> = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].map(f32::to_le_bytes).concat();
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"uri":"../lib/a.bin","byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]}"#;
    let obj = "mtllib ../lib/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl white\nf 1 2 3\n";
    let text = |text: &str| text.as_bytes().to_vec();
    vec![
        (
            "a.toml",
            format!("include = \"../lib/a.toml\"\n{FLOOR}"),
            "include: ",
            "../lib/a.toml",
            text(white),
        ),
        ("b.toml", format!("{lamp}{white}{FLOOR}"), "photometry = ", "../lib/lamp.ies", text(TABLE)),
        ("c.toml", format!("{grain}{FLOOR}"), "image = ", "../lib/a.png", texels),
        ("a.obj", obj.to_owned(), "mtllib '", "../lib/a.mtl", text("newmtl white\nKd 0.5 0.5 0.5\n")),
        (
            "a.mgf",
            "i ../lib/b.mgf\n".to_owned(),
            "included file '",
            "../lib/b.mgf",
            text("v a =\n\tp 0 0 1\nsph a 1\n"),
        ),
        ("a.gltf", gltf.to_owned(), "the buffer 0: the file '", "../lib/a.bin", buffer),
        (
            "a.xml",
            format!("<scene version=\"3.0.0\">{mesh}</scene>"),
            "the mesh '",
            "../lib/a.ply",
            text(ply),
        ),
        (
            "a.rad",
            "!xform ../lib/a.rad\n".to_owned(),
            "included file '",
            "../lib/a.rad",
            text("void plastic white 0 0 5 0.7 0.7 0.7 0 0\nwhite sphere ball 0 0 4 0 0 0 1\n"),
        ),
    ]
}

/// The folder `room` with a scene in a new folder, and a file beside it.
fn house(scene: &str, text: &str, outside: &str, content: &[u8]) -> tempfile::TempDir {
    let (scene, outside) = (format!("room/{scene}"), outside.replace("../", ""));
    folder(&[(&scene, text.as_bytes()), (&outside, content)])
}

fn told(folder: &Path, args: &[&str]) -> String {
    let output = radiosity(folder, args);
    String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned()
}

#[test]
fn the_command_reads_files_outside_and_says_so() {
    for (scene, text, _, outside, content) in scenes() {
        let house = house(scene, &text, outside, &content);
        let [found, _] = done(&house.path().join("room"), &["check", scene]);
        let told = format!("read outside the folder of the scene: {outside}");
        assert!(found.contains(&told), "{scene}: {found}");
        let [found, _] = done(&house.path().join("room"), &["check", scene, "--format", "json"]);
        let found: serde_json::Value = serde_json::from_str(&found).expect("JSON");
        assert_eq!(found["read_outside"], serde_json::json!([outside]), "{scene}");
    }
}

#[test]
fn inside_and_the_library_refuse_by_key_and_path() {
    for (scene, text, key, outside, content) in scenes() {
        let house = house(scene, &text, outside, &content);
        let room = house.path().join("room");
        let cure =
            "help: put a copy of it into the folder of the scene or below, and give its path from there";
        refused(
            &room,
            &["check", scene, "--inside"],
            &[key, outside, "outside the folder of the scene", cure],
        );
        let error = radiosity::load(&room.join(scene).to_string_lossy()).expect_err("it is outside");
        assert!(error.to_string().contains(outside), "{scene}: {error}");
        // The cure works.
        let near = outside.replace("../lib/", "near-");
        std::fs::write(room.join(&near), content).expect("it can be written");
        std::fs::write(room.join(scene), text.replace(outside, &near)).expect("it can be written");
        done(&room, &["check", scene, "--inside"]);
    }
}

#[test]
fn what_stands_outside_is_not_shown() {
    for (scene, text, _, outside, _) in scenes() {
        for content in
            [format!("{SECRET}\n"), format!("{SECRET} = [\n"), format!("[{SECRET}]\n{SECRET} = 1\n")]
        {
            let house = house(scene, &text, outside, content.as_bytes());
            let room = house.path().join("room");
            for args in [&["check", scene][..], &["check", scene, "--inside"]] {
                let told = told(&room, args);
                assert!(!told.contains(SECRET), "{args:?}: {told}");
            }
        }
    }
}

/// Notes on an import and lists of names show no word of a file outside, nor do they where all is read.
#[test]
fn notes_and_lists_of_names_show_no_word_of_files_outside() {
    let disk = "<shape type=\"disk\"/>";
    let scene = format!("<scene version=\"3.0.0\"><include filename=\"../lib/a.xml\"/>{disk}</scene>");
    let part = format!("<scene version=\"3.0.0\"><shape type=\"disk\" {SECRET}=\"1\"/></scene>");
    let house = house("a.xml", &scene, "../lib/a.xml", part.as_bytes());
    let room = house.path().join("room");
    let [found, _] = done(&room, &["check", "a.xml"]);
    assert!(found.contains("the attribute … of … is left out") && !found.contains(SECRET), "{found}");
    let named = format!("[materials.{SECRET}]\nreflectance = 0.5\n");
    let near = SECRET.replace("scenes", "scene");
    for material in [near.as_str(), "far"] {
        let floor = FLOOR.replace("white", material);
        let house = self::house(
            "a.toml",
            &format!("include = \"../lib/a.toml\"\n{floor}"),
            "../lib/a.toml",
            named.as_bytes(),
        );
        let room = house.path().join("room");
        let parts = [
            "unknown material",
            "names are not listed, as some are of files outside the folder of the scene",
        ];
        refused(&room, &["check", "a.toml"], &parts);
        assert!(!told(&room, &["check", "a.toml"]).contains(SECRET));
    }
}

/// A name with an odd quote in it hides no more and no less.
#[test]
fn notes_hide_what_files_say_and_keep_own_words() {
    let obj = "mtllib ../lib/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl it's\nf 1 2 3\n";
    let mtl = format!("newmtl it's\nKd 0.5\nKs 1 1 1\nnewmtl {SECRET}'s\nKd -1\n");
    let house = house("a.obj", obj, "../lib/a.mtl", mtl.as_bytes());
    let [found, _] = done(&house.path().join("room"), &["check", "a.obj"]);
    for own in [
        "specular reflection is left out",
        "the material …, which no face has, is left out: one of its colours cannot be followed",
    ] {
        assert!(found.contains(own), "{own:?} is missing in\n{found}");
    }
    assert!(!found.contains(SECRET), "{found}");
}

/// Messages list words of the language and names that stand in the folder of a scene, and no others.
#[test]
fn lists_hold_what_stands_in_the_folder_alone() {
    let secret = SECRET.replace('-', "_");
    let lib = format!(
        "[variables]\n{secret}_v = 1\n[materials.{secret}_m]\nreflectance = 0.5\nemission = 1\ngroup = \"{secret}_g\"\n\
         [planes.{secret}_p]\norigin = [0, 0, 1]\nedges = [[1, 0, 0], [0, 1, 0]]\nspacing = 0.5\n\
         [[surfaces]]\nname = \"{secret}_s\"\nmaterial = \"{secret}_m\"\n\
         parallelogram = {{ origin = [0, 0, 2], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }}\n"
    );
    let own = "[variables]\nheight = 1\n[materials.white]\nreflectance = 0.5\nemission = 1\ngroup = \"sun\"\n\
               [planes.desk]\norigin = [0, 0, 1]\nedges = [[1, 0, 0], [0, 1, 0]]\nspacing = 0.5\n";
    let scene = format!("include = \"../lib/a.toml\"\n{own}{FLOOR}name = \"floor\"\n");
    let wrong = [
        (
            scene.replace("material = \"white\"", "material = \"whit\""),
            &["check", "a.toml"][..],
            "did you mean \"white\"?",
        ),
        (scene.replace("height = 1", "height = \"=sine(1)\""), &["check", "a.toml"], "functions: "),
        (
            scene.replace("height = 1", "height = 1\nwidth = \"=heigt\""),
            &["check", "a.toml"],
            "did you mean \"height\"?",
        ),
        (scene.clone(), &["probe", "a.toml", "--plane", "dask"], "did you mean \"desk\"?"),
        (scene.clone(), &["solve", "a.toml", "--set", "heigt=1"], "did you mean \"height\"?"),
        (
            scene.clone(),
            &["solve", "a.toml", "--set", "snu=1"],
            "light groups: sun; others stand in files outside",
        ),
        (scene.clone(), &["view-factors", "a.toml", "--pairs", "floor,flor"], "did you mean \"floor\"?"),
    ];
    for (scene, args, cure) in wrong {
        let house = house("a.toml", &scene, "../lib/a.toml", lib.as_bytes());
        let told = told(&house.path().join("room"), args);
        assert!(told.contains(cure) && !told.contains(&secret), "{args:?}: {told}");
    }
}

/// Surfaces that stand outside are not named where heat lacks what they do not state.
#[test]
fn heat_names_no_surface_of_files_outside() {
    let lib = |heat: &str| {
        format!(
            "[materials.white]\nreflectance = 0.5\nemissivity = 0.5\n[[surfaces]]\nname = \"{SECRET}\"\nmaterial = \"white\"\n\
             {heat}\nparallelogram = {{ origin = [0, 0, 2], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }}\n"
        )
    };
    let scene = format!("include = \"../lib/a.toml\"\n{FLOOR}name = \"floor\"\ntemperature = 300\n");
    for (scene, heat, cause) in [
        (scene.clone(), "", "neither a temperature nor a flux of heat is given for \"…\""),
        (scene.replace("temperature = 300", ""), "temperature = 300", "is given for \"floor\""),
        (
            scene,
            "heat_flux = -1e6",
            "more heat is drawn than arrives: no temperature is low enough for \"…\"",
        ),
    ] {
        let house = house("a.toml", &scene, "../lib/a.toml", lib(heat).as_bytes());
        let told = told(&house.path().join("room"), &["heat", "a.toml"]);
        assert!(told.contains(cause) && !told.contains(SECRET), "{told}");
    }
}

#[test]
fn reports_list_the_files_outside() {
    let white = "[materials.white]\nreflectance = 0.5\nemission = 1\n";
    let scene = format!("include = \"../lib/a.toml\"\n{FLOOR}");
    let house = house("a.toml", &scene, "../lib/a.toml", white.as_bytes());
    let room = house.path().join("room");
    done(&room, &["solve", "a.toml", "-o", "a.json", "--report", "r.json"]);
    let report = std::fs::read_to_string(room.join("r.json")).expect("a report");
    let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
    assert_eq!(report["read_outside"], serde_json::json!(["../lib/a.toml"]));
}

/// A scene whose part stands outside, with names of that part and with own ones.
fn with_part(secret: &str) -> (String, String) {
    let lib = format!(
        "[materials.{secret}_m]\nreflectance = 0.5\nemission = 1\n\
         [[surfaces]]\nname = \"{secret}_s\"\nmaterial = \"{secret}_m\"\ntwo_sided = true\n\
         parallelogram = {{ origin = [0, 0, 2], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }}\n\
         [[surfaces]]\nname = \"{secret}_box\"\nmaterial = \"{secret}_m\"\n\
         box = {{ origin = [5, 5, 5], size = [1, 1, 1] }}\n\
         [[luminaires]]\nname = \"{secret}_l\"\nposition = [0.5, 0.5, 1.5]\naim = [0, 0, -1]\nextent = [0.1, 0.1]\n\
         spot = {{ exponent = 1 }}\nflux = 1\n"
    );
    let seat = "[[parts.chair.surfaces]]\nname = \"seat\"\nmaterial = \"white\"\n\
                parallelogram = { origin = [0, 0, 0.5], edge1 = [0.1, 0, 0], edge2 = [0, 0.1, 0] }\n\
                [[instances]]\nname = \"row\"\npart = \"chair\"\narray = { count = 2, step = [0.3, 0, 0] }\n";
    let scene = format!(
        "include = \"../lib/a.toml\"\n[materials.white]\nreflectance = 0.5\nemission = 1\ngroup = \"sun\"\n\
         [planes.desk]\norigin = [0, 0, 1]\nedges = [[1, 0, 0], [0, 1, 0]]\nspacing = 0.5\n\
         {FLOOR}name = \"lit\"\ntwo_sided = true\n{seat}"
    );
    (scene, lib)
}

/// Own names that a scene makes are listed, and those that it makes of what stands outside are not.
#[test]
fn names_that_scenes_make_are_listed_by_what_they_are_made_of() {
    let secret = SECRET.replace('-', "_");
    let (scene, lib) = with_part(&secret);
    let house = house("a.toml", &scene, "../lib/a.toml", lib.as_bytes());
    let room = house.path().join("room");
    for (typed, meant) in [
        ("lit:bac", "lit:back"),
        ("row[1].seet", "row[1].seat"),
        (&format!("{secret}_s:bac")[..], ""),
        (&format!("{secret}_box-to")[..], ""),
        (&format!("{secret}_")[..], ""),
    ] {
        let told = told(&room, &["view-factors", "a.toml", "--pairs", &format!("lit,{typed}")]);
        let listed = told.replace(&format!("{typed:?}"), "");
        assert!(!listed.contains(&secret), "{typed}: {told}");
        assert!(listed.contains("outside its folder: lit, lit:back, row[0].seat, row[1].seat"), "{told}");
        assert!(meant.is_empty() || told.contains(&format!("did you mean {meant:?}?")), "{told}");
    }
}

/// A solution keeps which files were outside.
#[test]
fn solutions_show_no_word_of_files_outside() {
    let secret = SECRET.replace('-', "_");
    let (scene, lib) = with_part(&secret);
    let lib = format!(
        "{lib}[planes.{secret}_p]\norigin = [0, 0, 1]\nedges = [[1, 0, 0], [0, 1, 0]]\nspacing = 0.5\n"
    );
    let house = house("a.toml", &scene, "../lib/a.toml", lib.as_bytes());
    let room = house.path().join("room");
    done(&room, &["solve", "a.toml", "-o", "a.json", "--order", "0", "--eps", "1e-1", "--audit", "0.001"]);
    for args in [
        &["probe", "a.json", "--plane", "hidden_from_scenes"][..],
        &["relight", "a.json", "--set", "snu=1", "-o", "b.json"],
    ] {
        let told = told(&room, args);
        assert!(!told.replace("\"hidden_from_scenes\"", "").contains(&secret), "{args:?}: {told}");
        assert!(told.contains("help: "), "{told}");
    }
    done(
        &room,
        &["probe", "a.json", "--plane", "desk", "--report", "r.json", "-o", "p.csv", "--audit", "0.001"],
    );
    let report = std::fs::read_to_string(room.join("r.json")).expect("a report");
    let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
    assert_eq!(report["read_outside"], serde_json::json!(["../lib/a.toml"]));
}

/// The text of a scene of another program holds what all its files say: no names of it are listed, and its solution
/// keeps that.
#[test]
fn imports_list_no_names_where_files_are_outside() {
    let lib = format!("void light lamp 0 0 3 1 1 1\nlamp sphere {SECRET} 0 0 4 0 0 2 0.5\n");
    let scene =
        "void plastic white 0 0 5 0.7 0.7 0.7 0 0\nwhite sphere ball 0 0 4 0 0 0 0.5\n!xform ../lib/a.rad\n";
    let house = house("a.rad", scene, "../lib/a.rad", lib.as_bytes());
    let room = house.path().join("room");
    let told = told(&room, &["view-factors", "a.rad", "--pairs", "ball,hidden-from-scene"]);
    assert!(told.contains("names are not listed") && !told.contains(SECRET), "{told}");
    done(&room, &["solve", "a.rad", "-o", "a.json", "--order", "0", "--eps", "1e-1", "--audit", "0.001"]);
    done(&room, &["render", "a.json", "-o", "p.png", "--size", "8x8", "--report", "r.json"]);
    let report = std::fs::read_to_string(room.join("r.json")).expect("a report");
    let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
    assert_eq!(report["read_outside"], serde_json::json!(["../lib/a.rad"]));
}

/// Values that a file outside gives to parameters are not quoted where they stand.
#[test]
fn parameters_of_files_outside_are_not_quoted() {
    let part = format!("<scene version=\"3.0.0\"><default name=\"size\" value=\"{SECRET}\"/></scene>");
    let include = "<scene version=\"3.0.0\"><include filename=\"../lib/a.xml\"/>";
    for inner in [
        "<shape type=\"sphere\"><float name=\"radius\" value=\"$size\"/></shape>",
        "<shape type=\"$size\"/>",
        "<default name=\"again\" value=\"a $size\"/><shape type=\"sphere\"><float name=\"radius\" value=\"$again\"/></shape>",
        "<include filename=\"$size\"/>",
        "<shape type=\"ply\"><string name=\"filename\" value=\"$size\"/></shape>",
        "<shape type=\"disk\"><ref id=\"$size\"/></shape>",
        "<path value=\"$size\"/><include filename=\"x.xml\"/>",
        "<path value=\"$size\"/><shape type=\"ply\"><string name=\"filename\" value=\"x.ply\"/></shape>",
    ] {
        let house = house("a.xml", &format!("{include}{inner}</scene>"), "../lib/a.xml", part.as_bytes());
        let told = told(&house.path().join("room"), &["check", "a.xml"]);
        assert!(!told.contains(SECRET), "{inner}: {told}");
        let is_known = inner.contains("type=\"$size\"");
        assert!(told.contains("which is not shown") != is_known, "{inner}: {told}");
    }
    // Nor are names of parameters that they make.
    let long = part.replace(SECRET, &SECRET.repeat(9));
    let named = format!("{include}<default name=\"$size\" value=\"1\"/></scene>");
    let house_of_names = house("a.xml", &named, "../lib/a.xml", long.as_bytes());
    let refused = told(&house_of_names.path().join("room"), &["check", "a.xml"]);
    assert!(refused.contains("which is not shown") && !refused.contains(SECRET), "{refused}");
    // Own values are.
    let own = "<scene version=\"3.0.0\"><include filename=\"../lib/a.xml\"/><default name=\"own\" value=\"big\"/>\
               <shape type=\"sphere\"><float name=\"radius\" value=\"$own\"/></shape></scene>";
    let house = house("a.xml", own, "../lib/a.xml", part.as_bytes());
    assert!(told(&house.path().join("room"), &["check", "a.xml"]).contains("'big'"));
}

/// Repairs and their refusals name no surface where a file outside is read, nor do files of materials.
#[test]
fn repairs_show_no_word_of_files_outside() {
    let lib = format!(
        "void plastic {SECRET}-m 0 0 5 0.7 0.7 0.7 0 0\n{SECRET}-m polygon {SECRET}-p 0 0 9 0 0 0 1 0 0 2 0 0\n\
         {SECRET}-m sphere {SECRET}-s 0 0 4 0 0 2 0.5\n"
    );
    let house = house("a.rad", "!xform ../lib/a.rad\n", "../lib/a.rad", lib.as_bytes());
    let room = house.path().join("room");
    std::fs::write(room.join("m.toml"), "[materials.far]\nreflectance = 0.5\n").expect("it can be written");
    std::fs::write(room.join("n.toml"), "[materials.\"hidden-from-scene\"]\nreflectance = 0.5\n")
        .expect("it can");
    let [summary, _] = done(&room, &["check", "a.rad", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let remarks = found["imported"]["remarks"].to_string();
    assert!(remarks.contains("… has no area; it was removed") && !remarks.contains(SECRET), "{remarks}");
    for args in [
        &["solve", "a.rad", "--strict"][..],
        &["check", "a.rad", "--materials", "m.toml"],
        &["check", "a.rad", "--materials", "n.toml"],
    ] {
        let told = told(&room, args);
        assert!(told.contains("help: ") && !told.contains(SECRET), "{args:?}: {told}");
    }
}

/// A buffer may be any file: its numbers, which are those of its letters, are not told.
#[test]
fn buffers_of_files_outside_are_not_spelt() {
    let scene = r#"{ "asset": { "version": "2.0" }, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "buffers": [{ "uri": "../lib/a.bin", "byteLength": 40 }],
        "bufferViews": [{ "buffer": 0, "byteOffset": 4, "byteLength": 36 }, { "buffer": 0, "byteLength": 12 }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" },
            { "bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR" }] }"#;
    let house = house("a.gltf", scene, "../lib/a.bin", b"password = hunter2, which is said to none.");
    let told = told(&house.path().join("room"), &["check", "a.gltf"]);
    let spelt = u32::from_le_bytes(*b"pass").to_string();
    assert!(told.contains("a vertex beyond the 3 that are listed") && !told.contains(&spelt), "{told}");
}

/// Faults of what an import makes show neither lines nor names of a file outside, nor a modifier that it gives.
#[test]
fn faults_of_imports_show_no_word_of_files_outside() {
    let far = format!(
        "void plastic {SECRET} 0 0 5 0.7 0.7 0.7 0 0\n{SECRET} sphere {SECRET} 0 0 4 0 0 9.9e30 1e30\n"
    );
    let given = format!("!xform -m {SECRET} ../room/in.rad\n");
    for (lib, inner) in [(far, ""), (given, "void sphere s 0 0 4 0 0 2 0.5\n")] {
        let house = house("a.rad", "!xform ../lib/a.rad\n", "../lib/a.rad", lib.as_bytes());
        let room = house.path().join("room");
        std::fs::write(room.join("in.rad"), inner).expect("it can be written");
        let told = told(&room, &["check", "a.rad"]);
        assert!(told.contains("which is not shown") && !told.contains(SECRET), "{told}");
    }
}
