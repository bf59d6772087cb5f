//! Luminaires whose light reaches no front, and what is odd about their tables.

use std::f64::consts::PI;

use radiosity_geom::{DVec3, Ray};

use crate::inspection::warning::Warning;
use crate::scene::{Distribution, Luminaire, Scene};
use crate::visibility::{OWN_END, Shadows, Visibility};

/// Rays that look for a front that a luminaire lights. Chosen.
const RAYS: u32 = 256;

/// Units of illuminance, in which the light of tables comes out.
const ILLUMINANCE: [&str; 4] = ["lx", "lux", "lm/m²", "lm/m^2"];

/// What is odd about the luminaires of a scene.
pub(super) fn odd(scene: &Scene) -> Vec<Warning> {
    if scene.luminaires.is_empty() {
        return Vec::new();
    }
    let visibility = Visibility::new(scene, Shadows::Rays(1e-3));
    let of_each = scene.luminaires.iter().flat_map(|own| {
        let dark = (own.emits() && !lights_a_front(own, &visibility)).then(|| {
            let message = "lights no front of a surface: it is within a body, behind a wall or outside the room; move it, \
                           or turn it";
            Warning::of_luminaire("unlit", &own.name, message)
        });
        dark.into_iter().chain(remarks(own))
    });
    of_each.chain(unit(scene)).collect()
}

/// Whether a ray of its light meets a front, beyond the surface that it may be mounted on.
fn lights_a_front(own: &Luminaire, visibility: &Visibility) -> bool {
    let around = (0..RAYS).map(direction);
    let mut lit = [own.aim].into_iter().chain(around).filter(|direction| own.relative(*direction) > 0.0);
    let start = OWN_END * visibility.bounds().diagonal();
    lit.any(|direction: DVec3| {
        let ray = Ray { range: [start, f64::INFINITY], ..Ray::new(own.position, direction) };
        visibility.nearest(&ray).is_some_and(|met| met.front)
    })
}

/// One of [`RAYS`] directions around, evenly spread: a spiral that turns by the golden angle from one to the next.
fn direction(index: u32) -> DVec3 {
    let z = 1.0 - (2 * index + 1) as f64 / f64::from(RAYS);
    let (sin, cos) = (f64::from(index) * PI * (3.0 - 5.0_f64.sqrt())).sin_cos();
    let across = (1.0 - z * z).sqrt();
    DVec3::new(across * cos, across * sin, z)
}

/// What its table says of itself.
fn remarks(own: &Luminaire) -> Vec<Warning> {
    let Distribution::Table(table) = &own.distribution else { return Vec::new() };
    let remark =
        |text: &str| Warning::of_luminaire("photometry", &own.name, &format!("has an odd table: {text}"));
    table.notes.iter().map(|note| remark(&note.text)).collect()
}

/// A unit that is not that of tables.
fn unit(scene: &Scene) -> Option<Warning> {
    let is_table = |own: &&Luminaire| matches!(own.distribution, Distribution::Table(_));
    let first = scene.luminaires.iter().find(is_table)?;
    let is_lux = ILLUMINANCE.contains(&scene.unit.as_str());
    let message = format!(
        "has a table in candela, from which illuminance comes out in lx where lengths are in metres, yet the unit of the \
         scene is {}: state unit = \"lx\"",
        scene.unit
    );
    (!is_lux).then(|| Warning::of_luminaire("unit", &first.name, &message))
}
