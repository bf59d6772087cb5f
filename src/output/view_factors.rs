//! View factors as CSV, JSON or NPY.
//!
//! The matrix is written row by row, N × N, F_ij in row i and column j.

use std::io::{self, Write};

use serde::Serialize;
use serde::ser::{SerializeSeq, Serializer};

use crate::output::npy;
use crate::view_factors::ViewFactors;

/// CSV with the names as header and as first column.
///
/// # Errors
/// What `out` reports.
pub fn csv(factors: &ViewFactors, out: impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    let header = ["surface"].into_iter().chain(factors.names.iter().map(String::as_str));
    writer.write_record(header)?;
    for (i, name) in factors.names.iter().enumerate() {
        let numbers = factors.row(i).into_iter().map(|factor| factor.to_string());
        writer.write_record([name.clone()].into_iter().chain(numbers))?;
    }
    writer.flush()
}

/// NPY, an array of shape (N, N).
///
/// # Errors
/// What `out` reports.
pub fn npy(factors: &ViewFactors, out: impl Write) -> io::Result<()> {
    let count = factors.names.len();
    npy::square(count, (0..count).map(|i| factors.row(i)), out)
}

/// JSON with names, areas, the matrix, its row sums and how good it is.
///
/// # Errors
/// What `out` reports.
pub fn json(factors: &ViewFactors, mut out: impl Write) -> io::Result<()> {
    serde_json::to_writer(&mut out, &Document::of(factors))?;
    writeln!(out)
}

/// The pairs (i, j) only, as CSV with 17 digits.
///
/// # Errors
/// What `out` reports.
pub fn pairs_csv(factors: &ViewFactors, pairs: &[[usize; 2]], out: impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(["from", "to", "F"])?;
    for [i, j] in pairs {
        let factor = format!("{:.16e}", factors.factor(*i, *j));
        writer.write_record([&factors.names[*i], &factors.names[*j], &factor])?;
    }
    writer.flush()
}

/// The pairs (i, j) only, as JSON.
///
/// # Errors
/// What `out` reports.
pub fn pairs_json(factors: &ViewFactors, pairs: &[[usize; 2]], mut out: impl Write) -> io::Result<()> {
    let pair = |[i, j]: &[usize; 2]| Pair {
        from: &factors.names[*i],
        to: &factors.names[*j],
        factor: factors.factor(*i, *j),
    };
    serde_json::to_writer(&mut out, &pairs.iter().map(pair).collect::<Vec<_>>())?;
    writeln!(out)
}

#[derive(Serialize)]
struct Pair<'a> {
    from: &'a str,
    to: &'a str,
    factor: f64,
}

#[derive(Serialize)]
struct Document<'a> {
    surfaces: &'a [String],
    areas: &'a [f64],
    factors: Rows<'a>,
    row_sums: Vec<f64>,
    reciprocity_max: f64,
    reciprocity_pairs: usize,
    accuracy_reached: f64,
    kernel_samples: u64,
    shadow_rays: u64,
    seconds: f64,
}

impl<'a> Document<'a> {
    fn of(factors: &'a ViewFactors) -> Self {
        Self {
            surfaces: &factors.names,
            areas: &factors.areas,
            factors: Rows(factors),
            row_sums: factors.row_sums(),
            reciprocity_max: factors.reciprocity.largest,
            reciprocity_pairs: factors.reciprocity.pairs,
            accuracy_reached: factors.accuracy_reached,
            kernel_samples: factors.samples,
            shadow_rays: factors.rays,
            seconds: factors.elapsed.as_secs_f64(),
        }
    }
}

/// The rows of the matrix, each made when it is written.
struct Rows<'a>(&'a ViewFactors);

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let count = self.0.names.len();
        let mut rows = serializer.serialize_seq(Some(count))?;
        (0..count).try_for_each(|i| rows.serialize_element(&self.0.row(i)))?;
        rows.end()
    }
}
