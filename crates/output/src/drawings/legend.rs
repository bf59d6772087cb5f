//! A legend: a bar of a scale's colours with its numbers, title and a note, at the right of a picture.

use super::lettering::Lettering;
use super::picture::{Colour, Picture};
use super::scale::Scale;

const PAPER: Colour = [255; 3];
const INK: Colour = [0; 3];
/// Space around the bar, its breadth, and the length of a tick (pixels at the smallest letters). Chosen.
const MARGIN: i32 = 12;
const BAR: i32 = 18;
const TICK: i32 = 5;

/// The legend of a picture in false colours.
#[derive(Clone, Debug)]
pub struct Legend<'a> {
    /// The colours and their numbers.
    pub scale: &'a Scale,
    /// Lines above the bar: the quantity, its unit.
    pub title: Vec<String>,
    /// Lines below the bar.
    pub note: Vec<String>,
    /// Numbers with a line across the bar.
    pub levels: Vec<f64>,
}

impl Legend<'_> {
    /// `picture` with the legend at its right.
    pub fn beside(&self, picture: &Picture) -> Picture {
        let [width, height] = picture.size().map(|x| x as i32);
        let letters = if height >= 900 { 24 } else { 16 };
        let ticks = self.scale.ticks();
        let broad = |text: &String| Lettering::level(text, letters).extent()[0];
        let labels = ticks.iter().map(|tick| BAR + TICK + 4 + broad(&tick.text)).max().unwrap_or(0);
        let texts = self.title.iter().chain(&self.note).map(broad).max().unwrap_or(0);
        let mut whole =
            Picture::filled((width + 2 * MARGIN + labels.max(texts)) as u32, height as u32, PAPER);
        whole.paste(picture, [0, 0]);
        let x = width + MARGIN;
        let step = Lettering::level("", letters).extent()[1] + 2;
        let mut write = |lines: &[String], top: i32| {
            for (k, text) in lines.iter().enumerate() {
                Lettering::level(text, letters).draw(&mut whole, [x, top + k as i32 * step]);
            }
        };
        write(&self.title, MARGIN);
        let foot = height - MARGIN - self.note.len() as i32 * step;
        write(&self.note, foot);
        let top = MARGIN + self.title.len() as i32 * step + step / 2 + 2;
        let ends = [top, (foot - step / 2 - 2).max(top + 2)];
        self.bar(&mut whole, x, ends);
        for level in &self.levels {
            let y = self.row(*level, ends);
            whole.fill([x, x + BAR], [y - 1, y + 2], PAPER);
            whole.fill([x, x + BAR], [y, y + 1], INK);
        }
        for tick in &ticks {
            let (y, label) = (self.row(tick.value, ends), Lettering::level(&tick.text, letters));
            whole.fill([x + BAR, x + BAR + TICK], [y, y + 1], INK);
            label.draw(&mut whole, [x + BAR + TICK + 4, y - step / 2 + 1]);
        }
        whole
    }

    fn bar(&self, picture: &mut Picture, x: i32, [top, foot]: [i32; 2]) {
        picture.fill([x - 1, x + BAR + 1], [top - 1, foot + 1], INK);
        for y in top..foot {
            let part = (f64::from(foot - y) - 0.5) / f64::from(foot - top);
            picture.fill([x, x + BAR], [y, y + 1], self.scale.colour_at(part));
        }
    }

    fn row(&self, value: f64, [top, foot]: [i32; 2]) -> i32 {
        (f64::from(foot - 1) - self.scale.place(value) * f64::from(foot - 1 - top)).round() as i32
    }
}
