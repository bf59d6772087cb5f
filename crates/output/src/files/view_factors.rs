//! View factors as CSV, JSON, NPY or NPZ, or as View3D writes them.
//!
//! The matrix is written row by row, N × N, F_ij in row i and column j; sparse, without its zeros.

use std::io::{self, Write};

use radiosity_audit::Checked;
use radiosity_reading::checked_factors::CheckedFactors;
use radiosity_solve::view_factors::ViewFactors;
use serde::Serialize;
use serde::ser::{SerializeSeq, Serializer};

use crate::files::npy;
use crate::files::npz::Archive;
use crate::table::{Column, Listed, Value};

/// CSV with the names as header and as first column.
///
/// # Errors
/// Errors of writing to `out`.
pub fn csv(factors: &ViewFactors, out: impl Write) -> io::Result<()> {
    let columns = [Column::text("surface"), Column::several("factors", &factors.names)];
    let rows = factors.names.iter().zip(factors.rows());
    let rows = rows.map(|(name, row)| [Value::from(name.as_str()), Value::numbers(row)]);
    Listed { columns: &columns, rows }.csv(out)
}

/// NPY, an array of shape (N, N).
///
/// # Errors
/// Errors of writing to `out`.
pub fn npy(factors: &ViewFactors, out: impl Write) -> io::Result<()> {
    let count = factors.names.len();
    npy::square(count, factors.rows(), out)
}

/// Storage of a matrix without its zeros.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Sparse {
    /// Row by row: columns and factors, and where each row begins.
    Csr,
    /// Triples of row, column and factor.
    Coo,
}

/// NPZ with `F` of shape (N, N), `names`, `areas` and `errors` of shape (N,).
///
/// # Errors
/// Errors of writing to `out`.
pub fn npz(factors: &ViewFactors, told: &CheckedFactors, out: impl Write) -> io::Result<()> {
    let count = factors.names.len();
    let mut archive = Archive::new(out);
    archive.square("F", count, factors.rows())?;
    named(factors, told, archive)
}

/// NPZ with the factors that are not zero, which `scipy.sparse.load_npz` reads, and `names`, `areas` and
/// `errors` beside them.
///
/// # Errors
/// Errors of writing to `out`.
pub fn sparse_npz(
    factors: &ViewFactors,
    told: &CheckedFactors,
    sparse: Sparse,
    out: impl Write,
) -> io::Result<()> {
    let rows = factors.names.len();
    let entry = |(i, row): (usize, Vec<(usize, f64)>)| row.into_iter().map(move |(j, factor)| (i, j, factor));
    let entries = || factors.sparse_rows().enumerate().flat_map(entry);
    let count = entries().count();
    let mut archive = Archive::new(out);
    match sparse {
        Sparse::Csr => {
            let ends = factors.sparse_rows().scan(0, |end, row| {
                *end += row.len();
                Some(*end)
            });
            archive.word("format", "csr")?;
            archive.indices("indices", count, entries().map(|(_, j, _)| j))?;
            archive.counts("indptr", rows + 1, [0].into_iter().chain(ends))?;
        }
        Sparse::Coo => {
            archive.word("format", "coo")?;
            archive.indices("row", count, entries().map(|(i, ..)| i))?;
            archive.indices("col", count, entries().map(|(_, j, _)| j))?;
        }
    }
    archive.counts("shape", 2, [rows; 2].into_iter())?;
    archive.numbers("data", count, entries().map(|(.., factor)| factor))?;
    named(factors, told, archive)
}

/// Adds the names and areas of the surfaces, which are the rows and columns of a matrix, and the errors of rows, and
/// ends the archive.
fn named<W: Write>(factors: &ViewFactors, told: &CheckedFactors, mut archive: Archive<W>) -> io::Result<()> {
    archive.texts("names", factors.names.iter().map(String::as_str))?;
    archive.numbers("areas", factors.areas.len(), factors.areas.iter().copied())?;
    archive.numbers("errors", told.errors.len(), told.errors.iter().copied())?;
    archive.finish()
}

/// The pairs (i, j) whose factor is not zero, row by row.
pub fn nonzero_pairs(factors: &ViewFactors) -> Vec<[usize; 2]> {
    let rows = factors.sparse_rows().enumerate();
    rows.flat_map(|(i, row)| row.into_iter().map(move |(j, _)| [i, j])).collect()
}

/// Characters of the first line that View3D writes, and reads back by their number.
const VIEW3D_LINE: usize = 30;

/// Text in the form that View3D 3.5 writes (its format 0): a line with program, version, format, whether
/// factors are adjusted to an enclosure and whether they hold emittances (0, 0), and the number of surfaces;
/// the areas; a row of factors for each surface; and the `emittances` ε, one for each surface. Numbers have
/// all their digits.
///
/// # Errors
/// Errors of writing to `out`.
pub fn view3d(factors: &ViewFactors, emittances: &[f64], mut out: impl Write) -> io::Result<()> {
    let count = factors.names.len();
    let first = format!("radiosity {} 0 0 0 {count}", env!("CARGO_PKG_VERSION"));
    writeln!(out, "{first:<VIEW3D_LINE$}")?;
    line(&factors.areas, &mut out)?;
    factors.rows().try_for_each(|row| line(&row, &mut out))?;
    line(emittances, &mut out)
}

/// Numbers with blanks between.
fn line(numbers: &[f64], out: &mut impl Write) -> io::Result<()> {
    let words: Vec<String> = numbers.iter().map(f64::to_string).collect();
    writeln!(out, "{}", words.join(" "))
}

/// JSON with names, areas, the matrix, its row sums and how good it is, as a referee found too where it looked.
///
/// # Errors
/// Errors of writing to `out`.
pub fn json(factors: &ViewFactors, told: &CheckedFactors, mut out: impl Write) -> io::Result<()> {
    serde_json::to_writer(&mut out, &Document::of(factors, told))?;
    writeln!(out)
}

/// The pairs (i, j) only, as CSV with 17 digits, with the largest error in the row of each.
///
/// # Errors
/// Errors of writing to `out`.
pub fn pairs_csv(
    factors: &ViewFactors,
    told: &CheckedFactors,
    pairs: &[[usize; 2]],
    out: impl Write,
) -> io::Result<()> {
    let rows =
        pairs.iter().map(|pair| named_factor(factors, told, pair, |factor| format!("{factor:.16e}").into()));
    Listed { columns: &["from", "to", "F", "error"].map(Column::text), rows }.csv(out)
}

/// The pairs (i, j) only, as JSON, with the largest error in the row of each.
///
/// # Errors
/// Errors of writing to `out`.
pub fn pairs_json(
    factors: &ViewFactors,
    told: &CheckedFactors,
    pairs: &[[usize; 2]],
    mut out: impl Write,
) -> io::Result<()> {
    let rows = pairs.iter().map(|pair| named_factor(factors, told, pair, Value::from));
    let columns = ["from", "to", "factor", "error"].map(Column::text);
    serde_json::to_writer(&mut out, &Listed { columns: &columns, rows })?;
    writeln!(out)
}

/// The names of a pair, its factor, and the error of its row.
fn named_factor<'a>(
    factors: &'a ViewFactors,
    told: &CheckedFactors,
    [i, j]: &[usize; 2],
    shown: impl Fn(f64) -> Value<'a>,
) -> [Value<'a>; 4] {
    [
        factors.names[*i].as_str().into(),
        factors.names[*j].as_str().into(),
        shown(factors.factor(*i, *j)),
        told.errors[*i].into(),
    ]
}

#[derive(Serialize)]
struct Document<'a> {
    surfaces: &'a [String],
    areas: &'a [f64],
    factors: Rows<'a>,
    row_sums: Vec<f64>,
    errors: &'a [f64],
    #[serde(flatten)]
    checked: Option<&'a Checked>,
    accuracy_reached: f64,
    kernel_samples: u64,
    /// Segments tested for visibility, where rules carry the pairs.
    shadow_rays: u64,
    transport: Transport<'a>,
    seconds: f64,
}

/// The carrier of the pairs.
#[derive(Serialize)]
struct Transport<'a> {
    /// `exact` or `sampled`.
    kind: &'a str,
    why: &'a str,
    /// Rays sent; 0 if exact.
    rays: u64,
    /// Pairs of elements that rules carried beside the rays.
    exact_pairs: usize,
}

impl<'a> Transport<'a> {
    fn of(factors: &'a ViewFactors) -> Self {
        let ViewFactors { choice, rays, exact_pairs, .. } = factors;
        let (kind, rays) = if choice.sampled { ("sampled", *rays) } else { ("exact", 0) };
        Self { kind, why: &choice.why, rays, exact_pairs: *exact_pairs }
    }
}

impl<'a> Document<'a> {
    fn of(factors: &'a ViewFactors, told: &'a CheckedFactors) -> Self {
        Self {
            surfaces: &factors.names,
            areas: &factors.areas,
            factors: Rows(factors),
            row_sums: factors.row_sums(),
            errors: &told.errors,
            checked: told.checked.as_ref(),
            accuracy_reached: told.largest(),
            kernel_samples: factors.samples,
            shadow_rays: if factors.choice.sampled { 0 } else { factors.rays },
            transport: Transport::of(factors),
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
        self.0.rows().try_for_each(|row| rows.serialize_element(&row))?;
        rows.end()
    }
}
