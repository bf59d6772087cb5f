//! Section 6.1 takes E. M. Sparrow's variational problem (*Application of variational methods to radiation
//! heat-transfer calculations*, J. Heat Transfer 82, 1960): two opposed plates of one temperature, finite in
//! width, and says that order 4 gave under 1 %.
//!
//! Strips and disks, whose radiosity obeys integral equations in one variable, solved by Nyström's method
//! ([`Opposed`]), are held against whole plates by polynomials in three dimensions. A strip is a parallelogram
//! 8 times as long as wide between others that go on to 1000 widths; its radiosity is read across its middle.
//! All light is integrated, and projected: nothing is recomputed at points.

use std::error::Error;
use std::io::Write;

use radiosity::Work;
use radiosity::geom::DVec3;
use radiosity::geom::shapes::{Disk, FULL_TURN, Parallelogram};
use radiosity::scene::{Material, Scene, SceneBuilder};
use radiosity::solve::solved::Solved;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::work::digits::significant;
use radiosity_test_support::opposed::{Opposed, Plates};

use crate::curves::{OfOrder, panel, side_by_side};
use crate::squares::{ORDERS, header};

/// Reflectances, each a band of the scene.
const REFLECTANCES: [f64; 3] = [0.1, 0.5, 0.9];
/// Distances of strips (widths) and of disks (radii): nearer disks take minutes.
const STRIPS: [f64; 3] = [0.1, 0.5, 1.0];
const DISKS: [f64; 3] = [0.5, 1.0, 2.0];
/// Where plates of strips end along them (widths).
const ENDS: [f64; 8] = [-1000.0, -200.0, -30.0, -4.0, 4.0, 30.0, 200.0, 1000.0];
/// Places along a plate.
const PLACES: usize = 200;

/// Errors of all orders.
struct Errors {
    mean: Vec<f64>,
    largest: Vec<f64>,
}

/// Prints the errors of strips and disks, and draws those of the brightest.
pub(crate) fn opposed_plates(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    header(out, "Sparrow's plates: mean error of the radiosity in %", "largest, N = 4")?;
    let mut lines = Vec::new();
    for (name, plates, distances) in [("strips", Plates::Strips, STRIPS), ("disks", Plates::Disks, DISKS)] {
        for distance in distances {
            for (reflectance, errors) in REFLECTANCES.into_iter().zip(errors(plates, distance)?) {
                let Errors { mean, largest } = errors;
                write!(out, "| {name}, distance {distance}, ρ = {reflectance} |")?;
                mean.iter().try_for_each(|mean| write!(out, " {} |", significant(*mean, 2)))?;
                writeln!(out, " {} |", significant(largest[4], 2))?;
                if reflectance == REFLECTANCES[2] {
                    lines.push(OfOrder { label: format!("{name} at {distance}"), values: mean });
                }
            }
        }
    }
    let caption = "mean error of the radiosity, ρ = 0.9; distances in widths, in radii";
    side_by_side("docs/sparrow.svg", "Two opposed plates of one temperature", caption, vec![panel("", lines)])
}

/// Errors for each reflectance.
fn errors(plates: Plates, distance: f64) -> Result<Vec<Errors>, Box<dyn Error>> {
    let truths = REFLECTANCES.map(|reflectance| Opposed::new(plates, distance, reflectance));
    let empty = || Errors { mean: Vec::new(), largest: Vec::new() };
    let mut errors: Vec<Errors> = REFLECTANCES.iter().map(|_| empty()).collect();
    let scene = scene(plates, distance)?;
    let read = scene.surface_named("read")?;
    for order in 0..ORDERS {
        let options = Options {
            order,
            subdivide: Some(1),
            eps: 1e-6,
            shadow_eps: 1e-6,
            transport: Transport::Exact,
            direct: Direct::Projected,
            ..Options::default()
        };
        let solved = Solved::new(scene.clone(), options, &Work::alone())?;
        for (band, (truth, errors)) in truths.iter().zip(&mut errors).enumerate() {
            let (mut sum, mut largest) = (0.0, 0.0f64);
            for k in 0..PLACES {
                let x = (k as f64 + 0.5) / PLACES as f64;
                let (parameters, place) = match plates {
                    Plates::Strips => ([0.0, 2.0 * x - 1.0], x - 0.5),
                    // Equal areas of rings.
                    Plates::Disks => ([0.2, 1.0 - 2.0 * x.sqrt()], x.sqrt()),
                };
                let found = solved.radiosity_at(read, parameters).ok_or("plates have no holes")?[band];
                let missed = (found / truth.radiosity(place) - 1.0).abs();
                (sum, largest) = (sum + missed, largest.max(missed));
            }
            errors.mean.push(100.0 * sum / PLACES as f64);
            errors.largest.push(100.0 * largest);
        }
    }
    Ok(errors)
}

/// The plates, of exitance 1; the surface that is read is called so.
fn scene(plates: Plates, distance: f64) -> Result<Scene, Box<dyn Error>> {
    let mut scene = SceneBuilder::new("opposed plates", ["ρ = 0.1", "ρ = 0.5", "ρ = 0.9"]);
    let grey = scene.material("grey", Material::new(REFLECTANCES.to_vec(), vec![1.0; 3])?);
    match plates {
        Plates::Disks => {
            for (name, height, normal) in [("read", 0.0, DVec3::Z), ("other", distance, -DVec3::Z)] {
                let center = height * DVec3::Z;
                scene.surface(name, Disk::new(center, normal, 1.0, 0.0, FULL_TURN)?, &grey);
            }
        }
        Plates::Strips => {
            for ends in ENDS.windows(2) {
                let [from, length] = [ends[0], ends[1] - ends[0]];
                let corner = DVec3::new(from, -0.5, 0.0);
                let (along, across) = (length * DVec3::X, DVec3::Y);
                let name = if from < 0.0 && from + length > 0.0 {
                    "read".into()
                } else {
                    format!("lower at {from}")
                };
                scene.surface(name, Parallelogram::new(corner, along, across)?, &grey);
                let opposite = Parallelogram::new(corner + distance * DVec3::Z, across, along)?;
                scene.surface(format!("upper at {from}"), opposite, &grey);
            }
        }
    }
    Ok(scene.build()?)
}
