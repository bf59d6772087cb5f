//! Error against work, a panel a scene: all runs as dots, the front of each family as a line.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use radiosity::output::drawings::chart::COLOURS;
use radiosity::output::drawings::log_axis::LogAxis;

use crate::family::Family;
use crate::front::Front;
use crate::record::Record;
use crate::study::Study;
use crate::work::Work;

/// Width of the diagram and height of a row of panels, in SVG units.
const WIDTH: u32 = 1100;
const ROW: u32 = 400;
const COLUMNS: usize = 3;

/// Larger errors are not drawn.
const LARGEST: f64 = 1.0;

type Panel<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws the panels of the studies that have runs; the place that is left over holds the legend.
pub(crate) fn write(
    path: &Path,
    work: Work,
    studies: &[Study],
    records: &[Record],
) -> Result<(), Box<dyn Error>> {
    let shown: Vec<&Study> =
        studies.iter().filter(|study| records.iter().any(|record| record.scene == study.name)).collect();
    let rows = (shown.len() + 1).div_ceil(COLUMNS);
    let root = SVGBackend::new(path, (WIDTH, ROW * rows as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    let panels = root.split_evenly((rows, COLUMNS));
    for (study, panel) in shown.iter().zip(&panels) {
        let is_own = |record: &&Record| record.scene == study.name && record.error <= LARGEST;
        let own: Vec<&Record> = records.iter().filter(is_own).collect();
        draw(panel, study.title, work, &own)?;
    }
    legend(&panels[shown.len()])?;
    root.present()?;
    Ok(())
}

fn colour(family: Family) -> RGBColor {
    let [blue, red, green, purple, sky, orange] = COLOURS;
    match family {
        Family::Constant => BLACK,
        Family::Legendre => RGBColor(150, 150, 150),
        Family::Hybrid => purple,
        Family::Orders(1, _) => orange,
        Family::Orders(2, _) => sky,
        Family::Orders(4, _) => green,
        Family::Orders(..) => blue,
        Family::Gathered => red,
    }
}

fn text(size: i32) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&BLACK)
}

fn draw(panel: &Panel, title: &str, work: Work, own: &[&Record]) -> Result<(), Box<dyn Error>> {
    let x = LogAxis::around(own.iter().map(|record| work.of(record)));
    let y = LogAxis::around(own.iter().map(|record| record.error));
    let mut chart = ChartBuilder::on(panel)
        .margin(8)
        .margin_right(16)
        .caption(title, text(16))
        .x_label_area_size(42)
        .y_label_area_size(56)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .x_desc(work.label())
        .y_desc("relative error")
        .label_style(text(12))
        .axis_desc_style(text(12))
        .bold_line_style(RGBColor(200, 200, 200))
        .light_line_style(RGBColor(240, 240, 240))
        .draw()?;
    for family in Family::ALL {
        let members = || own.iter().copied().filter(move |record| family.holds(record));
        let place = |record: &Record| (work.of(record), record.error);
        let paint = colour(family);
        chart.draw_series(members().map(|record| Circle::new(place(record), 2, paint.mix(0.5).filled())))?;
        let front = Front::of(members(), work);
        let line = front.runs().iter().map(|record| place(record));
        chart.draw_series(LineSeries::new(line.clone(), paint.stroke_width(2)))?;
        chart.draw_series(line.map(|place| Circle::new(place, 3, paint.filled())))?;
    }
    Ok(())
}

/// The colours of the families.
fn legend(panel: &Panel) -> Result<(), Box<dyn Error>> {
    const LINE: i32 = 26;
    for (row, family) in (0..).zip(Family::ALL) {
        let (y, paint) = (60 + LINE * row, colour(family));
        panel.draw(&PathElement::new([(70, y), (110, y)], paint.stroke_width(2)))?;
        panel.draw(&Circle::new((90, y), 3, paint.filled()))?;
        panel.draw_text(&family.label(), &text(14).pos(Pos::new(HPos::Left, VPos::Center)), (122, y))?;
    }
    Ok(())
}
