//! The referee beside other witnesses, by files of `../shared/cases`.
//!
//! `cargo run --release -p radiosity-studies --bin referee_rooms -- [WALKS] [rooms] [faults]`: for the sensors of
//! sixty random rooms that another program has path-traced, z = (M − mc)/√(s² + s_mc²), by what stands in the
//! rooms; for scenes on which this program errs or has erred, what it prints, the true error where it is known, and
//! what the referee tells. A folder that is missing is passed over with a message.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "tables for people")]

use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;
use std::{env, fs};

use radiosity::audit::{Effort, Estimate, Judged, Referee, Spot, Verdict};
use radiosity::geom::DVec3;
use radiosity::reading::probe::{Probe, probe};
use radiosity::reading::quality::Quality;
use radiosity::{Options, Scene, Solved, Work, load};

/// Folder of the cases.
const CASES: &str = "../shared/cases";

/// Walks for each sensor.
const WALKS: f64 = 65536.0;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let walks = words.iter().find_map(|own| own.parse().ok()).unwrap_or(WALKS);
    let wants = |name: &str| {
        words.iter().any(|own| own == name) || words.iter().all(|own| own.parse::<f64>().is_ok())
    };
    for (name, table) in [("rooms", rooms as fn(&Path, f64) -> _), ("faults", faults)] {
        if !wants(name) {
            continue;
        }
        if !Path::new(CASES).exists() {
            eprintln!("{CASES} is missing: {name} are passed over");
            continue;
        }
        table(Path::new(CASES), walks)?;
    }
    Ok(())
}

/// The points of a file, in its coordinates, with unit normals.
fn points(path: &Path) -> Result<Vec<(DVec3, DVec3)>, Box<dyn Error>> {
    let mut rows = csv::Reader::from_path(path)?;
    let rows = rows.deserialize::<[f64; 6]>();
    let point = |[x, y, z, a, b, c]: [f64; 6]| (DVec3::new(x, y, z), DVec3::new(a, b, c).normalize());
    rows.map(|row| Ok(point(row?))).collect()
}

/// What the referee finds at points.
fn estimates(scene: &Scene, points: &[(DVec3, DVec3)], walks: f64) -> Vec<Estimate> {
    let spot = |(position, normal): &(DVec3, DVec3)| Spot::Point {
        position: *position - scene.middle,
        normal: *normal,
    };
    let spots: Vec<Spot> = points.iter().map(spot).collect();
    Referee::of_light(scene).estimates(&spots, &Effort::of_walks(walks), &Work::alone())
}

/// z of sensors.
#[derive(Default)]
struct Scores {
    rooms: usize,
    list: Vec<f64>,
    /// Relative noise of the referee and of the other program, squared and summed.
    noise: [f64; 2],
}

impl Scores {
    fn print(&self, name: &str) {
        let count = self.list.len() as f64;
        let mean = self.list.iter().sum::<f64>() / count;
        let square = self.list.iter().map(|own| own * own).sum::<f64>() / count;
        let largest = self.list.iter().fold(0.0_f64, |largest, own| largest.max(own.abs()));
        let [own, other] = self.noise.map(|sum| 100.0 * (sum / count).sqrt());
        println!(
            "| {name} | {} | {} | {mean:.2} ± {:.2} | {:.2} | {largest:.1} | {own:.2} | {other:.2} |",
            self.rooms,
            self.list.len(),
            count.sqrt().recip(),
            square.sqrt(),
        );
    }
}

/// Starts of the names of surfaces, by kind.
const KINDS: [(&str, &[&str]); 14] = [
    ("windows", &["window", "rev"]),
    ("tables, desks", &["top", "desk", "dt"]),
    ("shelves", &["shelf", "cab"]),
    ("rugs, pictures", &["rug", "pic"]),
    ("crates", &["crate"]),
    ("partitions", &["par"]),
    ("leaning sheets", &["sheet"]),
    ("shades", &["sh", "bulb"]),
    ("bodies below lamps", &["lamp-bottom"]),
    ("balls, domes", &["ball", "dome"]),
    ("cylinders", &["bin", "col"]),
    ("cones", &["cone"]),
    ("tori", &["tor"]),
    ("pillars, beams", &["pil", "across", "head"]),
];

fn kinds(scene: &Scene) -> Vec<&'static str> {
    let stem =
        |name: &str| name.chars().take_while(|own| !own.is_ascii_digit() && *own != ':').collect::<String>();
    let stems: Vec<String> = scene.surfaces.iter().map(|own| stem(&own.name)).collect();
    let has = |names: &[&str]| names.iter().any(|name| stems.iter().any(|own| own == name));
    KINDS.into_iter().filter(|(_, names)| has(names)).map(|(kind, _)| kind).collect()
}

fn rooms(folder: &Path, walks: f64) -> Result<(), Box<dyn Error>> {
    let mut by_kind: BTreeMap<&str, Scores> = BTreeMap::new();
    let mut paths: Vec<_> =
        fs::read_dir(folder.join("rooms"))?.map(|own| own.map(|own| own.path())).collect::<Result<_, _>>()?;
    paths.retain(|path| path.extension().is_some_and(|own| own == "mc"));
    paths.sort();
    for path in paths {
        let scene = load(path.with_extension("json").to_string_lossy().as_ref())?;
        let points = points(&path.with_extension("csv"))?;
        let found = estimates(&scene, &points, walks);
        let lines = fs::read_to_string(&path)?;
        let mut kinds = kinds(&scene);
        kinds.push("all");
        for kind in &kinds {
            by_kind.entry(kind).or_default().rooms += 1;
        }
        for ((number, line), estimate) in lines.lines().enumerate().zip(&found) {
            let numbers: Vec<f64> = line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
            let (mean, own) = (numbers[0], estimate.bands[0]);
            let error = numbers[1];
            let z = (own.value - mean) / own.error.hypot(error);
            if z.abs() > 4.0 {
                let (x, n) = points[number];
                println!(
                    "{}, sensor {number} at {x} along {n}: referee {:.4} ± {:.4}, other program {mean:.4} ± {error:.4}: z = {z:.1}",
                    path.file_stem().unwrap_or_default().to_string_lossy(),
                    own.value,
                    own.error
                );
            }
            for kind in &kinds {
                let scores = by_kind.entry(kind).or_default();
                scores.list.push(z);
                scores.noise[0] += (own.error / mean).powi(2);
                scores.noise[1] += (error / mean).powi(2);
            }
        }
    }
    println!(
        "| rooms with | rooms | sensors | mean of z | spread of z | largest | noise of the referee, % | of the other, % |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    by_kind.iter().for_each(|(kind, scores)| scores.print(kind));
    Ok(())
}

/// A scene on which this program errs or has erred.
struct Fault {
    scene: &'static str,
    points: Where,
    /// The right values of some sensors, where they are known.
    right: &'static [(usize, f64)],
}

/// Where light is read.
enum Where {
    File(&'static str),
    /// At points of both sides of this surface and of all others.
    Sample,
}

/// Right values are those of the notes on the cases: of path tracing (± 0.15 %), of furnaces 2.
const FAULTS: [Fault; 9] = [
    Fault {
        scene: "adversary/01-sky-horizon.json",
        points: Where::File("adversary/01-sky-horizon-direct.csv"),
        right: &[],
    },
    Fault {
        scene: "adversary/01-sky-horizon.json",
        points: Where::File("adversary/01-sky-horizon-walls.csv"),
        right: &[],
    },
    Fault {
        scene: "adversary/02-table-shadow-cells.json",
        points: Where::File("adversary/02-table-shadow-cells.csv"),
        right: &[],
    },
    Fault {
        scene: "adversary/03-mat-on-desk.json",
        points: Where::File("adversary/03-mat-on-desk.csv"),
        right: &[],
    },
    Fault {
        scene: "adversary/03b-disk-lifted-1e-6.json",
        points: Where::File("adversary/03b-disk-lifted-1e-6.csv"),
        right: &[],
    },
    Fault {
        scene: "adversary/04-one-sided-disk-back.json",
        points: Where::File("adversary/04-one-sided-disk-back.csv"),
        right: &[],
    },
    Fault {
        scene: "adversary/05-sheet-edge-rays.json",
        points: Where::File("adversary/05-sheet-edge-rays.csv"),
        right: &[],
    },
    Fault {
        scene: "adversary/06-disk-luminaire-far.json",
        points: Where::File("adversary/06-disk-luminaire-far.csv"),
        right: &[],
    },
    Fault { scene: "papers/t_bez2.toml", points: Where::Sample, right: &[] },
];

fn faults(folder: &Path, walks: f64) -> Result<(), Box<dyn Error>> {
    println!("| scene | sensor | printed | referee | ± | right |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let mut verdicts = Vec::new();
    for fault in FAULTS {
        let scene = load(folder.join(fault.scene).to_string_lossy().as_ref())?;
        let points = match fault.points {
            Where::File(path) => points(&folder.join(path))?,
            Where::Sample => {
                let sample = Referee::of_light(&scene).sample(64, 0);
                let place = |spot: Spot| match spot {
                    Spot::Point { position, normal } => Some((position + scene.middle, normal)),
                    _ => None,
                };
                sample.into_iter().filter_map(|own| place(own.spot)).collect()
            }
        };
        let found = estimates(&scene, &points, walks);
        let printed = printed(scene, &points)?;
        for (number, (estimate, printed)) in found.iter().zip(&printed).enumerate() {
            let own = estimate.bands[0];
            let right = fault.right.iter().find(|(sensor, _)| *sensor == number);
            let right = right.map_or(String::new(), |(_, value)| format!("{value:.4}"));
            println!(
                "| {} | {number} | {printed:.4} | {:.4} | {:.4} | {right} |",
                fault.scene, own.value, own.error
            );
        }
        let judge = |(estimate, printed): (Estimate, &f64)| Judged {
            printed: vec![*printed],
            printed_groups: Vec::new(),
            estimate,
            weight: 1.0,
            class: "sensors".to_owned(),
        };
        let judged: Vec<Judged> = found.into_iter().zip(&printed).map(judge).collect();
        verdicts.push((fault.scene, Verdict::of(&judged, 3)));
    }
    println!();
    println!("| scene | error told by the referee, % | ± of its square, %² | it finds something |");
    println!("| --- | --- | --- | --- |");
    for (name, verdict) in verdicts {
        println!(
            "| {name} | {:.2} | {:.3} | {} |",
            100.0 * verdict.error(),
            1e4 * verdict.squared_error,
            verdict.finds(0.0)
        );
    }
    Ok(())
}

/// What the program prints at points at its defaults.
fn printed(scene: Scene, points: &[(DVec3, DVec3)]) -> Result<Vec<f64>, Box<dyn Error>> {
    let solved = Solved::new(scene, Options::default(), &Work::alone())?;
    let reader = Quality::Default.reading().reader(&solved.outcome.solution, solved.visibility());
    let probes: Vec<Probe> =
        points.iter().map(|(position, normal)| Probe { position: *position, normal: *normal }).collect();
    let found = probe(&reader, &probes, solved.scene.middle, &Work::alone());
    let found = found.map_err(|(index, fault)| format!("sensor {index}: {fault:?}"))?;
    Ok(found.into_iter().map(|own| own.irradiance[0]).collect())
}
