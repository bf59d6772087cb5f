//! Error against time: panels of lines.

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use radiosity::output::drawings::chart::COLOURS;
use radiosity::output::drawings::log_axis::LogAxis;

/// Width and height in SVG units.
const SIZE: (u32, u32) = (980, 430);

/// A line with dots.
pub(crate) struct Line {
    pub(crate) label: String,
    /// Seconds and errors.
    pub(crate) places: Vec<(f64, f64)>,
}

/// The lines of a panel.
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) lines: Vec<Line>,
}

/// Draws the panels side by side; `error` says what the ordinates are.
pub(crate) fn write(path: &Path, error: &str, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    for (area, panel) in root.split_evenly((1, panels.len())).iter().zip(panels) {
        let places = || panel.lines.iter().flat_map(|line| &line.places);
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_right(16)
            .caption(&panel.title, text(16))
            .x_label_area_size(42)
            .y_label_area_size(56)
            .build_cartesian_2d(
                LogAxis::around(places().map(|place| place.0)),
                LogAxis::around(places().map(|place| place.1)),
            )?;
        chart
            .configure_mesh()
            .x_desc("time, s")
            .y_desc(error)
            .label_style(text(12))
            .axis_desc_style(text(12))
            .bold_line_style(RGBColor(200, 200, 200))
            .light_line_style(RGBColor(240, 240, 240))
            .draw()?;
        for (line, paint) in panel.lines.iter().zip(COLOURS) {
            let drawn =
                chart.draw_series(LineSeries::new(line.places.iter().copied(), paint.stroke_width(2)))?;
            drawn
                .label(&line.label)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], paint.stroke_width(2)));
            chart.draw_series(line.places.iter().map(|place| Circle::new(*place, 3, paint.filled())))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .background_style(WHITE)
            .label_font(text(12))
            .draw()?;
    }
    root.present()?;
    Ok(())
}

fn text(size: i32) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&BLACK)
}
