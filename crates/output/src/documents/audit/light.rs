//! Judged light: readings at places.

use radiosity_reading::checked_readings::CheckEffort;
use radiosity_reading::judging::{JudgedReading, JudgedRun};
use radiosity_scene::Scene;
use radiosity_work::digits::{decimals, error, significant};

use super::judgement::{DIGITS, Judgement, finite, mark, signed_percent};
use crate::table::{Column, Table, Value};

/// The judgement on light.
pub fn judgement<'a>(scene: &'a Scene, effort: &CheckEffort, run: &'a JudgedRun) -> Judgement<'a> {
    Judgement {
        verdict: &run.verdict,
        checked: &run.checked,
        of: "readings",
        walks_of: "reading",
        walks: effort.effort.walks(),
        unread: run.unread,
        unread_because: "places could not be read: by polynomials there is light on surfaces alone",
        bands: &scene.bands,
        unit: &scene.unit,
        units: format!(" ({})", scene.unit).into(),
        worst: worst(scene, run),
        has_means: true,
        all: Table::new(columns(scene), run.readings.iter().map(row)),
    }
}

fn worst(scene: &Scene, run: &JudgedRun) -> Table<'static> {
    let columns = ["of", "band"].map(Column::text).to_vec();
    let numbers = ["x", "y", "z", "printed", "found", "s", "difference %", "in s", ""];
    let columns = [columns, numbers.map(|head| Column::numbers(head, "")).to_vec()].concat();
    let rows = run.verdict.worst.iter().map(|own| {
        let difference = own.printed - own.found.value;
        let position = run.readings[own.reading].probe.position.to_array();
        let head = [own.of.clone(), scene.bands[own.band].clone()].map(Value::from);
        let figures = [
            significant(own.printed, DIGITS),
            significant(own.found.value, DIGITS),
            error(own.found.error),
            signed_percent(difference / own.found.value),
            decimals(difference / own.found.error, 1),
            mark(own.is_outlier),
        ];
        head.into_iter()
            .chain(position.map(|x| significant(x, DIGITS).into()))
            .chain(figures.map(Value::from))
            .collect::<Vec<_>>()
    });
    Table::new(columns, rows)
}

/// The columns of all readings: `x,y,z,nx,ny,nz,of,E_<band>…,F_<band>…,s_<band>…,difference,in_s`.
fn columns(scene: &Scene) -> Vec<Column> {
    vec![
        Column::several("position", ["x", "y", "z"]),
        Column::several("normal", ["nx", "ny", "nz"]),
        Column::text("of"),
        Column::bands("printed", 'E', &scene.bands),
        Column::bands("found", 'F', &scene.bands),
        Column::bands("s", 's', &scene.bands),
        Column::numbers("difference", ""),
        Column::numbers("in_s", ""),
    ]
}

fn row(own: &JudgedReading) -> [Value<'_>; 8] {
    let bands = &own.judged.estimate.bands;
    [
        Value::numbers(own.probe.position.to_array().to_vec()),
        Value::numbers(own.probe.normal.to_array().to_vec()),
        Value::from(own.judged.class.as_str()),
        Value::numbers(&own.judged.printed),
        Value::numbers(bands.iter().map(|mean| mean.value).collect::<Vec<_>>()),
        Value::numbers(bands.iter().map(|mean| mean.error).collect::<Vec<_>>()),
        finite(own.judged.relative()),
        finite(own.judged.in_errors()),
    ]
}
