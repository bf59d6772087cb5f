//! Error against time: panels of lines.

use std::error::Error;
use std::fs;
use std::path::Path;

use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};

/// A panel of lines through seconds and errors; `error` says what the ordinates are.
pub(crate) fn panel(title: &str, error: &str, lines: impl IntoIterator<Item = Line>) -> Panel {
    let dot = |(seconds, error)| Dot { place: [seconds, error], text: String::new() };
    let curve = |(line, colour): (Line, [u8; 3])| Curve {
        label: line.label,
        colour,
        dots: line.places.into_iter().map(dot).collect(),
        others: Vec::new(),
    };
    let curves = lines.into_iter().zip(COLOURS).map(curve).collect();
    let axes = ["time, s", error].map(str::to_owned);
    Panel { title: title.to_owned(), axes, along: Spacing::Logarithmic, curves }
}

/// A line with dots.
pub(crate) struct Line {
    pub(crate) label: String,
    /// Seconds and errors.
    pub(crate) places: Vec<(f64, f64)>,
}

/// Draws the panels side by side.
pub(crate) fn write(path: &Path, caption: &str, panels: Vec<Panel>) -> Result<(), Box<dyn Error>> {
    let [title, caption] = ["Error against time", caption].map(str::to_owned);
    let diagram = Diagram { title, caption, columns: panels.len(), panels };
    Ok(fs::write(path, diagram.drawing().svg())?)
}
