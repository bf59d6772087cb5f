//! Planes of sensors: options that name or give them.

use clap::Args;
use radiosity_geom::DVec3;
use radiosity_scene::{Fault, Scene, SensorPlane};

use crate::error::CliError;

/// The planes that are read.
#[derive(Debug, Args)]
pub(crate) struct PlaneArgs {
    /// Plane of sensors: its name in the scene, or "origin; edge; edge; spacing", as often as needed
    #[arg(long = "plane", value_name = "PLANE", allow_hyphen_values = true)]
    pub(crate) plane: Vec<String>,

    /// All planes of the scene
    #[arg(long)]
    pub(crate) planes: bool,
}

/// Form in which a plane is typed.
const FORM: &str = "write origin, edge, edge and spacing between semicolons, such as --plane \"0,0,0.75; 4,0,0; 0,3,0; 0.25\"";

impl PlaneArgs {
    /// Whether any plane was typed.
    pub(crate) fn is_typed(&self) -> bool {
        self.planes || !self.plane.is_empty()
    }

    /// The planes of the scene if all are wanted, then those that were typed.
    pub(crate) fn of(&self, scene: &Scene) -> Result<Vec<SensorPlane>, CliError> {
        if self.planes && scene.planes.is_empty() {
            let message = format!("{}: there are no planes", scene.origin);
            let cure = "define one: [planes.desk] with origin, edges and spacing; or type it with --plane";
            return Err(CliError::refused(message, cure));
        }
        let all = scene.planes.iter().filter(|_| self.planes).cloned().map(Ok);
        let typed = self.plane.iter().enumerate().map(|(index, text)| plane(text, index, scene));
        all.chain(typed).collect()
    }
}

/// The plane of that name in the scene, or else the one that `text` gives.
pub(crate) fn plane(text: &str, index: usize, scene: &Scene) -> Result<SensorPlane, CliError> {
    match scene.plane_named(text) {
        Ok(plane) => Ok(plane.clone()),
        Err(_) if text.contains(';') => given(text, index),
        Err(unknown) => Err(unknown.into()),
    }
}

/// A plane that was typed, called after its place among them.
fn given(text: &str, index: usize) -> Result<SensorPlane, CliError> {
    let parts: Vec<&str> = text.split(';').map(str::trim).collect();
    let [origin, first, second, spacing] = parts[..] else {
        return Err(refused(text, &format!("there are {} parts instead of 4", parts.len()), FORM));
    };
    let point = |what: &str, part: &str| match numbers(part)[..] {
        [Some(x), Some(y), Some(z)] => Ok(DVec3::new(x, y, z)),
        _ => Err(refused(text, &format!("the {what} '{part}' is not three numbers"), FORM)),
    };
    let [origin, first, second] =
        [point("origin", origin)?, point("first edge", first)?, point("second edge", second)?];
    let spacing = match numbers(spacing)[..] {
        [Some(both)] => [both; 2],
        [Some(along_first), Some(along_second)] => [along_first, along_second],
        _ => return Err(refused(text, &format!("the spacing '{spacing}' is not one number or two"), FORM)),
    };
    SensorPlane::new(format!("plane-{}", index + 1), origin, [first, second], spacing)
        .map_err(|fault: Fault| refused(text, &fault.to_string(), &fault.cure().unwrap_or_default()))
}

/// The numbers between commas.
fn numbers(text: &str) -> Vec<Option<f64>> {
    text.split(',').map(|number| number.trim().parse().ok()).collect()
}

fn refused(text: &str, fault: &str, cure: &str) -> CliError {
    CliError::refused(format!("--plane \"{text}\": {fault}"), cure)
}
