//! Scenes whose corners nearly agree: what the command tells of them, and that it keeps to it.

use radiosity_test_support::folders::folder;
use std::fs;

use crate::program::radiosity;

/// A room with a box whose feet hover over its floor by rounding, and a bottom that lies in it.
fn hovering(gap: f64) -> String {
    let polygon = |name: &str, corners: [[f64; 3]; 4]| {
        format!(
            "[[surfaces]]\nname = {name:?}\nmaterial = \"white\"\npolygon = {{ vertices = {corners:?} }}\n"
        )
    };
    let [low, high] = [gap, 0.5 + gap];
    let faces = [
        polygon("floor", [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]]),
        polygon("top", [[0.0, 0.0, high], [1.0, 0.0, high], [1.0, 1.0, high], [0.0, 1.0, high]]),
        polygon("south", [[0.0, 0.0, low], [1.0, 0.0, low], [1.0, 0.0, high], [0.0, 0.0, high]]),
        polygon("east", [[1.0, 0.0, low], [1.0, 1.0, low], [1.0, 1.0, high], [1.0, 0.0, high]]),
        polygon("north", [[1.0, 1.0, low], [0.0, 1.0, low], [0.0, 1.0, high], [1.0, 1.0, high]]),
        polygon("west", [[0.0, 1.0, low], [0.0, 0.0, low], [0.0, 0.0, high], [0.0, 1.0, high]]),
    ];
    format!("[materials.white]\nreflectance = 0.5\nemission = 1\n{}", faces.concat())
}

#[test]
fn what_was_welded_is_told_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let lines = |text: &str, arguments: &[&str]| {
        fs::write(folder.path().join("box.toml"), text).unwrap();
        let output = radiosity(folder.path(), &[&["check", "box.toml"], arguments].concat());
        assert!(output.status.success());
        let text = String::from_utf8(output.stdout).unwrap();
        text.lines()
            .filter(|line| line.starts_with("welded") || line.starts_with("set apart"))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let told = lines(&hovering(3e-7), &[]);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].starts_with("welded: ") && told[0].contains(" corners moved, by "), "{told:?}");
    assert_eq!(lines(&hovering(0.0), &[]), [""; 0]);
    assert_eq!(lines(&hovering(1e-4), &[]), [""; 0]);
    assert_eq!(lines(&hovering(3e-7), &["--tolerance-length", "0"]), [""; 0]);
    assert_eq!(lines(&hovering(1e-4), &["--tolerance-length", "1e-3"]).len(), 1);
    let refused = radiosity(folder.path(), &["check", "box.toml", "--tolerance-length", "-1"]);
    let message = String::from_utf8(refused.stderr).unwrap();
    assert!(refused.status.code() == Some(2) && message.contains("a length of 0 or more"), "{message}");
    // A bottom in the plane of the floor.
    let bottom = "[[surfaces]]\nname = \"bottom\"\nmaterial = \"white\"\n\
                  polygon = { vertices = [[0.0,0.0,0.0],[0.0,1.0,0.0],[1.0,1.0,0.0],[1.0,0.0,0.0]] }\n";
    assert_eq!(lines(&(hovering(0.0) + bottom), &[]), ["set apart: bottom lies on floor"]);
}

#[test]
fn a_solution_keeps_the_tolerance_it_was_read_with() {
    let folder = folder(&[("box.toml", hovering(1e-4))]);
    let solve = ["solve", "box.toml", "--tolerance-length", "1e-3", "-o", "box.json"];
    assert!(radiosity(folder.path(), &solve).status.success());
    let text = fs::read_to_string(folder.path().join("box.json")).unwrap();
    let tree: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(tree["scene"]["tolerance"], 1e-3);
    let grid = |scene: &str, more: &[&str]| {
        let output = radiosity(folder.path(), &[&["grid", scene, "--cells", "2x2", "-q"], more].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        output.stdout
    };
    assert_eq!(grid("box.json", &[]), grid("box.toml", &["--tolerance-length", "1e-3"]));
}

#[test]
fn points_far_from_the_origin_are_those_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let offset = [431_000.0, 5_412_000.0, 128.0];
    let moved = |text: &str| {
        let mut tree: toml::Table = text.parse().unwrap();
        for surface in tree["surfaces"].as_array_mut().unwrap() {
            for corner in surface["polygon"]["vertices"].as_array_mut().unwrap() {
                for (x, by) in corner.as_array_mut().unwrap().iter_mut().zip(offset) {
                    *x = toml::Value::Float(x.as_float().unwrap() + by);
                }
            }
        }
        toml::to_string(&tree).unwrap()
    };
    let near = hovering(0.0);
    let far = moved(&near);
    let probe = |text: &str, by: [f64; 3]| {
        fs::write(folder.path().join("box.toml"), text).unwrap();
        let point = [-1.0, -1.0, 0.0]
            .iter()
            .zip(by)
            .map(|(x, by)| (x + by).to_string())
            .collect::<Vec<_>>()
            .join(",");
        fs::write(folder.path().join("points.csv"), format!("x,y,z,nx,ny,nz\n{point},0,0,1\n")).unwrap();
        let output = radiosity(folder.path(), &["probe", "box.toml", "--points", "points.csv", "-q"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).unwrap();
        let row = text.lines().nth(1).unwrap().to_owned();
        assert!(row.starts_with(&point), "{row}");
        row.split(',').skip(6).map(str::to_owned).collect::<Vec<_>>()
    };
    let [a, b] = [probe(&near, [0.0; 3]), probe(&far, offset)];
    let [e, f] = [&a, &b].map(|row| row[0].parse::<f64>().unwrap());
    assert!((e / f - 1.0).abs() < 1e-9 && a[4] == b[4], "{a:?} {b:?}");
}
