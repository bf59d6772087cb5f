//! Error against work: high orders, constant elements and the rules of 1993 on the same axes.
//!
//! `cargo run --release -p radiosity-studies --bin work_precision -- [SCENE ... | --redraw]` runs every
//! study, or only those named (box-a, box-b, lit-sphere, two-boxes, cornell-box, cornell-cells, teapot), on
//! one thread, takes what it measured into docs/work-precision.csv, draws docs/work-precision*.svg from all
//! that is there (against time, samples, unknowns), and prints the equal-error speed-ups over constant
//! elements as Markdown. `--redraw` runs nothing.
//!
//! Errors are those of the polynomials alone, relative L² over the scene of what is reflected: against a
//! finer run in rooms, against Lambert's form on the lit sphere. `cornell-cells` reads 16 × 16 cells and
//! holds those of floor and back wall against path tracing, whose own noise is 0.14 %. Times are CPU times of
//! one thread, of the solution and of cells where these are read. A time with ~ goes on beyond the finest
//! constant elements by the line through the last three, to a quarter of their error; beyond that it is only
//! told what they took.

mod diagram;
mod family;
mod front;
mod judge;
mod record;
mod study;
mod table;
mod work;

use std::error::Error;
use std::io::{Write, stderr, stdout};
use std::path::Path;

use radiosity_studies::words::words;
use record::Record;
use study::{Study, studies};
use work::Work;

const CSV: &str = "docs/work-precision.csv";
const REDRAW: &str = "--redraw";

fn main() -> Result<(), Box<dyn Error>> {
    let studies = studies();
    let known: Vec<&str> = studies.iter().map(|study| study.name).chain([REDRAW]).collect();
    let only = words(&known)?;
    let wanted = |study: &&Study| only.is_empty() || only.iter().any(|only| only == study.name);
    let mut records = if Path::new(CSV).exists() { record::read(Path::new(CSV))? } else { Vec::new() };
    for study in studies.iter().filter(wanted) {
        records.retain(|record| record.scene != study.name);
        records.extend(judge::records(study, tell));
        records.sort_by_key(|record| studies.iter().position(|study| study.name == record.scene));
        record::write(Path::new(CSV), &records)?;
    }
    for (work, diagram) in Work::ALL {
        diagram::write(Path::new(diagram), work, &studies, &records)?;
    }
    table::print(&mut stdout().lock(), &studies, &records)?;
    Ok(())
}

/// Tells that a run is done; nobody is left to hear it where stderr is closed.
fn tell(record: &Record) {
    let Record { scene, kernel, order, layers, cells, eps, seconds, error, .. } = record;
    let _ = writeln!(
        stderr(),
        "{scene} {kernel} order {order} layers {layers} cells {cells} eps {eps:e}: {seconds:.4} s {error:.3e}"
    );
}
