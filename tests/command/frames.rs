//! `--frame`: the still scene of a frame in every verb, and what `check` tells of motions.

use radiosity_test_support::folders::folder;
use std::fs;

use crate::program::{done, refused};

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
    let folder = folder(&[("moving.toml", squares(1.0, UP)), ("typed.toml", squares(2.5, ""))]);
    let factors = |scene: &str, more: &[&str]| {
        let [text, _] =
            done(folder.path(), &[&["view-factors", scene, "--pairs", "floor,roof"], more].concat());
        let factor = text.lines().last().unwrap().split(',').nth(2).unwrap().to_owned();
        factor.parse::<f64>().unwrap()
    };
    let typed = factors("typed.toml", &[]);
    assert!((factors("moving.toml", &["--frame", "3"]) - typed).abs() < 1e-14 * typed);
    // Parallel unit squares at the distance 1, at rest.
    assert!((factors("moving.toml", &[]) - 0.199_824_895_698_387).abs() < 1e-12);
    assert!(factors("moving.toml", &["--frame", "2.5"]) > typed);
}

const FADES: &str =
    "[[motion]]\nname = \"fade\"\nsurfaces = [\"floor\", \"roof\"]\nemission = { factors = [1, 0] }\n";

#[test]
fn a_frame_of_dimmed_lamps_is_the_scene_of_their_emission() {
    let moving = squares(1.0, FADES);
    let folder = folder(&[
        ("moving.toml", moving.clone()),
        ("typed.toml", squares(1.0, "").replace("emission = 1", "emission = 0.25")),
        ("points.csv", "x,y,z,nx,ny,nz\n0.3,0.5,0,0,0,1\n".to_owned()),
    ]);
    let folder = folder.path();
    let grid = |more: &[&str]| done(folder, &[&["grid", "--cells", "2x2"], more].concat())[0].clone();
    assert_eq!(grid(&["moving.toml", "--frame", "3"]), grid(&["typed.toml"]));
    // In the dark there is no light, in tables, pictures and solutions.
    let dark = grid(&["moving.toml", "--frame", "4"]);
    let is_dark = |line: &str| line.split(',').skip(3).take(2).all(|light| light == "0");
    assert!(dark.lines().count() == 9 && dark.lines().skip(1).all(is_dark), "{dark}");
    done(folder, &["solve", "moving.toml", "--frame", "4", "-o", "dark.json"]);
    assert_eq!(grid(&["dark.json"]), dark);
    done(folder, &["render", "moving.toml", "--frame", "4", "--size", "8x6", "-o", "dark.png"]);
    for way in ["fresh", "selective", "path", "series"] {
        let frames = ["animate", "moving.toml", "--animation", way, "--probe", "points.csv"];
        let [table, _] = done(folder, &[&frames[..], &["--transport", "exact"]].concat());
        let light: Vec<f64> = table
            .lines()
            .skip(1)
            .map(|line| line.split(',').nth(8).unwrap().parse().expect("a number"))
            .collect();
        for (k, light_of_frame) in light.iter().enumerate() {
            let right = light[0] * (1.0 - 0.25 * k as f64);
            assert!((light_of_frame - right).abs() <= 1e-9 * light[0], "{way} {k}: {light:?}");
        }
        assert_eq!(light[4], 0.0, "{way}");
    }
    done(folder, &["animate", "moving.toml", "--frames", "3..4", "--size", "8x6", "-o", "f-#.png"]);
    let [text, _] = done(folder, &["check", "moving.toml"]);
    assert!(text.contains("motion: fade dims floor, roof\n"), "{text}");
    let json: serde_json::Value =
        serde_json::from_str(&done(folder, &["check", "moving.toml", "--format", "json"])[0]).unwrap();
    assert_eq!(json["animation"]["motions"][0]["dims"], true);
    assert_eq!(json["animation"]["motions"][0]["moves"], false);
    let [_, told] = done(folder, &["convert", "moving.toml", "x.obj"]);
    assert!(told.contains("emission over time is left out"), "{told}");
    fs::write(folder.join("moving.toml"), moving.replace("factors = [1, 0]", "factors = [1, -1]")).unwrap();
    refused(folder, &["check", "moving.toml"], &["the factor is -1", "moving.toml:", "factor ≥ 0"]);
}

#[test]
fn a_solution_keeps_its_frame() {
    let folder = folder(&[("moving.toml", squares(1.0, UP))]);
    done(folder.path(), &["solve", "moving.toml", "--frame", "3", "-o", "three.json"]);
    let grid = |more: &[&str]| done(folder.path(), &[&["grid", "--cells", "2x2"], more].concat())[0].clone();
    assert_eq!(grid(&["three.json"]), grid(&["moving.toml", "--frame", "3"]));
    assert!(grid(&["three.json"]) != grid(&["moving.toml"]));
    done(folder.path(), &["solve", "moving.toml", "--frame", "1.5"]);
    assert!(folder.path().join("moving-1.5.solution.json").exists());
    refused(folder.path(), &["grid", "three.json", "--frame", "2"], &["--frame"]);
    refused(
        folder.path(),
        &["convert", "moving.toml", "x.json", "--frame", "2"],
        &["a frame has no text of its own"],
    );
}

#[test]
fn frames_that_are_not_there_end_with_a_cure() {
    let folder = folder(&[("moving.toml", squares(1.0, UP))]);
    for frame in ["5", "-1", "4.5", "nan"] {
        let parts = ["there is no frame", "choose one from 0 to 4"];
        refused(folder.path(), &["check", "moving.toml", "--frame", frame], &parts);
    }
    refused(
        folder.path(),
        &["solve", "cornell-box", "--frame", "0", "-o", "x.json"],
        &["yet nothing moves in the scene"],
    );
}

#[test]
fn check_tells_of_motions_and_of_passages() {
    let folder = tempfile::tempdir().unwrap();
    let slab = "[[surfaces]]\nname = \"slab\"\nmaterial = \"white\"\n\
                parallelogram = { origin = [-1,-1,1.2], edge1 = [3,0,0], edge2 = [0,3,0.3] }\n";
    fs::write(folder.path().join("moving.toml"), squares(1.0, &format!("{slab}{UP}"))).unwrap();
    let [text, _] = done(folder.path(), &["check", "moving.toml"]);
    assert!(text.contains("frames: 5, 0 to 4\n") && text.contains("motion: up moves roof\n"), "{text}");
    // Over the roof the slab is from 1.3 to 1.4 high, and the roof is 1 and 1.5 high in frames 0 and 1.
    let warned =
        "warning: surface \"roof\" passes through \"slab\" between frames 0 and 1: lead its path past that";
    assert!(text.contains(warned), "{text}");
    let tilted = slab.replace("[0,3,0.3]", "[0,3,0.6]");
    fs::write(folder.path().join("moving.toml"), squares(1.0, &format!("{tilted}{UP}"))).unwrap();
    let [text, _] = done(folder.path(), &["check", "moving.toml"]);
    // Over the roof the slab is from 1.4 to 1.6 high; the roof is 1.5 high in frame 1.
    let warned = "warning: surface \"roof\" passes through \"slab\" in frame";
    assert!(text.contains(warned), "{text}");
    let json: serde_json::Value =
        serde_json::from_str(&done(folder.path(), &["check", "moving.toml", "--format", "json"])[0]).unwrap();
    assert_eq!(json["animation"]["frames"], 5);
    assert_eq!(json["animation"]["motions"][0]["surfaces"][0], "roof");
    assert_eq!(json["animation"]["passages"][0]["through"], "slab");
    assert_eq!(json["animation"]["passages"][0]["frames"], serde_json::json!([1]));
    // Each frame by itself is a still scene.
    let [text, _] = done(folder.path(), &["check", "moving.toml", "--frame", "0"]);
    assert!(!text.contains("frames:") && !text.contains("passes through"), "{text}");
}
