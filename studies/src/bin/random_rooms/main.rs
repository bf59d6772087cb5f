//! Writes random rooms with the right light at sensors, random scenes of heat with the right flows.
//!
//! `cargo run -qr -p radiosity-studies --bin random_rooms -- FOLDER [lit COUNT] [heat COUNT] [walks WALKS]`
//!
//! Room 7 is `r7.toml`, its sensors are `r7.csv`, and `r7.mc` has a line for each of them: the mean irradiance
//! and its standard error. Heat 7 is `h7.toml`, and `h7.mc` has a line for each surface: its name, its net flow
//! (W) and its temperature (K), each with its standard error. A title names what is in the scene. Scenes are
//! equal in every run, whatever the counts.
//!
//! What is right comes from the referee, which another path tracer has judged (study `referee_rooms`), by draws
//! that no run takes by itself.

#![expect(clippy::print_stderr, reason = "progress for people")]

mod draft;
mod shell;
mod lights;
mod things;
mod sensors;
mod room;
mod enclosures;

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

use radiosity::audit::{Effort, HeatReferee, Referee, Spot};
use radiosity::{Scene, Work, load};
use radiosity_test_support::random::Random;

use crate::draft::Draft;

/// Seed of the referee's draws; runs count theirs from 0.
const SEED: u64 = 0x5EED_0062;

/// Walks for each sensor. Measured on forty rooms: a quarter of them leaves an L2 noise of 0.36 % (median).
const WALKS: f64 = 65536.0;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let folder = PathBuf::from(words.first().ok_or("name a folder for the scenes")?);
    let number = |name: &str, otherwise: f64| -> Result<f64, Box<dyn Error>> {
        let place = words.iter().position(|word| word == name);
        Ok(place.and_then(|k| words.get(k + 1)).map_or(Ok(otherwise), |word| word.parse())?)
    };
    let effort = Effort::of_walks(number("walks", WALKS)?).seeded(SEED);
    fs::create_dir_all(&folder)?;
    for case in 0..number("lit", 0.0)? as u64 {
        let mut draft = room::draw(&mut random(1, case));
        draft.title = format!("room {case}: {}", draft.kinds());
        lit(&folder.join(format!("r{case}")), &draft, &effort)?;
    }
    for case in 0..number("heat", 0.0)? as u64 {
        let mut draft = enclosures::draw(&mut random(2, case));
        draft.title = format!("heat {case}: {}", draft.kinds());
        warm(&folder.join(format!("h{case}")), &draft, &effort)?;
    }
    Ok(())
}

/// The sequence of a case.
fn random(kind: u64, case: u64) -> Random {
    let mut random = Random((kind << 32) | case);
    Random(random.bits())
}

fn written(path: &Path, draft: &Draft) -> Result<Scene, Box<dyn Error>> {
    let file = path.with_extension("toml");
    draft.tables.iter().try_for_each(|(name, text)| fs::write(file.with_file_name(name), text))?;
    fs::write(&file, draft.text())?;
    eprintln!("{}: {}", file.display(), draft.title);
    Ok(load(&file.to_string_lossy())?)
}

fn lit(path: &Path, draft: &Draft, effort: &Effort) -> Result<(), Box<dyn Error>> {
    let scene = written(path, draft)?;
    let sensors = sensors::all(&scene, draft);
    let mut rows = String::from("x,y,z,nx,ny,nz\n");
    for [x, n] in &sensors {
        writeln!(rows, "{},{},{},{},{},{}", x.x, x.y, x.z, n.x, n.y, n.z)?;
    }
    fs::write(path.with_extension("csv"), rows)?;
    let spot = |[x, normal]: &[glam::DVec3; 2]| Spot::Point { position: *x - scene.middle, normal: *normal };
    let spots: Vec<Spot> = sensors.iter().map(spot).collect();
    let mut lines = String::new();
    for estimate in Referee::of_light(&scene).estimates(&spots, effort, &Work::alone()) {
        writeln!(lines, "{} {}", estimate.bands[0].value, estimate.bands[0].error)?;
    }
    Ok(fs::write(path.with_extension("mc"), lines)?)
}

fn warm(path: &Path, draft: &Draft, effort: &Effort) -> Result<(), Box<dyn Error>> {
    let scene = written(path, draft)?;
    let surfaces: Vec<usize> = (0..scene.surfaces.len()).collect();
    let referee = HeatReferee::of(&scene).map_err(|fault| format!("{}: {fault}", path.display()))?;
    let mut lines = String::new();
    for own in referee.estimates(&surfaces, effort, &Work::alone()) {
        let name = &scene.surfaces[own.surface].name;
        let (flow, level) = (own.flow, own.temperature);
        writeln!(lines, "{name} {} {} {} {}", flow.value, flow.error, level.value, level.error)?;
    }
    Ok(fs::write(path.with_extension("mc"), lines)?)
}
