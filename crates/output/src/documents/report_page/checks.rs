//! Self-checks: the figures found, and those of a computation without errors.

use radiosity_scene::Scene;

use super::light_part::LightPart;
use crate::documents::document::Block;
use crate::table::{Column, Table};
use radiosity_reading::quantity::power_unit;
use radiosity_work::digits::{decimals, error, significant};

pub(super) fn blocks(scene: &Scene, light: &LightPart) -> Vec<Block> {
    let columns = [Column::text("check"), Column::numbers("found", ""), Column::text("without errors")];
    let table = Table::new(columns, rows(scene, light));
    vec![Block::Heading("Checks".to_owned()), Block::Table(table)]
}

fn rows(scene: &Scene, light: &LightPart) -> Vec<[String; 3]> {
    let report = light.report;
    let checks = &report.checks;
    let power = |power: f64| format!("{} {}", significant(power, 4), power_unit(&scene.unit));
    let percent = |part: f64| match checks.energy_in {
        0.0 => "–".to_owned(),
        whole => format!("{} %", decimals(100.0 * part / whole, 3)),
    };
    let row = |check: &str, found: String, ideal: &str| [check.to_owned(), found, ideal.to_owned()];
    let absorbed: f64 = light.surfaces.iter().flat_map(|own| &own.absorbed).sum();
    let mut rows = vec![
        row("emitted power, where lengths are metres", power(checks.energy_in), "as the scene states"),
        row("absorbed power", percent(checks.energy_absorbed), "100 % in a closed scene"),
        row("lost power", percent(checks.energy_lost), "0 % in a closed scene"),
        row("absorbed power as the surfaces were read", percent(absorbed), "the absorbed power"),
        row("least row sum Σ F", decimals(checks.row_sum_min, 5), "1 in a closed scene"),
        row("greatest row sum Σ F", decimals(checks.row_sum_max, 5), "1 at most"),
        row("closure ‖c − G c‖, greatest", error(checks.closure_max), "0 in a closed scene"),
        row("residual of the solver", error(report.residual), "0"),
    ];
    // No radius is known where columns are missing.
    let bound = Some(checks.spectral_bound).filter(|bound| *bound > 0.0);
    rows.extend(bound.map(|bound| row("spectral radius, estimate", decimals(bound, 4), "below 1")));
    rows.push(row(
        "jump of radiosity at seams, greatest",
        error(checks.seam_jump_max),
        "0 where light is smooth",
    ));
    rows.extend(
        report
            .transport
            .error
            .map(|found| row("error that rays leave in means of elements", error(found), "0")),
    );
    let missed = Some(report.accuracy_reached).filter(|found| *found > 0.0);
    rows.extend(missed.map(|found| row("error of transfers left unresolved", error(found), "0")));
    rows.extend(report.accuracy_estimate.map(|found| row("estimated relative error", error(found), "0")));
    rows.extend(report.read_error.map(|found| {
        row(
            "standard deviation of light gathered by rays",
            format!("{} %", decimals(100.0 * found.rms, 2)),
            "0",
        )
    }));
    rows.extend(report.checked.as_ref().map(|checked| {
        let line = checked.to_string();
        let (how, found) = line.split_once(": ").unwrap_or((&line, ""));
        row(&format!("light of sensors and cells, {how}"), found.to_owned(), "no error seen")
    }));
    rows
}
