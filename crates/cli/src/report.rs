//! `radiosity report`: a report for people.

mod args;
mod report_files;
mod light;

use std::path::Path;

use radiosity_heat::{Heat, HeatError, HeatOptions};
use radiosity_output::documents::report_page::ReportPage;
use radiosity_reading::checkpoint::Checkpoint;
use radiosity_request::memory::allowed;
use radiosity_request::ranges::Threads;
use radiosity_scene::Scene;
use radiosity_solve::Options;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Observer, Progress as Event, Stage, Work};

use crate::{
    console,
    error::CliError,
    loaded::{Loaded, outside},
    progress::Progress,
    run::RunArgs,
};
pub(crate) use args::ReportPageArgs;
use light::ReportLight;
use report_files::ReportFiles;

/// Solves the scene and writes the report.
pub(crate) fn run(args: &ReportPageArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let path = args.output.clone().unwrap_or_else(|| format!("{}.html", loaded.scene().name).into());
    let is_lit = loaded.scene().require_light().is_ok();
    if !is_lit && Heat::is_known(loaded.scene()) {
        return run_in_the_dark(args, &path, &loaded, ranks);
    }
    let loaded = loaded.required()?;
    let wanted = ReportLight::of(args, loaded.scene(), ranks)?;
    let RunArgs { method, report, .. } = &args.run;
    args.read.check(&loaded.options(method, ranks), method)?;
    let reserve = |path: &Path| loaded.reserve(path, report, ranks);
    let files = ReportFiles::reserve(&path, &wanted.figures(), reserve)?;
    let (run, read) = wanted.read(args, loaded, ranks)?;
    let scene = &run.solved.scene;
    let heat = Heat::is_known(scene).then(|| heat(args, scene, run.progress(), ranks));
    let heat = heat.map(told).transpose()?;
    let command = command();
    let light = Some(read.part(&wanted, &run));
    let heat = heat.as_ref().map(Result::as_ref);
    let document = ReportPage { scene, light, heat, command: &command }.document();
    files.write(&document)?;
    run.finish(Some(&files.written()))
}

/// Writes the report of a scene that has heat and no light.
fn run_in_the_dark(
    args: &ReportPageArgs,
    path: &Path,
    loaded: &Loaded,
    ranks: &Ranks,
) -> Result<(), CliError> {
    let report = &args.run.report;
    if report.report.is_some() {
        return Err(CliError::refused(
            "--report has the figures of light, and no surface of this scene emits any",
            "leave it out; `radiosity heat -o FILE.json` has those of heat",
        ));
    }
    let files = ReportFiles::reserve(path, &[], |path| loaded.reserve(path, report, ranks))?;
    let threads = args.run.method.threads.map_or(0, Threads::count);
    let progress = Progress::of(report, threads, loaded.started, ranks);
    let heat = heat(args, loaded.scene(), &progress, ranks)?;
    let command = command();
    let page = ReportPage { scene: loaded.scene(), light: None, heat: Some(Ok(&heat)), command: &command };
    progress.begin_output();
    files.write(&page.document())?;
    progress.clear();
    let checkpoint = Checkpoint::so_far(ranks);
    if !report.quiet {
        let mut lines: Vec<String> = checkpoint.iter().map(Checkpoint::to_string).collect();
        lines.extend(checkpoint.and_then(|own| own.warning()).map(|warning| warning.to_string()));
        lines.push(progress.stages());
        lines.extend(outside(loaded.scene()));
        lines.push(format!("wrote {}", files.written()));
        console::tell(&lines, ranks);
    }
    Ok(())
}

/// The balance of heat, as `radiosity heat` computes it unless told otherwise.
fn heat(args: &ReportPageArgs, scene: &Scene, progress: &Progress, ranks: &Ranks) -> Result<Heat, HeatError> {
    let show = |event| match event {
        Event::Done { stage: Stage::Blocks | Stage::Comparison, done, of } => {
            progress.show("blocks of heat", done, of);
        }
        Event::Began { .. } | Event::Ended { .. } => progress.report(event),
        _ => {}
    };
    let usual = HeatOptions::default();
    let threads = args.run.method.threads.map_or(usual.options.threads, Threads::count);
    let memory = allowed(args.run.method.memory, ranks);
    let wanted = HeatOptions { options: Options { memory, threads, ..usual.options }, ..usual };
    let work = Work::among(ranks).observed_by(&show);
    let mut balance = Heat::of(scene, &wanted, &work)?;
    let checked = || args.run.check.check_heat(&mut balance, scene, wanted.options.shadows, &work);
    // Heat that no referee can read keeps the errors that it has.
    let _ = wanted.options.in_threads(ranks, checked)?;
    Ok(balance)
}

/// The balance, or the error of the scene that the report tells; failures of the solver end the command.
fn told(heat: Result<Heat, HeatError>) -> Result<Result<Heat, HeatError>, CliError> {
    match heat {
        Err(HeatError::Solve(failure)) => Err(failure.into()),
        heat => Ok(heat),
    }
}

/// The command as it was typed, for a shell.
fn command() -> String {
    let typed: Vec<String> =
        std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let words = unrecorded(&typed).into_iter().map(quoted);
    ["radiosity".to_owned()].into_iter().chain(words).collect::<Vec<_>>().join(" ")
}

/// The words that were typed, without the options of a checkpoint.
fn unrecorded(typed: &[String]) -> Vec<&str> {
    let mut words = typed.iter().map(String::as_str);
    let mut kept = Vec::new();
    while let Some(word) = words.next() {
        match word {
            "--checkpoint" => {
                words.next();
            }
            "--resume" => {}
            word if word.starts_with("--checkpoint=") => {}
            word => kept.push(word),
        }
    }
    kept
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./=,:+@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_a_run_was_recorded_does_not_belong_to_the_command() {
        let kept = |text: &str| {
            let typed: Vec<String> = text.split(' ').map(str::to_owned).collect();
            unrecorded(&typed).join(" ")
        };
        assert_eq!(kept("report --checkpoint c room --resume -o a.md"), "report room -o a.md");
        assert_eq!(kept("report --checkpoint=c"), "report");
    }

    #[test]
    fn words_are_quoted_where_a_shell_would_read_them_otherwise() {
        let words = ["room.toml", "--set", "a=1", "0,0; 1", "it's", ""].map(quoted);
        assert_eq!(words, ["room.toml", "--set", "a=1", "'0,0; 1'", r"'it'\''s'", "''"]);
    }
}
