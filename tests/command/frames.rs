//! `--frame`: the still scene of a frame in every verb, and what `check` tells of motions.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn radiosity(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_radiosity"));
    command.current_dir(folder).args(args).output().expect("the binary runs")
}

fn out(folder: &Path, args: &[&str]) -> String {
    let output = radiosity(folder, args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn refused(folder: &Path, args: &[&str]) -> String {
    let output = radiosity(folder, args);
    assert_eq!(output.status.code(), Some(2), "{args:?}");
    String::from_utf8(output.stderr).unwrap()
}

/// Two squares, one of which moves away from the other.
fn squares(height: f64, motion: &str) -> String {
    format!(
        "{}materials.white = {{ reflectance = 0.5, emission = 1 }}\n\
         camera = {{ eye = [0.5, -3, 0.5], target = [0.5, 0.5, 0.5] }}\n\
         [[surfaces]]\nname = \"floor\"\nmaterial = \"white\"\n\
         parallelogram = {{ origin = [0,0,0], edge1 = [1,0,0], edge2 = [0,1,0] }}\n\
         [[surfaces]]\nname = \"roof\"\nmaterial = \"white\"\n\
         parallelogram = {{ origin = [0,0,{height}], edge1 = [0,1,0], edge2 = [1,0,0] }}\n{motion}",
        if motion.is_empty() { "" } else { "frames = 5\n" }
    )
}

const UP: &str =
    "[[motion]]\nname = \"up\"\nsurfaces = \"roof\"\ntranslate = { points = [[0,0,0], [0,0,2]] }\n";

#[test]
fn a_frame_is_the_scene_that_is_typed_as_it_shows() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("moving.toml"), squares(1.0, UP)).unwrap();
    fs::write(folder.path().join("typed.toml"), squares(2.5, "")).unwrap();
    let factors = |scene: &str, more: &[&str]| {
        let text = out(folder.path(), &[&["view-factors", scene, "--pairs", "floor,roof"], more].concat());
        let last = text.lines().last().unwrap().rsplit(',').next().unwrap().to_owned();
        last.parse::<f64>().unwrap()
    };
    let typed = factors("typed.toml", &[]);
    assert!((factors("moving.toml", &["--frame", "3"]) - typed).abs() < 1e-14 * typed);
    // Parallel unit squares at the distance 1, at rest.
    assert!((factors("moving.toml", &[]) - 0.199_824_895_698_387).abs() < 1e-12);
    assert!(factors("moving.toml", &["--frame", "2.5"]) > typed);
}

#[test]
fn a_solution_keeps_its_frame() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("moving.toml"), squares(1.0, UP)).unwrap();
    out(folder.path(), &["solve", "moving.toml", "--frame", "3", "-o", "three.json"]);
    let grid = |more: &[&str]| out(folder.path(), &[&["grid", "--cells", "2x2"], more].concat());
    assert_eq!(grid(&["three.json"]), grid(&["moving.toml", "--frame", "3"]));
    assert!(grid(&["three.json"]) != grid(&["moving.toml"]));
    out(folder.path(), &["solve", "moving.toml", "--frame", "1.5"]);
    assert!(folder.path().join("moving-1.5.solution.json").exists());
    let message = refused(folder.path(), &["grid", "three.json", "--frame", "2"]);
    assert!(message.contains("--frame"), "{message}");
    let message = refused(folder.path(), &["convert", "moving.toml", "x.json", "--frame", "2"]);
    assert!(message.contains("a frame has no text of its own"), "{message}");
}

#[test]
fn frames_that_are_not_there_end_with_a_cure() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("moving.toml"), squares(1.0, UP)).unwrap();
    for frame in ["5", "-1", "4.5", "nan"] {
        let message = refused(folder.path(), &["check", "moving.toml", "--frame", frame]);
        assert!(
            message.contains("there is no frame") && message.contains("choose one from 0 to 4"),
            "{message}"
        );
    }
    let message = refused(folder.path(), &["solve", "cornell-box", "--frame", "0", "-o", "x.json"]);
    assert!(message.contains("yet nothing moves in the scene"), "{message}");
    assert!(!folder.path().join("x.json").exists());
}

#[test]
fn check_tells_of_motions_and_of_passages() {
    let folder = tempfile::tempdir().unwrap();
    let slab = "[[surfaces]]\nname = \"slab\"\nmaterial = \"white\"\n\
                parallelogram = { origin = [-1,-1,1.2], edge1 = [3,0,0], edge2 = [0,3,0.3] }\n";
    fs::write(folder.path().join("moving.toml"), squares(1.0, &format!("{slab}{UP}"))).unwrap();
    let text = out(folder.path(), &["check", "moving.toml"]);
    assert!(text.contains("frames: 5, 0 to 4\n") && text.contains("motion: up moves roof\n"), "{text}");
    // Over the roof the slab is from 1.3 to 1.4 high, and the roof is 1 and 1.5 high in frames 0 and 1.
    assert!(!text.contains("passes through"), "{text}");
    let tilted = slab.replace("[0,3,0.3]", "[0,3,0.6]");
    fs::write(folder.path().join("moving.toml"), squares(1.0, &format!("{tilted}{UP}"))).unwrap();
    let text = out(folder.path(), &["check", "moving.toml"]);
    // Over the roof the slab is from 1.4 to 1.6 high; the roof is 1.5 high in frame 1.
    let warned = "warning: surface \"roof\" passes through \"slab\" in frame";
    assert!(text.contains(warned), "{text}");
    let json: serde_json::Value =
        serde_json::from_str(&out(folder.path(), &["check", "moving.toml", "--format", "json"])).unwrap();
    assert_eq!(json["animation"]["frames"], 5);
    assert_eq!(json["animation"]["motions"][0]["surfaces"][0], "roof");
    assert_eq!(json["animation"]["passages"][0]["through"], "slab");
    // Each frame by itself is a still scene.
    let text = out(folder.path(), &["check", "moving.toml", "--frame", "0"]);
    assert!(!text.contains("frames:") && !text.contains("passes through"), "{text}");
}
