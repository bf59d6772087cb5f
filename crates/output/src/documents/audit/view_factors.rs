//! Judged view factors.

use radiosity_reading::judged_factors::{JudgedFactor, JudgedFactors};
use radiosity_work::digits::{decimals, error, significant};

use super::judgement::{DIGITS, Judgement, finite, mark, signed_percent};
use crate::table::{Column, Table, Value};

/// The judgement on view factors.
pub fn judgement(run: &JudgedFactors) -> Judgement<'_> {
    Judgement {
        verdict: &run.verdict,
        checked: &run.checked,
        of: "view factors",
        walks_of: "surface",
        walks: run.rays,
        unread: 0,
        unread_because: "",
        bands: &[],
        unit: "",
        units: "".into(),
        worst: worst(run),
        has_means: true,
        all: Table::new(columns(), run.factors.iter().map(row)),
    }
}

fn worst(run: &JudgedFactors) -> Table<'static> {
    let columns = ["from", "to"].map(Column::text).to_vec();
    let numbers = ["printed", "found", "s", "difference %", "in s", ""];
    let columns = [columns, numbers.map(|head| Column::numbers(head, "")).to_vec()].concat();
    let rows = run.verdict.worst.iter().map(|worst| {
        let own = &run.factors[worst.reading];
        [
            own.judged.class.clone(),
            own.to.clone(),
            significant(worst.printed, DIGITS),
            significant(worst.found.value, DIGITS),
            error(worst.found.error),
            signed_percent(own.judged.relative()),
            decimals(own.judged.in_errors(), 1),
            mark(worst.is_outlier),
        ]
    });
    Table::new(columns, rows)
}

fn columns() -> Vec<Column> {
    let texts = ["from", "to"].map(Column::text);
    let numbers = ["printed", "found", "s", "difference", "in_s"];
    texts.into_iter().chain(numbers.map(|head| Column::numbers(head, ""))).collect()
}

fn row(own: &JudgedFactor) -> [Value<'_>; 7] {
    let found = own.judged.estimate.bands[0];
    [
        Value::from(own.judged.class.as_str()),
        own.to.as_str().into(),
        own.judged.printed[0].into(),
        found.value.into(),
        found.error.into(),
        finite(own.judged.relative()),
        finite(own.judged.in_errors()),
    ]
}
