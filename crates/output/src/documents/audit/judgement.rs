//! A verdict with its tables: as text, CSV or JSON.

use std::borrow::Cow;
use std::io::{self, Write};

use radiosity_audit::{Checked, Verdict};
use radiosity_work::digits::{decimals, significant};
use serde::Serialize;

use crate::table::{Column, Table, Value};

/// Signed means that are shown at the least; all that exceed chance are. Chosen.
const SIGNED: usize = 5;

/// Digits of printed and of true numbers in texts. Chosen.
pub(super) const DIGITS: usize = 5;

/// Rays of a million, in texts.
const MILLION: f64 = 1e6;

/// A verdict with what it was reached by, and its tables.
#[derive(Debug)]
pub struct Judgement<'a> {
    /// The verdict.
    pub(super) verdict: &'a Verdict,
    /// The errors that it makes of those that the run tells by itself.
    pub(super) checked: &'a Checked,
    /// Plural noun of what is judged.
    pub(super) of: &'static str,
    /// Words for the thing that has so many walks.
    pub(super) walks_of: &'static str,
    /// Walks for each of these.
    pub(super) walks: u64,
    /// Number of things that could not be judged.
    pub(super) unread: usize,
    /// Why that is so.
    pub(super) unread_because: &'static str,
    /// Bands of light; none for other things.
    pub(super) bands: &'a [String],
    /// Unit of printed numbers; none where they have none.
    pub(super) unit: &'a str,
    /// Units of the table of the worst.
    pub(super) units: Cow<'a, str>,
    /// The worst, for people.
    pub(super) worst: Table<'a>,
    /// Whether classes have means of more than one number.
    pub(super) has_means: bool,
    /// All, for programs.
    pub(super) all: Table<'a>,
}

impl Judgement<'_> {
    /// The verdict in a line, and a line about what is more than the run tells.
    pub fn summary(&self) -> Vec<String> {
        [self.checked.to_string()].into_iter().chain(self.finding()).collect()
    }

    /// For people: the verdict in lines, the worst, and the largest signed means.
    pub fn text(&self) -> String {
        let mut lines = vec![self.checked.to_string(), self.effort()];
        lines.extend(self.unread());
        lines.extend(self.finding());
        let (head, of, units) = (lines.join("\n"), self.of, &self.units);
        let worst = format!("{head}\n\nthe {of} that differ most{units}\n{}", self.worst);
        match self.has_means {
            true => format!("{worst}\nmeans of signed differences\n{}", signed(self.verdict)),
            false => worst,
        }
    }

    /// CSV with a row for each printed number, with what was found, its standard error, the relative
    /// difference and that difference in standard errors.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn csv(&self, out: impl Write) -> io::Result<()> {
        self.all.listed().csv(out)
    }

    /// JSON with the verdict and all printed numbers.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn json(&self, mut out: impl Write) -> io::Result<()> {
        let verdict = self.verdict;
        let document = Document {
            bands: self.bands,
            unit: self.unit,
            error: verdict.error(),
            error_sd: verdict.error_sd(),
            visible: verdict.visible(),
            told: self.checked.own_error,
            finds_more: self.checked.finds_more(),
            error_factor: self.checked.error_factor,
            readings: verdict.readings,
            unread: self.unread,
            rays: verdict.rays,
            walks: self.walks,
            signed: &verdict.signed,
            worst: &verdict.worst,
            points: self.all.listed(),
        };
        serde_json::to_writer_pretty(&mut out, &document)?;
        writeln!(out)
    }

    /// The line about rays, and what they let see.
    fn effort(&self) -> String {
        format!(
            "{} million rays, {} walks a {}: an error of {} % would be seen; the run tells {} %",
            significant(self.verdict.rays as f64 / MILLION, 3),
            self.walks,
            self.walks_of,
            percent(self.verdict.visible()),
            percent(self.checked.own_error)
        )
    }

    /// The line about what could not be read, if there is any.
    fn unread(&self) -> Option<String> {
        (self.unread > 0).then(|| format!("{} more {}", self.unread, self.unread_because))
    }

    /// The line about a verdict that finds more than the run tells.
    fn finding(&self) -> Option<String> {
        let found = self.checked.finding()?;
        Some(format!("more than the run tells, {} %: {found}", percent(self.checked.own_error)))
    }
}

fn percent(part: f64) -> String {
    significant(100.0 * part, 2)
}

fn signed(verdict: &Verdict) -> Table<'static> {
    let columns = ["of"].map(Column::text).to_vec();
    let numbers = ["readings", "difference %", "s %", "in s", ""];
    let columns = [columns, numbers.map(|head| Column::numbers(head, "")).to_vec()].concat();
    let shown = verdict.signed.iter().enumerate().filter(|(rank, own)| *rank < SIGNED || own.is_finding);
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
pub(super) fn signed_percent(part: f64) -> String {
    if part.is_finite() { decimals(100.0 * part, 2) } else { "–".to_owned() }
}

/// The mark of what stands out.
pub(super) fn mark(is_outlier: bool) -> String {
    if is_outlier { "stands out" } else { "" }.to_owned()
}

/// A number, if it is one.
pub(super) fn finite(number: f64) -> Value<'static> {
    Some(number).filter(|number| number.is_finite()).into()
}

#[derive(Serialize)]
struct Document<'a, S, W, P> {
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    bands: &'a [String],
    #[serde(skip_serializing_if = "str::is_empty")]
    unit: &'a str,
    error: f64,
    error_sd: f64,
    visible: f64,
    told: f64,
    finds_more: bool,
    error_factor: f64,
    readings: usize,
    unread: usize,
    rays: u64,
    walks: u64,
    signed: &'a [S],
    worst: &'a [W],
    points: P,
}
