//! Behaviour that users may rely on beside the numbers: exit codes, interruption, partial results, messages.

use std::{fs, path::Path, process::Command};

use radiosity::work::ranks::Ranks;
use radiosity::{elements::Discretization, solve::driver::memory_estimate::MemoryEstimate};
use radiosity_solvers::method::Method;
use radiosity_test_support::data::number;
use radiosity_test_support::folders::{folder, json, names};
use radiosity_test_support::scenes::builtin;
use serde_json::Value;

use crate::program::{self, command, done, radiosity};

#[test]
#[cfg(unix)]
fn ctrl_c_stops_within_a_second_and_leaves_nothing() {
    use std::{process::Stdio, thread::sleep, time::Duration, time::Instant};
    let folder = tempfile::tempdir().unwrap();
    let args = ["render", "cornell-box", "--order", "12", "--subdivide", "4", "--report", "r.json"];
    let mut child = command(folder.path(), &args).stderr(Stdio::piped()).spawn().unwrap();
    // Long enough to be at work, and nowhere near its end.
    sleep(Duration::from_millis(500));
    assert!(child.try_wait().unwrap().is_none(), "it is at work");
    let sent = Instant::now();
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
    let status = child.wait().unwrap();
    assert!(sent.elapsed() < Duration::from_secs(1), "{:?}", sent.elapsed());
    assert_eq!(status.code(), Some(130));
    assert_eq!(names(folder.path()), Vec::<String>::new());
}

#[test]
#[cfg(unix)]
fn ctrl_c_leaves_what_the_rays_told_so_far_where_that_is_asked_for() {
    use std::{process::Stdio, thread::sleep, time::Duration};
    let folder = tempfile::tempdir().unwrap();
    let endless = ["solve", "cornell-box", "--rays", "4000000000", "--keep-partial", "-o", "s.json"];
    let run = command(folder.path(), &endless).stderr(Stdio::piped()).spawn().unwrap();
    sleep(Duration::from_secs(3));
    assert!(Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap().success());
    let output = run.wait_with_output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    for part in ["finishing with the rays sent so far", "wrote s.json", "of 400", "rays leave an error of"] {
        assert!(message.contains(part), "{part:?} is missing in:\n{message}");
    }
    done(folder.path(), &["grid", "s.json", "--cells", "1x1", "--read", "basis"]);
}

#[test]
#[cfg(not(feature = "mpi"))]
fn without_mpi_several_processes_are_refused_by_the_first() {
    let folder = tempfile::tempdir().unwrap();
    let started = |number: &str, count: &str| {
        let variables = [("OMPI_COMM_WORLD_RANK", number), ("OMPI_COMM_WORLD_SIZE", count)];
        command(folder.path(), &["scenes"]).envs(variables).output().unwrap()
    };
    let [first, second] = ["0", "1"].map(|number| started(number, "2"));
    let message = String::from_utf8_lossy(&first.stderr);
    assert!(message.starts_with("error: ") && message.contains("--features mpi"), "{message}");
    assert!(second.stderr.is_empty(), "the message is said once");
    for refused in [first, second] {
        assert_eq!(refused.status.code(), Some(2));
        assert!(refused.stdout.is_empty());
    }
    assert!(started("0", "1").status.success(), "one process is one process, whoever starts it");
}

#[test]
fn a_solver_that_does_not_converge_writes_only_what_it_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let short = ["solve", "empty-box", "--order", "1", "--solver", "jacobi", "--max-iterations", "2"];
    let output = radiosity(here, &short);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.contains("left a relative residual of") && message.contains("--keep-partial"),
        "{message}"
    );
    assert_eq!(names(here), Vec::<String>::new());

    let output =
        radiosity(here, &[&short[..], &["--keep-partial", "--report", "r.json", "-o", "s.json"]].concat());
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("error: s.json: the solver did not converge"), "{message}");
    for [converged, residual] in [
        [&json(&here.join("r.json"))["converged"], &json(&here.join("r.json"))["residual"]],
        [
            &json(&here.join("s.json"))["figures"]["converged"],
            &json(&here.join("s.json"))["figures"]["residual"],
        ],
    ] {
        assert_eq!(*converged, Value::Bool(false));
        assert!(residual.as_f64().unwrap() > 1e-8);
    }
    // It can be looked at as it is.
    let output = radiosity(here, &["grid", "s.json", "--cells", "1x1", "--report", "again.json"]);
    assert!(output.status.success());
    let again = json(&here.join("again.json"));
    assert_eq!(again["converged"], Value::Bool(false));
    assert_eq!(codes(&again), ["not-converged"]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("warning: the solver did not converge"));
    // It is no truth to hold others against.
    let output = radiosity(here, &["convergence", "empty-box", "--reference", "s.json"]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        message.contains("s.json: its solver did not converge") && message.contains("help:"),
        "{message}"
    );
}

/// The codes of a report's warnings.
fn codes(report: &Value) -> Vec<&str> {
    report["warnings"].as_array().unwrap().iter().map(|warning| warning["code"].as_str().unwrap()).collect()
}

#[test]
fn a_reader_who_leaves_early_costs_no_file() {
    use std::process::Stdio;
    let cases: [(&[&str], &str); 3] = [
        (&["grid", "furnace-cube", "--order", "0", "--read", "basis", "--report", "a.json"], "a.json"),
        (&["probe", "furnace-cube", "--order", "0", "--points", "p.csv", "--report", "b.json"], "b.json"),
        (&["convergence", "furnace-cube", "--max-order", "1", "-o", "c.svg"], "c.svg"),
    ];
    let folder = folder(&[("p.csv", "0.5,0.5,0,0,0,1\n")]);
    for (args, file) in cases {
        let mut child =
            command(folder.path(), args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(folder.path().join(file).exists(), "{file} is missing");
    }
}

/// Refused with all of `parts`, one of them a cure.
#[track_caller]
fn refused(folder: &Path, args: &[&str], parts: &[&str]) {
    program::refused(folder, args, &[parts, &["help: "]].concat());
}

#[test]
fn outputs_take_the_place_of_nothing_else_asked_for_or_read() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let text = radiosity::language::source("furnace-cube", &[]).unwrap().text().into_owned();
    fs::write(here.join("room.toml"), text.as_bytes()).unwrap();
    refused(
        here,
        &["solve", "room.toml", "-o", "r.json", "--report", "./r.json"],
        &["r.json: this is the file of the report"],
    );
    refused(here, &["solve", "room.toml", "-o", "room.toml"], &["room.toml: this is the file of the scene"]);
    refused(
        here,
        &["grid", "room.toml", "--report", "./room.toml"],
        &["room.toml: this is the file of the scene"],
    );
    fs::write(here.join("p.csv"), "0.5,0.5,0,0,0,1\n").unwrap();
    for option in ["-o", "--report"] {
        let args = ["probe", "room.toml", "--points", "p.csv", option, "p.csv"];
        refused(here, &args, &["p.csv: this is the file of the points"]);
    }
    refused(here, &["grid", "room.toml", "-o", "-"], &["-: an output needs a name", "standard output"]);
    assert_eq!(fs::read_to_string(here.join("room.toml")).unwrap(), &*text);
}

#[test]
fn the_ending_of_a_table_is_its_form() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let grid = ["grid", "furnace-cube", "--order", "0", "--cells", "1x1", "--read", "basis"];
    let with = |more: &[&'static str]| [&grid[..], more].concat();
    assert!(radiosity(here, &with(&["-o", "cells.JSON"])).status.success());
    assert_eq!(json(&here.join("cells.JSON"))["cells"].as_array().map(Vec::len), Some(6));
    assert!(radiosity(here, &with(&["-o", "cells.txt", "--format", "csv"])).status.success());
    assert!(fs::read_to_string(here.join("cells.txt")).unwrap().starts_with("surface,i,j,"));
    refused(
        here,
        &with(&["-o", "x.csv", "--format", "json"]),
        &["x.csv: --format json and the ending disagree"],
    );
    refused(here, &with(&["-o", "x.txt"]), &["x.txt: the ending names no format", ".csv or .json"]);
}

#[test]
fn solutions_are_told_from_scenes_and_keep_what_was_wanted() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let args = ["solve", "furnace-cube", "--accuracy", "1e-3", "-o", "s.json", "--report", "r.json"];
    assert!(radiosity(here, &args).status.success());
    for verb in ["check", "view-factors", "convergence"] {
        refused(here, &[verb, "s.json"], &["s.json: this is a solution already", "give it to render"]);
    }
    let read =
        radiosity(here, &["grid", "s.json", "--cells", "1x1", "--read", "basis", "--report", "again.json"]);
    assert!(read.status.success());
    let [told, again] = ["r.json", "again.json"].map(|file| json(&here.join(file)));
    assert!(told["accuracy_estimate"].is_f64());
    assert_eq!(told["accuracy_estimate"], again["accuracy_estimate"]);
    assert_eq!(told["warnings"], again["warnings"]);
}

#[test]
fn a_wanted_accuracy_that_memory_forbids_keeps_the_best_run() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let how = Discretization::uniform(3, 1);
    let scene = builtin("empty-box");
    let peak =
        MemoryEstimate::of(&scene, &how, Method::named("auto").unwrap(), Ranks::alone()).peak().to_string();
    let args =
        ["solve", "empty-box", "--accuracy", "1e-6", "--subdivide", "1", "--report", "r.json", "--memory"];
    let output = radiosity(here, &[&args[..], &[&peak]].concat());
    assert_eq!(output.status.code(), Some(3), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(here.join("empty-box.solution.json").exists());
    let report = json(&here.join("r.json"));
    assert_eq!(codes(&report), ["accuracy-not-reached"]);
    assert!(report["warnings"][0]["message"].as_str().unwrap().contains("does not fit into memory"));
    // Of what fits no run, nothing is proposed.
    let args = ["solve", "empty-box", "--order", "0", "--memory", "1k"];
    refused(here, &args, &["no lower order and no other solver would fit", "help: allow more with --memory"]);
    let args = ["solve", "empty-box", "--layers", "8", "--ratio", "0.01"];
    refused(here, &args, &["8 layers of ratio 0.01", "help: take fewer --layers"]);
}

#[test]
fn numbers_of_what_is_not_asked_for_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let idle = [
        (
            ["--ratio", "0.3"],
            "--ratio does nothing without --layers",
            "help: add --layers, or leave --ratio out",
        ),
        (
            ["--mask-cells", "9"],
            "--mask-cells does nothing without --shadows mask",
            "help: add --shadows mask, or leave --mask-cells out",
        ),
        (
            ["--mask-average", "plain"],
            "--mask-average does nothing without --shadows mask",
            "help: add --shadows mask",
        ),
        (
            ["--link-measure", "form-factor"],
            "--link-measure does nothing without --method hierarchical",
            "help: add --method hierarchical, or leave --link-measure out",
        ),
        (
            ["--link-rays", "9"],
            "--link-rays does nothing without --method hierarchical",
            "help: add --method hierarchical",
        ),
        (
            ["--least-area", "1e-3"],
            "--least-area does nothing without --method hierarchical",
            "help: add --method hierarchical",
        ),
    ];
    for (option, message, cure) in idle {
        refused(here, &[&["solve", "empty-box"], &option[..]].concat(), &[message, cure]);
    }
}

#[test]
fn a_wanted_accuracy_that_takes_too_long_keeps_the_best_run() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let late = |rest: &[&str]| {
        let args = ["--accuracy", "1e-4", "--time-limit", "1e-6", "-q", "--report", "r.json"];
        let output = radiosity(here, &[rest, &args].concat());
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(3), "{message}");
        assert!(message.contains("the estimated error is") && message.contains("was written"), "{message}");
        let report = json(&here.join("r.json"));
        let text = report["warnings"][0]["message"].as_str().unwrap().to_owned();
        assert!(text.contains("longer than allowed") && text.contains("--time-limit"), "{text}");
        assert!(report["accuracy_estimate"].as_f64().unwrap() > 1e-4);
    };
    late(&["solve", "empty-box", "-o", "s.json"]);
    late(&["solve", "cornell-box", "--transport", "sampled", "-o", "s.json"]);
    late(&["grid", "empty-box", "--cells", "1x1", "-o", "cells.csv"]);
    // What was not reached is told again where the file is read, which itself succeeds.
    let read = radiosity(here, &["grid", "s.json", "--cells", "1x1", "--read", "basis", "-o", "again.csv"]);
    assert!(read.status.success() && String::from_utf8_lossy(&read.stderr).contains("longer than allowed"));
    for name in ["cells.csv", "again.csv"] {
        assert!(here.join(name).exists(), "{name}");
    }
    let args = ["grid", "empty-box", "--accuracy", "1e-2", "--read", "basis"];
    refused(here, &args, &["--accuracy is that of gathered light", "help: add --for solution"]);
    let args = ["solve", "empty-box", "--accuracy", "0.1", "--time-limit", "0"];
    let output = radiosity(here, &args);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("expected seconds, above 0, such as 30"));
}

#[test]
fn an_accuracy_may_be_that_of_points_a_plane_or_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::write(here.join("points.csv"), "0.5,0.5,0.5,0,0,1\n").unwrap();
    let aims: [&[&str]; 4] = [
        &["--for", "points", "points.csv", "empty-box"],
        &["empty-box", "--for", "plane=0.2,0.2,0.7; 0.6,0,0; 0,0.6,0; 0.2"],
        &["empty-box", "--for", "picture"],
        &["--for", "points=points.csv", "empty-box"],
    ];
    for aim in aims {
        let output = radiosity(here, &[&["solve", "--accuracy", "1e-2", "-o", "s.json"], aim].concat());
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let of = if aim.contains(&"picture") { "light in the picture" } else { "light at the points" };
        assert!(output.status.success() && text.contains(&format!("error of {of}")), "{aim:?}: {text}");
    }
    let probed = radiosity(here, &["probe", "empty-box", "--points", "points.csv", "--accuracy", "1e-2"]);
    assert!(String::from_utf8_lossy(&probed.stderr).contains("error of light at the points"));
    let args = ["solve", "empty-box", "--accuracy", "1e-2", "--for", "points", "none.csv"];
    refused(here, &args, &["none.csv", "help: give the path of a CSV file of points"]);
    let args = ["solve", "empty-box", "--accuracy", "1e-2", "--for", "plane", "desk"];
    refused(here, &args, &["desk", "help:"]);
    let scene = "bands = [\"grey\"]\n[materials.lamp]\nreflectance = 0\nemission = 1\n[[surfaces]]\nname = \"lamp\"\n\
                 material = \"lamp\"\nquad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }\n";
    fs::write(here.join("dark.toml"), scene).unwrap();
    let args = ["solve", "dark.toml", "--accuracy", "1e-2", "--for", "picture"];
    refused(here, &args, &["there is no camera", "help: add [camera]"]);
    let away = format!("camera = {{ eye = [0, 0, 1], target = [0, 0, 2], up = [0, 1, 0] }}\n{scene}");
    fs::write(here.join("dark.toml"), away).unwrap();
    refused(here, &args, &["the camera sees no front", "help: turn the camera"]);
    let output = radiosity(here, &["solve", "empty-box", "--accuracy", "1e-2", "--for", "all"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("points FILE or plane NAME"));
}

#[test]
fn hierarchical_radiosity_is_a_method_that_every_verb_reads() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let args = ["solve", "two-boxes", "--method", "hierarchical", "-o", "s.json", "--report", "r.json"];
    let solved = radiosity(here, &args);
    let text = String::from_utf8_lossy(&solved.stderr).into_owned();
    assert!(
        solved.status.success() && text.contains("order 0") && text.contains(" links between "),
        "{text}"
    );
    let report = json(&here.join("r.json"));
    assert_eq!(report["transport"]["kind"], "hierarchical");
    assert!(report["transport"]["links"]["links"].as_u64().unwrap() > 100);
    let read = radiosity(here, &["grid", "s.json", "--cells", "2x2", "--read", "basis"]);
    assert!(read.status.success(), "{}", String::from_utf8_lossy(&read.stderr));
    for (option, value) in [("--rays", "100"), ("--order", "2"), ("--layers", "1"), ("--transport", "exact")]
    {
        let args = ["solve", "two-boxes", "--method", "hierarchical", option, value];
        refused(here, &args, &[&format!("knows no {option}"), "help: leave --"]);
    }
}

/// Refine(Fe, Ae) of 1991: faces of at most a part of the area are not cut, whatever their form factors; and
/// each link costs the rays that are asked for.
#[test]
fn links_have_the_least_area_measure_and_rays_that_are_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let links = |options: &[&str]| {
        let args = ["solve", "empty-box", "--method", "hierarchical", "--link-measure", "form-factor"];
        assert!(radiosity(here, &[&args[..], options, &["--report", "r.json"]].concat()).status.success());
        let report = json(&here.join("r.json"));
        let links = report["transport"]["links"]["links"].as_u64().unwrap();
        (report["elements"].as_u64().unwrap(), links, report["shadow_rays"].as_u64().unwrap())
    };
    // Six squares, each a sixth of the area, between each other's edges: all are cut until they are small.
    let [coarse, fine] = ["2e-2", "5e-3"].map(|area| links(&["--eps", "1e-2", "--least-area", area]));
    assert_eq!((coarse.0, fine.0), (6 * 16, 6 * 64), "cells of 1/96 and 1/384 of the area");
    // No form factor is above 1.
    assert_eq!(links(&["--eps", "0.999", "--link-rays", "7"]), (6, 15, 105));
}

#[test]
fn a_report_has_every_key_and_they_agree() {
    let folder = tempfile::tempdir().unwrap();
    let args =
        ["grid", "cornell-box", "--order", "1", "--cells", "1x1", "--report", "r.json", "--threads", "2"];
    assert!(radiosity(folder.path(), &args).status.success());
    let report = json(&folder.path().join("r.json"));
    for key in "scene bands surfaces elements unknowns order solver threads version seconds peak_bytes pairs \
                kernel_samples kernel_samples_distinct shadow_rays iterations residual converged checks warnings"
        .split_whitespace()
    {
        assert!(report.get(key).is_some(), "{key} is missing");
    }
    for key in "load elements blocks visibility solve output total".split_whitespace() {
        assert!(report["seconds"][key].as_f64().unwrap() >= 0.0, "{key}");
    }
    for key in "closure_max row_sum_min row_sum_max energy_in energy_absorbed energy_lost \
                spectral_bound seam_jump_max"
        .split_whitespace()
    {
        assert!(report["checks"][key].is_f64(), "{key}");
    }
    let pairs = |key: &str| report["pairs"][key].as_u64().unwrap_or_else(|| panic!("{key} is missing"));
    let skipped = ["skipped_behind", "skipped_coplanar", "skipped_hidden", "skipped_black"].map(pairs);
    let taken = ["same", "edge", "vertex", "contact", "split", "separated", "contour"].map(pairs);
    assert_eq!(pairs("total"), skipped.iter().chain(&taken).sum::<u64>());
    let elements = report["elements"].as_u64().unwrap();
    assert_eq!(pairs("total"), elements * (elements - 1) / 2 + pairs("same"));
    // Shadows of blocks are outlines, on the bent wall as well.
    assert!(pairs("partly_hidden") > 0 && report["shadow_rays"].as_u64() == Some(0));
    assert_eq!((&report["threads"], &report["order"]), (&2.into(), &1.into()));
    assert_eq!(report["unknowns"].as_u64().unwrap(), 3 * elements);
}

#[test]
fn messages_have_no_colours_and_no_bar_without_a_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let output = radiosity(folder.path(), &["solve", "furnace-cube", "--order", "0", "-v"]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(!message.contains('\u{1b}') && !message.contains('\r'), "{message:?}");
    let stages: Vec<&str> = message.lines().take(6).map(|line| line.split(':').next().unwrap()).collect();
    assert_eq!(stages, ["visibility", "elements", "direct", "blocks", "solve", "self-checks"]);
    let quiet = radiosity(folder.path(), &["solve", "furnace-cube", "--order", "0", "--quiet"]);
    assert!(quiet.status.success() && quiet.stderr.is_empty() && quiet.stdout.is_empty());
}

#[test]
fn every_verb_shows_an_example() {
    let folder = tempfile::tempdir().unwrap();
    let help = radiosity(folder.path(), &["help"]);
    let text = String::from_utf8(help.stdout).unwrap();
    let bare = radiosity(folder.path(), &[]);
    assert_eq!(bare.status.code(), Some(2));
    assert_eq!(String::from_utf8(bare.stderr).unwrap(), text, "without a verb the help is shown");
    let (_, verbs) = text.split_once("Commands:\n").unwrap();
    let verbs = verbs.lines().take_while(|line| !line.trim().is_empty());
    // Lines that go on are indented further.
    let verbs = verbs.filter(|line| !line.starts_with("   "));
    let verbs: Vec<&str> = verbs.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(verbs.len() > 5, "{verbs:?}");
    for verb in verbs.into_iter().filter(|verb| *verb != "help") {
        let help = radiosity(folder.path(), &[verb, "--help"]);
        let text = String::from_utf8(help.stdout).unwrap();
        assert!(text.contains("Example") && text.contains(&format!("radiosity {verb}")), "{verb}: {text}");
    }
}

#[test]
fn completions_name_the_verbs() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = radiosity(folder.path(), &["completions", shell]);
        let script = String::from_utf8(output.stdout).unwrap();
        assert!(
            output.status.success() && script.contains("render") && script.contains("keep-partial"),
            "{shell}"
        );
    }
}

#[test]
fn shots_are_counted_with_the_columns_that_were_integrated() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let few = ["render", "empty-box", "--order", "1", "--size", "8x8", "--shots", "2"];
    let run = radiosity(here, &[&few[..], &["--ambient", "--report", "r.json", "-o", "p.png"]].concat());
    let message = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{message}");
    assert!(message.contains("2 shots leave") && message.contains("2 of 6 columns integrated"), "{message}");
    assert!(message.contains("for which an ambient term stands"), "{message}");
    let report = json(&here.join("r.json"));
    assert_eq!((&report["shots"]["count"], &report["shots"]["columns"]), (&2.into(), &2.into()));
    assert_eq!(report["shots"]["history"].as_array().unwrap().len(), 3);
    assert_eq!(report["warnings"][0]["code"], "shots", "the light is partial");
    assert_eq!(report["warnings"].as_array().unwrap().len(), 1);
    let all = ["solve", "empty-box", "--order", "1", "--solver", "southwell", "--columns", "all"];
    let run = radiosity(here, &all);
    let message = String::from_utf8_lossy(&run.stderr);
    assert!(
        message.contains("all 6 columns integrated before the first shot: that was asked for"),
        "{message}"
    );
}

#[test]
fn errors_are_drawn_against_shots_and_time() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["convergence", "empty-box", "--max-order", "1", "--shots", "8", "--format", "csv"];
    let run = radiosity(folder.path(), &args);
    let table = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let place = |name: &str| rows[0].iter().position(|own| *own == name).unwrap();
    let column = |way: &str, name: &str| -> Vec<f64> {
        let own = rows.iter().filter(|row| row[place("way")] == way);
        own.map(|row| row[place(name)].parse().unwrap()).collect()
    };
    for way in ["shots", "shots-of-all"] {
        assert_eq!(column(way, "shots"), [0.0, 1.0, 2.0, 4.0, 8.0]);
        assert!(column(way, "error").is_sorted_by(|a, b| a > b), "{table}");
    }
    assert_eq!(column("shots", "columns"), [0.0, 1.0, 2.0, 4.0, 6.0]);
    assert_eq!(column("shots-of-all", "columns"), [6.0; 5]);
    assert_eq!(column("shots", "error"), column("shots-of-all", "error"));
    let drawing = fs::read_to_string(folder.path().join("empty-box.svg")).unwrap();
    assert!(drawing.contains(">shots<") && drawing.contains("time, s"), "{drawing}");
}

#[test]
fn progressive_and_shooting_name_southwell() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["southwell", "progressive", "shooting"] {
        let args = ["solve", "empty-box", "--order", "1", "--solver", name, "--report", "r.json"];
        let output = radiosity(folder.path(), &args);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(json(&folder.path().join("r.json"))["solver"], "southwell", "{name}");
    }
}

/// Bytes of memory that the file of a run tells, and those foretold for the same scene, cuts and solver.
fn peak_and_estimate(order: usize, subdivide: usize, solver: &str) -> [f64; 2] {
    let folder = tempfile::tempdir().unwrap();
    let (degree, parts) = (order.to_string(), subdivide.to_string());
    let args = ["solve", "empty-box", "--order", &degree, "--subdivide", &parts, "--solver", solver];
    let output = radiosity(folder.path(), &[&args[..], &["--eps", "0.1", "--report", "r.json"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let scene = builtin("empty-box");
    let how = Discretization::uniform(order, subdivide);
    let estimate = MemoryEstimate::of(&scene, &how, Method::named(solver).unwrap(), Ranks::alone()).peak();
    [json(&folder.path().join("r.json"))["peak_bytes"].as_f64().unwrap(), estimate as f64]
}

#[test]
#[cfg(target_os = "linux")]
fn memory_is_foretold_within_a_factor_of_two() {
    for (order, subdivide, solver) in [(6, 4, "cg"), (6, 4, "cholesky"), (0, 4, "auto")] {
        let [peak, estimate] = peak_and_estimate(order, subdivide, solver);
        let ratio = estimate / peak;
        assert!(0.5 < ratio && ratio < 2.0, "order {order}, {solver}: {peak} bytes, {estimate} foretold");
    }
}

#[test]
fn too_little_memory_is_told_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let solve = ["render", "empty-box", "--order", "12", "--subdivide", "4", "--solver", "lu"];
    let output = radiosity(folder.path(), &[&solve[..], &["--size", "64x64", "--memory", "100M"]].concat());
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in
        ["not enough memory: about", "100.0 MB allowed", "or one element a surface", "help:", "--memory"]
    {
        assert!(message.contains(part), "{part:?} is missing in:\n{message}");
    }
    assert_eq!(names(folder.path()), Vec::<String>::new());
    let wrong = radiosity(folder.path(), &["grid", "--memory", "much"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&wrong.stderr).contains("such as 500M, 2G or 2GiB"));
}

#[test]
fn the_report_tells_what_carried_the_light_and_how_well() {
    let folder = tempfile::tempdir().unwrap();
    let transport = |args: &[&str]| {
        let args = [&["solve", "cornell-box", "--order", "1", "--report", "r.json"][..], args].concat();
        let output = radiosity(folder.path(), &args);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        json(&folder.path().join("r.json"))["transport"].clone()
    };
    let exact = transport(&[]);
    assert_eq!((&exact["kind"], &exact["rays"], &exact["error"]), (&"exact".into(), &0.into(), &Value::Null));
    assert!(exact["why"].as_str().unwrap().contains("exact blocks take as long as about"));
    let sampled = transport(&["--rays", "50000"]);
    assert_eq!(sampled["kind"], "sampled");
    assert!(sampled["rays"].as_u64().unwrap() >= 50_000);
    let error = sampled["error"].as_f64().unwrap();
    assert!(error > 1e-3 && error < 0.2, "{error}");
    let finer = transport(&["--transport", "sampled", "--accuracy", "0.015"]);
    assert!(finer["error"].as_f64().unwrap() <= 0.015, "{finer}");
    assert!(finer["rays"].as_u64().unwrap() > 50_000);
}

/// Where rays carry the light, a finer quality sends more of them, on more elements.
#[test]
fn finer_qualities_send_more_rays_on_finer_elements() {
    let folder = tempfile::tempdir().unwrap();
    let of = |quality: &str| {
        let args = ["solve", "teapot", "--quality", quality, "--report", "r.json", "-o", "t.json"];
        program::done(folder.path(), &args);
        let report = json(&folder.path().join("r.json"));
        assert_eq!(report["transport"]["kind"], "sampled");
        [number(&report["transport"]["rays"]), number(&report["elements"])]
    };
    let [quick, usual, fine] = ["quick", "default", "fine"].map(of);
    for k in [0, 1] {
        assert!(quick[k] < usual[k] && usual[k] < fine[k], "{quick:?}, {usual:?}, {fine:?}");
    }
    assert!((fine[0] / usual[0] - 4.0).abs() < 0.1, "{usual:?}, {fine:?}");
}
