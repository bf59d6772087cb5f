//! The figures and the table of H. R. Zatz, "Galerkin radiosity" (1993), computed again.
//!
//! `cargo run --release -p radiosity-studies --bin zatz_1993 -- [PART ...]` prints Markdown, the paper's
//! numbers beside those of its own rule (the hybrid, H1) and of ours: `figure-4` and `figure-5` (error
//! against order of two squares, drawn in docs/zatz-figure-4.svg and -5.svg), `chebyshev` (the basis that
//! section 10 wishes for, docs/chebyshev.svg), `sparrow` (opposed plates of section 6.1, docs/sparrow.svg),
//! `table-1` (times and shots, with figures 6, 7, 8 and 12), `figure-7` (the
//! shadow of figures 7 and 8, with docs/occluder-box-pictures.png and -differences.png), `figure-9` (the two
//! boxes at orders 0, 1, 3 and 7; figure 11 is the second row of the picture it writes,
//! docs/zatz-two-boxes.png; figure 10 is the mesh), `figure-13` (the temple); all unless said. No pairs are
//! carried by rays: a run of which rays carry any fails.
//!
//! Only the squares are known to the last number: sizes, reflectances, cameras and stopping rules of the
//! rooms were not published, and the scenes here are stand-ins of the same make.

mod boxes;
mod chebyshev;
mod curves;
mod memory;
mod reproduction;
mod rooms;
mod shadow;
mod sparrow;
mod squares;

use std::error::Error;
use std::io::{Write, stdout};

use radiosity_studies::words::words;

fn main() -> Result<(), Box<dyn Error>> {
    let only = words(&[
        "figure-4",
        "figure-5",
        "chebyshev",
        "sparrow",
        "table-1",
        "figure-7",
        "figure-9",
        "figure-13",
    ])?;
    let wanted = |part: &str| only.is_empty() || only.iter().any(|only| only == part);
    let mut out = stdout().lock();
    if wanted("figure-4") {
        squares::figure_4(&mut out)?;
        writeln!(out)?;
    }
    if wanted("figure-5") {
        squares::figure_5(&mut out)?;
        writeln!(out)?;
    }
    if wanted("chebyshev") {
        chebyshev::beside_legendre(&mut out)?;
        writeln!(out)?;
    }
    if wanted("sparrow") {
        sparrow::opposed_plates(&mut out)?;
        writeln!(out)?;
    }
    if wanted("table-1") {
        rooms::table_1(&mut out)?;
        writeln!(out)?;
    }
    if wanted("figure-7") {
        shadow::figure_7(&mut out)?;
        writeln!(out)?;
    }
    if wanted("figure-9") {
        boxes::figure_9(&mut out)?;
        writeln!(out)?;
    }
    if wanted("figure-13") {
        rooms::figure_13(&mut out)?;
    }
    Ok(())
}
