//! Surfaces: their irradiance and powers.

use super::light_part::LightPart;
use crate::output::document::{Block, Column, Table};
use crate::output::round::{column, significant};
use crate::output::shown::{Shown, of_bands, power_unit};
use crate::output::surface_light::SurfaceLight;
use crate::scene::{Scene, SceneSurface};

/// Most rows of a table. Chosen: some ten pages.
const MOST: usize = 400;

/// Most bands that have columns of their own. Chosen: what fits across a page.
const FEW: usize = 4;

pub(super) fn blocks(scene: &Scene, light: &LightPart) -> Vec<Block> {
    let listed = listed(&light.surfaces);
    let [n, m] = light.cells;
    let quantity = Shown::Irradiance.name(&scene.unit);
    let several = if scene.bands.len() > 1 {
        " Irradiance is the mean of the bands, powers are their sum."
    } else {
        ""
    };
    let unit = power_unit(&scene.unit);
    let mut blocks = vec![
        Block::Heading("Surfaces".to_owned()),
        Block::Text(format!(
            "Means of the {quantity} over each surface, the least and the greatest mean over one of its {n} × {m} cells, and \
             powers that arrive, are absorbed and are emitted.{several} Areas and powers are in m² and {unit} where lengths \
             are metres."
        )),
    ];
    if listed.len() < light.surfaces.len() {
        blocks.push(Block::Text(format!(
            "The {} surfaces that receive most of {} are listed; `radiosity grid` has all.",
            listed.len(),
            light.surfaces.len()
        )));
    }
    blocks.push(Block::Table(powers(scene, &light.surfaces, &listed)));
    if (2..=FEW).contains(&scene.bands.len()) {
        blocks.extend([
            Block::Subheading("By band".to_owned()),
            Block::Text(format!("Reflectance ρ and mean {quantity} E of each band.")),
            Block::Table(by_band(scene, &listed)),
        ]);
    }
    blocks
}

/// The surfaces with rows of their own, in the scene's order: all, or those that receive most.
fn listed(surfaces: &[SurfaceLight]) -> Vec<&SurfaceLight> {
    let mut listed: Vec<&SurfaceLight> = surfaces.iter().collect();
    listed.sort_by(|a, b| sum(&b.received).total_cmp(&sum(&a.received)));
    listed.truncate(MOST);
    listed.sort_by_key(|own| own.surface);
    listed
}

fn sum(values: &[f64]) -> f64 {
    values.iter().sum()
}

fn material(surface: &SceneSurface) -> String {
    surface.material_name.clone().unwrap_or_else(|| "–".to_owned())
}

fn powers(scene: &Scene, all: &[SurfaceLight], listed: &[&SurfaceLight]) -> Table {
    let (unit, power) = (scene.unit.as_str(), power_unit(&scene.unit));
    let has_reflectance = scene.bands.len() == 1;
    let reflectance = has_reflectance.then(|| Column::numbers("ρ", ""));
    let irradiance = ["E mean", "E min", "E max"].map(|head| Column::numbers(head, unit));
    let powers = ["received", "absorbed", "emitted"].map(|head| Column::numbers(head, &power));
    let names = [Column::text("surface"), Column::text("material")];
    let columns = names.into_iter().chain(reflectance).chain([Column::numbers("area", "m²")]);
    let mut table = Table::new(columns.chain(irradiance).chain(powers).collect::<Vec<_>>());
    let of =
        |value: fn(&SurfaceLight) -> f64| column(&listed.iter().map(|own| value(own)).collect::<Vec<_>>());
    let irradiances: Vec<f64> = listed
        .iter()
        .flat_map(|own| [of_bands(&own.irradiance, None), own.extremes[0], own.extremes[1]])
        .collect();
    let irradiances = column(&irradiances);
    let whole = |value: fn(&SurfaceLight) -> f64| all.iter().map(value).sum::<f64>();
    let columns: [(fn(&SurfaceLight) -> f64, Vec<String>); 3] = [
        (|own| sum(&own.received), of(|own| sum(&own.received))),
        (|own| sum(&own.absorbed), of(|own| sum(&own.absorbed))),
        (|own| sum(&own.emitted), of(|own| sum(&own.emitted))),
    ];
    for (index, own) in listed.iter().enumerate() {
        let surface = &scene.surfaces[own.surface];
        let reflectance = has_reflectance.then(|| significant(surface.material.reflectance[0], 3));
        let mut cells = vec![surface.name.clone(), material(surface)];
        cells.extend(reflectance);
        cells.push(significant(own.area, 4));
        cells.extend_from_slice(&irradiances[3 * index..3 * index + 3]);
        cells.extend(columns.iter().map(|(value, texts)| match value(own) {
            0.0 => "–".to_owned(),
            _ => texts[index].clone(),
        }));
        table.row(cells);
    }
    let blank = |count: usize| vec![String::new(); count];
    let mut total = vec!["all surfaces".to_owned()];
    total.extend(blank(1 + usize::from(has_reflectance)));
    total.push(significant(whole(|own| own.area), 4));
    total.extend(blank(3));
    total.extend(columns.iter().map(|(value, _)| significant(whole(*value), 4)));
    table.total = Some(total);
    table
}

fn by_band(scene: &Scene, listed: &[&SurfaceLight]) -> Table {
    let bands = &scene.bands;
    let reflectances = bands.iter().map(|band| Column::numbers(&format!("ρ {band}"), ""));
    let irradiances = bands.iter().map(|band| Column::numbers(&format!("E {band}"), &scene.unit));
    let names = [Column::text("surface"), Column::text("material")];
    let mut table = Table::new(names.into_iter().chain(reflectances).chain(irradiances).collect::<Vec<_>>());
    let values: Vec<f64> = listed.iter().flat_map(|own| own.irradiance.clone()).collect();
    for (own, values) in listed.iter().zip(column(&values).chunks(bands.len())) {
        let surface = &scene.surfaces[own.surface];
        let mut cells = vec![surface.name.clone(), material(surface)];
        cells.extend(surface.material.reflectance.iter().map(|rho| significant(*rho, 3)));
        cells.extend_from_slice(values);
        table.row(cells);
    }
    table
}
