//! The cost of a solution of a scene by its usual ways, before any is made.

use std::time::Instant;

use radiosity_output::table::{Column, Table};
use radiosity_reading::quality::Quality;
use radiosity_request::MethodRequest;
use radiosity_scene::Scene;
use radiosity_solve::driver::{RunForecast, Transport};
use radiosity_work::digits::significant;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Machine, Work};
use serde_json::{Value, json};

use crate::error::CliError;
use crate::progress::Progress;

/// A way to solve a scene, as its options on the command line, and what it takes.
#[derive(Debug)]
pub(super) struct Way {
    options: &'static str,
    forecast: RunForecast,
    /// Seconds by the clock of the threads of this machine.
    seconds: f64,
}

impl Way {
    /// The usual ways to solve `scene`.
    ///
    /// # Errors
    /// A scene that cannot be cut into elements.
    pub(super) fn all(scene: &Scene, ranks: &Ranks) -> Result<Vec<Self>, CliError> {
        let of_quality = |quality| MethodRequest { quality: Some(quality), ..MethodRequest::default() };
        let by = |transport| MethodRequest { transport: Some(transport), ..MethodRequest::default() };
        let ways = [
            ("", MethodRequest::default()),
            ("--quality quick", of_quality(Quality::Quick)),
            ("--quality fine", of_quality(Quality::Fine)),
            ("--transport sampled", by(Transport::Sampled)),
            ("--transport exact", by(Transport::Exact)),
        ];
        let asked = ways.each_ref().map(|(_, request)| request.options(ranks));
        let progress = Progress::new(false, 0, Instant::now(), ranks);
        let work = Work::among(ranks).observed_by(&progress);
        let forecasts = RunForecast::all(scene, &asked, &work)?;
        let machine = Machine::of(ranks.threads(0));
        let way = |((options, _), forecast): ((&'static str, MethodRequest), RunForecast)| Self {
            options,
            forecast,
            seconds: machine.seconds(forecast.seconds),
        };
        Ok(ways.into_iter().zip(forecasts).map(way).collect())
    }

    /// A table of ways for people.
    pub(super) fn table(ways: &[Self]) -> Table<'static> {
        let ways_of = ["solve", "light goes by"].map(Column::text);
        let counts = ["elements", "unknowns a band"].map(|head| Column::numbers(head, ""));
        let limits = [Column::numbers("about", "s"), Column::numbers("at the most", "MB")];
        let columns: Vec<Column> = ways_of.into_iter().chain(counts).chain(limits).collect();
        Table::new(columns, ways.iter().map(Self::row))
    }

    fn row(&self) -> [String; 6] {
        let Self { options, forecast, seconds } = self;
        let carrier = forecast.rays.map_or_else(|| "rules".to_owned(), |rays| format!("{rays} rays"));
        let options = if options.is_empty() { "at the defaults" } else { options };
        [
            options.to_owned(),
            carrier,
            forecast.elements.to_string(),
            forecast.unknowns.to_string(),
            significant(*seconds, 2),
            format!("{:.0}", forecast.bytes as f64 / 1e6),
        ]
    }

    /// The way for programs.
    pub(super) fn as_json(&self) -> Value {
        let Self { options, forecast, seconds } = self;
        json!({
            "options": options, "rays": forecast.rays, "elements": forecast.elements, "unknowns": forecast.unknowns,
            "seconds": seconds, "bytes": forecast.bytes,
        })
    }
}
