//! Growth of memory and time with the number of surfaces: a closed room in which boxes hover, at orders 0, 2
//! and 4.
//!
//! `cargo run --release -p radiosity-studies --bin sizes > sizes.md`
//!
//! Each row is a process of its own (`sizes ROW ORDER`, rows from 0), on one thread: "MB at most" is the most
//! memory that the system granted it, and seconds are of processor time, both as Linux tells them. Direct
//! light is projected, so that blocks and solver are all there is to do. Bytes of blocks are those stored,
//! one triangle, zero blocks left out; the matrix of the system is dense. Before a row is begun its memory is
//! told by [`MemoryEstimate`] and its time from the rows before it: more than 2 GB or two minutes are not
//! run. Below the table stand the exponents p of y ~ surfacesᵖ between the last two rows of each order.

#![expect(clippy::print_stdout, reason = "a table for people")]
#![expect(clippy::print_stderr, reason = "notes about the table")]

use std::process::Command;
use std::time::Duration;

use radiosity::Work;
use radiosity::elements::cells::Layers;
use radiosity::elements::coating::Coating;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::solve::driver::memory_estimate::MemoryEstimate;
use radiosity::solve::system::System;
use radiosity::solve::{Options, in_threads};
use radiosity::transport;
use radiosity::work::ranks::Ranks;
use radiosity_solvers::Settings;

use radiosity_studies::boxes::room;
use radiosity_studies::memory::most_memory;
use radiosity_studies::words::words;

const ORDERS: [usize; 3] = [0, 2, 4];
/// Orders that can be asked for are lower.
const HIGHEST: usize = 20;
/// Boxes along the three edges of the room.
const GRIDS: [[usize; 3]; 6] = [[0, 0, 0], [2, 1, 1], [2, 2, 2], [4, 4, 2], [6, 5, 4], [10, 8, 4]];
const MOST_BYTES: u64 = 2_000_000_000;
const MOST_SECONDS: f64 = 120.0;

/// Memory and time of one size at one order.
#[derive(Clone, Copy)]
struct Row {
    surfaces: usize,
    /// Megabytes, seconds of blocks, seconds of the solver.
    figures: [f64; 3],
}

fn main() -> Result<(), String> {
    let known: Vec<String> = (0..HIGHEST.max(GRIDS.len())).map(|number| number.to_string()).collect();
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    let numbers: Vec<usize> = words(&known)?.iter().filter_map(|word| word.parse().ok()).collect();
    match numbers[..] {
        [] => table(),
        [row, order] if row < GRIDS.len() => {
            in_threads(1, || measure(GRIDS[row], order)).map_err(|failure| failure.to_string())?;
        }
        _ => return Err(format!("give ROW, less than {}, and ORDER, or nothing", GRIDS.len())),
    }
    Ok(())
}

/// All rows, by processes of their own.
fn table() {
    println!(
        "| order | surfaces | unknowns | pairs | skipped | partly hidden | MB of blocks | MB of matrix | MB at most | blocks, s | solve, s |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | ---: | --- | --- |");
    let exponents: Vec<String> = ORDERS.iter().map(|order| rows(*order)).collect();
    println!("\n| order | surfaces | memory p | blocks p | solver p |\n| --- | --- | ---: | ---: | ---: |");
    println!("{}", exponents.join("\n"));
}

/// The rows of an order; tells how their figures grow.
fn rows(order: usize) -> String {
    let mut done: Vec<Row> = Vec::new();
    for (index, grid) in GRIDS.into_iter().enumerate() {
        let surfaces = 6 + 6 * grid.iter().product::<usize>();
        if let Some(why) = refusal(grid, order, &done) {
            println!("| {order} | {surfaces} | not run: {why} | | | | | | | | |");
            continue;
        }
        let program = std::env::current_exe().expect("this program has a path");
        let output = Command::new(program).args([index, order].map(|x| x.to_string())).output();
        let text = String::from_utf8(output.expect("it can be run again").stdout).expect("it prints text");
        print!("{text}");
        eprint!("{text}");
        let figures = figures(&text);
        done.push(Row { surfaces, figures });
    }
    exponents(order, &done)
}

/// The last three columns of a row.
fn figures(row: &str) -> [f64; 3] {
    let numbers: Vec<f64> = row.split('|').filter_map(|cell| cell.trim().parse().ok()).collect();
    numbers.last_chunk().copied().expect("a row ends with three figures")
}

/// Why a row is not begun.
fn refusal(grid: [usize; 3], order: usize, done: &[Row]) -> Option<String> {
    let scene = room(grid);
    let bytes = MemoryEstimate::of(&scene, &how(order), Options::default().solver, Ranks::alone()).peak();
    if bytes > MOST_BYTES {
        return Some(format!("about {:.1} GB", bytes as f64 / 1e9));
    }
    let [.., before, last] = done else { return None };
    // Processor time is told in hundredths of a second.
    let total = |row: &Row| (row.figures[1] + row.figures[2]).max(1e-2);
    let power = exponent(before, last, total).clamp(2.0, 3.0);
    let seconds = total(last) * (scene.surfaces.len() as f64 / last.surfaces as f64).powf(power);
    (seconds > MOST_SECONDS).then(|| format!("about {:.0} minutes", seconds / 60.0))
}

fn exponent(a: &Row, b: &Row, figure: impl Fn(&Row) -> f64) -> f64 {
    (figure(b) / figure(a)).ln() / (b.surfaces as f64 / a.surfaces as f64).ln()
}

fn exponents(order: usize, done: &[Row]) -> String {
    let [.., a, b] = done else { return String::new() };
    let power = |k: usize| exponent(a, b, |row: &Row| row.figures[k].max(1e-2));
    format!(
        "| {order} | {} to {} | {:.1} | {:.1} | {:.1} |",
        a.surfaces,
        b.surfaces,
        power(0),
        power(1),
        power(2)
    )
}

fn how(order: usize) -> Discretization {
    Discretization { order, space: Space::Total, subdivide: Subdivide::Uniform(1), layers: Layers::NONE }
}

/// Solves one room and prints its row.
fn measure(grid: [usize; 3], order: usize) {
    let (scene, options) = (room(grid), Options::default());
    let elements = Elements::new(&scene, &how(order)).expect("all have area");
    let visibility = options.visibility(&scene);
    let start = processor();
    let blocks = transport::assemble(
        transport::Demand::all(&elements, &visibility, options.accuracy()),
        None,
        &Work::alone(),
    );
    let integrated = processor();
    let coating = Coating::of(&scene, elements.list(), 0);
    let system = System::new(elements.list(), &blocks, &coating);
    let right = system.right_hand_side();
    let mut unknowns = vec![0.0; right.len()];
    let matrix = system.matrix().expect("it fits");
    let settings = Settings::default().with_threads(1);
    let solved = options.solver.solver.solve(&matrix, &right, &mut unknowns, &settings, &mut |_| {});
    solved.expect("walls of reflectance ½ converge");
    let seconds = [integrated - start, processor() - integrated].map(|time| time.as_secs_f64());
    let pairs = &blocks.statistics.pairs;
    let skipped = pairs.skipped_behind + pairs.skipped_coplanar + pairs.skipped_hidden;
    let stored: usize = blocks.iter().map(|block| 8 * block.values.len()).sum();
    println!(
        "| {order} | {} | {} | {} | {skipped} | {} | {:.1} | {:.1} | {:.0} | {:.2} | {:.2} |",
        scene.surfaces.len(),
        right.len(),
        pairs.total,
        pairs.partly_hidden,
        stored as f64 / 1e6,
        8.0 * (right.len() as f64).powi(2) / 1e6,
        most_memory(),
        seconds[0],
        seconds[1],
    );
}

/// Processor time of this process so far, in the ticks of Linux: hundredths of a second.
fn processor() -> Duration {
    let line = std::fs::read_to_string("/proc/self/stat").expect("Linux tells the time of processes");
    let after_name = line.rsplit(')').next().expect("the name ends in one");
    let ticks = after_name.split_whitespace().skip(11).take(2);
    Duration::from_millis(10 * ticks.filter_map(|tick| tick.parse::<u64>().ok()).sum::<u64>())
}
