//! Judged readings as text, CSV or JSON.

use std::io::{self, Write};

use radiosity_reading::digits::{decimals, error, significant};
use radiosity_reading::judging::{JudgedReading, JudgedRun, Judging};
use radiosity_scene::Scene;
use serde::Serialize;

use crate::table::{Column, Listed, Table, Value};

/// Signed means that are shown at the least; all that exceed chance are. Chosen.
const SIGNED: usize = 5;

/// Digits of printed and of true light in texts. Chosen.
const DIGITS: usize = 5;

/// Rays of a million, in texts.
const MILLION: f64 = 1e6;

/// For people: the verdict in lines, the worst readings, and the largest signed means.
pub fn text(scene: &Scene, judging: &Judging, run: &JudgedRun) -> String {
    let mut lines = vec![run.to_string(), effort(judging, run)];
    lines.extend(unread(run));
    lines.extend(finding(judging, run));
    let head = lines.join("\n");
    let unit = &scene.unit;
    format!(
        "{head}\n\nthe readings that differ most ({unit})\n{}\nmeans of signed differences\n{}",
        worst(scene, run),
        signed(run)
    )
}

/// The line about rays, and what they let see.
fn effort(judging: &Judging, run: &JudgedRun) -> String {
    let verdict = &run.verdict;
    format!(
        "{} million rays, {} walks a reading: an error of {} % would be seen; the run tells {} %",
        significant(verdict.rays as f64 / MILLION, 3),
        judging.effort.walks(),
        percent(verdict.visible()),
        percent(judging.told)
    )
}

/// The line about places that could not be read, if there are any.
fn unread(run: &JudgedRun) -> Option<String> {
    let words = |count: usize| {
        format!("{count} more places could not be read: by polynomials there is light on surfaces alone")
    };
    (run.unread > 0).then(|| words(run.unread))
}

/// The line about a verdict that finds more than the run tells.
pub fn finding(judging: &Judging, run: &JudgedRun) -> Option<String> {
    let verdict = &run.verdict;
    if !verdict.finds(judging.told) {
        return None;
    }
    let all = verdict.exceeds(judging.told).then(|| {
        format!(
            "all readings together by {} % (± {} %)",
            percent(verdict.error()),
            percent(verdict.error_sd())
        )
    });
    let signed = verdict
        .signed
        .iter()
        .filter(|own| own.finds(judging.told))
        .take(SIGNED)
        .map(|own| format!("\"{}\" by {} % (± {} %)", own.of, percent(own.relative), percent(own.error)));
    let parts: Vec<String> = all.into_iter().chain(signed).collect();
    Some(format!("more than the run tells, {} %: {}", percent(judging.told), parts.join(", ")))
}

fn percent(part: f64) -> String {
    significant(100.0 * part, 2)
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
            if own.is_outlier { "stands out" } else { "" }.to_owned(),
        ];
        head.into_iter()
            .chain(position.map(|x| significant(x, DIGITS).into()))
            .chain(figures.map(Value::from))
            .collect::<Vec<_>>()
    });
    Table::new(columns, rows)
}

fn signed(run: &JudgedRun) -> Table<'static> {
    let columns = ["of"].map(Column::text).to_vec();
    let numbers = ["readings", "difference %", "s %", "in s", ""];
    let columns = [columns, numbers.map(|head| Column::numbers(head, "")).to_vec()].concat();
    let shown = run.verdict.signed.iter().enumerate().filter(|(rank, own)| *rank < SIGNED || own.is_finding);
    let rows = shown.map(|(_, own)| {
        [
            Value::from(own.of.clone()),
            own.readings.into(),
            signed_percent(own.relative).into(),
            percent(own.error).into(),
            decimals(own.in_errors(), 1).into(),
            if own.is_finding { "exceeds chance" } else { "" }.to_owned().into(),
        ]
    });
    Table::new(columns, rows)
}

/// A part as a percentage with two decimals; none where it is of nothing.
fn signed_percent(part: f64) -> String {
    if part.is_finite() { decimals(100.0 * part, 2) } else { "–".to_owned() }
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
        Some(own.difference()).filter(|difference| difference.is_finite()).into(),
        Some(own.in_errors()).filter(|errors| errors.is_finite()).into(),
    ]
}

/// CSV with a row for each reading: place, printed numbers, what was found, its standard errors, the relative
/// difference of all bands together and that difference in standard errors.
///
/// # Errors
/// Errors of writing to `out`.
pub fn csv(scene: &Scene, run: &JudgedRun, out: impl Write) -> io::Result<()> {
    Listed { columns: &columns(scene), rows: run.readings.iter().map(row) }.csv(out)
}

/// JSON with the verdict and all readings.
///
/// # Errors
/// Errors of writing to `out`.
pub fn json(scene: &Scene, judging: &Judging, run: &JudgedRun, mut out: impl Write) -> io::Result<()> {
    let verdict = &run.verdict;
    let columns = columns(scene);
    let document = Document {
        bands: &scene.bands,
        unit: &scene.unit,
        error: verdict.error(),
        error_sd: verdict.error_sd(),
        visible: verdict.visible(),
        told: judging.told,
        finds_more: verdict.finds(judging.told),
        readings: verdict.readings,
        unread: run.unread,
        rays: verdict.rays,
        walks: judging.effort.walks(),
        signed: &verdict.signed,
        worst: &verdict.worst,
        points: Listed { columns: &columns, rows: run.readings.iter().map(row) },
    };
    serde_json::to_writer_pretty(&mut out, &document)?;
    writeln!(out)
}

#[derive(Serialize)]
struct Document<'a, S, W, P> {
    bands: &'a [String],
    unit: &'a str,
    error: f64,
    error_sd: f64,
    visible: f64,
    told: f64,
    finds_more: bool,
    readings: usize,
    unread: usize,
    rays: u64,
    walks: u64,
    signed: &'a [S],
    worst: &'a [W],
    points: P,
}
