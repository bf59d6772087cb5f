//! Planes of sensors: figures and plans.

use radiosity_scene::{Scene, SensorPlane};

use super::light_part::{LightPart, ReportedPlane, plan_name};
use crate::documents::document::{Block, Figure};
use crate::table::{Column, Table};
use radiosity_reading::plane_figures::{BandFigures, PlaneFigures};
use radiosity_reading::quantity::Quantity;
use radiosity_reading::uniformity::Uniformity;
use radiosity_work::digits::{column, short, significant};

pub(super) fn blocks(scene: &Scene, light: &LightPart) -> Vec<Block> {
    if light.plans.is_empty() {
        return Vec::new();
    }
    let quantity = Quantity::Irradiance.name(&scene.unit);
    let mut blocks = vec![
        Block::Heading("Planes of sensors".to_owned()),
        Block::Text(format!(
            "Mean, least and greatest {quantity} of the sensors, with the uniformities U0 = min/mean (EN 12464-1) and \
             Ud = min/max."
        )),
        Block::Table(table(scene, light)),
    ];
    let left_out: usize = light.report.planes.iter().map(|plane| plane.left_out).sum();
    if left_out > 0 {
        blocks.push(Block::Text(format!(
            "The figures leave out {left_out} sensors that lie outside of the room or in solids; they are white in the plans."
        )));
    }
    blocks.extend(light.plans.iter().enumerate().map(|(index, reported)| {
        Block::Figure(Figure {
            name: plan_name(index),
            picture: reported.picture.clone(),
            alternative: format!("Plan of the {quantity} on the plane {}", reported.plane.name()),
            caption: caption(reported.plane),
        })
    }));
    blocks
}

/// A row for each plane and band.
fn table(scene: &Scene, light: &LightPart) -> Table<'static> {
    let rows: Vec<Row> =
        light.plans.iter().zip(&light.report.planes).flat_map(|(plan, own)| rows(plan, own)).collect();
    let heads = ["mean", "min", "max"].map(|head| Column::numbers(head, &scene.unit));
    let ratios = ["U0", "Ud"].map(|head| Column::numbers(head, ""));
    let band = (scene.bands.len() > 1).then(|| Column::text("band"));
    let names = [Column::text("plane")].into_iter().chain(band).chain([Column::numbers("sensors", "")]);
    let part = |part: Option<f64>| part.map_or_else(|| "–".to_owned(), |part| format!("{part:.2}"));
    let values: Vec<f64> =
        rows.iter().flat_map(|row| [row.figures.mean, row.figures.min, row.figures.max]).collect();
    let texts = column(&values);
    let cells = rows.iter().zip(texts.chunks(3)).map(|(row, values)| {
        let mut cells = vec![row.plane.name.clone()];
        cells.extend(row.band.clone());
        cells.push(row.plane.points.to_string());
        cells.extend_from_slice(values);
        cells.extend([part(row.figures.u0), part(row.figures.ud)]);
        cells
    });
    Table::new(names.chain(heads).chain(ratios).collect::<Vec<_>>(), cells)
}

/// The figures of a plane in a band, which is named where there are several.
struct Row<'a> {
    plane: &'a PlaneFigures,
    band: Option<String>,
    figures: Uniformity,
}

/// A row for each band, and one for the values of the plan where they are of none of these bands.
fn rows<'a>(reported: &ReportedPlane, plane: &'a PlaneFigures) -> Vec<Row<'a>> {
    let row = |band: Option<String>, figures: Uniformity| Row { plane, band, figures };
    match &plane.figures {
        BandFigures::One(figures) => vec![row(None, *figures)],
        BandFigures::Several { bands } => {
            let own = bands.iter().map(|named| row(Some(named.band.clone()), named.figures));
            let is_own = bands.iter().any(|named| Some(&named.band) == reported.band.as_ref());
            own.chain((!is_own).then(|| row(reported.band.clone(), reported.shown))).collect()
        }
    }
}

/// Place and grid of the plane, in a line.
fn caption(plane: &SensorPlane) -> String {
    let point = |p: radiosity_geom::DVec3| p.to_array().map(|x| short(significant_value(x))).join(", ");
    let ([n, m], [a, b]) = (plane.counts(), plane.edges());
    let spacing = [(a, n), (b, m)].map(|(edge, count)| significant(edge.length() / count as f64, 3));
    format!(
        "Plane {}: {n} × {m} sensors, {} × {} apart, from ({}) along ({}) and ({}), seen against the direction they face.",
        plane.name(),
        spacing[0],
        spacing[1],
        point(plane.origin()),
        point(a),
        point(b)
    )
}

/// `x` to six digits.
fn significant_value(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}
