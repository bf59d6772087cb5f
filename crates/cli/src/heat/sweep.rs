//! `--sweep`: balances for some values of a quantity, by transfers that are found once.

use std::path::Path;
use std::time::Instant;

use radiosity_heat::ToldHeat;
use radiosity_output::documents::heat as output;
use radiosity_request::{HeatSweep, SweptHeat};
use radiosity_scene::Scene;
use radiosity_solve::Options;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Observer, Work};

use super::{Format, HeatArgs, findings, judge, shown};
use crate::format::{self, Format as SweptFormat};
use crate::{destination::Destination, error::CliError, progress::Progress};

/// Computes the balances of a sweep of `scene` and writes them; `read` is the scene as its file says it.
pub(super) fn run(
    sweep: &HeatSweep,
    args: &HeatArgs,
    options: &Options,
    start: Instant,
    read: &Scene,
    scene: &Scene,
    ranks: &Ranks,
) -> Result<(), CliError> {
    let output = args.output.as_deref();
    let asked = args.format.map(of_sweep).transpose()?;
    let format = format::chosen(asked, output, SweptFormat::Csv)?;
    let reserve = |path: &Path| args.scene.reserve(path, ranks);
    let figures = Destination::of(output.map(reserve).transpose()?, ranks);
    let progress = Progress::new(args.transfers.quiet, options.threads, start, ranks);
    let show = |event| shown(event).into_iter().for_each(|event| progress.report(event));
    let work = Work::among(ranks).observed_by(&show);
    let swept: SweptHeat<ToldHeat> = sweep.balances(scene, options, &args.transfers.check, &work)?;
    progress.begin_output();
    let (setting, values) = (sweep.setting().to_string(), sweep.values());
    let (surfaces, told_value) = (swept.largest.surfaces.len(), values[swept.point]);
    let asked_order = args.request.asked_order();
    let findings = findings(&swept.scene, &swept.largest, asked_order, swept.unchecked.as_ref());
    let judged = judge(args, &swept.largest);
    let balances = swept.into_balances();
    figures.write(|writer| match format {
        SweptFormat::Json => output::swept_json(&setting, values, &balances, writer),
        SweptFormat::Csv => output::swept_csv(&setting, values, &balances, writer),
    })?;
    progress.clear();
    let elapsed = start.elapsed().as_secs_f64();
    let told = vec![
        format!("{}: {surfaces} surfaces, {} values of {setting}, {elapsed:.3} s", read.name, values.len()),
        progress.stages(),
        format!("the flows are largest at {setting} = {told_value}, of which the following is told"),
    ];
    args.transfers.tell(told, read, findings, &args.output, ranks);
    judged
}

/// The format of figures of a sweep.
fn of_sweep(asked: Format) -> Result<SweptFormat, CliError> {
    match asked {
        Format::Csv => Ok(SweptFormat::Csv),
        Format::Json => Ok(SweptFormat::Json),
        Format::Text => Err(CliError::refused(
            "--format text has no place for a sweep",
            "take --format csv or json, or leave it out",
        )),
    }
}
