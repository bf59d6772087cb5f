//! Judged heat: flows and temperatures of surfaces.

use radiosity_heat::judging::{JudgedHeat, JudgedSurface};
use radiosity_work::digits::{decimals, error, significant};

use super::judgement::{DIGITS, Judgement, finite, mark};
use crate::table::{Column, Table, Value};

/// The judgement on heat, whose verdict is on watts.
pub fn judgement(run: &JudgedHeat) -> Judgement<'_> {
    Judgement {
        verdict: &run.verdict,
        checked: &run.checked,
        of: "surfaces",
        walks_of: "surface",
        walks: run.walks,
        unread: run.unread,
        unread_because: "surfaces could not be judged: walks from them do not end",
        bands: &[],
        unit: "W",
        units: "".into(),
        worst: worst(run),
        has_means: false,
        all: Table::new(columns(), run.surfaces.iter().map(row)),
    }
}

fn worst(run: &JudgedHeat) -> Table<'static> {
    let columns = ["surface", "what"].map(Column::text).to_vec();
    let numbers = ["printed", "± told", "found", "± s", "in s", ""];
    let columns = [columns, numbers.map(|head| Column::numbers(head, "")).to_vec()].concat();
    let rows = run.verdict.worst.iter().map(|worst| {
        let own = &run.surfaces[worst.reading];
        [
            own.judged.class.clone(),
            what(own).to_owned(),
            significant(own.printed, DIGITS),
            error(own.told),
            significant(own.found.value, DIGITS),
            error(own.found.error),
            decimals(own.judged.in_errors(), 1),
            mark(worst.is_outlier),
        ]
    });
    Table::new(columns, rows)
}

fn what(own: &JudgedSurface) -> &'static str {
    if own.is_flow { "flow W" } else { "temperature K" }
}

/// The columns of all surfaces; difference and `in_s` are those of watts.
fn columns() -> Vec<Column> {
    let texts = ["surface", "what"].map(Column::text);
    let numbers = ["printed", "told", "found", "s", "difference", "in_s"];
    texts.into_iter().chain(numbers.map(|head| Column::numbers(head, ""))).collect()
}

fn row(own: &JudgedSurface) -> [Value<'_>; 8] {
    [
        Value::from(own.judged.class.as_str()),
        what(own).into(),
        own.printed.into(),
        own.told.into(),
        own.found.value.into(),
        own.found.error.into(),
        finite(own.judged.relative()),
        finite(own.judged.in_errors()),
    ]
}
