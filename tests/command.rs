//! What a user may rely on beside the numbers: exit codes, interruption, partial results, messages.

use std::{
    fs,
    path::Path,
    process::{Command, Output},
};

use radiosity::{elements::Discretization, footprint::Footprint, scene::Scene};
use radiosity_solvers::method::Method;
use serde_json::Value;

fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_radiosity"));
    command.current_dir(folder).args(args);
    command
}

fn radiosity(folder: &Path, args: &[&str]) -> Output {
    command(folder, args).output().expect("the binary runs")
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect("the file was written")).expect("it is JSON")
}

fn files(folder: &Path) -> Vec<String> {
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
    fs::read_dir(folder).unwrap().map(name).collect()
}

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
    assert_eq!(files(folder.path()), Vec::<String>::new());
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
    assert_eq!(files(here), Vec::<String>::new());

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
    assert_eq!(json(&here.join("again.json"))["converged"], Value::Bool(false));
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
    for key in "closure_max reciprocity_max row_sum_min row_sum_max energy_in energy_absorbed energy_lost \
                spectral_bound seam_jump_max"
        .split_whitespace()
    {
        assert!(report["checks"][key].is_f64(), "{key}");
    }
    let pairs = |key: &str| report["pairs"][key].as_u64().unwrap_or_else(|| panic!("{key} is missing"));
    let skipped = ["skipped_facing", "skipped_coplanar", "skipped_hidden", "skipped_black"].map(pairs);
    let taken = ["same", "edge", "vertex", "contact", "split", "separated", "contour"].map(pairs);
    assert_eq!(pairs("total"), skipped.iter().chain(&taken).sum::<u64>());
    let elements = report["elements"].as_u64().unwrap();
    assert_eq!(pairs("total"), elements * (elements - 1) / 2 + pairs("same"));
    assert!(pairs("partly_hidden") > 0 && report["shadow_rays"].as_u64() > Some(0));
    assert_eq!((&report["threads"], &report["order"]), (&2.into(), &1.into()));
    assert_eq!(report["unknowns"].as_u64().unwrap(), 3 * elements);
}

#[test]
fn messages_have_no_colours_and_no_bar_without_a_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let output = radiosity(folder.path(), &["solve", "furnace-cube", "--order", "0", "-v"]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(!message.contains('\u{1b}') && !message.contains('\r'), "{message:?}");
    let stages: Vec<&str> = message.lines().take(4).map(|line| line.split(':').next().unwrap()).collect();
    assert_eq!(stages, ["visibility", "elements", "blocks", "solve"]);
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

/// What the file of a run tells of its memory, and what was foretold for the same scene, cuts and solver.
fn peak_and_estimate(order: usize, subdivide: usize, solver: &str) -> [f64; 2] {
    let folder = tempfile::tempdir().unwrap();
    let (degree, parts) = (order.to_string(), subdivide.to_string());
    let args = ["solve", "empty-box", "--order", &degree, "--subdivide", &parts, "--solver", solver];
    let output = radiosity(folder.path(), &[&args[..], &["--eps", "0.1", "--report", "r.json"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let scene = Scene::builtin("empty-box").unwrap();
    let how = Discretization::uniform(order, subdivide);
    let estimate = Footprint::of(&scene, &how, Method::named(solver).unwrap()).peak();
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
    let args =
        ["render", "empty-box", "--order", "12", "--subdivide", "4", "--memory", "100M", "--solver", "lu"];
    let output = radiosity(folder.path(), &args);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in
        ["not enough memory: about", "100.0 MB allowed", "or one element a surface", "help:", "--memory"]
    {
        assert!(message.contains(part), "{part:?} is missing in:\n{message}");
    }
    assert_eq!(files(folder.path()), Vec::<String>::new());
    let wrong = radiosity(folder.path(), &["grid", "--memory", "much"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&wrong.stderr).contains("such as 500M, 2G or 2GiB"));
}
