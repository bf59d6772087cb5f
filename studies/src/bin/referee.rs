//! The referee's noise and speed: seconds in which it sees an error of 1, 0.3 and 0.1 % at 64 readings.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::env;
use std::error::Error;
use std::time::Instant;

use cpu_time::ProcessTime;
use radiosity::audit::{Effort, Referee, Spot};
use radiosity::{Work, load};

fn main() -> Result<(), Box<dyn Error>> {
    let walks: f64 = env::args().nth(1).and_then(|own| own.parse().ok()).unwrap_or(1024.0);
    for name in env::args().skip(2) {
        let scene = match radiosity::builtin(&name) {
            Ok(scene) => scene,
            Err(_) => load(&name)?,
        };
        let start = Instant::now();
        let referee = Referee::of_light(&scene);
        let built = start.elapsed().as_secs_f64();
        let points = referee.sample(64, 0);
        let spots: Vec<Spot> = points.into_iter().map(|point| point.spot).collect();
        let effort = Effort::of_walks(walks);
        let (start, cpu) = (Instant::now(), ProcessTime::now());
        let found = referee.estimates(&spots, &effort, &Work::alone());
        let (wall, cpu) = (start.elapsed().as_secs_f64(), cpu.elapsed().as_secs_f64());
        let means: f64 = found.iter().flat_map(|own| &own.bands).map(|mean| mean.value.powi(2)).sum();
        let errors: f64 = found.iter().flat_map(|own| &own.bands).map(|mean| mean.error.powi(2)).sum();
        if env::var("TOP").is_ok() {
            let mut order: Vec<usize> = (0..found.len()).collect();
            let e = |k: &usize| found[*k].bands.iter().map(|m| m.error.powi(2)).sum::<f64>();
            order.sort_by(|a, b| e(b).total_cmp(&e(a)));
            for k in order.iter().take(6) {
                println!("  {:?} {:?} {:?}", spots[*k], found[*k].bands[0], e(k).sqrt() / errors.sqrt());
            }
        }
        let rays: u64 = found.iter().map(|own| own.rays).sum();
        let all = (spots.len() as u64 * effort.walks()) as f64;
        let relative = (errors / means).sqrt();
        let noise = relative * (effort.walks() as f64).sqrt();
        // Three standard errors of err² are √(4.55 …): see docs/theory/error.md; s needed for an error e.
        let seconds = |e: f64| cpu / 2.0 * (relative / (e / 0.754)).powi(2);
        println!(
            "{name:30} build {built:.3} cpu {cpu:.2} wall {wall:.2} Mwalks/s {:.3} Mrays/s {:.2} rays/walk {:.2} rel {relative:.5} noise {noise:.3} eff {:.4} | {:.2} {:.2} {:.2} mean {:.4}",
            all / cpu * 1e-6,
            rays as f64 / cpu * 1e-6,
            rays as f64 / all,
            relative * cpu.sqrt(),
            seconds(0.01),
            seconds(0.005),
            seconds(0.002),
            found.iter().map(|own| own.bands[0].value).sum::<f64>() / found.len() as f64,
        );
    }
    Ok(())
}
