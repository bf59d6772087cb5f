//! Planes of sensors: figures and plans.

use super::light_part::{LightPart, ReportedPlane, plan_name};
use crate::output::document::{Block, Column, Figure, Table};
use crate::output::plane_figures::{BandFigures, PlaneFigures};
use crate::output::round::{column, short, significant};
use crate::output::shown::Shown;
use crate::output::uniformity::Uniformity;
use crate::scene::{Scene, SensorPlane};

pub(super) fn blocks(scene: &Scene, light: &LightPart) -> Vec<Block> {
    if light.plans.is_empty() {
        return Vec::new();
    }
    let quantity = Shown::Irradiance.name(&scene.unit);
    let mut blocks = vec![
        Block::Heading("Planes of sensors".to_owned()),
        Block::Text(format!(
            "Mean, least and greatest {quantity} of the sensors, with the uniformities U0 = min/mean (EN 12464-1) and \
             Ud = min/max."
        )),
    ];
    for (index, (reported, figures)) in light.plans.iter().zip(&light.report.planes).enumerate() {
        blocks.extend([
            Block::Subheading(format!("Plane {}", reported.plane.name())),
            Block::Table(table(scene, reported, figures)),
            Block::Figure(Figure {
                name: plan_name(index),
                picture: reported.picture.clone(),
                alternative: format!("Plan of the {quantity} on the plane {}", reported.plane.name()),
                caption: caption(reported.plane),
            }),
        ]);
    }
    blocks
}

/// A row for each band, and one for what the plan shows where that is none of them.
fn table(scene: &Scene, reported: &ReportedPlane, plane: &PlaneFigures) -> Table {
    let rows: Vec<(String, Uniformity)> = match &plane.figures {
        BandFigures::One(figures) => vec![(scene.bands[0].clone(), *figures)],
        BandFigures::Several { bands } => {
            let mean = reported.band.clone().filter(|shown| !scene.bands.contains(shown));
            let own = bands.iter().map(|named| (named.band.clone(), named.figures));
            own.chain(mean.map(|name| (name, reported.shown))).collect()
        }
    };
    let heads = ["mean", "min", "max"].map(|head| Column::numbers(head, &scene.unit));
    let ratios = ["U0", "Ud"].map(|head| Column::numbers(head, ""));
    let points = Column::numbers("sensors", "");
    let mut table =
        Table::new([vec![Column::text("band"), points], heads.to_vec(), ratios.to_vec()].concat());
    let part = |part: Option<f64>| part.map_or_else(|| "–".to_owned(), |part| format!("{part:.2}"));
    let values: Vec<f64> = rows.iter().flat_map(|(_, own)| [own.mean, own.min, own.max]).collect();
    for ((band, own), values) in rows.iter().zip(column(&values).chunks(3)) {
        let cells = [band.clone(), plane.points.to_string()].into_iter().chain(values.iter().cloned());
        table.row(cells.chain([part(own.u0), part(own.ud)]).collect::<Vec<_>>());
    }
    table
}

/// Where the plane is.
fn caption(plane: &SensorPlane) -> String {
    let point = |p: radiosity_geom::DVec3| p.to_array().map(|x| short(significant_value(x))).join(", ");
    let ([n, m], [a, b]) = (plane.counts(), plane.edges());
    let spacing = [(a, n), (b, m)].map(|(edge, count)| significant(edge.length() / count as f64, 3));
    format!(
        "{n} × {m} sensors, {} × {} apart, from ({}) along ({}) and ({}), seen against the direction they face.",
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
