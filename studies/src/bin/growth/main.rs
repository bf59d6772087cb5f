//! Growth of time with the number of surfaces, stage by stage, of families of scenes.
//!
//! `cargo run --release -p radiosity-studies --bin growth > growth.md`
//!
//! Names of families print these alone; without one all are printed, and drawn in `docs/growth.svg`. Seconds
//! are of processor time on one thread. Below each table stand the exponents p of y ~ surfacesᵖ between its
//! last two rows.

#![expect(clippy::print_stdout, reason = "a table for people")]

mod family;
mod halls;
mod sinks;
mod balls;

use std::error::Error;
use std::fs;

use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};
use radiosity::solve::in_threads;
use radiosity_studies::words::words;

use family::{Family, Row};

const FAMILIES: [Family; 4] = [halls::OPEN, halls::CLOSED, sinks::FAMILY, balls::FAMILY];

fn main() -> Result<(), Box<dyn Error>> {
    let chosen = words(&FAMILIES.map(|family| family.name))?;
    let mut panels = Vec::new();
    for family in
        FAMILIES.iter().filter(|family| chosen.is_empty() || chosen.iter().any(|word| word == family.name))
    {
        let rows = in_threads(1, || table(family))?;
        panels.push(panel(family, &rows));
    }
    if chosen.is_empty() {
        let title = "time against the number of surfaces".to_owned();
        let caption = "processor time of one thread".to_owned();
        let diagram = Diagram { title, caption, columns: panels.len(), panels };
        fs::write("docs/growth.svg", diagram.drawing().svg())?;
    }
    Ok(())
}

/// Prints the table of a family.
fn table(family: &Family) -> Vec<Row> {
    println!("| {} | surfaces | {}, s |", family.name, family.stages.join(", s | "));
    println!("| --- |{}", " --- |".repeat(family.stages.len() + 1));
    let mut rows: Vec<Row> = Vec::new();
    for size in family.sizes {
        let row = (family.measure)(*size);
        let seconds: Vec<String> = row.seconds.iter().map(|seconds| format!("{seconds:.2}")).collect();
        println!("| {} | {} | {} |", family.name, row.surfaces, seconds.join(" | "));
        rows.push(row);
    }
    if let [.., a, b] = &rows[..] {
        let powers: Vec<String> =
            (0..family.stages.len()).map(|stage| format!("{:.2}", a.exponent(b, stage))).collect();
        println!("\n| {} | surfaces | {} |", family.name, family.stages.join(" p | ") + " p");
        println!("| --- | --- |{}", " ---: |".repeat(family.stages.len()));
        println!("| p | {} to {} | {} |\n", a.surfaces, b.surfaces, powers.join(" | "));
    }
    rows
}

/// Curves of a family, one for each stage.
fn panel(family: &Family, rows: &[Row]) -> Panel {
    let curve = |(stage, label): (usize, &&str)| {
        let dot = |row: &Row| Dot {
            place: [row.surfaces as f64, row.seconds[stage].max(family::LEAST)],
            text: String::new(),
        };
        let colour = COLOURS[stage % COLOURS.len()];
        Curve { label: (*label).to_owned(), colour, dots: rows.iter().map(dot).collect(), others: Vec::new() }
    };
    Panel {
        title: family.name.to_owned(),
        axes: ["surfaces".to_owned(), "seconds".to_owned()],
        along: Spacing::Logarithmic,
        curves: family.stages.iter().enumerate().map(curve).collect(),
    }
}
