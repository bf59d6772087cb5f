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
use radiosity::solve::Transport;
use radiosity::solve::gather::gather_method::GatherMethod;
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

/// Estimates of the referee at points.
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
    /// Its file, without its ending, and that of the sensors.
    files: [&'static str; 2],
    /// The right values of the sensors.
    right: Right,
}

/// Right values at the sensors of a scene.
enum Right {
    /// By a program that knows no trees, rules or elements, in which a ray tries every surface; ± 0.05 to 0.2 %.
    Traced(&'static [f64]),
    /// The light of a disk of this radius at this height, of a Lambertian intensity with the peak 1000, which
    /// nothing reflects: a sum over the disk.
    Disk { radius: f64, height: f64 },
    /// The scene is a furnace; read by cells at points of all surfaces, from exact transfers.
    Furnace(f64),
}

const FAULTS: [Fault; 10] = [
    Fault {
        files: ["adversary/01-sky-horizon.json", "adversary/01-sky-horizon-direct.csv"],
        right: Right::Traced(&[
            672.40, 556.43, 1573.25, 1350.98, 1547.79, 473.08, 477.64, 334.25, 2285.17, 4746.13, 1450.39,
            440.89,
        ]),
    },
    Fault {
        files: ["adversary/01-sky-horizon.json", "adversary/01-sky-horizon-walls.csv"],
        right: Right::Traced(&[626.24, 473.66, 555.09, 828.99, 564.69, 353.38, 662.40, 1573.99]),
    },
    Fault {
        files: ["adversary/02-table-shadow-cells.json", "adversary/02-table-shadow-cells.csv"],
        right: Right::Traced(&[10.7865, 10.1219, 9.8386, 10.6412, 10.0129, 9.6787]),
    },
    Fault {
        files: ["adversary/03-mat-on-desk.json", "adversary/03-mat-on-desk.csv"],
        right: Right::Traced(&[172.63, 184.44, 172.71, 161.14, 172.58, 172.57, 26.52]),
    },
    Fault {
        files: ["adversary/03b-disk-lifted-1e-6.json", "adversary/03b-disk-lifted-1e-6.csv"],
        right: Right::Traced(&[190.47, 0.00, 178.08, 201.33, 27.57]),
    },
    Fault {
        files: ["adversary/04-one-sided-disk-back.json", "adversary/04-one-sided-disk-back.csv"],
        right: Right::Traced(&[30.8101, 30.7805]),
    },
    Fault {
        files: ["adversary/05-sheet-edge-rays.json", "adversary/05-sheet-edge-rays.csv"],
        right: Right::Traced(&[142.65, 46.20, 57.78, 81.59, 81.56]),
    },
    Fault {
        files: ["adversary/06-disk-luminaire-far.json", "adversary/06-disk-luminaire-far.csv"],
        right: Right::Disk { radius: 0.2, height: 2.0 },
    },
    Fault { files: ["papers/t_bez2.toml", ""], right: Right::Furnace(2.0) },
    Fault { files: ["papers/t_sph2.toml", ""], right: Right::Furnace(2.0) },
];

impl Right {
    /// Right values at points.
    fn at(&self, points: &[(DVec3, DVec3)]) -> Vec<f64> {
        match self {
            Self::Traced(values) => values.to_vec(),
            Self::Disk { radius, height } => {
                points.iter().map(|own| by_disk(*radius, *height, own)).collect()
            }
            Self::Furnace(light) => vec![*light; points.len()],
        }
    }
}

/// ⟨I cos γ cos θ / r²⟩ over a disk above the origin that faces down, I = 1000.
fn by_disk(radius: f64, height: f64, (point, normal): &(DVec3, DVec3)) -> f64 {
    const SIDE: usize = 1000;
    let part = |k: usize| (k as f64 + 0.5) / SIDE as f64;
    let light = |k: usize| {
        let (sine, cosine) = (std::f64::consts::TAU * part(k / SIDE)).sin_cos();
        let out = radius * part(k % SIDE).sqrt();
        let step = DVec3::new(out * cosine, out * sine, height) - *point;
        1000.0 * step.z * normal.dot(step).max(0.0) / step.length().powi(4)
    };
    (0..SIDE * SIDE).map(light).sum::<f64>() / (SIDE * SIDE) as f64
}

/// √(Σ (a − b)² / Σ b²).
fn distance(found: impl Iterator<Item = f64>, right: &[f64]) -> f64 {
    let squares: f64 = found.zip(right).map(|(a, b)| (a - b) * (a - b)).sum();
    (squares / right.iter().map(|own| own * own).sum::<f64>()).sqrt()
}

fn faults(folder: &Path, walks: f64) -> Result<(), Box<dyn Error>> {
    println!(
        "| scene | sensors | printed: true error, % | the referee tells, % | ± | it finds something | its own error, % |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for Fault { files: [file, sensors], right } in FAULTS {
        let scene = load(folder.join(file).to_string_lossy().as_ref())?;
        let points = match right {
            Right::Furnace(_) => sample(&scene),
            _ => points(&folder.join(sensors))?,
        };
        let found = estimates(&scene, &points, walks);
        let printed = printed(scene, &points, matches!(right, Right::Furnace(_)))?;
        let right = right.at(&points);
        let own = distance(found.iter().map(|own| own.bands[0].value), &right);
        let judge = |(estimate, printed): (Estimate, &f64)| Judged {
            printed: vec![*printed],
            printed_groups: Vec::new(),
            estimate,
            size: 1.0,
            class: "sensors".to_owned(),
        };
        let judged: Vec<Judged> = found.into_iter().zip(&printed).map(judge).collect();
        let verdict = Verdict::of(&judged, 3);
        let name = if sensors.is_empty() { file } else { sensors };
        println!(
            "| {name} | {} | {:.3} | {:.3} | {:.3} | {} | {:.3} |",
            points.len(),
            100.0 * distance(printed.iter().copied(), &right),
            100.0 * verdict.error(),
            // Of the root: half the relative error of the square.
            50.0 * verdict.squared_error / verdict.error().max(1e-12),
            if verdict.finds(0.0) { "yes" } else { "no" },
            100.0 * own
        );
    }
    Ok(())
}

/// Points of all surfaces, in the coordinates of the scene's text.
fn sample(scene: &Scene) -> Vec<(DVec3, DVec3)> {
    let place = |spot: Spot| match spot {
        Spot::Point { position, normal } => Some((position + scene.middle, normal)),
        _ => None,
    };
    Referee::of_light(scene).sample(256, 0).into_iter().filter_map(|own| place(own.spot)).collect()
}

/// Numbers that the program prints at points at its defaults, or by cells from exact transfers.
fn printed(scene: Scene, points: &[(DVec3, DVec3)], is_by_cells: bool) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut options = Options::default();
    let mut reading = Quality::Default.reading();
    if is_by_cells {
        options.transport = Transport::Exact;
        reading.by = GatherMethod::Cells;
    }
    let solved = Solved::new(scene, options, &Work::alone())?;
    let reader = reading.reader(&solved.outcome.solution, solved.visibility());
    let probe_at = |(position, normal): &(DVec3, DVec3)| Probe { position: *position, normal: *normal };
    let probes: Vec<Probe> = points.iter().map(probe_at).collect();
    let found = probe(&reader, &probes, solved.scene.middle, &Work::alone());
    let found = found.map_err(|(index, fault)| format!("sensor {index}: {fault:?}"))?;
    Ok(found.into_iter().map(|own| own.irradiance[0]).collect())
}
