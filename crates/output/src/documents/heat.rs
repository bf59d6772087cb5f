//! The balance of heat as CSV or JSON, and its conductances as CSV, JSON, NPY or NPZ.

use std::io::{self, Write};

use radiosity_heat::{Conductances, Heat, SurfaceHeat, ToldHeat};
use serde::Serialize;

use crate::files::npy;
use crate::files::npz::Archive;
use crate::table::{Column, Listed, Table, Value};
use radiosity_work::digits::significant;

/// Names of the figures of a surface in CSV.
const FIGURES: [&str; 10] = ["surface", "area", "emissivity", "T", "T_error", "q", "Q", "Q_error", "J", "H"];

/// CSV with a row for each surface; an emissivity that is not known is left empty.
///
/// # Errors
/// Errors of writing to `out`.
pub fn csv(surfaces: &[SurfaceHeat], out: impl Write) -> io::Result<()> {
    Table::new(FIGURES.map(Column::text), surfaces.iter().map(row)).listed().csv(out)
}

/// CSV with a row for each surface at each value of what is `swept`, in the first column.
///
/// # Errors
/// Errors of writing to `out`.
pub fn swept_csv(swept: &str, values: &[f64], balances: &[ToldHeat], out: impl Write) -> io::Result<()> {
    let columns: Vec<Column> = [swept].into_iter().chain(FIGURES).map(Column::text).collect();
    let points = values.iter().zip(balances);
    Table::new(columns, points.flat_map(|(value, heat)| rows_at(*value, heat))).listed().csv(out)
}

/// The rows of a balance behind a value.
fn rows_at(value: f64, heat: &ToldHeat) -> impl Iterator<Item = Vec<Value<'_>>> {
    heat.surfaces().iter().map(move |own| [Value::from(value)].into_iter().chain(row(own)).collect())
}

/// The figures of a surface.
fn row(own: &SurfaceHeat) -> impl Iterator<Item = Value<'_>> {
    let numbers = [
        own.temperature,
        own.temperature_error,
        own.flux,
        own.flow,
        own.flow_error,
        own.radiosity,
        own.irradiance,
    ];
    let head = [Value::from(own.name.as_str()), own.area.into(), own.emissivity.into()];
    head.into_iter().chain(numbers.map(Value::from))
}

/// Digits of given figures. Chosen.
const GIVEN: usize = 6;

/// The figures for people: given ones as they are, others to so many digits with their errors.
pub fn table(surfaces: &[SurfaceHeat], digits: usize) -> Table<'static> {
    let columns = [("area", "m²"), ("ε", ""), ("T", "K"), ("±", "K"), ("q", "W/m²"), ("Q", "W"), ("±", "W")];
    let columns = columns.map(|(head, unit)| Column::numbers(head, unit));
    let columns = [vec![Column::text("surface")], columns.to_vec()].concat();
    let figure = |is_given: bool, value: f64| significant(value, if is_given { GIVEN } else { digits });
    let error =
        |is_given: bool, error: f64| if is_given { "given".to_owned() } else { significant(error, 2) };
    let row = |own: &SurfaceHeat| {
        [
            Value::from(own.name.clone()),
            significant(own.area, GIVEN).into(),
            own.emissivity.map(|emissivity| significant(emissivity, GIVEN)).into(),
            own.has_level().then(|| figure(own.is_temperature_known, own.temperature)).into(),
            own.has_level().then(|| error(own.is_temperature_known, own.temperature_error)).into(),
            figure(own.is_flow_known, own.flux).into(),
            figure(own.is_flow_known, own.flow).into(),
            error(own.is_flow_known, own.flow_error).into(),
        ]
    };
    Table::new(columns, surfaces.iter().map(row))
}

/// JSON with the figures of each surface, the balance and how good it is.
///
/// # Errors
/// Errors of writing to `out`.
pub fn json(heat: &Heat, mut out: impl Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut out, &ToldHeat::from(heat))?;
    writeln!(out)
}

/// JSON with what is `swept`, and its value and the balance of each point; the check of a referee stands at the point
/// where it was made.
///
/// # Errors
/// Errors of writing to `out`.
pub fn swept_json(swept: &str, values: &[f64], balances: &[ToldHeat], mut out: impl Write) -> io::Result<()> {
    let points = values.iter().zip(balances);
    let points = points.map(|(value, balance)| SweptPoint { value: *value, balance }).collect();
    serde_json::to_writer_pretty(&mut out, &SweptPoints { swept, points })?;
    writeln!(out)
}

#[derive(Serialize)]
struct SweptPoints<'a> {
    swept: &'a str,
    points: Vec<SweptPoint<'a>>,
}

#[derive(Serialize)]
struct SweptPoint<'a> {
    value: f64,
    #[serde(flatten)]
    balance: &'a ToldHeat,
}

/// CSV with the names as header and as first column; the last column is the conductance to the surroundings.
///
/// # Errors
/// Errors of writing to `out`.
pub fn conductances_csv(names: &[&str], conductances: &Conductances, out: impl Write) -> io::Result<()> {
    let columns = [
        Column::text("surface"),
        Column::several("conductances", names.iter().copied()),
        Column::text("(surroundings)"),
    ];
    let rows = names.iter().zip(&conductances.rows).zip(&conductances.lost);
    let rows = rows.map(|((name, row), lost)| [Value::from(*name), Value::numbers(row), (*lost).into()]);
    Listed { columns: &columns, rows }.csv(out)
}

/// JSON with the names, the matrix, the conductances to the surroundings and the largest asymmetry.
///
/// # Errors
/// Errors of writing to `out`.
pub fn conductances_json(names: &[&str], conductances: &Conductances, mut out: impl Write) -> io::Result<()> {
    let Conductances { rows, lost, asymmetry, negative } = conductances;
    let document = serde_json::json!({
        "surfaces": names, "conductances": rows, "surroundings": lost, "asymmetry_max": asymmetry,
        "negative_max": negative,
    });
    serde_json::to_writer(&mut out, &document)?;
    writeln!(out)
}

/// NPY, an array of shape (N, N).
///
/// # Errors
/// Errors of writing to `out`.
pub fn conductances_npy(conductances: &Conductances, out: impl Write) -> io::Result<()> {
    npy::square(conductances.rows.len(), conductances.rows.iter(), out)
}

/// NPZ with `C` of shape (N, N), and `surroundings`, `names`, `areas` of shape (N,).
///
/// # Errors
/// Errors of writing to `out`.
pub fn conductances_npz(
    surfaces: &[SurfaceHeat],
    conductances: &Conductances,
    out: impl Write,
) -> io::Result<()> {
    let count = surfaces.len();
    let mut archive = Archive::new(out);
    archive.square("C", count, conductances.rows.iter())?;
    archive.numbers("surroundings", count, conductances.lost.iter().copied())?;
    archive.texts("names", surfaces.iter().map(|surface| surface.name.as_str()))?;
    archive.numbers("areas", count, surfaces.iter().map(|surface| surface.area))?;
    archive.finish()
}
