//! The command `report`: its figures against those of other verbs, its files, and what it refuses.

use std::fs;
use std::path::Path;

use radiosity_test_support::folders::names;
use serde_json::Value;

use crate::program::{done, refused};

fn text(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).expect("the file was written")
}

/// The cells of the row of a table in Markdown that begins with `first`, behind the heading `heading`.
#[track_caller]
fn row(page: &str, heading: &str, first: &str) -> Vec<String> {
    let (_, rest) = page.split_once(&format!("{heading}\n")).unwrap_or_else(|| panic!("{heading}: {page}"));
    let row = rest.lines().find(|line| line.starts_with(&format!("| {first} |")));
    let row = row.unwrap_or_else(|| panic!("no row {first}: {rest}"));
    row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
}

#[track_caller]
fn near(cell: &str, expected: f64, digits: i32) {
    let found: f64 = cell.parse().unwrap_or_else(|_| panic!("{cell} is no number"));
    let allowed = 0.6 * 10f64.powf(expected.abs().log10().floor() - f64::from(digits - 1));
    assert!((found - expected).abs() <= allowed, "{found} instead of {expected}");
}

const PLANE: &str = "0.1,0.1,0.3; 0.8,0,0; 0,0.8,0; 0.2";

fn column(csv: &str, name: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let index = reader.headers().unwrap().iter().position(|head| head == name).expect("the column");
    reader.records().map(|record| record.unwrap()[index].parse().unwrap()).collect()
}

/// Mean, least, greatest.
fn figures(values: &[f64]) -> [f64; 3] {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    [mean, least, values.iter().copied().fold(0.0, f64::max)]
}

#[test]
fn planes_are_those_of_probe_and_surfaces_those_of_grid() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    done(folder, &["report", "empty-box", "--plane", PLANE, "-o", "box.md", "--report", "box.json", "-q"]);
    let page = text(folder, "box.md");
    let sensed = column(&done(folder, &["probe", "empty-box", "--plane", PLANE, "-q"])[0], "E_grey");
    let [mean, least, greatest] = figures(&sensed);
    let plane = row(&page, "## Planes of sensors", "plane-1");
    assert_eq!(plane[1], "16");
    for (cell, expected) in plane[2..5].iter().zip([mean, least, greatest]) {
        near(cell, expected, 4);
    }
    near(&plane[5], least / mean, 2);
    near(&plane[6], least / greatest, 2);
    let [cells, _] = done(folder, &["grid", "empty-box", "--cells", "8x8", "-q"]);
    // The cells of a square are alike; the floor is the first of six.
    let floor = row(&page, "## Surfaces", "floor");
    for (cell, expected) in floor[4..7].iter().zip(figures(&column(&cells, "E_grey")[..64])) {
        near(cell, expected, 4);
    }
    // A reflectance of a half absorbs a half of what arrives on 1 m².
    near(&floor[7], floor[4].parse().unwrap(), 3);
    near(&floor[8], 0.5 * floor[4].parse::<f64>().unwrap(), 3);
    let whole = row(&page, "## Surfaces", "all surfaces");
    assert_eq!((whole[3].as_str(), whole[9].as_str()), ("6", "1.000"));
    // The box is closed: what its ceiling emits is absorbed.
    assert!((whole[8].parse::<f64>().unwrap() - 1.0).abs() < 2e-3, "{whole:?}");
    let json: Value = serde_json::from_str(&text(folder, "box.json")).unwrap();
    assert_eq!(json["planes"][0]["mean"].as_f64().map(|x| (x - mean).abs() < 1e-12), Some(true));
}

#[test]
fn html_is_one_file_that_asks_for_no_other_and_is_the_same_every_time() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let args = ["report", "empty-box", "--plane", PLANE, "--size", "64x48", "-q", "-o", "box.html"];
    done(folder, &args);
    assert_eq!(names(folder), ["box.html"]);
    let page = text(folder, "box.html");
    let lower = page.to_lowercase();
    for address in ["http:", "https:", "//", "url(", "@import", "<script", "<link", "<iframe"] {
        // Two slashes are letters of base 64 as well.
        let found = lower
            .split("data:image/png;base64,")
            .map(|part| part.split_once('"').map_or(part, |(_, rest)| rest));
        assert!(found.skip(1).all(|part| !part.contains(address)), "{address}");
        assert!(!lower.split("data:image").next().unwrap().contains(address), "{address}");
    }
    assert_eq!(page.matches("<img ").count(), 2);
    assert_eq!(page.matches("src=\"data:image/png;base64,iVBORw0KGgo").count(), 2);
    assert!(
        page.contains(
            "<code>radiosity report empty-box --plane &#39;0.1,0.1,0.3; 0.8,0,0; 0,0.8,0; 0.2&#39; "
        )
    );
    done(folder, &args);
    assert_eq!(text(folder, "box.html"), page);
}

#[test]
fn pictures_of_markdown_stand_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    done(folder, &["report", "empty-box", "--plane", PLANE, "--size", "64x48", "-q", "-o", "my box.md"]);
    assert_eq!(names(folder), ["my box-picture.png", "my box-plane-1.png", "my box.md"]);
    let page = text(folder, "my box.md");
    assert!(page.contains("](my%20box-picture.png)") && page.contains("](my%20box-plane-1.png)"), "{page}");
    let picture = png::Decoder::new(std::io::BufReader::new(
        fs::File::open(folder.join("my box-picture.png")).unwrap(),
    ));
    assert_eq!(picture.read_info().unwrap().info().size(), (64, 48));
}

/// A lamp over a floor, with names that would be markup.
const ODD: &str = "
    title = \"A <b>bold</b> & 'odd' room\"
    bands = [\"lm\"]
    unit = \"lx\"
    [planes.\"a<b>|c\"]
    origin = [-0.4, -0.4, 0.5]
    edges = [[0.8, 0, 0], [0, 0.8, 0]]
    spacing = 0.4
    [materials.\"wood & <i>oil</i>\"]
    reflectance = 0.4
    [materials.lamp]
    reflectance = 0
    emission = 8000
    [[surfaces]]
    name = \"<script>alert(1)</script>\"
    material = \"wood & <i>oil</i>\"
    disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 2 }
    [[surfaces]]
    name = \"lamp_*1*\"
    material = \"lamp\"
    disk = { center = [0, 0, 1.5], normal = [0, 0, -1], radius = 0.2 }
";

#[test]
fn names_are_never_markup() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("odd.toml"), ODD).unwrap();
    done(folder, &["report", "odd.toml", "-o", "odd.html", "-q"]);
    let page = text(folder, "odd.html");
    assert!(page.contains("<title>A &lt;b&gt;bold&lt;/b&gt; &amp; &#39;odd&#39; room</title>"), "{page}");
    assert!(page.contains(
        "<td>&lt;script&gt;alert(1)&lt;/script&gt;</td><td>wood &amp; &lt;i&gt;oil&lt;/i&gt;</td>"
    ));
    assert!(page.contains("<td>a&lt;b&gt;|c</td>"));
    assert!(["<script", "<b>", "<i>"].iter().all(|tag| !page.contains(tag)));
    done(folder, &["report", "odd.toml", "-o", "odd.md", "-q"]);
    let page = text(folder, "odd.md");
    assert!(page.contains("| \\<script\\>alert(1)\\</script\\> | wood \\& \\<i\\>oil\\</i\\> |"), "{page}");
    assert!(page.contains("| lamp\\_\\*1\\* | lamp |") && page.contains("| a\\<b\\>\\|c |"), "{page}");
    assert!(page.contains("The scene has no camera"));
}

/// The floor, the lamp and the plane of a solution are those of its scene.
#[test]
fn a_solution_is_reported_as_its_scene_is() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("odd.toml"), ODD).unwrap();
    done(folder, &["solve", "odd.toml", "-o", "odd.json", "-q"]);
    done(folder, &["report", "odd.toml", "-o", "scene.md", "-q"]);
    done(folder, &["report", "odd.json", "-o", "solution.md", "-q"]);
    let table = |name: &str| {
        let page = text(folder, name);
        let light = page.split("## Settings").next().unwrap().to_owned();
        light.lines().filter(|line| line.starts_with('|')).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(table("scene.md"), table("solution.md"));
    assert!(table("scene.md").len() > 15);
    refused(folder, &["report", "odd.json", "--order", "2", "-o", "other.md"], &["--order", "odd.json"]);
}

#[test]
fn the_heat_of_the_oven_is_that_of_the_verb() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    done(folder, &["heat", "oven", "-o", "heat.json", "-q"]);
    done(folder, &["report", "oven", "-o", "oven.md", "--size", "64x48", "-q"]);
    let page = text(folder, "oven.md");
    let heat: Value = serde_json::from_str(&text(folder, "heat.json")).unwrap();
    for own in heat["surfaces"].as_array().unwrap() {
        let cells = row(&page, "## Radiant heat", own["name"].as_str().unwrap());
        near(&cells[3], own["temperature"].as_f64().unwrap(), 4);
        let flow = own["flow"].as_f64().unwrap();
        if flow != 0.0 {
            near(&cells[6], flow, 4);
        }
    }
    // Both surfaces with a temperature of their own.
    assert_eq!(row(&page, "## Radiant heat", "slab")[4], "given");
}

/// Two disks that face each other: with temperatures and no light, and with a temperature for one of them
/// alone.
#[test]
fn heat_without_light_is_reported_and_what_lacks_a_condition_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let disks = |emission: u32, condition: &str| {
        format!(
            "materials.hot = {{ reflectance = 0.1, emission = {emission}, emissivity = 0.9, temperature = 500 }}
             materials.cold = {{ reflectance = 0.1, emissivity = 0.9{condition} }}
             surfaces = [
                 {{ name = \"below\", material = \"hot\", disk = {{ center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }} }},
                 {{ name = \"above\", material = \"cold\", disk = {{ center = [0, 0, 1], normal = [0, 0, -1], radius = 1 }} }},
             ]"
        )
    };
    fs::write(folder.join("dark.toml"), disks(0, ", temperature = 300")).unwrap();
    done(folder, &["report", "dark.toml", "-o", "dark.md"]);
    let page = text(folder, "dark.md");
    assert_eq!(row(&page, "## Radiant heat", "above")[3], "300");
    assert!(!page.contains("## Surfaces") && !page.contains("## Checks"), "{page}");
    refused(
        folder,
        &["report", "dark.toml", "-o", "x.md", "--report", "r.json"],
        &["--report", "radiosity heat"],
    );
    fs::write(folder.join("half.toml"), disks(1, "")).unwrap();
    done(folder, &["report", "half.toml", "-o", "half.md"]);
    let page = text(folder, "half.md");
    assert!(page.contains("There is no balance of heat") && page.contains("above"), "{page}");
    fs::write(folder.join("half.toml"), disks(0, "")).unwrap();
    refused(folder, &["report", "half.toml", "-o", "x.md"], &["above"]);
}

#[test]
fn files_that_cannot_be_are_refused_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("odd.toml"), ODD).unwrap();
    refused(folder, &["report", "odd.toml", "-o", "odd.pdf"], &["odd.pdf: the ending", ".html", ".md"]);
    refused(folder, &["report", "odd.toml", "-o", "nowhere/odd.html"], &["cannot be written", "folder"]);
    refused(folder, &["report", "odd.toml", "-o", "a.html", "--report", "a.html"], &["the report as well"]);
    refused(folder, &["report", "odd.toml", "--plane", "desk", "-o", "a.html"], &["desk"]);
    // The place of a picture is a folder.
    fs::create_dir(folder.join("odd-plane-1.png")).unwrap();
    refused(folder, &["report", "odd.toml", "-o", "odd.md"], &["odd-plane-1.png", "it is a folder"]);
}
