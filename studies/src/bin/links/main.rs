//! Hierarchical radiosity: how links and time grow with the number of surfaces, and with the accuracy of one
//! scene.
//!
//! `cargo run --release -p radiosity-studies --bin links > links.md`
//!
//! `halls` alone prints the halls, `cornell` alone the Cornell box, `orders` alone links of polynomials, with
//! their curves in `docs/links.svg`. The halls are closed rooms in which boxes
//! hover. Below their table stand the exponents p of y ~ surfacesᵖ between each row and the next, and the
//! error of the smallest hall against elements of order 0 with blocks from many rays. An error is the root of
//! the mean square, by area, of the errors of the surfaces' mean irradiances, in parts of the largest of
//! these; that of the Cornell box is against polynomials of order 5. Seconds are wall time of all threads.

#![expect(clippy::print_stdout, reason = "a table for people")]

mod judge;
mod levels;
mod orders;
mod rows;
mod scales;
mod two_scale;

use std::error::Error;
use std::time::Instant;

use radiosity::published::hierarchy::{Counts, Hierarchical, HierarchyOptions, solve_hierarchically};
use radiosity::solve::{Options, Outcome, solve};
use radiosity::{Scene, Solution, Work};

use radiosity_studies::boxes::room;
use radiosity_studies::words::words;

/// Boxes along the three edges of the room.
const GRIDS: [[usize; 3]; 3] = [[7, 6, 4], [15, 13, 9], [31, 28, 19]];
/// Greatest power of a link in the halls, and rays for its visibility.
const HALLS: (f64, usize) = (1e-3, 8);
/// Rays for the blocks that the smallest hall is compared with.
const RAYS: u64 = 30_000_000;
/// Greatest powers of a link in the Cornell box.
const FALLING: [f64; 6] = [3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4];

fn main() -> Result<(), Box<dyn Error>> {
    let chosen = words(&["halls", "cornell", "rows", "orders"])?;
    let is_chosen = |name: &str| chosen.is_empty() || chosen.iter().any(|word| word == name);
    if is_chosen("halls") {
        halls();
        errors_of_hall();
    }
    if is_chosen("cornell") {
        cornell();
    }
    if is_chosen("rows") {
        rows::rows();
    }
    if is_chosen("orders") {
        orders::orders("docs/links.svg")?;
    }
    Ok(())
}

/// Solves a scene; returns the seconds that it took.
fn timed(scene: &Scene, options: &HierarchyOptions) -> (Hierarchical, f64) {
    let start = Instant::now();
    let solved = solve_hierarchically(scene, options, &|_| {}).expect("the scene can be solved");
    (solved, start.elapsed().as_secs_f64())
}

fn hall_options() -> HierarchyOptions {
    HierarchyOptions { eps: HALLS.0, rays_per_link: HALLS.1, ..HierarchyOptions::default() }
}

fn halls() {
    println!(
        "| surfaces | nodes | leaves | links | with clusters | hidden | rounds | links per surface | seconds |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    let mut rows: Vec<[f64; 3]> = Vec::new();
    for grid in GRIDS {
        let scene = room(grid);
        let (solved, seconds) = timed(&scene, &hall_options());
        let Counts { surfaces, nodes, leaves, links, cluster_links, hidden, rounds, .. } = solved.counts();
        println!(
            "| {surfaces} | {nodes} | {leaves} | {links} | {cluster_links} | {hidden} | {rounds} | {:.1} | {seconds:.2} |",
            links as f64 / surfaces as f64
        );
        rows.push([surfaces as f64, links as f64, seconds]);
    }
    println!();
    for pair in rows.windows(2) {
        let power = |k: usize| (pair[1][k] / pair[0][k]).ln() / (pair[1][0] / pair[0][0]).ln();
        let [from, to] = [pair[0][0], pair[1][0]];
        println!("{from} to {to} surfaces: links p = {:.2}, seconds p = {:.2}.", power(1), power(2));
    }
    println!();
}

/// Prints the error of the smallest hall, against blocks from many rays.
fn errors_of_hall() {
    let scene = room(GRIDS[0]);
    let options = Options { order: 0, rays: Some(RAYS), ..Options::default() };
    let Outcome { solution, .. } = solve(&scene, &options, &Work::alone()).expect("the scene can be solved");
    for separation in [1.5, 3.0] {
        let options = HierarchyOptions { separation, ..hall_options() };
        let (solved, seconds) = timed(&scene, &options);
        let (error, links) = (error(&scene, &solved, &solution), solved.counts().links);
        println!(
            "{} surfaces, separation {separation}: error {error:.1e}, {links} links, {seconds:.2} s.",
            scene.surfaces.len()
        );
    }
    println!();
}

fn cornell() {
    let scene = radiosity::builtin("cornell-box").expect("the scene is built in");
    let options = Options { order: 5, eps: 1e-4, shadow_eps: 1e-4, ..Options::default() };
    let Outcome { solution, .. } = solve(&scene, &options, &Work::alone()).expect("the scene can be solved");
    println!("| eps | leaves | links | links per leaf | links / leaves² | error | rounds | seconds |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    let mut rows: Vec<[f64; 2]> = Vec::new();
    for eps in FALLING {
        let options = HierarchyOptions { eps, least_area: 1e-6, ..HierarchyOptions::default() };
        let (solved, seconds) = timed(&scene, &options);
        let Counts { leaves, links, rounds, .. } = solved.counts();
        let (each, all) = (links as f64 / leaves as f64, links as f64 / (leaves as f64).powi(2));
        let error = error(&scene, &solved, &solution);
        rows.push([leaves as f64, links as f64]);
        println!(
            "| {eps:.0e} | {leaves} | {links} | {each:.1} | {all:.1e} | {error:.1e} | {rounds} | {seconds:.2} |"
        );
    }
    let [first, .., last] = rows[..] else { return };
    let power = (last[1] / first[1]).ln() / (last[0] / first[0]).ln();
    println!("\n{} to {} leaves: links p = {power:.2}, y ~ leavesᵖ.", first[0], last[0]);
}

/// √(Σ A (E − E*)² / Σ A) of the surfaces' mean irradiances in the first band, over the largest of them.
fn error(scene: &Scene, solved: &Hierarchical, exact: &Solution) -> f64 {
    let (mut squares, mut areas, mut largest) = (0.0, 0.0, 0.0f64);
    for (surface, own) in scene.surfaces.iter().enumerate() {
        let mean = exact.mean_irradiance(0, surface);
        let area = own.shape.area();
        squares += area * (solved.mean_irradiance(0, surface) - mean).powi(2);
        areas += area;
        largest = largest.max(mean);
    }
    (squares / areas).sqrt() / largest
}
