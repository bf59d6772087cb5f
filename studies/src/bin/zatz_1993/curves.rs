//! Errors in percent against order, drawn.

use std::error::Error;
use std::fs;

use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};

const BLACK: [u8; 3] = [0; 3];

/// A line through the errors (%) of the orders 0, 1, 2, …
pub(crate) struct OfOrder {
    pub(crate) label: String,
    pub(crate) values: Vec<f64>,
}

/// Draws lines in one panel, and marks where the paper prints a number: an order, and an error (%).
pub(crate) fn write(
    path: &str,
    title: &str,
    lines: Vec<OfOrder>,
    marks: &[(usize, f64)],
) -> Result<(), Box<dyn Error>> {
    let mut panel = panel("", lines);
    panel.curves.extend(marks.iter().map(|(order, error)| Curve {
        label: "numbers that the paper prints".to_owned(),
        colour: BLACK,
        dots: vec![Dot { place: [*order as f64, *error], text: error.to_string() }],
        others: Vec::new(),
    }));
    side_by_side(path, title, "metric (30): mean of the relative error over 500 × 500 points", vec![panel])
}

/// A panel of lines.
pub(crate) fn panel(title: &str, lines: Vec<OfOrder>) -> Panel {
    let dot = |(order, error): (usize, f64)| Dot { place: [order as f64, error], text: String::new() };
    let curve = |(OfOrder { label, values }, colour)| {
        // Exact ones have no place on a logarithmic axis.
        let dots = values.into_iter().enumerate().filter(|(_, error)| *error > 0.0).map(dot);
        Curve { label, colour, dots: dots.collect(), others: Vec::new() }
    };
    let curves = lines.into_iter().zip(COLOURS).map(curve).collect();
    let axes = ["order N", "error, %"].map(str::to_owned);
    Panel { title: title.to_owned(), axes, along: Spacing::Linear, curves }
}

/// Draws panels, at most two in a row.
pub(crate) fn side_by_side(
    path: &str,
    title: &str,
    caption: &str,
    panels: Vec<Panel>,
) -> Result<(), Box<dyn Error>> {
    let [title, caption] = [title, caption].map(str::to_owned);
    let diagram = Diagram { title, caption, columns: panels.len().min(2), panels };
    Ok(fs::write(path, diagram.drawing().svg())?)
}
