//! `--sweep`: balances for some values of a quantity, by transfers that are found once.

use std::path::Path;
use std::time::Instant;

use radiosity_output::documents::heat as output;
use radiosity_request::{HeatSweep, SweptHeat};
use radiosity_scene::Scene;
use radiosity_solve::Options;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Observer, Work};

use super::{Format, HeatArgs, findings, shown};
use crate::{destination::Destination, error::CliError, format, progress::Progress};

/// Computes the balances of a sweep and writes them; the first scene is as its file says it.
pub(super) fn run(
    sweep: &HeatSweep,
    args: &HeatArgs,
    options: &Options,
    start: Instant,
    [read, scene]: [&Scene; 2],
    ranks: &Ranks,
) -> Result<(), CliError> {
    let output = args.output.as_deref();
    let format = format::chosen(args.format, output, Format::Csv)?;
    if format == Format::Text {
        return Err(CliError::refused(
            "--format text has no place for a sweep",
            "take --format csv or json, or leave it out",
        ));
    }
    let reserve = |path: &Path| args.scene.reserve(path, ranks);
    let figures = Destination::of(output.map(reserve).transpose()?, ranks);
    let scenes = sweep.scenes(scene)?;
    let progress = Progress::new(args.transfers.quiet, start, ranks);
    let show = |event| shown(event).into_iter().for_each(|event| progress.report(event));
    let work = Work::among(ranks).observed_by(&show);
    let swept = sweep.balances(&scenes, options, &args.transfers.check, &work)?;
    progress.begin_output();
    let (setting, values) = (sweep.setting().to_string(), sweep.values());
    figures.write(|writer| match format {
        Format::Json => output::swept_json(&setting, values, &swept.balances, writer),
        Format::Csv | Format::Text => output::swept_csv(&setting, values, &swept.balances, writer),
    })?;
    progress.clear();
    let SweptHeat { balances, first, unchecked } = &swept;
    let found = &balances[*first];
    let told = vec![
        format!(
            "{}: {} surfaces, {} values of {setting}, {:.3} s",
            read.name,
            found.surfaces.len(),
            values.len(),
            start.elapsed().as_secs_f64()
        ),
        progress.stages(),
        format!("transfers are those of {setting} = {}, of which the following is told", values[*first]),
    ];
    let findings = findings(&scenes[*first], found, unchecked.as_ref());
    args.transfers.tell(told, read, findings, &args.output, ranks);
    match found.checked.as_ref().filter(|checked| args.scene.strict && checked.finds_more()) {
        Some(checked) => Err(CliError::FoundMore { what: "the heat is", told: checked.own_error }),
        None => Ok(()),
    }
}
