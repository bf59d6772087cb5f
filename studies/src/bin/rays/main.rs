//! The sampled transport: error against time, time against surfaces, and whether the error told is true.
//!
//! `cargo run --release -p radiosity-studies --bin rays -- STUDY`, with one of
//!
//! * `rooms FOLDER FILE.svg`: scenes `NAME.json` with points `NAME_reference.json`, which have a position
//!   `p`, a normal `n` and an irradiance `E` each. E is read at the points by rays from the solution, and by
//!   samples of the emitters themselves; "L2" is √(Σ (E − E_ref)² / Σ E_ref²), "median" that of
//!   |E − E_ref| / E_ref over points above 1 % of the mean.
//! * `halls`: the closed rooms of the study `sizes`, at the rays that 3 % of error are told for.
//! * `told [FOLDER]`: the error told against the true one (100 times as many rays, the same elements) in
//!   built-in scenes, a hall, and the rooms of FOLDER.
//! * `against SCENE`: error of the irradiance at points, by rays and by exact blocks (`temple`: minutes); the
//!   truth is by 10⁸ rays.
//! * `sooner FILE.svg`: error against time of exact blocks, of rays, and of both together, in two rooms of
//!   few surfaces.
//!
//! Seconds are of wall time, all of the solution but reading the scene; memory is the most that the process
//! had so far (Linux).

#![expect(clippy::print_stdout, reason = "a table for people")]

mod judge;
mod diagram;
mod rooms;
mod halls;
mod apart;
mod told;
mod against;
mod sooner;

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["rooms", folder, file] => rooms::rooms(Path::new(folder), Path::new(file)),
        ["halls"] => halls::halls(),
        ["told"] => told::told(None),
        ["told", folder] => told::told(Some(Path::new(folder))),
        ["against", scene] => against::against(scene),
        ["sooner", file] => sooner::sooner(Path::new(file)),
        _ => Err(
            "say which study: rooms FOLDER FILE.svg, halls, told [FOLDER], against SCENE, or sooner FILE.svg"
                .into(),
        ),
    }
}
