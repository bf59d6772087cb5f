//! The beginning: figures at a glance, and warnings.

use radiosity_heat::{Heat, HeatError, SurfaceHeat};
use radiosity_scene::Scene;
use radiosity_solve::checks::Checks;

use super::light_part::{LightPart, ReportedPlane};
use crate::documents::document::{Block, Highlight};
use radiosity_reading::quantity::{Quantity, power_unit};
use radiosity_work::digits::{decimals, error, significant, three_digits};

/// Most planes at a glance. Chosen.
const PLANES: usize = 6;

pub(super) fn blocks(
    scene: &Scene,
    light: Option<&LightPart>,
    heat: Option<Result<&Heat, &HeatError>>,
) -> Vec<Block> {
    let at_a_glance = light.iter().flat_map(|light| of_light(scene, light));
    let heat = heat.and_then(Result::ok).into_iter().flat_map(of_heat);
    let mut blocks = vec![Block::Highlights(at_a_glance.chain(heat).collect())];
    let warnings = light.iter().flat_map(|light| &light.report.warnings);
    let warnings: Vec<String> = warnings.map(|warning| warning.message.to_string()).collect();
    if !warnings.is_empty() {
        blocks.extend([Block::Heading("Warnings".to_owned()), Block::Warnings(warnings)]);
    }
    blocks
}

fn of_light(scene: &Scene, light: &LightPart) -> Vec<Highlight> {
    let quantity = Quantity::Irradiance.name(&scene.unit);
    let plane = |reported: &ReportedPlane| {
        let figures = &reported.shown;
        let u0 = figures.u0.map_or_else(|| "–".to_owned(), |u0| format!("{u0:.2}"));
        let band = reported.band.iter().map(|band| format!(", {band}")).collect::<String>();
        Highlight {
            label: format!("Mean {quantity}, plane {}{band}", reported.plane.name()),
            value: format!("{} {}", three_digits(figures.mean), scene.unit),
            note: format!("min {}, U0 {u0}", three_digits(figures.min)),
        }
    };
    let mut highlights: Vec<Highlight> = light.plans.iter().take(PLANES).map(plane).collect();
    highlights.push(power(scene, &light.report.checks));
    highlights.extend(light.report.accuracy_estimate.map(|estimate| Highlight {
        label: "Estimated relative error".to_owned(),
        value: error(estimate),
        note: String::new(),
    }));
    let warnings = light.report.warnings.len();
    highlights.push(Highlight {
        label: "Warnings".to_owned(),
        value: if warnings == 0 { "none".to_owned() } else { warnings.to_string() },
        note: String::new(),
    });
    highlights
}

fn power(scene: &Scene, checks: &Checks) -> Highlight {
    let percent = |part: f64| decimals(100.0 * part / checks.energy_in, 2);
    let note = match checks.energy_in {
        0.0 => "all lights are off".to_owned(),
        _ => {
            format!("{} % absorbed, {} % lost", percent(checks.energy_absorbed), percent(checks.energy_lost))
        }
    };
    Highlight {
        label: "Emitted power (lengths in metres)".to_owned(),
        value: format!("{} {}", significant(checks.energy_in, 4), power_unit(&scene.unit)),
        note,
    }
}

fn of_heat(heat: &Heat) -> Vec<Highlight> {
    let sum = |sign: f64| -> f64 { heat.surfaces.iter().map(|own| (sign * own.flow).max(0.0)).sum() };
    let temperature = |own: &SurfaceHeat| own.temperature;
    let least = heat.surfaces.iter().map(temperature).fold(f64::INFINITY, f64::min);
    let most = heat.surfaces.iter().map(temperature).fold(0.0, f64::max);
    vec![
        Highlight {
            label: "Radiant heat sent out".to_owned(),
            value: format!("{} W", significant(sum(1.0), 4)),
            note: format!("{} W taken up", significant(sum(-1.0), 4)),
        },
        Highlight {
            label: "Temperatures".to_owned(),
            value: format!("{} to {} K", significant(least, 4), significant(most, 4)),
            note: String::new(),
        },
    ]
}
