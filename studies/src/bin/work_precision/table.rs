//! Speed-ups of the orders over constant elements at the same error.

use std::io::{self, Write};

use crate::family::Family;
use crate::front::{Front, Time};
use crate::record::Record;
use crate::study::Study;
use crate::work::Work;

/// Errors at which times are compared.
const ERRORS: [f64; 4] = [3e-2, 1e-2, 3e-3, 1e-3];

/// Orders with a column of their own.
const ORDERS: [usize; 5] = [1, 2, 3, 4, 6];

/// The table of all studies that have runs, as Markdown.
pub(crate) fn print(out: &mut impl Write, studies: &[Study], records: &[Record]) -> io::Result<()> {
    let orders: String = ORDERS.iter().map(|order| format!(" order {order} |")).collect();
    writeln!(out, "| scene | error | constants, s |{orders} cheapest run | its s | speed-up |")?;
    writeln!(out, "| --- | --- | ---: |{} ---: | ---: | ---: |", " ---: |".repeat(ORDERS.len()))?;
    for study in studies {
        let own: Vec<&Record> = records.iter().filter(|record| record.scene == study.name).collect();
        let front =
            |family: Family| Front::of(own.iter().copied().filter(move |r| family.holds(r)), Work::Seconds);
        let constants = front(Family::Constant);
        let high = |r: &&Record| (r.kernel == "default" && r.order > 0) || r.kernel == "gathered";
        let best = Front::of(own.iter().copied().filter(high), Work::Seconds);
        for error in ERRORS {
            let (Some(slow), Some(run)) = (constants.time(error), best.first(error)) else { continue };
            write!(out, "| {} | {} % | {} |", study.title, 100.0 * error, seconds(slow))?;
            for order in ORDERS {
                write!(out, " {} |", speed_up(slow, front(Family::Orders(order, order)).time(error)))?;
            }
            let fast = best.time(error);
            let time = fast.map_or_else(String::new, seconds);
            writeln!(out, " {} | {time} | {} |", name(run), speed_up(slow, fast))?;
        }
    }
    Ok(())
}

/// Name of a run: its order, cuts, layers and gathering.
fn name(record: &Record) -> String {
    let layers = match record.layers {
        0 => String::new(),
        1 => ", 1 layer".to_owned(),
        layers => format!(", {layers} layers"),
    };
    let cells = if record.cells > 1 { format!(", {0} × {0}", record.cells) } else { String::new() };
    let gathered = if record.kernel == "gathered" { ", gathered" } else { "" };
    format!("order {}{cells}{layers}{gathered}", record.order)
}

fn seconds(time: Time) -> String {
    match time {
        Time::Reached(seconds) => digits(seconds),
        Time::Extrapolated(seconds) => format!("~{}", digits(seconds)),
        Time::MoreThan(seconds) => format!("> {}", digits(seconds)),
    }
}

/// The quotient of two times; only a baseline is prolonged.
fn speed_up(slow: Time, fast: Option<Time>) -> String {
    match (slow, fast) {
        (Time::Reached(slow), Some(Time::Reached(fast))) => digits(slow / fast),
        (Time::Extrapolated(slow), Some(Time::Reached(fast))) => format!("~{}", digits(slow / fast)),
        (Time::MoreThan(slow), Some(Time::Reached(fast))) => format!("> {}", digits(slow / fast)),
        _ => "–".to_owned(),
    }
}

/// Two digits, thousands apart.
fn digits(value: f64) -> String {
    let magnitude = value.log10().floor();
    if magnitude < 2.0 {
        return format!("{value:.0$}", (1.0 - magnitude).clamp(0.0, 5.0) as usize);
    }
    let unit = 10f64.powf(magnitude - 1.0);
    let whole = format!("{:.0}", (value / unit).round() * unit);
    let groups: Vec<&str> =
        whole.as_bytes().rchunks(3).rev().filter_map(|g| std::str::from_utf8(g).ok()).collect();
    groups.join("\u{202f}")
}
