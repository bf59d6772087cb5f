//! Bad input: every case gets file, line, column, name and cure on stderr, exit code 2, and leaves no file
//! behind.

use radiosity_test_support::folders::folder;
use std::fs;

use crate::program::{self, assert_refused, fed, radiosity};

/// A scene that is right, to be broken in one place.
const ROOM: &str = r#"title = "room"
[camera]
eye = [0, -3, 1]
target = [0, 0, 1]
[materials.white]
reflectance = 0.5
emission = 1
[[surfaces]]
name = "floor"
material = "white"
quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
"#;

/// `ROOM` with `old`, which it must contain, replaced by `new`.
fn room(old: &str, new: &str) -> String {
    assert!(ROOM.contains(old), "{old:?} is not in the room");
    ROOM.replace(old, new)
}

/// Renders a scene that must be refused: exit code 2, empty stdout, no new file, all of `parts` on stderr.
#[track_caller]
fn refused_file(file: &str, scene: &str, parts: &[&str]) {
    let folder = folder(&[(file, scene)]);
    program::refused(folder.path(), &["render", file, "-o", "out.png", "--report", "report.json"], parts);
}

#[track_caller]
fn refused(scene: &str, parts: &[&str]) {
    refused_file("room.toml", scene, parts);
}

/// Runs in an empty folder, which must stay empty.
#[track_caller]
fn refused_command(args: &[&str], parts: &[&str]) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    program::refused(folder.path(), args, parts);
}

#[test]
fn the_room_itself_is_right() {
    let folder = folder(&[("room.toml", ROOM)]);
    let output = radiosity(folder.path(), &["check", "room.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn toml_syntax() {
    refused(&room("0.5", "0,5"), &["room.toml:6:16: syntax error", "help: TOML wants"]);
    refused(&room("[camera]", "[camera"), &["room.toml:2:", "syntax error"]);
}

#[test]
fn json_syntax() {
    let scene = "{\n  \"title\": \"room\",\n  \"surfaces\": [}\n}";
    refused_file("room.json", scene, &["room.json:3:16: syntax error: expected value", "help: JSON wants"]);
    refused_file("room.json", "{\"title\": NaN}", &["room.json:1:11: syntax error"]);
}

#[test]
fn unknown_key() {
    let parts =
        ["room.toml:6:1: material \"white\": unknown key \"reflectence\"", "did you mean \"reflectance\"?"];
    refused(&room("reflectance", "reflectence"), &parts);
    let parts = ["room.toml:1:1: unknown key \"tilte\"", "did you mean \"title\"?", "surfaces"];
    refused(&room("title", "tilte"), &parts);
    let parts =
        ["room.toml:11:10: surface \"floor\": unknown key \"vertexes\"", "did you mean \"vertices\"?"];
    refused(&room("vertices", "vertexes"), &parts);
}

#[test]
fn repeated_key() {
    refused(&room("emission = 1", "reflectance = 1"), &["room.toml:7:1: syntax error: duplicate key"]);
    let scene = "{\"title\": \"a\",\n \"title\": \"b\"}";
    refused_file("room.json", scene, &["room.json:2:2: the key \"title\" stands twice", "help: keep one"]);
}

#[test]
fn unknown_material() {
    let parts = ["room.toml:10:12: surface \"floor\": unknown material \"whit\"", "did you mean \"white\"?"];
    refused(&room("= \"white\"", "= \"whit\""), &parts);
}

#[test]
fn light_groups_have_names() {
    let parts = [
        "room.toml:7:9: material \"white\": expected a text in quotes, found a number",
        "help: write it in quotes",
    ];
    refused(&room("emission = 1", "group = 1"), &parts);
    let parts = ["surface \"floor\": expected a text in quotes, found a list"];
    refused(&room("material = \"white\"", "group = [\"lamps\"]"), &parts);
    for blank in ["", " "] {
        let parts =
            ["room.toml:10:9: surface \"floor\": this text is empty", "help: write at least one letter"];
        refused(&room("material = \"white\"", &format!("group = \"{blank}\"")), &parts);
    }
}

#[test]
fn missing_material() {
    let parts = ["room.toml:8:", "surface \"floor\": the key \"material\" is missing", "help: add `material"];
    refused(&room("material = \"white\"", ""), &parts);
}

#[test]
fn unknown_shape() {
    let parts =
        ["room.toml:11:1: surface \"floor\": unknown key \"quadd\"", "did you mean \"quad\"?", "polygon"];
    refused(&room("quad", "quadd"), &parts);
    refused(
        &room("quad = {", "# {"),
        &["room.toml:8:", "surface \"floor\": no shape is given", "help: add one"],
    );
}

#[test]
fn two_shapes() {
    let scene = format!("{ROOM}triangle = {{ vertices = [[0,0,0],[1,0,0],[1,1,0]] }}\n");
    refused(&scene, &["room.toml:12:12: surface \"floor\": two shapes are given: \"quad\" and \"triangle\""]);
}

#[test]
fn wrong_number_of_numbers() {
    refused(
        &room("[1,1,0]", "[1,1]"),
        &["room.toml:11:38: surface \"floor\": a point takes 3 numbers, found 2"],
    );
    refused(&room(",[1,1,0]", ""), &["room.toml:11:21: surface \"floor\": a quad takes 4 vertices, found 3"]);
    refused(
        &room("0.5", "[0.5, 0.5]"),
        &["room.toml:6:15: material \"white\"", "3, one per band", "found 2"],
    );
}

#[test]
fn empty_list_and_empty_text() {
    let parts = ["room.toml:2:9: the list of bands takes at least one name, found 0"];
    refused(&room("[camera]", "bands = []\n[camera]"), &parts);
    refused(&room("\"floor\"", "\" \""), &["room.toml:9:8: surface \"surface-1\": this text is empty"]);
}

#[test]
fn wrong_kind_of_value() {
    refused(
        &room("0.5", "\"half\""),
        &["room.toml:6:15: material \"white\": expected a number, found a text"],
    );
    refused(&room("= \"white\"", "= 3"), &["room.toml:10:12: surface \"floor\": expected a text in quotes"]);
    let scene = "{\"surfaces\": [{\"name\": null}]}";
    refused_file("room.json", scene, &["room.json:1:24: surface \"surface-1\"", "found null"]);
}

#[test]
fn not_finite() {
    refused(
        &room("0.5", "nan"),
        &["room.toml:6:15: material \"white\": NaN is not a finite number", "help: write a finite number"],
    );
    refused(
        &room("[1,1,0]", "[1,inf,0]"),
        &["room.toml:11:41: surface \"floor\": inf is not a finite number"],
    );
    refused(
        &room("[1,1,0]", "[1,1e31,0]"),
        &["room.toml:11:41: surface \"floor\": the number is 1e31, outside −1e30 ≤ x ≤ 1e30", "help: choose"],
    );
    let scene = "{\"camera\": {\"eye\": [0, 0, 1e999], \"target\": [0, 0, 0]}}";
    refused_file("room.json", scene, &["room.json:1:27: camera: inf is not a finite number"]);
}

#[test]
fn reflectance_out_of_range() {
    for rho in ["1.2", "1", "-0.1"] {
        let message =
            format!("room.toml:6:15: material \"white\": the reflectance is {rho}, outside 0 ≤ ρ < 1");
        refused(&room("0.5", rho), &[&message, "help: choose"]);
    }
    refused(&room("0.5", "[0.1, 0.2, 1.5]"), &["room.toml:6:26: material \"white\": the reflectance is 1.5"]);
}

#[test]
fn negative_emission() {
    let parts =
        ["room.toml:7:12: material \"white\": the emission is -1, outside emission ≥ 0", "help: choose"];
    refused(&room("emission = 1", "emission = -1"), &parts);
}

#[test]
fn surface_without_area() {
    refused(&room("[1,1,0],[0,1,0]", "[1,0,0],[0,0,0]"), &["room.toml:11:", "surface \"floor\": `vertices`"]);
    refused(&room("[1,1,0],[0,1,0]", "[3,0,0],[2,0,0]"), &["surface \"floor\": `vertices` spans no area"]);
    let parallelogram = "parallelogram = { origin = [0,0,0], edge1 = [1,0,0], edge2 = [2,0,0] }\n#";
    refused(
        &room("quad", parallelogram),
        &["room.toml:11:", "surface \"floor\"", "`edge2` is parallel to `edge1`"],
    );
}

#[test]
fn folded_surface() {
    let parts = ["room.toml:11:21: surface \"floor\": `vertices` folds over", "in order around"];
    // Corners in the wrong order, and an outline that is not convex.
    refused(&room("[1,1,0],[0,1,0]", "[0,1,0],[1,1,0]"), &parts);
    refused(&room("[1,1,0]", "[0.2,0.2,0]"), &parts);
}

#[test]
fn polygon_that_is_not_planar() {
    let scene = room("quad", "polygon").replace("[1,1,0]", "[1,1,0.4]");
    refused(&scene, &["room.toml:11:", "surface \"floor\": `vertices`", "off the plane"]);
}

#[test]
fn hole_outside() {
    let parts = ["room.toml:11:19: surface \"floor\": `holes[0]` reaches outside the outline"];
    refused(&room("vertices", "holes = [[[0.1,0.1,0],[0.4,0.1,0],[2,2,0]]], vertices"), &parts);
}

#[test]
fn duplicate_names() {
    let moved = "[[surfaces]]\nname = \"floor\"\nmaterial = \"white\"\n\
                 quad = { vertices = [[0,0,1],[1,0,1],[1,1,1],[0,1,1]] }\n";
    let parts = ["room.toml:13:8: the name \"floor\" is given twice", "on line 9"];
    refused(&format!("{ROOM}{moved}"), &parts);
    let named_back = moved.replace("\"floor\"", "\"floor:back\"");
    refused(&format!("{ROOM}two_sided = true\n{named_back}"), &["the name \"floor:back\" is given twice"]);
    refused(
        &room("[camera]", "bands = [\"a\", \"a\"]\n[camera]"),
        &["room.toml:2:15: the name \"a\" is given twice"],
    );
}

#[test]
fn coincident_surfaces() {
    // Overlapping by a half, and turned over.
    let other = "[[surfaces]]\nname = \"carpet\"\nmaterial = \"white\"\n\
                 polygon = { vertices = [[0.5,0,0],[0.5,1,0],[2,1,0],[2,0,0]] }\n";
    let parts = [
        "room.toml:15:11: surface \"carpet\": coincides with surface \"floor\"",
        "cut a hole into \"floor\"",
    ];
    refused(&format!("{ROOM}{other}"), &parts);
    // A copy of a surface that is not planar, with other corners first.
    let bent = room("[1,1,0]", "[1,1,0.2]");
    let copy =
        "[[surfaces]]\nmaterial = \"white\"\nquad = { vertices = [[1,0,0],[1,1,0.2],[0,1,0],[0,0,0]] }\n";
    refused(&format!("{bent}{copy}"), &["surface \"surface-2\": coincides with surface \"floor\""]);
}

#[test]
fn a_back_may_be_given_by_name() {
    let side = |name: &str, vertices: &str| {
        format!(
            "{ROOM}[[surfaces]]\nname = {name:?}\nmaterial = \"white\"\nquad = {{ vertices = {vertices} }}\n"
        )
    };
    let turned = "[[0,0,0],[0,1,0],[1,1,0],[1,0,0]]";
    let folder = folder(&[("room.toml", side("floor:back", turned))]);
    let output = radiosity(folder.path(), &["check", "room.toml"]);
    let [message, findings] = [&output.stderr, &output.stdout].map(|text| String::from_utf8_lossy(text));
    assert_eq!(output.status.code(), Some(0), "{message}");
    assert!(!findings.contains("lies partly in"), "{findings}");
    // Facing the same way, or under another name, it is refused.
    let same = "[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]";
    refused(&side("floor:back", same), &["surface \"floor:back\": coincides with surface \"floor\""]);
    refused(&side("floor:below", turned), &["surface \"floor:below\": coincides with surface \"floor\""]);
}

#[test]
fn no_surface() {
    let (before, _) = ROOM.split_once("[[surfaces]]").unwrap();
    refused(before, &["room.toml: the scene has no surface", "help: add a [[surfaces]] entry"]);
    refused("", &["room.toml: the scene has no surface"]);
}

#[test]
fn no_emitter_is_wrong_only_where_light_is_asked_for() {
    let dark = room("emission = 1", "emission = 0");
    refused(&dark, &["room.toml: nothing emits light", "help: give a material an emission"]);
    let folder = folder(&[("room.toml", dark)]);
    let output = radiosity(folder.path(), &["check", "room.toml"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(String::from_utf8_lossy(&output.stdout).contains("warning: nothing emits light"));
}

#[test]
fn order_out_of_range() {
    let parts = ["room.toml:9:9: surface \"floor\": the order is 21, outside 0 ≤ order ≤ 20"];
    refused(&room("name", "order = 21\nname"), &parts);
    refused(
        &room("name", "order = 1.5\nname"),
        &["room.toml:9:9: surface \"floor\": 1.5 is not a whole number"],
    );
    refused_command(
        &["solve", "--order", "21"],
        &["invalid value '21' for '--order <N|auto>'", "expected a whole number from 0 to 20, or auto"],
    );
}

#[test]
fn camera_without_view() {
    let parts = ["room.toml:", "camera: eye and target are the same point", "help: move the eye"];
    refused(&room("target = [0, 0, 1]", "target = [0, -3, 1]"), &parts);
    refused(&room("eye", "fov = 180\neye"), &["room.toml:3:7: camera: the angle of view is 180"]);
}

/// The room with a plane of sensors, to be broken in one place.
fn planed(old: &str, new: &str) -> String {
    let plane = "[planes.desk]\norigin = [0, 0, 0.7]\nedges = [[1, 0, 0], [0, 1, 0]]\nspacing = 0.25\n";
    assert!(plane.contains(old), "{old:?} is not in the plane");
    room("[materials.white]", &(plane.replace(old, new) + "[materials.white]"))
}

#[test]
fn planes_that_cannot_be() {
    for (edge, problem) in
        [("[2, 0, 0]", "the edges are parallel"), ("[0, 0, 0]", "second edge has no length")]
    {
        let parts = ["room.toml:7:9: plane \"desk\": ", problem, "help: give two edges"];
        refused(&planed("[0, 1, 0]", edge), &parts);
    }
    refused(&planed("[1, 0, 0]", "[0, 0, 0]"), &["plane \"desk\": the first edge has no length"]);
    for spacing in ["0", "-0.1", "[0.2, 0]"] {
        let parts =
            ["room.toml:8:11: plane \"desk\": the spacing is ", "outside spacing > 0", "help: choose"];
        refused(&planed("0.25", spacing), &parts);
    }
    refused(&planed("0.25", "nan"), &["room.toml:8:11: plane \"desk\": NaN is not a finite number"]);
    refused(&planed("0.25", "[0.1, 0.1, 0.1]"), &["spacing takes 2 numbers, one along each edge, found 3"]);
    let parts =
        ["room.toml:8:11: plane \"desk\": there are 1.0e8 sensors, more than 10⁷", "help: choose a larger"];
    refused(&planed("0.25", "1e-4"), &parts);
    refused(&planed("spacing", "distance"), &["unknown key \"distance\"", "origin, edges, spacing"]);
    refused(&planed("spacing = 0.25", ""), &["plane \"desk\": the key \"spacing\" is missing", "a length"]);
}

#[test]
fn units_that_cannot_be_printed() {
    let parts = ["room.toml:2:8: the unit is longer than 16 characters", "help: write a short text"];
    refused(&room("[camera]", "unit = \"watts per square metre\"\n[camera]"), &parts);
    refused(&room("[camera]", "unit = \"l\\nx\"\n[camera]"), &["the unit is more than one line"]);
}

#[test]
fn bad_transform() {
    let parts = ["room.toml:9:24: surface \"floor\": `rotate` has no length; give a vector"];
    refused(&room("name", "transform = { rotate = [0, 0, 0, 30] }\nname"), &parts);
    refused(
        &room("name", "transform = { scale = 0 }\nname"),
        &["room.toml:9:23:", "`scale` is 0; it must be greater than zero"],
    );
}

#[test]
fn coincident_curved_surfaces() {
    let ball = "sphere = { center = [5,0,0], radius = 1 }";
    let part = "disk = { center = [0.5,0.5,0], normal = [0,0,-1], radius = 0.2 }";
    let zone = "sphere = { center = [5,0,0], radius = 1, axis = [1,1,0], z = [0, 0.5] }";
    let with = |shapes: [&str; 2]| {
        let entry = |shape| format!("[[surfaces]]\nmaterial = \"white\"\n{shape}\n");
        format!("{ROOM}{}{}", entry(shapes[0]), entry(shapes[1]))
    };
    let parts =
        ["room.toml:17:10: surface \"surface-3\": coincides with surface \"surface-2\"", "help: remove one"];
    refused(&with([ball, zone]), &parts);
    let parts =
        ["room.toml:14:8: surface \"surface-2\": coincides with surface \"floor\"", "help: remove one"];
    refused(&with([part, ball]), &parts);
}

#[test]
fn sheets_that_turn_back() {
    let scene = format!(
        "{ROOM}[[surfaces]]\nmaterial = \"white\"\nextrusion = {{ curve = [[0,5,0],[3,5,0],[-1,5,0],[2,5,0]], direction = [0,0,1] }}\n"
    );
    let parts = [
        "room.toml:14:23: surface \"surface-2\": `curve` turns back on itself; give control points that advance",
    ];
    refused(&scene, &parts);
}

#[test]
fn sizes_beyond_computing() {
    let parts = [
        "room.toml:12:8: surface \"floor\": the extent of the surface is 1",
        "outside 1e-30 ≤ extent ≤ 1e30",
    ];
    refused(
        &room("quad = {", "transform = { scale = 1e-30 }\nquad = {")
            .replace("[1,", "[0.1,")
            .replace(",1,", ",0.1,"),
        &parts,
    );
}

#[test]
fn missing_file() {
    refused_command(&["render", "none.toml"], &["none.toml: cannot be read", "help: check the path"]);
}

#[test]
fn unknown_scene_name() {
    let parts = ["unknown scene \"cornel-box\"", "did you mean \"cornell-box\"?", "furnace-cube"];
    refused_command(&["solve", "cornel-box"], &parts);
}

#[test]
fn more_cells_or_pixels_than_memory() {
    let parts = ["not enough memory", "help: ask for fewer with", "--memory"];
    for (verb, option) in [("grid", "--cells"), ("render", "--size")] {
        let args = [verb, "cornell-box", option, "16384x16384", "--memory", "100M"];
        refused_command(&args, &[&parts[..], &[option]].concat());
    }
}

#[test]
fn unwritable_output() {
    refused_command(
        &["render", "-o", "none/out.png"],
        &["none/out.png: cannot be written", "help: choose a file"],
    );
    refused_command(&["solve", "-o", "."], &[".: cannot be written: it is a folder"]);
    refused_command(&["grid", "--report", "none/r.json"], &["none/r.json: cannot be written"]);
}

#[test]
fn accuracies_below_rounding_and_points_beyond_all_scenes_are_refused() {
    for option in ["--eps", "--shadow-eps"] {
        refused_command(&["solve", "cornell-box", option, "1e-300"], &["from 1e-14", option]);
        refused_command(&["view-factors", "cornell-box", option, "1e-300"], &["from 1e-14", option]);
    }
}

#[test]
fn rays_with_what_knows_none() {
    for others in [
        &["--kernel", "paper-legendre"][..],
        &["--shadows", "mask"],
        &["--shadows", "off"],
        &["--transport", "exact"],
    ] {
        let args = [&["solve", "cornell-box", "--rays", "1000"][..], others].concat();
        refused_command(&args, &["--rays does not go with", "leave one of them out"]);
    }
    let args = ["solve", "cornell-box", "--transport", "sampled", "--shadows", "mask"];
    refused_command(&args, &["--transport sampled does not go with --shadows mask"]);
    refused_command(&["solve", "cornell-box", "--rays", "0"], &["--rays"]);
    refused_command(&["solve", "cornell-box", "--transport", "some"], &["exact", "sampled"]);
}

#[test]
fn what_goes_with_no_other_basis() {
    for (basis, others, told) in [
        ("constant", &["--order", "2"][..], "--basis constant has no --order 2"),
        ("linear", &["--order", "0"], "--basis linear has no --order 0"),
        ("linear", &["--tensor"], "--basis linear does not go with --tensor"),
        ("harmonic", &["--accuracy", "0.1"], "--basis harmonic does not go with --accuracy"),
        (
            "harmonic",
            &["--method", "hierarchical", "--order", "0"],
            "--basis harmonic does not go with --method hierarchical",
        ),
        ("constant", &["--rays", "1000"], "--basis constant does not go with --rays"),
        ("linear", &["--kernel", "paper-legendre"], "--basis linear does not go with --kernel"),
        ("linear", &["--shadows", "mask"], "--basis linear does not go with --shadows mask"),
    ] {
        let args = [&["grid", "empty-box", "--basis", basis][..], others].concat();
        refused_command(&args, &[told, "leave"]);
    }
    refused_command(&["convergence", "--basis", "constant"], &["not --basis constant", "--with constant"]);
    refused_command(&["convergence", "--basis", "harmonic", "--bases"], &["not --basis harmonic"]);
}

#[test]
fn what_goes_with_no_limit_of_reflections() {
    refused_command(
        &["solve", "--bounces", "2"],
        &["--bounces 2: a solution is kept", "render, probe or grid"],
    );
    refused_command(
        &["grid", "--bounces", "2", "--accuracy", "0.1"],
        &["--bounces does not go with --accuracy"],
    );
    let args = ["grid", "--bounces", "2", "--method", "hierarchical"];
    refused_command(&args, &["--bounces does not go with --method hierarchical"]);
    refused_command(
        &["grid", "--preconditioner", "none", "--solver", "lu"],
        &["does nothing with --solver lu"],
    );
}

#[test]
fn what_goes_with_shots_and_columns() {
    for (args, told) in [
        ("solve --shots 3", &["--shots 3: a solution is kept", "type --shots to render"][..]),
        ("render --shots 3 --solver cg", &["--shots does nothing without --solver southwell"]),
        ("render --ambient", &["--ambient does nothing without --shots", "add --shots"]),
        ("render --shots 3 --bounces 2", &["--shots does not go with --bounces"]),
        ("grid --shots 3 --accuracy 0.1", &["--shots does not go with --accuracy"]),
        ("grid --shots 3 --basis linear", &["--shots does not go with --basis linear"]),
        ("render --shots 3 --read gather", &["light that was not shot", "take --read basis"]),
        ("solve --columns all", &["--columns does nothing without --solver southwell"]),
        ("solve --solver southwell --columns shot --rays 1000", &["--columns shot does not go with --rays"]),
        (
            "solve --solver southwell --columns shot --kernel paper-legendre",
            &["--columns shot does not go with --kernel"],
        ),
        ("solve --solver cg --sweep symmetric", &["--sweep does nothing with --solver cg", "gauss-seidel"]),
        ("solve --solver lu --relaxation 1.1", &["--relaxation does nothing with --solver lu"]),
        ("solve --solver richardson --at-once block", &["--at-once does nothing with --solver richardson"]),
        ("solve --solver cg --restart 9", &["--restart does nothing with --solver cg", "--solver gmres"]),
        ("convergence --shots 3 --bases", &["--shots is a study of one order"]),
        ("animate --shots 3", &["--shots 3: frames", "render --frame K --shots"]),
    ] {
        refused_command(&args.split(' ').collect::<Vec<_>>(), told);
    }
}

#[test]
fn unknown_solver() {
    refused_command(&["solve", "--solver", "gauss"], &["'gauss'", "lu", "gauss-seidel", "southwell"]);
}

#[test]
fn options_out_of_range() {
    for (option, value) in [
        ("--eps", "1"),
        ("--eps", "nan"),
        ("--tolerance", "0"),
        ("--max-iterations", "0"),
        ("--subdivide", "0"),
        ("--subdivide", "257"),
        ("--basis", "wavelet"),
        ("--bounces", "-1"),
        ("--bounces", "1.5"),
        ("--preconditioner", "some"),
        ("--shots", "-1"),
        ("--columns", "some"),
        ("--relaxation", "2"),
        ("--restart", "0"),
        ("--shadows", "some"),
        ("--threads", "0"),
        ("--threads", "100000"),
    ] {
        refused_command(&["grid", option, value], &[option, &format!("invalid value '{value}'")]);
    }
    refused_command(&["grid", "--cells", "16"], &["invalid value '16' for '--cells", "such as 16x16"]);
    refused_command(&["render", "--size", "0x5"], &["invalid value '0x5' for '--size"]);
}

#[test]
fn standard_input_is_named() {
    let output = fed(&std::env::temp_dir(), &["check", "-"], "{\"surfaces\": 1}");
    assert_refused(&output, &["<stdin>:1:14: expected a list, found a number"]);
}

const POLYGONS_CSV: &str = "# one\n\nname,x,y,z\na,0,0,0\na,1,0,0\na,0,1,0\n";
const POLYGONS_JSON: &str = "[[[0,0,0],[1,0,0],[0,1,0]]]";

#[test]
fn lists_of_polygons_are_known_by_their_beginning_and_by_any_case_of_their_ending() {
    for text in [POLYGONS_CSV, POLYGONS_JSON] {
        for mark in ["", "\u{feff}"] {
            let output = fed(&std::env::temp_dir(), &["check", "-"], &format!("{mark}{text}"));
            assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let json = "{\"surfaces\": [{\"triangle\": {\"vertices\": [[0,0,0],[1,0,0],[0,1,0]]}}]}";
    for (file, text) in [
        ("a.CSV", POLYGONS_CSV),
        ("b.JSON", POLYGONS_JSON),
        ("c.TOML", ROOM),
        ("d.json", &format!("\u{feff}{json}")),
    ] {
        fs::write(folder.path().join(file), text).unwrap();
        let output = radiosity(folder.path(), &["check", file]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn lists_of_polygons_carry_no_materials() {
    let parts = ["a list of polygons carries no materials", "view-factors", "TOML scene"];
    refused_file("a.csv", POLYGONS_CSV, &parts);
    refused_file("a.json", POLYGONS_JSON, &parts);
}

#[test]
fn rows_after_comments_and_blank_lines_are_placed() {
    let broken = POLYGONS_CSV.replace("a,1,0,0", "\n# two\na,1,O,0");
    refused_file("a.csv", &broken, &["a.csv:7:5: expected a number"]);
    let semicolons = POLYGONS_CSV.replace(',', ";");
    refused_file("a.csv", &semicolons, &["a.csv:3:1: a row takes four fields parted by commas"]);
}

#[test]
fn points_between_semicolons() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.csv"), "# desk\n0;0;0;0;0;1\n").unwrap();
    let output = radiosity(folder.path(), &["probe", "--points", "p.csv", "furnace-cube"]);
    assert_refused(&output, &["p.csv:2: there is no comma in it", "help: part the numbers by commas"]);
}

#[test]
fn the_line_is_shown_and_underlined() {
    let parts = ["  |\n6 | reflectance = 1.2\n  |               ^^^\n"];
    refused(&room("0.5", "1.2"), &parts);
}
