//! Surfaces: their irradiance and powers.

use radiosity_scene::{Scene, SceneSurface};

use super::light_part::LightPart;
use crate::documents::document::Block;
use crate::table::{Column, Table};
use radiosity_reading::quantity::{Quantity, of_bands, power_unit};
use radiosity_reading::surface_light::SurfaceLight;
use radiosity_work::digits::{column, significant};

/// Most rows of a table. Chosen: some ten pages.
const MOST: usize = 400;

/// Rows of a table up to which every surface has one. Chosen: a page.
const PAGE: usize = 40;

/// Part of the light that the listed surfaces of larger scenes receive. Chosen.
const LISTED: f64 = 0.99;

/// Most bands that have columns of their own. Chosen: what fits across a page.
const FEW: usize = 4;

pub(super) fn blocks(scene: &Scene, light: &LightPart) -> Vec<Block> {
    let listed = listed(&light.surfaces);
    let cells = light.cells.map_or_else(String::new, |[n, m]| format!("{n} × {m} "));
    let quantity = Quantity::Irradiance.name(&scene.unit);
    let several = if scene.bands.len() > 1 {
        " Irradiance is the mean of the bands, powers are their sum."
    } else {
        ""
    };
    let unit = power_unit(&scene.unit);
    let mut blocks = vec![
        Block::Heading("Surfaces".to_owned()),
        Block::Text(format!(
            "Means of the {quantity} over each surface, the least and the greatest mean over one of its {cells}cells, and \
             powers that arrive, are absorbed and are emitted.{several} Areas and powers are in m² and {unit} where lengths \
             are metres."
        )),
    ];
    if listed.len() < light.surfaces.len() {
        blocks.push(Block::Text(format!(
            "The {} surfaces that receive most are listed; {} others receive {:.1} % in all, and `radiosity grid` has them.",
            listed.len(),
            light.surfaces.len() - listed.len(),
            100.0 * (1.0 - received(listed.iter().copied()) / received(light.surfaces.iter()))
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

/// The surfaces with rows of their own, in the scene's order: all on a page, or those that receive most of the light.
fn listed(surfaces: &[SurfaceLight]) -> Vec<&SurfaceLight> {
    let mut listed: Vec<&SurfaceLight> = surfaces.iter().collect();
    listed.sort_by(|a, b| sum(&b.received).total_cmp(&sum(&a.received)));
    let (all, mut so_far) = (received(surfaces.iter()), 0.0);
    let is_small = |own: &&SurfaceLight| {
        let has_enough = so_far >= LISTED * all;
        so_far += sum(&own.received);
        has_enough
    };
    let large = listed.iter().position(is_small).unwrap_or(listed.len());
    listed.truncate(large.clamp(PAGE, MOST));
    listed.sort_by_key(|own| own.surface);
    listed
}

/// Power that these surfaces receive, all bands together.
fn received<'a>(surfaces: impl Iterator<Item = &'a SurfaceLight>) -> f64 {
    surfaces.map(|own| sum(&own.received)).sum()
}

fn sum(values: &[f64]) -> f64 {
    values.iter().sum()
}

/// A column with its cells and the total below them.
struct TotalledColumn {
    column: Column,
    cells: Vec<String>,
    total: String,
}

impl TotalledColumn {
    fn new(column: Column, cells: Vec<String>) -> Self {
        Self { column, cells, total: String::new() }
    }
}

/// The columns side by side.
fn table(columns: Vec<TotalledColumn>) -> Table<'static> {
    let rows = columns.first().map_or(0, |first| first.cells.len());
    let row = |row: usize| columns.iter().map(move |own| own.cells[row].clone());
    let heads: Vec<Column> = columns.iter().map(|own| own.column.clone()).collect();
    let mut table = Table::new(heads, (0..rows).map(row));
    let has_total = columns.iter().any(|own| !own.total.is_empty());
    table.total = has_total.then(|| columns.into_iter().map(|own| own.total.into()).collect());
    table
}

fn powers(scene: &Scene, all: &[SurfaceLight], listed: &[&SurfaceLight]) -> Table<'static> {
    let [mut names, materials] = names(scene, listed);
    names.total = "all surfaces".to_owned();
    let mut columns = vec![names, materials];
    if scene.bands.len() == 1 {
        columns.push(reflectance(scene, listed, 0, "ρ"));
    }
    columns.push(areas(all, listed));
    columns.extend(irradiances(scene, listed));
    let unit = power_unit(&scene.unit);
    let power = |head: &str, of: Powers| power(Column::numbers(head, &unit), of, all, listed);
    columns.extend([
        power("received", |own| &own.received),
        power("absorbed", |own| &own.absorbed),
        power("emitted", |own| &own.emitted),
    ]);
    table(columns)
}

fn by_band(scene: &Scene, listed: &[&SurfaceLight]) -> Table<'static> {
    let bands = scene.bands.iter().enumerate();
    let reflectances =
        bands.clone().map(|(band, name)| reflectance(scene, listed, band, &format!("ρ {name}")));
    let values: Vec<f64> = listed.iter().flat_map(|own| own.irradiance.clone()).collect();
    let texts = column(&values);
    let irradiances = bands.map(|(band, name)| {
        let cells = texts.iter().skip(band).step_by(scene.bands.len()).cloned().collect();
        TotalledColumn::new(Column::numbers(&format!("E {name}"), &scene.unit), cells)
    });
    table(names(scene, listed).into_iter().chain(reflectances).chain(irradiances).collect())
}

/// Names of surfaces and of their materials.
fn names(scene: &Scene, listed: &[&SurfaceLight]) -> [TotalledColumn; 2] {
    let of = |head: &str, text: fn(&SceneSurface) -> String| {
        let cells = listed.iter().map(|own| text(&scene.surfaces[own.surface])).collect();
        TotalledColumn::new(Column::text(head), cells)
    };
    let material = |surface: &SceneSurface| surface.material_name.clone().unwrap_or_else(|| "–".to_owned());
    [of("surface", |surface| surface.name.clone()), of("material", material)]
}

fn reflectance(scene: &Scene, listed: &[&SurfaceLight], band: usize, head: &str) -> TotalledColumn {
    let rho = |own: &&SurfaceLight| significant(scene.surfaces[own.surface].material.reflectance[band], 3);
    TotalledColumn::new(Column::numbers(head, ""), listed.iter().map(rho).collect())
}

fn areas(all: &[SurfaceLight], listed: &[&SurfaceLight]) -> TotalledColumn {
    let cells = listed.iter().map(|own| significant(own.area, 4)).collect();
    let total = significant(all.iter().map(|own| own.area).sum(), 4);
    TotalledColumn { column: Column::numbers("area", "m²"), cells, total }
}

/// Mean, least and greatest irradiance, all with the same decimals.
fn irradiances(scene: &Scene, listed: &[&SurfaceLight]) -> impl Iterator<Item = TotalledColumn> {
    let three = |own: &&SurfaceLight| [of_bands(&own.irradiance, None), own.extremes[0], own.extremes[1]];
    let texts = column(&listed.iter().flat_map(three).collect::<Vec<_>>());
    ["E mean", "E min", "E max"].into_iter().enumerate().map(move |(index, head)| {
        let cells = texts.iter().skip(index).step_by(3).cloned().collect();
        TotalledColumn::new(Column::numbers(head, &scene.unit), cells)
    })
}

/// A power of a surface in each band.
type Powers = fn(&SurfaceLight) -> &Vec<f64>;

/// The sum of the bands, a dash for none, and the sum over all surfaces.
fn power(column_head: Column, of: Powers, all: &[SurfaceLight], listed: &[&SurfaceLight]) -> TotalledColumn {
    let whole = all.iter().map(|own| sum(of(own))).sum();
    let values: Vec<f64> = listed.iter().map(|own| sum(of(own))).chain([whole]).collect();
    let mut cells: Vec<String> = column(&values)
        .into_iter()
        .zip(&values)
        .map(|(text, value)| if *value == 0.0 { "–".to_owned() } else { text })
        .collect();
    let total = cells.pop().unwrap_or_default();
    TotalledColumn { column: column_head, cells, total }
}
