//! The error that is told against the true one.

use std::error::Error;
use std::path::Path;

use radiosity::Scene;
use radiosity::Work;
use radiosity::solve::{Options, Outcome, Transport, solve};

use crate::apart::{apart, means};
use radiosity_studies::boxes::room;
use radiosity_studies::spread::print_spread;

/// Rays of the runs that are judged.
const RAYS: [u64; 4] = [25_000, 100_000, 400_000, 1_600_000];

/// Rays of the truth over those of the last run but one.
const FINER: u64 = 100;

/// Boxes along the three edges of the hall.
const HALL: [usize; 3] = [4, 3, 2];

/// A built-in scene with its settings, and cuts along u and v of its surfaces.
struct Study {
    name: &'static str,
    settings: &'static [(&'static str, f64)],
    cuts: usize,
}

const BUILT_IN: [Study; 7] = [
    Study { name: "cornell-box", settings: &[], cuts: 3 },
    Study { name: "empty-box", settings: &[], cuts: 3 },
    Study { name: "occluder-box", settings: &[], cuts: 3 },
    Study { name: "occluder-box", settings: &[("reflectance", 0.9), ("height", 0.2)], cuts: 2 },
    Study { name: "two-boxes", settings: &[], cuts: 2 },
    Study { name: "teapot", settings: &[], cuts: 2 },
    Study { name: "temple", settings: &[("bays", 3.0)], cuts: 1 },
];

/// Prints the table of all scenes.
pub(crate) fn told(folder: Option<&Path>) -> Result<(), Box<dyn Error>> {
    println!("| scene | rays | told | true | told / true |");
    println!("| --- | --- | --- | --- | --- |");
    let mut ratios = Vec::new();
    for Study { name, settings, cuts } in BUILT_IN {
        let scene = radiosity::language::read(&radiosity::language::source(name, settings)?)?;
        let settings: String = settings.iter().map(|(name, value)| format!(", {name} {value}")).collect();
        judge(&format!("{name}{settings}"), &scene, cuts, &mut ratios)?;
    }
    judge("hall of 150 surfaces", &room(HALL), 1, &mut ratios)?;
    for name in ["soda", "classroom"] {
        if let Some(folder) = folder {
            let path = folder.join(format!("{name}.json"));
            let scene = radiosity::load(path.to_str().ok_or("the path is no text")?)?;
            judge(name, &scene, 1, &mut ratios)?;
        }
    }
    print_spread("told / true", ratios);
    Ok(())
}

/// Prints the rows of a scene, and adds their ratios.
fn judge(name: &str, scene: &Scene, cuts: usize, ratios: &mut Vec<f64>) -> Result<(), Box<dyn Error>> {
    let truth = irradiances(&by_rays(scene, cuts, FINER * RAYS[2])?);
    for rays in RAYS {
        let outcome = by_rays(scene, cuts, rays)?;
        let sampling = outcome.sampling.ok_or("rays were asked for")?;
        let list = outcome.solution.elements().list();
        let found = irradiances(&outcome);
        let bands = found.iter().zip(&truth).map(|(found, truth)| apart(list, found, truth));
        let error = bands.fold(0.0, f64::max);
        let told = sampling.error.unwrap_or(f64::NAN);
        ratios.push(told / error);
        println!(
            "| {name} | {} | {:.2} % | {:.2} % | {:.2} |",
            sampling.rays,
            100.0 * told,
            100.0 * error,
            told / error
        );
    }
    Ok(())
}

/// Mean irradiances of the elements, band by band.
fn irradiances(outcome: &Outcome) -> Vec<Vec<f64>> {
    let list = outcome.solution.elements().list();
    outcome.solution.bands().iter().map(|band| means(list, &band.coefficients.irradiance)).collect()
}

/// A solution on elements that do not depend on the number of rays.
fn by_rays(scene: &Scene, cuts: usize, rays: u64) -> Result<Outcome, Box<dyn Error>> {
    let transport = Transport::Sampled;
    let options =
        Options { transport, order: 1, subdivide: Some(cuts), rays: Some(rays), ..Options::default() };
    Ok(solve(scene, &options, &Work::alone())?)
}
