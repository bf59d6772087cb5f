//! A plan on a page: its name and figures above, rulers in the scene's length at its sides, a legend.

use crate::drawings::tick::Tick;
use radiosity_scene::{Scene, SensorPlane};

use crate::drawings::false_colour::{FalseColours, false_colour};
use crate::drawings::legend::Legend;
use crate::drawings::lettering::Lettering;
use crate::drawings::nice_numbers::multiples;
use crate::drawings::picture::{Colour, Picture};
use crate::drawings::plan::Plan;
use radiosity_reading::plane_figures::is_in_room;
use radiosity_reading::probe::ProbeReading;
use radiosity_reading::quantity::{Quantity, band_name, of_bands};
use radiosity_reading::uniformity::Uniformity;

const PAPER: Colour = [255; 3];
const INK: Colour = [0; 3];
/// Space around the plan, length of a tick, height of the name and of other lines (pixels). Chosen.
const MARGIN: i32 = 14;
const TICK: i32 = 5;
const NAME: u32 = 24;
const LINE: u32 = 16;
/// Least height of a page, so that the legend has room (pixels). Chosen.
const LEAST: i32 = 260;

/// A plan with what is written beside it.
#[derive(Clone, Debug)]
struct PlanPage<'a> {
    /// The plan.
    pub plan: &'a Plan<'a>,
    /// Its name.
    pub name: &'a str,
    /// The line below the name.
    pub figures: &'a str,
    /// Lines above the legend: the quantity, its unit.
    pub legend: Vec<String>,
}

/// The page of what the sensors of a plane read in a band, or in the mean of all; `colours` chooses colours
/// and isolines for the range of its values.
pub fn plan_page(
    scene: &Scene,
    plane: &SensorPlane,
    readings: &[ProbeReading],
    band: Option<usize>,
    colours: impl FnOnce([f64; 2]) -> FalseColours,
) -> Picture {
    let is_in_room = is_in_room(readings);
    let value =
        |(reading, inside): (&ProbeReading, &bool)| inside.then(|| of_bands(&reading.irradiance, band));
    let values: Vec<Option<f64>> = readings.iter().zip(&is_in_room).map(value).collect();
    let figures = Uniformity::of(values.iter().copied().flatten());
    let quantity = Quantity::Irradiance.name(&scene.unit).to_owned();
    let legend = [quantity].into_iter().chain(band_name(&scene.bands, band)).chain([scene.unit.clone()]);
    let page = PlanPage {
        plan: &Plan::new(plane, &values),
        name: plane.name(),
        figures: &figures.text(&scene.unit),
        legend: legend.collect(),
    };
    page.picture(&colours([figures.min, figures.max]))
}

impl PlanPage<'_> {
    /// The page in colours.
    fn picture(&self, colours: &FalseColours) -> Picture {
        let field = self.plan.field();
        let mut drawing = false_colour(&field, &colours.scale);
        let parts: Vec<Option<u32>> = field.pixels().map(|(_, part)| (part > 0.0).then_some(0)).collect();
        colours.draw_isolines(&mut drawing, &field, &parts);
        let page = self.page(&drawing);
        let levels = colours.isolines.iter().map(|tick| tick.value).collect();
        Legend { scale: &colours.scale, title: self.legend.clone(), note: Vec::new(), levels }.beside(&page)
    }

    /// The plan with its titles and rulers.
    fn page(&self, drawing: &Picture) -> Picture {
        let [width, height] = drawing.size().map(|pixels| pixels as i32);
        let [across, up] = self.plan.extent().map(multiples);
        let labels = up.iter().map(|tick| broad(&tick.text, LINE)).max().unwrap_or(0);
        let corner = [MARGIN + labels + TICK + 4, MARGIN + NAME as i32 + LINE as i32 + 16];
        let titles = MARGIN + broad(self.name, NAME).max(broad(self.figures, LINE));
        let foot = TICK + LINE as i32 + MARGIN;
        let size = [(corner[0] + width + MARGIN).max(titles), (corner[1] + height + foot).max(LEAST)];
        let mut page = Picture::filled(size[0] as u32, size[1] as u32, PAPER);
        Lettering::level(self.name, NAME).draw(&mut page, [MARGIN, MARGIN]);
        Lettering::level(self.figures, LINE).draw(&mut page, [MARGIN, MARGIN + NAME as i32 + 4]);
        page.paste(drawing, corner);
        let [columns, rows] = [[corner[0], corner[0] + width - 1], [corner[1] + height - 1, corner[1]]];
        ruler_below(
            &mut page,
            &Ruler { range: self.plan.extent()[0], pixels: columns, ticks: across },
            rows[0] + 1,
        );
        ruler_beside(
            &mut page,
            &Ruler { range: self.plan.extent()[1], pixels: rows, ticks: up },
            columns[0] - 1,
        );
        page
    }
}

/// Numbers along a side of a drawing.
struct Ruler {
    /// The numbers at its ends.
    range: [f64; 2],
    /// The pixels of its ends.
    pixels: [i32; 2],
    ticks: Vec<Tick>,
}

impl Ruler {
    /// The pixel of a tick.
    fn pixel(&self, tick: &Tick) -> i32 {
        let [low, high] = self.range;
        let [first, last] = self.pixels.map(f64::from);
        (first + (tick.value - low) / (high - low) * (last - first)).round() as i32
    }

    /// Its ticks without those whose texts would come nearer than `apart` says.
    fn spaced_ticks(&self, apart: impl Fn(&Tick) -> i32) -> Vec<&Tick> {
        let mut shown: Vec<&Tick> = Vec::new();
        for tick in &self.ticks {
            if shown.last().is_none_or(|other| (self.pixel(tick) - self.pixel(other)).abs() >= apart(tick)) {
                shown.push(tick);
            }
        }
        shown
    }
}

fn broad(text: &str, size: u32) -> i32 {
    Lettering::level(text, size).extent()[0]
}

fn ruler_below(page: &mut Picture, ruler: &Ruler, top: i32) {
    for tick in ruler.spaced_ticks(|tick| broad(&tick.text, LINE) + 10) {
        let x = ruler.pixel(tick);
        page.fill([x, x + 1], [top, top + TICK], INK);
        Lettering::level(&tick.text, LINE).draw(page, [x - broad(&tick.text, LINE) / 2, top + TICK]);
    }
}

fn ruler_beside(page: &mut Picture, ruler: &Ruler, right: i32) {
    for tick in ruler.spaced_ticks(|_| LINE as i32 + 4) {
        let y = ruler.pixel(tick);
        page.fill([right - TICK + 1, right + 1], [y, y + 1], INK);
        Lettering::level(&tick.text, LINE)
            .draw(page, [right - TICK - 3 - broad(&tick.text, LINE), y - LINE as i32 / 2]);
    }
}
