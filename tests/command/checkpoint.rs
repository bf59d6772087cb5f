//! Runs that are recorded: killed at any time they go on, and what does not belong together is refused.

use radiosity_test_support::folders::{self, json, png};
use std::fs;
use std::path::Path;
#[cfg(unix)]
use std::{
    process::{Child, Command, Stdio},
    thread::sleep,
    time::Duration,
};

#[cfg(unix)]
use crate::program::command;
use crate::program::{done, radiosity, refused};

/// A room with a picture on its floor, a photometric file and a camera.
const ROOM: &str = r#"
bands = ["lm"]
unit = "lx"
camera = { eye = [3.8, 0.3, 1.6], target = [1.5, 3, 1], width = 16, height = 12 }
[materials.wall]
reflectance = 0.5
[materials.wood]
reflectance = { image = "wood.png" }
[[surfaces]]
name = "floor"
material = "wood"
parallelogram = { origin = [0, 0, 0], edge1 = [4, 0, 0], edge2 = [0, 4, 0] }
[[surfaces]]
name = "wall"
material = "wall"
parallelogram = { origin = [0, 4, 0], edge1 = [4, 0, 0], edge2 = [0, 0, 3] }
[[luminaires]]
name = "lamp"
position = [2, 2, 2.5]
aim = [0, 0, -1]
flux = 1000
photometry = "lamp.ies"
"#;

/// 100 cd straight down, so many at 90°, nothing above.
fn table(aside: u32) -> String {
    format!(
        "IESNA:LM-63-2002\n[TEST] 1\n[MANUFAC] none\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 {aside}\n"
    )
}

/// Numbers of pieces recalled and recorded, as a report has them.
fn checkpoint(report: &Path) -> [u64; 2] {
    let report = json(report);
    ["recalled", "recorded"].map(|key| report["checkpoint"][key].as_u64().expect("it is told"))
}

/// Pieces recalled and recorded, as the summary says.
fn told(summary: &str) -> [u64; 2] {
    told_of("checkpoint: ", summary)
}

/// Pieces recalled and recorded, as the line of the summary says that begins so.
fn told_of(begins: &str, summary: &str) -> [u64; 2] {
    let line = summary.lines().find_map(|line| line.strip_prefix(begins)).expect("it is told");
    let count =
        |word: &str| word.trim_start_matches(", ").split(' ').next().and_then(|count| count.parse().ok());
    let (recalled, rest) = line.split_once(" pieces recalled").expect("they are counted");
    [recalled, rest].map(|words| count(words).expect("a number"))
}

/// Two texels, of which the second is so bright.
fn picture(bright: u8) -> Vec<u8> {
    png([2, 1], png::ColorType::Grayscale, &[200, bright])
}

fn folder() -> tempfile::TempDir {
    let (table, picture) = (table(50), picture(20));
    let points = "1,1,1,0,0,1\n";
    let files = [("room.toml", ROOM), ("lamp.ies", &table), ("points.csv", points)]
        .map(|(name, text)| (name, text.as_bytes()));
    folders::folder(&[&files[..], &[("wood.png", &picture)]].concat())
}

const SOLVE: [&str; 7] = ["solve", "room.toml", "--order", "1", "-q", "-o", "a.json"];
const RECORD: [&str; 2] = ["--checkpoint", "kept"];
const RESUME: [&str; 3] = ["--checkpoint", "kept", "--resume"];

/// SOLVE with more options.
fn solve<'a>(more: &[&[&'a str]]) -> Vec<&'a str> {
    SOLVE.into_iter().chain(more.concat()).collect()
}

#[test]
fn a_folder_that_holds_something_else_is_refused() {
    let folder = folder();
    let folder = folder.path();
    refused(folder, &solve(&[&["--resume"]]), &["--checkpoint <FOLDER>"]);
    refused(
        folder,
        &["solve", "room.toml", "-o", "nowhere/a.json", "--checkpoint", "kept"],
        &["nowhere/a.json"],
    );
    assert!(!folder.join("kept").exists(), "nothing was recorded");
    done(folder, &solve(&[&RECORD]));
    refused(folder, &solve(&[&RECORD]), &["kept: a run was recorded here", "add --resume to go on"]);
    refused(
        folder,
        &solve(&[&["--checkpoint", "room.toml"]]),
        &["room.toml: this is no folder", "choose a folder"],
    );
    #[cfg(target_os = "linux")]
    refused(folder, &solve(&[&["--checkpoint", "/proc/self"]]), &["/proc/self", "that can be written to"]);
}

#[test]
fn what_an_earlier_version_recorded_is_refused_by_name() {
    let folder = folder();
    let folder = folder.path();
    // The header of the first format: eight bytes of its name, eight of the fingerprint of a run.
    fs::create_dir(folder.join("kept")).expect("it can be made");
    fs::write(folder.join("kept/000000-000000.journal"), b"RADJRNL1\x01\x02\x03\x04\x05\x06\x07\x08")
        .expect("it can be written");
    refused(
        folder,
        &solve(&[&RESUME]),
        &["000000.journal: this was recorded by an earlier version", "start anew in another folder"],
    );
    assert_eq!(fs::read_dir(folder.join("kept")).expect("it is there").count(), 1, "it is left as it was");
}

#[test]
fn a_run_of_another_scene_or_with_other_options_is_refused() {
    let folder = folder();
    let folder = folder.path();
    let aimed = ["--accuracy", "0.5", "--for", "points", "points.csv"];
    done(folder, &solve(&[&RECORD]));
    radiosity(folder, &solve(&[&aimed, &["--checkpoint", "aimed"]]));
    let other = ["this records a run of another scene, or with other options", "help: give the scene"];
    let refused = |args: &[&str]| refused(folder, args, &other);
    refused(&solve(&[&["--eps", "1e-2"], &RESUME]));
    refused(&[
        "probe",
        "room.toml",
        "--order",
        "1",
        "--points",
        "points.csv",
        "--checkpoint",
        "kept",
        "--resume",
    ]);
    let changes: [(&str, &dyn Fn()); 4] = [
        ("kept", &|| {
            fs::write(folder.join("room.toml"), ROOM.replace("0.5", "0.6")).expect("it can be written")
        }),
        ("kept", &|| fs::write(folder.join("lamp.ies"), table(60)).expect("it can be written")),
        ("kept", &|| fs::write(folder.join("wood.png"), picture(21)).expect("it can be written")),
        ("aimed", &|| fs::write(folder.join("points.csv"), "1,1,2,0,0,1\n").expect("it can be written")),
    ];
    for (kept, change) in changes {
        let more: &[&str] = if kept == "aimed" { &aimed } else { &[] };
        let resumed = solve(&[more, &["--checkpoint", kept, "--resume"]]);
        let message = radiosity(folder, &resumed).stderr;
        assert!(!String::from_utf8_lossy(&message).contains(other[0]), "nothing was changed yet");
        change();
        refused(&resumed);
        fs::write(folder.join("room.toml"), ROOM).expect("it can be written");
        fs::write(folder.join("lamp.ies"), table(50)).expect("it can be written");
        fs::write(folder.join("wood.png"), picture(20)).expect("it can be written");
    }
}

#[test]
fn means_and_names_may_change_and_nothing_is_done_twice() {
    let folder = folder();
    let folder = folder.path();
    done(folder, &solve(&[&RECORD, &["--report", "a.report.json"]]));
    let again = ["solve", "room.toml", "--order", "1", "-o", "b.json", "--threads", "1", "--memory", "1G"];
    done(folder, &[&again[..], &RESUME, &["--report", "b.report.json"]].concat());
    let [first, second] = ["a", "b"].map(|name| checkpoint(&folder.join(format!("{name}.report.json"))));
    assert!(first[0] == 0 && first[1] > 0, "{first:?}");
    assert_eq!(second, [first[1], 0]);
    let [first, second] =
        ["a.json", "b.json"].map(|name| fs::read(folder.join(name)).expect("it was written"));
    assert!(first == second);
}

#[test]
fn every_verb_recalls_all_that_it_recorded() {
    let folder = folder();
    let folder = folder.path();
    done(folder, &SOLVE);
    let verbs: [(&[&str], &str); 8] = [
        (&["render", "room.toml", "--order", "1", "-o"], "png"),
        (&["render", "a.json", "-o"], "exr"),
        (&["render", "room.toml", "--size", "32x32", "--order", "1", "-o"], "glb"),
        (&["probe", "a.json", "--plane", "0.5,0.5,1; 3,0,0; 0,3,0; 1", "-o"], "csv"),
        (&["grid", "room.toml", "--accuracy", "0.1", "--cells", "2x2", "-o"], "csv"),
        (&["report", "room.toml", "--order", "1", "--size", "16x12", "-o"], "html"),
        (&["view-factors", "oven", "-o"], "csv"),
        (&["heat", "oven", "-o"], "json"),
    ];
    for (index, (verb, ending)) in verbs.into_iter().enumerate() {
        let [first, second, kept] =
            [format!("whole-{index}.{ending}"), format!("again-{index}.{ending}"), format!("kept{index}")];
        let [_, summary] = done(folder, &[verb, &[&first, "--checkpoint", &kept]].concat());
        let recorded = told(&summary);
        assert!(recorded[0] == 0 && recorded[1] > 0, "{verb:?}: {recorded:?}");
        let [_, summary] = done(folder, &[verb, &[&second, "--checkpoint", &kept, "--resume"]].concat());
        assert_eq!(told(&summary), [recorded[1], 0], "{verb:?}");
        let [first, second] = [first, second].map(|name| {
            let bytes = fs::read(folder.join(&name)).expect("it was written");
            // A report names the file that it is, and a .glb the one beside it.
            String::from_utf8_lossy(&bytes).replace(&name[..6], "FILE")
        });
        assert!(first == second, "{verb:?}");
    }
}

/// Runs of a verb, with or without transfers in a file, write the same.
fn transfers_serve(folder: &Path, verb: &[&str], other: &[&str]) {
    let run = |more: &[&str], file: &str| {
        let [_, summary] = done(folder, &[verb, more, &["-o", file]].concat());
        (summary, fs::read_to_string(folder.join(file)).expect("it was written"))
    };
    let kept = ["--transfers", "kept.transfers"];
    let (summary, _) = run(&kept, "first.csv");
    let [recalled, recorded] = told_of("transfers: ", &summary);
    assert!(recalled == 0 && recorded > 0, "{verb:?}: {summary}");
    let (summary, found) = run(&[other, &kept].concat(), "second.csv");
    assert_eq!(told_of("transfers: ", &summary), [recorded, 0], "{verb:?}");
    assert!(found == run(other, "alone.csv").1, "{verb:?}");
    fs::remove_file(folder.join("kept.transfers")).expect("it was written");
}

#[test]
fn transfers_serve_other_materials_and_temperatures() {
    let folder = folder();
    let folder = folder.path();
    let heat = ["heat", "oven"];
    transfers_serve(folder, &heat, &["--set", "brick.emissivity=0.5", "--set", "panel.temperature=1300"]);
    transfers_serve(folder, &["grid", "cornell-box", "--order", "1", "--cells", "2x2"], &["--solver", "lu"]);
    transfers_serve(folder, &["view-factors", "oven"], &[]);
    done(folder, &["heat", "oven", "-q", "--transfers", "kept"]);
    // Other options are added, and all of them are found again.
    let coarse = ["heat", "oven", "--order", "1", "--transfers", "kept"];
    let [first, second] = [(); 2].map(|()| told_of("transfers: ", &done(folder, &coarse)[1]));
    assert!(first[1] > 0, "{first:?}");
    assert_eq!(second, [first[0] + first[1], 0]);
    refused(
        folder,
        &["view-factors", "room.toml", "--transfers", "kept"],
        &[
            "--transfers kept: these are no transfers between the surfaces",
            "choose a file that is not there yet",
        ],
    );
    refused(folder, &["heat", "oven", "--transfers", "lamp.ies"], &["lamp.ies: these are no transfers"]);
    refused(
        folder,
        &["heat", "oven", "--transfers", "nowhere/kept"],
        &["nowhere/kept", "in a folder that exists"],
    );
    refused(folder, &["heat", "oven", "--transfers", "kept", "--checkpoint", "run"], &["--checkpoint"]);
}

/// A run by rays that takes some seconds of one thread.
const RAYS: [&str; 7] = ["solve", "cornell-box", "--rays", "3000000", "--order", "1", "-q"];

/// RAYS with more options, on one thread, recorded; it is at work and has written some of it.
#[cfg(unix)]
fn at_work(folder: &Path, more: &[&str]) -> Child {
    let args = [&RAYS[..], &RECORD, &["--threads", "1"], more].concat();
    let mut run = command(folder, &args).stderr(Stdio::null()).spawn().expect("the binary runs");
    let file = folder.join("kept/000000-000000.journal");
    while fs::metadata(&file).map_or(0, |file| file.len()) < 1 << 16 {
        assert!(run.try_wait().expect("it is a child").is_none(), "it ended too soon");
        sleep(Duration::from_millis(5));
    }
    run
}

/// Asserts that RAYS goes on from what was recorded, does the rest, and leaves the same as if it had not been
/// ended.
#[cfg(unix)]
#[track_caller]
fn goes_on(folder: &Path) {
    done(folder, &[&RAYS[..], &RESUME, &["-o", "a.json", "--threads", "3", "--report", "r.json"]].concat());
    let [recalled, recorded] = checkpoint(&folder.join("r.json"));
    assert!(recalled > 0 && recorded > 0, "{recalled} {recorded}");
    done(folder, &[&RAYS[..], &["-o", "whole.json"]].concat());
    let [whole, resumed] = ["whole.json", "a.json"].map(|name| fs::read(folder.join(name)));
    assert!(whole.expect("it was written") == resumed.expect("it was written"));
}

#[test]
#[cfg(unix)]
fn a_killed_run_goes_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut run = at_work(folder.path(), &["-o", "a.json"]);
    run.kill().expect("it is a child");
    assert_eq!(run.wait().expect("it is a child").code(), None, "it was killed");
    assert!(!folder.path().join("a.json").exists());
    goes_on(folder.path());
}

#[test]
#[cfg(unix)]
fn a_run_that_ctrl_c_ended_with_fewer_rays_goes_on_to_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut run = at_work(folder.path(), &["-o", "part.json", "--keep-partial"]);
    let interrupt = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(interrupt.expect("kill runs").success());
    assert_eq!(run.wait().expect("it is a child").code(), Some(1), "it finished with what it had");
    assert!(folder.path().join("part.json").exists());
    goes_on(folder.path());
}
