//! The chart of a convergence study: error against unknowns and against time, on logarithmic axes.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use radiosity_solve::studies::convergence::{ConvergenceRun, RunSeries};

use super::canvas::Canvas;
use super::log_axis::LogAxis;
use super::picture::Picture;

/// A chart that could not be drawn.
#[derive(Debug, thiserror::Error)]
#[error("the chart could not be drawn: {0}")]
pub struct ChartError(String);

/// Width and height of the chart in SVG units; the PNG has twice as many pixels. Chosen.
const SIZE: (u32, u32) = (980, 470);

/// Colours that most eyes distinguish, in grey too (Okabe and Ito).
pub const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];

/// The content of a chart.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Title, above the chart.
    pub title: String,
    /// The line below the title: what the errors are measured against.
    pub caption: String,
    /// Runs, sorted by their way and by the number of layers; runs without an error above 0 are not shown.
    pub runs: &'a [ConvergenceRun],
}

impl Chart<'_> {
    /// The chart as SVG.
    ///
    /// # Errors
    /// Errors of the drawing library.
    pub fn svg(&self) -> Result<String, ChartError> {
        let mut text = String::new();
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        self.draw(&root, 1).map_err(|error| ChartError(error.to_string()))?;
        drop(root);
        Ok(text)
    }

    /// The chart as a picture.
    ///
    /// # Errors
    /// Errors of the drawing library.
    pub fn picture(&self) -> Result<Picture, ChartError> {
        let mut picture = Picture::filled(2 * SIZE.0, 2 * SIZE.1, [255; 3]);
        let root = Canvas::new(&mut picture).into_drawing_area();
        self.draw(&root, 2).map_err(|error| ChartError(error.to_string()))?;
        drop(root);
        Ok(picture)
    }

    /// Draws with `zoom` pixels per unit.
    fn draw<B: DrawingBackend>(&self, root: &DrawingArea<B, Shift>, zoom: i32) -> Result<(), DrawError<B>> {
        root.fill(&WHITE)?;
        let (width, _) = root.dim_in_pixel();
        let centered = |size: i32| text(size * zoom).pos(Pos::new(HPos::Center, VPos::Top));
        root.draw_text(&self.title, &centered(16), (width as i32 / 2, 10 * zoom))?;
        let grey = centered(12).color(&RGBColor(90, 90, 90));
        root.draw_text(&self.caption, &grey, (width as i32 / 2, 32 * zoom))?;
        let panels = root.margin(54 * zoom, 8 * zoom, 8 * zoom, 8 * zoom).split_evenly((1, 2));
        let unknowns = |run: &ConvergenceRun| run.unknowns as f64;
        self.panel(&panels[0], zoom, "unknowns per band", unknowns, true)?;
        self.panel(&panels[1], zoom, "time, s", |run| run.seconds, false)?;
        root.present()
    }

    fn panel<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        zoom: i32,
        label: &str,
        abscissa: impl Fn(&ConvergenceRun) -> f64,
        with_legend: bool,
    ) -> Result<(), DrawError<B>> {
        let series = self.series(&abscissa);
        let points = || series.iter().flat_map(|(_, points)| points);
        let x = LogAxis::around(points().map(|p| p.place.0));
        let y = LogAxis::around(points().map(|p| p.place.1));
        let mut chart = ChartBuilder::on(area)
            .margin(6 * zoom)
            .margin_right(22 * zoom)
            .x_label_area_size(44 * zoom)
            .y_label_area_size(62 * zoom)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .x_desc(label)
            .y_desc("relative error of the radiosity")
            .label_style(text(12 * zoom))
            .axis_desc_style(text(12 * zoom))
            .axis_style(BLACK.stroke_width(zoom as u32))
            .bold_line_style(RGBColor(190, 190, 190).stroke_width(zoom as u32))
            .light_line_style(RGBColor(235, 235, 235).stroke_width(zoom as u32))
            .set_all_tick_mark_size(4 * zoom)
            .draw()?;
        for (k, (label, points)) in series.iter().enumerate() {
            let colour = COLOURS[k % COLOURS.len()];
            let line = colour.stroke_width(2 * zoom as u32);
            let drawn = chart.draw_series(LineSeries::new(points.iter().map(|p| p.place), line))?;
            drawn.label(label.clone()).legend(move |(x, y)| {
                PathElement::new(vec![(x, y), (x + 18 * zoom, y)], colour.stroke_width(2 * zoom as u32))
            });
            // A dot, with the order next to it where that is what changes.
            let letters = text(11 * zoom).color(&colour);
            chart.draw_series(points.iter().map(|point| {
                EmptyElement::at(point.place)
                    + Circle::new((0, 0), 3 * zoom, colour.filled())
                    + Text::new(point.text.clone(), (6 * zoom, -13 * zoom), letters.clone())
            }))?;
        }
        if with_legend {
            chart
                .configure_series_labels()
                .position(SeriesLabelPosition::LowerLeft)
                .margin(10 * zoom)
                .legend_area_size(24 * zoom)
                .label_font(text(12 * zoom))
                .background_style(WHITE.mix(0.9))
                .border_style(RGBColor(190, 190, 190).stroke_width(zoom as u32))
                .draw()?;
        }
        Ok(())
    }

    /// The points of each way and number of layers, with their label.
    fn series(&self, abscissa: &impl Fn(&ConvergenceRun) -> f64) -> Vec<(String, Vec<Point>)> {
        let groups = self.runs.chunk_by(|a, b| a.layers == b.layers && a.series == b.series);
        let point = |run: &ConvergenceRun| {
            let error = run.error.filter(|error| *error > 0.0)?;
            let is_by_order = matches!(run.series, RunSeries::Uniform | RunSeries::Harmonic);
            let text = if is_by_order { run.order.to_string() } else { String::new() };
            Some(Point { place: (abscissa(run).max(1e-6), error), text })
        };
        groups.map(|runs| (label(&runs[0]), runs.iter().filter_map(point).collect())).collect()
    }
}

type DrawError<B> = DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>;

/// A run's place in a panel.
struct Point {
    place: (f64, f64),
    /// Text beside the point.
    text: String,
}

fn label(run: &ConvergenceRun) -> String {
    match (run.series, run.layers) {
        (RunSeries::Hierarchical, _) => "hierarchical, constants".to_owned(),
        (RunSeries::Hp, _) => "refined for gathered light".to_owned(),
        (RunSeries::Constant, _) => "constants on cells".to_owned(),
        (RunSeries::Linear, _) => "tents on cells".to_owned(),
        (RunSeries::Harmonic, _) => "cosines over surfaces".to_owned(),
        (RunSeries::Sampled, _) => format!("order {} by rays", run.order),
        (RunSeries::Uniform, 0) => "whole elements".to_owned(),
        (RunSeries::Uniform, 1) => "1 layer".to_owned(),
        (RunSeries::Uniform, layers) => format!("{layers} layers"),
    }
}

fn text(size: i32) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&BLACK)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(order: usize, unknowns: usize, error: Option<f64>) -> ConvergenceRun {
        let seconds = 1e-4 * unknowns as f64;
        ConvergenceRun {
            series: RunSeries::Uniform,
            order,
            layers: 0,
            elements: 1,
            unknowns,
            samples: 1,
            rays: 0,
            seconds,
            error,
            rate: None,
            energy: None,
        }
    }

    #[test]
    fn both_kinds_show_the_runs_that_have_errors() {
        let runs = [run(0, 6, Some(0.3)), run(1, 18, Some(0.1)), run(2, 36, None)];
        let chart = |runs| Chart { title: "room".into(), caption: "against the finest".into(), runs };
        let svg = chart(&runs).svg().expect("it is drawn");
        let circles = svg.matches("<circle").count();
        assert_eq!(circles, 4, "two runs in two panels");
        assert!(svg.contains("room") && svg.contains("10⁻¹"));
        let blank = chart(&[]).picture().expect("no runs are no error");
        assert_ne!(chart(&runs).picture().expect("it is drawn"), blank);
    }
}
