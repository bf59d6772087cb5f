//! Error against time and unknowns, drawn.

use std::error::Error;
use std::fs;

use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};

use crate::ways::Run;

const BLACK: [u8; 3] = [0; 3];

/// A panel with a curve for each way.
pub(crate) fn panel(title: &str, axis: &str, runs: &[Run], along: impl Fn(&Run) -> f64) -> Panel {
    let groups = runs.chunk_by(|one, other| one.label == other.label);
    let curve = |(own, colour): (&[Run], [u8; 3])| Curve {
        label: own[0].label.to_owned(),
        colour,
        dots: own.iter().map(|run| Dot { place: [along(run), run.error], text: String::new() }).collect(),
        others: Vec::new(),
    };
    Panel {
        title: title.to_owned(),
        axes: [axis, "relative error of the floor"].map(str::to_owned),
        along: Spacing::Logarithmic,
        curves: groups.zip(COLOURS.into_iter().chain([BLACK])).map(curve).collect(),
    }
}

/// Draws the panels, those of a scene side by side.
pub(crate) fn write(path: &str, panels: Vec<Panel>) -> Result<(), Box<dyn Error>> {
    let diagram = Diagram {
        title: "One shadow by a discontinuity mesh, by masks and gathered".to_owned(),
        caption: "relative L2 error of the floor's irradiance, against CPU time and against unknowns"
            .to_owned(),
        columns: 2,
        panels,
    };
    Ok(fs::write(path, diagram.drawing().svg())?)
}
