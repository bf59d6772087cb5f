//! `radiosity check`: what is in a scene, and what looks wrong.

use std::{
    fmt::{self, Write as _},
    io::{Write as _, stdout},
};

use clap::Args;
use radiosity::scene::{Camera, Scene, SceneSurface};

use crate::cli::{error::CliError, options::SceneArg, table::Table};

/// Says what is in a scene, and what looks wrong
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  radiosity check room.toml")]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,
}

/// Prints the scene's bands, surfaces and camera, then the warnings.
pub(crate) fn run(_: &CheckArgs, scene: &Scene) -> Result<(), CliError> {
    let mut text = String::new();
    describe(scene, &mut text).expect("a String takes all text");
    Ok(stdout().write_all(text.as_bytes())?)
}

fn describe(scene: &Scene, text: &mut String) -> fmt::Result {
    writeln!(text, "{}: {}", scene.origin, scene.title.as_deref().unwrap_or("(no title)"))?;
    writeln!(text, "bands: {}", scene.bands.join(", "))?;
    let area: f64 = scene.surfaces.iter().map(|surface| surface.shape.area()).sum();
    let emitters = scene.surfaces.iter().filter(|surface| surface.material.emits()).count();
    writeln!(text, "surfaces: {}, of which {emitters} emit; total area {area:.6}\n", scene.surfaces.len())?;
    writeln!(text, "{}", surface_table(&scene.surfaces))?;
    match &scene.camera {
        Some(camera) => writeln!(text, "camera: {}", camera_line(camera))?,
        None => writeln!(text, "camera: none")?,
    }
    let warnings = warnings(scene);
    for warning in &warnings {
        writeln!(text, "warning: {warning}")?;
    }
    if warnings.is_empty() { writeln!(text, "nothing looks wrong") } else { Ok(()) }
}

fn surface_table(surfaces: &[SceneSurface]) -> Table<6> {
    let mut table = Table::new(["surface", "shape", "area", "normal", "material", "reflectance"]);
    for surface in surfaces {
        let center = surface.shape.jet(0.0, 0.0).normal;
        let curved = if surface.shape.region().is_some() { "" } else { " at its centre" };
        table.row([
            surface.name.clone(),
            surface.kind.to_owned(),
            format!("{:.6}", surface.shape.area()),
            vector(center.to_array()) + curved,
            surface.material_name.clone().unwrap_or_else(|| "none".to_owned()),
            numbers(&surface.material.reflectance),
        ]);
    }
    table
}

/// Three decimals, without the −0 of rounding.
fn vector(numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers.map(|number| (number * 1e3).round() / 1e3 + 0.0);
    format!("({x}, {y}, {z})")
}

fn numbers(numbers: &[f64]) -> String {
    let equal = numbers.iter().all(|number| *number == numbers[0]);
    let shown = if equal { &numbers[..1] } else { numbers };
    shown.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
}

fn camera_line(camera: &Camera) -> String {
    let Camera { eye, target, fov, width, height, .. } = camera;
    let (eye, target) = (vector(eye.to_array()), vector(target.to_array()));
    format!("at {eye}, looking at {target}, {fov:.1} degrees high, {width}x{height} pixels")
}

/// Reflectances above this make light bounce so often that a small error in them is a large one in the result.
const BRIGHT: f64 = 0.95;

fn warnings(scene: &Scene) -> Vec<String> {
    let mut warnings = Vec::new();
    if !scene.surfaces.iter().any(|surface| surface.material.emits()) {
        warnings.push("no surface emits light: give a material an emission above 0".to_owned());
    }
    for surface in &scene.surfaces {
        let name = &surface.name;
        let bright = surface.material.reflectance.iter().copied().fold(0.0, f64::max);
        if surface.material_name.is_none() {
            warnings.push(format!("surface {name:?} has no material, it counts as black"));
        } else if bright > BRIGHT {
            warnings.push(format!("surface {name:?} reflects {bright}, few real materials exceed {BRIGHT}"));
        }
    }
    if scene.camera.is_none() {
        warnings.push("there is no camera for a picture: add a [camera] with eye and target".to_owned());
    }
    warnings
}
